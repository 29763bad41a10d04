/* Declares the common members of all kinds of models, and the common members of all kinds of
 * surfaces. */
#ifndef PAIR_MODEL_H
#define PAIR_MODEL_H

#include "core/pair/kind.h"

struct arc_model {
  const arc_kind *kind;
  int references;
  arc_model_def def;
  double seconds; /* [s] duration of the build */
};

/* First member of the surfaces of all kinds. */
typedef struct shape_handle {
  arc_model *model;
} shape_handle;

#endif
