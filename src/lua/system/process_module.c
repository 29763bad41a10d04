/* Module `archard.process`: a pool of worker processes (copies of this program), which read and
 * write lines. system/child.c starts and ends them. A worker exits when its standard input is
 * closed. */
#include "lua/base/archard.h"
#include "lua/base/array_read.h"
#include "lua/base/call.h"
#include "lua/base/box.h"
#include "lua/base/confine.h"
#include "lua/base/error.h"
#include "lua/base/file_name.h"
#include "lua/base/interrupt.h"
#include "system/child.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

/* LINE is the largest length of a worker's line [bytes]. The last WORDS bytes of a worker's
 * standard error are stored. MOST_WORKERS and MOST_ARGUMENTS are limits of a pool. */
enum { LINE = 4096, WORDS = 400, MOST_WORKERS = 256, MOST_ARGUMENTS = 1000 };

typedef struct worker {
  pid_t process; /* 0: not running */
  int input, output, errors;
  size_t filled; /* number of bytes in `line` */
  char line[LINE];
  size_t said; /* number of bytes in `words`, the last part of the standard error */
  char words[WORDS];
} worker;

typedef struct pool {
  int count, counted; /* counted: true if the pool is included in `pools` */
  char **arguments;   /* argument list for execv, terminated by NULL */
  char **environment;
  worker *workers;
} pool;

/* --- one worker ------------------------------------------------------------------------------- */

/* Starts a worker. Returns 0 or an errno. `ends` are the channels for input, output and errors of
 * the worker. The child process uses end 0 of the first channel and end 1 of the other two. */
static int connect_and_start(const pool *p, int ends[3][2], pid_t *process) {
  int failed = 0;
  for (int i = 0; i < 3 && !failed; i++) failed = arc_child_channel(ends[i], i == 0);
  if (failed) return failed;
  int idle = 0; /* workers that do not run share the memory equally with this process */
  for (int i = 0; i < p->count; i++) idle += p->workers[i].process == 0;
  arc_child_def def = {"/proc/self/exe", p->arguments,
                       p->environment,   {ends[0][0], ends[1][1], ends[2][1]},
                       1.0 / (idle + 1), 1};
  return arc_child_start(&def, process);
}

static int start(const pool *p, worker *w) {
  int ends[3][2] = {{-1, -1}, {-1, -1}, {-1, -1}};
  const int failed = connect_and_start(p, ends, &w->process);
  for (int i = 0; i < 3; i++) {
    arc_child_close(&ends[i][i != 0]);
    if (failed) arc_child_close(&ends[i][i == 0]);
  }
  if (failed) {
    w->process = 0;
    return failed;
  }
  w->input = ends[0][1];
  w->output = ends[1][0];
  w->errors = ends[2][0];
  fcntl(w->output, F_SETFL, O_NONBLOCK);
  fcntl(w->errors, F_SETFL, O_NONBLOCK);
  w->filled = w->said = 0;
  return 0;
}

/* Kills a worker and waits for its end. Returns the exit status in the form of waitpid. */
static int end_worker(worker *w) {
  const int how = w->process > 0 ? arc_child_kill(w->process) : 0;
  arc_child_close(&w->input);
  arc_child_close(&w->output);
  arc_child_close(&w->errors);
  w->process = 0;
  return how;
}

static void end_all(pool *p) {
  for (int i = 0; p->workers && i < p->count; i++) end_worker(&p->workers[i]);
}

static void free_list(char **list) {
  for (char **text = list; text && *text; text++) free(*text);
  free(list);
}

static int pools; /* number of pools in this process */

static void destroy_pool(void *thing) {
  pool *p = thing;
  end_all(p);
  pools -= p->counted;
  free(p->workers);
  free_list(p->arguments);
  free_list(p->environment);
}

/* --- the pool --------------------------------------------------------------------------------- */

static int pool_send(lua_State *L);
static int pool_wait(lua_State *L);

static int pool_tostring(lua_State *L) {
  lua_pushliteral(L, "a pool of worker processes");
  return 1;
}

static int pool_count(lua_State *L);

static const luaL_Reg methods[] = {
    {"send", pool_send}, {"wait", pool_wait}, {"count", pool_count}, {NULL, NULL}};

static const box_class pool_class = {.name = "pool",
                                     .methods = methods,
                                     .tostring = pool_tostring,
                                     .destroy = destroy_pool,
                                     .value = sizeof(pool)};

/* Environment variables of workers. BLAS, OpenMP and glibc read them before main. Workers have
 * only one thread. They keep freed memory, because returning it to the system would cost a tenth
 * of the time of short cases. */
static const char *const of_workers[] = {"OMP_THREAD_LIMIT=1", "OPENBLAS_NUM_THREADS=1",
                                         "MALLOC_TRIM_THRESHOLD_=268435456",
                                         "MALLOC_MMAP_THRESHOLD_=33554432"};
enum { ADDED = sizeof of_workers / sizeof *of_workers };

static int is_replaced(const char *variable) {
  for (int i = 0; i < ADDED; i++) {
    size_t name = strcspn(of_workers[i], "=") + 1;
    if (strncmp(variable, of_workers[i], name) == 0) return 1;
  }
  return 0;
}

static char **make_environment(void) {
  size_t count = 0, kept = 0;
  while (environ[count]) count++;
  char **list = calloc(count + ADDED + 1, sizeof *list);
  int short_of = !list;
  for (size_t i = 0; i < count && !short_of; i++)
    if (!is_replaced(environ[i])) short_of = !(list[kept++] = strdup(environ[i]));
  for (int i = 0; i < ADDED && !short_of; i++) short_of = !(list[kept++] = strdup(of_workers[i]));
  if (!short_of) return list;
  free_list(list);
  return NULL;
}

/* Replaces the list at `index` by a checked copy, which scripts cannot change. */
static void use_arguments(lua_State *L, int index) {
  luaL_checktype(L, index, LUA_TTABLE);
  args_push_copy(L, index);
  lua_replace(L, index);
  lua_pushvalue(L, index);
  const size_t count =
      array_length(L, (args_location){"process.pool", ""}, "arguments", MOST_ARGUMENTS);
  lua_pop(L, 1);
  for (size_t i = 1; i <= count; i++) {
    if (lua_rawgeti(L, index, (lua_Integer)i) != LUA_TSTRING)
      luaL_error(L, "process.pool: argument %d is not a text", (int)i);
    lua_pop(L, 1);
  }
}

/* Returns the argument list: the program's name, then the checked texts of the list at `index`. */
static char **make_arguments(lua_State *L, int index) {
  lua_Integer count = (lua_Integer)lua_rawlen(L, index);
  char **list = calloc((size_t)count + 2, sizeof *list);
  int short_of = !list || !(list[0] = strdup("archard"));
  for (lua_Integer i = 1; i <= count && !short_of; i++) {
    lua_rawgeti(L, index, i);
    short_of = !(list[i] = strdup(lua_tostring(L, -1)));
    lua_pop(L, 1);
  }
  if (!short_of) return list;
  free_list(list);
  return NULL;
}

static int processors(void) {
  const long count = sysconf(_SC_NPROCESSORS_ONLN);
  return count > 0 ? (int)count : 1;
}

/* Returns the largest allowed number of workers. In a sandbox it is at most the number of
 * processors. */
static int most_workers(void) {
  return confine_folder() && processors() < MOST_WORKERS ? processors() : MOST_WORKERS;
}

/* process.pool(count, arguments) returns a pool of `count` workers, which are started with these
 * arguments. */
static int process_pool(lua_State *L) {
  lua_Integer count = luaL_checkinteger(L, 1);
  luaL_argcheck(L, count >= 1 && count <= MOST_WORKERS, 1, "expected from 1 to 256 workers");
  if (count > most_workers()) count = most_workers();
  if (pools > 0 && confine_folder())
    error_raise(L, ARC_ARGUMENT, "sandbox",
                "another study is running: only one is allowed in a sandbox");
  use_arguments(L, 2);
  pool *p = box_push(L, &pool_class)->thing;
  p->workers = calloc((size_t)count, sizeof *p->workers);
  p->arguments = make_arguments(L, 2);
  p->environment = make_environment();
  if (!p->workers || !p->arguments || !p->environment) luaL_error(L, "out of memory");
  p->count = (int)count;
  pools += p->counted = 1;
  for (int i = 0; i < p->count; i++)
    p->workers[i].input = p->workers[i].output = p->workers[i].errors = -1;
  return 1;
}

/* pool:count() returns the number of workers. In a sandbox it may be less than requested. */
static int pool_count(lua_State *L) {
  lua_pushinteger(L, ((pool *)box_self_idle(L, &pool_class, "pool:count")->thing)->count);
  return 1;
}

/* pool:send(worker, line) sends a line to a worker. If the worker does not run, it is started
 * first. pool:wait later returns the worker's answer, or reports that the worker has ended. */
static int pool_send(lua_State *L) {
  pool *p = box_self_idle(L, &pool_class, "pool:send")->thing;
  lua_Integer which = luaL_checkinteger(L, 2);
  size_t length;
  const char *line = luaL_checklstring(L, 3, &length);
  luaL_argcheck(L, which >= 1 && which <= p->count, 2, "no such worker");
  luaL_argcheck(L, length < 1000 && !strchr(line, '\n'), 3,
                "expected one line of less than 1000 bytes");
  worker *w = &p->workers[which - 1];
  int failed = w->process ? 0 : start(p, w);
  if (failed)
    error_raise(L, ARC_IO, "pool:send", "a worker process cannot be started: %s", strerror(failed));
  char text[1001];
  memcpy(text, line, length);
  text[length] = '\n';
  /* send does not block, because the line fits into the socket's buffer. If sending fails, the
   * worker has ended or is ending, and pool:wait reports its end. */
  if (send(w->input, text, length + 1, MSG_NOSIGNAL) < 0) arc_child_close(&w->input);
  return 0;
}

/* --- waiting ---------------------------------------------------------------------------------- */

/* Reads the available bytes of a worker's output. Returns 0 at the end of the stream. */
static int read_some(int descriptor, char *to, size_t bytes, size_t *count) {
  ssize_t got = read(descriptor, to, bytes);
  *count = got > 0 ? (size_t)got : 0;
  return got > 0 || (got < 0 && (errno == EAGAIN || errno == EINTR));
}

/* Stores the last bytes that the worker wrote on standard error. Closes the stream at its end,
 * because poll would report it at each call. */
static void hear(worker *w) {
  char text[WORDS];
  size_t count = 1;
  while (w->errors >= 0 && count > 0) {
    if (!read_some(w->errors, text, sizeof text, &count)) arc_child_close(&w->errors);
    size_t kept = w->said + count > WORDS ? WORDS - count : w->said;
    memmove(w->words, w->words + (w->said - kept), kept);
    memcpy(w->words + kept, text, count);
    w->said = kept + count;
  }
}

/* Appends { worker=, line= } to the list on top of the stack, for a line that a worker has
 * written. */
static void add_line(lua_State *L, int which, const char *line, size_t length) {
  lua_createtable(L, 0, 2);
  lua_pushinteger(L, which + 1);
  lua_setfield(L, -2, "worker");
  lua_pushlstring(L, line, length);
  lua_setfield(L, -2, "line");
  lua_rawseti(L, -2, (lua_Integer)lua_rawlen(L, -2) + 1);
}

static void split_lines(lua_State *L, int which, worker *w) {
  char *from = w->line, *end;
  size_t left = w->filled;
  while ((end = memchr(from, '\n', left)) != NULL) {
    add_line(L, which, from, (size_t)(end - from));
    left -= (size_t)(end - from) + 1;
    from = end + 1;
  }
  if (left == LINE) left = 0; /* discards a line that is too long to be valid */
  memmove(w->line, from, left);
  w->filled = left;
}

/* Appends { worker=, ended=, words= } to the list on top of the stack, for a worker whose output is
 * closed. */
static void add_end(lua_State *L, int which, worker *w) {
  hear(w);
  const int status = end_worker(w);
  lua_createtable(L, 0, 3);
  lua_pushinteger(L, which + 1);
  lua_setfield(L, -2, "worker");
  if (WIFSIGNALED(status))
    lua_pushfstring(L, "signal %d (%s)", WTERMSIG(status), strsignal(WTERMSIG(status)));
  else
    lua_pushfstring(L, "exit status %d", WEXITSTATUS(status));
  lua_setfield(L, -2, "ended");
  lua_pushlstring(L, w->words, w->said);
  lua_setfield(L, -2, "words");
  lua_rawseti(L, -2, (lua_Integer)lua_rawlen(L, -2) + 1);
}

static void attend(lua_State *L, int which, worker *w) {
  size_t count;
  hear(w);
  int open = read_some(w->output, w->line + w->filled, LINE - w->filled, &count);
  w->filled += count;
  split_lines(L, which, w);
  if (!open) add_end(L, which, w);
}

/* Ends all workers after an interrupt, because no Lua code that could end them runs after the
 * interrupt. */
static void check_interrupt(lua_State *L, pool *p) {
  if (!interrupt_pending(NULL)) return;
  end_all(p);
  luaL_error(L, "interrupted");
}

/* Reads the number of seconds at `index` and returns it in milliseconds, as poll requires. */
static int wait_argument(lua_State *L, int index) {
  const double seconds = luaL_checknumber(L, index);
  luaL_argcheck(L, seconds >= 0 && seconds <= 1e6, index, "expected 0 to 1e6 seconds");
  return (int)(1000 * seconds);
}

/* pool:wait(seconds) returns a list of { worker=, line= } for answers and { worker=, ended=,
 * words= } for ended workers. `words` is the last part of the worker's standard error. After the
 * timeout the list is empty. */
static int pool_wait(lua_State *L) {
  pool *p = box_self_idle(L, &pool_class, "pool:wait")->thing;
  const int wait = wait_argument(L, 2);
  struct pollfd ready[2 * MOST_WORKERS];
  check_interrupt(L, p);
  for (int i = 0; i < p->count; i++) { /* closed descriptors are -1, which poll ignores */
    ready[2 * i] = (struct pollfd){.fd = p->workers[i].output, .events = POLLIN};
    ready[2 * i + 1] = (struct pollfd){.fd = p->workers[i].errors, .events = POLLIN};
  }
  int found = poll(ready, 2 * (nfds_t)p->count, wait);
  check_interrupt(L, p);
  lua_newtable(L);
  for (int i = 0; found > 0 && i < p->count; i++) {
    if (ready[2 * i + 1].revents) hear(&p->workers[i]);
    if (ready[2 * i].revents) attend(L, i, &p->workers[i]);
  }
  return 1;
}

/* process.processors() returns the number of online processors. */
static int process_processors(lua_State *L) {
  lua_pushinteger(L, processors());
  return 1;
}

/* process.pause(seconds, stand) waits. An interrupt ends the pause with the error "interrupted". If
 * the text `stand` is given, the error is this text and ": interrupted". */
static int process_pause(lua_State *L) {
  const int wait = wait_argument(L, 1);
  const char *stand = luaL_optstring(L, 2, NULL);
  poll(NULL, 0, wait);
  if (interrupt_pending(NULL) && stand) interrupt_raise(L, stand);
  if (interrupt_pending(NULL)) luaL_error(L, "interrupted");
  return 0;
}

/* process.report(text) sets a text about the progress of the present work. An interrupt then raises
 * "TEXT: interrupted". The empty text "" removes the text. */
static int process_report(lua_State *L) {
  interrupt_report(luaL_checkstring(L, 1));
  return 0;
}

/* process.make_folder(path) creates a folder. Returns true, even if the folder already exists,
 * or nil and the reason of the failure. */
static int process_make_folder(lua_State *L) {
  const char *name = path_argument(L, 1, "folder", "path");
  char path[PATH_MAX];
  struct stat there;
  arc_error error = {0};
  size_t length = strlen(name);
  while (length > 1 && name[length - 1] == '/')
    length--; /* removes final slashes, because the folder "name/" need not exist */
  name = lua_pushlstring(L, name, length);
  const arc_status status = arc_file_find(name, ARC_FILE_WRITE, path, &error);
  error_check(L, status, &error, "folder", -1);
  if (mkdir(path, 0777) == 0 ||
      (errno == EEXIST && stat(path, &there) == 0 && S_ISDIR(there.st_mode))) {
    lua_pushboolean(L, 1);
    return 1;
  }
  lua_pushnil(L);
  lua_pushstring(L, strerror(errno));
  return 2;
}

/* process.program() returns the path of this program, or nil if it is unknown. */
static int process_program(lua_State *L) {
  char path[4096];
  const ssize_t length = readlink("/proc/self/exe", path, sizeof path);
  if (length <= 0 || (size_t)length == sizeof path) return 0;
  lua_pushlstring(L, path, (size_t)length);
  return 1;
}

static int list_folder(lua_State *L) {
  DIR *folder = lua_touserdata(L, 1);
  lua_newtable(L);
  const struct dirent *entry;
  while ((entry = readdir(folder)) != NULL) {
    lua_pushstring(L, entry->d_name);
    lua_rawseti(L, -2, (lua_Integer)lua_rawlen(L, -2) + 1);
  }
  return 1;
}

/* process.files(folder) returns the unsorted names of all entries of a folder, or nil if the folder
 * cannot be opened. */
static int process_files(lua_State *L) {
  DIR *folder = opendir(luaL_checkstring(L, 1));
  if (!folder) return 0;
  lua_pushcfunction(L, list_folder);
  lua_pushlightuserdata(L, folder);
  const int failed = lua_pcall(L, 1, 1, 0);
  closedir(folder);
  return failed ? lua_error(L) : 1;
}

/* process.kind(path) returns "file", "folder", "symbolic link" or "device" (also for pipes and
 * sockets), without following a link; nil if there is no such file. */
static int process_kind(lua_State *L) {
  struct stat facts;
  if (lstat(luaL_checkstring(L, 1), &facts) != 0) return 0;
  lua_pushstring(L, S_ISREG(facts.st_mode)   ? "file"
                    : S_ISDIR(facts.st_mode) ? "folder"
                    : S_ISLNK(facts.st_mode) ? "symbolic link"
                                             : "device");
  return 1;
}

int luaopen_archard_process(lua_State *L) {
  static const luaL_Reg functions[] = {{"pool", process_pool},
                                       {"processors", process_processors},
                                       {"make_folder", process_make_folder},
                                       {"program", process_program},
                                       {"files", process_files},
                                       {"kind", process_kind},
                                       {"pause", process_pause},
                                       {"report", process_report},
                                       {NULL, NULL}};
  call_new_library(L, functions);
  return 1;
}
