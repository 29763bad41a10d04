/* Declares the table of functions that a kind of pair of bodies implements: for surfaces, contact,
 * and the wear of a cycle. Wear laws, coefficients, steps and histories are common to all kinds
 * (core/wear). A run uses its bodies only through this table. */
#ifndef PAIR_KIND_H
#define PAIR_KIND_H

#include "core/pair/cycle.h"

/* Functions for runs whose contact becomes larger than the part of the surface that has sites.
 * Optional functions may be NULL. */
typedef struct arc_growth {
  /* Returns true if a run must grow before the next step, and sets *why to the reason. */
  int (*must_grow)(const arc_wear *w, arc_error *why);
  /* Returns true if a step failed with the status `why` because the contact has outgrown the sites,
   * and not because the step was too long. */
  int (*has_outgrown)(const arc_wear *w, arc_status why);
  /* Returns true if the bodies are large enough for the sites that the definition needs. */
  int (*can_grow)(const arc_wear *w);
  /* `grow` copies a run to a larger surface with more sites, `remesh` to the sites of a mesh with
   * other settings. On failure *result is NULL. */
  arc_status (*grow)(const arc_wear *w, arc_status why, const arc_callbacks *callbacks,
                     arc_wear **result, arc_error *error);
  arc_status (*remesh)(const arc_wear *w, const arc_mesh_def *mesh, const arc_callbacks *callbacks,
                       arc_wear **result, arc_error *error);
  /* Optional: sets *finer to a copy of a new run with sites that are small enough for its cycles.
   * Sets *finer to NULL if the sites already are, or if the user set their size. */
  arc_status (*resolve)(arc_wear *w, arc_wear **finer, arc_error *error);
  /* `report` reports that a run has grown, and `report_mesh` that the user changed the mesh. If a
   * step of a run that can grow has failed, `refuse` combines the errors of the step (`why`) and of
   * the growth (`trouble`) in one error. */
  void (*report)(const arc_wear *before, const arc_wear *now, const arc_callbacks *callbacks);
  void (*report_mesh)(const arc_wear *before, const arc_wear *now, const arc_callbacks *callbacks);
  arc_status (*refuse)(const arc_wear *w, const arc_error *why, const arc_error *trouble,
                       arc_error *error);
} arc_growth;

/* Functions of a kind. Optional functions may be NULL. */
typedef struct arc_kind {
  const char *name;

  /* --- models --------------------------------------------------------------------------------- */

  /* Checks a definition before `build`. Errors: ARC_ARGUMENT, ARC_GEOMETRY. */
  arc_status (*check_model)(const arc_model_def *def, arc_error *error);
  /* Builds a model with a reference count of 1. The first member of the model is its handle
   * (pair/model.h). */
  arc_status (*build)(const arc_model_def *def, const arc_callbacks *callbacks, arc_model **model,
                      arc_error *error);
  void (*end_model)(arc_model *model);
  size_t (*model_bytes)(const arc_model *model);
  const arc_mesh *(*mesh)(
      const arc_model *model,
      arc_body body); /* returns the mesh of a body; NULL: the kind has no meshes */

  int elastic; /* true if displacements follow from the moduli of the materials */
  int maps; /* true if surfaces are height maps over x and z. Each contact and run then chooses its
               own cells. */

  /* --- definitions, on the definition of a model ---------------------------------------------- */

  /* Returns true if implicit steps with error control are better for a run than explicit steps.
   * NULL: they never are. */
  int (*prefers_implicit)(const arc_wear_def *def);

  /* Checks combinations of settings of a run. Errors: ARC_ARGUMENT. */
  arc_status (*check)(const arc_wear_def *def, const arc_model_def *model, arc_error *error);
  wear_manner (*manner)(const arc_wear_def *def, const arc_model_def *model);
  /* Optional: returns the number of increments in a full cycle of a run without a loading. NULL:
   * "auto" is 100 increments. */
  int (*increments)(const arc_wear_def *def, const arc_model_def *model);
  /* Optional: returns the number of increments of a loading, at least one between two points.
   * Unless `parts` [count] is NULL, parts[i] is set to the number of increments from point i - 1 to
   * point i. */
  double (*parts)(const arc_wear_def *def, const arc_model_def *model, const arc_loading *loading,
                  double *parts);
  /* Optional: returns the longest accurate increment [mm] under a load [N]. */
  double (*reach)(const arc_model_def *model, double load);

  /* --- runs ----------------------------------------------------------------------------------- */

  /* Sets the number of sites of a run and its member `own` (data of the kind). It is called when
   * definition, surfaces and blocks of the run are complete. On ARC_MEMORY `end` must be called. */
  arc_status (*begin)(arc_wear *w);
  void (*end)(arc_wear *w);
  size_t (*bytes)(const arc_wear *w); /* Optional: returns the memory [bytes] that surfaces,
                                         tangents and data of the kind need */
  /* Optional: checks that the zones contain the contact over the whole motion. Errors: ARC_ZONE. */
  arc_status (*check_reach)(arc_wear *w, arc_error *error);
  /* Optional: warns about the definition and, if `unworn` is true, about sites that are too
   * coarse. */
  void (*warn)(const arc_wear *w, int unworn, const arc_callbacks *callbacks);
  /* Optional: warns of limits of the kind that the last update has crossed, for example if sites
   * are too coarse. `given` is the sum of the numbers (powers of 2) of the warnings that the run
   * has given; each is given once. Returns the new sum. */
  int (*warn_late)(const arc_wear *w, int given, const arc_callbacks *callbacks);

  /* --- surfaces ------------------------------------------------------------------------------- */

  /* Creates the initial surfaces of a run: a copy of `from`, which belongs to the same model, or
   * unworn surfaces if `from` is NULL. */
  arc_status (*surfaces)(arc_model *model, const arc_wear_def *def, const arc_shape *from,
                         arc_shape **shape, arc_error *error);
  /* Optional: creates unworn surfaces for single contacts (arc_shape_create). */
  arc_status (*unworn)(arc_model *model, arc_geometry geometry, double refresh, arc_shape **shape,
                       arc_error *error);
  arc_status (*copy)(const arc_shape *shape, arc_shape **copy, arc_error *error);
  void (*discard)(arc_shape **shape);
  wear_sites (*sites)(const arc_shape *shape, arc_body body);
  /* Returns the size of site i of a body: a length along x [mm], or an area [mm2]. */
  double (*area)(const arc_shape *shape, arc_body body, int i);
  /* Returns the profile of the surface along x, in 3-D at z = 0. */
  arc_profile (*profile)(const arc_shape *shape, arc_body body);
  double (*deepest)(const arc_shape *shape, arc_body body); /* returns the largest depth [mm] */
  /* Optional: converts depths [n], computed with the largest wear coefficient, to depths with the
   * coefficients of the layers. */
  void (*through_layers)(const arc_shape *shape, double *depth);
  /* Adds the wear volumes of the depths, and the depths of tracks, to the record. It is called
   * before the depths are applied to the shape. */
  void (*add_volumes)(const arc_wear *w, const arc_shape *shape, const wear_depths *depth,
                      arc_wear_record *record);
  /* Optional: predicts, for the middle of an update, data of a shape that depend on its wear, such
   * as the compliance. `depth` contains the wear up to the middle. */
  arc_status (*look_ahead)(const arc_wear *w, arc_shape *shape, wear_depths *depth,
                           arc_error *error);
  /* Applies the wear depths to a shape, and adds their volumes to the record. Depths through layers
   * are converted by the wear coefficients of the layers. On failure the shape must be
   * destroyed. */
  arc_status (*wear)(const arc_wear *w, arc_shape *shape, wear_depths *depth,
                     arc_wear_record *record, arc_error *error);
  /* Solves the contact of a shape in the reference configuration (x = 0, nominal load) and writes
   * its results to the record. */
  arc_status (*measure)(arc_wear *w, const arc_shape *shape, arc_wear_record *record,
                        arc_error *error);

  /* --- the cycle ------------------------------------------------------------------------------ */

  /* Computes the wear rates of a window. */
  arc_status (*rate)(arc_wear *w, const wear_window *window, wear_progress *progress,
                     wear_rate *rate, arc_error *error);
  /* Optional: for the surfaces of the record `measured`, returns the largest difference between the
   * pressure at a site and the mean pressure of its two neighbours, divided by the mean pressure.
   */
  double (*ripple)(const arc_wear *w, const arc_shape *shape, const arc_wear_record *measured);
  /* Optional: computes the fretting loop of a cycle. */
  arc_status (*loop)(arc_wear *w, const wear_window *window, wear_progress *progress,
                     arc_loop **loop, arc_error *error);
  wear_tangent *(*tangent)(const arc_wear *w); /* creates a tangent; NULL: out of memory */
  void (*end_tangent)(wear_tangent **tangent);
  /* Returns the largest eigenvalue [1/cycle] of k times a tangent, or, if it cannot be computed or
   * the user stops the computation, an upper bound of it. */
  double (*eigenvalue)(const arc_wear *w, const double k[ARC_BODIES], wear_tangent *tangent,
                       const arc_callbacks *callbacks);

  /* Functions of an implicit step. `begin_stages` allocates memory (after ARC_MEMORY `end_stages`
   * must still be called). `start` computes k times the rate at z = 0. `stage` starts from the
   * present z and its rate, and writes z and the rate of the solution, for which z = known + h rate
   * is exact. If it returns ARC_NOT_CONVERGED, a shorter step may succeed. `error` filters stiff
   * ripples out of the estimated errors of the depths. It returns the effect of these errors on the
   * contact: the fraction of the load that they shift, or the change of pressure divided by the
   * largest pressure; a negative value means that the effect is unknown. Unless `depth` is NULL,
   * `end_stages` writes the uniform wear, largest pressure and normal force of a step. */
  arc_status (*begin_stages)(wear_stage *s);
  arc_status (*start)(wear_stage *s, double *rate);
  arc_status (*stage)(wear_stage *s, double h, double *rate);
  double (*error)(wear_stage *s, double h, double *defect);
  void (*end_stages)(wear_stage *s, double cycles, wear_depths *depth);

  /* --- lengths of steps */

  /* Returns the depth of wear [mm] that changes the contact as much as the elastic displacement
   * does. */
  double (*natural_depth)(const arc_wear *w);
  /* Optional: limits of the integral of k over the distance [mm3/N] in one update. At the limit
   * even_k_integral, a uniformly worn lower body has lost `depth` [mm]. At the limit
   * layer_k_integral, the wear of layers has changed the contact as much as allowed in one update;
   * it includes uniformly worn layers and, if `scars` is true, layers under scars. NULL: no such
   * limit. */
  double (*even_k_integral)(const arc_wear *w, double depth);
  double (*layer_k_integral)(const arc_wear *w, int scars);
  /* Optional: returns the wear coefficient at the deepest point of a body, divided by the largest
   * coefficient of the body. They differ if the exposed layer wears more slowly. NULL: 1. */
  double (*open_share)(const arc_wear *w, arc_body body);

  const arc_growth *growth; /* NULL: the number of sites is constant */

  /* --- one contact ---------------------------------------------------------------------------- */

  /* Functions of single contacts (arc_contact_solve, arc_contact_move, arc_contact_surfaces). A
   * kind has all of them or none. */
  arc_status (*solve)(const arc_shape *shape, const arc_contact_def *def,
                      const arc_callbacks *callbacks, arc_contact **contact, arc_error *error);
  arc_status (*move)(const arc_contact *from, const arc_motion_def *motion,
                     const arc_callbacks *callbacks, arc_contact **contact, arc_error *error);
  void (*end_contact)(arc_contact *contact);
  size_t (*contact_bytes)(const arc_contact *contact);
  arc_status (*show_contact)(const arc_contact *contact, arc_array **surfaces, size_t *count,
                             arc_error *error);

  /* --- results */

  /* Optional: creates the contact of the present state. */
  arc_status (*contact)(const arc_wear *w, arc_contact **contact, arc_error *error);
  /* Returns the arrays of arc_wear_surfaces for the present surfaces, body by body. */
  arc_status (*show)(const arc_wear *w, arc_array **surfaces, size_t *count, arc_error *error);
  /* `save` returns the complete state of surfaces, with update and distance 0, in one block, which
   * the caller frees with free(). It returns NULL if out of memory. `load` restores surfaces from a
   * state, whose numbers it checks. Errors: those of arc_wear_resume. */
  arc_array *(*save)(const arc_shape *shape, size_t *count);
  arc_status (*load)(arc_model *model, const arc_wear_def *def, const arc_array *state,
                     size_t count, arc_shape **shape, arc_error *error);
  double (*roughness)(const arc_wear *w, arc_body body);
  /* Optional: checks surfaces and contact. Errors: ARC_NUMERIC. */
  arc_status (*validate)(const arc_wear *w, arc_error *error);
} arc_kind;

/* Returns the kind of pair of models with a geometry. */
const arc_kind *arc_kind_of(arc_space geometry);

#endif
