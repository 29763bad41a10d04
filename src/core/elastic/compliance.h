/* Compliance of a surface: displacements of its nodes under forces on its nodes. */
#ifndef ELASTIC_COMPLIANCE_H
#define ELASTIC_COMPLIANCE_H

#include "archard/base.h"

/* Response of the n candidate surface nodes to nodal forces per thickness [mm2/N], column-major n x
 * n, in one block of memory. Entry (r, c) of `uv` is the displacement of node r along u under a
 * unit force along v at node c. yy and xx are symmetric, and yx is xy transposed. */
typedef struct compliance {
  int n;
  double *yy, *xy, *yx, *xx;
  /* Data of the condensed surface with moved nodes: slopes m = dy/dx [n], and `along`, the response
   * of gaps to pressures along the surface's normals, yy - m xy - yx m + m xx m. The caller sets
   * the slopes and computes `along` by arc_compliance_incline. For flat surfaces `along` is yy. */
  double *slope, *along;
  double *level; /* [n] yy - xx without the error of the elements; NULL: xx is used for shear */
} compliance;

/* Returns the displacement of node r along the surface under a unit of shear at node k [mm2/N]. */
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
/* Returns another reference to the compliance, which must be freed too. The compliance must not be
 * changed afterwards. */
compliance arc_compliance_share(const compliance *c);
/* Computes the matrix `along` from the blocks and the slopes. */
void arc_compliance_incline(compliance *c);
/* Computes the matrix `level`: the compliance for shear, xx, derived from the compliance for
 * pressure, yy, for bodies of one material. A uniform half-plane has the same tangential
 * displacements under shear as normal displacements under pressure. Elements are too stiff for
 * shear that alternates from node to node, especially tall elements: at a height of 1.25 widths
 * such shear causes only half of the displacements of such pressure. Between nodes at most a few
 * columns of elements apart, yy therefore replaces xx, apart from the difference due to the finite
 * size of bodies. */
void arc_compliance_level(compliance *c);
/* Returns the memory of a compliance of n nodes [bytes]. */
size_t arc_compliance_bytes(int n);

#endif
