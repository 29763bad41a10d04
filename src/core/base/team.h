/* Declares a team of threads (workers) that share the tasks of a loop. Each worker repeatedly
 * executes the next task that no other worker has begun. Tasks must write to separate memory, so
 * that results do not depend on the number of workers. */
#ifndef BASE_TEAM_H
#define BASE_TEAM_H

#include "archard/base.h"

typedef struct work_team work_team;

/* Executes one task. `worker` (0 .. workers - 1) is the index of the thread and selects its own
 * workspace. */
typedef void (*team_task)(void *context, int task, int worker);

/* Creates a team of `workers` threads, including the caller. If `workers` is 1, *team is NULL,
 * which all functions below accept. Error: ARC_MEMORY, also if the system cannot create threads. */
arc_status arc_team_create(int workers, work_team **team, arc_error *error);
/* Ends the threads and sets the handle to NULL. */
void arc_team_destroy(work_team **team);
int arc_team_workers(const work_team *team);

/* Executes tasks 0 .. tasks - 1 and returns when all are done. In a forked child, which has no
 * other threads, the caller executes all tasks. Two callers must not use the same team at once. */
void arc_team_run(work_team *team, int tasks, team_task task, void *context);

#endif
