/* Reads the sections of a Gmsh file, versions 2.2 and 4.1. */
#include "core/mesh/gmsh_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Largest accepted count of items, four times the limit of archard's mesher. A larger count is
 * an error in the file. */
enum { most_items = 4000000 };

static arc_status out_of_memory(const msh_file *f, arc_error *error) {
  return arc_fail(error, ARC_MEMORY, "out of memory for reading %s", f->text.path);
}

/* --- items and their counts ------------------------------------------------------------------- */

/* Reads the line of item `i` of `count` items. Error: ARC_FORMAT if the section ends before this
 * item. */
static arc_status next_item(msh_file *f, const char *what, long long i, long long count,
                            arc_error *error) {
  if (!arc_msh_line(&f->text))
    return arc_msh_fail(&f->text, error, "the file ends after %lld of %lld %s", i, count, what);
  if (*f->text.at == '$')
    return arc_msh_fail(&f->text, error, "expected %lld %s, got %lld and then '%s'", count, what, i,
                        arc_msh_show(f->text.at).text);
  return ARC_OK;
}

static arc_status bad_item(const msh_file *f, const char *expected, arc_error *error) {
  return arc_msh_fail(&f->text, error, "expected %s, got '%s'", expected,
                      arc_msh_show(f->text.at).text);
}

/* Reads a count between 0 and `most` from the current line. */
static arc_status read_count(msh_file *f, const char *what, long long most, long long *count,
                             arc_error *error) {
  char *before = f->text.at;
  if (arc_msh_whole(&f->text, count) && *count >= 0 && *count <= most) return ARC_OK;
  return arc_msh_fail(&f->text, error, "expected a number of %s from 0 to %lld, got '%s'", what,
                      most, arc_msh_show(before).text);
}

/* Reads `n` whole numbers from the current line. Returns 0 if a number is missing. */
static int read_wholes(msh_file *f, int n, long long *value) {
  for (int k = 0; k < n; k++)
    if (!arc_msh_whole(&f->text, &value[k])) return 0;
  return 1;
}

static int skip_reals(msh_file *f, int n) {
  double ignored;
  for (int k = 0; k < n; k++)
    if (!arc_msh_real(&f->text, &ignored)) return 0;
  return 1;
}

/* --- format and groups ------------------------------------------------------------------------ */

static arc_status read_format(msh_file *f, arc_error *error) {
  double version;
  long long binary, bytes;
  arc_status status = next_item(f, "lines of the format", 0, 1, error);
  if (status != ARC_OK) return status;
  char *before = f->text.at;
  if (!arc_msh_real(&f->text, &version) || !arc_msh_whole(&f->text, &binary) ||
      !arc_msh_whole(&f->text, &bytes))
    return bad_item(f, "version, file type and bytes per number, such as \"4.1 0 8\"", error);
  if (binary != 0)
    return arc_msh_fail(
        &f->text, error,
        "the file is binary; save it as text (without -bin, or with Mesh.Binary = 0)");
  f->version = version == 4.1 ? 4 : version == 2.2 ? 2 : 0;
  if (f->version) return ARC_OK;
  return arc_msh_fail(&f->text, error,
                      "expected version 4.1 or 2.2, got '%s'; save it with -format msh41",
                      arc_msh_show(before).text);
}

/* Reads a line with dimension, number and name of a physical group, such as 2 1 "upper". */
static arc_status read_name(msh_file *f, arc_error *error) {
  long long dim, tag;
  char *stop = NULL;
  if (arc_msh_whole(&f->text, &dim) && arc_msh_whole(&f->text, &tag) && *f->text.at == '"')
    stop = strchr(f->text.at + 1, '"');
  if (!stop || dim < 0 || dim > 3)
    return bad_item(f, "dimension, number and name of a group, such as 2 1 \"upper\"", error);
  const size_t length = (size_t)(stop - f->text.at - 1);
  msh_group *group = arc_list_add(&f->groups, sizeof *group);
  if (!group) return out_of_memory(f, error);
  group->dim = (int)dim;
  group->tag = tag;
  const size_t capacity = sizeof group->name - 1;
  memcpy(group->name, f->text.at + 1, length < capacity ? length : capacity);
  for (char *c = group->name; *c; c++)
    if ((unsigned char)*c < ' ') *c = '?';
  return ARC_OK;
}

static arc_status read_names(msh_file *f, arc_error *error) {
  long long count;
  arc_status status = next_item(f, "counts", 0, 1, error);
  if (status == ARC_OK) status = read_count(f, "groups", most_items, &count, error);
  for (long long i = 0; status == ARC_OK && i < count; i++)
    if ((status = next_item(f, "groups", i, count, error)) == ARC_OK) status = read_name(f, error);
  return status;
}

/* --- entities --------------------------------------------------------------------------------- */

/* Reads the number, the extent and the physical groups of an entity. The list of its boundary
 * entities is ignored. */
static arc_status read_entity(msh_file *f, int dim, arc_error *error) {
  long long tag, count = 0, group;
  if (!arc_msh_whole(&f->text, &tag) || !skip_reals(f, dim == 0 ? 3 : 6) ||
      !arc_msh_whole(&f->text, &count))
    return bad_item(f, "number, extent and groups of an entity", error);
  for (long long i = 0; i < count; i++) {
    if (!arc_msh_whole(&f->text, &group) || group == 0)
      return bad_item(f, "the number of a group of an entity", error);
    msh_member *member = arc_list_add(&f->members, sizeof *member);
    if (!member) return out_of_memory(f, error);
    *member = (msh_member){.tag = tag, .dim = dim, .group = group < 0 ? -group : group};
  }
  return ARC_OK;
}

static arc_status read_entities(msh_file *f, arc_error *error) {
  static const char *const names[] = {"points", "curves", "surfaces", "volumes"};
  long long count[4];
  if (f->version == 2) return bad_item(f, "no $Entities in version 2.2", error);
  arc_status status = next_item(f, "counts", 0, 1, error);
  for (int dim = 0; status == ARC_OK && dim < 4; dim++)
    status = read_count(f, names[dim], most_items, &count[dim], error);
  for (int dim = 0; status == ARC_OK && dim < 4; dim++)
    for (long long i = 0; status == ARC_OK && i < count[dim]; i++)
      if ((status = next_item(f, names[dim], i, count[dim], error)) == ARC_OK)
        status = read_entity(f, dim, error);
  return status;
}

/* --- nodes ------------------------------------------------------------------------------------ */

static arc_status add_node(msh_file *f, arc_error *error) {
  long long tag;
  if (!arc_msh_whole(&f->text, &tag) || tag < 1) return bad_item(f, "the number of a node", error);
  msh_node *node = arc_list_add(&f->nodes, sizeof *node);
  if (!node) return out_of_memory(f, error);
  node->tag = tag;
  return ARC_OK;
}

static arc_status read_position(msh_file *f, int index, arc_error *error) {
  msh_node *node = (msh_node *)f->nodes.data + index;
  for (int d = 0; d < 3; d++) {
    if (!arc_msh_real(&f->text, &node->x[d]))
      return bad_item(f, "three finite coordinates of a node", error);
    node->x[d] += 0.0; /* changes -0.0 to 0.0 */
  }
  return ARC_OK;
}

/* Reads a block of nodes, which contains first all node numbers and then all coordinates. */
static arc_status read_node_block(msh_file *f, long long count, arc_error *error) {
  const int first = f->nodes.count;
  arc_status status = ARC_OK;
  for (long long i = 0; status == ARC_OK && i < count; i++)
    if ((status = next_item(f, "node numbers of a block", i, count, error)) == ARC_OK)
      status = add_node(f, error);
  for (int i = 0; status == ARC_OK && i < count; i++)
    if ((status = next_item(f, "nodes of a block", i, count, error)) == ARC_OK)
      status = read_position(f, first + i, error);
  return status;
}

/* Reads the first line of a block: three numbers, and the count of items in the block. A count
 * above `left` is an error. */
static arc_status read_block(msh_file *f, long long i, long long blocks, const char *what,
                             long long left, long long head[3], long long *count,
                             arc_error *error) {
  const arc_status status = next_item(f, "blocks", i, blocks, error);
  if (status != ARC_OK) return status;
  if (!read_wholes(f, 3, head)) return bad_item(f, "the four numbers before a block", error);
  return read_count(f, what, left, count, error);
}

/* Reads the number of blocks (only in version 4) and the number of items. The range of item
 * numbers at the end of the line is ignored. */
static arc_status read_counts(msh_file *f, const char *what, long long *blocks, long long *count,
                              arc_error *error) {
  arc_status status = next_item(f, "counts", 0, 1, error);
  if (status == ARC_OK && f->version == 4)
    status = read_count(f, "blocks", most_items, blocks, error);
  return status == ARC_OK ? read_count(f, what, most_items, count, error) : status;
}

static arc_status expect_all(const msh_file *f, const char *what, long long left,
                             arc_error *error) {
  if (left == 0) return ARC_OK;
  return arc_msh_fail(&f->text, error, "the blocks contain %lld fewer %s than their count", left,
                      what);
}

static arc_status read_nodes(msh_file *f, arc_error *error) {
  long long blocks = 0, left, count, head[3];
  arc_status status = read_counts(f, "nodes", &blocks, &left, error);
  const long long all = left;
  for (long long i = 0; f->version == 2 && status == ARC_OK && i < all; i++) {
    if ((status = next_item(f, "nodes", i, all, error)) != ARC_OK) break;
    if ((status = add_node(f, error)) == ARC_OK)
      status = read_position(f, f->nodes.count - 1, error);
    left--;
  }
  for (long long i = 0; status == ARC_OK && i < blocks; i++) {
    status = read_block(f, i, blocks, "nodes", left, head, &count, error);
    if (status == ARC_OK) status = read_node_block(f, count, error);
    left -= count;
  }
  return status == ARC_OK ? expect_all(f, "nodes", left, error) : status;
}

/* --- elements --------------------------------------------------------------------------------- */

/* Returns the dimension of the elements of a Gmsh element type. The result is 3 for solid and
 * unknown types. */
static int dimension_of(long long type) {
  static const char plane[] = {2, 3, 9, 10, 16, 20, 21, 22, 23, 24, 25, 36, 37, 0};
  static const char line[] = {1, 8, 26, 27, 28, 0};
  if (type == 15) return 0;
  if (type < 1 || type > 100) return 3;
  return strchr(line, (char)type) ? 1 : strchr(plane, (char)type) ? 2 : 3;
}

/* Returns the number of corners that the reader stores for an element type, or 0 for types of
 * higher order. */
static int corners_of(int type) {
  return type == MSH_LINE ? 2 : type == MSH_TRIANGLE ? 3 : type == MSH_QUAD ? 4 : 0;
}

/* Adds an element and reads its corners from the rest of the line. Elements that are not lines
 * or areas are ignored. */
static arc_status add_element(msh_file *f, long long tag, long long entity, long long type,
                              arc_error *error) {
  const int dim = dimension_of(type);
  if (dim != 1 && dim != 2) return ARC_OK;
  msh_element *e = arc_list_add(&f->elements, sizeof *e);
  if (!e) return out_of_memory(f, error);
  *e = (msh_element){.tag = tag, .entity = entity, .dim = dim, .type = (int)type};
  if (!read_wholes(f, corners_of(e->type), e->corner))
    return bad_item(f, "the nodes of an element", error);
  if (corners_of(e->type) > 0 && *f->text.at)
    return bad_item(f, "the end of the line after the nodes of an element", error);
  return ARC_OK;
}

/* Reads a line with an element in version 2.2: number, type, count of tags, tags, nodes. The
 * first tag is the number of the physical group. */
static arc_status read_element_2(msh_file *f, arc_error *error) {
  long long head[3], group = 0, other;
  if (!read_wholes(f, 3, head) || head[2] < 0)
    return bad_item(f, "number, type and tags of an element", error);
  for (long long i = 0; i < head[2]; i++)
    if (!arc_msh_whole(&f->text, i == 0 ? &group : &other))
      return bad_item(f, "the tags of an element", error);
  return add_element(f, head[0], group, head[1], error);
}

static arc_status read_element_block(msh_file *f, const long long head[3], long long count,
                                     arc_error *error) {
  arc_status status = ARC_OK;
  long long tag;
  if (dimension_of(head[2]) != head[0] && dimension_of(head[2]) < 3)
    return arc_msh_fail(&f->text, error, "elements of type %lld do not have dimension %lld",
                        head[2], head[0]);
  for (long long i = 0; status == ARC_OK && i < count; i++) {
    if ((status = next_item(f, "elements of a block", i, count, error)) != ARC_OK) break;
    status = arc_msh_whole(&f->text, &tag) ? add_element(f, tag, head[1], head[2], error)
                                           : bad_item(f, "the number of an element", error);
  }
  return status;
}

static arc_status read_elements(msh_file *f, arc_error *error) {
  long long blocks = 0, left, count, head[3];
  arc_status status = read_counts(f, "elements", &blocks, &left, error);
  const long long all = left;
  for (long long i = 0; f->version == 2 && status == ARC_OK && i < all; i++, left--)
    if ((status = next_item(f, "elements", i, all, error)) == ARC_OK)
      status = read_element_2(f, error);
  for (long long i = 0; status == ARC_OK && i < blocks; i++) {
    status = read_block(f, i, blocks, "elements", left, head, &count, error);
    if (status == ARC_OK) status = read_element_block(f, head, count, error);
    left -= count;
  }
  return status == ARC_OK ? expect_all(f, "elements", left, error) : status;
}

/* --- sections --------------------------------------------------------------------------------- */

typedef arc_status (*section_fn)(msh_file *f, arc_error *error);

static const struct section {
  const char *name;
  section_fn read;
} sections[] = {{"MeshFormat", read_format}, {"PhysicalNames", read_names},
                {"Entities", read_entities}, {"Nodes", read_nodes},
                {"Elements", read_elements}, {NULL, NULL}};

static int find_section(const char *name) {
  int s = 0;
  while (sections[s].name && strcmp(sections[s].name, name) != 0) s++;
  return s;
}

/* Returns true if the current line ends the section `name`. */
static int ends(const msh_file *f, const char *name) {
  return strncmp(f->text.at, "$End", 4) == 0 && strcmp(f->text.at + 4, name) == 0;
}

static arc_status end_section(msh_file *f, const char *name, int known, arc_error *error) {
  do {
    if (!arc_msh_line(&f->text))
      return arc_msh_fail(&f->text, error, "the file ends before $End%s", name);
    if (ends(f, name)) return ARC_OK;
  } while (!known);
  return arc_msh_fail(&f->text, error, "expected $End%s, got '%s'", name,
                      arc_msh_show(f->text.at).text);
}

/* Reads one section of the file. *seen has a bit for each section that has been read. */
static arc_status read_section(msh_file *f, unsigned *seen, arc_error *error) {
  char name[40];
  if (*f->text.at != '$' || strlen(f->text.at) > sizeof name)
    return bad_item(f, "a section such as $Nodes", error);
  strcpy(name, f->text.at + 1);
  const int s = find_section(name);
  if (*seen == 0 && s != 0)
    return bad_item(f, "$MeshFormat at the beginning, as in files of Gmsh", error);
  if (*seen >> s & 1 && sections[s].name)
    return arc_msh_fail(&f->text, error, "a second section $%s", name);
  *seen |= 1u << s;
  arc_status status = sections[s].name ? sections[s].read(f, error) : ARC_OK;
  if (status == ARC_OK) status = end_section(f, name, sections[s].name != NULL, error);
  return status;
}

static arc_status read_sections(msh_file *f, arc_error *error) {
  unsigned seen = 0;
  arc_status status = ARC_OK;
  while (status == ARC_OK && arc_msh_line(&f->text)) status = read_section(f, &seen, error);
  for (int s = 0; status == ARC_OK && sections[s].name; s++)
    if (!(seen >> s & 1) && !(f->version == 2 && sections[s].read == read_entities))
      status = arc_msh_fail(&f->text, error, "the file has no section $%s%s", sections[s].name,
                            sections[s].read == read_names ? ": it has no physical groups" : "");
  return status;
}

arc_status arc_msh_read(msh_file *f, arc_error *error) {
  const arc_status status = read_sections(f, error);
  if (status != ARC_OK) arc_msh_free(f);
  return status;
}

void arc_msh_free(msh_file *f) {
  arc_msh_close(&f->text);
  free(f->groups.data);
  free(f->members.data);
  free(f->nodes.data);
  free(f->elements.data);
  free(f->entities.data);
  *f = (msh_file){0};
}
