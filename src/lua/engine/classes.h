/* lua/classes.h - the classes of the engine, as the files of the binding see each other.
 *
 * luaopen_archard_NAME leaves what the global NAME is: the constructor (a function, or a table that
 * can be called).
 */
#ifndef LUA_CLASSES_H
#define LUA_CLASSES_H

#include "archard/wear.h"
#include "lua/base/args.h"
#include "lua/base/box.h"
#include "lua/base/settings.h"

/* Defines the reader of a computed field that is a number; `expression` may use L. */
#define NUMBER_FIELD(class, field, expression)                                                     \
  static int class##_##field(lua_State *L) {                                                       \
    lua_pushnumber(L, (lua_Number)(expression));                                                   \
    return 1;                                                                                      \
  }

int luaopen_archard_material(lua_State *L);
int luaopen_archard_hertz(lua_State *L);
int luaopen_archard_model(lua_State *L);
int luaopen_archard_body(lua_State *L);
int luaopen_archard_contact(lua_State *L);
int luaopen_archard_contact_record(lua_State *L);
int luaopen_archard_wear(lua_State *L);

extern const box_class model_class;   /* thing: arc_model, one reference */
extern const box_class mesh_class;    /* thing: a view of mesh_class.c */
extern const box_class contact_class; /* thing: arc_contact; user value: the model's box */
extern const box_class wear_class;    /* thing: arc_wear; user value: the model's box */

/* --- bodies by name (by_body.c); without a definition (NULL) they are the usual pair --- */

/* {"cylinder", "plate", NULL} in the order of arc_body: fields of definitions and files. */
extern const char *const body_names[];

/* What a body is called, as arc_model_body_name; the body a word means, as arc_model_find_body. */
const char *body_name(const arc_model_def *def, arc_body body);
int body_find(const arc_model_def *def, const char *word, arc_body *body);

/* The body named at `index`; `otherwise` (-1: none) where nothing stands there. */
arc_body body_argument(lua_State *L, int index, const char *where, const arc_model_def *def,
                       int otherwise);

/* Sets the value on top as the field of a body in the table below it. */
void set_by_body(lua_State *L, const arc_model_def *def, arc_body body);
/* Such a table, on top, answers to all other words for the bodies as well. */
void by_body_named(lua_State *L, const arc_model_def *def, const char *where);
/* Pushes a table with a number, or with what each is called, by body. */
void push_by_body(lua_State *L, const arc_model_def *def, double upper, double lower,
                  const char *where);
/* A history on top answers to depth_NAME and volume_NAME by all words for the bodies. */
void columns_by_body(lua_State *L, const arc_model_def *def, const char *where);
void push_body_names(lua_State *L, const arc_model_def *def);
/* Pushes the table at `index` with the fields of bodies called as in body_names. */
void push_usual_names(lua_State *L, int index, args_place place, const arc_model_def *def);

/* Pushes a material object. */
void material_push(lua_State *L, arc_material material);

/* --- joints (joint_module.c) --- */

/* Where the definition at index 1 has a joint as its model, calls the joint's method ("contact",
 * "wear") with the rest of it: 1, and the result is on top. */
int joint_takes(lua_State *L, const char *method);

/* --- models (model_class.c) --- */

/* Writes the zones that a contact or run needs on a model of `def`, or says why it cannot be. */
typedef arc_status (*zones_fn)(const void *asker, const arc_model_def *def, double zone[ARC_BODIES],
                               arc_error *error);

/* Pushes the box of the model that the field `model` of the definition table at index 1 means: an
 * object, or one of the table's fields; if there is none, one like that of the worn object at index
 * `worn`, or the default. What is "auto" of its mesh suits the load [N], and what `zones` asks for.
 */
arc_model *model_argument(lua_State *L, int worn, const char *where, double load, zones_fn zones,
                          const void *asker);

/* Where the field `model` of the definition table at index 1 is an object: pushes a model like
 * `model` whose zones are as wide as `zones` asks for, and warns of that. NULL, and nothing, where
 * it is a table, that is no wider, or the meshes were given. */
arc_model *model_push_wider(lua_State *L, const arc_model *model, const char *where, zones_fn zones,
                            const void *asker);

/* Reads the field "mesh" of the table at `index` over that of a run, for arc_wear_set; returns 0
 * where there is none. */
int model_read_mesh(lua_State *L, int index, const char *where, arc_mesh_def *mesh);

/* Raises where the bodies of a pair have no meshes (surface_maps.c). */
void model_check_meshed(lua_State *L, const arc_model *model, const char *where);

/* --- sharing them (model_share.c) --- */

/* Pushes the box of a model of this definition: one that lives already, or a new one. */
arc_model *model_push(lua_State *L, const arc_model_def *def, const char *where);
/* The same of two meshes that are given, by arc_body, which a new one takes over and nulls. */
arc_model *model_push_given(lua_State *L, const arc_model_def *def, arc_mesh **given,
                            const char *where);

/* Pushes a box of a model that lives without one. */
void model_push_living(lua_State *L, arc_model *model);

/* Pushes a mesh object of one body of the model whose box is at `index`. */
void mesh_push(lua_State *L, int index, arc_body body);

/* Pushes { cylinder=, plate= }: the meshes with the nodes as they are worn by now. */
void mesh_push_worn(lua_State *L, const arc_shape *shape);

/* The mesh in the box at `index`; box_check's errors. */
const arc_mesh *mesh_of(lua_State *L, int index, const char *where);

/* Pushes the corners of all elements, four numbers from 1 each; a triangle has 0 as its fourth. */
void mesh_push_elements(lua_State *L, const arc_mesh *mesh);

/* --- worn shapes (worn.c) --- */

extern const box_class shape_class; /* thing: arc_shape; internal */

/* Checks the field `worn` of the definition table at `index` and pushes it (nil: unworn): a wear
 * object, or a table by body of functions or { x=, h= }. */
void worn_check(lua_State *L, int index, const char *where);

/* Pushes a box that holds a new shape on `model`, worn as the value at index `worn` says, for a run
 * of this definition. */
arc_shape *worn_push_shape(lua_State *L, int worn, arc_model *model, const arc_wear_def *def,
                           const char *where);
/* The same in 3-D, of a table by body (worn_map.c). */
arc_shape *worn_push_map(lua_State *L, int worn, arc_model *model, const arc_wear_def *def,
                         const char *where);
/* Whether the table at `index` is a map, or has its fields (worn_map.c). */
int worn_is_map(lua_State *L, int index);

/* The definition of the model that a worn wear object lives on; NULL for anything else. */
const arc_model_def *worn_model_def(lua_State *L, int worn);
/* Its model where that is of meshes from outside, which no definition builds again; else NULL. */
arc_model *worn_given_model(lua_State *L, int worn);

/* --- others --- */

/* Pushes { x=, p= } of a body. */
void contact_push_pressure(lua_State *L, const arc_contact *contact, arc_body body);

/* Pushes what frees arrays that the engine hands out. */
arc_array **arrays_push_holder(lua_State *L);

/* contact:stress() (stress.c). */
int stress_new(lua_State *L);

/* The contact that the stress object at `index` belongs to; NULL if it is anything else. */
const arc_contact *stress_contact(lua_State *L, int index, const char *where);

/* Pushes what holds the stresses of one body until it is collected. */
const arc_field *field_push_holder(lua_State *L, const arc_contact *contact, arc_body body,
                                   const char *where);

/* "thickness 1 mm", or what else the section stands for. */
const char *model_show_space(const arc_model_def *def, char *text, size_t size);

#endif
