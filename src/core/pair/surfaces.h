/* What the contacts of all kinds begin with. */
#ifndef PAIR_SURFACES_H
#define PAIR_SURFACES_H

#include "core/pair/model.h"

/* An arc_contact of any kind. */
typedef struct contact_handle {
  arc_shape *shape; /* own copy: what was solved */
  arc_contact_def def;
  arc_contact_result result;
} contact_handle;

#endif
