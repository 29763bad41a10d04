/* A picture in characters as gnuplot sends it, made fit for people. */
#ifndef PLOT_TIDY_H
#define PLOT_TIDY_H

#include "plot/text.h"

/* Appends the picture without form feeds, blanks at line ends, empty lines at both ends and colour
 * changes that change nothing. In colour gnuplot draws every curve with + - and |; here each colour
 * gets the mark it has without colour, so that curves differ for every eye. Lines end uncoloured.
 */
void arc_tidy(const char *picture, size_t length, arc_text *out);

#endif
