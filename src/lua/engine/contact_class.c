/* Class contact: one contact solution and its pressures. The stresses are in stress_class.c. */
#include "archard/contact.h"
#include "lua/base/interrupt.h"
#include "lua/base/array.h"
#include "lua/base/call.h"
#include "lua/engine/classes.h"
#include "lua/base/error.h"
#include "lua/base/names.h"
#include "lua/base/strict.h"
#include "lua/engine/peak.h"
#include "lua/engine/surface_maps.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- the object ------------------------------------------------------------------------------- */

static void destroy_contact(void *thing) {
  arc_contact *contact = thing;
  arc_contact_destroy(&contact);
}

static arc_contact *self(lua_State *L) {
  return box_self(L, &contact_class, "contact")->thing;
}

static arc_contact_result result(lua_State *L) {
  return arc_contact_get(self(L));
}

NUMBER_FIELD(contact, p_center, result(L).p_center)
NUMBER_FIELD(contact, p_max, result(L).p_max)
NUMBER_FIELD(contact, p_average, result(L).p_average)
NUMBER_FIELD(contact, half_width, result(L).half_width)
NUMBER_FIELD(contact, half_width_z, result(L).half_width_z)
NUMBER_FIELD(contact, area, result(L).area)
NUMBER_FIELD(contact, normal_force, result(L).normal_force)
NUMBER_FIELD(contact, approach, result(L).approach)
NUMBER_FIELD(contact, tangential, result(L).tangential)
NUMBER_FIELD(contact, energy, result(L).energy)
NUMBER_FIELD(contact, energy_error, result(L).energy_error)
NUMBER_FIELD(contact, z, result(L).z)
NUMBER_FIELD(contact, tangential_z, result(L).tangential_z)

static int contact_iterations(lua_State *L) {
  lua_pushinteger(L, result(L).iterations);
  return 1;
}

static int push_edges(lua_State *L, double left, double right) {
  lua_createtable(L, 0, 2);
  array_set_number(L, "left", left);
  array_set_number(L, "right", right);
  strict_table(L, "zone");
  return 1;
}

static int contact_edges(lua_State *L) {
  arc_contact_result solved = result(L);
  return push_edges(L, solved.left, solved.right);
}

static const arc_model_def *model_of(const arc_contact *contact) {
  return arc_model_definition(arc_contact_model(contact));
}

/* Field contact.stick: the list of the stick zones from left to right, or in 3-D the fraction of
 * the contact area that sticks. */
static int contact_stick(lua_State *L) {
  const arc_contact *contact = self(L);
  double edges[2];
  if (arc_model_has_maps(model_of(contact))) {
    lua_pushnumber(L, arc_contact_get(contact).stick);
    return 1;
  }
  lua_newtable(L);
  for (int i = 0; arc_contact_stick(contact, i, edges); i++) {
    push_edges(L, edges[0], edges[1]);
    lua_seti(L, -2, i + 1);
  }
  return 1;
}

static int contact_model(lua_State *L) {
  self(L);
  lua_getiuservalue(L, 1, 1);
  return 1;
}

/* Writes the position of the largest pressure as text, or "" if the largest pressure is at the
 * centre. */
static void show_peak(const arc_contact *contact, const arc_contact_result *solved, char *text,
                      size_t size) {
  arc_error error = {0};
  arc_array *arrays = NULL;
  size_t count = 0;
  text[0] = '\0';
  if (!(solved->p_max > solved->p_center)) return;
  if (arc_contact_surfaces(contact, &arrays, &count, &error) != ARC_OK) return;
  peak_position(arrays, count, solved->p_center, text, size);
  free(arrays);
}

/* Pushes the lines about friction in the text of a printed contact. */
static void push_friction_text(lua_State *L, const arc_contact_def *def,
                               const arc_contact_result *solved) {
  char text[240];
  const double least = 1e-8 * def->load; /* [N] forces below this limit are printed as 0 */
  const double along_x = fabs(solved->tangential) < least ? 0 : solved->tangential;
  const double along_z = fabs(solved->tangential_z) < least ? 0 : solved->tangential_z;
  if (arc_model_has_maps(model_of(self(L))))
    snprintf(text, sizeof text,
             "\n  friction  %.6g, tangential force %.6g N along x, %.6g N along z\n"
             "            %.4g of the area sticks, %.6g N mm dissipated",
             def->friction, along_x, along_z, solved->stick, solved->energy);
  else
    snprintf(text, sizeof text, "\n  friction  %.6g, tangential force %.6g N, %.6g N mm dissipated",
             def->friction, along_x, solved->energy);
  lua_pushstring(L, text);
}

static int contact_tostring(lua_State *L) {
  const arc_contact_def *def = arc_contact_definition(self(L));
  arc_contact_result solved = result(L);
  char text[560], at[80];
  show_peak(self(L), &solved, at, sizeof at);
  snprintf(text, sizeof text,
           "contact: load %.6g N, plate at x = %.6g mm\n"
           "  pressure  centre %.6g MPa, largest %.6g MPa%s\n"
           "  width     half %.6g mm, from %.6g to %.6g mm\n"
           "  approach  %.6g mm (%d iterations)",
           def->load, def->x, solved.p_center, solved.p_max, at, solved.half_width, solved.left,
           solved.right, solved.approach, solved.iterations);
  if (arc_model_has_maps(model_of(self(L))))
    snprintf(text, sizeof text,
             "contact: load %.6g N, lower body at x = %.6g mm\n"
             "  pressure  centre %.6g MPa, largest %.6g MPa%s\n"
             "  size      half widths %.6g mm along x, %.6g mm along z; area %.6g mm2\n"
             "  approach  %.6g mm (%d iterations)",
             def->load, def->x, solved.p_center, solved.p_max, at, solved.half_width,
             solved.half_width_z, solved.area, solved.approach, solved.iterations);
  lua_pushstring(L, text);
  if (def->friction == 0) return 1;
  push_friction_text(L, def, &solved);
  lua_concat(L, 2);
  return 1;
}

void contact_push_pressure(lua_State *L, const arc_contact *contact, arc_body body) {
  arc_pressure pressure = arc_contact_pressure(contact, body);
  lua_createtable(L, 0, 2);
  array_set(L, "x", pressure.x, (size_t)pressure.count);
  array_set(L, "p", pressure.p, (size_t)pressure.count);
  strict_table(L, "pressure");
}

/* Metamethod __gc: frees the array of the engine. */
static int free_arrays(lua_State *L) {
  arc_array **held = lua_touserdata(L, 1);
  free(*held);
  *held = NULL;
  return 0;
}

arc_array **arrays_push_holder(lua_State *L) {
  arc_array **held = lua_newuserdatauv(L, sizeof *held, 0);
  *held = NULL;
  if (luaL_newmetatable(L, "arrays of the engine")) {
    lua_pushcfunction(L, free_arrays);
    lua_setfield(L, -2, "__gc");
  }
  lua_setmetatable(L, -2);
  return held;
}

/* Pushes shear or slip of a 3-D contact: a map of the magnitude, a map of the component along "x"
 * or "z", or a section with both components. */
static int push_friction(lua_State *L, const arc_contact *contact, const char *where,
                         const char *unit, const char *size, const char *const *names) {
  size_t count;
  arc_error error = {0};
  if (arc_contact_definition(contact)->friction == 0)
    error_raise(L, ARC_ARGUMENT, where, "expected a contact with friction, got friction 0");
  lua_settop(L, 2);
  arc_array **held = arrays_push_holder(L);
  error_check(L, arc_contact_surfaces(contact, held, &count, &error), &error, where, -1);
  if (lua_istable(L, 2)) {
    surface_push_section(L, 2, where, *held, count, ARC_UPPER, names);
    return 1;
  }
  const char *axis = lua_isstring(L, 2) ? lua_tostring(L, 2) : "";
  const int along_x = strcmp(axis, "x") == 0, along_z = strcmp(axis, "z") == 0;
  if (!lua_isnoneornil(L, 2) && !along_x && !along_z)
    error_raise(L, ARC_ARGUMENT, where,
                "expected \"x\", \"z\", a section { z = } or no argument, got %s",
                names_push_shown(L, 2));
  surface_push_map(L, *held, count, ARC_UPPER,
                   along_x   ? names[0]
                   : along_z ? names[1]
                             : size,
                   unit);
  return 1;
}

/* Pushes the pressures of a 3-D contact: a map for contact:pressure(), a section { x=, p= } for
 * contact:pressure{ z = 0 }. */
static int push_spatial(lua_State *L, const arc_contact *contact) {
  static const char where[] = "contact:pressure", *const names[] = {"p", NULL};
  size_t count;
  arc_error error = {0};
  lua_settop(L, 2);
  arc_array **held = arrays_push_holder(L);
  error_check(L, arc_contact_surfaces(contact, held, &count, &error), &error, where, -1);
  if (lua_istable(L, 2))
    surface_push_section(L, 2, where, *held, count, ARC_UPPER, names);
  else
    surface_push_map(L, *held, count, body_argument(L, 2, where, model_of(contact), ARC_UPPER), "p",
                     "MPa");
  return 1;
}

/* contact:pressure(body) returns { x=, p= }. For both bodies x is in the coordinates of the
 * cylinder. */
static int contact_pressure(lua_State *L) {
  const arc_contact *contact = self(L);
  if (arc_model_has_maps(model_of(contact))) return push_spatial(L, contact);
  const arc_body body = body_argument(L, 2, "contact:pressure", model_of(contact), ARC_UPPER);
  contact_push_pressure(L, contact, body);
  return 1;
}

/* contact:shear(body) returns { x=, q= }. In 3-D contact:shear() returns a map of the magnitude. */
static int contact_shear(lua_State *L) {
  static const char *const names[] = {"q", "qz", NULL};
  const arc_contact *contact = self(L);
  if (arc_model_has_maps(model_of(contact)))
    return push_friction(L, contact, "contact:shear", "MPa", "shear", names);
  const arc_body body = body_argument(L, 2, "contact:shear", model_of(contact), ARC_UPPER);
  const arc_shear shear = arc_contact_shear(contact, body);
  lua_createtable(L, 0, 2);
  array_set(L, "x", shear.x, (size_t)shear.count);
  array_set(L, "q", shear.q, (size_t)shear.count);
  return 1;
}

/* contact:slip() returns { x=, s= } at the cylinder's nodes. In 3-D it returns a map of the
 * magnitude. */
static int contact_slip(lua_State *L) {
  static const char *const names[] = {"s", "sz", NULL};
  const arc_contact *contact = self(L);
  int count;
  if (arc_model_has_maps(model_of(contact)))
    return push_friction(L, contact, "contact:slip", "mm", "slip", names);
  const double *slip = arc_contact_slip(contact, &count);
  if (lua_gettop(L) > 1)
    error_raise(L, ARC_ARGUMENT, "contact:slip",
                "expected no argument (slip is given at the cylinder's nodes), got %s",
                names_push_shown(L, 2));
  if (!slip)
    error_raise(L, ARC_ARGUMENT, "contact:slip",
                "expected a contact with friction, got friction 0");
  lua_createtable(L, 0, 2);
  array_set(L, "x", arc_contact_shear(contact, ARC_CYLINDER).x, (size_t)count);
  array_set(L, "s", slip, (size_t)count);
  return 1;
}

/* --- the calls that created a contact --------------------------------------------------------- */

/* Pushes a shallow copy of the table at `index`, or an empty table if the value is not a table. */
static void push_copy(lua_State *L, int index) {
  lua_newtable(L);
  if (!lua_istable(L, index)) return;
  for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
    lua_pushvalue(L, -2);
    lua_pushvalue(L, -2);
    lua_rawset(L, -5);
  }
}

/* Stores a record of the call in the contact on top of the stack. The record contains the
 * definition at index `given`, the record of the previous contact at index `from` (0: none), and
 * the number of updates of the wear object in the field `worn`. */
static void keep_call(lua_State *L, int given, int from) {
  lua_createtable(L, 0, 3);
  push_copy(L, given);
  if (lua_getfield(L, -1, "worn") != LUA_TNIL && box_test(L, -1, &wear_class)) {
    lua_getfield(L, -1, "update");
    lua_setfield(L, -4, "update");
  }
  lua_pop(L, 1);
  lua_setfield(L, -2, "given");
  if (from) {
    lua_getiuservalue(L, from, 2);
    lua_setfield(L, -2, "from");
  }
  lua_setiuservalue(L, -2, 2);
}

/* Module contact_record: record(contact) returns { given=, update=, from= }. `given` contains the
 * arguments of contact{} or contact:move{}. `update` is the number of updates that the run in
 * `worn` had when the contact was created, or nil. `from` is the record of the contact before the
 * move, or nil. */
static int contact_record(lua_State *L) {
  box_check(L, 1, &contact_class, "contact_record");
  lua_getiuservalue(L, 1, 2);
  return 1;
}

int luaopen_archard_contact_record(lua_State *L) {
  lua_pushcfunction(L, contact_record);
  return 1;
}

/* --- construction ----------------------------------------------------------------------------- */

static arc_status needed_zones(const void *definition, const arc_model_def *model,
                               double zone[ARC_BODIES], arc_error *error) {
  const arc_contact_def *def = definition;
  const arc_hertz_def pair = {.radius = model->radius,
                              .thickness = model->thickness,
                              .load = def->load,
                              .material = {model->material[0], model->material[1]}};
  arc_hertz hertz = {0};
  const arc_status status =
      arc_hertz_of(&pair, &hertz, error); /* arc_hertz_of also checks the ranges of the settings */
  if (status == ARC_OK) arc_contact_zones(def, model, zone);
  return status;
}

/* Pushes the shape of the contact. It is the shape of the wear object `worn` if this object has the
 * same model, otherwise a new shape. */
static const arc_shape *push_shape(lua_State *L, int worn, arc_model *model, double load) {
  arc_wear_def def = arc_wear_default();
  if (arc_model_is_given(model)) def.geometry = ARC_FROZEN;
  def.refresh = 0;
  def.load = load;
  def.alpha = 1;
  def.procedure = ARC_NSP; /* the plate has only one position, so no sliding is simulated */
  box *other = box_test(L, worn, &wear_class);
  if (!other || arc_wear_model(other->thing) != model)
    return worn_push_shape(L, worn, model, &def, "contact");
  lua_pushvalue(L, worn);
  return arc_wear_shape(other->thing);
}

static void warn(void *context, const char *text) {
  lua_warning(context, text, 0);
}

/* Arguments of a new contact: either a shape and a definition, or a previous contact and its
 * motion. */
typedef struct request {
  const arc_shape *shape;
  const arc_contact_def *def;
  const arc_contact *from;
  const arc_motion_def *motion;
} request;

/* Solves the requested contact and pushes a box that owns the contact. The value at `holder` keeps
 * the contact's model alive. */
static arc_status push_contact(lua_State *L, int holder, const request *asked, arc_error *error) {
  const arc_callbacks callbacks = {.stop = interrupt_pending, .warn = warn, .context = L};
  arc_contact *contact = NULL;
  box *made = box_push(L, &contact_class);
  box_keep(L, holder);
  const arc_status status =
      asked->from ? arc_contact_move(asked->from, asked->motion, &callbacks, &contact, error)
                  : arc_contact_solve(asked->shape, asked->def, &callbacks, &contact, error);
  made->thing = contact;
  if (status == ARC_OK) box_weigh(L, arc_contact_bytes(contact));
  return status;
}

/* Constructor contact{ model=, load=, x=, worn=, friction= }: solves and returns a contact. */
static int contact_new(lua_State *L) {
  arc_contact_def def = arc_contact_default();
  lua_settop(L, 1);
  if (joint_takes(L, "contact")) return 1;
  args_read(L, 1, (args_location){"contact", ""}, arc_contact_settings, &def);
  worn_check(L, 1, "contact");
  int worn = lua_gettop(L);
  arc_model *model =
      model_argument(L, worn, "contact", def.load, def.friction > 0, needed_zones, &def);
  int holder = lua_gettop(L);
  arc_error error = {0};
  request asked = {.shape = push_shape(L, worn, model, def.load), .def = &def};
  arc_status status = push_contact(L, holder, &asked, &error);
  if (status == ARC_ZONE && (model = model_push_wider(L, model, "contact", needed_zones, &def))) {
    holder = lua_gettop(L);
    asked.shape = push_shape(L, worn, model, def.load);
    status = push_contact(L, holder, &asked, &error);
  }
  error_check(L, status, &error, "contact", -1);
  keep_call(L, 1, 0);
  return 1;
}

/* contact:move{ x=, z=, load=, tangential=, tangential_z=, increments= } returns a new contact. */
static int contact_move(lua_State *L) {
  const arc_contact *from = self(L);
  const args_location location = {"contact:move", ""};
  arc_motion_def motion = arc_contact_motion(from);
  lua_settop(L, 2);
  args_read(L, 2, location, arc_motion_settings, &motion);
  motion.by_force = args_given(L, 2, "tangential");
  if (motion.by_force && args_given(L, 2, "x"))
    error_raise(
        L, ARC_ARGUMENT, location.where,
        "fields 'x' and 'tangential': expected one of them (displacement or force), got both");
  motion.by_force_z = args_given(L, 2, "tangential_z");
  if (motion.by_force_z && args_given(L, 2, "z"))
    error_raise(L, ARC_ARGUMENT, location.where,
                "fields 'z' and 'tangential_z': expected one of them, got both");
  lua_getiuservalue(L, 1, 1);
  arc_error error = {0};
  const request asked = {.from = from, .motion = &motion};
  error_check(L, push_contact(L, lua_gettop(L), &asked, &error), &error, location.where, -1);
  keep_call(L, 2, 1);
  return 1;
}

static const luaL_Reg fields[] = {
    {"p_center", contact_p_center},
    {"p_max", contact_p_max},
    {"p_average", contact_p_average},
    {"edges", contact_edges},
    {"half_width", contact_half_width},
    {"half_width_z", contact_half_width_z},
    {"area", contact_area},
    {"approach", contact_approach},
    {"normal_force", contact_normal_force},
    {"tangential", contact_tangential},
    {"energy", contact_energy},
    {"energy_error", contact_energy_error},
    {"z", contact_z},
    {"tangential_z", contact_tangential_z},
    {"stick", contact_stick},
    {"iterations", contact_iterations},
    {"model", contact_model},
    {NULL, NULL},
};

static const luaL_Reg methods[] = {{"pressure", contact_pressure}, {"shear", contact_shear},
                                   {"slip", contact_slip},         {"move", contact_move},
                                   {"stress", stress_new},         {NULL, NULL}};

static const void *definition(lua_State *L) {
  return arc_contact_definition(self(L));
}

const box_class contact_class = {
    .name = "contact",
    .settings = arc_contact_settings,
    .definition = definition,
    .methods = methods,
    .fields = fields,
    .tostring = contact_tostring,
    .destroy = destroy_contact,
};

int luaopen_archard_contact(lua_State *L) {
  call_push(L, contact_new);
  return 1;
}
