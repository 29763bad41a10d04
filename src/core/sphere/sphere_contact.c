/* Solves one contact of a joint: an active-set problem in which the components of the head's
 * displacement are three rigid-body unknowns. */
#include "core/sphere/sphere.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* Gap at cells outside the cup [mm], so large that these cells are never in contact. */
static const double open_gap = 1e3;

static void axis_of(const arc_joint *j, double axis[3]) {
  const double incl = j->def.inclination * pi / 180;
  axis[0] = sin(incl), axis[1] = 0, axis[2] = cos(incl);
}

static double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* --- the problem ------------------------------------------------------------------------------ */

/* Multiplies the pressures by the compliance, which includes the wear per pressure in this
 * contact. */
static arc_status apply(void *context, const double *p, double *u) {
  arc_joint *j = context;
  const int n = j->size * j->size;
  if (j->kernel) {
    arc_sphere_kernel_apply(j->kernel, p, u);
    for (int c = 0; c < n; c++) u[c] += j->soft[c] * p[c];
  } else {
    for (int c = 0; c < n; c++) u[c] = (1 / j->K + j->soft[c]) * p[c];
  }
  return ARC_OK;
}

/* Returns true if the head is worn. An unworn head needs no interpolation, which saves a third of
 * the time on a Winkler foundation. */
static int head_is_worn(const arc_joint *j) {
  for (int i = 0; i < j->sites; i++)
    if (j->h[ARC_UPPER][i] != 0) return 1;
  return 0;
}

/* Computes the gaps for the head at rotation R. The second-order terms use the head's
 * displacement u [mm]. */
static void set_gaps(arc_joint *j, const double R[9], const double u[3]) {
  const double least = cos(j->def.cover * pi / 180);
  double axis[3], on_head[3];
  const int worn = head_is_worn(j);
  axis_of(j, axis);
  for (int c = 0; c < j->size * j->size; c++) {
    const int site = sphere_site(j, c);
    const double *n = j->normal + 3 * (size_t)site;
    arc_sphere_rotate_back(R, n, on_head);
    j->gap[c] = dot(n, axis) < least
                    ? open_gap
                    : j->def.clearance + j->h[ARC_LOWER][site] + j->creep[site] +
                          (worn ? arc_sphere_cubic(j, j->h[ARC_UPPER], on_head) : 0) +
                          (dot(u, u) - pow(dot(u, n), 2)) / (2 * j->def.radius);
  }
}

static void set_softness(arc_joint *j, const sphere_stand *at) {
  for (int c = 0; c < j->size * j->size; c++) {
    const int site = sphere_site(j, c);
    const double k = at->k ? at->k[site] : 1;
    j->soft[c] = at->omega ? at->dose * k * arc_sphere_sliding(j, at->omega, site) : 0;
  }
}

/* Half angle of the cap that has initial pressures, divided by the half angle of the window, for
 * each attempt. */
static const double caps[] = {0.5, 0.25, 0.8, 0.12, 0.06};
enum { attempts = sizeof caps / sizeof *caps };

/* Sets the initial pressures: at the first attempt the pressures stored for the instant, otherwise
 * pressures on a cap around the direction of the load. */
static void start(arc_joint *j, const sphere_stand *at, int attempt) {
  const size_t n = (size_t)j->size * (size_t)j->size;
  double sum = 0;
  if (attempt == 0 && at->instant >= 0 && at->instant < j->kept_count)
    memcpy(j->press, j->kept + (size_t)at->instant * n, n * sizeof *j->press);
  else
    memset(j->press, 0, n * sizeof *j->press);
  for (size_t c = 0; c < n; c++) sum += j->press[c];
  if (sum > 0) return;
  const double load = sqrt(dot(at->load, at->load)),
               least = cos(fmax(3, caps[attempt] * j->size / 2) * j->d);
  for (size_t c = 0; c < n; c++) {
    const double cosine = dot(j->normal + 3 * (size_t)sphere_site(j, (int)c), at->load) / load;
    j->press[c] = cosine > least && j->gap[c] < open_gap ? cosine - least : 0;
  }
}

static int touches_rim(const arc_joint *j) {
  const int m = j->size;
  for (int i = 0; i < m; i++)
    if (j->press[i] > 0 || j->press[(m - 1) * m + i] > 0 || j->press[i * m] > 0 ||
        j->press[i * m + m - 1] > 0)
      return 1;
  return 0;
}

static void keep(arc_joint *j, int instant) {
  const size_t n = (size_t)j->size * (size_t)j->size;
  if (instant < 0) return;
  if (instant >= j->kept_count) {
    double *more = realloc(j->kept, ((size_t)instant + 1) * n * sizeof *more);
    if (!more) return; /* continues without initial pressures */
    memset(more + (size_t)j->kept_count * n, 0,
           ((size_t)(instant + 1 - j->kept_count)) * n * sizeof *more);
    j->kept = more;
    j->kept_count = instant + 1;
  }
  memcpy(j->kept + (size_t)instant * n, j->press, n * sizeof *j->press);
}

static arc_status check_load(const arc_joint *j, const double load[3], arc_error *error) {
  double axis[3];
  axis_of(j, axis);
  const double size = sqrt(dot(load, load));
  if (!(size > 0) || !isfinite(size))
    return arc_fail(error, ARC_ARGUMENT, "field 'load': expected a number > 0 N, got %g", size);
  if (load[2] > 0 && dot(load, axis) > size * cos(fmin(90, j->def.cover) * pi / 180)) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field 'direction': expected z > 0 and less than %g degrees from the cup's axis, "
                  "got z = %.3g and %.3g degrees",
                  fmin(90, j->def.cover), load[2] / size,
                  acos(fmax(-1, fmin(1, dot(load, axis) / size))) * 180 / pi);
}

/* Returns true if the direction of the load lies in the window and is not too close to its edge: at
 * least 4 cells and 10 degrees away. */
static int holds(const arc_joint *j, const double load[3]) {
  const double lat = asin(load[0] / sqrt(dot(load, load))), lon = atan2(load[1], load[2]);
  const double margin = fmax(4 * j->d, pi / 18);
  return j->size >= j->rows - 2 || fmax(fabs(lat), fabs(lon)) + margin <= j->size * j->d / 2;
}

/* Sets u, the displacement for the second-order terms of the gaps, to `approach`, and returns true
 * if u changed by less than 1e-9 radii. Without second-order terms u remains 0, and the function
 * returns true. */
static int settled(const arc_joint *j, const double approach[3], double u[3]) {
  double moved = 0;
  if (!j->def.second_order) return 1;
  for (int i = 0; i < 3; i++) {
    moved = fmax(moved, fabs(approach[i] - u[i]));
    u[i] = approach[i];
  }
  return moved < 1e-9 * j->def.radius;
}

/* Composes the error message for a contact with so few cells that they cannot carry a load in three
 * directions. The cells may be too large. */
static arc_status refuse_cells(const arc_joint *j, const double load[3], arc_error *error) {
  const arc_error why = *error;
  return arc_fail(error, why.status,
                  "field 'mesh.size': the contact under %.3g N was not found on cells of %.3g "
                  "degrees, which may be too large for it (%.200s)",
                  sqrt(dot(load, load)), j->d * 180 / pi, why.message);
}

arc_status arc_sphere_solve(arc_joint *j, const sphere_stand *at, double approach[3],
                            int *iterations, arc_error *error) {
  static const double unit[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  enum { most_rounds = 30 };
  double u[3] = {0};
  int rounds = 0;
  arc_status status = check_load(j, at->load, error);
  while (status == ARC_OK && !holds(j, at->load)) status = arc_sphere_grow(j, error);
  for (int attempt = 0; status == ARC_OK;) {
    active_count count = {0};
    set_gaps(j, at->rotation ? at->rotation : unit, u);
    set_softness(j, at);
    if (rounds == 0) start(j, at, attempt);
    const active_problem problem = {.blocks = 1,
                                    .cells = j->size * j->size,
                                    .modes = 3,
                                    .gap = j->gap,
                                    .area = j->cell,
                                    .mode = j->mode,
                                    .load = at->load,
                                    .apply = apply,
                                    .context = j,
                                    .tolerance = 1e-7};
    status = arc_active_set_solve(&problem, j->work, j->press, approach, &count, error);
    *iterations += count.iterations;
    if (status == ARC_OK && !touches_rim(j)) {
      if (!settled(j, approach, u) && rounds++ < most_rounds) continue;
      keep(j, at->instant);
      return ARC_OK;
    }
    rounds = 0;
    if (status == ARC_OK) {
      status = arc_sphere_grow(j, error);
      attempt = 0;
    } else if (status != ARC_MEMORY && ++attempt < attempts) {
      status = ARC_OK;
    }
  }
  return status == ARC_NUMERIC ? refuse_cells(j, at->load, error) : status;
}

/* --- results ---------------------------------------------------------------------------------- */

double arc_sphere_rim_margin(const arc_joint *j) {
  double axis[3], least = 1;
  axis_of(j, axis);
  for (int c = 0; c < j->size * j->size; c++)
    if (j->press[c] > 0) least = fmin(least, dot(j->normal + 3 * (size_t)sphere_site(j, c), axis));
  return j->def.cover - acos(fmax(-1, least)) * 180 / pi;
}

arc_status arc_joint_press(arc_joint *j, const double rotation[9], const double load[3],
                           const arc_callbacks *callbacks, arc_joint_contact *contact,
                           arc_error *error) {
  const sphere_stand at = {.rotation = rotation, .load = load, .instant = -1};
  arc_joint_contact made = {0};
  if (callbacks && callbacks->stop && callbacks->stop(callbacks->context))
    return arc_fail(error, ARC_STOPPED, "stopped");
  const arc_status status = arc_sphere_solve(j, &at, made.approach, &made.iterations, error);
  if (status != ARC_OK) return status;
  memset(j->p, 0, (size_t)j->sites * sizeof *j->p);
  for (int c = 0; c < j->size * j->size; c++) {
    j->p[sphere_site(j, c)] = j->press[c];
    made.p_max = fmax(made.p_max, j->press[c]);
    made.area += j->press[c] > 0 ? j->cell[c] : 0;
    made.normal_force += j->press[c] * j->cell[c];
  }
  const double size = sqrt(dot(load, load));
  const double n[3] = {load[0] / size, load[1] / size, load[2] / size};
  made.p_center = arc_sphere_cubic(j, j->p, n);
  made.p_max = fmax(made.p_max, made.p_center); /* the load may point between cell centres */
  made.half_angle =
      acos(fmax(-1, 1 - made.area / (2 * pi * j->def.radius * j->def.radius))) * 180 / pi;
  made.rim_margin = arc_sphere_rim_margin(j);
  *contact = made;
  return ARC_OK;
}
