/* The engine's definitions as named values, written and read by the lists of their settings: a new
 * setting needs nothing here. Beside a setting NAME stand NAME_auto, NAME_function (only that it
 * was one), NAME_series.distance and NAME_series.value. */
#include "store/store.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- writing ---------------------------------------------------------------------------------- */

enum { LONGEST_NAME = 96, VALUES_A_SETTING = 5, VALUES_A_BLOCK = 7, OTHERS = 3 };

/* Values under construction, with room for their names. */
typedef struct value_list {
  arc_value *value;
  size_t count;
  char (*name)[LONGEST_NAME];
} value_list;

/* Adds a value named `name` and `ending`. */
static arc_value *add(value_list *list, int kind, const char *name, const char *ending) {
  char *text = list->name[list->count];
  arc_value *value = &list->value[list->count++];
  snprintf(text, LONGEST_NAME, "%s%s", name, ending);
  *value = (arc_value){.kind = kind, .name = text};
  return value;
}

static void add_number(value_list *list, const char *name, const char *ending, double number) {
  add(list, ARC_VALUE_NUMBER, name, ending)->number = number;
}

static void add_array(value_list *list, const char *name, const char *ending, const double *array,
                      int count) {
  arc_value *value = add(list, ARC_VALUE_ARRAY, name, ending);
  value->array = array;
  value->count = (size_t)count;
}

static int add_setting(void *context, const char *path, const arc_setting *s, void *member,
                       const void *def) {
  value_list *list = context;
  const arc_series series = arc_setting_series(s, def);
  if (s->kind == ARC_TEXT) {
    if (*(const char *)member) add(list, ARC_VALUE_TEXT, path, "")->text = member;
    return 0;
  }
  if (s->kind == ARC_CHOICE)
    add(list, ARC_VALUE_TEXT, path, "")->text = s->choices[*(const int *)member];
  else
    add_number(list, path, "", arc_setting_number(s, def));
  if (s->automatic && s->forms & ARC_AUTOMATIC)
    add_number(list, path, "_auto", arc_setting_is_auto(s, def));
  if (series.count > 0) {
    add_array(list, path, "_series.distance", series.distance, series.count);
    add_array(list, path, "_series.value", series.value, series.count);
  }
  return 0;
}

static void add_functions(value_list *list, const arc_wear_def *def) {
  for (const arc_setting *s = arc_wear_settings; s->name; s++)
    if (arc_setting_has_function(s, def))
      add(list, ARC_VALUE_FLAG, s->name, "_function")->number = 1;
}

static void add_block(value_list *list, const arc_loading *block, int number) {
  char prefix[32];
  snprintf(prefix, sizeof prefix, "loading.%d.", number);
  add_array(list, prefix, "x", block->x, block->count);
  add_array(list, prefix, "load", block->load, block->count);
  if (block->tangential) add_array(list, prefix, "tangential", block->tangential, block->count);
  if (block->rotation) add_array(list, prefix, "rotation", block->rotation, block->count);
  if (block->load_angle) add_array(list, prefix, "load_angle", block->load_angle, block->count);
  add_number(list, prefix, "cycles", block->cycles);
  add_number(list, prefix, "periodic", block->periodic);
}

static void add_wear(value_list *list, const arc_wear_def *def) {
  arc_settings_walk(arc_wear_settings, "", def, add_setting, list);
  add_functions(list, def);
  add_number(list, "blocks", "", def->blocks);
  add_number(list, "start_distance", "", def->start_distance);
  add_number(list, "start_cycle", "", def->start_cycle);
  for (int b = 0; b < def->blocks; b++) add_block(list, &def->loading[b], b + 1);
}

static int count_setting(void *context, const char *path, const arc_setting *s, void *member,
                         const void *def) {
  (void)path, (void)s, (void)member, (void)def;
  ++*(size_t *)context;
  return 0;
}

static arc_status allocate_list(value_list *list, const arc_wear_def *wear,
                                const arc_model_def *model, arc_error *error) {
  size_t settings = ARC_WEAR_SETTINGS_COUNT;
  arc_settings_walk(arc_model_settings, "", model, count_setting, &settings);
  const size_t most = VALUES_A_SETTING * settings + VALUES_A_BLOCK * (size_t)wear->blocks + OTHERS;
  *list = (value_list){malloc(most * sizeof *list->value), 0, malloc(most * sizeof *list->name)};
  if (list->value && list->name) return ARC_OK;
  return arc_fail(error, ARC_MEMORY, "out of memory for a definition");
}

arc_status arc_definition_save(arc_store *store, int id, const arc_wear *wear, arc_error *error) {
  const arc_wear_def *def = arc_wear_definition(wear);
  const arc_model_def *model = arc_model_definition(arc_wear_model(wear));
  value_list list;
  arc_status status = allocate_list(&list, def, model, error);
  if (status == ARC_OK) {
    add_wear(&list, def);
    arc_settings_walk(arc_model_settings, "model.", model, add_setting, &list);
    status = arc_store_set_values(store, id, ARC_DEFINITION, list.value, list.count, error);
  }
  free(list.value);
  free(list.name);
  return status;
}

/* --- reading ---------------------------------------------------------------------------------- */

/* What is read, and the memory of its arrays: blocks first, numbers behind them. */
typedef struct reading {
  const char *path;
  arc_stored_run *run;
  size_t seen, numbers; /* values; numbers in arrays */
  int blocks;
  arc_loading *loading; /* NULL while only counting */
  double *free_numbers; /* where the next array goes */
  arc_error *error;
  arc_status status;
} reading;

static int refuse_value(reading *r, const arc_value *value) {
  char shown[80] = "an array";
  if (value->kind == ARC_VALUE_TEXT) snprintf(shown, sizeof shown, "'%.60s'", value->text);
  if (value->kind == ARC_VALUE_NUMBER) snprintf(shown, sizeof shown, "%g", value->number);
  r->status = arc_fail(r->error, ARC_FORMAT,
                       "%s: this program does not know the field '%s' with the value %s", r->path,
                       value->name, shown);
  return 1;
}

static int read_choice(const arc_setting *s, const arc_value *value, int *to) {
  for (int i = 0; value->kind == ARC_VALUE_TEXT && s->choices[i]; i++)
    if (strcmp(s->choices[i], value->text) == 0) {
      *to = i;
      return 1;
    }
  return 0;
}

static int read_whole(const arc_value *value, int *to) {
  const int fits = value->kind == ARC_VALUE_NUMBER && fabs(value->number) < 1e9;
  if (fits) *to = (int)value->number;
  return fits;
}

static int read_number(const arc_value *value, double *to) {
  if (value->kind == ARC_VALUE_NUMBER) *to = value->number;
  return value->kind == ARC_VALUE_NUMBER;
}

static int read_text(const arc_value *value, char *to) {
  const int fits = value->kind == ARC_VALUE_TEXT && strlen(value->text) < ARC_TEXT_SIZE;
  if (fits) strcpy(to, value->text);
  return fits;
}

/* A value on its way to the setting of its name. */
typedef struct search {
  const arc_value *value;
  int read; /* whether it was what the setting takes */
} search;

static int take_setting(void *context, const char *path, const arc_setting *s, void *member,
                        const void *def) {
  search *at = context;
  (void)def;
  if (strcmp(path, at->value->name) != 0) return 0;
  if (s->kind == ARC_CHOICE)
    at->read = read_choice(s, at->value, member);
  else if (s->kind == ARC_TEXT)
    at->read = read_text(at->value, member);
  else
    at->read =
        s->kind == ARC_NUMBER ? read_number(at->value, member) : read_whole(at->value, member);
  return 1;
}

/* Reads a plain value; 0: it is none, or does not hold what it should. */
static int read_plain(reading *r, const arc_value *value) {
  arc_wear_def *def = &r->run->def;
  search at = {value, 0};
  if (arc_settings_walk(arc_wear_settings, "", def, take_setting, &at) ||
      arc_settings_walk(arc_model_settings, "model.", &r->run->model, take_setting, &at))
    return at.read;
  if (strcmp(value->name, "blocks") == 0) return read_whole(value, &def->blocks);
  if (strcmp(value->name, "start_distance") == 0) return read_number(value, &def->start_distance);
  return strcmp(value->name, "start_cycle") == 0 && read_number(value, &def->start_cycle);
}

static const double *take_array(reading *r, const arc_value *value) {
  double *to = r->free_numbers;
  memcpy(to, value->array, value->count * sizeof *to);
  r->free_numbers += value->count;
  return to;
}

/* The two arrays of a series come one after the other: of equal length. */
static int read_series(reading *r, const arc_value *value, arc_series *series,
                       const double **array) {
  if (value->kind != ARC_VALUE_ARRAY || value->count == 0 || value->count > 1000000) return 0;
  if (!r->loading) return 1;
  if (series->count != 0 && (size_t)series->count != value->count) return 0;
  *array = take_array(r, value);
  series->count = (int)value->count;
  return 1;
}

static int read_function(reading *r, const arc_value *value, const arc_setting *s) {
  r->run->functions[s - arc_wear_settings] = 1;
  return value->kind == ARC_VALUE_FLAG;
}

/* A table of a model's settings on its way. */
typedef struct model_table {
  reading *r;
  const arc_value *value;
  int read;
} model_table;

static int take_model_table(void *context, const char *path, const arc_setting *s, void *member,
                            const void *def) {
  model_table *at = context;
  const size_t length = strlen(path);
  (void)member;
  if (!(s->forms & ARC_SERIES) || strncmp(path, at->value->name, length) != 0) return 0;
  arc_series *series = (arc_series *)(void *)((char *)(size_t)def + s->series);
  const char *ending = at->value->name + length;
  if (strcmp(ending, "_series.distance") == 0)
    at->read = read_series(at->r, at->value, series, &series->distance);
  else if (strcmp(ending, "_series.value") == 0)
    at->read = read_series(at->r, at->value, series, &series->value);
  return at->read;
}

/* What stands beside a setting under its name with an ending; 0: it is none. */
static int read_other_form(reading *r, const arc_value *value) {
  for (const arc_setting *s = arc_wear_settings; s->name; s++) {
    const size_t length = strlen(s->name);
    if (strncmp(s->name, value->name, length) != 0) continue;
    const char *ending = value->name + length;
    char *def = (char *)&r->run->def;
    arc_series *series = (arc_series *)(void *)(def + s->series);
    if (s->automatic && s->forms & ARC_AUTOMATIC && strcmp(ending, "_auto") == 0)
      return read_whole(value, (int *)(void *)(def + s->automatic));
    if (s->forms & ARC_FUNCTION && strcmp(ending, "_function") == 0)
      return read_function(r, value, s);
    if (s->forms & ARC_SERIES && strcmp(ending, "_series.distance") == 0)
      return read_series(r, value, series, &series->distance);
    if (s->forms & ARC_SERIES && strcmp(ending, "_series.value") == 0)
      return read_series(r, value, series, &series->value);
  }
  model_table table = {r, value, 0};
  arc_settings_walk(arc_model_settings, "model.", &r->run->model, take_model_table, &table);
  return table.read;
}

static int read_block(reading *r, const arc_value *value, arc_loading *block, const char *what) {
  const int is_array = value->kind == ARC_VALUE_ARRAY;
  double periodic;
  if (strcmp(what, "x") == 0 && is_array) {
    block->x = take_array(r, value);
    block->count = (int)value->count;
  } else if (strcmp(what, "load") == 0 && is_array) {
    block->load = take_array(r, value);
  } else if (strcmp(what, "tangential") == 0 && is_array) {
    block->tangential = take_array(r, value);
  } else if (strcmp(what, "rotation") == 0 && is_array) {
    block->rotation = take_array(r, value);
  } else if (strcmp(what, "load_angle") == 0 && is_array) {
    block->load_angle = take_array(r, value);
  } else if (strcmp(what, "cycles") == 0) {
    return read_number(value, &block->cycles);
  } else if (strcmp(what, "periodic") == 0 && read_number(value, &periodic)) {
    block->periodic = periodic != 0;
  } else {
    return 0;
  }
  return 1;
}

/* Reads a value of the loading; 0: it is none. While counting it only notes how many there are. */
static int read_loading(reading *r, const arc_value *value) {
  int number, used = 0;
  if (sscanf(value->name, "loading.%d.%n", &number, &used) != 1 || used == 0 || number < 1 ||
      number >= 1000000)
    return 0;
  if (number > r->blocks) r->blocks = number;
  return !r->loading || read_block(r, value, &r->loading[number - 1], value->name + used);
}

static int see(void *context, const arc_value *value) {
  reading *r = context;
  r->seen++;
  if (value->kind == ARC_VALUE_ARRAY) r->numbers += value->count;
  if (read_plain(r, value) || read_other_form(r, value) || read_loading(r, value)) return 0;
  return refuse_value(r, value);
}

/* Once for the sizes, once for the contents. */
static arc_status read_twice(arc_store *store, int id, reading *r, arc_error *error) {
  arc_status status = arc_store_values(store, id, ARC_DEFINITION, see, r, error);
  if (status == ARC_OK) status = r->status;
  if (status == ARC_OK && r->seen == 0)
    status = arc_fail(error, ARC_ARGUMENT, "%s: no run is stored as case %d", store->path, id);
  if (status != ARC_OK) return status;
  size_t blocks = (size_t)r->blocks * sizeof *r->loading;
  r->loading = calloc(1, blocks + (r->numbers + 1) * sizeof(double));
  if (!r->loading) return arc_fail(error, ARC_MEMORY, "%s: out of memory", store->path);
  r->free_numbers = (double *)(void *)((char *)r->loading + blocks);
  status = arc_store_values(store, id, ARC_DEFINITION, see, r, error);
  return status == ARC_OK ? r->status : status;
}

static arc_status check_arrays(const reading *r, arc_error *error) {
  const arc_wear_def *def = &r->run->def;
  if (def->blocks != r->blocks)
    return arc_fail(error, ARC_FORMAT, "%s: expected %d blocks of loading, found %d", r->path,
                    def->blocks, r->blocks);
  for (int i = 0; i < r->blocks; i++)
    if (!r->loading[i].x || !r->loading[i].load)
      return arc_fail(error, ARC_FORMAT, "%s: block %d of the loading is not complete", r->path,
                      i + 1);
  for (const arc_setting *s = arc_wear_settings; s->name; s++) {
    const arc_series series = arc_setting_series(s, def);
    if (series.count > 0 && !(series.distance && series.value))
      return arc_fail(error, ARC_FORMAT, "%s: the table of '%s' is not complete", r->path, s->name);
  }
  return ARC_OK;
}

arc_status arc_store_definition(arc_store *store, int id, arc_stored_run *run, arc_error *error) {
  reading r = {.path = store->path, .run = run, .error = error, .status = ARC_OK};
  *run = (arc_stored_run){.model = arc_model_default(), .def = arc_wear_default()};
  arc_status status = read_twice(store, id, &r, error);
  if (status == ARC_OK) status = check_arrays(&r, error);
  run->memory = r.loading;
  run->def.loading = r.blocks > 0 ? r.loading : NULL;
  if (status != ARC_OK) arc_stored_run_free(run);
  return status;
}

void arc_stored_run_free(arc_stored_run *run) {
  free(run->memory);
  *run = (arc_stored_run){.memory = NULL};
}
