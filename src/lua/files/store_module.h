/* lua/store.h - run files as objects, for the module `archard.store` and for wear.open. */
#ifndef LUA_STORE_H
#define LUA_STORE_H

#include "archard/store.h"
#include "lua/engine/classes.h"

extern const box_class store_class; /* thing: arc_store */

/* Pushes an empty box and opens a file into it. */
arc_store *store_push(lua_State *L, const char *path, arc_store_mode mode, const char *where);

/* The number of a case at `index`; ARC_ARGUMENT where it is none. */
int store_id_argument(lua_State *L, int index, const char *where);

/* Pushes the wear object stored as case `id`; the table at index `given` (0: none) holds the
 * functions of its definition again. */
void store_push_wear(lua_State *L, arc_store *store, int id, int given, const char *where);

/* --- store_values.c: named values as Lua tables --- */

/* Reads the table at `index`, names to numbers, texts, booleans or arrays of numbers, and stores it
 * as the values of a case. */
void store_write_values(lua_State *L, arc_store *store, int id, arc_value_use use, int index,
                        const char *where);
/* Pushes such a table. */
void store_push_values(lua_State *L, arc_store *store, int id, arc_value_use use,
                       const char *where);

/* --- store_run.c: runs --- */
int store_save(lua_State *L);
int store_history(lua_State *L);
int store_surfaces(lua_State *L);
int store_wear(lua_State *L);
int store_note_saved(lua_State *L);

#endif
