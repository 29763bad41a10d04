/* Maps from logical coordinates to positions, for rectangles, solid arcs and walls of rings. The
 * heights of a rectangle's surface decay with depth. Below the contact region of a solid arc,
 * the radius at depth d is r = r0 exp(-d / r0), so that cells have the same aspect ratio down to
 * the centre. */
#include "core/mesh/map.h"

#include <math.h>
#include <stdlib.h>

/* Returns the level of the root cells, which are 2^level units wide. Solid arcs have few and
 * wide root cells; otherwise the triangles at the centre of the arc would be acute. */
static int choose_root_level(const arc_mesh_def *def, const body_map *m) {
  const double wide = arc_body_map_closed(m) ? 5 : 2.5;
  const double largest = m->core ? m->half_s / wide : fmin(def->far, m->half_s / 2);
  const int level = (int)floor(log2(largest / def->size) + 1e-9);
  return level > 0 ? level : 0;
}

/* Returns the number of root cells of a given width in a length, at least 1. Round lengths and
 * widths often have a quotient of exactly n + 1/2, in which rounding errors must not count. */
static int count_cells(double length, double width) {
  return (int)fmax(1, round(length / width * (1 + 1e-9)));
}

/* Converts a logical coordinate [mm] to a physical coordinate. Coordinates up to `near` are
 * unchanged. Larger coordinates are stretched linearly, so that `units` becomes `target`. */
static double stretch(double at, double near, double units, double target) {
  if (at <= near) return at;
  return near + (at - near) * ((target - near) / (units - near));
}

/* Returns the physical depth [mm] of a logical depth in a body without layers. */
static double plain_depth(const body_map *m, double d) {
  if (m->core) return d;
  return d >= m->units_d ? m->depth : stretch(d, m->near_d, m->units_d, m->depth);
}

/* Returns the row nearest to a depth [mm], but at least the row after row `above`. Far below the
 * surface, only rows at the ends of coarse cells are used. */
static double row_at(const body_map *m, double depth, double above) {
  double least = 0, most = m->units_d;
  for (int k = 0; k < 60; k++) {
    const double middle = (least + most) / 2;
    if (plain_depth(m, middle) < depth)
      least = middle;
    else
      most = middle;
  }
  const double j = least / m->height, coarse = exp2(floor(log2(fmax(1, j / 8))));
  return fmax(above + 1, round(j / coarse) * coarse);
}

/* Assigns a row of nodes to each interface between layers, and computes the shift of the row to
 * the depth of the interface. */
static void lay_layers(body_map *m) {
  m->layers = arc_body_layers(m->solid);
  for (int l = 0; l < m->layers; l++) {
    const double depth = arc_body_interface(m->solid, l);
    m->line[l] = row_at(m, depth, l > 0 ? m->line[l - 1] : 0);
    m->shift[l] = depth - plain_depth(m, m->line[l] * m->height);
  }
}

body_map arc_body_map_make(const arc_mesh_def *def, arc_body body, const arc_body_def *solid,
                           double near_s, double near_d) {
  body_map m = {.solid = solid,
                .up = body == ARC_UPPER ? 1 : -1,
                .round = arc_body_is_round(solid),
                .hollow = arc_body_is_hollow(solid),
                .radius = fabs(arc_body_radius(solid)),
                .size = def->size,
                .height = def->height};
  m.core = arc_body_is_core(solid);
  m.half_s = arc_body_half_length(solid);
  m.depth = arc_body_depth(solid);
  m.crest = arc_body_crest(solid);
  m.near_s = near_s;
  m.near_d = near_d;
  m.root_level = choose_root_level(def, &m);
  const double unit = ldexp(1, m.root_level), deep = m.core ? 1.9 * m.radius : m.depth;
  m.columns = count_cells(m.half_s, unit * def->size);
  m.lines = count_cells(deep, unit * def->height);
  /* Columns beside the contact may be compressed at most to half their width. */
  const double beside = m.half_s - near_s;
  if (m.columns * unit * def->size < near_s + beside / 2) m.columns++;
  m.units_s = m.columns * unit * def->size;
  m.units_d = m.lines * unit * def->height;
  lay_layers(&m);
  return m;
}

/* Returns the change of the depth [mm] of row j that moves rows onto the interfaces of layers.
 * The change is linear between interfaces, and zero at the surface and the base. */
static double shift_at(const body_map *m, double j) {
  double above = 0, from = 0;
  for (int l = 0; l < m->layers; l++) {
    if (j <= m->line[l]) return from + (m->shift[l] - from) * (j - above) / (m->line[l] - above);
    above = m->line[l];
    from = m->shift[l];
  }
  return from * (1 - (j - above) / (m->units_d / m->height - above));
}

static double depth_at(const body_map *m, double j) {
  const double d = plain_depth(m, j * m->height);
  return m->layers > 0 ? d + shift_at(m, j) : d;
}

static double radius_at(const body_map *m, double depth) {
  if (m->hollow) return m->radius + depth;
  if (!m->core || depth <= m->near_d) return m->radius - depth;
  const double r0 = m->radius - m->near_d;
  return r0 * exp(-(depth - m->near_d) / r0);
}

/* Computes a point of a rectangle. Surface heights decay linearly to zero at the base. */
static void point_of_block(const body_map *m, double along, double j, double xy[2]) {
  const double depth = depth_at(m, j), inset = arc_body_inset(m->solid, m->crest, along);
  xy[0] = along;
  xy[1] = m->up * (inset == 0 ? depth : depth + inset * (1 - depth / m->depth));
}

/* Computes a point of an arc about (0, R), or about (0, -R) if the arc has the opposite
 * curvature. */
static void point_of_arc(const body_map *m, double along, double j, double xy[2]) {
  const double r = radius_at(m, depth_at(m, j)), angle = along / m->radius;
  const double side = m->hollow ? -m->up : m->up;
  /* R - r cos(angle), without cancellation near the apex */
  const double half = sin(angle / 2);
  const int end = fabs(along) >= m->half_s, closed = arc_body_map_closed(m);
  xy[0] = end && closed ? 0 : r * sin(angle);
  xy[1] = side * (end && !closed ? m->radius : (m->radius - r) + 2 * r * half * half);
}

void arc_body_map_point(const body_map *m, double i, double j, double xy[2]) {
  const double s = fabs(i) * m->size;
  const double there = s >= m->units_s ? m->half_s : stretch(s, m->near_s, m->units_s, m->half_s);
  const double along = i < 0 ? -there : there;
  if (m->round)
    point_of_arc(m, along, j, xy);
  else
    point_of_block(m, along, j, xy);
}

double arc_body_map_unit(const body_map *m, double j) {
  if (!m->core) return m->size;
  return m->size * radius_at(m, j * m->height) / m->radius;
}
