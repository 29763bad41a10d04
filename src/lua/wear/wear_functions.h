/* lua/wear_functions.h - the user's functions of a run, e.g. k, alpha, jump and local_factor.
 * A holder (a userdata) keeps them alive. It is the second user value of a run, shared with its
 * clones, and the engine's context. Every call of the engine that may call a function is enclosed
 * by functions_enter and functions_leave. An error of a function is stored until the engine has
 * returned, then raised again. */
#ifndef LUA_WEAR_FUNCTIONS_H
#define LUA_WEAR_FUNCTIONS_H

#include "lua/engine/classes.h"

/* Reads the functions of the table at `index`; for settings not in the table those of the holder at
 * `previous` (0: none) are kept. Pushes the holder, or nil without functions, and sets the function
 * pointers of the definition. */
void functions_read(lua_State *L, int index, int previous, args_location location,
                    arc_wear_def *def);

/* Context in which functions are called. */
typedef struct functions_place {
  lua_State *L;              /* NULL outside a call of the engine */
  box *run;                  /* NULL during its construction */
  const arc_model_def *pair; /* model definition of a run under construction */
  int at;                    /* stack index of the holder, which the functions follow */
  int failed;                /* the holder has an error value */
} functions_place;

typedef struct functions_call {
  struct wear_functions *held; /* NULL: a run without functions */
  functions_place outer;       /* context of the enclosing call */
} functions_call;

/* Prepares calls of the functions of the holder at `holder` (nil: does nothing). While a function
 * runs, `run` is marked as busy. Leaves values on the stack. */
functions_call functions_enter(lua_State *L, int holder, box *run);
/* functions_enter during the construction of a run with this model definition. */
functions_call functions_enter_making(lua_State *L, int holder, const arc_model_def *pair);

/* True if a function has raised an error, which functions_leave will raise again. */
int functions_failed(const functions_call *call);

/* Ends the context; raises the error of a function. The stack is not restored. */
void functions_leave(lua_State *L, functions_call *call, const char *where);

/* Pushes the function of a field ("k") from the holder at `holder`, or nil. */
void functions_push(lua_State *L, int holder, const char *field);

/* Pushes the list of the fields of a definition that are functions. */
void functions_push_names(lua_State *L, const arc_wear_def *def);

/* Data of a state object; record: NULL outside a call; pair: names of the bodies. */
typedef struct callback_state {
  const arc_wear_record *record;
  const arc_model_def *pair;
} callback_state;

/* Pushes a state object and returns its data. */
callback_state *state_push(lua_State *L);

enum { RUN_IDLE = 0, RUN_BUSY = 1, RUN_IN_STEP = 2 }; /* values of box.busy of a run */
enum { RUN_MODEL = 1, RUN_FUNCTIONS = 2 };            /* user values of a run */

#endif
