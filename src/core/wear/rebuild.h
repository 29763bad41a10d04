/* Runs that outgrow their meshes. */
#ifndef WEAR_REBUILD_H
#define WEAR_REBUILD_H

#include "core/wear/run.h"

/* Whether what a step failed of is want of room (ARC_ZONE) or depth (ARC_GEOMETRY) that the run has
 * grown into, and not the step itself. */
int arc_wear_has_outgrown(const arc_wear *w, arc_status why);

/* Whether bodies of that radius have room for the zones that the run needs. */
int arc_wear_has_room(const arc_wear *w);

/* A copy of the run on larger meshes. Errors: those of arc_model_build, `why` where
 * there is no room for larger ones; *result is NULL then. */
arc_status arc_wear_grow(const arc_wear *w, arc_status why, const arc_callbacks *callbacks,
                         arc_wear **result, arc_error *error);

/* A copy of the run, whose definition has changed, on meshes that its contact asks for: where the
 * element size is nobody's choice, and the contact under the present load has less than half of the
 * elements that it would get. *result is NULL where they serve as they are. */
arc_status arc_wear_suit(arc_wear *w, arc_wear **result, arc_error *error);

/* A copy of the run on another model of the same bodies. */
arc_status arc_wear_onto(const arc_wear *w, const arc_model_def *def,
                         const arc_callbacks *callbacks, arc_wear **result, arc_error *error);

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
