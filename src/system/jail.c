/* Restricts the process by means of Linux: Landlock for files, a filter of system calls, and
 * resource limits. Constants newer than the headers of Debian 12 are defined here. The kernel
 * reports which features it supports. */
#define _GNU_SOURCE /* for O_PATH, dl_iterate_phdr, syscall */
#include "system/jail.h"

#include <dirent.h>
#include <elf.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <link.h>
#include <linux/audit.h>
#include <linux/capability.h>
#include <linux/filter.h>
#include <linux/fs.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

/* --- files ------------------------------------------------------------------------------------ */

#if __has_include(<linux/landlock.h>)

#include <linux/landlock.h>

/* Rights of Landlock in the order of its versions. */
enum {
  EXECUTE = 1 << 0,
  WRITE_FILE = 1 << 1,
  READ_FILE = 1 << 2,
  READ_DIR = 1 << 3,
  REMOVE_DIR = 1 << 4,
  REMOVE_FILE = 1 << 5,
  MAKE_DIR = 1 << 7,
  MAKE_REG = 1 << 8,
  MAKE_BLOCK = 1 << 11,
  MAKE_SYM = 1 << 12,
  VERSION_1 = (1 << 13) - 1,
  REFER = 1 << 13,     /* since Landlock version 2 */
  TRUNCATE = 1 << 14,  /* since Landlock version 3 */
  IOCTL_DEV = 1 << 15, /* since Landlock version 5 */
  LOOK = READ_FILE | READ_DIR,
  CHANGE =
      WRITE_FILE | REMOVE_DIR | REMOVE_FILE | MAKE_DIR | MAKE_REG | MAKE_SYM | REFER | TRUNCATE,
  OF_A_FILE = EXECUTE | WRITE_FILE | READ_FILE | TRUNCATE | IOCTL_DEV
};

typedef struct rules {
  int set, failed;
  uint64_t handled;
} rules;

/* The rights that Landlock restricts: access to files, connections (since version 4), and signals
 * and abstract sockets of other processes (since version 6). */
typedef struct ruleset {
  uint64_t files, net, scoped;
} ruleset;

static rules begin_rules(void) {
  const int version =
      (int)syscall(SYS_landlock_create_ruleset, NULL, 0, LANDLOCK_CREATE_RULESET_VERSION);
  rules r = {.set = -1, .failed = 1};
  if (version < 3) return r; /* before version 3 Landlock does not prevent truncation */
  r.handled = VERSION_1 | REFER | TRUNCATE | (version < 5 ? 0u : (unsigned)IOCTL_DEV);
  const ruleset all = {r.handled, version < 4 ? 0 : 3, version < 6 ? 0 : 3};
  const size_t known = version < 4 ? 8 : version < 6 ? 16 : 24;
  r.set = (int)syscall(SYS_landlock_create_ruleset, &all, known, 0);
  r.failed = r.set < 0;
  return r;
}

/* Adds a rule for a file or folder. A missing file needs no rule. */
static void allow(rules *r, const char *path, uint64_t rights) {
  struct stat facts;
  const int file = path && !r->failed ? open(path, O_PATH | O_CLOEXEC) : -1;
  if (file < 0) return;
  if (fstat(file, &facts) == 0 && !S_ISDIR(facts.st_mode)) rights &= OF_A_FILE;
  const struct landlock_path_beneath_attr rule = {rights & r->handled, file};
  if (syscall(SYS_landlock_add_rule, r->set, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) != 0)
    r->failed = 1;
  close(file);
}

/* Allows files that programs need to start, and fonts for gnuplot, but no personal files. Landlock
 * itself allows the public data of other processes. */
static void allow_system(rules *r) {
  static const char *const looked_at[] = {
      "/usr/lib",
      "/usr/lib32",
      "/usr/lib64",
      "/usr/share",
      "/usr/local/lib",
      "/usr/local/share",
      "/lib",
      "/lib64",
      "/etc/ld.so.cache",
      "/etc/ld.so.preload",
      "/etc/fonts",
      "/etc/localtime",
      "/var/cache/fontconfig",
      "/sys/devices/system",
      "/sys/fs/cgroup",
      "/dev/zero",
      "/proc/self",
      "/proc/meminfo",
      "/proc/cpuinfo",
      "/proc/stat",
      "/proc/sys/kernel/random/boot_id",
#ifdef __SANITIZE_ADDRESS__
      "/proc",
#endif
  };
  static const char *const devices[] = {"/dev/null", "/dev/urandom"};
  for (size_t i = 0; i < sizeof looked_at / sizeof *looked_at; i++) allow(r, looked_at[i], LOOK);
  for (size_t i = 0; i < sizeof devices / sizeof *devices; i++)
    allow(r, devices[i], READ_FILE | WRITE_FILE);
}

/* Allows access to a library of this program, in any folder. The first library in the list is the
 * program itself, which contains the name of its loader. */
static int allow_library(struct dl_phdr_info *library, size_t size, void *context) {
  rules *r = context;
  (void)size;
  allow(r, library->dlpi_name, READ_FILE);
  for (int i = 0; i < library->dlpi_phnum; i++)
    if (library->dlpi_phdr[i].p_type == PT_INTERP)
      allow(r, (const char *)(library->dlpi_addr + library->dlpi_phdr[i].p_vaddr),
            READ_FILE | EXECUTE);
  return 0;
}

/* Allows access to a program. If the program is outside the system folders, also allows the folders
 * lib and share/gnuplot beside its folder. The rest of share is not allowed, because in a home
 * folder it contains personal files. */
static void allow_program(rules *r, const char *path) {
  char whole[PATH_MAX], beside[PATH_MAX + 16];
  if (!path || !realpath(path, whole)) return;
  allow(r, whole, READ_FILE | EXECUTE);
  char *slash = strrchr(whole, '/');
  *slash = '\0';
  slash = strrchr(whole, '/');
  if (!slash || slash == whole) return;
  *slash = '\0';
  snprintf(beside, sizeof beside, "%s/lib", whole);
  allow(r, beside, LOOK);
  snprintf(beside, sizeof beside, "%s/share/gnuplot", whole);
  allow(r, beside, LOOK);
}

static int confine_files(const arc_jail *jail) {
  rules r = begin_rules();
  allow_system(&r);
  dl_iterate_phdr(allow_library, &r);
  allow(&r, "/proc/self/exe", READ_FILE | EXECUTE);
  allow_program(&r, jail->program);
  allow(&r, jail->read, LOOK);
  allow(&r, jail->write, LOOK | CHANGE);
  const int done = !r.failed && syscall(SYS_landlock_restrict_self, r.set, 0) == 0;
  if (r.set >= 0) close(r.set);
  return done;
}

/* Enters a domain of Landlock of its own. A process cannot read the memory or use the files of a
 * process outside its domain, such as its parent. A ruleset must not be empty; this one
 * refuses only to create block devices. */
static void leave_domain(void) {
  const ruleset own = {.files = MAKE_BLOCK};
  const int set = (int)syscall(SYS_landlock_create_ruleset, &own, sizeof own.files, 0);
  if (set < 0) return;
  syscall(SYS_landlock_restrict_self, set, 0);
  close(set);
}

#else

static void leave_domain(void) {}

static int confine_files(const arc_jail *jail) {
  (void)jail;
  return 0;
}

#endif

/* --- system calls ----------------------------------------------------------------------------- */

#if defined(__x86_64__)
#define MACHINE AUDIT_ARCH_X86_64
#elif defined(__aarch64__)
#define MACHINE AUDIT_ARCH_AARCH64
#elif defined(__riscv) && __riscv_xlen == 64
#define MACHINE AUDIT_ARCH_RISCV64
#endif

#ifdef MACHINE

/* Sanitizers need ptrace, because they stop their threads to search for leaks. */
#ifdef __SANITIZE_ADDRESS__
#define HOLD SYS_kcmp
#else
#define HOLD SYS_ptrace
#endif

/* Denied system calls. They concern connections, other processes, execution of files without a
 * name, settings of the system, and properties of files that Landlock does not cover (rights,
 * owners, times, attributes, notifications of changes). */
static const unsigned denied[] = {SYS_socket,
                                  SYS_bind,
                                  SYS_connect,
                                  SYS_listen,
                                  SYS_accept,
                                  SYS_accept4,
                                  HOLD,
                                  SYS_process_vm_readv,
                                  SYS_process_vm_writev,
                                  SYS_kcmp,
                                  SYS_setpriority,
                                  SYS_ioprio_set,
                                  SYS_sched_setaffinity,
                                  SYS_sched_setscheduler,
                                  SYS_sched_setparam,
                                  SYS_sched_setattr,
                                  SYS_execveat,
                                  SYS_fchmodat,
                                  SYS_fchownat,
                                  SYS_setxattr,
                                  SYS_lsetxattr,
                                  SYS_getxattr,
                                  SYS_lgetxattr,
                                  SYS_listxattr,
                                  SYS_llistxattr,
                                  SYS_removexattr,
                                  SYS_lremovexattr,
                                  SYS_fchown,
                                  SYS_fsetxattr,
                                  SYS_fgetxattr,
                                  SYS_flistxattr,
                                  SYS_fremovexattr,
                                  SYS_utimensat,
                                  SYS_mknodat,
                                  SYS_open_by_handle_at,
                                  SYS_inotify_init1,
                                  SYS_fanotify_init,
                                  SYS_unshare,
                                  SYS_setns,
                                  SYS_mount,
                                  SYS_umount2,
                                  SYS_pivot_root,
                                  SYS_chroot,
                                  SYS_bpf,
                                  SYS_perf_event_open,
                                  SYS_userfaultfd,
                                  SYS_keyctl,
                                  SYS_add_key,
                                  SYS_request_key,
                                  SYS_init_module,
                                  SYS_finit_module,
                                  SYS_delete_module,
                                  SYS_kexec_load,
                                  SYS_reboot,
                                  SYS_swapon,
                                  SYS_swapoff,
                                  SYS_sethostname,
                                  SYS_setdomainname,
                                  SYS_settimeofday,
                                  SYS_clock_settime,
                                  SYS_adjtimex,
                                  SYS_acct,
                                  SYS_quotactl,
                                  SYS_syslog,
                                  SYS_mq_open,
                                  SYS_mq_unlink,
                                  SYS_shmget,
                                  SYS_shmat,
                                  SYS_shmctl,
                                  SYS_msgget,
                                  SYS_msgsnd,
                                  SYS_msgrcv,
                                  SYS_msgctl,
                                  SYS_semget,
                                  SYS_semop,
                                  SYS_semtimedop,
                                  SYS_semctl};

/* Older system calls with the same effects as denied calls, if the architecture has them. */
#ifdef SYS_chmod
static const unsigned older[] = {SYS_chmod, SYS_chown,  SYS_lchown,    SYS_mknod,
                                 SYS_utime, SYS_utimes, SYS_futimesat, SYS_inotify_init,
                                 SYS_iopl,  SYS_ioperm, SYS_modify_ldt};
#else
static const unsigned older[] = {SYS_chroot};
#endif

/* System calls whose names older headers do not define. Their numbers are the same on all
 * architectures: io_uring, mounts, pidfd_getfd, fchmodat2, attributes. */
static const unsigned newer[] = {425, 426, 427, 428, 429, 430, 431, 432, 433,
                                 438, 442, 452, 463, 464, 465, 466, 467, 469};

/* System calls for which programs have an alternative (memfd_create, clone3, memfd_secret). They
 * fail as if the kernel did not support them. */
static const unsigned unknown[] = {SYS_memfd_create, 435, 447};

typedef struct filter {
  struct sock_filter code[512];
  unsigned short length;
} filter;

static void add(filter *f, unsigned short code, uint32_t value, unsigned char yes,
                unsigned char no) {
  f->code[f->length++] = (struct sock_filter){code, yes, no, value};
}

static void load(filter *f, size_t offset) {
  add(f, BPF_LD | BPF_W | BPF_ABS, (uint32_t)offset, 0, 0);
}

static void end(filter *f, uint32_t action) {
  add(f, BPF_RET | BPF_K, action, 0, 0);
}

static void refuse(filter *f, const unsigned *calls, size_t count, int why) {
  for (size_t i = 0; i < count; i++) {
    add(f, BPF_JMP | BPF_JEQ | BPF_K, calls[i], 0, 1);
    end(f, SECCOMP_RET_ERRNO | (uint32_t)why);
  }
}

/* Refuses a call depending on the bits `mask` in the lower half of an argument: with `when` 1 if
 * they equal `value`, with `when` 0 if they differ from it. */
static void refuse_where(filter *f, unsigned call, int argument, uint32_t mask, uint32_t value,
                         int when) {
  load(f, offsetof(struct seccomp_data, nr));
  add(f, BPF_JMP | BPF_JEQ | BPF_K, call, 0, 4);
  load(f, offsetof(struct seccomp_data, args) + 8 * (size_t)argument);
  add(f, BPF_ALU | BPF_AND | BPF_K, mask, 0, 0);
  add(f, BPF_JMP | BPF_JEQ | BPF_K, value, when ? 0 : 1, when ? 1 : 0);
  end(f, SECCOMP_RET_ERRNO | EPERM);
}

/* Allows only calls of this architecture with their 64-bit numbers. */
static void begin(filter *f) {
  load(f, offsetof(struct seccomp_data, arch));
  add(f, BPF_JMP | BPF_JEQ | BPF_K, MACHINE, 1, 0);
  end(f, SECCOMP_RET_KILL_PROCESS);
  load(f, offsetof(struct seccomp_data, nr));
  add(f, BPF_JMP | BPF_JGE | BPF_K, 1u << 30, 0, 1); /* x32 numbers */
  end(f, SECCOMP_RET_ERRNO | EPERM);
}

static void write_filter(filter *f) {
  enum { SOCK_TYPE = 0xf }; /* without the flags of the argument */
  const uint32_t all = UINT32_MAX, spaces = CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS |
                                            CLONE_NEWIPC | CLONE_NEWUSER | CLONE_NEWPID |
                                            CLONE_NEWNET;
  begin(f);
  refuse(f, denied, sizeof denied / sizeof *denied, EPERM);
  refuse(f, older, sizeof older / sizeof *older, EPERM);
  refuse(f, newer, sizeof newer / sizeof *newer, EPERM);
  refuse(f, unknown, sizeof unknown / sizeof *unknown, ENOSYS);
  /* AF_UNIX streams are allowed, because they connect children. Sockets of other types can send to
   * sockets outside. */
  refuse_where(f, SYS_socketpair, 0, all, AF_UNIX, 0);
  refuse_where(f, SYS_socketpair, 1, SOCK_TYPE, SOCK_STREAM, 0);
  /* SQLite needs fchmod. Bits that run a file with the rights of its owner or group are refused. */
  refuse_where(f, SYS_fchmod, 1, S_ISUID | S_ISGID | S_ISVTX, 0, 0);
  refuse_where(f, SYS_ioctl, 1, all, FS_IOC_SETFLAGS, 1);
  refuse_where(f, SYS_ioctl, 1, all, FS_IOC_FSSETXATTR, 1);
  refuse_where(f, SYS_fcntl, 1, all, F_NOTIFY, 1);
  refuse_where(f, SYS_fcntl, 1, all, F_SETLEASE, 1);
  refuse_where(f, SYS_clone, 0, spaces, 0, 0);
  /* TIOCSTI inserts text into the input of the terminal */
  refuse_where(f, SYS_ioctl, 1, all, TIOCSTI, 1);
  refuse_where(f, SYS_ioctl, 1, all, TIOCLINUX, 1);
  refuse_where(f, SYS_prlimit64, 0, all, 0, 0); /* 0: this process */
}

static int install(filter *f) {
  end(f, SECCOMP_RET_ALLOW);
  const struct sock_fprog program = {f->length, f->code};
  return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0) == 0;
}

static int confine_calls(void) {
  filter f = {.length = 0};
  write_filter(&f);
  return install(&f);
}

/* Prevents new processes, access to the parent, changes of the rights of files, and memory that
 * limits do not count: shared memory without a file, and large buffers of the kernel. clone3 needs
 * no rule here, because the first filter already refuses it. */
int arc_jail_alone(void) {
  static const unsigned others[] = {SYS_fchmod, SYS_socketpair};
  filter f = {.length = 0};
  leave_domain();
  begin(&f);
  refuse(&f, others, sizeof others / sizeof *others, EPERM);
  refuse_where(&f, SYS_fcntl, 1, UINT32_MAX, F_SETPIPE_SZ, 1);
  refuse_where(&f, SYS_mmap, 3, MAP_SHARED | MAP_ANONYMOUS, MAP_SHARED | MAP_ANONYMOUS, 1);
  refuse_where(&f, SYS_mmap, 3, MAP_GROWSDOWN, MAP_GROWSDOWN, 1);
#ifdef SYS_fork
  static const unsigned processes[] = {SYS_fork, SYS_vfork};
  refuse(&f, processes, 2, EPERM);
#endif
  refuse_where(&f, SYS_clone, 0, CLONE_THREAD, 0, 1);
  return install(&f);
}

#else

int arc_jail_alone(void) {
  return 0;
}

static int confine_calls(void) {
  return 0;
}

#endif

/* --- rights of root --------------------------------------------------------------------------- */

/* Drops all capabilities except those that override the permissions of files, because Landlock
 * restricts files. */
static void drop_rights(void) {
  const uint32_t kept = 1u << CAP_DAC_OVERRIDE | 1u << CAP_DAC_READ_SEARCH | 1u << CAP_FOWNER;
  struct __user_cap_header_struct head = {_LINUX_CAPABILITY_VERSION_3, 0};
  struct __user_cap_data_struct rights[_LINUX_CAPABILITY_U32S_3] = {{0}};
  for (int right = 0; right <= CAP_LAST_CAP; right++)
    if (right >= 32 || !(kept & 1u << right)) prctl(PR_CAPBSET_DROP, right, 0, 0, 0);
  if (syscall(SYS_capget, &head, rights) != 0) return;
  rights[0].effective &= kept, rights[0].permitted &= kept, rights[0].inheritable &= kept;
  rights[1] = (struct __user_cap_data_struct){0};
  syscall(SYS_capset, &head, rights);
}

/* --- limits ----------------------------------------------------------------------------------- */

int arc_jail_limit(int resource, double most) {
  const __rlimit_resource_t what = (__rlimit_resource_t)resource;
  struct rlimit l;
  if (getrlimit(what, &l) != 0) return 0;
  if (l.rlim_max == RLIM_INFINITY || (double)l.rlim_max > most) l.rlim_max = (rlim_t)most;
  if (l.rlim_cur == RLIM_INFINITY || l.rlim_cur > l.rlim_max) l.rlim_cur = l.rlim_max;
  return setrlimit(what, &l) == 0;
}

/* Returns the number of threads in all processes of the user. The limit includes these threads. */
static double threads_of_user(void) {
  double count = 0;
  DIR *list = opendir("/proc");
  for (struct dirent *entry; list && (entry = readdir(list));) {
    char path[NAME_MAX + 20];
    struct stat tasks;
    snprintf(path, sizeof path, "/proc/%s/task", entry->d_name);
    if (stat(path, &tasks) == 0 && tasks.st_uid == getuid()) count += (double)tasks.st_nlink - 2;
  }
  if (list) closedir(list);
  return count;
}

/* Threads allowed in addition to the present threads of the user: workers, gnuplot, and numerical
 * libraries on a machine with many processors. These libraries end the program if they cannot start
 * threads. */
enum { MORE_THREADS = 512 };

/* Limits the number of processes and threads. Returns false on failure, and for root, because the
 * system does not count root's processes. */
static int confine_processes(void) {
  return arc_jail_limit(RLIMIT_NPROC, threads_of_user() + MORE_THREADS) && getuid() != 0;
}

int arc_jail_enter(const arc_jail *jail) {
  int missing = 0;
  arc_jail_limit(RLIMIT_CORE, 0);
  arc_jail_limit(RLIMIT_FSIZE, jail->largest_file);
  if (!confine_processes()) missing |= ARC_JAIL_PROCESSES;
  drop_rights();
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return missing | ARC_JAIL_FILES | ARC_JAIL_CALLS;
  if (!confine_files(jail)) missing |= ARC_JAIL_FILES;
  if (!confine_calls()) missing |= ARC_JAIL_CALLS;
  return missing;
}
