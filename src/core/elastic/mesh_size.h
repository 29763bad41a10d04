/* Sizes, zones and depths of meshes for a contact. */
#ifndef ELASTIC_MESH_SIZE_H
#define ELASTIC_MESH_SIZE_H

#include "archard/model.h"

/* Returns the width of the widest zone of a body of the model [mm], which is limited where arcs
 * curve away from the contact. */
double arc_model_widest_zone(const arc_model_def *def, arc_body body);

/* Returns the largest possible depth of the wear box in both bodies [mm]. */
double arc_model_deepest_box(const arc_model_def *def);

/* Returns the "auto" size of the elements [mm] for a half width [mm] at fineness 1. */
double arc_model_size_for(double half_width);

/* Returns the approximate peak memory of building the model [bytes]. */
double arc_model_memory(const arc_model_def *def);

/* Half width of a zone divided by the half width of the contact, with a margin for the edge peaks
 * of worn contacts. */
#define ARC_CONTACT_MARGIN 1.3

#endif
