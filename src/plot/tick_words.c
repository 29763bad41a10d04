/* Writes the ticks of an axis and their numbers or words as gnuplot commands. */
#include <math.h>
#include <stdlib.h>

#include "plot/figure.h"

static void tic_format(arc_writer *w, const char *axis, const arc_ticks *ticks) {
  const int fraction = arc_ticks_fraction(ticks->step);
  const char *power = w->canvas->text ? "e%T" : "10^{%T}",
             *times = w->canvas->text ? "" : "\303\227";
  if (ticks->bare)
    arc_text_format(w->out, "set format %s '%s%s'\n", axis, w->canvas->text ? "1" : "", power);
  else if (ticks->powers)
    arc_text_format(w->out, "set format %s '%%.%dt%s%s'\n", axis, ticks->decimals, times, power);
  else if (fraction && !w->canvas->window)
    arc_text_format(w->out, "set format %s '%%.%df'\n", axis, fraction);
  else
    arc_text_format(w->out, "set format %s '%%.%dg'\n", axis, ticks->digits);
}

static void log_places(arc_writer *w, const char *axis, const arc_ticks *ticks) {
  arc_text_format(w->out, "set %stics (", axis);
  for (int power = ticks->first; power <= ticks->last; power++)
    for (int part = 1; part < (ticks->decades == 1 ? 10 : 2); part++) {
      int shown = part == 1 ? (power - ticks->first) % ticks->decades == 0
                            : ticks->parts == 1 || (ticks->parts == 3 && part % 3 == 2 && part < 8);
      arc_text_format(w->out, "%s%s%de%d%s", power == ticks->first && part == 1 ? "" : ", ",
                      shown ? "" : "'' ", part, power, shown ? "" : " 1");
    }
  arc_text_word(w->out, ") enhanced\n");
}

/* Returns the minus sign U+2212 for a negative number, otherwise an empty text. */
static const char *minus_of(double number) {
  return number < 0 ? "\342\210\222" : "";
}

/* Writes the tick labels of a linear axis with powers of ten. All labels have the power of the
 * largest number, such as 0.5e-8 beside 1.0e-8. */
static void power_words(arc_writer *w, const char *axis, const arc_ticks *ticks) {
  const int decimals = ticks->exponent - (int)floor(log10(ticks->step) + 1e-9);
  arc_text_format(w->out, "set %stics add ('0' 0", axis);
  for (double i = ticks->low; i <= ticks->high && !w->canvas->text; i++)
    if (i != 0)
      arc_text_format(w->out, ", '%s%.*f\303\22710^{%s%d}' %.17g", minus_of(i),
                      decimals > 0 ? decimals : 0, fabs(i) * ticks->step / pow(10, ticks->exponent),
                      minus_of(ticks->exponent), abs(ticks->exponent), i * ticks->step);
  arc_text_word(w->out, ")\n");
}

/* Sets tick positions at which the numbers do not overlap, because gnuplot does not prevent
 * overlaps. In a window gnuplot chooses the positions, because the user may zoom. */
static void tic_words(arc_writer *w, const char *axis, arc_ticks ticks) {
  tic_format(w, axis, &ticks);
  if (ticks.decades && !w->canvas->window) {
    log_places(w, axis, &ticks);
    return;
  }
  if (ticks.step == 0 || w->canvas->window)
    arc_text_format(w->out, "set %stics autofreq enhanced\n", axis);
  else
    arc_text_format(w->out, "set %stics %.17g enhanced\n", axis, ticks.step);
  if (ticks.powers && !ticks.bare && !ticks.decades) power_words(w, axis, &ticks);
}

/* Writes words instead of numbers at positions of an axis. */
static void place_words(arc_writer *w, const char *name, const arc_plot_axis *axis) {
  arc_text_format(w->out, "set %stics (", name);
  for (size_t i = 0; i < axis->place_count; i++) {
    arc_text_word(w->out, i ? ", " : "");
    arc_text_quoted(w->out, axis->words[i], w->canvas->ascii);
    arc_text_format(w->out, " %.17g", axis->places[i]);
  }
  arc_text_word(w->out, ") noenhanced\n");
}

void arc_ticks_write(arc_writer *w, const char *name, const arc_plot_axis *axis, arc_ticks ticks) {
  if (axis->places)
    place_words(w, name, axis);
  else
    tic_words(w, name, ticks);
}

void arc_ticks_of_scale(arc_writer *w, double step) {
  enum { longest = 3 }; /* most decimals; with more, %h writes powers of ten */
  const int fraction = arc_ticks_fraction(step);
  if (step > 0)
    arc_text_format(w->out, "set cbtics %.17g\n", step);
  else
    arc_text_word(w->out, "set cbtics autofreq\n");
  if (fraction > 0 && fraction <= longest)
    arc_text_format(w->out, "set format cb '%%.%df'\n", fraction);
  else
    arc_text_word(w->out, "set format cb '%h'\n");
}
