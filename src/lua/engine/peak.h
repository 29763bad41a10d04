/* lua/peak.h - where the largest pressure of a contact lies, for summaries. */
#ifndef LUA_PEAK_H
#define LUA_PEAK_H

#include "archard/array.h"

#include <stddef.h>

/* Writes " (x = 1.8 mm)", in 3-D also z, into text [size]: the position of the largest pressure
 * p of the upper body [MPa] among `count` arrays of surfaces; "+-" where the other side has it,
 * too. Writes "" if the pressure at the centre [MPa] is as large or there are no arrays. */
void peak_position(const arc_array *arrays, size_t count, double center, char *text, size_t size);

#endif
