/* Tests of error conditions of the run file: foreign and damaged files are refused and not changed.
 * Further conditions are a full disk, a killed writer, two writers at once, and shards of different
 * studies. */
#include "store_shared.h"

/* --- foreign files ---------------------------------------------------------------------------- */

/* Checks that opening `name` in every mode fails with a message that contains `words` and leaves
 * every byte unchanged. */
static void assert_refused(const char *name, arc_status expected, const char *words) {
  const char *path = in_folder(name);
  size_t before_count, after_count;
  unsigned char *before = bytes_of(path, &before_count);
  for (int mode = ARC_STORE_READ; mode <= ARC_STORE_CREATE; mode++) {
    arc_error error = {0};
    arc_store *store;
    assert_int_equal(arc_store_open(path, (arc_store_mode)mode, &store, &error), expected);
    assert_null(store);
    if (!strstr(error.message, words)) fail_msg("no '%s' in: %s", words, error.message);
    assert_non_null(strstr(error.message, path));
  }
  unsigned char *after = bytes_of(path, &after_count);
  assert_int_equal(before_count, after_count);
  assert_memory_equal(before, after, before_count);
  free(before);
  free(after);
}

/* Writes a copy of a good file with some bytes changed. */
static void write_changed(const char *name, size_t at, const char *bytes, size_t count,
                          size_t keep) {
  arc_store *store = opened("good", ARC_STORE_CREATE);
  arc_store_close(&store);
  size_t size;
  unsigned char *good = bytes_of(in_folder("good"), &size);
  memcpy(good + at, bytes, count);
  write_bytes(in_folder(name), good, keep < size ? keep : size);
  free(good);
}

static void test_foreign_files(void **state) {
  (void)state;
  arc_store *store;
  arc_error error = {0};
  assert_int_equal(arc_store_open(in_folder("absent"), ARC_STORE_READ, &store, &error), ARC_IO);
  assert_int_equal(arc_store_open("/no/such/folder/f", ARC_STORE_CREATE, &store, &error), ARC_IO);
  write_bytes(in_folder("empty"), "", 0);
  assert_refused("empty", ARC_FORMAT, "empty");
  char text[300];
  memset(text, 'x', sizeof text);
  write_bytes(in_folder("text"), text, sizeof text);
  assert_refused("text", ARC_FORMAT, "not a run file");
  write_changed("other", 68, "\1\2\3\4", 4, SIZE_MAX);
  assert_refused("other", ARC_FORMAT, "another program");
  write_changed("newer", 60, "\0\0\0\x63", 4, SIZE_MAX);
  assert_refused("newer", ARC_FORMAT, "newer");
  write_changed("short", 0, "", 0, 5000);
  assert_refused("short", ARC_FORMAT, "damaged");
}

static void test_damaged_pages(void **state) {
  (void)state;
  char noise[4096];
  memset(noise, 0x5a, sizeof noise);
  write_changed("noise", 4096, noise, sizeof noise, SIZE_MAX);
  arc_error error = {0};
  arc_store *store;
  arc_status status = arc_store_open(in_folder("noise"), ARC_STORE_READ, &store, &error);
  if (status == ARC_OK) status = arc_store_check(store, &error);
  assert_int_equal(status, ARC_FORMAT);
  assert_non_null(strstr(error.message, "damaged"));
  arc_store_close(&store);
}

/* Returns true if all data of the first case can be read and equal the expected data. */
static int reads_well(const char *name, const arc_wear_record *expected, size_t expected_count) {
  arc_error error = {0};
  arc_store *store;
  arc_wear_record *history = NULL;
  size_t count = 0;
  int well = 0;
  if (arc_store_open(in_folder(name), ARC_STORE_READ, &store, &error) != ARC_OK) return 0;
  if (arc_store_history(store, 1, &history, &count, &error) == ARC_OK) {
    assert_int_equal(count, expected_count);
    assert_memory_equal(history, expected, count * sizeof *history);
    well = 1;
  }
  free(history);
  arc_store_close(&store);
  return well;
}

/* Tests files with one changed bit: the file is refused, or the data read are unchanged. */
static void test_turned_bits(void **state) {
  (void)state;
  arc_error error = {0};
  arc_model_def definition = arc_model_default();
  definition.mesh.size = 0.05;
  definition.mesh.height = 0.06;
  arc_model *model;
  must(arc_model_build(&definition, &model, &error), &error);
  arc_wear *wear = short_run(model, 44);
  arc_store *store = opened("bits", ARC_STORE_CREATE);
  must(arc_store_add(store, 1, "one", &error), &error);
  save_run(store, 1, wear);
  must(arc_store_mark(store, 1, ARC_CASE_DONE, NULL, 1, &error), &error);
  arc_store_close(&store);
  size_t rows, count;
  const arc_wear_record *history = arc_wear_history(wear, &rows);
  assert_true(reads_well("bits", history, rows));
  unsigned char *bytes = bytes_of(in_folder("bits"), &count);
  int refused = 0;
  for (size_t at = 100; at < count; at += count / 97) {
    bytes[at] ^= 4;
    write_bytes(in_folder("turned"), bytes, count);
    refused += !reads_well("turned", history, rows);
    bytes[at] ^= 4;
  }
  print_message("# %d of 97 turned bits refused, the others touch nothing that is read\n", refused);
  assert_true(refused > 5);
  free(bytes);
  arc_wear_destroy(&wear);
  arc_model_release(&model);
}

static void test_replace(void **state) {
  (void)state;
  arc_error error = {0};
  arc_store *store;
  char *text;
  for (int round = 0; round < 2; round++) {
    must(arc_store_replace(in_folder("replaced"), "wear", &store, &error), &error);
    must(arc_store_add(store, 1, "run", &error), &error);
    must(arc_store_publish(&store, &error), &error);
  }
  must(arc_store_replace(in_folder("replaced"), "wear", &store, &error), &error);
  arc_store_close(&store); /* closes the new file without storing it */
  store = opened("replaced", ARC_STORE_READ);
  must(arc_store_info(store, "kind", &text, &error), &error);
  assert_string_equal(text, "wear");
  free(text);
  arc_case *cases;
  size_t count;
  must(arc_store_cases(store, &cases, &count, &error), &error);
  assert_int_equal(count, 1);
  free(cases);
  arc_store_close(&store);
  assert_int_equal(arc_store_replace(in_folder("replaced"), "study", &store, &error), ARC_ARGUMENT);
  write_bytes(in_folder("letter"), "Dear Sir", 8);
  assert_int_equal(arc_store_replace(in_folder("letter"), "wear", &store, &error), ARC_FORMAT);
  size_t size;
  unsigned char *letter = bytes_of(in_folder("letter"), &size);
  assert_memory_equal(letter, "Dear Sir", 8);
  free(letter);
}

/* --- full disks and killed programs ----------------------------------------------------------- */

static void add_many(arc_store *store, int from, int to, arc_error *error, arc_status *status) {
  *status = arc_store_begin(store, error);
  for (int id = from; id < to && *status == ARC_OK; id++)
    *status = arc_store_add(store, id, "a label of some length, so that pages fill up", error);
  if (*status == ARC_OK)
    *status = arc_store_commit(store, error);
  else
    arc_store_rollback(store);
}

static size_t count_of(const char *name) {
  arc_error error = {0};
  arc_store *store = opened(name, ARC_STORE_WRITE);
  must(arc_store_check(store, &error), &error);
  arc_case *cases;
  size_t count;
  must(arc_store_cases(store, &cases, &count, &error), &error);
  free(cases);
  arc_store_close(&store);
  return count;
}

/* Tests a full disk, which a limit on the size of files simulates. The test runs in a child
 * process because the limit cannot be raised again. */
static void test_full_disk(void **state) {
  (void)state;
  arc_store *store = opened("full", ARC_STORE_CREATE);
  arc_error error = {0};
  arc_status status;
  add_many(store, 1, 100, &error, &status);
  must(status, &error);
  arc_store_close(&store);
  pid_t child = fork();
  if (child == 0) {
    struct rlimit limit = {100000, 100000};
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &limit);
    if (arc_store_open(in_folder("full"), ARC_STORE_WRITE, &store, &error) != ARC_OK) _exit(2);
    add_many(store, 100, 20000, &error, &status);
    int told = status == ARC_IO && strstr(error.message, in_folder("full")) != NULL;
    arc_store_close(&store);
    _exit(told ? 0 : 3);
  }
  int ended;
  waitpid(child, &ended, 0);
  assert_true(WIFEXITED(ended) && WEXITSTATUS(ended) == 0);
  assert_int_equal(count_of("full"), 99);
}

/* Tests a writer that is killed at a random time: the file contains only complete batches. */
static void test_killed_writer(void **state) {
  (void)state;
  enum { ROUNDS = 12, BATCH = 50 };
  arc_store *store = opened("killed", ARC_STORE_CREATE);
  arc_store_close(&store);
  for (int round = 0; round < ROUNDS; round++) {
    size_t before = count_of("killed");
    pid_t child = fork();
    if (child == 0) {
      arc_error error = {0};
      arc_status status = arc_store_open(in_folder("killed"), ARC_STORE_WRITE, &store, &error);
      for (int id = (int)before + 1; status == ARC_OK; id += BATCH)
        add_many(store, id, id + BATCH, &error, &status);
      _exit(1);
    }
    usleep(3000u * (unsigned)(round + 1));
    kill(child, SIGKILL);
    int ended;
    waitpid(child, &ended, 0);
    assert_true(WIFSIGNALED(ended) && WTERMSIG(ended) == SIGKILL);
    size_t after = count_of("killed");
    assert_true(after >= before);
    assert_int_equal(after % BATCH, 0);
  }
}

static void test_two_writers(void **state) {
  (void)state;
  enum { WRITERS = 3, EACH = 20 };
  arc_store *store = opened("shared", ARC_STORE_CREATE);
  arc_store_close(&store);
  pid_t child[WRITERS];
  for (int w = 0; w < WRITERS; w++) {
    child[w] = fork();
    if (child[w] == 0) {
      arc_error error = {0};
      arc_status status = arc_store_open(in_folder("shared"), ARC_STORE_WRITE, &store, &error);
      for (int i = 0; i < EACH && status == ARC_OK; i++)
        status = arc_store_add(store, w * EACH + i + 1, "one of many", &error);
      _exit(status == ARC_OK ? 0 : 1);
    }
  }
  for (int w = 0; w < WRITERS; w++) {
    int ended;
    waitpid(child[w], &ended, 0);
    assert_true(WIFEXITED(ended) && WEXITSTATUS(ended) == 0);
  }
  assert_int_equal(count_of("shared"), WRITERS * EACH);
}

/* Starts a program that alternately stores two runs as case 1 until it is killed; returns the
 * program's process id. */
static pid_t keep_by_turns(const char *name, const arc_wear *one, const arc_wear *two) {
  const pid_t child = fork();
  if (child != 0) return child;
  alarm(60); /* ends this process if the parent fails to kill it */
  arc_store *store = opened(name, ARC_STORE_WRITE);
  for (int turn = 0;; turn++) {
    save_run(store, 1, turn % 2 ? one : two);
    usleep(5000);
  }
}

/* Tests that data read while another program stores them are valid and belong to one version of
 * the case. */
static void test_reader_beside_writer(void **state) {
  (void)state;
  enum { READS = 25 };
  arc_model *model = coarse_model();
  arc_wear *one = short_run(model, 33), *two = short_run(model, 66);
  save_as("kept", 1, one);
  const pid_t child = keep_by_turns("kept", one, two);
  for (int i = 0; i < READS; i++) {
    arc_error error = {0};
    arc_model *there;
    arc_store *store = opened("kept", ARC_STORE_READ);
    must(arc_store_check(store, &error), &error);
    arc_store_close(&store);
    arc_wear *wear = restored("kept", 1, &there);
    const double distance = arc_wear_last(wear)->distance;
    assert_true(distance == 33 || distance == 66);
    assert_same_runs(distance == 33 ? one : two, wear);
    arc_wear_destroy(&wear);
    arc_model_release(&there);
  }
  kill(child, SIGKILL);
  waitpid(child, NULL, 0);
  arc_wear_destroy(&one);
  arc_wear_destroy(&two);
  arc_model_release(&model);
}

/* --- shards ----------------------------------------------------------------------------------- */

static void make_share(const char *name, int done, double alpha, const arc_wear *wear) {
  arc_error error = {0};
  arc_store *store = opened(name, ARC_STORE_CREATE);
  arc_value value = {.kind = ARC_VALUE_NUMBER, .name = "alpha", .number = alpha};
  for (int id = 1; id <= 2; id++) {
    must(arc_store_add(store, id, id == 1 ? "one" : "two", &error), &error);
    must(arc_store_set_values(store, id, ARC_SETTINGS, &value, 1, &error), &error);
  }
  if (done > 0) {
    save_run(store, done, wear);
    must(arc_store_mark(store, done, ARC_CASE_DONE, NULL, 2.5, &error), &error);
  }
  arc_store_close(&store);
}

static void test_merge(void **state) {
  (void)state;
  arc_error error = {0};
  arc_model *model = coarse_model(), *second_model;
  arc_wear *wear = short_run(model, 66), *other = short_run(model, 44);
  make_share("share 1", 1, 0.5, wear);
  make_share("share 1 of others", 1, 0.5, other);
  make_share("share '2'", 2, 0.5, wear);
  make_share("stranger", 2, 0.25, wear);
  make_share("joined", 0, 0.5, wear);
  arc_store *store = opened("joined", ARC_STORE_WRITE);
  save_run(store, 2, other); /* as if a killed program had stored only a part of this case */
  must(arc_store_merge(store, in_folder("share 1"), &error), &error);
  assert_int_equal(arc_store_merge(store, in_folder("stranger"), &error), ARC_ARGUMENT);
  assert_non_null(strstr(error.message, "different studies"));
  must(arc_store_merge(store, in_folder("share 1"), &error), &error); /* a second merge of the
                                                                       * same shard */
  assert_int_equal(arc_store_merge(store, in_folder("share 1 of others"), &error), ARC_ARGUMENT);
  assert_non_null(strstr(error.message, "case 1 is finished in both, with other results"));
  must(arc_store_merge(store, in_folder("share '2'"), &error), &error);
  assert_int_equal(symlink(in_folder("joined"), in_folder("link")), 0);
  assert_int_equal(arc_store_merge(store, in_folder("link"), &error), ARC_ARGUMENT);
  assert_non_null(strstr(error.message, "link: is the study itself"));
  arc_case *cases;
  size_t count;
  must(arc_store_cases(store, &cases, &count, &error), &error);
  assert_int_equal(count, 2);
  for (size_t i = 0; i < count; i++) {
    assert_int_equal(cases[i].status, ARC_CASE_DONE);
    assert_true(cases[i].seconds == 2.5);
  }
  free(cases);
  arc_store_close(&store);
  arc_wear *again = restored("joined", 2, &second_model);
  assert_same_runs(wear, again);
  arc_wear_destroy(&wear);
  arc_wear_destroy(&other);
  arc_wear_destroy(&again);
  arc_model_release(&model);
  arc_model_release(&second_model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_foreign_files),       cmocka_unit_test(test_damaged_pages),
      cmocka_unit_test(test_turned_bits),         cmocka_unit_test(test_replace),
      cmocka_unit_test(test_full_disk),           cmocka_unit_test(test_killed_writer),
      cmocka_unit_test(test_two_writers),         cmocka_unit_test(test_merge),
      cmocka_unit_test(test_reader_beside_writer)};
  arc_single_threaded();
  return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
