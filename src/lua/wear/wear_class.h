/* lua/wear/wear_class.h - functions shared between the files of the class wear. */
#ifndef LUA_WEAR_H
#define LUA_WEAR_H

#include "lua/engine/classes.h"

typedef struct wear_request {
  arc_wear_def def;
  double cycles; /* end of the run [cycles]; 0: the end is given as a distance */
  double distance_before, cycle_before; /* [mm], [cycles] position at which wear:set is called */
  int own_steps; /* true if the default scheme and jump do not apply: the user set one of them, or
                    wear:set changes other settings of the run */
  int own_k;     /* true if the coefficients of the bodies do not apply: the user set k or alpha, or
                    wear:set changes the run */
  int worn;      /* true if the run starts on worn surfaces */
  int functions; /* stack index of the holder of the user's functions, or of nil */
} wear_request;

enum { MOST_GOALS = 16 };

/* End conditions of a run: distance, target values and a function. */
typedef struct wear_goals {
  double distance; /* [mm] total distance */
  arc_wear_target target[MOST_GOALS];
  char name[MOST_GOALS][32]; /* name of each target, such as "depth.cylinder" */
  size_t count;
  int stop_when; /* stack index of the user's function; 0: none */
} wear_goals;

/* --- wear_class.c ----------------------------------------------------------------------------- */

/* Returns the run at index 1. */
arc_wear *wear_self(lua_State *L, const char *where);

/* wear_is_saved returns true if the present state of the run is saved in a file. wear_note_saved
 * marks the present state as saved. Both use the number of saved rows of the history, which is
 * stored in the box. */
int wear_is_saved(const box *made);
void wear_note_saved(box *made);

/* Pushes the box of the present model of the run in the box at `index`. */
void run_push_model(lua_State *L, int index, const arc_wear *wear);

/* --- wear_def.c: the definition table --------------------------------------------------------- */

/* Reads and checks the definition table at `index` (or nil), except the fields model and worn.
 * Settings that are not in the table have the values of the run in the box at index `changed`,
 * or the defaults if `changed` is 0. Buffers of arrays stay on the stack. */
wear_request wear_request_read(lua_State *L, int index, int changed);

/* Returns the definition of a requested run. Values not set by the user are derived from the model,
 * and `cycles` is converted to a distance. */
arc_wear_def wear_request_settle(const wear_request *request, const arc_model_def *model);

/* --- wear_loading.c: the field `loading` ------------------------------------------------------ */

/* Reads the field `loading` of the table at `index` into the definition. A block without a load
 * gets def->load. Returns false if the field is nil or false. Buffers stay on the stack. */
int loading_read(lua_State *L, int index, args_location location, arc_wear_def *def);

/* Returns the largest load of all blocks [N]. */
double loading_largest(const arc_wear_def *def);

/* Pushes the list of blocks with their sampled values. */
void loading_push(lua_State *L, const arc_wear_def *def);

/* --- wear_print.c: printed summary of a run --------------------------------------------------- */

int wear_tostring(lua_State *L);

/* --- wear_run.c: methods that advance a run --------------------------------------------------- */

int wear_step(lua_State *L);
int wear_run(lua_State *L);

/* --- files/store_run.c: runs in files --------------------------------------------------------- */

int wear_save(lua_State *L);
int wear_open(lua_State *L);

/* --- wear_goal.c: end conditions of a run ----------------------------------------------------- */

/* Reads the end conditions from the table at index 2 (or nil). */
wear_goals wear_goals_read(lua_State *L, const arc_wear *wear);

/* --- wear_profile.c: profiles, maps and other results ----------------------------------------- */

int wear_profile(lua_State *L);
int wear_pressure(lua_State *L);
int wear_map(lua_State *L);
int wear_surfaces(lua_State *L);
int wear_contact(lua_State *L);
int wear_p_average(lua_State *L);
int wear_combined(lua_State *L);
int wear_local_partition(lua_State *L);
int wear_roughness(lua_State *L);
int wear_stability(lua_State *L);

/* --- wear_scripted.c -------------------------------------------------------------------------- */

int wear_sensitivity(lua_State *L);

/* --- wear_state.c: fields of a run ------------------------------------------------------------ */

extern const luaL_Reg wear_fields[];
int wear_loop(lua_State *L);

/* --- wear_record.c: rows of history ----------------------------------------------------------- */

/* Replaces the text on top of the stack by a table of the record's columns by name. __tostring of
 * the table returns the text. */
void record_push(lua_State *L, const arc_wear_record *record);

/* record_push_line pushes a record as one line of text. record_push_lines pushes `count` records
 * as a text table of aligned lines with a header. */
void record_push_line(lua_State *L, const arc_wear_record *record);
void record_push_lines(lua_State *L, const arc_wear_record *records, size_t count);

/* history_push pushes the history of a run, records_push_columns pushes `count` records. The result
 * is a table of arrays by column name. */
void history_push(lua_State *L, const arc_wear *wear);
void records_push_columns(lua_State *L, const arc_wear_record *records, size_t count);

#endif
