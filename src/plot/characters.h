/* Converts and cleans gnuplot's pictures in characters. */
#ifndef PLOT_CHARACTERS_H
#define PLOT_CHARACTERS_H

#include "plot/text.h"

/* Appends the picture without form feeds, blanks at line ends, empty lines at both ends and
 * superfluous colour changes. With colours gnuplot draws every curve with + - and |. Here each
 * colour has the mark of the picture without colours, so that curves differ also for colour-blind
 * readers. Each line ends without colour.
 *
 * `dots`, unless NULL, is gnuplot's picture of the curves alone, with twice the columns and four
 * times the rows. Its dots are added as Braille characters, eight dots to a character, where
 * `picture` is blank or black. Black in `picture` marks the curves. Marks of points are kept. */
void arc_characters(const char *picture, size_t length, const char *dots, size_t dots_length,
                    arc_text *out);

#endif
