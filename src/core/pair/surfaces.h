/* Declares the first member of contacts of all kinds. */
#ifndef PAIR_SURFACES_H
#define PAIR_SURFACES_H

#include "core/pair/model.h"

/* First member of every arc_contact, for all kinds of pairs. */
typedef struct contact_handle {
  arc_shape *shape; /* copy of the solved surfaces, owned by the contact */
  arc_contact_def def;
  arc_contact_result result;
} contact_handle;

#endif
