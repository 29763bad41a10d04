/* Implements the functions of arc_contact. Functions that depend on the kind of pair are called
 * through its table. */
#include "core/pair/surfaces.h"
#include "core/pair/units.h"

static const contact_handle *handle_of(const arc_contact *contact) {
  return (const contact_handle *)(const void *)contact;
}

arc_status arc_contact_solve(const arc_shape *shape, const arc_contact_def *def,
                             const arc_callbacks *callbacks, arc_contact **contact,
                             arc_error *error) {
  *contact = NULL;
  const arc_kind *kind = arc_shape_model(shape)->kind;
  if (!kind->solve)
    return arc_fail(error, ARC_ARGUMENT, "pairs of kind \"%s\" have no contact objects",
                    kind->name);
  const arc_status status = kind->solve(shape, def, callbacks, contact, error);
  if (status != ARC_OK) return status;
  arc_units_warn_friction(def->friction, callbacks);
  arc_units_warn_pair(arc_model_definition(arc_shape_model(shape)), arc_contact_get(*contact).p_max,
                      callbacks);
  return status;
}

arc_status arc_contact_move(const arc_contact *from, const arc_motion_def *motion,
                            const arc_callbacks *callbacks, arc_contact **contact,
                            arc_error *error) {
  *contact = NULL;
  return arc_contact_model(from)->kind->move(from, motion, callbacks, contact, error);
}

void arc_contact_destroy(arc_contact **contact) {
  if (!contact || !*contact) return;
  arc_contact_model(*contact)->kind->end_contact(*contact);
  *contact = NULL;
}

size_t arc_contact_bytes(const arc_contact *contact) {
  return arc_contact_model(contact)->kind->contact_bytes(contact);
}

arc_status arc_contact_surfaces(const arc_contact *contact, arc_array **surfaces, size_t *count,
                                arc_error *error) {
  *surfaces = NULL;
  *count = 0;
  return arc_contact_model(contact)->kind->show_contact(contact, surfaces, count, error);
}

const arc_contact_def *arc_contact_definition(const arc_contact *contact) {
  return &handle_of(contact)->def;
}

arc_contact_result arc_contact_get(const arc_contact *contact) {
  return handle_of(contact)->result;
}

const arc_shape *arc_contact_shape(const arc_contact *contact) {
  return handle_of(contact)->shape;
}

arc_model *arc_contact_model(const arc_contact *contact) {
  return arc_shape_model(handle_of(contact)->shape);
}
