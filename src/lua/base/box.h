/* lua/box.h - userdata that own one object of the engine ("thing").
 *
 * Every constructor checks all arguments, pushes an empty box, calls the engine and then fills the
 * box, so that an error leaks nothing. close(), a to-be-closed variable or the garbage collector
 * empties a box.
 *
 * Completion and help read three fields of a class's metatable: __name, __methods (table of
 * functions) and __fields (list of the names of the computed fields).
 */
#ifndef LUA_BOX_H
#define LUA_BOX_H

#include "archard/setting.h"
#include "lua/base/call.h"

#include <lauxlib.h>
#include <lua.h>
#include <stddef.h>

/* A class. With `destroy`, its objects have :close(). If `value` > 0 the thing is stored inside the
 * box, and `destroy` frees only the memory that the thing owns; a class without `destroy` must set
 * `value`. */
typedef struct box_class {
  const char *name;        /* name for the user: "wear" */
  const luaL_Reg *methods; /* called as object:method(...); may be NULL */
  /* called with the object as the only argument; each pushes the field's value */
  const luaL_Reg *fields;
  lua_CFunction tostring;       /* pushes a description of a few lines */
  void (*destroy)(void *thing); /* NULL: nothing to free */
  size_t value; /* [bytes] size of the thing stored in the box; 0: stored elsewhere */
  const arc_setting *settings; /* readable as fields, after those in `fields`; may be NULL */
  const void *(*definition)(lua_State *L); /* of the object at index 1 */
  /* method that changes fields, for messages: "w:set{ ... }"; NULL: read-only */
  const char *setter;
} box_class;

typedef struct box {
  const box_class *class;
  const void *metatable; /* metatable of the class; the registry keeps it alive */
  void *thing;           /* NULL: empty */
  int tag;               /* for use by the class */
  int busy;              /* the engine is changing the thing: no close, no second call */
  int closing; /* close() was called while functions hold the box; the last of them empties it */
  call_held held;
} box;

/* Pushes an empty box with two user values (a parent to keep alive; one for use by the class). If
 * the thing is stored inside, `thing` points to zeroed memory. */
box *box_push(lua_State *L, const box_class *class);

/* The box of this class at `index`, or NULL. */
box *box_test(lua_State *L, int index, const box_class *class);

/* Copies the value of the box at `index` to `value` if the box is of the class `class_name`;
 * returns true if so. */
int box_copy_value(lua_State *L, int index, const char *class_name, void *value);

/* The box at `index`, which must not be empty; it is held until the running function returns
 * (call.h). Otherwise raises an error with the function's name `where`. */
box *box_check(lua_State *L, int index, const box_class *class, const char *where);

/* box_check for the object of a method or field, at index 1; the error explains how to call a
 * method. box_self_idle is for methods that change the object: it also raises an error if the box
 * is busy or another function holds it. */
box *box_self(lua_State *L, const box_class *class, const char *where);
box *box_self_idle(lua_State *L, const box_class *class, const char *where);

/* Empties a box, e.g. a temporary one, even if it is busy. */
void box_empty(box *emptied, const box_class *class);

/* Stores the value at index `parent` as user value 1 of the box on top of the stack. */
void box_keep(lua_State *L, int parent);

/* Informs the garbage collector of `bytes` allocated outside Lua. */
void box_weigh(lua_State *L, size_t bytes);

#endif
