/* Defines the names of the values of enumerations, and the names of the bodies. */
#include "core/pair/cycle.h"

const char *const arc_geometry_names[] = {ARC_GEOMETRY_LIST(ARC_CHOICE_NAME) NULL};
const char *const arc_corrections_names[] = {ARC_CORRECTIONS_LIST(ARC_CHOICE_NAME) NULL};
const char *const arc_press_names[] = {ARC_PRESS_LIST(ARC_CHOICE_NAME) NULL};

const char *arc_body_name(arc_body body) {
  return body == ARC_CYLINDER ? "cylinder" : "plate";
}
