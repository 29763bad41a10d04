/* Inside of arc_contact, for contact.c, motion.c, field.c and stick.c. */
#ifndef PLANE_SOLUTION_H
#define PLANE_SOLUTION_H

#include "core/friction/friction.h"

struct arc_contact {
  arc_shape *shape; /* own copy: fields come from the shape that was solved */
  pose pose;
  arc_contact_def def;
  arc_contact_result result;
  double *x[ARC_BODIES], *p[ARC_BODIES], *f[ARC_BODIES];
  double *force[ARC_BODIES]; /* [2 * surface] as arc_pose_forces, on the body */
  double *q[ARC_BODIES];     /* [surface] shear traction */
  int count[ARC_BODIES];
  int iterations; /* of all increments */
  int rubs;       /* whether there is friction, and what is below */
  double mu;      /* coefficient of the last increment */
  tangential_compliance compliance;
  friction_workspace workspace;
  friction_state state;
};

/* An empty contact on a copy of the shape, without its solution. */
arc_status arc_contact_create(const arc_shape *shape, const arc_contact_def *def,
                              arc_contact **contact, arc_error *error);
/* Reads, warns and, in builds with checks, validates; *contact is NULL where `status` is not OK. */
arc_status arc_contact_finish(arc_contact **contact, arc_status status,
                              const arc_callbacks *callbacks, arc_error *error);
/* Presses with friction (motion.c). */
arc_status arc_contact_press(arc_contact *contact, arc_error *error);

/* Load per thickness [N/mm]. */
static inline double contact_line(const arc_contact *c) {
  return c->def.load / arc_model_definition(c->shape->model)->thickness;
}

#endif
