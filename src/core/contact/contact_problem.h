/* The contact with the plate at one position: mortar coupling, contact matrix, solution with warm
 * start.
 *
 * Everything is in the cylinder's frame and per mm of thickness. B [candidates x plate nodes] takes
 * plate nodal values to cylinder nodes; plate forces are B'f, so that forces balance to rounding. g
 * = gap - approach + A f with A = F_c + B F_p B'. f are the components along y of forces along the
 * plate's normals, so that their sum is the load; pressures are f over widths along x (mortar.c).
 */
#ifndef CONTACT_CONTACT_PROBLEM_H
#define CONTACT_CONTACT_PROBLEM_H

#include "core/contact/shape.h"

typedef struct contact_problem {
  double x;                   /* [mm] plate position */
  double angle;               /* [rad] of the load, along s; 0 but in holes */
  int aimed;                  /* 1 if `down` is up to date */
  const arc_shape *shape;     /* of the last arc_contact_problem_update, for the next solution */
  const revolution *revolved; /* of the bodies of the last placement */
  long version;    /* version of the compliance of the last placement, see arc_shape; 0: none */
  int nc, np;      /* surface nodes of cylinder and plate */
  int lo, count;   /* candidates: cylinder nodes lo .. lo + count - 1 */
  int width;       /* row length of B */
  int *first;      /* [nc] first plate node of each row of B, by candidate */
  double *b;       /* [nc * width] rows of B */
  double *wc, *wp; /* [nc], [np] tributary widths along x [mm] */
  double *slope;   /* [nc] dy/dx of the surface at each candidate, else 0: forces along x are
                      -slope f */
  double *down; /* [nc] share of a candidate's force along the load, 1 except on polar charts; also
                   d gap / d approach */
  double *a;    /* [count x count] A [mm2/N] */
  double *gap;  /* [nc] initial gap of the candidates [mm] */
  double *f;    /* [nc] solution: nodal forces [N/mm], by candidate */
  double *open; /* [nc] solution: gap left [mm], by candidate */
  double approach; /* [mm] */
  int iterations;  /* iterations of the last solution */
  int active;      /* size of the active set */
  int *set;        /* [nc] the active candidates in increasing order */
  int *joined;     /* [nc] work: the next set */
  int *made, of;   /* [nc] set of the present factor and ones, `of` candidates */
  double *factor;  /* [of x of] Cholesky factor of A on that set */
  double *ones;    /* [nc] (A_set)^-1 down */
  int factored;    /* 1 if factor and ones are valid for A */
  /* workspaces, each used by one function and its callees */
  double *column;   /* [np] of the assembly of A */
  double *weighted; /* [nc] of transfers to the plate */
  double *nodal;    /* [2 nc] of forces on a body */
  double *on_body;  /* [2 (nc + np)] of displacements along x */
  double *drift;    /* [3 nc + 2 np] of the change of compliance */
  double *step;     /* [2 nc] of the complementarity problem, and of its error in a stage */
} contact_problem;

/* Allocates a problem for a model. ARC_MEMORY: it is empty. */
arc_status arc_contact_problem_create(contact_problem *p, const arc_model *model);
void arc_contact_problem_free(contact_problem *p);
/* Memory of one problem [bytes]. */
size_t arc_contact_problem_bytes(const contact_problem *p);

/* Updates a problem for a shape and the plate at x [mm]: coupling and contact matrix if compliance
 * or position have changed, and the gaps. ARC_ZONE and ARC_MEMORY of arc_contact_problem_place: the
 * problem is then invalid. */
arc_status arc_contact_problem_update(contact_problem *p, const arc_shape *shape, double x,
                                      arc_error *error);

/* Sets the angle of the load [rad] from the next update on. */
void arc_contact_problem_set_angle(contact_problem *p, double angle);

/* Steps of arc_contact_problem_update. Computes B and tributary widths for the plate at x [mm] from
 * the positions along x at the last condensation, so that coupling and compliance match. ARC_ZONE:
 * fewer than three candidates; ARC_MEMORY. */
arc_status arc_contact_problem_couple(contact_problem *p, const arc_shape *shape, double x,
                                      arc_error *error);
/* Computes the shares of forces along the load. */
void arc_contact_problem_compute_down(contact_problem *p, const arc_shape *shape);
/* Computes the contact matrix from the present compliance of the shape. */
void arc_contact_problem_assemble(contact_problem *p, const arc_shape *shape);
/* Computes the initial gaps along y from the present heights of the shape. */
void arc_contact_problem_update_gaps(contact_problem *p, const arc_shape *shape);

/* Solves for `line`, the load per thickness [N/mm]. On ARC_ZONE (contact at the edge of the
 * candidates) and ARC_NUMERIC the warm start is dropped, nothing else changes. */
arc_status arc_contact_problem_solve(contact_problem *p, double line, arc_error *error);

/* Starts an unsolved problem from the active set of a neighbour. Otherwise all candidates are
 * active at first, which is expensive. Results are the same. */
void arc_contact_problem_start_from(contact_problem *p, const contact_problem *neighbour);

/* Checks that the contact does not reach the edges of the candidates; else ARC_ZONE, and the warm
 * start is dropped. */
arc_status arc_contact_problem_check_zone(contact_problem *p, arc_error *error);
/* Fails with ARC_NUMERIC and drops the warm start. */
arc_status arc_contact_problem_fail(contact_problem *p, arc_error *error);

/* Adds the change of both compliances times the forces to the gaps (compliance_update.c). Returns 0
 * if there is none. */
int arc_contact_problem_add_compliance_change(contact_problem *p);

/* Forces of the solution at all cylinder nodes, f [nc]. */
void arc_contact_problem_forces(const contact_problem *p, double *f);
/* Forces of the solution on a body's surface nodes [N/mm], along x at all nodes first, then along
 * y: those on both bodies balance to rounding. force [2 * surface]. */
void arc_contact_problem_forces_on(const contact_problem *p, arc_body body, double *force);
/* Pressures [MPa] of the solution at all surface nodes: pc [nc], pp [np]. */
void arc_contact_problem_pressures(const contact_problem *p, double *pc, double *pp);
/* Maps a density on the cylinder, from [nc], to the plate, to [np], with the same integral along x;
 * non-negative densities stay non-negative. */
void arc_contact_problem_transfer(const contact_problem *p, const double *from, double *to);
/* Pressure [MPa] at the cylinder's node in the direction of the load, and the largest nodal
 * pressure. */
void arc_contact_problem_peaks(const contact_problem *p, double *center, double *largest);
/* Sawtooth measure of the pressures within `reach` [mm] of the cylinder's lowest node: largest
 * difference of a node from the mean of its neighbours, relative to the mean pressure [-]. */
double arc_contact_problem_ripple(const contact_problem *p, const arc_shape *shape, double reach);
/* The largest pressure averaged over a length [mm] of the cylinder's surface along x, of pressures
 * constant around each node. */
double arc_contact_problem_average(const contact_problem *p, const arc_shape *shape, double length);
/* Elastic displacement of a body along x [mm] at its surface nodes, u [surface]. */
void arc_contact_problem_tangential(const contact_problem *p, const arc_shape *shape, arc_body body,
                                    double *u);
/* result [nc] := B v for the candidates, 0 elsewhere; v [np]. */
void arc_contact_problem_to_cylinder(const contact_problem *p, const double *v, double *result);
/* result [np] := B' v; v by cylinder node [nc]. */
void arc_contact_problem_to_plate(const contact_problem *p, const double *v, double *result);
/* One end of the contact (edge.c). */
typedef struct contact_edge {
  double x;      /* [mm] in the cylinder's frame */
  double width;  /* [mm] of the element it lies in */
  double smooth; /* 1: smooth contact as in Hertz' theory; 0: at a kink */
  int out;       /* 1: the right end, -1: the left one */
  double c[2];   /* pressure c0 sqrt(d) + c1 d sqrt(d) at d inside [MPa, mm] */
} contact_edge;
contact_edge arc_contact_problem_edge(const contact_problem *p, const arc_shape *shape, int right);
/* Contact edges [mm], left and right. */
void arc_contact_problem_edges(const contact_problem *p, const arc_shape *shape, double edges[2]);
/* Replaces nodal pressures, or a shear of `share` times them, p [n] [MPa] at x [n] (the cylinder's
 * frame), by point values: within two elements of a smooth edge and outside it by the edge law. The
 * sum of forces is not conserved. */
void arc_edge_sharpen(const contact_edge *edge, int n, const double *x, double share, double *p);
/* A shear of `share` times the pressure causes a cusp in the stress along the surface at the edge.
 * Adds the difference from nodal means [MPa] to cusp [n]. */
void arc_edge_add_cusp(const contact_edge *edge, int n, const double *x, double share,
                       double *cusp);

/* The complementarity problem (lcp.c): computes p's set, factor, ones, f, approach for a load per
 * thickness [N/mm], from the set as a warm start. */
arc_status arc_lcp_solve(contact_problem *p, double line);
/* Computes factor and ones of the present set, if friction has not. Non-zero: A is not positive
 * definite on it. */
int arc_lcp_factorise(contact_problem *p);

#endif
