/* Module `archard.files`: exports objects and tables to files of other tools, and reads and writes
 * text files. The global table export (scripts/export) uses this module. */
#include "archard/export.h"
#include "lua/base/archard.h"
#include "lua/base/call.h"
#include "lua/base/confine.h"
#include "lua/base/error.h"
#include "lua/base/names.h"
#include "lua/base/file_name.h"
#include "lua/files/export.h"
#include "lua/wear/wear_class.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* Returns the file name at index 2, which stays on the stack. Adds the first item of `endings` if
 * the name has no extension, and raises an error if its extension is not in `endings`. */
static const char *path_ending(lua_State *L, const char *where, const char *const endings[],
                               const char *expected) {
  const char *path = path_argument(L, 2, where, "path"), *ending = export_ending(path);
  if (!ending) {
    lua_pushfstring(L, "%s%s", path, endings[0]);
    lua_replace(L, 2);
    return lua_tostring(L, 2);
  }
  for (int i = 0; endings[i]; i++)
    if (strcmp(ending, endings[i]) == 0) return path;
  lua_settop(L, 2);
  args_refuse(L, (args_location){where, ""}, "path", expected);
}

/* Pushes a value that keeps the contact of the object at index 1 alive, and returns the contact,
 * or NULL if the object has none. The contact of a run is computed with the plate at x = 0. */
static const arc_contact *push_contact(lua_State *L, const char *where) {
  const arc_contact *of_stress = stress_contact(L, 1, where);
  if (of_stress || !(box_test(L, 1, &wear_class) || box_test(L, 1, &contact_class))) {
    lua_pushnil(L);
    return of_stress;
  }
  if (box_test(L, 1, &wear_class)) {
    lua_pushcfunction(L, wear_contact);
    lua_pushvalue(L, 1);
    lua_call(L, 1, 1);
  } else {
    lua_pushvalue(L, 1);
  }
  const arc_contact *contact = box_check(L, -1, &contact_class, where)->thing;
  model_check_meshed(L, arc_contact_model(contact), where);
  return contact;
}

/* Returns the model at index 1. Raises an error if it has no meshes. */
static const arc_model *meshed_model(lua_State *L, const char *where) {
  const arc_model *model = box_check(L, 1, &model_class, where)->thing;
  model_check_meshed(L, model, where);
  if (!arc_model_mesh(model, ARC_UPPER))
    error_raise(L, ARC_ARGUMENT, where, "expected a model with meshes");
  return model;
}

/* --- VTK -------------------------------------------------------------------------------------- */

static const char vtk_where[] = "export.vtk";

/* Data for the VTK files of one object. */
typedef struct vtk_source {
  const arc_model *model;
  const arc_contact *contact; /* contact of the object; NULL: only the mesh is written */
  double time;
} vtk_source;

static void write_vtk(lua_State *L, const char *file, const arc_mesh *mesh, vtk_source from) {
  arc_error error = {0};
  arc_status status;
  if (strcmp(export_ending(file), ".vtu") == 0) {
    status = arc_export_vtu(file, mesh, from.contact, from.time, &error);
  } else {
    const arc_field *field =
        from.contact ? field_push_holder(L, from.contact, mesh->body, vtk_where) : NULL;
    status = arc_export_vtk(file, mesh, field, &error);
    if (field) lua_pop(L, 1);
  }
  error_check(L, status, &error, vtk_where, -1);
}

static vtk_source read_source(lua_State *L) {
  if (box_test(L, 1, &model_class)) return (vtk_source){.model = meshed_model(L, vtk_where)};
  vtk_source from = {.contact = push_contact(L, vtk_where)};
  if (!from.contact)
    error_raise(L, ARC_ARGUMENT, vtk_where,
                "expected a run, a contact, its stress, a model or a mesh, got %s",
                names_push_shown(L, 1));
  from.model = arc_contact_model(from.contact);
  box *run = box_test(L, 1, &wear_class);
  if (run) from.time = arc_wear_last(run->thing)->distance;
  return from;
}

static const char *name_in(const arc_model *model, arc_body body) {
  return body_name(arc_model_definition(model), body);
}

/* vtk(wear, contact, stress, model or mesh object, path) returns the names of the written files:
 * one for a mesh, otherwise one for each body. */
static int export_vtk(lua_State *L) {
  static const char *const endings[] = {".vtk", ".vtu", NULL};
  lua_settop(L, 2);
  const char *path =
      path_ending(L, vtk_where, endings, "a file name that ends in .vtk (legacy) or .vtu (XML)");
  if (box_test(L, 1, &mesh_class)) {
    write_vtk(L, path, mesh_of(L, 1, vtk_where), (vtk_source){0});
    lua_pushvalue(L, 2);
    return 1;
  }
  const vtk_source from = read_source(L);
  for (int body = 0; body < ARC_BODIES; body++)
    write_vtk(L, export_push_path(L, path, name_in(from.model, (arc_body)body), ".vtk"),
              arc_model_mesh(from.model, (arc_body)body), from);
  return ARC_BODIES;
}

/* --- input decks ------------------------------------------------------------------------------ */

/* Pushes a contact of the model at index 1, solved with the default load. */
static const arc_contact *push_usual_contact(lua_State *L, const char *where) {
  lua_pushcfunction(L, luaopen_archard_contact);
  lua_call(L, 0, 1);
  lua_newtable(L);
  lua_pushvalue(L, 1);
  lua_setfield(L, -2, "model");
  lua_call(L, 1, 1);
  return box_check(L, -1, &contact_class, where)->thing;
}

/* inp(wear, contact, stress or model object, path) returns the name of the written input deck. */
static int export_inp(lua_State *L) {
  static const char where[] = "export.inp";
  static const char *const endings[] = {".inp", NULL};
  lua_settop(L, 2);
  const char *path = path_ending(L, where, endings, "a file name that ends in .inp");
  if (box_test(L, 1, &model_class))
    model_check_meshed(L, box_check(L, 1, &model_class, where)->thing, where);
  const arc_contact *contact =
      box_test(L, 1, &model_class) ? push_usual_contact(L, where) : push_contact(L, where);
  if (!contact)
    error_raise(L, ARC_ARGUMENT, where, "expected a run, a contact or a model, got %s",
                names_push_shown(L, 1));
  arc_error error = {0};
  error_check(L, arc_export_inp(path, contact, &error), &error, where, -1);
  lua_pushvalue(L, 2);
  return 1;
}

/* --- Gmsh files ------------------------------------------------------------------------------- */

static int push_text(lua_State *L) {
  lua_pushlstring(L, lua_touserdata(L, 1), (size_t)lua_tointeger(L, 2));
  return 1;
}

/* Pushes a C text as a string and frees the C text, even if Lua runs out of memory. */
static int push_and_free(lua_State *L, char *text, size_t length) {
  lua_pushcfunction(L, push_text);
  lua_pushlightuserdata(L, text);
  lua_pushinteger(L, (lua_Integer)length);
  const int failed = lua_pcall(L, 2, 1, 0);
  free(text);
  return failed ? lua_error(L) : 1;
}

/* Pushes the contents of a Gmsh file as a text. */
static int msh_as_text(lua_State *L, const arc_mesh *const mesh[ARC_BODIES], const char *where) {
  arc_error error = {0};
  char *text;
  error_check(L, arc_export_msh_text(&text, mesh, &error), &error, where, -1);
  return push_and_free(L, text, strlen(text));
}

/* msh(model or mesh object, path) writes a Gmsh file and returns its name. The file of a model
 * has the meshes of both bodies. Without a path, msh returns the text of the file. */
static int export_msh(lua_State *L) {
  static const char where[] = "export.msh";
  static const char *const endings[] = {".msh", NULL};
  const arc_mesh *mesh[ARC_BODIES] = {0};
  const int is_file = !lua_isnoneornil(L, 2);
  lua_settop(L, 2);
  const char *path =
      is_file ? path_ending(L, where, endings, "a file name that ends in .msh") : NULL;
  if (box_test(L, 1, &mesh_class)) {
    const arc_mesh *one = mesh_of(L, 1, where);
    mesh[one->body] = one;
  } else if (box_test(L, 1, &model_class)) {
    const arc_model *model = meshed_model(L, where);
    for (int body = 0; body < ARC_BODIES; body++)
      mesh[body] = arc_model_mesh(model, (arc_body)body);
  } else {
    error_raise(L, ARC_ARGUMENT, where, "expected a model or a mesh, got %s",
                names_push_shown(L, 1));
  }
  if (!is_file) return msh_as_text(L, mesh, where);
  arc_error error = {0};
  error_check(L, arc_export_msh(path, mesh, &error), &error, where, -1);
  lua_pushvalue(L, 2);
  return 1;
}

/* --- text files and the sandbox --------------------------------------------------------------- */

/* write(where, path, text) writes a complete file. On failure it raises an error that names the
 * function `where`, and no incomplete file remains. */
static int files_write(lua_State *L) {
  size_t length;
  const char *where = luaL_checkstring(L, 1);
  const char *path = path_argument(L, 2, where, "file");
  const char *text = luaL_checklstring(L, 3, &length);
  arc_error error = {0};
  error_check(L, arc_export_text(path, text, length, &error), &error, where, -1);
  return 0;
}

/* read(where, path) returns the text of a regular file. On failure it raises an error that names
 * the function `where`. */
static int files_read(lua_State *L) {
  const char *where = luaL_checkstring(L, 1);
  const char *path = path_argument(L, 2, where, "file");
  arc_error error = {0};
  char *text;
  size_t length;
  error_check(L, arc_file_read(path, &text, &length, &error), &error, where, -1);
  return push_and_free(L, text, length);
}

/* is_there(path) returns true if `path` is a readable regular file, not a pipe or device. */
static int files_is_there(lua_State *L) {
  FILE *stream;
  const char *path = luaL_checkstring(L, 1);
  const int found = arc_file_open(path, &stream, NULL) == ARC_OK;
  if (found) fclose(stream);
  lua_pushboolean(L, found);
  return 1;
}

/* number(value) returns the shortest text that is read back as exactly the same number. */
static int files_number(lua_State *L) {
  lua_pushstring(L, arc_number_to_text(luaL_checknumber(L, 1)).text);
  return 1;
}

/* find(name, "read" or "write") returns the path of the file `name`. Returns nil and the reason
 * if there is no such file, or if the sandbox does not allow this use. */
static int files_find(lua_State *L) {
  static const char *const uses[] = {"read", "write", NULL};
  char path[PATH_MAX];
  arc_error error = {0};
  const arc_file_use use = (arc_file_use)luaL_checkoption(L, 2, NULL, uses);
  const int found = arc_file_find(luaL_checkstring(L, 1), use, path, &error) == ARC_OK;
  lua_pushstring(L, found ? path : NULL);
  error_push_plain(L, error.message);
  return 2;
}

/* confine(folder, least) restricts reading to `folder` and the working folder. Writing is allowed
 * only in the working folder, and only while its disk has at least `least` bytes of free space. */
static int files_confine(lua_State *L) {
  arc_error error = {0};
  const arc_status status = confine_files(luaL_checkstring(L, 1), ".", &error);
  error_check(L, status, &error, "confine", -1);
  confine_disk(luaL_checknumber(L, 2));
  return 0;
}

/* confined() returns the folder of readable files, or nil if there is no sandbox, and the number
 * of bytes that must stay free on the disk. */
static int files_confined(lua_State *L) {
  lua_pushstring(L, confine_folder());
  lua_pushnumber(L, confine_least());
  return 2;
}

int luaopen_archard_files(lua_State *L) {
  static const luaL_Reg functions[] = {
      {"csv", export_csv},          {"vtk", export_vtk},          {"inp", export_inp},
      {"msh", export_msh},          {"write", files_write},       {"read", files_read},
      {"is_there", files_is_there}, {"number", files_number},     {"find", files_find},
      {"confine", files_confine},   {"confined", files_confined}, {NULL, NULL}};
  call_new_library(L, functions);
  return 1;
}
