/* Starting and ending children: the one file that starts programs. Leans on POSIX only.
 *
 * By posix_spawn, so by exec: a bare fork would carry over locks of the libraries.
 */
#include "system/child.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

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

static int set_attributes(posix_spawnattr_t *attributes) {
  sigset_t usual, none;
  sigemptyset(&none);
  sigemptyset(&usual);
  sigaddset(&usual, SIGINT);
  sigaddset(&usual, SIGPIPE);
  sigaddset(&usual, SIGTERM);
  short flags = POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK;
  int failed = posix_spawnattr_setpgroup(attributes, 0);
  if (!failed) failed = posix_spawnattr_setsigdefault(attributes, &usual);
  if (!failed) failed = posix_spawnattr_setsigmask(attributes, &none);
  if (!failed) failed = posix_spawnattr_setflags(attributes, flags);
  return failed;
}

int arc_child_start(const arc_child_def *def, pid_t *process) {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  int failed = posix_spawn_file_actions_init(&actions);
  if (failed) return failed;
  failed = posix_spawnattr_init(&attributes);
  if (!failed) {
    for (int i = 0; i < 3 && !failed; i++)
      failed = posix_spawn_file_actions_adddup2(&actions, def->ends[i], i);
    if (!failed) failed = set_attributes(&attributes);
    if (!failed)
      failed = posix_spawnp(process, def->program, &actions, &attributes, def->arguments,
                            def->environment ? def->environment : environ);
    posix_spawnattr_destroy(&attributes);
  }
  posix_spawn_file_actions_destroy(&actions);
  return failed;
}

int arc_child_kill(pid_t process) {
  int how = -1;
  kill(-process, SIGKILL);
  while (waitpid(process, &how, 0) < 0)
    if (errno != EINTR) return -1; /* somebody else has waited for it */
  return how;
}
