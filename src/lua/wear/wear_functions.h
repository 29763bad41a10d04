/* lua/wear/wear_functions.h - the user's functions of a run, such as k, alpha, jump and
 * local_factor. A holder (a userdata) keeps the functions alive. The holder is the second user
 * value of a run, is shared with the clones of the run, and is the context of the engine's
 * callbacks. functions_enter and functions_leave enclose each call of the engine that may call a
 * function. An error of a function is stored until the engine has returned, and is then raised
 * again. */
#ifndef LUA_WEAR_FUNCTIONS_H
#define LUA_WEAR_FUNCTIONS_H

#include "lua/engine/classes.h"

/* Context in which the engine may call the user's functions. */
typedef struct functions_place {
  lua_State *L;              /* NULL outside calls of the engine */
  box *run;                  /* NULL while the run is constructed */
  const arc_model_def *pair; /* model definition, if the run is being constructed */
  int at;                    /* stack index of the holder, followed by the functions */
  int failed;                /* true if the holder contains the error value of a function */
} functions_place;

typedef struct functions_call {
  struct wear_functions *held; /* NULL for a run without functions */
  functions_place outer;       /* context of the enclosing call */
} functions_call;

/* Data of a state object. `record` is NULL outside a call of a function. `pair` contains the
 * names of the bodies. */
typedef struct callback_state {
  const arc_wear_record *record;
  const arc_model_def *pair;
} callback_state;

enum { RUN_IDLE = 0, RUN_BUSY = 1, RUN_IN_STEP = 2 }; /* values of `busy` in the box of a run */
enum { RUN_MODEL = 1, RUN_FUNCTIONS = 2 }; /* indices of the user values of a run's box */

/* --- wear_functions.c ------------------------------------------------------------------------- */

/* Reads the functions of the table at `index`. Settings that are not in the table keep the
 * functions of the holder at `previous` (0: none). Pushes the holder, or nil if there are no
 * functions, and sets the function pointers of the definition. */
void functions_read(lua_State *L, int index, int previous, args_location location,
                    arc_wear_def *def);

/* Prepares calls of the functions in the holder at index `holder`; has no effect if the holder is
 * nil. While a function runs, `run` is marked as busy. Pushes values that must stay on the stack
 * until functions_leave. */
functions_call functions_enter(lua_State *L, int holder, box *run);
/* Works like functions_enter for a run that is being constructed with the model definition
 * `pair`. */
functions_call functions_enter_making(lua_State *L, int holder, const arc_model_def *pair);

/* Returns true if a function has raised an error, which functions_leave will raise again. */
int functions_failed(const functions_call *call);

/* Ends the context that functions_enter created. If a function has failed, raises its error. The
 * values that functions_enter pushed stay on the stack. */
void functions_leave(lua_State *L, functions_call *call, const char *where);

/* Pushes the user's function of a field, such as "k", from the holder at index `holder`. Pushes nil
 * if the field is not a function. */
void functions_push(lua_State *L, int holder, const char *field);

/* Pushes the list of the fields of a definition that are functions. */
void functions_push_names(lua_State *L, const arc_wear_def *def);

/* --- wear_callback_state.c -------------------------------------------------------------------- */

/* Pushes a state object and returns its data. */
callback_state *state_push(lua_State *L);

#endif
