/* One contact solution as an object: a pose, solved, and what users ask of it. */
#include "core/contact/solution.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define ARC_SETTING_OF arc_contact_def
const arc_setting arc_contact_settings[] = {
    ARC_CONTACT_SETTINGS(ARC_SETTING_NUMBER, ARC_SETTING_OTHER){.name = NULL},
};
#undef ARC_SETTING_OF

arc_contact_def arc_contact_default(void) {
  arc_contact_def def;
  arc_settings_default(arc_contact_settings, &def);
  return def;
}

static arc_status out_of_memory(arc_error *error) {
  return arc_fail(error, ARC_MEMORY, "out of memory for a contact solution");
}

static arc_status allocate(arc_contact *c) {
  if (arc_pose_create(&c->pose, c->shape->model) != ARC_OK) return ARC_MEMORY;
  for (int b = 0; b < ARC_BODIES; b++) {
    const size_t n = (size_t)c->shape->side[b].n;
    c->count[b] = (int)n;
    c->x[b] = calloc(5 * n, sizeof(double));
    if (!c->x[b]) return ARC_MEMORY;
    c->p[b] = c->x[b] + n;
    c->f[b] = c->p[b] + n;
    c->force[b] = c->f[b] + n;
  }
  return ARC_OK;
}

static void read_pressures(arc_contact *c) {
  arc_pose_pressures(&c->pose, c->p[ARC_CYLINDER], c->p[ARC_PLATE]);
  for (int b = 0; b < ARC_BODIES; b++) {
    const double *width = b == ARC_CYLINDER ? c->pose.wc : c->pose.wp;
    for (int i = 0; i < c->count[b]; i++) {
      c->x[b][i] = c->shape->side[b].xy[2 * i] + (b == ARC_PLATE ? c->pose.x : 0);
      c->f[b][i] = c->p[b][i] * width[i];
    }
    arc_pose_forces_on(&c->pose, (arc_body)b, c->force[b]);
  }
}

static void read_result(arc_contact *c) {
  double edges[2], center, largest;
  arc_pose_edges(&c->pose, c->shape, edges);
  arc_pose_peaks(&c->pose, &center, &largest);
  c->result =
      (arc_contact_result){.p_center = center,
                           .p_max = largest,
                           .p_average = arc_pose_average(&c->pose, c->shape, c->def.average),
                           .left = edges[0],
                           .right = edges[1],
                           .half_width = (edges[1] - edges[0]) / 2,
                           .approach = c->pose.approach,
                           .iterations = c->pose.iterations};
}

arc_status arc_contact_solve(const arc_shape *shape, const arc_contact_def *def,
                             const arc_callbacks *callbacks, arc_contact **result,
                             arc_error *error) {
  *result = NULL;
  arc_status status = arc_settings_check(arc_contact_settings, "", def, error);
  if (status != ARC_OK) return status;
  const double line = def->load / arc_model_definition(shape->model)->thickness;
  arc_contact *c = calloc(1, sizeof *c);
  if (!c) return out_of_memory(error);
  c->def = *def;
  status = arc_shape_clone(shape, &c->shape, error);
  if (status == ARC_OK && (status = allocate(c)) != ARC_OK) out_of_memory(error);
  if (status == ARC_OK) status = arc_pose_update(&c->pose, c->shape, def->x, error);
  if (status == ARC_OK) status = arc_pose_solve(&c->pose, line, error);
  if (status == ARC_OK) {
    read_pressures(c);
    read_result(c);
    arc_model_warn(shape->model, c->result.half_width, callbacks);
  } else {
    arc_contact_destroy(&c);
  }
#ifdef ARC_CHECKS
  arc_error broken;
  if (status == ARC_OK && arc_contact_validate(c, &broken) == ARC_NUMERIC) {
    status = arc_fail(error, ARC_NUMERIC, "%s", broken.message);
    arc_contact_destroy(&c);
  }
#endif
  *result = c;
  return status;
}

const arc_contact_def *arc_contact_definition(const arc_contact *c) {
  return &c->def;
}

void arc_contact_destroy(arc_contact **contact) {
  if (!contact || !*contact) return;
  arc_contact *c = *contact;
  arc_pose_free(&c->pose);
  for (int b = 0; b < ARC_BODIES; b++) free(c->x[b]);
  arc_shape_destroy(&c->shape);
  free(c);
  *contact = NULL;
}

size_t arc_contact_bytes(const arc_contact *c) {
  const size_t nodes = (size_t)(c->count[ARC_CYLINDER] + c->count[ARC_PLATE]);
  return sizeof *c + arc_shape_bytes(c->shape) + arc_pose_bytes(&c->pose) +
         5 * nodes * sizeof(double);
}

arc_contact_result arc_contact_get(const arc_contact *contact) {
  return contact->result;
}

arc_pressure arc_contact_pressure(const arc_contact *c, arc_body body) {
  return (arc_pressure){c->count[body], c->x[body], c->p[body], c->f[body], c->force[body]};
}

arc_model *arc_contact_model(const arc_contact *contact) {
  return contact->shape->model;
}

const arc_shape *arc_contact_shape(const arc_contact *contact) {
  return contact->shape;
}
