/* Reads the field `worn` of 3-D models, which contains a function (x, z) -> depth or a map of
 * depths for each body. The depths are sampled at the initial cells of the run. */
#include "archard/space.h"
#include "lua/base/array_read.h"
#include "lua/base/error.h"
#include "lua/base/names.h"
#include "lua/engine/classes.h"

#include <stdio.h>

static const args_location *at_body(arc_body body, const char *where, char prefix[40],
                                    args_location *location) {
  snprintf(prefix, 40, "worn.%s.", body_names[body]);
  *location = (args_location){where, prefix};
  return location;
}

int worn_is_map(lua_State *L, int index) {
  static const char *const fields[] = {"x", "y", "z", NULL};
  int is = 1;
  index = lua_absindex(L, index);
  for (const char *const *name = fields; *name && is; name++) {
    lua_pushstring(L, *name);
    is = lua_rawget(L, index) == LUA_TTABLE;
    lua_pop(L, 1);
  }
  return is;
}

/* --- maps of depths --------------------------------------------------------------------------- */

/* Depths [mm] on a uniform grid. The depth at x[i] and z[j] is h[i * nz + j]. Outside the grid the
 * depth is 0. */
typedef struct depth_map {
  size_t nx, nz;
  const double *x, *z, *h;
} depth_map;

/* Reads the map at `index` and checks the lengths of its lists. The buffers stay on the stack. */
static depth_map push_depth_map(lua_State *L, int index, args_location location) {
  depth_map m;
  size_t count;
  index = lua_absindex(L, index);
  luaL_checkstack(L, 12, location.where);
  lua_getfield(L, index, "x");
  m.x = array_read(L, location, "x", &m.nx);
  lua_getfield(L, index, "z");
  m.z = array_read(L, location, "z", &m.nz);
  lua_getfield(L, index, "y");
  m.h = array_read(L, location, "y", &count);
  if (m.nx < 2 || m.nz < 2 || count != m.nx * m.nz)
    error_raise(L, ARC_ARGUMENT, location.where,
                "field '%sy': expected a map, as returned by map{}", location.prefix);
  return m;
}

/* Computes the index of the grid point before a position, and the interpolation weight of the next
 * grid point. Returns 0 outside the grid. */
static int locate(const double *at, size_t n, double wanted, size_t *before, double *share) {
  const double step = (at[n - 1] - at[0]) / (double)(n - 1), u = (wanted - at[0]) / step;
  if (!(u >= 0 && u <= (double)(n - 1))) return 0;
  *before = u >= (double)(n - 1) ? n - 2 : (size_t)u;
  *share = u - (double)*before;
  return 1;
}

static double depth_at(const depth_map *m, double x, double z) {
  size_t i, j;
  double u, v;
  if (!locate(m->x, m->nx, x, &i, &u) || !locate(m->z, m->nz, z, &j, &v)) return 0;
  const double *h = m->h + i * m->nz + j;
  return (1 - u) * ((1 - v) * h[0] + v * h[1]) + u * ((1 - v) * h[m->nz] + v * h[m->nz + 1]);
}

/* Enlarges the half widths [mm] so that they include all points with a depth > 0. */
static void widen(const depth_map *m, double half[2]) {
  for (size_t i = 0; i < m->nx; i++)
    for (size_t j = 0; j < m->nz; j++)
      if (m->h[i * m->nz + j] > 0) {
        const double step_x = fabs(m->x[1] - m->x[0]), step_z = fabs(m->z[1] - m->z[0]);
        half[0] = fmax(half[0], fabs(m->x[i]) + step_x);
        half[1] = fmax(half[1], fabs(m->z[j]) + step_z);
      }
}

/* --- functions -------------------------------------------------------------------------------- */

static double call_depth(lua_State *L, int index, const char *where, arc_body body, double x,
                         double z) {
  char call[100];
  snprintf(call, sizeof call, "worn.%s(%.6g, %.6g)", body_names[body], x, z);
  lua_pushvalue(L, index);
  lua_pushnumber(L, x);
  lua_pushnumber(L, z);
  if (error_pcall(L, 2, 1) != LUA_OK) error_callback(L, where, call);
  const double depth = lua_tonumber(L, -1);
  if (lua_type(L, -1) != LUA_TNUMBER || !(isfinite(depth) && depth >= 0))
    error_raise(L, ARC_CALLBACK, where, "%s: expected a depth >= 0 in mm, got %s", call,
                names_push_shown(L, -1));
  lua_pop(L, 1);
  return depth;
}

/* --- shapes ----------------------------------------------------------------------------------- */

/* Pushes the function or map for a body from the table at `worn`, or nil. Returns the Lua type of
 * the pushed value. */
static int push_body(lua_State *L, int worn, const arc_model_def *def, arc_body body,
                     const char *where) {
  push_usual_names(L, worn, (args_location){where, "worn."}, def);
  const int type = lua_getfield(L, -1, body_names[body]);
  lua_remove(L, -2);
  return type;
}

static void check_type(lua_State *L, int type, arc_body body, const char *where) {
  if (type == LUA_TNIL || type == LUA_TFUNCTION || (type == LUA_TTABLE && worn_is_map(L, -1)))
    return;
  args_refuse(L, (args_location){where, "worn."}, body_names[body],
              "with geometry = \"3-D\" a function (x, z) -> depth or a map of depths in mm");
}

static void half_widths(lua_State *L, int worn, const arc_model_def *def, const char *where,
                        double half[2]) {
  const int top = lua_gettop(L);
  for (int b = 0; b < ARC_BODIES; b++) {
    char prefix[40];
    args_location location;
    const int type = push_body(L, worn, def, (arc_body)b, where);
    check_type(L, type, (arc_body)b, where);
    if (type == LUA_TTABLE) {
      const depth_map m = push_depth_map(L, -1, *at_body((arc_body)b, where, prefix, &location));
      widen(&m, half);
    }
    lua_settop(L, top);
  }
}

static arc_status wear_body(lua_State *L, int worn, arc_shape *shape, const arc_model_def *def,
                            arc_body body, const char *where, arc_error *error) {
  const int top = lua_gettop(L), type = push_body(L, worn, def, body, where);
  const double *x, *z;
  arc_status status = ARC_OK;
  if (type != LUA_TNIL) {
    const int n = arc_space_given_sites(shape, body, &x, &z);
    double *depth = array_buffer(L, (size_t)n);
    char prefix[40];
    args_location location;
    depth_map m = {0};
    if (type == LUA_TTABLE)
      m = push_depth_map(L, top + 1, *at_body(body, where, prefix, &location));
    for (int i = 0; i < n; i++)
      depth[i] = type == LUA_TTABLE ? depth_at(&m, x[i], z[i])
                                    : call_depth(L, top + 1, where, body, x[i], z[i]);
    status = arc_space_given_depths(shape, body, depth, error);
  }
  lua_settop(L, top);
  return status;
}

/* Replaces the shape in the box `holder` by a new shape with the depths of the table `worn`.
 * `half`: minimum half widths of its window along x and z [mm]. */
static arc_status fill(lua_State *L, box *holder, int worn, arc_model *model,
                       const arc_wear_def *def, const double half[2], const char *where,
                       arc_error *error) {
  const arc_model_def *bodies = arc_model_definition(model);
  arc_shape *shape = holder->thing;
  arc_shape_destroy(&shape);
  holder->thing = NULL;
  arc_status status = arc_space_given_create(model, def, half[0], half[1], &shape, error);
  holder->thing = shape;
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++)
    status = wear_body(L, worn, shape, bodies, (arc_body)b, where, error);
  return status;
}

/* Pushes a new shape. If the depth of a function is not 0 at the edge of the window, enlarges
 * the window and repeats, up to three times. */
arc_shape *worn_push_map(lua_State *L, int worn, arc_model *model, const arc_wear_def *def,
                         const char *where) {
  enum { most_windows = 4 };
  static const double wider = 1.5;
  arc_error error = {0};
  double half[2] = {0};
  worn = lua_absindex(L, worn);
  luaL_checkstack(L, 20, where);
  if (!lua_istable(L, worn))
    error_raise(L, ARC_ARGUMENT, where,
                "field 'worn': with geometry = \"3-D\" expected a wear object on the same model "
                "(model = w.model), or a table with a function or map for each body");
  half_widths(L, worn, arc_model_definition(model), where, half);
  box *holder = box_push(L, &shape_class);
  arc_status status = fill(L, holder, worn, model, def, half, where, &error);
  for (int k = 1; k < most_windows && status == ARC_ZONE; k++) {
    const double *x, *z;
    const int n = arc_space_given_sites(holder->thing, ARC_UPPER, &x, &z);
    half[0] = wider * fabs(x[n - 1]);
    half[1] = wider * fabs(z[n - 1]);
    status = fill(L, holder, worn, model, def, half, where, &error);
  }
  error_check(L, status, &error, where, -1);
  return holder->thing;
}
