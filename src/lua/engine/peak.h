/* lua/engine/peak.h - writes the position of the largest pressure of a contact for printed
 * summaries. */
#ifndef LUA_PEAK_H
#define LUA_PEAK_H

#include "archard/array.h"

#include <stddef.h>

/* Writes the position of the largest pressure on the upper body into `text`, such as " (x = 1.8
 * mm)"; in 3-D also z. The sign "+-" means that the pressure is equally large at both signs. Writes
 * "" if the pressure `center` at the centre [MPa] is equally large, or if the pressure p [MPa] is
 * not among the `count` surface arrays `arrays`. */
void peak_position(const arc_array *arrays, size_t count, double center, char *text, size_t size);

#endif
