/* Charts: coordinates along and across the surfaces of a pair. */
#include "core/elastic/chart.h"
#include "core/elastic/pair.h"
#include "core/mesh/body_shape.h"

#include <math.h>
#include <string.h>

chart arc_chart_of(const arc_model_def *def) {
  for (int b = 0; b < ARC_BODIES; b++) {
    const arc_body_def solid = arc_model_solid(def, (arc_body)b);
    const arc_body_def other = arc_model_solid(def, (arc_body)(1 - b));
    if (arc_body_is_hollow(&solid))
      return (chart){.polar = 1,
                     .radius = solid.inner,
                     .side = b == ARC_LOWER ? 1 : -1,
                     .pin = arc_body_radius(&other)};
  }
  return (chart){.revolved = {def->geometry == ARC_AXISYMMETRIC, def->axis}};
}

int arc_model_is_hole(const arc_model_def *def) {
  return arc_chart_of(def).polar;
}

double arc_model_arc_length(const arc_model_def *def, double degrees) {
  return arc_chart_of(def).radius * arc_radians(degrees);
}

int arc_model_slides_along(const arc_model_def *def) {
  const arc_body_def lower = arc_model_solid(def, ARC_LOWER);
  return arc_model_is_hole(def) || arc_body_is_flat(&lower);
}

/* The formula z = side (2 side R y - x^2 - y^2) / (R + r) is used because R - r loses digits by
 * cancellation near the surface. */
void arc_chart_from_space(const chart *c, int n, const double *xy, double *sz) {
  if (!c->polar) {
    memcpy(sz, xy, 2 * (size_t)n * sizeof *sz);
    return;
  }
  for (int i = 0; i < n; i++) {
    const double x = xy[2 * i], up = c->side * xy[2 * i + 1], to = c->radius - up;
    sz[2 * i] = c->radius * atan2(x, to);
    sz[2 * i + 1] = c->side * (2 * c->radius * up - x * x - up * up) / (c->radius + hypot(x, to));
  }
}

void arc_chart_to_space(const chart *c, int n, const double *sz, double *xy) {
  if (!c->polar) {
    memcpy(xy, sz, 2 * (size_t)n * sizeof *xy);
    return;
  }
  for (int i = 0; i < n; i++) {
    const double angle = sz[2 * i] / c->radius, z = c->side * sz[2 * i + 1];
    const double half = sin(angle / 2), r = c->radius - z;
    xy[2 * i] = r * sin(angle);
    xy[2 * i + 1] = c->side * (z + 2 * r * half * half);
  }
}

int arc_chart_nearest(const double *sz, int step, int count, double s) {
  int best = count / 2;
  for (int i = 0; i < count; i++)
    if (fabs(sz[2 * step * i] - s) < fabs(sz[2 * step * best] - s)) best = i;
  return best;
}

void arc_chart_axes(const chart *c, double s, double along[2], double across[2]) {
  const double angle = c->polar ? s / c->radius : 0;
  along[0] = across[1] = cos(angle);
  along[1] = c->side * sin(angle);
  across[0] = -along[1];
}

double arc_chart_rest(const chart *c, double s, double angle) {
  const double off = c->radius - c->pin, at = s / c->radius - angle;
  return off * cos(at) + sqrt(c->pin * c->pin - off * off * sin(at) * sin(at));
}

/* Computes the position of a body. A pin rotates about its own centre, and a body with a hole
 * about the centre of the hole. */
placing arc_chart_placing(const chart *c, arc_body body, double x, double angle) {
  placing p = {.cos = 1};
  const int is_pin = (body == ARC_UPPER) == (c->side > 0);
  const double turn = c->polar && body == ARC_LOWER ? c->side * x / c->radius : 0;
  if (!c->polar) {
    p.shift[0] = body == ARC_LOWER ? x : 0;
    return p;
  }
  p.cos = cos(turn);
  p.sin = sin(turn);
  p.centre[1] = c->side * (is_pin ? c->pin : c->radius);
  if (!is_pin) return p;
  const double off = c->radius - c->pin;
  p.shift[0] = off * sin(angle);
  p.shift[1] = c->side * off * (1 - cos(angle));
  return p;
}

void arc_placing_vectors(const placing *p, int n, double *v) {
  for (int i = 0; i < n && p->sin != 0; i++) {
    const double x = v[2 * i], y = v[2 * i + 1];
    v[2 * i] = p->cos * x - p->sin * y;
    v[2 * i + 1] = p->sin * x + p->cos * y;
  }
}

void arc_placing_points(const placing *p, int n, double *xy) {
  for (int i = 0; i < n && p->sin != 0; i++)
    for (int d = 0; d < 2; d++) xy[2 * i + d] -= p->centre[d];
  arc_placing_vectors(p, n, xy);
  for (int i = 0; i < n && p->sin != 0; i++)
    for (int d = 0; d < 2; d++) xy[2 * i + d] += p->centre[d];
  for (int i = 0; i < n; i++)
    for (int d = 0; d < 2; d++) xy[2 * i + d] += p->shift[d];
}
