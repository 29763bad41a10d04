/* What bodies may be called. */
#ifndef MESH_BODY_NAME_H
#define MESH_BODY_NAME_H

#include "archard/body.h"

/* Whether a name is a word, ARC_BODY_NAME but for its length. */
int arc_body_is_word(const char *name);
/* Names that are words, and stand for nothing else. */
arc_status arc_body_check_name(const arc_body_def *body, const char *path, arc_error *error);

#endif
