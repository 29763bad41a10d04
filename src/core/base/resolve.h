/* File names of open descriptors, and refusals of files. */
#ifndef CORE_BASE_RESOLVE_H
#define CORE_BASE_RESOLVE_H

#include "archard/base.h"

/* Descriptor named by a path such as "/proc/PID/fd/1" of this process; -1 for other paths. */
int arc_file_descriptor(const char *path);

/* Fails with ARC_IO: "cannot read NAME: why", or write. */
arc_status arc_file_refused(const char *name, arc_file_use use, const char *why, arc_error *error);

#endif
