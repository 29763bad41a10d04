/* Tests of files that are written completely or not at all: replacement, links and leftover
 * temporary files. */
#include "check.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "archard/lock.h"
#include "archard/atomic_file.h"

static char folder[] = "/tmp/archard-atomic-XXXXXX";

static int set_up(void **state) {
  (void)state;
  signal(SIGXFSZ, SIG_IGN);
  return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

static int tear_down(void **state) {
  (void)state;
  char command[80];
  snprintf(command, sizeof command, "chmod -R u+w %s && rm -rf %s", folder, folder);
  return system(command);
}

static void write_to(const char *path, const char *text) {
  FILE *file = fopen(path, "w");
  assert_non_null(file);
  fputs(text, file);
  fclose(file);
}

static void assert_holds(const char *path, const char *text) {
  char bytes[100] = "";
  FILE *file = fopen(path, "r");
  assert_non_null(file);
  bytes[fread(bytes, 1, sizeof bytes - 1, file)] = '\0';
  fclose(file);
  assert_string_equal(bytes, text);
}

static int parts(const char *where) {
  DIR *list = opendir(where);
  int count = 0;
  for (struct dirent *entry; (entry = readdir(list));)
    count += strstr(entry->d_name, "archard-part") != NULL;
  closedir(list);
  return count;
}

/* Writes a text to a file by the same functions as all writers of archard. */
static arc_status put(const char *path, const char *text, arc_error *error) {
  arc_atomic_file *file;
  arc_status status = arc_atomic_file_create(path, &file, error);
  if (status != ARC_OK) return status;
  write_to(arc_atomic_file_path(file), text);
  return arc_atomic_file_publish(&file, error);
}

static void test_whole_or_not(void **state) {
  (void)state;
  arc_atomic_file *file;
  assert_int_equal(put("new", "first", NULL), ARC_OK);
  assert_int_equal(arc_atomic_file_create("new", &file, NULL), ARC_OK);
  write_to(arc_atomic_file_path(file), "second");
  assert_holds("new", "first");
  arc_atomic_file_discard(&file);
  assert_null(file);
  assert_holds("new", "first");
  assert_int_equal(put("./new", "third", NULL), ARC_OK);
  assert_holds("new", "third");
  assert_int_equal(parts("."), 0);
  arc_atomic_file_discard(&file);
}

static void test_links_are_followed(void **state) {
  (void)state;
  struct stat facts;
  mkdir("far", 0700);
  assert_int_equal(symlink("far/there", "link"), 0);
  assert_int_equal(symlink("link", "link of link"), 0);
  assert_int_equal(put("link", "made", NULL), ARC_OK); /* the target does not exist yet */
  assert_holds("far/there", "made");
  assert_int_equal(put("link of link", "anew", NULL), ARC_OK);
  assert_holds("far/there", "anew");
  assert_int_equal(lstat("link of link", &facts), 0);
  assert_true(S_ISLNK(facts.st_mode));
  assert_int_equal(parts("far"), 0);
  assert_int_equal(symlink("round", "round"), 0);
  arc_error error;
  assert_int_equal(put("round", "x", &error), ARC_IO);
  assert_non_null(strstr(error.message, strerror(ELOOP)));
}

/* Tests which file a name is resolved to, for all functions that open, create or confine files. */
static void test_names_mean_files(void **state) {
  (void)state;
  char meant[PATH_MAX], expected[PATH_MAX], descriptor[40];
  mkdir("meant", 0700);
  write_to("meant/file", "text");
  assert_int_equal(symlink("meant/new", "to-new"), 0);
  assert_int_equal(symlink("../meant/../to-new", "meant/chain"), 0);
  assert_int_equal(symlink("ring", "ring"), 0);
  static const struct meaning {
    const char *name, *file; /* the path relative to this folder */
  } known[] = {{"meant/file", "/meant/file"}, {"./meant//../meant/file", "/meant/file"},
               {"meant/none", "/meant/none"}, {"to-new", "/meant/new"},
               {"meant/chain", "/meant/new"}, {"file:meant", "/file:meant"},
               {"meant/", "/meant"},          {"meant/..", ""}};
  for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
    assert_int_equal(arc_file_find(known[i].name, ARC_FILE_READ, meant, NULL), ARC_OK);
    snprintf(expected, sizeof expected, "%s%s", folder, known[i].file);
    assert_string_equal(meant, expected);
  }
  snprintf(descriptor, sizeof descriptor, "/proc/%ld/fd/1", (long)getpid());
  assert_int_equal(arc_file_find("/dev/stdout", ARC_FILE_WRITE, meant, NULL), ARC_OK);
  assert_string_equal(meant, descriptor);
  static const struct nothing {
    const char *name;
    int why;
  } nothing[] = {{"none/file", ENOENT}, {"meant/file/x", ENOTDIR}, {"ring", ELOOP}};
  arc_error error;
  for (size_t i = 0; i < sizeof nothing / sizeof *nothing; i++) {
    assert_int_equal(arc_file_find(nothing[i].name, ARC_FILE_READ, meant, &error), ARC_IO);
    assert_non_null(strstr(error.message, strerror(nothing[i].why)));
  }
}

static void test_permissions_stay(void **state) {
  (void)state;
  struct stat facts;
  write_to("mode", "old");
  chmod("mode", 0640);
  assert_int_equal(put("mode", "new", NULL), ARC_OK);
  assert_int_equal(stat("mode", &facts), 0);
  assert_int_equal(facts.st_mode & 07777, 0640);
  mode_t usual = umask(027);
  assert_int_equal(put("fresh", "new", NULL), ARC_OK);
  umask(usual);
  assert_int_equal(stat("fresh", &facts), 0);
  assert_int_equal(facts.st_mode & 07777, 0640);
}

/* Tests that each refusal has a message. Two refusals are skipped for root, which may write
 * everywhere. */
static void test_refused(void **state) {
  (void)state;
  arc_error error;
  static char long_name[6000];
  memset(long_name, 'a', sizeof long_name - 1);
  struct refusal {
    const char *path;
    arc_status status;
    const char *why;
  } cases[] = {{"nowhere/file", ARC_IO, "No such file or directory"},
               {"far", ARC_IO, "Is a directory"},
               {"new/file", ARC_IO, "Not a directory"},
               {"a\nb", ARC_ARGUMENT, "control character"},
               {"through/x.png", ARC_IO, "control character in its folder's name"},
               {"", ARC_ARGUMENT, "name is empty"},
               {long_name, ARC_IO, "too long"},
               {"read-only", ARC_IO, "Permission denied"},
               {"locked/file", ARC_IO, "Permission denied"}};
  mkdir("d\nsystem 'x'\n#", 0700);
  assert_int_equal(symlink("d\nsystem 'x'\n#", "through"), 0);
  write_to("read-only", "kept");
  chmod("read-only", 0444);
  mkdir("locked", 0500);
  for (size_t i = 0; i < sizeof cases / sizeof *cases - (geteuid() == 0 ? 2 : 0); i++) {
    assert_int_equal(put(cases[i].path, "x", &error), cases[i].status);
    assert_non_null(strstr(error.message, cases[i].why));
  }
  if (geteuid() != 0) assert_holds("read-only", "kept");
}

static void test_devices_are_written_to(void **state) {
  (void)state;
  arc_error error;
  struct stat facts;
  char text[10] = "";
  assert_int_equal(put("/dev/null", "gone", NULL), ARC_OK);
  assert_int_equal(put("/dev/full", "no room", &error), ARC_IO);
  assert_non_null(strstr(error.message, strerror(ENOSPC)));
  assert_int_equal(stat("/dev/null", &facts), 0);
  assert_true(S_ISCHR(facts.st_mode));
  assert_int_equal(mkfifo("pipe", 0600), 0);
  int reader = open("pipe", O_RDONLY | O_NONBLOCK);
  assert_int_equal(put("pipe", "through", NULL), ARC_OK);
  assert_int_equal(read(reader, text, sizeof text), 7);
  assert_string_equal(text, "through");
  close(reader);
  assert_int_equal(stat("pipe", &facts), 0);
  assert_true(S_ISFIFO(facts.st_mode));
}

/* Tests a disk that becomes full while the new file is written: the write fails and the old file
 * is unchanged. */
static void test_no_room(void **state) {
  (void)state;
  struct rlimit limit, usual;
  getrlimit(RLIMIT_FSIZE, &usual);
  limit = usual;
  arc_atomic_file *file;
  write_to("kept", "old");
  assert_int_equal(arc_atomic_file_create("kept", &file, NULL), ARC_OK);
  limit.rlim_cur = 3;
  setrlimit(RLIMIT_FSIZE, &limit);
  FILE *stream = fopen(arc_atomic_file_path(file), "w");
  fputs("more than that", stream);
  int failed = fclose(stream) != 0;
  setrlimit(RLIMIT_FSIZE, &usual);
  assert_true(failed);
  arc_atomic_file_discard(&file);
  assert_holds("kept", "old");
  assert_int_equal(parts("."), 0);
}

/* Tests the removal of files that a killed program did not delete: its temporary file and the
 * journal of its database. The next writer in the folder removes them, but no file that is in
 * use or has another origin. */
static void test_strays(void **state) {
  (void)state;
  arc_atomic_file *held;
  mkdir("busy", 0700);
  pid_t child = fork();
  if (child == 0) {
    arc_atomic_file *lost;
    arc_atomic_file_create("busy/lost", &lost, NULL);
    char journal[5000];
    snprintf(journal, sizeof journal, "%s-journal", arc_atomic_file_path(lost));
    close(open(journal, O_CREAT | O_WRONLY, 0600));
    raise(SIGKILL);
  }
  waitpid(child, NULL, 0);
  assert_int_equal(parts("busy"), 2);
  assert_int_equal(arc_atomic_file_create("busy/held", &held, NULL), ARC_OK);
  assert_int_equal(parts("busy"), 1);
  write_to("busy/.archard-party", "not ours");
  assert_int_equal(put("busy/other", "x", NULL), ARC_OK);
  assert_int_equal(parts("busy"), 2);
  assert_int_equal(arc_atomic_file_publish(&held, NULL), ARC_OK);
  assert_int_equal(parts("busy"), 1);
  arc_atomic_file_clean("busy");
  arc_atomic_file_clean("nowhere");
}

/* Tests that a lock file belongs to the program named in it and is free after the end of this
 * program. A lock of a program on another system remains in force. */
static void test_locks_by_name(void **state) {
  (void)state;
  char text[60] = "";
  pid_t child = fork();
  if (child == 0) {
    arc_lock_take("file.lock", 0);
    raise(SIGKILL);
  }
  waitpid(child, NULL, 0);
  assert_true(readlink("file.lock", text, sizeof text) > 0);
  assert_int_equal(arc_lock_take("file.lock", 0), 0);
  assert_int_equal(arc_lock_take("file.lock", 0), -1);
  assert_int_equal(errno, EEXIST);
  assert_int_equal(arc_lock_leave("file.lock"), 0);
  /* a program that was killed while it removed the abandoned lock */
  assert_int_equal(symlink(text, "file.lock"), 0);
  assert_int_equal(symlink(text, "file.lock-turn"), 0);
  assert_int_equal(arc_lock_take("file.lock", 0), 0);
  assert_int_equal(access("file.lock-turn", F_OK), -1);
  assert_int_equal(arc_lock_leave("file.lock"), 0);
  assert_int_equal(symlink("0123456789abcdef-1", "file.lock"), 0);
  assert_int_equal(arc_lock_take("file.lock", 0), -1);
  assert_int_equal(arc_lock_leave("file.lock"), 0);
  assert_int_equal(arc_lock_leave("file.lock"), -1);
}

/* Tests programs that write to one name at the same time: the result is the complete file of one
 * of them. */
static void test_together(void **state) {
  (void)state;
  arc_atomic_file *early, *late;
  assert_int_equal(arc_atomic_file_create("race", &early, NULL), ARC_OK);
  assert_int_equal(arc_atomic_file_create("race", &late, NULL), ARC_OK);
  write_to(arc_atomic_file_path(early), "early");
  write_to(arc_atomic_file_path(late), "late");
  assert_int_equal(arc_atomic_file_publish_first(&late, NULL), ARC_OK);
  assert_int_equal(arc_atomic_file_publish_first(&early, NULL), ARC_OK);
  assert_holds("race", "late");
  pid_t children[8];
  for (int i = 0; i < 8; i++)
    if ((children[i] = fork()) == 0) {
      for (int k = 0; k < 50; k++)
        if (put("shared", "whole", NULL) != ARC_OK) _exit(1);
      _exit(0);
    }
  for (int i = 0; i < 8; i++) {
    int how = -1;
    waitpid(children[i], &how, 0);
    assert_int_equal(how, 0);
  }
  assert_holds("shared", "whole");
  assert_int_equal(parts("."), 0);
}

/* Acquires and releases a lock many times. Returns the errno of the first failure other than
 * EEXIST, or 0. */
static int compete(int times) {
  int wrong = 0;
  for (int i = 0; i < times && wrong == 0; i++) {
    if (arc_lock_take("shared.lock", 0) == 0)
      arc_lock_leave("shared.lock");
    else if (errno != EEXIST)
      wrong = errno;
  }
  return wrong;
}

/* Tests a lock that is released while another program reads its owner: the lock counts as in
 * use, not as a missing file. */
static void test_locks_compete(void **state) {
  enum { TIMES = 20000 };
  int ended = 0;
  (void)state;
  const pid_t child = fork();
  if (child == 0) _exit(compete(TIMES));
  assert_int_equal(compete(TIMES), 0);
  assert_int_equal(waitpid(child, &ended, 0), child);
  assert_true(WIFEXITED(ended) && WEXITSTATUS(ended) == 0);
}

static void test_scratch(void **state) {
  (void)state;
  arc_atomic_file *file;
  struct stat facts;
  assert_int_equal(arc_atomic_file_create_scratch("far", &file, NULL), ARC_OK);
  assert_int_equal(stat(arc_atomic_file_path(file), &facts), 0);
  assert_int_equal(facts.st_mode & 07777, 0600);
  arc_atomic_file_discard(&file);
  assert_int_equal(parts("far"), 0);
  assert_int_equal(arc_atomic_file_create_scratch("nowhere", &file, NULL), ARC_IO);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_whole_or_not),     cmocka_unit_test(test_links_are_followed),
      cmocka_unit_test(test_names_mean_files), cmocka_unit_test(test_permissions_stay),
      cmocka_unit_test(test_refused),          cmocka_unit_test(test_devices_are_written_to),
      cmocka_unit_test(test_no_room),          cmocka_unit_test(test_strays),
      cmocka_unit_test(test_locks_by_name),    cmocka_unit_test(test_together),
      cmocka_unit_test(test_scratch),          cmocka_unit_test(test_locks_compete),
  };
  return cmocka_run_group_tests_name("atomic_file", tests, set_up, tear_down);
}
