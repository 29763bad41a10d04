/* Checks that a picture file is complete. */
#ifndef PLOT_PICTURE_H
#define PLOT_PICTURE_H

#include "archard/base.h"

/* Checks the first and last bytes of a picture for the format given by the ending of `file`, as
 * gnuplot does not report a full disk. ARC_IO: incomplete. */
arc_status arc_picture_check(const char *path, const char *file, arc_error *error);

#endif
