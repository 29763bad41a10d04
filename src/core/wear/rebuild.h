/* Runs that outgrow their meshes. */
#ifndef WEAR_REBUILD_H
#define WEAR_REBUILD_H

#include "core/wear/run.h"

/* Whether what a step failed of is want of room (ARC_ZONE) or depth (ARC_GEOMETRY) that the run has
 * grown into, and not the step itself. */
int arc_wear_has_outgrown(const arc_wear *w, arc_status why);

/* The rows that a wear box needs for layers that wear evenly, of which only those in the box are
 * felt as they get thinner; 0 where it has them. */
int arc_wear_layer_rows(const arc_wear *w);

/* Whether bodies of that radius have room for the zones that the run needs. */
int arc_wear_has_room(const arc_wear *w);

/* A copy of the run on larger meshes. Errors: those of arc_model_build, `why` where
 * there is no room for larger ones; *result is NULL then. */
arc_status arc_wear_grow(const arc_wear *w, arc_status why, const arc_callbacks *callbacks,
                         arc_wear **result, arc_error *error);

/* A copy of the run on a mesh that is asked for, as in arc_wear_set. Errors: those of
 * arc_wear_grow, ARC_ARGUMENT where the meshes are from outside. */
arc_status arc_wear_remesh(const arc_wear *w, const arc_mesh_def *mesh,
                           const arc_callbacks *callbacks, arc_wear **result, arc_error *error);

/* Says which meshes a run has got by now, and why. */
void arc_wear_tell_meshes(const arc_wear *before, const arc_wear *now, const char *why,
                          const arc_callbacks *callbacks);

/* Says that and how a run has grown. */
void arc_wear_tell_grown(const arc_wear *before, const arc_wear *now,
                         const arc_callbacks *callbacks);

/* Tells of a step that failed, and, of one that failed for want of room, why the run does not grow:
 * `trouble` (a message that may be empty), or a step too long, with the mesh that may hold it. */
arc_status arc_wear_refuse(const arc_wear *w, const arc_error *why, const arc_error *trouble,
                           arc_error *error);

/* Each becomes the other. */
void arc_wear_exchange(arc_wear *a, arc_wear *b);

#endif
