/* Decomposition of a profile into its form and waves. */
#ifndef MESH_WAVES_H
#define MESH_WAVES_H

#include "archard/body.h"

/* Form and waves of a profile. Other bodies have the wavelength INFINITY and the height 0. */
typedef struct body_waves {
  double form;   /* radius of the fitted parabola [mm]; negative if hollow, INFINITY if flat */
  double length; /* wavelength [mm]; INFINITY without waves */
  double height; /* height from valley to peak [mm] */
} body_waves;
body_waves arc_body_waves(const arc_body_def *body);

#endif
