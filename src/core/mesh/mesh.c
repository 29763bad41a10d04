/* Mesher of a body. It builds a quadtree from the element sizes, converts the leaves to
 * elements, and mirrors the half body to the whole body. */
#include "core/mesh/mesh.h"
#include "core/mesh/body_shape.h"
#include "core/mesh/outline.h"
#include "core/mesh/tile.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Largest number of elements of a body. Definitions that need more are rejected. */
enum { most_elements = 1000000 };

const char *const arc_element_names[] = {ARC_ELEMENT_LIST(ARC_CHOICE_NAME) NULL};
const char *const arc_space_names[] = {ARC_SPACE_LIST(ARC_CHOICE_NAME) NULL};
_Static_assert(0 ARC_SPACE_LIST(ARC_CHOICE_ONE) == 5,
               "a new geometry: implement it here, in elastic/{element,chart,pair}.c and in "
               "plane/{field,recovery,revolved}.c");

const char *arc_mesh_element(const arc_mesh *mesh, int corners) {
  static const char *const names[][3] = {
      {"CPE3", "CPE4", "CPE4I"}, {"CPS3", "CPS4", "CPS4I"}, {"CAX3", "CAX4", "CAX4I"}};
  if (corners == 3) return names[mesh->space][0];
  return names[mesh->space][mesh->def.element == ARC_CPE4I ? 2 : 1];
}
_Static_assert(
    0 ARC_ELEMENT_LIST(ARC_CHOICE_ONE) == 3,
    "a new element: implement it in elastic/element.c, body.c, model.c and export/inp.c");

static const arc_setting zone_settings[] = {
    {.name = "cylinder",
     .unit = "mm",
     .kind = ARC_NUMBER,
     .forms = ARC_AUTOMATIC,
     ARC_RANGE_ABOVE(0),
     .text = "Full width of the contact zone of the cylinder."},
    {.name = "plate",
     .unit = "mm",
     .kind = ARC_NUMBER,
     .forms = ARC_AUTOMATIC,
     ARC_RANGE_ABOVE(0),
     .offset = sizeof(double),
     .text = "Full width of the contact zone of the plate, which must include the contact at both "
             "ends of the stroke."},
    {.name = NULL},
};

#define ARC_SETTING_OF arc_mesh_def
const arc_setting arc_mesh_settings[] = {
    ARC_MESH_SETTINGS(ARC_SETTING_NUMBER, ARC_SETTING_WHOLE, ARC_SETTING_CHOICE){
        .name = "zone",
        .unit = "mm",
        .kind = ARC_GROUP,
        .offset = offsetof(arc_mesh_def, zone),
        .group = zone_settings,
        .type = "a table { cylinder=, plate= }",
        .text =
            "Full width of the contact zone of each body, the part of the surface with small "
            "elements. The bodies cannot touch outside this zone. The depth of the fine mesh is "
            "proportional to the width of the cylinder's zone. \"auto\": as wide as the contact "
            "and the stroke require."},
    {.name = NULL},
};
#undef ARC_SETTING_OF

arc_mesh_def arc_mesh_default(void) {
  arc_mesh_def def = {0};
  arc_settings_default(arc_mesh_settings, &def);
  def.size = 0.020;
  def.height = 0.025;
  def.far = 1.0;
  def.zone[ARC_CYLINDER] = 1.0;
  def.zone[ARC_PLATE] = 1.2;
  return def;
}

/* Half widths and depths [mm] of the two nested partitions with fine elements. In an example
 * with zones of 1 mm (cylinder) and 1.2 mm (plate), the partitions of the cylinder are 1 mm wide
 * and 0.5 mm deep, and 4 mm wide and 1 mm deep. The partitions of the plate are 1.2 mm wide and
 * 0.5 mm deep, and 4.2 mm wide and 1.5 mm deep. All sizes are proportional to the zone of the
 * cylinder, except that the widths of the plate's partitions grow with the plate's zone. */
typedef struct partitions {
  double inner_s, inner_d, outer_s, outer_d;
} partitions;

/* Returns the number of rows of the wear box. Each layer has its own row. If the layers are so thin
 * that the defined number of rows would end within them, the number is increased. */
static int rows_of_box(const arc_mesh_def *def, const arc_body_def *solid) {
  int rows = def->rows;
  while (rows <= arc_body_layers(solid) &&
         arc_body_interface(solid, rows - 1) < rows * def->height / 2)
    rows++;
  return rows;
}

static partitions partitions_of(const arc_mesh_def *def, arc_body body, const arc_body_def *solid) {
  const double measure = arc_body_measure(solid), z = def->zone[body], c = def->zone[ARC_CYLINDER];
  partitions p = body == ARC_CYLINDER ? (partitions){z / 2, 0.5 * c, 2 * c, c}
                                      : (partitions){z / 2, 0.5 * c, z / 2 + 1.5 * c, 1.5 * c};
  p.inner_d = fmax(p.inner_d, (rows_of_box(def, solid) + 1) * def->height);
  p.outer_s = fmin(p.outer_s, arc_body_limits(solid).outer);
  p.outer_d = fmin(fmax(p.outer_d, p.inner_d), 0.5 * measure);
  return p;
}

typedef struct size_rule {
  partitions part;
  const body_map *map;
  double far;
} size_rule;

/* Returns true if an interface between layers crosses a cell. */
static int straddles(const body_map *m, const quad_cell *c) {
  for (int l = 0; l < m->layers; l++)
    if (c->j < m->line[l] && m->line[l] < c->j + (1 << c->level)) return 1;
  return 0;
}

/* Returns the coarsest quadtree level allowed for a cell. It is 0 in the inner partition, at
 * most 2 (four times the finest size) in the outer partition, and limited by the size `far`
 * elsewhere. A cell that is crossed by an interface between layers must be split. */
static int coarsest_level(const void *context, const quad_cell *c) {
  const size_rule *rule = context;
  const body_map *m = rule->map;
  const double s = c->i * m->size * (1 + 1e-12) + 1e-12, d = c->j * m->height + 1e-12;
  if (s < rule->part.inner_s && d < rule->part.inner_d) return 0;
  if (straddles(m, c)) return c->level - 1;
  const double wide = arc_body_map_unit(m, c->j), tall = wide * m->height / m->size;
  int level = (int)floor(log2(rule->far / fmax(wide, tall)) + 1e-9);
  if (s < rule->part.outer_s && d < rule->part.outer_d && level > 2) level = 2;
  return level > 0 ? level : 0;
}

static arc_status check_zone(const arc_mesh_def *def, arc_body body, const arc_body_def *solid,
                             arc_error *error) {
  const double z = def->zone[body], narrowest = 4 * def->size;
  const body_limits limits = arc_body_limits(solid);
  if (z >= narrowest * (1 - 1e-9) && z <= limits.zone * (1 + 1e-12)) return ARC_OK;
  return arc_fail(error, ARC_ZONE,
                  "field 'mesh.zone.%s': expected a number from 4 size = %g to %s = %g mm, got %g",
                  arc_body_name(body), narrowest, limits.zone_text, limits.zone, z);
}

static arc_status check_positive(const char *field, double value, double limit, const char *what,
                                 arc_error *error) {
  if (value > 0 && value <= limit) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field '%s': expected a number > 0 and at most %s = %g mm, got %g", field, what,
                  limit, value);
}

double arc_mesh_nodes(const arc_mesh_def *def, arc_body body, const arc_body_def *solid) {
  const partitions p = partitions_of(def, body, solid);
  const double area = 2 * arc_body_half_length(solid) * arc_body_depth(solid);
  const double whole = arc_body_is_round(solid) ? area / 1.5 : area;
  const double outer_element = 16 * def->size * def->height;
  return 2 * p.inner_s * p.inner_d / (def->size * def->height) +
         2 * p.outer_s * p.outer_d / fmin(outer_element, def->far * def->far) +
         whole / (def->far * def->far);
}

/* Largest width and depth of a body in element sizes. A limit is necessary because logical
 * positions are integers in these units. */
static const double most_sizes = 5e8;

arc_status arc_mesh_check(const arc_mesh_def *def, arc_body body, const arc_body_def *solid,
                          arc_error *error) {
  const double radius = arc_body_measure(solid);
  arc_status status;
  if ((status = check_positive("mesh.size", def->size, radius / 10, "radius / 10", error)) ||
      (status = check_positive("mesh.height", def->height, radius / 10, "radius / 10", error)) ||
      (status = check_positive("mesh.far", def->far, radius, "radius", error)))
    return status;
  if (radius > most_sizes * def->size)
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'mesh.size': expected at least radius / %g = %g mm, got %g mm",
                    most_sizes, radius / most_sizes, def->size);
  const double aspect = def->height / def->size;
  if (!(aspect > 0.05 && aspect < 20))
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'mesh.height': expected between size / 20 and 20 size, got %g mm at a size of %g mm",
        def->height, def->size);
  if (def->far < fmax(def->size, def->height))
    return arc_fail(error, ARC_ARGUMENT,
                    "field 'mesh.far': expected at least the element size %g mm, got %g mm",
                    fmax(def->size, def->height), def->far);
  const double most_rows =
      floor(radius / 4 / def->height * (1 + 1e-9)); /* tolerance for heights at the limit */
  if (def->rows < 1 || def->rows > most_rows)
    return arc_fail(
        error, ARC_ARGUMENT,
        "field 'mesh.rows': expected from 1 to radius / 4 / height = %g, got %d; rows of %g mm are "
        "too high for bodies of radius %g mm: use fewer rows or a smaller mesh.height",
        most_rows, def->rows, def->height, radius);
  if ((status = check_zone(def, body, solid, error))) return status;
  const double estimate = arc_mesh_nodes(def, body, solid);
  if (estimate > most_elements)
    return arc_fail(error, ARC_ARGUMENT,
                    "mesh.size: %g mm needs about %.0f elements, at most %d are allowed", def->size,
                    estimate, most_elements);
  return ARC_OK;
}

/* --- from logical elements of the half body to the whole mesh --------------------------------- */

static int compare_keys(const void *a, const void *b) {
  const mesh_key *p = a, *q = b;
  if (p->j != q->j) return p->j < q->j ? -1 : 1;
  return (p->i > q->i) - (p->i < q->i);
}

/* Returns the mirror image (-i, j) of the logical point (i, j). The two ends of a closed surface,
 * such as a full circle, are the same point, which is its own mirror image. */
static mesh_key mirrored(const body_map *m, mesh_key key) {
  const int seam = arc_body_map_closed(m) && key.i == 2 * (m->columns << m->root_level);
  return (mesh_key){seam ? key.i : -key.i, key.j};
}

/* Writes the distinct keys of both halves to *keys in sorted order. Returns their number, or -1
 * if memory is exhausted. */
static int collect_keys(const mesh_builder *b, mesh_key **keys) {
  const int corners = 4 * b->count;
  mesh_key *all = malloc(2 * (size_t)corners * sizeof *all);
  if (!all) return -1;
  for (int c = 0; c < corners; c++) {
    all[2 * c] = b->corner[c];
    all[2 * c + 1] = mirrored(&b->map, b->corner[c]);
  }
  qsort(all, 2 * (size_t)corners, sizeof *all, compare_keys);
  int n = 0;
  for (int c = 0; c < 2 * corners; c++)
    if (n == 0 || compare_keys(&all[n - 1], &all[c]) != 0) all[n++] = all[c];
  *keys = all;
  return n;
}

static int find_key(const mesh_key *keys, int n, mesh_key wanted) {
  const mesh_key *at = bsearch(&wanted, keys, (size_t)n, sizeof *keys, compare_keys);
  return at ? (int)(at - keys) : -1;
}

static double twice_area(const double *xy, const int *e) {
  double area = 0;
  const int corners = e[3] < 0 ? 3 : 4;
  for (int c = 0; c < corners; c++) {
    const double *p = &xy[2 * e[c]], *q = &xy[2 * e[(c + 1) % corners]];
    area += p[0] * q[1] - q[0] * p[1];
  }
  return area;
}

/* Returns the layer at the side of a cell that is nearest to the surface. No interface crosses
 * the cell. */
static int layer_of(const body_map *map, const mesh_key *corner) {
  int top = corner[0].j, layer = 0;
  for (int c = 1; c < 4; c++) top = corner[c].j < top ? corner[c].j : top;
  while (layer < map->layers && top >= 2 * map->line[layer]) layer++;
  return layer;
}

/* Writes element number `at` with its corners counter-clockwise. `mirror` is -1 for the mirrored
 * half, otherwise 1. */
static void place_element(arc_mesh *mesh, const body_map *map, const mesh_key *keys,
                          const mesh_key *corner, int mirror, int at) {
  int *e = &mesh->element[4 * at];
  mesh->layer[at] = layer_of(map, corner);
  for (int c = 0; c < 4; c++)
    e[c] = find_key(keys, mesh->nodes, mirror < 0 ? mirrored(map, corner[c]) : corner[c]);
  if (e[3] == e[2]) e[3] = -1;
  if (twice_area(mesh->xy, e) < 0) {
    const int last = e[3] < 0 ? 2 : 3, swap = e[1];
    e[1] = e[last];
    e[last] = swap;
  }
}

static void place_nodes(arc_mesh *mesh, const body_map *map, const mesh_key *keys) {
  const int core = 2 * (map->lines << map->root_level) + 2;
  for (int n = 0; n < mesh->nodes; n++) {
    double *xy = &mesh->xy[2 * n];
    if (map->core && keys[n].j == core) {
      xy[0] = 0, xy[1] = map->up * map->radius;
      continue;
    }
    arc_body_map_point(map, keys[n].i / 2.0, keys[n].j / 2.0, xy);
  }
}

/* Writes all elements to the mesh. The elements of the wear box are first, column by column from
 * left to right. */
static void place_elements(arc_mesh *mesh, const mesh_builder *b, const mesh_key *keys, int half) {
  const int box = half * mesh->rows;
  int at = 0;
  for (int column = half - 1; column >= 0; column--)
    for (int row = 0; row < mesh->rows; row++)
      place_element(mesh, &b->map, keys, &b->corner[4 * (column * mesh->rows + row)], -1, at++);
  for (int e = 0; e < box; e++) place_element(mesh, &b->map, keys, &b->corner[4 * e], 1, at++);
  for (int e = box; e < b->count; e++) {
    place_element(mesh, &b->map, keys, &b->corner[4 * e], 1, at++);
    place_element(mesh, &b->map, keys, &b->corner[4 * e], -1, at++);
  }
  mesh->box_elements = 2 * box;
  for (int e = 0; e < mesh->elements; e++) mesh->triangles += arc_mesh_corners(mesh, e) == 3;
  mesh->quads = mesh->elements - mesh->triangles;
}

/* Returns true if a node is fixed. Fixed nodes are on the flat side of a half cylinder, at the
 * hub of a disc, and at the base or rim of other bodies. */
static int is_tied(const body_map *map, mesh_key key) {
  const int side = 2 * (map->columns << map->root_level);
  const int deep = 2 * (map->lines << map->root_level);
  if (map->core && !arc_body_map_closed(map)) return abs(key.i) == side || key.j == deep + 2;
  return key.j >= deep;
}

static void place_sets(arc_mesh *mesh, const body_map *map, const mesh_key *keys, int half) {
  for (int c = 0; c < mesh->surface; c++)
    for (int row = 0; row <= mesh->rows; row++)
      mesh->box_node[c * (mesh->rows + 1) + row] =
          find_key(keys, mesh->nodes, (mesh_key){2 * (c - half), 2 * row});
  for (int c = 0; c < mesh->surface; c++)
    mesh->surface_node[c] = mesh->box_node[c * (mesh->rows + 1)];
  for (int n = 0; n < mesh->nodes; n++)
    if (is_tied(map, keys[n])) mesh->fixed_node[mesh->fixed++] = n;
}

static arc_status fill(arc_mesh *mesh, const mesh_builder *b, int half) {
  mesh_key *keys = NULL;
  mesh->nodes = collect_keys(b, &keys);
  if (mesh->nodes < 0) return ARC_MEMORY;
  mesh->elements = 2 * b->count;
  mesh->surface = 2 * half + 1;
  mesh->xy = malloc(2 * (size_t)mesh->nodes * sizeof(double));
  mesh->element = malloc(4 * (size_t)mesh->elements * sizeof(int));
  mesh->surface_node = malloc((size_t)mesh->surface * sizeof(int));
  mesh->box_node = malloc((size_t)(mesh->surface * (mesh->rows + 1)) * sizeof(int));
  mesh->fixed_node = malloc((size_t)mesh->nodes * sizeof(int));
  mesh->layer = malloc((size_t)mesh->elements * sizeof(int));
  const int complete = mesh->xy && mesh->element && mesh->layer && mesh->surface_node &&
                       mesh->box_node && mesh->fixed_node;
  if (complete) {
    place_nodes(mesh, &b->map, keys);
    place_elements(mesh, b, keys, half);
    place_sets(mesh, &b->map, keys, half);
  }
  free(keys);
  return complete ? ARC_OK : ARC_MEMORY;
}

static arc_status tile_and_fill(arc_mesh *mesh, int half) {
  const partitions part = partitions_of(&mesh->def, mesh->body, &mesh->solid);
  mesh_builder b = {
      .map = arc_body_map_make(&mesh->def, mesh->body, &mesh->solid, part.outer_s, part.outer_d)};
  const size_rule rule = {part, &b.map, mesh->def.far};
  quadtree tree = {0};
  arc_status status = arc_quadtree_build(&tree, b.map.root_level, b.map.columns, b.map.lines,
                                         coarsest_level, &rule);
  if (status == ARC_OK) status = arc_mesh_tile(&b, &tree, half, mesh->rows);
  if (status == ARC_OK) status = fill(mesh, &b, half);
  arc_quadtree_free(&tree);
  free(b.corner);
  return status;
}

arc_status arc_mesh_build(const arc_mesh_def *def, arc_body body, double radius, arc_mesh **out,
                          arc_error *error) {
  *out = NULL;
  if (!(radius > 0) || !isfinite(radius))
    return arc_fail(error, ARC_ARGUMENT, "field 'radius': expected a number > 0 mm, got %g",
                    radius);
  const arc_body_def usual = arc_body_resolve(&(arc_body_def){0}, body, radius);
  return arc_mesh_build_solid(def, body, &usual, out, error);
}

arc_status arc_mesh_build_solid(const arc_mesh_def *def, arc_body body, const arc_body_def *solid,
                                arc_mesh **out, arc_error *error) {
  *out = NULL;
  arc_status status = arc_mesh_check(def, body, solid, error);
  if (status != ARC_OK) return status;
  arc_mesh *mesh = calloc(1, sizeof *mesh);
  if (!mesh)
    return arc_fail(error, ARC_MEMORY, "out of memory for the %s's mesh", arc_body_name(body));
  mesh->body = body;
  mesh->solid = *solid;
  mesh->radius = arc_body_measure(solid);
  mesh->def = *def;
  mesh->rows = rows_of_box(def, solid);
  const int half = (int)ceil(def->zone[body] / 2 / def->size - 1e-9);
  status = tile_and_fill(mesh, half);
  if (status == ARC_OK) status = arc_mesh_outline(mesh);
  if (status == ARC_MEMORY)
    arc_fail(error, status, "out of memory for the %s's mesh", arc_body_name(body));
  else if (status == ARC_OK && !(arc_mesh_quality(mesh, NULL).smallest_jacobian > 0))
    status = arc_fail(error, ARC_GEOMETRY,
                      "the %s's mesh has an inverted element (size %g, far %g, zone %g mm)",
                      arc_body_name(body), def->size, def->far, def->zone[body]);
  if (status != ARC_OK) arc_mesh_destroy(&mesh);
  *out = mesh;
  return status;
}

int arc_mesh_corners(const arc_mesh *mesh, int element) {
  return mesh->element[4 * element + 3] < 0 ? 3 : 4;
}

void arc_mesh_destroy(arc_mesh **mesh) {
  if (!mesh || !*mesh) return;
  free((*mesh)->xy);
  free((*mesh)->element);
  free((*mesh)->surface_node);
  free((*mesh)->box_node);
  free((*mesh)->fixed_node);
  free((*mesh)->layer);
  free((*mesh)->outline_node);
  free((*mesh)->material_name);
  free((*mesh)->material);
  free(*mesh);
  *mesh = NULL;
}
