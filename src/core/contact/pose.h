/* The contact with the plate at one position: mortar coupling, contact matrix, solution with warm
 * start.
 *
 * Everything is in the cylinder's frame and per mm of thickness. B [candidates x plate nodes] takes
 * plate nodal values to cylinder nodes; plate forces are B'f, so that forces balance to rounding. g
 * = gap - approach + A f with A = F_c + B F_p B'. f are the components along y of forces along the
 * plate's normals, so that their sum is the load; pressures are f over widths along x (mortar.c).
 */
#ifndef CONTACT_POSE_H
#define CONTACT_POSE_H

#include "core/contact/shape.h"

typedef struct pose {
  double x;                   /* [mm] plate position */
  double angle;               /* [rad] of the load, along s; 0 but in holes */
  int aimed;                  /* whether `down` belongs to it */
  const arc_shape *shape;     /* of the last arc_pose_update, for the solution that follows */
  const revolution *revolved; /* of the bodies it was placed on */
  long version;               /* of the compliance it was placed on, see arc_shape; 0: none */
  int nc, np;                 /* surface nodes of cylinder and plate */
  int lo, count;              /* candidates: cylinder nodes lo .. lo + count - 1 */
  int width;                  /* row length of B */
  int *first;                 /* [nc] first plate node of each row of B, by candidate */
  double *b;                  /* [nc * width] rows of B */
  double *wc, *wp;            /* [nc], [np] tributary widths along x [mm] */
  double *slope;   /* [nc] dy/dx of the surface at each candidate, else 0: forces along x are
                      -slope f */
  double *down;    /* [nc] share of a candidate's force that carries load: 1 but on polar
                      charts; the approach opens and closes gaps by it */
  double *a;       /* [count x count] A [mm2/N] */
  double *gap;     /* [nc] initial gap of the candidates [mm] */
  double *f;       /* [nc] solution: nodal forces [N/mm], by candidate */
  double *open;    /* [nc] solution: gap left [mm], by candidate */
  double approach; /* [mm] */
  int iterations;  /* of the last solution; all of them count */
  int active;      /* size of the active set */
  int *set;        /* [nc] the active candidates in increasing order */
  int *joined;     /* [nc] work: the next set */
  int *made, of;   /* [nc] the set that factor and ones were made for, `of` candidates */
  double *factor;  /* [of x of] Cholesky factor of A on that set */
  double *ones;    /* [nc] (A_set)^-1 down */
  int factored;    /* factor and ones belong to A */
  double *work;    /* [5 * (nc + np)] */
} pose;

/* Room for a pose on a model; ARC_MEMORY leaves it empty. */
arc_status arc_pose_create(pose *p, const arc_model *model);
void arc_pose_free(pose *p);
/* Bytes of one pose. */
size_t arc_pose_bytes(const pose *p);

/* Brings a pose up to date with a shape and the plate at x [mm]: places and stiffens it anew where
 * the compliance or the position is another one, and measures the gaps. ARC_ZONE and ARC_MEMORY as
 * arc_pose_place: the pose is then out of date. */
arc_status arc_pose_update(pose *p, const arc_shape *shape, double x, arc_error *error);

/* Has the load come from an angle [rad] from the next update on. */
void arc_pose_aim(pose *p, double angle);

/* What it consists of. B and tributary widths for the plate at x [mm], from where the nodes stood
 * along x at the last condensation: coupling and compliance always belong together. ARC_ZONE where
 * fewer than three candidates remain, ARC_MEMORY. */
arc_status arc_pose_place(pose *p, const arc_shape *shape, double x, arc_error *error);
/* What forces carry of the load at the pose's angle. */
void arc_pose_find_down(pose *p, const arc_shape *shape);
/* Contact matrix from the shape's present compliance. */
void arc_pose_stiffen(pose *p, const arc_shape *shape);
/* Initial gaps along y from the shape's present levels. */
void arc_pose_measure(pose *p, const arc_shape *shape);

/* Solves for `line`, the load per thickness [N/mm]. On ARC_ZONE (contact at the edge of the
 * candidates) and ARC_NUMERIC the warm start is dropped, nothing else changes. */
arc_status arc_pose_solve(pose *p, double line, arc_error *error);

/* A pose that has not been solved yet begins where a neighbour's contact is: else all candidates
 * are thought to touch, and their factorisations cost more than many solutions. Results are the
 * same. */
void arc_pose_follow(pose *p, const pose *neighbour);

/* Whether the solution keeps off the edges of the candidates; else ARC_ZONE, and the warm start is
 * dropped. */
arc_status arc_pose_check_zone(pose *p, arc_error *error);
/* ARC_NUMERIC in words, and drops the warm start. */
arc_status arc_pose_broke_down(pose *p, arc_error *error);

/* Adds to the gaps what the drift of both compliances does under the solution's forces
 * (compliance_update.c). Returns 0 where there is no drift. */
int arc_pose_add_drift(pose *p);

/* Forces of the solution at all cylinder nodes, f [nc]. */
void arc_pose_forces(const pose *p, double *f);
/* Forces of the solution on a body's surface nodes [N/mm], along x at all nodes first, then along
 * y: those on both bodies balance to rounding. force [2 * surface]. */
void arc_pose_forces_on(const pose *p, arc_body body, double *force);
/* Pressures [MPa] of the solution at all surface nodes: pc [nc], pp [np]. */
void arc_pose_pressures(const pose *p, double *pc, double *pp);
/* A density on the cylinder, from [nc], becomes the one on the plate under it, to [np]: their
 * integrals along x are the same, and where the first is not negative neither is the second. */
void arc_pose_transfer(const pose *p, const double *from, double *to);
/* Pressure [MPa] at the cylinder's lowest node, that under the load, and the largest at any of its
 * nodes. */
void arc_pose_peaks(const pose *p, double *center, double *largest);
/* How far pressures jump between neighbouring nodes of the cylinder within `reach` [mm] of the
 * lowest one: the largest distance of one from the mean of the two beside it, over the mean of all
 * [-]. */
double arc_pose_ripple(const pose *p, const arc_shape *shape, double reach);
/* The largest pressure averaged over a length [mm] of the cylinder's surface along x, of pressures
 * constant around each node. */
double arc_pose_average(const pose *p, const arc_shape *shape, double length);
/* Elastic displacement of a body along x [mm] at its surface nodes, u [surface]. */
void arc_pose_tangential(const pose *p, const arc_shape *shape, arc_body body, double *u);
/* result [nc] := B v for the candidates, 0 elsewhere; v [np]. */
void arc_pose_to_cylinder(const pose *p, const double *v, double *result);
/* result [np] := B' v; v by cylinder node [nc]. */
void arc_pose_to_plate(const pose *p, const double *v, double *result);
/* One end of the contact (edge.c). */
typedef struct contact_edge {
  double x;      /* [mm] in the cylinder's frame */
  double width;  /* [mm] of the element it lies in */
  double smooth; /* 1: the surfaces meet smoothly there, as Hertz' do; 0: at a kink */
  int out;       /* 1: the right end, -1: the left one */
  double c[2];   /* pressure c0 sqrt(d) + c1 d sqrt(d) at d inside [MPa, mm] */
} contact_edge;
contact_edge arc_pose_edge(const pose *p, const arc_shape *shape, int right);
/* Contact edges [mm], left and right. */
void arc_pose_edges(const pose *p, const arc_shape *shape, double edges[2]);
/* Nodal pressures, or a shear that is `share` of them, p [n] [MPa] at x [n] (the cylinder's frame)
 * become those at the points: within two elements of a smooth edge and beyond it the law replaces
 * them. Forces are no longer kept. */
void arc_edge_sharpen(const contact_edge *edge, int n, const double *x, double share, double *p);
/* A shear that is `share` of the pressure and ends with it leaves a cusp in the stress along the
 * surface. Adds what means between a node and those beside it miss of that [MPa], to cusp [n]. */
void arc_edge_add_cusp(const contact_edge *edge, int n, const double *x, double share,
                       double *cusp);

/* The complementarity problem (lcp.c): finds p's set, factor, ones, f, approach for a load
 * per thickness [N/mm], from the set as a warm start. */
arc_status arc_lcp_solve(pose *p, double line);
/* factor and ones of the set at hand, which friction may have found without them. Non-zero: A is
 * not definite there. */
int arc_lcp_factorise(pose *p);

#endif
