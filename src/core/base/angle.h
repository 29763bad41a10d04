/* Converts angles from degrees to radians. */
#ifndef BASE_ANGLE_H
#define BASE_ANGLE_H

static inline double arc_radians(double degrees) {
  return degrees * (3.14159265358979323846 / 180);
}

#endif
