/* Restricts file access of the whole process to two folders, and refuses writing if the disk has
 * too little free space. The function arc_file_allowed in this file replaces the function of this
 * name in the library, which allows all files. */
#include "lua/base/confine.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/statvfs.h>

/* Folders in which reading and writing are allowed, as absolute paths without symbolic links. An
 * empty text means that there is no restriction. */
static struct {
  char read[PATH_MAX], write[PATH_MAX];
  double least; /* [bytes] free space that must remain on the disk; 0: no limit */
} confined;

static arc_status no_folder(const char *folder, arc_error *error) {
  return arc_fail(error, ARC_IO, "%s: no such folder", folder);
}

arc_status confine_files(const char *read, const char *write, arc_error *error) {
  char from[PATH_MAX], into[PATH_MAX];
  if (!realpath(read, from)) return no_folder(read, error);
  if (!realpath(write, into)) return no_folder(write, error);
  strcpy(confined.read, from);
  strcpy(confined.write, into);
  return ARC_OK;
}

const char *confine_folder(void) {
  return confined.read[0] ? confined.read : NULL;
}

double confine_free(void) {
  struct statvfs disk;
  return statvfs(confined.write, &disk) == 0 ? (double)disk.f_bavail * (double)disk.f_frsize : 0;
}

void confine_disk(double least) {
  confined.least = least;
}

double confine_least(void) {
  return confined.least;
}

static int is_below(const char *path, const char *folder) {
  const size_t length = strlen(folder);
  if (strncmp(path, folder, length) != 0) return 0;
  return path[length] == '/' || path[length] == '\0' || folder[length - 1] == '/';
}

/* Returns true if a file, which may not exist yet, is on the disk of the working folder. The limit
 * of disk use is for this disk. */
static int is_on_our_disk(const char *path) {
  char place[PATH_MAX];
  struct stat here, there;
  snprintf(place, sizeof place, "%s", path);
  for (char *slash; stat(place, &there) != 0 && (slash = strrchr(place, '/')) && slash > place;)
    *slash = '\0';
  return stat(confined.write, &here) == 0 && stat(place, &there) == 0 &&
         here.st_dev == there.st_dev;
}

/* Checks the limit of disk use before a file below the working folder is written. */
static arc_status check_disk(const char *name, const char *path, arc_error *error) {
  if (confine_free() < confined.least)
    return arc_fail(error, ARC_IO,
                    "cannot write '%.200s': no free space remains on the disk for the sandbox",
                    name);
  if (!is_on_our_disk(path))
    return arc_fail(error, ARC_IO,
                    "cannot write '%.200s': it is not on the disk of the working folder (sandbox)",
                    name);
  return ARC_OK;
}

arc_status arc_file_allowed(const char *name, const char *path, arc_file_use use,
                            arc_error *error) {
  if (!confined.read[0]) return ARC_OK;
  if (is_below(path, confined.write))
    return use == ARC_FILE_WRITE ? check_disk(name, path, error) : ARC_OK;
  if (use == ARC_FILE_WRITE)
    return arc_fail(error, ARC_IO,
                    "cannot write '%.200s': it is not below the working folder (sandbox)", name);
  if (is_below(path, confined.read)) return ARC_OK;
  return arc_fail(error, ARC_IO,
                  "cannot read '%.200s': it is not below the folder of the script or the working "
                  "folder (sandbox)",
                  name);
}
