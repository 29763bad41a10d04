/* Subscripts, superscripts and Greek letters in titles. A subscript requires a single letter before
 * _, a superscript requires digits after ^, so that names of files or columns are not changed.
 * Other characters that gnuplot would interpret are escaped. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "plot/text.h"

static int is_letter(unsigned char c) {
  return isalpha(c) || c >= 0x80;
}

/* Returns the number of bytes of the combining accents (U+0300 to U+036F) that end at `at`. Accents
 * belong to the letter before them. */
static size_t accents_before(const char *words, const char *at) {
  size_t length = 0;
  while (at - length >= words + 2) {
    unsigned char first = (unsigned char)at[-(long)length - 2],
                  second = (unsigned char)at[-(long)length - 1];
    if (first != 0xcc && !(first == 0xcd && second < 0xb0)) break;
    length += 2;
  }
  return length;
}

/* Returns the number of bytes of the letter that ends at `at` if this letter is a word of one
 * letter, so that it can have a subscript. Otherwise returns 0. */
static size_t symbol_before(const char *words, const char *at) {
  size_t length = 1 + accents_before(words, at);
  while (at - length > words && ((unsigned char)at[-(long)length] & 0xc0) == 0x80) length++;
  if ((size_t)(at - words) < length || !is_letter((unsigned char)at[-(long)length])) return 0;
  const char *before = at - length;
  if (before == words) return length;
  unsigned char c = (unsigned char)before[-1];
  return isalnum(c) || c == '_' || c >= 0x80 ? 0 : length;
}

/* Returns the number of bytes of the subscript or superscript after the _ or ^ at `at`. Returns
 * 0 if the _ or ^ is an ordinary character. */
static size_t marked(const char *words, const char *at) {
  size_t count = 0;
  if (at == words) return 0;
  if (*at == '_' && symbol_before(words, at) > 0) {
    while (is_letter((unsigned char)at[1 + count]) || isdigit((unsigned char)at[1 + count]))
      count++;
    return at[1 + count] == '_' ? 0 : count;
  }
  if (*at != '^' || !(isalnum((unsigned char)at[-1]) || at[-1] == ')')) return 0;
  size_t sign = at[1] == '-';
  while (isdigit((unsigned char)at[1 + sign + count])) count++;
  return count ? sign + count : 0;
}

/* Returns the number of bytes of an exponent such as e-08 at `at`, and its value in `power`.
 * Returns 0 if there is no exponent. */
static size_t exponent_at(const char *words, const char *at, int *power) {
  const char *begin = at;
  if (*at != 'e' || (at[1] != '-' && at[1] != '+') || !isdigit((unsigned char)at[2])) return 0;
  while (begin > words && (isdigit((unsigned char)begin[-1]) || begin[-1] == '.')) begin--;
  unsigned char before = begin > words ? (unsigned char)begin[-1] : ' ';
  char *end;
  *power = (int)strtol(at + 1, &end, 10);
  if (begin == at || isalnum(before) || before == '_' || before >= 0x80) return 0;
  return is_letter((unsigned char)*end) || *end == '.' || *end == '_' ? 0 : (size_t)(end - at);
}

int arc_text_marked(const char *words) {
  int power;
  for (const char *at = words; *at; at++)
    if (((*at == '_' || *at == '^') && marked(words, at) > 0) || exponent_at(words, at, &power))
      return 1;
  return 0;
}

void arc_text_enhanced(arc_text *text, const char *words) {
  int power;
  for (const char *at = words; *at; at++) {
    size_t count = *at == '_' || *at == '^' ? marked(words, at) : 0;
    if (count > 0) {
      arc_text_add(text, at, 1);
      arc_text_word(text, "{");
      arc_text_add(text, at + 1, count);
      arc_text_word(text, "}");
      at += count;
    } else if ((count = exponent_at(words, at, &power)) > 0) {
      arc_text_format(text, "\303\22710^{%d}", power);
      at += count - 1;
    } else {
      if (strchr("_^{}@&~\\", *at)) arc_text_word(text, "\\");
      arc_text_add(text, at, 1);
    }
  }
}

/* --- Greek letters ---------------------------------------------------------------------------- */

typedef struct letter {
  const char *name, *utf8;
} letter;

/* Returns the Greek letter whose complete name is at `name` (the text after a backslash), or NULL
 * if there is no such letter. */
static const letter *letter_at(const char *name) {
  static const letter letters[] = {
      {"alpha", "\316\261"},   {"beta", "\316\262"},  {"gamma", "\316\263"}, {"delta", "\316\264"},
      {"epsilon", "\316\265"}, {"eta", "\316\267"},   {"kappa", "\316\272"}, {"lambda", "\316\273"},
      {"mu", "\316\274"},      {"nu", "\316\275"},    {"pi", "\317\200"},    {"rho", "\317\201"},
      {"sigma", "\317\203"},   {"tau", "\317\204"},   {"phi", "\317\206"},   {"omega", "\317\211"},
      {"Delta", "\316\224"},   {"Sigma", "\316\243"},
  };
  for (size_t i = 0; i < sizeof letters / sizeof *letters; i++) {
    size_t length = strlen(letters[i].name);
    if (strncmp(name, letters[i].name, length) == 0 && !isalpha((unsigned char)name[length]))
      return &letters[i];
  }
  return NULL;
}

void arc_text_greek(arc_text *text, const char *words) {
  arc_text_word(text, "");
  for (const char *at = words; *at; at++) {
    const letter *found = *at == '\\' ? letter_at(at + 1) : NULL;
    if (found)
      arc_text_word(text, found->utf8);
    else
      arc_text_add(text, at, 1);
    if (found) at += strlen(found->name);
  }
}
