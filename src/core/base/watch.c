/* Runs a computation on its own thread while the caller waits. */
#include "core/base/watch.h"

#include <omp.h>
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <time.h>

static const long interval = 50000000; /* [ns] between two calls of callbacks */

/* Data shared by both threads; the last one frees it. */
typedef struct meeting {
  pthread_t thread;
  pthread_mutex_t lock;
  pthread_cond_t changed;
  int done, alone; /* alone: nobody waits */
  int levels;      /* of OpenMP, which every thread has its own of */
  arc_status status;
  watched_work work;
  void *job;
} meeting;

arc_status arc_watch_stage(work_watch *w) {
  if (!w) return ARC_OK;
  w->stage++;
  return w->unwanted ? ARC_STOPPED : ARC_OK;
}

static void end_meeting(meeting *m) {
  pthread_cond_destroy(&m->changed);
  pthread_mutex_destroy(&m->lock);
  free(m);
}

static void *run(void *context) {
  meeting *m = context;
  omp_set_max_active_levels(m->levels);
  const arc_status status = m->work.work(m->job);
  pthread_mutex_lock(&m->lock);
  m->status = status;
  m->done = 1;
  const int alone = m->alone;
  pthread_cond_signal(&m->changed);
  pthread_mutex_unlock(&m->lock);
  if (alone) {
    m->work.discard(m->job);
    end_meeting(m);
  }
  return NULL;
}

/* Starts a thread with blocked signals: the caller handles them. */
static int start(meeting *m) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const int started = pthread_create(&m->thread, NULL, run, m) == 0;
  pthread_sigmask(SIG_SETMASK, &before, NULL);
  return started;
}

static double clock_now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Waits for the work or the interval. Returns 1 if it is done. */
static int wait_a_while(meeting *m) {
  struct timespec until;
  clock_gettime(CLOCK_REALTIME, &until);
  until.tv_nsec += interval;
  until.tv_sec += until.tv_nsec / 1000000000;
  until.tv_nsec %= 1000000000;
  pthread_mutex_lock(&m->lock);
  if (!m->done) pthread_cond_timedwait(&m->changed, &m->lock, &until);
  const int done = m->done;
  pthread_mutex_unlock(&m->lock);
  return done;
}

/* Abandons the work. Returns 0 if it has ended meanwhile. */
static int leave(meeting *m) {
  const pthread_t thread = m->thread;
  pthread_mutex_lock(&m->lock);
  m->alone = !m->done;
  if (m->alone) m->work.progress->unwanted = 1;
  const int left = m->alone;
  pthread_mutex_unlock(&m->lock);
  if (left) pthread_detach(thread);
  return left;
}

static void tell(const meeting *m, const char *what, double seconds, const arc_callbacks *c) {
  const work_watch *w = m->work.progress;
  if (c->working) c->working(c->context, what, (double)w->stage / w->stages, seconds);
}

arc_status arc_watched(const watched_work *work, void *job, const char *what,
                       const arc_callbacks *callbacks, int *left_behind) {
  *left_behind = 0;
  meeting *m = callbacks && (callbacks->stop || callbacks->working) ? malloc(sizeof *m) : NULL;
  if (!m) return work->work(job);
  *m = (meeting){.work = *work, .job = job, .levels = omp_get_max_active_levels()};
  pthread_mutex_init(&m->lock, NULL);
  pthread_cond_init(&m->changed, NULL);
  const double begun = clock_now();
  if (!start(m)) {
    end_meeting(m);
    return work->work(job);
  }
  while (!wait_a_while(m)) {
    tell(m, what, clock_now() - begun, callbacks);
    if (callbacks->stop && callbacks->stop(callbacks->context) && leave(m)) {
      *left_behind = 1;
      return ARC_STOPPED;
    }
  }
  const arc_status status = m->status;
  pthread_join(m->thread, NULL);
  end_meeting(m);
  return status;
}
