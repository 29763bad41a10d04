/* Long computations without stopping points. They run on a thread of their own while the caller
 * calls the callbacks, and are abandoned when a stop is requested. */
#ifndef BASE_WORKER_THREAD_H
#define BASE_WORKER_THREAD_H

#include "archard/base.h"

#include <stdatomic.h>

/* Progress of the work, and the request to stop. The work updates and reads it at each stage. */
typedef struct work_progress {
  _Atomic int stage, stages;
  _Atomic int abandoned;
} work_progress;

/* Ends a stage. ARC_STOPPED if the work was abandoned. NULL is allowed. */
arc_status arc_work_stage(work_progress *p);

/* Functions of a job: `work` computes it and returns its status, `discard` frees it with all
 * results. */
typedef struct worker_task {
  arc_status (*work)(void *job);
  void (*discard)(void *job);
  work_progress *progress; /* progress, a member of the job */
} worker_task;

/* Runs the work. If a callback requests a stop it returns ARC_STOPPED, and the job is discarded
 * after its work has ended. Otherwise it returns the status of the work, and the caller owns the
 * job. */
arc_status arc_worker_thread_run(const worker_task *work, void *job, const char *what,
                                 const arc_callbacks *callbacks, int *left_behind);

#endif
