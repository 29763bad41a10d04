/* Implements lists of settings: access to members, defaults, range checks with messages, and
 * iteration over a list. */
#include "archard/setting.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const char *const arc_switch_names[] = {ARC_SWITCH_LIST(ARC_CHOICE_NAME) NULL};

/* --- members ---------------------------------------------------------------------------------- */

static const void *at(const void *def, size_t offset) {
  return (const char *)def + offset;
}

void *arc_setting_member(const arc_setting *s, void *def) {
  return (char *)def + s->offset;
}

const void *arc_setting_value(const arc_setting *s, const void *def) {
  return at(def, s->offset);
}

int arc_setting_has_function(const arc_setting *s, const void *def) {
  void (*function)(void) = NULL;
  if (s->function) memcpy(&function, at(def, s->function), sizeof function);
  return function != NULL;
}

double arc_setting_number(const arc_setting *s, const void *def) {
  const void *member = arc_setting_value(s, def);
  if (s->kind == ARC_TEXT) return 0;
  return s->kind == ARC_NUMBER ? *(const double *)member : *(const int *)member;
}

arc_series arc_setting_series(const arc_setting *s, const void *def) {
  return s->series ? *(const arc_series *)at(def, s->series) : (arc_series){0};
}

int arc_setting_is_auto(const arc_setting *s, const void *def) {
  return s->forms & ARC_AUTOMATIC && arc_setting_number(s, def) == 0 &&
         !arc_setting_has_function(s, def) && arc_setting_series(s, def).count == 0;
}

const arc_setting *arc_setting_find(const arc_setting *list, const char *name) {
  while (list->name && strcmp(list->name, name) != 0) list++;
  return list->name ? list : NULL;
}

/* --- texts --------------------------------------------------------------------------------- */

/* Buffer to which text is appended. Text that does not fit is cut off. */
typedef struct phrase {
  char *text;
  size_t size, length;
} phrase;

__attribute__((format(printf, 2, 3))) static void say(phrase *p, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int length = vsnprintf(p->text + p->length, p->size - p->length, format, arguments);
  va_end(arguments);
  p->length += (size_t)length;
  if (p->length >= p->size) p->length = p->size - 1;
}

static void say_range(phrase *p, const arc_setting *s) {
  const char *kind = s->kind == ARC_NUMBER ? "a number" : "a whole number";
  say(p, "%s", s->multiple == 2 ? "an even number" : kind);
  if (isfinite(s->low) && isfinite(s->high))
    say(p, " in %c%.14g, %.14g%c", s->open & ARC_LOW_OPEN ? '(' : '[', s->low, s->high,
        s->open & ARC_HIGH_OPEN ? ')' : ']');
  else if (isfinite(s->low))
    say(p, " %s %.14g", s->open & ARC_LOW_OPEN ? ">" : ">=", s->low);
  if (s->unit && s->unit[0]) say(p, " %s%s", isfinite(s->low) ? "" : "in ", s->unit);
}

static void say_choices(phrase *p, const char *const *choices) {
  const char *const quote = choices == arc_switch_names ? "" : "\"";
  for (int i = 0; choices[i]; i++)
    say(p, "%s%s%s%s", i == 0 ? "" : choices[i + 1] ? ", " : " or ", quote, choices[i], quote);
}

/* Appends the forms that a setting accepts besides numbers, separated by commas, with "or" before
 * the last one. */
static void say_forms(phrase *p, unsigned forms) {
  static const struct {
    unsigned form;
    const char *text;
  } known[] = {{ARC_AUTOMATIC, "\"auto\""},
               {ARC_FUNCTION, "a function of the state"},
               {ARC_SERIES, "a table { distance=, value= }"}};
  unsigned left = forms & (ARC_AUTOMATIC | ARC_FUNCTION | ARC_SERIES);
  for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
    if (!(left & known[i].form)) continue;
    left &= ~known[i].form;
    say(p, "%s%s", left ? ", " : " or ", known[i].text);
  }
}

const char *arc_setting_expected(const arc_setting *s, char *text, size_t size) {
  phrase p = {text, size, 0};
  text[0] = '\0';
  if (s->type)
    say(&p, "%s", s->type);
  else if (s->kind == ARC_CHOICE)
    say_choices(&p, s->choices);
  else
    say_range(&p, s);
  say_forms(&p, s->type ? 0 : s->forms);
  return text;
}

const char *arc_setting_usual(const arc_setting *s) {
  if (s->forms & ARC_OPTIONAL && s->usual == 0) return "";
  if (s->kind == ARC_CHOICE) return s->choices[(int)s->usual];
  if (s->forms & ARC_AUTOMATIC && s->usual == 0) return "\"auto\"";
  return s->usual_text ? s->usual_text : "";
}

/* --- defaults and checks ---------------------------------------------------------------------- */

void arc_settings_default(const arc_setting *list, void *def) {
  for (const arc_setting *s = list; s->name; s++) {
    void *member = arc_setting_member(s, def);
    if (s->kind == ARC_GROUP)
      arc_settings_default(s->group, member);
    else if (s->kind == ARC_NUMBER)
      *(double *)member = s->usual;
    else if (s->kind == ARC_TEXT)
      memset(member, 0, ARC_TEXT_SIZE);
    else if (s->kind != ARC_OTHER)
      *(int *)member = (int)s->usual;
  }
}

static int within(const arc_setting *s, double value) {
  const int above = s->open & ARC_LOW_OPEN ? value > s->low : value >= s->low;
  const int below = s->open & ARC_HIGH_OPEN ? value < s->high : value <= s->high;
  const int whole = s->kind == ARC_NUMBER || value == floor(value);
  return isfinite(value) && above && below && whole &&
         (s->multiple == 0 || fmod(value, s->multiple) == 0);
}

/* Returns ARC_ARGUMENT. The message contains the valid range of numbers; it omits other forms that
 * the setting accepts, such as "auto". */
static arc_status refuse_number(const arc_setting *s, const char *prefix, const char *place,
                                double value, arc_error *error) {
  char expected[160];
  arc_setting plain = *s;
  plain.forms = 0;
  return arc_fail(error, ARC_ARGUMENT, "field '%s%s%s': expected %s, got %.14g", prefix, s->name,
                  place, arc_setting_expected(&plain, expected, sizeof expected), value);
}

arc_status arc_setting_check_number(const arc_setting *s, const char *prefix, double value,
                                    arc_error *error) {
  return within(s, value) ? ARC_OK : refuse_number(s, prefix, "", value, error);
}

static arc_status check_series(const arc_setting *s, const char *prefix, arc_series series,
                               arc_error *error) {
  for (int i = 0; i < series.count; i++) {
    const double d = series.distance[i];
    char place[40];
    snprintf(place, sizeof place, ".value[%d]", i + 1);
    const int third = i > 1 && d == series.distance[i - 2];
    if (!isfinite(d) || (i > 0 && !(d >= series.distance[i - 1])) || third)
      return arc_fail(error, ARC_ARGUMENT,
                      "field '%s%s.distance[%d]': expected increasing distances in mm (two equal "
                      "ones define a jump), got %.14g%s",
                      prefix, s->name, i + 1, d, third ? " for the third time" : "");
    if (!within(s, series.value[i])) return refuse_number(s, prefix, place, series.value[i], error);
  }
  return ARC_OK;
}

static int in_choices(const arc_setting *s, int value) {
  int count = 0;
  while (s->choices[count]) count++;
  return value >= 0 && value < count;
}

static arc_status check_choice(const arc_setting *s, const char *prefix, int value,
                               arc_error *error) {
  char expected[160];
  if (in_choices(s, value)) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT, "field '%s%s': expected %s, got the number %d", prefix,
                  s->name, arc_setting_expected(s, expected, sizeof expected), value);
}

static arc_status check_group(const arc_setting *s, const char *prefix, const void *def,
                              arc_error *error) {
  char inside[80];
  snprintf(inside, sizeof inside, "%s%s.", prefix, s->name);
  return arc_settings_check(s->group, inside, arc_setting_value(s, def), error);
}

static arc_status check_value(const arc_setting *s, const char *prefix, const void *def,
                              arc_error *error) {
  const arc_series series = arc_setting_series(s, def);
  if (s->kind == ARC_OTHER || s->kind == ARC_TEXT || arc_setting_has_function(s, def) ||
      arc_setting_is_auto(s, def))
    return ARC_OK;
  if (s->kind == ARC_GROUP) return check_group(s, prefix, def, error);
  if (series.count > 0) return check_series(s, prefix, series, error);
  const double value = arc_setting_number(s, def);
  if (s->forms & ARC_OPTIONAL && value == 0) return ARC_OK;
  if (s->kind == ARC_CHOICE) return check_choice(s, prefix, (int)value, error);
  return arc_setting_check_number(s, prefix, value, error);
}

arc_status arc_settings_check(const arc_setting *list, const char *prefix, const void *def,
                              arc_error *error) {
  for (const arc_setting *s = list; s->name; s++) {
    const arc_status status = check_value(s, prefix, def, error);
    if (status != ARC_OK) return status;
  }
  return ARC_OK;
}

/* --- loops --------------------------------------------------------------------------------- */

int arc_settings_walk(const arc_setting *list, const char *prefix, const void *def,
                      arc_setting_fn see, void *context) {
  int ended = 0;
  for (const arc_setting *s = list; s->name && !ended; s++) {
    char path[96];
    snprintf(path, sizeof path, "%s%s%s", prefix, s->name, s->kind == ARC_GROUP ? "." : "");
    if (s->kind == ARC_GROUP)
      ended = arc_settings_walk(s->group, path, arc_setting_value(s, def), see, context);
    else if (s->kind != ARC_OTHER)
      ended = see(context, path, s, def);
  }
  return ended;
}
