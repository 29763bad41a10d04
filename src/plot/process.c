/* Starts and ends a child process and exchanges data with it. The child's standard input and output
 * are one socket. Data can be sent to a socket without the signal SIGPIPE, so the caller's signal
 * handlers need not be changed. */
#include "plot/process.h"
#include "system/child.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* --- start of a process ----------------------------------------------------------------------- */

arc_status arc_process_start(arc_process *process, char *const argv[], arc_error *error) {
  int talk[2] = {-1, -1}, errors[2] = {-1, -1}; /* [0]: end in this process, [1]: in the child */
  pid_t pid = 0;
  int opened = arc_child_channel(talk, 1), failed = opened;
  if (!failed) failed = opened = arc_child_channel(errors, 0);
  if (!failed && fcntl(errors[0], F_SETFL, O_NONBLOCK) != 0) failed = opened = errno;
  if (!failed) {
    arc_child_def def = {argv[0], argv, NULL, {talk[1], talk[1], errors[1]}, 0.25, 0};
    failed = arc_child_start(&def, &pid);
  }
  arc_child_close(&talk[1]);
  arc_child_close(&errors[1]);
  if (!failed) {
    *process = (arc_process){pid, talk[0], errors[0]};
    return ARC_OK;
  }
  arc_child_close(&talk[0]);
  arc_child_close(&errors[0]);
  if (opened)
    return arc_fail(error, ARC_IO, "cannot connect to '%s': %s", argv[0], strerror(opened));
  return arc_fail(error, failed == ENOENT ? ARC_MISSING : ARC_IO, "cannot start '%s': %s", argv[0],
                  strerror(failed));
}

/* --- exchange of data ------------------------------------------------------------------------- */

enum { BLOCK = 1 << 16 };

/* Reads the available bytes. Returns the number of bytes, 0 if no bytes are available now, or -1
 * if the child has closed its end. */
static ssize_t take(int descriptor, arc_text *text) {
  char block[BLOCK];
  ssize_t got = read(descriptor, block, sizeof block);
  if (got > 0) arc_text_add(text, block, (size_t)got);
  if (got == 0) return -1;
  if (got < 0) return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR ? 0 : -1;
  return got;
}

/* Sends as many bytes as possible without waiting. Returns the number of bytes, 0 if none can be
 * sent now, or -1 on failure. */
static ssize_t give(int descriptor, const char *bytes, size_t count) {
  ssize_t sent = send(descriptor, bytes, count, MSG_NOSIGNAL | MSG_DONTWAIT);
  if (sent < 0) return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR ? 0 : -1;
  return sent;
}

/* Returns true if the last line of the answer is complete and begins with the text `mark`. */
static int finished(const arc_text *answer, const char *mark) {
  if (answer->length == 0 || answer->data[answer->length - 1] != '\n') return 0;
  size_t start = answer->length - 1;
  while (start > 0 && answer->data[start - 1] != '\n') start--;
  return strncmp(answer->data + start, mark, strlen(mark)) == 0;
}

/* Waits for data, at most 0.1 s, and transfers data in both directions. Returns the number of
 * transferred bytes, or -1 if the child has ended. */
static long one_round(arc_process *process, arc_exchange *exchange, size_t *sent) {
  struct pollfd watched[2] = {{process->talk, POLLIN, 0}, {process->errors, POLLIN, 0}};
  if (*sent < exchange->length) watched[0].events |= POLLOUT;
  long moved = 0;
  if (poll(watched, 2, 100) <= 0) return arc_process_alive(process) ? 0 : -1;
  if (watched[1].revents) {
    ssize_t got = take(process->errors, &exchange->errors);
    if (got < 0) arc_child_close(&process->errors);
    moved += got > 0 ? (long)got : 0;
  }
  if (watched[0].revents & (POLLIN | POLLHUP | POLLERR)) {
    ssize_t got = take(process->talk, &exchange->answer);
    if (got < 0) return -1;
    moved += (long)got;
  }
  if (watched[0].revents & POLLOUT) {
    ssize_t gone = give(process->talk, exchange->question + *sent, exchange->length - *sent);
    if (gone < 0) return -1;
    *sent += (size_t)gone;
    moved += (long)gone;
  }
  return moved;
}

static void drain_errors(arc_process *process, arc_exchange *exchange) {
  while (process->errors >= 0 && take(process->errors, &exchange->errors) > 0) {
  }
}

arc_exchange_end arc_process_exchange(arc_process *process, arc_exchange *exchange) {
  size_t sent = 0;
  double last_sign = seconds();
  arc_exchange_end end = ARC_EXCHANGE_DONE;
  while (sent < exchange->length || !finished(&exchange->answer, exchange->last_line)) {
    long moved = one_round(process, exchange, &sent);
    if (moved > 0) last_sign = seconds();
    if (moved < 0)
      end = ARC_EXCHANGE_DIED;
    else if (exchange->answer.failed || exchange->errors.failed)
      end = ARC_EXCHANGE_MEMORY;
    else if (exchange->answer.length + exchange->errors.length > ARC_EXCHANGE_MOST)
      end = ARC_EXCHANGE_FLOOD;
    else if (exchange->should_stop && exchange->should_stop(exchange->stop_context))
      end = ARC_EXCHANGE_STOPPED;
    else if (seconds() - last_sign > exchange->patience)
      end = ARC_EXCHANGE_SILENT;
    if (end != ARC_EXCHANGE_DONE) break;
  }
  drain_errors(process, exchange);
  return end;
}

/* --- end of a process ------------------------------------------------------------------------- */

/* Returns true if the process runs. The check does not reap the process, so that its exit status
 * is kept for arc_process_end. An open socket does not prove that the process runs, because
 * another program that it started may have the socket open. */
int arc_process_alive(const arc_process *process) {
  if (process->pid <= 0) return 0;
  siginfo_t info = {.si_pid = 0};
  if (waitid(P_PID, (id_t)process->pid, &info, WEXITED | WNOHANG | WNOWAIT) != 0) return 0;
  struct pollfd watched = {process->talk, 0, 0};
  return info.si_pid == 0 && poll(&watched, 1, 0) >= 0 &&
         !(watched.revents & (POLLHUP | POLLERR | POLLNVAL));
}

/* Waits for the end of the process, at most `patience` [s]. Returns true if the process has
 * ended. */
static int wait_for(pid_t pid, double patience, int *how) {
  double until = seconds() + patience;
  for (;;) {
    pid_t got = waitpid(pid, how, WNOHANG);
    if (got == pid) return 1;
    if (got < 0 && errno != EINTR) { /* another caller has already reaped the process */
      *how = -1;
      return 1;
    }
    if (seconds() >= until) return 0;
    nanosleep(&(struct timespec){0, 2000000}, NULL);
  }
}

int arc_process_end(arc_process *process, double patience) {
  int how = -1;
  arc_child_close(&process->talk);
  if (process->pid > 0 && !wait_for(process->pid, patience, &how))
    how = arc_child_kill(process->pid);
  arc_child_ended(process->pid);
  arc_child_close(&process->errors);
  *process = ARC_PROCESS_NONE;
  return how;
}
