/* Contact and wear of two meshed bodies in plane models, at every point of a block of loading. */
#ifndef PLANE_CYCLE_H
#define PLANE_CYCLE_H

#include "core/elastic/contact_estimate.h"
#include "core/friction/friction.h"
#include "core/wear/run.h"

/* Solution at one point of the path of a cycle. Each array has one entry per surface node of the
 * body. */
typedef struct wear_point {
  double *p[ARC_BODIES]; /* pressure [MPa] */
  double *q[ARC_BODIES]; /* wear rate divided by the wear coefficient: pressure times the factor
                            of the wear law and the local factor [MPa] */
  double *u[ARC_BODIES]; /* elastic displacement of the surface along x [mm] */
  double *f[ARC_BODIES]; /* local factor */
} wear_point;

/* Present block of loading, its contact problems, and the last two solved points. Point i of the
 * block is stored in point[i % 2]. */
typedef struct wear_path {
  const wear_block *block; /* NULL before the first block */
  int problems;
  contact_problem *problem; /* [problems] */
  int nodes;                /* number of surface nodes of both bodies */
  wear_point point[2];
  wear_point image[2]; /* mirror images of both points, used for asymmetric local factors */

  /* members for runs with friction */
  int has_friction;
  tangential_compliance *compliance; /* [problems] */
  friction_workspace workspace;
  friction_state state;
} wear_path;

/* Data of a run in the plane. */
typedef struct plane_cycle {
  wear_path path;
  contact_problem reference; /* contact problem with the plate at x = 0 under the nominal load */
  double *slip;              /* workspace of 4 values per surface node, for the slip of an
                                increment or for mirror images */
  double *down; /* vertical lowering of the surface at each node, divided by the depth of wear along
                   the normal, see arc_shape_downward */
  double *width;         /* width of the surface cell of each node in the previous window [mm] */
  double *plate, *below; /* wear depths at the plate's nodes, and these depths interpolated to the
                            cylinder's nodes [mm] */
} plane_cycle;

static inline plane_cycle *plane_of(const arc_wear *w) {
  return w->own;
}
static inline wear_path *path_of(const arc_wear *w) {
  return &plane_of(w)->path;
}

/* Negative Jacobian of the wear rate with respect to depths along y, at constant compliance.
 * Neighbouring points with nearly the same contact form a group, which uses the contact solution of
 * one point. This is accurate enough for Newton's method. */
struct wear_tangent {
  int nc, np;
  double width;  /* range of the plate positions in a group [mm]; 0: no groups */
  double *value; /* square matrix over all surface nodes, cylinder first, column-major */
  struct jacobian_group *group;
};

/* --- path.c ----------------------------------------------------------------------------------- */
/* Allocates the arrays of the points. Error: ARC_MEMORY; nothing has to be freed then. */
arc_status arc_path_create(wear_path *path, const arc_model *model, int has_friction);
void arc_path_free(wear_path *path);
/* Makes a block the present block and creates its contact problems. Does nothing if it is the
 * present block already. Error: ARC_MEMORY; there is no present block then. */
arc_status arc_path_enter(wear_path *path, const wear_block *block, const arc_model *model,
                          arc_error *error);
/* Sets all values of a point to zero, which is the state of separated bodies. */
void arc_path_clear(const wear_path *path, wear_point *point);
void arc_path_copy(const wear_path *path, const wear_point *from, wear_point *to);

/* --- rate.c ----------------------------------------------------------------------------------- */
/* Computes the wear of a window, which is a cycle or a part of a cycle. */
arc_status arc_wear_evaluate(arc_wear *w, const wear_window *window, wear_progress *progress,
                             wear_rate *rate, arc_error *error);
/* Returns the total sliding distance of a window [mm]. */
double arc_wear_window_sliding(const arc_wear *w, const wear_window *window);
/* Returns the wear rate at node i of an inclined surface, divided by the wear rate of a
 * horizontal surface under the same pressure. */
double arc_wear_slope_share(const arc_wear *w, const wear_window *window, arc_body b, int i);
/* Solves only the contact at point window->first, to check that the contact lies within the
 * zones. */
arc_status arc_wear_probe(arc_wear *w, const wear_window *window, arc_error *error);

/* Updates the contact problem of point `at` of the present block to the shape and the depths of
 * a window. */
arc_status arc_wear_prepare(arc_wear *w, const wear_window *window, int at, arc_error *error);
/* Computes the pressures and wear rates of a point from its solved contact problem `p`. */
arc_status arc_wear_take(arc_wear *w, const wear_window *window, const contact_problem *p,
                         wear_point *point, arc_error *error);

/* Computes the local factors at a point and multiplies the wear rates q by them. */
arc_status arc_wear_find_local_factors(const arc_wear *w, const arc_wear_record *state,
                                       wear_point *point, arc_error *error);

/* Adds to the rates of both bodies the wear due to `work`, the work per area at the cylinder's
 * nodes [MPa mm]. The coupling (Eq. 15 of the paper on alpha) transfers the same work to the plate.
 * The work is multiplied by the local factors of `point`. `on` is workspace for one value per plate
 * node. */
void arc_wear_share(const arc_wear *w, const contact_problem *p, const wear_point *point,
                    const double *work, double *on, wear_rate *rate);

/* --- mirror.c --------------------------------------------------------------------------------- */
/* Returns true if the wear of the second half of a window can be computed as the mirror image of
 * the first half. */
int arc_wear_is_mirrored(const arc_wear *w, const wear_window *window);
/* Returns true if the contact of a window is at rest at x = 0, between exactly symmetric surfaces
 * under a load along y. Its wear is symmetric up to rounding errors. */
int arc_wear_rests_mirrored(const arc_wear *w, const wear_window *window);
/* Returns true if a window has local factors, which may make the wear of a symmetric contact
 * asymmetric. */
int arc_wear_has_local_factors(const arc_wear *w, const wear_window *window);
/* Computes the mirror image of point `at`, the last solved point. `law` contains the wear rate
 * of the point without local factors. */
arc_status arc_wear_reflect(arc_wear *w, const wear_window *window, int at, const wear_point *law,
                            arc_error *error);
/* Replaces the depths or wear rates of all nodes by the mean of them and their mirror image about
 * x = 0. */
void arc_wear_symmetrise(const arc_wear *w, double *depth);
/* Extends the wear and the Jacobian of the first half of a window to the whole window. `images`
 * is the wear of the second half; NULL: it is the mirror image of the first half. */
void arc_wear_add_mirror(const arc_wear *w, const wear_window *window, const wear_rate *images,
                         wear_rate *rate);

/* --- fretting.c ------------------------------------------------------------------------------- */
/* Computes the wear of a periodic cycle with friction. */
arc_status arc_wear_fret(arc_wear *w, const wear_window *window, wear_progress *progress,
                         wear_rate *rate, arc_error *error);

/* Computes the fretting loop of a periodic cycle: the tangential force as a function of the
 * position. */
arc_status arc_wear_fret_loop(arc_wear *w, const wear_window *window, wear_progress *progress,
                              arc_loop **loop, arc_error *error);

/* --- slip.c ----------------------------------------------------------------------------------- */
/* Adds the wear due to the work of the increment that ends at point `at`. The slip includes the
 * elastic displacements. */
void arc_wear_add_work(const arc_wear *w, int at, wear_rate *rate);

/* --- jacobian.c ------------------------------------------------------------------------------- */
wear_tangent *arc_tangent_create(const arc_wear *w);
void arc_tangent_free(wear_tangent **tangent);
size_t arc_tangent_bytes(const arc_wear *w);
double arc_tangent_eigenvalue(const arc_wear *w, const double k[ARC_BODIES], wear_tangent *tangent,
                              const arc_callbacks *callbacks);
void arc_wear_jacobian_clear(wear_tangent *j);
/* Adds to the Jacobian of the window the Jacobian of the wear at point `at`, the last solved point.
 * Points must be added in order. `share` is the largest sliding distance of a node [mm].
 * sliding[body] contains the sliding distance of each node [mm]; NULL: all nodes slide by `share`.
 */
void arc_wear_jacobian_add(const arc_wear *w, const wear_window *window, int at, double share,
                           double *const sliding[ARC_BODIES]);
/* Completes the Jacobian after the last point of a window. */
void arc_wear_jacobian_finish(wear_tangent *j);

/* --- plane_definition.c ----------------------------------------------------------------------- */
arc_procedure arc_wear_choose_procedure(const arc_wear_def *def, const arc_model_def *model);
int arc_wear_over_plate(const arc_wear_def *def, const arc_model_def *model);
/* Returns true if implicit steps are better. With friction explicit steps need half the time, with
 * elastic slip a third, and histories make a step in every increment. With local factors that jump
 * with the pressure the depths of implicit steps had errors of up to 4 %. */
int arc_plane_prefers_implicit(const arc_wear_def *def);
wear_manner arc_plane_manner(const arc_wear_def *def, const arc_model_def *model);
arc_status arc_plane_check(const arc_wear_def *def, const arc_model_def *model, arc_error *error);

/* --- increments.c ----------------------------------------------------------------------------- */
double arc_loading_increments(const arc_wear_def *def, const arc_model_def *model,
                              const arc_loading *from, double *parts);
/* Warns if the increments chosen by the user are too long for the width of the contact. */
void arc_plane_warn_leaps(const arc_wear *w, const arc_callbacks *callbacks);

/* --- revolved.c ------------------------------------------------------------------------------- */
/* Checks the settings of a run with bodies of revolution. Error: ARC_ARGUMENT. */
arc_status arc_wear_check_revolved(const arc_wear_def *def, const arc_model_def *model,
                                   arc_error *error);
/* Returns the half width [mm] of a flat scar of a given volume [mm3] on a cylinder or ball of a
 * given radius [mm]. */
double arc_wear_scar(const arc_wear_def *def, const arc_model_def *model, double radius,
                     double volume);
/* Returns the slip at surface node i divided by the slip at the reference radius of a spin.
 * Returns 1 for runs without spin. */
double arc_wear_spin_share(const arc_wear *w, const shape_side *side, int i);

/* --- measures.c ------------------------------------------------------------------------------- */
/* Returns true if the contact never changes, because only the plate wears and the stroke covers
 * the whole plate. */
int arc_plane_stays_as_it_is(const arc_wear_def *def, const arc_model_def *model);
double arc_plane_ripple(const arc_wear *w, const arc_shape *shape, const arc_wear_record *measured);
double arc_plane_roughness(const arc_wear *w, arc_body body);
/* Returns the largest wear depth of the plate [mm]; for a track, the mean depth over the contact
 * width. `record` must contain the plate's worn volume and the half width. */
double arc_plane_depth(const arc_wear *w, const arc_shape *shape, const arc_wear_record *record);
/* Returns the length of the uniformly worn surface [mm]: the width of the plate or, with a track,
 * the length of the track. */
double arc_plane_even_width(const arc_wear *w);
arc_status arc_plane_measure(arc_wear *w, const arc_shape *shape, arc_wear_record *record,
                             arc_error *error);

/* --- wearing.c -------------------------------------------------------------------------------- */
void arc_plane_add_volumes(const arc_wear *w, const arc_shape *shape, const wear_depths *depth,
                           arc_wear_record *record);
arc_status arc_plane_look_ahead(const arc_wear *w, arc_shape *shape, wear_depths *depth,
                                arc_error *error);
arc_status arc_plane_wear(const arc_wear *w, arc_shape *shape, wear_depths *depth,
                          arc_wear_record *record, arc_error *error);
double arc_plane_natural_depth(const arc_wear *w);
double arc_plane_even_k_integral(const arc_wear *w, double depth);
double arc_plane_layer_k_integral(const arc_wear *w, int scars);
double arc_plane_open_share(const arc_wear *w, arc_body body);

/* --- plane_surfaces.c ------------------------------------------------------------------------- */
arc_status arc_plane_show(const arc_wear *w, arc_array **surfaces, size_t *count, arc_error *error);
arc_array *arc_plane_save(const arc_shape *shape, size_t *count);
arc_status arc_plane_load(arc_model *model, const arc_wear_def *def, const arc_array *state,
                          size_t count, arc_shape **shape, arc_error *error);

/* --- validate_plane.c ------------------------------------------------------------------------- */
arc_status arc_plane_validate(const arc_wear *w, arc_error *error);

/* --- remesh.c --------------------------------------------------------------------------------- */
/* Returns true if a step that failed with the error `why` can succeed on a larger mesh: the contact
 * has left the meshed zone (ARC_ZONE), or the wear is too deep for the wear box (ARC_GEOMETRY). */
int arc_wear_has_outgrown(const arc_wear *w, arc_status why);

/* Returns the number of rows that the wear box needs to contain all uniformly worn layers. Returns
 * 0 if the present box contains them. */
int arc_wear_layer_rows(const arc_wear *w);

/* Returns the smallest width [mm] of the layers that are exposed on each side of a scar that has
 * worn through them and that wear more slowly than the material below. They carry pressures several
 * times higher than the centre. Returns INFINITY if there is no such layer. */
double arc_wear_exposed_width(const arc_wear *w);

/* Returns true if the mean pressure is close to the centre pressure, as in a contact that has worn
 * flat. In Hertz' contacts their ratio is 0.785 in the plane and 0.667 for balls. Returns 0 for
 * rings. */
int arc_wear_is_uniform(const arc_wear *w);

/* Returns true if exposed layers are too narrow for the elements of an automatic mesh. */
int arc_wear_must_refine(const arc_wear *w);

/* Returns true if both bodies are wide enough for the zones that the run needs. */
int arc_wear_can_grow(const arc_wear *w);

/* Copies the run to larger meshes. Errors: all errors of arc_model_build; `why` if larger meshes
 * are impossible. After an error *result is NULL. */
arc_status arc_wear_grow(const arc_wear *w, arc_status why, const arc_callbacks *callbacks,
                         arc_wear **result, arc_error *error);

/* Copies the run to a mesh that the user chose with arc_wear_set. Errors: all errors of
 * arc_model_build; ARC_ARGUMENT for imported meshes. */
arc_status arc_wear_remesh(const arc_wear *w, const arc_mesh_def *mesh,
                           const arc_callbacks *callbacks, arc_wear **result, arc_error *error);

/* Warns that a run has new meshes. `why` is the text of the reason. */
void arc_wear_report_meshes(const arc_wear *before, const arc_wear *now, const char *why,
                            const arc_callbacks *callbacks);

/* Warns that a run has larger meshes. A change to coarser elements is not reported. */
void arc_wear_report_growth(const arc_wear *before, const arc_wear *now,
                            const arc_callbacks *callbacks);

/* Reports the error `why` of a failed step. If the contact left the mesh, the message also states
 * why the mesh was not enlarged. The reason is the error `trouble`, unless it equals `why`. If
 * `trouble` is empty, the step was too long, and the message includes the required zones. */
arc_status arc_wear_refuse(const arc_wear *w, const arc_error *why, const arc_error *trouble,
                           arc_error *error);

/* --- rims.c ----------------------------------------------------------------------------------- */
/* Sets *finer to a copy of a new run on finer meshes, which resolve its slip zones. Sets *finer
 * to NULL if the present meshes resolve the zones, if the user chose the sizes, or without
 * friction. */
arc_status arc_wear_resolve(arc_wear *w, arc_wear **finer, arc_error *error);
/* Returns the largest element size [mm] that resolves the slip zones of the last update. Returns
 * INFINITY without slip zones. */
double arc_wear_rim_size(const arc_wear *w);
/* Returns the smallest automatic element size [mm] in a zone of a given width [mm]. */
double arc_wear_least_size(double width);

/* --- layers.c --------------------------------------------------------------------------------- */
/* Returns the wear depth [mm] of an update that begins at depth `h` of node i, computed with the
 * wear coefficients of the layers. `due` is the wear depth [mm] for the largest wear coefficient.
 */
double arc_wear_through_layers(const arc_shape *shape, arc_body body, int i, double h, double due);

/* Applies arc_wear_through_layers to the depths of all nodes of both surfaces, cylinder first. */
void arc_wear_into_layers(const arc_shape *shape, double *depth);
/* Returns the wear coefficient at node i after `depth` [mm] of further wear, divided by the
 * largest wear coefficient of the body. */
double arc_wear_layer_share(const arc_shape *shape, arc_body body, int i, double depth);

#endif
