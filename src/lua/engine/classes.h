/* lua/engine/classes.h - functions shared between the files of the binding. luaopen_archard_NAME
 * pushes the value of the global NAME, a constructor (function or callable table). */
#ifndef LUA_CLASSES_H
#define LUA_CLASSES_H

#include "archard/wear.h"
#include "lua/base/args.h"
#include "lua/base/box.h"
#include "lua/base/settings.h"

/* Defines the function that pushes a computed field. The value of the field is the number
 * `expression`, which may use L. */
#define NUMBER_FIELD(class, field, expression)                                                     \
  static int class##_##field(lua_State *L) {                                                       \
    lua_pushnumber(L, (lua_Number)(expression));                                                   \
    return 1;                                                                                      \
  }

extern const box_class model_class;   /* box of an arc_model; owns one reference */
extern const box_class mesh_class;    /* box of a mesh_view (mesh_class.c) */
extern const box_class contact_class; /* box of an arc_contact; user value 1: box of its model */
extern const box_class wear_class;    /* box of an arc_wear; user value 1: box of its model */

/* {"cylinder", "plate", NULL}, indexed by arc_body. These are the field names of the bodies in
 * definitions and files. */
extern const char *const body_names[];

/* Computes the half widths [mm] that the meshed zones of both bodies need for a contact or a run
 * with this definition. `def` defines the model. */
typedef arc_status (*zones_fn)(const void *definition, const arc_model_def *def,
                               double zone[ARC_BODIES], arc_error *error);

extern const box_class shape_class; /* box of an arc_shape; scripts cannot use it */

/* --- material_class.c ------------------------------------------------------------------------- */

int luaopen_archard_material(lua_State *L);

/* Pushes a material object. */
void material_push(lua_State *L, arc_material material);

/* --- hertz_class.c ---------------------------------------------------------------------------- */

int luaopen_archard_hertz(lua_State *L);

/* --- model_class.c: models -------------------------------------------------------------------- */

int luaopen_archard_model(lua_State *L);

/* Pushes and returns the model for the definition table at index 1. Its field `model` is a model
 * object or a table of fields. If the field is nil, the definition is that of the model of the worn
 * object at index `worn`, or the default. A mesh size "auto" is chosen for the load [N], and is
 * smaller with friction (arc_model_fit_friction). The function `zones` computes zones that are
 * "auto". */
arc_model *model_argument(lua_State *L, int worn, const char *where, double load, int friction,
                          zones_fn zones, const void *definition);

/* If the field `model` of the definition table at index 1 is a model object whose zones are too
 * narrow, pushes a new model with the zones that `zones` computes, and prints a warning. In other
 * cases, and for imported meshes, pushes nothing and returns NULL. */
arc_model *model_push_wider(lua_State *L, const arc_model *model, const char *where, zones_fn zones,
                            const void *definition);

/* Reads the field `mesh` of the table at `index` into `mesh`, the new mesh settings of a run
 * (arc_wear_set). Returns 0 if the field is nil. */
int model_read_mesh(lua_State *L, int index, const char *where, arc_mesh_def *mesh);

/* Writes a text about the geometry, such as "thickness 1 mm" or "axisymmetric", into `text` and
 * returns it. */
const char *model_show_space(const arc_model_def *def, char *text, size_t size);

/* --- body_module.c ---------------------------------------------------------------------------- */

int luaopen_archard_body(lua_State *L);

/* --- contact_class.c -------------------------------------------------------------------------- */

int luaopen_archard_contact(lua_State *L);
int luaopen_archard_contact_record(lua_State *L);

/* Pushes the table { x=, p= } of positions [mm] and pressures [MPa] on the surface of a body. */
void contact_push_pressure(lua_State *L, const arc_contact *contact, arc_body body);

/* Pushes a userdata that owns an array of the engine and frees it. Returns the address of the
 * userdata's pointer to the array. */
arc_array **arrays_push_holder(lua_State *L);

/* --- wear/wear_class.c ------------------------------------------------------------------------ */

int luaopen_archard_wear(lua_State *L);

/* --- by_body.c: bodies by name; a NULL definition means the default bodies -------------------- */

/* body_name returns the name of a body, like arc_model_body_name. body_find searches for the body
 * that a name, role or kind identifies, like arc_model_find_body. */
const char *body_name(const arc_model_def *def, arc_body body);
int body_find(const arc_model_def *def, const char *word, arc_body *body);

/* Returns the body that the text at `index` names. If the value is nil or none, returns
 * `otherwise`, or raises an error if `otherwise` is -1. */
arc_body body_argument(lua_State *L, int index, const char *where, const arc_model_def *def,
                       int otherwise);

/* Pops a value and stores it in the table below it, in the field of the body `body`. */
void set_by_body(lua_State *L, const arc_model_def *def, arc_body body);
/* Sets the metatable of the table on top of the stack, which has one field for each body. Every
 * name, role or kind that identifies a body becomes an alias of its field. */
void by_body_named(lua_State *L, const arc_model_def *def, const char *where);
/* Pushes a table with one number for each body. */
void push_by_body(lua_State *L, const arc_model_def *def, double upper, double lower,
                  const char *where);
/* Adds aliases of the columns depth_NAME and volume_NAME to the history on top of the stack: one
 * for each name, role or kind that identifies a body. */
void columns_by_body(lua_State *L, const arc_model_def *def, const char *where);
/* Pushes a table of the names of both bodies. */
void push_body_names(lua_State *L, const arc_model_def *def);
/* Pushes a copy of the table at `index`, in which each key that identifies a body is replaced by
 * the body's name in body_names. */
void push_usual_names(lua_State *L, int index, args_location location, const arc_model_def *def);

/* --- joint_module.c: joints ------------------------------------------------------------------- */

/* If the field `model` of the definition at index 1 is a joint, calls the joint's method
 * `method` ("contact", "wear") with the definition without `model`. Returns 1 with the result on
 * top of the stack, or 0 if `model` is not a joint. */
int joint_takes(lua_State *L, const char *method);

/* --- surface_maps.c --------------------------------------------------------------------------- */

/* Raises an error if the bodies have no meshes. */
void model_check_meshed(lua_State *L, const arc_model *model, const char *where);

/* --- model_share.c: models shared by runs ----------------------------------------------------- */

/* Pushes a box with the model of the definition `def`. The model is from the cache, or new if the
 * cache does not have it. */
arc_model *model_push(lua_State *L, const arc_model_def *def, const char *where);
/* Works like model_push for a model with two imported meshes, indexed by arc_body. A new model
 * becomes the owner of the meshes, and the pointers are set to NULL. */
arc_model *model_push_given(lua_State *L, const arc_model_def *def, arc_mesh **given,
                            const char *where);

/* Pushes a new box for a model that already exists. */
void model_push_living(lua_State *L, arc_model *model);

/* --- mesh_class.c ----------------------------------------------------------------------------- */

/* Pushes the mesh object of one body of the model whose box is at `index`. */
void mesh_push(lua_State *L, int index, arc_body body);

/* Pushes a table with the mesh objects of both bodies, which have the present nodes of the worn
 * shape. */
void mesh_push_worn(lua_State *L, const arc_shape *shape);

/* Returns the mesh in the box at `index`. Raises the same errors as box_check. */
const arc_mesh *mesh_of(lua_State *L, int index, const char *where);

/* Pushes a flat list with four node numbers (from 1) for each element. The fourth number of a
 * triangle is 0. */
void mesh_push_elements(lua_State *L, const arc_mesh *mesh);

/* --- worn.c: worn shapes ---------------------------------------------------------------------- */

/* Checks the field `worn` of the definition table at `index` and pushes its value. nil means an
 * unworn shape. Other valid values are a wear object, or a table with a function, a profile { x=,
 * h= } or a map for each body. */
void worn_check(lua_State *L, int index, const char *where);

/* Pushes a box with a new shape of `model` for a run with the definition `def`. The value at index
 * `worn` defines the initial wear depths. */
arc_shape *worn_push_shape(lua_State *L, int worn, arc_model *model, const arc_wear_def *def,
                           const char *where);

/* Returns the model definition of the wear object at `worn`, or NULL if the value is not a wear
 * object. */
const arc_model_def *worn_model_def(lua_State *L, int worn);
/* If the value at `worn` is a wear object with imported meshes, returns its model, because no
 * definition can rebuild this model. Otherwise returns NULL. */
arc_model *worn_given_model(lua_State *L, int worn);

/* --- worn_map.c ------------------------------------------------------------------------------- */

/* Works like worn_push_shape for 3-D models. The value at `worn` is a table with one field for each
 * body (worn_map.c). */
arc_shape *worn_push_map(lua_State *L, int worn, arc_model *model, const arc_wear_def *def,
                         const char *where);
/* Returns true if the table at `index` is a map or has the fields of a map (worn_map.c). */
int worn_is_map(lua_State *L, int index);

/* --- stress_class.c --------------------------------------------------------------------------- */

/* Implements the Lua method contact:stress() (stress_class.c). */
int stress_new(lua_State *L);

/* Returns the contact of the stress object at `index`, or NULL if the value is not a stress
 * object. */
const arc_contact *stress_contact(lua_State *L, int index, const char *where);

/* Pushes a box with the stress field of one body and returns the field. The field is freed with the
 * box. */
const arc_field *field_push_holder(lua_State *L, const arc_contact *contact, arc_body body,
                                   const char *where);

#endif
