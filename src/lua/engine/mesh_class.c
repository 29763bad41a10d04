/* Class mesh (read-only): the finite element mesh of one body of a model or of a worn run. Numbers
 * of nodes and elements start at 1 in Lua and at 0 in the engine. */
#include "archard/export.h"
#include "lua/base/array.h"
#include "lua/engine/classes.h"
#include "lua/base/error.h"
#include "lua/base/names.h"
#include "lua/base/file_name.h"
#include "lua/base/strict.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct mesh_view {
  arc_model *model; /* model of the mesh; the view owns one reference */
  arc_mesh mesh;    /* shallow copy of the model's mesh; its nodes are `xy` if the mesh is worn */
  double *xy;       /* [mm] positions of the worn nodes; NULL: the model's nodes are used */
} mesh_view;

const arc_mesh *mesh_of(lua_State *L, int index, const char *where) {
  return &((mesh_view *)box_check(L, index, &mesh_class, where)->thing)->mesh;
}

static const mesh_view *view_self(lua_State *L) {
  return box_self(L, &mesh_class, "mesh")->thing;
}

static const arc_mesh *self(lua_State *L) {
  return &view_self(L)->mesh;
}

static const char *called(const mesh_view *view) {
  return body_name(arc_model_definition(view->model), view->mesh.body);
}

NUMBER_FIELD(mesh, radius, self(L)->radius)

static int push_count(lua_State *L, int count) {
  lua_pushinteger(L, count);
  return 1;
}

static int mesh_nodes(lua_State *L) {
  return push_count(L, self(L)->nodes);
}

static int mesh_quads(lua_State *L) {
  return push_count(L, self(L)->quads);
}

static int mesh_triangles(lua_State *L) {
  return push_count(L, self(L)->triangles);
}

static int mesh_elements_count(lua_State *L) {
  return push_count(L, self(L)->elements);
}

static int mesh_rows(lua_State *L) {
  return push_count(L, self(L)->rows);
}

static int mesh_element(lua_State *L) {
  lua_pushstring(L, arc_mesh_element(self(L), 4));
  return 1;
}

static int mesh_body(lua_State *L) {
  lua_pushstring(L, called(view_self(L)));
  return 1;
}

/* Pushes a list of node numbers. The numbers are increased by 1, because they start at 0 in C and
 * at 1 in Lua; -1 (no node) becomes 0. */
static int push_numbers(lua_State *L, const int *numbers, int count) {
  lua_createtable(L, count, 0);
  for (int i = 0; i < count; i++) {
    lua_pushinteger(L, (lua_Integer)numbers[i] + 1);
    lua_rawseti(L, -2, (lua_Integer)i + 1);
  }
  strict_table(L, "list of numbers");
  return 1;
}

void mesh_push_elements(lua_State *L, const arc_mesh *mesh) {
  push_numbers(L, mesh->element, 4 * mesh->elements);
}

/* mesh:elements() returns a flat list with four node numbers for each element. The fourth number of
 * a triangle is 0. */
static int mesh_elements(lua_State *L) {
  mesh_push_elements(L, self(L));
  return 1;
}

/* mesh:surface() returns the numbers of the nodes that may be in contact, sorted by increasing
 * x. */
static int mesh_surface(lua_State *L) {
  const arc_mesh *mesh = self(L);
  return push_numbers(L, mesh->surface_node, mesh->surface);
}

/* mesh:box() returns the numbers of the nodes of the wear box: for each surface node, this node and
 * one node for each row of elements, from the surface inwards. */
static int mesh_box(lua_State *L) {
  const arc_mesh *mesh = self(L);
  return push_numbers(L, mesh->box_node, mesh->surface * (mesh->rows + 1));
}

/* mesh:outline() returns the numbers of the boundary nodes, counter-clockwise. */
static int mesh_outline(lua_State *L) {
  const arc_mesh *mesh = self(L);
  return push_numbers(L, mesh->outline_node, mesh->outline);
}

/* mesh:fixed() returns the numbers of the nodes that are clamped or tied to the rigid base. */
static int mesh_fixed(lua_State *L) {
  const arc_mesh *mesh = self(L);
  return push_numbers(L, mesh->fixed_node, mesh->fixed);
}

/* mesh:node(i) returns x and y of node i [mm]. */
static int mesh_node(lua_State *L) {
  const arc_mesh *mesh = self(L);
  int valid;
  lua_settop(L, 2);
  lua_Integer number = lua_tointegerx(L, 2, &valid);
  if (!valid || number < 1 || number > mesh->nodes)
    error_raise(L, ARC_ARGUMENT, "mesh:node", "expected a node number from 1 to %d, got %s",
                mesh->nodes, names_push_shown(L, 2));
  lua_pushnumber(L, mesh->xy[2 * (number - 1)]);
  lua_pushnumber(L, mesh->xy[2 * (number - 1) + 1]);
  return 2;
}

/* Pushes a list of the coordinates of all nodes along `axis` (0: x, 1: y). */
static void push_axis(lua_State *L, const arc_mesh *mesh, int axis) {
  lua_createtable(L, mesh->nodes, 0);
  for (int i = 0; i < mesh->nodes; i++) {
    lua_pushnumber(L, mesh->xy[2 * i + axis]);
    lua_rawseti(L, -2, (lua_Integer)i + 1);
  }
  strict_table(L, "list of numbers");
}

/* mesh:coordinates() returns { x=, y= } of all nodes [mm]. */
static int mesh_coordinates(lua_State *L) {
  const arc_mesh *mesh = self(L);
  lua_createtable(L, 0, 2);
  push_axis(L, mesh, 0);
  lua_setfield(L, -2, "x");
  push_axis(L, mesh, 1);
  lua_setfield(L, -2, "y");
  strict_table(L, "mesh:coordinates");
  return 1;
}

static void push_quality(lua_State *L, arc_quality quality) {
  lua_createtable(L, 0, 6);
  array_set_number(L, "smallest_angle", quality.smallest_angle);
  array_set_number(L, "largest_angle", quality.largest_angle);
  array_set_number(L, "aspect", quality.aspect);
  array_set_number(L, "jacobian_ratio", quality.jacobian_ratio);
  array_set_number(L, "smallest_jacobian", quality.smallest_jacobian);
  strict_table(L, "mesh:quality");
}

/* mesh:quality() returns the worst value over all elements for each measure of element shape. The
 * field `box` of the result contains the worst values over the elements of the wear box. */
static int mesh_quality(lua_State *L) {
  push_quality(L, arc_mesh_quality(self(L), NULL));
  push_quality(L, arc_mesh_box_quality(self(L), NULL));
  lua_setfield(L, -2, "box");
  return 1;
}

/* Writes a CSV file with the columns node, x and y. */
static arc_status write_csv(lua_State *L, const char *path, const arc_mesh *mesh,
                            arc_error *error) {
  static const char *const names[] = {"node", "x", "y"}, *const units[] = {"", "mm", "mm"};
  size_t rows = (size_t)mesh->nodes;
  double *columns = array_buffer(L, 3 * rows);
  for (size_t i = 0; i < rows; i++) {
    columns[i] = (double)i + 1;
    columns[rows + i] = mesh->xy[2 * i];
    columns[2 * rows + i] = mesh->xy[2 * i + 1];
  }
  const double *data[] = {columns, columns + rows, columns + 2 * rows};
  return arc_export_csv(path, 3, names, units, data, rows, error);
}

static arc_status write_msh(const char *path, const arc_mesh *mesh, arc_error *error) {
  const arc_mesh *bodies[ARC_BODIES] = {0};
  bodies[mesh->body] = mesh;
  return arc_export_msh(path, bodies, error);
}

/* mesh:write(path) writes the mesh to a file. The extension of the file name selects the format. */
static int mesh_write(lua_State *L) {
  static const char where[] = "mesh:write";
  const arc_mesh *mesh = self(L);
  lua_settop(L, 2);
  const char *path = path_argument(L, 2, where, "path");
  const char *ending = strrchr(path, '.');
  arc_error error = {0};
  arc_status status = ARC_OK;
  if (ending && strcmp(ending, ".vtk") == 0)
    status = arc_export_vtk(path, mesh, NULL, &error);
  else if (ending && strcmp(ending, ".vtu") == 0)
    status = arc_export_vtu(path, mesh, NULL, 0, &error);
  else if (ending && strcmp(ending, ".inp") == 0)
    status = arc_export_mesh_inp(path, mesh, &error);
  else if (ending && strcmp(ending, ".msh") == 0)
    status = write_msh(path, mesh, &error);
  else if (ending && strcmp(ending, ".csv") == 0)
    status = write_csv(L, path, mesh, &error);
  else
    args_refuse(L, (args_location){where, ""}, "path",
                "a file name that ends in .vtk, .vtu, .inp, .msh or .csv");
  error_check(L, status, &error, where, -1);
  return 0;
}

static int mesh_tostring(lua_State *L) {
  const mesh_view *view = view_self(L);
  const arc_mesh *mesh = &view->mesh;
  arc_quality quality = arc_mesh_quality(mesh, NULL);
  const arc_quality inner = arc_mesh_box_quality(mesh, NULL);
  char text[440];
  snprintf(text, sizeof text,
           "%smesh of the %s: %d nodes, %d quads, %d triangles, %d at the contact\n"
           "  size     %.6g x %.6g mm at the contact, up to %.6g mm elsewhere\n"
           "  quality  angles %.3g to %.4g degrees, aspect to %.3g, Jacobian ratio from %.3g\n"
           "  wear box angles %.3g to %.4g degrees, aspect to %.3g, Jacobian ratio from %.3g",
           view->xy ? "worn " : "", called(view), mesh->nodes, mesh->quads, mesh->triangles,
           mesh->surface, mesh->def.size, mesh->def.height, mesh->def.far, quality.smallest_angle,
           quality.largest_angle, quality.aspect, quality.jacobian_ratio, inner.smallest_angle,
           inner.largest_angle, inner.aspect, inner.jacobian_ratio);
  lua_pushstring(L, text);
  return 1;
}

static const luaL_Reg fields[] = {
    {"nodes", mesh_nodes},
    {"quads", mesh_quads},
    {"triangles", mesh_triangles},
    {"elements_count", mesh_elements_count},
    {"rows", mesh_rows},
    {"body", mesh_body},
    {"radius", mesh_radius},
    {"element", mesh_element},
    {NULL, NULL},
};

static const luaL_Reg methods[] = {
    {"elements", mesh_elements},
    {"node", mesh_node},
    {"coordinates", mesh_coordinates},
    {"surface", mesh_surface},
    {"box", mesh_box},
    {"outline", mesh_outline},
    {"fixed", mesh_fixed},
    {"quality", mesh_quality},
    {"write", mesh_write},
    {NULL, NULL},
};

static void destroy_view(void *thing) {
  mesh_view *view = thing;
  arc_model_release(&view->model);
  free(view->xy);
}

const box_class mesh_class = {
    .name = "mesh",
    .methods = methods,
    .fields = fields,
    .tostring = mesh_tostring,
    .destroy = destroy_view,
    .value = sizeof(mesh_view),
};

/* Pushes the mesh object of a body. If `shape` is not NULL, the mesh has the worn nodes of the
 * shape. */
static void push_view(lua_State *L, arc_model *model, arc_body body, const arc_shape *shape) {
  if (!arc_model_mesh(model, body))
    error_raise(L, ARC_ARGUMENT, "mesh", "a pair of kind \"%s\" has no meshes",
                arc_model_kind_name(model));
  mesh_view *view = box_push(L, &mesh_class)->thing;
  view->model = arc_model_retain(model);
  view->mesh = *arc_model_mesh(model, body);
  if (!shape) return;
  const size_t bytes = 2 * (size_t)view->mesh.nodes * sizeof *view->xy;
  view->mesh.xy = view->xy = malloc(bytes);
  if (!view->xy) error_raise(L, ARC_MEMORY, "mesh", "out of memory for the nodes of a worn mesh");
  arc_shape_nodes(shape, body, view->xy);
  box_weigh(L, bytes);
}

void mesh_push(lua_State *L, int index, arc_body body) {
  index = lua_absindex(L, index);
  push_view(L, box_check(L, index, &model_class, "mesh")->thing, body, NULL);
  box_keep(L, index);
}

void mesh_push_worn(lua_State *L, const arc_shape *shape) {
  const arc_model_def *def = arc_model_definition(arc_shape_model(shape));
  lua_createtable(L, 0, ARC_BODIES);
  for (int body = 0; body < ARC_BODIES; body++) {
    push_view(L, arc_shape_model(shape), (arc_body)body, shape);
    set_by_body(L, def, (arc_body)body);
  }
  by_body_named(L, def, "wear.mesh");
}
