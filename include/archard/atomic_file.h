/* archard/atomic_file.h - atomic writing of files.
 *
 * The new content is written to a temporary file in the same folder. The complete file is renamed
 * to the final name. A reader therefore sees either the old or the new file, even if a program is
 * killed. If several programs write the same file, the last version remains. */
#ifndef ARCHARD_ATOMIC_FILE_H
#define ARCHARD_ATOMIC_FILE_H

#include "archard/base.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

typedef struct arc_atomic_file arc_atomic_file;

/* Creates a temporary file for `path` and removes temporary files of killed programs from the
 * folder. Symbolic links are followed. If `path` exists, it must be writable, and the new file gets
 * its permissions. A device or pipe is written to directly, not replaced. Errors: those of
 * arc_file_find; ARC_IO (the message has the reason); ARC_MEMORY. */
arc_status arc_atomic_file_create(const char *path, arc_atomic_file **file, arc_error *error);

/* Creates a temporary file in a folder, without a final name. The caller removes it with
 * arc_atomic_file_discard. Errors as for arc_atomic_file_create. */
arc_status arc_atomic_file_create_scratch(const char *folder, arc_atomic_file **file,
                                          arc_error *error);

/* Returns the absolute path of the temporary file. */
const char *arc_atomic_file_path(const arc_atomic_file *file);

/* Returns the name of the final file, as passed by the caller. */
const char *arc_atomic_file_name(const arc_atomic_file *file);

/* Flushes the temporary file to the disk and renames it to the final name. Always frees the object
 * and sets the pointer to NULL. ARC_IO: the message has the reason, and the old file is
 * unchanged. */
arc_status arc_atomic_file_publish(arc_atomic_file **file, arc_error *error);

/* Publishes the file unless another program has meanwhile created a file with the final name. In
 * that case the other file is kept, the temporary file is removed, and the function returns
 * ARC_OK. */
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
