/* Creates the contact problems of the present block and the arrays of its points. */
#include "core/base/carve.h"
#include "core/plane/cycle.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

arc_status arc_path_create(wear_path *path, const arc_model *model, int has_friction) {
  const int nc = arc_model_mesh(model, ARC_CYLINDER)->surface;
  const int n = nc + arc_model_mesh(model, ARC_PLATE)->surface;
  carve_part parts[4 * 4 * ARC_BODIES];
  carve_part *next = parts;
  *path = (wear_path){.nodes = n, .has_friction = has_friction};
  for (int k = 0; k < 4; k++) {
    wear_point *point = k < 2 ? &path->point[k] : &path->image[k - 2];
    double **array[] = {point->p, point->q, point->u, point->f};
    for (int m = 0; m < 4; m++) {
      *next++ = (carve_part){&array[m][ARC_CYLINDER], (size_t)nc};
      *next++ = (carve_part){&array[m][ARC_PLATE], (size_t)(n - nc)};
    }
  }
  if (!ARC_CARVE(parts)) return ARC_MEMORY;
  if (!has_friction) return ARC_OK;
  const arc_status status = arc_friction_workspace_create(&path->workspace, model);
  return status == ARC_OK ? arc_friction_create(&path->state, model, 0) : status;
}

static void leave(wear_path *path) {
  for (int i = 0; i < path->problems; i++) arc_contact_problem_free(&path->problem[i]);
  for (int i = 0; i < path->problems && path->compliance; i++)
    arc_tangential_free(&path->compliance[i]);
  free(path->problem);
  free(path->compliance);
  path->compliance = NULL;
  path->problem = NULL;
  path->problems = 0;
  path->block = NULL;
}

void arc_path_free(wear_path *path) {
  leave(path);
  if (path->has_friction) {
    arc_friction_workspace_free(&path->workspace);
    arc_friction_free(&path->state);
  }
  free(path->point[0].p[0]);
  *path = (wear_path){0};
}

static arc_status create_compliances(wear_path *path, const wear_block *block,
                                     const arc_model *model) {
  arc_status status = ARC_OK;
  path->compliance = calloc((size_t)block->problems, sizeof *path->compliance);
  for (int i = 0; i < block->problems && path->compliance && status == ARC_OK; i++)
    status = arc_tangential_create(&path->compliance[i], model);
  return path->compliance ? status : ARC_MEMORY;
}

arc_status arc_path_enter(wear_path *path, const wear_block *block, const arc_model *model,
                          arc_error *error) {
  assert(block && block->problems > 0);
  if (path->block == block) return ARC_OK;
  leave(path);
  path->problem = calloc((size_t)block->problems, sizeof *path->problem);
  arc_status status = path->problem ? ARC_OK : ARC_MEMORY;
  for (; path->problems < block->problems && status == ARC_OK; path->problems++)
    status = arc_contact_problem_create(&path->problem[path->problems], model);
  if (path->has_friction && status == ARC_OK) status = create_compliances(path, block, model);
  if (status != ARC_OK) {
    leave(path);
    return arc_fail(error, ARC_MEMORY, "out of memory for %d contact problems", block->problems);
  }
  path->block = block;
  return ARC_OK;
}

void arc_path_clear(const wear_path *path, wear_point *point) {
  memset(point->p[0], 0, (size_t)(3 * path->nodes) * sizeof(double));
}

void arc_path_copy(const wear_path *path, const wear_point *from, wear_point *to) {
  memcpy(to->p[0], from->p[0], (size_t)(4 * path->nodes) * sizeof(double));
}
