/* Declares functions that call the user's callbacks, any of which may be NULL. */
#ifndef BASE_CALLBACKS_H
#define BASE_CALLBACKS_H

#include "archard/base.h"

static inline int callbacks_stop(const arc_callbacks *c) {
  return c && c->stop && c->stop(c->context);
}

/* Returns ARC_STOPPED with a message if the user stops the computation, else ARC_OK. */
static inline arc_status callbacks_check(const arc_callbacks *c, arc_error *error) {
  return callbacks_stop(c) ? arc_fail(error, ARC_STOPPED, "stopped on request") : ARC_OK;
}

static inline int callbacks_progress(const arc_callbacks *c, const struct arc_wear *wear) {
  return c && c->progress && c->progress(c->context, wear);
}

/* Formats a one-line warning about the accuracy of results and passes it to the warning
 * callback. */
void arc_warn(const arc_callbacks *callbacks, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

#endif
