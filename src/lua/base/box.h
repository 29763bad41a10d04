/* lua/box.h - userdata that hold one thing of the engine.
 *
 * The order in every constructor: check all arguments, push the box empty, call the engine, fill
 * the box; so that whatever fails, nothing is lost. A box is emptied by close(), by a
 * to-be-closed variable or by the collector, whichever comes first.
 *
 * The metatable of a class holds, for completion and help: __name, __methods (table of functions)
 * and __fields (list of the names of the computed fields).
 */
#ifndef LUA_BOX_H
#define LUA_BOX_H

#include "archard/setting.h"
#include "lua/base/call.h"

#include <lauxlib.h>
#include <lua.h>
#include <stddef.h>

/* A class. Things with a `destroy` get :close() and may be emptied. Where `value` tells a size the
 * thing lives inside the box, and `destroy` ends what it holds alone; things without a `destroy`
 * do. */
typedef struct box_class {
  const char *name;             /* as the user writes it, "wear" */
  const luaL_Reg *methods;      /* called as object:method(...); may be NULL */
  const luaL_Reg *fields;       /* called with the object alone, each pushes the field's value */
  lua_CFunction tostring;       /* a few readable lines */
  void (*destroy)(void *thing); /* NULL: the thing holds nothing */
  size_t value;                 /* [bytes] of the thing; 0: it lives elsewhere */
  const arc_setting *settings;  /* fields too, unless one above has the name; may be NULL */
  const void *(*definition)(lua_State *L); /* of the object at index 1 */
  const char *setter; /* how to change a field instead, "w:set{ ... }"; NULL: not at all */
} box_class;

typedef struct box {
  const box_class *class;
  const void *metatable; /* of the class, which the registry keeps */
  void *thing;           /* NULL: empty */
  int tag;               /* the class' own use */
  int busy;              /* the engine changes it: may be neither closed nor entered again */
  int closing; /* closed for all but the functions that hold it; the last of them empties it */
  call_held held;
} box;

/* Pushes an empty box with two user values (a parent to keep alive; the class' own use). Where the
 * thing lives inside, `thing` is that, zeroed. */
box *box_push(lua_State *L, const box_class *class);

/* The box at `index`, or NULL if it is anything else. */
box *box_test(lua_State *L, int index, const box_class *class);

/* Copies the value in the box at `index` where that is of the class with this name and holds a
 * value; returns whether it did. */
int box_copy_value(lua_State *L, int index, const char *class_name, void *value);

/* The box at `index` of the stack, full, held until the function that runs returns (call.h). Raises
 * an error that names `where` for anything else. */
box *box_check(lua_State *L, int index, const box_class *class, const char *where);

/* box_check for the object of a method or field, at index 1, with a word on how to call those; and
 * for methods that change it, which a box that is busy or held by another function refuses. */
box *box_self(lua_State *L, const box_class *class, const char *where);
box *box_self_idle(lua_State *L, const box_class *class, const char *where);

/* Empties a box, e.g. a temporary one; busy or not. */
void box_empty(box *emptied, const box_class *class);

/* Makes the value at index `parent` the user value of the box on top of the stack. */
void box_keep(lua_State *L, int parent);

/* Tells the collector that something of `bytes` has come into being outside its sight. */
void box_weigh(lua_State *L, size_t bytes);

#endif
