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
  int count[ARC_BODIES];
};

#endif
