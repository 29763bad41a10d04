/* Converts the surfaces of plane models to arrays, for output and for stored states. */
#include "core/plane/cycle.h"

enum { X, H, Y, P, NAMES };

arc_status arc_plane_show(const arc_wear *wear, arc_array **surfaces, size_t *count,
                          arc_error *error) {
  static const char *const names[] = {"x", "h", "y", "p"};
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
    list[i] = (arc_array){
        names[i % NAMES], body, last->update, last->distance, {(size_t)profile.count, 1},
        values[i % NAMES]};
  }
  *surfaces = arc_arrays_copy(list, ARC_BODIES * NAMES);
  arc_contact_destroy(&contact);
  if (!*surfaces) return arc_fail(error, ARC_MEMORY, "out of memory for the surfaces of a run");
  *count = ARC_BODIES * NAMES;
  return ARC_OK;
}

arc_array *arc_plane_save(const arc_shape *shape, size_t *count) {
  arc_array list[ARC_SHAPE_STATE];
  arc_shape_state(shape, list);
  *count = ARC_SHAPE_STATE;
  return arc_arrays_copy(list, ARC_SHAPE_STATE);
}

arc_status arc_plane_load(arc_model *model, const arc_wear_def *def, const arc_array *state,
                          size_t count, arc_shape **shape, arc_error *error) {
  return arc_shape_restore(model, def->geometry, def->refresh, state, count, shape, error);
}
