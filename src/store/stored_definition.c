/* Stores definitions as named values. A table with the name, type and address of each value is
 * used for writing, reading and checking. The table is made from the lists of settings, so that
 * a new setting needs no code here. A setting NAME may also have the values NAME_function (a
 * flag, because functions are not stored), NAME_series.distance and NAME_series.value. */
#include "archard/export.h"
#include "store/store.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- the table of settings -------------------------------------------------------------------- */

enum { LONGEST_NAME = 96 };

/* The name, type and address of a value in a definition. */
typedef struct slot {
  char name[LONGEST_NAME];
  enum { SLOT_NUMBER, SLOT_WHOLE, SLOT_CHOICE, SLOT_TEXT, SLOT_LONG, SLOT_FLAG, SLOT_ARRAY } kind;
  const char *const *choices;
  void *at;     /* address of the value, whose type depends on `kind` */
  int *count;   /* address of the array's length, which several arrays may share; *count is 0
                   without an array */
  int optional; /* true if the array may be missing in the file */
} slot;

typedef struct slots {
  slot *slot;
  size_t count;
  int failed; /* true if memory is exhausted */
} slots;

static void add(slots *list, const char *name, const char *ending, slot added) {
  slot *grown = arc_store_grown(list->slot, list->count, sizeof *grown);
  list->failed |= !grown;
  if (!grown) return;
  list->slot = grown;
  snprintf(added.name, sizeof added.name, "%s%s", name, ending);
  grown[list->count++] = added;
}

static void add_series(slots *list, const char *path, arc_series *series) {
  add(list, path, "_series.distance",
      (slot){.kind = SLOT_ARRAY, .at = &series->distance, .count = &series->count});
  add(list, path, "_series.value",
      (slot){.kind = SLOT_ARRAY, .at = &series->value, .count = &series->count});
}

/* Context of add_setting: the table of values, and the definition to which their addresses
 * refer. */
typedef struct added {
  slots *list;
  char *def;
} added;

static int add_setting(void *context, const char *path, const arc_setting *s, const void *def) {
  const added *a = context;
  slots *list = a->list;
  char *of = a->def + ((const char *)def - a->def);
  slot plain = {.kind = s->kind == ARC_NUMBER ? SLOT_NUMBER : SLOT_WHOLE,
                .at = arc_setting_member(s, of)};
  if (s->kind == ARC_CHOICE) plain.kind = SLOT_CHOICE, plain.choices = s->choices;
  if (s->kind == ARC_TEXT) plain.kind = SLOT_TEXT;
  add(list, path, "", plain);
  if (s->forms & ARC_SERIES) add_series(list, path, (arc_series *)(void *)(of + s->series));
  return 0;
}

static void add_optional(slots *list, const char *prefix, const char *name, const double **array,
                         arc_loading *block) {
  add(list, prefix, name,
      (slot){.kind = SLOT_ARRAY, .at = array, .count = &block->count, .optional = 1});
}

static void add_block(slots *list, arc_loading *block, int number) {
  char prefix[32];
  snprintf(prefix, sizeof prefix, "loading.%d.", number);
  add(list, prefix, "x", (slot){.kind = SLOT_ARRAY, .at = &block->x, .count = &block->count});
  add(list, prefix, "load", (slot){.kind = SLOT_ARRAY, .at = &block->load, .count = &block->count});
  add_optional(list, prefix, "tangential", &block->tangential, block);
  add_optional(list, prefix, "rotation", &block->rotation, block);
  add_optional(list, prefix, "load_angle", &block->load_angle, block);
  add(list, prefix, "cycles", (slot){.kind = SLOT_NUMBER, .at = &block->cycles});
  add(list, prefix, "periodic", (slot){.kind = SLOT_WHOLE, .at = &block->periodic});
}

static void add_settings(slots *list, const arc_setting *settings, const char *prefix, void *def) {
  added a = {list, def};
  arc_settings_walk(settings, prefix, def, add_setting, &a);
}

/* Returns a table of all values of a run. The blocks of `loading` must be allocated. `msh` is
 * the address of the Gmsh text of imported meshes; the text is NULL without imported meshes. */
static slots table_of(arc_stored_run *run, arc_loading *loading, const char **msh) {
  slots list = {0};
  arc_wear_def *def = &run->def;
  add_settings(&list, arc_wear_settings, "", def);
  for (const arc_setting *s = arc_wear_settings; s->name; s++)
    if (s->forms & ARC_FUNCTION)
      add(&list, s->name, "_function",
          (slot){.kind = SLOT_FLAG, .at = &run->functions[s - arc_wear_settings]});
  add(&list, "blocks", "", (slot){.kind = SLOT_WHOLE, .at = &def->blocks});
  add(&list, "start_distance", "", (slot){.kind = SLOT_NUMBER, .at = &def->start_distance});
  add(&list, "start_cycle", "", (slot){.kind = SLOT_NUMBER, .at = &def->start_cycle});
  for (int b = 0; b < def->blocks; b++) add_block(&list, &loading[b], b + 1);
  add_settings(&list, arc_model_settings, "model.", &run->model);
  add(&list, "model.msh", "", (slot){.kind = SLOT_LONG, .at = msh});
  return list;
}

/* --- writing definitions ---------------------------------------------------------------------- */

static const double *array_at(const slot *s) {
  return *(const double **)s->at;
}

static const char *long_at(const slot *s) {
  return *(const char **)s->at;
}

static int is_there(const slot *s) {
  if (s->kind == SLOT_LONG) return long_at(s) != NULL;
  if (s->kind == SLOT_FLAG || s->kind == SLOT_TEXT) return *(const char *)s->at != 0;
  return s->kind != SLOT_ARRAY || (*s->count > 0 && array_at(s));
}

static arc_value value_of(const slot *s) {
  arc_value value = {.kind = ARC_VALUE_NUMBER, .name = s->name};
  switch (s->kind) {
  case SLOT_NUMBER:
    value.number = *(const double *)s->at;
    break;
  case SLOT_WHOLE:
    value.number = *(const int *)s->at;
    break;
  case SLOT_CHOICE:
    value.kind = ARC_VALUE_TEXT;
    value.text = s->choices[*(const int *)s->at];
    break;
  case SLOT_TEXT:
    value.kind = ARC_VALUE_TEXT;
    value.text = s->at;
    break;
  case SLOT_LONG:
    value.kind = ARC_VALUE_TEXT;
    value.text = long_at(s);
    break;
  case SLOT_FLAG:
    value.kind = ARC_VALUE_FLAG;
    value.number = 1;
    break;
  case SLOT_ARRAY:
    value.kind = ARC_VALUE_ARRAY;
    value.array = array_at(s);
    value.count = (size_t)*s->count;
    break;
  }
  return value;
}

static arc_status save(arc_store *store, int id, const arc_wear *wear, const char *msh,
                       arc_error *error) {
  arc_stored_run run = {.model = *arc_model_definition(arc_wear_model(wear)),
                        .def = *arc_wear_definition(wear)};
  for (const arc_setting *s = arc_wear_settings; s->name; s++)
    run.functions[s - arc_wear_settings] = (char)arc_setting_has_function(s, &run.def);
  const size_t blocks = (size_t)run.def.blocks;
  arc_loading *loading = malloc((blocks + 1) * sizeof *loading);
  if (loading && blocks > 0) memcpy(loading, run.def.loading, blocks * sizeof *loading);
  slots table = loading ? table_of(&run, loading, &msh) : (slots){.failed = 1};
  arc_value *values = malloc((table.count + 1) * sizeof *values);
  size_t count = 0;
  arc_status status = ARC_MEMORY;
  for (size_t i = 0; values && !table.failed && i < table.count; i++)
    if (is_there(&table.slot[i])) values[count++] = value_of(&table.slot[i]);
  if (!values || table.failed)
    arc_fail(error, status, "%s: out of memory", store->path);
  else
    status = arc_store_set_values(store, id, ARC_DEFINITION, values, count, error);
  free(values);
  free(table.slot);
  free(loading);
  return status;
}

arc_status arc_definition_save(arc_store *store, int id, const arc_wear *wear, arc_error *error) {
  const arc_model *model = arc_wear_model(wear);
  const arc_mesh *mesh[ARC_BODIES] = {arc_model_mesh(model, ARC_UPPER),
                                      arc_model_mesh(model, ARC_LOWER)};
  char *msh = NULL;
  arc_status status = ARC_OK;
  if (arc_model_is_given(model)) status = arc_export_msh_text(&msh, mesh, error);
  if (status == ARC_OK) status = save(store, id, wear, msh, error);
  free(msh);
  return status;
}

/* --- values in the file ----------------------------------------------------------------------- */

/* A value that was read from a case, and the memory of its name and contents. */
typedef struct kept {
  arc_value value;
  void *memory; /* memory to which the value refers */
} kept;

typedef struct stock {
  kept *kept;
  size_t count;
  arc_loading *loading;
} stock;

static void free_stock(stock *s) {
  if (!s) return;
  for (size_t i = 0; i < s->count; i++) free(s->kept[i].memory);
  free(s->kept);
  free(s->loading);
  free(s);
}

void arc_stored_run_free(arc_stored_run *run) {
  for (int b = 0; b < ARC_BODIES; b++) arc_mesh_destroy(&run->given[b]);
  free_stock(run->memory);
  *run = (arc_stored_run){.memory = NULL};
}

/* Copies a value. Returns 0 if memory is exhausted. */
static int copy_value(const arc_value *from, kept *to) {
  const size_t numbers = from->array ? from->count * sizeof(double) : 0;
  const size_t name = strlen(from->name) + 1, text = from->text ? strlen(from->text) + 1 : 0;
  *to = (kept){*from, malloc(numbers + name + text)};
  char *memory = to->memory;
  if (!memory) return 0;
  if (from->array) to->value.array = memcpy(memory, from->array, numbers);
  to->value.name = memcpy(memory + numbers, from->name, name);
  if (from->text) to->value.text = memcpy(memory + numbers + name, from->text, text);
  return 1;
}

/* State of the function that reads a case. */
typedef struct reading {
  const arc_store *store;
  int id;
  arc_stored_run *run;
  stock *stock;
  arc_error *error;
  arc_status status;
  const char *msh; /* Gmsh text of imported meshes, or NULL */
} reading;

static arc_status no_memory(const reading *r) {
  return arc_fail(r->error, ARC_MEMORY, "%s: out of memory", r->store->path);
}

static int collect(void *context, const arc_value *value) {
  reading *r = context;
  stock *s = r->stock;
  kept *grown = arc_store_grown(s->kept, s->count, sizeof *grown);
  if (grown) s->kept = grown;
  if (!grown || !copy_value(value, &grown[s->count])) {
    r->status = no_memory(r);
    return 1;
  }
  s->count++;
  if (s->count < 2 || strcmp(grown[s->count - 2].value.name, value->name) < 0) return 0;
  r->status = arc_store_damaged(r->store, r->error, r->id, "has the field '%s' twice", value->name);
  return 1;
}

/* --- reading definitions ---------------------------------------------------------------------- */

static arc_status refuse_value(const reading *r, const arc_value *value) {
  char shown[80] = "an array";
  if (value->kind == ARC_VALUE_TEXT) snprintf(shown, sizeof shown, "'%.60s'", value->text);
  if (value->kind == ARC_VALUE_NUMBER) snprintf(shown, sizeof shown, "%g", value->number);
  if (value->kind == ARC_VALUE_FLAG) snprintf(shown, sizeof shown, "%g as a flag", value->number);
  return arc_store_damaged(
      r->store, r->error, r->id,
      "has the field '%.100s' with the value %s, which this program does not support; was the file "
      "written by a newer archard?",
      value->name, shown);
}

static int read_whole(const arc_value *value, int *to) {
  const int fits = value->kind == ARC_VALUE_NUMBER && fabs(value->number) < 1e9 &&
                   value->number == floor(value->number);
  if (fits) *to = (int)value->number;
  return fits;
}

static int read_choice(const slot *s, const arc_value *value) {
  for (int i = 0; value->kind == ARC_VALUE_TEXT && s->choices[i]; i++)
    if (strcmp(s->choices[i], value->text) == 0) {
      *(int *)s->at = i;
      return 1;
    }
  return 0;
}

static int read_text(const slot *s, const arc_value *value) {
  const int fits = value->kind == ARC_VALUE_TEXT && strlen(value->text) < ARC_TEXT_SIZE;
  if (fits) arc_show_text(value->text, s->at, ARC_TEXT_SIZE);
  return fits;
}

/* Reads an array. Several arrays may share one length, which is the length of the array that is
 * read first. Returns 0 if the array is invalid. */
static int read_array(const slot *s, const arc_value *value) {
  if (value->kind != ARC_VALUE_ARRAY || value->count == 0 || value->count > 1000000) return 0;
  if (*s->count != 0 && (size_t)*s->count != value->count) return 0;
  *(const double **)s->at = value->array;
  *s->count = (int)value->count;
  return 1;
}

/* Reads a value. Returns 0 if the value is invalid for this setting. */
static int read_value(const slot *s, const arc_value *value) {
  switch (s->kind) {
  case SLOT_WHOLE:
    return read_whole(value, s->at);
  case SLOT_CHOICE:
    return read_choice(s, value);
  case SLOT_TEXT:
    return read_text(s, value);
  case SLOT_LONG:
    *(const char **)s->at = value->text;
    return value->kind == ARC_VALUE_TEXT;
  case SLOT_ARRAY:
    return read_array(s, value);
  case SLOT_FLAG:
    *(char *)s->at = 1;
    return value->kind == ARC_VALUE_FLAG && value->number == 1;
  case SLOT_NUMBER:
    break;
  }
  *(double *)s->at = value->number;
  return value->kind == ARC_VALUE_NUMBER && !isnan(value->number);
}

static int by_name(const void *a, const void *b) {
  return strcmp(((const slot *)a)->name, ((const slot *)b)->name);
}

static int is_called(const void *name, const void *s) {
  return strcmp(name, ((const slot *)s)->name);
}

/* Allocates the blocks of loading. The number of blocks must not exceed half the number of
 * stored values, because each block has at least two values. */
static arc_status make_blocks(const reading *r) {
  stock *s = r->stock;
  int blocks = 0;
  for (size_t i = 0; i < s->count; i++)
    if (strcmp(s->kept[i].value.name, "blocks") == 0 &&
        (!read_whole(&s->kept[i].value, &blocks) || blocks < 0 || (size_t)blocks > s->count / 2))
      return refuse_value(r, &s->kept[i].value);
  s->loading = calloc((size_t)blocks + 1, sizeof *s->loading);
  if (!s->loading) return no_memory(r);
  r->run->def.blocks = blocks;
  r->run->def.loading = blocks > 0 ? s->loading : NULL;
  return ARC_OK;
}

static arc_status fill_in(const reading *r, const slots *table) {
  for (size_t i = 0; i < r->stock->count; i++) {
    const arc_value *value = &r->stock->kept[i].value;
    const slot *s = bsearch(value->name, table->slot, table->count, sizeof *table->slot, is_called);
    if (!s || !read_value(s, value)) return refuse_value(r, value);
  }
  for (size_t i = 0; i < table->count; i++) {
    const slot *s = &table->slot[i];
    if (s->kind == SLOT_ARRAY && *s->count > 0 && !array_at(s) && !s->optional)
      return arc_store_damaged(r->store, r->error, r->id, "lacks the field '%s'", s->name);
  }
  return ARC_OK;
}

static arc_status fill(reading *r) {
  arc_status status = make_blocks(r);
  if (status != ARC_OK) return status;
  slots table = table_of(r->run, r->stock->loading, &r->msh);
  if (table.failed) {
    status = no_memory(r);
  } else {
    qsort(table.slot, table.count, sizeof *table.slot, by_name);
    status = fill_in(r, &table);
  }
  free(table.slot);
  return status;
}

/* --- checking definitions --------------------------------------------------------------------- */

static void stand_in(void) {}

/* Reads the imported meshes. The reader of Gmsh files rejects invalid meshes. */
static arc_status read_meshes(const reading *r) {
  arc_error why = {0};
  if (!r->msh) return ARC_OK;
  if (arc_mesh_parse_msh("the mesh", r->msh, strlen(r->msh), r->run->given, &why) == ARC_OK)
    return ARC_OK;
  if (why.status == ARC_FORMAT)
    return arc_store_damaged(r->store, r->error, r->id, "has no mesh that can be read: %s",
                             why.message);
  return arc_store_refused(r->store, r->error, r->id, &why);
}

static arc_status check_model(const reading *r, arc_error *why) {
  if (!r->msh) return arc_model_check(&r->run->model, why);
  return arc_model_check_given(&r->run->model, r->run->given, why);
}

/* Checks the definition by the functions of the engine. A dummy replaces each function of the
 * user, because functions are not stored. */
static arc_status check(const reading *r) {
  arc_error why = {0};
  arc_wear_def def = r->run->def;
  void (*const function)(void) = stand_in;
  for (const arc_setting *s = arc_wear_settings; s->name; s++)
    if (r->run->functions[s - arc_wear_settings])
      memcpy((char *)&def + s->function, &function, sizeof function);
  arc_status status = check_model(r, &why);
  if (status == ARC_OK) status = arc_wear_check(&def, &r->run->model, &why);
  return status == ARC_OK ? ARC_OK : arc_store_refused(r->store, r->error, r->id, &why);
}

arc_status arc_stored_run_model(arc_stored_run *run, const arc_callbacks *callbacks,
                                arc_model **model, arc_error *error) {
  if (run->given[ARC_UPPER])
    return arc_model_build_given(&run->model, run->given, callbacks, model, error);
  return arc_model_build_with_callbacks(&run->model, callbacks, model, error);
}

arc_status arc_store_definition(arc_store *store, int id, arc_stored_run *run, arc_error *error) {
  stock *values = calloc(1, sizeof *values);
  *run =
      (arc_stored_run){.model = arc_model_default(), .def = arc_wear_default(), .memory = values};
  reading r = {store, id, run, values, error, ARC_OK, NULL};
  if (!values) return no_memory(&r);
  arc_status status = arc_store_values(store, id, ARC_DEFINITION, collect, &r, error);
  if (status == ARC_OK) status = r.status;
  if (status == ARC_OK && r.stock->count == 0)
    status = arc_fail(error, ARC_ARGUMENT, "%s: no run is stored as case %d", store->path, id);
  if (status == ARC_OK) status = fill(&r);
  if (status == ARC_OK) status = read_meshes(&r);
  if (status == ARC_OK) status = check(&r);
  if (status != ARC_OK) arc_stored_run_free(run);
  return status;
}
