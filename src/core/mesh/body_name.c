/* Checks of the names of bodies. */
#include "core/mesh/body_name.h"
#include "archard/mesh.h"

#include <ctype.h>
#include <string.h>

/* Returns true for names that a body must not have: roles, kinds of bodies, words for sums such
 * as "total", and settings of a mesh. */
static int is_taken(const char *name) {
  static const char *const words[] = {"upper", "lower", "plate", "total", "both", "all", NULL};
  for (int i = 0; words[i]; i++)
    if (strcmp(name, words[i]) == 0) return 1;
  for (int i = 0; arc_solid_names[i]; i++)
    if (strcmp(name, arc_solid_names[i]) == 0) return 1;
  return arc_setting_find(arc_mesh_settings, name) != NULL;
}

int arc_body_is_word(const char *name) {
  int word = isalpha((unsigned char)name[0]) != 0;
  for (; *name; name++) word = word && (isalnum((unsigned char)*name) || *name == '_');
  return word;
}

arc_status arc_body_check_name(const arc_body_def *b, const char *path, arc_error *error) {
  if (!b->name[0]) return ARC_OK;
  if (!arc_body_is_word(b->name))
    return arc_fail(error, ARC_ARGUMENT, "field '%sname': expected " ARC_BODY_NAME ", got \"%s\"",
                    path, b->name);
  if (!is_taken(b->name)) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field '%sname': expected a name other than a kind of body, a field of mesh, or "
                  "one of 'upper', "
                  "'lower', 'plate', 'total', 'both', 'all', got \"%s\"; bodies of different "
                  "kinds are called by their kind without a name",
                  path, b->name);
}
