/* archard/store.h - the run file, an SQLite database of cases. Each case has its settings and,
 * after it has run, its definition, history, profiles and state.
 *
 * A file has an application id and a format number. A file of a newer format, a file of another
 * program, or a damaged file is refused and not changed. A file of an older format is converted
 * when it is opened for writing; a reader converts a temporary copy. Each change is one synchronous
 * transaction, so a killed program loses only data that it had not stored. Several processes may
 * use one file; they wait for each other.
 *
 * Files are not trusted: all data is checked against the lists of settings and columns before use.
 * A case that is finished or has a run has a checksum. Views and triggers are not executed. Reading
 * stops if it needs more work than any valid file of this size. Each of these errors is ARC_FORMAT
 * with the message "PATH: the file is damaged: REASON". Labels and messages are filtered by
 * arc_show_text.
 *
 * archard-file(5) describes the tables. All doubles except NaN are restored bit for bit. */
#ifndef ARCHARD_STORE_H
#define ARCHARD_STORE_H

#include "archard/wear.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* Format number of the file (SQLite's user_version). It increases with every change of a table; see
 * src/store/schema.c. */
#define ARC_STORE_FORMAT 6

typedef struct arc_store arc_store;

typedef enum arc_store_mode {
  ARC_STORE_READ,  /* the file must exist */
  ARC_STORE_WRITE, /* the file must exist and be writable */
  ARC_STORE_CREATE /* a missing file is created without cases */
} arc_store_mode;

/* Opens a run file. Errors: ARC_IO (the file cannot be opened, created or written), ARC_FORMAT (the
 * file is damaged, of a newer format, or of another program). On failure *store is NULL and the
 * file is unchanged. */
arc_status arc_store_open(const char *path, arc_store_mode mode, arc_store **store,
                          arc_error *error);

/* arc_store_replace creates a new file, and arc_store_publish renames this file to `path`. An
 * existing file at `path` must be a run file of the same kind (note "kind", arc_store_info); other
 * files are refused. If the store is closed before it is published, the new file is discarded. If
 * arc_store_replace did not create the store, arc_store_publish returns ARC_ARGUMENT, and the store
 * stays open. In all other cases it sets *store to NULL. */
arc_status arc_store_replace(const char *path, const char *kind, arc_store **store,
                             arc_error *error);
arc_status arc_store_publish(arc_store **store, arc_error *error);

/* Closes the store and sets it to NULL; *store may be NULL. */
void arc_store_close(arc_store **store);

const char *arc_store_path(const arc_store *store);

/* Checks the structure of every page of the file. ARC_FORMAT: the file is damaged. */
arc_status arc_store_check(arc_store *store, arc_error *error);

/* arc_store_begin starts a transaction that contains all calls until arc_store_commit. After any
 * failure, arc_store_rollback undoes these calls. Without arc_store_begin every call is a
 * transaction of its own. */
arc_status arc_store_begin(arc_store *store, arc_error *error);
arc_status arc_store_commit(arc_store *store, arc_error *error);
void arc_store_rollback(arc_store *store);

/* --- notes on the whole file ------------------------------------------------------------------ */

/* Sets a note of the file. If `text` is NULL, the note is removed. */
arc_status arc_store_set_info(arc_store *store, const char *name, const char *text,
                              arc_error *error);
/* Reads a note. *text is NULL if there is no such note; otherwise the caller frees it with
 * free(). */
arc_status arc_store_info(arc_store *store, const char *name, char **text, arc_error *error);

/* --- cases ------------------------------------------------------------------------------------ */

/* A named value of a case. */
typedef struct arc_value {
  enum { ARC_VALUE_NUMBER, ARC_VALUE_TEXT, ARC_VALUE_FLAG, ARC_VALUE_ARRAY } kind;
  const char *name;
  double number;       /* value of a number, or 0 or 1 for a flag */
  const char *text;    /* a text */
  const double *array; /* [count] numbers */
  size_t count;
} arc_value;

/* Use of the named values of a case. */
typedef enum arc_value_use {
  ARC_SETTINGS,   /* settings given by the user */
  ARC_DEFINITION, /* all settings of a run; written by arc_store_save */
  ARC_RESULTS     /* results of a finished case */
} arc_value_use;

#define ARC_CASE_STATUS_LIST(X)                                                                    \
  X(WAITING, "waiting")                                                                            \
  X(RUNNING, "running")                                                                            \
  X(DONE, "done")                                                                                  \
  X(FAILED, "failed")

typedef enum arc_case_status {
#define ARC_CASE_STATUS_ENUM(name, text) ARC_CASE_##name,
  ARC_CASE_STATUS_LIST(ARC_CASE_STATUS_ENUM)
#undef ARC_CASE_STATUS_ENUM
} arc_case_status;

extern const char *const arc_case_status_names[];

typedef struct arc_case {
  int id; /* number of the case, from 1 */
  arc_case_status status;
  char label[200];
  char message[512]; /* message of a failed case */
  double seconds;    /* [s] computing time of a finished case; NaN for other cases */
} arc_case;

/* Adds a waiting case. ARC_ARGUMENT: a case with this id exists. */
arc_status arc_store_add(arc_store *store, int id, const char *label, arc_error *error);

/* Returns all *count cases in the order of their ids. The caller frees *cases with free(). */
arc_status arc_store_cases(arc_store *store, arc_case **cases, size_t *count, arc_error *error);

/* Sets the status of a case, with `message` (NULL: none) and `seconds` as in arc_case. A case whose
 * status is "done" is not changed, because another program may have finished it. ARC_ARGUMENT:
 * there is no such case. */
arc_status arc_store_mark(arc_store *store, int id, arc_case_status status, const char *message,
                          double seconds, arc_error *error);

/* Sets the status of running cases of killed programs to waiting. */
arc_status arc_store_release(arc_store *store, arc_error *error);

/* Replaces the values of a case. */
arc_status arc_store_set_values(arc_store *store, int id, arc_value_use use,
                                const arc_value *values, size_t count, arc_error *error);

/* Calls `see` for each value of a case, in the order of names. Values are valid during the call. A
 * non-zero result of `see` ends the loop. */
typedef int (*arc_value_fn)(void *context, const arc_value *value);
arc_status arc_store_values(arc_store *store, int id, arc_value_use use, arc_value_fn see,
                            void *context, arc_error *error);

/* --- runs ------------------------------------------------------------------------------------- */

/* Stores a run under an existing case and replaces the old data of the case. The data are the
 * definition, the history, the state, and `count` arrays of surfaces (arc_wear_check_surfaces),
 * which include the present surfaces (arc_wear_surfaces). If several arrays have the same body,
 * update and name, the last one is stored. Imported meshes are stored as Gmsh text. A setting that
 * is a function is stored without the function; to continue the run, the caller must set the
 * function again. The call is a transaction of its own unless arc_store_begin started one.
 * ARC_ARGUMENT: the data are invalid and would be refused when read. */
arc_status arc_store_save(arc_store *store, int id, const arc_wear *wear, const arc_array *surfaces,
                          size_t count, arc_error *error);

/* Definition of a stored run. */
typedef struct arc_stored_run {
  arc_model_def model;
  arc_wear_def def; /* definition of the run, without its functions (NULL) */
  arc_mesh
      *given[ARC_BODIES]; /* imported meshes, or NULL; arc_model_build_given becomes their owner */
  char functions[ARC_WEAR_SETTINGS_COUNT]; /* [setting] 1 if the setting was a function, else 0 */
  void *memory;                            /* block of memory of the arrays in `def` */
} arc_stored_run;

/* Reads and checks the definition of a stored run. Its functions are NULL. ARC_ARGUMENT: no run is
 * stored for this case. ARC_FORMAT: an unknown field or an invalid value. On failure *run needs no
 * arc_stored_run_free. */
arc_status arc_store_definition(arc_store *store, int id, arc_stored_run *run, arc_error *error);
void arc_stored_run_free(arc_stored_run *run);
/* Builds the model of a stored run. If the run has imported meshes, the model is built from them
 * and becomes their owner. Errors: those of arc_model_build. */
arc_status arc_stored_run_model(arc_stored_run *run, const arc_callbacks *callbacks,
                                arc_model **model, arc_error *error);

/* Restores a run on a model of the stored definition and meshes. `def` is the stored definition
 * with its functions set. The restored run gives the same results as the original one, to the bit.
 * Errors: ARC_FORMAT (incomplete state) and those of arc_wear_resume. */
arc_status arc_store_restore(arc_store *store, int id, arc_model *model, const arc_wear_def *def,
                             arc_wear **wear, arc_error *error);

/* Reads the *count records of the stored history. The caller frees *history with free(). *count is
 * 0 if no history is stored. */
arc_status arc_store_history(arc_store *store, int id, arc_wear_record **history, size_t *count,
                             arc_error *error);

/* Reads the *count arrays of the stored surfaces, sorted by update, body (cylinder first) and
 * name. *surfaces is one block, which the caller releases with free(). */
arc_status arc_store_surfaces(arc_store *store, int id, arc_array **surfaces, size_t *count,
                              arc_error *error);

/* --- shards ----------------------------------------------------------------------------------- */

/* Copies the finished cases of the file `from` to `store`. Both must have the same cases with the
 * same settings. A case that is finished in both files is not changed. ARC_ARGUMENT: the files have
 * different results for a case, or belong to different studies, or are the same file. */
arc_status arc_store_merge(arc_store *store, const char *from, arc_error *error);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif
