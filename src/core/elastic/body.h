/* One elastic body, condensed to its wear box.
 *
 * Unknowns: `far` outside the wear box, eliminated once; `rim` the box nodes that far elements
 * touch; `inner` the other box nodes, the contact surface among them. In the inner unknowns,
 * numbered column by column, K_box is a narrow band.
 */
#ifndef ELASTIC_BODY_H
#define ELASTIC_BODY_H

#include "archard/model.h"
#include "core/base/watch.h"
#include "core/elastic/chart.h"
#include "core/elastic/element.h"
#include "core/elastic/factor.h"

/* Response of the n candidate surface nodes to nodal forces per thickness [mm2/N], column-major n x
 * n, one block of memory: entry (r, c) of `uv` is the displacement of node r along u under a unit
 * force along v at node c. yy and xx are symmetric, yx is xy transposed. */
typedef struct compliance {
  int n;
  double *yy, *xy, *yx, *xx;
  /* The surface it was condensed on, where nodes have moved: slopes dy/dx [n], and the response of
   * gaps to pressures along its normals, yy - m xy - yx m + m xx m. Left to whoever knows the
   * surface; along is yy where the surface is flat. */
  double *slope, *along;
  double *level; /* [n] yy - xx but for the elements' error; NULL: shear goes by xx */
} compliance;

/* What of one layer lies under a node of the surface: down to `end` [mm] along the chart's z, the
 * last one to INFINITY. */
typedef struct stratum {
  double end;
  int layer;
} stratum;

/* Displacement of node r along the surface under a unit of shear at node k. */
enum { ARC_SHEAR_REACH = 8 };
static inline double compliance_shear(const compliance *c, int r, int k) {
  const size_t at = (size_t)k * (size_t)c->n + (size_t)r;
  if (!c->level || r - k > ARC_SHEAR_REACH || k - r > ARC_SHEAR_REACH) return c->xx[at];
  return c->yy[at] - (c->level[r] + c->level[k]) / 2;
}

typedef struct elastic_body {
  arc_mesh *mesh;
  arc_material material;
  elasticity d;                          /* of its own material, under all layers */
  elasticity layer[ARC_MOST_LAYERS + 1]; /* by the layer of an element */
  arc_space space;
  chart chart;
  double *box_at; /* [2 * box_count] unworn wear-box nodes in the chart [mm] */
  int *node_box;  /* [nodes] index in the wear box (as box_node), or -1 */
  int *node_far;  /* [nodes] far unknown of its x (y follows), or -1 */
  int far_count;  /* far unknowns */
  int box_count;  /* nodes of the wear box */
  int *box_inner; /* [box_count] inner number, or -1 */
  int *box_rim;   /* [box_count] rim number, or -1 */
  int inner, rim; /* nodes of each kind */
  int band;       /* half band width of the inner unknowns */
  factor *far;
  sparse_entries coupling; /* K between far (row) and rim (column) unknowns */
  double *s_far;           /* [2 rim x 2 rim] Schur complement of the far part */
  compliance unworn;
  double *thinning;   /* see arc_body_thinning */
  stratum *stratum;   /* of a mesh from outside with layers, node by node; NULL of others */
  int *stratum_start; /* [surface] where those of a node begin */
} elastic_body;

/* How the compliance answers where the wear box gets thinner at one column: to be added to the
 * normal compliance between the nodes `a` and `b` columns away from it, per share of its thickness
 * lost. Reaches ARC_THINNING_REACH columns: what is left of the box is as stiff as before to a
 * contact, and only the elements' own error changes. Found at the unworn centre; of revolution for
 * a circumference of 1 mm, halfway between the axis and the edge. */
enum { ARC_THINNING_REACH = 8, ARC_THINNING_SPAN = 2 * ARC_THINNING_REACH + 1 };
static inline double arc_body_thinning(const elastic_body *body, int a, int b) {
  return body->thinning[(a + ARC_THINNING_REACH) * ARC_THINNING_SPAN + b + ARC_THINNING_REACH];
}

/* Meshes, assembles, factorises, condenses: ARC_BODY_STAGES of the watch (NULL: nobody's). A mesh
 * that is given (*given not NULL) is taken over and nulled, on failure too. On failure *body is
 * NULL. */
enum { ARC_BODY_STAGES = 4 };
arc_status arc_body_create(const arc_model_def *def, arc_body which, arc_mesh **given,
                           work_watch *seen, elastic_body **body, arc_error *error);
void arc_body_destroy(elastic_body **body);
size_t arc_body_bytes(const elastic_body *body);

/* Room for a compliance of n nodes, all zero and flat; ARC_MEMORY leaves it empty. */
arc_status arc_compliance_create(compliance *c, int n);
void arc_compliance_free(compliance *c);
/* The same compliance once more, to be freed on its own; neither may be written to any more. */
compliance arc_compliance_share(const compliance *c);
/* Fills `along` from the blocks and the slopes. */
void arc_compliance_incline(compliance *c);
/* Has shear answered as pressure is, for bodies of one material. A uniform half-plane moves along
 * its surface under shear as it moves across under pressure. Elements find shear that changes from
 * node to node too stiff, the more the taller they are: 1.25 widths high they give way half as much
 * as under such pressure. So within a few columns yy stands for xx, but for the difference that
 * bodies of finite size make. */
void arc_compliance_level(compliance *c);
/* Bytes of a compliance of n nodes. */
size_t arc_compliance_bytes(int n);

/* An unworn surface node in the chart, and the wear box's bottom under it: s and z [mm]. */
static inline const double *arc_body_top(const elastic_body *body, int i) {
  return &body->box_at[2 * i * (body->mesh->rows + 1)];
}
static inline const double *arc_body_bottom(const elastic_body *body, int i) {
  return &body->box_at[2 * (i * (body->mesh->rows + 1) + body->mesh->rows)];
}

/* Share of the surface's way that row `row` of wear-box column i takes: by its depth, which goes by
 * rows but where layers have rows of their own. */
static inline double arc_body_pull(const elastic_body *body, int i, int row) {
  const int rows = body->mesh->rows;
  if (body->mesh->solid.layer[0].thickness == 0) return (double)(rows - row) / rows;
  const double top = arc_body_top(body, i)[1], bottom = arc_body_bottom(body, i)[1];
  return (bottom - body->box_at[2 * (i * (rows + 1) + row) + 1]) / (bottom - top);
}

/* The n-th stratum under node i of the surface, from 0; the last one ends at INFINITY. */
static inline stratum arc_body_stratum(const elastic_body *body, int i, int n) {
  if (body->stratum) return body->stratum[body->stratum_start[i] + n];
  const arc_body_def *solid = &body->mesh->solid;
  return (stratum){n < arc_body_layers(solid) ? arc_body_interface(solid, n) : INFINITY, n};
}

/* Elasticity of an element outside the wear box. */
static inline elasticity arc_body_elasticity(const elastic_body *body, int e) {
  return body->layer[body->mesh->layer[e]];
}

/* The compliance, in the chart's directions, with the wear-box nodes at box_at [2 * box_count] of
 * the chart (order of box_node). Under a surface that stays where it is although it wore by `even`
 * [mm] the layers in the box lie so much higher. ARC_NUMERIC, ARC_MEMORY. */
arc_status arc_body_condense(const elastic_body *body, const double *box_at, double even,
                             compliance *result, arc_error *error);

/* Triangles that share one dilatation with triangle e, the first of its cell: e, e + 2, ...; none
 * locks alone then. 1 for elements that stand for themselves, as all of a mesh from outside do, 0
 * for the later ones of a cell. */
int arc_body_cell(const elastic_body *body, int e);

/* The element with the corners corner[4] (-1 fourth: triangle) of the body, among nodes xy. */
element arc_body_element(const elastic_body *body, const double *xy, const int corner[4]);

/* Displacements u [2 * nodes] of the whole body, in space, under surface forces f [2 * surface,
 * N/mm], along s at all nodes first, then along z, by back-substitution. */
arc_status arc_body_displacements(const elastic_body *body, const double *box_at, double even,
                                  const double *f, double *u, arc_error *error);

/* The model's body (not public: contact and wear lean on it). */
const elastic_body *arc_model_body(const arc_model *model, arc_body which);

/* Warns where a contact of this half width [mm], or a sharp edge of the unworn one under a load [N]
 * (0: it is worn), has less than four elements of the model, and where a body's elements lock. */
void arc_model_warn(const arc_model *model, double load, double half_width,
                    const arc_callbacks *callbacks);

/* Numbers for compliances, so that what was made from one knows when it is stale. The model counts
 * them: a number means the same bits on whatever shape it stands. The unworn compliance has the
 * first one; none is 0. */
enum { ARC_UNWORN_VERSION = 1 };
long arc_model_next_version(arc_model *model);

/* Modulus of a material's half-plane [MPa]: E*, in plane stress E. */
double arc_material_modulus(arc_space space, arc_material material);

/* That of the half-plane which yields as much as a body with its layers does to a pressure of wave
 * number q [1/mm]; to the bit the material's where there are no layers and no base is near. */
double arc_body_modulus(arc_space space, const arc_body_def *body, arc_material own, double q);
/* The same of layers, from the surface inwards, on a base of its own material `base` mm thick,
 * INFINITY for a half-plane, that is held below. */
double arc_layers_modulus(arc_space space, const arc_layer *layer, int layers, double base,
                          arc_material own, double q);
/* The contact modulus of two such bodies [MPa]. */
double arc_pair_modulus(arc_space space, const arc_body_def body[ARC_BODIES],
                        const arc_material own[ARC_BODIES], double q);
/* That of a model, with the layers that bodies from outside have. */
double arc_model_felt_modulus(const arc_model *model, double q);

/* Whether the contact is a spot on the axis of revolution. */
int arc_model_is_round(const arc_model_def *def);

/* Dundurs' second constant of a pair: how unlike its bodies are to shear. */
double arc_contact_mismatch(arc_space space, const arc_material material[ARC_BODIES]);

/* Whether two bodies, each in order, make a pair; ARC_ARGUMENT. */
arc_status arc_model_check_pair(const arc_model_def *def, arc_error *error);

/* Of a pair whose meshes are given, which tell themselves how far they reach. */
arc_status arc_model_check_given_pair(const arc_model_def *def, arc_error *error);

/* --- meshes from outside: imported_mesh.c, imported_shape.c ---------------------------------------------- */

/* Checks a definition and two meshes, and makes of it that of their model. ARC_ARGUMENT. */
arc_status arc_given_settle(const arc_model_def *def, arc_mesh *const given[ARC_BODIES],
                            arc_model_def *settled, arc_error *error);
/* Refuses a shape that a body has beside a mesh from outside. ARC_ARGUMENT. */
arc_status arc_given_check_shape(const arc_model_def *def, arc_body body, arc_error *error);
/* Fills in the layer of each element by the names of the body's. ARC_MEMORY. */
arc_status arc_given_layers(arc_mesh *mesh, const arc_body_def *solid, arc_error *error);
/* Refuses what belongs to such meshes alone. ARC_ARGUMENT. */
arc_status arc_given_refuse(const arc_model_def *def, arc_error *error);

/* --- what lies under the nodes of a surface: imported_layers.c ----------------------------------------- */

/* Finds those of a given mesh whose body has layers; else there is nothing to find. ARC_MEMORY. */
arc_status arc_body_find_strata(elastic_body *body, arc_error *error);
/* Of a body that has them: the body with those under the middle of its surface as layers by their
 * thickness, on *own. */
arc_body_def arc_body_under_middle(const elastic_body *body, arc_material *own);

/* The widest zone of a body of the model [mm]: arcs curl away from the contact. */
double arc_model_widest_zone(const arc_model_def *def, arc_body body);

/* The deepest wear box that both bodies have room for [mm]. */
double arc_model_deepest_box(const arc_model_def *def);

/* The size that "auto" is at a fineness of 1 for a half width [mm]. */
double arc_model_size_for(double half_width);

/* Bytes that building the model takes at its height, about. */
double arc_model_memory(const arc_model_def *def);

/* Room for the edge peaks of worn contacts, in half widths. */
#define ARC_CONTACT_ROOM 1.3

#endif
