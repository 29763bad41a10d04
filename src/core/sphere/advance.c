/* Steps with error control: two updates of half a step are compared with one update of the whole
 * step. The second half solves the instants of the cycle in reverse order. */
#include "core/sphere/sphere.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* State and record of a joint before the step. */
typedef struct kept_state {
  double *list; /* list of numbers from arc_joint_state */
  arc_joint_record record;
} kept_state;

static arc_status remember(const arc_joint *j, const arc_joint_record *record, kept_state *was,
                           arc_error *error) {
  was->record = *record;
  was->list = malloc(arc_joint_state_count(j) * sizeof *was->list);
  if (!was->list) return arc_fail(error, ARC_MEMORY, "out of memory for a step");
  arc_joint_state(j, was->list);
  return ARC_OK;
}

/* Returns the depth maps of a state [2 sites]: first the head's map, then the cup's. */
static const double *depths(const kept_state *was) {
  return was->list + 3;
}

/* Returns the error estimate: the largest difference in depth between the whole step and the two
 * halves, divided by the depth that all cycles so far would cause at the rate of this step. */
static double difference(const arc_joint *j, const kept_state *was, const kept_state *whole) {
  const double steps = whole->record.cycles / (whole->record.cycles - was->record.cycles);
  double off = 0, gain = 0;
  for (int b = 0; b < ARC_BODIES; b++) {
    const double *before = depths(was) + (size_t)b * (size_t)j->sites;
    const double *once = depths(whole) + (size_t)b * (size_t)j->sites;
    for (int i = 0; i < j->sites; i++) {
      off = fmax(off, fabs(once[i] - j->h[b][i]));
      gain = fmax(gain, j->h[b][i] - before[i]);
    }
  }
  return gain > 0 ? off / (gain * steps) : 0;
}

/* Makes the step as one update, restores the state, and makes the step again as two halves. Sets
 * *error_made to the difference of the two results. */
static arc_status try_step(arc_joint *j, const arc_joint_wear_def *def, double cycles,
                           const kept_state *was, const arc_callbacks *callbacks,
                           arc_joint_record *record, double *error_made, arc_error *error) {
  kept_state whole = {0};
  arc_joint_record once = was->record;
  arc_status status = arc_joint_update(j, def, cycles, callbacks, &once, error);
  if (status == ARC_OK) status = remember(j, &once, &whole, error);
  if (status == ARC_OK) arc_sphere_restore(j, was->list);
  *record = was->record;
  record->solutions = once.solutions;
  record->iterations = once.iterations;
  for (int half = 0; half < 2 && status == ARC_OK; half++)
    status = arc_joint_update(j, def, cycles / 2, callbacks, record, error);
  if (status == ARC_OK) *error_made = difference(j, was, &whole);
  free(whole.list);
  return status;
}

arc_status arc_joint_advance(arc_joint *j, const arc_joint_wear_def *def, double tolerance,
                             double most, double *step, const arc_callbacks *callbacks,
                             arc_joint_record *record, arc_error *error) {
  const double grow = 2, shrink = 0.3, safety = 0.9;
  enum { attempts = 30 };
  kept_state was;
  arc_joint_record made = *record;
  double next = *step;
  if (!(tolerance > 0) || !(most > 0) || !(*step > 0))
    return arc_fail(error, ARC_ARGUMENT, "expected tolerance, cycles and step above 0");
  const size_t count = arc_joint_state_count(j);
  arc_status status = remember(j, record, &was, error);
  if (status != ARC_OK) return status;
  for (int attempt = 0; status == ARC_OK; attempt++) {
    const double cycles = next < most ? next : most;
    double off = 0;
    status = try_step(j, def, cycles, &was, callbacks, &made, &off, error);
    if (status != ARC_OK) break;
    const double factor = fmin(grow, fmax(shrink, safety * tolerance / fmax(off, 1e-300)));
    if (off <= tolerance) {
      /* A step shortened by the end of the run does not change the next length. */
      next = fmax(factor * cycles, cycles < next ? next : 0);
      break;
    }
    next = fmin(factor, safety) * cycles;
    if (attempt == attempts)
      status = arc_fail(error, ARC_NOT_CONVERGED,
                        "the step did not converge: a step of %g cycles and its two halves differ "
                        "by %.2g of the wear, expected %g",
                        cycles, off, tolerance);
    was.record.solutions = made.solutions;
    was.record.iterations = made.iterations;
    arc_sphere_restore(j, was.list);
  }
  if (status == ARC_OK) {
    *record = made;
    *step = next;
  } else {
    arc_sphere_back(j, was.list, count);
  }
  free(was.list);
  return status;
}
