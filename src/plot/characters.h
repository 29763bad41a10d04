/* Converts and cleans the plots that gnuplot draws with characters (terminal `dumb`). */
#ifndef PLOT_CHARACTERS_H
#define PLOT_CHARACTERS_H

#include "plot/text.h"

/* Appends the picture to `out` without form feeds, blanks at line ends, empty lines at its start
 * and end, and superfluous colour changes. In coloured pictures gnuplot draws every curve with + -
 * and |. This function replaces them by one character for each colour, so that colour-blind readers
 * can distinguish curves. The colour is reset at each line end.
 *
 * If `dots` is not NULL, it is gnuplot's picture of only the curves, with twice the columns and
 * four times the rows. Where `picture` is blank or black, the dots are added as Braille characters
 * of eight dots. Black characters in `picture` belong to curves. Marks of points are not
 * replaced. */
void arc_characters(const char *picture, size_t length, const char *dots, size_t dots_length,
                    arc_text *out);

#endif
