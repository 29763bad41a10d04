/* lua/base/interrupt.h - stops running Lua code or the engine at the user's request (Ctrl-C). A
 * request sets a flag, which the engine reads by interrupt_pending, and installs a hook in the
 * running coroutine. Flag and hook stay until interrupt_clear, so that pcall in a script cannot
 * discard the request. Without a request and without an instruction limit no hook is installed, so
 * that Lua is not slowed down. */
#ifndef LUA_INTERRUPT_H
#define LUA_INTERRUPT_H

#include <lua.h>

/* Replaces coroutine.create, resume, wrap and close by versions that track the running coroutine.
 * Must be called once, after the standard libraries are open. */
void interrupt_install(lua_State *L);

/* Between interrupt_attach and interrupt_detach, a request stops the code in `L`, even if it was
 * made just before interrupt_attach. At other times a request only sets the flag, so that the
 * program's own code is not interrupted. */
void interrupt_attach(lua_State *L);
void interrupt_detach(lua_State *L);

/* Requests a stop; async-signal-safe. Returns the number of requests that were already pending. */
int interrupt_request(void);

/* Returns true if a stop was requested at any time in this process. */
int interrupt_ever(void);

/* Returns true if a stop is requested. The function has the type arc_stop_fn, so that the engine
 * can call it. `context` is not used. */
int interrupt_pending(void *context);

/* Raises the error of a pending request: the text `progress`, which describes the progress of the
 * run, followed by ": interrupted". Later errors of this request repeat the message. */
void interrupt_raise(lua_State *L, const char *progress);

/* Key of a registry value that is true while the prompt runs, where an interrupted run can be
 * continued. */
#define INTERRUPT_PROMPT "archard.prompt"

/* Sets a text that replaces `progress` in the errors of interrupt_raise, such as the progress of a
 * search over many runs. The text applies until the next call or interrupt_clear. An empty text
 * ends the replacement. */
void interrupt_report(const char *text);

/* Limits the number of Lua instructions (0: no limit). A limit slows Lua down. At the limit,
 * execution is stopped as by a request that cannot be cleared. Code that runs because of the
 * resulting error is not stopped: Lua calls no hook in message handlers and __close methods.
 * Therefore the function `reached` (may be NULL) is called once at the limit. */
void interrupt_limit(lua_State *L, double instructions, void (*reached)(void));

/* Stops execution because a limit was exceeded; async-signal-safe. `text` is the error message and
 * is not copied. */
void interrupt_exceed(const char *text);

/* Returns the message of the exceeded limit, or NULL if no limit was exceeded;
 * async-signal-safe. */
const char *interrupt_exceeded(void);

/* Clears all pending requests, but not an exceeded limit. Must be called only while no code of the
 * user runs. */
void interrupt_clear(void);

#endif
