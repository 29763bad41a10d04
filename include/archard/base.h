/* archard/base.h - status codes, errors, files and callbacks, used by all other headers.
 *
 * Units are mm, N and MPa (N/mm2). Unless stated otherwise, bodies are in plane strain, and forces
 * are per mm of thickness. */
#ifndef ARCHARD_BASE_H
#define ARCHARD_BASE_H

#include <stddef.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

#define ARC_VERSION "0.1.0"

/* Status codes of all functions. Zero is success, a positive code means that a computation ended
 * early, and a negative code is an error. */
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
  X(MISSING, -8, "a required program is missing")

typedef enum arc_status {
#define ARC_STATUS_ENUM(name, value, text) ARC_##name = (value),
  ARC_STATUS_LIST(ARC_STATUS_ENUM)
#undef ARC_STATUS_ENUM
} arc_status;

/* An error and its message for the user. Functions with an arc_error argument write to it only on
 * failure; the argument may be NULL. */
typedef struct arc_error {
  arc_status status;
  char message[512];
} arc_error;

/* Returns the fixed text of a status, such as "out of memory". Never NULL. */
const char *arc_status_text(arc_status status);

/* Returns the name of a status without its prefix, such as "MEMORY". Never NULL. */
const char *arc_status_name(arc_status status);

/* Purpose for which a file is opened. */
typedef enum arc_file_use { ARC_FILE_READ, ARC_FILE_WRITE } arc_file_use;

/* Resolves the symbolic links in a file name and writes the absolute path to `path` (PATH_MAX
 * bytes). The file, or at least its folder, must exist. The name of an open descriptor of this
 * process, such as "/dev/stdout", is resolved to "/proc/PID/fd/N" and no further. All functions
 * that open, create or replace files call this function first. ARC_ARGUMENT: the name is empty, or
 * it has a control character and the file is to be written. ARC_IO: the folder does not exist, or
 * the file is not allowed (arc_file_allowed). */
arc_status arc_file_find(const char *name, arc_file_use use, char *path, arc_error *error);

/* Decides whether a file may be used. arc_file_find calls this function. `name` is used in
 * messages; `path` is absolute and has no symbolic links. The function in this library allows all
 * files. A program that may use only some folders defines its own function of the same name, which
 * replaces this one. ARC_IO: the file is not allowed. */
arc_status arc_file_allowed(const char *name, const char *path, arc_file_use use, arc_error *error);

/* Opens a file for reading. ARC_IO: the file does not exist, or is a folder, pipe or device. Other
 * errors: those of arc_file_find. */
arc_status arc_file_open(const char *path, FILE **stream, arc_error *error);
/* Reads a whole file of *length bytes into *text and appends a zero byte. The caller frees *text
 * with free(). Errors: ARC_IO, ARC_MEMORY, ARC_FORMAT (the file is larger than 1 GiB). */
arc_status arc_file_read(const char *path, char **text, size_t *length, arc_error *error);

/* Copies `text` to the buffer `shown` of `size` bytes for display, truncated to fit. Control
 * characters and invalid UTF-8 become \xNN; line ends and tabs are kept. */
void arc_show_text(const char *text, char *shown, size_t size);

/* Writes a printf-style message, filtered by arc_show_text, to `error` (may be NULL). Returns
 * `status`. */
arc_status arc_fail(arc_error *error, arc_status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Function that long computations call regularly. A non-zero result stops the computation with
 * ARC_STOPPED. */
typedef int (*arc_stop_fn)(void *context);

/* Callbacks of long computations. Each member, and a pointer to the struct, may be NULL. A callback
 * must return to its caller (no longjmp) and must not change the objects of the computation. */
struct arc_wear;
typedef struct arc_callbacks {
  /* Called between contact solutions and while a model is built. A non-zero result stops the
   * computation with ARC_STOPPED. A model that is being built first completes its present stage on
   * another thread. A process that ends before then must call _exit, because exit is not safe
   * during a BLAS computation. */
  arc_stop_fn stop;
  /* Receives a one-line warning about the accuracy of results. The computation continues. */
  void (*warn)(void *context, const char *text);
  /* Called after each step of a run. A non-zero result stops the run with ARC_STOPPED; the step
   * remains part of the run. */
  int (*progress)(void *context, const struct arc_wear *wear);
  /* Reports the construction of an object about twenty times a second: its name `what` (such as
   * "model"), the estimated completed fraction `share` (0 to 1) and the elapsed time [s]. */
  void (*working)(void *context, const char *what, double share, double seconds);
  void *context; /* first argument of each callback */
} arc_callbacks;

/* Limits BLAS and OpenMP to one thread in this process. More threads are slower for the small
 * matrices used here, and a child process made by fork() would hang. Call this function once at the
 * start. Returns a description of the BLAS library, or NULL if it is unknown. */
const char *arc_single_threaded(void);

/* Makes BLAS allocate its workspace now. Call it before a memory limit of the process (RLIMIT_AS)
 * is set, because OpenBLAS loops forever if this allocation fails. */
void arc_reserve_blas(void);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif
