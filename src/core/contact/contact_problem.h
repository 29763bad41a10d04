/* Contact problem with the plate at one position: mortar coupling, contact matrix, solution with
 * warm start.
 *
 * All quantities are in the cylinder's frame and per mm of thickness. Candidates are the cylinder
 * nodes that may touch the plate. The unknowns f are the contact forces at the candidates. These
 * forces act along the plate's normals, and f are their y components, so the sum of f is the load.
 * Pressures are f divided by the widths of the nodes along x (mortar.c).
 *
 * The matrix B [candidates x plate nodes] maps plate nodal values to the candidates. The forces on
 * the plate are B'f, so the forces on both bodies balance except for rounding errors. The gap under
 * load is the initial gap - approach + A f with A = F_c + B F_p B', where F_c and F_p are the
 * compliances of cylinder and plate. */
#ifndef CONTACT_CONTACT_PROBLEM_H
#define CONTACT_CONTACT_PROBLEM_H

#include "core/contact/shape.h"

typedef struct contact_problem {
  double x;     /* [mm] position of the plate */
  double angle; /* [rad] angle of the load, positive along the arc length s; 0 except for pins in
                   holes */
  int aimed;    /* 1: `down` is up to date */
  const arc_model *model; /* model of the bodies, for messages */
  const arc_shape
      *shape; /* shape of the last arc_contact_problem_update, used by the next solution */
  const revolution
      *revolved;   /* axis of bodies of revolution (chart.h); inactive for other bodies */
  long version;    /* version of the compliance (see arc_shape) at the last coupling; 0: not coupled
                      yet */
  int nc, np;      /* numbers of surface nodes of cylinder and plate */
  int lo, count;   /* candidates are the cylinder nodes lo .. lo + count - 1 */
  int width;       /* row length of B */
  int *first;      /* [nc] for each candidate, the first plate node of its row of B */
  double *b;       /* [nc * width] rows of B */
  double *wc, *wp; /* [nc], [np] tributary widths along x [mm] */
  double *slope;   /* [nc] slope dy/dx of the plate's surface at each candidate, 0 at other nodes;
                      forces along x are -slope f */
  double *down; /* [nc] component along the load of a unit force at each candidate, which equals the
                   decrease of the candidate's gap per approach; 1 except for pins in holes (polar
                   charts) */
  double *a;    /* [count x count] contact matrix A [mm2/N] */
  double *gap;  /* [nc] initial gap by candidate [mm] */
  double *f;    /* [nc] solution: nodal forces by candidate [N/mm] */
  double *open; /* [nc] solution: remaining gap by candidate [mm] */
  double approach; /* [mm] solution: approach of the bodies */
  int iterations;  /* number of iterations of the last solution */
  int active;      /* size of the active set */
  int *set;        /* [nc] the active candidates in increasing order */
  int *joined;     /* [nc] workspace for the next active set */
  int *made, of;   /* [nc] active set for which `factor` and `ones` were computed, and its size */
  double *factor;  /* Cholesky factor of A, restricted to the candidates in `made`; a square matrix
                      with `of` rows */
  double *ones;    /* [nc] solution of A ones = down, restricted to the candidates in `made` */
  int factored;    /* 1: `factor` and `ones` are valid for A */
  /* workspaces, each used by one function and its callees */
  double *column;   /* [np] workspace for the assembly of A */
  double *weighted; /* [nc] workspace for transfers to the plate */
  double *nodal;    /* [2 nc] workspace for forces on a body */
  double *on_body;  /* [2 (nc + np)] workspace for displacements along x */
  double *drift;    /* [3 nc + 2 np] workspace for the change of compliance */
  double *step;     /* [2 nc] workspace for the complementarity problem (lcp.c) */
} contact_problem;

/* One end of the contact (edge.c). */
typedef struct contact_edge {
  double x;      /* [mm] position in the cylinder's frame */
  double width;  /* [mm] size of the element at the edge */
  double smooth; /* [-] weight of the smooth-edge law: 1 at a smooth edge as in Hertz' theory, 0 at
                    a kink */
  int out;       /* 1: the right end, -1: the left one */
  double c[2];   /* coefficients of the pressure c0 sqrt(d) + c1 d sqrt(d) [MPa] inside the contact,
                    at the distance d [mm] from the edge */
} contact_edge;

/* --- contact_problem.c ------------------------------------------------------------------------ */

/* Allocates a problem for a model. On ARC_MEMORY the problem is empty. */
arc_status arc_contact_problem_create(contact_problem *p, const arc_model *model);
void arc_contact_problem_free(contact_problem *p);
/* Returns the memory of one problem [bytes]. */
size_t arc_contact_problem_bytes(const contact_problem *p);

/* Updates a problem for a shape with the plate at x [mm]. Computes the gaps and, if the compliance
 * or the position has changed, the coupling and the contact matrix. Errors: ARC_ZONE and
 * ARC_MEMORY, as in arc_contact_problem_couple; the problem is then invalid. */
arc_status arc_contact_problem_update(contact_problem *p, const arc_shape *shape, double x,
                                      arc_error *error);

/* Sets the angle of the load [rad], which applies from the next arc_contact_problem_update on. */
void arc_contact_problem_set_angle(contact_problem *p, double angle);

/* Solves the contact problem for `line`, the load per thickness [N/mm]. After ARC_ZONE (the contact
 * reaches the edge of the candidates) or ARC_NUMERIC the next solution begins without a warm
 * start. */
arc_status arc_contact_problem_solve(contact_problem *p, double line, arc_error *error);

/* Copies the active set of a problem at a neighbouring position to an unsolved problem as its warm
 * start. Without a warm start all candidates are active at first, which is expensive. The results
 * do not depend on the start. */
void arc_contact_problem_start_from(contact_problem *p, const contact_problem *neighbour);

/* Checks that the contact does not reach the edges of the candidates. Otherwise returns ARC_ZONE
 * and drops the warm start. */
arc_status arc_contact_problem_check_zone(contact_problem *p, arc_error *error);
/* Reports a failed solution: drops the warm start, writes the message to *error and returns
 * ARC_NUMERIC. */
arc_status arc_contact_problem_fail(contact_problem *p, arc_error *error);

/* Writes the nodal forces of the solution at all surface nodes of the cylinder to f [nc] [N/mm]. */
void arc_contact_problem_forces(const contact_problem *p, double *f);
/* Writes the forces of the solution on a body's surface nodes [N/mm] to force [2 * surface]: first
 * along x at all nodes, then along y. The forces on both bodies balance except for rounding errors.
 */
void arc_contact_problem_forces_on(const contact_problem *p, arc_body body, double *force);
/* Writes the pressures [MPa] of the solution at all surface nodes: pc [nc], pp [np]. */
void arc_contact_problem_pressures(const contact_problem *p, double *pc, double *pp);
/* Transfers a distributed quantity, such as a pressure, from the nodes of the cylinder [nc] to
 * those of the plate [np]. Conserves its integral along x. Non-negative values stay non-negative.
 */
void arc_contact_problem_transfer(const contact_problem *p, const double *from, double *to);
/* Computes the pressure [MPa] at the cylinder's node in the direction of the load, and the largest
 * nodal pressure. */
void arc_contact_problem_peaks(const contact_problem *p, double *center, double *largest);
/* Returns the sawtooth measure [-] of the pressures within `reach` [mm] of the cylinder's lowest
 * node: the largest difference between a nodal pressure and the mean of both neighbours, relative
 * to the mean pressure. */
double arc_contact_problem_ripple(const contact_problem *p, const arc_shape *shape, double reach);
/* Returns the largest mean pressure [MPa] over a length [mm] of the cylinder's surface along x. The
 * pressure is assumed constant over the cell of each node. */
double arc_contact_problem_average(const contact_problem *p, const arc_shape *shape, double length);
/* Computes the elastic displacement of a body along x [mm] at its surface nodes, u [surface]. */
void arc_contact_problem_tangential(const contact_problem *p, const arc_shape *shape, arc_body body,
                                    double *u);

/* --- mortar.c --------------------------------------------------------------------------------- */

/* Computes B and the tributary widths for the plate at x [mm] from the node positions at the last
 * condensation, so that coupling and compliance match. This function and the next three are steps
 * of arc_contact_problem_update. Errors: ARC_ZONE (fewer than three candidates), ARC_MEMORY. */
arc_status arc_contact_problem_couple(contact_problem *p, const arc_shape *shape, double x,
                                      arc_error *error);
/* Computes `down`, the component along the load of a unit force at each candidate. */
void arc_contact_problem_compute_down(contact_problem *p, const arc_shape *shape);
/* Computes the contact matrix from the present compliance of the shape. */
void arc_contact_problem_assemble(contact_problem *p, const arc_shape *shape);
/* Computes the initial gaps along y from the present heights of the shape. */
void arc_contact_problem_update_gaps(contact_problem *p, const arc_shape *shape);
/* Computes result [nc] = B v for values v [np] of the plate's nodes. result is 0 at nodes that are
 * not candidates. */
void arc_contact_problem_to_cylinder(const contact_problem *p, const double *v, double *result);
/* Computes result [np] = B' v for values v [nc] of the cylinder's nodes. */
void arc_contact_problem_to_plate(const contact_problem *p, const double *v, double *result);

/* --- compliance_update.c ---------------------------------------------------------------------- */

/* Corrects the gaps by the forces times the changes of both bodies' compliances since their last
 * condensation. Returns 0 if there is no change. */
int arc_contact_problem_add_compliance_change(contact_problem *p);

/* --- edge.c ----------------------------------------------------------------------------------- */

contact_edge arc_contact_problem_edge(const contact_problem *p, const arc_shape *shape, int right);
/* Computes the contact edges [mm], left and right. */
void arc_contact_problem_edges(const contact_problem *p, const arc_shape *shape, double edges[2]);
/* Sharpens nodal values p [n] [MPa] at x [n] (in the cylinder's frame) near a smooth edge. Values
 * outside the edge, and within two elements inside it, are replaced by `share` times the pressure
 * of the edge law. `share` is 1 for pressures, and the ratio shear / pressure for shear tractions.
 * The sum of the forces is not conserved. */
void arc_edge_sharpen(const contact_edge *edge, int n, const double *x, double share, double *p);
/* Adds a correction [MPa] of the normal stress along the surface to cusp [n]. A shear traction of
 * `share` times the pressure causes a cusp of this stress at the contact edge, which nodal means
 * smooth out. The correction at a node is the value of the cusp minus its mean under the node's hat
 * function. */
void arc_edge_add_cusp(const contact_edge *edge, int n, const double *x, double share,
                       double *cusp);

/* --- lcp.c ------------------------------------------------------------------------------------ */

/* Solves the complementarity problem: computes the members set, factor, ones, f and
 * approach of p for a load per thickness [N/mm], with the present active set as a warm start. */
arc_status arc_lcp_solve(contact_problem *p, double line);
/* Computes `factor` and `ones` for the present active set unless they are already valid for it.
 * Returns non-zero if A is not positive definite on this set. */
int arc_lcp_factorise(contact_problem *p);

#endif
