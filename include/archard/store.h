/* archard/store.h - the run file: an SQLite database of cases, each with its settings and, once it
 * has run, its definition, history, profiles and the state to go on from.
 *
 * A file is either whole or refused: it carries an application id and the number of its format, and
 * a newer, foreign or damaged file is left as it is. One of an older format is brought to this one
 * when it is opened for writing; a reader leaves it as it is and works on a temporary copy.
 * Everything that belongs together is written in one transaction, synchronously: a killed program
 * loses what it was computing, never what it stored. Several processes may have one file open; they
 * take turns.
 *
 * A file may be a stranger's: whatever is read is checked, by the lists of settings and columns
 * that write it, before anything is made of it. A case that is finished or holds a run has a
 * checksum. Views and triggers of a file are not run, and a file that takes more work to read than
 * its size explains is given up. All this is ARC_FORMAT, "PATH: the file is damaged: " and what is.
 * Labels and messages come as arc_show_text shows them.
 *
 * The tables are described in archard-file(5). All doubles come back to the same bits (a NaN as a
 * NaN).
 */
#ifndef ARCHARD_STORE_H
#define ARCHARD_STORE_H

#include "archard/wear.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* The file's user_version. One more whenever a table changes; see src/store/schema.c. */
#define ARC_STORE_FORMAT 6

typedef struct arc_store arc_store;

typedef enum arc_store_mode {
  ARC_STORE_READ,  /* the file must be there */
  ARC_STORE_WRITE, /* it must be there, and be writable */
  ARC_STORE_CREATE /* made, with no cases, where there is none */
} arc_store_mode;

/* Opens a run file. Errors: ARC_IO (cannot be opened, made or written), ARC_FORMAT (foreign, newer,
 * damaged; the message says which). On failure *store is NULL and the file is as it was. */
arc_status arc_store_open(const char *path, arc_store_mode mode, arc_store **store,
                          arc_error *error);

/* A new file in place of `path`, which may be absent or a run file of the same kind (info "kind");
 * anything else there is refused and stays. The file appears under its name, whole, with
 * arc_store_publish; until then, closing the store forgets it. Publishing one that replaces nothing
 * is ARC_ARGUMENT, and leaves it open; after anything else *store is NULL. */
arc_status arc_store_replace(const char *path, const char *kind, arc_store **store,
                             arc_error *error);
arc_status arc_store_publish(arc_store **store, arc_error *error);

/* Closes and nulls; NULL inside is fine. */
void arc_store_close(arc_store **store);

const char *arc_store_path(const arc_store *store);

/* Reads every page and compares it with what the file's structure promises. ARC_FORMAT: damaged. */
arc_status arc_store_check(arc_store *store, arc_error *error);

/* Groups what follows into one transaction, until commit; rollback (after any failure) takes it all
 * back. Without them every call is a transaction of its own. */
arc_status arc_store_begin(arc_store *store, arc_error *error);
arc_status arc_store_commit(arc_store *store, arc_error *error);
void arc_store_rollback(arc_store *store);

/* --- notes on the file as a whole ------------------------------------------------------------- */

/* text NULL: forgets the note. */
arc_status arc_store_set_info(arc_store *store, const char *name, const char *text,
                              arc_error *error);
/* *text is to be freed with free(); NULL where there is no such note. */
arc_status arc_store_info(arc_store *store, const char *name, char **text, arc_error *error);

/* --- cases ------------------------------------------------------------------------------------ */

/* One named value. */
typedef struct arc_value {
  enum { ARC_VALUE_NUMBER, ARC_VALUE_TEXT, ARC_VALUE_FLAG, ARC_VALUE_ARRAY } kind;
  const char *name;
  double number;       /* number, or flag: 0 or 1 */
  const char *text;    /* text */
  const double *array; /* [count] numbers */
  size_t count;
} arc_value;

/* What a case's values are for. */
typedef enum arc_value_use {
  ARC_SETTINGS,   /* as the user gave them */
  ARC_DEFINITION, /* all of a run's, as the engine had them; written by arc_store_save */
  ARC_RESULTS     /* what a task found */
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
  int id; /* from 1 */
  arc_case_status status;
  char label[200];
  char message[512]; /* of a failed case */
  double seconds;    /* [s] a finished one took; NaN before */
} arc_case;

/* Adds a waiting case. ARC_ARGUMENT: there is one of this id already. */
arc_status arc_store_add(arc_store *store, int id, const char *label, arc_error *error);

/* All cases by id; *cases [*count] is to be freed with free(). */
arc_status arc_store_cases(arc_store *store, arc_case **cases, size_t *count, arc_error *error);

/* `message` and `seconds` as in arc_case; message NULL: none. A case that is done neither runs nor
 * fails any more, as another program may have done it meanwhile: its mark stays. Of a case that is
 * not there: ARC_ARGUMENT. */
arc_status arc_store_mark(arc_store *store, int id, arc_case_status status, const char *message,
                          double seconds, arc_error *error);

/* Cases that a killed program left as running wait again. */
arc_status arc_store_release(arc_store *store, arc_error *error);

/* Replaces the values of a case. */
arc_status arc_store_set_values(arc_store *store, int id, arc_value_use use,
                                const arc_value *values, size_t count, arc_error *error);

/* Sees the values of a case, by name; they live during the call. Non-zero from `see` ends it. */
typedef int (*arc_value_fn)(void *context, const arc_value *value);
arc_status arc_store_values(arc_store *store, int id, arc_value_use use, arc_value_fn see,
                            void *context, arc_error *error);

/* --- runs ------------------------------------------------------------------------------------- */

/* Stores a run under a case that is there, in place of what was stored of it: definition, history,
 * state, and the `count` arrays of surfaces (arc_wear_check_surfaces), the present ones
 * (arc_wear_surfaces) among them; of two of one body and update the later counts. What could not be
 * read back is refused: ARC_ARGUMENT. Meshes from outside are stored as the text of a Gmsh file.
 * One transaction (its own, or the one begun). Of a field that is a function only that is stored:
 * it must be given again to go on. */
arc_status arc_store_save(arc_store *store, int id, const arc_wear *wear, const arc_array *surfaces,
                          size_t count, arc_error *error);

/* The definition of a stored run. */
typedef struct arc_stored_run {
  arc_model_def model;
  arc_wear_def def;            /* its functions are NULL */
  arc_mesh *given[ARC_BODIES]; /* its meshes where they came from outside, else NULL: for
                                  arc_model_build_given, which takes them over */
  char functions[ARC_WEAR_SETTINGS_COUNT]; /* whether the setting in this place was a function */
  void *memory;                            /* the arrays `def` points to */
} arc_stored_run;

/* Reads and checks it, functions aside. ARC_ARGUMENT: nothing of this case is stored. ARC_FORMAT: a
 * field or value that this program does not know or the engine does not take. On failure there is
 * nothing to free. */
arc_status arc_store_definition(arc_store *store, int id, arc_stored_run *run, arc_error *error);
void arc_stored_run_free(arc_stored_run *run);
/* Builds its model, of its meshes where it has some, which are taken over. Errors of
 * arc_model_build. */
arc_status arc_stored_run_model(arc_stored_run *run, const arc_callbacks *callbacks,
                                arc_model **model, arc_error *error);

/* The run itself, on a model of the stored definition and meshes, with `def` the stored one and its
 * functions set: goes on to the same bits as the run that was stored. Errors: ARC_FORMAT (the state
 * is not complete) and those of arc_wear_resume. */
arc_status arc_store_restore(arc_store *store, int id, arc_model *model, const arc_wear_def *def,
                             arc_wear **wear, arc_error *error);

/* The stored history; *history [*count] is to be freed with free(). Count 0: nothing stored. */
arc_status arc_store_history(arc_store *store, int id, arc_wear_record **history, size_t *count,
                             arc_error *error);

/* The arrays of the stored surfaces in the order of updates, cylinder before plate, by name;
 * *surfaces [*count], one block, is to be freed with free(). */
arc_status arc_store_surfaces(arc_store *store, int id, arc_array **surfaces, size_t *count,
                              arc_error *error);

/* --- shards ----------------------------------------------------------------------------------- */

/* Copies into `store` the finished cases of the file `from`. Both must hold the same cases with the
 * same settings. A case that is finished in both stays as it is in `store`; ARC_ARGUMENT: it has
 * other results there, or another study. */
arc_status arc_store_merge(arc_store *store, const char *from, arc_error *error);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif
