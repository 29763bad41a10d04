/* File names of open descriptors. */
#ifndef CORE_BASE_RESOLVE_H
#define CORE_BASE_RESOLVE_H

/* Descriptor named by a path such as "/proc/PID/fd/1" of this process; -1 for other paths. */
int arc_file_descriptor(const char *path);

#endif
