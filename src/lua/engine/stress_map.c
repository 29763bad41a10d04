/* Computes maps of the stresses in half-spaces. contact:stress{ y= } returns maps of a horizontal
 * plane, contact:stress{ z= } and contact:stress{ x= } return maps of a vertical section. */
#include "archard/space.h"
#include "lua/base/array.h"
#include "lua/base/error.h"
#include "lua/base/scripts.h"
#include "lua/base/strict.h"
#include "lua/engine/classes.h"
#include "lua/engine/surface_maps.h"

enum { COMPONENTS = 6, MISES = COMPONENTS, ARRAYS, DEPTHS = 41 };
static const char *const names[] = {"sxx", "syy", "szz", "sxy", "syz", "sxz", "mises"};

/* The requested cut: the plane at a depth y <= 0 [mm], or the section at a position x or z [mm].
 * Default: the section of the lower body at z = 0. */
typedef struct cut {
  char axis;
  double at;
  arc_body body;
} cut;

static cut read_cut(lua_State *L, int index, const char *where, const arc_model_def *def) {
  static const arc_setting known[] = {
      ARGS_OTHER("x"), ARGS_OTHER("y"), ARGS_OTHER("z"), ARGS_OTHER("body"), {.name = NULL}};
  const args_location location = {where, ""};
  cut c = {0, 0, ARC_LOWER};
  if (lua_isnoneornil(L, index)) return (cut){'z', 0, ARC_LOWER};
  args_check_table(L, index, where);
  args_check_names(L, index, location, known);
  for (const char *axis = "xyz"; *axis; axis++) {
    const char name[] = {*axis, '\0'};
    if (args_get(L, index, name) != LUA_TNIL) {
      if (c.axis)
        error_raise(L, ARC_ARGUMENT, where,
                    "fields 'x', 'y' and 'z': expected one of them, got %s and %s",
                    c.axis == 'x' ? "x" : "y", name);
      if (!lua_isnumber(L, -1)) args_refuse(L, location, name, "a number in mm");
      c.axis = *axis;
      c.at = lua_tonumber(L, -1);
    }
    lua_pop(L, 1);
  }
  if (!c.axis) c.axis = 'z';
  if (args_get(L, index, "body") != LUA_TNIL)
    c.body = body_argument(L, lua_gettop(L), where, def, -1);
  lua_pop(L, 1);
  return c;
}

/* Coordinates of the grid points of the window: row i is at x[i * nz], column j at z[j]. */
typedef struct window {
  const double *x, *z;
  size_t nx, nz;
} window;

/* Computes the stresses [MPa] at the n grid points of the plane at depth `y`: n values of each
 * component, then n equivalent stresses. */
static void fill_plane(lua_State *L, const arc_contact *contact, const cut *c, double y, size_t n,
                       double *value, const char *where) {
  arc_error error = {0};
  error_check(L, arc_space_contact_stress(contact, c->body, y, value, &error), &error, where, -1);
  for (size_t i = 0; i < n; i++) {
    const double *s = value + i, xx = s[0], yy = s[n], zz = s[2 * n];
    const double shear = s[3 * n] * s[3 * n] + s[4 * n] * s[4 * n] + s[5 * n] * s[5 * n];
    value[MISES * n + i] = sqrt(
        ((xx - yy) * (xx - yy) + (yy - zz) * (yy - zz) + (zz - xx) * (zz - xx)) / 2 + 3 * shear);
  }
}

/* Creates a map of nx * nz values and sets it as field `name` of the table on top of the stack. */
static void set_map(lua_State *L, const char *name, const double *x, size_t nx, const double *z,
                    size_t nz, const double *value) {
  script_require(L, "archard.map.made");
  lua_getfield(L, -1, "new");
  lua_remove(L, -2);
  lua_newtable(L);
  array_set(L, "x", x, nx);
  array_set(L, "z", z, nz);
  array_set(L, "y", value, nx * nz);
  lua_pushliteral(L, "MPa");
  lua_setfield(L, -2, "unit");
  lua_pushstring(L, name);
  lua_setfield(L, -2, "name");
  lua_call(L, 1, 1);
  lua_setfield(L, -2, name);
}

/* Returns the index of the grid point before the position of the cut. `share` is the interpolation
 * weight of the next grid point. */
static size_t locate(lua_State *L, const char *where, const cut *c, const double *at, size_t n,
                     double *share) {
  size_t i = 0;
  const char name[] = {c->axis, '\0'};
  if (!(c->at >= at[0] && c->at <= at[n - 1]))
    error_raise(L, ARC_ARGUMENT, where, "field '%s': expected a number from %f to %f mm, got %f",
                name, at[0], at[n - 1], c->at);
  while (i + 2 < n && at[i + 1] <= c->at) i++;
  *share = (c->at - at[i]) / (at[i + 1] - at[i]);
  return i;
}

/* Pushes maps of the stresses in a section over the depth and the coordinate along the section (x
 * or z). The depths are sorted from the deepest point to the surface. */
static void push_section(lua_State *L, const arc_contact *contact, const cut *c, const window *w,
                         const double *x, const double *z, const char *where) {
  const size_t n = w->nx * w->nz, along = c->axis == 'z' ? w->nx : w->nz;
  const double deepest = 3 * arc_contact_get(contact).half_width;
  double *plane = array_buffer(L, ARRAYS * n), y[DEPTHS], share;
  double *section = array_buffer(L, ARRAYS * along * DEPTHS);
  const size_t at = c->axis == 'z' ? locate(L, where, c, z, w->nz, &share)
                                   : locate(L, where, c, x, w->nx, &share);
  const size_t step = c->axis == 'z' ? w->nz : 1, next = c->axis == 'z' ? 1 : w->nz;
  for (size_t k = 0; k < DEPTHS; k++) {
    y[k] = -deepest * (double)(DEPTHS - 1 - k) / (DEPTHS - 1);
    fill_plane(L, contact, c, y[k], n, plane, where);
    for (size_t a = 0; a < ARRAYS; a++)
      for (size_t i = 0; i < along; i++) {
        const double *v = plane + a * n + i * step + at * next;
        section[(a * along + i) * DEPTHS + k] = (1 - share) * v[0] + share * v[next];
      }
  }
  lua_createtable(L, 0, ARRAYS);
  for (size_t a = 0; a < ARRAYS; a++)
    set_map(L, names[a], c->axis == 'z' ? x : z, along, y, DEPTHS, section + a * along * DEPTHS);
}

static void push_plane(lua_State *L, const arc_contact *contact, const cut *c, const window *w,
                       const double *x, const double *z, const char *where) {
  const size_t n = w->nx * w->nz;
  double *plane = array_buffer(L, ARRAYS * n);
  fill_plane(L, contact, c, c->at, n, plane, where);
  lua_createtable(L, 0, ARRAYS);
  for (size_t a = 0; a < ARRAYS; a++) set_map(L, names[a], x, w->nx, z, w->nz, plane + a * n);
}

int stress_push_space(lua_State *L, const arc_contact *contact, int index, const char *where) {
  const cut c = read_cut(L, index, where, arc_model_definition(arc_contact_model(contact)));
  window w = {NULL, NULL, 0, 0};
  luaL_checkstack(L, 20, where);
  const size_t n = (size_t)arc_space_given_sites(arc_contact_shape(contact), ARC_UPPER, &w.x, &w.z);
  while (w.nz < n && w.x[w.nz] == w.x[0]) w.nz++;
  w.nx = n / w.nz;
  double *x = array_buffer(L, w.nx + w.nz), *z = x + w.nx;
  for (size_t i = 0; i < w.nx; i++) x[i] = w.x[i * w.nz];
  for (size_t j = 0; j < w.nz; j++) z[j] = w.z[j];
  if (c.axis == 'y')
    push_plane(L, contact, &c, &w, x, z, where);
  else
    push_section(L, contact, &c, &w, x, z, where);
  strict_table(L, where);
  return 1;
}
