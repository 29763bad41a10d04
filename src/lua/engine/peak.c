/* Writes the position of the largest pressure of a contact as text. */
#include "lua/engine/peak.h"

#include <math.h>
#include <stdio.h>

/* Largest relative differences at which two pressures (`alike`) or two positions (`same_position`)
 * are regarded as equal. */
static const double alike = 1e-3, same_position = 1e-6;

static size_t largest(const arc_array *p) {
  size_t most = 0;
  for (size_t i = 1; i < arc_array_count(p); i++)
    if (p->values[i] > p->values[most]) most = i;
  return most;
}

/* Returns true if the pressure at the mirrored point is as large as at point `most`. Mirroring
 * changes the sign of the coordinate `along`, but not the coordinate `across` (may be NULL). */
static int is_mirrored(const arc_array *p, const arc_array *along, const arc_array *across,
                       size_t most) {
  const double at = along->values[most], least = (1 - alike) * p->values[most];
  for (size_t i = 0; i < arc_array_count(p); i++)
    if (p->values[i] >= least && fabs(along->values[i] + at) <= same_position * fabs(at) &&
        (!across || fabs(across->values[i] - across->values[most]) <=
                        same_position * fabs(across->values[most])))
      return 1;
  return 0;
}

static void show(char *text, size_t size, const char *name, double at, int mirrored) {
  if (mirrored && at != 0)
    snprintf(text, size, "%s = +-%.4g mm", name, fabs(at));
  else
    snprintf(text, size, "%s = %.4g mm", name, at);
}

void peak_position(const arc_array *arrays, size_t count, double center, char *text, size_t size) {
  const arc_array *p = arc_array_find(arrays, count, ARC_UPPER, "p"),
                  *x = arc_array_find(arrays, count, ARC_UPPER, "x"),
                  *z = arc_array_find(arrays, count, ARC_UPPER, "z");
  char along[40], across[40];
  text[0] = '\0';
  if (!p || !x || arc_array_count(p) == 0) return;
  const size_t most = largest(p);
  if (!(p->values[most] > center * (1 + same_position))) return;
  show(along, sizeof along, "x", x->values[most], is_mirrored(p, x, z, most));
  if (z) show(across, sizeof across, "z", z->values[most], is_mirrored(p, z, x, most));
  snprintf(text, size, z ? " (%s, %s)" : " (%s)", along, z ? across : "");
}
