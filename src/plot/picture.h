/* Whether a picture on the disk is whole. */
#ifndef PLOT_PICTURE_H
#define PLOT_PICTURE_H

#include "archard/base.h"

/* gnuplot does not notice a full disk: a picture counts once it begins and ends as its kind, told
 * by the ending of `file`, does. ARC_IO where it does not. */
arc_status arc_picture_check(const char *path, const char *file, arc_error *error);

#endif
