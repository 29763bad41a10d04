/* Reads and writes the history file. The file is read as a whole, split into entries and, if
 * necessary, rewritten without duplicates. Sessions lock its folder while they use the file. An
 * entry consists of a line "#TIME" and the lines of its text. A line of text that has the form
 * "#TIME" itself is written with a backslash before it. Remains of a crash (half a line, a line
 * "#TIME" without text, zero bytes) do not affect other entries. */
#include "cli/history_file.h"

#include "archard/base.h"
#include "archard/atomic_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

/* An entry of the history. Its header (the line "#TIME") and its text point into the text of the
 * file. */
typedef struct entry {
  char *header, *text;
  int position, copy; /* position: index of the entry in the file; copy: true if a later entry
                         has the same text */
} entry;

typedef struct history {
  char *text; /* text of the file, with a '\0' after every header and entry */
  entry *entries;
  int count;
} history;

/* --- folder and lock -------------------------------------------------------------------------- */

static char *join(const char *folder, const char *name) {
  size_t size = strlen(folder) + strlen(name) + 2;
  char *path = malloc(size);
  if (path) snprintf(path, size, "%s/%s", folder, name);
  return path;
}

/* Creates all missing folders of `path`. Only the user can access the created folders. Returns 0 on
 * failure. */
static int make_folders(char *path) {
  for (char *slash = path + 1;; slash++) {
    if (*slash != '/' && *slash != '\0') continue;
    char kept = *slash;
    *slash = '\0';
    int failed = mkdir(path, 0700) != 0 && errno != EEXIST;
    *slash = kept;
    if (failed) return 0;
    if (kept == '\0') return 1;
  }
}

static char *state_folder(void) {
  const char *state = getenv("XDG_STATE_HOME");
  if (state != NULL && *state == '/') return join(state, "archard");
  const char *home = getenv("HOME");
  return home != NULL && *home == '/' ? join(home, ".local/state/archard") : NULL;
}

char *history_file_open(void) {
  char *folder = state_folder();
  char *path = NULL;
  if (folder && make_folders(folder)) path = join(folder, "history");
  free(folder);
  return path;
}

/* Waits for the lock of the folder. All waits together last at most 2 s; then the history is used
 * without a lock, so that another program cannot block the prompt. */
static void wait_for_lock(int descriptor) {
  static int tries = 100;
  const struct timespec moment = {0, 20000000};
  while (flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK && tries-- > 0)
    nanosleep(&moment, NULL);
}

/* Locks the folder and returns a file descriptor. Closing the descriptor releases the lock. */
static int lock_folder(const char *path) {
  char *folder = strdup(path);
  if (folder == NULL) return -1;
  *strrchr(folder, '/') = '\0';
  int descriptor = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  free(folder);
  if (descriptor >= 0) wait_for_lock(descriptor);
  return descriptor;
}

static void unlock_folder(int descriptor) {
  if (descriptor >= 0) close(descriptor);
}

/* --- lines of the file ------------------------------------------------------------------------ */

static int is_header(const char *line) {
  size_t digits = line[0] == '#' ? strspn(line + 1, "0123456789") : 0;
  return digits > 0 && (line[1 + digits] == '\n' || line[1 + digits] == '\0');
}

/* Returns true if the line, without the backslashes at its beginning, is a header. */
static int looks_like_header(const char *line) {
  return is_header(line + strspn(line, "\\"));
}

static char *next_line(char *line) {
  char *end = strchr(line, '\n');
  return end ? end + 1 : NULL;
}

/* --- writing ---------------------------------------------------------------------------------- */

static FILE *open_private(const char *path) {
  int descriptor = open(path, O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC | O_NONBLOCK, 0600);
  if (descriptor < 0) return NULL;
  FILE *file = fdopen(descriptor, "a");
  if (file == NULL) close(descriptor);
  return file;
}

static void put_entry(FILE *file, const char *header, const char *text) {
  fprintf(file, "%s\n", header);
  for (const char *line = text, *end; line; line = *end ? end + 1 : NULL) {
    end = line + strcspn(line, "\n");
    fprintf(file, "%s%.*s\n", looks_like_header(line) ? "\\" : "", (int)(end - line), line);
  }
}

/* Adds a newline if the last line of the file does not end with one. */
static void mend_end(FILE *file) {
  struct stat facts;
  char last;
  if (fstat(fileno(file), &facts) == 0 && facts.st_size > 0 &&
      pread(fileno(file), &last, 1, facts.st_size - 1) == 1 && last != '\n')
    fputc('\n', file);
}

/* Appends an entry to the file. Errors during writing are ignored. */
void history_file_append(const char *path, const char *text) {
  int lock = lock_folder(path);
  FILE *file = open_private(path);
  if (file) {
    char header[32];
    snprintf(header, sizeof header, "#%lld", (long long)time(NULL));
    mend_end(file);
    put_entry(file, header, text);
    fclose(file);
  }
  unlock_folder(lock);
}

/* Writes the entries from index `first` on. Returns 0 if an entry could not be written
 * completely. */
static int put_entries(const char *path, const history *self, int first) {
  FILE *file = fopen(path, "w");
  if (file == NULL) return 0;
  for (int i = first; i < self->count; i++)
    if (!self->entries[i].copy) put_entry(file, self->entries[i].header, self->entries[i].text);
  int broken = ferror(file);
  return fclose(file) == 0 && !broken;
}

static void rewrite(const char *path, const history *self, int first) {
  arc_atomic_file *temporary;
  if (arc_atomic_file_create(path, &temporary, NULL) != ARC_OK) return;
  if (put_entries(arc_atomic_file_path(temporary), self, first))
    arc_atomic_file_publish(&temporary, NULL);
  arc_atomic_file_discard(&temporary);
}

/* --- reading ---------------------------------------------------------------------------------- */

/* Reads the file and removes its zero bytes, which would end the string early. */
static char *read_text(const char *path) {
  char *text;
  size_t size, kept = 0;
  if (arc_file_read(path, &text, &size, NULL) != ARC_OK) return NULL;
  for (size_t i = 0; i < size; i++)
    if (text[i]) text[kept++] = text[i];
  text[kept] = '\0';
  return text;
}

static int count_headers(char *text) {
  int count = 0;
  for (char *line = text; line && *line; line = next_line(line)) count += is_header(line);
  return count;
}

/* Removes the backslashes that put_entry added. */
static void restore_lines(char *text) {
  char *to = text;
  for (char *line = text, *after; line; line = after) {
    after = next_line(line);
    if (*line == '\\' && looks_like_header(line)) line++;
    const size_t length = after ? (size_t)(after - line) : strlen(line);
    memmove(to, line, length);
    to += length;
  }
  *to = '\0';
}

/* Replaces the newline before `line` by a zero byte, so that the text before `line` ends there. */
static void cut_before(char *line) {
  line[-1] = '\0';
}

static void cut_entries(history *self) {
  char *line = self->text, *after;
  int open = 0;
  for (; line && *line; line = after) {
    after = next_line(line);
    if (!is_header(line)) continue;
    if (open) cut_before(line);
    open = after && *after && !is_header(after);
    if (!open) continue;
    cut_before(after);
    self->entries[self->count] = (entry){line, after, self->count, 0};
    self->count++;
  }
  if (!open || self->count == 0) return;
  char *last = self->entries[self->count - 1].text;
  size_t length = strlen(last);
  if (length > 0 && last[length - 1] == '\n') last[length - 1] = '\0';
}

static int by_text(const void *left, const void *right) {
  const entry *a = *(entry *const *)left, *b = *(entry *const *)right;
  int order = strcmp(a->text, b->text);
  return order ? order : a->position - b->position;
}

/* Marks the entries whose text is repeated later. Returns the number of unmarked entries, or -1
 * if memory is exhausted. */
static int mark_copies(history *self) {
  entry **sorted = malloc((size_t)self->count * sizeof *sorted);
  if (sorted == NULL) return -1;
  for (int i = 0; i < self->count; i++) sorted[i] = &self->entries[i];
  qsort(sorted, (size_t)self->count, sizeof *sorted, by_text);
  int kept = self->count;
  for (int i = 0; i + 1 < self->count; i++) {
    sorted[i]->copy = strcmp(sorted[i]->text, sorted[i + 1]->text) == 0;
    kept -= sorted[i]->copy;
  }
  free(sorted);
  return kept;
}

/* Returns the index of the oldest of the last `limit` entries that are not copies, or 0 if there
 * are fewer such entries. */
static int first_kept(const history *self, int limit) {
  int i = self->count;
  while (i > 0 && limit > 0) limit -= !self->entries[--i].copy;
  return i;
}

void history_file_read(const char *path, int limit, history_entry_fn found, void *context) {
  int lock = lock_folder(path);
  history self = {.text = read_text(path)};
  int capacity = self.text ? count_headers(self.text) : 0;
  if (capacity > 0) self.entries = calloc((size_t)capacity, sizeof *self.entries);
  if (self.entries) {
    cut_entries(&self);
    int kept = mark_copies(&self);
    int first = first_kept(&self, limit);
    for (int i = 0; i < self.count; i++) restore_lines(self.entries[i].text);
    if (first > 0 || (kept >= 0 && kept < self.count)) rewrite(path, &self, first);
    for (int i = first; found && i < self.count; i++)
      if (!self.entries[i].copy) found(context, self.entries[i].text);
  }
  unlock_folder(lock);
  free(self.entries);
  free(self.text);
}
