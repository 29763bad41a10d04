/* archard/space.h - contact and wear in three dimensions: two half-spaces, or layers on them.
 *
 * Axes: x along the motion, y up, z across. The upper body carries the load and stands still; the
 * lower one moves along x. Both surfaces are functions of (x, z) on cells of size_x x size_z. The
 * window is what the upper body has: nx x nz cells about x = z = 0. The lower body's cells, the
 * track, go on in x: a body moved to x has its middle there.
 *
 *   gap = recess_upper + recess_lower + depth_upper + depth_lower + K p - approach >= 0
 *   p >= 0,  p gap = 0,  sum of p size_x size_z = load
 *
 * Arrays over sites go row by row, z fastest: site = i * nz + j of the cell at x_i, z_j. Pressures
 * are those of the window's sites.
 */
#ifndef ARCHARD_SPACE_H
#define ARCHARD_SPACE_H

#include "archard/wear.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* How far an unworn surface lies inside its body at (x, z) [mm], below its outermost point. */
typedef double (*arc_recess_fn)(void *context, double x, double z);

typedef struct arc_halfspace_body {
  arc_material material;
  arc_layer layer[ARC_MOST_LAYERS]; /* from the surface inwards; thickness 0 ends them */
  double depth;                     /* [mm] of a rigid base below the surface; 0: there is none */
  double radius_x, radius_z;        /* [mm] of the surface along x and z: x^2 / 2R; 0: flat */
  arc_recess_fn recess;             /* in addition to the radii; NULL: none */
  void *context;                    /* handed to it */
} arc_halfspace_body;

typedef struct arc_halfspace_def {
  arc_halfspace_body body[ARC_BODIES];
  double size_x, size_z; /* of a cell [mm] */
  int nx, nz;            /* cells of the window */
  int track;             /* rows of the lower body: nx and an even number more; 0: nx */
  double groove;         /* [mm] > 0: the lower body is the same all along x, has one row of sites
                            of this length, and its wear is spread over it (long strokes, circles) */
  int turned;            /* the lower body moves along z: size_x, nx and track count along z, size_z
                            and nz along x; radii, recess, sites and extents keep their axes */
  int periodic;          /* the window repeats in x and z; without a track */
  int workers;           /* threads over positions; 0 and 1: the caller alone */
} arc_halfspace_def;

/* A ball of 10 mm on a flat, steel, 63 x 63 cells of 0.02 mm. */
arc_halfspace_def arc_halfspace_default(void);

/* Opaque; the definition and what follows from it. Not for two threads at once. */
typedef struct arc_halfspace arc_halfspace;

/* ARC_ARGUMENT (names field, expectation, value), ARC_GEOMETRY (cells wider than four times the
 * thinnest layer), ARC_MEMORY; *made is NULL then. The functions in the definition are called here
 * only. */
arc_status arc_halfspace_create(const arc_halfspace_def *def, arc_halfspace **made,
                                arc_error *error);
void arc_halfspace_destroy(arc_halfspace **h);
const arc_halfspace_def *arc_halfspace_definition(const arc_halfspace *h);
/* Bytes that a stage over so many positions takes. */
double arc_halfspace_bytes(const arc_halfspace_def *def, int positions);

/* Sites of a body; the area of one [mm2]; where one is [mm]. */
int arc_halfspace_sites(const arc_halfspace *h, arc_body body);
double arc_halfspace_site_area(const arc_halfspace *h, arc_body body);
void arc_halfspace_site_at(const arc_halfspace *h, arc_body body, int site, double *x, double *z);
/* The unworn recess of the body's sites [mm]. */
const double *arc_halfspace_recess(const arc_halfspace *h, arc_body body);

/* --- contact ------------------------------------------------------------------------------------
 */

/* One position of the lower body. */
typedef struct arc_halfspace_position {
  double x;    /* of the lower body [mm]; between cells both are read, and worn, by their shares */
  double load; /* [N] > 0 */
  double weight; /* sliding distance it stands for [mm], > 0 for wear */
} arc_halfspace_position;

/* How solutions are made; NULL in calls: the defaults. */
typedef struct arc_halfspace_options {
  double tolerance;               /* of gaps, share of the largest displacement; 0: 1e-5 */
  const double *gap;              /* [window] added to the gap of a single contact [mm]; NULL */
  int warm;                       /* start from the pressures that are given; 0: from the shapes */
  const arc_callbacks *callbacks; /* asked to stop; NULL */
} arc_halfspace_options;

/* What a solution cost, and came to. */
typedef struct arc_halfspace_report {
  int iterations, applications, sets, guarded; /* steps of conjugate gradients, applications of K,
                                                  active sets, steps of the fallback */
  double p_max;                                /* [MPa] over all positions */
} arc_halfspace_report;

/* One contact on worn depths [mm] by site (NULL: unworn): pressures of the window [MPa], and the
 * approach [mm]. ARC_ZONE: the contact reaches the edge of the window, or the position needs a
 * longer track; ARC_NOT_CONVERGED, ARC_NUMERIC, ARC_STOPPED, ARC_MEMORY. On failure pressure and
 * approach are unchanged. */
arc_status arc_halfspace_solve(arc_halfspace *h, const double *const depth[ARC_BODIES],
                               const arc_halfspace_position *position,
                               const arc_halfspace_options *options, double *pressure,
                               double *approach, arc_halfspace_report *report, arc_error *error);

/* Gaps of a solution [mm] on the window's sites, about 0 in contact. ARC_MEMORY. */
arc_status arc_halfspace_gaps(arc_halfspace *h, const double *const depth[ARC_BODIES],
                              const arc_halfspace_position *position, const double *pressure,
                              double approach, double *gap, arc_error *error);

/* --- friction ------------------------------------------------------------------------------------
 *
 * q is the shear on the upper body along +x and +z (on the lower one along -x, -z). A lower body
 * that moves by xi drags it along: slip of its surface over the upper one's is
 *
 *   E = xi - C q + N p,   gap has N q in addition,   |q| <= friction p, dE = 0 where less, else
 *                                                    along q
 *
 * with the compliance C of both bodies to shear, and N, which is zero for like bodies, between
 * shear and pressure. Results depend on the path: a contact is followed over increments.
 */

/* A contact with friction, and what its next increment starts from. One block at `pressure`, to be
 * freed with arc_halfspace_friction_end; zeros are bodies apart. */
typedef struct arc_halfspace_friction {
  double *pressure; /* [window] [MPa] */
  double *q[2];     /* [window] along x and z [MPa] */
  double *slip[2];  /* [window] E [mm], of sites that are apart too */
  double *moved[2]; /* [window] slip of the last increment [mm] */
  double *stick;    /* [window] 1: stuck in the last increment */
  double xi[2];     /* [mm] */
  double force[2];  /* [N] that drives the lower body */
  double approach;  /* [mm] */
  double energy;    /* [N mm] dissipated so far */
  double work;      /* [N mm] the share of the last increment */
} arc_halfspace_friction;

/* One increment, to given forces or motions. */
typedef struct arc_halfspace_increment {
  double friction;                 /* >= 0 */
  arc_halfspace_position position; /* at its end; the weight is not used */
  int by_force[2];                 /* along x and z: force instead of xi */
  double xi[2];                    /* [mm] at the end */
  double force[2];                 /* [N] at the end; less than friction times the load */
} arc_halfspace_increment;

/* What increments cost. */
typedef struct arc_halfspace_effort {
  int sweeps;                         /* between pressure and shear; 1 for like bodies */
  int sets, iterations, applications; /* of shear: sets, steps of conjugate gradients, of C */
  int flipping;   /* sets where single cells went on changing between stick and slip */
  int unfinished; /* increments of unlike bodies that ended before pressures settled */
} arc_halfspace_effort;

/* ARC_MEMORY; zeros. */
arc_status arc_halfspace_friction_begin(const arc_halfspace *h, arc_halfspace_friction *state,
                                        arc_error *error);
arc_status arc_halfspace_friction_copy(const arc_halfspace *h, const arc_halfspace_friction *from,
                                       arc_halfspace_friction *copy, arc_error *error);
void arc_halfspace_friction_end(arc_halfspace_friction *state);
/* The state on a window of the same cells, larger on all sides, with slip in the rest of it. */
arc_status arc_halfspace_friction_widen(const arc_halfspace *from,
                                        const arc_halfspace_friction *state, arc_halfspace *to,
                                        arc_halfspace_friction *wide, arc_error *error);

/* Takes a state over one increment. Work is that of the mean of friction times pressure over each
 * site's slip. Errors as of arc_halfspace_solve, and ARC_ARGUMENT for forces that friction does not
 * carry, layers, rigid bases, windows that repeat: the state is unchanged. *effort is added to. */
arc_status arc_halfspace_slide(arc_halfspace *h, const double *const depth[ARC_BODIES],
                               const arc_halfspace_increment *increment,
                               const arc_halfspace_options *options, arc_halfspace_friction *state,
                               arc_halfspace_effort *effort, arc_error *error);

/* Extents of a contact or scar. */
typedef struct arc_halfspace_extent {
  double area;                     /* [mm2] */
  double half_width, half_width_z; /* [mm] along x and z */
  double center_x, center_z;       /* [mm] middle of the extents */
  double largest;                  /* largest value, [MPa] or [mm] */
  double center;                   /* value at x = z = 0, between cells */
} arc_halfspace_extent;

/* Of a contact: where the pressure is positive; its edge is where the pressure's square, linear
 * there, falls to zero. */
arc_halfspace_extent arc_halfspace_contact_extent(const arc_halfspace *h, const double *pressure);
/* Of a scar: where the depth is above `share` of the largest, linear between sites. */
arc_halfspace_extent arc_halfspace_scar(const arc_halfspace *h, arc_body body, const double *depth,
                                        double share);

/* --- wear
 * ----------------------------------------------------------------------------------------- */

/* rate [by body][sites]: sum over the positions of weight times pressure [MPa mm] on the depths.
 * pressure [count][window]: out, and in where options->warm; NULL: kept from nobody. On failure
 * rate and pressure are unchanged. */
arc_status arc_halfspace_rate(arc_halfspace *h, const double *const depth[ARC_BODIES],
                              const arc_halfspace_position *position, int count,
                              const arc_halfspace_options *options, double *pressure,
                              double *const rate[ARC_BODIES], arc_halfspace_report *report,
                              arc_error *error);

/* sum [sites] of a body: over the positions, weight times a value [count][window], for what is not
 * proportional to pressure, as power laws, and for energies. On failure sum is unchanged. */
arc_status arc_halfspace_sum(arc_halfspace *h, const arc_halfspace_position *position, int count,
                             const double *value, arc_body body, double *sum, arc_error *error);

/* Wear of a step: depth = known + c factor rate, by body. */
typedef struct arc_halfspace_wear {
  double c[ARC_BODIES];             /* [mm2/N], times cycles */
  const double *factor[ARC_BODIES]; /* by site, >= 0; NULL: 1 */
} arc_halfspace_wear;

/* The implicit stage: depths z with z = known + c factor rate(z), for all positions at once. depth
 * may be the same arrays as known. */
arc_status arc_halfspace_stage(arc_halfspace *h, const double *const known[ARC_BODIES],
                               const arc_halfspace_wear *wear,
                               const arc_halfspace_position *position, int count,
                               const arc_halfspace_options *options, double *pressure,
                               double *const depth[ARC_BODIES], arc_halfspace_report *report,
                               arc_error *error);

/* The largest eigenvalue of - d (c factor rate) / d depth, on the active sets of the pressures
 * [count][window] that belong to the depths: explicit steps are stable below 2 / it. To a few per
 * cent. */
arc_status arc_halfspace_eigenvalue(arc_halfspace *h, const arc_halfspace_wear *wear,
                                    const arc_halfspace_position *position, int count,
                                    const double *pressure, double *eigenvalue, arc_error *error);

/* Depths of one half-space on the sites of another one, larger or finer: copied where the cells
 * coincide, else linear between sites, with the volume kept. ARC_ZONE: worn sites have no place. */
arc_status arc_halfspace_regrow(const arc_halfspace *from, const double *const depth[ARC_BODIES],
                                const arc_halfspace *to, double *const grown[ARC_BODIES],
                                arc_error *error);

/* Cells and sizes for a run: cells of a share 1 / fineness of the unworn contact's half width, a
 * whole number of which fit `increment` [mm] (0: any), and a window for the volume [mm3] worn at
 * the end, an estimate: contacts that reach its edge are ARC_ZONE. Sets size_x, size_z, nx, nz and
 * track for a stroke [mm]; nothing where the bodies' radii make no contact of a point. */
void arc_halfspace_fit(arc_halfspace_def *def, double load, double volume, double stroke,
                       double increment, double fineness);

/* --- depths to start from -----------------------------------------------------------------------
 */

/* An unworn shape on a model in 3-D, on the cells that a run of this definition begins with, its
 * window at least from -half_x to half_x and -half_z to half_z [mm]. ARC_ARGUMENT, ARC_MEMORY;
 * *shape is NULL then. */
arc_status arc_space_given_create(arc_model *model, const arc_wear_def *def, double half_x,
                                  double half_z, arc_shape **shape, arc_error *error);
/* Number of sites of a body, and where they are [mm]: arrays of the shape. A groove's are at x = 0.
 */
int arc_space_given_sites(const arc_shape *shape, arc_body body, const double **x,
                          const double **z);
/* Sets the depths of a body [mm] by site. ARC_ARGUMENT (a depth below 0), ARC_ZONE (one above 0 at
 * the border of the window, beyond which more is worn): the shape is unchanged. */
arc_status arc_space_given_depths(arc_shape *shape, arc_body body, const double *depth,
                                  arc_error *error);

/* --- below the surface --------------------------------------------------------------------------
 */

/* Stresses [MPa] at depth y <= 0 [mm] below the window's sites under pressures, in the body of
 * Poisson's ratio nu: [6][window] of xx, yy, zz, xy, yz, xz; tension is positive. For homogeneous
 * half-spaces. ARC_MEMORY. */
arc_status arc_halfspace_stress(const arc_halfspace *h, const double *pressure, double nu, double y,
                                double *stress, arc_error *error);

/* The same below the contact of a model in 3-D, on the window of its shape; y = 0 is the surface of
 * either body, and y < 0 inside it. ARC_ARGUMENT: the body has layers or a base, or was worn along
 * z. */
arc_status arc_space_contact_stress(const arc_contact *contact, arc_body body, double y,
                                    double *stress, arc_error *error);

/* --- closed form ---------------------------------------------------------------------------------
 */

/* Hertz' contact of surfaces with relative radii along x and z. */
typedef struct arc_hertz_ellipse {
  double half_width, half_width_z; /* [mm] */
  double p_max;                    /* [MPa] */
  double approach;                 /* [mm] */
} arc_hertz_ellipse;

/* radius_x, radius_z, E_star and load above 0, else ARC_ARGUMENT. */
arc_status arc_hertz_ellipse_of(double radius_x, double radius_z, double E_star, double load,
                                arc_hertz_ellipse *hertz, arc_error *error);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif
