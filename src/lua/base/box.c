/* Implements boxes (lua/base/box.h): metatables, methods, fields and close(). */
#include "lua/base/box.h"
#include "lua/base/call.h"
#include "lua/base/error.h"
#include "lua/base/settings.h"
#include "lua/base/strict.h"

#include <stdalign.h>
#include <stdint.h>
#include <string.h>

static const char class_key[] = "archard.class %s"; /* format of the registry keys of classes */

static const box_class *class_upvalue(lua_State *L) {
  return lua_touserdata(L, lua_upvalueindex(1));
}

/* If the user's code reads the unknown name at index 2, raises an error. In built-in scripts and C
 * functions the name is nil, so that they can test for fields. Upvalue 4: list of valid names. */
static int unknown_field(lua_State *L) {
  if (lua_type(L, 2) == LUA_TSTRING && strict_reads(L))
    strict_refuse(L, class_upvalue(L)->name, lua_tostring(L, 2), lua_upvalueindex(4));
  return 0;
}

/* Returns the value at index 3. A table without a metatable becomes strict with the name
 * "CLASS.FIELD": reading an unknown field of the table is then an error. */
static int guarded(lua_State *L) {
  if (!lua_istable(L, 3)) return 1;
  if (lua_getmetatable(L, 3)) return lua_settop(L, 3), 1;
  const char *where = lua_pushfstring(L, "%s.%s", class_upvalue(L)->name, lua_tostring(L, 2));
  lua_pushvalue(L, 3);
  strict_table(L, where);
  return 1;
}

/* Pushes the value of a setting of the object at index 1. Upvalues: class, setting. */
static int setting_field(lua_State *L) {
  const arc_setting *setting = lua_touserdata(L, lua_upvalueindex(2));
  settings_push(L, setting, class_upvalue(L)->definition(L));
  return 1;
}

/* Metamethod __index(object, name): returns the value of a field, or a method. Upvalues: class,
 * methods, fields, all names. */
static int class_index(lua_State *L) {
  lua_settop(L, 2);
  lua_pushvalue(L, 2);
  if (lua_rawget(L, lua_upvalueindex(3)) != LUA_TNIL) {
    lua_pushvalue(L, 1);
    call_now(L, 1, 1);
    return guarded(L);
  }
  lua_settop(L, 2);
  lua_pushvalue(L, 2);
  return lua_rawget(L, lua_upvalueindex(2)) != LUA_TNIL ? 1 : unknown_field(L);
}

static int class_newindex(lua_State *L) {
  const box_class *class = class_upvalue(L);
  const char *name = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : luaL_typename(L, 2);
  error_raise(L, ARC_ARGUMENT, class->name, "field '%s' cannot be set: the object is read-only%s%s",
              name, class->setter ? "; change it by " : "", class->setter ? class->setter : "");
}

void box_empty(box *emptied, const box_class *class) {
  void *thing = emptied->thing;
  emptied->thing = NULL;
  if (thing && class->destroy) class->destroy(thing);
}

static void close_box(box *self) {
  if (self->held.count > 0)
    self->closing = 1;
  else
    box_empty(self, self->class);
}

static void last_use(call_held *held) {
  box *self = (box *)(void *)((char *)held - offsetof(box, held));
  if (self->closing && !self->busy) box_empty(self, self->class);
}

/* Metamethods __gc and __close: destroy the object. They ignore values that are not boxes of this
 * class, because a script may have set the metatable on another value. */
static int class_gc(lua_State *L) {
  const box_class *class = class_upvalue(L);
  box *self = box_test(L, 1, class);
  if (self && !self->busy) close_box(self);
  return 0;
}

/* Lua method object:close(). A second call of the method has no effect. */
static int class_close(lua_State *L) {
  const box_class *class = class_upvalue(L);
  box *self = box_test(L, 1, class);
  if (!self)
    error_raise(L, ARC_ARGUMENT, class->name, "call this method with a colon: object:close()");
  if (self->busy)
    error_raise(L, ARC_ARGUMENT, class->name, "a %s object cannot be closed while it is running",
                class->name);
  close_box(self);
  if (self->closing) return 0;
  lua_pushnil(L);
  lua_setiuservalue(L, 1, 1);
  lua_pushnil(L);
  lua_setiuservalue(L, 1, 2);
  return 0;
}

static int class_tostring(lua_State *L) {
  const box_class *class = class_upvalue(L);
  const box *self = box_test(L, 1, class);
  if (self && self->thing && !self->closing) return class->tostring(L);
  lua_pushfstring(L, "%s (closed)", class->name);
  return 1;
}

/* Two boxes are equal if they contain the same object of the engine, such as a shared model. */
static int class_eq(lua_State *L) {
  const box_class *class = class_upvalue(L);
  const box *a = box_test(L, 1, class), *b = box_test(L, 2, class);
  lua_pushboolean(L, a && b && a->thing && a->thing == b->thing && a->tag == b->tag);
  return 1;
}

/* Pushes a pointer as light userdata. The cast removes const, which is safe because the object at
 * the pointer is only read. */
static void push_pointer(lua_State *L, const void *pointer) {
  lua_pushlightuserdata(L, (void *)(uintptr_t)pointer);
}

/* Sets field `name` of the table on top of the stack to a C function with the class as upvalue. */
static void set_function(lua_State *L, const char *name, const box_class *class,
                         lua_CFunction function) {
  push_pointer(L, class);
  lua_pushcclosure(L, function, 1);
  lua_setfield(L, -2, name);
}

static void push_methods(lua_State *L, const box_class *class) {
  lua_newtable(L);
  if (class->methods) call_set_functions(L, class->methods);
  if (class->destroy) set_function(L, "close", class, class_close);
}

/* Pushes a table that maps the name of each field to the function that reads the field. A
 * computed field replaces the setting with the same name. */
static void push_readers(lua_State *L, const box_class *class) {
  lua_newtable(L);
  for (const arc_setting *s = class->settings; s && s->name; s++) {
    if (s->kind == ARC_OTHER) continue;
    push_pointer(L, class);
    push_pointer(L, s);
    lua_pushcclosure(L, setting_field, 2);
    lua_setfield(L, -2, s->name);
  }
  if (class->fields) luaL_setfuncs(L, class->fields, 0);
}

/* Pushes the list of all field names. */
static void push_field_names(lua_State *L, const box_class *class) {
  lua_newtable(L);
  int count = 0;
  for (const luaL_Reg *field = class->fields; field && field->name; field++) {
    lua_pushstring(L, field->name);
    lua_rawseti(L, -2, ++count);
  }
  for (const arc_setting *s = class->settings; s && s->name; s++) {
    if (s->kind == ARC_OTHER) continue;
    lua_pushstring(L, s->name);
    lua_rawseti(L, -2, ++count);
  }
}

/* Pushes the list of all field and method names. */
static void push_names(lua_State *L, const box_class *class) {
  push_field_names(L, class);
  for (const luaL_Reg *method = class->methods; method && method->name; method++) {
    lua_pushstring(L, method->name);
    lua_rawseti(L, -2, (lua_Integer)lua_rawlen(L, -2) + 1);
  }
}

/* Fills the new metatable on top of the stack for objects of the class. */
static void fill_metatable(lua_State *L, const box_class *class) {
  lua_pushstring(L, class->name);
  lua_setfield(L, -2, "__name");
  push_field_names(L, class);
  lua_setfield(L, -2, "__fields");
  push_methods(L, class);
  lua_pushvalue(L, -1);
  lua_setfield(L, -3, "__methods");
  push_pointer(L, class);
  lua_insert(L, -2);
  push_readers(L, class);
  push_names(L, class);
  lua_pushcclosure(L, class_index, 4);
  lua_setfield(L, -2, "__index");
  set_function(L, "__newindex", class, class_newindex);
  push_pointer(L, class);
  lua_pushcclosure(L, class_tostring, 1);
  call_wrap(L);
  lua_pushcclosure(L, error_plain_result, 1);
  lua_setfield(L, -2, "__tostring");
  set_function(L, "__eq", class, class_eq);
  if (class->destroy) {
    set_function(L, "__gc", class, class_gc);
    set_function(L, "__close", class, class_gc);
  }
}

static void push_metatable(lua_State *L, const box_class *class) {
  if (lua_rawgetp(L, LUA_REGISTRYINDEX, class) == LUA_TTABLE) return;
  lua_pop(L, 1);
  lua_newtable(L);
  fill_metatable(L, class);
  lua_pushvalue(L, -1);
  lua_rawsetp(L, LUA_REGISTRYINDEX, class);
  lua_pushfstring(L, "archard.%s", class->name); /* registry key of the metatable, for help */
  lua_pushvalue(L, -2);
  lua_rawset(L, LUA_REGISTRYINDEX);
  lua_pushfstring(L, class_key, class->name);
  push_pointer(L, class);
  lua_rawset(L, LUA_REGISTRYINDEX);
}

box *box_push(lua_State *L, const box_class *class) {
  luaL_checkstack(L, 12, class->name);
  size_t unit = alignof(max_align_t);
  size_t head = (sizeof(box) + unit - 1) / unit * unit;
  box *made = lua_newuserdatauv(L, head + class->value, 2);
  memset(made, 0, head + class->value);
  made->class = class;
  made->held.last = last_use;
  if (class->value) made->thing = (char *)made + head;
  push_metatable(L, class);
  made->metatable = lua_topointer(L, -1);
  lua_setmetatable(L, -2);
  return made;
}

/* Checks the class and the metatable, because a script may have set the metatable of a box on
 * another userdata. */
box *box_test(lua_State *L, int index, const box_class *class) {
  box *found = lua_touserdata(L, index);
  if (!found || lua_rawlen(L, index) < sizeof *found || found->class != class ||
      !lua_getmetatable(L, index))
    return NULL;
  const int same = lua_topointer(L, -1) == found->metatable;
  lua_pop(L, 1);
  return same ? found : NULL;
}

/* Returns the type name of the value at `index`: the __name of its metatable if there is one,
 * otherwise the Lua type. */
static const char *kind_of(lua_State *L, int index) {
  int type = luaL_getmetafield(L, index, "__name");
  if (type == LUA_TSTRING) return lua_tostring(L, -1);
  return luaL_typename(L, index);
}

__attribute__((noreturn)) static void refuse(lua_State *L, int index, const box_class *class,
                                             const char *where, const char *hint) {
  error_raise(L, ARC_ARGUMENT, where, "expected a %s object, got %s%s", class->name,
              kind_of(L, index), hint);
}

static box *hold_full(lua_State *L, int index, box *found, const char *where) {
  if (!found->thing || found->closing)
    error_raise(L, ARC_ARGUMENT, where, "this %s object has been closed", found->class->name);
  call_hold(L, index, &found->held);
  return found;
}

box *box_check(lua_State *L, int index, const box_class *class, const char *where) {
  box *found = box_test(L, index, class);
  if (!found) refuse(L, index, class, where, "");
  return hold_full(L, index, found, where);
}

box *box_self(lua_State *L, const box_class *class, const char *where) {
  box *found = box_test(L, 1, class);
  if (!found) refuse(L, 1, class, where, "; methods are called with a colon, as object:method()");
  return hold_full(L, 1, found, where);
}

box *box_self_idle(lua_State *L, const box_class *class, const char *where) {
  box *self = box_self(L, class, where);
  if (self->busy)
    error_raise(L, ARC_ARGUMENT, where, "this %s object is already running", class->name);
  if (call_is_held_outside(&self->held))
    error_raise(L, ARC_ARGUMENT, where, "this %s object is in use and cannot change", class->name);
  return self;
}

void box_keep(lua_State *L, int parent) {
  lua_pushvalue(L, parent);
  lua_setiuservalue(L, -2, 1);
}

int box_copy_value(lua_State *L, int index, const char *class_name, void *value) {
  index = lua_absindex(L, index);
  lua_pushfstring(L, class_key, class_name);
  lua_rawget(L, LUA_REGISTRYINDEX);
  const box_class *class = lua_touserdata(L, -1);
  lua_pop(L, 1);
  const box *found = class ? box_test(L, index, class) : NULL;
  if (found) memcpy(value, found->thing, class->value);
  return found != NULL;
}

void box_weigh(lua_State *L, size_t bytes) {
  size_t kilobytes = bytes / 1024;
  if (kilobytes > 0 && lua_gc(L, LUA_GCISRUNNING))
    lua_gc(L, LUA_GCSTEP, kilobytes > 1000000 ? 1000000 : (int)kilobytes);
}
