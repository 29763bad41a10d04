/* Manages a session with gnuplot: starts gnuplot, reads its version, sends commands, reads the
 * replies, and starts gnuplot again after it has ended. gnuplot continues after an error. Therefore
 * the last command of every request prints a marker line with the error number. The output before
 * the marker line is the answer. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

#include "plot/plot.h"
#include "plot/process.h"
#include "plot/text.h"

struct arc_gnuplot {
  arc_gnuplot_def def;
  char *program;
  arc_process process;
  double version;
  char *terminals;
  unsigned long questions; /* number of the last request, which is part of its marker line */
};

static const char remedy[] = "On Debian: apt-get install gnuplot-nox";

arc_gnuplot_def arc_gnuplot_default(void) {
  return (arc_gnuplot_def){
      .program = "gnuplot", .start_timeout = 15.0, .silence_timeout = 60.0, .should_stop = NULL};
}

arc_status arc_gnuplot_open(const arc_gnuplot_def *def, arc_gnuplot **session, arc_error *error) {
  arc_gnuplot *s = calloc(1, sizeof *s);
  if (s) s->program = strdup(def->program);
  if (!s || !s->program) {
    free(s);
    return arc_fail(error, ARC_MEMORY, "no memory for a gnuplot session");
  }
  s->def = *def;
  s->def.program = s->program;
  s->process = ARC_PROCESS_NONE;
  *session = s;
  return ARC_OK;
}

void arc_gnuplot_close(arc_gnuplot **session) {
  arc_gnuplot *s = *session;
  if (!s) return;
  arc_process_end(&s->process, 0.5);
  free(s->terminals);
  free(s->program);
  free(s);
  *session = NULL;
}

double arc_gnuplot_version(const arc_gnuplot *session) {
  return session->version;
}

const char *arc_gnuplot_terminals(const arc_gnuplot *session) {
  return session->terminals ? session->terminals : "";
}

long arc_gnuplot_process(const arc_gnuplot *session) {
  return (long)session->process.pid;
}

int arc_gnuplot_has_terminal(const arc_gnuplot *session, const char *name) {
  char word[40];
  int length = snprintf(word, sizeof word, " %s ", name);
  return length > 0 && (size_t)length < sizeof word && strstr(arc_gnuplot_terminals(session), word);
}

/* --- commands and answers --------------------------------------------------------------------- */

/* Returns the message at the end of gnuplot's error output. The output contains the command, a
 * caret, and then "line 0: MESSAGE" or "\"file\" line 7: MESSAGE". */
static const char *last_words(arc_text *errors) {
  if (!errors->data) return "gnuplot gave no reason";
  size_t end = errors->length;
  while (end > 0 && strchr(" \n\r\t", errors->data[end - 1])) end--;
  errors->data[end] = '\0';
  char *last = strrchr(errors->data, '\n');
  last = last ? last + 1 : errors->data;
  while (*last == ' ') last++;
  char *line = strstr(last, "line ");
  size_t digits = line ? strspn(line + 5, "0123456789") : 0;
  return digits && strncmp(line + 5 + digits, ": ", 2) == 0 ? line + 7 + digits : last;
}

static void how_it_ended(int how, char text[64]) {
  if (how != -1 && WIFSIGNALED(how))
    snprintf(text, 64, "killed by signal %d", WTERMSIG(how));
  else if (how != -1 && WIFEXITED(how))
    snprintf(text, 64, "exit status %d", WEXITSTATUS(how));
  else
    snprintf(text, 64, "unknown exit status");
}

static arc_status missing(const arc_gnuplot *session, arc_error *error) {
  return arc_fail(error, ARC_MISSING,
                  "gnuplot is needed for plots, and there is no program '%s'. %s", session->program,
                  remedy);
}

/* Ends the process after a failed exchange and sets the error. Exit status 127 means that there is
 * no such program. This status is returned by a shell, and by a spawn call that cannot report the
 * error. */
static arc_status broken(arc_gnuplot *session, arc_exchange *x, arc_exchange_end end,
                         arc_error *error) {
  char ending[64];
  int how = arc_process_end(&session->process, end == ARC_EXCHANGE_DIED ? 0.5 : 0.0);
  how_it_ended(how, ending);
  if (end == ARC_EXCHANGE_DIED && how != -1 && WIFEXITED(how) && WEXITSTATUS(how) == 127)
    return missing(session, error);
  switch (end) {
  case ARC_EXCHANGE_SILENT:
    return arc_fail(error, ARC_IO,
                    "gnuplot ('%s') gave no answer for %g s and was ended; the next plot starts it "
                    "again",
                    session->program, x->patience);
  case ARC_EXCHANGE_STOPPED:
    return arc_fail(error, ARC_STOPPED, "the plot was stopped");
  case ARC_EXCHANGE_FLOOD:
    return arc_fail(error, ARC_IO, "gnuplot ('%s') answered with more than %d MB and was ended",
                    session->program, ARC_EXCHANGE_MOST >> 20);
  case ARC_EXCHANGE_MEMORY:
    return arc_fail(error, ARC_MEMORY, "no memory for the answer of gnuplot");
  default:
    return arc_fail(error, ARC_IO,
                    "gnuplot ('%s') ended during a plot (%s%s%.200s); the next plot starts "
                    "it again",
                    session->program, ending, x->errors.length ? "; it said: " : "",
                    x->errors.length ? last_words(&x->errors) : "");
  }
}

/* Removes the marker line and the line break before the marker line from the answer. Returns the
 * error number in the marker line. */
static int error_number(arc_text *answer, const char *mark) {
  size_t start = answer->length - 1;
  while (start > 0 && answer->data[start - 1] != '\n') start--;
  int number = atoi(answer->data + start + strlen(mark));
  if (start > 0) start--;
  answer->length = start;
  answer->data[start] = '\0';
  return number;
}

static arc_status judge(arc_gnuplot *session, arc_exchange *x, arc_exchange_end end,
                        arc_error *error) {
  if (end != ARC_EXCHANGE_DONE) return broken(session, x, end, error);
  if (error_number(&x->answer, x->last_line) == 0) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT, "gnuplot refuses: %.300s", last_words(&x->errors));
}

/* Sends commands to the running gnuplot. If they succeed, sets `answer`. */
static arc_status ask(arc_gnuplot *session, const char *commands, size_t count, double patience,
                      arc_text *answer, arc_error *error) {
  char mark[48];
  snprintf(mark, sizeof mark, "<<archard %lu:", ++session->questions);
  arc_text question = {0};
  arc_text_word(&question, "reset errors\narchard_failed = 0\nset print '-'\n");
  arc_text_add(&question, commands, count);
  /* The first print command writes a line break, because a picture may end without one and the
   * marker must begin a line. */
  arc_text_format(&question, "\nprint ''\nprint sprintf('%s%%d>>', archard_failed + GPVAL_ERRNO)\n",
                  mark);
  if (question.failed) {
    arc_text_free(&question);
    return arc_fail(error, ARC_MEMORY, "no memory for the plot's commands");
  }
  arc_exchange x = {.question = question.data,
                    .length = question.length,
                    .last_line = mark,
                    .patience = patience,
                    .should_stop = session->def.should_stop,
                    .stop_context = session->def.stop_context};
  arc_status status = judge(session, &x, arc_process_exchange(&session->process, &x), error);
  if (status == ARC_OK) {
    *answer = x.answer;
    x.answer = (arc_text){0};
  }
  arc_text_free(&x.answer);
  arc_text_free(&x.errors);
  arc_text_free(&question);
  return status;
}

/* --- start ------------------------------------------------------------------------------------ */

static arc_status spawn(arc_gnuplot *session, arc_error *error) {
  char defaults[] = "-d"; /* with -d gnuplot ignores the user's start-up file */
  char *argv[] = {session->program, defaults, NULL};
  arc_status status = arc_process_start(&session->process, argv, error);
  if (status == ARC_MISSING) return missing(session, error);
  return status;
}

/* Reads gnuplot's version from the first line of the answer, and its terminals from the second
 * line. */
static arc_status note_abilities(arc_gnuplot *session, arc_text *answer, arc_error *error) {
  char *end;
  session->version = strtod(answer->data, &end);
  if (end == answer->data)
    return arc_fail(error, ARC_MISSING, "'%s' does not answer like gnuplot. %s", session->program,
                    remedy);
  if (session->version < ARC_GNUPLOT_OLDEST - 1e-9)
    return arc_fail(error, ARC_MISSING, "gnuplot %g ('%s') is too old, %g or newer is needed. %s",
                    session->version, session->program, ARC_GNUPLOT_OLDEST, remedy);
  char *line = strchr(end, '\n');
  free(session->terminals);
  session->terminals = strdup(line ? line + 1 : "");
  if (!session->terminals) return arc_fail(error, ARC_MEMORY, "no memory for gnuplot's terminals");
  line = strchr(session->terminals, '\n');
  if (line) *line = '\0';
  return ARC_OK;
}

/* Sets the error if gnuplot fails to answer its first request. The message contains advice. */
static arc_status failed_start(arc_gnuplot *session, arc_status status, arc_error *error) {
  arc_process_end(&session->process, 0.0);
  if (status != ARC_IO || !error) return status;
  char reason[256];
  snprintf(reason, sizeof reason, "%.255s", error->message);
  return arc_fail(error, status, "gnuplot does not start: %s. Try '%.100s -d' in a shell", reason,
                  session->program);
}

arc_status arc_gnuplot_start(arc_gnuplot *session, arc_error *error) {
  static const char probe[] = "print GPVAL_VERSION\nprint ' '.GPVAL_TERMINALS.' '";
  if (arc_process_alive(&session->process)) return ARC_OK;
  arc_process_end(&session->process, 0.0);
  arc_status status = spawn(session, error);
  if (status != ARC_OK) return status;
  arc_text answer = {0};
  status = ask(session, probe, sizeof probe - 1, session->def.start_timeout, &answer, error);
  if (status != ARC_OK) return failed_start(session, status, error);
  status = note_abilities(session, &answer, error);
  arc_text_free(&answer);
  if (status != ARC_OK) arc_process_end(&session->process, 0.0);
  return status;
}

arc_status arc_gnuplot_run(arc_gnuplot *session, const char *commands, size_t count, char **reply,
                           size_t *length, arc_error *error) {
  if (reply) *reply = NULL;
  if (length) *length = 0;
  arc_status status = arc_gnuplot_start(session, error);
  if (status != ARC_OK) return status;
  arc_text answer = {0};
  status = ask(session, commands, count, session->def.silence_timeout, &answer, error);
  if (status == ARC_OK && length) *length = answer.length;
  if (status == ARC_OK && reply)
    *reply = answer.data;
  else
    arc_text_free(&answer);
  return status;
}
