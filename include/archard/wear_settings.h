/* archard/wear_settings.h - the definition of a wear run: the settings of wear{}, and the wear
 * laws.
 *
 * A definition is a plain structure. It starts from arc_wear_default, and runs copy it. Lists of
 * choices and the table of settings have the words, units, ranges and texts that users read. */
#ifndef ARCHARD_WEAR_SETTINGS_H
#define ARCHARD_WEAR_SETTINGS_H

#include "archard/contact.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* Procedures of a run (Fig. 7 of the reference paper). SP: the sliding of the plate is simulated.
 * NSP: one contact is solved in each update, which is correct if the plate stays flat. Auto: SP or
 * NSP, chosen from the definition. */
#define ARC_PROCEDURE_LIST(X)                                                                      \
  X(AUTO, "auto")                                                                                  \
  X(SP, "SP")                                                                                      \
  X(NSP, "NSP")
#define ARC_SCHEME_LIST(X)                                                                         \
  X(EXPLICIT, "explicit")                                                                          \
  X(IMPLICIT, "implicit")
/* Sliding distance of an increment. Rigid: the motion of the plate. Total: this motion plus the
 * elastic displacements (CSLIP of Abaqus). */
#define ARC_SLIP_LIST(X)                                                                           \
  X(SLIP_RIGID, "rigid")                                                                           \
  X(SLIP_TOTAL, "total")
/* Direction of sliding. x: along x, in the plane. z: along z, across the plane, so that each point
 * stays opposite to the same point of the other body. */
#define ARC_SLIDE_LIST(X)                                                                          \
  X(SLIDE_X, "x")                                                                                  \
  X(SLIDE_Z, "z")
/* Rule by which the wear is integrated over the increments of a cycle. Trapezoid: with the mean of
 * the pressures at both ends of an increment, Eq. (4) of the reference paper. Simple: with the
 * pressure at its end, Eq. (5). */
#define ARC_RULE_LIST(X)                                                                           \
  X(TRAPEZOID, "trapezoid")                                                                        \
  X(SIMPLE, "simple")
/* Times at which the geometry is updated. Cycle: every `jump` cycles. Increment: at every increment
 * of a cycle. */
#define ARC_UPDATE_LIST(X)                                                                         \
  X(UPDATE_CYCLE, "cycle")                                                                         \
  X(UPDATE_INCREMENT, "increment")
/* Wear laws: X(name, "name", properties, text for users, factor, growth). A law multiplies k at a
 * node by `factor`, which depends on the pressure p [MPa] of the node. `growth` is d ln(p factor) /
 * d ln p, for implicit steps. Both expressions may use the arc_wear_def `d`. Other code depends
 * only on the properties of a law. */
#define ARC_LAW_LIST(X)                                                                            \
  X(LAW_ARCHARD, "archard", ARC_LAW_LINEAR, "1", 1, 1)                                             \
  X(LAW_POWER, "power", 0, "(p / law_pressure)^law_exponent",                                      \
    p > 0 ? pow(p / d->law_pressure, d->law_exponent) : 0, 1 + d->law_exponent)                    \
  X(LAW_THRESHOLD, "threshold", ARC_LAW_JUMPS, "1 where p > law_pressure, 0 elsewhere",            \
    p > d->law_pressure, 1)                                                                        \
  X(LAW_ENERGY, "energy", ARC_LAW_OF_SHEAR,                                                        \
    "q / p, so that wear is k times the friction energy q ds and k is in mm3/(N mm)", 1, 1)

#define ARC_LAW_TEXT(name, word, properties, text, ...) " \"" word "\": " text "."

/* Properties of wear laws, as flags. */
enum {
  ARC_LAW_LINEAR =
      1, /* Archard's law: the wear is k times pressure times sliding distance at every pressure */
  ARC_LAW_JUMPS = 2,   /* the factor on k is not a continuous function of the pressure */
  ARC_LAW_OF_SHEAR = 4 /* the wear depends on the shear q instead of the pressure; needs friction */
};

typedef enum arc_procedure { ARC_PROCEDURE_LIST(ARC_CHOICE_ENUM) } arc_procedure;
typedef enum arc_scheme { ARC_SCHEME_LIST(ARC_CHOICE_ENUM) } arc_scheme;
typedef enum arc_slip { ARC_SLIP_LIST(ARC_CHOICE_ENUM) } arc_slip;
typedef enum arc_slide { ARC_SLIDE_LIST(ARC_CHOICE_ENUM) } arc_slide;
typedef enum arc_rule { ARC_RULE_LIST(ARC_CHOICE_ENUM) } arc_rule;
typedef enum arc_update { ARC_UPDATE_LIST(ARC_CHOICE_ENUM) } arc_update;
typedef enum arc_law { ARC_LAW_LIST(ARC_CHOICE_ENUM) } arc_law;
extern const char *const arc_procedure_names[];
extern const char *const arc_slide_names[];
extern const char *const arc_scheme_names[];
extern const char *const arc_slip_names[];
extern const char *const arc_rule_names[];
extern const char *const arc_update_names[];
extern const char *const arc_law_names[];
extern const unsigned arc_law_properties[]; /* [law] flags of the properties of each law */

typedef struct arc_wear_record arc_wear_record;

/* User function that computes the value of the setting `what` from the state of a run. A status
 * other than ARC_OK makes the step fail. */
typedef arc_status (*arc_state_fn)(void *context, const arc_setting *what,
                                   const arc_wear_record *state, double *value);

/* User function that computes the factors by which k is multiplied at n nodes of one body. The
 * inputs are the unworn positions x [mm] of the nodes on the body, in 3-D their positions z [mm]
 * across the motion (otherwise NULL), and their pressures p [MPa] at one increment. A status other
 * than ARC_OK makes the step fail. */
typedef arc_status (*arc_local_fn)(void *context, arc_body body, int n, const double *x,
                                   const double *z, const double *p, const arc_wear_record *state,
                                   double *factor);

/* One block of loading: positions of the plate and loads at count >= 2 points of a cycle, which
 * includes both strokes. At points with load 0 the bodies are apart and do not wear. */
typedef struct arc_loading {
  int count;
  const double *x;          /* [count] position of the plate [mm] */
  const double *load;       /* [count] normal load [N], >= 0 */
  const double *tangential; /* [count] tangential force that drives the plate [N]; x is then 0.
                               NULL: the position x is prescribed */
  const double *rotation;   /* [count] rotation of the lower body in holes [degrees]; x is then 0.
                               NULL: no rotation */
  const double *load_angle; /* [count] angle of the load in holes [degrees], see the setting
                               load_angle; NULL: load_angle of the definition */
  double cycles; /* number of cycles > 0. It may be INFINITY in the last block, which then lasts to
                    the end of the distance */
  int periodic;  /* 1: the cycle repeats; 0: the block runs once, with an update at every increment
                  */
} arc_loading;

#define ARC_WEAR_SETTINGS(NUMBER, WHOLE, CHOICE, QUANTITY, FUNCTION, OTHER)                        \
  CHOICE(scheme, scheme, ARC_EXPLICIT, ARC_OPTIONAL,                                               \
         "How an update computes the wear: \"explicit\", from the pressures at its start; "        \
         "\"implicit\", from the pressures at its end, which allows longer steps (see order). By " \
         "default steps are implicit. They are explicit where this is faster or more accurate: "   \
         "if jump is a number or a function, for law = \"threshold\" and, in 2-D, with friction, " \
         "slip = \"total\", a local_factor, update = \"increment\", loadings that do not repeat "  \
         "or geometry = \"springs\".")                                                             \
  QUANTITY(                                                                                        \
      k, "mm2/N", 1e-8, FROM(0), ARC_FUNCTION | ARC_SERIES,                                        \
      "Wear coefficient k of both bodies together: wear volume = k times load times sliding "      \
      "distance (Eq. 1). To convert from mm3/(N m), divide by 1000. k is divided between "         \
      "the bodies by alpha (by default in halves). If the coefficient of one body was "            \
      "measured, use k_cylinder or k_plate instead. k can also be a function of the state "        \
      "(help \"state\"), or a table that is interpolated linearly over the distance; two "         \
      "values at the same distance define a jump, and an update ends there. Functions and "        \
      "tables are integrated over each update. A function is evaluated at intervals shorter "      \
      "than a cycle or, in runs of over 2000 cycles, than a 3000th of the run; shorter peaks "     \
      "may be missed.")                                                                            \
  QUANTITY(alpha, "", 0.5, WITHIN(0, 1), ARC_FUNCTION | ARC_SERIES,                                \
           "Wear partition factor k_c / k (Eq. 19 of the paper): the upper body's (cylinder's) "   \
           "share of the wear volume. 0: only the plate wears, 1: only the cylinder (pin, ball) "  \
           "wears. It is measured as the worn volume of the upper body divided by the worn "       \
           "volume of both bodies: calibrate{ volume={...} }. For a polymer on metal, where only " \
           "the polymer wears: 0 if the polymer is the lower body, 1 if it is the upper.")         \
  OTHER(k_cylinder, "a number >= 0 mm2/N", NULL, 0,                                                \
        "Wear coefficient of the cylinder alone, k_c = alpha k. If both bodies wear with "         \
        "different coefficients, give k_cylinder and k_plate (0 for a body that does not wear) "   \
        "instead of k and alpha, or give each body a k: model = { cylinder = { k = ... }, plate "  \
        "= { k = ... } }.")                                                                        \
  OTHER(                                                                                           \
      k_plate, "a number >= 0 mm2/N", NULL, 0,                                                     \
      "Wear coefficient of the plate alone, k_p = (1 - alpha) k. Set k_cylinder as well (0 for a " \
      "body that does not wear).")                                                                 \
  NUMBER(load, "N", 100, ABOVE(0), 0,                                                              \
         "Normal load L_N, in 2-D over the whole thickness of the bodies. For a load that varies " \
         "during a cycle use loading; load is then the load at which pressures and widths are "    \
         "reported.")                                                                              \
  NUMBER(load_angle, "degrees", 0, BETWEEN(-90, 90), 0,                                            \
         "Direction of the load on a pin in a hole: angle between the load and the line from the " \
         "centre of the hole to the point of first contact, positive towards +x. With loading, "   \
         "the angle at which pressures and widths are reported.")                                  \
  NUMBER(stroke, "mm", 0.11, ABOVE(0), 0,                                                          \
         "Stroke s_t of the plate, from one end to the other, twice the amplitude. In a "          \
         "reciprocating test give cycles = frequency times time; results do not depend on the "    \
         "frequency or on whether the motion is sinusoidal. For fretting give friction too: "      \
         "wear{ friction=0.6, stroke=0.05 } has an amplitude of 25 um. In 2-D, if the stroke "     \
         "is twice the radius, the whole plate slides under the contact once, in one direction: "  \
         "a cycle has one stroke instead of two. The strokes in the reference paper are 0.11, "    \
         "0.22, 0.44 mm (a, 2a, 4a; a is the half width of the contact) and 20 mm (2R).")          \
  NUMBER(distance, "mm", 1320, ABOVE(0), ARC_OPTIONAL,                                             \
         "Sliding distance d_t to simulate. Give distance or cycles. With loading, the default "   \
         "is the end of its last block.")                                                          \
  OTHER(cycles, "a number > 0 cycles", NULL, 0,                                                    \
        "Number of loading cycles to simulate: the distance divided by the sliding distance of a " \
        "cycle (Eq. 21). Give cycles or distance.")                                                \
  QUANTITY(                                                                                        \
      jump, "cycles", 0, ABOVE(0), ARC_AUTOMATIC | ARC_FUNCTION,                                   \
      "Number of cycles between two updates of the geometry (N-bar in the paper). \"auto\": the "  \
      "number follows from an estimate of the error. With a number, pressures stay constant "      \
      "between two updates, as in the paper; too large a number is unstable and causes sawtooth "  \
      "ripples, see w:stability(). A function computes the number from the state before each "     \
      "update. scheme = \"implicit\" is stable with any jump.")                                    \
  WHOLE(increments, "", 0, EVEN(2, 100000), ARC_AUTOMATIC,                                         \
        "Number n_c of increments in a full cycle. Only half of them are simulated, since both "   \
        "strokes are alike (Eq. 22). \"auto\": 100, or as many as are needed for the plate to "    \
        "move by at most an eighth of the contact's half width in one increment; the motion "      \
        "between two points of a loading is divided by the same rule.")                            \
  NUMBER(refresh, "", 0.05, FROM(0), 0,                                                            \
         "With moving geometry: the stiffness of a worn body is recomputed when wear has moved a " \
         "surface node by this fraction of the height of its element. Smaller values are more "    \
         "accurate and slower; the default suffices for most runs. In a layer a fifth of the "     \
         "remaining thickness replaces the height if it is less. Along the surface the limit is "  \
         "0.01 times this fraction of the element width. Between two computations the stiffness "  \
         "is corrected to first order (not with layers). 0: the stiffness is recomputed at every " \
         "update. No effect in 3-D.")                                                              \
  CHOICE(                                                                                          \
      corrections, corrections, ARC_CORRECTIONS_ALL, 0,                                            \
      "\"none\": the finite elements alone, without the terms that correct their errors at short " \
      "wavelengths (edges of contact, shear from node to node, slip between nodes, stiffness "     \
      "between two refreshes); use it to see the effect of these terms. No effect in 3-D.")        \
  CHOICE(procedure, procedure, ARC_AUTO, 0,                                                        \
         "\"SP\" simulates the sliding plate (Eq. 22). \"NSP\" solves one contact per update, "    \
         "which is correct if the plate stays flat: if alpha = 1 and, in 3-D, the lower body is "  \
         "flat, or if the stroke is twice the radius (Eqs. 24-27). \"auto\" chooses one of them.") \
  CHOICE(slip, slip, ARC_SLIP_RIGID, 0,                                                            \
         "Sliding distance of an increment. \"rigid\": the motion of the plate; the wear volume "  \
         "is then exactly k times load times distance (with slide = \"z\" slightly more, because " \
         "an inclined surface is longer). \"total\": this motion plus the elastic "                \
         "displacements of the surfaces, which matter if the stroke is short. In both cases the "  \
         "volumes of the bodies have the ratio k_c / k_p. Not used with friction, where wear "     \
         "uses the local slip.")                                                                   \
  QUANTITY(                                                                                        \
      friction, "", 0, FROM(0), ARC_FUNCTION | ARC_SERIES,                                         \
      "Coefficient of friction between the bodies: a number, a function of the state or a table "  \
      "over the distance; 0: no friction. With friction, wear and energy use the local slip: "     \
      "both strokes are solved with stick and slip, starting from newly pressed bodies, until "    \
      "the cycle is periodic; wear and energy are those of this cycle. With jump = \"auto\" and "  \
      "implicit updates a change of the coefficient within an update is integrated; updates of a " \
      "fixed number of cycles use the mean. An update ends where a table jumps. Needs update = "   \
      "\"cycle\", the default.")                                                                   \
  CHOICE(                                                                                          \
      press, press, ARC_PRESS_FRICTION, 0,                                                         \
      "\"friction\": friction acts while the bodies are pressed together, as in contact{}; "       \
      "\"frictionless\": friction acts only after that. The choice matters if the materials "      \
      "differ and a part of the contact never slips. If both bodies have the same material and "   \
      "Hertz' formulas apply, pressing causes no shear and is computed without friction.")         \
  NUMBER(tangential, "N", 0, ABOVE(0), ARC_OPTIONAL,                                               \
         "Amplitude of a tangential force that moves the plate back and forth, instead of "        \
         "stroke; needs friction, and must be less than friction times load. Since the slip is "   \
         "not known beforehand, a cycle counts as the distance 4 force / (E* thickness), with "    \
         "the contact modulus E*; in 3-D twice the half width of the contact replaces the "        \
         "thickness. Give cycles rather than a distance.")                                         \
  CHOICE(slide, slide, ARC_SLIDE_X, 0,                                                             \
         "Direction of sliding: along x, or along z out of the plane. With \"z\" the contact "     \
         "stays at x = 0, stroke is the displacement along z, and alpha-tilde is alpha. Bodies "   \
         "of revolution need \"z\" (all points slide by the same distance, as for a pin on a "     \
         "disc), unless they spin.")                                                               \
  NUMBER(spin, "mm", 0, ABOVE(0), ARC_OPTIONAL,                                                    \
         "For bodies that rotate about their axis of revolution: the radius at which stroke and "  \
         "distance are measured. Slip is proportional to the radius. With spin = 1, distances "    \
         "are angles in radians.")                                                                 \
  NUMBER(track, "mm", 0, ABOVE(0), ARC_OPTIONAL,                                                   \
         "For a pin on a disc: mean radius of its track, larger than the radius of the contact. "  \
         "A cycle is then a revolution, and stroke is not used. Except in 3-D, the disc stays "    \
         "flat, and its depth is the mean over a track as wide as the present contact. In 3-D a "  \
         "groove is worn into the disc, with the same cross-section along the whole track.")       \
  CHOICE(rule, rule, ARC_TRAPEZOID, 0,                                                             \
         "Integration of the wear over the increments of a cycle: \"simple\", with the pressure "  \
         "at the end of each increment (Eq. 5); \"trapezoid\", with the mean of the pressures at " \
         "both ends (Eq. 4).")                                                                     \
  CHOICE(geometry, geometry, ARC_MOVING, ARC_FIXED,                                                \
         "\"moving\": wear changes the mesh and with it the stiffness near the surface; "          \
         "\"frozen\": wear changes only the gap between the bodies. No effect in 3-D, where the "  \
         "stiffness of the bodies is always that of half-spaces.")                                 \
  CHOICE(update, update, ARC_UPDATE_CYCLE, 0,                                                      \
         "When the geometry is updated: \"cycle\", every `jump` cycles; \"increment\", at every "  \
         "increment of a cycle (quasi-continuous).")                                               \
  CHOICE(law, law, ARC_LAW_ARCHARD, 0,                                                             \
         "Wear law: a factor on k that depends on the pressure p or, with friction, on the "       \
         "shear q." ARC_LAW_LIST(ARC_LAW_TEXT))                                                    \
  NUMBER(law_pressure, "MPa", 100, ABOVE(0), 0,                                                    \
         "Reference pressure of the power law, or threshold of the threshold law; see law.")       \
  NUMBER(law_exponent, "", 1, ABOVE_TO(-1, 10), 0, "Exponent of the power law.")                   \
  WHOLE(order, "", 2, WITHIN(1, 2), 0,                                                             \
        "Order of the implicit scheme. 1: an update uses the pressures at its end (backward "      \
        "Euler). 2: it uses the pressures at its start, at an intermediate stage and at its end "  \
        "(TR-BDF2).")                                                                              \
  WHOLE(workers, "", 1, WITHIN(1, 64), 0,                                                          \
        "Number of threads among which the positions of a stroke are divided in 3-D. Results are " \
        "the same to the bit for any number of threads.")                                          \
  NUMBER(                                                                                          \
      tolerance, "", 0, BETWEEN(0, 1), ARC_OPTIONAL,                                               \
      "Accepted error of the depths of an implicit run, relative to the largest depth, at "        \
      "every node deeper than a twentieth of the largest depth. The lengths of the steps are "     \
      "chosen for this error. Pressures have 10 times this error on average, and more at "         \
      "single nodes at the edge of the contact. Default: 1e-3 if jump is \"auto\". With a "        \
      "number as jump all steps have this length, and their error is not checked. Explicit "       \
      "runs have an error of about 0.5 % with jump = \"auto\"; a tolerance makes them implicit.")  \
  OTHER(model, "a model object or a table of its fields", "model", ARC_FIXED,                      \
        "The two bodies. Default: model{} with contact zones wide enough for the stroke, built "   \
        "on first use.")                                                                           \
  OTHER(worn, "a wear object or a table { cylinder=, plate= }", "wear", ARC_FIXED,                 \
        "Initial surfaces: a wear run, whose present surfaces are used, or for each body a "       \
        "function f(x) for the depth in mm or a measured profile { x={...}, h={...} }; in 3-D a "  \
        "function f(x, z) or a map of depths, which is 0 outside the scar. Depths and "            \
        "alpha-tilde are measured from the unworn surfaces, volumes from the initial surfaces.")   \
  OTHER(loading, "a block { x=, load= } or a list of them", NULL, 0,                               \
        "A loading cycle instead of a stroke and a constant load. Its fields x and load are "      \
        "functions of t, which runs from 0 to 1 over the cycle, or lists of sampled values. Both " \
        "strokes are simulated. Functions are called once, when the run is created. A list of "    \
        "loadings defines blocks that follow each other, each with its number of cycles. Without " \
        "a distance the run ends with the last block; a last block without cycles lasts to the "   \
        "end of the distance. Pressures and widths are reported at the field load of wear{}, by "  \
        "default the largest load of the loading. \n\nIn a hole, the field rotation (degrees) "    \
        "turns the lower body and replaces x; load_angle (degrees) is the angle of the load. "     \
        "Meshes reach 80 degrees to either side: a narrow contact can rotate by about 70 "         \
        "degrees, a wide contact by less. A full rotation is not possible. \n\ncsv.read(path) "    \
        "reads measured lists.")                                                                   \
  FUNCTION(local_factor, "a function(body, x, p, state, z) or { vector = function }",              \
           arc_local_fn, 0,                                                                        \
           "Function that returns a factor on k for each node, for effects such as cross-shear. "  \
           "body is \"cylinder\" or \"plate\", x the position of the node on its body in mm, p "   \
           "its pressure in MPa, and z its position across the motion in mm (with geometry = "     \
           "\"3-D\" only). The factor must be >= 0. The function is called at every increment "    \
           "for nodes with pressure, because other nodes do not wear.")

typedef struct arc_wear_def {
  ARC_WEAR_SETTINGS(ARC_MEMBER_NUMBER, ARC_MEMBER_WHOLE, ARC_MEMBER_CHOICE, ARC_MEMBER_QUANTITY,
                    ARC_MEMBER_FUNCTION, ARC_MEMBER_OTHER)
  void *context; /* first argument of every user function */
  int blocks; /* number of blocks of loading; 0: the plate reciprocates by `stroke` under `load` */
  const arc_loading
      *loading; /* [blocks] blocks of loading in the order of time; the run copies them */
  double start_distance, start_cycle; /* distance [mm] and cycle at which the loading
                                         starts; set by arc_wear_set */
} arc_wear_def;

extern const arc_setting arc_wear_settings[];

/* Index of each setting in the list, such as ARC_AT_k. */
enum {
  ARC_WEAR_SETTINGS(ARC_POSITION, ARC_POSITION, ARC_POSITION, ARC_POSITION, ARC_POSITION,
                    ARC_POSITION) ARC_WEAR_SETTINGS_COUNT
};

arc_wear_def arc_wear_default(void);

/* Default tolerance of implicit runs without a jump. */
#define ARC_USUAL_TOLERANCE 1e-3

/* Sets the default control of step lengths: the implicit scheme with ARC_USUAL_TOLERANCE or, where
 * it is better, the explicit scheme (see the setting scheme). A tolerance that is set stays and
 * makes the scheme implicit. */
void arc_wear_def_usual(arc_wear_def *def, const arc_model_def *model);

/* Sets k = k_c + k_p and alpha = k_c / k (Eqs. 18 and 19 of the reference paper) from the
 * coefficients of the bodies [mm2/N]. */
void arc_wear_def_partition(arc_wear_def *def, const double k[ARC_BODIES]);
/* Sets k and alpha like arc_wear_def_partition, from the wear coefficients of the
 * materials. Returns 0 and changes nothing if no material has a wear coefficient. */
int arc_wear_def_of_bodies(arc_wear_def *def, const arc_model_def *model);

/* Returns the position of the plate [mm] at point i of a loading. */
double arc_loading_x(const arc_loading *loading, const arc_model_def *model, int i);

/* Returns the sliding distance of a cycle [mm] for a definition without a loading: the number of
 * strokes in a cycle times the stroke. If a tangential force drives the plate, it is the sum of the
 * changes of this force in a cycle, divided by (E* thickness). */
double arc_wear_def_sliding(const arc_wear_def *def, const arc_model_def *model);

/* Checks ranges and combinations of settings for a run on `model`. ARC_ARGUMENT: the
 * message has the field, the expected and the actual value. */
arc_status arc_wear_check(const arc_wear_def *def, const arc_model_def *model, arc_error *error);

/* Returns the longest accurate increment [mm] under a load [N]. It is an eighth of the half width
 * of the unworn contact, which is smaller than the half width after wear. */
double arc_wear_reach(const arc_model_def *model, double load);

/* Returns the number of increments in a full cycle without a loading: the number set by the user,
 * or the automatic number. */
int arc_wear_def_increments(const arc_wear_def *def, const arc_model_def *model);
/* Returns the stroke [mm]; on a circular track it is half the circumference. */
double arc_wear_def_stroke(const arc_wear_def *def);
/* Returns the number of strokes in a cycle (r in the reference paper): 2, or 1 if the stroke is as
 * long as the plate is wide. */
double arc_wear_def_strokes(const arc_wear_def *def, const arc_model_def *model);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif
