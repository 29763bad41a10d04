/* Checks and constants of pairs of bodies. */
#ifndef ELASTIC_PAIR_H
#define ELASTIC_PAIR_H

#include "archard/model.h"

/* Returns Dundurs' second constant beta [-] for a pair of materials, a measure of their elastic
 * mismatch. It is exactly 0 for materials that differ by rounding errors. */
double arc_contact_mismatch(arc_space space, const arc_material material[ARC_BODIES]);

/* Checks that two valid bodies form a valid pair. Errors: ARC_ARGUMENT. */
arc_status arc_model_check_pair(const arc_model_def *def, arc_error *error);

/* Checks that two bodies with imported meshes form a valid pair. For bodies of revolution only
 * holes are rejected; extents and symmetry are not checked. Errors: ARC_ARGUMENT. */
arc_status arc_model_check_given_pair(const arc_model_def *def, arc_error *error);

#endif
