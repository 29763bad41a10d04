/* Decomposition of a profile into its form and waves. */
#ifndef MESH_WAVES_H
#define MESH_WAVES_H

#include "archard/body.h"

/* Form and waves of a profile. For other bodies the wavelength is INFINITY and the height zero. */
typedef struct body_waves {
  double form;   /* radius of the best-fit parabola [mm]: negative if hollow, INFINITY if flat */
  double length; /* wavelength [mm], INFINITY: no waves */
  double height; /* height from valleys to peaks [mm] */
} body_waves;
body_waves arc_body_waves(const arc_body_def *body);

#endif
