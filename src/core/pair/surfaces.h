/* Declares the first member of contacts of all kinds. */
#ifndef PAIR_SURFACES_H
#define PAIR_SURFACES_H

#include "core/pair/model.h"

/* The object behind an arc_contact, the same for all kinds of pairs. */
typedef struct contact_handle {
  arc_shape *shape; /* own copy of the solved surfaces */
  arc_contact_def def;
  arc_contact_result result;
} contact_handle;

#endif
