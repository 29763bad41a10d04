/* lua/files/store_module.h - run files as Lua objects, for the module `archard.store` and the
 * function wear.open. */
#ifndef LUA_STORE_H
#define LUA_STORE_H

#include "archard/store.h"
#include "lua/engine/classes.h"

extern const box_class store_class; /* box of an arc_store */

/* --- store_module.c --------------------------------------------------------------------------- */

/* Pushes a new box with an open run file. */
arc_store *store_push(lua_State *L, const char *path, arc_store_mode mode, const char *where);

/* Returns the case number at `index`. Errors: ARC_ARGUMENT if the value is not a case number. */
int store_id_argument(lua_State *L, int index, const char *where);

/* --- store_run.c: runs ------------------------------------------------------------------------ */

/* Pushes the wear object stored as case `id`. A file cannot store functions; therefore the table at
 * index `given` (0: none) contains the settings of the run that are functions. */
void store_push_wear(lua_State *L, arc_store *store, int id, int given, const char *where);

int store_save(lua_State *L);
int store_history(lua_State *L);
int store_surfaces(lua_State *L);
int store_wear(lua_State *L);
int store_note_saved(lua_State *L);

/* --- store_values.c: named values as Lua tables ----------------------------------------------- */

/* Stores the table at `index` as values of a case. The table maps names to numbers, texts, booleans
 * or arrays of numbers. */
void store_write_values(lua_State *L, arc_store *store, int id, arc_value_use use, int index,
                        const char *where);
/* Pushes the values of a case as a table. */
void store_push_values(lua_State *L, arc_store *store, int id, arc_value_use use,
                       const char *where);

#endif
