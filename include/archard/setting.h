/* archard/setting.h - descriptions of all settings.
 *
 * Each definition struct (arc_material, arc_mesh_def, arc_model_def, arc_contact_def, arc_wear_def)
 * has a list of rows; the members and an array of arc_setting are made from the same rows.
 * Defaults, checks, messages, readers of tables and files, help and manual use this array: a new
 * setting is one row.
 *
 * The rows: unit "" for none, range such as ABOVE(0), `forms` from the list below, `text` for
 * users.
 *
 *   NUMBER(name, unit, usual, range, forms, text)      double
 *   WHOLE(name, unit, usual, range, forms, text)       int
 *   CHOICE(name, type, usual, forms, text)             arc_TYPE, named by arc_TYPE_names
 *   QUANTITY(name, unit, usual, range, forms, text)    double, or what `forms` allow instead
 *   FUNCTION(name, type, pointer, forms, text)         a pointer to a function, or NULL
 *   TEXT(name, type, forms, text)                      char [ARC_TEXT_SIZE], "" for none
 *   OTHER(name, type, class, forms, text)              no member made by the row: objects
 */
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
  ARC_TEXT,  /* a word */
  ARC_GROUP, /* a struct with settings of its own */
  ARC_OTHER  /* read by special code */
} arc_setting_kind;

/* Size of a text with its final zero. */
enum { ARC_TEXT_SIZE = 32 };

/* Other forms and properties of a setting. */
enum {
  ARC_FUNCTION = 1,  /* a function of the state */
  ARC_SERIES = 2,    /* a table over distance */
  ARC_AUTOMATIC = 4, /* the word "auto"; 0 in the struct */
  ARC_OPTIONAL = 8,  /* 0 in the struct: not given */
  ARC_FIXED = 16     /* cannot be changed in an existing object */
};

enum { ARC_LOW_OPEN = 1, ARC_HIGH_OPEN = 2 };

typedef struct arc_setting {
  const char *name; /* in tables of users; NULL ends a list */
  const char *unit; /* "" for none */
  const char *text; /* description for help */
  const char *type; /* for ARC_OTHER and ARC_TEXT: description of the possible values; else NULL */
  const char *class_name;     /* for ARC_OTHER and ARC_GROUP: class of the object; NULL: none */
  const char *usual_text;     /* the default as written in the row */
  const char *const *choices; /* names, NULL ends them */
  const struct arc_setting *group;
  arc_setting_kind kind;
  unsigned forms;
  size_t offset;           /* of the member in the struct */
  size_t function, series; /* offsets of the members for the other forms; 0: none */
  double usual, low, high;
  int open;     /* ARC_LOW_OPEN, ARC_HIGH_OPEN: ends that are excluded */
  int multiple; /* whole numbers: multiples of this; 0: any */
} arc_setting;

/* A quantity by travelled distance: linear between points, constant outside; distance [mm]
 * increases. */
typedef struct arc_series {
  int count; /* 0: none */
  const double *distance, *value;
} arc_series;

/* --- rows of lists ---------------------------------------------------------------------------- */

/* Ranges; rows name them without ARC_RANGE_, as ABOVE(0). */
#define ARC_RANGE_ANY                 .low = -HUGE_VAL, .high = HUGE_VAL
#define ARC_RANGE_ABOVE(bound)        .low = (bound), .high = HUGE_VAL, .open = ARC_LOW_OPEN
#define ARC_RANGE_FROM(bound)         .low = (bound), .high = HUGE_VAL
#define ARC_RANGE_WITHIN(least, most) .low = (least), .high = (most)
#define ARC_RANGE_BETWEEN(least, most)                                                             \
  .low = (least), .high = (most), .open = ARC_LOW_OPEN | ARC_HIGH_OPEN
#define ARC_RANGE_ABOVE_TO(least, most) .low = (least), .high = (most), .open = ARC_LOW_OPEN
#define ARC_RANGE_EVEN(least, most)     .low = (least), .high = (most), .multiple = 2

/* Members of a struct, from the rows of its list. */
#define ARC_MEMBER_NUMBER(name, unit, usual, range, forms, text) double name;
#define ARC_MEMBER_WHOLE(name, unit, usual, range, forms, text)  int name;
#define ARC_MEMBER_CHOICE(name, type, usual, forms, text)        arc_##type name;
#define ARC_MEMBER_QUANTITY(name, unit, usual, range, forms, text)                                 \
  double name;                                                                                     \
  arc_state_fn name##_function; /* replaces the number if not NULL */                              \
  arc_series name##_series;     /* replaces the number if it has points */
#define ARC_MEMBER_TEXT(name, type, forms, text)              char name[ARC_TEXT_SIZE];
#define ARC_MEMBER_FUNCTION(name, type, pointer, forms, text) pointer name;
#define ARC_MEMBER_OTHER(name, type, class_name, forms, text)

/* Rows as initialisers of arc_setting; ARC_SETTING_OF names the struct. */
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

/* Positions in the list: an enumerator AT_name for each row. */
#define ARC_POSITION(name, ...) ARC_AT_##name,

/* Choices: a list X(NAME, "name") as enumerators ARC_NAME, and as names. */
#define ARC_CHOICE_ENUM(name, ...)  ARC_##name,
#define ARC_CHOICE_ONE(...)         +1 /* 0 LIST(ARC_CHOICE_ONE): how many there are */
#define ARC_CHOICE_NAME(name, ...)  ARC_CHOICE_FIRST(__VA_ARGS__, 0),
#define ARC_CHOICE_FIRST(text, ...) text

/* true or false in tables of users. */
#define ARC_SWITCH_LIST(X)                                                                         \
  X(OFF, "false")                                                                                  \
  X(ON, "true")
typedef enum arc_switch { ARC_SWITCH_LIST(ARC_CHOICE_ENUM) } arc_switch;
extern const char *const arc_switch_names[];

/* --- functions on lists ----------------------------------------------------------------------- */

/* Sets every member that has a default. */
void arc_settings_default(const arc_setting *list, void *def);

/* Checks all ranges. ARC_ARGUMENT for the first violation: "field 'NAME': expected ..., got ...",
 * with `prefix` ("" or "mesh.") before the name. */
arc_status arc_settings_check(const arc_setting *list, const char *prefix, const void *def,
                              arc_error *error);

/* The same for one value of a setting. */
arc_status arc_setting_check_number(const arc_setting *setting, const char *prefix, double value,
                                    arc_error *error);

/* The setting of that name in the list itself (groups are not entered), or NULL. */
const arc_setting *arc_setting_find(const arc_setting *list, const char *name);

/* Description of the possible values: "a number > 0 mm", "\"SP\" or \"NSP\"". Written to text
 * [size]. */
const char *arc_setting_expected(const arc_setting *setting, char *text, size_t size);

/* The default as text, "200e3"; "" without a default. */
const char *arc_setting_usual(const arc_setting *setting);

/* The member of a definition; for ARC_CHOICE it is an int. */
void *arc_setting_member(const arc_setting *setting, void *def);
const void *arc_setting_value(const arc_setting *setting, const void *def);
/* The value as a number: the int of a whole number or choice, 0 for a text. */
double arc_setting_number(const arc_setting *setting, const void *def);
/* True if a function is set; if "auto" is set; the series (count 0: none). */
int arc_setting_has_function(const arc_setting *setting, const void *def);
int arc_setting_is_auto(const arc_setting *setting, const void *def);
arc_series arc_setting_series(const arc_setting *setting, const void *def);

/* Calls `see` for every setting with a member, also in groups (`def` is then the struct of the
 * group); `path` is the name after those of its groups ("mesh.size"). A non-zero result of `see`
 * ends the loop and is returned. */
typedef int (*arc_setting_fn)(void *context, const char *path, const arc_setting *setting,
                              const void *def);
int arc_settings_walk(const arc_setting *list, const char *prefix, const void *def,
                      arc_setting_fn see, void *context);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif

#endif
