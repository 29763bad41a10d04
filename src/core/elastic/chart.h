/* Charts: the coordinates s along and z across the surfaces of a pair, in which the contact is
 * solved.
 *
 * In the chart of a line, s is x and z is y. A polar chart has its centre at (0, side R), the
 * centre of a hollow surface of radius R. Its coordinates are s = R theta and z = side (R - r),
 * where side is 1 if the lower body is hollow and -1 if the upper body is hollow. Thus z
 * increases towards +y at the first point of contact, which is the origin of both charts.
 * Lengths along s are measured on the surface of the hole, and pressures refer to the area of
 * this surface and act along z. Kinematics are of first order in clearance / R and wear / R. */
#ifndef ELASTIC_CHART_H
#define ELASTIC_CHART_H

#include "archard/model.h"
#include "core/base/angle.h"

#include <math.h>

/* Section of a body of revolution about the axis x = -axis. A point at x has the radius axis +
 * x. */
typedef struct revolution {
  int on;
  double axis; /* [mm] distance of the axis from x = 0; 0: the section contains each ring twice,
                  at x and -x */
} revolution;

/* Returns the length [mm] normal to the section that a point represents. In bodies of revolution
 * this is the circumference, or half of it if the section shows both sides of the axis, so that
 * each ring has two points. In the plane it is 1. */
static inline double arc_revolution_weight(const revolution *r, double x) {
  static const double pi = 3.14159265358979323846;
  if (!r->on) return 1;
  return (r->axis > 0 ? 2 : 1) * pi * fabs(r->axis + x);
}

/* Returns the area from the axis to x [mm2]. For surfaces of revolution, this area replaces x
 * because the displacement u_y is linear in the area. In the plane the function returns x. */
static inline double arc_revolution_area(const revolution *r, double x) {
  static const double pi = 3.14159265358979323846;
  if (!r->on) return x;
  return r->axis > 0 ? pi * (r->axis + x) * (r->axis + x) : pi / 2 * x * fabs(x);
}

typedef struct chart {
  int polar;
  double radius; /* [mm] radius R of the hole */
  double side;   /* 1: the lower body is hollow; -1: the upper body is hollow */
  double pin;    /* [mm] radius of the pin in the hole, which touches the hole in the direction
                    of the load */
  revolution revolved;
} chart;

/* Returns the chart of a pair. */
chart arc_chart_of(const arc_model_def *def);

/* These functions convert n points from coordinates in space to coordinates in the chart, and
 * back. */
void arc_chart_from_space(const chart *c, int n, const double *xy, double *sz);
void arc_chart_to_space(const chart *c, int n, const double *sz, double *xy);

/* Returns the index i < count of the point sz[2 * step * i] in the chart that is nearest to s. */
int arc_chart_nearest(const double *sz, int step, int count, double s);

/* Computes the unit vectors `along` and `across` in the directions of s and z at the position s. */
void arc_chart_axes(const chart *c, double s, double along[2], double across[2]);

/* Returns the distance [mm] from the hole's centre to the surface of an unworn pin at s. The pin
 * touches the hole at `angle` [rad, along s]. */
double arc_chart_rest(const chart *c, double s, double angle);

/* Position of a body that has moved by x along s under a load at an angle. The body is rotated
 * about a centre and then shifted [mm]. `cos` and `sin` define the rotation. */
typedef struct placing {
  double cos, sin, centre[2], shift[2];
} placing;
placing arc_chart_placing(const chart *c, arc_body body, double x, double angle);
/* These functions move n points from the original to the present position of a body, and rotate n
 * vectors. */
void arc_placing_points(const placing *p, int n, double *xy);
void arc_placing_vectors(const placing *p, int n, double *v);

#endif
