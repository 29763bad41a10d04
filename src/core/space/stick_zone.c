/* Chooses the cell size that fits the stick zone of a fretting run. Wear in partial slip ends when
 * the stick zone carries the whole load, so the volume depends on the area of the sticking cells.
 * The largest depth depends on the rim of these cells. Both converge slowly and unevenly with the
 * cell size, as the number of grid points in a circle does. */
#include "core/space/stick_zone.h"

#include <math.h>
#include <stdlib.h>

/* Cells stick if their centre is at most this far beyond the rim of the zone [cells], as measured
 * at the end of wear for ten amplitudes (0.113 +- 0.007). `play` is the uncertainty. */
static const double beyond = 0.113, play = 0.02;

/* The half axes of a stick zone and the width of the slip annulus [cells]. */
typedef struct stick_zone {
  double x, z, annulus;
} stick_zone;

/* Returns the number of cells whose centre lies within an ellipse of the half axes x and z
 * [cells], divided by the area of the ellipse. */
static double filling(double x, double z) {
  const int rows = (int)ceil(x), columns = (int)ceil(z);
  int inside = 0;
  for (int i = -rows; i <= rows; i++)
    for (int j = -columns; j <= columns; j++) inside += (i / x) * (i / x) + (j / z) * (j / z) <= 1;
  return inside / (acos(-1) * x * z);
}

/* Returns the relative error of the area of the cells that stick up to the distance `to` beyond the
 * rim. */
static double area_error(const stick_zone *s, double to) {
  const double x = s->x + to, z = s->z + to;
  return fabs(filling(x, z) * x * z / ((s->x + beyond) * (s->z + beyond)) - 1);
}

/* --- the rim ---------------------------------------------------------------------------------- */

/* The end of a column of cells along x. */
typedef struct column_end {
  double angle;   /* parameter of the ellipse */
  double outside; /* distance of the sticking cells' end from the rim, normal to it [cells] */
  double steep;   /* component along x of the normal of the rim */
} column_end;

/* Computes the ends of the columns -count to count. */
static void find_ends(const stick_zone *s, double to, int count, column_end *end) {
  const double x = s->x + beyond, z = s->z + beyond;
  for (int j = -count; j <= count; j++, end++) {
    const double part = j / z, inside = j / (s->z + to);
    const double rim = x * sqrt(fmax(0, 1 - part * part)),
                 last = floor((s->x + to) * sqrt(fmax(0, 1 - inside * inside))) + 0.5;
    end->angle = asin(fmax(-1, fmin(part, 1)));
    end->steep = rim / (x * x) / hypot(rim / (x * x), part / z);
    end->outside = (last - rim) * end->steep;
  }
}

/* Returns the mean of `outside` over an arc with the middle `at`. The weights decrease to 0 at a
 * distance of two annuli. */
static double mean_outside(const stick_zone *s, const column_end *end, int ends,
                           const column_end *at) {
  const double length = hypot(s->x * sin(at->angle), s->z * cos(at->angle));
  double sum = 0, weights = 0;
  for (int j = 0; j < ends; j++) {
    const double distance = length * fabs(end[j].angle - at->angle);
    if (distance >= 2 * s->annulus || end[j].steep == 0) continue;
    const double weight = (1 - distance / (2 * s->annulus)) / end[j].steep;
    sum += weight * end[j].outside;
    weights += weight;
  }
  return sum / weights;
}

/* Returns the distance of the rim from the sticking cells' end, as a mean over an arc, where these
 * cells end farthest inside, divided by the half axis x. Near this arc the depth is too large.
 * Examines the part of the rim that is crossed by columns along x at less than 45 degrees. */
static double rim_error(const stick_zone *s, double to) {
  static const double steepest = 0.69; /* somewhat less than cos(45 degrees) */
  const int count = (int)(s->z + to), ends = 2 * count + 1;
  column_end *end = malloc((size_t)ends * sizeof *end);
  double least = INFINITY;
  if (!end) return 0;
  find_ends(s, to, count, end);
  for (int j = count; j < ends && end[j].steep >= steepest; j++)
    least = fmin(least, mean_outside(s, end, ends, &end[j]));
  free(end);
  return fabs(least) / s->x;
}

/* Returns the effect, as a fraction of the area, of the row of cells at an end of an axis of the
 * stick zone. It is above 0 if the half axis [cells] ends beyond the first part of its last cell.
 * Then a straight row of cells slips although the zone covers much of it, and the depth there is
 * too large by up to a tenth of the largest depth. Rows are longer in larger zones. */
static double ragged(double half) {
  static const double covered = 0.3, straight = 0.005, few = 11.5;
  return straight * fmax(0, half - floor(half) - covered) * fmax(0, 1 - few / half);
}

/* --- the choice ------------------------------------------------------------------------------- */

/* Returns the error of a zone whose cells stick up to the distance `to` beyond the rim. */
static double error_of(const stick_zone *s, double to) {
  static const double share = 0.5;
  const stick_zone turned = {s->z, s->x, s->annulus};
  return area_error(s, to) + share * fmax(rim_error(s, to), rim_error(&turned, to));
}

double arc_stick_zone_cell(double size, double x, double z, double annulus) {
  enum { tries = 60 };
  static const double range = 1.0 / 6;
  double best = size, least = INFINITY;
  for (int i = 0; i < tries; i++) {
    const double now = size * (1 - range * i / tries), low = beyond - play, high = beyond + play;
    const stick_zone s = {x / now, z / now, annulus / now};
    const double rows = fmax(fmax(ragged(s.x + low), ragged(s.x + high)),
                             fmax(ragged(s.z + low), ragged(s.z + high)));
    const double off = fmax(error_of(&s, low), error_of(&s, high)) + rows;
    if (off < least) least = off, best = now;
  }
  return best;
}
