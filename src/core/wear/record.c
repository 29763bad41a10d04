/* Checks and stores the records in the history of a run. */
#include "core/wear/run.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

double arc_wear_record_get(const arc_wear_record *record, int column) {
  switch (column) {
#define COLUMN_CASE(name, unit, range, rule, text)                                                 \
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
#define COLUMN_NAME(name, unit, range, rule, text) #name,
  static const char *const names[] = {ARC_WEAR_COLUMNS(COLUMN_NAME)};
#undef COLUMN_NAME
  assert(0 <= column && column < ARC_WEAR_COLUMN_COUNT);
  return names[column];
}

/* --- validity of rows */

/* Largest valid value in a record. The squares and sums of valid values do not overflow. */
static const double largest = 1e100;

static const struct column_rule {
  double low, high;
  arc_column_rule rule;
} rules[] = {
#define COLUMN_RULE(name, unit, range, rule_, text) {ARC_RANGE_##range, .rule = ARC_COLUMN_##rule_},
    ARC_WEAR_COLUMNS(COLUMN_RULE)
#undef COLUMN_RULE
};

/* Checks the value of one column in a row. Returns the status `refused` if the value is invalid.
 * `before` is the previous row (NULL for the first row). */
static arc_status check_value(const arc_wear_record *before, const arc_wear_record *record,
                              size_t row, int column, arc_status refused, arc_error *error) {
  const struct column_rule *r = &rules[column];
  const double value = arc_wear_record_get(record, column),
               last = before ? arc_wear_record_get(before, column) : (double)NAN;
  double low = fmax(r->low, -largest);
  if (r->rule == ARC_COLUMN_LATER && isnan(value) && isnan(last)) return ARC_OK;
  if (r->rule == ARC_COLUMN_GROWS && before) low = last;
  if (value >= low && value <= fmin(r->high, largest)) return ARC_OK;
  return arc_fail(error, refused,
                  "history: row %zu: expected for %s a number from %g to %g, got %g", row,
                  arc_wear_column_name(column), low, fmin(r->high, largest), value);
}

static arc_status check_row(const arc_wear_record *history, size_t row,
                            const arc_wear_record *record, arc_status refused, arc_error *error) {
  arc_status status = ARC_OK;
  for (int column = 0; column < ARC_WEAR_COLUMN_COUNT && status == ARC_OK; column++)
    status = check_value(row > 0 ? &history[row - 1] : NULL, record, row, column, refused, error);
  return status;
}

arc_status arc_wear_check_history(const arc_wear_record *history, size_t count, arc_error *error) {
  arc_status status = ARC_OK;
  for (size_t row = 0; row < count && status == ARC_OK; row++)
    status = check_row(history, row, &history[row], ARC_ARGUMENT, error);
  return status;
}

/* --- rows ------------------------------------------------------------------------------------- */

/* Returns the smallest load of a block [N]. For a plain stroke it is exactly the load of the
 * definition. */
static double smallest_load(const arc_wear *w, const wear_block *block) {
  double line = block->line[0];
  for (int i = 1; i < block->count; i++) line = fmin(line, block->line[i]);
  return w->def.blocks == 0 ? block->load : line * w->manner.thickness;
}

void arc_wear_note_motion(const arc_wear *w, const wear_block *block, int first,
                          arc_wear_record *record) {
  const double *x = &block->x[first], *line = &block->line[first];
  const double thickness = w->manner.thickness;
  record->load = block->load;
  record->load_low = smallest_load(w, block);
  record->travel = block->travel;
  if (block->periodic) return;
  record->load = fmax(line[0], line[1]) * thickness;
  record->load_low = fmin(line[0], line[1]) * thickness;
  record->travel = fabs(x[1] - x[0]);
}

arc_status arc_wear_append(arc_wear *w, const arc_wear_record *record, arc_error *error) {
  const arc_status status = check_row(w->history, w->records, record, ARC_NUMERIC, error);
  if (status != ARC_OK) return status;
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
