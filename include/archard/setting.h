/* archard/setting.h - descriptions of all settings.
 *
 * Each definition struct (arc_material, arc_mesh_def, arc_model_def, arc_contact_def, arc_wear_def)
 * has a list of rows, from which its members and an array of arc_setting are made. Defaults,
 * checks, messages, readers of tables and files, help and manual use this array, so a new setting
 * needs only one row.
 *
 * In a row, unit is "" for a pure number, `usual` is the default, range is for example ABOVE(0),
 * `forms` are from the list below, and `text` is for users.
 *
 *   NUMBER(name, unit, usual, range, forms, text)      double
 *   WHOLE(name, unit, usual, range, forms, text)       int
 *   CHOICE(name, type, usual, forms, text)             arc_TYPE, named by arc_TYPE_names
 *   QUANTITY(name, unit, usual, range, forms, text)    double, or a value of another of the `forms`
 *   FUNCTION(name, type, pointer, forms, text)         a pointer to a function, or NULL
 *   TEXT(name, type, forms, text)                      char [ARC_TEXT_SIZE], "" for none
 *   OTHER(name, type, class, forms, text)              for objects; the row makes no member */
#ifndef ARCHARD_SETTING_H
#define ARCHARD_SETTING_H

#include "archard/base.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

typedef enum arc_setting_kind {
  ARC_NUMBER,
  ARC_WHOLE,
  ARC_CHOICE,
  ARC_TEXT,  /* text of less than ARC_TEXT_SIZE bytes */
  ARC_GROUP, /* a struct with its own list of settings */
  ARC_OTHER  /* value of another type, which separate code reads */
} arc_setting_kind;

/* Size of a text including its final zero. */
enum { ARC_TEXT_SIZE = 32 };

/* Flags of a setting: values that it accepts besides a number, and other properties. */
enum {
  ARC_FUNCTION = 1,  /* accepts a function of the state */
  ARC_SERIES = 2,    /* accepts a table over the distance */
  ARC_AUTOMATIC = 4, /* accepts the word "auto"; the member is then 0 */
  ARC_OPTIONAL = 8,  /* may be omitted; the member is then 0 */
  ARC_FIXED = 16     /* cannot be changed in an existing object */
};

enum { ARC_LOW_OPEN = 1, ARC_HIGH_OPEN = 2 };

typedef struct arc_setting {
  const char *name; /* name that users write in tables; NULL ends a list */
  const char *unit; /* unit of the value; "" for a pure number */
  const char *text; /* description for help */
  const char *type; /* description of the possible values of ARC_OTHER and ARC_TEXT, else NULL */
  const char *class_name;     /* class of the object for ARC_OTHER and ARC_GROUP; NULL: no class */
  const char *usual_text;     /* text of the default in the row, such as "200e3" */
  const char *const *choices; /* names of the choices; NULL ends the list */
  const struct arc_setting *group;
  arc_setting_kind kind;
  unsigned forms;
  size_t offset;           /* offset of the member in the struct */
  size_t function, series; /* offsets of the members for a function and for a table; 0: the setting
                              does not accept this form */
  double usual, low, high;
  int open;     /* flags ARC_LOW_OPEN, ARC_HIGH_OPEN: the bound does not belong to the range */
  int multiple; /* a whole number must be a multiple of this number; 0: no such condition */
} arc_setting;

/* Table of a quantity over the travelled distance. Values are linear between points and constant
 * beyond them. distance [mm] never decreases; two points at the same distance define a jump. */
typedef struct arc_series {
  int count; /* number of points; 0: no table */
  const double *distance, *value;
} arc_series;

/* --- rows of lists ---------------------------------------------------------------------------- */

/* Ranges of values. Rows use these names without the prefix ARC_RANGE_, such as ABOVE(0). */
#define ARC_RANGE_ANY                 .low = -HUGE_VAL, .high = HUGE_VAL
#define ARC_RANGE_ABOVE(bound)        .low = (bound), .high = HUGE_VAL, .open = ARC_LOW_OPEN
#define ARC_RANGE_FROM(bound)         .low = (bound), .high = HUGE_VAL
#define ARC_RANGE_WITHIN(least, most) .low = (least), .high = (most)
#define ARC_RANGE_BETWEEN(least, most)                                                             \
  .low = (least), .high = (most), .open = ARC_LOW_OPEN | ARC_HIGH_OPEN
#define ARC_RANGE_ABOVE_TO(least, most) .low = (least), .high = (most), .open = ARC_LOW_OPEN
#define ARC_RANGE_EVEN(least, most)     .low = (least), .high = (most), .multiple = 2

/* Each of these macros turns a row of a list into a member of the struct. */
#define ARC_MEMBER_NUMBER(name, unit, usual, range, forms, text) double name;
#define ARC_MEMBER_WHOLE(name, unit, usual, range, forms, text)  int name;
#define ARC_MEMBER_CHOICE(name, type, usual, forms, text)        arc_##type name;
#define ARC_MEMBER_QUANTITY(name, unit, usual, range, forms, text)                                 \
  double name;                                                                                     \
  arc_state_fn name##_function; /* function that replaces the number; NULL: none */                \
  arc_series name##_series;     /* table that replaces the number if it has points */
#define ARC_MEMBER_TEXT(name, type, forms, text)              char name[ARC_TEXT_SIZE];
#define ARC_MEMBER_FUNCTION(name, type, pointer, forms, text) pointer name;
#define ARC_MEMBER_OTHER(name, type, class_name, forms, text)

/* Each of these macros turns a row of a list into an initialiser of arc_setting. Define
 * ARC_SETTING_OF as the struct that contains the members. */
#define ARC_SETTING_NUMBER(name_, unit_, usual_, range, forms_, text_)                             \
  {.name = #name_,                                                                                 \
   .unit = unit_,                                                                                  \
   .text = text_,                                                                                  \
   .usual_text = #usual_,                                                                          \
   .kind = ARC_NUMBER,                                                                             \
   .forms = forms_,                                                                                \
   .offset = offsetof(ARC_SETTING_OF, name_),                                                      \
   .usual = usual_,                                                                                \
   ARC_RANGE_##range},
#define ARC_SETTING_WHOLE(name_, unit_, usual_, range, forms_, text_)                              \
  {.name = #name_,                                                                                 \
   .unit = unit_,                                                                                  \
   .text = text_,                                                                                  \
   .usual_text = #usual_,                                                                          \
   .kind = ARC_WHOLE,                                                                              \
   .forms = forms_,                                                                                \
   .offset = offsetof(ARC_SETTING_OF, name_),                                                      \
   .usual = usual_,                                                                                \
   ARC_RANGE_##range},
#define ARC_SETTING_CHOICE(name_, type_, usual_, forms_, text_)                                    \
  {.name = #name_,                                                                                 \
   .unit = "",                                                                                     \
   .text = text_,                                                                                  \
   .kind = ARC_CHOICE,                                                                             \
   .forms = forms_,                                                                                \
   .choices = arc_##type_##_names,                                                                 \
   .offset = offsetof(ARC_SETTING_OF, name_),                                                      \
   .usual = usual_},
#define ARC_SETTING_QUANTITY(name_, unit_, usual_, range, forms_, text_)                           \
  {.name = #name_,                                                                                 \
   .unit = unit_,                                                                                  \
   .text = text_,                                                                                  \
   .usual_text = #usual_,                                                                          \
   .kind = ARC_NUMBER,                                                                             \
   .forms = forms_,                                                                                \
   .offset = offsetof(ARC_SETTING_OF, name_),                                                      \
   .usual = usual_,                                                                                \
   .function = offsetof(ARC_SETTING_OF, name_##_function),                                         \
   .series = offsetof(ARC_SETTING_OF, name_##_series),                                             \
   ARC_RANGE_##range},
#define ARC_SETTING_TEXT(name_, type_, forms_, text_)                                              \
  {.name = #name_,                                                                                 \
   .unit = "",                                                                                     \
   .text = text_,                                                                                  \
   .type = type_,                                                                                  \
   .kind = ARC_TEXT,                                                                               \
   .forms = forms_,                                                                                \
   .offset = offsetof(ARC_SETTING_OF, name_)},
#define ARC_SETTING_FUNCTION(name_, type_, pointer, forms_, text_)                                 \
  {.name = #name_,                                                                                 \
   .unit = "",                                                                                     \
   .text = text_,                                                                                  \
   .type = type_,                                                                                  \
   .kind = ARC_OTHER,                                                                              \
   .forms = ARC_FUNCTION | forms_,                                                                 \
   .function = offsetof(ARC_SETTING_OF, name_)},
#define ARC_SETTING_OTHER(name_, type_, class_, forms_, text_)                                     \
  {.name = #name_,                                                                                 \
   .unit = "",                                                                                     \
   .text = text_,                                                                                  \
   .type = type_,                                                                                  \
   .class_name = class_,                                                                           \
   .kind = ARC_OTHER,                                                                              \
   .forms = forms_},

/* Turns a row of a list into the enumerator ARC_AT_name, which is the position of the row in the
 * list. */
#define ARC_POSITION(name, ...) ARC_AT_##name,

/* These macros turn the choices of a list X(NAME, "name") into enumerators ARC_NAME, their number
 * and their names. */
#define ARC_CHOICE_ENUM(name, ...)  ARC_##name,
#define ARC_CHOICE_ONE(...)         +1 /* counts choices: 0 LIST(ARC_CHOICE_ONE) */
#define ARC_CHOICE_NAME(name, ...)  ARC_CHOICE_FIRST(__VA_ARGS__, 0),
#define ARC_CHOICE_FIRST(text, ...) text

/* Choices of a setting for which users write false or true. */
#define ARC_SWITCH_LIST(X)                                                                         \
  X(OFF, "false")                                                                                  \
  X(ON, "true")
typedef enum arc_switch { ARC_SWITCH_LIST(ARC_CHOICE_ENUM) } arc_switch;
extern const char *const arc_switch_names[];

/* --- functions on lists ----------------------------------------------------------------------- */

/* Sets every member of `def` that has a default to its default. */
void arc_settings_default(const arc_setting *list, void *def);

/* Checks the ranges of all members. Returns ARC_ARGUMENT for the first violation: "field 'NAME':
 * expected ..., got ...", with `prefix` ("" or "mesh.") before the name. */
arc_status arc_settings_check(const arc_setting *list, const char *prefix, const void *def,
                              arc_error *error);

/* Checks the range of one value of a setting. Errors as for arc_settings_check. */
arc_status arc_setting_check_number(const arc_setting *setting, const char *prefix, double value,
                                    arc_error *error);

/* Returns the setting called `name` in the list, or NULL if there is none. Groups are not
 * searched. */
const arc_setting *arc_setting_find(const arc_setting *list, const char *name);

/* Writes a description of the possible values to text [size] and returns it, such as "a number > 0
 * mm" or "\"SP\" or \"NSP\"". */
const char *arc_setting_expected(const arc_setting *setting, char *text, size_t size);

/* Returns the default of a setting as text, such as "200e3", or "" if it has no default. */
const char *arc_setting_usual(const arc_setting *setting);

/* Both functions return a pointer to the member of `def` that belongs to the setting. The member of
 * an ARC_CHOICE is an int. */
void *arc_setting_member(const arc_setting *setting, void *def);
const void *arc_setting_value(const arc_setting *setting, const void *def);
/* Returns the value of a setting as a number: a choice is returned as its index, a text as 0. */
double arc_setting_number(const arc_setting *setting, const void *def);
/* These functions read a setting from the definition `def`. The first function returns true if the
 * setting is a function, the second one returns true if it is "auto", and the third one returns its
 * table (count 0: no table). */
int arc_setting_has_function(const arc_setting *setting, const void *def);
int arc_setting_is_auto(const arc_setting *setting, const void *def);
arc_series arc_setting_series(const arc_setting *setting, const void *def);

/* Calls `see` for every setting with a member, including settings in groups, for which `def` is the
 * struct of the group. `path` is the name of the setting after the names of its groups, such as
 * "mesh.size". A non-zero result of `see` ends the loop and is returned. */
typedef int (*arc_setting_fn)(void *context, const char *path, const arc_setting *setting,
                              const void *def);
int arc_settings_walk(const arc_setting *list, const char *prefix, const void *def,
                      arc_setting_fn see, void *context);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif

#endif
