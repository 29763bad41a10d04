/* Models as handles: a definition, a kind that makes of it what it needs, references. */
#include "core/pair/model.h"

arc_status arc_model_check(const arc_model_def *def, arc_error *error) {
  return arc_kind_of(def)->check_model(def, error);
}

arc_status arc_model_build_watched(const arc_model_def *def, const arc_callbacks *callbacks,
                                   arc_model **model, arc_error *error) {
  return arc_kind_of(def)->build(def, callbacks, model, error);
}

arc_status arc_model_build(const arc_model_def *def, arc_model **model, arc_error *error) {
  return arc_model_build_watched(def, NULL, model, error);
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

const char *arc_model_kind_name(const arc_model *model) {
  return model->kind->name;
}

size_t arc_model_bytes(const arc_model *model) {
  return model->kind->model_bytes(model);
}
