/* Cleans pictures in characters from gnuplot. */
#ifndef PLOT_CHARACTERS_H
#define PLOT_CHARACTERS_H

#include "plot/text.h"

/* Appends the picture without form feeds, blanks at line ends, empty lines at both ends and colour
 * changes that change nothing. In colour gnuplot draws every curve with + - and |; here each colour
 * gets the mark it has without colour, so that curves differ for every eye. Lines end uncoloured.
 *
 * `dots`, unless NULL, is gnuplot's picture of the curves alone, with twice the columns and four
 * times the rows: they come as Braille dots, eight to a character, where `picture` is blank. What
 * is black in `picture` holds the place of a curve and goes. A point's mark stays a mark. */
void arc_characters(const char *picture, size_t length, const char *dots, size_t dots_length,
                    arc_text *out);

#endif
