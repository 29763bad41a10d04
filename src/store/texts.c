/* Stores long texts, such as imported meshes. Each text is stored only once, under a name made
 * from its checksum. Values contain this name instead of the text. A text has the same name in
 * all files. */
#include "store/store.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A text with this number of characters or more is stored separately. A shorter text is stored in
 * the row of its value, unless it has the form of a name. */
enum { LONG = 1000 };
static const char prefix[] = "text:";

static int is_name(const char *text) {
  return strncmp(text, prefix, sizeof prefix - 1) == 0;
}

static void find_name(const char *text, char name[ARC_TEXT_NAME]) {
  snprintf(name, ARC_TEXT_NAME, "%s%016" PRIx64, prefix,
           arc_store_checksum(ARC_STORE_CHECKSUM, text, strlen(text)));
}

arc_status arc_store_put_text(arc_store *store, const char *text, char name[ARC_TEXT_NAME],
                              arc_error *error) {
  query *q;
  name[0] = '\0';
  if (strlen(text) < LONG && !is_name(text)) return ARC_OK;
  find_name(text, name);
  arc_status status = arc_query_open(
      store->db, "INSERT OR IGNORE INTO texts (name, text) VALUES (?1, ?2)", &q, error);
  if (status == ARC_OK) {
    arc_query_set_text(q, 1, name);
    arc_query_set_text(q, 2, text);
    status = arc_query_run(q, error);
  }
  arc_query_close(&q);
  return status;
}

/* Returns true if the checksum of the text in this column matches the name of the text. */
static int is_sound(query *q, int column, const char *name) {
  char expected[ARC_TEXT_NAME];
  find_name(arc_query_text(q, column), expected);
  return arc_query_kind(q, column) == COLUMN_TEXT && strcmp(name, expected) == 0;
}

static arc_status damaged(const arc_store *store, const char *name, arc_error *error) {
  return arc_fail(error, ARC_FORMAT,
                  "%s: the file is damaged: the text '%.40s' is missing or has changed",
                  store->path, name);
}

arc_status arc_store_get_text(arc_store *store, const char *name, char **text, arc_error *error) {
  query *q;
  int row = 0;
  *text = NULL;
  if (!is_name(name)) return ARC_OK;
  arc_status status =
      arc_query_open(store->db, "SELECT text FROM texts WHERE name = ?1", &q, error);
  if (status == ARC_OK) {
    arc_query_set_text(q, 1, name);
    status = arc_query_step(q, &row, error);
  }
  if (status == ARC_OK && (!row || !is_sound(q, 0, name))) status = damaged(store, name, error);
  if (status == ARC_OK && !(*text = strdup(arc_query_text(q, 0))))
    status = arc_fail(error, ARC_MEMORY, "%s: out of memory", store->path);
  arc_query_close(&q);
  return status;
}

arc_status arc_store_verify_texts(arc_store *store, arc_error *error) {
  query *q;
  int row = 0;
  arc_status status =
      arc_query_open(store->db, "SELECT name, text FROM texts ORDER BY name", &q, error);
  while (status == ARC_OK && (status = arc_query_step(q, &row, error)) == ARC_OK && row)
    if (!is_sound(q, 1, arc_query_text(q, 0))) status = damaged(store, arc_query_text(q, 0), error);
  arc_query_close(&q);
  return status;
}
