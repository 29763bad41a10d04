/* lua/args.h - reads a table of named fields into a definition struct, strictly: an unknown name, a
 * wrong type or a value out of range is an error (ARC_ARGUMENT) that names the field, what was
 * expected, what came, and the nearest known name.
 */
#ifndef LUA_ARGS_H
#define LUA_ARGS_H

#include <lua.h>
#include <math.h>
#include <stddef.h>

/* Where a value stands, for the text of errors: "wear: field 'mesh.size': ...". */
typedef struct args_place {
  const char *where;  /* the function, "wear" */
  const char *prefix; /* what goes before the field's name, "mesh." or "" */
} args_place;

/* How a field is read. */
typedef enum args_kind {
  ARGS_NUMBER, /* finite double */
  ARGS_WHOLE,  /* int */
  ARGS_CHOICE, /* one of `choices`; stored as int, its position */
  ARGS_READER, /* `read` is called with the value on top of the stack, and leaves it there */
  ARGS_ANY     /* known name; whoever made the list reads it */
} args_kind;

enum { ARGS_LOW_OPEN = 1, ARGS_HIGH_OPEN = 2 };

/* Entries for common members: a number above or from `bound` on, a name out of a list, a value with
 * its own reader. */
#define ARGS_ABOVE(type, field, member, bound)                                                     \
  {                                                                                                \
    .name = (field), .kind = ARGS_NUMBER, .offset = offsetof(type, member), .low = (bound),        \
    .high = HUGE_VAL, .open = ARGS_LOW_OPEN                                                        \
  }
#define ARGS_FROM(type, field, member, bound)                                                      \
  {                                                                                                \
    .name = (field), .kind = ARGS_NUMBER, .offset = offsetof(type, member), .low = (bound),        \
    .high = HUGE_VAL                                                                               \
  }
#define ARGS_NAMED(type, field, member, names)                                                     \
  { .name = (field), .kind = ARGS_CHOICE, .offset = offsetof(type, member), .choices = (names) }
#define ARGS_READ(type, field, member, reader)                                                     \
  { .name = (field), .kind = ARGS_READER, .offset = offsetof(type, member), .read = (reader) }
/* A name that whoever made the list reads. */
#define ARGS_OTHER(field)                                                                          \
  { .name = (field), .kind = ARGS_ANY }

typedef struct args_field {
  const char *name; /* NULL ends a list */
  args_kind kind;
  size_t offset;              /* in the definition struct */
  double low, high;           /* numbers: the range, ends included */
  int open;                   /* numbers: which ends are not included */
  const char *const *choices; /* names, NULL ends them */
  void (*read)(lua_State *L, args_place place, const char *name, void *member);
} args_field;

/* Reads the table at `index` (nil or none: an empty one) into `definition`, which holds the
 * defaults. */
void args_read(lua_State *L, int index, args_place place, const args_field *fields,
               void *definition);

/* Only the check of the names; `index` as above, except that the table must be there. */
void args_check_names(lua_State *L, int index, args_place place, const args_field *fields);

/* Raises the error for a name that is none of the fields. */
void args_unknown(lua_State *L, args_place place, const args_field *fields, const char *name)
    __attribute__((noreturn));

/* The number on top of the stack, finite and in the range of `field`, or an error. */
double args_number(lua_State *L, args_place place, const args_field *field);

/* The position in `choices` of the text at `index`; `otherwise` for nil or none, unless that is
 * negative. `name` is what the value is called. */
int args_choice(lua_State *L, int index, args_place place, const char *name,
                const char *const *choices, int otherwise);

/* Raises "field 'NAME': expected EXPECTED, got ..." for the value on top of the stack. */
void args_refuse(lua_State *L, args_place place, const char *name, const char *expected)
    __attribute__((noreturn));

/* Pushes the fields' value of the table at `index` (nil where there is no table). */
int args_get(lua_State *L, int index, const char *name);

/* Pushes a number as text, whole ones without a point. */
const char *args_show_number(lua_State *L, double value);

#endif
