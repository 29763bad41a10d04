/* Sizes, zones and depths of meshes for a contact. */
#ifndef ELASTIC_MESH_SIZE_H
#define ELASTIC_MESH_SIZE_H

#include "archard/model.h"

/* Returns the width of the widest possible zone of a body [mm]. It is limited where arcs curve
 * away from the contact. */
double arc_model_widest_zone(const arc_model_def *def, arc_body body);

/* Returns the largest depth of the wear box that is possible in both bodies [mm]. */
double arc_model_deepest_box(const arc_model_def *def);

/* Returns the "auto" element size [mm] for a half width of the contact [mm] at fineness 1. */
double arc_model_size_for(double half_width);

/* Returns the approximate peak memory of building the model [bytes]. */
double arc_model_memory(const arc_model_def *def);

/* Half width of a zone divided by the half width of the contact. The margin is for the peaks at
 * the edges of worn contacts. */
#define ARC_CONTACT_MARGIN 1.3

#endif
