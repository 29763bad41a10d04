/* Kinds of pairs of bodies. A kind knows surfaces, contact and how they wear over a cycle; laws,
 * coefficients, steps and histories are the same for all (core/wear). Everything a run asks of its
 * bodies stands in this table. */
#ifndef PAIR_KIND_H
#define PAIR_KIND_H

#include "core/pair/cycle.h"

/* Runs that outgrow their sites. Verbs marked with a * may be NULL. */
typedef struct arc_growth {
  /* Whether a run cannot go on before it grows; says why. */
  int (*must_grow)(const arc_wear *w, arc_error *why);
  /* Whether a step failed because the run has outgrown its sites, and not because of its length. */
  int (*has_outgrown)(const arc_wear *w, arc_status why);
  /* Whether its bodies have room for what the definition needs. */
  int (*has_room)(const arc_wear *w);
  /* A copy of the run on more sites, or on those of a mesh; *result NULL on failure. */
  arc_status (*grow)(const arc_wear *w, arc_status why, const arc_callbacks *callbacks,
                     arc_wear **result, arc_error *error);
  arc_status (*remesh)(const arc_wear *w, const arc_mesh_def *mesh, const arc_callbacks *callbacks,
                       arc_wear **result, arc_error *error);
  /* * A new run like one just created, on sites fine enough for what its cycles need; *finer NULL:
   * those it has are, or somebody chose them. */
  arc_status (*resolve)(arc_wear *w, arc_wear **finer, arc_error *error);
  /* Reports growth, a wanted mesh, and a step that failed although the run could grow. */
  void (*report)(const arc_wear *before, const arc_wear *now, const arc_callbacks *callbacks);
  void (*report_mesh)(const arc_wear *before, const arc_wear *now, const arc_callbacks *callbacks);
  arc_status (*refuse)(const arc_wear *w, const arc_error *why, const arc_error *trouble,
                       arc_error *error);
} arc_growth;

/* Verbs marked with a * may be NULL. */
typedef struct arc_kind {
  const char *name;

  /* --- models --- */

  /* Whether `build` takes a definition, but for the memory; ARC_ARGUMENT, ARC_GEOMETRY. */
  arc_status (*check_model)(const arc_model_def *def, arc_error *error);
  /* A model with one reference, whose handle stands first (pair/model.h). */
  arc_status (*build)(const arc_model_def *def, const arc_callbacks *callbacks, arc_model **model,
                      arc_error *error);
  void (*end_model)(arc_model *model);
  size_t (*model_bytes)(const arc_model *model);
  const arc_mesh *(*mesh)(const arc_model *model, arc_body body); /* NULL: it has none */

  int maps; /* surfaces are maps over x and z, whose cells each contact and run finds */

  /* --- definitions, on the definition of a model --- */

  /* * What a run does that is not told otherwise; NULL: what the settings say. */
  void (*usual)(arc_wear_def *def);

  /* What goes together on such bodies, beyond the ranges of settings; ARC_ARGUMENT. */
  arc_status (*check)(const arc_wear_def *def, const arc_model_def *model, arc_error *error);
  wear_manner (*manner)(const arc_wear_def *def, const arc_model_def *model);
  /* * Increments of a full cycle of the plain stroke; NULL: 100 where they are "auto". */
  int (*increments)(const arc_wear_def *def, const arc_model_def *model);
  /* * In how many increments a loading is simulated, at least one between two of its points; into
   * parts [count] (or NULL) those that end at each point. */
  double (*parts)(const arc_wear_def *def, const arc_model_def *model, const arc_loading *loading,
                  double *parts);
  /* * The longest increment [mm] that follows the contact under a load [N]. */
  double (*reach)(const arc_model_def *model, double load);

  /* --- runs --- */

  /* Sets sites and `own` of a run with definition, surfaces and blocks; ARC_MEMORY leaves what
   * `end` takes. */
  arc_status (*begin)(arc_wear *w);
  void (*end)(arc_wear *w);
  size_t (*bytes)(const arc_wear *w); /* * with surfaces and tangents */
  /* * Whether the contact can be everywhere on its way; ARC_ZONE. */
  arc_status (*check_reach)(arc_wear *w, arc_error *error);
  /* * Warns of what speaks against the definition; `unworn`: and of too coarse sites. */
  void (*warn)(const arc_wear *w, int unworn, const arc_callbacks *callbacks);
  /* * Warns of what the last update showed its sites to be too coarse for; returns whether it did.
   */
  int (*warn_coarse)(const arc_wear *w, const arc_callbacks *callbacks);

  /* --- surfaces --- */

  /* Surfaces to start from: unworn, or a copy of `from` of the same model. */
  arc_status (*surfaces)(arc_model *model, const arc_wear_def *def, const arc_shape *from,
                         arc_shape **shape, arc_error *error);
  /* * Unworn ones for single contacts, see arc_shape_create. */
  arc_status (*unworn)(arc_model *model, arc_geometry geometry, double refresh, arc_shape **shape,
                       arc_error *error);
  arc_status (*copy)(const arc_shape *shape, arc_shape **copy, arc_error *error);
  void (*discard)(arc_shape **shape);
  wear_sites (*sites)(const arc_shape *shape, arc_body body);
  /* What site i of a body stands for: a length along x [mm], or an area [mm2]. */
  double (*area)(const arc_shape *shape, arc_body body, int i);
  /* Along x through the middle. */
  arc_profile (*profile)(const arc_shape *shape, arc_body body);
  double (*deepest)(const arc_shape *shape, arc_body body); /* [mm] */
  /* * Depths [n] due at the largest coefficient of layers become those at their own. */
  void (*through_layers)(const arc_shape *shape, double *depth);
  /* Adds to volumes, and depths of tracks, what depths take from a shape before it is worn. */
  void (*add_volumes)(const arc_wear *w, const arc_shape *shape, const wear_depths *depth,
                      arc_wear_record *record);
  /* Wears a shape, and adds the volumes; depths become what layers leave of them. On failure the
   * shape is to be given up. */
  arc_status (*wear)(const arc_wear *w, arc_shape *shape, wear_depths *depth,
                     arc_wear_record *record, arc_error *error);
  /* Reads the reference configuration (x = 0, nominal load) of a shape into the record, which holds
   * the rest. */
  arc_status (*measure)(arc_wear *w, const arc_shape *shape, arc_wear_record *record,
                        arc_error *error);

  /* --- the cycle --- */

  /* The wear of a window. */
  arc_status (*rate)(arc_wear *w, const wear_window *window, wear_watch *watch, wear_rate *rate,
                     arc_error *error);
  /* * How far pressures jump between neighbouring sites, over their mean [-], on the surfaces that
   * were measured last into the record. */
  double (*ripple)(const arc_wear *w, const arc_shape *shape, const arc_wear_record *measured);
  /* * The fretting loop of a whole cycle. */
  arc_status (*loop)(arc_wear *w, const wear_window *window, wear_watch *watch, arc_loop **loop,
                     arc_error *error);
  wear_tangent *(*tangent)(const arc_wear *w); /* NULL: out of memory */
  void (*end_tangent)(wear_tangent **tangent);
  /* Largest eigenvalue [1/cycle] of k times a tangent. */
  double (*eigenvalue)(const arc_wear *w, const double k[ARC_BODIES], wear_tangent *tangent);

  /* An implicit step: * `begin_stages` takes memory (ARC_MEMORY: `end_stages` is still to be
   * called), `start` gives k times the rate at z = 0, `stage` solves from the present z, whose rate
   * is given, and gives that of the solution, with z = known + h rate to the bit
   * (ARC_NOT_CONVERGED: try a shorter step). `error` filters stiff ripples out of the estimated
   * errors of depths, and returns the share of the load, or of the largest pressure, that they
   * shift; negative: it cannot tell. `end_stages` gives a step's even wear, peak and normal
   * force, where depths are not NULL. */
  arc_status (*begin_stages)(wear_stage *s);
  arc_status (*start)(wear_stage *s, double *rate);
  arc_status (*stage)(wear_stage *s, double h, double *rate);
  double (*error)(wear_stage *s, double h, double *defect);
  void (*end_stages)(wear_stage *s, double cycles, wear_depths *depth);

  /* --- how far steps go --- */

  /* Depth [mm] of wear that changes the contact as much as its elasticity does. */
  double (*natural_depth)(const arc_wear *w);
  /* * Integral of k over the distance [mm3/N] that takes `depth` [mm] off a lower body that wears
   * evenly, and that by which layers, even ones or under `scars` too, change the contact by all
   * that an update may; NULL where there are none. */
  double (*even_dose)(const arc_wear *w, double depth);
  double (*layer_dose)(const arc_wear *w, int scars);
  /* * Wear coefficient of the layer that lies open where a body is worn deepest, over the largest
   * of that body; NULL: 1. */
  double (*open_share)(const arc_wear *w, arc_body body);

  const arc_growth *growth; /* NULL: sites do not grow */

  /* --- one contact --- */

  /* * All or none: see arc_contact_solve, arc_contact_move, arc_contact_surfaces. */
  arc_status (*solve)(const arc_shape *shape, const arc_contact_def *def,
                      const arc_callbacks *callbacks, arc_contact **contact, arc_error *error);
  arc_status (*move)(const arc_contact *from, const arc_motion_def *motion,
                     const arc_callbacks *callbacks, arc_contact **contact, arc_error *error);
  void (*end_contact)(arc_contact *contact);
  size_t (*contact_bytes)(const arc_contact *contact);
  arc_status (*show_contact)(const arc_contact *contact, arc_array **surfaces, size_t *count,
                             arc_error *error);

  /* --- what is read --- */

  /* * */
  arc_status (*contact)(const arc_wear *w, arc_contact **contact, arc_error *error);
  /* What is shown of the present surfaces, as arc_wear_surfaces; those of a body together. */
  arc_status (*show)(const arc_wear *w, arc_array **surfaces, size_t *count, arc_error *error);
  /* All that surfaces need to go on to the same bits, with update and distance 0: one block to be
   * freed with free(), NULL: out of memory; and back from what may be anybody's numbers: errors as
   * of arc_wear_resume. */
  arc_array *(*save)(const arc_shape *shape, size_t *count);
  arc_status (*load)(arc_model *model, const arc_wear_def *def, const arc_array *state,
                     size_t count, arc_shape **shape, arc_error *error);
  double (*roughness)(const arc_wear *w, arc_body body);
  /* * Whether surfaces and contact are sound; ARC_NUMERIC. */
  arc_status (*validate)(const arc_wear *w, arc_error *error);
} arc_kind;

/* The kind that a model's definition is of. */
const arc_kind *arc_kind_of(const arc_model_def *def);

#endif
