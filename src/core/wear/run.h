/* Inside of arc_wear: what one run holds, and what is asked of it. */
#ifndef WEAR_RUN_H
#define WEAR_RUN_H

#include "core/wear/path.h"

/* Wear of one cycle per unit of wear coefficient: sum of p ds over the strokes [MPa mm]. */
typedef struct wear_rate {
  double *node[ARC_BODIES]; /* [surface of the body]; one block, cylinder first */
  double even;              /* the plate's, where it wears evenly (Eq. 27): a track 1 mm wide */
  double peak;              /* largest nodal pressure on the way [MPa] */
  double energy;            /* dissipated per thickness [N] */
  double shear, stick;      /* largest tangential force [N/mm], width that never slips [mm] */
  double gross;             /* 1: all of the contact slips at some time */
  double pressed;           /* normal force over the sliding of a cycle [N] */
} wear_rate;

/* What an update takes off. */
typedef struct wear_depths {
  double *node[ARC_BODIES]; /* [surface of the body] [mm]; one block, cylinder first */
  double even;              /* off the whole plate, or a track 1 mm wide [mm] */
  double error;             /* estimated by an implicit update, over the tolerance; else 0 */
  double peak;              /* largest nodal pressure of the cycle they come from [MPa] */
  double energy;            /* dissipated meanwhile, per thickness [N] */
  double pressed;           /* normal force over the sliding of the update [N] */
} wear_depths;

/* Room that lasts for a call and means nothing between calls. */
typedef struct wear_work {
  wear_rate rate;
  wear_depths depth;
  double *slip; /* [4 * (nc + np)] of an increment; or what mirror images wear */
} wear_work;

/* The wear of a cycle of a block on the present surfaces: found with them, as the next update
 * begins with it. Leaves no trace in results. */
typedef struct wear_start {
  const wear_block *block; /* NULL: unknown */
  wear_rate rate;
  int solutions;                  /* it took, and no record counts yet */
  struct wear_jacobian *jacobian; /* NULL: none was ever wanted */
  int linear;                     /* the Jacobian belongs to it */
  double mu;                      /* coefficient of friction it was found with */
} wear_start;

/* What the limit of stability was found for. */
typedef struct wear_judged {
  const wear_block *block; /* NULL: not yet */
  double k[ARC_BODIES];    /* [mm2/N] */
  double p_center;         /* [MPa] */
  double eigenvalue;       /* [1/cycle] */
  int warned;
} wear_judged;

struct arc_wear {
  arc_model *model;

  /* state: all that is stored; a restored run goes on to the same bits */
  arc_wear_def def; /* series and loading are own copies */
  arc_shape *shape;
  size_t records, capacity;
  arc_wear_record *history;

  /* what follows from the definition */
  arc_procedure procedure; /* SP or NSP */
  int over_plate;          /* the stroke is the whole plate's width */
  int blocks;
  wear_block *block;
  int nc, np; /* surface nodes */

  /* where contact is solved: leaves no trace in results */
  wear_path path;
  pose reference; /* plate at x = 0, nominal load */
  wear_work work;
  int warned; /* the callbacks know what speaks against this definition */
  wear_judged judged;
  wear_start start;
};

/* The plate stays flat, and wears everywhere alike, or along a track. */
static inline int wears_evenly(const arc_wear *w) {
  return (w->over_plate || w->def.track > 0) && w->procedure == ARC_NSP;
}

/* Every increment of a cycle has an update of its own. */
static inline int splits_cycles(const arc_wear *w) {
  return w->def.update == ARC_UPDATE_INCREMENT && w->procedure == ARC_SP;
}

/* Whether the load alone does not tell the work: forces along the load balance it, those along
 * normals are more in a hole; and a spin goes farther at larger radii. */
static inline int arc_wear_counts_forces(const arc_wear *w) {
  return arc_model_body(w->model, ARC_CYLINDER)->chart.polar || w->def.spin > 0;
}

/* --- definition.c --- */
arc_procedure arc_wear_choose_procedure(const arc_wear_def *def, const arc_model_def *model);
int arc_wear_over_plate(const arc_wear_def *def, const arc_model_def *model);
/* Deep copy of series and loading into *copy; frees with arc_wear_def_free. ARC_MEMORY leaves
 * nothing to free. */
arc_status arc_wear_def_copy(const arc_wear_def *def, arc_wear_def *copy);
void arc_wear_def_free(arc_wear_def *def);

/* Whether only the cylinder wears, all the way. */
int arc_wear_alpha_stays_one(const arc_wear_def *def);

/* --- revolved.c --- */
/* Whether a definition keeps to the axis of a model of revolution, and asks for one only there;
 * ARC_ARGUMENT. */
arc_status arc_wear_check_revolved(const arc_wear_def *def, const arc_model_def *model,
                                   arc_error *error);
/* Half width of a flat scar of a volume [mm3] on a cylinder of that radius, or on a ball. */
double arc_wear_scar(const arc_wear_def *def, const arc_model_def *model, double radius,
                     double volume);
/* Slip at surface node i over that at the radius where it is told: 1 unless the bodies spin. */
double arc_wear_spin_share(const arc_wear *w, const shape_side *side, int i);

/* --- definition.c --- */
/* Whether a run is one with friction. */
int arc_wear_rubs(const arc_wear_def *def);

/* --- block.c --- */
/* The block that holds the state after so many cycles. */
const wear_block *arc_wear_block_at(const arc_wear *w, double cycle);

/* --- coefficient.c --- */
/* Wear coefficients of both bodies [mm2/N], averaged over distances [from, to]; functions are asked
 * with `state`. */
arc_status arc_wear_coefficients(const arc_wear *w, double from, double to,
                                 const arc_wear_record *state, double k[ARC_BODIES],
                                 arc_error *error);
/* A table at a distance [mm]. */
double arc_wear_series(const arc_series *s, double distance);
/* Asks a function for a quantity, and refuses what is out of its range. */
arc_status arc_wear_ask(const arc_wear *w, const arc_setting *what, arc_state_fn function,
                        const arc_wear_record *state, double *value, arc_error *error);
/* Those of the present state. */
arc_status arc_wear_coefficients_now(const arc_wear *w, double k[ARC_BODIES], arc_error *error);
int arc_wear_has_state_functions(const arc_wear *w);
/* k and alpha of a record from the bodies' coefficients. */
void arc_wear_note_coefficients(const double k[ARC_BODIES], arc_wear_record *record);
/* What wears under a pressure [MPa]: p times the factor of the law. */
double arc_wear_law(const arc_wear *w, double p);
/* The same with friction, whose coefficient the energy law takes. */
double arc_wear_law_rubbed(const arc_wear *w, double p, double mu);
/* Multiplies a point's q by the local factors. */
arc_status arc_wear_local(const arc_wear *w, const arc_wear_record *state, wear_point *point,
                          arc_error *error);
/* dq/dp of the law at a node. */
double arc_wear_law_slope(const arc_wear *w, double p, double q);

/* --- reference.c --- */
/* alpha = 0 over the whole plate: the contact never changes and no solution is needed. */
int arc_wear_closed_form(const arc_wear *w);
/* Reads the reference configuration of a shape into the record (which holds the rest). */
arc_status arc_wear_measure(arc_wear *w, const arc_shape *shape, arc_wear_record *record,
                            arc_error *error);

/* --- ahead.c --- */
/* Largest depth of the plate [mm]; of a track, its mean depth as wide as the contact is. The record
 * has volume and half width. */
double arc_wear_plate_depth(const arc_wear *w, const arc_shape *shape,
                            const arc_wear_record *record);

/* --- record.c --- */
/* Loads and travel of a record: a cycle of a block, or increment `first` of a generic one. */
void arc_wear_note_motion(const arc_wear *w, const wear_block *block, int first,
                          arc_wear_record *record);
arc_status arc_wear_append(arc_wear *w, const arc_wear_record *record, arc_error *error);

#endif
