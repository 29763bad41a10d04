/* Names of open descriptors, and error messages for files. */
#ifndef CORE_BASE_RESOLVE_H
#define CORE_BASE_RESOLVE_H

#include "archard/base.h"

/* Returns the descriptor named by a path of this process such as "/proc/PID/fd/1"; -1 for other
 * paths. */
int arc_file_descriptor(const char *path);

/* Fails with ARC_IO and the message "cannot read NAME: WHY" or "cannot write 'NAME': WHY". */
arc_status arc_file_refused(const char *name, arc_file_use use, const char *why, arc_error *error);

#endif
