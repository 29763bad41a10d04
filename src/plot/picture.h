/* Checks that a picture file is complete. */
#ifndef PLOT_PICTURE_H
#define PLOT_PICTURE_H

#include "archard/base.h"

/* Checks the first and last bytes of the picture at `path`, because gnuplot does not report a full
 * disk. The ending of the file name `file` determines the format. Errors: ARC_IO if the picture is
 * incomplete. */
arc_status arc_picture_check(const char *path, const char *file, arc_error *error);

#endif
