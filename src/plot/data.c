/* Writes curves as rows of numbers. */
#include <math.h>

#include "plot/figure.h"

static int drawable(const arc_plot_panel *panel, double x, double y) {
  return isfinite(x) && isfinite(y) && !(panel->x.log && x <= 0) && !(panel->y.log && y <= 0);
}

/* Writes the points of a curve. A blank line in the data interrupts the curve. Only one blank line
 * is written, because two blank lines would begin another data set. Blank lines before the first
 * point are omitted. */
void arc_data_curve(const arc_plot_panel *panel, const arc_plot_curve *curve, arc_text *script) {
  int in_line = 0;
  for (size_t i = 0; i < curve->count; i++) {
    if (drawable(panel, curve->x[i], curve->y[i])) {
      arc_text_format(script, "%.17g %.17g", curve->x[i], curve->y[i]);
      if (curve->error) arc_text_format(script, " %.17g", curve->error[i]);
      arc_text_word(script, "\n");
      in_line = 1;
    } else if (in_line) {
      arc_text_word(script, "\n");
      in_line = 0;
    }
  }
}
