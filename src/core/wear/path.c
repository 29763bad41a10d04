/* The poses and points of the block at hand. Leans on the contact layer's poses. */
#include "core/wear/path.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

arc_status arc_path_create(wear_path *path, const arc_model *model) {
  const int nc = arc_model_mesh(model, ARC_CYLINDER)->surface;
  const int n = nc + arc_model_mesh(model, ARC_PLATE)->surface;
  double *at = calloc((size_t)(8 * n), sizeof *at);
  *path = (wear_path){.nodes = n};
  if (!at) return ARC_MEMORY;
  for (int k = 0; k < 2; k++) {
    double **part[] = {path->point[k].p, path->point[k].q, path->point[k].u, path->point[k].f};
    for (int m = 0; m < 4; m++, at += n) {
      part[m][ARC_CYLINDER] = at;
      part[m][ARC_PLATE] = at + nc;
    }
  }
  return ARC_OK;
}

static void leave(wear_path *path) {
  for (int i = 0; i < path->poses; i++) arc_pose_free(&path->pose[i]);
  free(path->pose);
  path->pose = NULL;
  path->poses = 0;
  path->block = NULL;
}

void arc_path_free(wear_path *path) {
  leave(path);
  free(path->point[0].p[0]);
  *path = (wear_path){0};
}

arc_status arc_path_enter(wear_path *path, const wear_block *block, const arc_model *model,
                          arc_error *error) {
  assert(block && block->poses > 0);
  if (path->block == block) return ARC_OK;
  leave(path);
  path->pose = calloc((size_t)block->poses, sizeof *path->pose);
  arc_status status = path->pose ? ARC_OK : ARC_MEMORY;
  for (; path->poses < block->poses && status == ARC_OK; path->poses++)
    status = arc_pose_create(&path->pose[path->poses], model);
  if (status != ARC_OK) {
    leave(path);
    return arc_fail(error, ARC_MEMORY, "out of memory for %d contact poses", block->poses);
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
