/* Checks of the names of bodies. */
#ifndef MESH_BODY_NAME_H
#define MESH_BODY_NAME_H

#include "archard/body.h"

/* Returns true if a name has the form described by ARC_BODY_NAME. The length is not checked. */
int arc_body_is_word(const char *name);
/* Checks that the name of a body is a word and not reserved. Error: ARC_ARGUMENT; the message
 * contains the field and the name. */
arc_status arc_body_check_name(const arc_body_def *body, const char *path, arc_error *error);

#endif
