/* Class wear: the printed summary of a run. */
#include "archard/space.h"
#include "lua/engine/pair_text.h"
#include "lua/engine/peak.h"
#include "lua/wear/wear_class.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Writes a value such as "100 N". If wear:set has changed the value since the last record,
 * writes "100 N until now, 20 N from here on". The record's value is NaN if it is unknown. */
static const char *show_course(double record, double set, const char *unit, char *text,
                               size_t size) {
  if (fabs(record - set) > 1e-9 * fmax(fabs(record), fabs(set)))
    snprintf(text, size, "%.6g%s until now, %.6g%s from here on", record, unit, set, unit);
  else
    snprintf(text, size, "%.6g%s", set, unit);
  return text;
}

/* Returns `value`, a result of the last update, or NaN if there was no update yet. */
static double of_update(const arc_wear_record *record, double value) {
  return record->update > 0 ? value : NAN;
}

/* Writes a coefficient as text: "0.5" for a constant, "by distance" for a series, or "by
 * function". */
static const char *show_coefficient(double record, double number, const arc_series *series,
                                    int function, const char *unit, char *text, size_t size) {
  if (function) return "by function";
  if (series->count > 0) return "by distance";
  return show_course(record, number, unit, text, size);
}

/* Writes the motion as text, such as "stroke 0.11 mm" or "loading of 3 blocks, now over 0.2 mm". */
static void show_motion(const arc_wear *wear, char *text, size_t size) {
  const int blocks = arc_wear_definition(wear)->blocks;
  const double travel = arc_wear_travel(wear);
  const double force = arc_wear_definition(wear)->tangential;
  const arc_wear_record *now = arc_wear_last(wear);
  char course[100];
  if (force > 0)
    snprintf(text, size, "force of +-%.6g N along x", force);
  else if (arc_wear_definition(wear)->track > 0)
    snprintf(text, size, "revolutions on a track of radius %.6g mm",
             arc_wear_definition(wear)->track);
  else if (blocks == 0)
    snprintf(text, size, "stroke %s%s",
             show_course(of_update(now, now->travel), travel, " mm", course, sizeof course),
             arc_wear_strokes(wear) == 1 ? " in one direction" : "");
  else
    snprintf(text, size, "loading of %d block%s%s over %.6g mm", blocks, blocks == 1 ? "" : "s",
             blocks == 1 ? "" : ", now", travel);
}

/* Writes the setting that controls the step length: "jump 100", "jump auto", "tolerance 0.001". */
static void show_steps(const arc_wear_def *settings, char *text, size_t size) {
  if (settings->tolerance > 0)
    snprintf(text, size, "tolerance %.6g", settings->tolerance);
  else if (arc_setting_is_auto(&arc_wear_settings[ARC_AT_jump], settings))
    snprintf(text, size, "jump auto");
  else if (settings->jump_function)
    snprintf(text, size, "jump by function");
  else
    snprintf(text, size, "jump %.6g", settings->jump);
}

/* Returns true for settings that are already in the first lines of the summary. */
static int is_printed_above(const arc_setting *s) {
  static const int printed[] = {
      ARC_AT_scheme,   ARC_AT_k,         ARC_AT_alpha,      ARC_AT_load, ARC_AT_stroke,
      ARC_AT_distance, ARC_AT_jump,      ARC_AT_increments, ARC_AT_slip, ARC_AT_procedure,
      ARC_AT_geometry, ARC_AT_tolerance, ARC_AT_tangential};
  for (size_t i = 0; i < sizeof printed / sizeof *printed; i++)
    if (s == &arc_wear_settings[printed[i]]) return 1;
  return 0;
}

static int is_usual(const arc_setting *s, const arc_wear_def *settings) {
  return arc_setting_number(s, settings) == s->usual;
}

/* Appends the name and value of a setting to the summary, such as "law_pressure 50 MPa". */
static void add_setting(luaL_Buffer *text, const arc_setting *s, const arc_wear_def *settings) {
  const void *member = arc_setting_value(s, settings);
  char line[120];
  if (s->kind == ARC_CHOICE)
    snprintf(line, sizeof line, "%s %s", s->name, s->choices[*(const int *)member]);
  else
    snprintf(line, sizeof line, "%s %.6g%s%s", s->name, arc_setting_number(s, settings),
             s->unit[0] ? " " : "", s->unit);
  luaL_addstring(text, line);
}

/* Adds a line with the remaining settings that differ from their defaults, if there are any. */
static void add_others(luaL_Buffer *text, const arc_wear_def *settings) {
  const char *before = "  others    ";
  for (const arc_setting *s = arc_wear_settings; s->name; s++) {
    if (s->kind == ARC_OTHER || is_printed_above(s) || is_usual(s, settings)) continue;
    luaL_addstring(text, before);
    add_setting(text, s, settings);
    before = ", ";
  }
  if (settings->local_factor) {
    luaL_addstring(text, before);
    luaL_addstring(text, "a local factor");
    before = ", ";
  }
  if (before[0] == ',') luaL_addchar(text, '\n');
}

/* Writes the wear coefficient k as text. A constant k is written in both units. */
static const char *show_k(const arc_wear *wear, char *text, size_t size) {
  const arc_wear_def *def = arc_wear_definition(wear);
  const arc_wear_record *now = arc_wear_last(wear);
  const double k = of_update(now, now->k);
  if (!def->k_function && def->k_series.count == 0 && !(fabs(k - def->k) > 1e-12 * k)) {
    snprintf(text, size, "%.6g mm2/N = %.6g mm3/(N m)", def->k, 1e3 * def->k);
    return text;
  }
  return show_coefficient(k, def->k, &def->k_series, def->k_function != NULL, " mm2/N", text, size);
}

static const char *show_alpha(const arc_wear *wear, char *text, size_t size) {
  const arc_wear_def *def = arc_wear_definition(wear);
  const arc_wear_record *now = arc_wear_last(wear);
  return show_coefficient(of_update(now, now->alpha), def->alpha, &def->alpha_series,
                          def->alpha_function != NULL, "", text, size);
}

/* Writes the load of the reference configuration, for which the pressures are printed. */
static const char *show_load(const arc_wear *wear, char *text, size_t size) {
  const arc_wear_def *def = arc_wear_definition(wear);
  return show_course(arc_wear_last(wear)->load_reference, def->load, " N", text, size);
}

/* Writes the number of increments, or "auto" if the user sets no number for a 3-D model or for
 * loading. */
static const char *show_increments(const arc_wear *wear, char *text, size_t size) {
  const arc_wear_def *def = arc_wear_definition(wear);
  const arc_model_def *model = arc_model_definition(arc_wear_model(wear));
  snprintf(text, size, "auto");
  if (arc_model_has_maps(model) && def->increments == 0) return text;
  if (def->blocks == 0 || def->increments > 0)
    snprintf(text, size, "%d", arc_wear_def_increments(def, model));
  return text;
}

/* Writes the sizes and numbers of the cells of a 3-D run, or the sizes of the elements at the
 * surface. */
static void show_mesh(const arc_wear *wear, char *text, size_t size) {
  const arc_model_def *model = arc_model_definition(arc_wear_model(wear));
  const double *x, *z;
  if (!arc_model_has_maps(model)) {
    snprintf(text, size, "elements %.6g x %.6g mm", model->mesh.size, model->mesh.height);
    return;
  }
  const int n = arc_space_given_sites(arc_wear_shape(wear), ARC_UPPER, &x, &z);
  int nx = 0, nz = 0;
  for (int i = 0; i < n; i++) {
    nx += z[i] == z[0];
    nz += x[i] == x[0];
  }
  snprintf(text, size, "%d x %d cells of %.4g x %.4g mm", nx, nz, (x[n - 1] - x[0]) / (nx - 1),
           (z[n - 1] - z[0]) / (nz - 1));
}

/* Adds lines that describe the bodies: shapes, materials, layers and mesh. */
static void add_bodies(luaL_Buffer *text, const arc_wear *wear) {
  const arc_model_def *model = arc_model_definition(arc_wear_model(wear));
  const arc_wear_record *last = arc_wear_last(wear);
  const double depth[ARC_BODIES] = {last->depth_cylinder, last->depth_plate};
  enum { columns = 80 };
  char line[500], pair[300], space[100], mesh[80];
  pair_show(model, pair, sizeof pair);
  const int shapes = arc_model_has_maps(model);
  snprintf(line, sizeof line, "  bodies    %s, %s", pair,
           shapes ? "3-D, half-spaces" : model_show_space(model, space, sizeof space));
  show_mesh(wear, mesh, sizeof mesh);
  luaL_addstring(text, line);
  luaL_addstring(text, strlen(line) + strlen(mesh) + 2 > columns ? ",\n            " : ", ");
  luaL_addstring(text, mesh);
  luaL_addchar(text, '\n');
  pair_add_materials(text, model);
  pair_add_all_layers(text, model, depth);
}

/* Writes coefficients such as "k 1e-08 mm2/N, alpha 0.5". For bodies with layers, writes the
 * coefficients of the layers at the present surfaces. */
static void show_coefficients(const arc_wear *wear, char *text, size_t size) {
  const arc_model_def *model = arc_model_definition(arc_wear_model(wear));
  const double upper = arc_wear_open_k(wear, ARC_UPPER), lower = arc_wear_open_k(wear, ARC_LOWER);
  char k[100], alpha[100];
  if (pair_has_layers(model) && upper + lower > 0)
    snprintf(text, size, "k %.6g mm2/N = %.6g mm3/(N m), alpha %.6g at the present surfaces",
             upper + lower, 1e3 * (upper + lower), upper / (upper + lower));
  else
    snprintf(text, size, "k %s, alpha %s", show_k(wear, k, sizeof k),
             show_alpha(wear, alpha, sizeof alpha));
}

static void add_settings(luaL_Buffer *text, const arc_wear *wear) {
  const arc_wear_def *settings = arc_wear_definition(wear);
  const int rubs = settings->friction > 0 || settings->friction_function != NULL ||
                   settings->friction_series.count > 0;
  const int half_spaces = arc_model_has_maps(arc_model_definition(arc_wear_model(wear)));
  char line[600], motion[140], load[100], k_alpha[220], steps[40], increments[40];
  show_motion(wear, motion, sizeof motion);
  show_steps(settings, steps, sizeof steps);
  show_coefficients(wear, k_alpha, sizeof k_alpha);
  snprintf(line, sizeof line, "wear: %s, load %s\n  wears by  %s\n", motion,
           show_load(wear, load, sizeof load), k_alpha);
  luaL_addstring(text, line);
  add_bodies(text, wear);
  snprintf(line, sizeof line, "  settings  %s %s, %s, increments %s, %s%s%s\n",
           arc_procedure_names[arc_wear_procedure(wear)], arc_scheme_names[settings->scheme], steps,
           show_increments(wear, increments, sizeof increments),
           half_spaces ? "" : arc_geometry_names[settings->geometry], half_spaces ? "" : ", ",
           rubs                               ? "slip of each point by friction"
           : settings->slip == ARC_SLIP_TOTAL ? "total slip"
                                              : "rigid slip");
  luaL_addstring(text, line);
  add_others(text, settings);
}

/* Writes the position of the largest pressure as text, or "" if the pressure at the centre is as
 * large or no surfaces are available. */
static void show_peak(const arc_wear *wear, char *text, size_t size) {
  arc_error error = {0};
  arc_array *arrays = NULL;
  size_t count = 0;
  const arc_wear_record *record = arc_wear_last(wear);
  text[0] = '\0';
  if (!(record->p_max > record->p_center)) return;
  if (arc_wear_surfaces(wear, &arrays, &count, &error) != ARC_OK) return;
  peak_position(arrays, count, record->p_center, text, size);
  free(arrays);
}

static void add_state(luaL_Buffer *text, const arc_wear *wear) {
  const arc_wear_record *record = arc_wear_last(wear);
  const arc_model_def *model = arc_model_definition(arc_wear_model(wear));
  const char *upper = body_name(model, ARC_UPPER), *lower = body_name(model, ARC_LOWER);
  const int means = arc_wear_definition(wear)->track > 0 && !arc_model_has_maps(model);
  char line[800], partition[40] = "none yet", peak[60] = "", at[80], across[60] = "";
  if (record->update > 0 && isfinite(record->p_peak))
    snprintf(peak, sizeof peak, ", in a cycle %.2f", record->p_peak);
  if (isfinite(record->depth_partition))
    snprintf(partition, sizeof partition, "%.4f", record->depth_partition);
  if (arc_model_has_maps(model))
    snprintf(across, sizeof across, " along x, %.6g mm along z", record->half_width_z);
  show_peak(wear, at, sizeof at);
  snprintf(line, sizeof line,
           "  done      cycle %.6g of %.6g, distance %.6g of %.6g mm, %.0f update%s\n"
           "  pressure  centre %.2f, largest %.2f%s%s MPa\n"
           "  width     half %.6g mm%s\n"
           "  depth     %s %.4e mm, %s %.4e mm%s; alpha-tilde %s\n"
           "  volume    %s %.4e mm3, %s %.4e mm3, total %.4e mm3",
           record->cycle, arc_wear_cycles(wear), record->distance,
           arc_wear_definition(wear)->distance, record->update, record->update == 1 ? "" : "s",
           record->p_center, record->p_max, at, peak, record->half_width, across, upper,
           record->depth_cylinder, lower, record->depth_plate,
           means ? " (mean over its track)" : "", partition, upper, record->volume_cylinder, lower,
           record->volume_plate, record->volume_cylinder + record->volume_plate);
  luaL_addstring(text, line);
}

/* Adds the friction results of the last cycle if the run has friction. */
static void add_rubbing(luaL_Buffer *text, const arc_wear_record *record) {
  char line[200], slips[40] = "gross slip";
  if (record->update == 0 || !(record->largest_shear > 0)) return;
  if (record->gross == 0) snprintf(slips, sizeof slips, "sticks on %.4g mm", record->stick_width);
  snprintf(line, sizeof line,
           "\n  friction  force up to %.4g N, %s; energy %.4g N mm a cycle, %.4g N mm in total",
           record->largest_shear, slips, record->cycle_energy, record->energy);
  luaL_addstring(text, line);
}

int wear_tostring(lua_State *L) {
  const arc_wear *wear = wear_self(L, "wear");
  luaL_Buffer text;
  luaL_buffinit(L, &text);
  add_settings(&text, wear);
  add_state(&text, wear);
  add_rubbing(&text, arc_wear_last(wear));
  luaL_pushresult(&text);
  return 1;
}
