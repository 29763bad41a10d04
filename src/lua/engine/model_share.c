/* Models with equal definitions (and equal imported meshes) are built once and shared. A weak
 * table in the registry refers to all existing models. The registry also keeps the most recent
 * model alive. */
#include "lua/base/error.h"
#include "lua/base/interrupt.h"
#include "lua/base/scripts.h"
#include "lua/engine/classes.h"

#include <stdio.h>

static const char cache_key = 0, last_key = 0; /* registry keys; only the addresses are used */

/* --- building and sharing --------------------------------------------------------------------- */

static int add_to_key(void *context, const char *path, const arc_setting *s, const void *def) {
  char text[40];
  (void)path;
  if (s->kind == ARC_TEXT) {
    luaL_addlstring(context, arc_setting_value(s, def), ARC_TEXT_SIZE);
    return 0;
  }
  snprintf(text, sizeof text, "%a ", arc_setting_number(s, def));
  luaL_addstring(context, text);
  const arc_series series = arc_setting_series(s, def);
  if (series.count == 0) return 0;
  luaL_addlstring(context, (const char *)series.distance, (size_t)series.count * sizeof(double));
  luaL_addlstring(context, (const char *)series.value, (size_t)series.count * sizeof(double));
  return 0;
}

static void add_numbers(luaL_Buffer *text, const int *numbers, int count) {
  luaL_addlstring(text, (const char *)&count, sizeof count);
  luaL_addlstring(text, (const char *)numbers, (size_t)count * sizeof *numbers);
}

/* Appends all data of an imported mesh to the key. */
static void add_mesh(luaL_Buffer *text, const arc_mesh *m) {
  luaL_addlstring(text, (const char *)m->xy, 2 * (size_t)m->nodes * sizeof *m->xy);
  add_numbers(text, m->element, 4 * m->elements);
  add_numbers(text, m->surface_node, m->surface);
  add_numbers(text, m->fixed_node, m->fixed);
  if (m->material) add_numbers(text, m->material, m->elements);
  for (int k = 0; k < m->materials; k++)
    luaL_addlstring(text, m->material_name[k], sizeof m->material_name[k]);
}

/* Pushes a key that is unique for a definition and its imported meshes. */
static void push_key(lua_State *L, const arc_model_def *def, arc_mesh *const *given) {
  luaL_Buffer text;
  luaL_buffinit(L, &text);
  arc_settings_walk(arc_model_settings, "", def, add_to_key, &text);
  for (int b = 0; b < ARC_BODIES && given; b++) add_mesh(&text, given[b]);
  luaL_pushresult(&text);
}

/* Pushes the weak table that maps keys to holders. A holder is a hidden box with a shared model.
 * The model boxes of scripts have the holder as a user value, so the holder exists as long as
 * any of these boxes. */
static void push_cache(lua_State *L) {
  if (lua_rawgetp(L, LUA_REGISTRYINDEX, &cache_key) == LUA_TTABLE) return;
  lua_pop(L, 1);
  lua_newtable(L);
  lua_createtable(L, 0, 1);
  lua_pushliteral(L, "v");
  lua_setfield(L, -2, "__mode");
  lua_setmetatable(L, -2);
  lua_pushvalue(L, -1);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &cache_key);
}

/* State of the progress display (archard.lib.build_progress) during a long construction. */
typedef struct building {
  lua_State *L;
  int begun; /* true if the display function is on the stack */
} building;

static void warn(void *context, const char *text) {
  lua_warning(context, text, 0);
}

static void begin_showing(building *b) {
  b->begun = 1;
  if (script_pcall(b->L, "archard.lib.build_progress", 0, 1) == LUA_OK) return;
  lua_pop(b->L, 1);
  lua_pushnil(b->L); /* nil: no progress is displayed */
}

static void tell(building *b, int arguments) {
  if (lua_pcall(b->L, arguments, 0, 0) != LUA_OK) lua_pop(b->L, 1);
}

static void show(void *context, const char *what, double share, double seconds) {
  static const double patience = 1; /* [s] time before progress is displayed */
  building *b = context;
  if (seconds < patience || interrupt_pending(NULL)) return;
  if (!b->begun) begin_showing(b);
  if (lua_isnil(b->L, -1)) return;
  lua_pushvalue(b->L, -1);
  lua_pushstring(b->L, what);
  lua_pushnumber(b->L, share);
  lua_pushnumber(b->L, seconds);
  tell(b, 3);
}

static void end_showing(building *b) {
  if (!b->begun) return;
  if (lua_isnil(b->L, -1))
    lua_pop(b->L, 1);
  else
    tell(b, 0);
}

/* Stores a model in its box, or raises the error of the construction. */
static void end_build(lua_State *L, box *holder, arc_model *model, building *shown,
                      arc_status status, const arc_error *error, const char *where) {
  holder->thing = model;
  end_showing(shown);
  if (status == ARC_STOPPED && interrupt_pending(NULL)) interrupt_raise(L, "building a model");
  error_check(L, status, error, where, -1);
  box_weigh(L, arc_model_bytes(model));
}

/* Pushes a holder with a new model. The model becomes the owner of the imported meshes in `given`
 * (NULL: none). */
static void build_holder(lua_State *L, const arc_model_def *def, arc_mesh **given,
                         const char *where) {
  arc_error error = {0};
  arc_model *model = NULL;
  box *holder = box_push(L, &model_class);
  building shown = {.L = L};
  const arc_callbacks callbacks = {.stop = interrupt_pending, .working = show, .context = &shown};
  arc_model_warn_moduli(def, &(arc_callbacks){.warn = warn, .context = L});
  const arc_status status = given ? arc_model_build_given(def, given, &callbacks, &model, &error)
                                  : arc_model_build_with_callbacks(def, &callbacks, &model, &error);
  end_build(L, holder, model, &shown, status, &error, where);
}

/* Pushes the holder of the model with the definition `def`. The holder is from the cache, or new if
 * the cache does not have it. */
static void push_holder(lua_State *L, const arc_model_def *def, arc_mesh **given,
                        const char *where) {
  push_cache(L);
  push_key(L, def, given);
  lua_pushvalue(L, -1);
  if (lua_rawget(L, -3) != LUA_TUSERDATA) {
    lua_pop(L, 1);
    build_holder(L, def, given, where);
    lua_pushvalue(L, -2);
    lua_pushvalue(L, -2);
    lua_rawset(L, -5);
  }
  lua_replace(L, -3);
  lua_pop(L, 1);
}

arc_model *model_push_given(lua_State *L, const arc_model_def *def, arc_mesh **given,
                            const char *where) {
  luaL_checkstack(L, 10, where);
  push_holder(L, def, given, where);
  int holder = lua_gettop(L);
  lua_pushvalue(L, holder);
  lua_rawsetp(L, LUA_REGISTRYINDEX, &last_key);
  box *made = box_push(L, &model_class);
  made->thing = arc_model_retain(box_test(L, holder, &model_class)->thing);
  box_keep(L, holder);
  lua_remove(L, holder);
  return made->thing;
}

arc_model *model_push(lua_State *L, const arc_model_def *def, const char *where) {
  return model_push_given(L, def, NULL, where);
}

void model_push_living(lua_State *L, arc_model *model) {
  box *made = box_push(L, &model_class);
  made->thing = arc_model_retain(model);
  box_weigh(L, arc_model_bytes(model));
}
