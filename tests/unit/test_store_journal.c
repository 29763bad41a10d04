/* Tests of files beside a run file. A journal of archard restores the state before a killed
 * program's change; a journal or log of another program causes no deletion, no writing and no
 * waiting. */
#include "store_sql.h"

#include <fcntl.h>

enum { PAGE = 4096, SECTOR = 512 };

static int make_good(void **state) {
  if (make_folder(state) != 0) return -1;
  arc_model *model = coarse_model();
  arc_wear *wear = short_run(model, 33);
  save_as("good", 1, wear);
  seal("good");
  arc_wear_destroy(&wear);
  arc_model_release(&model);
  return 0;
}

/* --- journals, byte by byte ------------------------------------------------------------------- */

static void put_number(FILE *to, uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) fputc((int)(number >> shift & 255), to);
}

static void put_magic(FILE *to) {
  fwrite("\xd9\xd5\x05\xf9\x20\xa1\x63\xd7", 1, 8, to);
}

/* Starts the journal of a file that had `pages` pages; `records` is the number of pages saved in
 * the journal. */
static FILE *begin_journal(const char *name, uint32_t records, uint32_t pages) {
  char path[300];
  snprintf(path, sizeof path, "%s-journal", in_folder(name));
  FILE *to = fopen(path, "wb");
  assert_non_null(to);
  put_magic(to);
  const uint32_t header[] = {records, 7, pages, SECTOR, PAGE};
  for (int i = 0; i < 5; i++) put_number(to, header[i]);
  while (ftell(to) < SECTOR) fputc(0, to);
  return to;
}

/* Writes the saved content of a page with SQLite's checksum. */
static void put_page(FILE *to, uint32_t number, const unsigned char *page) {
  uint32_t sum = 7;
  for (int i = PAGE - 200; i > 0; i -= 200) sum += page[i];
  put_number(to, number);
  fwrite(page, 1, PAGE, to);
  put_number(to, sum);
}

/* Writes the end of a journal that belongs to several files, whose paths are listed in `names`. */
static void put_name(FILE *to, const char *names) {
  uint32_t sum = 0;
  for (const char *c = names; *c; c++) sum += (unsigned char)*c;
  put_number(to, 0x40000000 / PAGE + 1);
  fwrite(names, 1, strlen(names), to);
  put_number(to, (uint32_t)strlen(names));
  put_number(to, sum);
  put_magic(to);
}

/* --- journals of archard ---------------------------------------------------------------------- */

/* Creates a file without its last page and the journal that contains this page, as left by a
 * killed program. */
static void cut_in_mid_change(const char *name) {
  size_t count;
  unsigned char *bytes = bytes_of(in_folder("good"), &count);
  const size_t pages = count / PAGE;
  FILE *journal = begin_journal(name, 1, (uint32_t)pages);
  put_page(journal, (uint32_t)pages, bytes + (pages - 1) * PAGE);
  fclose(journal);
  write_bytes(in_folder(name), bytes, count - PAGE);
  free(bytes);
}

static void test_put_right(void **state) {
  (void)state;
  arc_error error = {0};
  size_t before, after;
  unsigned char *good = bytes_of(in_folder("good"), &before);
  for (int linked = 0; linked < 2; linked++) {
    cut_in_mid_change("cut");
    if (linked) assert_int_equal(symlink("cut", in_folder("link")), 0);
    must(read_all(linked ? "link" : "cut", &error), &error);
    unsigned char *bytes = bytes_of(in_folder("cut"), &after);
    assert_int_equal(before, after);
    assert_memory_equal(good, bytes, before);
    assert_int_not_equal(access(in_folder("cut-journal"), F_OK), 0);
    free(bytes);
  }
  free(good);
}

/* --- journals of other programs --------------------------------------------------------------- */

static void lay_file(const char *name) {
  write_bytes(in_folder(name), "precious", 8);
}

static void assert_there(const char *name) {
  size_t count;
  unsigned char *bytes = bytes_of(in_folder(name), &count);
  assert_int_equal(count, 8);
  assert_memory_equal(bytes, "precious", 8);
  free(bytes);
}

/* Checks that opening the file is refused in all modes and that the file "victim" is unchanged. */
static void assert_none_of_ours(const char *name) {
  for (int mode = ARC_STORE_READ; mode <= ARC_STORE_CREATE; mode++) {
    arc_error error = {0};
    arc_store *store;
    arc_status status = arc_store_open(in_folder(name), (arc_store_mode)mode, &store, &error);
    if (status == ARC_OK) status = arc_store_add(store, 9, "another", &error);
    assert_int_equal(status, ARC_FORMAT);
    if (!strstr(error.message, "the journal or log beside it")) fail_msg("%s", error.message);
    arc_store_close(&store);
    assert_there("victim");
  }
  assert_damaged(name, "the journal or log beside it was not written by archard");
  arc_error error = {0};
  arc_store *store = NULL;
  assert_int_equal(arc_store_replace(in_folder(name), "wear", &store, &error), ARC_FORMAT);
  assert_there("victim");
}

static void test_names_a_file(void **state) {
  (void)state;
  lay_file("victim");
  copy_good("named");
  FILE *journal = begin_journal("named", 0, 10);
  put_name(journal, in_folder("victim"));
  fclose(journal);
  assert_none_of_ours("named");
  /* the name of the victim now ends like the name of a journal */
  assert_int_equal(rename(in_folder("victim"), in_folder("other-journal")), 0);
  copy_good("again");
  journal = begin_journal("again", 0, 10);
  put_name(journal, in_folder("other-journal"));
  fclose(journal);
  assert_damaged("again", "the journal or log beside it");
  assert_there("other-journal");
}

/* Tests that a journal which would enlarge the file to 17 TB is refused, and one of a user who may
 * not write the file (which only root can test). */
static void test_of_another(void **state) {
  (void)state;
  lay_file("victim");
  copy_good("large");
  fclose(begin_journal("large", 0, 4294967295u));
  assert_none_of_ours("large");
  if (geteuid() != 0) return;
  arc_error error = {0};
  cut_in_mid_change("foreign");
  assert_int_equal(chown(in_folder("foreign-journal"), 12345, 12345), 0);
  assert_int_equal(chmod(in_folder("foreign"), 0644), 0);
  assert_none_of_ours("foreign");
  assert_int_equal(chmod(in_folder("foreign"), 0664), 0);
  must(read_all("foreign", &error), &error);
}

/* Tests that merging a shard that has a foreign journal is refused, too. */
static void test_share(void **state) {
  (void)state;
  arc_error error = {0};
  lay_file("victim");
  copy_good("share");
  copy_good("whole");
  FILE *journal = begin_journal("share", 0, 10);
  put_name(journal, in_folder("victim"));
  fclose(journal);
  arc_store *store = opened("whole", ARC_STORE_WRITE);
  assert_int_equal(arc_store_merge(store, in_folder("share"), &error), ARC_FORMAT);
  assert_there("victim");
  arc_store_close(&store);
}

static void test_links_and_pipes(void **state) {
  (void)state;
  lay_file("victim");
  copy_good("linked");
  assert_int_equal(symlink("victim", in_folder("linked-journal")), 0);
  assert_none_of_ours("linked");
  cut_in_mid_change("moved");
  assert_int_equal(rename(in_folder("moved-journal"), in_folder("elsewhere")), 0);
  assert_int_equal(symlink("elsewhere", in_folder("moved-journal")), 0);
  assert_none_of_ours("moved");
  copy_good("piped");
  assert_int_equal(mkfifo(in_folder("piped-journal"), 0600), 0);
  assert_none_of_ours("piped");
}

/* Tests files with a write-ahead log of another program. Such a log contains pages that replace
 * pages of the file, and its index (-shm) could be a link to any file. */
static void test_logs(void **state) {
  (void)state;
  lay_file("victim");
  copy_good("logged");
  run_sql("logged", "PRAGMA journal_mode = WAL");
  assert_int_equal(symlink("victim", in_folder("logged-shm")), 0);
  assert_none_of_ours("logged");
  copy_good("beside");
  lay_file("beside-wal");
  assert_none_of_ours("beside");
  assert_there("beside-wal");
}

/* Tests that the journal of a deleted file is not applied to a new file of the same name. */
static void test_left_alone(void **state) {
  (void)state;
  arc_error error = {0};
  arc_store *store = NULL;
  cut_in_mid_change("gone");
  assert_int_equal(unlink(in_folder("gone")), 0);
  assert_int_equal(arc_store_open(in_folder("gone"), ARC_STORE_CREATE, &store, &error),
                   ARC_ARGUMENT);
  assert_non_null(strstr(error.message, "gone-journal"));
  assert_int_equal(arc_store_replace(in_folder("gone"), "wear", &store, &error), ARC_ARGUMENT);
  assert_int_not_equal(access(in_folder("gone"), F_OK), 0);
  assert_int_equal(unlink(in_folder("gone-journal")), 0);
  store = opened("gone", ARC_STORE_CREATE);
  arc_store_close(&store);
}

int main(void) {
  arc_single_threaded();
  alarm(60); /* a program that opens the pipe would wait forever */
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_put_right),       cmocka_unit_test(test_names_a_file),
      cmocka_unit_test(test_of_another),      cmocka_unit_test(test_share),
      cmocka_unit_test(test_links_and_pipes), cmocka_unit_test(test_logs),
      cmocka_unit_test(test_left_alone),
  };
  return cmocka_run_group_tests(tests, make_good, remove_folder);
}
