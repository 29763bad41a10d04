/* archard/space.h - contact and wear in three dimensions: two half-spaces, or layers on them.
 *
 * Axes: x along the motion, y up, z across the motion. The upper body carries the load and does not
 * move; the lower body moves along x. Both surfaces are functions of (x, z) on cells of size_x x
 * size_z. The window is the grid of the upper body: nx x nz cells around x = z = 0. The track is
 * the grid of the lower body, which is longer along x. The middle of the track is at the position
 * of the lower body.
 *
 *   gap = recess_upper + recess_lower + depth_upper + depth_lower + K p - approach >= 0
 *   p >= 0,  p gap = 0,  sum of p size_x size_z = load
 *
 * Arrays over sites are stored row by row, z fastest: site = i * nz + j is the cell at x_i, z_j.
 * Pressures p are given at the sites of the window. K is the normal compliance of both bodies. */
#ifndef ARCHARD_SPACE_H
#define ARCHARD_SPACE_H

#include "archard/wear.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* Returns the recess [mm] of an unworn surface at (x, z) [mm]: its depth below the outermost point
 * of the body. */
typedef double (*arc_recess_fn)(void *context, double x, double z);

typedef struct arc_halfspace_body {
  arc_material material;
  arc_layer
      layer[ARC_MOST_LAYERS]; /* layers from the surface inwards; a thickness of 0 ends the list */
  double depth;               /* [mm] depth of a rigid base below the surface; 0: no base */
  double radius_x, radius_z;  /* [mm] radii of curvature along x and z; 0: flat. A radius R adds the
                                 recess x^2 / (2 R) */
  arc_recess_fn recess;       /* recess in addition to that of the radii; NULL: none */
  void *context;              /* first argument of `recess` */
} arc_halfspace_body;

typedef struct arc_halfspace_def {
  arc_halfspace_body body[ARC_BODIES];
  double size_x, size_z; /* [mm] size of a cell */
  int nx, nz;            /* number of cells of the window */
  int track;             /* number of cells of the track along x, nx plus an even number; 0: nx */
  double groove; /* [mm] length of a groove, over which the wear of the lower body is spread evenly,
                    for long strokes and circular tracks. If > 0, the lower body is uniform along x
                    and has one row of sites; 0: no groove */
  int turned;   /* 1: the lower body moves along z. Then size_x, nx and track apply to z, and size_z
                   and nz to x. In radii, recesses, positions of sites and extents, x and z are not
                   exchanged */
  int periodic; /* 1: the surfaces are periodic, and the window is one period; the lower body must
                   have a groove or no track */
  int workers;  /* number of threads among which the positions of a cycle are divided; 0 or 1: only
                   the calling thread */
} arc_halfspace_def;

/* Returns a steel ball of 10 mm radius on a flat, with 63 x 63 cells of 0.02 mm. */
arc_halfspace_def arc_halfspace_default(void);

/* Two half-spaces with their grids and compliances. Opaque; two threads must not use the same
 * object at once. */
typedef struct arc_halfspace arc_halfspace;

/* Creates the half-spaces. The function `recess` is called only here. Errors: ARC_ARGUMENT (the
 * message has the field, the expected and the actual value), ARC_GEOMETRY (cells are wider than
 * four times the thinnest layer), ARC_MEMORY. On failure *made is NULL. */
arc_status arc_halfspace_create(const arc_halfspace_def *def, arc_halfspace **made,
                                arc_error *error);
void arc_halfspace_destroy(arc_halfspace **h);
const arc_halfspace_def *arc_halfspace_definition(const arc_halfspace *h);
/* Returns the memory [bytes] needed for a computation with `positions` positions in a cycle. */
double arc_halfspace_bytes(const arc_halfspace_def *def, int positions);

/* arc_halfspace_sites returns the number of sites of a body, arc_halfspace_site_area the area of
 * one site [mm2]. arc_halfspace_site_at writes the position of a site [mm]. */
int arc_halfspace_sites(const arc_halfspace *h, arc_body body);
double arc_halfspace_site_area(const arc_halfspace *h, arc_body body);
void arc_halfspace_site_at(const arc_halfspace *h, arc_body body, int site, double *x, double *z);
/* Returns the recess [mm] of the unworn surface at each site of a body. */
const double *arc_halfspace_recess(const arc_halfspace *h, arc_body body);

/* --- contact ---------------------------------------------------------------------------------- */

/* One position of the lower body in a cycle, with the load at this position. */
typedef struct arc_halfspace_position {
  double
      x; /* [mm] position of the lower body, whose surface is interpolated linearly between cells */
  double load;   /* [N] normal load, > 0 */
  double weight; /* [mm] sliding distance assigned to this position; wear needs a value > 0 */
} arc_halfspace_position;

/* Options of the solver. NULL in a call means the defaults. */
typedef struct arc_halfspace_options {
  double tolerance;  /* tolerance of gaps, relative to the largest displacement; 0: 1e-5. With
                        friction between different materials it is always 1e-5 */
  const double *gap; /* [positions][window] gap added to the computed gaps [mm]; NULL: none */
  int warm; /* 1: the solver starts from the pressures in the output array; 0: it starts from an
               estimate */
  const arc_callbacks *callbacks; /* callbacks that may stop the solver; NULL: none */
} arc_halfspace_options;

/* Computing effort of a solution, and its largest pressure. */
typedef struct arc_halfspace_report {
  int iterations, applications, sets,
      guarded; /* number of conjugate gradient steps, of applications of the compliance K, of active
                  sets, and of fallback steps */
  double p_max; /* [MPa] largest pressure over all positions */
} arc_halfspace_report;

/* Solves the contact at one position, on surfaces with the wear depth `depth` [mm] at each site
 * (NULL: unworn). Writes the pressures of the window [MPa] and the approach [mm]. ARC_ZONE: the
 * contact reaches the edge of the window, or the track is too short for the position. Other errors:
 * ARC_NOT_CONVERGED, ARC_NUMERIC, ARC_STOPPED, ARC_MEMORY. On failure pressure and approach are
 * unchanged. */
arc_status arc_halfspace_solve(arc_halfspace *h, const double *const depth[ARC_BODIES],
                               const arc_halfspace_position *position,
                               const arc_halfspace_options *options, double *pressure,
                               double *approach, arc_halfspace_report *report, arc_error *error);

/* Computes the gaps [mm] of a solution at the sites of the window; they are about 0 in contact.
 * Errors: ARC_MEMORY. */
arc_status arc_halfspace_gaps(arc_halfspace *h, const double *const depth[ARC_BODIES],
                              const arc_halfspace_position *position, const double *pressure,
                              double approach, double *gap, arc_error *error);

/* --- friction ------------------------------------------------------------------------------------
 *
 * q is the shear on the upper body along +x and +z (on the lower body along -x, -z). The lower body
 * moves by xi. The slip E of its surface relative to the upper one is
 *
 *   E = xi - C q + N p, |q| <= friction p, dE = 0 if |q| < friction p, else dE is along q,
 *
 * and N q is added to the gap. C is the shear compliance of both bodies. N is the coupling of shear
 * and pressure, which is zero for equal materials. Results depend on the history of load and
 * motion, so a contact is computed in increments. */

/* State of a contact with friction. All arrays are in one block at `pressure`, which
 * arc_halfspace_friction_end releases. If all members are zero, the bodies are apart. */
typedef struct arc_halfspace_friction {
  double *pressure; /* [window] pressure [MPa] */
  double *q[2];     /* [window] shear along x and z [MPa] */
  double *slip[2];  /* [window] slip E [mm], also defined at sites that are not in contact */
  double *moved[2]; /* [window] slip in the last increment while the site was in contact [mm] */
  double *stick;    /* [window] 1 if the site stuck in the last increment, else 0 */
  double xi[2];     /* [mm] motion of the lower body along x and z */
  double travel[2]; /* [mm] sliding of the whole contact along x and z: the smallest slip of all
                       sites in contact, summed over the increments. It does not change while a part
                       of the contact sticks */
  double force[2];  /* [N] force on the lower body along x and z */
  double approach;  /* [mm] rigid approach of the bodies */
  double energy;    /* [N mm] energy dissipated since the first increment */
  double work;      /* [N mm] energy dissipated in the last increment */
} arc_halfspace_friction;

/* Definition of one increment, with prescribed forces or motions. */
typedef struct arc_halfspace_increment {
  double friction; /* coefficient of friction >= 0 */
  arc_halfspace_position
      position; /* position and load at the end of the increment; the weight is not used */
  int follows;  /* 1: the lower body is at position.x + travel[0], so that its surface follows the
                   sliding without the elastic displacement; 0: it is at position.x */
  int by_force[2]; /* 1 if the force along x or z is prescribed, 0 if the motion xi is prescribed */
  double xi[2];    /* [mm] motion at the end of the increment */
  double force[2]; /* [N] force at the end of the increment; its magnitude must be less than the
                      coefficient of friction times the load */
  const double *pressure; /* [window] pressure [MPa] at the end of the increment, if it is known
                             because it does not depend on the shear; the approach then does not
                             change. NULL: the pressure is computed */
  const arc_halfspace_friction *guess; /* state from which the solver starts (pressure, shear,
                                          motion and stick zone); NULL: the present state */
} arc_halfspace_increment;

/* Computing effort of the increments, summed over all calls, and the farthest position. */
typedef struct arc_halfspace_effort {
  int increments; /* number of increments solved */
  int sweeps; /* number of solutions for the pressure, each followed by a solution for the shear;
                 equal materials need one in each increment */
  int sets, iterations, applications; /* numbers of active sets, conjugate gradient steps and
                                         applications of the compliance C for the shear */
  int flipping;    /* number of solutions for the shear that ended while some cells still alternated
                      between stick and slip */
  int unfinished;  /* number of increments (for different materials) that ended before the pressures
                      converged */
  double farthest; /* [mm] largest |x| of the lower body in increments with `follows`, also if
                      outside the track */
  int unresolved;  /* number of intervals of a leg whose results did not converge within the allowed
                      number of halvings */
} arc_halfspace_effort;

/* Allocates a state in which all values are zero. Errors: ARC_MEMORY. */
arc_status arc_halfspace_friction_begin(const arc_halfspace *h, arc_halfspace_friction *state,
                                        arc_error *error);
arc_status arc_halfspace_friction_copy(const arc_halfspace *h, const arc_halfspace_friction *from,
                                       arc_halfspace_friction *copy, arc_error *error);
void arc_halfspace_friction_end(arc_halfspace_friction *state);
/* Copies a state to a larger window with cells of the same size. The slip outside the smaller
 * window is computed. */
arc_status arc_halfspace_friction_widen(const arc_halfspace *from,
                                        const arc_halfspace_friction *state, arc_halfspace *to,
                                        arc_halfspace_friction *wide, arc_error *error);

/* Advances a state by one increment. The dissipated work is the sum over the sites of friction
 * times mean pressure times slip. Errors: those of arc_halfspace_solve; ARC_ARGUMENT if a force
 * exceeds friction times load, or for layers, rigid bases and periodic windows. On failure the
 * state is unchanged. The effort is added to *effort. */
arc_status arc_halfspace_slide(arc_halfspace *h, const double *const depth[ARC_BODIES],
                               const arc_halfspace_increment *increment,
                               const arc_halfspace_options *options, arc_halfspace_friction *state,
                               arc_halfspace_effort *effort, arc_error *error);

/* Definition of a leg: a part of the loading path along which the load, and the motion or force,
 * change linearly from their present values to the values in `to`. */
typedef struct arc_halfspace_leg {
  arc_halfspace_increment to;
  double load;    /* [N] load at the start */
  int increments; /* number of equal increments; 0: increments are halved until motion, force and
                     work converge */
} arc_halfspace_leg;

/* Advances a state along a leg. Increments are halved until this changes the shear by less than
 * 1e-3 and the motion by less than 1e-4 of their values in full slip, and the work of an interval
 * by less than 1e-3 of the work of the leg or 3e-3 of its own value. For an error estimate, the
 * state `coarser` (NULL: none) is advanced along the same leg in half as many increments. The
 * difference of the energies of both states estimates the error. Where the direction of slip
 * changes, the error is proportional to the length of the increments and about equal to this
 * difference; elsewhere it is smaller. If the number of increments is fixed, `coarser` does not
 * change. Errors: those of arc_halfspace_slide. On failure the states are unchanged. The effort is
 * added to *effort. */
arc_status arc_halfspace_follow(arc_halfspace *h, const double *const depth[ARC_BODIES],
                                const arc_halfspace_leg *leg, const arc_halfspace_options *options,
                                arc_halfspace_friction *state, arc_halfspace_friction *coarser,
                                arc_halfspace_effort *effort, arc_error *error);

/* Size and position of a contact or scar. */
typedef struct arc_halfspace_extent {
  double area;                     /* [mm2] area of the contact or scar */
  double half_width, half_width_z; /* [mm] half widths along x and z */
  double center_x, center_z;       /* [mm] middle of the contact or scar */
  double largest;                  /* largest pressure [MPa] or depth [mm] */
  double center; /* pressure [MPa] or depth [mm] at x = z = 0, interpolated between cells */
} arc_halfspace_extent;

/* Computes the extent of a contact, the area with pressure > 0. Its edge is where the square of
 * the pressure, extrapolated linearly, becomes zero. */
arc_halfspace_extent arc_halfspace_contact_extent(const arc_halfspace *h, const double *pressure);
/* Computes the extent of a scar, the area that is deeper than `share` times the largest depth.
 * Depths are interpolated linearly between sites. */
arc_halfspace_extent arc_halfspace_scar(const arc_halfspace *h, arc_body body, const double *depth,
                                        double share);

/* --- wear ------------------------------------------------------------------------------------- */

/* Computes the wear rate of each site, rate [body][sites] [MPa mm]: the sum over `count` positions
 * of weight times pressure, on surfaces with the given depths. pressure [count][window] [MPa]
 * receives the pressures of all contacts (NULL: they are not returned). If options->warm is set, it
 * contains the initial pressures at the call. On failure rate and pressure are unchanged. */
arc_status arc_halfspace_rate(arc_halfspace *h, const double *const depth[ARC_BODIES],
                              const arc_halfspace_position *position, int count,
                              const arc_halfspace_options *options, double *pressure,
                              double *const rate[ARC_BODIES], arc_halfspace_report *report,
                              arc_error *error);

/* Computes for each site of a body the sum over positions of weight times value [count][window].
 * The values are, for example, rates of a power law, or energies. On failure sum is unchanged. */
arc_status arc_halfspace_sum(arc_halfspace *h, const arc_halfspace_position *position, int count,
                             const double *value, arc_body body, double *sum, arc_error *error);

/* Wear coefficients of both bodies in a step. The depth after the step is known + c factor rate,
 * where `known` does not depend on the step and `rate` is the result of arc_halfspace_rate. */
typedef struct arc_halfspace_wear {
  double c[ARC_BODIES];             /* [mm2/N] wear coefficient times number of cycles */
  const double *factor[ARC_BODIES]; /* [sites] factor on c at each site, >= 0; NULL: 1 */
} arc_halfspace_wear;

/* Solves the implicit stage z = known + c factor rate(z) for the depths z (see arc_halfspace_wear),
 * for all positions at once. depth and known may be the same arrays. */
arc_status arc_halfspace_stage(arc_halfspace *h, const double *const known[ARC_BODIES],
                               const arc_halfspace_wear *wear,
                               const arc_halfspace_position *position, int count,
                               const arc_halfspace_options *options, double *pressure,
                               double *const depth[ARC_BODIES], arc_halfspace_report *report,
                               arc_error *error);

/* Computes the largest eigenvalue of - d (c factor rate) / d depth (arc_halfspace_wear), accurate
 * to a few per cent, for the active sets of the given pressures [count][window]. An explicit step
 * with these coefficients is stable if the eigenvalue is less than 2. Errors: ARC_STOPPED,
 * ARC_MEMORY. */
arc_status arc_halfspace_eigenvalue(arc_halfspace *h, const arc_halfspace_wear *wear,
                                    const arc_halfspace_position *position, int count,
                                    const double *pressure, const arc_callbacks *callbacks,
                                    double *eigenvalue, arc_error *error);

/* Transfers depths to the sites of another half-space, which has a larger window or smaller cells.
 * Depths are copied if the cells coincide. Otherwise they are interpolated linearly between sites,
 * and the volume is kept. ARC_ZONE: worn sites are outside the other half-space. */
arc_status arc_halfspace_regrow(const arc_halfspace *from, const double *const depth[ARC_BODIES],
                                const arc_halfspace *to, double *const grown[ARC_BODIES],
                                arc_error *error);

/* Sets size_x, size_z, nx, nz and track for a run. The width of a cell is about the smaller half
 * width of the unworn contact divided by `fineness`, and `increment` [mm] is a whole number of
 * cells (0, or less than half of this width: no such condition). The size of the window is
 * estimated from the final wear volume [mm3], and the track from the stroke [mm]. A contact that
 * reaches the edge of the window later causes ARC_ZONE. Nothing is set if the radii do not form a
 * point contact. */
void arc_halfspace_fit(arc_halfspace_def *def, double load, double volume, double stroke,
                       double increment, double fineness);

/* --- initial depths -------------------------------------------------------------------------- */

/* Creates an unworn shape on a 3-D model. The shape has the initial cells of a run with this
 * definition, and its window covers at least |x| <= half_x, |z| <= half_z [mm]. Errors:
 * ARC_ARGUMENT, ARC_MEMORY. On failure *shape is NULL. */
arc_status arc_space_given_create(arc_model *model, const arc_wear_def *def, double half_x,
                                  double half_z, arc_shape **shape, arc_error *error);
/* Returns the number of sites of a body and writes pointers to their positions [mm]. The shape owns
 * these arrays. Sites of a groove have x = 0. */
int arc_space_given_sites(const arc_shape *shape, arc_body body, const double **x,
                          const double **z);
/* Sets the depth [mm] of each site of a body. Errors: ARC_ARGUMENT (a negative depth), ARC_ZONE (a
 * depth > 0 at the border of the window). On failure the shape is unchanged. */
arc_status arc_space_given_depths(arc_shape *shape, arc_body body, const double *depth,
                                  arc_error *error);

/* --- below the surface ------------------------------------------------------------------------ */

/* Computes the stresses [MPa] at y <= 0 [mm] below the sites of the window, from pressures and
 * Poisson's ratio nu. The result is stress [6][window] with the components xx, yy, zz, xy, yz, xz;
 * tension is positive. The half-spaces must be homogeneous. Errors: ARC_MEMORY. */
arc_status arc_halfspace_stress(const arc_halfspace *h, const double *pressure, double nu, double y,
                                double *stress, arc_error *error);

/* Computes the stresses of arc_halfspace_stress for a contact of a 3-D model, on the window of the
 * contact's shape. y = 0 is the surface of the body, and y < 0 is inside the body. ARC_ARGUMENT:
 * the contact has friction, the body has layers or a rigid base, or the surfaces were worn along
 * z. */
arc_status arc_space_contact_stress(const arc_contact *contact, arc_body body, double y,
                                    double *stress, arc_error *error);

/* --- closed form ------------------------------------------------------------------------------ */

/* Results of Hertz' formulas for an elliptic contact. */
typedef struct arc_hertz_ellipse {
  double half_width, half_width_z; /* [mm] half widths along x and z */
  double p_max;                    /* [MPa] largest pressure */
  double approach;                 /* [mm] approach of the bodies */
} arc_hertz_ellipse;

/* Solves Hertz' elliptic contact with the relative radii radius_x and radius_z [mm], the contact
 * modulus E_star [MPa] and the load [N]. Errors: ARC_ARGUMENT unless all of them are > 0. */
arc_status arc_hertz_ellipse_of(double radius_x, double radius_z, double E_star, double load,
                                arc_hertz_ellipse *hertz, arc_error *error);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif
