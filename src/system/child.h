/* system/child.h - child processes and their connections. */
#ifndef SYSTEM_CHILD_H
#define SYSTEM_CHILD_H

#include <sys/types.h>

/* A program to start. */
typedef struct arc_child_def {
  const char *program;      /* name of a program in PATH, or a path with a slash */
  char *const *arguments;   /* name of the program and its arguments, terminated by NULL */
  char *const *environment; /* terminated by NULL; NULL: environment of this process */
  int ends[3];              /* descriptors of the child's standard input, output and error */
  double part;              /* fraction of the remaining memory for the child (memory_limit.h) */
  int again;                /* true if the program is this program, with the same libraries */
} arc_child_def;

/* Memory [bytes] that a program may use in addition to its fraction of the remaining memory.
 * gnuplot and workers have 23 MiB of data at their start. Workers may also use as much data as the
 * libraries of this program reserve: OpenBLAS never returns if it gets no memory. */
enum { ARC_CHILD_OWN_MEMORY = 32 << 20 };

/* Starts a program in its own process group, so that Ctrl-C at the terminal does not reach it.
 * In the program no signals are blocked; SIGINT, SIGPIPE and SIGTERM have their default action;
 * only the three descriptors are open. The child is killed when the calling thread ends for any
 * reason. Returns 0 and sets *process, or returns an errno. */
int arc_child_start(const arc_child_def *def, pid_t *process);

/* Prevents children that are started later from starting processes themselves, if the system
 * supports filters of system calls. */
void arc_child_confine(void);

/* Replaces this process by a new start of the same program. Other threads end. Returns only on
 * failure, with an errno. */
int arc_child_again(char *const argv[]);

/* Creates two connected descriptors, closed on exec: a pipe, read at ends[0] and written at
 * ends[1], or, if `is_socket` is true, a socket for both directions, which causes no SIGPIPE.
 * Returns 0 or an errno. Also after a failure, the caller closes the open descriptors. */
int arc_child_channel(int ends[2], int is_socket);

/* Releases the resources of a child. Must be called for each child that the caller has reaped by
 * waitpid. */
void arc_child_ended(pid_t process);

/* Kills the process group of a child and waits for the child. Returns its status in the form of
 * waitpid(), or -1 if the status is unknown. */
int arc_child_kill(pid_t process);

/* Closes a descriptor and sets it to -1. Has no effect if it is already -1. */
void arc_child_close(int *descriptor);

#endif
