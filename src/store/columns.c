/* The names of columns in the file, and the parts of SQL texts that are made of them. All about the
 * history follows from the one list in archard/wear.h. A name tells the unit: half_width_mm. */
#include "store/store.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct column {
  const char *name, *unit, *text;
} column;

static const column history[] = {
#define COLUMN(name, unit, text) {#name, unit, text},
    ARC_WEAR_COLUMNS(COLUMN)
#undef COLUMN
};

/* A column of case_results that comes from the definition, or before there is one from the
 * settings; without a value where one of `instead` is there and not 0. */
typedef struct setting {
  column column;
  const char *name, *instead;
} setting;

static const setting settings[] = {
    {{"k", "mm2/N", "wear coefficient; none where a function or series"},
     "k",
     "'k_function', 'k_series.value'"},
    {{"alpha", "", "wear partition factor; none where a function or series"},
     "alpha",
     "'alpha_function', 'alpha_series.value'"},
    {{"load", "N", "load, whole thickness; of the reference configuration"}, "load", ""},
    {{"stroke", "mm", "stroke; none with blocks of loading"}, "stroke", "'blocks'"},
    {{"total_distance", "mm", "travelled distance to simulate; 0: all blocks"}, "distance", ""},
    {{"jump", "", "cycles per update; none where it varies"},
     "jump",
     "'jump_function', 'jump_auto'"},
    {{"increments", "", "increments of a full cycle; 0: chosen by the program"},
     "increments",
     "'blocks'"},
    {{"procedure", "", "auto, SP or NSP"}, "procedure", ""},
    {{"scheme", "", "explicit or implicit"}, "scheme", ""},
    {{"geometry", "", "moving or frozen"}, "geometry", ""},
    {{"radius", "mm", "radius of the cylinder"}, "model.radius", ""},
    {{"thickness", "mm", "thickness of both bodies"}, "model.thickness", ""},
    {{"E_cylinder", "MPa", "Young's modulus of the cylinder"}, "model.cylinder.E", ""},
    {{"nu_cylinder", "", "Poisson's ratio of the cylinder"}, "model.cylinder.nu", ""},
    {{"E_plate", "MPa", "Young's modulus of the plate"}, "model.plate.E", ""},
    {{"nu_plate", "", "Poisson's ratio of the plate"}, "model.plate.nu", ""},
    {{"mesh_size", "mm", "width of the elements at the contact"}, "model.mesh.size", ""},
    {{"mesh_height", "mm", "height of the elements at the contact"}, "model.mesh.height", ""},
};

/* What has a unit elsewhere. */
static const column others[] = {
    {"volume_total", "mm3", "wear volume of both bodies"},
    {"seconds", "", "time in s that a finished case took"},
    {"x", "mm", "unworn position of a node"},
    {"h", "mm", "wear depth of a node"},
    {"y", "mm", "present height of a node"},
    {"p", "MPa", "pressure of a node, plate at x = 0"},
};

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* --- parts ------------------------------------------------------------------------------------ */

/* "update" is a word of SQL's own. */
static void put_name(FILE *to, const column *c) {
  fputs(strcmp(c->name, "update") == 0 ? "updates" : c->name, to);
  if (c->unit[0]) fputc('_', to);
  for (const char *at = c->unit; *at; at++)
    if (*at == '/')
      fputs("_per_", to);
    else
      fputc(*at, to);
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

static int is_setting(const char *name) {
  for (size_t s = 0; s < COUNT(settings); s++)
    if (strcmp(settings[s].column.name, name) == 0) return 1;
  return 0;
}

static void put_results(FILE *to) {
  for (size_t c = 0; c < COUNT(history); c++) {
    if (is_setting(history[c].name)) continue;
    fputs(", h.", to);
    put_name(to, &history[c]);
  }
}

static void put_settings(FILE *to) {
  for (size_t s = 0; s < COUNT(settings); s++) {
    fprintf(
        to,
        ", coalesce((SELECT value FROM definition WHERE case_id = c.id AND name = '%s' AND NOT "
        "EXISTS (SELECT 1 FROM definition d WHERE d.case_id = c.id AND d.name IN (%s) AND "
        "d.value <> 0)), (SELECT value FROM settings WHERE case_id = c.id AND name = '%s')) AS ",
        settings[s].name, settings[s].instead, settings[s].name);
    put_name(to, &settings[s].column);
  }
}

static void put_unit(FILE *to, const column *c, int first) {
  fputs(first ? "('" : ", ('", to);
  put_name(to, c);
  fprintf(to, "', '%s', ", c->unit);
  put_text(to, c->text);
  fputc(')', to);
}

static void put_units(FILE *to) {
  for (size_t s = 0; s < COUNT(settings); s++) put_unit(to, &settings[s].column, s == 0);
  for (size_t c = 0; c < COUNT(history); c++)
    if (!is_setting(history[c].name)) put_unit(to, &history[c], 0);
  for (size_t c = 0; c < COUNT(others); c++) put_unit(to, &others[c], 0);
}

/* --- texts ------------------------------------------------------------------------------------ */

static const struct {
  const char *word;
  void (*put)(FILE *to);
} parts[] = {{"@columns", put_columns},
             {"@values", put_values},
             {"@results", put_results},
             {"@settings", put_settings},
             {"@units", put_units}};

/* Puts the part that a text begins with; how long its word is. */
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
