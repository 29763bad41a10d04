/* Tries to leave the sandbox, which runs this program instead of gnuplot. Environment variables
 * name the targets: OUTSIDE, a folder with a file "secret" and a folder "empty", and VICTIM, a
 * process. The file "tried" receives a line for each attempt: the attempt, and "held" if it
 * failed or "OUT" if it succeeded. */
#define _GNU_SOURCE
#include <arpa/inet.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <sched.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/inotify.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <unistd.h>

static FILE *tried;
static char secret[PATH_MAX], name[PATH_MAX], outside[PATH_MAX];
static pid_t victim;

static void tell(const char *what, int out) {
  fprintf(tried, "%s: %s\n", what, out ? "OUT" : "held");
  fflush(tried);
}

#define TRY(what, succeeds) tell(what, (succeeds) ? 1 : 0)

static const char *beside(const char *leaf) {
  snprintf(name, sizeof name, "%s/%s", outside, leaf);
  return name;
}

static const char *of_process(pid_t process, const char *leaf) {
  snprintf(name, sizeof name, "/proc/%d/%s", (int)process, leaf);
  return name;
}

static const char *of_victim(const char *leaf) {
  return of_process(victim, leaf);
}

/* --- files ------------------------------------------------------------------------------------ */

static int opens(const char *path, int how) {
  const int file = open(path, how | O_NONBLOCK | O_NOCTTY, 0600);
  if (file >= 0) close(file);
  return file >= 0;
}

static int reads(const char *path) {
  char byte;
  const int file = open(path, O_RDONLY | O_NONBLOCK);
  const int got = file >= 0 && read(file, &byte, 1) == 1;
  if (file >= 0) close(file);
  return got;
}

static int through_link(const char *target, const char *leaf) {
  unlink("link");
  if (symlink(target, "link") != 0) return 0;
  char path[PATH_MAX];
  snprintf(path, sizeof path, "link%s", leaf);
  const int got = reads(path);
  unlink("link");
  return got;
}

static int lists(const char *path) {
  DIR *list = opendir(path);
  if (list) closedir(list);
  return list != NULL;
}

static int by_handle(void) {
  struct {
    struct file_handle head;
    unsigned char rest[128];
  } handle = {.head.handle_bytes = 128};
  int mount;
  if (name_to_handle_at(AT_FDCWD, secret, &handle.head, &mount, 0) != 0) return 0;
  return open_by_handle_at(AT_FDCWD, &handle.head, O_RDONLY) >= 0;
}

static int has_more_descriptors(void) {
  for (int file = 3; file < 1024; file++)
    if (file != fileno(tried) && fcntl(file, F_GETFD) >= 0) return 1;
  return 0;
}

static void try_files(void) {
  struct timespec now[2] = {{0, 0}, {0, 0}};
  char here[PATH_MAX], path[2 * PATH_MAX];
  TRY("read a file outside", reads(secret));
  TRY("list a folder outside", lists(outside));
  TRY("list the root", lists("/"));
  TRY("open a file outside to write", opens(secret, O_WRONLY));
  TRY("open it to append", opens(secret, O_WRONLY | O_APPEND));
  TRY("open it to cut it off", opens(secret, O_WRONLY | O_TRUNC));
  TRY("cut it off by name", truncate(secret, 0) == 0);
  TRY("make a file outside", opens(beside("new"), O_WRONLY | O_CREAT));
  TRY("make a file without a name outside", opens(outside, O_WRONLY | O_TMPFILE));
  TRY("make a folder outside", mkdir(beside("folder"), 0700) == 0);
  TRY("remove a file outside", unlink(secret) == 0);
  TRY("remove a folder outside", rmdir(beside("empty")) == 0);
  TRY("take a file in", rename(secret, "taken") == 0);
  TRY("put a file out", opens("mine", O_WRONLY | O_CREAT) && rename("mine", beside("mine")) == 0);
  TRY("exchange one with another",
      syscall(SYS_renameat2, AT_FDCWD, "mine", AT_FDCWD, secret, 2) == 0);
  TRY("a second name inside for a file outside", link(secret, "second") == 0 && reads("second"));
  TRY("a second name outside", link("mine", beside("second")) == 0);
  TRY("a link to a file outside", through_link(secret, ""));
  TRY("a link to a folder outside", through_link(outside, "/secret"));
  TRY("a link to the root", (snprintf(path, sizeof path, "%s", secret), through_link("/", path)));
  TRY("a link made outside", symlink("x", beside("link")) == 0);
  TRY("the root as /proc shows it",
      (snprintf(path, sizeof path, "/proc/self/root%s", secret), reads(path)));
  TRY("that of the victim",
      (snprintf(path, sizeof path, "/proc/%d/root%s", (int)victim, secret), reads(path)));
  TRY("its working folder", lists(of_victim("cwd")));
  TRY("the folder above", lists(".."));
  TRY("from the folder itself",
      getcwd(here, sizeof here) && chdir(outside) == 0 && reads("secret"));
  if (chdir(here) != 0) abort();
  TRY("change the rights of a file outside", chmod(secret, 0666) == 0);
  TRY("by another call", syscall(452, AT_FDCWD, secret, 0666, 0) == 0);
  TRY("change its owner", chown(secret, 1, 1) == 0);
  TRY("change its times", utimensat(AT_FDCWD, secret, now, 0) == 0);
  TRY("give it an attribute", setxattr(secret, "user.x", "x", 1, 0) == 0);
  TRY("read its attributes", listxattr(secret, path, sizeof path) >= 0);
  TRY("watch it", inotify_add_watch(inotify_init(), secret, IN_ALL_EVENTS) >= 0);
  TRY("open it by its handle", by_handle());
  TRY("make a device", mknod("device", S_IFBLK | 0600, makedev(254, 0)) == 0);
  TRY("a descriptor that was left open", has_more_descriptors());
  TRY("a file in /tmp", opens("/tmp/archard-out", O_WRONLY | O_CREAT));
  TRY("one in /dev/shm", opens("/dev/shm/archard-out", O_WRONLY | O_CREAT));
  TRY("read the users' file", reads("/etc/passwd"));
  TRY("read a home", lists(getenv("HOME") ? getenv("HOME") : "/root"));
  TRY("the disk", opens("/dev/vda", O_RDONLY) || opens("/dev/sda", O_RDONLY));
  TRY("memory", opens("/dev/mem", O_RDONLY) || opens("/proc/kcore", O_RDONLY));
  TRY("the terminal", opens("/dev/tty", O_RDWR));
  TRY("another terminal", opens("/dev/ptmx", O_RDWR));
  TRY("a setting of the system", opens("/proc/sys/kernel/core_pattern", O_WRONLY));
  TRY("a setting of its group", opens("/sys/fs/cgroup/cgroup.procs", O_WRONLY));
}

/* --- programs --------------------------------------------------------------------------------- */

/* Replaces this process by another program. If that fails, returns, because the sandbox allows
 * no further process. The line "OUT" is written first; it is overwritten if the other program
 * does not start. */
static void try_program(const char *what, const char *path, char *const argv[]) {
  const long line = ftell(tried);
  tell(what, 1);
  if (strchr(path, '/'))
    execv(path, argv);
  else
    syscall(SYS_execveat, atoi(path), "", argv, environ, AT_EMPTY_PATH);
  if (ftruncate(fileno(tried), line) != 0) abort();
  fseek(tried, line, SEEK_SET);
  tell(what, 0);
}

static const char *own_script(void) {
  static const char text[] = "#!/bin/sh\nexit 0\n";
  const int file = open("script", O_WRONLY | O_CREAT | O_TRUNC, 0700);
  const int complete = file >= 0 && write(file, text, sizeof text - 1) == sizeof text - 1;
  if (file >= 0) close(file);
  return complete ? "./script" : "no/script";
}

static const char *from_memory(void) {
  static char number[12] = "-1";
  const int file = memfd_create("x", 0);
  if (file >= 0 && write(file, "#!/bin/sh\n", 10) == 10)
    snprintf(number, sizeof number, "%d", file);
  return number;
}

static void try_programs(void) {
  char *sh[] = {"sh", "-c", "exit 0", NULL}, *su[] = {"su", "-c", "true", NULL};
  char *loader[] = {"ld", "/bin/sh", "-c", "touch hit", NULL}, *env[] = {"env", NULL};
  TRY("a shell as libraries call it", system("exit 0") == 0);
  try_program("a shell", "/bin/sh", sh);
  try_program("another program", "/usr/bin/env", env);
  try_program("one with the rights of root", "/bin/su", su);
  try_program("the same elsewhere", "/usr/bin/su", su);
  try_program("a script of its own", own_script(), env);
  try_program("a program in memory", from_memory(), env);
  tell("one through the loader, which may run: the caller looks for its file", 0);
  execv("/lib64/ld-linux-x86-64.so.2", loader);
}

/* --- processes -------------------------------------------------------------------------------- */

static int forks(long (*start)(void)) {
  const long child = start();
  if (child == 0) _exit(0);
  if (child > 0) waitpid((pid_t)child, NULL, 0);
  return child > 0;
}

static long by_fork(void) {
  return fork();
}
static long by_clone(void) {
  return syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0);
}
static long by_orphaning_clone(void) {
  return syscall(SYS_clone, CLONE_PARENT, 0, 0, 0, 0);
}
static long by_clone3(void) {
  return syscall(435, &(uint64_t[8]){[4] = SIGCHLD}, 64);
}
#ifdef SYS_fork
static long by_old_fork(void) {
  return syscall(SYS_fork);
}
#else
static long by_old_fork(void) {
  return -1;
}
#endif

static void try_processes(void) {
  TRY("a process", forks(by_fork));
  TRY("by the old call", forks(by_old_fork));
  TRY("by clone", forks(by_clone));
  TRY("by clone, of the same parent", forks(by_orphaning_clone));
  TRY("by clone3", forks(by_clone3));
}

/* --- connections and the system --------------------------------------------------------------- */

static int connects(int family, int kind) {
  const int s = socket(family, kind, 0);
  if (s >= 0) close(s);
  return s >= 0;
}

static void try_connections(void) {
  int ends[2];
  char ring[256] = {0};
  TRY("a connection", connects(AF_INET, SOCK_STREAM));
  TRY("a datagram", connects(AF_INET, SOCK_DGRAM));
  TRY("the same of version 6", connects(AF_INET6, SOCK_STREAM));
  TRY("a socket of this machine", connects(AF_UNIX, SOCK_STREAM));
  TRY("one of the kernel", connects(AF_NETLINK, SOCK_RAW));
  TRY("packets", connects(AF_PACKET, SOCK_RAW));
  TRY("a virtual machine's", connects(40, SOCK_STREAM));
  TRY("a pair of another family", socketpair(AF_TIPC, SOCK_STREAM, 0, ends) == 0);
  TRY("a pair of datagrams", socketpair(AF_UNIX, SOCK_DGRAM, 0, ends) == 0);
  TRY("a pair of packets", socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) == 0);
  TRY("a pair of streams, whose buffers no limit counts",
      socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0);
  TRY("a ring of calls", syscall(425, 4, ring) >= 0);
}

static void try_system(void) {
  char word[16];
  int ends[2];
  struct rlimit l = {RLIM_INFINITY, RLIM_INFINITY};
  TRY("a space of its own for users", unshare(CLONE_NEWUSER) == 0);
  TRY("one for mounts", unshare(CLONE_NEWNS) == 0);
  TRY("one by clone", syscall(SYS_clone, CLONE_NEWUSER | SIGCHLD, 0, 0, 0, 0) > 0);
  TRY("one by clone3", syscall(435, &(uint64_t[8]){CLONE_NEWUSER}, 64) >= 0);
  TRY("the victim's", setns(open(of_victim("ns/mnt"), O_RDONLY), 0) == 0);
  TRY("a mount", mount("none", ".", "tmpfs", 0, "") == 0);
  TRY("a mount by the new calls", syscall(430, "tmpfs", 0) >= 0);
  TRY("another root", chroot(".") == 0);
  TRY("a program in the kernel", syscall(SYS_bpf, 0, NULL, 0) >= 0 || errno == EINVAL);
  TRY("counters of the processor",
      syscall(SYS_perf_event_open, &(char[128]){0}, 0, -1, -1, 0) >= 0);
  TRY("faults of pages", syscall(SYS_userfaultfd, 0) >= 0);
  TRY("keys", syscall(SYS_keyctl, 0, -3, 0) >= 0);
  TRY("memory of the system", syscall(SYS_shmget, 77, 4096, 01600) >= 0);
  TRY("memory that others made", syscall(SYS_shmctl, 0, 14, (char[256]){0}) >= 0); /* SHM_INFO */
  TRY("attaching it", syscall(SYS_shmat, 0, NULL, 0) != -1 || errno != EPERM);
  TRY("messages of others", syscall(SYS_msgrcv, 0, word, 8, 0, 04000) >= 0 || errno != EPERM);
  TRY("semaphores of others", syscall(SYS_semctl, 0, 0, 3) >= 0 || errno != EPERM);
  TRY("shared memory, which no limit counts",
      mmap(NULL, 1 << 20, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0) != MAP_FAILED);
  TRY("rights of an open file", fchmod(fileno(tried), 0600) == 0);
  TRY("rights of the user, of an open file", fchmod(fileno(tried), 04700) == 0);
  TRY("attributes of an open file", fsetxattr(fileno(tried), "user.x", "1", 1, 0) == 0);
  TRY("flags of an open file", ioctl(fileno(tried), 0x40086602, &(long){0}) == 0 || errno != EPERM);
  TRY("a queue of messages", syscall(SYS_mq_open, "out", O_CREAT | O_RDWR, 0600, NULL) >= 0);
  TRY("typing into the terminal", ioctl(0, TIOCSTI, "x") == 0 || errno != EPERM);
  TRY("more processes again", setrlimit(RLIMIT_NPROC, &l) == 0);
  TRY("larger files again", setrlimit(RLIMIT_FSIZE, &l) == 0);
  TRY("more memory again", setrlimit(RLIMIT_DATA, &l) == 0);
  TRY("a larger stack again", setrlimit(RLIMIT_STACK, &l) == 0);
  TRY("more open files again", setrlimit(RLIMIT_NOFILE, &(struct rlimit){4096, 4096}) == 0);
  TRY("a larger buffer of a pipe", pipe(ends) != 0 || fcntl(ends[0], F_SETPIPE_SZ, 1 << 20) > 0);
  char host[HOST_NAME_MAX + 1] = "";
  gethostname(host, sizeof host);
  TRY("the name of the machine", sethostname(host, strlen(host)) == 0);
}

static void try_others(void) {
  char word[8];
  struct iovec to = {word, 8}, from = {(void *)&victim, 8};
  struct rlimit l = {0, 0};
  TRY("a signal to the victim", kill(victim, SIGTERM) == 0);
  TRY("one by its handle",
      syscall(SYS_pidfd_send_signal, syscall(SYS_pidfd_open, victim, 0), SIGTERM, NULL, 0) == 0);
  TRY("its environment", reads(of_victim("environ")));
  TRY("its memory", opens(of_victim("mem"), O_RDWR));
  TRY("its files", lists(of_victim("fd")));
  TRY("the environment of the parent", reads(of_process(getppid(), "environ")));
  TRY("memory of the parent", opens(of_process(getppid(), "mem"), O_RDONLY));
  TRY("the output of the parent", opens(of_process(getppid(), "fd/1"), O_WRONLY));
  TRY("holding it", ptrace(PTRACE_ATTACH, victim, NULL, NULL) == 0);
  TRY("seizing it", ptrace(PTRACE_SEIZE, victim, NULL, NULL) == 0);
  TRY("reading it", process_vm_readv(victim, &to, 1, &from, 1, 0) >= 0);
  TRY("writing it", process_vm_writev(victim, &to, 1, &from, 1, 0) >= 0);
  TRY("a descriptor of it", syscall(438, syscall(SYS_pidfd_open, victim, 0), 0, 0) >= 0);
  TRY("its limits", prlimit(victim, RLIMIT_CPU, &l, NULL) == 0);
  TRY("its priority", setpriority(PRIO_PROCESS, (id_t)victim, 19) == 0);
  TRY("its processors", sched_setaffinity(victim, sizeof(cpu_set_t), &(cpu_set_t){{1}}) == 0);
}

/* --- bombs ------------------------------------------------------------------------------------ */

static int has_no_end_of_processes(void) {
  int count = 0;
  while (count < 5000) {
    const pid_t child = fork();
    if (child < 0) break;
    if (child == 0) {
      pause();
      _exit(0);
    }
    count++;
  }
  signal(SIGTERM, SIG_IGN);
  kill(0, SIGTERM);
  while (wait(NULL) > 0) {
  }
  return count == 5000;
}

static int has_no_end_of_memory(void) {
  size_t had = 0;
  while (had < 4096 && malloc(1 << 20)) had++;
  return had == 4096;
}

static int has_no_end_of_file(void) {
  signal(SIGXFSZ, SIG_IGN);
  const int file = open("large", O_WRONLY | O_CREAT, 0600);
  const int large = file < 0 || ftruncate(file, (off_t)8 << 30) == 0;
  unlink("large");
  return large;
}

int main(void) {
  snprintf(outside, sizeof outside, "%s", getenv("OUTSIDE"));
  snprintf(secret, sizeof secret, "%s/secret", outside);
  victim = (pid_t)atoi(getenv("VICTIM"));
  tried = fopen("tried", "w");
  if (!tried) return 1;
  try_files();
  try_processes();
  try_connections();
  try_system();
  try_others();
  TRY("memory without an end", has_no_end_of_memory());
  TRY("a file without an end", has_no_end_of_file());
  TRY("processes without an end", has_no_end_of_processes());
  try_programs();
  return 0;
}
