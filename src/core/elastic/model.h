/* Functions on models of meshed bodies, used by contact and wear. */
#ifndef ELASTIC_MODEL_H
#define ELASTIC_MODEL_H

#include "core/elastic/body.h"

/* Returns a body of the model. */
const elastic_body *arc_model_body(const arc_model *model, arc_body which);

/* Warns if a contact of the given half width [mm] has fewer than four elements, or if the elements
 * of a body lock. Also warns if a sharp edge of the unworn contact under the load [N] has too few
 * elements. For worn contacts the load is 0. */
void arc_model_warn(const arc_model *model, double load, double half_width,
                    const arc_callbacks *callbacks);

/* Version numbers of compliances, counted by the model. Compliances with equal numbers are
 * identical for all shapes. The unworn compliance has the number ARC_UNWORN_VERSION; the number
 * 0 is not used. */
enum { ARC_UNWORN_VERSION = 1 };
long arc_model_next_version(arc_model *model);

/* Returns the contact modulus of a model [MPa] for a pressure wave of wave number q [1/mm],
 * including the layers of imported bodies. See arc_pair_modulus. */
double arc_model_apparent_modulus(const arc_model *model, double q);

/* Implementations of arc_model_check, arc_model_build_with_callbacks, arc_model_release,
 * arc_model_bytes and arc_model_mesh for meshed bodies. */
arc_status arc_elastic_check(const arc_model_def *def, arc_error *error);
arc_status arc_elastic_build(const arc_model_def *def, const arc_callbacks *callbacks,
                             arc_model **model, arc_error *error);
void arc_elastic_destroy(arc_model *model);
size_t arc_elastic_bytes(const arc_model *model);
const arc_mesh *arc_elastic_mesh(const arc_model *model, arc_body body);

#endif
