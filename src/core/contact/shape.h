/* Defines arc_shape, which contains the worn surfaces of a pair of bodies and their compliance, and
 * its functions. */
#ifndef CONTACT_SHAPE_H
#define CONTACT_SHAPE_H

#include "archard/contact.h"
#include "core/elastic/body.h"
#include "core/elastic/condense.h"
#include "core/elastic/mesh_size.h"
#include "core/elastic/model.h"
#include "core/elastic/pair.h"
#include "core/pair/surfaces.h"

typedef struct shape_side {
  const elastic_body *body;
  int n;
  double *h;         /* [n] wear depth, the sum of all depths along the normals [mm] */
  double *x0, *y;    /* [n] x of the unworn nodes; present heights, including even wear [mm] */
  double *xy;        /* [2 n] present surface nodes, without even wear [mm] */
  double *settled;   /* [2 n] surface nodes at the last condensation [mm] */
  double *x, *shift; /* [n] present x; distance of a node from its unworn position [mm] */
  double *level;     /* [n] present height of the surface at the x of each node in `settled` [mm] */
  double *compliance_change; /* [n x ARC_THINNING_SPAN] change of the compliance since the last
                                condensation, between node i and the nodes up to ARC_THINNING_REACH
                                away */
  double *work;              /* [4 n] workspace */
  int compliance_changed;    /* 1: compliance_change is not zero */
  double even; /* [mm] even wear, a depth that all nodes have in common; h includes it */
  int ahead;   /* 1: the compliance was computed for the middle of the present update */
  compliance
      own; /* compliance of the worn wear box; if its n is 0, the unworn compliance is used */
} shape_side;

struct arc_shape {
  shape_handle handle;
  arc_geometry geometry;
  double refresh;
  arc_corrections corrections;
  long version; /* version of both compliances; among all shapes of a model, compliances with equal
                   versions are identical */
  shape_side side[ARC_BODIES];
};

static inline const compliance *shape_compliance(const shape_side *side) {
  return side->own.n > 0 ? &side->own : &side->body->unworn;
}

/* Returns the sign of y in the direction into the material: 1 (up) for the cylinder, -1 (down) for
 * the plate. */
static inline double shape_inward(const shape_side *side) {
  return side->body->mesh->body == ARC_CYLINDER ? 1 : -1;
}

/* Computes the chord from the left to the right neighbour of node i. xy [2 n] contains the nodes of
 * the surface. At the ends of the surface the node itself replaces the missing neighbour. */
static inline void shape_chord(const double *xy, int n, int i, double chord[2]) {
  const double *a = &xy[2 * (i > 0 ? i - 1 : 0)], *b = &xy[2 * (i + 1 < n ? i + 1 : i)];
  chord[0] = b[0] - a[0];
  chord[1] = b[1] - a[1];
}

/* Largest number of rows of a deepened wear box. */
enum { ARC_SHAPE_MOST_ROWS = 100 };

/* Largest wear [mm] of a frozen geometry; above it the rounding errors of the gaps are too
 * large. */
#define ARC_SHAPE_DEEPEST 1e6
static inline int shape_is_corrected(const arc_shape *shape) {
  return shape->corrections == ARC_CORRECTIONS_ALL;
}

/* --- surface.c -------------------------------------------------------------------------------- */

/* Moves the surface nodes by `depth` [n] [mm] along their present normals and writes the result to
 * xy [2 n]. */
void arc_shape_move(const shape_side *side, arc_geometry geometry, const double *depth, double *xy);

/* Returns the tributary width of surface node i [mm], from the positions along x at the last
 * condensation. For bodies of revolution it is the area of the node's ring as seen from above
 * [mm2]. */
double arc_shape_width(const shape_side *side, int i);

/* Writes to down [n] the vertical lowering of the surface at fixed x, divided by the depth of wear
 * along the normal. The result is 1 / cos of the slope angle. */
void arc_shape_downward(const arc_shape *shape, arc_body body, double *down);

/* Returns the length of the surface that belongs to node i [mm], along the surface or, with frozen
 * geometry, along x. For bodies of revolution it is an area [mm2]. */
double arc_shape_span(const arc_shape *shape, arc_body body, int i);

/* Corrects depths so that the polygon of the surface loses exactly the areas depth[i] * span,
 * although the length of a curved surface changes with depth. Surfaces of revolution are not
 * corrected: the effect is of second order in the depth of an update. */
void arc_shape_conserve(arc_shape *shape, arc_body body, double *depth);

/* --- shape.c ---------------------------------------------------------------------------------- */

/* Computes level, x, y and shift from the present nodes. Wear along the normals also moves nodes
 * along x, but the coupling and `level` use their x at the last condensation. */
void arc_shape_read_nodes(shape_side *side);

/* Computes the compliance of the wear box with the surface nodes xy [2 n]. */
arc_status arc_shape_condense(const shape_side *side, const double *xy, compliance *result,
                              arc_error *error);

/* Implementations of arc_shape_create, arc_shape_clone, arc_shape_destroy, arc_shape_profile and
 * arc_shape_depth for meshed surfaces. */
arc_status arc_meshed_create(arc_model *model, arc_geometry geometry, double refresh,
                             arc_shape **shape, arc_error *error);
arc_status arc_meshed_copy(const arc_shape *shape, arc_shape **copy, arc_error *error);
void arc_meshed_discard(arc_shape **shape);
arc_profile arc_meshed_profile(const arc_shape *shape, arc_body body);
double arc_meshed_depth(const arc_shape *shape, arc_body body);

/* Computes the wear-box nodes [2 * box_count] for the surface nodes surface_xy [2 n] and an even
 * wear [mm]. */
void arc_shape_box(const shape_side *side, const double *surface_xy, double even, double *box_xy);

/* Returns the even wear [mm] included in the stiffness; 0 with frozen geometry. */
double arc_shape_risen(const arc_shape *shape, arc_body body);

/* Changes the geometry. Frozen geometry uses the unworn compliance; moving geometry uses the
 * compliance of the present nodes. On failure the shape is unchanged. */
arc_status arc_shape_set_geometry(arc_shape *shape, arc_geometry geometry, double refresh,
                                  arc_error *error);

/* Switches the corrections of the discretisation errors on or off. */
void arc_shape_set_corrections(arc_shape *shape, arc_corrections corrections);
/* Prepares an update that wears the surface of one body. If the surface will move too far for its
 * present compliance, computes the compliance in the middle of the update, for the surface worn by
 * `depth` [n] [mm]. This compliance also applies to the end of the update. If the worn surface is
 * not valid, the compliance is unchanged. Errors: ARC_MEMORY, ARC_NUMERIC. */
arc_status arc_shape_look_ahead(arc_shape *shape, arc_body body, const double *depth,
                                arc_error *error);

/* Sets the surface of one body by displacements of its unworn nodes along x and y [surface] [mm],
 * with depths h [surface] and additional even wear, and computes the compliance of moving geometry.
 * Errors as for arc_shape_wear; the shape is then unchanged. */
arc_status arc_shape_put(arc_shape *shape, arc_body body, const double *shift_x,
                         const double *shift_y, const double *h, double even, arc_error *error);

/* Returns the memory of one shape [bytes]. */
size_t arc_shape_bytes(const arc_shape *shape);

/* --- wear_box.c ------------------------------------------------------------------------------- */

/* Returns the depth of the wear box under the unworn centre [mm]. */
double arc_shape_box_depth(const shape_side *side);

/* Returns the displacement of node `row` of column i of the wear box [mm] for a displacement `sunk`
 * of the surface [mm] and even wear [mm]. Rows on interfaces of layers remain on the interfaces
 * until the surface reaches them. Even wear moves the interfaces toward the surface. Between these
 * rows the displacement is linear. */
double arc_shape_sink(const shape_side *side, double sunk, double even, int i, int row);

/* Returns the even wear [mm] that changes the stiffness: the even wear of a body with layers if its
 * wear box extends below all of them, else 0. */
double arc_shape_even_stiffening(const shape_side *side);

/* Returns the number of rows that the wear box of an evenly worn body needs to extend below all
 * layers, at most ARC_SHAPE_MOST_ROWS and within the body. Returns 0 if the present rows suffice or
 * no more are possible. */
int arc_shape_layer_rows(const arc_shape *shape, arc_body body);

/* Checks the elements of the wear box with the surface nodes xy: every column must retain a tenth
 * of the box depth, and x must increase from node to node. Otherwise returns ARC_GEOMETRY. */
arc_status arc_shape_check_box(const arc_shape *shape, const shape_side *side, const double *xy,
                               arc_error *error);

/* Checks that no depth exceeds ARC_SHAPE_DEEPEST after additional wear by `depth` [n] [mm]. Even
 * wear is not included. Errors: ARC_GEOMETRY. */
arc_status arc_shape_check_depth(const shape_side *side, const double *depth, arc_error *error);

/* --- compliance_update.c ---------------------------------------------------------------------- */

/* Updates `compliance_change` for the present surface nodes. */
void arc_shape_find_compliance_change(const arc_shape *shape, shape_side *side);

#endif
