/* Inside the reader of Gmsh files: the text, what stands in it, and the bodies that are made of it.
 *
 * Text to lines and numbers (gmsh_text.c), to nodes, elements and groups as the file has them
 * (gmsh_file.c), to which body and which of its sets each belongs (gmsh_groups.c), to one body
 * (gmsh_body.c) and its boundary (gmsh_boundary.c), to the pair (gmsh.c). No count of a file is
 * believed: arrays grow with what has been read.
 */
#ifndef MESH_GMSH_H
#define MESH_GMSH_H

#include "archard/mesh.h"
#include "core/base/list.h"

/* --- text ------------------------------------------------------------------------------------- */

typedef struct msh_text {
  const char *path; /* what messages call it */
  char *data, *end; /* the whole file, and a zero behind it */
  char *next;       /* the line that follows */
  char *at;         /* what is left of the present line, without its end */
  long line;        /* its number, from 1 */
} msh_text;

/* Reads the whole file. ARC_IO, ARC_MEMORY, ARC_FORMAT (too large). */
arc_status arc_msh_open(msh_text *text, const char *path, arc_error *error);
/* Takes a copy of a text that is no file, under a name. ARC_MEMORY. */
arc_status arc_msh_copy(msh_text *text, const char *name, const char *from, size_t length,
                        arc_error *error);
void arc_msh_close(msh_text *text);

/* Goes to the next line that is not blank; 0: there is none. */
int arc_msh_line(msh_text *text);
/* Takes a number from the line: finite, with white space or the line's end behind it; else 0. */
int arc_msh_real(msh_text *text, double *value);
int arc_msh_whole(msh_text *text, long long *value);

/* ARC_FORMAT: file and line, and what is wrong there. */
arc_status arc_msh_fail(const msh_text *text, arc_error *error, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* What a message shows of a text: its beginning, printable. */
typedef struct msh_shown {
  char text[32];
} msh_shown;
msh_shown arc_msh_show(const char *text);

/* --- the file --------------------------------------------------------------------------------- */

/* A physical group with a name. */
typedef struct msh_group {
  long long tag;
  int dim;
  char name[64];
} msh_group;

/* What elements refer to: an entity of the geometry (4.1), or a physical group (2.2). */
typedef struct msh_entity {
  long long tag;
  int dim;
  unsigned sets;            /* of which it is part, see set_of */
  int material[ARC_BODIES]; /* index among the body's materials */
} msh_entity;

/* Entity and physical group that belong together. */
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
  long long corner[4]; /* numbers of nodes; after arc_msh_sort, indices */
  int dim, type;       /* type as in Gmsh */
} msh_element;

enum { MSH_LINE = 1, MSH_TRIANGLE = 2, MSH_QUAD = 3 };

typedef struct msh_file {
  msh_text text;
  int version;                                                  /* 2 or 4 */
  item_list groups, members, nodes, elements;                   /* of the structs above */
  item_list entities;                                           /* by dimension and number */
  int materials[ARC_BODIES];                                    /* of each body */
  char material[ARC_BODIES][ARC_MESH_MATERIALS][ARC_TEXT_SIZE]; /* their names */
} msh_file;

/* Reads the text of a file that is set up but for that. On failure there is nothing to free. */
arc_status arc_msh_read(msh_file *file, arc_error *error);
void arc_msh_free(msh_file *file);

/* --- groups ----------------------------------------------------------------------------------- */

typedef enum msh_set { MSH_BODY, MSH_CONTACT, MSH_FIXED, MSH_SETS } msh_set;

static inline unsigned arc_msh_bit(arc_body body, msh_set set) {
  return 1u << ((int)body * MSH_SETS + (int)set);
}

/* "upper" or "lower". */
const char *arc_msh_role(arc_body body);

/* Finds what the groups of the file mean; all six are there. ARC_FORMAT, ARC_MEMORY. */
arc_status arc_msh_sort_groups(msh_file *file, arc_error *error);
/* The entity of an element; NULL: one without a group. */
const msh_entity *arc_msh_entity_of(const msh_file *file, const msh_element *element);

/* --- bodies ----------------------------------------------------------------------------------- */

/* A body under construction. */
typedef struct msh_body {
  const msh_file *file;
  arc_mesh *mesh;
  int *local;  /* [nodes of the file] number in the mesh, or -1 */
  int *origin; /* [nodes] index in the file */
  int *source; /* [elements] index in the file */
  int *next;   /* [nodes] the node that follows on the boundary, or -1 */
  arc_error *error;
} msh_body;

/* Number of a node of the mesh in the file, and its place. */
static inline long long arc_msh_tag(const msh_body *b, int node) {
  return ((const msh_node *)b->file->nodes.data)[b->origin[node]].tag;
}

/* The mesh of one body. `owner` [nodes of the file] has the body that uses a node, -1: none yet. */
arc_status arc_msh_body(const msh_file *file, arc_body body, signed char *owner, arc_mesh **mesh,
                        arc_error *error);
/* Boundary, candidate surface, fixed nodes. */
arc_status arc_msh_boundary(msh_body *b);

#endif
