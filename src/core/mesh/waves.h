/* Decomposition of a profile into its form and its waves. */
#ifndef MESH_WAVES_H
#define MESH_WAVES_H

#include "archard/body.h"

/* Form and waves of a profile. For bodies without a profile the wavelength is INFINITY and the
 * height is 0. */
typedef struct body_waves {
  double form;   /* radius of the fitted parabola [mm]; negative for a hollow surface, INFINITY
                    for a flat one */
  double length; /* wavelength [mm]; INFINITY without waves */
  double height; /* height of the waves from valley to peak [mm] */
} body_waves;
body_waves arc_body_waves(const arc_body_def *body);

#endif
