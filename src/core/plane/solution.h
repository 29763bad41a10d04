/* Members of the struct arc_contact of plane models, used by contact.c, motion.c, field.c and
 * stick.c. */
#ifndef PLANE_SOLUTION_H
#define PLANE_SOLUTION_H

#include "core/friction/friction.h"
#include "core/pair/surfaces.h"

struct arc_contact {
  contact_handle handle;
  contact_problem problem;
  double *x[ARC_BODIES], *p[ARC_BODIES], *f[ARC_BODIES];
  double *force[ARC_BODIES]; /* forces on the surface nodes of each body, see
                                arc_contact_problem_forces */
  double *q[ARC_BODIES];     /* shear traction at each surface node [MPa] */
  int count[ARC_BODIES];
  int iterations;   /* total number of iterations of all increments */
  int has_friction; /* true for a contact with friction, which uses the members below */
  double mu;        /* coefficient of friction in the last increment */
  tangential_compliance compliance;
  friction_workspace workspace;
  friction_state state;
};

/* Returns the load per thickness [N/mm]. */
static inline double contact_line(const arc_contact *c) {
  return c->handle.def.load / arc_model_definition(c->handle.shape->handle.model)->thickness;
}

/* --- contact.c -------------------------------------------------------------------------------- */

/* Warns if the coefficient of friction and the elastic mismatch are so large that the solution may
 * not be unique. */
void arc_friction_warn(const arc_model *model, double mu, const char *who,
                       const arc_callbacks *callbacks);

/* Creates a contact on a copy of the shape, without solving it. */
arc_status arc_contact_create(const arc_shape *shape, const arc_contact_def *def,
                              arc_contact **contact, arc_error *error);
/* Completes a contact: computes its results, emits warnings and, in builds with checks,
 * validates the solution. If `status` is not ARC_OK, frees the contact and sets *contact to
 * NULL. */
arc_status arc_contact_finish(arc_contact **contact, arc_status status,
                              const arc_callbacks *callbacks, arc_error *error);
/* Functions of the pair kind "plane"; see arc_contact_solve, arc_contact_move,
 * arc_contact_destroy, arc_contact_bytes and arc_contact_surfaces. */
arc_status arc_plane_solve(const arc_shape *shape, const arc_contact_def *def,
                           const arc_callbacks *callbacks, arc_contact **contact, arc_error *error);
void arc_plane_end_contact(arc_contact *contact);
size_t arc_plane_contact_bytes(const arc_contact *contact);
arc_status arc_plane_show_contact(const arc_contact *contact, arc_array **surfaces, size_t *count,
                                  arc_error *error);

/* --- motion.c --------------------------------------------------------------------------------- */

arc_status arc_plane_move(const arc_contact *from, const arc_motion_def *motion,
                          const arc_callbacks *callbacks, arc_contact **contact, arc_error *error);
/* Presses the bodies of a contact with friction together. Defined in motion.c. */
arc_status arc_contact_press(arc_contact *contact, arc_error *error);

#endif
