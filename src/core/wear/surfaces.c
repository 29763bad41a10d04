/* The surfaces of a run as arrays: what shows them, and what to go on from. Leans on the shape and
 * a contact solution. */
#include "archard/wear.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { X, H, Y, P, NAMES };
const char *const arc_surface_names[] = {"x", "h", "y", "p", NULL};

arc_status arc_wear_surfaces(const arc_wear *wear, arc_array **surfaces, size_t *count,
                             arc_error *error) {
  arc_contact *contact;
  arc_array list[ARC_BODIES * NAMES];
  *surfaces = NULL;
  *count = 0;
  arc_status status = arc_wear_contact(wear, &contact, error);
  if (status != ARC_OK) return status;
  const arc_wear_record *last = arc_wear_last(wear);
  for (int i = 0; i < ARC_BODIES * NAMES; i++) {
    const arc_body body = (arc_body)(i / NAMES);
    const arc_profile profile = arc_shape_profile(arc_wear_shape(wear), body);
    const double *const values[NAMES] = {[X] = profile.x,
                                         [H] = profile.h,
                                         [Y] = profile.y,
                                         [P] = arc_contact_pressure(contact, body).p};
    list[i] = (arc_array){arc_surface_names[i % NAMES],
                          body,
                          last->update,
                          last->distance,
                          {(size_t)profile.count, 1},
                          values[i % NAMES]};
  }
  *surfaces = arc_arrays_copy(list, ARC_BODIES * NAMES);
  arc_contact_destroy(&contact);
  if (!*surfaces) return arc_fail(error, ARC_MEMORY, "out of memory for the surfaces of a run");
  *count = ARC_BODIES * NAMES;
  return ARC_OK;
}

/* --- checks ----------------------------------------------------------------------------------- */

static arc_status check_values(const arc_array *array, int name, arc_error *error) {
  for (size_t i = 0; i < array->size[0]; i++) {
    const double value = array->values[i];
    if (isfinite(value) && (name != P || value >= 0) &&
        (name != X || i == 0 || value > array->values[i - 1]))
      continue;
    return arc_fail(
        error, ARC_ARGUMENT,
        "surface of the %s after update %g: expected for %s[%zu] a finite number%s, got "
        "%g",
        arc_body_name(array->body), array->update, array->name, i,
        name == X   ? " above the one before"
        : name == P ? " >= 0"
                    : "",
        value);
  }
  return ARC_OK;
}

/* Whether the first NAMES of `count` arrays are one surface. */
static arc_status check_surface(const arc_array *first, size_t count, arc_error *error) {
  arc_status status = ARC_OK;
  for (int name = 0; name < NAMES && status == ARC_OK; name++) {
    const arc_array *array =
        arc_array_find(first, count < NAMES ? count : NAMES, first->body, arc_surface_names[name]);
    if (!array || array->update != first->update || array->distance != first->distance ||
        array->size[0] != first->size[0] || array->size[1] != 1)
      return arc_fail(
          error, ARC_ARGUMENT, "surface of the %s after update %g: expected %s of %zu numbers",
          arc_body_name(first->body), first->update, arc_surface_names[name], first->size[0]);
    status = check_values(array, name, error);
  }
  return status;
}

arc_status arc_wear_check_surfaces(const arc_array *surfaces, size_t count, arc_error *error) {
  arc_status status = ARC_OK;
  for (size_t i = 0; i < count && status == ARC_OK; i += NAMES)
    status = check_surface(&surfaces[i], count - i, error);
  return status;
}

/* --- going on --------------------------------------------------------------------------------- */

arc_status arc_wear_state(const arc_wear *wear, arc_array **state, size_t *count,
                          arc_error *error) {
  arc_array list[ARC_SHAPE_STATE];
  const arc_wear_record *last = arc_wear_last(wear);
  arc_shape_state(arc_wear_shape(wear), list);
  for (int i = 0; i < ARC_SHAPE_STATE; i++) {
    list[i].update = last->update;
    list[i].distance = last->distance;
  }
  *state = arc_arrays_copy(list, ARC_SHAPE_STATE);
  *count = *state ? ARC_SHAPE_STATE : 0;
  return *state ? ARC_OK : arc_fail(error, ARC_MEMORY, "out of memory for the state of a run");
}

arc_status arc_wear_resume(arc_model *model, const arc_wear_def *def, const arc_array *state,
                           size_t arrays, const arc_wear_record *history, size_t count,
                           arc_wear **wear, arc_error *error) {
  arc_shape *shape = NULL;
  *wear = NULL;
  arc_status status =
      arc_shape_restore(model, def->geometry, def->refresh, state, arrays, &shape, error);
  if (status == ARC_OK) status = arc_wear_restore(model, def, shape, history, count, wear, error);
  arc_shape_destroy(&shape);
  return status;
}
