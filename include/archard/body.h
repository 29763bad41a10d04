/* archard/body.h - shapes of bodies: surface, dimensions, layers and supports.
 *
 * A pair consists of an upper and a lower body. The surface of each body passes through the origin,
 * which is the first point of contact. Surfaces are symmetric about x = 0, except for measured
 * profiles. */
#ifndef ARCHARD_BODY_H
#define ARCHARD_BODY_H

#include "archard/material.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* Roles of the two bodies. The load acts on the support of the upper body, and the lower body
 * moves. In the reference paper they are the cylinder and the plate. */
typedef enum arc_body {
  ARC_CYLINDER = 0,
  ARC_PLATE = 1,
  ARC_UPPER = ARC_CYLINDER,
  ARC_LOWER = ARC_PLATE
} arc_body;
#define ARC_BODIES 2

/* Returns the name of a role in the reference paper: "cylinder" or "plate". */
const char *arc_body_name(arc_body body);

/* Kinds of bodies: X(NAME, "name", functions). The functions of a kind are in an object of that
 * name, see src/core/mesh/body_shape.h. */
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

/* Support of a cylinder. Fixed: its flat side is fixed. Free: the flat side is fixed along y, and
 * along x only in its middle part. Hub: the body is a whole disc around a rigid hub. */
#define ARC_HOLD_LIST(X)                                                                           \
  X(HOLD_FIXED, "fixed")                                                                           \
  X(HOLD_HUB, "hub")                                                                               \
  X(HOLD_FREE, "free")
typedef enum arc_hold { ARC_HOLD_LIST(ARC_CHOICE_ENUM) } arc_hold;
extern const char *const arc_hold_names[];

/* A layer on the surface of a body, with a material of its own. It has a uniform thickness, or it
 * is the part of an imported mesh that has the material `name`. */
#define ARC_LAYER_SETTINGS(NUMBER, TEXT)                                                           \
  TEXT(name, "a name of a material in the imported mesh", ARC_OPTIONAL,                            \
       "Name of the layer's physical group in an imported mesh, instead of a thickness.")          \
  NUMBER(thickness, "mm", 0, ABOVE(0), ARC_OPTIONAL, "Thickness of the layer.")

typedef struct arc_layer {
  ARC_LAYER_SETTINGS(
      ARC_MEMBER_NUMBER,
      ARC_MEMBER_TEXT) /* either name or thickness is set; if neither is set, there is no layer */
  arc_material material;
} arc_layer;
enum { ARC_MOST_LAYERS = 4 };

extern const arc_setting
    arc_layer_settings[]; /* settings of a layer, with its material as a group */

/* Description of a valid name of a body, for messages. */
#define ARC_BODY_NAME                                                                              \
  "a word of letters, digits and _ that begins with a letter, at most 31 characters"

#define ARC_BODY_SETTINGS(NUMBER, CHOICE, TEXT)                                                    \
  TEXT(name, ARC_BODY_NAME, ARC_OPTIONAL,                                                          \
       "Name of the body in results, pictures and files. Default: the kind of body, or "           \
       "\"upper\" and \"lower\".")                                                                 \
  CHOICE(kind, solid, ARC_SOLID_USUAL, 0,                                                          \
         "Shape of the body. \"usual\": a cylinder as upper and a block as lower body; \"gmsh\": " \
         "the shape in the Gmsh file of the model.")                                               \
  NUMBER(                                                                                          \
      radius, "mm", 0, ABOVE(0), ARC_OPTIONAL,                                                     \
      "Radius of a cylinder or disc, or of the rounded edges of a punch; default: the radius of "  \
      "the model. For a map: radius of a ball to which the heights are added; default: none.")     \
  NUMBER(radius_z, "mm", 0, ABOVE(0), ARC_OPTIONAL,                                                \
         "Radius of a ball across the motion (along z), for a crowned roller or an ellipsoid. "    \
         "Default: radius.")                                                                       \
  NUMBER(width, "mm", 0, ABOVE(0), ARC_OPTIONAL,                                                   \
         "Width of a block or profile. Default: twice the model's radius.")                        \
  NUMBER(height, "mm", 0, ABOVE(0), ARC_OPTIONAL,                                                  \
         "Height of a block, profile or punch. Default: the model's radius; for a punch at least " \
         "twice the radius of its edges.")                                                         \
  NUMBER(flat, "mm", 0, ABOVE(0), ARC_OPTIONAL,                                                    \
         "Full width of the flat face of a punch between its rounded edges; each edge is one "     \
         "radius wide.")                                                                           \
  NUMBER(inner, "mm", 0, ABOVE(0), ARC_OPTIONAL, "Inner radius of a ring.")                        \
  NUMBER(outer, "mm", 0, ABOVE(0), ARC_OPTIONAL, "Outer radius of a ring.")                        \
  CHOICE(fixed, rim, ARC_RIM_OUTER, 0, "Fixed rim of a ring. The other rim is in contact.")        \
  CHOICE(hold, hold, ARC_HOLD_FIXED, 0,                                                            \
         "Support of a cylinder, which matters if the contact is nearly as wide as the cylinder. " \
         "\"fixed\": the flat side of a half cylinder is rigid; \"free\": this side is fixed "     \
         "vertically, and sideways only in its middle 15 %; \"hub\": a whole disc around a rigid " \
         "hub of 0.15 times its radius, as in body.disc.")

typedef struct arc_body_def {
  ARC_BODY_SETTINGS(ARC_MEMBER_NUMBER, ARC_MEMBER_CHOICE, ARC_MEMBER_TEXT)
  double y;            /* unused, always 0; the heights are in y_series */
  arc_series y_series; /* heights [mm], positive out of the body. A profile has heights at
                          positions x [mm], and is linear between them and constant beyond them. A
                          map has one height for each point of its grid, in the order of the
                          points, in which z varies fastest. The caller owns the arrays; a model
                          stores a copy */
  double x, z;         /* unused, always 0; the positions are in x_series and z_series */
  arc_series x_series,
      z_series; /* position [mm] of each point of a map, in the order of the points */
  arc_layer layer[ARC_MOST_LAYERS]; /* layers from the surface inwards */
} arc_body_def;

extern const arc_setting arc_body_settings[];

/* Returns the body with all dimensions set. Dimensions that are 0 in `def` are set to their
 * defaults, which depend on the radius of the model [mm] and on the role of the body. */
arc_body_def arc_body_resolve(const arc_body_def *def, arc_body role, double radius);

/* Checks a body that arc_body_resolve returned. ARC_ARGUMENT: the message has the field with the
 * prefix `path` ("upper." or "lower."), the expected and the actual value. */
arc_status arc_body_check(const arc_body_def *def, const char *path, arc_error *error);

/* Returns the names of the settings that apply to a kind of body, as a list that ends with NULL. */
const char *const *arc_body_fields(arc_solid kind);

/* arc_body_is_hollow returns true if the surface is the hollow side of an arc, arc_body_is_round if
 * it is an arc, and arc_body_is_flat if it is a straight line. */
int arc_body_is_hollow(const arc_body_def *def);
int arc_body_is_round(const arc_body_def *def);
int arc_body_is_flat(const arc_body_def *def);

/* Returns the radius of curvature of the surface [mm]: negative if it is concave, INFINITY if it is
 * flat. */
double arc_body_radius(const arc_body_def *def);

/* Returns true if the body has a radius of curvature across the motion (along z), which only 3-D
 * models use. */
int arc_body_is_spatial(const arc_body_def *def);

/* arc_body_half_length returns half the length of the body along its surface [mm], arc_body_depth
 * the depth of the body below the surface [mm]. */
double arc_body_half_length(const arc_body_def *def);
double arc_body_depth(const arc_body_def *def);

/* Returns the dimension that limits the element sizes [mm]: the radius of a cylinder or disc, the
 * wall thickness of a ring, the smaller of half width and height of a body that is not round. */
double arc_body_measure(const arc_body_def *def);

/* Returns the width of the widest possible contact zone [mm]. */
double arc_body_widest_zone(const arc_body_def *def);

/* Returns the height of a profile's outermost point [mm]; 0 for other bodies. */
double arc_body_crest(const arc_body_def *def);
/* Returns the depth [mm] of the surface at x [mm] below its outermost point, whose height is
 * `crest` [mm]. Returns 0 for arcs. */
double arc_body_inset(const arc_body_def *def, double crest, double x);

/* Returns true if the surface is a map over x and z. */
int arc_body_is_map(const arc_body_def *def);
/* Properties of a map. arc_body_map_height returns the height [mm] at (x, z), positive out of the
 * body. It is interpolated by cubics between the points and constant beyond them.
 * arc_body_map_extent writes the distances from x = z = 0 to the nearest ends of the map, and the
 * largest spacing of its points [mm]. arc_body_map_curvature writes the curvatures along x and z
 * [1/mm] of a parabola fitted to the map, positive for a ball. */
double arc_body_map_height(const arc_body_def *def, double x, double z);
void arc_body_map_extent(const arc_body_def *def, double *half_x, double *half_z, double *step);
void arc_body_map_curvature(const arc_body_def *def, double *along_x, double *along_z);

/* Replaces the series of a body (heights and positions) by copies in one block. The caller frees
 * *block with free(); it is NULL if the body has no series. On ARC_MEMORY the body has no
 * series. */
arc_status arc_body_keep_series(arc_body_def *def, double **block);

/* arc_body_layers returns the number of layers. arc_body_interface returns the depth [mm] of the
 * lower side of a layer with a thickness, and 0 for layer -1, the surface. arc_body_layer_material
 * returns the material of a layer, or `own` if no layer has this index. */
int arc_body_layers(const arc_body_def *def);
double arc_body_interface(const arc_body_def *def, int layer);
arc_material arc_body_layer_material(const arc_body_def *def, int layer, arc_material own);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif
