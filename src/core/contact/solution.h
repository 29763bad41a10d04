/* Inside of arc_contact, for contact.c and field.c. */
#ifndef CONTACT_SOLUTION_H
#define CONTACT_SOLUTION_H

#include "core/contact/pose.h"

struct arc_contact {
  arc_shape *shape; /* own copy: fields come from the shape that was solved */
  pose pose;
  arc_contact_def def;
  arc_contact_result result;
  double *x[ARC_BODIES], *p[ARC_BODIES], *f[ARC_BODIES];
  double *force[ARC_BODIES]; /* [2 * surface] as arc_pose_forces, on the body */
  int count[ARC_BODIES];
};

#endif
