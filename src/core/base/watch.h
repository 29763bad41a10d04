/* Long computations without stopping points: they run on their own thread while the caller calls
 * the callbacks, and are abandoned when a stop is requested. */
#ifndef BASE_WATCH_H
#define BASE_WATCH_H

#include "archard/base.h"

#include <stdatomic.h>

/* Progress of the work, and the request to stop; used by the work at each stage. */
typedef struct work_watch {
  _Atomic int stage, stages;
  _Atomic int unwanted;
} work_watch;

/* Ends a stage. ARC_STOPPED if the work was abandoned. NULL is allowed. */
arc_status arc_watch_stage(work_watch *w);

/* Functions of a job: `work` computes it and returns its status, `discard` frees it with all
 * results. */
typedef struct watched_work {
  arc_status (*work)(void *job);
  void (*discard)(void *job);
  work_watch *progress; /* inside the job */
} watched_work;

/* Runs the work. ARC_STOPPED by a callback: the job is discarded after its work has ended;
 * otherwise returns the status of the work, and the caller owns the job. */
arc_status arc_watched(const watched_work *work, void *job, const char *what,
                       const arc_callbacks *callbacks, int *left_behind);

#endif
