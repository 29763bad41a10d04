/* lua/args.h - reads a table of named fields into a definition struct by its list of settings
 * (archard/setting.h), strictly: an unknown name, a wrong type or a value out of range is an error
 * (ARC_ARGUMENT) that names the field, what was expected, what came, and the nearest known name.
 */
#ifndef LUA_ARGS_H
#define LUA_ARGS_H

#include "archard/setting.h"

#include <lua.h>
#include <math.h>

/* Where a value stands, for the text of errors: "wear: field 'mesh.size': ...". */
typedef struct args_place {
  const char *where;  /* the function, "wear" */
  const char *prefix; /* what goes before the field's name, "mesh." or "" */
} args_place;

/* Rows for what only scripts can set: a number above 0, a name that whoever made the list reads. */
#define ARGS_ABOVE_0(owner, member)                                                                \
  { .name = #member, .offset = offsetof(owner, member), ARC_RANGE_ABOVE(0) }
#define ARGS_OTHER(field)                                                                          \
  { .name = (field), .kind = ARC_OTHER }

/* Reads the table at `index` (nil or none: an empty one) into `definition`, which holds the
 * defaults. Numbers, choices, the word "auto" and groups are read (a group also from an object of
 * its class); of functions and series only the type is checked, and whoever made the list reads
 * them. */
void args_read(lua_State *L, int index, args_place place, const arc_setting *list,
               void *definition);

/* Only the check of the names; `index` as above, except that the table must be there. */
void args_check_names(lua_State *L, int index, args_place place, const arc_setting *list);

/* Raises the error for what is no table at `index`. */
void args_check_table(lua_State *L, int index, const char *where);

/* Raises the error for a field that has no name; its key stands below the top. */
void args_refuse_position(lua_State *L, args_place place) __attribute__((noreturn));

/* Raises the error for a name that is none of the list's. */
void args_unknown(lua_State *L, args_place place, const arc_setting *list, const char *name)
    __attribute__((noreturn));

/* The number on top of the stack, finite and in the range of the setting, or an error. */
double args_number(lua_State *L, args_place place, const arc_setting *setting);

/* The position in `choices` of the text at `index`; `otherwise` for nil or none, unless that is
 * negative. `name` is what the value is called. */
int args_choice(lua_State *L, int index, args_place place, const char *name,
                const char *const *choices, int otherwise);

/* Raises "field 'NAME': expected EXPECTED, got ..." for the value on top of the stack. */
void args_refuse(lua_State *L, args_place place, const char *name, const char *expected)
    __attribute__((noreturn));

/* Pushes the fields' value of the table at `index` (nil where there is no table). */
int args_get(lua_State *L, int index, const char *name);

/* Pushes a table with what the one at `index` has itself. */
void args_push_copy(lua_State *L, int index);

/* Whether the table at `index` has something under the name. */
int args_given(lua_State *L, int index, const char *name);

/* Pushes a number as text, whole ones without a point. */
const char *args_show_number(lua_State *L, double value);

#endif
