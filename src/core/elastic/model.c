/* Models of two condensed bodies: settings, construction and warnings. */
#include "core/elastic/model.h"
#include "core/base/callbacks.h"
#include "core/base/memory.h"
#include "core/elastic/contact_estimate.h"
#include "core/elastic/imported_layers.h"
#include "core/elastic/imported_mesh.h"
#include "core/elastic/layered.h"
#include "core/elastic/mesh_size.h"
#include "core/elastic/pair.h"
#include "core/mesh/mesh.h"
#include "core/pair/model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* A model of two meshed bodies. */
typedef struct elastic_model {
  arc_model handle;
  elastic_body *body[ARC_BODIES];
  double *profile[ARC_BODIES]; /* copies of the heights of profiles in the definition */
  long version; /* version of the newest compliance; the next version is higher by one */
} elastic_model;

static const elastic_model *meshed(const arc_model *model) {
  return (const elastic_model *)model;
}

#define ARC_BODY_SETTING(role, name_, text_)                                                       \
  {                                                                                                \
    .name = name_, .unit = "", .kind = ARC_GROUP, .group = arc_body_settings,                      \
    .offset = offsetof(arc_model_def, body[role]), .class_name = "body",                           \
    .type = "a body such as body.cylinder{ radius=10 }", .text = text_                             \
  }

#define ARC_SETTING_OF arc_model_def
const arc_setting arc_model_settings[] = {
    ARC_MODEL_SETTINGS(ARC_SETTING_NUMBER, ARC_SETTING_CHOICE) ARC_MATERIAL_SETTING(
        offsetof(arc_model_def, material[ARC_CYLINDER]), "cylinder", "Material of the cylinder."),
    ARC_MATERIAL_SETTING(offsetof(arc_model_def, material[ARC_PLATE]), "plate",
                         "Material of the plate."),
    ARC_BODY_SETTING(ARC_UPPER, "upper",
                     "The upper body, which carries the load: body.cylinder{}, body.punch{}, ..."),
    ARC_BODY_SETTING(ARC_LOWER, "lower",
                     "The lower body, which moves: body.block{}, body.ring{}, ..."),
    {.name = "mesh",
     .unit = "",
     .kind = ARC_GROUP,
     .group = arc_mesh_settings,
     .offset = offsetof(arc_model_def, mesh),
     .text = "Element sizes and contact zones of the meshes.",
     .type = "a table { size=, height=, far=, zone=, rows=, element= }"},
    {.name = NULL},
};
#undef ARC_SETTING_OF

arc_model_def arc_model_default(void) {
  arc_model_def def = {0};
  arc_settings_default(arc_model_settings, &def);
  def.mesh = arc_mesh_default();
  return def;
}

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* A model under construction. The thread that builds the model may still run after the caller
 * has returned. */
typedef struct build {
  elastic_model *model;
  arc_mesh *given[ARC_BODIES]; /* imported meshes; NULL: the bodies are meshed */
  work_progress progress;
  arc_error error;
} build;

static arc_status build_bodies(void *job) {
  build *b = job;
  elastic_model *m = b->model;
  arc_status status = ARC_OK;
  m->handle.seconds = -now();
  for (int i = 0; i < ARC_BODIES && status == ARC_OK; i++)
    status = arc_body_create(&m->handle.def, (arc_body)i, &b->given[i], &b->progress, &m->body[i],
                             &b->error);
  m->handle.seconds += now();
  return status;
}

static void discard(void *job) {
  build *b = job;
  if (b->model) arc_elastic_destroy(&b->model->handle);
  for (int i = 0; i < ARC_BODIES; i++) arc_mesh_destroy(&b->given[i]);
  free(b);
}

/* Replaces the profiles of the definition, which the caller owns, by copies. */
static arc_status keep_profiles(elastic_model *m) {
  arc_status status = ARC_OK;
  for (int b = 0; b < ARC_BODIES; b++)
    if (arc_body_keep_series(&m->handle.def.body[b], &m->profile[b]) != ARC_OK) status = ARC_MEMORY;
  return status;
}

static build *begin_build(const arc_model_def *def) {
  build *b = calloc(1, sizeof *b);
  if (b) b->model = calloc(1, sizeof *b->model);
  if (!b || !b->model) {
    free(b);
    return NULL;
  }
  b->progress.stages = ARC_BODIES * ARC_BODY_STAGES;
  b->model->handle = (arc_model){.kind = arc_kind_of(def->geometry), .references = 1, .def = *def};
  b->model->version = ARC_UNWORN_VERSION;
  if (keep_profiles(b->model) == ARC_OK) return b;
  arc_elastic_destroy(&b->model->handle);
  free(b);
  return NULL;
}

static arc_status refuse_memory(const arc_model_def *def, arc_error *error) {
  const double needed = arc_model_memory(def), free_bytes = arc_memory_free();
  if (!(needed > free_bytes)) return ARC_OK;
  return arc_fail(error, ARC_MEMORY,
                  "the model needs about %.2g GB of memory, and %.2g GB are free: use a mesh.size "
                  "above %.2g mm, or zones smaller than %g and %g mm",
                  needed / 1e9, free_bytes / 1e9, def->mesh.size * sqrt(needed / free_bytes),
                  def->mesh.zone[ARC_CYLINDER], def->mesh.zone[ARC_PLATE]);
}

/* Builds a model, which then owns the imported meshes `given` (NULL: no imported meshes). */
static arc_status build_with_callbacks(const arc_model_def *def, arc_mesh *given[ARC_BODIES],
                                       const arc_callbacks *callbacks, arc_model **result,
                                       arc_error *error) {
  build *b = begin_build(def);
  if (!b) return arc_fail(error, ARC_MEMORY, "out of memory for a model");
  for (int i = 0; i < ARC_BODIES && given; i++) {
    b->given[i] = given[i];
    given[i] = NULL;
  }
  const worker_task work = {build_bodies, discard, &b->progress};
  int left_behind;
  const arc_status status = arc_worker_thread_run(&work, b, "model", callbacks, &left_behind);
  if (left_behind) return arc_fail(error, status, "stopped while a model was built");
  if (status == ARC_OK) {
    *result = &b->model->handle;
    b->model = NULL;
  } else {
    arc_fail(error, status, "%s", b->error.message);
  }
  discard(b);
  return status;
}

/* Checks a definition and replaces its "auto" values. */
static arc_status settle(arc_model_def *def, arc_error *error) {
  arc_status status = arc_settings_check(arc_model_settings, "", def, error);
  if (status == ARC_OK) status = arc_model_check_pair(def, error);
  if (status == ARC_OK) status = arc_given_refuse(def, error);
  if (status != ARC_OK) return status;
  arc_model_fit_alone(def);
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++) {
    const arc_body_def solid = arc_model_solid(def, (arc_body)b);
    status = arc_mesh_check(&def->mesh, (arc_body)b, &solid, error);
  }
  return status;
}

arc_status arc_elastic_check(const arc_model_def *def, arc_error *error) {
  arc_model_def settled = *def;
  return settle(&settled, error);
}

arc_status arc_elastic_build(const arc_model_def *wanted, const arc_callbacks *callbacks,
                             arc_model **result, arc_error *error) {
  *result = NULL;
  arc_model_def def = *wanted;
  arc_status status = settle(&def, error);
  if (status == ARC_OK) status = refuse_memory(&def, error);
  return status == ARC_OK ? build_with_callbacks(&def, NULL, callbacks, result, error) : status;
}

arc_status arc_model_build_given(const arc_model_def *def, arc_mesh *given[ARC_BODIES],
                                 const arc_callbacks *callbacks, arc_model **result,
                                 arc_error *error) {
  *result = NULL;
  arc_model_def settled;
  arc_status status = arc_given_settle(def, given, &settled, error);
  if (status == ARC_OK) status = build_with_callbacks(&settled, given, callbacks, result, error);
  for (int b = 0; b < ARC_BODIES; b++) arc_mesh_destroy(&given[b]);
  return status;
}

int arc_model_is_given(const arc_model *model) {
  const arc_mesh *upper = arc_model_mesh(model, ARC_UPPER),
                 *lower = arc_model_mesh(model, ARC_LOWER);
  return upper && (upper->rows == 0 || lower->rows == 0);
}

void arc_elastic_destroy(arc_model *model) {
  elastic_model *m = (elastic_model *)model;
  for (int b = 0; b < ARC_BODIES; b++) {
    arc_body_destroy(&m->body[b]);
    free(m->profile[b]);
  }
  free(m);
}

const arc_mesh *arc_elastic_mesh(const arc_model *model, arc_body body) {
  return meshed(model)->body[body]->mesh;
}

size_t arc_elastic_bytes(const arc_model *model) {
  return arc_body_bytes(meshed(model)->body[ARC_CYLINDER]) +
         arc_body_bytes(meshed(model)->body[ARC_PLATE]);
}

double arc_model_apparent_modulus(const arc_model *m, double q) {
  arc_material own[ARC_BODIES] = {m->def.material[0], m->def.material[1]};
  arc_body_def solid[ARC_BODIES];
  for (int b = 0; b < ARC_BODIES; b++)
    solid[b] = meshed(m)->body[b]->stratum ? arc_body_under_middle(meshed(m)->body[b], &own[b])
                                           : arc_model_solid(&m->def, (arc_body)b);
  return arc_pair_modulus(m->def.geometry, solid, own, q);
}

/* Warns if CPE4 elements of a body lock, which is assumed if Poisson's ratio is above 0.45. With
 * elements of 20 um the error of the pressure is 0.4 % at a ratio of 0.45 and 3 % at 0.49. */
static void warn_locking(const arc_model *m, arc_body which, const arc_callbacks *callbacks) {
  const elastic_body *body = meshed(m)->body[which];
  if (m->def.geometry == ARC_PLANE_STRESS) return; /* elements do not lock in plane stress */
  if (body->mesh->def.element != ARC_CPE4 || body->material.nu <= 0.45) return;
  arc_warn(callbacks,
           "CPE4 elements lock at nu = %g of the %s: pressures may be far too high; use "
           "mesh.element = \"auto\" or \"CPE4I\"",
           body->material.nu, arc_body_name(body->mesh->body));
}

enum { fewest = 4 }; /* smallest number of elements in a contact, or in one of its sharp edges */

/* Smallest number of elements in a contact spot of a rough profile. In tests with about two
 * elements the errors of the pressure were 3 % to 4 %. */
static const double least_of_spot = 3;

/* Largest number of elements in the half width for which a finer mesh is suggested. Models with
 * such meshes are built within half a minute. */
static const double most_elements = 250;

/* Warns if the spots or the sharp edges of the unworn contact have too few elements. The
 * pressure peaks are 6 % too low with three elements in an edge, and 16 % with two elements. */
static void warn_edges(const arc_model *m, double load, const arc_callbacks *callbacks) {
  const double size = m->def.mesh.size;
  if (!(load > 0) || arc_model_is_given(m)) return;
  const contact_estimate e = arc_model_estimate(&m->def, load);
  if (e.spot < least_of_spot * size)
    arc_warn(callbacks,
             "the waves of the profile touch over %.2g mm, fewer than %g elements of %g mm: "
             "pressures on their crests may be off by several per cent; mesh.size = %.2g resolves "
             "them",
             e.spot, least_of_spot, size, e.spot / 5);
  if (e.edge >= 0.5 * e.half_width || e.edge >= fewest * size) return;
  const double fine = arc_model_size_for(e.edge);
  char advice[60] = "a mesh that resolves them would be too large";
  if (e.half_width < most_elements * fine)
    snprintf(advice, sizeof advice, "mesh.size = %.2g resolves them", fine);
  arc_warn(callbacks,
           "pressure rises over %.2g mm at the edges of the contact, fewer than %d elements of %g "
           "mm: its peaks there are too low until wear widens the edges; %s",
           e.edge, fewest, size, advice);
}

/* Returns the height of a body's surface at the node nearest to position s [mm]. */
static double height_at(const elastic_body *body, double s) {
  const arc_mesh *m = body->mesh;
  const int next = arc_chart_nearest(body->box_at, m->rows + 1, m->surface, s);
  return arc_body_top(body, next)[1];
}

/* Returns the slope of a hollow surface at the edges of a contact. For surfaces that are not
 * hollow the result is negative. */
static double hollow_slope(const arc_model *m, arc_body which, double half_width) {
  const elastic_body *body = meshed(m)->body[which];
  const double rise =
      height_at(body, half_width) + height_at(body, -half_width) - 2 * height_at(body, 0);
  return (which == ARC_PLATE ? rise : -rise) / half_width;
}

/* Warns if an imported mesh seems to be a hole, in which slopes are not small. The pressure in
 * the middle is 0.3 % too low at a slope of 0.15, and 2 % at a slope of 0.4. */
static void warn_hollow(const arc_model *m, double half_width, const arc_callbacks *callbacks) {
  const double steep = 0.15;
  if (!arc_model_is_given(m) || meshed(m)->body[ARC_PLATE]->chart.polar || !(half_width > 0))
    return;
  const double slope =
      fmax(hollow_slope(m, ARC_PLATE, half_width), hollow_slope(m, ARC_CYLINDER, half_width));
  if (slope > steep)
    arc_warn(callbacks,
             "the contact is treated as flat, but lies in a hole and slopes by %.0f degrees at its "
             "edges: pressures are too low; give body.ring{} and body.disc{} with the radius "
             "beside the mesh",
             atan(slope) / arc_radians(1));
}

void arc_model_warn(const arc_model *model, double load, double half_width,
                    const arc_callbacks *callbacks) {
  if (!callbacks || !callbacks->warn) return;
  warn_edges(model, load, callbacks);
  warn_hollow(model, half_width, callbacks);
  for (int b = 0; b < ARC_BODIES; b++) warn_locking(model, (arc_body)b, callbacks);
  const double size = model->def.mesh.size;
  if (2 * half_width < fewest * size)
    arc_warn(callbacks,
             "the contact, %.2g mm wide, has fewer than %d elements of %g mm: pressures may be far "
             "off; %s",
             2 * half_width, fewest, size,
             model->def.mesh.fineness > 0
                 ? "mesh.size was chosen for another load: give the model's fields to contact{} or "
                   "wear{}, which choose mesh.size for their load, or use a smaller size"
                 : "use mesh.size = \"auto\" or a smaller one");
}

long arc_model_next_version(arc_model *model) {
  return ++((elastic_model *)model)->version;
}

const elastic_body *arc_model_body(const arc_model *model, arc_body which) {
  return meshed(model)->body[which];
}
