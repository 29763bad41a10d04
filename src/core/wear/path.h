/* The way the plate goes: blocks of loading as they are simulated, and the poses of contact that
 * belong to one of them. */
#ifndef WEAR_PATH_H
#define WEAR_PATH_H

#include "archard/wear.h"
#include "core/friction/friction.h"
#include "core/elastic/contact_estimate.h"

/* A block of loading: points, which of them share a pose, how often. */
typedef struct wear_block {
  int count;          /* points; increments between them */
  double *x;          /* [count] plate position [mm] */
  double *line;       /* [count] load per thickness [N/mm], 0: lifted off */
  double *pose_x;     /* [count] plate position of the contact [mm]: x, or 0 for NSP */
  double *angle;      /* [count] of the load [rad]; 0 but in holes */
  double *tangential; /* [count] force per thickness that drives the plate [N/mm]; NULL: x does */
  int press;          /* with friction: the point at which surfaces are pressed together */
  int *place;         /* [count] which pose a point belongs to */
  int poses;
  int periodic;
  double load, travel; /* largest [N]; from one end of the way to the other [mm] */
  double repeat;  /* 2 where a half cycle stands for a whole one, 1/2 where both strokes stand for
                     one, else 1 */
  double sliding; /* travelled distance of a cycle [mm] */
  double cycles;  /* how often, may be INFINITY for the last */
  double start_distance, start_cycle; /* of the run, where this block begins */
} wear_block;

/* The blocks of a checked definition: block [count], freed by arc_wear_blocks_free. */
arc_status arc_wear_blocks_create(const arc_wear_def *def, const arc_model_def *model,
                                  wear_block **block, int *count);
void arc_wear_blocks_free(wear_block **block, int count);
/* arc_wear_reach of a pair that is asked for more loads than one. */
double arc_wear_reach_of(contact_pair *pair, double load);
/* Load below which contact is followed no closer [N]: what wears there is next to nothing. */
double arc_loading_least(const arc_loading *from, const arc_model_def *model);
/* How long the increment that ends at point i of a loading is, over what follows the contact there,
 * or that of the least load; 0 where nothing touches. */
double arc_loading_length(contact_pair *pair, const arc_loading *from, double least, int i);
/* How many increments a loading is simulated in, at least one between two of its points; into parts
 * [count] (NULL: not asked) those that end at each point. */
double arc_loading_increments(const arc_wear_def *def, const arc_model_def *model,
                              const arc_loading *from, double *parts);
/* Where it ends [mm]. */
double arc_wear_block_end(const wear_block *block);

/* One point of the path, solved. Arrays by body; one block. */
typedef struct wear_point {
  double *p[ARC_BODIES]; /* pressure [MPa] */
  double *q[ARC_BODIES]; /* what wears: p times the factors of law and place [MPa] */
  double *u[ARC_BODIES]; /* elastic displacement along x [mm] */
  double *f[ARC_BODIES]; /* factor of the place */
} wear_point;

/* The block at hand, its poses (which know themselves whether they are up to date) and the last two
 * points that were solved: point i in point[i % 2]. */
typedef struct wear_path {
  const wear_block *block; /* NULL: none yet */
  int poses;
  pose *pose; /* [poses] */
  int nodes;  /* surface nodes of both bodies */
  wear_point point[2];
  wear_point image[2]; /* mirror images of those, where factors of places tell them apart */

  /* with friction */
  int rubs;
  tangential_compliance *compliance; /* [poses] */
  friction_workspace workspace;
  friction_state state;
} wear_path;

/* Room for the points; ARC_MEMORY leaves nothing to free. */
arc_status arc_path_create(wear_path *path, const arc_model *model, int rubs);
void arc_path_free(wear_path *path);
/* Makes poses for a block, unless it is the one at hand. ARC_MEMORY: no block is at hand. */
arc_status arc_path_enter(wear_path *path, const wear_block *block, const arc_model *model,
                          arc_error *error);
/* Zeroes a point: lifted off. */
void arc_path_clear(const wear_path *path, wear_point *point);
void arc_path_copy(const wear_path *path, const wear_point *from, wear_point *to);

#endif
