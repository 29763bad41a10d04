/* lua/base/box.h - boxes. A box is a userdata that owns one object of the engine, the `thing`.
 *
 * Every constructor checks all arguments, pushes an empty box, calls the engine and then fills the
 * box, so that an error leaks nothing. close(), a to-be-closed variable or the garbage collector
 * empties a box.
 *
 * Completion and help read three fields of a class's metatable: __name, __methods (table of
 * functions) and __fields (list of the field names). */
#ifndef LUA_BOX_H
#define LUA_BOX_H

#include "archard/setting.h"
#include "lua/base/call.h"

#include <lauxlib.h>
#include <lua.h>
#include <stddef.h>

/* A class of boxes. If `destroy` is set, the objects of the class have the method close(). If
 * `value` > 0, the thing is stored inside the box, and `destroy` frees only the memory that the
 * thing owns. A class without `destroy` must set `value`. */
typedef struct box_class {
  const char *name;        /* name for the user, such as "wear" */
  const luaL_Reg *methods; /* methods, called as object:method(...); may be NULL */
  /* functions that push the value of a field; the only argument is the object; may be NULL */
  const luaL_Reg *fields;
  lua_CFunction tostring;       /* pushes a description of the object, a few lines of text */
  void (*destroy)(void *thing); /* frees the object; NULL if there is nothing to free */
  size_t value; /* [bytes] size of a thing that is stored inside the box; 0: the thing is stored
                   elsewhere */
  const arc_setting *settings; /* settings that scripts can also read as fields; may be NULL. If a
                                  name is in both lists, the function in `fields` is used. */
  const void *(*definition)(lua_State *L); /* returns the definition of the object at index 1 */
  /* method that changes settings, as written in messages, such as "w:set{ ... }"; NULL: fields are
   * read-only */
  const char *setter;
} box_class;

typedef struct box {
  const box_class *class;
  const void *metatable; /* metatable of the class, kept alive by the registry */
  void *thing;           /* the object of the engine; NULL: the box is empty */
  int tag;               /* number whose meaning depends on the class */
  int busy;    /* true while the engine changes the thing; other calls then raise an error */
  int closing; /* true if close() was called while functions used the box; the last of these
                  functions empties the box */
  call_held held;
} box;

/* Pushes an empty box with two user values: a parent object that the box keeps alive, and a value
 * whose meaning the class defines. If the class stores the thing inside the box, `thing` points to
 * zeroed memory. */
box *box_push(lua_State *L, const box_class *class);

/* Returns the box at `index`, or NULL if the value is not a box of this class. */
box *box_test(lua_State *L, int index, const box_class *class);

/* If the box at `index` has the class `class_name`, copies the value in the box to `value` and
 * returns true. Otherwise returns false. */
int box_copy_value(lua_State *L, int index, const char *class_name, void *value);

/* Returns the box at `index` and marks it as used until the running function returns (call.h). If
 * the value is not a box of this class, or the box is empty, raises an error that names the
 * function `where`. */
box *box_check(lua_State *L, int index, const box_class *class, const char *where);

/* box_self applies box_check to index 1, the object of a method or field. The error of box_self
 * explains how methods are called. box_self_idle is for methods that change the object: it also
 * raises an error if the box is busy or in use by another function. */
box *box_self(lua_State *L, const box_class *class, const char *where);
box *box_self_idle(lua_State *L, const box_class *class, const char *where);

/* Destroys the object in a temporary box and empties the box, even if the box is busy. */
void box_empty(box *emptied, const box_class *class);

/* Stores the value at index `parent` as user value 1 of the box on top of the stack. */
void box_keep(lua_State *L, int parent);

/* Reports `bytes` of memory allocated outside Lua to the garbage collector. */
void box_weigh(lua_State *L, size_t bytes);

#endif
