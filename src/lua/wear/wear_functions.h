/* lua/wear_functions.h - the user's functions in the definition of a run: k, alpha, jump and
 * local_factor.
 *
 * A holder (a userdata) keeps them; runs have it as their second user value, a clone shares that of
 * its original. The engine gets the holder's memory as context. Every call of the engine that may
 * ask a function stands between functions_enter and functions_leave: what a function raises is kept
 * until the engine has unwound, then raised again.
 */
#ifndef LUA_WEAR_FUNCTIONS_H
#define LUA_WEAR_FUNCTIONS_H

#include "lua/engine/classes.h"

/* Reads the functions of the table at `index`, or keeps those of the holder at `previous` (0: none)
 * where the table has nothing in their place. Pushes the holder, or nil without functions, and puts
 * them into the definition. */
void functions_read(lua_State *L, int index, int previous, args_place place, arc_wear_def *def);

/* Where functions are called: on which stack, for which run. */
typedef struct functions_place {
  lua_State *L;              /* NULL outside a call of the engine */
  box *run;                  /* NULL while it is being made */
  const arc_model_def *pair; /* that of a run that is being made */
  int at;                    /* index of the holder on the stack; the functions follow it */
  int failed;                /* the holder keeps an error */
} functions_place;

typedef struct functions_call {
  struct wear_functions *held; /* NULL: a run without functions */
  functions_place outer;       /* of the call around this one, if any */
} functions_call;

/* Makes ready to call the functions of the holder at `holder` (nil: nothing is done); `run` is
 * marked as busy in the middle of a step while one of them runs. Leaves values on the stack. */
functions_call functions_enter(lua_State *L, int holder, box *run);
/* The same where there is no run yet, on a model of that definition. */
functions_call functions_enter_making(lua_State *L, int holder, const arc_model_def *pair);

/* Whether one has raised an error that functions_leave will raise. */
int functions_failed(const functions_call *call);

/* The end of the call. Raises what a function has raised; the stack may hold anything. */
void functions_leave(lua_State *L, functions_call *call, const char *where);

/* Pushes the function of a field ("k") from the holder at `holder`, or nil. */
void functions_push(lua_State *L, int holder, const char *field);

/* Pushes the list of the fields of a definition that are functions. */
void functions_push_names(lua_State *L, const arc_wear_def *def);

/* What a state object shows: nothing while there is no record; by body as the pair's are called. */
typedef struct called_state {
  const arc_wear_record *record;
  const arc_model_def *pair;
} called_state;

/* Pushes a state object, and what it shows from now on. */
called_state *state_push(lua_State *L);

enum { RUN_IDLE = 0, RUN_BUSY = 1, RUN_IN_STEP = 2 }; /* box.busy of a run */
enum { RUN_MODEL = 1, RUN_FUNCTIONS = 2 };            /* its user values */

#endif
