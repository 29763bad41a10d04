/* Kinds of bodies: the properties of a shape that meshes and contact estimates use. Each kind is
 * one constant body_shape, and ARC_SOLID_LIST generates the table of kinds. Other files do not
 * test for a particular kind. */
#ifndef MESH_BODY_SHAPE_H
#define MESH_BODY_SHAPE_H

#include "archard/body.h"

typedef enum body_form {
  FORM_RECTANGLE, /* rectangle whose surface heights decay to zero at the base */
  FORM_POINTS,    /* body with a surface through given points */
  FORM_WALL,      /* wall of a ring between two arcs */
  FORM_MAP,       /* half-space with heights at points over x and z */
  FORM_CORE       /* solid arc, filled with a fan of triangles at its centre */
} body_form;

/* Limits of a kind of body: lengths along the surface [mm]. */
typedef struct body_limits {
  double zone;           /* largest width of a zone with coarse columns beside it */
  const char *zone_text; /* formula of the largest width, for messages */
  double outer;          /* half the largest length of the surface with fine elements */
  double reach;          /* largest half width of a contact on this body */
  double flat;           /* half width of the contact without load; 0 if it is a point */
} body_limits;

/* Properties and functions of a kind of body. The functions receive resolved bodies. */
typedef struct body_shape {
  const char *const *fields; /* names of the settings of this kind; the last entry is NULL */
  body_form form;
  double turn; /* half the angle of an arc [rad]; 0 for other forms */
  void (*resolve)(arc_body_def *b, double radius); /* computes the fields that depend on other
                                                      fields and on the model's radius [mm]; may
                                                      be NULL */
  double (*radius)(const arc_body_def *b); /* returns the radius of an arc [mm], negative if hollow;
                                              NULL for other forms */
  double (*depth)(const arc_body_def *b); /* returns the depth of the body below its surface [mm] */
  body_limits (*limits)(const arc_body_def *b);
  double (*crest)(const arc_body_def *b); /* returns the result of arc_body_crest; NULL: the
                                             result is 0 */
  double (*inset)(const arc_body_def *b, double crest,
                  double x); /* returns the result of arc_body_inset; NULL: the result is 0 */
  arc_status (*check)(const arc_body_def *b, const char *path,
                      arc_error *error); /* checks the fields of the kind; may be NULL */
  const struct body_shape *with_hub;     /* shape of the body if hold = "hub"; NULL: this shape */
} body_shape;

#define ARC_BODY_SHAPE(name, word, shape) extern const body_shape arc_body_shape_##shape;
ARC_SOLID_LIST(ARC_BODY_SHAPE)
#undef ARC_BODY_SHAPE

const body_shape *arc_body_shape_of(const arc_body_def *b);
body_limits arc_body_limits(const arc_body_def *b);
/* arc_body_has_points returns true if points define the surface. arc_body_is_core returns true
 * if the body is a solid arc. */
int arc_body_has_points(const arc_body_def *b);
int arc_body_is_core(const arc_body_def *b);
/* Returns true if the support at x [mm] also fixes the body along x. A "free" support fixes it
 * only at |x| <= 0.15 radius; other supports fix it everywhere. */
int arc_body_holds_sideways(const arc_body_def *b, double x);
/* Returns true if the surface is a closed curve, such as a full circle. */
int arc_body_is_closed(const arc_body_def *b);

/* Functions that several kinds have in common. */
double arc_body_height(const arc_body_def *b);
body_limits arc_body_limits_of_width(const arc_body_def *b);

#endif
