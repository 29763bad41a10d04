/* archard/wear.h - Archard wear with a partition factor, step by step.
 *
 * k_c = alpha k, k_p = (1 - alpha) k. One step is one geometry update: the contact is solved at
 * every increment of a cycle on the present shape (SP), or once where the plate stays flat (NSP),
 * and `jump` cycles of that wear are applied together. A step either completes or leaves everything
 * as it was.
 */
#ifndef ARCHARD_WEAR_H
#define ARCHARD_WEAR_H

#include "archard/contact.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* Fig. 7: SP simulates the sliding plate; NSP does not (alpha = 1, or a stroke over the whole
 * plate). */
#define ARC_PROCEDURE_LIST(X)                                                                      \
  X(AUTO, "auto")                                                                                  \
  X(SP, "SP")                                                                                      \
  X(NSP, "NSP")
#define ARC_SCHEME_LIST(X)                                                                         \
  X(EXPLICIT, "explicit")                                                                          \
  X(IMPLICIT, "implicit")
/* Sliding distance of an increment: rigid plate motion, or with the elastic part (Abaqus' CSLIP).
 */
#define ARC_SLIP_LIST(X)                                                                           \
  X(SLIP_RIGID, "rigid")                                                                           \
  X(SLIP_TOTAL, "total")
/* The way of the plate: in the plane, or out of it, where points stay in contact with their
 * partners.
 */
#define ARC_SLIDE_LIST(X)                                                                          \
  X(SLIDE_X, "x")                                                                                  \
  X(SLIDE_Z, "z")
/* Integration over increments: Eq. (4) or Eq. (5). */
#define ARC_RULE_LIST(X)                                                                           \
  X(TRAPEZOID, "trapezoid")                                                                        \
  X(SIMPLE, "simple")
/* When the geometry is updated: after `jump` cycles together, or at every increment
 * (quasi-continuous). */
#define ARC_UPDATE_LIST(X)                                                                         \
  X(UPDATE_CYCLE, "cycle")                                                                         \
  X(UPDATE_INCREMENT, "increment")
/* Wear laws: X(name, "name", properties, text for users, factor, growth). A law is a factor on k at
 * a node under the pressure p [MPa]; growth is d ln(p factor) / d ln p, which implicit steps need;
 * d is the arc_wear_def. The program knows a law by its row alone. */
#define ARC_LAW_LIST(X)                                                                            \
  X(LAW_ARCHARD, "archard", ARC_LAW_LINEAR, "1", 1, 1)                                             \
  X(LAW_POWER, "power", 0, "(p / law_pressure)^law_exponent",                                      \
    p > 0 ? pow(p / d->law_pressure, d->law_exponent) : 0, 1 + d->law_exponent)                    \
  X(LAW_THRESHOLD, "threshold", ARC_LAW_JUMPS, "1 where p > law_pressure, 0 elsewhere",            \
    p > d->law_pressure, 1)                                                                        \
  X(LAW_ENERGY, "energy", ARC_LAW_OF_SHEAR, "q / p, so that k takes the energy q ds", 1, 1)

#define ARC_LAW_TEXT(name, word, properties, text, ...) " \"" word "\": " text "."

/* Properties of laws. */
enum {
  ARC_LAW_LINEAR = 1,  /* Archard's: the wear is k p ds, at every pressure */
  ARC_LAW_JUMPS = 2,   /* the factor is not a continuous function of p */
  ARC_LAW_OF_SHEAR = 4 /* the factor stands on the shear q in place of p; needs friction */
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
extern const unsigned arc_law_properties[]; /* by arc_law */

typedef struct arc_wear_record arc_wear_record;

/* A quantity that depends on the state of the run: `what` is its setting. Anything but ARC_OK
 * refuses the step. */
typedef arc_status (*arc_state_fn)(void *context, const arc_setting *what,
                                   const arc_wear_record *state, double *value);

/* A factor on k at each of the n nodes of one body: x [mm] own (unworn) position, z [mm] across the
 * motion (3-D; NULL in the plane), p [MPa] at one increment, to factor [n]. Anything but ARC_OK
 * refuses the step. */
typedef arc_status (*arc_local_fn)(void *context, arc_body body, int n, const double *x,
                                   const double *z, const double *p, const arc_wear_record *state,
                                   double *factor);

/* One block of loading: plate position and load at count >= 2 points of a cycle; both strokes are
 * simulated as they are. A load of 0 is a lift-off: no contact and no wear there. */
typedef struct arc_loading {
  int count;
  const double *x;          /* [count] [mm] */
  const double *load;       /* [count] [N], >= 0 */
  const double *tangential; /* [count] [N] drives the plate instead of x, which is 0 then; NULL: x
                               does */
  const double *rotation;   /* [count] [degrees] turns the lower body instead of x, which is 0 then:
                               in holes; NULL: x does */
  const double *load_angle; /* [count] [degrees] direction of the load in holes; NULL: the
                               definition's */
  double cycles; /* how often, > 0 (INFINITY: to the end of the distance, last block only) */
  int periodic; /* 0: a generic history (Eq. 4): run once, updated at every increment, one increment
                   a step */
} arc_loading;

#define ARC_WEAR_SETTINGS(NUMBER, WHOLE, CHOICE, QUANTITY, FUNCTION, OTHER)                        \
  CHOICE(scheme, scheme, ARC_EXPLICIT, 0,                                                          \
         "Pressures of an update: those of the geometry it begins with, or those of the geometry " \
         "it ends in, which takes longer steps.")                                                  \
  QUANTITY(                                                                                        \
      k, "mm2/N", 1e-8, FROM(0), ARC_FUNCTION | ARC_SERIES,                                        \
      "Wear coefficient k of the couple: volume = k L_N d (Eq. 1). A function is asked "           \
      "along each "                                                                                \
      "update, see help \"state\"; a table is interpolated over the distance, and two values at "  \
      "one "                                                                                       \
      "distance are a jump. Both are integrated, and an update ends where they jump. Functions "   \
      "are asked 1.6 times a cycle or 3236 times a run, whichever is less: what is shorter may "   \
      "be missed.")                                                                                \
  QUANTITY(alpha, "", 0.5, WITHIN(0, 1), ARC_FUNCTION | ARC_SERIES,                                \
           "Wear partition factor k_c / k (Eq. 19): the share of the volume that the cylinder "    \
           "loses. 0: only the plate wears, 1: only the cylinder.")                                \
  OTHER(k_cylinder, "a number >= 0 mm2/N", NULL, 0,                                                \
        "Wear coefficient of the cylinder alone, k_c = alpha k. Give this and k_plate, or k and "  \
        "alpha; or each body its own, as model = { cylinder = { k = ... }, plate = { k = ... } "   \
        "}.")                                                                                      \
  OTHER(k_plate, "a number >= 0 mm2/N", NULL, 0,                                                   \
        "Wear coefficient of the plate alone, k_p = (1 - alpha) k.")                               \
  NUMBER(load, "N", 100, ABOVE(0), 0,                                                              \
         "Normal load L_N; with loading, that of the reference configuration.")                    \
  NUMBER(load_angle, "degrees", 0, BETWEEN(-90, 90), 0,                                            \
         "Direction of the load in a hole, along the surface from where the bodies first touch; "  \
         "positive towards +x. With loading, that of the reference configuration.")                \
  NUMBER(stroke, "mm", 0.11, ABOVE(0), 0,                                                          \
         "Stroke s_t, the plate's way from one end to the other. The reference cases are a, 2a, "  \
         "4a (0.11, 0.22, 0.44) and 2R (20): the last slides over the whole plate, one way only "  \
         "(r = 1 instead of 2).")                                                                  \
  NUMBER(distance, "mm", 1320, ABOVE(0), ARC_OPTIONAL,                                             \
         "Travelled distance d_t to simulate. Give this or cycles; with loading, none means all "  \
         "its blocks.")                                                                            \
  OTHER(cycles, "a number > 0 cycles", NULL, 0,                                                    \
        "Loading cycles to simulate, N = d_t / (r s_t) (Eq. 21). Give this or distance.")          \
  QUANTITY(                                                                                        \
      jump, "cycles", 0, ABOVE(0), ARC_AUTOMATIC | ARC_FUNCTION,                                   \
      "Cycles from one geometry update to the next (N-bar). \"auto\" follows an estimate of the "  \
      "error, by updates of second order in several stages. With a number pressures are kept "     \
      "between two updates, as in the paper; too large a one makes the surfaces rough. A "         \
      "function gets the state before the update.")                                                \
  WHOLE(increments, "", 0, EVEN(2, 100000), ARC_AUTOMATIC,                                         \
        "Increments n_c of a full cycle. Half of them are simulated, the way back being like the " \
        "way out (Eq. 22). \"auto\": 100, or more where the plate would move by more than an "     \
        "eighth "                                                                                  \
        "of the contact's half width in one; the points of a loading are then joined by more of "  \
        "them.")                                                                                   \
  NUMBER(                                                                                          \
      refresh, "", 0.05, FROM(0), 0,                                                               \
      "With moving geometry: the stiffness is computed anew once a node has moved by more than "   \
      "this share of an element's present height, by a fifth of it of what is left of its layer, " \
      "or along the surface by a hundredth of it in elements' widths, and, without layers, "       \
      "followed to first order in between; 0: anew at every update.")                              \
  CHOICE(procedure, procedure, ARC_AUTO, 0,                                                        \
         "SP simulates the sliding plate (Eq. 22); NSP solves one contact an update, right where " \
         "the plate stays flat: alpha = 1, or a stroke of 2 radius (Eqs. 24-27). \"auto\" "        \
         "chooses.")                                                                               \
  CHOICE(                                                                                          \
      slip, slip, ARC_SLIP_RIGID, 0,                                                               \
      "Sliding distance of an increment: the motion of the plate, or with the elastic part "       \
      "added, found at pairs of points that touch. With the rigid one the volume is k L_N d to "   \
      "rounding; with both, volumes are as k_c to k_p.")                                           \
  QUANTITY(friction, "", 0, FROM(0), ARC_FUNCTION | ARC_SERIES,                                    \
           "Coefficient of friction of the couple; 0: none. With it slip is the real one, that "   \
           "of each point: increments of the cycle are solved with stick and slip, on both "       \
           "strokes, from bodies pressed anew, until the cycle is steady; that one counts. "       \
           "k p ds and the energy are those of that slip. Updates in stages and "                  \
           "implicit ones follow a coefficient that changes, and their errors tell of it; one of " \
           "a given jump takes its mean. A jump in it ends an update, as one in k does. For "      \
           "updates of whole cycles.")                                                             \
  CHOICE(press, press, ARC_PRESS_FRICTION, 0,                                                      \
         "Whether friction acts while the bodies are pressed together, as in contact{}, or only "  \
         "from then on. It matters where a part never slips and materials differ; between like "   \
         "bodies that Hertz' formulas hold for pressing shears nothing, and friction is left "     \
         "out.")                                                                                   \
  NUMBER(tangential, "N", 0, ABOVE(0), ARC_OPTIONAL,                                               \
         "Amplitude of a tangential force that moves the plate to and fro, instead of stroke; "    \
         "needs friction, and less than friction times load. Of distance it counts as "            \
         "force / (E* thickness), as slip is not known beforehand: give cycles.")                  \
  CHOICE(                                                                                          \
      slide, slide, ARC_SLIDE_X, 0,                                                                \
      "The way of the plate: along x, or out of the plane along z. Then the contact stays at x "   \
      "= 0, stroke is the way along z, and alpha-tilde is alpha. Bodies of revolution need "       \
      "\"z\": "                                                                                    \
      "the same way for all points, as of a pin on a disc, unless they spin.")                     \
  NUMBER(spin, "mm", 0, ABOVE(0), ARC_OPTIONAL,                                                    \
         "Of bodies that spin about their axis of revolution: the radius at which stroke and "     \
         "distance are told; elsewhere slip goes with the radius. 1: distances are angles in "     \
         "radians.")                                                                               \
  NUMBER(track, "mm", 0, ABOVE(0), ARC_OPTIONAL,                                                   \
         "Of a pin on a disc: mean radius of its track, beyond the contact's. A cycle is a "       \
         "revolution then, in place of "                                                           \
         "stroke. The disc stays flat; its depth is told as the mean over the track, as wide as "  \
         "the contact is by then. In 3-D it wears to a track the same all round.")                 \
  CHOICE(rule, rule, ARC_TRAPEZOID, 0, "Integration over the increments: Eq. (4) or Eq. (5).")     \
  CHOICE(geometry, geometry, ARC_MOVING, ARC_FIXED,                                                \
         "Whether the worn nodes change the stiffness of the surface layer, or the gap alone.")    \
  CHOICE(update, update, ARC_UPDATE_CYCLE, 0,                                                      \
         "When the geometry is updated: after jump cycles together, or at every increment "        \
         "(quasi-continuous).")                                                                    \
  CHOICE(law, law, ARC_LAW_ARCHARD, 0,                                                             \
         "Wear law: a factor on k that depends on the pressure p or, with friction, on the "       \
         "shear q." ARC_LAW_LIST(ARC_LAW_TEXT))                                                    \
  NUMBER(law_pressure, "MPa", 100, ABOVE(0), 0, "Pressure in the law.")                            \
  NUMBER(law_exponent, "", 1, ABOVE_TO(-1, 10), 0, "Exponent of the power law.")                   \
  WHOLE(order, "", 2, WITHIN(1, 2), 0,                                                             \
        "Order of the implicit scheme: pressures of the end of the update, or of its start, a "    \
        "stage on the way and its end (TR-BDF2).")                                                 \
  WHOLE(workers, "", 1, WITHIN(1, 64), ARC_FIXED,                                                  \
        "Threads that share the positions of a stroke in 3-D; results are the same to the bit.")   \
  NUMBER(                                                                                          \
      tolerance, "", 0, BETWEEN(0, 1), ARC_OPTIONAL,                                               \
      "Bound on the error of an implicit run's depths, over the deepest, at every node of more "   \
      "than a twentieth of that; pressures keep to 10 times as much in the mean, single nodes "    \
      "at the edge of the contact do not. The run then chooses its own steps. Of implicit runs "   \
      "with neither tolerance nor jump: 1e-3. None: steps of jump.")                               \
  OTHER(model, "a model object or a table of its fields", "model", ARC_FIXED,                      \
        "The bodies. Without it one is built on first use whose contact zones suit the stroke.")   \
  OTHER(worn, "a wear object or a table { cylinder=, plate= }", "wear", ARC_FIXED,                 \
        "Shape of the surfaces to start from: that of a wear run; or for each body a function "    \
        "f(x) that gives the depth, or a measured profile { x={...}, h={...} }, in mm; in 3-D a "  \
        "function f(x, z) or a map of depths, which is 0 outside the scar. Depths "                \
        "and alpha-tilde count from the unworn shape, volumes from this one.")                     \
  OTHER(loading, "a block { x=, load= } or a list of them", NULL, 0,                               \
        "A cycle of your own instead of stroke and load: x and load as functions of t, which "     \
        "goes from 0 to 1 over the cycle, or as sampled lists. Both strokes are simulated as "     \
        "they are. Functions are called once, when the run is made. Several blocks in a list "     \
        "follow each other, each with its cycles. Without a distance the run ends with the last "  \
        "block; where that has no cycles, it goes on to the end of the distance. The pressures "   \
        "and widths that a run tells are those under load, which by default is the largest of "    \
        "the loading. \n\nIn a hole rotation (degrees, as x) turns the lower body instead of x, "  \
        "and "                                                                                     \
        "load_angle (degrees; a number, or as load) is the load's direction. Meshes reach 80 "     \
        "degrees to either side: a narrow contact may turn by about 70, a wide one by less, and "  \
        "none all round. \n\ncsv.read(path) reads measured lists.")                                \
  FUNCTION(                                                                                        \
      local_factor, "a function(body, x, p, state, z) or { vector = function }", arc_local_fn, 0,  \
      "Factor on k at each node, for cross-shear and the like. body is \"cylinder\" or "           \
      "\"plate\", x the node's own position in mm, p its pressure in MPa, z its position across "  \
      "the motion in mm, with geometry = \"3-D\" only; the result is 0 or above. Nodes without "   \
      "pressure are left out: they do not wear. It is called at every increment.")

typedef struct arc_wear_def {
  ARC_WEAR_SETTINGS(ARC_MEMBER_NUMBER, ARC_MEMBER_WHOLE, ARC_MEMBER_CHOICE, ARC_MEMBER_QUANTITY,
                    ARC_MEMBER_FUNCTION, ARC_MEMBER_OTHER)
  void *context;                      /* handed to every function above */
  int blocks;                         /* 0: reciprocating by `stroke` under `load` */
  const arc_loading *loading;         /* [blocks], in this order; copied by the run */
  double start_distance, start_cycle; /* where the loading begins; set by arc_wear_set */
} arc_wear_def;

extern const arc_setting arc_wear_settings[];

/* Where each stands in the list: ARC_AT_k, ARC_AT_alpha, ... */
enum {
  ARC_WEAR_SETTINGS(ARC_POSITION, ARC_POSITION, ARC_POSITION, ARC_POSITION, ARC_POSITION,
                    ARC_POSITION) ARC_WEAR_SETTINGS_COUNT
};

arc_wear_def arc_wear_default(void);

/* Tolerance of implicit runs where neither it nor a jump is given. */
#define ARC_USUAL_TOLERANCE 1e-3

/* Sets how steps are made, where nothing is given: in 3-D the implicit scheme, in the plane
 * jump = "auto". */
void arc_wear_def_usual(arc_wear_def *def, const arc_model_def *model);

/* Sets k = k_c + k_p and alpha = k_c / k (Eqs. 18 and 19) from the coefficients of the bodies
 * [mm2/N]. */
void arc_wear_def_partition(arc_wear_def *def, const double k[ARC_BODIES]);
/* The same from the materials, where one of them has a wear coefficient; else returns 0. */
int arc_wear_def_of_bodies(arc_wear_def *def, const arc_model_def *model);

/* Position of the plate [mm] at point i of a loading. */
double arc_loading_x(const arc_loading *loading, const arc_model_def *model, int i);

/* Distance of a cycle of the plain stroke [mm]: r s of Eq. (21); under a tangential force the sum
 * of its changes over E* and the thickness. */
double arc_wear_def_sliding(const arc_wear_def *def, const arc_model_def *model);

/* Checks a definition against the model it is to run on: ranges, and what goes together.
 * ARC_ARGUMENT names field, expectation and value. */
arc_status arc_wear_check(const arc_wear_def *def, const arc_model_def *model, arc_error *error);

/* The longest increment [mm] that follows the contact under `load` [N] well: an eighth of the half
 * width when unworn, the narrowest of a run. */
double arc_wear_reach(const arc_model_def *model, double load);

/* Increments of a full cycle of the plain stroke: as set, or as chosen. */
int arc_wear_def_increments(const arc_wear_def *def, const arc_model_def *model);

/* The stroke [mm]: as set, or half a revolution of a track. */
double arc_wear_def_stroke(const arc_wear_def *def);

/* Strokes of a cycle, r of Eq. (21): 2, or 1 where the stroke is the whole plate's width. */
double arc_wear_def_strokes(const arc_wear_def *def, const arc_model_def *model);

/* One row of history: the state after an update (row 0: before the first), in the reference
 * configuration (plate at x = 0, nominal load). Only p_peak looks further: over the whole cycle of
 * the update, on the row's own surfaces and under the loads of the cycle (an update at every
 * increment, or a generic history: at what was solved on the way; row 0: p_max). Without a loading
 * it is never less than p_max; and load, load_low and travel tell what went by in the update: of a
 * cycle, or of the increment of a generic history (row 0: of the first to come). NaN where a file
 * is older than they are. X(name, unit, range, rule, text): what a run records outside of the range
 * is ARC_NUMERIC, and refuses the step; what a file has outside of it, is damage. The range as in
 * archard/setting.h, closed; the rule: */
typedef enum arc_column_rule {
  ARC_COLUMN_LATER,  /* rows of older files have none: NaN until the first number, then never again.
                        What may be none at first is this, too. */
  ARC_COLUMN_ALWAYS, /* all files have it */
  ARC_COLUMN_GROWS   /* all files have it, and it never falls */
} arc_column_rule;
#define ARC_WEAR_COLUMNS(X)                                                                        \
  X(update, "", FROM(0), GROWS, "geometry updates so far")                                         \
  X(cycle, "", FROM(0), GROWS, "loading cycles so far")                                            \
  X(distance, "mm", FROM(0), GROWS, "travelled distance d")                                        \
  X(jump, "", FROM(0), ALWAYS, "cycles of this update")                                            \
  X(load, "N", FROM(0), LATER, "largest normal load of the update's cycle")                        \
  X(load_low, "N", FROM(0), LATER, "smallest normal load of it")                                   \
  X(load_reference, "N", FROM(0), LATER, "normal load of the row's pressures and width")           \
  X(travel, "mm", FROM(0), LATER, "way of the plate in it, from one end to the other")             \
  X(k, "mm2/N", FROM(0), ALWAYS, "wear coefficient of this update")                                \
  X(alpha, "", FROM(0), ALWAYS, "wear partition factor of this update")                            \
  X(p_center, "MPa", FROM(0), ALWAYS, "pressure at the centre")                                    \
  X(p_max, "MPa", FROM(0), ALWAYS, "largest nodal pressure; unsettled at scar edges")              \
  X(p_peak, "MPa", FROM(0), LATER, "largest nodal pressure of the update's cycle")                 \
  X(half_width, "mm", FROM(0), ALWAYS, "half the contact width")                                   \
  X(half_width_z, "mm", FROM(0), LATER, "half the contact width across the motion; 3-D")           \
  X(area, "mm2", FROM(0), LATER, "contact area; 3-D")                                              \
  X(depth_cylinder, "mm", FROM(0), ALWAYS, "largest wear depth of the cylinder")                   \
  X(depth_plate, "mm", FROM(0), ALWAYS, "largest wear depth of the plate")                         \
  X(volume_cylinder, "mm3", FROM(0), ALWAYS, "wear volume of the cylinder")                        \
  X(volume_plate, "mm3", FROM(0), ALWAYS, "wear volume of the plate")                              \
  X(load_distance, "N mm", FROM(0), LATER, "load, in holes normal force, over local sliding")      \
  X(depth_partition, "", FROM(0), LATER,                                                           \
    "depth partition factor alpha-tilde; NaN before any wear")                                     \
  X(error, "", FROM(0), LATER, "estimated error of an adaptive step, over its tolerance")          \
  X(solutions, "", FROM(0), ALWAYS, "contact solutions so far")                                    \
  X(box_rows, "", FROM(0), LATER, "rows of elements that may wear, more where outgrown")           \
  X(elements, "", FROM(0), LATER, "elements of both meshes, new where outgrown")                   \
  X(energy, "N mm", FROM(0), LATER, "dissipated by friction so far")                               \
  X(cycle_energy, "N mm", FROM(0), LATER, "dissipated in a cycle of the update")                   \
  X(largest_shear, "N", FROM(0), LATER, "largest tangential force of the update's cycle")          \
  X(stick_width, "mm", FROM(0), LATER, "width that sticks throughout that cycle")                  \
  X(gross, "", FROM(0), LATER, "1: the whole contact slips at some time in it, else 0")

struct arc_wear_record {
#define ARC_WEAR_MEMBER(name, unit, range, rule, text) double name;
  ARC_WEAR_COLUMNS(ARC_WEAR_MEMBER)
#undef ARC_WEAR_MEMBER
};

/* The columns by number, in this order, and one more: the sum of both volumes. */
enum {
#define ARC_WEAR_COLUMN(name, unit, range, rule, text) ARC_WEAR_COLUMN_##name,
  ARC_WEAR_COLUMNS(ARC_WEAR_COLUMN)
#undef ARC_WEAR_COLUMN
      ARC_WEAR_COLUMN_COUNT,
  ARC_WEAR_TOTAL_VOLUME = ARC_WEAR_COLUMN_COUNT
};

/* The value in a column, or the total volume. */
double arc_wear_record_get(const arc_wear_record *record, int column);
/* The name of a column, "p_center". */
const char *arc_wear_column_name(int column);

/* A running simulation. Opaque; keeps its model alive. */
typedef struct arc_wear arc_wear;

/* A new run from unworn surfaces, or from `start` (copied; same model) if not NULL. Errors:
 * ARC_ARGUMENT with field, expectation and value; ARC_ZONE (a zone of the model too narrow for the
 * stroke, names what it needs). */
arc_status arc_wear_create(arc_model *model, const arc_wear_def *def, const arc_shape *start,
                           arc_wear **wear, arc_error *error);
arc_status arc_wear_clone(const arc_wear *wear, arc_wear **copy, arc_error *error);
void arc_wear_destroy(arc_wear **wear);

/* Whether rows can be a run's history, by the ranges and rules of the columns. ARC_ARGUMENT names
 * row and column. */
arc_status arc_wear_check_history(const arc_wear_record *history, size_t count, arc_error *error);

/* A run as it stood after the last of `count` >= 1 records on `shape` (copied): goes on to the same
 * bits as one that was never stored. Errors as in arc_wear_create. */
arc_status arc_wear_restore(arc_model *model, const arc_wear_def *def, const arc_shape *shape,
                            const arc_wear_record *history, size_t count, arc_wear **wear,
                            arc_error *error);

/* The arrays that a run goes on from, with its history; *state [*count] is one block, to be freed
 * with free(). ARC_MEMORY. */
arc_status arc_wear_state(const arc_wear *wear, arc_array **state, size_t *count, arc_error *error);

/* arc_wear_restore from such arrays, which may be anybody's numbers. Errors also of
 * arc_shape_restore. */
arc_status arc_wear_resume(arc_model *model, const arc_wear_def *def, const arc_array *state,
                           size_t arrays, const arc_wear_record *history, size_t count,
                           arc_wear **wear, arc_error *error);

/* The zones a model needs for this run, to build one that suits (see arc_mesh_def.zone): for all of
 * its way, or, where the elements go with the contact (mesh.fineness), for a scar of up to six
 * unworn half widths: such meshes grow. */
void arc_wear_zones(const arc_wear_def *def, const arc_model_def *model, double zone[ARC_BODIES]);

/* One geometry update: `jump` cycles, or fewer where the definition's distance ends before. At
 * the end of the distance: ARC_OK and nothing happens. Anything but ARC_OK leaves the run as it
 * was; ARC_STOPPED where the callbacks asked for it. They do not hear of progress.
 * Before the first step of a definition they are warned of a mesh too coarse for the contact, and
 * before or after the first one that goes past it, of an explicit jump past the limit of
 * arc_wear_stability. */
arc_status arc_wear_step(arc_wear *wear, const arc_callbacks *callbacks, arc_error *error);

/* Steps until `distance` [mm] (in total, met exactly by a shorter last step; may exceed the
 * definition's, and then becomes it). */
arc_status arc_wear_run(arc_wear *wear, double distance, const arc_callbacks *callbacks,
                        arc_error *error);

/* A quantity of the record that ends a run where it is reached, exactly, by a shorter last step. */
typedef struct arc_wear_target {
  int column; /* ARC_WEAR_COLUMN_..., or ARC_WEAR_TOTAL_VOLUME */
  double value;
} arc_wear_target;

/* As arc_wear_run, and ends earlier where one of `count` targets is reached (to 1e-9 relative);
 * *reached is its index, or -1. A target that cannot be met within a step is passed. */
arc_status arc_wear_run_until(arc_wear *wear, double distance, const arc_wear_target *targets,
                              size_t count, const arc_callbacks *callbacks, int *reached,
                              arc_error *error);

/* Changes the definition between steps (load, k, alpha, stroke, jump, loading, ...); the worn shape
 * and the history stay. The loading begins here, unless it is arc_wear_definition's own array: then
 * it goes on. The run goes over to new meshes, which the callbacks are told of, where `mesh` is not
 * NULL (what is "auto" of it is that of an unworn contact, its zones those that are needed; rows 0:
 * as deep a wear box as before), and where its way has no room on those it has. On failure
 * everything stays; ARC_STOPPED where the callbacks asked for it. */
arc_status arc_wear_set(arc_wear *wear, const arc_wear_def *def, const arc_mesh_def *mesh,
                        const arc_callbacks *callbacks, arc_error *error);

const arc_wear_def *arc_wear_definition(const arc_wear *wear);
arc_procedure arc_wear_procedure(const arc_wear *wear); /* never ARC_AUTO */
/* Wear coefficient [mm2/N] of what lies open of a body where it is worn deepest: that of the last
 * update, of the layer there where the body has layers. */
double arc_wear_open_k(const arc_wear *wear, arc_body body);
double arc_wear_strokes(const arc_wear *wear); /* r of Eq. (21): 2 or 1 */
double arc_wear_cycles(const arc_wear *wear);  /* N of Eq. (21), for the whole distance */
double arc_wear_travel(const arc_wear *wear);  /* from one end of the present block's way to the
                                                 other [mm]: the stroke, or that of the loading */
const arc_shape *arc_wear_shape(const arc_wear *wear);
arc_model *arc_wear_model(const arc_wear *wear);
const arc_wear_record *arc_wear_history(const arc_wear *wear, size_t *count);
const arc_wear_record *arc_wear_last(const arc_wear *wear);
size_t arc_wear_bytes(const arc_wear *wear);

/* The contact in the reference configuration on the present shape; a new object each call. */
arc_status arc_wear_contact(const arc_wear *wear, arc_contact **contact, arc_error *error);

/* The names of the arrays that show a surface after an update, [nodes, 1] each: the unworn position
 * x [mm], the wear depth h [mm], the present height y [mm], and the pressure p [MPa] in the
 * reference configuration. The last is NULL. */
extern const char *const arc_surface_names[];

/* The present surfaces, cylinder before plate, in the order of the names; *surfaces [*count] is one
 * block, to be freed with free(). Errors: those of arc_wear_contact. */
arc_status arc_wear_surfaces(const arc_wear *wear, arc_array **surfaces, size_t *count,
                             arc_error *error);

/* Whether arrays can be surfaces of a run: those of one body and update stand together, all names
 * and no others, with as many finite numbers, x in order, no pressure below zero. ARC_ARGUMENT says
 * what is not so. */
arc_status arc_wear_check_surfaces(const arc_array *surfaces, size_t count, arc_error *error);

/* The fretting loop of the steady cycle that an update begins with. */
typedef struct arc_loop {
  size_t count;
  double energy;            /* [N mm] dissipated in it; over the whole plate, where a cycle is a
                               pass, twice that of a cycle */
  double stick_width;       /* [mm] what never slips */
  int gross;                /* all of the contact slips at some time */
  const double *x;          /* [count] position of the plate's base [mm] */
  const double *tangential; /* [count] force that drives it [N] */
} arc_loop;

/* The loop on the present surfaces; *loop is one block, to be freed with free(). ARC_ARGUMENT: the
 * run has no friction; also what a step may fail of, ARC_STOPPED where the callbacks (NULL: none)
 * asked for it. */
arc_status arc_wear_loop(arc_wear *wear, const arc_callbacks *callbacks, arc_loop **loop,
                         arc_error *error);

/* Growth rate of ripples: largest eigenvalue of the wear of one cycle per unit of depth, linearised
 * about the present state [1/cycle], by power iteration. Explicit updates are stable while jump *
 * eigenvalue < 2. ARC_STOPPED where the callbacks (NULL: none) asked for it. */
arc_status arc_wear_stability(arc_wear *wear, const arc_callbacks *callbacks, double *eigenvalue,
                              arc_error *error);

/* Roughness of a profile [-]: its sawtooth part (arc_measure_sawtooth) over the middle of the
 * contact, as a share of the largest depth; smooth profiles stay under 1e-4 at the default mesh. */
double arc_wear_roughness(const arc_wear *wear, arc_body body);

/* Whether the run is sound, for tests and builds with checks: numbers finite, history growing,
 * volume k L d where Archard's law promises it, worn meshes with positive Jacobians, a valid
 * contact in the reference configuration. ARC_NUMERIC says what failed and by how much; also
 * ARC_MEMORY. */
arc_status arc_wear_validate(const arc_wear *wear, arc_error *error);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif
