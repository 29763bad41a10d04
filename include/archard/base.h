/* archard/base.h - status codes and errors, shared by every layer.
 *
 * Units everywhere: mm, N, MPa (N/mm2). Plane strain; forces in the engine are per mm of thickness
 * unless a name or comment says otherwise.
 */
#ifndef ARCHARD_BASE_H
#define ARCHARD_BASE_H

#include <stddef.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

#define ARC_VERSION "0.1.0"

/* Zero is success; positive: it did not succeed, yet nothing is broken; negative: it cannot work.
 */
#define ARC_STATUS_LIST(X)                                                                         \
  X(OK, 0, "success")                                                                              \
  X(STOPPED, 1, "stopped on request")                                                              \
  X(NOT_CONVERGED, 2, "did not converge")                                                          \
  X(CALLBACK, 3, "a user function failed")                                                         \
  X(ARGUMENT, -1, "invalid argument")                                                              \
  X(MEMORY, -2, "out of memory")                                                                   \
  X(GEOMETRY, -3, "invalid geometry")                                                              \
  X(ZONE, -4, "outside the candidate contact zone")                                                \
  X(NUMERIC, -5, "numerical breakdown")                                                            \
  X(IO, -6, "input or output failed")                                                              \
  X(FORMAT, -7, "not a file of the expected format")                                               \
  X(MISSING, -8, "a program that is needed is missing")

typedef enum arc_status {
#define ARC_STATUS_ENUM(name, value, text) ARC_##name = (value),
  ARC_STATUS_LIST(ARC_STATUS_ENUM)
#undef ARC_STATUS_ENUM
} arc_status;

/* What went wrong, in words for the user. Functions that take an arc_error fill it on failure and
 * leave it alone on success; NULL is allowed everywhere. */
typedef struct arc_error {
  arc_status status;
  char message[512];
} arc_error;

/* The fixed text of a status, e.g. "out of memory". Never NULL. */
const char *arc_status_text(arc_status status);

/* The name of a status without its prefix, e.g. "MEMORY". Never NULL. */
const char *arc_status_name(arc_status status);

/* The file that a name means, in path [PATH_MAX]: absolute and behind all links, there already or
 * in a folder that is there. A name of a descriptor of this process ("/dev/stdout") means that.
 * Returns 0, or an errno: ENOENT (no such folder), ENOTDIR, ELOOP, ENAMETOOLONG, EACCES. */
int arc_file_resolve(const char *name, char *path);

/* What a file is for. */
typedef enum arc_file_use { ARC_FILE_READ, ARC_FILE_WRITE } arc_file_use;

/* Whether a file of that name may be used so, which whatever opens, makes or replaces files asks:
 * here it may. A program that keeps to some folders has a function of this name, which takes the
 * place of this one. ARC_IO: it may not. */
arc_status arc_file_allowed(const char *path, arc_file_use use, arc_error *error);

/* Opens a file to be read from its beginning. ARC_IO: there is none, or what has the name is a
 * folder, pipe or device; or as arc_file_allowed says. */
arc_status arc_file_open(const char *path, FILE **stream, arc_error *error);
/* The whole of one, with a zero behind it; *text [*length] is to be freed with free(). ARC_IO,
 * ARC_MEMORY, ARC_FORMAT (above 1 GiB). */
arc_status arc_file_read(const char *path, char **text, size_t *length, arc_error *error);

/* Copies text to shown [size] as people may see it, cut where there is no room: what a terminal
 * would obey, and what is no UTF-8, as \xNN; ends of lines and tabs stay. */
void arc_show_text(const char *text, char *shown, size_t size);

/* Fills `error` (may be NULL) with a printf-style message, as arc_show_text shows it, and returns
 * `status`. */
arc_status arc_fail(arc_error *error, arc_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Asked now and then by long computations; non-zero stops them with ARC_STOPPED. */
typedef int (*arc_stop_fn)(void *context);

/* Whom long computations ask and tell on their way. Any member may be NULL, and so may a pointer to
 * all of them. They must return, and leave alone what is being computed. */
struct arc_wear;
typedef struct arc_callbacks {
  /* Asked between contact solutions, and while a model is built; non-zero stops with ARC_STOPPED. A
   * model that is given up is computed on to the end of a stage, on a thread of its own: a process
   * that ends before then does so by _exit, as BLAS does not survive exit meanwhile. */
  arc_stop_fn stop;
  /* Told, in one line, why results may mean little; the computation goes on. */
  void (*warn)(void *context, const char *text);
  /* Called after each step of a run; non-zero stops it with ARC_STOPPED (the step stays). */
  int (*progress)(void *context, const struct arc_wear *wear);
  /* Told some twenty times a second while `what` is made, as "model": the share that is done, as
   * far as it can be told, and how long it has taken [s]. */
  void (*working)(void *context, const char *what, double share, double seconds);
  void *context; /* handed to each */
} arc_callbacks;

/* Runs BLAS and OpenMP of this process on one thread: at these sizes more threads only cost, and
 * a child of fork() would hang. Programs call it once at start; returns the BLAS' own description
 * or NULL where it has none. */
const char *arc_single_threaded(void);

/* BLAS takes its working memory now. OpenBLAS asks for it again and again, without end, once a
 * limit on the memory of the process (RLIMIT_AS) leaves none: call this before such a limit is set.
 */
void arc_reserve_blas(void);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif
