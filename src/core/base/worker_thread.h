/* Runs long computations on a separate thread while the caller's thread calls the callbacks. A
 * computation is abandoned when a callback requests a stop. */
#ifndef BASE_WORKER_THREAD_H
#define BASE_WORKER_THREAD_H

#include "archard/base.h"

#include <stdatomic.h>

/* Progress of a computation, and a flag that requests its end. At each stage the computation
 * increases `stage` and checks `abandoned`. */
typedef struct work_progress {
  _Atomic int stage, stages;
  _Atomic int abandoned;
} work_progress;

/* Counts a finished stage. Returns ARC_STOPPED if the computation was abandoned, otherwise ARC_OK.
 * `p` may be NULL. */
arc_status arc_work_stage(work_progress *p);

/* Functions of a job. `work` computes the results and returns the status of the computation.
 * `discard` frees the job with its results. */
typedef struct worker_task {
  arc_status (*work)(void *job);
  void (*discard)(void *job);
  work_progress *progress; /* progress of the computation, a member of the job */
} worker_task;

/* Runs the work of a job and reports its progress under the name `what`. If a callback requests a
 * stop, the function sets *left_behind to 1 and returns ARC_STOPPED; the job is discarded when its
 * work has ended. Otherwise the function returns the status of the work, and the caller owns the
 * job. */
arc_status arc_worker_thread_run(const worker_task *work, void *job, const char *what,
                                 const arc_callbacks *callbacks, int *left_behind);

#endif
