/* Selects the kind of pair for a geometry. */
#include "core/pair/kind.h"

extern const arc_kind arc_plane_kind, arc_space_kind, arc_springs_kind;

const arc_kind *arc_kind_of(arc_space geometry) {
  if (geometry == ARC_SPATIAL) return &arc_space_kind;
  return geometry == ARC_SPRINGS ? &arc_springs_kind : &arc_plane_kind;
}
