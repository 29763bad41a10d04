/* A child process with connected standard input, output and error. */
#ifndef PLOT_PROCESS_H
#define PLOT_PROCESS_H

#include <sys/types.h>

#include "archard/base.h"
#include "plot/text.h"

/* Not running: pid 0, both descriptors -1. */
typedef struct arc_process {
  pid_t pid;
  int talk;   /* its standard input and output: one socket */
  int errors; /* its standard error */
} arc_process;

#define ARC_PROCESS_NONE ((arc_process){0, -1, -1})

/* Starts `argv[0]` as arc_child_start() does. Errors: ARC_MISSING when there is no such program,
 * ARC_IO otherwise; nothing remains open then. */
arc_status arc_process_start(arc_process *process, char *const argv[], arc_error *error);

/* Largest size of a reply and of its errors [bytes]. */
enum { ARC_EXCHANGE_MOST = 64 << 20 };

/* One request and its reply. */
typedef struct arc_exchange {
  const char *question;
  size_t length;
  const char *last_line; /* prefix of the line that ends the reply */
  double patience;       /* [s] limit without data in any direction */
  arc_stop_fn should_stop;
  void *stop_context;
  arc_text answer; /* out: up to and with the last line; the caller frees */
  arc_text errors; /* out: standard error; the caller frees */
} arc_exchange;

typedef enum arc_exchange_end {
  ARC_EXCHANGE_DONE,
  ARC_EXCHANGE_DIED,
  ARC_EXCHANGE_SILENT,
  ARC_EXCHANGE_STOPPED,
  ARC_EXCHANGE_FLOOD,
  ARC_EXCHANGE_MEMORY
} arc_exchange_end;

/* Writes and reads at once, so that neither side can block the other. */
arc_exchange_end arc_process_exchange(arc_process *process, arc_exchange *exchange);

/* Non-zero while the process runs and reads its input. */
int arc_process_alive(const arc_process *process);

/* Closes its input, waits up to `patience` [s] for its end, then kills its group. Returns its
 * status as of waitpid(), or -1 when that is unknown. */
int arc_process_end(arc_process *process, double patience);

#endif
