/* What a profile consists of: its form, and the waves on it. */
#ifndef MESH_WAVES_H
#define MESH_WAVES_H

#include "archard/body.h"

/* What a profile consists of; INFINITY, and no height, for others. */
typedef struct body_waves {
  double form;   /* radius of the parabola that fits best [mm]: negative where that is hollow,
                    INFINITY where it is flat */
  double length; /* of the waves on it [mm], INFINITY: there are none */
  double height; /* from valleys to peaks [mm] */
} body_waves;
body_waves arc_body_waves(const arc_body_def *body);

#endif
