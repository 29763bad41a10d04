/* Stability of explicit updates. */
#include "core/wear/run.h"

#include <stdlib.h>

arc_status arc_wear_stability(arc_wear *w, double *eigenvalue, arc_error *error) {
  *eigenvalue = 0;
  const arc_wear_record *now = arc_wear_last(w);
  double k[ARC_BODIES];
  arc_status status = arc_wear_enter_block(w, arc_wear_block_at(w, now), error);
  if (status == ARC_OK)
    status = arc_wear_coefficients(w, now->distance, now->distance, now, k, error);
  if (status != ARC_OK) return status;
  if (w->procedure == ARC_NSP) k[ARC_PLATE] = 0; /* its even wear feels nothing */
  if (k[ARC_CYLINDER] == 0 && k[ARC_PLATE] == 0) return ARC_OK;
  const size_t n = (size_t)(w->nc + w->np);
  double *jacobian = malloc((n * n + 2 * n) * sizeof *jacobian);
  if (!jacobian) return arc_fail(error, ARC_MEMORY, "out of memory for the stability limit");
  const wear_window window = {0, w->block[w->current].count - 1, 0, NULL, jacobian, now};
  int solutions = 0;
  status = arc_wear_evaluate(w, w->shape, &window, NULL, NULL, &solutions, error);
  if (status == ARC_OK)
    *eigenvalue = arc_wear_largest_eigenvalue(w->nc, w->np, k, jacobian, jacobian + n * n);
  free(jacobian);
  return status;
}
