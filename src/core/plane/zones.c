/* Computes the widths of the zones that a run needs, from the motion and the contact. */
#include "core/plane/cycle.h"

#include <math.h>

/* Returns the sliding distance of the whole run [mm]. If the user defined none, it is the total
 * distance of all blocks of loading. */
static double whole_distance(const arc_wear_def *def, const arc_model_def *model) {
  double sum = def->distance;
  for (int b = 0; b < def->blocks && def->distance == 0; b++) {
    const arc_loading *l = &def->loading[b];
    for (int i = 1; i < l->count; i++)
      sum += l->cycles * fabs(arc_loading_x(l, model, i) - arc_loading_x(l, model, i - 1));
  }
  return sum;
}

static double largest_k(const arc_wear_def *def) {
  double k = def->k_series.count > 0 ? 0 : def->k;
  for (int i = 0; i < def->k_series.count; i++) k = fmax(k, def->k_series.value[i]);
  return k;
}

/* Automatic zones are wide enough for contacts of up to this many unworn half widths. All 20
 * cases of the paper on alpha (up to 2.5 half widths) need only one mesh. */
static const double outgrown_at = 6;

/* Estimates the half width [mm] of the widest contact of a run. The estimate is the half width of
 * Hertz or, if larger, half of it plus the half width of a flat scar, assuming that only the
 * cylinder wears. */
static double widest_contact(const arc_wear_def *def, const arc_model_def *model, double load) {
  const double half = arc_model_half_width(model, load);
  const double relative = arc_model_relative_radius(model);
  const double radius = isfinite(relative) ? relative : arc_model_solid(model, ARC_UPPER).radius;
  const double volume = largest_k(def) * load * whole_distance(def, model);
  const double scar = arc_wear_scar(def, model, radius, volume);
  /* with automatic sizes remesh.c builds a wider, coarser mesh when necessary */
  const double most = model->mesh.fineness > 0 ? outgrown_at * half : INFINITY;
  const double widest = fmin(most, fmax(half, half / 2 + scar));
  /* coarse meshes need a margin of three elements: one below the contact edge and two without
   * contact */
  return fmax(widest, (widest + 3 * model->mesh.size) / ARC_CONTACT_MARGIN);
}

void arc_wear_zones(const arc_wear_def *def, const arc_model_def *model, double zone[ARC_BODIES]) {
  const int slides = def->slide == ARC_SLIDE_X && arc_wear_choose_procedure(def, model) == ARC_SP;
  const int strokes = slides && def->blocks == 0 && !(def->tangential > 0);
  const double aside = fabs(arc_model_arc_length(model, def->load_angle));
  double load = def->load, turn = aside, reach = aside + (strokes ? def->stroke / 2 : 0);
  for (int b = 0; b < def->blocks; b++)
    for (int i = 0; i < def->loading[b].count; i++) {
      const arc_loading *l = &def->loading[b];
      const double x = slides ? arc_loading_x(l, model, i) : 0;
      const double under =
          arc_model_arc_length(model, l->load_angle ? l->load_angle[i] : def->load_angle);
      turn = fmax(turn, fabs(under));
      reach = fmax(reach, fabs(under - x));
      load = fmax(load, l->load[i]);
    }
  arc_zone_for(reach, widest_contact(def, model, load), model->mesh.size, zone);
  zone[ARC_UPPER] += 2 * turn;
}
