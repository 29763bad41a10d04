/* lua/base/args.h - reads a table of named fields into a definition struct, according to its list
 * of settings (archard/setting.h). An unknown name, a wrong type or a value out of range raises
 * ARC_ARGUMENT. The message contains the name of the field, the expected and the actual value, and
 * the most similar valid name. */
#ifndef LUA_ARGS_H
#define LUA_ARGS_H

#include "archard/setting.h"

#include <lua.h>
#include <math.h>

/* The function and the group of fields that an error message names: "wear" and "mesh." in "wear:
 * field 'mesh.size': ...". */
typedef struct args_location {
  const char *where;  /* name of the function, such as "wear" */
  const char *prefix; /* prefix of the field's name, such as "mesh.", or "" */
} args_location;

/* Settings that exist only in scripts, not in the C library. ARGS_ABOVE_0 defines a setting for a
 * number above 0. ARGS_OTHER defines a setting whose value the caller reads and checks. */
#define ARGS_ABOVE_0(owner, member)                                                                \
  { .name = #member, .offset = offsetof(owner, member), ARC_RANGE_ABOVE(0) }
#define ARGS_OTHER(field)                                                                          \
  { .name = (field), .kind = ARC_OTHER }

/* Reads the table at `index` into `definition`, which contains the defaults. If the value is nil or
 * none, `definition` is not changed. Numbers, choices, texts, "auto" and groups are read; a group
 * may also be an object of its class. For functions and series only the type is checked, and the
 * caller reads them. */
void args_read(lua_State *L, int index, args_location location, const arc_setting *list,
               void *definition);

/* Raises an error if the table at `index` has a field that is not in the list of settings. The
 * values are not checked. */
void args_check_names(lua_State *L, int index, args_location location, const arc_setting *list);

/* Raises an error if the value at `index` is not a table. */
void args_check_table(lua_State *L, int index, const char *where);

/* Raises the error for a table entry whose key is not a text, such as a list item. The key and its
 * value are on top of the stack. */
void args_refuse_position(lua_State *L, args_location location) __attribute__((noreturn));

/* Raises the error for a field `name` that is not in the list of settings. */
void args_unknown(lua_State *L, args_location location, const arc_setting *list, const char *name)
    __attribute__((noreturn));

/* Returns the number on top of the stack; raises an error if it is not finite or out of range. */
double args_number(lua_State *L, args_location location, const arc_setting *setting);

/* Returns the position in `choices` (from 0) of the text at stack index `index`. If the value is
 * nil or none and `otherwise` >= 0, returns `otherwise`. `name` is the field's name in the error
 * message. */
int args_choice(lua_State *L, int index, args_location location, const char *name,
                const char *const *choices, int otherwise);

/* Raises "field 'NAME': expected EXPECTED, got ..." for the value on top of the stack. */
void args_refuse(lua_State *L, args_location location, const char *name, const char *expected)
    __attribute__((noreturn));

/* Pushes field `name` of the table at `index`, or nil if the value is not a table. Returns the Lua
 * type of the pushed value. */
int args_get(lua_State *L, int index, const char *name);

/* Pushes a shallow copy of the table at `index`. Metamethods are not called. */
void args_push_copy(lua_State *L, int index);

/* Returns true if the value at `index` is a table whose field `name` is not nil. */
int args_given(lua_State *L, int index, const char *name);

/* Pushes and returns a number as text with up to 14 digits; integers have no decimal point. */
const char *args_show_number(lua_State *L, double value);

#endif
