/* Reads chunks from the line editor or standard input, runs them and prints their values.
 * scripts/lib/prompt.lua decides whether a chunk is complete and formats values.
 * scripts/session/complete.lua completes words. */
#include "cli/repl.h"

#include "archard/base.h"
#include "cli/edit.h"
#include "lua/base/interrupt.h"
#include "lua/base/scripts.h"

#include <lauxlib.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Lines of an incomplete chunk. */
typedef struct pending {
  char *text; /* text of the lines; NULL without lines */
  size_t length;
} pending;

static void pending_clear(pending *self) {
  free(self->text);
  *self = (pending){NULL, 0};
}

/* Adds a line to the chunk. Returns 0 if memory is exhausted. */
static int pending_add(pending *self, const char *line, size_t size) {
  char *text = realloc(self->text, self->length + size + 2);
  if (text == NULL) return 0;
  if (self->text) text[self->length++] = '\n';
  memcpy(text + self->length, line, size);
  text[self->length + size] = '\0';
  self->text = text;
  self->length += size;
  return 1;
}

/* --- the functions of scripts/lib/prompt.lua -------------------------------------------------- */

static void push_module_function(lua_State *L, const char *module, const char *name) {
  script_require(L, module);
  lua_getfield(L, -1, name);
  lua_remove(L, -2);
}

enum { CHUNK_READY, CHUNK_OPEN, CHUNK_WRONG };

/* Compiles the chunk. Pushes the function (result CHUNK_READY), the error message (CHUNK_WRONG),
 * or nothing if the chunk is incomplete (CHUNK_OPEN). */
static int compile(lua_State *L, const pending *chunk, const char *name, int line) {
  push_module_function(L, "archard.lib.prompt", "compile");
  lua_pushlstring(L, chunk->text, chunk->length);
  lua_pushstring(L, name);
  lua_pushinteger(L, line);
  lua_call(L, 3, 2);
  int state = lua_isfunction(L, -2) ? CHUNK_READY : lua_isstring(L, -1) ? CHUNK_WRONG : CHUNK_OPEN;
  if (state == CHUNK_READY)
    lua_pop(L, 1);
  else if (state == CHUNK_WRONG)
    lua_remove(L, -2);
  else
    lua_pop(L, 2);
  return state;
}

/* Runs the function on top of the stack, then prints its values. */
static run_status evaluate(lua_State *L) {
  int base = lua_gettop(L);
  run_status status = run_call(L, 0, LUA_MULTRET);
  int values = status == RUN_OK ? lua_gettop(L) - base + 1 : 0;
  if (values > 0) {
    push_module_function(L, "archard.lib.prompt", "show");
    lua_insert(L, base);
    status = run_call(L, values, 0);
  }
  lua_settop(L, base - 1);
  fflush(stdout);
  return status;
}

/* --- completion ------------------------------------------------------------------------------- */

/* The state of the prompt, which is also the context of the completion callback. */
typedef struct prompt {
  lua_State *L;
  pending chunk;
} prompt;

/* Lua function with two arguments: the prompt, and the text before the cursor. Returns a list of
 * words or the text "files", and the character to append if there is only one word. */
static int find_words(lua_State *L) {
  prompt *self = lua_touserdata(L, 1);
  push_module_function(L, "archard.session.complete", "words");
  lua_pushfstring(L, "%s\n%s", self->chunk.text ? self->chunk.text : "", lua_tostring(L, 2));
  lua_call(L, 1, 2);
  return 2;
}

static void copy_words(lua_State *L, edit_proposal *proposal) {
  size_t count = lua_rawlen(L, -1);
  proposal->words = calloc(count + 1, sizeof *proposal->words);
  for (size_t i = 0; proposal->words && i < count; i++) {
    lua_rawgeti(L, -1, (lua_Integer)i + 1);
    const char *word = lua_tostring(L, -1);
    if (word && (proposal->words[proposal->count] = strdup(word))) proposal->count++;
    lua_pop(L, 1);
  }
}

static void complete(void *context, const char *before, edit_proposal *proposal) {
  prompt *self = context;
  lua_State *L = self->L;
  int top = lua_gettop(L);
  lua_pushcfunction(L, find_words);
  lua_pushlightuserdata(L, self);
  lua_pushstring(L, before);
  /* after an internal error there are no completions */
  if (lua_pcall(L, 2, 2, 0) == LUA_OK) {
    const char *append = lua_tostring(L, -1);
    proposal->append = append ? *append : '\0';
    lua_pop(L, 1);
    proposal->files = lua_type(L, -1) == LUA_TSTRING;
    if (lua_istable(L, -1)) copy_words(L, proposal);
  }
  lua_settop(L, top);
}

/* --- the prompt ------------------------------------------------------------------------------- */

/* Pushes a text of scripts/lib/prompt.lua ("first", "more" or "banner"), with colours if they
 * are allowed. */
static void push_text(lua_State *L, const char *which) {
  push_module_function(L, "archard.lib.prompt", "text");
  lua_pushstring(L, which);
  lua_call(L, 1, 1);
}

/* --- end of a session ------------------------------------------------------------------------- */

/* Calls the function `name` of the script that ends sessions. The argument on top of the stack
 * is replaced by the result, or by nil on failure. */
static run_status ask(lua_State *L, const char *name) {
  push_module_function(L, "archard.session.leave", name);
  lua_insert(L, -2);
  const run_status status = run_call(L, 1, 1);
  if (status != RUN_OK) lua_pushnil(L);
  return status;
}

/* Interprets the user's answer to the question whether to end the session. Returns 1 for quit, 0
 * for stay, and -1 for an unclear answer. An error counts as stay. */
static int understand(lua_State *L, const char *line) {
  lua_pushstring(L, line);
  const run_status status = ask(L, "answer");
  const int answer = status != RUN_OK ? 0 : lua_isnil(L, -1) ? -1 : lua_toboolean(L, -1);
  lua_pop(L, 1);
  return answer;
}

/* Requests a confirmation if there are unsaved runs. Returns true if the session may end. Ctrl-D
 * at this question also ends the session. */
static int may_leave(lua_State *L) {
  lua_pushnil(L);
  int answer = ask(L, "question") == RUN_OK && lua_isstring(L, -1) ? -1 : 1;
  while (answer < 0) {
    char *line = NULL;
    const char *question = lua_tostring(L, -1), *last = strrchr(question, '\n');
    if (last) printf("%.*s\n", (int)(last - question), question);
    fflush(stdout);
    const edit_result result = edit_read(last ? last + 1 : question, &line);
    answer = result == EDIT_END ? 1 : result == EDIT_INTERRUPTED ? 0 : understand(L, line);
    free(line);
    interrupt_clear();
  }
  lua_pop(L, 1);
  return answer;
}

/* --- typed lines ------------------------------------------------------------------------------ */

static edit_result read_line(prompt *self, char **line) {
  push_text(self->L, self->chunk.text ? "more" : "first");
  edit_result result = edit_read(lua_tostring(self->L, -1), line);
  lua_pop(self->L, 1);
  return result;
}

static int asks_to_leave(const prompt *self, const char *line) {
  static const char *const words[] = {"exit", "quit", "exit()", "quit()"};
  int word = 0;
  while (word < 4 && strcmp(line, words[word]) != 0) word++;
  if (self->chunk.text || word == 4) return 0;
  lua_pushglobaltable(self->L);
  lua_pushstring(self->L, words[word % 2]);
  int taken = lua_rawget(self->L, -2) != LUA_TNIL;
  lua_pop(self->L, 2);
  return !taken;
}

/* Adds a line to the chunk, and runs the chunk once it is complete. */
static void take_line(prompt *self, const char *line) {
  if (!pending_add(&self->chunk, line, strlen(line))) {
    fputs("archard: out of memory; the input is dropped\n", stderr);
    pending_clear(&self->chunk);
    return;
  }
  int state = compile(self->L, &self->chunk, "=prompt", 1);
  if (state == CHUNK_OPEN) return;
  edit_remember(self->chunk.text);
  pending_clear(&self->chunk);
  if (state == CHUNK_READY)
    evaluate(self->L);
  else
    run_refused(self->L);
  interrupt_clear();
}

/* Reads a line and runs the chunk if it is complete. Returns 1 if the user ends the session. */
static int next_line(prompt *self) {
  char *line = NULL;
  const edit_result result = read_line(self, &line);
  if (result == EDIT_END) pending_clear(&self->chunk);
  if (result == EDIT_END) return 1;
  if (result == EDIT_INTERRUPTED) {
    pending_clear(&self->chunk);
    interrupt_clear();
    return 0;
  }
  const int leave = asks_to_leave(self, line);
  if (!leave) take_line(self, line);
  free(line);
  return leave;
}

void repl_run(lua_State *L) {
  prompt self = {L, {NULL, 0}};
  lua_pushboolean(L, 1);
  lua_setfield(L, LUA_REGISTRYINDEX, INTERRUPT_PROMPT);
  edit_start(complete, &self);
  push_text(L, "banner");
  fputs(lua_tostring(L, -1), isatty(STDOUT_FILENO) ? stdout : stderr);
  lua_pop(L, 1);
  while (!(next_line(&self) && may_leave(L))) continue;
  pending_clear(&self.chunk);
  edit_finish();
}

/* --- piped input ------------------------------------------------------------------------------ */

/* Compiles the chunk and runs it if it is complete. Its first line is line `first` of the input.
 * `last_line` is true at the end of the input. */
static run_status take_piped(lua_State *L, pending *chunk, int first, int last_line) {
  int state = compile(L, chunk, "=stdin", first);
  if (state == CHUNK_OPEN && !last_line) return RUN_OK;
  if (state == CHUNK_OPEN) {
    lua_pushfstring(L, "stdin:%d: the input ends within the chunk that begins here", first);
    state = CHUNK_WRONG;
  }
  pending_clear(chunk);
  return state == CHUNK_READY ? evaluate(L) : run_refused(L);
}

/* Returns the length of a line without its line end. Zero bytes remain in the line; Lua reports
 * them as an error. */
static size_t line_length(const char *line, size_t length) {
  if (length > 0 && line[length - 1] == '\n') length--;
  if (length > 0 && line[length - 1] == '\r') length--;
  return length;
}

run_status repl_run_pipe(lua_State *L) {
  pending chunk = {NULL, 0};
  char *line = NULL;
  size_t capacity = 0;
  ssize_t length;
  int number = 0, first = 1;
  run_status status = RUN_OK;
  while (status == RUN_OK && (length = getline(&line, &capacity, stdin)) != -1) {
    number++;
    /* a first line that begins with # is skipped, as in scripts */
    const int is_note = number == 1 && line[0] == '#';
    const size_t size = is_note ? 0 : line_length(line, (size_t)length);
    if (chunk.text == NULL) first = number;
    if (pending_add(&chunk, line, size)) {
      status = take_piped(L, &chunk, first, 0);
    } else {
      lua_pushliteral(L, "out of memory");
      status = run_refused(L);
    }
  }
  if (status == RUN_OK && chunk.text) status = take_piped(L, &chunk, first, 1);
  if (status == RUN_OK && interrupt_pending(NULL)) status = RUN_INTERRUPTED;
  pending_clear(&chunk);
  free(line);
  return status;
}
