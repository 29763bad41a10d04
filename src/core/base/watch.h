/* Long computations that cannot be stopped where they are: they run on a thread of their own while
 * the caller's callbacks are asked and told, and are left behind when a stop is asked for. */
#ifndef BASE_WATCH_H
#define BASE_WATCH_H

#include "archard/base.h"

#include <stdatomic.h>

/* How far the work is, and whether it is still wanted; the work looks and tells now and then. */
typedef struct work_watch {
  _Atomic int stage, stages;
  _Atomic int unwanted;
} work_watch;

/* The end of a stage: ARC_STOPPED where nobody waits any more. NULL is fine. */
arc_status arc_watch_stage(work_watch *w);

/* What is to be done with a job: `work` fills it and returns its status, `discard` frees it with
 * all it has made. */
typedef struct watched_work {
  arc_status (*work)(void *job);
  void (*discard)(void *job);
  work_watch *progress; /* inside the job */
} watched_work;

/* Does the work. ARC_STOPPED by the callbacks: the job is no longer the caller's, and is discarded
 * once its work has ended; after anything else it is the caller's, as is its status. */
arc_status arc_watched(const watched_work *work, void *job, const char *what,
                       const arc_callbacks *callbacks, int *left_behind);

#endif
