/* A child process with connected standard input, output and error. */
#ifndef PLOT_PROCESS_H
#define PLOT_PROCESS_H

#include <sys/types.h>

#include "archard/base.h"
#include "plot/text.h"

/* A child process. If no process is running, pid is 0 and both descriptors are -1. */
typedef struct arc_process {
  pid_t pid;
  int talk;   /* socket to the standard input and output of the process */
  int errors; /* standard error of the process */
} arc_process;

#define ARC_PROCESS_NONE ((arc_process){0, -1, -1})

/* Starts the program `argv[0]` by arc_child_start(). After a failure no descriptor is open. Errors:
 * ARC_MISSING if there is no such program, ARC_IO for any other failure. */
arc_status arc_process_start(arc_process *process, char *const argv[], arc_error *error);

/* Largest total size of a reply and the output on standard error [bytes]. */
enum { ARC_EXCHANGE_MOST = 64 << 20 };

/* A request to a process, and its reply. */
typedef struct arc_exchange {
  const char *question;
  size_t length;
  const char *last_line; /* text at the start of the reply's last line */
  double patience;       /* [s] longest time without data in either direction */
  arc_stop_fn should_stop;
  void *stop_context;
  arc_text answer; /* output: the reply including its last line; freed by the caller */
  arc_text errors; /* output: standard error; freed by the caller */
} arc_exchange;

typedef enum arc_exchange_end {
  ARC_EXCHANGE_DONE,
  ARC_EXCHANGE_DIED,
  ARC_EXCHANGE_SILENT,
  ARC_EXCHANGE_STOPPED,
  ARC_EXCHANGE_FLOOD,
  ARC_EXCHANGE_MEMORY
} arc_exchange_end;

/* Sends the request and receives the reply at the same time, so that neither process can block the
 * other. Returns the reason of the end. */
arc_exchange_end arc_process_exchange(arc_process *process, arc_exchange *exchange);

/* Returns true while the process runs and reads its input. */
int arc_process_alive(const arc_process *process);

/* Closes the input of the process and waits for its end, at most `patience` [s]. If the process has
 * not ended then, kills its process group. Returns its exit status in the form of waitpid(), or -1
 * if the status is unknown. */
int arc_process_end(arc_process *process, double patience);

#endif
