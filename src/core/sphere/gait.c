/* Gaits: rotations and loads at the instants of a cycle. */
#include "archard/joint.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

static void multiply(const double a[9], const double b[9], double c[9]) {
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      c[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
}

static void transpose(const double a[9], double t[9]) {
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) t[3 * i + j] = a[3 * j + i];
}

/* Computes the matrix of a rotation about x (axis = 0), y (1) or z (2). */
static void about(int axis, double degrees, double R[9]) {
  const double c = cos(degrees * pi / 180), s = sin(degrees * pi / 180);
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  memset(R, 0, 9 * sizeof *R);
  R[4 * axis] = 1;
  R[4 * j] = R[4 * k] = c;
  R[3 * j + k] = -s;
  R[3 * k + j] = s;
}

/* Computes the rotation vector of the rotation matrix R. */
static void logarithm(const double R[9], double v[3]) {
  const double x = (R[7] - R[5]) / 2, y = (R[2] - R[6]) / 2, z = (R[3] - R[1]) / 2;
  const double sine = sqrt(x * x + y * y + z * z), cosine = (R[0] + R[4] + R[8] - 1) / 2;
  const double f = sine > 1e-12 ? atan2(sine, cosine) / sine : 1;
  v[0] = f * x, v[1] = f * y, v[2] = f * z;
}

arc_status arc_gait_from_rotations(int n, const double *rotation, const double *load,
                                   arc_gait_instant *instant, arc_error *error) {
  double back[9], step[9], open[3];
  if (n < 1)
    return arc_fail(error, ARC_ARGUMENT, "field 'increments': expected at least 1, got %d", n);
  transpose(rotation, back);
  multiply(rotation + 18 * (size_t)n, back, step);
  logarithm(step, open);
  const double gap = sqrt(open[0] * open[0] + open[1] * open[1] + open[2] * open[2]) * 180 / pi;
  if (!(gap < 1e-3))
    return arc_fail(error, ARC_ARGUMENT,
                    "the gait does not close: expected the same rotation at its end as at its "
                    "start, got rotations that differ by %.4g degrees",
                    gap);
  for (int i = 0; i < n; i++) {
    arc_gait_instant *to = &instant[i];
    transpose(rotation + 18 * (size_t)i, back);
    multiply(rotation + 18 * (size_t)(i + 1), back, step);
    logarithm(step, to->omega);
    memcpy(to->rotation, rotation + 18 * (size_t)i + 9, sizeof to->rotation);
    memcpy(to->load, load + 3 * (size_t)i, sizeof to->load);
  }
  return ARC_OK;
}

static int is_order(const char *order) {
  return strlen(order) == 3 && strchr(order, 'x') && strchr(order, 'y') && strchr(order, 'z');
}

arc_status arc_gait_from_angles(int n, const double *degrees, const double *load, const char *order,
                                arc_gait_instant *instant, arc_error *error) {
  if (!is_order(order))
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'order': expected the letters x, y and z, got \"%s\"", order);
  if (n < 1)
    return arc_fail(error, ARC_ARGUMENT, "field 'increments': expected at least 1, got %d", n);
  double *rotation = malloc(9 * (2 * (size_t)n + 1) * sizeof *rotation);
  if (!rotation) return arc_fail(error, ARC_MEMORY, "out of memory for a gait");
  for (int i = 0; i <= 2 * n; i++) {
    double turn[3][9] = {{0}}, both[9];
    for (int a = 0; a < 3; a++) about(order[a] - 'x', degrees[3 * i + order[a] - 'x'], turn[a]);
    multiply(turn[0], turn[1], both);
    multiply(both, turn[2], rotation + 9 * (size_t)i);
  }
  const arc_status status = arc_gait_from_rotations(n, rotation, load, instant, error);
  free(rotation);
  return status;
}

/* Returns the load [N] of the walking gaits at the time t (0 to 1) of the cycle: half cosines with
 * two peaks of 3000 N. */
static double walking_load(double t) {
  static const double at[] = {0, 0.12, 0.32, 0.5, 0.62, 1}, N[] = {300, 3000, 1500, 3000, 300, 300};
  int i = 0;
  while (i < 4 && t > at[i + 1]) i++;
  return N[i] + (N[i + 1] - N[i]) * (1 - cos(pi * (t - at[i]) / (at[i + 1] - at[i]))) / 2;
}

enum { ISO, PROSIM, FLEXION, ROCKING, GAITS };

static void pose(int gait, double t, double angle, double R[9]) {
  const double a = 2 * pi * t;
  double x[9], y[9], z[9], both[9];
  if (gait == ROCKING) {
    about(2, 360 * t, x);
    about(1, angle, y);
    about(2, -360 * t, z);
  } else {
    about(0,
          gait == ISO      ? 3.5 + 21.5 * cos(a)
          : gait == PROSIM ? 7.5 + 22.5 * cos(a)
                           : angle * cos(a),
          x);
    about(1, gait == ISO ? 1.5 + 5.5 * cos(2 * pi * (t - 0.21)) : 0, y);
    about(2, gait == ISO ? -4 - 6 * cos(a) : gait == PROSIM ? 10 * sin(a) : 0, z);
  }
  multiply(x, y, both);
  multiply(both, z, R);
}

arc_status arc_gait_named(const char *name, int n, double angle, double load,
                          arc_gait_instant *instant, arc_error *error) {
  static const char *const names[GAITS] = {"iso", "prosim", "flexion", "rocking"};
  int gait = 0;
  while (gait < GAITS && strcmp(names[gait], name) != 0) gait++;
  if (gait == GAITS)
    return arc_fail(error, ARC_ARGUMENT,
                    "expected the gait \"iso\", \"prosim\", \"flexion\" or \"rocking\", got \"%s\"",
                    name);
  if (n < 1)
    return arc_fail(error, ARC_ARGUMENT, "field 'increments': expected at least 1, got %d", n);
  double *rotation = malloc((2 * (size_t)n + 1) * 9 * sizeof *rotation);
  double *force = calloc(3 * (size_t)n, sizeof *force);
  arc_status status = ARC_MEMORY;
  if (rotation && force) {
    for (int i = 0; i <= 2 * n; i++) pose(gait, i / (2.0 * n), angle, rotation + 9 * (size_t)i);
    for (int i = 0; i < n; i++)
      force[3 * (size_t)i + 2] = gait < FLEXION ? walking_load((i + 0.5) / n) : load;
    status = arc_gait_from_rotations(n, rotation, force, instant, error);
  } else {
    arc_fail(error, ARC_MEMORY, "out of memory for a gait");
  }
  free(rotation);
  free(force);
  return status;
}

/* Returns |omega x F| at an instant [N], with the rotation vector omega [rad] and the load F. Sets
 * *load to |F| [N]. The sliding distance at the point under the load is |omega x F| / |F| times the
 * radius. */
static double sliding(const arc_gait_instant *i, double *load) {
  const double *w = i->omega, *F = i->load;
  *load = sqrt(F[0] * F[0] + F[1] * F[1] + F[2] * F[2]);
  return sqrt(pow(w[1] * F[2] - w[2] * F[1], 2) + pow(w[2] * F[0] - w[0] * F[2], 2) +
              pow(w[0] * F[1] - w[1] * F[0], 2));
}

double arc_gait_track(int n, const arc_gait_instant *instant, double radius) {
  double sum = 0, load;
  for (int i = 0; i < n; i++) {
    const double moved = sliding(&instant[i], &load);
    if (load > 0) sum += moved / load * radius;
  }
  return sum;
}

double arc_gait_work(int n, const arc_gait_instant *instant, double radius) {
  double sum = 0, load;
  for (int i = 0; i < n; i++) sum += sliding(&instant[i], &load) * radius;
  return sum;
}
