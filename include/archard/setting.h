/* archard/setting.h - everything a user can set, described once.
 *
 * Each definition struct (arc_material, arc_mesh_def, arc_model_def, arc_contact_def, arc_wear_def)
 * has a list of rows that makes its members, and an array of arc_setting made from the same rows.
 * Defaults, checks, their messages, the readers of tables and files, help and manual all read that
 * array: a new setting is one row.
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
  ARC_OTHER  /* whoever made the list reads it */
} arc_setting_kind;

/* Room for a text with its end. */
enum { ARC_TEXT_SIZE = 32 };

/* What a setting may be besides its kind, and what else is to be known of it. */
enum {
  ARC_FUNCTION = 1,  /* a function of the state */
  ARC_SERIES = 2,    /* a table over distance */
  ARC_AUTOMATIC = 4, /* the word "auto"; 0 in the struct */
  ARC_OPTIONAL = 8,  /* 0 in the struct: not given */
  ARC_FIXED = 16     /* cannot be changed in what has been made */
};

enum { ARC_LOW_OPEN = 1, ARC_HIGH_OPEN = 2 };

typedef struct arc_setting {
  const char *name;           /* as users write it; NULL ends a list */
  const char *unit;           /* "" for none */
  const char *text;           /* what it is, for help */
  const char *type;           /* of ARC_OTHER and ARC_TEXT: what it can be, in words; NULL else */
  const char *class_name;     /* of ARC_OTHER and ARC_GROUP: the object it can be; NULL: none */
  const char *usual_text;     /* the default as written in the row */
  const char *const *choices; /* names, NULL ends them */
  const struct arc_setting *group;
  arc_setting_kind kind;
  unsigned forms;
  size_t offset;           /* of the member in the struct */
  size_t function, series; /* of the members for the other forms; 0: none */
  double usual, low, high;
  int open;     /* which ends of the range do not belong to it */
  int multiple; /* whole numbers: of what they are multiples; 0: any */
} arc_setting;

/* A quantity by travelled distance: linear between points, constant outside; distance [mm]
 * increases. */
typedef struct arc_series {
  int count; /* 0: none */
  const double *distance, *value;
} arc_series;

/* --- what lists are made of ------------------------------------------------------------------- */

/* Ranges; rows name them without ARC_RANGE_, as ABOVE(0). */
#define ARC_RANGE_ANY                 .low = -HUGE_VAL, .high = HUGE_VAL
#define ARC_RANGE_ABOVE(bound)        .low = (bound), .high = HUGE_VAL, .open = ARC_LOW_OPEN
#define ARC_RANGE_FROM(bound)         .low = (bound), .high = HUGE_VAL
#define ARC_RANGE_WITHIN(least, most) .low = (least), .high = (most)
#define ARC_RANGE_BETWEEN(least, most)                                                             \
  .low = (least), .high = (most), .open = ARC_LOW_OPEN | ARC_HIGH_OPEN
#define ARC_RANGE_ABOVE_TO(least, most) .low = (least), .high = (most), .open = ARC_LOW_OPEN
#define ARC_RANGE_EVEN(least, most)     .low = (least), .high = (most), .multiple = 2

/* Members of a struct, as the rows of its list make them. */
#define ARC_MEMBER_NUMBER(name, unit, usual, range, forms, text) double name;
#define ARC_MEMBER_WHOLE(name, unit, usual, range, forms, text)  int name;
#define ARC_MEMBER_CHOICE(name, type, usual, forms, text)        arc_##type name;
#define ARC_MEMBER_QUANTITY(name, unit, usual, range, forms, text)                                 \
  double name;                                                                                     \
  arc_state_fn name##_function; /* instead of the number, where not NULL */                        \
  arc_series name##_series;     /* instead of the number, where it has points */
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

/* --- what can be done with a list ------------------------------------------------------------- */

/* Sets every member that has a default. */
void arc_settings_default(const arc_setting *list, void *def);

/* The first value out of its range, told as "field 'NAME': expected ..., got ...": ARC_ARGUMENT.
 * Names carry `prefix` ("" or "mesh."). */
arc_status arc_settings_check(const arc_setting *list, const char *prefix, const void *def,
                              arc_error *error);

/* The same of one number that is meant for a setting. */
arc_status arc_setting_check_number(const arc_setting *setting, const char *prefix, double value,
                                    arc_error *error);

/* The setting of that name in the list itself (groups are not entered), or NULL. */
const arc_setting *arc_setting_find(const arc_setting *list, const char *name);

/* What it can be, in words: "a number > 0 mm", "\"SP\" or \"NSP\"". Written to text [size]. */
const char *arc_setting_expected(const arc_setting *setting, char *text, size_t size);

/* The default in words, "200e3"; "" where there is none. */
const char *arc_setting_usual(const arc_setting *setting);

/* The member of a definition; for ARC_CHOICE it is an int. */
void *arc_setting_member(const arc_setting *setting, void *def);
const void *arc_setting_value(const arc_setting *setting, const void *def);
/* Its number: of a whole one or a choice the int, of a text 0. */
double arc_setting_number(const arc_setting *setting, const void *def);
/* Whether the function, the word "auto" is set; the series (count 0: none). */
int arc_setting_has_function(const arc_setting *setting, const void *def);
int arc_setting_is_auto(const arc_setting *setting, const void *def);
arc_series arc_setting_series(const arc_setting *setting, const void *def);

/* Sees every setting with a member, those in groups too, which are then `def`: `path` is the name
 * with the groups' before it ("mesh.size"). Non-zero from `see` ends the walk and is returned. */
typedef int (*arc_setting_fn)(void *context, const char *path, const arc_setting *setting,
                              const void *def);
int arc_settings_walk(const arc_setting *list, const char *prefix, const void *def,
                      arc_setting_fn see, void *context);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif

#endif
