/* lua/engine/peak.h - writes the position of the largest pressure of a contact for printed
 * summaries. */
#ifndef LUA_PEAK_H
#define LUA_PEAK_H

#include "archard/array.h"

#include <stddef.h>

/* Writes the position of the largest pressure of the upper body into text [size], such as " (x =
 * 1.8 mm)"; in 3-D also z. In "x = +-1.8 mm" the pressure at the mirrored point is equally large.
 * Writes "" if `center`, the pressure at the centre [MPa], is as large, or without arrays. `arrays`
 * are the `count` surface arrays of a contact, which include the pressure p [MPa]. */
void peak_position(const arc_array *arrays, size_t count, double center, char *text, size_t size);

#endif
