/* Assigns the physical groups of a Gmsh file to the sets of both bodies. */
#include "core/mesh/gmsh_groups.h"
#include "core/mesh/body_name.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const roles[] = {"upper", "lower"};
static const char *const set_names[] = {"", ".contact", ".fixed"};
static const char *const dimension_names[] = {"points", "curves", "surfaces", "volumes"};

const char *arc_msh_role(arc_body body) {
  return roles[body];
}

/* Returns the part of a group's name that follows the role of the body, "upper" or "lower".
 * Returns NULL if the group does not belong to this body. */
static const char *behind_role(const msh_group *g, int body) {
  const size_t n = strlen(roles[body]);
  if (strncmp(g->name, roles[body], n) != 0) return NULL;
  return g->name[n] == 0 || g->name[n] == '.' ? g->name + n : NULL;
}

static msh_set set_of(const char *behind) {
  int set = MSH_FIXED;
  while (set > MSH_BODY && strcmp(behind, set_names[set]) != 0) set--;
  return (msh_set)set;
}

/* Returns the index of a material of the body. A new material is added to the list. Returns -1
 * if the list is full. */
static int enter_material(msh_file *f, int body, const char *name) {
  int m = 0;
  while (m < f->materials[body] && strcmp(f->material[body][m], name) != 0) m++;
  if (m == ARC_MESH_MATERIALS) return -1;
  if (m == f->materials[body]) {
    snprintf(f->material[body][m], sizeof f->material[body][m], "%s", name);
    f->materials[body]++;
  }
  return m;
}

/* Stores in an entity the body, set or material that a physical group assigns to it. */
static arc_status note_group(msh_file *f, const msh_group *g, msh_entity *entity,
                             arc_error *error) {
  for (int body = 0; body < ARC_BODIES; body++) {
    const char *behind = behind_role(g, body);
    if (!behind) continue;
    const msh_set set = set_of(behind);
    const int dim = set == MSH_BODY ? 2 : 1;
    if (g->dim != dim)
      return arc_fail(error, ARC_GEOMETRY, "%s: expected %s in the group '%s', got %s",
                      f->text.path, dimension_names[dim], g->name, dimension_names[g->dim]);
    entity->sets |= arc_msh_bit((arc_body)body, set);
    if (set != MSH_BODY || !*behind) continue;
    if (!arc_body_is_word(behind + 1) || strlen(behind + 1) >= ARC_TEXT_SIZE)
      return arc_fail(error, ARC_GEOMETRY,
                      "%s: expected a material after '%s.', " ARC_BODY_NAME ", got '%s'",
                      f->text.path, roles[body], behind + 1);
    const int material = enter_material(f, body, behind + 1);
    if (material < 0)
      return arc_fail(error, ARC_GEOMETRY, "%s: expected at most %d materials of '%s', got more",
                      f->text.path, ARC_MESH_MATERIALS, roles[body]);
    if (entity->material[body] >= 0 && entity->material[body] != material)
      return arc_fail(error, ARC_GEOMETRY, "%s: surface %lld has two materials, '%s' and '%s'",
                      f->text.path, entity->tag, f->material[body][entity->material[body]],
                      behind + 1);
    entity->material[body] = material;
  }
  return ARC_OK;
}

/* --- looking up ------------------------------------------------------------------------------- */

static int compare_numbers(int dim_a, long long a, int dim_b, long long b) {
  if (dim_a != dim_b) return dim_a < dim_b ? -1 : 1;
  return (a > b) - (a < b);
}

static int compare_groups(const void *a, const void *b) {
  const msh_group *p = a, *q = b;
  return compare_numbers(p->dim, p->tag, q->dim, q->tag);
}

static int compare_members(const void *a, const void *b) {
  const msh_member *p = a, *q = b;
  return compare_numbers(p->dim, p->tag, q->dim, q->tag);
}

static int compare_entities(const void *a, const void *b) {
  const msh_entity *p = a, *q = b;
  return compare_numbers(p->dim, p->tag, q->dim, q->tag);
}

static const msh_group *find_group(const msh_file *f, int dim, long long tag) {
  const msh_group wanted = {.dim = dim, .tag = tag};
  if (f->groups.count == 0) return NULL;
  return bsearch(&wanted, f->groups.data, (size_t)f->groups.count, sizeof wanted, compare_groups);
}

const msh_entity *arc_msh_entity_of(const msh_file *f, const msh_element *element) {
  const msh_entity wanted = {.dim = element->dim, .tag = element->entity};
  if (f->entities.count == 0) return NULL;
  return bsearch(&wanted, f->entities.data, (size_t)f->entities.count, sizeof wanted,
                 compare_entities);
}

/* --- entities --------------------------------------------------------------------------------- */

/* Converts each physical group to an entity with the same number, because elements of version
 * 2.2 refer directly to groups. */
static arc_status groups_as_members(msh_file *f) {
  const msh_group *g = f->groups.data;
  for (int i = 0; i < f->groups.count; i++) {
    msh_member *member = arc_list_add(&f->members, sizeof *member);
    if (!member) return ARC_MEMORY;
    *member = (msh_member){.tag = g[i].tag, .group = g[i].tag, .dim = g[i].dim};
  }
  return ARC_OK;
}

/* Creates the entities. Consecutive members with the same number and dimension become one
 * entity. */
static arc_status collect_entities(msh_file *f, arc_error *error) {
  const msh_member *m = f->members.data;
  msh_entity *entity = NULL;
  for (int i = 0; i < f->members.count; i++) {
    if (i == 0 || compare_members(&m[i - 1], &m[i]) != 0) {
      entity = arc_list_add(&f->entities, sizeof *entity);
      if (!entity) return arc_fail(error, ARC_MEMORY, "out of memory for reading %s", f->text.path);
      *entity = (msh_entity){.tag = m[i].tag, .dim = m[i].dim, .material = {-1, -1}};
    }
    const msh_group *g = find_group(f, m[i].dim, m[i].group);
    const arc_status status = g ? note_group(f, g, entity, error) : ARC_OK;
    if (status != ARC_OK) return status;
  }
  return ARC_OK;
}

/* --- missing groups --------------------------------------------------------------------------- */

/* Writes the names of as many groups as fit into `size` bytes to `text`, for a message. Returns
 * `text`. */
static const char *list_groups(const msh_file *f, char *text, size_t size) {
  const msh_group *g = f->groups.data;
  size_t n = 0;
  snprintf(text, size, "none");
  for (int i = 0; i < f->groups.count && n + 1 < size; i++) {
    const int more = snprintf(text + n, size - n, "%s'%s' (%s)", i > 0 ? ", " : "", g[i].name,
                              dimension_names[g[i].dim]);
    n += more > 0 ? (size_t)more : 0;
  }
  return text;
}

static arc_status check_complete(const msh_file *f, arc_error *error) {
  unsigned found = 0;
  char list[300];
  const msh_entity *e = f->entities.data;
  for (int i = 0; i < f->entities.count; i++) found |= e[i].sets;
  for (int body = 0; body < ARC_BODIES; body++)
    for (int set = 0; set < MSH_SETS; set++)
      if (!(found & arc_msh_bit((arc_body)body, (msh_set)set)))
        return arc_fail(error, ARC_GEOMETRY, "%s: no physical group '%s%s' of %s; found: %s",
                        f->text.path, roles[body], set_names[set],
                        dimension_names[set == MSH_BODY ? 2 : 1],
                        list_groups(f, list, sizeof list));
  return ARC_OK;
}

arc_status arc_msh_sort_groups(msh_file *f, arc_error *error) {
  arc_list_sort(&f->groups, sizeof(msh_group), compare_groups);
  if (f->version == 2 && groups_as_members(f) != ARC_OK)
    return arc_fail(error, ARC_MEMORY, "out of memory for reading %s", f->text.path);
  arc_list_sort(&f->members, sizeof(msh_member), compare_members);
  const arc_status status = collect_entities(f, error);
  return status == ARC_OK ? check_complete(f, error) : status;
}
