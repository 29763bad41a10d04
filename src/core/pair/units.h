/* Declares functions that warn about numbers that are probably in another unit. Each warning
 * contains the number and the expected unit. */
#ifndef PAIR_UNITS_H
#define PAIR_UNITS_H

#include "archard/model.h"

/* Checks the largest pressure `p_max` [MPa] relative to the smaller Young's modulus. */
void arc_units_warn_pair(const arc_model_def *model, double p_max, const arc_callbacks *callbacks);

/* Writes the end of an error message to `text`: a question whether the smaller modulus is in GPa,
 * or "" if this modulus is usual. */
void arc_units_doubt(const arc_model_def *model, char *text, size_t size);

/* Checks a coefficient of friction. */
void arc_units_warn_friction(double friction, const arc_callbacks *callbacks);

/* Checks a wear coefficient [mm2/N], and a stroke [mm] relative to the half width of the contact
 * [mm]. */
void arc_units_warn_wear(double k, double stroke, double half_width,
                         const arc_callbacks *callbacks);

#endif
