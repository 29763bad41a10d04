/* Kinds of bodies: the properties of a shape that meshes and contact estimates use. Each kind is
 * one object, and the table is generated from ARC_SOLID_LIST. No other file tests for a particular
 * kind. */
#ifndef MESH_BODY_SHAPE_H
#define MESH_BODY_SHAPE_H

#include "archard/body.h"

typedef enum body_form {
  FORM_RECTANGLE, /* surface with heights over x, which decay towards the base */
  FORM_POINTS,    /* surface with heights through given points */
  FORM_WALL,      /* wall between two arcs */
  FORM_MAP,       /* half-space with points over x and z */
  FORM_CORE       /* solid arc, closed by a fan of triangles at its centre */
} body_form;

/* Lengths along the surface [mm]. */
typedef struct body_limits {
  double zone; /* width of the widest zone beside which coarse columns fit, and its
                  formula in the user's fields */
  const char *zone_text;
  double outer; /* half of the surface that may have fine elements */
  double reach; /* largest half width of a contact on this body */
  double flat;  /* half width in contact without load; 0: a point */
} body_limits;

/* Functions of a kind of body; their arguments are resolved bodies. */
typedef struct body_shape {
  const char *const
      *fields; /* settings that only this kind has, ended by NULL; x and y for a profile */
  body_form form;
  double turn; /* for an arc: the angle of half its surface; else 0 */
  void (*resolve)(arc_body_def *b, double radius); /* computes fields that depend on others and on
                                                      the model's radius [mm]; NULL: none */
  double (*radius)(
      const arc_body_def *b);             /* radius of an arc [mm], negative if hollow; else NULL */
  double (*depth)(const arc_body_def *b); /* depth below the surface [mm] */
  body_limits (*limits)(const arc_body_def *b);
  double (*crest)(const arc_body_def *b);                         /* see arc_body_crest; NULL: 0 */
  double (*inset)(const arc_body_def *b, double crest, double x); /* see arc_body_inset; NULL: 0 */
  arc_status (*check)(const arc_body_def *b, const char *path,
                      arc_error *error); /* check of the kind's fields; may be NULL */
  const struct body_shape *with_hub;     /* shape with hold = "hub"; NULL: unchanged */
} body_shape;

#define ARC_BODY_SHAPE(name, word, shape) extern const body_shape arc_body_shape_##shape;
ARC_SOLID_LIST(ARC_BODY_SHAPE)
#undef ARC_BODY_SHAPE

const body_shape *arc_body_shape_of(const arc_body_def *b);
body_limits arc_body_limits(const arc_body_def *b);
/* Return true if the surface is given by points, and if the body is a solid arc. */
int arc_body_has_points(const arc_body_def *b);
int arc_body_is_core(const arc_body_def *b);
/* Returns true if the support at x [mm] also fixes the body along x, which is everywhere or only in
 * a hub. */
int arc_body_holds_sideways(const arc_body_def *b, double x);
/* Returns true if the surface is closed, as a full circle is. */
int arc_body_is_closed(const arc_body_def *b);

/* Functions that several kinds use. */
double arc_body_height(const arc_body_def *b);
body_limits arc_body_limits_of_width(const arc_body_def *b);

#endif
