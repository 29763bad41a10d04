/* Creates the blocks of a loading with their increments, from the stroke or from the loading of the
 * definition. */
#include "core/base/angle.h"
#include "core/wear/run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Largest number of contact problems of a block. A block with more positions has a single problem,
 * which is built again at every point. */
enum { most_problems = 2048 };

static arc_status block_create(wear_block *b, int count) {
  const size_t n = (size_t)count;
  *b = (wear_block){.count = count, .repeat = 1};
  b->x = calloc(5 * n, sizeof(double));
  b->problem_of = malloc(n * sizeof(int));
  if (!b->x || !b->problem_of) return ARC_MEMORY;
  b->line = b->x + n;
  b->problem_x = b->line + n;
  b->angle = b->problem_x + n;
  return ARC_OK;
}

static int compare(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Creates a single contact problem with the plate at x [mm]. It suffices, at x = 0, for the
 * procedure NSP and for sliding out of the plane. */
static void one_problem(wear_block *b, double x) {
  b->problems = 1;
  for (int i = 0; i < b->count; i++) b->problem_x[i] = x;
  memset(b->problem_of, 0, (size_t)b->count * sizeof *b->problem_of);
}

/* Creates one contact problem for each distinct position of the plate. */
static void find_problems(wear_block *b) {
  double *position = b->problem_x; /* positions of the plate, sorted, without repetitions */
  int n = 0;
  memcpy(position, b->x, (size_t)b->count * sizeof *b->x);
  qsort(position, (size_t)b->count, sizeof *position, compare);
  for (int i = 0; i < b->count; i++)
    if (n == 0 || position[i] != position[n - 1]) position[n++] = position[i];
  for (int i = 0; i < b->count; i++) {
    const double *at = bsearch(&b->x[i], position, (size_t)n, sizeof *position, compare);
    b->problem_of[i] = n > most_problems ? 0 : (int)(at - position);
  }
  b->problems = n > most_problems ? 1 : n;
  memcpy(b->problem_x, b->x, (size_t)b->count * sizeof *b->x);
}

/* Returns the nominal sliding distance [mm] of a cycle that is driven by a force, because the
 * displacement is unknown until the contact is solved. The distance is the sum of all changes of
 * the force per thickness, divided by E*. If the force is constant, changes of the load are used
 * instead. */
static double sliding_of_force(const wear_block *b, const wear_manner *m) {
  double force = 0, load = 0;
  for (int i = 1; i < b->count; i++) {
    force += fabs(b->tangential[i] - b->tangential[i - 1]);
    load += fabs(b->line[i] - b->line[i - 1]);
  }
  return (force > 0 ? force : load) / m->modulus;
}

static int increments_of(const arc_wear_def *def, const arc_model_def *model) {
  enum { usual = 100 };
  const arc_kind *kind = arc_kind_of(model->geometry);
  if (kind->increments) return kind->increments(def, model);
  return def->increments > 0 ? def->increments : usual;
}

/* Computes the numbers of increments between consecutive points of a loading. Returns their sum.
 * Kinds of pair that do not choose increments have one increment between two points. */
static double parts_of(const arc_wear_def *def, const arc_model_def *model, const arc_loading *from,
                       double *parts) {
  const arc_kind *kind = arc_kind_of(model->geometry);
  if (kind->parts) return kind->parts(def, model, from, parts);
  for (int i = 1; i < from->count; i++) parts[i] = 1;
  return from->count - 1;
}

static void finish(wear_block *b, const arc_wear_def *def, const arc_model_def *model,
                   const wear_manner *m) {
  double once = b->tangential ? sliding_of_force(b, m) : 0, low = b->x[0], high = b->x[0];
  for (int i = 1; i < b->count; i++) {
    once += fabs(b->x[i] - b->x[i - 1]);
    low = fmin(low, b->x[i]);
    high = fmax(high, b->x[i]);
  }
  b->sliding = b->repeat * once;
  b->travel = high - low;
  if (m->rests)
    one_problem(b, 0);
  else if (arc_wear_has_friction(def) &&
           b->travel <= arc_kind_of(model->geometry)->reach(model, b->load))
    one_problem(b, (low + high) / 2); /* preserves pairs of points that stick */
  else
    find_problems(b);
}

/* Creates a cycle of an alternating tangential force. The bodies are pressed together where the
 * force in the cycle is closest to 0. */
static arc_status by_force(const arc_wear_def *def, const arc_model_def *model,
                           const wear_manner *m, wear_block *b) {
  const int half = increments_of(def, model) / 2;
  const arc_status status = block_create(b, 2 * half + 1);
  if (status != ARC_OK) return status;
  b->tangential = b->angle + b->count;
  for (int i = 0; i < b->count; i++) {
    const int at = i <= half ? i : 2 * half - i;
    b->tangential[i] = def->tangential / m->thickness * (2 * at - half) / half;
    b->line[i] = def->load / m->thickness;
  }
  b->periodic = 1;
  b->cycles = INFINITY;
  b->press = half + (half + 1) / 2;
  b->load = def->load;
  finish(b, def, model, m);
  return ARC_OK;
}

/* Returns the position of the plate [mm] at point i (0 to last) of a stroke, from -stroke / 2 to
 * stroke / 2. The positions are exactly symmetric. */
static double along(double stroke, int i, int last) {
  return stroke * (2 * i - last) / (2.0 * last);
}

/* Creates the cycle of a plain stroke. The block is one stroke. Its wear counts twice if a cycle
 * has two strokes, and once for a single pass over the plate. With updates within the cycle, or
 * with friction, the block contains both strokes. Without friction, the procedure NSP needs only
 * the end points of the stroke. */
static arc_status reciprocating(const arc_wear_def *def, const arc_model_def *model,
                                const wear_manner *m, wear_block *b) {
  if (def->tangential > 0) return by_force(def, model, m, b);
  const int has_friction = arc_wear_has_friction(def), over = m->strokes == 1;
  const int back = has_friction || (def->update == ARC_UPDATE_INCREMENT && !over);
  const int ends = m->rests && !has_friction && def->update == ARC_UPDATE_CYCLE;
  const int half = ends ? 1 : increments_of(def, model) / 2;
  const arc_status status = block_create(b, back ? 2 * half + 1 : half + 1);
  if (status != ARC_OK) return status;
  for (int i = 0; i < b->count; i++) {
    b->x[i] = along(m->stroke, i <= half ? i : 2 * half - i, half);
    b->angle[i] = arc_radians(def->load_angle);
    b->line[i] = def->load / m->thickness;
  }
  b->periodic = 1;
  b->cycles = INFINITY;
  b->repeat = over && back ? 0.5 : over || back ? 1 : 2;
  if (has_friction)
    b->press = half + (half + 1) / 2; /* the increment of the return stroke at which x is about 0 */
  b->load = def->load;
  finish(b, def, model, m);
  /* number of strokes times stroke, without the rounding errors of the sum over increments */
  b->sliding = m->strokes * m->stroke;
  b->travel = m->stroke;
  return ARC_OK;
}

/* Returns the position of the lower body at point i [mm]. */
static double position(const arc_loading *from, const wear_manner *m, int i) {
  return from->rotation ? m->radius * arc_radians(from->rotation[i]) : from->x[i];
}

/* Returns the direction of the load at point i of a loading [degrees]. */
static double angle_of(const arc_wear_def *def, const arc_loading *from, int i) {
  return from->load_angle ? from->load_angle[i] : def->load_angle;
}

/* Sets the increments of a block, which divide the intervals between the points of a loading. */
static void fill(const arc_wear_def *def, const arc_model_def *model, const wear_manner *m,
                 const arc_loading *from, const double *parts, wear_block *b) {
  int at = 0;
  if (from->tangential) {
    b->tangential = b->angle + b->count;
    b->tangential[0] = from->tangential[0] / m->thickness;
  }
  b->x[0] = position(from, m, 0);
  b->angle[0] = arc_radians(angle_of(def, from, 0));
  b->line[0] = from->load[0] / m->thickness;
  for (int i = 1; i < from->count; i++) {
    const int n = (int)parts[i];
    for (int j = 1; j <= n; j++) { /* at j = n the values equal those of point i exactly */
      const double left = (double)(n - j) / n, right = (double)j / n;
      b->x[++at] = left * position(from, m, i - 1) + right * position(from, m, i);
      b->angle[at] =
          arc_radians(left * angle_of(def, from, i - 1) + right * angle_of(def, from, i));
      b->line[at] = (left * from->load[i - 1] + right * from->load[i]) / m->thickness;
      if (b->tangential)
        b->tangential[at] =
            (left * from->tangential[i - 1] + right * from->tangential[i]) / m->thickness;
    }
  }
  for (int i = 0; i < from->count; i++) b->load = fmax(b->load, from->load[i]);
  b->periodic = from->periodic;
  b->cycles = from->cycles;
  finish(b, def, model, m);
}

static arc_status given(const arc_wear_def *def, const arc_model_def *model, const wear_manner *m,
                        const arc_loading *from, wear_block *b) {
  double *parts = malloc((size_t)from->count * sizeof *parts);
  if (!parts) return ARC_MEMORY;
  const double increments = parts_of(def, model, from, parts);
  const arc_status status = block_create(b, 1 + (int)increments);
  if (status == ARC_OK) fill(def, model, m, from, parts, b);
  free(parts);
  return status;
}

arc_status arc_wear_blocks_create(const arc_wear_def *def, const arc_model_def *model,
                                  wear_block **block, int *count) {
  *count = def->blocks > 0 ? def->blocks : 1;
  *block = calloc((size_t)*count, sizeof **block);
  if (!*block) return ARC_MEMORY;
  const wear_manner m = arc_kind_of(model->geometry)->manner(def, model);
  double distance = def->start_distance, cycle = def->start_cycle;
  for (int b = 0; b < *count; b++) {
    wear_block *at = &(*block)[b];
    const arc_status status = def->blocks > 0 ? given(def, model, &m, &def->loading[b], at)
                                              : reciprocating(def, model, &m, at);
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
    free((*block)[b].problem_of);
  }
  free(*block);
  *block = NULL;
}

double arc_wear_block_end(const wear_block *block) {
  return block->start_distance + block->cycles * block->sliding;
}

/* Compares cycle numbers instead of distances, because a block without motion has no sliding
 * distance. */
const wear_block *arc_wear_block_at(const arc_wear *w, double cycle) {
  int b = 0;
  while (b + 1 < w->blocks && cycle >= w->block[b + 1].start_cycle * (1 - 1e-13)) b++;
  return &w->block[b];
}
