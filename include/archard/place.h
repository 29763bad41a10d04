/* archard/place.h - files that appear whole or not at all.
 *
 * What is written stands in a file of its own, in the folder of the file it is meant for, until it
 * is complete; then it takes that file's name. A reader sees the old file or the new one, whatever
 * is killed when, and however many write at once (the last one stays).
 */
#ifndef ARCHARD_PLACE_H
#define ARCHARD_PLACE_H

#include "archard/base.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

typedef struct arc_place arc_place;

/* Takes a place for the file `path`. Symbolic links are followed to what they name; a file that is
 * there gives its permissions and must be one that may be written; a device or a pipe will be
 * written to, never replaced. What killed programs left in the folder is taken away.
 * ARC_ARGUMENT: a control character in the name; ARC_IO with the reason, arc_file_allowed's too;
 * ARC_MEMORY. */
arc_status arc_place_take(const char *path, arc_place **place, arc_error *error);

/* A place in a folder for a file that nobody will see, to be dropped. Same errors. */
arc_status arc_place_scratch(const char *folder, arc_place **place, arc_error *error);

/* Where to write: the absolute path of an empty file. */
const char *arc_place_path(const arc_place *place);

/* The name of the file it is for, as it was given. */
const char *arc_place_asked(const arc_place *place);

/* Brings what was written to the disk and gives it its name. Frees the place in any case and sets
 * it to NULL. ARC_IO with the reason: then the old file is as it was. */
arc_status arc_place_publish(arc_place **place, arc_error *error);

/* The same, but a file that has got the name in the meantime keeps it: no error. */
arc_status arc_place_publish_first(arc_place **place, arc_error *error);

/* Forgets what was written. NULL and a pointer to NULL are allowed. */
void arc_place_drop(arc_place **place);

/* Takes away what killed programs left in a folder. */
void arc_place_sweep(const char *folder);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif

#endif
