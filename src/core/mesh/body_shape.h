/* Kinds of bodies: the properties of a shape that meshes and contact estimates use. Each kind is
 * one object; the table is generated from ARC_SOLID_LIST. No other file tests for a particular
 * kind. */
#ifndef MESH_BODY_SHAPE_H
#define MESH_BODY_SHAPE_H

#include "archard/body.h"

typedef enum body_form {
  FORM_RECTANGLE, /* the surface has a height over x, which decays towards the base */
  FORM_POINTS,    /* the same, through given points */
  FORM_WALL,      /* between two arcs */
  FORM_MAP,       /* points over x and z, of a half-space */
  FORM_CORE       /* a solid arc, closed by a fan at its centre */
} body_form;

/* Lengths along the surface [mm]. */
typedef struct body_limits {
  double zone; /* the widest zone beside which coarse columns fit, and its formula in the user's
                  fields */
  const char *zone_text;
  double outer; /* half of the surface that the mesh may refine */
  double reach; /* largest half width of a contact on this body */
  double flat;  /* half width in contact without load; 0: none */
} body_limits;

/* Arguments of the functions are resolved bodies. */
typedef struct body_shape {
  const char *const *fields; /* its own settings, terminated by NULL; x and y for a profile */
  body_form form;
  double turn; /* of an arc: the angle of half its surface; else 0 */
  void (*resolve)(arc_body_def *b, double radius); /* computes fields that depend on others and on
                                                      the model's radius [mm]; NULL: none */
  double (*radius)(const arc_body_def *b); /* of an arc [mm], negative if hollow; else NULL */
  double (*depth)(const arc_body_def *b);  /* below the surface [mm] */
  body_limits (*limits)(const arc_body_def *b);
  double (*crest)(const arc_body_def *b);                         /* see arc_body_crest; NULL: 0 */
  double (*inset)(const arc_body_def *b, double crest, double x); /* see there; NULL: 0 */
  arc_status (*check)(const arc_body_def *b, const char *path, arc_error *error); /* or NULL */
  const struct body_shape *with_hub; /* the shape with hold = "hub"; NULL: the same */
} body_shape;

#define ARC_BODY_SHAPE(name, word, shape) extern const body_shape arc_body_shape_##shape;
ARC_SOLID_LIST(ARC_BODY_SHAPE)
#undef ARC_BODY_SHAPE

const body_shape *arc_body_shape_of(const arc_body_def *b);
body_limits arc_body_limits(const arc_body_def *b);
/* True if the surface is given by points; true if the body is a solid arc. */
int arc_body_has_points(const arc_body_def *b);
int arc_body_is_core(const arc_body_def *b);
/* True if the support at x [mm] holds the body along x as well: everywhere, or in a hub. */
int arc_body_holds_sideways(const arc_body_def *b, double x);
/* True if the surface is closed: full circles. */
int arc_body_is_closed(const arc_body_def *b);

/* Functions used by several kinds. */
double arc_body_height(const arc_body_def *b);
body_limits arc_body_limits_of_width(const arc_body_def *b);

#endif
