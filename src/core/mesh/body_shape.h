/* Kinds of bodies: what a mesh and an estimate of contact need to know of a shape. One object a
 * kind, the table is made from ARC_SOLID_LIST; nothing outside asks which kind a body is. */
#ifndef MESH_BODY_SHAPE_H
#define MESH_BODY_SHAPE_H

#include "archard/body.h"

typedef enum body_form {
  FORM_RECTANGLE, /* its surface has a height over x, which fades towards the base */
  FORM_POINTS,    /* the same, through points that are given */
  FORM_WALL,      /* between two arcs */
  FORM_MAP,       /* points over x and z, a half-space's */
  FORM_CORE       /* a solid arc, closed by a fan at its centre */
} body_form;

/* Lengths along the surface [mm]. */
typedef struct body_limits {
  double zone; /* the widest zone that leaves room beside it, and how users have it */
  const char *zone_text;
  double outer; /* half of the surface that the mesh may refine */
  double reach; /* the widest half width of a contact that the body is for */
  double flat;  /* half width that touches without load; 0: none */
} body_limits;

/* Functions take resolved bodies. */
typedef struct body_shape {
  const char *const *fields; /* its own settings, NULL ends them; a profile's are x and y */
  body_form form;
  double turn; /* of an arc: the angle of half its surface; else 0 */
  void (*resolve)(arc_body_def *b, double radius); /* fills what follows from its fields and the
                                                      model's radius [mm]; NULL: nothing */
  double (*radius)(const arc_body_def *b); /* of an arc [mm], negative where hollow; else NULL */
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
/* Whether its surface goes through points; whether it is a solid arc. */
int arc_body_has_points(const arc_body_def *b);
int arc_body_is_core(const arc_body_def *b);
/* True if the support at x [mm] holds the body along x as well: everywhere, or in a hub. */
int arc_body_holds_sideways(const arc_body_def *b, double x);
/* Whether both ends of the surface are one: whole arcs. */
int arc_body_is_closed(const arc_body_def *b);

/* What several kinds share. */
double arc_body_height(const arc_body_def *b);
body_limits arc_body_limits_of_width(const arc_body_def *b);

#endif
