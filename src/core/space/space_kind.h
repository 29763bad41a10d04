/* Half-spaces as a kind of pair: surfaces that depend on x and z, with sliding along one axis. */
#ifndef SPACE_KIND_H
#define SPACE_KIND_H

#include "archard/space.h"
#include "core/pair/surfaces.h"
#include "core/wear/run.h"

/* Half-spaces and the coordinates of their cells. All surfaces with the same cells share one
 * object. */
typedef struct space_grid {
  int references;
  arc_halfspace *h;
  double *x[ARC_BODIES],
      *z[ARC_BODIES]; /* [sites] coordinates of the sites [mm]; allocated as one block */
} space_grid;

/* Shape (arc_shape) of this kind of pair. */
typedef struct space_shape {
  shape_handle handle;
  space_grid *grid;
  double *depth[ARC_BODIES]; /* [sites] wear depth [mm]; depths of both bodies and `line` are one
                                block */
  double *line[ARC_BODIES];  /* [3 rows] profile in the middle of the body: positions, depths,
                                heights; computed on demand */
} space_shape;

/* Contact (arc_contact) of this kind of pair. */
typedef struct space_contact {
  contact_handle handle;
  double *pressure;               /* [window] [MPa] */
  arc_halfspace_friction rubbing; /* friction state; all members are zero without friction */
  arc_halfspace_friction coarser; /* friction state computed with half as many increments */
  double origin;                  /* position of the lower body before the first motion [mm] */
} space_contact;

/* The positions in a part of a cycle (wear_window) at which the contact is solved. With friction
 * each site of the upper body has its own slip at each position, and shear between unlike bodies
 * changes the gaps. */
typedef struct space_path {
  int count;
  arc_halfspace_position *position; /* [count] */
  int *of;         /* with friction: [points] index of the position of each point of the cycle */
  double *slip;    /* [count][window] slip divided by the weight of the position; NULL: all are 1 */
  double *gap;     /* [count][window] gaps due to shear [mm]; NULL: none */
  double unsteady; /* change of `gap` in the last slip solution, relative to its largest value */
  arc_halfspace_friction
      *guess;  /* [points] initial guesses, see arc_space_guess_at; NULL without friction */
  int guesses; /* number of points in `guess` */
} space_path;

static inline const space_shape *space_shape_of(const arc_shape *shape) {
  return (const space_shape *)(const void *)shape;
}

/* Returns true if the lower body moves along z. */
static inline int space_turned(const space_shape *s) {
  return arc_halfspace_definition(s->grid->h)->turned;
}

/* Returns half the width of a contact along the motion [mm]. */
static inline double space_along(const space_shape *s, double half_width, double half_width_z) {
  return space_turned(s) ? half_width_z : half_width;
}

static inline int space_sites(const space_shape *s, int body) {
  return arc_halfspace_sites(s->grid->h, (arc_body)body);
}

/* --- space_model.c ---------------------------------------------------------------------------- */
arc_status arc_space_check_model(const arc_model_def *def, arc_error *error);
arc_status arc_space_build(const arc_model_def *def, const arc_callbacks *callbacks,
                           arc_model **model, arc_error *error);
void arc_space_end_model(arc_model *model);
size_t arc_space_model_bytes(const arc_model *model);
/* Returns Hertz' contact of the pair under a load [N]. For periodic surfaces, returns the result of
 * arc_space_period instead. */
arc_hertz_ellipse arc_space_hertz(const arc_model_def *def, double load);
/* Returns the definition of a model's half-spaces without cells. */
arc_halfspace_def arc_space_bodies(const arc_model_def *def);
/* Chooses cells for a motion along x, or along z if `turned` is 1. The window is sized for the load
 * [N] and the volume worn at the end [mm3], the track for positions up to +- stroke / 2 [mm]. The
 * cell size is chosen so that the increment [mm] is a whole number of cells; 0 allows any cell
 * size. */
void arc_space_fit(const arc_model_def *def, int turned, double load, double volume, double stroke,
                   double increment, arc_halfspace_def *cells);
/* Returns the fraction of a motion by which the contact moves over the upper body: the curvature of
 * the lower body along the motion, divided by the sum of both curvatures. */
double arc_space_lower_share(const arc_model_def *def, int turned);
/* Limits a window to the extent of the bodies' maps. */
void arc_space_limit(const arc_model_def *def, arc_halfspace_def *cells);
/* Enlarges the window on each side by its number of cells divided by `part`, but not beyond the
 * edge of the maps. Error: ARC_ZONE if the window already extends to this edge. */
arc_status arc_space_widen(const arc_model_def *def, int part, arc_halfspace_def *cells,
                           arc_error *error);
/* Adds rows to the window and makes the track `beyond` rows longer than the window. Error: ARC_ZONE
 * if the maps are too short. */
arc_status arc_space_extend_cells(const arc_model_def *def, int rows, int beyond,
                                  arc_halfspace_def *cells, arc_error *error);
/* Returns the cell width of the model [mm]: mesh.size, or else a default for the load [N]. */
double arc_space_cell(const arc_model_def *def, double load);
/* Returns 1 and, unless callbacks is NULL, warns if a half width of a contact along x or z [mm] is
 * too large for the half-space approximation; otherwise returns 0. */
int arc_space_warn_steep(const arc_model_def *def, double half_x, double half_z,
                         const arc_callbacks *callbacks);
/* Warns if the half widths of a contact along x and z [mm] are too large for the half-space
 * approximation, if the half width along x is too small for the cells, or if the cells are wider
 * than the steps of a map. */
void arc_space_warn(const arc_model_def *def, const arc_halfspace_def *cells, double half_width,
                    double half_z, const arc_callbacks *callbacks);

/* --- space_periodic.c ------------------------------------------------------------------------- */
/* Checks the bodies of a model with periodic = true. arc_space_check_periodic_run checks a run
 * with such a model. Error: ARC_ARGUMENT. */
arc_status arc_space_check_periodic(const arc_model_def *def, arc_error *error);
arc_status arc_space_check_periodic_run(const arc_wear_def *d, const arc_model_def *model,
                                        arc_error *error);
/* Returns the recess of a periodic map at x and z, where the middle of the map is x = z = 0 (an
 * arc_recess_fn). The context is the body's definition. */
double arc_space_period_height(void *context, double x, double z);
/* Returns the reference values of one period of a periodic surface: half widths [mm], mean pressure
 * [MPa] and height of the map [mm]. */
arc_hertz_ellipse arc_space_period(const arc_model_def *def, double load);
double arc_space_period_step(const arc_model_def *def);
void arc_space_period_cells(const arc_model_def *def, int turned, arc_halfspace_def *cells);

/* --- space_definition.c ----------------------------------------------------------------------- */
arc_status arc_space_check(const arc_wear_def *def, const arc_model_def *model, arc_error *error);
int arc_space_prefers_implicit(const arc_wear_def *def);
wear_manner arc_space_manner(const arc_wear_def *def, const arc_model_def *model);
int arc_space_increments(const arc_wear_def *def, const arc_model_def *model);
double arc_space_parts(const arc_wear_def *def, const arc_model_def *model,
                       const arc_loading *loading, double *parts);
double arc_space_reach(const arc_model_def *model, double load);
/* Returns the definition of the half-spaces with the initial cells of a run. */
arc_halfspace_def arc_space_cells(const arc_wear_def *def, const arc_model_def *model);

/* --- coarsen.c -------------------------------------------------------------------------------- */
/* Returns true if the cells of a run follow its contact: they were chosen by default, and neither
 * roughness, layers nor the edge of a stick zone must be resolved. */
int arc_space_follows(const arc_wear_def *def, const arc_model_def *model);
/* Returns the number of which the automatic number of cells of a stroke is a multiple: 2, or more
 * if so many cells can be doubled, once or several times. `cells` is their usual number. */
double arc_space_stroke_unit(const arc_wear_def *def, const arc_model_def *model, double cells);
/* Writes to `cells` the cells of a run, doubled along each axis along which the contact has become
 * so wide that doubled cells still resolve it better than the first cells resolved the unworn
 * contact. Returns true if any were doubled. */
int arc_space_coarsen(const arc_wear *w, arc_halfspace_def *cells);
/* Returns the worn volume [mm3] for which the first window of a run is sized: the volume at which
 * cells are doubled, and the window with them; INFINITY if the cells of the run stay. `rests` is
 * true if the contact does not move. */
double arc_space_first_volume(const arc_wear_def *def, const arc_model_def *model, int rests);
/* Returns the number of increments of a cycle in a cell: 1, or more after cells were doubled. */
int arc_space_increments_per_cell(const arc_wear *w, const wear_block *block);

/* --- space_shape.c ---------------------------------------------------------------------------- */
/* Creates unworn surfaces on the given cells. */
arc_status arc_space_create(arc_model *model, const arc_halfspace_def *cells, space_shape **shape,
                            arc_error *error);
arc_status arc_space_surfaces(arc_model *model, const arc_wear_def *def, const arc_shape *from,
                              arc_shape **shape, arc_error *error);
arc_status arc_space_copy(const arc_shape *shape, arc_shape **copy, arc_error *error);
void arc_space_discard(arc_shape **shape);
space_grid *arc_space_hold(space_grid *grid);
void arc_space_let_go(space_grid **grid);
/* Transfers surfaces to other cells, which must contain all worn cells. */
arc_status arc_space_regrow(const space_shape *from, const arc_halfspace_def *cells,
                            space_shape **grown, arc_error *error);
arc_array *arc_space_save(const arc_shape *shape, size_t *count);
arc_status arc_space_load(arc_model *model, const arc_wear_def *def, const arc_array *state,
                          size_t count, arc_shape **shape, arc_error *error);

/* --- space_cycle.c ---------------------------------------------------------------------------- */
/* Computes the positions in a part of a cycle. arc_space_end_path frees them. Error: ARC_MEMORY. */
arc_status arc_space_path(const arc_wear *w, const wear_window *window, space_path *path,
                          arc_error *error);
void arc_space_end_path(space_path *path);
/* arc_space_guess_at returns the initial guess of the solution at a point of a cycle with friction:
 * pressure, shear, motion and stick zone of the last solution at this point, or NULL if there is
 * none. arc_space_remember stores or replaces the guess. If the memory for the first guess of a
 * point is not available, the point remains without a guess, which is not an error.
 * arc_space_forget frees the guesses of all points. */
const arc_halfspace_friction *arc_space_guess_at(const space_path *path, int at);
void arc_space_remember(space_path *path, int at, const arc_halfspace_friction *state, int cells);
void arc_space_forget(space_path *path);
/* Computes the pressures [count][window] for given depths, the sums of weight times pressure by
 * site, and the peak pressure, rate->peak. With friction, also computes the slip of the cycle and
 * writes energy, forces and stick zone to `rate`. */
arc_status arc_space_solve_path(arc_wear *w, const wear_window *window,
                                const double *const depth[ARC_BODIES], space_path *path,
                                wear_progress *progress, double *pressure, wear_rate *rate,
                                arc_error *error);
arc_status arc_space_rate(arc_wear *w, const wear_window *window, wear_progress *progress,
                          wear_rate *rate, arc_error *error);
wear_tangent *arc_space_tangent(const arc_wear *w);
void arc_space_end_tangent(wear_tangent **tangent);
size_t arc_space_tangent_bytes(const arc_wear *w);
double arc_space_eigenvalue(const arc_wear *w, const double k[ARC_BODIES], wear_tangent *tangent,
                            const arc_callbacks *callbacks);

/* --- space_slip.c ----------------------------------------------------------------------------- */
/* Computes slip and shear of the steady cycle with friction, for given wear depths. The results are
 * path->slip and path->gap, and energy, force and stick zone in `rate`. `pressure` [count][window]
 * contains the pressures at the positions of the cycle. They are averaged over mirror images. For
 * unlike bodies they are replaced by the pressures of the cycle, which depend on the shear. */
arc_status arc_space_slip(arc_wear *w, const wear_window *window,
                          const double *const depth[ARC_BODIES], space_path *path, double *pressure,
                          wear_progress *progress, wear_rate *rate, arc_error *error);

/* --- space_loop.c ----------------------------------------------------------------------------- */
/* Computes the loop of a cycle (see arc_kind.loop), in increments fine enough for a plot. */
arc_status arc_space_loop(arc_wear *w, const wear_window *window, wear_progress *progress,
                          arc_loop **loop, arc_error *error);

/* --- space_law.c ------------------------------------------------------------------------------ */
/* Returns true if the wear is k p ds with rigid slip, which requires a linear law, no local factors
 * and no friction. */
int arc_space_is_linear(const arc_wear *w, const arc_wear_record *state);
/* Computes the wear work of the pressures [count][window] at each site of a body [MPa mm]: the
 * sum over the positions of weight, law, local factor and pressure. Errors: ARC_MEMORY, errors
 * of the local factor. */
arc_status arc_space_work(const arc_wear *w, const arc_wear_record *state, const space_shape *s,
                          const space_path *path, const double *pressure, double mu, arc_body body,
                          double *work, arc_error *error);
/* Computes the wear work (see arc_space_work) and its linearisation about the given pressures at
 * each site. For nearby pressures p the work is factor sum(weight p) + (1 - growth) work, with
 * growth from arc_space_law_growth. */
arc_status arc_space_linearise(const arc_wear *w, const arc_wear_record *state,
                               const space_shape *s, const space_path *path, const double *pressure,
                               double mu, arc_body body, double *work, double *factor,
                               arc_error *error);
/* Returns the exponent d ln(law p) / d ln p that the linearisation uses; it is at least 1. */
double arc_space_law_growth(const arc_wear *w);

/* --- space_layers.c --------------------------------------------------------------------------- */
/* Returns the depth that site i of a body loses in a step, with the wear coefficients of the layers
 * at this site [mm]. `due` is the depth that the site would lose with the largest wear coefficient
 * of the layers. If `share` is not NULL, *share is set to the coefficient of the exposed layer
 * divided by the largest coefficient. */
double arc_space_worn(const arc_shape *shape, arc_body body, int i, double due, double *share);
void arc_space_through_layers(const arc_shape *shape, double *depth);
double arc_space_open_share(const arc_wear *w, arc_body body);

/* --- space_stages.c --------------------------------------------------------------------------- */
arc_status arc_space_begin_stages(wear_stage *s);
arc_status arc_space_start(wear_stage *s, double *rate);
arc_status arc_space_stage(wear_stage *s, double h, double *rate);
double arc_space_error(wear_stage *s, double h, double *defect);
void arc_space_end_stages(wear_stage *s, double cycles, wear_depths *depth);

/* --- space_contact.c -------------------------------------------------------------------------- */
arc_status arc_space_solve(const arc_shape *shape, const arc_contact_def *def,
                           const arc_callbacks *callbacks, arc_contact **contact, arc_error *error);
arc_status arc_space_move(const arc_contact *from, const arc_motion_def *motion,
                          const arc_callbacks *callbacks, arc_contact **contact, arc_error *error);
void arc_space_end_contact(arc_contact *contact);
/* Enlarges the track, if it is too short for position x [mm], or else the window. Used after a
 * contact solution that failed with ARC_ZONE. */
arc_status arc_space_widen_contact(space_contact *c, double x, arc_error *error);
/* Computes the result of the contact (widths, pressures, approach) from its present pressures. */
void arc_space_read_result(space_contact *c, double approach, int iterations);
size_t arc_space_contact_bytes(const arc_contact *contact);
arc_status arc_space_show(const arc_wear *w, arc_array **surfaces, size_t *count, arc_error *error);
arc_status arc_space_show_contact(const arc_contact *contact, arc_array **surfaces, size_t *count,
                                  arc_error *error);
/* Checks that the contact under a load [N] lies within the window. Errors: ARC_ZONE if the contact
 * reaches the edge; errors of a contact solution. */
arc_status arc_space_hold_load(const space_shape *s, double load, arc_error *error);
arc_status arc_space_measure(arc_wear *w, const arc_shape *shape, arc_wear_record *record,
                             arc_error *error);
/* --- space_friction.c ------------------------------------------------------------------------- */
/* Presses the bodies together as the contact's definition describes. arc_space_rub moves the
 * pressed bodies. */
arc_status arc_space_press(space_contact *c, const arc_callbacks *callbacks, arc_error *error);
arc_status arc_space_rub(space_contact *c, const arc_motion_def *motion,
                         const arc_callbacks *callbacks, arc_error *error);
/* Chooses cells that are fine enough for the edge of the stick zone. */
void arc_space_fit_friction(const arc_model_def *def, double load, arc_halfspace_def *cells);
/* Returns the cell width [mm] of a run with friction: the width in the model's definition, else a
 * width fine enough for the stick and slip zones of the cycles. */
double arc_space_slip_cell(const arc_wear_def *def, const arc_model_def *model);
/* Warns if cells of the given size [mm] do not resolve the slip annulus of a run. */
void arc_space_warn_slip(const arc_wear_def *def, const arc_model_def *model, double size,
                         const arc_callbacks *callbacks);
/* Returns the estimated worn volume [mm3] after which wear in partial slip ends: the volume of 20 /
 * (4 mu k p_0) cycles that dissipate the energy of Mindlin's loop of the unworn contact (mu:
 * friction coefficient, k: wear coefficient, p_0: largest pressure). Returns INFINITY for gross
 * slip, full stick, and a loading history of blocks. */
double arc_space_slip_volume(const arc_wear_def *def, const arc_model_def *model);
/* Computes the magnitudes of shear [window] [MPa] and slip [window] [mm] of a contact with
 * friction. */
void arc_space_sizes(const space_contact *c, double *shear, double *slip);

#endif
