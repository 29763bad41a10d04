/* Curves of a picture in characters as Braille dots. */
#ifndef PLOT_BRAILLE_H
#define PLOT_BRAILLE_H

#include "plot/text.h"

/* Lays the curves of `dots`, gnuplot's picture of nothing else with twice the columns and four
 * times the rows, over the blanks of `picture`; both as gnuplot writes them, with ANSI colours.
 * What is black in `picture` holds the place of a curve and goes. A point's mark stays a mark. */
void arc_braille(const char *picture, size_t length, const char *dots, size_t dots_length,
                 arc_text *out);

#endif
