/* The command `archard`: reads options, opens Lua and the module `archard`, runs scripts or the
 * prompt, and returns the exit status. */
#include "archard/base.h"
#include "cli/repl.h"
#include "cli/chunk.h"
#include "cli/sandbox.h"
#include "cli/signals.h"
#include "lua/base/archard.h"
#include "lua/base/interrupt.h"
#include "lua/base/scripts.h"
#include "lua/base/strict.h"
#include "lua/base/strings.h"

#include <getopt.h>
#include <lauxlib.h>
#include <limits.h>
#include <locale.h>
#include <lualib.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { EXIT_DONE = 0, EXIT_ERROR = 1, EXIT_USAGE = 2, EXIT_INTERRUPTED = 130 };

/* Options and arguments of the command line. `steps` contains the options -e and -l in the order
 * of the command line. */
typedef struct command {
  struct step {
    int kind;         /* option letter, 'e' or 'l' */
    const char *text; /* text of the chunk (-e) or name of the module (-l) */
  } * steps;
  int step_count;
  int interactive, lax, version, help, wrong;
  sandbox sandbox;
  int script; /* index of the script in argv; argc if there is no script */
  int argc;
  char **argv;
} command;

static void print_usage(FILE *stream) {
  fputs("usage: archard [options] [script [arguments]]\n"
        "  -e CHUNK        run the Lua text CHUNK\n"
        "  -l MODULE       require MODULE and assign it to the global MODULE\n"
        "  -i              open the prompt after the script\n"
        "  --lax           undefined names are nil, not errors\n"
        "  --sandbox       run an untrusted script: only files below its folder and the\n"
        "                  working folder, only gnuplot and workers started, and limits:\n"
        "  --memory MIB    memory of Lua, the engine and started programs, default 1024\n"
        "  --seconds S     elapsed time, default 3600\n"
        "  --instructions N  Lua instructions, default 1e11\n"
        "  --sandbox=strict  as --sandbox, but do not run if the system cannot enforce it\n"
        "  -v, --version   print the version\n"
        "  -h, --help      print this help\n"
        "  -               run standard input as a script\n"
        "  --              end of the options\n"
        "Without a script, archard shows its prompt, or runs standard input line by line.\n"
        "At the prompt, help() explains the objects. See also archard(1).\n",
        stream);
}

static void read_options(command *self) {
  static const struct option names[] = {
      {"version", no_argument, NULL, 'v'},
      {"help", no_argument, NULL, 'h'},
      {"lax", no_argument, NULL, 'x'},
      {"sandbox", optional_argument, NULL, 's'},
      {"memory", required_argument, NULL, 'L'},
      {"seconds", required_argument, NULL, 'L'},
      {"instructions", required_argument, NULL, 'L'},
      {NULL, 0, NULL, 0},
  };
  int letter, which = 0, limits = 0;
  self->sandbox = sandbox_usual();
  while ((letter = getopt_long(self->argc, self->argv, "+e:l:ivh", names, &which)) != -1) {
    switch (letter) {
    case 'e':
    case 'l':
      self->steps[self->step_count].kind = letter;
      self->steps[self->step_count++].text = optarg;
      break;
    case 'i':
      self->interactive = 1;
      break;
    case 'x':
      self->lax = 1;
      break;
    case 's':
      self->sandbox.wanted = 1;
      self->sandbox.strict = optarg && strcmp(optarg, "strict") == 0;
      if (optarg && !self->sandbox.strict) self->wrong = 1;
      break;
    case 'L':
      limits = 1;
      if (!sandbox_set(&self->sandbox, names[which].name, optarg)) self->wrong = 1;
      break;
    case 'v':
      self->version = 1;
      break;
    case 'h':
      self->help = 1;
      break;
    default:
      self->wrong = 1;
    }
  }
  self->script = optind;
  const int idle = optind >= self->argc && self->step_count == 0;
  if (self->sandbox.wanted ? idle || self->interactive : limits) self->wrong = 1;
}

/* Sets the global table `arg`. arg[0] is the script. The arguments before the script have
 * negative indices, as in the standard interpreter. */
static void set_arg_table(lua_State *L, const command *self) {
  int zero = self->script < self->argc ? self->script : 0;
  lua_createtable(L, self->argc - zero, zero + 1);
  for (int i = 0; i < self->argc; i++) {
    lua_pushstring(L, self->argv[i]);
    lua_rawseti(L, -2, i - zero);
  }
  lua_setglobal(L, "arg");
}

/* Prints the error of a chunk that could not be loaded, the top of the stack.
 * scripts/lib/prompt.lua adds hints to syntax errors: `text` is the chunk, or NULL if it is the
 * script `file`. */
static run_status refuse_chunk(lua_State *L, int why, const char *text, const char *file) {
  if (why == LUA_ERRSYNTAX) {
    script_require(L, "archard.lib.prompt");
    lua_getfield(L, -1, "explained");
    lua_replace(L, -2);
    lua_pushvalue(L, -2);
    lua_pushstring(L, text);
    lua_pushstring(L, file);
    if (lua_pcall(L, 3, 1, 0) != LUA_OK) lua_pop(L, 1); /* without a hint */
  }
  return run_refused(L);
}

static run_status run_chunk(lua_State *L, const char *text) {
  const int loaded = luaL_loadbuffer(L, text, strlen(text), "=(command line)");
  return loaded == LUA_OK ? run_call(L, 0, 0) : refuse_chunk(L, loaded, text, NULL);
}

static run_status run_module(lua_State *L, const char *name) {
  lua_getglobal(L, "require");
  lua_pushstring(L, name);
  run_status status = run_call(L, 1, 1);
  if (status == RUN_OK) lua_setglobal(L, name);
  return status;
}

static run_status run_steps(lua_State *L, const command *self) {
  run_status status = RUN_OK;
  for (int i = 0; i < self->step_count && status == RUN_OK; i++) {
    const struct step *step = &self->steps[i];
    status = step->kind == 'e' ? run_chunk(L, step->text) : run_module(L, step->text);
  }
  return status;
}

/* Returns true if the script may be read: in the sandbox, a link must not lead out of its folder.
 * Otherwise pushes the message. */
static int may_read(lua_State *L, const command *self, const char *name) {
  char path[PATH_MAX];
  arc_error error = {0};
  if (!self->sandbox.wanted || arc_file_find(name, ARC_FILE_READ, path, &error) == ARC_OK) return 1;
  lua_pushstring(L, error.message);
  return 0;
}

static run_status run_script(lua_State *L, const command *self) {
  const char *name = self->argv[self->script];
  if (strcmp(name, "-") == 0) name = NULL;
  const char *mode = self->sandbox.wanted ? "t" : NULL;
  if (name && !may_read(L, self, name)) return run_refused(L);
  const int loaded = luaL_loadfilex(L, name, mode);
  if (loaded != LUA_OK) return name ? refuse_chunk(L, loaded, NULL, name) : run_refused(L);
  int count = self->argc - self->script - 1;
  luaL_checkstack(L, count, "too many arguments to the script");
  for (int i = 0; i < count; i++) lua_pushstring(L, self->argv[self->script + 1 + i]);
  return run_call(L, count, 0);
}

/* Runs the prompt if standard input is a terminal. Otherwise runs the text of standard input as
 * a program. */
static run_status run_input(lua_State *L) {
  if (!isatty(STDIN_FILENO)) return repl_run_pipe(L);
  signals_install(1);
  repl_run(L);
  return RUN_OK;
}

static run_status run_command(lua_State *L, const command *self) {
  int has_script = self->script < self->argc;
  if (self->version) puts("archard " ARC_VERSION);
  run_status status = run_steps(L, self);
  if (status == RUN_OK && has_script) status = run_script(L, self);
  int idle = !has_script && self->step_count == 0 && !self->version;
  /* -i opens the prompt even after a failure. */
  if (self->interactive || (idle && status == RUN_OK)) {
    run_status session = run_input(L);
    if (status == RUN_OK || isatty(STDIN_FILENO)) status = session;
  }
  return status;
}

/* Prints warnings of Lua's warn() and of this program on standard error. Messages that begin
 * with "@" are control messages of Lua and are not printed. */
static void print_warning(void *ignored, const char *message, int to_be_continued) {
  static int continued = 0, silent = 0;
  (void)ignored;
  if (!continued && !to_be_continued && message[0] == '@') {
    if (strcmp(message, "@off") == 0) silent = 1;
    if (strcmp(message, "@on") == 0) silent = 0;
    return;
  }
  if (!silent) {
    if (!continued) fputs("archard: warning: ", stderr);
    print_plain(message, strlen(message));
    if (!to_be_continued) fputs("\n", stderr);
  }
  continued = to_be_continued;
}

/* Returns the path of the script. Returns NULL without a script or if the script is standard
 * input. */
static const char *script_path(const command *self) {
  const char *name = self->script < self->argc ? self->argv[self->script] : NULL;
  return name && strcmp(name, "-") != 0 ? name : NULL;
}

/* Opens Lua's libraries and the module, and runs the script or the prompt. Called by lua_pcall,
 * because it may raise Lua errors. */
static int session(lua_State *L) {
  const command *self = lua_touserdata(L, 1);
  luaL_checkversion(L);
  luaL_openlibs(L);
  lua_setwarnf(L, print_warning, NULL);
  interrupt_install(L);
  signals_install(0);
  set_arg_table(L, self);
  luaopen_archard(L);
  strict_globals(L);
  strings_keep(L);
  strict_libraries(L);
  if (self->lax) strict_lax(L);
  lua_settop(L, 0);
  if (self->sandbox.wanted) sandbox_enter(L, &self->sandbox, script_path(self));
  lua_pushinteger(L, run_command(L, self));
  return 1;
}

static int exit_status(run_status status) {
  if (interrupt_exceeded()) return EXIT_ERROR;
  if (status == RUN_INTERRUPTED || interrupt_pending(NULL)) return EXIT_INTERRUPTED;
  return status == RUN_OK ? EXIT_DONE : EXIT_ERROR;
}

/* Returns the exit status after the finalizers, which run after the script under the same limits: a
 * failure if a finalizer exceeded a limit, otherwise `status`. */
static int finalizers_status(int status) {
  if (status != EXIT_DONE || !interrupt_exceeded()) return status;
  fprintf(stderr, "archard: %s\n", interrupt_exceeded());
  return EXIT_ERROR;
}

static int run_state(command *self) {
  lua_State *L = self->sandbox.wanted ? sandbox_new_state(&self->sandbox) : luaL_newstate();
  if (L == NULL) {
    fputs("archard: not enough memory to start\n", stderr);
    return EXIT_ERROR;
  }
  lua_pushcfunction(L, session);
  lua_pushlightuserdata(L, self);
  int status = EXIT_ERROR;
  if (lua_pcall(L, 1, 1, 0) == LUA_OK)
    status = exit_status((run_status)lua_tointeger(L, -1));
  else
    run_refused(L);
  lua_close(L);
  return finalizers_status(status);
}

/* Closes standard output. A write error, such as a full disk, changes the status to a failure. */
static int close_output(int status) {
  if (fflush(stdout) == 0 && !ferror(stdout)) return status;
  perror("archard: standard output");
  return status == EXIT_DONE ? EXIT_ERROR : status;
}

/* Ends the program by _exit if a computation was stopped. The thread of this computation may still
 * run, and would crash when exit() closes the libraries that it uses. */
static void leave_at_once(int status, void *unused) {
  (void)unused;
  if (!interrupt_ever()) return;
  fflush(NULL);
  _exit(status);
}

int main(int argc, char **argv) {
  on_exit(leave_at_once, NULL);
  setlocale(LC_CTYPE, "");
  command self = {.argc = argc, .argv = argv};
  self.steps = calloc((size_t)argc + 1, sizeof *self.steps);
  if (self.steps == NULL) {
    fputs("archard: not enough memory to start\n", stderr);
    return EXIT_ERROR;
  }
  read_options(&self);
  int status = EXIT_DONE;
  if (self.wrong) {
    print_usage(stderr);
    status = EXIT_USAGE;
  } else if (self.help) {
    print_usage(stdout);
  } else if (!self.sandbox.wanted || sandbox_confine(&self.sandbox, script_path(&self), argv)) {
    status = run_state(&self);
  } else {
    status = EXIT_ERROR;
  }
  free(self.steps);
  return close_output(status);
}
