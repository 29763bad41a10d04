/* Compliance of a surface: the displacements of its nodes due to forces on its nodes. */
#ifndef ELASTIC_COMPLIANCE_H
#define ELASTIC_COMPLIANCE_H

#include "archard/base.h"

/* Response of the n candidate surface nodes to nodal forces per thickness [mm2/N]. The n x n
 * matrices are column-major, in one block of memory. Entry (r, c) of a matrix `uv` is the
 * displacement of node r along u under a unit force along v at node c. yy and xx are symmetric,
 * and yx is the transpose of xy. */
typedef struct compliance {
  int n;
  double *yy, *xy, *yx, *xx;
  /* Data of the condensed surface with moved nodes. `slope` contains the slopes m = dy/dx.
   * `along` is the response of the gaps to pressures along the surface's normals, yy - m xy - yx
   * m + m xx m. The caller sets the slopes and calls arc_compliance_incline. For flat surfaces
   * `along` is yy. */
  double *slope, *along;
  double *level; /* yy - xx at each node without the discretisation error; NULL: xx is used for
                    shear */
} compliance;

/* Returns the displacement of node r along the surface under a unit shear force at node k
 * [mm2/N]. */
enum { ARC_SHEAR_REACH = 8 };
static inline double compliance_shear(const compliance *c, int r, int k) {
  const size_t at = (size_t)k * (size_t)c->n + (size_t)r;
  if (!c->level || r - k > ARC_SHEAR_REACH || k - r > ARC_SHEAR_REACH) return c->xx[at];
  return c->yy[at] - (c->level[r] + c->level[k]) / 2;
}

/* Allocates a compliance of n nodes whose entries and slopes are zero. On ARC_MEMORY it is
 * empty. */
arc_status arc_compliance_create(compliance *c, int n);
void arc_compliance_free(compliance *c);
/* Returns another reference to the compliance, which must be freed as well. The compliance must
 * not be changed afterwards. */
compliance arc_compliance_share(const compliance *c);
/* Computes the matrix `along` from the other matrices and the slopes. */
void arc_compliance_incline(compliance *c);
/* Computes the array `level`, by which the compliance under shear, xx, is derived from the
 * compliance under pressure, yy, for bodies of one material. On a uniform half-plane, tangential
 * displacements under shear equal normal displacements under pressure. Elements, especially tall
 * ones, are too stiff under shear that alternates from node to node: at a height of 1.25 widths the
 * displacements are only half of those under alternating pressure. Between nodes at most
 * ARC_SHEAR_REACH columns apart, xx is therefore replaced by yy minus a difference that is due to
 * the finite size of the bodies. */
void arc_compliance_level(compliance *c);
/* Returns the memory of a compliance for n nodes [bytes]. */
size_t arc_compliance_bytes(int n);

#endif
