/* system/child.h - programs started as children of this one, and the ways to talk with them. */
#ifndef SYSTEM_CHILD_H
#define SYSTEM_CHILD_H

#include <sys/types.h>

/* A program to start. */
typedef struct arc_child_def {
  const char *program;      /* looked up in PATH, unless there is a slash in it */
  char *const *arguments;   /* its name first, NULL last */
  char *const *environment; /* NULL last; NULL: as ours is */
  int ends[3];              /* become its standard input, output and error */
  double part;              /* of the memory that is left here, where that is limited (room.h) */
} arc_child_def;

/* What a program needs to be there at all, beside its part [bytes]: gnuplot and a worker of ours
 * have 23 MiB of data as they start. */
enum { ARC_CHILD_OWN_MEMORY = 32 << 20 };

/* Starts it in a process group of its own, which keeps a Ctrl-C at the terminal away from it, with
 * no signal blocked, SIGINT, SIGPIPE and SIGTERM as usual, and no descriptors but its three. It is
 * killed when the thread ends that called this, however that comes. Returns 0 and the process, or
 * an errno value. */
int arc_child_start(const arc_child_def *def, pid_t *process);

/* Becomes this very program anew, without the threads that there are. Returns an errno value where
 * it returns. */
int arc_child_again(char *const argv[]);

/* Two connected ends, both closed on exec: a pipe from [1] to [0], or a socket both ways, which can
 * be written without SIGPIPE. Returns 0, or an errno value; ends that are open then are the
 * caller's to close, as after success. */
int arc_child_channel(int ends[2], int is_socket);

/* To be told of each child that somebody has waited for. */
void arc_child_ended(pid_t process);

/* Kills the group of a child and waits for it. Returns how it ended, as waitpid() tells it, or -1
 * when that is unknown. */
int arc_child_kill(pid_t process);

/* Closes a descriptor, unless it is -1, and makes it -1. */
void arc_child_close(int *descriptor);

#endif
