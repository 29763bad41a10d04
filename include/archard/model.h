/* archard/model.h - the two elastic bodies, condensed to their wear boxes once and then shared.
 *
 * For each body: K assembled from plane-strain elements, everything outside the wear box eliminated
 * with CHOLMOD, so that any worn shape needs only a small dense update (S = S_far + K_box, F =
 * normal block of S^-1).
 */
#ifndef ARCHARD_MODEL_H
#define ARCHARD_MODEL_H

#include "archard/mesh.h"

typedef struct arc_material {
  double E;  /* [MPa] Young's modulus, > 0 */
  double nu; /* [-] Poisson's ratio, -1 < nu < 0.5 */
} arc_material;

/* Steel of the reference case: 200e3 MPa, 0.3. */
arc_material arc_material_default(void);

/* Plane-strain modulus E / (1 - nu^2) [MPa]. */
double arc_material_E_star(arc_material material);

/* Contact modulus of the couple, 1 / (1/E*_c + 1/E*_p) [MPa]. */
double arc_contact_modulus(const arc_material material[ARC_BODIES]);

/* Checks ranges; ARC_ARGUMENT names field, expectation and value. */
arc_status arc_material_check(arc_material material, arc_error *error);

typedef struct arc_model_def {
  double radius;                     /* [mm] 10 */
  double thickness;                  /* [mm] 1 */
  arc_material material[ARC_BODIES]; /* by arc_body */
  arc_mesh_def mesh;
} arc_model_def;

arc_model_def arc_model_default(void);

/* Closed-form Hertz line contact of a cylinder on a half-space. */
typedef struct arc_hertz {
  double half_width; /* [mm] a = sqrt(4 L R / (pi t E*)) */
  double p_max;      /* [MPa] p_H = 2 L / (pi a t) */
  double E_star;     /* [MPa] 1 / (1/E*_c + 1/E*_p), the contact modulus */
} arc_hertz;

/* load [N] > 0, radius and thickness [mm] > 0, else ARC_ARGUMENT. */
arc_status arc_hertz_solve(double radius, double thickness, double load,
                           const arc_material material[ARC_BODIES], arc_hertz *hertz,
                           arc_error *error);

/* Opaque, reference counted, unchanged after arc_model_build; not for two threads at once (stress
 * fields share the factor's workspace). */
typedef struct arc_model arc_model;

/* Meshes, assembles, factorises and condenses both bodies. Errors: those of arc_mesh_build,
 * ARC_ARGUMENT, ARC_NUMERIC (not positive definite), ARC_MEMORY. On failure *model is NULL. */
arc_status arc_model_build(const arc_model_def *def, arc_model **model, arc_error *error);

arc_model *arc_model_retain(arc_model *model);
/* Gives up one reference and nulls the handle. */
void arc_model_release(arc_model **model);

const arc_model_def *arc_model_definition(const arc_model *model);
const arc_mesh *arc_model_mesh(const arc_model *model, arc_body body);
/* Bytes held by the model, for a garbage collector. */
size_t arc_model_bytes(const arc_model *model);
/* Seconds arc_model_build took. */
double arc_model_seconds(const arc_model *model);

/* Zones (full widths, by body) [mm] that hold contacts up to half_width [mm] wide on either side of
 * the cylinder's axis, over plate positions |x| <= reach [mm]. Never under 50 and 60 elements of
 * `size` [mm]: at the default size these are the default zones. */
void arc_zone_for(double reach, double half_width, double size, double zone[ARC_BODIES]);

#endif
