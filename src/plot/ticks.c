/* Chooses round tick values with short labels that do not overlap. gnuplot by itself would write
 * 0.000000001 instead of 1e-09, and labels that overlap. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plot/figure.h"

/* Labels have at least DIGITS significant digits, and at most MOST_DIGITS, because further digits
 * are rounding errors of doubles. Powers of ten are considered if a label has LONG_LABEL characters
 * or more. */
enum { DIGITS = 6, MOST_DIGITS = 15, MOST_TICKS = 200, LONG_LABEL = 5 };

/* Returns the smallest step of the form 1, 2 or 5 times a power of ten that divides the span into
 * at most `steps` (2 or more) steps. */
static double round_step(double span, double steps) {
  double rough = span / fmax(2, steps), power = pow(10, floor(log10(rough)));
  double share = rough / power;
  return power * (share <= 1 ? 1 : share <= 2 ? 2 : share <= 5 ? 5 : 10);
}

double arc_field_step(const double range[2], int levels) {
  return round_step(range[1] - range[0], levels + 1);
}

/* Returns the number of significant digits that distinguish adjacent ticks, from DIGITS to
 * MOST_DIGITS. For example, 100.001 and 100.002 need six digits. */
static int digits_of(double low, double high, double step) {
  double largest = fmax(fabs(low), fabs(high));
  double digits = floor(log10(largest)) - floor(log10(step)) + 1;
  return (int)fmin(MOST_DIGITS, fmax(DIGITS, digits));
}

int arc_ticks_fraction(double step) {
  return step > 0 && step < 1 ? -(int)floor(log10(step) + 1e-9) : 0;
}

/* Returns the length of the longest label [characters]. The range is extended to the next tick at
 * both ends, as gnuplot extends automatic ends. */
static size_t longest_label(double low, double high, const arc_ticks *ticks) {
  char label[40];
  size_t longest = 1;
  const int fraction = arc_ticks_fraction(ticks->step);
  double first = floor(low / ticks->step), last = ceil(high / ticks->step);
  for (int i = 0; i < MOST_TICKS && first + i <= last; i++) {
    const double value = (first + i) * ticks->step;
    int length = fraction ? snprintf(label, sizeof label, "%.*f", fraction, value)
                          : snprintf(label, sizeof label, "%.*g", ticks->digits, value);
    if (length > 0 && (size_t)length > longest) longest = (size_t)length;
  }
  return longest;
}

/* Returns the length of the longest label in the form 7e-4 [characters], with as many decimals as
 * the step needs. */
static size_t longest_power(double low, double high, const arc_ticks *ticks) {
  double largest = fmax(fabs(low), fabs(high));
  int lowest = (int)floor(log10(ticks->step) + 1e-9), highest = (int)floor(log10(largest) + 1e-9);
  int exponent = abs(lowest) > abs(highest) ? lowest : highest;
  return (size_t)(ticks->decimals ? ticks->decimals + 2 : 1) + (low < 0) + 1 + (exponent < 0) +
         (abs(exponent) > 9) + 1;
}

/* Returns the number of decimals of the mantissa of a number: 1 for 1.2e-3, 0 for 1e-3. */
static int decimals_of(double value) {
  char text[40];
  snprintf(text, sizeof text, "%.*e", DIGITS - 1, value);
  char *end = strchr(text, 'e'), *point = strchr(text, '.');
  if (!end || !point) return 0;
  while (end > point + 1 && end[-1] == '0') end--;
  return (int)(end - point) - 1;
}

/* Chooses labels with powers of ten if plain numbers would be long and powers are shorter. */
static void choose_form(double low, double high, arc_ticks *ticks) {
  double first = floor(low / ticks->step + 1e-9), last = ceil(high / ticks->step - 1e-9);
  for (int i = 0; i < MOST_TICKS && first + i <= last; i++) {
    int decimals = decimals_of((first + i) * ticks->step);
    ticks->decimals = decimals > ticks->decimals ? decimals : ticks->decimals;
  }
  ticks->exponent = (int)floor(log10(fmax(fabs(first), fabs(last)) * ticks->step) + 1e-9);
  ticks->low = first, ticks->high = last;
  size_t power = longest_power(low, high, ticks);
  ticks->powers = ticks->digits == DIGITS && ticks->longest >= LONG_LABEL && power < ticks->longest;
  if (ticks->powers) ticks->longest = power;
}

static arc_ticks with_step(double low, double high, double step) {
  arc_ticks ticks = {.step = step, .digits = digits_of(low, high, step)};
  ticks.longest = longest_label(low, high, &ticks);
  choose_form(low, high, &ticks);
  return ticks;
}

/* Returns true if the span is unknown or zero, so that gnuplot must choose the ticks. */
static int is_free(double span) {
  return !isfinite(span) || span == 0;
}

/* Computes the ticks of a logarithmic axis. If the axis has few decades, multiples such as 2 and
 * 5 also have labels. All labels of an axis have one form, because 0.0001 beside 1e-05 would be
 * inconsistent. */
static arc_ticks log_ticks(double low, double high, double most) {
  int first = (int)floor(log10(low) + 1e-9), last = (int)ceil(log10(high) - 1e-9);
  arc_ticks ticks = {.digits = DIGITS,
                     .decades = (int)ceil((last - first + 1) / fmax(2, most)),
                     .first = first,
                     .last = last};
  ticks.powers = first < -3 || last > 4;
  if (last - first <= 2 && 3 * (last - first) <= most + 2)
    ticks.parts = high > 5.1 * low || ticks.powers ? 3 : 1;
  ticks.bare = ticks.powers && !ticks.parts;
  int digits = last > -first ? last + 1 : 2 - first,
      signs = (first < 0) + (abs(first) > 9 || abs(last) > 9);
  ticks.longest = (size_t)(!ticks.powers ? digits : ticks.bare ? 3 + signs : 4 + signs);
  return ticks;
}

static arc_ticks free_ticks(const arc_plot_axis *axis, double low, double high, double most) {
  if (axis->log && low > 0 && isfinite(high)) return log_ticks(low, high, most);
  return (arc_ticks){.digits = DIGITS, .longest = axis->log ? 6 : 5};
}

arc_ticks arc_ticks_up(const arc_plot_axis *axis, double from, double to, double most) {
  double low = fmin(from, to), high = fmax(from, to);
  if (axis->log || is_free(high - low)) return free_ticks(axis, low, high, most);
  return with_step(low, high, round_step(high - low, most));
}

/* Returns true if labels fit on an axis that is `columns` characters long, with a distance of
 * `gap` characters. */
static int fits(const arc_ticks *ticks, double span, double columns, double gap) {
  return ((double)ticks->longest + gap) * span <= columns * ticks->step;
}

/* The step is the smallest for which the labels fit. If only one label would remain, the step is
 * the largest number with one digit that gives more labels, because one label is no scale. */
arc_ticks arc_ticks_across(const arc_plot_axis *axis, double from, double to, double most,
                           double columns) {
  double low = fmin(from, to), high = fmax(from, to), span = high - low;
  if (axis->log || is_free(span)) return free_ticks(axis, low, high, most);
  arc_ticks ticks = with_step(low, high, round_step(span, most));
  while (!fits(&ticks, span, columns, 2) && ticks.step < span / 2)
    ticks = with_step(low, high, round_step(3 * ticks.step, 2));
  if (floor(high / ticks.step) > ceil(low / ticks.step)) return ticks;
  const double part = low < 0 && high > 0 ? fmax(high, -low) : span / 2;
  const double power = pow(10, floor(log10(part)));
  const arc_ticks few = with_step(low, high, power * fmax(1, floor(part / power + 1e-9)));
  return fits(&few, span, columns, 0.5) ? few : ticks;
}
