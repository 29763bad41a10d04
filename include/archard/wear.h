/* archard/wear.h - wear runs: Archard wear of two bodies, computed in steps.
 *
 * The wear coefficients are k_c = alpha k for the cylinder and k_p = (1 - alpha) k for the plate,
 * with the partition factor alpha. One step is one update of the geometry. The contact is solved on
 * the present shape at every increment of a cycle (SP), or once if the plate stays flat (NSP). Then
 * the wear of `jump` cycles is applied at once. A step that fails does not change the run. */
#ifndef ARCHARD_WEAR_H
#define ARCHARD_WEAR_H

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

/* One row of the history: the state after an update (row 0: before the first update). Pressures
 * (except p_peak) and widths refer to the plate at x = 0 under the nominal load. load, load_low and
 * travel refer to the cycle whose wear the update applied or, in a block of loading that runs once,
 * to the increment of the update (row 0: to the first cycle or increment). p_peak is
 *   - the largest pressure in a cycle on the surfaces of this row, and at least p_max if there is
 *     no loading;
 *   - with updates at every increment: the largest pressure in the solved increments of the update;
 *     in row 0 p_max.
 * Columns that are absent in older files are NaN.
 *
 * Each column is X(name, unit, range, rule, text). The range contains its limits and is written as
 * in archard/setting.h, for example FROM(0) for values >= 0. A value outside the range makes the
 * step fail with ARC_NUMERIC; a file with such a value is reported as damaged. The rule is one of
 * these: */
typedef enum arc_column_rule {
  ARC_COLUMN_LATER,  /* the column may be absent in older files, or undefined in the first rows; its
                        values are NaN before the first number, but not after it */
  ARC_COLUMN_ALWAYS, /* the column is in all files */
  ARC_COLUMN_GROWS   /* the column is in all files, and its values never decrease */
} arc_column_rule;
#define ARC_WEAR_COLUMNS(X)                                                                        \
  X(update, "", FROM(0), GROWS, "number of geometry updates so far")                               \
  X(cycle, "", FROM(0), GROWS, "number of loading cycles so far")                                  \
  X(distance, "mm", FROM(0), GROWS, "sliding distance so far")                                     \
  X(jump, "", FROM(0), ALWAYS, "number of cycles in this update")                                  \
  X(load, "N", FROM(0), LATER, "largest normal load in the cycle of this update")                  \
  X(load_low, "N", FROM(0), LATER, "smallest normal load in the cycle of this update")             \
  X(load_reference, "N", FROM(0), LATER, "normal load at which pressures and width are reported")  \
  X(travel, "mm", FROM(0), LATER, "stroke in the cycle of this update")                            \
  X(k, "mm2/N", FROM(0), ALWAYS, "wear coefficient of this update")                                \
  X(alpha, "", FROM(0), ALWAYS, "wear partition factor of this update")                            \
  X(p_center, "MPa", FROM(0), ALWAYS, "pressure at the centre of the contact")                     \
  X(p_max, "MPa", FROM(0), ALWAYS, "largest nodal pressure; mesh-dependent at scar edges")         \
  X(p_peak, "MPa", FROM(0), LATER, "largest nodal pressure in the cycle of this update")           \
  X(half_width, "mm", FROM(0), ALWAYS, "half the contact width")                                   \
  X(half_width_z, "mm", FROM(0), LATER, "half the contact width across the motion, in 3-D")        \
  X(area, "mm2", FROM(0), LATER, "contact area, in 3-D")                                           \
  X(depth_cylinder, "mm", FROM(0), ALWAYS, "largest wear depth of the cylinder")                   \
  X(depth_plate, "mm", FROM(0), ALWAYS, "largest wear depth of the plate")                         \
  X(volume_cylinder, "mm3", FROM(0), ALWAYS, "wear volume of the cylinder")                        \
  X(volume_plate, "mm3", FROM(0), ALWAYS, "wear volume of the plate")                              \
  X(load_distance, "N mm", FROM(0), LATER, "load (holes: normal force) integrated over distance")  \
  X(depth_partition, "", FROM(0), LATER, "depth partition factor alpha-tilde; NaN if unworn")      \
  X(error, "", FROM(0), LATER, "estimated error of the step divided by the tolerance")             \
  X(solutions, "", FROM(0), ALWAYS, "number of contact solutions so far")                          \
  X(box_rows, "", FROM(0), LATER, "number of element rows in the wear box")                        \
  X(elements, "", FROM(0), LATER, "number of elements in both meshes")                             \
  X(energy, "N mm", FROM(0), LATER, "energy dissipated by friction so far")                        \
  X(cycle_energy, "N mm", FROM(0), LATER, "energy dissipated in the cycle of this update")         \
  X(largest_shear, "N", FROM(0), LATER, "largest tangential force in the cycle of this update")    \
  X(stick_width, "mm", FROM(0), LATER, "width that sticks throughout the cycle of this update")    \
  X(gross, "", FROM(0), LATER, "1 if the whole contact slips at some time, else 0")

struct arc_wear_record {
#define ARC_WEAR_MEMBER(name, unit, range, rule, text) double name;
  ARC_WEAR_COLUMNS(ARC_WEAR_MEMBER)
#undef ARC_WEAR_MEMBER
};

/* Indices of the columns in the order of the list, followed by the index of the total volume. */
enum {
#define ARC_WEAR_COLUMN(name, unit, range, rule, text) ARC_WEAR_COLUMN_##name,
  ARC_WEAR_COLUMNS(ARC_WEAR_COLUMN)
#undef ARC_WEAR_COLUMN
      ARC_WEAR_COLUMN_COUNT,
  ARC_WEAR_TOTAL_VOLUME = ARC_WEAR_COLUMN_COUNT
};

/* arc_wear_record_get returns the value of a column, or the total volume. arc_wear_column_name
 * returns the name of a column, such as "p_center". */
double arc_wear_record_get(const arc_wear_record *record, int column);
const char *arc_wear_column_name(int column);

/* A wear run. Opaque; retains its model. */
typedef struct arc_wear arc_wear;

/* Creates a run on a copy of the shape `start` of the same model, or on unworn surfaces if `start`
 * is NULL. Errors: ARC_ARGUMENT (the message has the field, the expected and the actual value);
 * ARC_ZONE (a zone of the model is too narrow for the stroke; the message has the width needed). */
arc_status arc_wear_create(arc_model *model, const arc_wear_def *def, const arc_shape *start,
                           arc_wear **wear, arc_error *error);
arc_status arc_wear_clone(const arc_wear *wear, arc_wear **copy, arc_error *error);
void arc_wear_destroy(arc_wear **wear);

/* Checks rows of a history against the ranges and rules of the columns. ARC_ARGUMENT: the message
 * has the row and the column. */
arc_status arc_wear_check_history(const arc_wear_record *history, size_t count, arc_error *error);

/* Restores a run from its history of `count` >= 1 records and a copy of its shape. The restored run
 * continues with the same results as the original run, to the bit. Errors as for
 * arc_wear_create. */
arc_status arc_wear_restore(arc_model *model, const arc_wear_def *def, const arc_shape *shape,
                            const arc_wear_record *history, size_t count, arc_wear **wear,
                            arc_error *error);

/* Returns the state of a run as *count arrays. arc_wear_resume restores the run from these arrays
 * and its history. *state is one block, which the caller frees with free(). Errors: ARC_MEMORY. */
arc_status arc_wear_state(const arc_wear *wear, arc_array **state, size_t *count, arc_error *error);

/* Checks the arrays of arc_wear_state, and restores the run from them and its history, like
 * arc_wear_restore. Errors: also those of arc_shape_restore. */
arc_status arc_wear_resume(arc_model *model, const arc_wear_def *def, const arc_array *state,
                           size_t arrays, const arc_wear_record *history, size_t count,
                           arc_wear **wear, arc_error *error);

/* Computes the zones [mm] (arc_mesh_def.zone) that a model needs for this run. The zones are wide
 * enough for the whole run. If element sizes follow the contact (mesh.fineness), the zones are only
 * wide enough for a contact of six unworn half widths, because such meshes are rebuilt when the
 * contact reaches their edge. */
void arc_wear_zones(const arc_wear_def *def, const arc_model_def *model, double zone[ARC_BODIES]);

/* Makes one update of the geometry over `jump` cycles, or over fewer cycles at the end of the
 * distance. If the run has reached its end, the function makes no update and returns ARC_OK.
 * Returns ARC_STOPPED if a callback requested a stop. On failure the run is unchanged. The progress
 * callback is not called. The function warns if the mesh is too coarse for the contact (before the
 * first step with a definition) and if an explicit jump exceeds the limit of arc_wear_stability
 * (once). */
arc_status arc_wear_step(arc_wear *wear, const arc_callbacks *callbacks, arc_error *error);

/* Makes steps until the total sliding distance of the run is `distance` [mm]. The last step is
 * shortened so that it ends there exactly. A `distance` that exceeds the distance of the definition
 * replaces it. */
arc_status arc_wear_run(arc_wear *wear, double distance, const arc_callbacks *callbacks,
                        arc_error *error);

/* Target of a run: the run ends when a column reaches this value. The last step is shortened so
 * that it ends there. */
typedef struct arc_wear_target {
  int column; /* an index ARC_WEAR_COLUMN_..., or ARC_WEAR_TOTAL_VOLUME */
  double value;
} arc_wear_target;

/* Makes steps like arc_wear_run, but ends at the first of `count` targets (with a relative
 * tolerance of 1e-9). *reached is the index of this target, or -1. If a column jumps past its
 * target, the run ends at the jump. */
arc_status arc_wear_run_until(arc_wear *wear, double distance, const arc_wear_target *targets,
                              size_t count, const arc_callbacks *callbacks, int *reached,
                              arc_error *error);

/* Changes the definition (load, k, alpha, stroke, jump, loading, ...) between steps; shape and
 * history are kept. A new loading starts with its first block; the array `loading` of
 * arc_wear_definition continues at the present cycle. The run gets new meshes if `mesh` is not
 * NULL, or if the motion does not fit on the present meshes. New meshes are reported to the
 * callbacks. In `mesh`, "auto" sizes are set for an unworn contact, "auto" zones are set to the
 * needed widths, and rows = 0 keeps the depth of the wear box. Returns ARC_STOPPED if a callback
 * requested a stop. On failure the run is unchanged. */
arc_status arc_wear_set(arc_wear *wear, const arc_wear_def *def, const arc_mesh_def *mesh,
                        const arc_callbacks *callbacks, arc_error *error);

const arc_wear_def *arc_wear_definition(const arc_wear *wear);
arc_procedure
arc_wear_procedure(const arc_wear *wear); /* procedure that the run uses, never ARC_AUTO */
/* Returns the wear coefficient [mm2/N] of the layer that was exposed at the deepest worn point of a
 * body in the last update. */
double arc_wear_open_k(const arc_wear *wear, arc_body body);
double arc_wear_strokes(const arc_wear *wear); /* number of strokes in a cycle: 2 or 1 */
double
arc_wear_cycles(const arc_wear *wear); /* number of cycles in the whole distance of the run */
double arc_wear_travel(const arc_wear *wear); /* stroke [mm] of the present block */
const arc_shape *arc_wear_shape(const arc_wear *wear);
arc_model *arc_wear_model(const arc_wear *wear);
const arc_wear_record *arc_wear_history(const arc_wear *wear, size_t *count);
const arc_wear_record *arc_wear_last(const arc_wear *wear);
size_t arc_wear_bytes(const arc_wear *wear);

/* Solves the contact on the present shape in the reference configuration (plate at x = 0, nominal
 * load), and returns the contact as a new object. */
arc_status arc_wear_contact(const arc_wear *wear, arc_contact **contact, arc_error *error);

/* Names of the arrays that describe a surface after an update, as a list that ends with NULL. The
 * arrays have the size [nodes, 1]: the unworn position x [mm], the wear depth h [mm], the present
 * height y [mm], and the pressure p [MPa] with the plate at x = 0 under the nominal load. */
extern const char *const arc_surface_names[];

/* Returns the *count arrays of the present surfaces, first of the cylinder, then of the plate, in
 * the order of arc_surface_names. *surfaces is one block, which the caller frees with free().
 * Errors: those of arc_wear_contact. */
arc_status arc_wear_surfaces(const arc_wear *wear, arc_array **surfaces, size_t *count,
                             arc_error *error);

/* Checks that arrays are valid surfaces of a run. The arrays of each body and update must be in
 * sequence, with all names of arc_surface_names, equal numbers of finite values, increasing x and
 * pressures >= 0. ARC_ARGUMENT: the message has the first violation. */
arc_status arc_wear_check_surfaces(const arc_array *surfaces, size_t count, arc_error *error);

/* A fretting loop: tangential force over position in a periodic cycle, computed on the surfaces
 * before an update. */
typedef struct arc_loop {
  size_t count;
  double energy;            /* [N mm] energy dissipated in both strokes */
  double stick_width;       /* [mm] width that never slips */
  int gross;                /* 1 if the whole contact slips at some time, else 0 */
  const double *x;          /* [count] position of the plate's base [mm] */
  const double *tangential; /* [count] force on the plate [N] */
} arc_loop;

/* Computes the fretting loop on the present surfaces. *loop is one block, which the caller frees
 * with free(). Errors: ARC_ARGUMENT (the run has no friction), those of a step, and ARC_STOPPED if
 * a callback requested a stop. */
arc_status arc_wear_loop(arc_wear *wear, const arc_callbacks *callbacks, arc_loop **loop,
                         arc_error *error);

/* Computes the growth rate of ripples [1/cycle] at the present state by power iteration. It is the
 * largest eigenvalue of the derivative of one cycle's wear with respect to the depths. Explicit
 * updates are stable while jump * eigenvalue < 2. Returns ARC_STOPPED if a callback (NULL: none)
 * requested a stop. */
arc_status arc_wear_stability(arc_wear *wear, const arc_callbacks *callbacks, double *eigenvalue,
                              arc_error *error);

/* Returns the roughness of a profile [-]: its sawtooth part (arc_measure_sawtooth) over the middle
 * of the contact divided by the largest depth. On the default mesh the roughness of smooth profiles
 * is below 1e-4. */
double arc_wear_roughness(const arc_wear *wear, arc_body body);

/* Checks a run, for tests and for builds with ARC_CHECKS. All numbers must be finite, distances
 * must not decrease along the history, the wear volume must be k times load times distance by
 * Archard's law, the Jacobians of the elements must be positive, and the contact in the reference
 * configuration must be valid. Errors: ARC_NUMERIC (the message has the failed check and the
 * amount), ARC_MEMORY. */
arc_status arc_wear_validate(const arc_wear *wear, arc_error *error);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif
