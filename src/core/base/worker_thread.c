/* Runs a computation on a separate thread while the caller's thread calls the callbacks. */
#include "core/base/worker_thread.h"

#include <omp.h>
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <time.h>

static const long interval = 50000000; /* [ns] interval between two calls of callbacks */

/* Data shared by the caller's thread and the worker thread. They are freed by the thread that uses
 * them last. */
typedef struct worker {
  pthread_t thread;
  pthread_mutex_t lock;
  pthread_cond_t changed;
  int done, abandoned;
  int levels; /* limit of nested OpenMP levels, copied from the caller's thread */
  arc_status status;
  worker_task work;
  void *job;
} worker;

arc_status arc_work_stage(work_progress *p) {
  if (!p) return ARC_OK;
  p->stage++;
  return p->abandoned ? ARC_STOPPED : ARC_OK;
}

static void free_worker(worker *w) {
  pthread_cond_destroy(&w->changed);
  pthread_mutex_destroy(&w->lock);
  free(w);
}

static void *run(void *context) {
  worker *w = context;
  omp_set_max_active_levels(w->levels);
  const arc_status status = w->work.work(w->job);
  pthread_mutex_lock(&w->lock);
  w->status = status;
  w->done = 1;
  const int abandoned = w->abandoned;
  pthread_cond_signal(&w->changed);
  pthread_mutex_unlock(&w->lock);
  if (abandoned) {
    w->work.discard(w->job);
    free_worker(w);
  }
  return NULL;
}

/* Starts the worker thread with all signals blocked, so that signals are handled by the caller's
 * thread. */
static int start(worker *w) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const int started = pthread_create(&w->thread, NULL, run, w) == 0;
  pthread_sigmask(SIG_SETMASK, &before, NULL);
  return started;
}

static double clock_now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Waits until the work is done or the interval between callbacks ends. Returns 1 if the work is
 * done. */
static int wait_interval(worker *w) {
  struct timespec until;
  clock_gettime(CLOCK_REALTIME, &until);
  until.tv_nsec += interval;
  until.tv_sec += until.tv_nsec / 1000000000;
  until.tv_nsec %= 1000000000;
  pthread_mutex_lock(&w->lock);
  if (!w->done) pthread_cond_timedwait(&w->changed, &w->lock, &until);
  const int done = w->done;
  pthread_mutex_unlock(&w->lock);
  return done;
}

/* Abandons the work unless it is done. Returns 1 if it is abandoned, 0 if it is done. */
static int abandon(worker *w) {
  const pthread_t thread = w->thread;
  pthread_mutex_lock(&w->lock);
  w->abandoned = !w->done;
  if (w->abandoned) w->work.progress->abandoned = 1;
  const int left = w->abandoned;
  pthread_mutex_unlock(&w->lock);
  if (left) pthread_detach(thread);
  return left;
}

static void report(const worker *w, const char *what, double seconds, const arc_callbacks *c) {
  const work_progress *p = w->work.progress;
  if (c->working) c->working(c->context, what, (double)p->stage / p->stages, seconds);
}

arc_status arc_worker_thread_run(const worker_task *work, void *job, const char *what,
                                 const arc_callbacks *callbacks, int *left_behind) {
  *left_behind = 0;
  worker *w = callbacks && (callbacks->stop || callbacks->working) ? malloc(sizeof *w) : NULL;
  if (!w) return work->work(job);
  *w = (worker){.work = *work, .job = job, .levels = omp_get_max_active_levels()};
  pthread_mutex_init(&w->lock, NULL);
  pthread_cond_init(&w->changed, NULL);
  const double begun = clock_now();
  if (!start(w)) {
    free_worker(w);
    return work->work(job);
  }
  while (!wait_interval(w)) {
    report(w, what, clock_now() - begun, callbacks);
    if (callbacks->stop && callbacks->stop(callbacks->context) && abandon(w)) {
      *left_behind = 1;
      return ARC_STOPPED;
    }
  }
  const arc_status status = w->status;
  pthread_join(w->thread, NULL);
  free_worker(w);
  return status;
}
