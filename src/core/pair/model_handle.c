/* Implements the functions for models and surfaces that are common to all kinds: definition, kind,
 * and reference count. */
#include "core/pair/model.h"

#include <math.h>

arc_status arc_model_check(const arc_model_def *def, arc_error *error) {
  return arc_kind_of(def->geometry)->check_model(def, error);
}

arc_status arc_model_build_with_callbacks(const arc_model_def *def, const arc_callbacks *callbacks,
                                          arc_model **model, arc_error *error) {
  return arc_kind_of(def->geometry)->build(def, callbacks, model, error);
}

arc_status arc_model_build(const arc_model_def *def, arc_model **model, arc_error *error) {
  return arc_model_build_with_callbacks(def, NULL, model, error);
}

arc_model *arc_model_retain(arc_model *model) {
  model->references++;
  return model;
}

void arc_model_release(arc_model **model) {
  if (!model || !*model) return;
  arc_model *m = *model;
  *model = NULL;
  if (--m->references == 0) m->kind->end_model(m);
}

const arc_model_def *arc_model_definition(const arc_model *model) {
  return &model->def;
}

int arc_model_has_maps(const arc_model_def *def) {
  return arc_kind_of(def->geometry)->maps;
}

const char *arc_model_kind_name(const arc_model *model) {
  return model->kind->name;
}

const arc_mesh *arc_model_mesh(const arc_model *model, arc_body body) {
  return model->kind->mesh ? model->kind->mesh(model, body) : NULL;
}

double arc_model_seconds(const arc_model *model) {
  return model->seconds;
}

size_t arc_model_bytes(const arc_model *model) {
  return model->kind->model_bytes(model);
}

/* --- surfaces --------------------------------------------------------------------------------- */

arc_model *arc_shape_model(const arc_shape *shape) {
  return ((const shape_handle *)(const void *)shape)->model;
}

static const arc_kind *kind_of(const arc_shape *shape) {
  return arc_shape_model(shape)->kind;
}

arc_status arc_shape_create(arc_model *model, arc_geometry geometry, double refresh,
                            arc_shape **shape, arc_error *error) {
  *shape = NULL;
  if (model->kind->unworn) return model->kind->unworn(model, geometry, refresh, shape, error);
  return arc_fail(error, ARC_ARGUMENT, "expected a model with meshes, got one of kind \"%s\"",
                  model->kind->name);
}

arc_status arc_shape_clone(const arc_shape *shape, arc_shape **copy, arc_error *error) {
  return kind_of(shape)->copy(shape, copy, error);
}

void arc_shape_destroy(arc_shape **shape) {
  if (shape && *shape) kind_of(*shape)->discard(shape);
}

arc_profile arc_shape_profile(const arc_shape *shape, arc_body body) {
  return kind_of(shape)->profile(shape, body);
}

double arc_shape_depth(const arc_shape *shape, arc_body body) {
  return kind_of(shape)->deepest(shape, body);
}

double arc_shape_vector_depth(const arc_shape *shape, arc_body body) {
  const arc_profile profile = arc_shape_profile(shape, body);
  double depth = 0;
  for (int i = 0; i < profile.count; i++) depth = fmax(depth, profile.way[i]);
  return depth;
}
