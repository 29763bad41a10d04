/* Checks that the definition of a body with an imported mesh does not define the shape as well. */
#include "core/elastic/imported_mesh.h"

#include <string.h>

/* Returns true for the radii of a hole. They are allowed because they define the arc along which
 * the contact is solved. */
static int tells_arc(const arc_model_def *def, const char *name) {
  return arc_model_is_hole(def) &&
         (strcmp(name, "radius") == 0 || strcmp(name, "inner") == 0 || strcmp(name, "outer") == 0);
}

static int is_given(const arc_setting *s, const arc_body_def *body) {
  return s->kind == ARC_NUMBER &&
         (arc_setting_number(s, body) != 0 || arc_setting_series(s, body).count > 0);
}

arc_status arc_given_check_shape(const arc_model_def *def, arc_body body, arc_error *error) {
  for (const arc_setting *s = arc_body_settings; s->name; s++)
    if (is_given(s, &def->body[body]) && !tells_arc(def, s->name))
      return arc_fail(error, ARC_ARGUMENT,
                      "field '%s.%s': an imported mesh allows only name and materials "
                      "(and the radii of a hole), got the %s of a %s",
                      arc_model_role_name(body), s->name, s->name,
                      arc_solid_names[def->body[body].kind]);
  return ARC_OK;
}
