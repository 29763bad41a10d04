/* Names of what is open already. */
#ifndef CORE_BASE_RESOLVE_H
#define CORE_BASE_RESOLVE_H

/* "/proc/PID/fd/1" of this process, absolute and in whatever words before, names a descriptor, not
 * the file that stands behind it; -1 for other paths. */
int arc_file_descriptor(const char *path);

#endif
