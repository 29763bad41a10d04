/* Inside of arc_model: the handle that models of all kinds begin with. */
#ifndef PAIR_MODEL_H
#define PAIR_MODEL_H

#include "core/pair/kind.h"

struct arc_model {
  const arc_kind *kind;
  int references;
  arc_model_def def;
  double seconds; /* the build took */
};

/* What the surfaces of all kinds begin with. */
typedef struct shape_handle {
  arc_model *model;
} shape_handle;

#endif
