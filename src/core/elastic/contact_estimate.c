/* Estimates the contact width of unworn bodies, from which the element sizes are chosen. For
 * half-planes there are closed forms: the formulas of Hertz for arcs, and of Persson for pins in
 * holes. For other shapes with one contact zone, the load is an integral over the gap. For
 * layers and a base close to the surface, the contact modulus is computed for a pressure wave of
 * about the contact's length. */
#include "core/elastic/contact_estimate.h"
#include "core/elastic/layered.h"
#include "core/mesh/body_shape.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

/* --- the pair --------------------------------------------------------------------------------- */

int arc_model_is_round(const arc_model_def *def) {
  return def->geometry == ARC_AXISYMMETRIC && def->axis == 0;
}

/* Returns the length of a straight or circular line contact [mm]. */
static double line_length(const arc_model_def *def) {
  return def->geometry == ARC_AXISYMMETRIC ? 2 * pi * def->axis : def->thickness;
}

/* Returns the wave number, multiplied by the half width of the contact, of a pressure wave under
 * which layers are as compliant as under the contact. The value is exact for layers that are so
 * thin that they act like independent springs. */
static double waves_over(const arc_model_def *def) {
  return arc_model_is_round(def) ? 32 / (3 * pi) : 0.75 * pi;
}

static arc_hertz hertz_on(const arc_model_def *def, double radius, double load) {
  const arc_hertz_def pair = {
      .radius = radius,
      .thickness = arc_model_is_round(def) ? 1 : line_length(def),
      .load = load,
      .geometry = def->geometry == ARC_AXISYMMETRIC && !arc_model_is_round(def) ? ARC_PLANE_STRAIN
                                                                                : def->geometry,
      .material = {def->material[0], def->material[1]}};
  arc_hertz hertz = {0};
  arc_hertz_of(&pair, &hertz, NULL);
  return hertz;
}

arc_hertz arc_model_hertz(const arc_model_def *def, double load) {
  return hertz_on(def, arc_model_relative_radius(def), load);
}

/* --- the gap ---------------------------------------------------------------------------------- */

/* Returns the depth [mm] of the surface at x [mm] below the outermost point of the surface. */
static double inset_at(const contact_pair *g, int b, double x) {
  const arc_body_def *s = &g->solid[b];
  const double radius = g->form[b] != 0 ? g->form[b] : arc_body_radius(s);
  if (isfinite(radius)) {
    const double side = fmax(-1, fmin(1, x / radius));
    return x * side / (1 + sqrt(1 - side * side));
  }
  return g->form[b] != 0 ? 0 : arc_body_inset(s, g->crest[b], x);
}

static double gap_at(const contact_pair *g, double x) {
  return inset_at(g, ARC_UPPER, x) + inset_at(g, ARC_LOWER, x);
}

/* Returns the gap [mm] at a distance s from the first point of contact, averaged over both
 * sides. */
static double opening(const contact_pair *g, double s) {
  return (gap_at(g, g->at + s) + gap_at(g, g->at - s)) / 2;
}

/* Sets g->at to the position where the gap of smooth profiles is smallest. This is a point, or
 * the middle of a flat; the half width of the flat is also stored. If there are several such
 * positions, the first one is used. */
static void find_first_touch(contact_pair *g) {
  const double alike = 1e-12 * g->most;
  double least = INFINITY, first = 0, last = 0;
  for (int b = 0; b < ARC_BODIES; b++) {
    const arc_series *y = &g->solid[b].y_series;
    int is_in_cell_of_previous = 0;
    for (int i = 0; i < y->count && g->form[b] == 0; i++) {
      const double x = y->distance[i], gap = gap_at(g, x);
      if (gap < least - alike) {
        least = gap;
        first = last = x;
        is_in_cell_of_previous = 1;
      } else if (gap > least + alike) {
        is_in_cell_of_previous = 0;
      } else if (is_in_cell_of_previous) {
        last = x;
      }
    }
  }
  g->at = (first + last) / 2;
  if (last > first) g->least = fmin((last - first) / 2, 0.9 * g->most);
}

static void find_limits(contact_pair *g) {
  const arc_body_def *s = g->solid;
  const body_limits limits[] = {arc_body_limits(&s[0]), arc_body_limits(&s[1])};
  g->most = fmin(limits[0].reach, limits[1].reach);
  for (int b = 0; b < ARC_BODIES; b++) {
    const double flat = limits[b].flat;
    if (flat > 0 && !arc_body_has_points(&s[1 - b]))
      g->least = g->least > 0 ? fmin(g->least, flat) : flat;
    if (!arc_body_is_hollow(&s[b])) continue;
    g->hole = s[b].inner;
    g->clearance = s[b].inner - arc_body_radius(&s[1 - b]);
    g->most = g->hole * pi / 2;
  }
}

contact_pair arc_model_pair(const arc_model_def *def) {
  contact_pair g = {.def = def, .round = arc_model_is_round(def), .load = NAN};
  for (int b = 0; b < ARC_BODIES; b++) {
    g.solid[b] = arc_model_solid(def, (arc_body)b);
    g.crest[b] = arc_body_crest(&g.solid[b]);
    g.waves[b] = arc_body_waves(&g.solid[b]);
  }
  find_limits(&g);
  return g;
}

/* --- load for a given contact width */

/* Returns the contact modulus [MPa] of the pair for a half width of the contact [mm]. */
static double modulus_at(const contact_pair *g, double half_width) {
  const arc_model_def *def = g->def;
  return arc_pair_modulus(def->geometry, g->solid, def->material, waves_over(def) / half_width);
}

/* Returns the load P / E* [mm] of Persson's contact of a pin in a hole, for equal materials and
 * the radial clearance c. Persson's formula for 2 E* c / P is a function of b = tan(e / 2),
 * where e is the half angle of the contact. */
static double press_into_hole(const contact_pair *g, double half_width) {
  const double b = tan(half_width / g->hole / 2), s = b * b;
  const double c = (2 - 2 * s * s - log1p(s)) / (pi * s * (1 + s));
  return c > 0 ? 2 * g->clearance / c : INFINITY;
}

/* Returns the load P / E* of a contact with the half width a and the gap g(s). For half-planes it
 * is the integral of s g' / sqrt(a^2 - s^2) ds, for round spots twice the integral of s^2 g' /
 * sqrt(a^2 - s^2) ds. Both integrands are smooth functions of t = sqrt(a^2 - s^2). `wide` is the
 * half width a, minus the half width of the part that touches without load. */
static double press(const contact_pair *g, double wide) {
  enum { steps = 100 };
  const double a = g->least + wide, most = sqrt(wide * (wide + 2 * g->least));
  if (g->hole > 0) return press_into_hole(g, a);
  double sum = 0, outer = a, out = opening(g, a);
  for (int k = 1; k <= steps; k++) {
    const double t = most * k / steps, step = most / steps, before = t - step;
    const double inner = k < steps ? sqrt((a - t) * (a + t)) : g->least, in = opening(g, inner);
    const double both = outer + inner;
    /* step / (outer - inner) = both / (t + before), as outer^2 - inner^2 = t^2 - before^2 */
    sum += (out - in) * both / (t + before) * (g->round ? both : 1);
    outer = inner;
    out = in;
  }
  return sum;
}

/* Returns the half width [mm] under a load, minus the half width of the part that touches
 * without load. The logarithm of this difference is computed by bisection. If the load is above
 * the load of the largest contact, the result is the value for the largest contact. */
static double width_under(const contact_pair *g, double load) {
  enum { halvings = 45 };
  static const double smallest = 1e-9;
  const double wanted = g->round ? load : load / line_length(g->def);
  double low = log(smallest), high = 0;
  for (int i = 0; i < halvings; i++) {
    const double middle = (low + high) / 2, wide = exp(middle) * (g->most - g->least);
    if (press(g, wide) * modulus_at(g, g->least + wide) < wanted)
      low = middle;
    else
      high = middle;
  }
  return exp(high) * (g->most - g->least);
}

/* Returns the half width [mm] of a cylinder's (or ball's) contact that grows with the load as fast
 * as the given contact, so that the pressure falls as steeply at its edges. The load is
 * proportional to the square of the half width for cylinders, to the cube for balls. */
static double edge_at(const contact_pair *g, double wide) {
  static const double step = 1e-3;
  const double a = g->least + wide, p = press(g, wide);
  const double growth = (press(g, wide * (1 + step)) - press(g, wide * (1 - step))) / (2 * step);
  if (g->hole > 0 || !(p > 0) || !(growth > 0)) return a;
  return fmin(a, (g->round ? 3 : 2) * p / growth * wide);
}

/* --- estimates */

/* Waves on a surface change the pressure by their amplitude times pi E* / wavelength. Waves are
 * neglected if this change is less than `felt` times the mean pressure. */
static const double felt = 1e-3;

static double mean_pressure(const contact_pair *g, double half_width, double load) {
  return g->round ? load / (pi * half_width * half_width)
                  : load / (2 * half_width * line_length(g->def));
}

/* Returns the width [mm] of the contact on each crest of waves under the mean pressure p, by
 * Westergaard's formula. */
static double spot_width(const body_waves *w, double modulus, double p) {
  const double flat = pi * modulus * w->height / 2 /
                      w->length; /* [MPa] mean pressure at which the contact becomes complete */
  return p < flat ? 2 * w->length / pi * asin(sqrt(p / flat)) : w->length;
}

/* Determines which profiles are rough under the load, based on the contact of their smooth
 * forms. For rough profiles the contact width is computed from the form. Sets the length of the
 * shortest waves and the width of the contact spots. */
static void find_waves(contact_pair *g, double load, contact_estimate *e) {
  for (int b = 0; b < ARC_BODIES; b++)
    if (arc_body_has_points(&g->solid[b])) g->form[b] = g->waves[b].form;
  const double wide = width_under(g, load), a = g->least + wide;
  const double p = mean_pressure(g, a, load);
  for (int b = 0; b < ARC_BODIES; b++) {
    const body_waves *w = &g->waves[b];
    const int rough = pi * modulus_at(g, a) * w->height / 2 > felt * p * w->length;
    if (!rough) {
      g->form[b] = 0;
      continue;
    }
    e->wave = fmin(e->wave, w->length);
    e->spot = fmin(e->spot, spot_width(w, modulus_at(g, a), p));
  }
}

static int has_profile(const contact_pair *g) {
  return arc_body_has_points(&g->solid[0]) || arc_body_has_points(&g->solid[1]);
}

static int is_arc_or_flat(const arc_body_def *b) {
  return arc_body_is_round(b) || arc_body_is_flat(b);
}

/* Returns true if both surfaces are arcs or flat, without layers or a base close to the surface. */
static int is_plain(const contact_pair *g, double half_width) {
  return g->hole == 0 && is_arc_or_flat(&g->solid[0]) && is_arc_or_flat(&g->solid[1]) &&
         half_width > 0 &&
         modulus_at(g, half_width) == arc_contact_modulus(g->def->geometry, g->def->material);
}

static contact_estimate estimate(contact_pair g, double load) {
  contact_estimate e = {
      .half_width = arc_model_hertz(g.def, load).half_width, .wave = INFINITY, .spot = INFINITY};
  e.edge = e.half_width;
  if (is_plain(&g, e.half_width)) return e;
  if (has_profile(&g)) {
    find_waves(&g, load, &e);
    find_first_touch(&g);
  }
  const double wide = width_under(&g, load);
  e.half_width = g.least + wide;
  e.edge = edge_at(&g, wide);
  e.at = g.at;
  e.flat = 2 * g.least;
  return e;
}

contact_estimate arc_pair_estimate(contact_pair *pair, double load) {
  if (load != pair->load) pair->answer = estimate(*pair, load);
  pair->load = load;
  return pair->answer;
}

contact_estimate arc_model_estimate(const arc_model_def *def, double load) {
  contact_pair pair = arc_model_pair(def);
  return arc_pair_estimate(&pair, load);
}

double arc_model_half_width(const arc_model_def *def, double load) {
  return arc_model_estimate(def, load).half_width;
}

double arc_model_line(const arc_model_def *def, double load) {
  if (!arc_model_is_round(def)) return load / line_length(def);
  return 2 * load / (pi * arc_model_half_width(def, load));
}
