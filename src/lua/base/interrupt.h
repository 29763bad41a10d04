/* lua/interrupt.h - stops whatever runs, in Lua or in the engine, when the user asks.
 *
 * A request sets a flag, which the engine polls through interrupt_pending, and arms a hook in the
 * running coroutine. The flag and the hook stay until interrupt_clear, so that pcall cannot swallow
 * the request. Nothing is paid while no request is there.
 */
#ifndef LUA_INTERRUPT_H
#define LUA_INTERRUPT_H

#include <lua.h>

/* Replaces coroutine.resume, wrap and close by versions that keep track of the running coroutine.
 * Once, after the standard libraries. */
void interrupt_install(lua_State *L);

/* Between these two calls requests stop what runs in `L`, also one that came just before; outside
 * they only set the flag, so that the program's own work is never cut short. */
void interrupt_attach(lua_State *L);
void interrupt_detach(lua_State *L);

/* Asks for a stop; may be called from a signal handler. Returns how many requests were pending. */
int interrupt_request(void);

/* Whether a stop was ever asked for in this process. */
int interrupt_ever(void);

/* Non-zero when a stop was asked for: an arc_stop_fn for the engine; `context` is not used. */
int interrupt_pending(void *context);

/* Raises the error of a pending request, "<stand>: interrupted", and gives later errors of the same
 * request this text too. */
void interrupt_raise(lua_State *L, const char *stand);

/* What errors of a request say in place of <stand>, until the next call or interrupt_clear: of a
 * search of many runs how far it is. Empty: nothing. */
void interrupt_report(const char *text);

/* From here on Lua runs so many instructions at most (0: any number); costs it speed. What is
 * beyond is stopped as by a request that nothing clears. No hook stops all of it (Lua calls none in
 * what a hook's own error runs: handlers, and __close of a coroutine that dies of it): `reached`,
 * which may be NULL, is called once, when they are used up. */
void interrupt_limit(lua_State *L, double instructions, void (*reached)(void));

/* Says that a limit was reached; may be called from a signal handler. `text` must stay. */
void interrupt_exceed(const char *text);

/* The text of the limit that was reached, or NULL. May be called from a signal handler. */
const char *interrupt_exceeded(void);

/* Forgets the request. Called when nothing of the user's runs. */
void interrupt_clear(void);

#endif
