/* Boxes: metatables made on first use, reading of methods and fields, closing. */
#include "lua/base/box.h"
#include "lua/base/error.h"
#include "lua/base/settings.h"
#include "lua/base/strict.h"

#include <stdalign.h>
#include <stdint.h>
#include <string.h>

static const box_class *class_upvalue(lua_State *L) {
  return lua_touserdata(L, lua_upvalueindex(1));
}

/* Refuses the unknown name at index 2 where the user reads it; upvalue 4: all names. */
static int unknown_field(lua_State *L) {
  if (lua_type(L, 2) == LUA_TSTRING && strict_reads(L))
    strict_refuse(L, class_upvalue(L)->name, lua_tostring(L, 2), lua_upvalueindex(4));
  return 0;
}

/* Returns the value at index 3. Tables of values are told apart by their field: "wear.depth". */
static int guarded(lua_State *L) {
  if (!lua_istable(L, 3) || lua_getmetatable(L, 3)) return lua_settop(L, 3), 1;
  const char *where = lua_pushfstring(L, "%s.%s", class_upvalue(L)->name, lua_tostring(L, 2));
  lua_pushvalue(L, 3);
  strict_table(L, where);
  return 1;
}

/* A setting that the class shows, by the name at index 2. */
static int push_setting(lua_State *L) {
  const box_class *class = class_upvalue(L);
  const arc_setting *setting = class->settings && lua_type(L, 2) == LUA_TSTRING
                                   ? arc_setting_find(class->settings, lua_tostring(L, 2))
                                   : NULL;
  if (!setting || setting->kind == ARC_OTHER) return unknown_field(L);
  settings_push(L, setting, class->definition(L));
  return guarded(L);
}

/* __index(object, name): a method, the value of a computed field or of a setting. Upvalues: class,
 * methods, fields, names of all. */
static int class_index(lua_State *L) {
  lua_settop(L, 2);
  lua_pushvalue(L, 2);
  if (lua_rawget(L, lua_upvalueindex(2)) != LUA_TNIL) return 1;
  lua_settop(L, 2);
  lua_pushvalue(L, 2);
  if (lua_rawget(L, lua_upvalueindex(3)) == LUA_TNIL) return lua_settop(L, 2), push_setting(L);
  lua_pushvalue(L, 1);
  lua_call(L, 1, 1);
  return guarded(L);
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

/* __gc and __close: whatever came is a box of this class, unless a script plays with metatables. */
static int class_gc(lua_State *L) {
  const box_class *class = class_upvalue(L);
  box *self = box_test(L, 1, class);
  if (self && !self->busy) box_empty(self, class);
  return 0;
}

/* object:close(): may be called twice. */
static int class_close(lua_State *L) {
  const box_class *class = class_upvalue(L);
  box *self = box_test(L, 1, class);
  if (!self) error_raise(L, ARC_ARGUMENT, class->name, "close is called as object:close()");
  if (self->busy)
    error_raise(L, ARC_ARGUMENT, class->name, "a running %s cannot be closed", class->name);
  box_empty(self, class);
  lua_pushnil(L);
  lua_setiuservalue(L, 1, 1);
  lua_pushnil(L);
  lua_setiuservalue(L, 1, 2);
  return 0;
}

static int class_tostring(lua_State *L) {
  const box_class *class = class_upvalue(L);
  box *self = box_test(L, 1, class);
  if (self && self->thing) return class->tostring(L);
  lua_pushfstring(L, "%s (closed)", class->name);
  return 1;
}

/* Two boxes of one thing, as the models that are shared, are equal. */
static int class_eq(lua_State *L) {
  const box_class *class = class_upvalue(L);
  const box *a = box_test(L, 1, class), *b = box_test(L, 2, class);
  lua_pushboolean(L, a && b && a->thing && a->thing == b->thing && a->tag == b->tag);
  return 1;
}

/* Sets field `name` of the table on top to a function that knows its class. */
static void set_function(lua_State *L, const char *name, const box_class *class,
                         lua_CFunction function) {
  lua_pushlightuserdata(L, (void *)(uintptr_t) class);
  lua_pushcclosure(L, function, 1);
  lua_setfield(L, -2, name);
}

static void push_methods(lua_State *L, const box_class *class) {
  lua_newtable(L);
  if (class->methods) luaL_setfuncs(L, class->methods, 0);
  if (class->destroy) set_function(L, "close", class, class_close);
}

/* The list of the names of the computed fields. */
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

/* The names of methods too. */
static void push_names(lua_State *L, const box_class *class) {
  push_field_names(L, class);
  for (const luaL_Reg *method = class->methods; method && method->name; method++) {
    lua_pushstring(L, method->name);
    lua_rawseti(L, -2, (lua_Integer)lua_rawlen(L, -2) + 1);
  }
}

/* Fills the new metatable on top of the stack. */
static void fill_metatable(lua_State *L, const box_class *class) {
  lua_pushstring(L, class->name);
  lua_setfield(L, -2, "__name");
  push_field_names(L, class);
  lua_setfield(L, -2, "__fields");
  push_methods(L, class);
  lua_pushvalue(L, -1);
  lua_setfield(L, -3, "__methods");
  lua_pushlightuserdata(L, (void *)(uintptr_t) class);
  lua_insert(L, -2);
  lua_newtable(L);
  if (class->fields) luaL_setfuncs(L, class->fields, 0);
  push_names(L, class);
  lua_pushcclosure(L, class_index, 4);
  lua_setfield(L, -2, "__index");
  set_function(L, "__newindex", class, class_newindex);
  set_function(L, "__tostring", class, class_tostring);
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
  lua_pushfstring(L, "archard.%s", class->name); /* where help looks for a method's owner */
  lua_pushvalue(L, -2);
  lua_rawset(L, LUA_REGISTRYINDEX);
}

box *box_push(lua_State *L, const box_class *class) {
  luaL_checkstack(L, 6, class->name);
  size_t unit = alignof(max_align_t);
  size_t head = (sizeof(box) + unit - 1) / unit * unit;
  box *made = lua_newuserdatauv(L, head + class->value, 2);
  memset(made, 0, head + class->value);
  if (class->value) made->thing = (char *)made + head;
  push_metatable(L, class);
  lua_setmetatable(L, -2);
  return made;
}

box *box_test(lua_State *L, int index, const box_class *class) {
  box *found = lua_touserdata(L, index);
  if (!found || lua_islightuserdata(L, index) || !lua_getmetatable(L, index)) return NULL;
  lua_rawgetp(L, LUA_REGISTRYINDEX, class);
  if (!lua_rawequal(L, -1, -2)) found = NULL;
  lua_pop(L, 2);
  return found;
}

/* What kind of value stands at `index`, in one word. */
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

static box *check_full(lua_State *L, box *found, const box_class *class, const char *where) {
  if (!found->thing)
    error_raise(L, ARC_ARGUMENT, where, "this %s object has been closed", class->name);
  return found;
}

box *box_check(lua_State *L, int index, const box_class *class, const char *where) {
  box *found = box_test(L, index, class);
  if (!found) refuse(L, index, class, where, "");
  return check_full(L, found, class, where);
}

box *box_self(lua_State *L, const box_class *class, const char *where) {
  box *found = box_test(L, 1, class);
  if (!found) refuse(L, 1, class, where, "; methods are called with a colon, as object:method()");
  return check_full(L, found, class, where);
}

box *box_self_idle(lua_State *L, const box_class *class, const char *where) {
  box *self = box_self(L, class, where);
  if (self->busy)
    error_raise(L, ARC_ARGUMENT, where, "this %s object is running already", class->name);
  return self;
}

void box_keep(lua_State *L, int parent) {
  lua_pushvalue(L, parent);
  lua_setiuservalue(L, -2, 1);
}

int box_copy_value(lua_State *L, int index, const char *class_name, void *value) {
  const box *found = lua_touserdata(L, index);
  if (lua_type(L, index) != LUA_TUSERDATA || !lua_getmetatable(L, index)) return 0;
  lua_pushfstring(L, "archard.%s", class_name);
  lua_rawget(L, LUA_REGISTRYINDEX);
  const int same = lua_rawequal(L, -1, -2);
  lua_pop(L, 2);
  if (same) {
    const size_t head = (size_t)((const char *)found->thing - (const char *)found);
    memcpy(value, found->thing, lua_rawlen(L, index) - head);
  }
  return same;
}

void box_weigh(lua_State *L, size_t bytes) {
  size_t kilobytes = bytes / 1024;
  if (kilobytes > 0 && lua_gc(L, LUA_GCISRUNNING))
    lua_gc(L, LUA_GCSTEP, kilobytes > 1000000 ? 1000000 : (int)kilobytes);
}
