/* The engine's definitions as named values: one list of fields each for writing and reading, so
 * that a new field is a line here and no change of the file's format. */
#include "store/store.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const procedures[] = {"auto", "SP", "NSP", NULL};
static const char *const schemes[] = {"explicit", "implicit", NULL};
static const char *const slips[] = {"rigid", "total", NULL};
static const char *const rules[] = {"trapezoid", "simple", NULL};
static const char *const geometries[] = {"moving", "frozen", NULL};
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

enum { FIELDS = sizeof fields / sizeof *fields };

/* A definition that grows must grow the list above, or this stops the build. */
_Static_assert(sizeof(arc_model_def) == 12 * sizeof(double),
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

arc_status definition_save(arc_store *store, int id, const arc_wear *wear, arc_error *error) {
  whole_def def = {*arc_wear_definition(wear), *arc_model_definition(arc_wear_model(wear))};
  arc_value values[FIELDS];
  for (size_t i = 0; i < FIELDS; i++) values[i] = value_of(&fields[i], &def);
  return arc_store_set_values(store, id, ARC_DEFINITION, values, FIELDS, error);
}

/* --- reading ---------------------------------------------------------------------------------- */

typedef struct reading {
  const char *path;
  whole_def def;
  size_t seen; /* values */
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

static int see(void *context, const arc_value *value) {
  reading *r = context;
  r->seen++;
  return read_field(r, value) ? 0 : refuse_value(r, value);
}

arc_status arc_store_definition(arc_store *store, int id, arc_model_def *model, arc_wear_def *def,
                                void **keep, arc_error *error) {
  reading r = {.path = store->path,
               .def = {arc_wear_default(), arc_model_default()},
               .error = error,
               .status = ARC_OK};
  *keep = NULL;
  arc_status status = arc_store_values(store, id, ARC_DEFINITION, see, &r, error);
  if (status == ARC_OK) status = r.status;
  if (status == ARC_OK && r.seen == 0)
    status = arc_fail(error, ARC_ARGUMENT, "%s: no run is stored as case %d", store->path, id);
  if (status != ARC_OK) return status;
  *model = r.def.model;
  *def = r.def.wear;
  return ARC_OK;
}
