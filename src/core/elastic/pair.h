/* What two bodies are to each other. */
#ifndef ELASTIC_PAIR_H
#define ELASTIC_PAIR_H

#include "archard/model.h"

/* Dundurs' second constant of a pair: how unlike its bodies are to shear. */
double arc_contact_mismatch(arc_space space, const arc_material material[ARC_BODIES]);

/* Whether two bodies, each in order, make a pair; ARC_ARGUMENT. */
arc_status arc_model_check_pair(const arc_model_def *def, arc_error *error);

/* Of a pair whose meshes are given, which tell themselves how far they reach. */
arc_status arc_model_check_given_pair(const arc_model_def *def, arc_error *error);

#endif
