/* archard/place.h - atomic writing of files.
 *
 * The new content is written to a temporary file in the same folder and renamed when complete. A
 * reader sees the old or the new file, also if a program is killed or several programs write (the
 * last one wins). */
#ifndef ARCHARD_PLACE_H
#define ARCHARD_PLACE_H

#include "archard/base.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

typedef struct arc_place arc_place;

/* Creates a temporary file for `path`. Symbolic links are followed; an existing file must be
 * writable and passes on its permissions; a device or pipe is written to, not replaced. Removes
 * temporary files of killed programs from the folder. ARC_ARGUMENT: a control character in the
 * name; ARC_IO (the reason, also of arc_file_allowed); ARC_MEMORY. */
arc_status arc_place_take(const char *path, arc_place **place, arc_error *error);

/* Creates a temporary file in a folder, to be dropped. Same errors. */
arc_status arc_place_scratch(const char *folder, arc_place **place, arc_error *error);

/* The absolute path of the temporary file. */
const char *arc_place_path(const arc_place *place);

/* The name of the final file, as given. */
const char *arc_place_asked(const arc_place *place);

/* Flushes the temporary file to the disk and renames it. Always frees the place and sets it to
 * NULL. ARC_IO (the reason): the old file is unchanged. */
arc_status arc_place_publish(arc_place **place, arc_error *error);

/* The same, but a file of this name created meanwhile is kept, without an error. */
arc_status arc_place_publish_first(arc_place **place, arc_error *error);

/* Removes the temporary file and frees the place. NULL and a pointer to NULL are allowed. */
void arc_place_drop(arc_place **place);

/* Removes temporary files of killed programs from a folder. */
void arc_place_sweep(const char *folder);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif

#endif
