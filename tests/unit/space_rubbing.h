/* Common parts of the tests of half-space contacts with friction under a history of loads. */
#ifndef TESTS_SPACE_RUBBING_H
#define TESTS_SPACE_RUBBING_H

#include "space_shared.h"

UNUSED static arc_material elastic(double E, double nu) {
  arc_material m = arc_material_default();
  m.E = E;
  m.nu = nu;
  return m;
}

/* The contact, its friction state and the present load increment of a history of loads. */
typedef struct rubbing {
  arc_halfspace *h;
  arc_halfspace_friction s;
  arc_halfspace_increment to;
  arc_halfspace_effort effort;
  arc_halfspace_options options;
  double work; /* work since the last reset [N mm] */
} rubbing;

UNUSED static void slide(rubbing *r) {
  check_ok(arc_halfspace_slide(r->h, NULL, &r->to, &r->options, &r->s, &r->effort, why));
  r->work += r->s.work;
}

UNUSED static rubbing press(const arc_halfspace_def *def, double load, double friction) {
  rubbing r = {.h = make_space(def)};
  r.to = (arc_halfspace_increment){.friction = friction, .position = {.load = load}};
  check_ok(arc_halfspace_friction_begin(r.h, &r.s, why));
  slide(&r);
  return r;
}

UNUSED static void end(rubbing *r) {
  arc_halfspace_friction_end(&r->s);
  arc_halfspace_destroy(&r->h);
}

#endif
