/* Texts that grow, and the quoting of user texts. In double quotes, gnuplot runs a text between
 * backquotes as a shell command, and a line break ends the gnuplot command. Therefore both are
 * written as character codes. Single quotes are not used, because gnuplot 5.4 reads some pairs
 * of quotes as the end of one text and the beginning of the next. */
#include "plot/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plot/plot.h"

static int reserve(arc_text *text, size_t more) {
  if (text->failed) return 0;
  if (text->capacity - text->length > more) return 1;
  size_t capacity = 2 * text->capacity + more + 64;
  char *data = realloc(text->data, capacity);
  if (!data) {
    text->failed = 1;
    return 0;
  }
  text->data = data;
  text->capacity = capacity;
  return 1;
}

void arc_text_add(arc_text *text, const char *bytes, size_t count) {
  if (!reserve(text, count)) return;
  memcpy(text->data + text->length, bytes, count);
  text->length += count;
  text->data[text->length] = '\0';
}

void arc_text_word(arc_text *text, const char *word) {
  arc_text_add(text, word, strlen(word));
}

void arc_text_format(arc_text *text, const char *format, ...) {
  char line[256];
  va_list arguments;
  va_start(arguments, format);
  int length = vsnprintf(line, sizeof line, format, arguments);
  va_end(arguments);
  if (length >= 0 && (size_t)length < sizeof line)
    arc_text_add(text, line, (size_t)length);
  else
    text->failed = 1; /* too long: this function is only for numbers and short texts */
}

void arc_text_free(arc_text *text) {
  free(text->data);
  memset(text, 0, sizeof *text);
}

/* Returns the code point at `bytes` and sets its length [bytes]. For invalid UTF-8 returns -1 with
 * length 1. */
static long code_point(const unsigned char *bytes, size_t *length) {
  static const long smallest[] = {0, 0, 0x80, 0x800, 0x10000};
  size_t count = bytes[0] < 0x80           ? 1
                 : (bytes[0] >> 5) == 0x06 ? 2
                 : (bytes[0] >> 4) == 0x0e ? 3
                 : (bytes[0] >> 3) == 0x1e ? 4
                                           : 0;
  *length = 1;
  if (count == 0) return -1;
  if (count == 1) return bytes[0];
  long code = bytes[0] & (0x7f >> count);
  for (size_t i = 1; i < count; i++) {
    if ((bytes[i] & 0xc0) != 0x80) return -1;
    code = code << 6 | (bytes[i] & 0x3f);
  }
  if (code < smallest[count] || code > 0x10ffff || (code >= 0xd800 && code <= 0xdfff)) return -1;
  *length = count;
  return code;
}

/* Returns the ASCII text that replaces the character with this code point; "?" if there is none. */
static const char *spelled(long code) {
  static const struct {
    long code;
    const char *ascii;
  } table[] = {
      {0xb0, "deg"},   {0xb1, "+-"},   {0xb2, "^2"},     {0xb3, "^3"},      {0xb5, "u"},
      {0xb7, "."},     {0xd7, "x"},    {0x3b1, "alpha"}, {0x3b2, "beta"},   {0x3b4, "delta"},
      {0x3b5, "eps"},  {0x3b7, "eta"}, {0x3ba, "kappa"}, {0x3bb, "lambda"}, {0x3bc, "u"},
      {0x3bd, "nu"},   {0x3c0, "pi"},  {0x3c3, "sigma"}, {0x3c4, "tau"},    {0x2013, "-"},
      {0x2014, "-"},   {0x2018, "'"},  {0x2019, "'"},    {0x201c, "\""},    {0x201d, "\""},
      {0x2026, "..."}, {0x2212, "-"},  {0x221e, "inf"},
  };
  for (size_t i = 0; i < sizeof table / sizeof *table; i++)
    if (table[i].code == code) return table[i].ascii;
  return "?";
}

/* Returns true for control characters (C0, DEL, C1), which a terminal could execute, and for
 * characters that end a line or change the direction of text (Unicode property Bidi_Control). */
static int is_control(long code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x61c || code == 0x200e ||
         code == 0x200f || (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
}

/* Appends a byte of a text in double quotes, escaped if necessary. */
static void add_byte(arc_text *text, char byte) {
  if (byte == '"' || byte == '\\')
    arc_text_add(text, (char[]){'\\', byte}, 2);
  else if (byte == '`' || (unsigned char)byte < 0x20 || byte == 0x7f)
    arc_text_format(text, "\\%03o", (unsigned)byte);
  else
    arc_text_add(text, &byte, 1);
}

static void add_character(arc_text *text, const char *bytes, size_t length, long code, int ascii) {
  if (code == -1)
    arc_text_word(text, "?");
  else if (is_control(code))
    arc_text_word(text, " ");
  else if (code < 0x80 || !ascii)
    for (size_t i = 0; i < length; i++) add_byte(text, bytes[i]);
  else
    for (const char *c = spelled(code); *c; c++) add_byte(text, *c);
}

void arc_text_quoted(arc_text *text, const char *words, int ascii) {
  arc_text_word(text, "\"");
  for (const char *at = words; *at;) {
    size_t length;
    long code = code_point((const unsigned char *)at, &length);
    /* XML does not allow "]]>" in texts, and gnuplot writes ">" to .svg files as it is */
    if (code == '>' && at - words >= 2 && at[-1] == ']' && at[-2] == ']') arc_text_word(text, " ");
    add_character(text, at, length, code, ascii);
    at += length;
  }
  arc_text_word(text, "\"");
}

void arc_text_path(arc_text *text, const char *path) {
  arc_text_word(text, "\"");
  for (; *path; path++) add_byte(text, *path);
  arc_text_word(text, "\"");
}

size_t arc_text_characters(const char *words) {
  size_t count = 0;
  for (; words && *words; words++) count += ((unsigned char)*words & 0xc0) != 0x80;
  return count;
}

size_t arc_text_line(const char *words, double columns) {
  size_t best = 0, clause = 0, i = 0;
  for (double seen = 0; words[i] && (seen <= columns || best == 0); i++) {
    if (((unsigned char)words[i] & 0xc0) != 0x80) seen++;
    if (words[i] != ' ' || i == 0) continue;
    best = i;
    if (strchr(",:;", words[i - 1])) clause = i;
  }
  if (!words[i] && (double)arc_text_characters(words) <= columns) return i;
  return clause ? clause : best ? best : strlen(words);
}

char *arc_plot_quote(const char *words, int ascii) {
  arc_text text = {0};
  arc_text_quoted(&text, words, ascii);
  if (text.failed) arc_text_free(&text);
  return text.data;
}
