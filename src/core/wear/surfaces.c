/* Returns the surfaces and the stored state of a run as arrays, checks such arrays, and restores
 * runs. */
#include "core/pair/model.h"
#include "core/wear/run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const arc_surface_names[] = {"x", "h", "y", "p", NULL};

arc_status arc_wear_surfaces(const arc_wear *w, arc_array **surfaces, size_t *count,
                             arc_error *error) {
  return w->kind->show(w, surfaces, count, error);
}

/* --- checks ----------------------------------------------------------------------------------- */

/* The arrays of one body at one update. */
typedef struct shown {
  const arc_array *first;
  size_t count;
  int line; /* 1 if x is the only coordinate of the sites, so that they are sorted by x */
} shown;

static int is_named(const arc_array *array, const char *name) {
  return strcmp(array->name, name) == 0;
}

static arc_status check_values(const shown *s, const arc_array *array, arc_error *error) {
  const int rises = s->line && is_named(array, "x"), presses = is_named(array, "p");
  for (size_t i = 0; i < array->size[0]; i++) {
    const double value = array->values[i];
    if (isfinite(value) && (!presses || value >= 0) &&
        (!rises || i == 0 || value > array->values[i - 1]))
      continue;
    return arc_fail(error, ARC_ARGUMENT,
                    "surface of the %s after update %g: expected for %s[%zu] a finite number%s, "
                    "got %g",
                    arc_body_name(array->body), array->update, array->name, i,
                    rises     ? " above the previous one"
                    : presses ? " >= 0"
                              : "",
                    value);
  }
  return ARC_OK;
}

static arc_status check_surface(const shown *s, arc_error *error) {
  const arc_array *first = s->first;
  for (const char *const *name = arc_surface_names; *name; name++)
    if (!arc_array_find(first, s->count, first->body, *name))
      return arc_fail(error, ARC_ARGUMENT,
                      "surface of the %s after update %g: expected %s of %zu numbers",
                      arc_body_name(first->body), first->update, *name, first->size[0]);
  arc_status status = ARC_OK;
  for (size_t i = 0; i < s->count && status == ARC_OK; i++) {
    const arc_array *array = &first[i];
    if (array->distance != first->distance || array->size[0] != first->size[0] ||
        array->size[1] != 1 || arc_array_find(first, i, array->body, array->name))
      return arc_fail(error, ARC_ARGUMENT,
                      "surface of the %s after update %g: expected %s of %zu numbers",
                      arc_body_name(first->body), first->update, array->name, first->size[0]);
    status = check_values(s, array, error);
  }
  return status;
}

arc_status arc_wear_check_surfaces(const arc_array *surfaces, size_t count, arc_error *error) {
  arc_status status = ARC_OK;
  for (size_t i = 0, n; i < count && status == ARC_OK; i += n) {
    const arc_array *first = &surfaces[i];
    for (n = 1; i + n < count; n++)
      if (first[n].body != first->body || first[n].update != first->update) break;
    const shown s = {first, n, !arc_array_find(first, n, first->body, "z")};
    status = check_surface(&s, error);
  }
  return status;
}

/* --- stored states ---------------------------------------------------------------------------- */

arc_status arc_wear_state(const arc_wear *w, arc_array **state, size_t *count, arc_error *error) {
  const arc_wear_record *last = arc_wear_last(w);
  *state = w->kind->save(w->shape, count);
  if (!*state) *count = 0;
  for (size_t i = 0; i < *count; i++) {
    (*state)[i].update = last->update;
    (*state)[i].distance = last->distance;
  }
  return *state ? ARC_OK : arc_fail(error, ARC_MEMORY, "out of memory for the state of a run");
}

arc_status arc_wear_resume(arc_model *model, const arc_wear_def *def, const arc_array *state,
                           size_t arrays, const arc_wear_record *history, size_t count,
                           arc_wear **wear, arc_error *error) {
  const arc_kind *kind = model->kind;
  arc_shape *shape = NULL;
  *wear = NULL;
  arc_status status = kind->load(model, def, state, arrays, &shape, error);
  if (status == ARC_OK) status = arc_wear_restore(model, def, shape, history, count, wear, error);
  kind->discard(&shape);
  return status;
}
