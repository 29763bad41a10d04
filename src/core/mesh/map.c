/* The two maps: the plate's is the identity, the half cylinder's polar. Below the contact region
 * the cylinder's depth follows r = r0 exp(-d / r0), which keeps the cells' shape while circles
 * shrink. */
#include "core/mesh/map.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

/* Roots along the half surface: few on the cylinder, so that the fan at its centre has blunt
 * triangles. */
static int choose_root_level(const arc_mesh_def *def, arc_body body, double half_s) {
  const double largest = body == ARC_CYLINDER ? half_s / 2.5 : fmin(def->far, half_s / 2);
  const int level = (int)floor(log2(largest / def->size) + 1e-9);
  return level > 0 ? level : 0;
}

body_map arc_body_map_make(const arc_mesh_def *def, arc_body body, double radius, double near_s,
                           double near_d) {
  body_map m = {.body = body, .radius = radius, .size = def->size, .height = def->height};
  m.half_s = body == ARC_CYLINDER ? pi * radius / 2 : radius;
  m.near_s = near_s;
  m.near_d = near_d;
  m.root_level = choose_root_level(def, body, m.half_s);
  const double unit = ldexp(1, m.root_level);
  const double deep = body == ARC_CYLINDER ? 1.9 * radius : radius;
  m.columns = (int)fmax(1, round(m.half_s / (unit * def->size)));
  m.lines = (int)fmax(1, round(deep / (unit * def->height)));
  m.units_s = m.columns * unit * def->size;
  m.units_d = m.lines * unit * def->height;
  return m;
}

/* Identity up to `near`, then linear so that `units` lands on `target`. */
static double stretch(double at, double near, double units, double target) {
  if (at <= near) return at;
  return near + (at - near) * ((target - near) / (units - near));
}

static double cylinder_radius_at(const body_map *m, double depth) {
  if (depth <= m->near_d) return m->radius - depth;
  const double r0 = m->radius - m->near_d;
  return r0 * exp(-(depth - m->near_d) / r0);
}

void arc_body_map_point(const body_map *m, double i, double j, double xy[2]) {
  const double s = i * m->size, d = j * m->height;
  const double along =
      i * m->size >= m->units_s ? m->half_s : stretch(s, m->near_s, m->units_s, m->half_s);
  if (m->body == ARC_PLATE) {
    xy[0] = along;
    xy[1] = d >= m->units_d ? -m->radius : -stretch(d, m->near_d, m->units_d, m->radius);
    return;
  }
  const double r = cylinder_radius_at(m, d), angle = along / m->radius;
  /* R - r cos(angle), written so that nothing cancels near the apex */
  const double half = sin(angle / 2);
  xy[0] = r * sin(angle);
  xy[1] = along >= m->half_s ? m->radius : (m->radius - r) + 2 * r * half * half;
}

double arc_body_map_unit(const body_map *m, double j) {
  if (m->body == ARC_PLATE) return m->size;
  return m->size * cylinder_radius_at(m, j * m->height) / m->radius;
}
