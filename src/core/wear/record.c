/* The history of a run and its rows. */
#include "core/wear/run.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

double arc_wear_record_get(const arc_wear_record *record, int column) {
  switch (column) {
#define COLUMN_CASE(name, unit, text)                                                              \
  case ARC_WEAR_COLUMN_##name:                                                                     \
    return record->name;
    ARC_WEAR_COLUMNS(COLUMN_CASE)
#undef COLUMN_CASE
  default:
    assert(column == ARC_WEAR_TOTAL_VOLUME);
    return record->volume_cylinder + record->volume_plate;
  }
}

const char *arc_wear_column_name(int column) {
#define COLUMN_NAME(name, unit, text) #name,
  static const char *const names[] = {ARC_WEAR_COLUMNS(COLUMN_NAME)};
#undef COLUMN_NAME
  assert(0 <= column && column < ARC_WEAR_COLUMN_COUNT);
  return names[column];
}

/* Past this squares and sums of what is recorded would overflow; no run comes near. */
static const double largest = 1e100;

static int grows(int column) {
  return column == ARC_WEAR_COLUMN_update || column == ARC_WEAR_COLUMN_cycle ||
         column == ARC_WEAR_COLUMN_distance;
}

/* What the first runs that were stored had already; alpha-tilde is none before any wear. */
static int was_always_known(int column) {
  switch (column) {
  case ARC_WEAR_COLUMN_jump:
  case ARC_WEAR_COLUMN_k:
  case ARC_WEAR_COLUMN_alpha:
  case ARC_WEAR_COLUMN_p_center:
  case ARC_WEAR_COLUMN_p_max:
  case ARC_WEAR_COLUMN_half_width:
  case ARC_WEAR_COLUMN_depth_cylinder:
  case ARC_WEAR_COLUMN_depth_plate:
  case ARC_WEAR_COLUMN_volume_cylinder:
  case ARC_WEAR_COLUMN_volume_plate:
  case ARC_WEAR_COLUMN_solutions:
    return 1;
  default:
    return grows(column);
  }
}

static arc_status check_column(const arc_wear_record *history, size_t count, int column,
                               arc_error *error) {
  double before = was_always_known(column) ? 0 : (double)NAN;
  for (size_t row = 0; row < count; row++) {
    const double value = arc_wear_record_get(&history[row], column);
    const int missing = isnan(value) && isnan(before);
    if (!missing && !(value >= (grows(column) ? before : 0) && value <= largest))
      return arc_fail(
          error, ARC_ARGUMENT, "history: row %zu: expected for %s a number >= 0%s, got %g", row,
          arc_wear_column_name(column), grows(column) ? " that never falls" : "", value);
    before = value;
  }
  return ARC_OK;
}

arc_status arc_wear_check_history(const arc_wear_record *history, size_t count, arc_error *error) {
  arc_status status = ARC_OK;
  for (int column = 0; column < ARC_WEAR_COLUMN_COUNT && status == ARC_OK; column++)
    status = check_column(history, count, column, error);
  return status;
}

/* A plain stroke has one load, to the bit. */
static double smallest_load(const arc_wear *w, const wear_block *block) {
  double line = block->line[0];
  for (int i = 1; i < block->count; i++) line = fmin(line, block->line[i]);
  return w->def.blocks == 0 ? block->load : line * arc_model_definition(w->model)->thickness;
}

void arc_wear_note_motion(const arc_wear *w, const wear_block *block, int first,
                          arc_wear_record *record) {
  const double *x = &block->x[first], *line = &block->line[first];
  const double thickness = arc_model_definition(w->model)->thickness;
  record->load = block->load;
  record->load_low = smallest_load(w, block);
  record->travel = block->travel;
  if (block->periodic) return;
  record->load = fmax(line[0], line[1]) * thickness;
  record->load_low = fmin(line[0], line[1]) * thickness;
  record->travel = fabs(x[1] - x[0]);
}

arc_status arc_wear_append(arc_wear *w, const arc_wear_record *record, arc_error *error) {
  if (w->records == w->capacity) {
    const size_t capacity = 2 * w->capacity + 16;
    arc_wear_record *grown = realloc(w->history, capacity * sizeof *grown);
    if (!grown) return arc_fail(error, ARC_MEMORY, "out of memory for a wear run");
    w->history = grown;
    w->capacity = capacity;
  }
  w->history[w->records++] = *record;
  return ARC_OK;
}

const arc_wear_record *arc_wear_history(const arc_wear *w, size_t *count) {
  if (count) *count = w->records;
  return w->history;
}

const arc_wear_record *arc_wear_last(const arc_wear *w) {
  assert(w->records > 0);
  return &w->history[w->records - 1];
}
