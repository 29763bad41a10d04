/* Radial compliance of concentric layers for each degree of spherical harmonics. In each layer the
 * equations of elasticity have four solutions, each proportional to a power r^s of the radius.
 * Their displacement is U Y along the radius and V grad Y along the sphere, with the spherical
 * harmonic Y, U = a r^s and V = b r^s. A small dense system couples the solutions of all layers. */
#include "core/sphere/sphere.h"

#include "core/base/dense.h"

#include <math.h>
#include <string.h>

enum { most_shells = ARC_MOST_LAYERS + 1, most = 4 * most_shells };

/* A layer between two radii [mm]; a solid sphere has inner radius 0. */
typedef struct shell {
  double inner, outer, lambda, mu;
} shell;

/* Layers from inside to outside. */
typedef struct stack {
  int count;
  shell shell[most_shells];
} stack;

/* One solution of a layer, with U = a (r / unit)^s and V = b (r / unit)^s at the radius r. */
typedef struct power {
  double s, a, b, unit;
} power;

static shell shell_of(double inner, double outer, arc_material m) {
  return (shell){inner, outer, m.E * m.nu / ((1 + m.nu) * (1 - 2 * m.nu)), m.E / (2 * (1 + m.nu))};
}

static stack cup_stack(const arc_joint_def *def) {
  stack s = {0};
  double r = def->radius;
  for (int i = 0; i < ARC_MOST_LAYERS && def->cup[i].thickness > 0; i++) {
    s.shell[s.count++] = shell_of(r, r + def->cup[i].thickness, def->cup[i].material);
    r += def->cup[i].thickness;
  }
  return s;
}

static stack head_stack(const arc_joint_def *def) {
  stack s = {0};
  double r = def->radius;
  int layers = 0;
  while (layers < ARC_MOST_LAYERS && def->head[layers].thickness > 0)
    r -= def->head[layers++].thickness;
  s.shell[s.count++] = shell_of(0, r, def->core);
  while (layers-- > 0) {
    s.shell[s.count++] = shell_of(r, r + def->head[layers].thickness, def->head[layers].material);
    r += def->head[layers].thickness;
  }
  return s;
}

/* Computes the solutions of a layer at degree l. The solutions that increase with r are stored
 * first. Returns the number of solutions. */
static int powers_of(const shell *m, int l, power *p) {
  const double L = (double)l * (l + 1), q = m->lambda + 2 * m->mu;
  const double exponent[] = {l - 1.0, l + 1.0, -l - 2.0, -(double)l};
  const int decaying = m->inner > 0;
  if (l == 0) {
    p[0] = (power){1, 1, 0, m->outer};
    p[1] = (power){-2, 1, 0, m->inner};
    return 1 + decaying;
  }
  for (int i = 0; i < 4; i++) {
    const double s = exponent[i];
    p[i] = (power){s, (q * L - m->mu * s * (s + 1)) / (q * L), (q * (s + 2) - m->mu * s) / (q * L),
                   i < 2 ? m->outer : m->inner};
  }
  p[0].a = 1, p[0].b = 1.0 / l;
  p[2].a = 1, p[2].b = -1 / (l + 1.0);
  return decaying ? 4 : 2;
}

/* Computes the four entries of `value` for a solution at radius r: the displacements U and V, then
 * the radial and the tangential stress, both divided by `scale`. */
static void evaluate(const shell *m, int l, const power *p, double r, double scale, double *value) {
  const double L = (double)l * (l + 1), f = pow(r / p->unit, p->s), g = f / r / scale;
  value[0] = p->a * f;
  value[1] = p->b * f;
  value[2] = (m->lambda * ((p->s + 2) * p->a - L * p->b) + 2 * m->mu * p->s * p->a) * g;
  value[3] = m->mu * ((p->s - 1) * p->b + p->a) * g;
}

/* Returns the displacement of one body under a unit pressure on its surface, which is the innermost
 * radius of a cup and the outermost radius of a head. The system has two equations at the bottom,
 * four at each interface, and two at the top. */
static double solve_degree(const stack *s, int l, int is_cup, double scale) {
  double matrix[most * most] = {0}, right[most] = {0};
  power solution[most_shells][4];
  int count[most_shells], first[most_shells + 1] = {0}, pivots[most];
  const int used = l == 0 ? 1 : 2; /* number of displacement components, and of stress components */
  for (int i = 0; i < s->count; i++) {
    count[i] = powers_of(&s->shell[i], l, solution[i]);
    first[i + 1] = first[i] + count[i];
  }
  const int n = first[s->count];
  int row = 0;
  double v[4];
  for (int end = 0; end <= s->count; end++) { /* boundary below layer `end` */
    const int bottom = end == 0, top = end == s->count;
    if (bottom && !is_cup) continue; /* a head has no inner boundary, because it is solid */
    const int from = bottom ? 0 : end - 1, to = top ? end - 1 : end;
    const double r = bottom ? s->shell[0].inner : s->shell[end - 1].outer;
    const int kinds = bottom || top ? used : 2 * used;
    const int stress = bottom || (top && !is_cup);
    for (int i = from; i <= to; i++)
      for (int j = 0; j < count[i]; j++) {
        evaluate(&s->shell[i], l, &solution[i][j], r, scale, v);
        const double sign = !bottom && !top && i == to ? -1 : 1;
        for (int k = 0; k < kinds; k++) {
          const int which = bottom || top ? k + 2 * stress : (k / used) * 2 + k % used;
          matrix[dense_at(row + k, first[i] + j, n)] = sign * v[which];
        }
      }
    if (stress) right[row] = -1 / scale;
    row += kinds;
  }
  if (arc_dense_factor(n, matrix, pivots) != 0) return NAN;
  arc_dense_factor_solve(n, 1, matrix, pivots, right);
  const int at = is_cup ? 0 : s->count - 1;
  const double r = is_cup ? s->shell[0].inner : s->shell[at].outer;
  double U = 0;
  for (int j = 0; j < count[at]; j++) {
    evaluate(&s->shell[at], l, &solution[at][j], r, scale, v);
    U += right[first[at] + j] * v[0];
  }
  return is_cup ? U : -U;
}

double arc_joint_compliance(const arc_joint_def *def, arc_body body, int degree) {
  const stack s = body == ARC_UPPER ? head_stack(def) : cup_stack(def);
  const double stiff = s.shell[body == ARC_UPPER ? s.count - 1 : 0].mu;
  if (body == ARC_UPPER && degree == 1) return 0;
  return solve_degree(&s, degree, body == ARC_LOWER, stiff * (degree + 1) / def->radius);
}

double arc_sphere_limit(const arc_joint_def *def, int rows) {
  return (rows + 0.5) *
         (arc_joint_compliance(def, ARC_UPPER, rows) + arc_joint_compliance(def, ARC_LOWER, rows));
}

/* Returns the stiffness of the Winkler springs. The springs represent the liner only, because
 * the deformation of the shells outside the liner is negligible. */
double arc_sphere_winkler(const arc_joint_def *def) {
  const arc_material m = def->cup[0].material;
  const double out = 1 + def->cup[0].thickness / def->radius, q = out * out * out;
  if (def->foundation == ARC_FOUNDATION_COLUMN)
    return m.E * (1 - m.nu) / ((1 + m.nu) * (1 - 2 * m.nu) * def->cup[0].thickness);
  return m.E * (1 / (1 - 2 * m.nu) + 2 * q / (1 + m.nu)) / (def->radius * (q - 1));
}
