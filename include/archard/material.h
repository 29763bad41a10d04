/* archard/material.h - materials: elastic constants and wear coefficient. */
#ifndef ARCHARD_MATERIAL_H
#define ARCHARD_MATERIAL_H

#include "archard/setting.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

#define ARC_MATERIAL_SETTINGS(NUMBER, TEXT)                                                        \
  NUMBER(E, "MPa", 200e3, ABOVE(0), 0, "Young's modulus.")                                         \
  NUMBER(nu, "", 0.3, BETWEEN(-1, 0.5), 0, "Poisson's ratio.")                                     \
  NUMBER(k, "mm2/N", 0, FROM(0), ARC_OPTIONAL,                                                     \
         "Wear coefficient of this body alone, not of the pair. wear{} uses it unless k or alpha " \
         "is set there. A body without k does not wear if the other body has a k.")                \
  TEXT(name, "a text of up to 31 characters", ARC_OPTIONAL,                                        \
       "Name of the material in printed "                                                          \
       "output.")

typedef struct arc_material {
  ARC_MATERIAL_SETTINGS(ARC_MEMBER_NUMBER, ARC_MEMBER_TEXT)
} arc_material;

extern const arc_setting arc_material_settings[];

/* Row of a settings list for a material that is part of another definition. The setting is called
 * `name_`, and the material is at the offset `offset_` [bytes] in the struct. */
#define ARC_MATERIAL_TABLE "{ E=, nu=, k=, name= }"
#define ARC_MATERIAL_SETTING(offset_, name_, text_)                                                \
  {                                                                                                \
    .name = name_, .unit = "", .kind = ARC_GROUP, .group = arc_material_settings,                  \
    .offset = offset_, .class_name = "material", .usual_text = "material{}",                       \
    .type = "a material object or a table " ARC_MATERIAL_TABLE, .text = text_                      \
  }

/* Returns the steel of the reference paper: E = 200e3 MPa, nu = 0.3. */
arc_material arc_material_default(void);

/* Returns the plane-strain modulus E / (1 - nu^2) [MPa]. */
double arc_material_E_star(arc_material material);

/* Checks the values of a material against their ranges. ARC_ARGUMENT: the message has the field,
 * the expected and the actual value. */
arc_status arc_material_check(arc_material material, arc_error *error);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif
