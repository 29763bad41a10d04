/* lua/interrupt.h - stops running Lua code or the engine at the user's request (Ctrl-C).
 *
 * A request sets a flag, which the engine polls through interrupt_pending, and installs a hook in
 * the running coroutine. Flag and hook stay until interrupt_clear, so that pcall cannot discard the
 * request. Without a request there is no cost.
 */
#ifndef LUA_INTERRUPT_H
#define LUA_INTERRUPT_H

#include <lua.h>

/* Replaces coroutine.create, resume, wrap and close by versions that track the running coroutine.
 * Call once, after opening the standard libraries. */
void interrupt_install(lua_State *L);

/* Between attach and detach, requests (also one made just before) stop the code in `L`; outside,
 * they only set the flag, so that the program's own code is not interrupted. */
void interrupt_attach(lua_State *L);
void interrupt_detach(lua_State *L);

/* Requests a stop; async-signal-safe. Returns the number of requests pending before. */
int interrupt_request(void);

/* True if a stop was ever requested in this process. */
int interrupt_ever(void);

/* True if a stop is requested. An arc_stop_fn for the engine; `context` is not used. */
int interrupt_pending(void *context);

/* Raises the error of a pending request, "<stand>: interrupted". Later errors of the same request
 * have the same text. `stand`: progress of the run. */
void interrupt_raise(lua_State *L, const char *stand);

/* Sets the text used instead of `stand` in errors of requests, until the next call or
 * interrupt_clear: the progress of a search over many runs. Empty: none. */
void interrupt_report(const char *text);

/* Limits the number of Lua instructions (0: no limit); slows Lua down. Beyond the limit, execution
 * is stopped as by a request that cannot be cleared. The hook does not cover everything: Lua calls
 * no hook while the hook's own error runs handlers or __close methods. Therefore `reached` (or
 * NULL) is called once when the limit is reached. */
void interrupt_limit(lua_State *L, double instructions, void (*reached)(void));

/* Reports that a limit was exceeded; async-signal-safe. `text` is not copied. */
void interrupt_exceed(const char *text);

/* The text of the exceeded limit, or NULL; async-signal-safe. */
const char *interrupt_exceeded(void);

/* Clears the request. Call only while no code of the user runs. */
void interrupt_clear(void);

#endif
