/* The engine's definitions as named values: one list of fields each for writing and reading, so
 * that a new field is a line here and no change of the file's format. */
#include "store/store.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const procedures[] = {"auto", "SP", "NSP", NULL};
static const char *const schemes[] = {"explicit", "implicit", NULL};
static const char *const slips[] = {"rigid", "total", NULL};
static const char *const rules[] = {"trapezoid", "simple", NULL};
static const char *const geometries[] = {"moving", "frozen", NULL};
static const char *const updates[] = {"cycle", "increment", NULL};
static const char *const laws[] = {"archard", "power", "threshold", NULL};
static const char *const elements[] = {"CPE4", "CPE4I", NULL};

/* Both definitions in one, so that one list tells of all. */
typedef struct whole_def {
  arc_wear_def wear;
  arc_model_def model;
} whole_def;

typedef enum field_kind { NUMBER, WHOLE, CHOICE } field_kind;

typedef struct field {
  const char *name;
  field_kind kind;
  size_t offset;
  const char *const *choices;
} field;

#define WEAR_NUMBER(member)                                                                        \
  { #member, NUMBER, offsetof(whole_def, wear.member), NULL }
#define WEAR_WHOLE(member)                                                                         \
  { #member, WHOLE, offsetof(whole_def, wear.member), NULL }
#define WEAR_CHOICE(member, names)                                                                 \
  { #member, CHOICE, offsetof(whole_def, wear.member), names }
#define MODEL_NUMBER(name, member)                                                                 \
  { "model." name, NUMBER, offsetof(whole_def, model.member), NULL }

static const field fields[] = {
    WEAR_NUMBER(k),
    WEAR_NUMBER(alpha),
    WEAR_NUMBER(load),
    WEAR_NUMBER(stroke),
    WEAR_NUMBER(distance),
    WEAR_NUMBER(jump),
    WEAR_WHOLE(increments),
    WEAR_CHOICE(procedure, procedures),
    WEAR_CHOICE(scheme, schemes),
    WEAR_CHOICE(slip, slips),
    WEAR_CHOICE(rule, rules),
    WEAR_CHOICE(geometry, geometries),
    WEAR_NUMBER(refresh),
    WEAR_CHOICE(update, updates),
    WEAR_WHOLE(jump_auto),
    WEAR_CHOICE(law, laws),
    WEAR_NUMBER(law_pressure),
    WEAR_NUMBER(law_exponent),
    WEAR_WHOLE(order),
    WEAR_NUMBER(tolerance),
    WEAR_WHOLE(blocks),
    WEAR_NUMBER(start_distance),
    WEAR_NUMBER(start_cycle),
    MODEL_NUMBER("radius", radius),
    MODEL_NUMBER("thickness", thickness),
    MODEL_NUMBER("cylinder.E", material[ARC_CYLINDER].E),
    MODEL_NUMBER("cylinder.nu", material[ARC_CYLINDER].nu),
    MODEL_NUMBER("plate.E", material[ARC_PLATE].E),
    MODEL_NUMBER("plate.nu", material[ARC_PLATE].nu),
    MODEL_NUMBER("mesh.size", mesh.size),
    MODEL_NUMBER("mesh.height", mesh.height),
    MODEL_NUMBER("mesh.far", mesh.far),
    MODEL_NUMBER("mesh.zone.cylinder", mesh.zone[ARC_CYLINDER]),
    MODEL_NUMBER("mesh.zone.plate", mesh.zone[ARC_PLATE]),
    {"model.mesh.rows", WHOLE, offsetof(whole_def, model.mesh.rows), NULL},
    {"model.mesh.element", CHOICE, offsetof(whole_def, model.mesh.element), elements},
};

enum { FIELDS = sizeof fields / sizeof *fields, BLOCK_FIELDS = 4 };

/* A definition that grows must grow the list above, or this stops the build. */
_Static_assert(sizeof(void *) != 8 || (sizeof(arc_model_def) == 96 && sizeof(arc_wear_def) == 248),
               "a new field: add it to the list above");

static void *member(const field *f, whole_def *def) {
  return (char *)def + f->offset;
}

/* --- writing ---------------------------------------------------------------------------------- */

static arc_value value_of(const field *f, whole_def *def) {
  const void *at = member(f, def);
  arc_value value = {.kind = ARC_VALUE_NUMBER, .name = f->name};
  if (f->kind == NUMBER) {
    value.number = *(const double *)at;
  } else if (f->kind == WHOLE) {
    value.number = *(const int *)at;
  } else {
    value.kind = ARC_VALUE_TEXT;
    value.text = f->choices[*(const int *)at];
  }
  return value;
}

/* A field that is a function, and where the definition has it. */
static const struct {
  const char *field, *stored;
} functions[] = {{"k", "k_function"},
                 {"alpha", "alpha_function"},
                 {"jump", "jump_function"},
                 {"local_factor", "local_factor_function"}};

enum { FUNCTIONS = sizeof functions / sizeof *functions };

/* The values under construction: room for all fields, functions, two series and the loading's
 * blocks. */
typedef struct value_list {
  arc_value *value;
  size_t count;
  char (*name)[40]; /* [blocks * BLOCK_FIELDS] */
} value_list;

static void add_array(value_list *list, const char *name, const double *array, size_t count) {
  list->value[list->count++] =
      (arc_value){.kind = ARC_VALUE_ARRAY, .name = name, .array = array, .count = count};
}

static void add_series(value_list *list, const char *distance, const char *value,
                       const arc_series *series) {
  if (series->count <= 0) return;
  add_array(list, distance, series->distance, (size_t)series->count);
  add_array(list, value, series->value, (size_t)series->count);
}

/* Of a function only that it is one. */
static void add_functions(value_list *list, const arc_wear_def *def) {
  const int given[FUNCTIONS] = {def->k_function != NULL, def->alpha_function != NULL,
                                def->jump_function != NULL, def->local_factor != NULL};
  for (int i = 0; i < FUNCTIONS; i++)
    if (given[i])
      list->value[list->count++] =
          (arc_value){.kind = ARC_VALUE_FLAG, .name = functions[i].stored, .number = 1};
}

static const char *block_name(value_list *list, int block, int which, const char *what) {
  char *name = list->name[block * BLOCK_FIELDS + which];
  snprintf(name, sizeof *list->name, "loading.%d.%s", block + 1, what);
  return name;
}

static void add_block(value_list *list, const arc_loading *block, int i) {
  add_array(list, block_name(list, i, 0, "x"), block->x, (size_t)block->count);
  add_array(list, block_name(list, i, 1, "load"), block->load, (size_t)block->count);
  list->value[list->count++] = (arc_value){
      .kind = ARC_VALUE_NUMBER, .name = block_name(list, i, 2, "cycles"), .number = block->cycles};
  list->value[list->count++] = (arc_value){.kind = ARC_VALUE_NUMBER,
                                           .name = block_name(list, i, 3, "periodic"),
                                           .number = block->periodic};
}

static arc_status allocate_list(value_list *list, int blocks, arc_error *error) {
  size_t block_values = BLOCK_FIELDS * (size_t)blocks;
  list->value = malloc((FIELDS + FUNCTIONS + 4 + block_values) * sizeof *list->value);
  list->name = malloc((block_values + 1) * sizeof *list->name);
  list->count = 0;
  if (list->value && list->name) return ARC_OK;
  return arc_fail(error, ARC_MEMORY, "out of memory for a definition");
}

arc_status arc_definition_save(arc_store *store, int id, const arc_wear *wear, arc_error *error) {
  whole_def def = {*arc_wear_definition(wear), *arc_model_definition(arc_wear_model(wear))};
  value_list list;
  arc_status status = allocate_list(&list, def.wear.blocks, error);
  if (status == ARC_OK) {
    for (size_t i = 0; i < FIELDS; i++) list.value[list.count++] = value_of(&fields[i], &def);
    add_functions(&list, &def.wear);
    add_series(&list, "k_series.distance", "k_series.value", &def.wear.k_series);
    add_series(&list, "alpha_series.distance", "alpha_series.value", &def.wear.alpha_series);
    for (int i = 0; i < def.wear.blocks; i++) add_block(&list, &def.wear.loading[i], i);
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
  whole_def def;
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
  if (value->kind == ARC_VALUE_TEXT) snprintf(shown, sizeof shown, "'%s'", value->text);
  if (value->kind == ARC_VALUE_NUMBER) snprintf(shown, sizeof shown, "%g", value->number);
  r->status = arc_fail(r->error, ARC_FORMAT,
                       "%s: this program does not know the field '%s' with the value %s", r->path,
                       value->name, shown);
  return 1;
}

static int read_choice(const field *f, const arc_value *value, int *to) {
  for (int i = 0; value->kind == ARC_VALUE_TEXT && f->choices[i]; i++)
    if (strcmp(f->choices[i], value->text) == 0) {
      *to = i;
      return 1;
    }
  return 0;
}

/* Reads a plain field; 0: it is none, or does not hold what it should. */
static int read_field(reading *r, const arc_value *value) {
  const field *f = fields;
  while (f < fields + FIELDS && strcmp(f->name, value->name) != 0) f++;
  if (f == fields + FIELDS) return 0;
  void *to = member(f, &r->def);
  if (f->kind == CHOICE) return read_choice(f, value, to);
  if (value->kind != ARC_VALUE_NUMBER) return 0;
  if (f->kind == NUMBER)
    *(double *)to = value->number;
  else if (fabs(value->number) < 1e9)
    *(int *)to = (int)value->number;
  else
    return 0;
  return 1;
}

static const double *take_array(reading *r, const arc_value *value) {
  double *to = r->free_numbers;
  memcpy(to, value->array, value->count * sizeof *to);
  r->free_numbers += value->count;
  return to;
}

/* Reads a value of a series; *to is the array it belongs to. 0: it is none. */
static int read_series(reading *r, const arc_value *value) {
  struct {
    const char *name;
    arc_series *series;
    const double **array;
  } known[] = {
      {"k_series.distance", &r->def.wear.k_series, &r->def.wear.k_series.distance},
      {"k_series.value", &r->def.wear.k_series, &r->def.wear.k_series.value},
      {"alpha_series.distance", &r->def.wear.alpha_series, &r->def.wear.alpha_series.distance},
      {"alpha_series.value", &r->def.wear.alpha_series, &r->def.wear.alpha_series.value},
  };
  for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
    if (strcmp(known[i].name, value->name) != 0 || value->kind != ARC_VALUE_ARRAY) continue;
    if (r->loading) *known[i].array = take_array(r, value);
    known[i].series->count = (int)value->count;
    return 1;
  }
  return 0;
}

/* Reads a value of the loading; 0: it is none. While counting it only notes how many there are. */
static int read_loading(reading *r, const arc_value *value) {
  int number, used = 0;
  if (sscanf(value->name, "loading.%d.%n", &number, &used) != 1 || used == 0 || number < 1)
    return 0;
  if (number > r->blocks) r->blocks = number;
  if (!r->loading) return number < 1000000;
  arc_loading *block = &r->loading[number - 1];
  const char *what = value->name + used;
  int is_array = value->kind == ARC_VALUE_ARRAY, is_number = value->kind == ARC_VALUE_NUMBER;
  if (strcmp(what, "x") == 0 && is_array) {
    block->x = take_array(r, value);
    block->count = (int)value->count;
  } else if (strcmp(what, "load") == 0 && is_array)
    block->load = take_array(r, value);
  else if (strcmp(what, "cycles") == 0 && is_number)
    block->cycles = value->number;
  else if (strcmp(what, "periodic") == 0 && is_number)
    block->periodic = value->number != 0;
  else
    return 0;
  return 1;
}

/* Reads the mark of a function; 0: it is none. */
static int read_function(reading *r, const arc_value *value) {
  for (int i = 0; i < FUNCTIONS; i++) {
    if (strcmp(functions[i].stored, value->name) != 0 || value->kind != ARC_VALUE_FLAG) continue;
    if (r->loading) strcat(strcat(r->run->functions, functions[i].field), " ");
    return 1;
  }
  return 0;
}

static int see(void *context, const arc_value *value) {
  reading *r = context;
  r->seen++;
  if (value->kind == ARC_VALUE_ARRAY) r->numbers += value->count;
  if (read_field(r, value) || read_function(r, value) || read_series(r, value) ||
      read_loading(r, value))
    return 0;
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

static arc_status check_blocks(const reading *r, arc_error *error) {
  if (r->def.wear.blocks != r->blocks)
    return arc_fail(error, ARC_FORMAT, "%s: expected %d blocks of loading, found %d", r->path,
                    r->def.wear.blocks, r->blocks);
  for (int i = 0; i < r->blocks; i++)
    if (!r->loading[i].x || !r->loading[i].load)
      return arc_fail(error, ARC_FORMAT, "%s: block %d of the loading is not complete", r->path,
                      i + 1);
  return ARC_OK;
}

arc_status arc_store_definition(arc_store *store, int id, arc_stored_run *run, arc_error *error) {
  reading r = {.path = store->path,
               .def = {arc_wear_default(), arc_model_default()},
               .run = run,
               .error = error,
               .status = ARC_OK};
  *run = (arc_stored_run){.memory = NULL};
  arc_status status = read_twice(store, id, &r, error);
  if (status == ARC_OK) status = check_blocks(&r, error);
  if (status != ARC_OK) {
    free(r.loading);
    return status;
  }
  r.def.wear.loading = r.blocks > 0 ? r.loading : NULL;
  run->memory = r.loading;
  run->model = r.def.model;
  run->def = r.def.wear;
  return ARC_OK;
}

void arc_stored_run_free(arc_stored_run *run) {
  free(run->memory);
  *run = (arc_stored_run){.memory = NULL};
}
