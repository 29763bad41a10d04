/* Contents of a Gmsh file: nodes, elements and groups. The lists grow while items are read,
 * because the counts in the file may be wrong. */
#ifndef MESH_GMSH_FILE_H
#define MESH_GMSH_FILE_H

#include "archard/mesh.h"
#include "core/base/list.h"
#include "core/mesh/gmsh_text.h"

/* A physical group with a name. */
typedef struct msh_group {
  long long tag;
  int dim;
  char name[64];
} msh_group;

/* Group to which elements refer: an entity of the geometry (version 4.1) or a physical group
 * (version 2.2). */
typedef struct msh_entity {
  long long tag;
  int dim;
  unsigned sets;            /* bits of the sets that contain the entity, see arc_msh_bit */
  int material[ARC_BODIES]; /* index of the entity's material in the list of each body; -1
                               without material */
} msh_entity;

/* Membership: the entity `tag` belongs to the physical group `group`. */
typedef struct msh_member {
  long long tag, group;
  int dim;
} msh_member;

typedef struct msh_node {
  long long tag;
  double x[3];
} msh_node;

typedef struct msh_element {
  long long tag, entity;
  long long corner[4]; /* node numbers; arc_mesh_read_msh replaces them by indices */
  int dim, type;       /* dimension, 1 or 2, and element type of Gmsh */
} msh_element;

enum { MSH_LINE = 1, MSH_TRIANGLE = 2, MSH_QUAD = 3 };

typedef struct msh_file {
  msh_text text;
  int version;                                /* major version of the format, 2 or 4 */
  item_list groups, members, nodes, elements; /* lists of msh_group, msh_member, msh_node and
                                                 msh_element */
  item_list entities;        /* list of msh_entity, sorted by dimension and number */
  int materials[ARC_BODIES]; /* number of materials of each body */
  char material[ARC_BODIES][ARC_MESH_MATERIALS][ARC_TEXT_SIZE]; /* names of the materials */
} msh_file;

/* Parses `file->text` and writes the other members of `file`. After an error nothing has to be
 * freed. */
arc_status arc_msh_read(msh_file *file, arc_error *error);
void arc_msh_free(msh_file *file);

#endif
