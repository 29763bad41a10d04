/* system/child.h - child processes and their connections. */
#ifndef SYSTEM_CHILD_H
#define SYSTEM_CHILD_H

#include <sys/types.h>

/* A program to start. */
typedef struct arc_child_def {
  const char *program;      /* name of a program in PATH, or a path with a slash */
  char *const *arguments;   /* name of the program and its arguments, terminated by NULL */
  char *const *environment; /* terminated by NULL; NULL: environment of this process */
  int ends[3];              /* descriptors that become its standard input, output and error */
  double part;              /* fraction of the remaining memory, if limited (memory_limit.h) */
} arc_child_def;

/* Memory that a program needs to start, in addition to its fraction [bytes]. gnuplot and workers
 * have 23 MiB of data at their start. */
enum { ARC_CHILD_OWN_MEMORY = 32 << 20 };

/* Starts a program in its own process group, so that Ctrl-C at the terminal does not reach it. No
 * signals are blocked; SIGINT, SIGPIPE and SIGTERM have their default action; only the three
 * descriptors are open. The child is killed when the calling thread ends for any reason. Returns 0
 * and the process, or an errno. */
int arc_child_start(const arc_child_def *def, pid_t *process);

/* Prevents later children from starting processes, if the system supports filters. */
void arc_child_confine(void);

/* Replaces this process by a new start of the same program, without the other threads. Returns only
 * on failure, with an errno. */
int arc_child_again(char *const argv[]);

/* Creates two connected descriptors, both closed on exec. They are a pipe from [1] to [0], or a
 * socket in both directions, which causes no SIGPIPE. Returns 0 or an errno; in both cases the
 * caller closes open descriptors. */
int arc_child_channel(int ends[2], int is_socket);

/* Releases the resources of a child; must be called for each child that has been reaped. */
void arc_child_ended(pid_t process);

/* Kills the process group of a child and waits for the child. Returns its status in the form of
 * waitpid(), or -1 if it is unknown. */
int arc_child_kill(pid_t process);

/* Closes a descriptor unless it is -1, and sets it to -1. */
void arc_child_close(int *descriptor);

#endif
