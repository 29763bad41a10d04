/* Implements a team of threads that share the tasks of loops. Loops follow each other within
 * microseconds, and waking a sleeping thread needs the time of many loops. Therefore a thread
 * that waits first yields its processor some times, and then sleeps. */
#include "core/base/team.h"

#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <unistd.h>

/* Next task of a thread's share. Counters of different threads are in different cache lines. */
typedef struct share_counter {
  atomic_int next;
  char apart[64 - sizeof(atomic_int)];
} share_counter;

struct work_team {
  pthread_mutex_t lock;
  pthread_cond_t begun, ended;
  pthread_t *thread;
  pid_t process;   /* process that created the threads */
  int threads;     /* number of threads besides the caller */
  atomic_int loop; /* number of loops started so far; changed only under the lock */
  atomic_int busy; /* number of threads that have not finished the loop */
  int closing;
  team_task task;
  void *context;
  int tasks;
  share_counter *share; /* [threads + 1] */
};

/* Argument of a thread. */
typedef struct member {
  work_team *team;
  int worker;
} member;

/* Returns the first task of a worker's share of the tasks. */
static int first_of(const work_team *t, int worker) {
  return (int)((long long)t->tasks * worker / (t->threads + 1));
}

/* Runs the tasks of the worker's own share, then those that are left in the shares of others. Loops
 * with the same number of tasks thus run most tasks on the processor whose cache has their data. */
static void run_tasks(work_team *t, int worker) {
  const int workers = t->threads + 1;
  for (int i = 0; i < workers; i++) {
    const int of = (worker + i) % workers, end = first_of(t, of + 1);
    for (int k = atomic_fetch_add(&t->share[of].next, 1); k < end;
         k = atomic_fetch_add(&t->share[of].next, 1))
      t->task(t->context, k, worker);
  }
}

enum { yields = 1000 /* number of times that a thread yields before it sleeps */ };

/* Yields while *value is `old` (unless `equal` is 0: while it is not). Gives up after some times.
 */
static void yield_while(atomic_int *value, int old, int equal) {
  for (int k = 0; k < yields && (atomic_load(value) == old) == equal; k++) sched_yield();
}

/* Waits for the next loop after loop number `last`. Returns 0 if the team is closing. */
static int await_loop(work_team *t, int last) {
  yield_while(&t->loop, last, 1);
  pthread_mutex_lock(&t->lock);
  while (atomic_load(&t->loop) == last && !t->closing) pthread_cond_wait(&t->begun, &t->lock);
  const int goes_on = !t->closing;
  pthread_mutex_unlock(&t->lock);
  return goes_on;
}

static void *work(void *context) {
  const member m = *(member *)context;
  work_team *t = m.team;
  free(context);
  for (int loop = 0; await_loop(t, loop); loop++) {
    run_tasks(t, m.worker);
    pthread_mutex_lock(&t->lock);
    if (atomic_fetch_sub(&t->busy, 1) == 1) pthread_cond_signal(&t->ended);
    pthread_mutex_unlock(&t->lock);
  }
  return NULL;
}

/* Starts one thread with all signals blocked, so that signals are handled by the caller's
 * thread. */
static int start(work_team *t) {
  member *m = malloc(sizeof *m);
  if (!m) return 0;
  *m = (member){t, t->threads + 1};
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const int started = pthread_create(&t->thread[t->threads], NULL, work, m) == 0;
  pthread_sigmask(SIG_SETMASK, &before, NULL);
  if (!started) free(m);
  t->threads += started;
  return started;
}

static void release(work_team *t) {
  if (!t) return;
  free(t->share);
  free(t->thread);
  free(t);
}

arc_status arc_team_create(int workers, work_team **team, arc_error *error) {
  *team = NULL;
  if (workers <= 1) return ARC_OK;
  work_team *t = calloc(1, sizeof *t);
  if (t) t->thread = calloc((size_t)workers - 1, sizeof *t->thread);
  if (t) t->share = calloc((size_t)workers, sizeof *t->share);
  if (!t || !t->thread || !t->share) {
    release(t);
    return arc_fail(error, ARC_MEMORY, "out of memory for %d workers", workers);
  }
  pthread_mutex_init(&t->lock, NULL);
  pthread_cond_init(&t->begun, NULL);
  pthread_cond_init(&t->ended, NULL);
  t->process = getpid();
  int complete = 1;
  for (int k = 1; k < workers && complete; k++) complete = start(t);
  if (!complete) {
    arc_team_destroy(&t);
    return arc_fail(error, ARC_MEMORY, "the system cannot create threads for %d workers", workers);
  }
  *team = t;
  return ARC_OK;
}

void arc_team_destroy(work_team **team) {
  work_team *t = *team;
  *team = NULL;
  if (!t) return;
  if (t->process == getpid()) {
    pthread_mutex_lock(&t->lock);
    t->closing = 1;
    pthread_cond_broadcast(&t->begun);
    pthread_mutex_unlock(&t->lock);
    for (int k = 0; k < t->threads; k++) pthread_join(t->thread[k], NULL);
    pthread_cond_destroy(&t->begun);
    pthread_cond_destroy(&t->ended);
    pthread_mutex_destroy(&t->lock);
  }
  release(t);
}

int arc_team_workers(const work_team *team) {
  return team ? team->threads + 1 : 1;
}

static void run_alone(int tasks, team_task task, void *context) {
  for (int k = 0; k < tasks; k++) task(context, k, 0);
}

void arc_team_run(work_team *t, int tasks, team_task task, void *context) {
  if (!t || tasks < 2 || t->process != getpid()) {
    run_alone(tasks, task, context);
    return;
  }
  pthread_mutex_lock(&t->lock);
  t->task = task;
  t->context = context;
  t->tasks = tasks;
  for (int w = 0; w <= t->threads; w++) atomic_store(&t->share[w].next, first_of(t, w));
  atomic_store(&t->busy, t->threads);
  atomic_fetch_add(&t->loop, 1);
  pthread_cond_broadcast(&t->begun);
  pthread_mutex_unlock(&t->lock);
  run_tasks(t, 0);
  yield_while(&t->busy, 0, 0);
  pthread_mutex_lock(&t->lock);
  while (atomic_load(&t->busy) > 0) pthread_cond_wait(&t->ended, &t->lock);
  pthread_mutex_unlock(&t->lock);
}
