/* Assigns the nodes and elements of a Gmsh file to bodies and sets. */
#ifndef MESH_GMSH_GROUPS_H
#define MESH_GMSH_GROUPS_H

#include "core/mesh/gmsh_file.h"

typedef enum msh_set { MSH_BODY, MSH_CONTACT, MSH_FIXED, MSH_SETS } msh_set;

static inline unsigned arc_msh_bit(arc_body body, msh_set set) {
  return 1u << ((int)body * MSH_SETS + (int)set);
}

/* Returns the role of a body, "upper" or "lower". */
const char *arc_msh_role(arc_body body);

/* Assigns the physical groups of the file to bodies and sets. All six groups are required.
 * Errors: ARC_GEOMETRY, ARC_MEMORY. */
arc_status arc_msh_sort_groups(msh_file *file, arc_error *error);
/* Returns the entity of an element, or NULL for an element without a group. */
const msh_entity *arc_msh_entity_of(const msh_file *file, const msh_element *element);

#endif
