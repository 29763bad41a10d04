/* archard/body.h - shapes of bodies: outline, layers, what is held.
 *
 * A body is the upper or the lower one of a pair. Its surface passes through the first point of
 * contact, the origin; it is symmetric about x = 0, but for measured profiles.
 */
#ifndef ARCHARD_BODY_H
#define ARCHARD_BODY_H

#include "archard/material.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* Roles. The upper body carries the load by what is held of it, the lower one moves. In the pair
 * of the paper they are the cylinder and the plate. */
typedef enum arc_body {
  ARC_CYLINDER = 0,
  ARC_PLATE = 1,
  ARC_UPPER = ARC_CYLINDER,
  ARC_LOWER = ARC_PLATE
} arc_body;
#define ARC_BODIES 2

/* "cylinder" or "plate". */
const char *arc_body_name(arc_body body);

/* X(name, "name", object with its functions, see src/core/mesh/body_shape.h). */
#define ARC_SOLID_LIST(X)                                                                          \
  X(SOLID_USUAL, "usual", usual)                                                                   \
  X(SOLID_CYLINDER, "cylinder", cylinder)                                                          \
  X(SOLID_BLOCK, "block", block)                                                                   \
  X(SOLID_PUNCH, "punch", punch)                                                                   \
  X(SOLID_PROFILE, "profile", profile)                                                             \
  X(SOLID_DISC, "disc", disc)                                                                      \
  X(SOLID_RING, "ring", ring)                                                                      \
  X(SOLID_BALL, "ball", ball)                                                                      \
  X(SOLID_MAP, "map", map)                                                                         \
  X(SOLID_GMSH, "gmsh", gmsh)
typedef enum arc_solid { ARC_SOLID_LIST(ARC_CHOICE_ENUM) } arc_solid;
extern const char *const arc_solid_names[];

#define ARC_RIM_LIST(X)                                                                            \
  X(RIM_OUTER, "outer")                                                                            \
  X(RIM_INNER, "inner")
typedef enum arc_rim { ARC_RIM_LIST(ARC_CHOICE_ENUM) } arc_rim;
extern const char *const arc_rim_names[];

/* Support of a cylinder: its flat is fixed, or held along y only (free); or it is a disc (hub). */
#define ARC_HOLD_LIST(X)                                                                           \
  X(HOLD_FIXED, "fixed")                                                                           \
  X(HOLD_HUB, "hub")                                                                               \
  X(HOLD_FREE, "free")
typedef enum arc_hold { ARC_HOLD_LIST(ARC_CHOICE_ENUM) } arc_hold;
extern const char *const arc_hold_names[];

/* A layer on a body's surface, with a material of its own: as thick everywhere, or, in a mesh from
 * outside, what the mesh has under that name. */
#define ARC_LAYER_SETTINGS(NUMBER, TEXT)                                                           \
  TEXT(name, "a name in the mesh from outside", ARC_OPTIONAL,                                      \
       "What a mesh from outside calls it, in place of its thickness.")                            \
  NUMBER(thickness, "mm", 0, ABOVE(0), ARC_OPTIONAL, "Thickness of the layer.")

typedef struct arc_layer {
  ARC_LAYER_SETTINGS(ARC_MEMBER_NUMBER, ARC_MEMBER_TEXT) /* one of both, or there is no layer */
  arc_material material;
} arc_layer;
enum { ARC_MOST_LAYERS = 4 };

extern const arc_setting arc_layer_settings[]; /* and the material, a group */

/* What a body's name is. */
#define ARC_BODY_NAME "a word of letters, digits and _ that begins with a letter, up to 31 long"

#define ARC_BODY_SETTINGS(NUMBER, CHOICE, TEXT)                                                    \
  TEXT(name, ARC_BODY_NAME, ARC_OPTIONAL,                                                          \
       "What it is called by results, pictures and files. Left out: by its kind or role.")         \
  CHOICE(kind, solid, ARC_SOLID_USUAL, 0,                                                          \
         "Its shape; the usual one is a cylinder above, and a block below; \"gmsh\" stands for "   \
         "that in the Gmsh file of its model.")                                                    \
  NUMBER(radius, "mm", 0, ABOVE(0), ARC_OPTIONAL,                                                  \
         "Radius of a cylinder or disc, or of a punch's rounded edges. Left out: the model's. Of " \
         "a map: that of the ball which its heights are added to; left out: none.")                \
  NUMBER(radius_z, "mm", 0, ABOVE(0), ARC_OPTIONAL,                                                \
         "Radius of a ball across the motion: a crowned roller, an ellipsoid. Left out: radius.")  \
  NUMBER(width, "mm", 0, ABOVE(0), ARC_OPTIONAL,                                                   \
         "Width of a block or profile. Left out: twice the model's radius.")                       \
  NUMBER(height, "mm", 0, ABOVE(0), ARC_OPTIONAL,                                                  \
         "Height of a block, profile or punch. Left out: the model's radius; of a punch at least " \
         "twice "                                                                                  \
         "its radius.")                                                                            \
  NUMBER(flat, "mm", 0, ABOVE(0), ARC_OPTIONAL,                                                    \
         "Full width of a punch's flat; its rounded edges, a radius wide, come on both sides.")    \
  NUMBER(inner, "mm", 0, ABOVE(0), ARC_OPTIONAL, "Inner radius of a ring.")                        \
  NUMBER(outer, "mm", 0, ABOVE(0), ARC_OPTIONAL, "Outer radius of a ring.")                        \
  CHOICE(fixed, rim, ARC_RIM_OUTER, 0,                                                             \
         "Which rim of a ring is held; the other one is in contact.")                              \
  CHOICE(                                                                                          \
      hold, hold, ARC_HOLD_FIXED, 0,                                                               \
      "Support of a cylinder, which matters where the contact is nearly as wide: \"fixed\": the "  \
      "flat of a half cylinder is rigid; \"free\": the flat moves along itself without friction, " \
      "held sideways in the middle 15 % only; \"hub\": a whole disc around a rigid hub of 0.15 "   \
      "radius, as body.disc.")

typedef struct arc_body_def {
  ARC_BODY_SETTINGS(ARC_MEMBER_NUMBER, ARC_MEMBER_CHOICE, ARC_MEMBER_TEXT)
  double y;            /* stands for the series: 0 */
  arc_series y_series; /* heights of a profile [mm] over x [mm], out of the body; linear between
                          points, level beyond them; of a map over the number of the point, z
                          fastest. Owned by whoever made the definition; a model keeps a copy */
  double x, z;         /* stand for the series: 0 */
  arc_series x_series, z_series;    /* of a map: where its points are, x over their number [mm] */
  arc_layer layer[ARC_MOST_LAYERS]; /* from the surface inwards */
} arc_body_def;

extern const arc_setting arc_body_settings[];

/* The body in numbers: what it leaves out by a model's radius [mm] and its role. */
arc_body_def arc_body_resolve(const arc_body_def *def, arc_body role, double radius);

/* ARC_ARGUMENT where a resolved body cannot be one: names field, expectation, value;
 * `path` is "upper." or "lower.". */
arc_status arc_body_check(const arc_body_def *def, const char *path, arc_error *error);

/* The settings that bodies of a kind have of their own, NULL ends them. */
const char *const *arc_body_fields(arc_solid kind);

/* Whether its surface is the hollow side of an arc; whether it is an arc at all, or a
 * line. */
int arc_body_is_hollow(const arc_body_def *def);
int arc_body_is_round(const arc_body_def *def);
int arc_body_is_flat(const arc_body_def *def);

/* Radius of its surface [mm], negative where it is hollow, INFINITY where it is flat. */
double arc_body_radius(const arc_body_def *def);

/* Whether it has a radius across the motion too, as half-spaces in 3-D need. */
int arc_body_is_spatial(const arc_body_def *def);

/* Half of its length along the surface [mm]; its depth below the surface [mm]. */
double arc_body_half_length(const arc_body_def *def);
double arc_body_depth(const arc_body_def *def);

/* The least of its dimensions that limit meshes [mm]: the radius of a cylinder and disc,
 * half the width or the height of a block, the wall of a ring. */
double arc_body_measure(const arc_body_def *def);

/* The widest zone that leaves room beside it [mm]. */
double arc_body_widest_zone(const arc_body_def *def);

/* Height of a profile's outermost point [mm]; 0 for others. */
double arc_body_crest(const arc_body_def *def);
/* How far the surface lies inside the body at x [mm], below its outermost point, the
 * crest; 0 for arcs. */
double arc_body_inset(const arc_body_def *def, double crest, double x);

/* Whether its surface is a map, with points over x and z. */
int arc_body_is_map(const arc_body_def *def);
/* Height of a map at (x, z) [mm], out of the body: cubic between its points, level beyond
 * them. Its reach from x = z = 0 to the nearest ends [mm], and the longest of its steps.
 * Curvatures of the parabola that fits it best [1/mm], positive where it is a ball's. */
double arc_body_map_height(const arc_body_def *def, double x, double z);
void arc_body_map_extent(const arc_body_def *def, double *half_x, double *half_z, double *step);
void arc_body_map_curvature(const arc_body_def *def, double *along_x, double *along_z);

/* Copies of a body's series in one block, which is to be freed: *block, NULL where there
 * are none. ARC_MEMORY: it has no series then. */
arc_status arc_body_keep_series(arc_body_def *def, double **block);

/* Layers; the lower end of one [mm] that goes by its thickness, 0 of layer -1; the
 * material of one, of `layers` and beyond the body's own. */
int arc_body_layers(const arc_body_def *def);
double arc_body_interface(const arc_body_def *def, int layer);
arc_material arc_body_layer_material(const arc_body_def *def, int layer, arc_material own);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif
