/* The complete state of a joint as one list of numbers, from which a run continues with identical
 * results. The list begins with three numbers: rows of the lattice, rows of the window, and
 * instants with initial pressures. Maps follow: depths of head and cup, cross-shear of the last
 * cycle, pressures of the last contact, creep, and the pressures integrated over cycles. The list
 * ends with the initial pressures. */
#include "core/sphere/sphere.h"

#include <math.h>
#include <string.h>

enum { header = 3, maps = 8 /* `maps` is the number of values per site in all maps */ };

static size_t window_of(const arc_joint *j) {
  return (size_t)j->size * (size_t)j->size;
}

size_t arc_joint_state_count(const arc_joint *j) {
  return header + maps * (size_t)j->sites + (size_t)j->kept_count * window_of(j);
}

/* One part of a state, which is stored as a list of parts. */
typedef struct state_part {
  double *at;
  size_t count;
} state_part;

enum { parts = 7 };

static void list_parts(const arc_joint *j, state_part part[parts]) {
  const size_t n = (size_t)j->sites;
  part[0] = (state_part){j->h[ARC_UPPER], n};
  part[1] = (state_part){j->h[ARC_LOWER], n};
  part[2] = (state_part){j->shear, 3 * n};
  part[3] = (state_part){j->p, n};
  part[4] = (state_part){j->creep, n};
  part[5] = (state_part){j->pressed, n};
  part[6] = (state_part){j->kept, (size_t)j->kept_count * window_of(j)};
}

void arc_joint_state(const arc_joint *j, double *state) {
  state_part part[parts];
  list_parts(j, part);
  state[0] = j->rows, state[1] = j->size, state[2] = j->kept_count;
  state += header;
  for (int i = 0; i < parts; state += part[i++].count)
    if (part[i].count > 0) memcpy(state, part[i].at, part[i].count * sizeof *state);
}

void arc_sphere_restore(arc_joint *j, const double *state) {
  state_part part[parts];
  j->kept_count = (int)state[1] == j->size ? (int)state[2] : 0;
  list_parts(j, part);
  state += header;
  for (int i = 0; i < parts; state += part[i++].count)
    if (part[i].count > 0) memcpy(part[i].at, state, part[i].count * sizeof *state);
}

static arc_status refuse(arc_error *error, const char *what) {
  return arc_fail(error, ARC_FORMAT, "the stored state is damaged: %s", what);
}

/* Returns true if a number of the header is an integer in the range. */
static int is_whole(double value, double low, double high) {
  return value >= low && value <= high && value == floor(value);
}

static arc_status check(const arc_joint *j, const double *state, size_t count, arc_error *error) {
  const size_t most = 100000; /* largest number of instants, as for gaits */
  if (count < header) return refuse(error, "the header is incomplete");
  if (state[0] != j->rows) return refuse(error, "it has another number of rows");
  if (!is_whole(state[1], 2, j->rows) || fmod(state[1], 2) != 0)
    return refuse(error, "the size of its contact is out of range");
  if (!is_whole(state[2], 0, (double)most))
    return refuse(error, "its number of instants is out of range");
  const size_t fixed = header + maps * (size_t)j->sites;
  if (count != fixed + (size_t)state[2] * (size_t)state[1] * (size_t)state[1])
    return refuse(error, "its length is wrong");
  for (size_t i = header; i < count; i++)
    if (!isfinite(state[i])) return refuse(error, "it contains NaN or infinite values");
  for (size_t i = fixed; i < count; i++)
    if (state[i] < 0) return refuse(error, "pressures are negative");
  for (size_t i = header; i < header + 2 * (size_t)j->sites; i++)
    if (!(fabs(state[i]) < j->def.radius)) return refuse(error, "depths are beyond the radius");
  return ARC_OK;
}

arc_status arc_joint_set_state(arc_joint *j, const double *state, size_t count, arc_error *error) {
  arc_status status = check(j, state, count, error);
  if (status == ARC_OK && (int)state[1] != j->size)
    status = arc_sphere_open(j, (int)state[1], error);
  if (status == ARC_OK) status = arc_sphere_make_kept(j, (int)state[2], error);
  if (status == ARC_OK) arc_sphere_restore(j, state);
  return status;
}

void arc_sphere_back(arc_joint *j, const double *state, size_t count) {
  arc_error ignored;
  if (arc_joint_set_state(j, state, count, &ignored) != ARC_OK && j->gap)
    arc_sphere_restore(j, state);
}

size_t arc_joint_bytes(const arc_joint *j) {
  const size_t n = window_of(j), size = (size_t)j->size;
  size_t numbers = 12 * (size_t)j->sites + (15 + (size_t)j->kept_count) * n;
  if (j->kernel)
    numbers += (size_t)j->kernel->waves * size * (size + 4) + 4096 /* table of the compliance */;
  return sizeof *j + numbers * sizeof(double);
}
