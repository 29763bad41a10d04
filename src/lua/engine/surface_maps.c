/* Pushes arrays over x and z as maps and sections. */
#include "lua/engine/surface_maps.h"

#include "lua/engine/classes.h"
#include "lua/base/array.h"
#include "lua/base/error.h"
#include "lua/base/scripts.h"
#include "lua/base/strict.h"

#include <string.h>

void model_check_meshed(lua_State *L, const arc_model *model, const char *where) {
  if (arc_model_has_maps(arc_model_definition(model)))
    error_raise(L, ARC_ARGUMENT, where,
                "expected bodies with meshes, got half-spaces (geometry = \"3-D\"), without "
                "meshes; plot.map draws their maps, and export.vti writes them");
}

/* Coordinates of the grid points of a map: row i is at x[i * nz], column j at z[j]. */
typedef struct lattice {
  const double *x, *z;
  size_t nx, nz;
} lattice;

static lattice lattice_of(const arc_array *arrays, size_t count, arc_body body) {
  const arc_array *x = arc_array_find(arrays, count, body, "x"),
                  *z = arc_array_find(arrays, count, body, "z");
  lattice l = {x->values, z->values, 0, 0};
  const size_t n = x->size[0];
  while (l.nz < n && l.x[l.nz] == l.x[0]) l.nz++;
  l.nx = l.nz > 0 ? n / l.nz : 0;
  return l;
}

/* Sets a field of the table on top of the stack to the list of the x coordinates of a grid. */
static void set_x(lua_State *L, const char *field, const lattice *l) {
  lua_createtable(L, (int)l->nx, 0);
  for (size_t i = 0; i < l->nx; i++) {
    lua_pushnumber(L, l->x[i * l->nz]);
    lua_rawseti(L, -2, (lua_Integer)i + 1);
  }
  lua_setfield(L, -2, field);
}

static const char *title_of(const char *name) {
  static const char *const titles[][2] = {
      {"p", "pressure"},     {"h", "depth"},          {"y", "height"},       {"q", "shear along x"},
      {"s", "slip along x"}, {"qz", "shear along z"}, {"sz", "slip along z"}};
  for (size_t i = 0; i < sizeof titles / sizeof *titles; i++)
    if (strcmp(name, titles[i][0]) == 0) return titles[i][1];
  return name;
}

void surface_push_map(lua_State *L, const arc_array *arrays, size_t count, arc_body body,
                      const char *name, const char *unit) {
  const lattice l = lattice_of(arrays, count, body);
  const arc_array *values = arc_array_find(arrays, count, body, name);
  if (l.nx < 2 || l.nz < 2)
    error_raise(L, ARC_ARGUMENT, "map",
                "a groove (procedure = \"NSP\") does not vary along x: use a section, "
                "w:profile(body, { x = 0 })");
  script_require(L, "archard.map.made");
  lua_getfield(L, -1, "new");
  lua_remove(L, -2);
  lua_createtable(L, 0, 4);
  set_x(L, "x", &l);
  array_set(L, "z", l.z, l.nz);
  array_set(L, "y", values->values, l.nx * l.nz);
  lua_pushstring(L, unit);
  lua_setfield(L, -2, "unit");
  lua_pushstring(L, title_of(name));
  lua_setfield(L, -2, "name");
  lua_call(L, 1, 1);
}

/* Computes the index `first` of the grid point before the position `wanted`, and the interpolation
 * weight `share` of the next grid point. */
static void find(lua_State *L, const char *where, const char *axis, const double *at, size_t step,
                 size_t n, double wanted, size_t *first, double *share) {
  size_t i = 0;
  *first = 0;
  *share = 0;
  if (n == 1) return;
  if (!(wanted >= at[0] && wanted <= at[(n - 1) * step]))
    error_raise(L, ARC_ARGUMENT, where, "field '%s': expected a position from %f to %f mm, got %f",
                axis, at[0], at[(n - 1) * step], wanted);
  while (i + 2 < n && at[(i + 1) * step] <= wanted) i++;
  *first = i;
  *share = (wanted - at[i * step]) / (at[(i + 1) * step] - at[i * step]);
}

/* Pushes a list of the values of one array at the points of the section. */
static void push_line(lua_State *L, const double *values, const lattice *l, int at_x, size_t first,
                      double share) {
  const size_t n = at_x ? l->nz : l->nx, along = at_x ? 1 : l->nz, across = at_x ? l->nz : 1;
  lua_createtable(L, (int)n, 0);
  for (size_t i = 0; i < n; i++) {
    const double *v = &values[i * along + first * across];
    lua_pushnumber(L, share > 0 ? (1 - share) * v[0] + share * v[across] : v[0]);
    lua_rawseti(L, -2, (lua_Integer)i + 1);
  }
}

static const arc_setting places[] = {ARGS_OTHER("x"), ARGS_OTHER("z"), {.name = NULL}};

/* Reads the position of the section from the table at `index`. Returns true for a section at
 * constant x. */
static int read_place(lua_State *L, int index, const char *where, double *wanted) {
  *wanted = 0;
  if (lua_isnoneornil(L, index)) return 0;
  const args_location location = {where, ""};
  args_check_table(L, index, where);
  args_check_names(L, index, location, places);
  const int at_x = args_given(L, index, "x");
  if (at_x && args_given(L, index, "z"))
    error_raise(L, ARC_ARGUMENT, where, "fields 'x' and 'z': expected one of them, got both");
  if (args_get(L, index, at_x ? "x" : "z") != LUA_TNIL) {
    if (!lua_isnumber(L, -1)) args_refuse(L, location, at_x ? "x" : "z", "a number in mm");
    *wanted = lua_tonumber(L, -1);
  }
  lua_pop(L, 1);
  return at_x;
}

void surface_push_section(lua_State *L, int index, const char *where, const arc_array *arrays,
                          size_t count, arc_body body, const char *const *names) {
  const lattice l = lattice_of(arrays, count, body);
  double wanted, share;
  size_t first;
  const int at_x = read_place(L, index, where, &wanted);
  if (at_x)
    find(L, where, "x", l.x, l.nz, l.nx, wanted, &first, &share);
  else
    find(L, where, "z", l.z, 1, l.nz, wanted, &first, &share);
  lua_createtable(L, 0, 4);
  if (at_x)
    array_set(L, "x", l.z, l.nz), array_set(L, "z", l.z, l.nz);
  else
    set_x(L, "x", &l);
  for (const char *const *name = names; *name; name++) {
    push_line(L, arc_array_find(arrays, count, body, *name)->values, &l, at_x, first, share);
    lua_setfield(L, -2, *name);
  }
  strict_table(L, where);
}

/* --- lists of surfaces ------------------------------------------------------------------------ */

/* Pushes a new surface table with the body, update and distance of an array. */
static void begin_surface(lua_State *L, const arc_array *array) {
  lua_createtable(L, 0, 8);
  lua_pushstring(L, arc_body_name(array->body));
  lua_setfield(L, -2, "body");
  array_set_number(L, "update", array->update);
  array_set_number(L, "distance", array->distance);
}

void surface_push_list(lua_State *L, const arc_array *arrays, size_t count) {
  lua_newtable(L);
  for (size_t i = 0; i < count; i++) {
    const arc_array *array = &arrays[i], *before = i > 0 ? array - 1 : NULL;
    if (!before || array->body != before->body || array->update != before->update) {
      begin_surface(L, array);
      lua_rawseti(L, -2, (lua_Integer)lua_rawlen(L, -2) + 1);
    }
    lua_rawgeti(L, -1, (lua_Integer)lua_rawlen(L, -1));
    array_set(L, array->name, array->values, arc_array_count(array));
    lua_pop(L, 1);
  }
}
