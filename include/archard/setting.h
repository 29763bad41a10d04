/* archard/setting.h - tables that describe all settings.
 *
 * Each definition struct (arc_material, arc_mesh_def, arc_model_def, arc_contact_def, arc_wear_def)
 * is generated from a list with one row for each setting. The same list generates an array of
 * arc_setting. Defaults, checks, messages, readers of tables and files, help and manual use this
 * array, so a new setting needs only one row.
 *
 * The columns of a row are: `unit` ("" for a pure number), `usual` (the default), `range` (such as
 * ABOVE(0)), `forms` (flags such as ARC_AUTOMATIC, or 0), and `text` (the help text).
 *
 *   NUMBER(name, unit, usual, range, forms, text)      double
 *   WHOLE(name, unit, usual, range, forms, text)       int
 *   CHOICE(name, type, usual, forms, text)             arc_TYPE, named by arc_TYPE_names
 *   QUANTITY(name, unit, usual, range, forms, text)    double, or a value of another of the `forms`
 *   FUNCTION(name, type, pointer, forms, text)         a pointer to a function, or NULL
 *   TEXT(name, type, forms, text)                      char [ARC_TEXT_SIZE], "" for none
 *   OTHER(name, type, class, forms, text)              another type; the struct has no member */
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
  ARC_TEXT,  /* text shorter than ARC_TEXT_SIZE bytes */
  ARC_GROUP, /* a struct with its own list of settings */
  ARC_OTHER  /* value of another type, such as an object, which is read by separate code */
} arc_setting_kind;

/* Size [bytes] of the text of a setting, including the terminating zero. */
enum { ARC_TEXT_SIZE = 32 };

/* Flags of a setting: values that it accepts besides a number, and other properties. */
enum {
  ARC_FUNCTION = 1,  /* the setting accepts a function of the state of a run */
  ARC_SERIES = 2,    /* the setting accepts a table of values over the sliding distance */
  ARC_AUTOMATIC = 4, /* the setting accepts the word "auto"; the member is then 0 */
  ARC_OPTIONAL = 8,  /* the setting may be omitted; the member is then 0 */
  ARC_FIXED = 16     /* the setting cannot be changed in an existing object */
};

enum { ARC_LOW_OPEN = 1, ARC_HIGH_OPEN = 2 };

typedef struct arc_setting {
  const char *name; /* name of the setting in tables of the user; NULL ends a list */
  const char *unit; /* unit of the value; "" for a pure number */
  const char *text; /* description for help */
  const char *type; /* description of the possible values, for the kinds ARC_OTHER and ARC_TEXT;
                       else NULL */
  const char *class_name; /* class of the object, for the kinds ARC_OTHER and ARC_GROUP; NULL: not
                             an object */
  const char *usual_text; /* the default as it is written in the row, such as "200e3" */
  const char *const *choices; /* names of the choices; NULL ends the list */
  const struct arc_setting *group;
  arc_setting_kind kind;
  unsigned forms;
  size_t offset;           /* offset of the member in the struct */
  size_t function, series; /* offsets of the members for a function and for a table; 0: the setting
                              does not accept this form */
  double usual, low, high;
  int open; /* flags ARC_LOW_OPEN and ARC_HIGH_OPEN: the range excludes its lower or upper bound */
  int multiple; /* if > 0, the value must be a multiple of this number */
} arc_setting;

/* Table of a quantity over the sliding distance. Values are interpolated linearly between points
 * and are constant beyond the ends. The distances [mm] never decrease; two points at the same
 * distance define a jump. */
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

/* Each of these macros turns a row of a list into a member of the definition struct. */
#define ARC_MEMBER_NUMBER(name, unit, usual, range, forms, text) double name;
#define ARC_MEMBER_WHOLE(name, unit, usual, range, forms, text)  int name;
#define ARC_MEMBER_CHOICE(name, type, usual, forms, text)        arc_##type name;
#define ARC_MEMBER_QUANTITY(name, unit, usual, range, forms, text)                                 \
  double name;                                                                                     \
  arc_state_fn name##_function; /* function that replaces the number; NULL: none */                \
  arc_series name##_series;     /* table that replaces the number; count 0: none */
#define ARC_MEMBER_TEXT(name, type, forms, text)              char name[ARC_TEXT_SIZE];
#define ARC_MEMBER_FUNCTION(name, type, pointer, forms, text) pointer name;
#define ARC_MEMBER_OTHER(name, type, class_name, forms, text)

/* Each of these macros turns a row of a list into an initialiser of arc_setting. Before use, define
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

/* Macros for a list of choices X(NAME, "name"). They generate the enumerators ARC_NAME, the number
 * of choices, and the names. */
#define ARC_CHOICE_ENUM(name, ...)  ARC_##name,
#define ARC_CHOICE_ONE(...)         +1 /* 0 LIST(ARC_CHOICE_ONE) is the number of choices */
#define ARC_CHOICE_NAME(name, ...)  ARC_CHOICE_FIRST(__VA_ARGS__, 0),
#define ARC_CHOICE_FIRST(text, ...) text

/* Choices of a setting whose value is false or true. */
#define ARC_SWITCH_LIST(X)                                                                         \
  X(OFF, "false")                                                                                  \
  X(ON, "true")
typedef enum arc_switch { ARC_SWITCH_LIST(ARC_CHOICE_ENUM) } arc_switch;
extern const char *const arc_switch_names[];

/* --- functions on lists ----------------------------------------------------------------------- */

/* Sets every member of `def` to its default. */
void arc_settings_default(const arc_setting *list, void *def);

/* Checks that all members are in their ranges. Returns ARC_ARGUMENT for the first member that is
 * not, with the message "field 'NAME': expected ..., got ...". `prefix` ("" or "mesh.") is written
 * before the name. */
arc_status arc_settings_check(const arc_setting *list, const char *prefix, const void *def,
                              arc_error *error);

/* Checks that one value is in the range of a setting. Errors as for arc_settings_check. */
arc_status arc_setting_check_number(const arc_setting *setting, const char *prefix, double value,
                                    arc_error *error);

/* Returns the setting called `name` in the list, or NULL if there is none. Groups are not
 * searched. */
const arc_setting *arc_setting_find(const arc_setting *list, const char *name);

/* Writes a description of the possible values of a setting, such as "a number > 0 mm" or "\"SP\"
 * or \"NSP\"", to `text` (`size` bytes). Returns `text`. */
const char *arc_setting_expected(const arc_setting *setting, char *text, size_t size);

/* Returns the default of a setting as text, such as "200e3", or "" if it has no default. */
const char *arc_setting_usual(const arc_setting *setting);

/* arc_setting_member and arc_setting_value return a pointer to the member of `def` that belongs to
 * the setting. The member of an ARC_CHOICE is an int. */
void *arc_setting_member(const arc_setting *setting, void *def);
const void *arc_setting_value(const arc_setting *setting, const void *def);
/* Returns the value of a setting as a number: a choice is returned as its index, a text as 0. */
double arc_setting_number(const arc_setting *setting, const void *def);
/* arc_setting_has_function returns true if the setting is a function in the definition `def`, and
 * arc_setting_is_auto if it is "auto". arc_setting_series returns the table of the setting (count
 * 0: no table). */
int arc_setting_has_function(const arc_setting *setting, const void *def);
int arc_setting_is_auto(const arc_setting *setting, const void *def);
arc_series arc_setting_series(const arc_setting *setting, const void *def);

/* Calls `see` for every setting with a member, including settings in groups. `def` is the struct
 * that contains the member. `path` is the name of the setting after the names of its groups, such
 * as "mesh.size". A non-zero result of `see` ends the loop and is returned. */
typedef int (*arc_setting_fn)(void *context, const char *path, const arc_setting *setting,
                              const void *def);
int arc_settings_walk(const arc_setting *list, const char *prefix, const void *def,
                      arc_setting_fn see, void *context);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif

#endif
