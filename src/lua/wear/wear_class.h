/* lua/wear.h - the parts of the class wear among themselves. */
#ifndef LUA_WEAR_H
#define LUA_WEAR_H

#include "lua/engine/classes.h"

/* The run at index 1. */
arc_wear *wear_self(lua_State *L, const char *where);

/* Whether a file holds the run in a box as it stands; and that one does. A box remembers the rows
 * of the history that were there. */
int wear_is_saved(const box *made);
void wear_note_saved(box *made);

/* --- wear_def.c: the definition table --- */

typedef struct wear_request {
  arc_wear_def def;
  double cycles;                        /* in place of a distance; 0: not given */
  double distance_before, cycle_before; /* where the run stands that is changed */
  int own_steps;                        /* scheme or jump were given, or are a run's */
  int own_k;                            /* k or alpha were given, or are a run's */
  int worn;                             /* it starts on worn surfaces */
  int functions;                        /* index of the holder of the user's functions, or of nil */
} wear_request;

/* Reads and checks the table at `index` (or nil); leaves what holds its arrays on the stack. What
 * it does not give stays as the run in the box at index `changed` has it, or at its default (0).
 * The fields model and worn are read by others. */
wear_request wear_request_read(lua_State *L, int index, int changed);

/* The definition on a model: `cycles` become a distance once the radius tells how many strokes a
 * cycle has. */
arc_wear_def wear_request_settle(const wear_request *request, const arc_model_def *model);

/* --- wear_loading.c: the field `loading` --- */

/* Reads it from the table at `index` into the definition, whose load stands where a block gives
 * none. Returns whether there is one; leaves what holds its numbers on the stack. */
int loading_read(lua_State *L, int index, args_place place, arc_wear_def *def);

/* The largest load of all blocks [N]. */
double loading_largest(const arc_wear_def *def);

/* Pushes the list of sampled blocks. */
void loading_push(lua_State *L, const arc_wear_def *def);

/* --- wear_state.c: what a run knows, as fields and in words --- */
extern const luaL_Reg wear_fields[];
int wear_tostring(lua_State *L);

/* --- wear_run.c: methods that go on with a run --- */
int wear_step(lua_State *L);
int wear_run(lua_State *L);

/* --- store_run.c: runs in files --- */
int wear_save(lua_State *L);
int wear_open(lua_State *L);

/* --- wear_goal.c: what ends a run --- */

enum { MOST_GOALS = 16 };

/* The distance, targets and function at which a run ends. */
typedef struct wear_goals {
  double distance; /* [mm] in all */
  arc_wear_target target[MOST_GOALS];
  char name[MOST_GOALS][32]; /* of the targets, "depth.cylinder" */
  size_t count;
  int stop_when; /* index of the function; 0: none */
} wear_goals;

/* Reads them from the table at index 2 (or nil). */
wear_goals wear_goals_read(lua_State *L, const arc_wear *wear);

/* --- wear_profile.c: methods that look at it --- */
int wear_profile(lua_State *L);
int wear_pressure(lua_State *L);
int wear_map(lua_State *L);
int wear_contact(lua_State *L);
int wear_p_average(lua_State *L);
int wear_combined(lua_State *L);
int wear_local_partition(lua_State *L);
int wear_roughness(lua_State *L);
int wear_stability(lua_State *L);
int wear_sensitivity(lua_State *L);
int wear_loop(lua_State *L);

/* --- wear_class.c --- */
/* Pushes the box of the model that the run in the box at `index` lives on now. */
void run_push_model(lua_State *L, int index, const arc_wear *wear);

/* --- wear_record.c: rows of history --- */

/* Pushes a table of the record's columns by name; its text is what the string on top of the stack
 * says, which it replaces. */
void record_push(lua_State *L, const arc_wear_record *record);

/* Pushes one aligned line on a record, and a table of lines on `count` of them. */
void record_push_line(lua_State *L, const arc_wear_record *record);
void record_push_lines(lua_State *L, const arc_wear_record *records, size_t count);

/* Pushes the history as a table of arrays by column name. */
void history_push(lua_State *L, const arc_wear *wear);
void records_push_columns(lua_State *L, const arc_wear_record *records, size_t count);

#endif
