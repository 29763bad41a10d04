/* system/child.h - child processes and their connections. */
#ifndef SYSTEM_CHILD_H
#define SYSTEM_CHILD_H

#include <sys/types.h>

/* A program to start. */
typedef struct arc_child_def {
  const char *program;      /* looked up in PATH, unless there is a slash in it */
  char *const *arguments;   /* begins with its name, terminated by NULL */
  char *const *environment; /* terminated by NULL; NULL: the environment of this process */
  int ends[3];              /* become its standard input, output and error */
  double part;              /* share of the memory left, if limited (memory_limit.h) */
} arc_child_def;

/* Memory that a program needs to start, in addition to its share [bytes]: gnuplot and a worker have
 * 23 MiB of data at their start. */
enum { ARC_CHILD_OWN_MEMORY = 32 << 20 };

/* Starts it in its own process group, so that Ctrl-C at the terminal does not reach it, with no
 * signal blocked, default SIGINT, SIGPIPE and SIGTERM, and no descriptors except the three. It is
 * killed when the calling thread ends for any reason. Returns 0 and the process, or an errno value.
 */
int arc_child_start(const arc_child_def *def, pid_t *process);

/* From now on children cannot start processes, if the system has filters. */
void arc_child_confine(void);

/* Replaces this process by a new start of the same program, without the present threads. Returns
 * only on failure, with an errno. */
int arc_child_again(char *const argv[]);

/* Creates two connected ends, both closed on exec: a pipe from [1] to [0], or a socket in both
 * directions, which causes no SIGPIPE. Returns 0, or an errno value; the caller closes open ends in
 * both cases. */
int arc_child_channel(int ends[2], int is_socket);

/* Must be called for each child that has been reaped. */
void arc_child_ended(pid_t process);

/* Kills the group of a child and waits for it. Returns its status as of waitpid(), or -1 when that
 * is unknown. */
int arc_child_kill(pid_t process);

/* Closes a descriptor, unless it is -1, and makes it -1. */
void arc_child_close(int *descriptor);

#endif
