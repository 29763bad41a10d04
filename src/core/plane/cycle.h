/* The cycle of the plane: contact at every point of a block on two meshes, and what it wears. */
#ifndef PLANE_CYCLE_H
#define PLANE_CYCLE_H

#include "core/elastic/contact_estimate.h"
#include "core/friction/friction.h"
#include "core/wear/run.h"

/* One point of the path, solved. Arrays by body; one block. */
typedef struct wear_point {
  double *p[ARC_BODIES]; /* pressure [MPa] */
  double *q[ARC_BODIES]; /* what wears: p times the factors of law and place [MPa] */
  double *u[ARC_BODIES]; /* elastic displacement along x [mm] */
  double *f[ARC_BODIES]; /* factor of the place */
} wear_point;

/* The block at hand, its poses (which know themselves whether they are up to date) and the last two
 * points that were solved: point i in point[i % 2]. */
typedef struct wear_path {
  const wear_block *block; /* NULL: none yet */
  int poses;
  pose *pose; /* [poses] */
  int nodes;  /* surface nodes of both bodies */
  wear_point point[2];
  wear_point image[2]; /* mirror images of those, where factors of places tell them apart */

  /* with friction */
  int rubs;
  tangential_compliance *compliance; /* [poses] */
  friction_workspace workspace;
  friction_state state;
} wear_path;

/* What the plane adds to a run. */
typedef struct plane_cycle {
  wear_path path;
  pose reference;        /* plate at x = 0, nominal load */
  double *slip;          /* [4 n] of an increment; or what mirror images wear */
  double *down;          /* [n] how much lower depths of the window make the surface, see
                            arc_shape_downward */
  double *width;         /* [n] of the nodes' cells [mm] in the window before */
  double *plate, *below; /* [np], [nc] depths of the plate, and those under the cylinder's nodes */
} plane_cycle;

static inline plane_cycle *plane_of(const arc_wear *w) {
  return w->own;
}
static inline wear_path *path_of(const arc_wear *w) {
  return &plane_of(w)->path;
}

/* -d rate / d depth, at frozen compliance and along y. Neighbouring points whose contact hardly
 * differs are taken together: a Newton iteration does not mind. */
struct wear_tangent {
  int nc, np;
  double width;  /* [mm] of plate positions in a group; 0: every point is its own */
  double *value; /* [n x n], n = nc + np, column-major; cylinder first */
  struct jacobian_group *group;
};

/* --- path.c --- */
/* Room for the points; ARC_MEMORY leaves nothing to free. */
arc_status arc_path_create(wear_path *path, const arc_model *model, int rubs);
void arc_path_free(wear_path *path);
/* Makes poses for a block, unless it is the one at hand. ARC_MEMORY: no block is at hand. */
arc_status arc_path_enter(wear_path *path, const wear_block *block, const arc_model *model,
                          arc_error *error);
/* Zeroes a point: lifted off. */
void arc_path_clear(const wear_path *path, wear_point *point);
void arc_path_copy(const wear_path *path, const wear_point *from, wear_point *to);

/* --- rate.c --- */
/* The wear of a window. */
arc_status arc_wear_evaluate(arc_wear *w, const wear_window *window, wear_watch *watch,
                             wear_rate *rate, arc_error *error);
/* Sliding [mm] that the points of a window stand for together. */
double arc_wear_window_sliding(const arc_wear *w, const wear_window *window);
/* What a slope takes of the wear that the same pressure does on the level. */
double arc_wear_slope_share(const arc_wear *w, const wear_window *window, arc_body b, int i);
/* Solves the point window->first only: can the contact be there? */
arc_status arc_wear_probe(arc_wear *w, const wear_window *window, arc_error *error);

/* Brings the pose of point `at` of the block at hand up to date with a window. */
arc_status arc_wear_prepare(arc_wear *w, const wear_window *window, int at, arc_error *error);
/* What the solution on a pose presses and wears. */
arc_status arc_wear_take(arc_wear *w, const wear_window *window, const pose *p, wear_point *point,
                         arc_error *error);

/* Multiplies a point's q by the local factors. */
arc_status arc_wear_place_factors(const arc_wear *w, const arc_wear_record *state,
                                  wear_point *point, arc_error *error);

/* Adds work at the cylinder's nodes [MPa mm], as a density along x, to the wear of both bodies, by
 * the factors of their places: the plate gets the same through the coupling (Eq. 15). on [np] is
 * room. */
void arc_wear_share(const arc_wear *w, const pose *p, const wear_point *point, const double *work,
                    double *on, wear_rate *rate);

/* --- mirror.c --- */
/* Whether the contact in the second half of a window is the mirror image of that in its first. */
int arc_wear_is_mirrored(const arc_wear *w, const wear_window *window);
/* Whether the wear is not, for factors of places. */
int arc_wear_has_places(const arc_wear *w, const wear_window *window);
/* The image of point `at`, just solved; `law` has what wears there without factors of places. */
arc_status arc_wear_reflect(arc_wear *w, const wear_window *window, int at, const wear_point *law,
                            arc_error *error);
/* Depths [n] become the mean of themselves and their mirror image. */
void arc_wear_symmetrise(const arc_wear *w, double *depth);
/* The wear of a first half, and its Jacobian, become those of the whole window; `images`: the wear
 * of the other half, NULL where it is the mirror image. */
void arc_wear_add_mirror(const arc_wear *w, const wear_window *window, const wear_rate *images,
                         wear_rate *rate);

/* --- fretting.c --- */
/* The wear of a steady cycle with friction. */
arc_status arc_wear_fret(arc_wear *w, const wear_window *window, wear_watch *watch, wear_rate *rate,
                         arc_error *error);

/* The fretting loop of a whole cycle. */
arc_status arc_wear_fret_loop(arc_wear *w, const wear_window *window, wear_watch *watch,
                              arc_loop **loop, arc_error *error);

/* --- slip.c --- */
/* Adds the work of the increment that ends at `at`, with the elastic part of the slip. */
void arc_wear_add_work(const arc_wear *w, int at, wear_rate *rate);

/* --- jacobian.c --- */
wear_tangent *arc_tangent_create(const arc_wear *w);
void arc_tangent_free(wear_tangent **tangent);
size_t arc_tangent_bytes(const arc_wear *w);
double arc_tangent_eigenvalue(const arc_wear *w, const double k[ARC_BODIES], wear_tangent *tangent);
void arc_wear_jacobian_clear(wear_tangent *j);
/* Adds share * (-d q / d depth) of point `at` of the window, just solved, to the window's; points
 * come in order. way [surface] of both bodies: what each node slides, where that is not share; its
 * largest is. */
void arc_wear_jacobian_add(const arc_wear *w, const wear_window *window, int at, double share,
                           double *const way[ARC_BODIES]);
/* After the last pose: value is complete. */
void arc_wear_jacobian_finish(wear_tangent *j);

/* --- plane_definition.c --- */
arc_procedure arc_wear_choose_procedure(const arc_wear_def *def, const arc_model_def *model);
int arc_wear_over_plate(const arc_wear_def *def, const arc_model_def *model);
wear_manner arc_plane_manner(const arc_wear_def *def, const arc_model_def *model);
arc_status arc_plane_check(const arc_wear_def *def, const arc_model_def *model, arc_error *error);

/* --- increments.c --- */
double arc_loading_increments(const arc_wear_def *def, const arc_model_def *model,
                              const arc_loading *from, double *parts);
/* Warns of increments that leap over parts of the contact's way. */
void arc_plane_warn_leaps(const arc_wear *w, const arc_callbacks *callbacks);

/* --- revolved.c --- */
/* Whether a definition keeps to the axis of a model of revolution, and asks for one only there;
 * ARC_ARGUMENT. */
arc_status arc_wear_check_revolved(const arc_wear_def *def, const arc_model_def *model,
                                   arc_error *error);
/* Half width of a flat scar of a volume [mm3] on a cylinder of that radius, or on a ball. */
double arc_wear_scar(const arc_wear_def *def, const arc_model_def *model, double radius,
                     double volume);
/* Slip at surface node i over that at the radius where it is told: 1 unless the bodies spin. */
double arc_wear_spin_share(const arc_wear *w, const shape_side *side, int i);

/* --- measures.c --- */
/* alpha = 0 over the whole plate: the contact never changes. */
int arc_plane_stays_as_it_is(const arc_wear_def *def, const arc_model_def *model);
double arc_plane_ripple(const arc_wear *w, const arc_shape *shape, const arc_wear_record *measured);
double arc_plane_roughness(const arc_wear *w, arc_body body);
/* Largest depth of the plate [mm]; of a track, its mean depth as wide as the contact is. The record
 * has volume and half width. */
double arc_plane_depth(const arc_wear *w, const arc_shape *shape, const arc_wear_record *record);
/* What wears evenly, per thickness [mm]: the plate's width; a track 1 mm wide [mm2]. */
double arc_plane_even_width(const arc_wear *w);
arc_status arc_plane_measure(arc_wear *w, const arc_shape *shape, arc_wear_record *record,
                             arc_error *error);

/* --- wearing.c --- */
void arc_plane_add_volumes(const arc_wear *w, const arc_shape *shape, const wear_depths *depth,
                           arc_wear_record *record);
arc_status arc_plane_wear(const arc_wear *w, arc_shape *shape, wear_depths *depth,
                          arc_wear_record *record, arc_error *error);
double arc_plane_natural_depth(const arc_wear *w);
double arc_plane_even_dose(const arc_wear *w, double depth);
double arc_plane_layer_dose(const arc_wear *w, int scars);
double arc_plane_open_share(const arc_wear *w, arc_body body);

/* --- plane_surfaces.c --- */
arc_status arc_plane_show(const arc_wear *w, arc_array **surfaces, size_t *count, arc_error *error);
arc_array *arc_plane_save(const arc_shape *shape, size_t *count);
arc_status arc_plane_load(arc_model *model, const arc_wear_def *def, const arc_array *state,
                          size_t count, arc_shape **shape, arc_error *error);

/* --- validate_plane.c --- */
arc_status arc_plane_validate(const arc_wear *w, arc_error *error);

/* --- remesh.c --- */
/* Whether what a step failed of is want of room (ARC_ZONE) or depth (ARC_GEOMETRY) that the run has
 * grown into, and not the step itself. */
int arc_wear_has_outgrown(const arc_wear *w, arc_status why);

/* The rows that a wear box needs for layers that wear evenly, of which only those in the box are
 * felt as they get thinner; 0 where it has them. */
int arc_wear_layer_rows(const arc_wear *w);

/* Whether bodies of that radius have room for the zones that the run needs. */
int arc_wear_has_room(const arc_wear *w);

/* A copy of the run on larger meshes. Errors: those of arc_model_build, `why` where
 * there is no room for larger ones; *result is NULL then. */
arc_status arc_wear_grow(const arc_wear *w, arc_status why, const arc_callbacks *callbacks,
                         arc_wear **result, arc_error *error);

/* A copy of the run on a mesh that is asked for, as in arc_wear_set. Errors: those of
 * arc_wear_grow, ARC_ARGUMENT where the meshes are from outside. */
arc_status arc_wear_remesh(const arc_wear *w, const arc_mesh_def *mesh,
                           const arc_callbacks *callbacks, arc_wear **result, arc_error *error);

/* Says which meshes a run has got by now, and why. */
void arc_wear_tell_meshes(const arc_wear *before, const arc_wear *now, const char *why,
                          const arc_callbacks *callbacks);

/* Says that and how a run has grown. */
void arc_wear_tell_grown(const arc_wear *before, const arc_wear *now,
                         const arc_callbacks *callbacks);

/* Tells of a step that failed, and, of one that failed for want of room, why the run does not grow:
 * `trouble` (a message that may be empty), or a step too long, with the mesh that may hold it. */
arc_status arc_wear_refuse(const arc_wear *w, const arc_error *why, const arc_error *trouble,
                           arc_error *error);

/* --- rims.c --- */
/* A run like one just created, on meshes whose elements resolve the rims that slip; *finer NULL
 * where they do, where sizes are given, and without friction. */
arc_status arc_wear_resolve(arc_wear *w, arc_wear **finer, arc_error *error);
/* The largest size [mm] that resolves the rims of the last update; INFINITY where there are none.
 */
double arc_wear_rim_size(const arc_wear *w);

/* --- layers.c --- */
/* The depth from h on [mm] that a depth due at the largest wear coefficient of the layers under
 * node i of a body comes to at their own. */
double arc_wear_through_layers(const arc_shape *shape, arc_body body, int i, double h, double due);

/* The same for the depths of all nodes of both surfaces, the cylinder's first. */
void arc_wear_into_layers(const arc_shape *shape, double *depth);
/* Share of the largest coefficient by which node i of a body wears where it has lost `depth` more.
 */
double arc_wear_layer_share(const arc_shape *shape, arc_body body, int i, double depth);

#endif
