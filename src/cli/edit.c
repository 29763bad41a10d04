/* The line editor, the only file that includes readline. It uses readline's callback interface,
 * so that signals can be handled between keys without a jump out of readline. history_file.c
 * reads and writes the history file. */
#include "cli/edit.h"
#include "archard/base.h"

#include "cli/history_file.h"
#include "lua/system/term_query.h"
#include "lua/base/interrupt.h"

#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/select.h>
#include <unistd.h>

#include <readline/readline.h>
#include <readline/history.h>

enum { HISTORY_ENTRIES = 5000 };

static struct {
  edit_complete_fn complete;
  void *context;
  edit_proposal proposal;
  char *path;         /* path of the history file, or NULL */
  char *line;         /* line that on_line received from readline */
  int done;           /* true after readline called on_line */
  sigset_t kept_back; /* signals that are blocked except while waiting for a key */
} editor;

static volatile sig_atomic_t continued;

static void on_continue(int signal_number) {
  (void)signal_number;
  continued = 1;
}

/* --- completion ------------------------------------------------------------------------------- */

static void forget_proposal(void) {
  for (size_t i = 0; i < editor.proposal.count; i++) free(editor.proposal.words[i]);
  free(editor.proposal.words);
  memset(&editor.proposal, 0, sizeof editor.proposal);
}

/* Generates completions for readline: returns the next word that begins with `text`. readline
 * frees the word. */
static char *next_word(const char *text, int state) {
  static size_t next;
  if (state == 0) next = 0;
  while (next < editor.proposal.count) {
    const char *word = editor.proposal.words[next++];
    if (strncmp(word, text, strlen(text)) == 0) return strdup(word);
  }
  return NULL;
}

/* Generates file names for readline. Omits names that contain control characters or would end the
 * Lua string. */
static char *next_file(const char *text, int state) {
  for (;;) {
    char *file = rl_filename_completion_function(text, state);
    if (file == NULL) return NULL;
    char shown[PATH_MAX];
    arc_show_text(file, shown, sizeof shown);
    if (strcmp(shown, file) == 0 && strpbrk(file, "\"'\\]\n\t") == NULL) return file;
    free(file);
    state = 1;
  }
}

static char **attempt_completion(const char *text, int start, int end) {
  (void)start;
  rl_attempted_completion_over = 1;
  char *before = strndup(rl_line_buffer, (size_t)end);
  if (before == NULL) return NULL;
  forget_proposal();
  editor.complete(editor.context, before, &editor.proposal);
  free(before);
  rl_completion_append_character = editor.proposal.append;
  if (!editor.proposal.files) return rl_completion_matches(text, next_word);
  rl_filename_completion_desired = 1;
  return rl_completion_matches(text, next_file);
}

/* --- history ---------------------------------------------------------------------------------- */

/* Removes all entries that equal `entry` from the history. */
static void forget_copies(const char *entry) {
  for (int i = history_length - 1; i >= 0; i--) {
    const HIST_ENTRY *old = history_get(history_base + i);
    if (old != NULL && strcmp(old->line, entry) == 0) free_history_entry(remove_history(i));
  }
}

static void recall(void *context, const char *entry) {
  (void)context;
  add_history(entry);
}

void edit_remember(const char *entry) {
  if (*entry == '\0') return;
  forget_copies(entry);
  add_history(entry);
  if (editor.path) history_file_append(editor.path, entry);
}

/* --- start and end ---------------------------------------------------------------------------- */

static void choose_signals(void) {
  static const int signals[] = {SIGINT, SIGTSTP, SIGWINCH, SIGTERM, SIGHUP, SIGQUIT, SIGCONT};
  sigemptyset(&editor.kept_back);
  for (size_t i = 0; i < sizeof signals / sizeof *signals; i++)
    sigaddset(&editor.kept_back, signals[i]);
  struct sigaction action;
  memset(&action, 0, sizeof action);
  action.sa_handler = on_continue;
  action.sa_flags = SA_RESTART; /* SIGCONT must not interrupt a wait for gnuplot */
  sigaction(SIGCONT, &action, NULL);
}

void edit_start(edit_complete_fn complete, void *context) {
  editor.complete = complete;
  editor.context = context;
  rl_readline_name = "archard";
  rl_catch_signals = 1;
  rl_persistent_signal_handlers = 1;
  rl_attempted_completion_function = attempt_completion;
  rl_completer_word_break_characters = " \t\n\"\\'`@$><=;|&{}()[]+-*/%^~#,:.?!";
  rl_completer_quote_characters = "\"'";
  /* The default of show-all-if-ambiguous is set before readline reads the user's inputrc, which may
   * change it. */
  rl_variable_bind("show-all-if-ambiguous", "on");
  if (!isatty(STDOUT_FILENO)) rl_outstream = stderr;
  choose_signals();
  stifle_history(HISTORY_ENTRIES);
  editor.path = history_file_open();
  if (editor.path) history_file_read(editor.path, HISTORY_ENTRIES, recall, NULL);
}

void edit_finish(void) {
  if (editor.path) history_file_read(editor.path, HISTORY_ENTRIES, NULL, NULL);
  free(editor.path);
  editor.path = NULL;
  forget_proposal();
  clear_history();
}

/* --- reading a line --------------------------------------------------------------------------- */

static void on_line(char *line) {
  editor.line = line;
  editor.done = 1;
  rl_callback_handler_remove();
  if (line == NULL) fputs("\n", rl_outstream); /* after Ctrl-D the cursor moves to a new line */
}

static void abandon_line(void) {
  rl_callback_sigcleanup();
  rl_free_line_state();
  rl_replace_line("", 0);
  rl_crlf();
  rl_callback_handler_remove();
}

/* Makes readline process a signal that was caught. readline restores the terminal and then calls
 * the previous handler or the default action. */
static void treat_signals(const sigset_t *normal) {
  do {
    sigprocmask(SIG_SETMASK, normal, NULL);
    rl_check_signals();
    sigprocmask(SIG_BLOCK, &editor.kept_back, NULL);
  } while (rl_pending_signal() != 0);
  if (continued) rl_forced_update_display();
  continued = 0;
}

/* Waits for a key or a signal while signals are unblocked. Returns 0 after a signal, even if a
 * key is already available. */
static int wait_for_key(const sigset_t *normal) {
  fd_set input;
  FD_ZERO(&input);
  FD_SET(STDIN_FILENO, &input);
  int ready = pselect(STDIN_FILENO + 1, &input, NULL, NULL, NULL, normal) > 0;
  sigprocmask(SIG_SETMASK, normal, NULL);
  sigprocmask(SIG_BLOCK, &editor.kept_back, NULL);
  return ready && rl_pending_signal() == 0;
}

/* Processes the keys that the user pressed while the terminal answered a query. Keys after the
 * end of a line are stored for the next prompt. */
static void replay_typed(void) {
  for (int key; !editor.done && (key = term_query_next_key()) >= 0;) {
    rl_stuff_char(key);
    rl_callback_read_char();
  }
}

edit_result edit_read(const char *prompt, char **line) {
  sigset_t normal;
  sigprocmask(SIG_BLOCK, &editor.kept_back, &normal);
  editor.done = 0;
  rl_callback_handler_install(prompt, on_line);
  replay_typed();
  while (!editor.done && !interrupt_pending(NULL)) {
    if (wait_for_key(&normal))
      rl_callback_read_char();
    else
      treat_signals(&normal);
  }
  int interrupted = !editor.done;
  if (interrupted) abandon_line();
  sigprocmask(SIG_SETMASK, &normal, NULL);
  if (interrupted) return EDIT_INTERRUPTED;
  *line = editor.line;
  return editor.line ? EDIT_LINE : EDIT_END;
}
