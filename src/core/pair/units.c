/* Warns about numbers that are probably in another unit. Moduli from polyethylene (500 MPa) to
 * diamond (1.2e6 MPa) and wear coefficients from a diamond film (1e-13 mm2/N) to a polymer without
 * filler (1e-6 mm2/N) cause no warning. */
#include "core/pair/units.h"
#include "core/base/callbacks.h"
#include "core/pair/kind.h"

#include <math.h>
#include <stdio.h>

static const double softest = 500,
                    stiffest = 2e6; /* lowest and highest modulus of usual materials [MPa] */

static void warn_modulus(const char *name, double E, const arc_callbacks *callbacks) {
  if (E < softest)
    arc_warn(callbacks,
             "E = %g MPa of the %s is the modulus of a soft plastic or rubber: was %g GPa meant (E "
             "= %g)?",
             E, name, E, 1e3 * E);
  if (E > stiffest)
    arc_warn(callbacks,
             "E = %g MPa of the %s is above the modulus of diamond: was %g Pa meant (E = %g)?", E,
             name, E, 1e-6 * E);
}

void arc_units_doubt(const arc_model_def *model, char *text, size_t size) {
  const double E = fmin(model->material[ARC_UPPER].E, model->material[ARC_LOWER].E);
  text[0] = '\0';
  if (E < softest)
    snprintf(text, size,
             "; E = %g MPa is the modulus of a soft plastic or rubber: was %g GPa meant?", E, E);
}

void arc_model_warn_moduli(const arc_model_def *model, const arc_callbacks *callbacks) {
  for (int b = 0; b < ARC_BODIES && arc_kind_of(model->geometry)->elastic; b++)
    warn_modulus(model->body[b].name[0] ? model->body[b].name : arc_body_name((arc_body)b),
                 model->material[b].E, callbacks);
}

void arc_units_warn_pair(const arc_model_def *model, double p_max, const arc_callbacks *callbacks) {
  static const double small =
      50; /* ratio of Young's modulus to pressure below which strains are no longer small */
  if (!arc_kind_of(model->geometry)->elastic) return;
  const double E = fmin(model->material[ARC_UPPER].E, model->material[ARC_LOWER].E);
  if (p_max > E / small)
    arc_warn(
        callbacks,
        "the largest pressure, %.4g MPa, is more than a fiftieth of E = %g MPa: strains are not "
        "small; are E in MPa, the load in N, radius and thickness in mm?",
        p_max, E);
}

void arc_units_warn_friction(double friction, const arc_callbacks *callbacks) {
  static const double highest = 3; /* largest usual coefficient of friction */
  if (friction > highest)
    arc_warn(callbacks, "friction = %g is a coefficient, force / load: was %g %% meant (%g)?",
             friction, friction, friction / 100);
}

void arc_units_warn_wear(double k, double stroke, double half_width,
                         const arc_callbacks *callbacks) {
  static const double smallest = 1e-13, largest = 1e-6; /* limits of k [mm2/N] */
  static const double short_of = 0.05; /* smallest usual ratio of stroke to half width */
  if (k > largest)
    arc_warn(callbacks, "k = %g mm2/N is %g mm3/(N m): was %g mm3/(N m) meant (k = %g)?", k,
             1e3 * k, k, 1e-3 * k);
  if (k > 0 && k < smallest)
    arc_warn(callbacks, "k = %g mm2/N is %g mm3/(N m): was %g m2/N meant (k = %g)?", k, 1e3 * k, k,
             1e6 * k);
  if (stroke > 0 && stroke < short_of * half_width)
    arc_warn(
        callbacks,
        "stroke = %g mm, from end to end, is %.2g of the contact's half width: was %g mm meant? "
        "Surfaces may stick in such a short stroke: set friction to include sticking",
        stroke, stroke / half_width, 1e3 * stroke);
}
