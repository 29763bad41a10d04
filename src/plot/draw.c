/* Draws figures as characters, in windows, or to files.
 *
 * A file is drawn under a temporary name and published when it is complete. gnuplot never receives
 * the user's file name, which could have a special meaning to gnuplot. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "archard/atomic_file.h"
#include "plot/plot.h"
#include "plot/characters.h"
#include "plot/figure.h"
#include "plot/picture.h"

static const char at_rest[] = "unset multiplot\nset output\nreset\nundefine $*\n";
/* Resets gnuplot between figures. First saves gnuplot's error number, because `reset` clears it. */
static const char anew[] = ARC_GNUPLOT_NOTE_FAILURE "reset\nundefine $*\n";

static arc_status no_memory(arc_error *error) {
  return arc_fail(error, ARC_MEMORY, "no memory for the plot");
}

static arc_status hand_over(arc_text *text, char **data, size_t *length, arc_error *error) {
  if (text->failed) {
    arc_text_free(text);
    return no_memory(error);
  }
  if (length) *length = text->length;
  *data = text->data;
  return ARC_OK;
}

/* --- commands --------------------------------------------------------------------------------- */

static void write_script(const arc_plot_figure *frames, size_t count, const arc_canvas *canvas,
                         const char *animation, const char *temporary, arc_text *script) {
  arc_text_word(script, at_rest);
  arc_canvas_command(canvas, animation, script);
  if (temporary) {
    arc_text_word(script, "set output ");
    arc_text_path(script, temporary);
    arc_text_word(script, "\n");
  }
  for (size_t i = 0; i < count; i++) {
    if (i > 0) arc_text_word(script, anew);
    arc_plot_commands(&frames[i], canvas, script);
  }
  arc_text_word(script, "unset multiplot\nset output\n");
  arc_text_word(script, anew);
}

/* Writes a script that the user runs. The script sets no terminal, because the user chooses the
 * terminal. */
static arc_status user_script(const arc_plot_figure *figure, const arc_canvas *canvas,
                              arc_text *script) {
  arc_text_word(script, "# Draw with: gnuplot -p this-file\n");
  arc_plot_commands(figure, canvas, script);
  return ARC_OK;
}

arc_status arc_plot_script(const arc_plot_figure *figure, const arc_plot_output *output,
                           char **commands, size_t *length, arc_error *error) {
  arc_canvas canvas;
  arc_text script = {0};
  arc_status status = arc_plot_check(figure, error);
  if (status == ARC_OK) status = arc_canvas_choose(figure, output, NULL, &canvas, error);
  if (status != ARC_OK) return status;
  if (canvas.terminal)
    write_script(figure, 1, &canvas, "", NULL, &script);
  else
    user_script(figure, &canvas, &script);
  return hand_over(&script, commands, length, error);
}

/* --- files ------------------------------------------------------------------------------------ */

static arc_status write_text(const arc_atomic_file *temporary, const arc_text *text,
                             arc_error *error) {
  FILE *stream = fopen(arc_atomic_file_path(temporary), "w");
  size_t written = stream ? fwrite(text->data, 1, text->length, stream) : 0;
  if (stream && fclose(stream) == 0 && written == text->length) return ARC_OK;
  return arc_fail(error, ARC_IO, "cannot write '%.200s': %s", arc_atomic_file_name(temporary),
                  strerror(errno));
}

/* --- drawing ---------------------------------------------------------------------------------- */

/* State while one or more figures are drawn. */
typedef struct drawing {
  arc_gnuplot *session;
  const arc_plot_figure *frames;
  size_t count;
  const char *animation;
  const arc_plot_output *output;
  arc_canvas canvas;
} drawing;

/* Writes a long script to a temporary file, because gnuplot reads its standard input slowly, byte
 * by byte. Replaces the script by a command that loads the file. If the file cannot be written, the
 * script stays unchanged. */
static void through_file(arc_text *script, arc_atomic_file **temporary) {
  const char *folder = getenv("TMPDIR");
  arc_error ignored;
  *temporary = NULL;
  if (script->failed || script->length < 20000) return;
  if (!folder || folder[0] != '/') folder = P_tmpdir;
  if (arc_atomic_file_create_scratch(folder, temporary, &ignored) != ARC_OK) return;
  if (write_text(*temporary, script, &ignored) != ARC_OK) {
    arc_atomic_file_discard(temporary);
    return;
  }
  script->length = 0;
  arc_text_word(script, "load ");
  arc_text_path(script, arc_atomic_file_path(*temporary));
}

/* Runs the commands for a canvas. `reply` receives gnuplot's output. */
static arc_status ask(drawing *d, const arc_canvas *canvas, const char *temporary, char **reply,
                      size_t *length, arc_error *error) {
  arc_text script = {0};
  write_script(d->frames, d->count, canvas, d->animation, temporary, &script);
  arc_atomic_file *file;
  through_file(&script, &file);
  arc_status status =
      script.failed ? no_memory(error)
                    : arc_gnuplot_run(d->session, script.data, script.length, reply, length, error);
  arc_atomic_file_discard(&file);
  arc_text_free(&script);
  if (status == ARC_ARGUMENT)
    arc_gnuplot_run(d->session, at_rest, sizeof at_rest - 1, NULL, NULL, NULL);
  return status;
}

/* Draws only the curves a second time, at the resolution of Braille dots, and adds them to the
 * picture in characters. */
static arc_status refine(drawing *d, const char *words, size_t length, arc_text *picture,
                         arc_error *error) {
  arc_canvas dots = d->canvas;
  char *reply = NULL;
  size_t count = 0;
  dots.fine = 0, dots.dots = 1;
  arc_status status = ask(d, &dots, NULL, &reply, &count, error);
  if (status == ARC_OK) arc_characters(words, length, reply ? reply : "", count, picture);
  free(reply);
  return status;
}

/* Draws the figures and stores gnuplot's output in `picture`. Pictures in characters are cleaned
 * by arc_characters. */
static arc_status run(drawing *d, const char *temporary, arc_text *picture, arc_error *error) {
  char *reply = NULL;
  size_t length = 0;
  arc_status status = ask(d, &d->canvas, temporary, &reply, &length, error);
  if (status == ARC_OK && d->canvas.fine)
    status = refine(d, reply, length, picture, error);
  else if (status == ARC_OK && d->canvas.text)
    arc_characters(reply, length, NULL, 0, picture);
  else if (status == ARC_OK && length > 0)
    arc_text_add(picture, reply, length);
  free(reply);
  return status == ARC_OK && picture->failed ? no_memory(error) : status;
}

/* Writes the output file. This program writes pictures in characters and commands, gnuplot writes
 * all other formats. */
static arc_status fill_place(drawing *d, const arc_atomic_file *temporary, arc_error *error) {
  arc_text text = {0};
  arc_status status;
  if (!d->canvas.terminal)
    status = user_script(d->frames, &d->canvas, &text);
  else
    status = run(d, d->canvas.text ? NULL : arc_atomic_file_path(temporary), &text, error);
  if (status == ARC_OK && text.failed) status = no_memory(error);
  if (status == ARC_OK && (d->canvas.text || !d->canvas.terminal))
    status = write_text(temporary, &text, error);
  else if (status == ARC_OK)
    status = arc_picture_check(arc_atomic_file_path(temporary), d->output->file, error);
  arc_text_free(&text);
  return status;
}

static arc_status draw_file(drawing *d, arc_error *error) {
  arc_atomic_file *temporary;
  arc_status status = arc_atomic_file_create(d->output->file, &temporary, error);
  if (status == ARC_OK) status = fill_place(d, temporary, error);
  if (status == ARC_OK) return arc_atomic_file_publish(&temporary, error);
  arc_atomic_file_discard(&temporary);
  return status;
}

/* Checks the figures and chooses the canvas. Starts gnuplot unless only commands are written. */
static arc_status prepare(drawing *d, arc_error *error) {
  arc_status status = ARC_OK;
  for (size_t i = 0; i < d->count && status == ARC_OK; i++)
    status = arc_plot_check(&d->frames[i], error);
  if (status == ARC_OK) status = arc_canvas_choose(d->frames, d->output, NULL, &d->canvas, error);
  if (status != ARC_OK || !d->canvas.terminal) return status;
  status = arc_gnuplot_start(d->session, error);
  return status == ARC_OK ? arc_canvas_choose(d->frames, d->output, d->session, &d->canvas, error)
                          : status;
}

arc_status arc_plot_draw(arc_gnuplot *session, const arc_plot_figure *figure,
                         const arc_plot_output *output, char **picture, size_t *length,
                         arc_error *error) {
  drawing d = {session, figure, 1, "", output, {0}};
  arc_text text = {0};
  *picture = NULL;
  if (length) *length = 0;
  arc_status status = prepare(&d, error);
  if (status != ARC_OK) return status;
  if (output->medium == ARC_PLOT_FILE) return draw_file(&d, error);
  status = run(&d, NULL, &text, error);
  if (status != ARC_OK || output->medium == ARC_PLOT_WINDOW) {
    arc_text_free(&text);
    return status;
  }
  return hand_over(&text, picture, length, error);
}

arc_status arc_plot_animate(arc_gnuplot *session, const arc_plot_figure *frames, size_t count,
                            double delay, const arc_plot_output *output, arc_error *error) {
  char animation[48];
  drawing d = {session, frames, count, animation, output, {0}};
  if (count == 0) return arc_fail(error, ARC_ARGUMENT, "an animation needs at least one frame");
  if (!(delay > 0) || delay > 60)
    return arc_fail(error, ARC_ARGUMENT, "delay must be above 0 and at most 60 s, got %g", delay);
  snprintf(animation, sizeof animation, "animate delay %d loop 0", (int)(100 * delay + 0.5));
  arc_status status = prepare(&d, error);
  if (status != ARC_OK) return status;
  if (output->medium != ARC_PLOT_FILE ||
      strcmp(d.canvas.terminal ? d.canvas.terminal : "", "gif") != 0)
    return arc_fail(error, ARC_ARGUMENT, "an animation needs a file name that ends in .gif");
  return draw_file(&d, error);
}
