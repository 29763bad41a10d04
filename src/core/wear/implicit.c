/* Implicit updates: the wear uses the pressures of the geometry it ends in (order 1, backward
 * Euler), or of two such stages (order 2, the L-stable two-stage SDIRK method). Newton on the
 * depths of both surfaces; each contact solution brings its own Jacobian. The depths that result
 * are made of pressures actually solved for, so that volumes stay exact. */
#include "core/base/dense.h"
#include "core/wear/step.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { newton_limit = 12, halvings = 5 };
static const double newton_tolerance = 1e-10; /* of the largest depth at hand */
/* Steps share the tolerance: errors of the first ones fade as the pressure flattens. Found on the
 * four strokes. */
static const double share_per_step = 0.5;
static const double gamma2 = 0.29289321881345247560; /* 1 - 1 / sqrt(2) */

typedef struct implicit_solver {
  arc_wear *w;
  wear_window window; /* with `trial`, and `jacobian` where it is wanted */
  wear_trial trial;
  wear_watch *watch;
  wear_dose dose;
  arc_error error;
  int n;
  double even, peak;                                    /* of the last evaluation */
  double *z, *residual, *step, *known, *down, *rate[3]; /* [n] each */
  double *jacobian, *matrix;                            /* [n x n] each */
  int *pivots;
} implicit_solver;

static arc_status solver_create(implicit_solver *s) {
  const size_t n = (size_t)s->n;
  double *block = calloc(8 * n + 2 * n * n, sizeof *block);
  s->pivots = malloc(n * sizeof(int));
  s->z = block;
  if (!block || !s->pivots) return ARC_MEMORY;
  double **member[] = {&s->z,    &s->residual, &s->step,    &s->known,
                       &s->down, &s->rate[0],  &s->rate[1], &s->rate[2]};
  for (int m = 0; m < 8; m++) *member[m] = block + (size_t)m * n;
  s->jacobian = block + 8 * n;
  s->matrix = s->jacobian + n * n;
  s->window.trial = &s->trial;
  for (int b = 0; b < ARC_BODIES; b++) {
    const size_t at = b == ARC_CYLINDER ? 0 : (size_t)s->w->nc;
    arc_shape_downward(s->window.shape, (arc_body)b, s->down + at);
    s->trial.depth[b] = s->z + at;
    s->trial.down[b] = s->down + at;
  }
  return ARC_OK;
}

static double k_at(const implicit_solver *s, int i) {
  return s->dose.k[i < s->w->nc ? ARC_CYLINDER : ARC_PLATE];
}

/* Wear per cycle [mm] at depths z beyond the shape's into `rate`; the Jacobian with it if asked
 * for. */
static arc_status evaluate(implicit_solver *s, double *rate, int with_jacobian) {
  wear_rate here = {.node = {rate, rate + s->w->nc}};
  s->window.jacobian = with_jacobian ? s->jacobian : NULL;
  const arc_status status = arc_wear_evaluate(s->w, &s->window, s->watch, &here, &s->error);
  if (status != ARC_OK) return status;
  for (int i = 0; i < s->n; i++) rate[i] *= k_at(s, i);
  s->even = here.even;
  s->peak = here.peak;
  return ARC_OK;
}

/* residual = z - known - h rate; its largest entry. */
static double residual_of(implicit_solver *s, double h, const double *rate) {
  double largest = 0;
  for (int i = 0; i < s->n; i++) {
    s->residual[i] = s->z[i] - s->known[i] - h * rate[i];
    largest = fmax(largest, fabs(s->residual[i]));
  }
  return largest;
}

/* Factors I + h k J and solves for `x` in place. */
static arc_status newton_direction(implicit_solver *s, double h, double *x) {
  const int n = s->n;
  for (int j = 0; j < n; j++)
    for (int i = 0; i < n; i++)
      s->matrix[dense_at(i, j, n)] = (i == j) + h * k_at(s, i) * s->jacobian[dense_at(i, j, n)];
  return arc_dense_solve(n, s->matrix, s->pivots, x) ? ARC_NUMERIC : ARC_OK;
}

/* Along the step, halved until the residual falls. A contact that leaves its zone on the way counts
 * as no fall. */
static arc_status line_search(implicit_solver *s, double h, double *rate, double *size) {
  const double before = *size;
  double share = 1, last = 0;
  for (int half = 0; half <= halvings; half++, share /= 2) {
    for (int i = 0; i < s->n; i++) s->z[i] -= (share - last) * s->step[i];
    last = share;
    const arc_status status = evaluate(s, rate, 1);
    if (status == ARC_STOPPED || status == ARC_CALLBACK || status == ARC_MEMORY) return status;
    if (status != ARC_OK) continue;
    *size = residual_of(s, h, rate);
    if (*size < before * (1 - 0.1 * share)) return ARC_OK;
  }
  return ARC_NOT_CONVERGED;
}

static double largest_of(const double *v, int n) {
  double largest = 0;
  for (int i = 0; i < n; i++) largest = fmax(largest, fabs(v[i]));
  return largest;
}

/* Solves z = known + h rate(z) from the present z; rate is that of the solution. */
static arc_status solve_stage(implicit_solver *s, double h, double *rate) {
  arc_status status = evaluate(s, rate, 1);
  if (status == ARC_ZONE || status == ARC_NUMERIC)
    return ARC_NOT_CONVERGED; /* the guess went too far */
  if (status != ARC_OK) return status;
  double size = residual_of(s, h, rate);
  const double depth = fmax(arc_shape_depth(s->window.shape, ARC_CYLINDER),
                            arc_shape_depth(s->window.shape, ARC_PLATE));
  for (int it = 0; it < newton_limit; it++) {
    if (size <= newton_tolerance * (depth + largest_of(s->z, s->n))) return ARC_OK;
    memcpy(s->step, s->residual, (size_t)s->n * sizeof(double));
    if (newton_direction(s, h, s->step) != ARC_OK) return ARC_NOT_CONVERGED;
    if ((status = line_search(s, h, rate, &size)) != ARC_OK) return status;
  }
  return ARC_NOT_CONVERGED;
}

/* Backward Euler; its error by comparison with the trapezoid. */
static arc_status first_order(implicit_solver *s, double cycles, double *defect) {
  for (int i = 0; i < s->n; i++) s->z[i] = cycles * s->rate[0][i];
  const arc_status status = solve_stage(s, cycles, s->rate[2]);
  for (int i = 0; i < s->n && status == ARC_OK; i++) {
    s->z[i] = cycles * s->rate[2][i];
    defect[i] = cycles * (s->rate[2][i] - s->rate[0][i]) / 2;
  }
  return status;
}

/* Two stages at gamma and 1; the error by comparison with the quadrature through the start and both
 * stages. */
static arc_status second_order(implicit_solver *s, double cycles, double *defect) {
  const double g = gamma2, h = g * cycles;
  const double b1 = 1 / (6 * g * (1 - g)), b2 = (1 / 3.0 - g / 2) / (1 - g), b0 = 1 - b1 - b2;
  for (int i = 0; i < s->n; i++) s->z[i] = h * s->rate[0][i];
  arc_status status = solve_stage(s, h, s->rate[1]);
  if (status != ARC_OK) return status;
  for (int i = 0; i < s->n; i++) {
    s->known[i] = cycles * (1 - g) * s->rate[1][i];
    s->z[i] = s->known[i] + h * s->rate[1][i];
  }
  status = solve_stage(s, h, s->rate[2]);
  for (int i = 0; i < s->n && status == ARC_OK; i++) {
    s->z[i] = s->known[i] + h * s->rate[2][i];
    defect[i] =
        cycles * (b0 * s->rate[0][i] + (b1 - 1 + g) * s->rate[1][i] + (b2 - g) * s->rate[2][i]);
  }
  return status;
}

/* Root mean square of the defect over the worn part of one body [mm]. At a scar's edge the error of
 * single nodes does not fall with the mesh, yet it moves nothing that anyone measures: a maximum
 * would ask for ever shorter steps. */
static double worn_mean(const implicit_solver *s, arc_body b, const double *defect,
                        double deepest) {
  static const double worn = 0.01; /* of the deepest node */
  const shape_side *side = &s->window.shape->side[b];
  double sum = 0, width = 0;
  for (int i = 0; i < side->n; i++) {
    if (side->h[i] + s->trial.depth[b][i] < worn * deepest) continue;
    const double w = arc_shape_width(side, i);
    sum += w * defect[i] * defect[i];
    width += w;
  }
  return width > 0 ? sqrt(sum / width) : 0;
}

/* The estimated error over what is allowed. Stiff ripples, which the step damps, are filtered out
 * first. */
static double share_of_tolerance(implicit_solver *s, double h, double *defect) {
  const double allowed = s->w->def.tolerance * share_per_step;
  if (allowed == 0 || newton_direction(s, h, defect) != ARC_OK) return 0;
  double share = 0;
  for (int b = 0; b < ARC_BODIES; b++) {
    double deepest = 0;
    for (int i = 0; i < s->window.shape->side[b].n; i++)
      deepest = fmax(deepest, s->window.shape->side[b].h[i] + s->trial.depth[b][i]);
    const double *own = b == ARC_CYLINDER ? defect : defect + s->w->nc;
    if (deepest > 0)
      share = fmax(share, worn_mean(s, (arc_body)b, own, deepest) / (allowed * deepest));
  }
  return share;
}

static arc_status run(implicit_solver *s, wear_depths *depth) {
  const double cycles = s->dose.cycles;
  arc_status status = evaluate(s, s->rate[0], 0); /* z = 0: at the start */
  if (status != ARC_OK) return status;
  double *defect = s->known;
  const int first = s->w->def.order == 1;
  if (first)
    status = first_order(s, cycles, s->step);
  else
    status = second_order(s, cycles, s->step);
  if (status != ARC_OK) return status;
  memcpy(defect, s->step, (size_t)s->n * sizeof(double));
  depth->error = share_of_tolerance(s, first ? cycles : gamma2 * cycles, defect);
  memcpy(depth->node[0], s->z, (size_t)s->n * sizeof(double));
  return ARC_OK;
}

static arc_status tell(const implicit_solver *s, arc_status status, arc_error *error) {
  if (status != ARC_NOT_CONVERGED) {
    if (status != ARC_OK && error) *error = s->error;
    return status;
  }
  const char *why = s->error.message;
  return arc_fail(error, status, "the implicit step did not converge for %g cycles%s%s",
                  s->dose.cycles, why[0] ? "; on the way " : "", why);
}

arc_status arc_wear_implicit(arc_wear *w, const wear_window *window, const wear_dose *dose,
                             wear_watch *watch, wear_depths *depth, arc_error *error) {
  implicit_solver s = {.w = w, .window = *window, .watch = watch, .dose = *dose};
  s.n = w->nc + w->np;
  /* under even wear the plate's nodes do not move against each other */
  if (w->procedure == ARC_NSP) s.dose.k[ARC_PLATE] = 0;
  depth->error = 0;
  arc_status status = solver_create(&s);
  if (status != ARC_OK)
    arc_fail(&s.error, status, "out of memory for an implicit step");
  else
    status = run(&s, depth);
  depth->even = wears_evenly(w) ? dose->cycles * dose->k[ARC_PLATE] * s.even : 0;
  depth->peak = s.peak;
  free(s.z);
  free(s.pivots);
  return tell(&s, status, error);
}
