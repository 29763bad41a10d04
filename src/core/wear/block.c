/* Blocks of loading as they are simulated: the reciprocating stroke, or the user's. */
#include "core/wear/run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* More distinct positions than this share one pose, which is built anew at every point. */
enum { most_poses = 2048 };

static arc_status block_create(wear_block *b, int count) {
  const size_t n = (size_t)count;
  *b = (wear_block){.count = count, .repeat = 1};
  b->x = calloc(5 * n, sizeof(double));
  b->place = malloc(n * sizeof(int));
  if (!b->x || !b->place) return ARC_MEMORY;
  b->line = b->x + n;
  b->pose_x = b->line + n;
  b->angle = b->pose_x + n;
  return ARC_OK;
}

static int compare(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* NSP looks at the flat plate at x = 0 only, and a way out of the plane leads nowhere else. */
static void one_pose(wear_block *b, double x) {
  b->poses = 1;
  for (int i = 0; i < b->count; i++) b->pose_x[i] = x;
  memset(b->place, 0, (size_t)b->count * sizeof *b->place);
}

/* Equal positions share a pose. */
static void find_poses(wear_block *b) {
  double *position = b->pose_x; /* sorted, each once */
  int n = 0;
  memcpy(position, b->x, (size_t)b->count * sizeof *b->x);
  qsort(position, (size_t)b->count, sizeof *position, compare);
  for (int i = 0; i < b->count; i++)
    if (n == 0 || position[i] != position[n - 1]) position[n++] = position[i];
  for (int i = 0; i < b->count; i++) {
    const double *at = bsearch(&b->x[i], position, (size_t)n, sizeof *position, compare);
    b->place[i] = n > most_poses ? 0 : (int)(at - position);
  }
  b->poses = n > most_poses ? 1 : n;
  memcpy(b->pose_x, b->x, (size_t)b->count * sizeof *b->x);
}

/* A force has a way only once it is solved for: it counts as force / E*. */
static double way_of_force(const wear_block *b, const arc_model_def *model) {
  double once = 0;
  for (int i = 1; i < b->count; i++) once += fabs(b->tangential[i] - b->tangential[i - 1]);
  return once / arc_contact_modulus(model->geometry, model->material);
}

static void finish(wear_block *b, const arc_wear_def *def, const arc_model_def *model) {
  const arc_procedure procedure = arc_wear_choose_procedure(def, model);
  double once = b->tangential ? way_of_force(b, model) : 0, low = b->x[0], high = b->x[0];
  for (int i = 1; i < b->count; i++) {
    once += fabs(b->x[i] - b->x[i - 1]);
    low = fmin(low, b->x[i]);
    high = fmax(high, b->x[i]);
  }
  b->sliding = b->repeat * once;
  b->travel = high - low;
  if (procedure == ARC_NSP || def->slide == ARC_SLIDE_Z)
    one_pose(b, 0);
  else if (arc_wear_rubs(def) && b->travel <= arc_wear_reach(model, b->load))
    one_pose(b, (low + high) / 2); /* points that stick keep their partners */
  else
    find_poses(b);
}

/* A force to and fro; pressed where it is about 0. */
static arc_status by_force(const arc_wear_def *def, const arc_model_def *model, wear_block *b) {
  const int half = arc_wear_def_increments(def, model) / 2;
  const arc_status status = block_create(b, 2 * half + 1);
  if (status != ARC_OK) return status;
  b->tangential = b->angle + b->count;
  for (int i = 0; i < b->count; i++) {
    const int at = i <= half ? i : 2 * half - i;
    b->tangential[i] = def->tangential / model->thickness * (2 * at - half) / half;
    b->line[i] = def->load / model->thickness;
  }
  b->periodic = 1;
  b->cycles = INFINITY;
  b->press = half + (half + 1) / 2;
  b->load = def->load;
  finish(b, def, model);
  return ARC_OK;
}

/* The plate's position at point i of `last` along a stroke from -s/2 to s/2: symmetric to the bit.
 */
static double along(double stroke, int i, int last) {
  return stroke * (2 * i - last) / (2.0 * last);
}

/* The paper's cycle: half of it, counted twice (r = 2), or the single pass over the plate (r = 1).
 * Where the geometry is updated within the cycle, and with friction, both strokes are simulated,
 * which stand for one of the passes. NSP needs no more than the ends, unless slip has to be found.
 */
static arc_status reciprocating(const arc_wear_def *def, const arc_model_def *model,
                                wear_block *b) {
  if (def->tangential > 0) return by_force(def, model, b);
  const int rubs = arc_wear_rubs(def);
  const arc_procedure procedure = arc_wear_choose_procedure(def, model);
  const int over = arc_wear_over_plate(def, model),
            back = rubs || (def->update == ARC_UPDATE_INCREMENT && !over);
  const int stays = (procedure == ARC_NSP && !rubs) || def->slide == ARC_SLIDE_Z;
  const int half =
      stays && def->update == ARC_UPDATE_CYCLE ? 1 : arc_wear_def_increments(def, model) / 2;
  const arc_status status = block_create(b, back ? 2 * half + 1 : half + 1);
  if (status != ARC_OK) return status;
  for (int i = 0; i < b->count; i++) {
    b->x[i] = along(arc_wear_def_stroke(def), i <= half ? i : 2 * half - i, half);
    b->angle[i] = arc_radians(def->load_angle);
    b->line[i] = def->load / model->thickness;
  }
  b->periodic = 1;
  b->cycles = INFINITY;
  b->repeat = over && back ? 0.5 : over || back ? 1 : 2;
  if (rubs) b->press = half + (half + 1) / 2; /* about x = 0 */
  b->load = def->load;
  finish(b, def, model);
  /* r s to the bit, whatever the increments add up to */
  b->sliding = (over ? 1 : 2) * arc_wear_def_stroke(def);
  b->travel = arc_wear_def_stroke(def);
  return ARC_OK;
}

double arc_loading_x(const arc_loading *from, const arc_model_def *model, int i) {
  return from->rotation ? arc_model_way(model, from->rotation[i]) : from->x[i];
}

/* Direction of the load [degrees]. */
static double angle_of(const arc_wear_def *def, const arc_loading *from, int i) {
  return from->load_angle ? from->load_angle[i] : def->load_angle;
}

double arc_wear_reach_of(contact_pair *pair, double load) {
  static const double share = 0.125; /* centre pressures within 1 % for short strokes, too */
  return share * arc_pair_estimate(pair, load).half_width;
}

double arc_wear_reach(const arc_model_def *model, double load) {
  contact_pair pair = arc_model_pair(model);
  return arc_wear_reach_of(&pair, load);
}

/* The contact goes with the load; the plate slides under it. [mm] */
static double way_to(const arc_loading *from, const arc_model_def *model, int i) {
  const double way = fabs(arc_loading_x(from, model, i) - arc_loading_x(from, model, i - 1));
  if (!from->load_angle) return way;
  return way + fabs(arc_model_way(model, from->load_angle[i] - from->load_angle[i - 1]));
}

/* Of a load that lifts off contact gets as narrow as one likes: below this share of the mean over
 * the way all loads together wear less than that share of all. */
double arc_loading_least(const arc_loading *from, const arc_model_def *model) {
  static const double share = 0.01;
  double sum = 0, whole = 0;
  for (int i = 1; i < from->count; i++) {
    const double way = way_to(from, model, i);
    sum += way * (from->load[i] + from->load[i - 1]) / 2;
    whole += way;
  }
  return whole > 0 ? share * sum / whole : 0;
}

double arc_loading_length(contact_pair *pair, const arc_loading *from, double least, int i) {
  const double load = fmax(from->load[i - 1], from->load[i]);
  if (!(load > 0)) return 0;
  return way_to(from, pair->def, i) / arc_wear_reach_of(pair, fmax(load, least));
}

/* As many as follow the contact there, unless the number is the user's. */
double arc_loading_increments(const arc_wear_def *def, const arc_model_def *model,
                              const arc_loading *from, double *parts) {
  enum { of_load = 100 }; /* a contact that stays where it is: only its load has to be followed */
  const int stays = def->slide == ARC_SLIDE_Z && !from->load_angle;
  const int follow = def->increments == 0 && arc_wear_choose_procedure(def, model) != ARC_NSP;
  const double least = follow ? arc_loading_least(from, model) : 0;
  contact_pair pair = {.def = NULL};
  double count = 0;
  if (follow) pair = arc_model_pair(model);
  for (int i = 1; i < from->count; i++) {
    const double length = follow ? arc_loading_length(&pair, from, least, i) : 1;
    double here = fmax(1, ceil(length * (1 - 1e-9)));
    if (stays) here = fmin(here, of_load);
    if (parts) parts[i] = here;
    count += here;
  }
  return count;
}

/* Fills a block with the increments that end at each point. */
static void fill(const arc_wear_def *def, const arc_model_def *model, const arc_loading *from,
                 const double *parts, wear_block *b) {
  int at = 0;
  if (from->tangential) {
    b->tangential = b->angle + b->count;
    b->tangential[0] = from->tangential[0] / model->thickness;
  }
  b->x[0] = arc_loading_x(from, model, 0);
  b->angle[0] = arc_radians(angle_of(def, from, 0));
  b->line[0] = from->load[0] / model->thickness;
  for (int i = 1; i < from->count; i++) {
    const int n = (int)parts[i];
    for (int j = 1; j <= n; j++) { /* the last is the point itself, to the bit */
      const double left = (double)(n - j) / n, right = (double)j / n;
      b->x[++at] = left * arc_loading_x(from, model, i - 1) + right * arc_loading_x(from, model, i);
      b->angle[at] =
          arc_radians(left * angle_of(def, from, i - 1) + right * angle_of(def, from, i));
      b->line[at] = (left * from->load[i - 1] + right * from->load[i]) / model->thickness;
      if (b->tangential)
        b->tangential[at] =
            (left * from->tangential[i - 1] + right * from->tangential[i]) / model->thickness;
    }
  }
  for (int i = 0; i < from->count; i++) b->load = fmax(b->load, from->load[i]);
  b->periodic = from->periodic;
  b->cycles = from->cycles;
  finish(b, def, model);
}

static arc_status given(const arc_wear_def *def, const arc_model_def *model,
                        const arc_loading *from, wear_block *b) {
  double *parts = malloc((size_t)from->count * sizeof *parts);
  if (!parts) return ARC_MEMORY;
  const double increments = arc_loading_increments(def, model, from, parts);
  const arc_status status = block_create(b, 1 + (int)increments);
  if (status == ARC_OK) fill(def, model, from, parts, b);
  free(parts);
  return status;
}

arc_status arc_wear_blocks_create(const arc_wear_def *def, const arc_model_def *model,
                                  wear_block **block, int *count) {
  *count = def->blocks > 0 ? def->blocks : 1;
  *block = calloc((size_t)*count, sizeof **block);
  if (!*block) return ARC_MEMORY;
  double distance = def->start_distance, cycle = def->start_cycle;
  for (int b = 0; b < *count; b++) {
    wear_block *at = &(*block)[b];
    const arc_status status =
        def->blocks > 0 ? given(def, model, &def->loading[b], at) : reciprocating(def, model, at);
    if (status != ARC_OK) {
      arc_wear_blocks_free(block, *count);
      return status;
    }
    at->start_distance = distance;
    at->start_cycle = cycle;
    distance += at->cycles * at->sliding;
    cycle += at->cycles;
  }
  return ARC_OK;
}

void arc_wear_blocks_free(wear_block **block, int count) {
  for (int b = 0; *block && b < count; b++) {
    free((*block)[b].x);
    free((*block)[b].place);
  }
  free(*block);
  *block = NULL;
}

double arc_wear_block_end(const wear_block *block) {
  return block->start_distance + block->cycles * block->sliding;
}

/* Cycles tell blocks apart where distances do not (a generic history may stand still). */
const wear_block *arc_wear_block_at(const arc_wear *w, double cycle) {
  int b = 0;
  while (b + 1 < w->blocks && cycle >= w->block[b + 1].start_cycle * (1 - 1e-13)) b++;
  return &w->block[b];
}
