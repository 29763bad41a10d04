/* If surfaces and motion are exactly symmetric about x = 0, the wear of the second half of a
 * stroke is the mirror image of the wear of the first half. Then only half of the contact
 * problems are solved. Symmetric runs remain exactly symmetric, also those of a contact at rest. */
#include "core/plane/cycle.h"

static int is_mirrored_motion(const wear_block *b) {
  const int last = b->count - 1;
  if (last % 2 || b->problems == 1) return 0;
  for (int i = 0; 2 * i <= last; i++)
    if (b->problem_x[i] != -b->problem_x[last - i] || b->x[i] != -b->x[last - i] ||
        b->line[i] != b->line[last - i] || b->angle[i] != -b->angle[last - i])
      return 0;
  return 1;
}

static int is_mirrored_list(int n, const double *xy) {
  for (int i = 0; 2 * i < n; i++)
    if (xy[2 * i] != -xy[2 * (n - 1 - i)] || xy[2 * i + 1] != xy[2 * (n - 1 - i) + 1]) return 0;
  return 1;
}

static int is_mirrored_shape(const arc_shape *shape) {
  for (int b = 0; b < ARC_BODIES; b++) {
    const shape_side *side = &shape->side[b];
    if (!is_mirrored_list(side->n, side->xy) || !is_mirrored_list(side->n, side->settled)) return 0;
  }
  return 1;
}

static int is_mirrored_depth(const arc_wear *w, const double *depth) {
  for (int b = 0; b < ARC_BODIES; b++) {
    const double *h = b == ARC_CYLINDER ? depth : depth + w->nc;
    const int n = sites_of(w, b);
    for (int i = 0; 2 * i < n; i++)
      if (h[i] != h[n - 1 - i]) return 0;
  }
  return 1;
}

int arc_wear_has_local_factors(const arc_wear *w, const wear_window *window) {
  return w->def.local_factor && window->state;
}

/* Returns true if the surfaces of a window are exactly symmetric and wear by rigid slip. Returns 0
 * for imported meshes, whose interior may be asymmetric. */
static int has_mirrored_surfaces(const arc_wear *w, const wear_window *window) {
  return w->def.slip == ARC_SLIP_RIGID && !arc_model_is_given(w->model) &&
         (!window->depth || is_mirrored_depth(w, window->depth)) &&
         is_mirrored_shape(window->shape);
}

/* Returns 0 in four cases even if surfaces and motion are symmetric: imported meshes, whose
 * interior may be asymmetric; the simple rule, which uses only one end of an increment; elastic
 * slip; and Jacobians with local factors. */
int arc_wear_is_mirrored(const arc_wear *w, const wear_window *window) {
  const wear_block *block = window->block;
  return window->first == 0 && window->last == block->count - 1 && w->def.rule == ARC_TRAPEZOID &&
         !(window->tangent && arc_wear_has_local_factors(w, window)) && is_mirrored_motion(block) &&
         has_mirrored_surfaces(w, window);
}

/* Returns true if all points of a window have the load along y and the plate at x = 0. */
static int is_centred(const wear_window *window) {
  const wear_block *b = window->block;
  for (int at = window->first; at <= window->last; at++)
    if (b->problem_x[at] != 0 || b->angle[at] != 0) return 0;
  return 1;
}

int arc_wear_rests_mirrored(const arc_wear *w, const wear_window *window) {
  const revolution *r = &window->shape->side[ARC_UPPER].body->chart.revolved;
  return is_centred(window) && (!r->on || r->axis == 0) && !arc_wear_has_friction(&w->def) &&
         !arc_wear_has_local_factors(w, window) && has_mirrored_surfaces(w, window);
}

static void fold(double *a, double *b) {
  const double sum = *a + *b;
  *a = *b = sum;
}

static void fold_list(int n, double *list) {
  for (int i = 0; 2 * i < n - 1; i++) fold(&list[i], &list[n - 1 - i]);
  if (n % 2) list[n / 2] *= 2;
}

/* Returns the index of the mirror image of unknown i. The unknowns are the depths at the nodes
 * of both bodies, cylinder first. */
static int image(const arc_wear *w, int i) {
  return i < w->nc ? w->nc - 1 - i : w->nc + (w->np - 1 - (i - w->nc));
}

static void fold_jacobian(const arc_wear *w, double *value) {
  const int n = w->nc + w->np;
  for (int c = 0; c < n; c++)
    for (int r = 0; r < n; r++) {
      const size_t at = (size_t)r + (size_t)c * (size_t)n;
      const size_t other = (size_t)image(w, r) + (size_t)image(w, c) * (size_t)n;
      if (at < other) fold(&value[at], &value[other]);
      if (at == other) value[at] *= 2;
    }
}

void arc_wear_symmetrise(const arc_wear *w, double *depth) {
  for (int b = 0; b < ARC_BODIES; b++) {
    double *h = sites_from(w, depth, b);
    const int n = sites_of(w, b);
    for (int i = 0; 2 * i < n; i++) h[i] = h[n - 1 - i] = (h[i] + h[n - 1 - i]) / 2;
  }
}

void arc_wear_add_mirror(const arc_wear *w, const wear_window *window, const wear_rate *images,
                         wear_rate *rate) {
  for (int b = 0; b < ARC_BODIES; b++) {
    const int n = w->shape->side[b].n;
    for (int i = 0; i < n && images; i++) rate->node[b][i] += images->node[b][i];
    if (!images) fold_list(n, rate->node[b]);
  }
  rate->pressed *= 2;
  if (window->tangent) fold_jacobian(w, window->tangent->value);
}

arc_status arc_wear_reflect(arc_wear *w, const wear_window *window, int at, const wear_point *law,
                            arc_error *error) {
  wear_point *image = &path_of(w)->image[at % 2];
  for (int b = 0; b < ARC_BODIES; b++) {
    const int n = w->shape->side[b].n;
    for (int i = 0; i < n; i++) {
      image->p[b][i] = law->p[b][n - 1 - i];
      image->q[b][i] = law->q[b][n - 1 - i];
    }
  }
  return arc_wear_find_local_factors(w, window->state, image, error);
}
