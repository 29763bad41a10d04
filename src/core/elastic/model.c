/* A model: two condensed bodies, reference counted. */
#include "core/elastic/body.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

struct arc_model {
  int references;
  arc_model_def def;
  elastic_body *body[ARC_BODIES];
  double seconds;
};

arc_material arc_material_default(void) {
  return (arc_material){200e3, 0.3};
}

double arc_material_E_star(arc_material m) {
  return m.E / (1 - m.nu * m.nu);
}

double arc_contact_modulus(const arc_material material[ARC_BODIES]) {
  return 1 / (1 / arc_material_E_star(material[ARC_CYLINDER]) +
              1 / arc_material_E_star(material[ARC_PLATE]));
}

arc_status arc_material_check(arc_material m, arc_error *error) {
  if (!(m.E > 0) || !isfinite(m.E))
    return arc_fail(error, ARC_ARGUMENT, "E: expected above 0 MPa, got %g MPa", m.E);
  if (!(m.nu > -1 && m.nu < 0.5))
    return arc_fail(error, ARC_ARGUMENT, "nu: expected above -1 and below 0.5, got %g", m.nu);
  return ARC_OK;
}

arc_model_def arc_model_default(void) {
  return (arc_model_def){.radius = 10,
                         .thickness = 1,
                         .material = {arc_material_default(), arc_material_default()},
                         .mesh = arc_mesh_default()};
}

static arc_status check(const arc_model_def *def, arc_error *error) {
  if (!(def->thickness > 0) || !isfinite(def->thickness))
    return arc_fail(error, ARC_ARGUMENT, "thickness: expected above 0 mm, got %g mm",
                    def->thickness);
  for (int b = 0; b < ARC_BODIES; b++) {
    arc_error why;
    if (arc_material_check(def->material[b], &why) != ARC_OK)
      return arc_fail(error, ARC_ARGUMENT, "%s.%s", arc_body_name((arc_body)b), why.message);
  }
  return ARC_OK;
}

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

arc_status arc_model_build(const arc_model_def *def, arc_model **result, arc_error *error) {
  *result = NULL;
  arc_status status = check(def, error);
  if (status != ARC_OK) return status;
  arc_model *m = calloc(1, sizeof *m);
  if (!m) return arc_fail(error, ARC_MEMORY, "out of memory for a model");
  m->references = 1;
  m->def = *def;
  m->seconds = -now();
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++)
    status = arc_body_create(def, (arc_body)b, &m->body[b], error);
  m->seconds += now();
  if (status != ARC_OK) arc_model_release(&m);
  *result = m;
  return status;
}

arc_model *arc_model_retain(arc_model *model) {
  model->references++;
  return model;
}

void arc_model_release(arc_model **model) {
  if (!model || !*model) return;
  arc_model *m = *model;
  *model = NULL;
  if (--m->references > 0) return;
  for (int b = 0; b < ARC_BODIES; b++) arc_body_destroy(&m->body[b]);
  free(m);
}

const arc_model_def *arc_model_definition(const arc_model *model) {
  return &model->def;
}

const arc_mesh *arc_model_mesh(const arc_model *model, arc_body body) {
  return model->body[body]->mesh;
}

size_t arc_model_bytes(const arc_model *model) {
  return arc_body_bytes(model->body[ARC_CYLINDER]) + arc_body_bytes(model->body[ARC_PLATE]);
}

double arc_model_seconds(const arc_model *model) {
  return model->seconds;
}

const elastic_body *arc_model_body(const arc_model *model, arc_body which) {
  return model->body[which];
}
