/* Defines the names of columns in the file, and writes the parts of SQL texts that contain these
 * names. The history has a column for each item in the list of archard/wear.h. The name of a
 * column includes the unit, such as half_width_mm. */
#include "store/store.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct column {
  const char *name, *unit, *text;
} column;

static const column history[] = {
#define COLUMN(name, unit, range, rule, text) {#name, unit, text},
    ARC_WEAR_COLUMNS(COLUMN)
#undef COLUMN
};

/* Columns outside the history: results of a case and values at the nodes. */
static const column others[] = {
    {"volume_total", "mm3", "wear volume of both bodies"},
    {"seconds", "s", "computing time of a finished case; its column has no unit in the name"},
    {"x", "mm", "unworn position of a node"},
    {"h", "mm", "wear depth of a node"},
    {"y", "mm", "present height of a node"},
    {"p", "MPa", "pressure at a node, with the plate at x = 0"},
};

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* --- parts of SQL texts ----------------------------------------------------------------------- */

/* Writes the name of a column with its unit. The name "update" is a keyword of SQL and is
 * replaced by "updates". */
static void put_name(FILE *to, const column *c) {
  fputs(strcmp(c->name, "update") == 0 ? "updates" : c->name, to);
  if (c->unit[0]) fputc('_', to);
  for (const char *at = c->unit; *at; at++)
    if (*at == '/')
      fputs("_per_", to);
    else
      fputc(*at == ' ' ? '_' : *at, to);
}

static void put_text(FILE *to, const char *text) {
  fputc('\'', to);
  for (; *text; text++) {
    if (*text == '\'') fputc('\'', to);
    fputc(*text, to);
  }
  fputc('\'', to);
}

static void put_columns(FILE *to) {
  for (size_t c = 0; c < COUNT(history); c++) {
    fputs(", ", to);
    put_name(to, &history[c]);
  }
}

static void put_values(FILE *to) {
  for (size_t c = 0; c < COUNT(history); c++) fputs(", ?", to);
}

/* Returns true for the columns of the history that are also settings: k, alpha and jump. */
static int is_setting(const char *name) {
  const arc_setting *s = arc_setting_find(arc_wear_settings, name);
  return s && s->kind != ARC_OTHER && strcmp(name, "distance") != 0 && strcmp(name, "update") != 0;
}

static void put_results(FILE *to) {
  for (size_t c = 0; c < COUNT(history); c++) {
    if (is_setting(history[c].name)) continue;
    fputs(", h.", to);
    put_name(to, &history[c]);
  }
}

/* Settings whose column has another name, because the setting's name is already the name of a
 * result, a keyword of SQL or, for a setting of the model, the name of a setting of the run. Each
 * row contains the prefix, the setting and the column. */
static const char *const renamed[][3] = {{"", "distance", "total_distance"},
                                         {"", "update", "update_at"},
                                         {"", "order", "scheme_order"},
                                         {"model.", "geometry", "model_geometry"}};

/* Returns the column of a setting. For example, the column of the setting mesh.size is
 * "mesh_size". */
static column column_of(const char *prefix, const char *path, const arc_setting *s,
                        char name[static 96]) {
  size_t i = 0;
  for (size_t r = 0; r < COUNT(renamed); r++)
    if (strcmp(prefix, renamed[r][0]) == 0 && strcmp(path, renamed[r][1]) == 0)
      path = renamed[r][2];
  for (; i < 95 && path[i]; i++) name[i] = path[i] == '.' ? '_' : path[i];
  name[i] = '\0';
  const int counted = !s->unit || strcmp(s->unit, "cycles") == 0;
  return (column){name, counted ? "" : s->unit, s->text};
}

/* Writes the names of the values that may replace the number of a setting: its function, its
 * series, or the blocks of loading. */
static void put_instead(FILE *to, const char *path, unsigned forms) {
  fputs("''", to);
  if (forms & ARC_FUNCTION) fprintf(to, ", '%s_function'", path);
  if (forms & ARC_SERIES) fprintf(to, ", '%s_series.value'", path);
  if (strcmp(path, "stroke") == 0 || strcmp(path, "increments") == 0) fputs(", 'blocks'", to);
}

/* Context of a loop over the settings: the output file, the prefix of the names, and the
 * function that writes a setting. */
typedef struct walk {
  FILE *to;
  const char *prefix;
  void (*put)(struct walk *walk, const char *path, const arc_setting *s);
} walk;

/* Writes the SQL expression for the value of a setting. The value is read from the definition of
 * the case, or from the settings of the case if there is no definition. */
static void put_setting(walk *at, const char *path, const arc_setting *s) {
  char name[96];
  const column c = column_of(at->prefix, path, s, name);
  const char *prefix = at->prefix;
  fprintf(at->to,
          ", coalesce((SELECT value FROM definition WHERE case_id = c.id AND name = '%s%s' AND NOT "
          "EXISTS (SELECT 1 FROM definition d WHERE d.case_id = c.id AND d.name IN (",
          prefix, path);
  put_instead(at->to, path, s->forms);
  fprintf(at->to,
          ") AND d.value <> 0)), (SELECT value FROM settings WHERE case_id = c.id AND name = "
          "'%s%s')) AS ",
          prefix, path);
  put_name(at->to, &c);
}

static int see_setting(void *context, const char *path, const arc_setting *s, const void *def) {
  walk *at = context;
  (void)def;
  at->put(at, path, s);
  return 0;
}

static void put_all(FILE *to, void (*put)(walk *at, const char *path, const arc_setting *s)) {
  const arc_wear_def wear = arc_wear_default();
  const arc_model_def model = arc_model_default();
  walk at = {to, "", put};
  arc_settings_walk(arc_wear_settings, "", &wear, see_setting, &at);
  at.prefix = "model.";
  arc_settings_walk(arc_model_settings, "", &model, see_setting, &at);
}

static void put_settings(FILE *to) {
  put_all(to, put_setting);
}

/* Writes all byte values from 00 to ff in hexadecimal. */
static void put_bytes(FILE *to) {
  for (unsigned b = 0; b < 256; b++) fprintf(to, "%02x", b);
}

/* Writes an SQL expression that decodes a double from its bits. The expression requires a column
 * `bytes` with all byte values. Each LIMIT prevents SQLite from evaluating an inner query again
 * for every use. Subnormal numbers become 0. */
static void put_number(FILE *to, const char *array) {
  const int least_first = __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__;
  fputs("(SELECT CASE WHEN e = 0 THEN f * 0.0 WHEN e = 2047 THEN NULL WHEN e < 1023 THEN f / power"
        "  ELSE f * power END FROM (SELECT e, f, (1 << (n & 31)) * iif(n & 32, 4294967296.0, 1.0)"
        "  * iif(n & 64, 18446744073709551616.0, 1.0) * iif(n & 128, 3.4028236692093846e38, 1.0)"
        "  * iif(n & 256, 1.157920892373162e77, 1.0) * iif(n & 512, 1.3407807929942597e154, 1.0)"
        "  AS power FROM (SELECT bits >> 52 & 2047 AS e, abs((bits >> 52 & 2047) - 1023) AS n,"
        "  iif(bits < 0, -1, 1) * (1 + (bits & 4503599627370495) / 4503599627370496.0) AS f FROM"
        "  (SELECT 0",
        to);
  for (int i = 0; i < 8; i++)
    fprintf(to, " | (instr(bytes, substr(b, %d, 1)) - 1 << %d)", least_first ? i + 1 : 8 - i,
            8 * i);
  fprintf(
      to,
      " AS bits FROM (SELECT substr(%s.numbers, 8 * node + 1, 8) AS b LIMIT 1) LIMIT 1) LIMIT 1)"
      " LIMIT 1))",
      array);
}

/* Writes the columns of the view `surfaces`, which are decoded from the arrays with the same
 * names. */
static void put_numbers(FILE *to) {
  for (const char *const *name = arc_surface_names; *name; name++) {
    fputs(", ", to);
    put_number(to, *name);
    fputs(" AS ", to);
    for (size_t c = 0; c < COUNT(others); c++)
      if (strcmp(others[c].name, *name) == 0) put_name(to, &others[c]);
  }
}

static void put_unit(FILE *to, const column *c, int first) {
  fputs(first ? "('" : ", ('", to);
  put_name(to, c);
  fprintf(to, "', '%s', ", c->unit);
  put_text(to, c->text);
  fputc(')', to);
}

static void put_setting_unit(walk *at, const char *path, const arc_setting *s) {
  char name[96];
  const column c = column_of(at->prefix, path, s, name);
  put_unit(at->to, &c, 0);
}

static void put_units(FILE *to) {
  for (size_t c = 0; c < COUNT(others); c++) put_unit(to, &others[c], c == 0);
  for (size_t c = 0; c < COUNT(history); c++)
    if (!is_setting(history[c].name)) put_unit(to, &history[c], 0);
  put_all(to, put_setting_unit);
}

/* --- complete SQL texts ----------------------------------------------------------------------- */

static const struct {
  const char *word;
  void (*put)(FILE *to);
} parts[] = {{"@columns", put_columns},   {"@values", put_values}, {"@results", put_results},
             {"@settings", put_settings}, {"@bytes", put_bytes},   {"@numbers", put_numbers},
             {"@units", put_units}};

/* If `text` begins with one of the words to be replaced, appends the replacement, otherwise the
 * first character of `text`. Returns the number of characters of `text` that were processed. */
static size_t put_part(FILE *to, const char *text) {
  for (size_t p = 0; p < COUNT(parts); p++) {
    size_t length = strlen(parts[p].word);
    if (strncmp(text, parts[p].word, length) != 0) continue;
    parts[p].put(to);
    return length;
  }
  fputc(*text, to);
  return 1;
}

char *arc_columns_sql(const char *pattern) {
  char *sql = NULL;
  size_t size;
  FILE *to = open_memstream(&sql, &size);
  if (!to) return NULL;
  while (*pattern) pattern += put_part(to, pattern);
  int failed = ferror(to);
  if (fclose(to) == 0 && !failed) return sql;
  free(sql);
  return NULL;
}
