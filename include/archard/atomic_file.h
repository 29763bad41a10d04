/* archard/atomic_file.h - atomic writing of files.
 *
 * The new content is written to a temporary file in the same folder and renamed when complete. A
 * reader sees the old or the new file, also if a program is killed or several programs write (the
 * last one wins). */
#ifndef ARCHARD_ATOMIC_FILE_H
#define ARCHARD_ATOMIC_FILE_H

#include "archard/base.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

typedef struct arc_atomic_file arc_atomic_file;

/* Creates a temporary file for `path`. Symbolic links are followed; an existing file must be
 * writable and passes on its permissions; a device or pipe is written to, not replaced. Removes
 * temporary files of killed programs from the folder. Errors of arc_file_find; ARC_IO (the reason);
 * ARC_MEMORY. */
arc_status arc_atomic_file_create(const char *path, arc_atomic_file **file, arc_error *error);

/* Creates a temporary file in a folder, to be discarded. Same errors. */
arc_status arc_atomic_file_create_scratch(const char *folder, arc_atomic_file **file,
                                          arc_error *error);

/* The absolute path of the temporary file. */
const char *arc_atomic_file_path(const arc_atomic_file *file);

/* The name of the final file, as given. */
const char *arc_atomic_file_name(const arc_atomic_file *file);

/* Flushes the temporary file to the disk and renames it. Always frees the object and sets it to
 * NULL. ARC_IO (the reason): the old file is unchanged. */
arc_status arc_atomic_file_publish(arc_atomic_file **file, arc_error *error);

/* The same, but a file of this name created meanwhile is kept, without an error. */
arc_status arc_atomic_file_publish_first(arc_atomic_file **file, arc_error *error);

/* Removes the temporary file and frees the object. NULL and a pointer to NULL are allowed. */
void arc_atomic_file_discard(arc_atomic_file **file);

/* Removes temporary files of killed programs from a folder. */
void arc_atomic_file_clean(const char *folder);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif

#endif
