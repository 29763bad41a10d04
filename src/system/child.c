/* Starts and ends child processes; no other file starts programs. A child receives the signal
 * SIGKILL when its parent ends (Linux). posix_spawn cannot request this signal, so vfork is used.
 * vfork copies no memory and runs no fork handlers of libraries. */
#define _GNU_SOURCE /* for vfork, execvpe, close_range */
#include "system/child.h"
#include "system/jail.h"
#include "system/memory_limit.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/close_range.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

void arc_child_close(int *descriptor) {
  if (*descriptor >= 0) close(*descriptor);
  *descriptor = -1;
}

int arc_child_channel(int ends[2], int is_socket) {
  if ((is_socket ? socketpair(AF_UNIX, SOCK_STREAM, 0, ends) : pipe(ends)) != 0) return errno;
  for (int i = 0; i < 2; i++)
    if (fcntl(ends[i], F_SETFD, FD_CLOEXEC) != 0) return errno;
  return 0;
}

/* --- code that runs in the child, which must not write to memory shared with its parent ------- */

/* Sets the signals of the child. Ignored signals stay ignored, except SIGINT, SIGPIPE and
 * SIGTERM. Handlers are removed, because they could run in the child when signals are unblocked.
 * Returns 0 or an errno. */
static int use_own_signals(void) {
  struct sigaction now, usual = {.sa_handler = SIG_DFL};
  sigset_t none;
  sigemptyset(&none);
  for (int n = 1; n < NSIG; n++)
    if (sigaction(n, NULL, &now) == 0 &&
        (now.sa_handler != SIG_IGN || n == SIGINT || n == SIGPIPE || n == SIGTERM))
      sigaction(n, &usual, NULL);
  return sigprocmask(SIG_SETMASK, &none, NULL) == 0 ? 0 : errno;
}

/* Connects standard input, output and error to the descriptors `ends`. Returns 0 or an errno. */
static int use_own_ends(const int ends[3]) {
  for (int i = 0; i < 3; i++)
    if (dup2(ends[i], i) < 0 || fcntl(i, F_SETFD, 0) != 0) return errno;
  close_range(3, ~0u, CLOSE_RANGE_CLOEXEC); /* has no effect on kernels without this call */
  return 0;
}

/* HAS_SHADOW is 1 if the program is built with sanitizers. Then memory cannot be limited, because
 * the shadow memory of sanitizers counts as data. */
#ifdef __SANITIZE_ADDRESS__
enum { HAS_SHADOW = 1 };
#else
enum { HAS_SHADOW = 0 };
#endif

/* Largest stack [bytes] and number of open files of a child whose memory is limited. The data do
 * not contain the stack, nor the buffers of pipes in the kernel. */
enum { CHILD_STACK = 8 << 20, CHILD_FILES = 256 };

/* Limits the data of the child to `bytes` (0: no limit) and the data at its start, `own`. Its
 * mappings are not limited, because they contain libraries, whose size depends on the program.
 * Returns 0 or an errno. */
static int use_own_memory(rlim_t bytes, rlim_t own) {
  struct rlimit all;
  if (bytes == 0 || HAS_SHADOW) return 0;
  if (getrlimit(RLIMIT_AS, &all) != 0) return errno;
  all.rlim_cur = all.rlim_max;
  const int done =
      setrlimit(RLIMIT_AS, &all) == 0 && arc_jail_limit(RLIMIT_DATA, (double)(bytes + own)) &&
      arc_jail_limit(RLIMIT_STACK, CHILD_STACK) && arc_jail_limit(RLIMIT_NOFILE, CHILD_FILES);
  return done ? 0 : errno;
}

static int confined; /* true if children must not start processes */

/* Replaces the child by the program. Returns only on failure, with an errno. */
static int become(const arc_child_def *def, pid_t parent, rlim_t memory) {
  if (setpgid(0, 0) != 0 || prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) return errno;
  if (getppid() != parent) return ESRCH; /* the parent has already ended */
  int failed = use_own_ends(def->ends);
  if (!failed) failed = use_own_signals();
  const rlim_t own = ARC_CHILD_OWN_MEMORY + (def->again ? arc_memory_limit_base() : 0);
  if (!failed) failed = use_own_memory(memory, own);
  if (failed) return failed;
  /* the leak check of sanitizers must be able to start a process */
  if (confined && !HAS_SHADOW) arc_jail_alone();
  execvpe(def->program, def->arguments, def->environment ? def->environment : environ);
  return errno;
}

/* --- code that runs in this process ----------------------------------------------------------- */

/* Starts the child. If the child fails, it stores the errno in memory that it shares with its
 * parent. Returns 0 or an errno. */
static int begin(const arc_child_def *def, rlim_t memory, pid_t *process) {
  volatile int failed = 0;
  const pid_t parent = getpid(), child = vfork();
  if (child < 0) return errno;
  if (child == 0) {
    failed = become(def, parent, memory);
    _exit(127);
  }
  *process = child;
  if (failed) waitpid(child, NULL, 0);
  return failed;
}

int arc_child_start(const arc_child_def *def, pid_t *process) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const rlim_t memory = arc_memory_limit_reserve(def->part);
  const int failed = begin(def, memory, process);
  arc_memory_limit_assign(memory, failed ? 0 : *process);
  pthread_sigmask(SIG_SETMASK, &before, NULL);
  return failed;
}

void arc_child_confine(void) {
  confined = 1;
}

int arc_child_again(char *const argv[]) {
  execv("/proc/self/exe", argv);
  return errno;
}

int arc_child_kill(pid_t process) {
  int how = -1;
  kill(-process, SIGKILL);
  while (waitpid(process, &how, 0) < 0)
    if (errno != EINTR) break; /* another caller has already reaped the child */
  arc_child_ended(process);
  return how;
}

void arc_child_ended(pid_t process) {
  arc_memory_limit_release(process);
}
