/* Sizes, zones and depths of meshes that fit a contact. */
#ifndef ELASTIC_MESH_SIZE_H
#define ELASTIC_MESH_SIZE_H

#include "archard/model.h"

/* The widest zone of a body of the model [mm]: arcs curl away from the contact. */
double arc_model_widest_zone(const arc_model_def *def, arc_body body);

/* The deepest wear box that both bodies have room for [mm]. */
double arc_model_deepest_box(const arc_model_def *def);

/* The size that "auto" is at a fineness of 1 for a half width [mm]. */
double arc_model_size_for(double half_width);

/* Bytes that building the model takes at its height, about. */
double arc_model_memory(const arc_model_def *def);

/* Room for the edge peaks of worn contacts, in half widths. */
#define ARC_CONTACT_ROOM 1.3

#endif
