/* archard/space.h - contact and wear in three dimensions: two half-spaces, or layers on them.
 *
 * Axes: x along the motion, y up, z across. The upper body carries the load and does not move; the
 * lower one moves along x. Both surfaces are functions of (x, z) on cells of size_x x size_z. The
 * window is the grid of the upper body: nx x nz cells about x = z = 0. The track is the grid of the
 * lower body, longer in x; its middle is at the position x of the body.
 *
 *   gap = recess_upper + recess_lower + depth_upper + depth_lower + K p - approach >= 0
 *   p >= 0,  p gap = 0,  sum of p size_x size_z = load
 *
 * Arrays over sites are stored row by row, z fastest: site = i * nz + j of the cell at x_i, z_j.
 * Pressures are those of the window's sites.
 */
#ifndef ARCHARD_SPACE_H
#define ARCHARD_SPACE_H

#include "archard/wear.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* Distance of an unworn surface at (x, z) [mm] below the outermost point of its body [mm]. */
typedef double (*arc_recess_fn)(void *context, double x, double z);

typedef struct arc_halfspace_body {
  arc_material material;
  arc_layer layer[ARC_MOST_LAYERS]; /* from the surface inwards; thickness 0 ends them */
  double depth;                     /* [mm] of a rigid base below the surface; 0: none */
  double radius_x, radius_z;        /* [mm] of the surface along x and z: x^2 / 2R; 0: flat */
  arc_recess_fn recess;             /* in addition to the radii; NULL: none */
  void *context;                    /* argument of recess */
} arc_halfspace_body;

typedef struct arc_halfspace_def {
  arc_halfspace_body body[ARC_BODIES];
  double size_x, size_z; /* of a cell [mm] */
  int nx, nz;            /* cells of the window */
  int track;             /* rows of the lower body: nx plus an even number; 0: nx */
  double groove; /* [mm] > 0: the lower body is uniform along x, with one row of sites of this
                    length over which its wear is spread (long strokes, circles) */
  int turned;    /* the lower body moves along z: size_x, nx and track count along z, size_z
                    and nz along x; radii, recess, sites and extents keep their axes */
  int periodic;  /* the window repeats in x and z; the lower body has a groove or no track */
  int workers;   /* threads over positions; 0 and 1: the caller alone */
} arc_halfspace_def;

/* A steel ball of 10 mm radius on a flat, 63 x 63 cells of 0.02 mm. */
arc_halfspace_def arc_halfspace_default(void);

/* Two half-spaces with their grids and kernels. Opaque; not for two threads at once. */
typedef struct arc_halfspace arc_halfspace;

/* Creates the half-spaces; calls the functions of the definition here only. Errors: ARC_ARGUMENT
 * (field, expected, given), ARC_GEOMETRY (cells wider than four times the thinnest layer),
 * ARC_MEMORY; *made is NULL then. */
arc_status arc_halfspace_create(const arc_halfspace_def *def, arc_halfspace **made,
                                arc_error *error);
void arc_halfspace_destroy(arc_halfspace **h);
const arc_halfspace_def *arc_halfspace_definition(const arc_halfspace *h);
/* Memory of a stage over `positions` positions [bytes]. */
double arc_halfspace_bytes(const arc_halfspace_def *def, int positions);

/* Number of sites of a body; area of a site [mm2]; position of a site [mm]. */
int arc_halfspace_sites(const arc_halfspace *h, arc_body body);
double arc_halfspace_site_area(const arc_halfspace *h, arc_body body);
void arc_halfspace_site_at(const arc_halfspace *h, arc_body body, int site, double *x, double *z);
/* The unworn recess of the body's sites [mm]. */
const double *arc_halfspace_recess(const arc_halfspace *h, arc_body body);

/* --- contact ---------------------------------------------------------------------------------- */

/* One position of the lower body. */
typedef struct arc_halfspace_position {
  double x;      /* of the lower body [mm]; between two cells by linear interpolation */
  double load;   /* [N] > 0 */
  double weight; /* sliding distance of this position [mm], > 0 for wear */
} arc_halfspace_position;

/* Options of the solver; NULL in calls: the defaults. */
typedef struct arc_halfspace_options {
  double tolerance;               /* of gaps, relative to the largest displacement; 0: 1e-5 */
  const double *gap;              /* [positions][window] added to the gaps [mm]; NULL */
  int warm;                       /* 1: start from the given pressures; 0: from the shapes */
  const arc_callbacks *callbacks; /* may stop the solver; NULL: none */
} arc_halfspace_options;

/* Work of a solution, and its largest pressure. */
typedef struct arc_halfspace_report {
  int iterations, applications, sets, guarded; /* steps of conjugate gradients, applications of K,
                                                  active sets, steps of the fallback */
  double p_max;                                /* [MPa] over all positions */
} arc_halfspace_report;

/* Solves one contact on worn depths [mm] by site (NULL: unworn): pressures of the window [MPa] and
 * approach [mm]. ARC_ZONE: the contact reaches the edge of the window, or the position needs a
 * longer track; ARC_NOT_CONVERGED, ARC_NUMERIC, ARC_STOPPED, ARC_MEMORY. On failure pressure and
 * approach are unchanged. */
arc_status arc_halfspace_solve(arc_halfspace *h, const double *const depth[ARC_BODIES],
                               const arc_halfspace_position *position,
                               const arc_halfspace_options *options, double *pressure,
                               double *approach, arc_halfspace_report *report, arc_error *error);

/* Computes the gaps of a solution [mm] on the window, about 0 in contact. ARC_MEMORY. */
arc_status arc_halfspace_gaps(arc_halfspace *h, const double *const depth[ARC_BODIES],
                              const arc_halfspace_position *position, const double *pressure,
                              double approach, double *gap, arc_error *error);

/* --- friction ------------------------------------------------------------------------------------
 *
 * q is the shear on the upper body along +x and +z (on the lower one along -x, -z). The lower body
 * moves by xi; slip of its surface relative to the upper one is
 *
 *   E = xi - C q + N p, |q| <= friction p, dE = 0 if less, else along q; the gap has N q in
 * addition
 *
 * with the shear compliance C of both bodies and the coupling N of shear and pressure, which is
 * zero for equal materials. Results depend on the history: a contact is computed over increments.
 */

/* State of a contact with friction. One block at `pressure`, released by
 * arc_halfspace_friction_end; zeros: the bodies are apart. */
typedef struct arc_halfspace_friction {
  double *pressure; /* [window] [MPa] */
  double *q[2];     /* [window] along x and z [MPa] */
  double *slip[2];  /* [window] E [mm], also of open sites */
  double *moved[2]; /* [window] slip of the last increment while in contact [mm] */
  double *stick;    /* [window] 1 if stuck in the last increment, else 0 */
  double xi[2];     /* [mm] */
  double force[2];  /* [N] on the lower body */
  double approach;  /* [mm] */
  double energy;    /* [N mm] dissipated so far */
  double work;      /* [N mm] dissipated in the last increment */
} arc_halfspace_friction;

/* One increment of prescribed forces or motions. */
typedef struct arc_halfspace_increment {
  double friction;                 /* >= 0 */
  arc_halfspace_position position; /* at its end; the weight is not used */
  int by_force[2];                 /* along x and z: force instead of xi */
  double xi[2];                    /* [mm] at the end */
  double force[2];                 /* [N] at the end; less than friction times the load */
  const double *pressure; /* [window] at the end, where it is known, as for equal materials;
                             NULL: solved for. The approach is kept then */
  const arc_halfspace_friction *guess; /* shear, motion and stick zone to start from; NULL: those
                                          of the state */
} arc_halfspace_increment;

/* Work of increments. */
typedef struct arc_halfspace_effort {
  int increments;                     /* of legs */
  int sweeps;                         /* between pressure and shear; 1 for equal materials */
  int sets, iterations, applications; /* of shear: sets, steps of conjugate gradients, of C */
  int flipping;   /* sets in which single cells alternated between stick and slip */
  int unfinished; /* increments of different materials that ended before pressures converged */
  int unresolved; /* parts of legs that halving still changed when they were not halved further */
} arc_halfspace_effort;

/* Allocates a state of zeros. ARC_MEMORY. */
arc_status arc_halfspace_friction_begin(const arc_halfspace *h, arc_halfspace_friction *state,
                                        arc_error *error);
arc_status arc_halfspace_friction_copy(const arc_halfspace *h, const arc_halfspace_friction *from,
                                       arc_halfspace_friction *copy, arc_error *error);
void arc_halfspace_friction_end(arc_halfspace_friction *state);
/* Copies a state to a larger window of equal cells; slip outside is computed. */
arc_status arc_halfspace_friction_widen(const arc_halfspace *from,
                                        const arc_halfspace_friction *state, arc_halfspace *to,
                                        arc_halfspace_friction *wide, arc_error *error);

/* Advances a state by one increment. The work is the mean friction times pressure times the slip of
 * each site. Errors of arc_halfspace_solve, and ARC_ARGUMENT for forces above friction times load,
 * layers, rigid bases or periodic windows: the state is unchanged. Adds to *effort. */
arc_status arc_halfspace_slide(arc_halfspace *h, const double *const depth[ARC_BODIES],
                               const arc_halfspace_increment *increment,
                               const arc_halfspace_options *options, arc_halfspace_friction *state,
                               arc_halfspace_effort *effort, arc_error *error);

/* Load and motion or force that change in proportion, from those of a state. */
typedef struct arc_halfspace_leg {
  arc_halfspace_increment to;
  double x, load; /* at the start [mm], [N] */
  int increments; /* equal ones; 0: halved until motion, force and work change no more */
} arc_halfspace_leg;

/* Advances a state along a leg. Halving ends where it changes shear by less than 1e-3 and motion by
 * less than 1e-4 of those of full slip, and the work by less than 1e-3 of the leg's or 1e-2 of
 * itself. `coarser` (NULL: none) follows
 * the same history in half as many increments: the difference of the energies is about the error
 * where it falls with the length of increments, as where the direction of slip turns, and more than
 * it elsewhere; given increments do not change it. Errors of arc_halfspace_slide: the states are
 * unchanged. Adds to *effort. */
arc_status arc_halfspace_follow(arc_halfspace *h, const double *const depth[ARC_BODIES],
                                const arc_halfspace_leg *leg, const arc_halfspace_options *options,
                                arc_halfspace_friction *state, arc_halfspace_friction *coarser,
                                arc_halfspace_effort *effort, arc_error *error);

/* Extents of a contact or scar. */
typedef struct arc_halfspace_extent {
  double area;                     /* [mm2] */
  double half_width, half_width_z; /* [mm] along x and z */
  double center_x, center_z;       /* [mm] middle of the extents */
  double largest;                  /* largest value, [MPa] or [mm] */
  double center;                   /* value at x = z = 0, between cells */
} arc_halfspace_extent;

/* Extent of the positive pressures; at the edge the square of the pressure is extrapolated linearly
 * to zero. */
arc_halfspace_extent arc_halfspace_contact_extent(const arc_halfspace *h, const double *pressure);
/* Extent of depths above `share` of the largest, linear between sites. */
arc_halfspace_extent arc_halfspace_scar(const arc_halfspace *h, arc_body body, const double *depth,
                                        double share);

/* --- wear ------------------------------------------------------------------------------------- */

/* Computes rate [body][sites], the sum over positions of weight times pressure [MPa mm] on the
 * given depths. pressure [count][window] is output, and input if options->warm; NULL: not returned.
 * On failure rate and pressure are unchanged. */
arc_status arc_halfspace_rate(arc_halfspace *h, const double *const depth[ARC_BODIES],
                              const arc_halfspace_position *position, int count,
                              const arc_halfspace_options *options, double *pressure,
                              double *const rate[ARC_BODIES], arc_halfspace_report *report,
                              arc_error *error);

/* Computes sum [sites] of a body over the positions of weight times value [count][window], for
 * power laws and energies. On failure sum is unchanged. */
arc_status arc_halfspace_sum(arc_halfspace *h, const arc_halfspace_position *position, int count,
                             const double *value, arc_body body, double *sum, arc_error *error);

/* Wear of a step: depth = known + c factor rate, by body. */
typedef struct arc_halfspace_wear {
  double c[ARC_BODIES];             /* [mm2/N], times cycles */
  const double *factor[ARC_BODIES]; /* by site, >= 0; NULL: 1 */
} arc_halfspace_wear;

/* Solves the implicit stage z = known + c factor rate(z) for the depths z, all positions at once.
 * depth may be the same arrays as known. */
arc_status arc_halfspace_stage(arc_halfspace *h, const double *const known[ARC_BODIES],
                               const arc_halfspace_wear *wear,
                               const arc_halfspace_position *position, int count,
                               const arc_halfspace_options *options, double *pressure,
                               double *const depth[ARC_BODIES], arc_halfspace_report *report,
                               arc_error *error);

/* Largest eigenvalue of - d (c factor rate) / d depth, on the active sets of the pressures
 * [count][window], to a few per cent: explicit steps are stable below 2 / eigenvalue. */
arc_status arc_halfspace_eigenvalue(arc_halfspace *h, const arc_halfspace_wear *wear,
                                    const arc_halfspace_position *position, int count,
                                    const double *pressure, double *eigenvalue, arc_error *error);

/* Transfers depths to the sites of another half-space, larger or finer: copied if the cells
 * coincide, else linear between sites with the same volume. ARC_ZONE: worn sites lie outside. */
arc_status arc_halfspace_regrow(const arc_halfspace *from, const double *const depth[ARC_BODIES],
                                const arc_halfspace *to, double *const grown[ARC_BODIES],
                                arc_error *error);

/* Sets size_x, size_z, nx, nz and track for a run: cells of the unworn contact's half width /
 * fineness, a divisor of `increment` [mm] (0: any), a window estimated for the final wear volume
 * [mm3] (contacts that reach its edge are ARC_ZONE) and a track for the stroke [mm]. Sets nothing
 * if the radii give no point contact. */
void arc_halfspace_fit(arc_halfspace_def *def, double load, double volume, double stroke,
                       double increment, double fineness);

/* --- depths to start from --------------------------------------------------------------------- */

/* Creates an unworn shape on a model in 3-D, with the initial cells of a run of this definition and
 * a window of at least |x| <= half_x, |z| <= half_z [mm]. ARC_ARGUMENT, ARC_MEMORY; *shape is NULL
 * then. */
arc_status arc_space_given_create(arc_model *model, const arc_wear_def *def, double half_x,
                                  double half_z, arc_shape **shape, arc_error *error);
/* Returns the number of sites of a body and their positions [mm], arrays owned by the shape. Sites
 * of a groove have x = 0. */
int arc_space_given_sites(const arc_shape *shape, arc_body body, const double **x,
                          const double **z);
/* Sets the depths of a body [mm] by site. ARC_ARGUMENT (a negative depth), ARC_ZONE (a depth > 0 at
 * the border of the window): the shape is unchanged. */
arc_status arc_space_given_depths(arc_shape *shape, arc_body body, const double *depth,
                                  arc_error *error);

/* --- below the surface ------------------------------------------------------------------------ */

/* Computes the stresses [MPa] at y <= 0 [mm] below the sites of the window, for given pressures and
 * Poisson's ratio nu: [6][window] of xx, yy, zz, xy, yz, xz, tension positive. For homogeneous
 * half-spaces. ARC_MEMORY. */
arc_status arc_halfspace_stress(const arc_halfspace *h, const double *pressure, double nu, double y,
                                double *stress, arc_error *error);

/* The same for a contact of a model in 3-D, on the window of its shape; y = 0 is the surface of
 * either body, y < 0 inside. ARC_ARGUMENT: the body has layers or a base, or was worn along z. */
arc_status arc_space_contact_stress(const arc_contact *contact, arc_body body, double y,
                                    double *stress, arc_error *error);

/* --- closed form ------------------------------------------------------------------------------ */

/* Hertz' contact of surfaces with relative radii along x and z. */
typedef struct arc_hertz_ellipse {
  double half_width, half_width_z; /* [mm] */
  double p_max;                    /* [MPa] */
  double approach;                 /* [mm] */
} arc_hertz_ellipse;

/* Solves Hertz' elliptic contact. ARC_ARGUMENT unless radius_x, radius_z [mm], E_star [MPa] and
 * load [N] > 0. */
arc_status arc_hertz_ellipse_of(double radius_x, double radius_z, double E_star, double load,
                                arc_hertz_ellipse *hertz, arc_error *error);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif
