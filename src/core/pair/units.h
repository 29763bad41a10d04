/* Numbers that look as if they were in another unit: a warning each, which name the number and the
 * unit that is expected. */
#ifndef PAIR_UNITS_H
#define PAIR_UNITS_H

#include "archard/model.h"

/* Young's moduli of both bodies, and the largest pressure `p_max` [MPa] beside them. */
void arc_units_warn_pair(const arc_model_def *model, double p_max, const arc_callbacks *callbacks);

/* A wear coefficient [mm2/N], and a stroke [mm] beside the half width of the contact. */
void arc_units_warn_wear(double k, double stroke, double half_width,
                         const arc_callbacks *callbacks);

#endif
