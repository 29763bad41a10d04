/* Declares the wear run (arc_wear), and functions that use its members. */
#ifndef WEAR_RUN_H
#define WEAR_RUN_H

#include "core/pair/kind.h"

/* Workspace for the updates of a run. */
typedef struct wear_work {
  wear_rate rate;
  wear_depths depth;
} wear_work;

/* Cached wear rate of a cycle on the present surfaces. The next update starts from this rate. The
 * cache does not change results. */
typedef struct wear_start {
  const wear_block *block; /* NULL: nothing is cached */
  wear_rate rate;
  int solutions; /* number of contact solutions that no record has counted yet */
  wear_tangent
      *tangent; /* derivative of the rate with respect to the depths; NULL: not needed so far */
  int linear;   /* 1 if `tangent` was computed with this rate */
  double mu;    /* friction coefficient with which the rate was computed */
} wear_start;

/* Inputs and result of the last computation of the stability limit. */
typedef struct wear_judged {
  const wear_block *block; /* block of loading of the computation; NULL: no limit computed so far */
  double k[ARC_BODIES];    /* [mm2/N] */
  double p_center;         /* [MPa] */
  double eigenvalue;       /* [1/cycle] */
  int warned;
} wear_judged;

struct arc_wear {
  arc_model *model;
  const arc_kind *kind;

  /* state that is stored, from which a restored run continues with identical results */
  arc_wear_def def; /* definition, with its own copies of tables and loading */
  arc_shape *shape;
  size_t records, capacity;
  arc_wear_record *history;

  /* members derived from the definition */
  wear_manner manner;
  int blocks;
  wear_block *block;

  /* members of the solver, which do not influence results */
  int nc, np; /* numbers of sites of the upper and lower body */
  void *own;  /* data of the kind of pair */
  wear_work work;
  int warned; /* 1 if the user has received the warnings about this definition */
  int late;   /* warnings that the user has received, see arc_kind.warn_late */
  wear_judged judged;
  wear_start start;
};

/* Returns true if the geometry is updated at every increment of a cycle. */
static inline int splits_cycles(const arc_wear *w) {
  return w->def.update == ARC_UPDATE_INCREMENT && w->manner.procedure == ARC_SP;
}

/* Returns the wear coefficient [mm2/N] for the sites of a body. It is 0 for a body that wears
 * uniformly, because its sites do not wear individually. */
static inline double sites_k(const arc_wear *w, const double k[ARC_BODIES], int body) {
  return body == ARC_LOWER && w->manner.even ? 0 : k[body];
}

static inline int sites_of(const arc_wear *w, int body) {
  return body == ARC_UPPER ? w->nc : w->np;
}

/* Returns the part of a vector [n] that belongs to the sites of a body. */
static inline double *sites_from(const arc_wear *w, double *vector, int body) {
  return body == ARC_UPPER ? vector : vector + w->nc;
}

/* --- definition.c ----------------------------------------------------------------------------- */
/* Copies a definition with its tables and loading to *copy; arc_wear_def_free frees the copy. After
 * an error (ARC_MEMORY) there is nothing to free. */
arc_status arc_wear_def_copy(const arc_wear_def *def, arc_wear_def *copy);
void arc_wear_def_free(arc_wear_def *def);
/* Returns true if alpha is 1 throughout the run, so that only the upper body wears. */
int arc_wear_alpha_stays_one(const arc_wear_def *def);
int arc_wear_jump_is_auto(const arc_wear_def *def);
/* arc_wear_has_friction returns 1 for a run with friction, arc_wear_friction_is_known if the
 * friction coefficient is constant. */
int arc_wear_has_friction(const arc_wear_def *def);
int arc_wear_friction_is_known(const arc_wear_def *def);

/* --- wear.c ----------------------------------------------------------------------------------- */
/* Creates a run as arc_wear_create does, but without a check of the zones. */
arc_status arc_wear_create_on(arc_model *model, const arc_wear_def *def, const arc_shape *start,
                              arc_wear **wear, arc_error *error);
/* arc_wear_rate_clear sets a rate to zero, and arc_wear_rate_copy copies a rate. n is the number of
 * sites of both bodies. */
void arc_wear_rate_clear(wear_rate *rate, int n);
void arc_wear_rate_copy(const wear_rate *from, wear_rate *to, int n);
/* Exchanges the contents of two runs. */
void arc_wear_exchange(arc_wear *a, arc_wear *b);

/* --- block.c ---------------------------------------------------------------------------------- */
/* Creates the blocks [count] of a checked definition. arc_wear_blocks_free frees the blocks.
 * Error: ARC_MEMORY. */
arc_status arc_wear_blocks_create(const arc_wear_def *def, const arc_model_def *model,
                                  wear_block **block, int *count);
void arc_wear_blocks_free(wear_block **block, int count);
/* Returns the distance at the end of a block [mm]. */
double arc_wear_block_end(const wear_block *block);
/* Returns the block of the loading that contains a cycle number. */
const wear_block *arc_wear_block_at(const arc_wear *w, double cycle);

/* --- coefficient.c ---------------------------------------------------------------------------- */
/* Computes the wear coefficients of both bodies [mm2/N], averaged over the distances from `from`
 * to `to` [mm]. Functions of the user are evaluated with `state`. */
arc_status arc_wear_coefficients(const arc_wear *w, double from, double to,
                                 const arc_wear_record *state, double k[ARC_BODIES],
                                 arc_error *error);
/* Returns the value of a table at a distance [mm]. */
double arc_wear_series(const arc_series *s, double distance);
/* Evaluates the user's function for a setting and checks the range of the result. */
arc_status arc_wear_evaluate_function(const arc_wear *w, const arc_setting *what,
                                      arc_state_fn function, const arc_wear_record *state,
                                      double *value, arc_error *error);
/* Computes the wear coefficients of both bodies at the present state [mm2/N]. */
arc_status arc_wear_coefficients_now(const arc_wear *w, double k[ARC_BODIES], arc_error *error);
int arc_wear_has_state_functions(const arc_wear *w);
/* Stores k and alpha in a record, computed from the coefficients of both bodies. */
void arc_wear_note_coefficients(const double k[ARC_BODIES], arc_wear_record *record);
/* Returns the pressure times the factor of the wear law, which is the wear per sliding distance
 * divided by k [MPa]. For the energy law this value must be multiplied by the coefficient of
 * friction. */
double arc_wear_law(const arc_wear *w, double p);
/* Returns the wear per sliding distance, divided by k [MPa], with the coefficient of friction mu,
 * on which only the energy law depends. */
double arc_wear_law_rubbed(const arc_wear *w, double p, double mu);
/* Computes the local factors of one body at sites with the pressures p [sites] [MPa]. Without a
 * local_factor in the definition, factor [sites] is 1. */
arc_status arc_wear_local(const arc_wear *w, const arc_wear_record *state, arc_body body,
                          const wear_sites *on, const double *p, double *factor, arc_error *error);
/* Returns the derivative dq/dp [-] of the wear law at a node with the pressure p [MPa]. q [MPa] is
 * the wear per sliding distance, divided by k. */
double arc_wear_law_slope(const arc_wear *w, double p, double q);

/* --- record.c --------------------------------------------------------------------------------- */
/* Sets the largest load, the smallest load and the stroke in `record`: of one cycle if the loading
 * block repeats, or of increment `first` if the block runs once. */
void arc_wear_note_motion(const arc_wear *w, const wear_block *block, int first,
                          arc_wear_record *record);
arc_status arc_wear_append(arc_wear *w, const arc_wear_record *record, arc_error *error);

/* --- friction_coefficient.c ------------------------------------------------------------------- */
/* Returns true if the friction coefficient is a table or a function. */
int arc_wear_friction_changes(const arc_wear *w);
/* Computes the friction coefficient for the state of a run. Errors: errors of the user's
 * function. */
arc_status arc_wear_friction_of(const arc_wear *w, const arc_wear_record *state, double *mu,
                                arc_error *error);
/* Returns ARC_ARGUMENT if friction cannot carry the tangential force at a state of the run,
 * otherwise ARC_OK. */
arc_status arc_wear_friction_carries(const arc_wear *w, const arc_wear_record *state, double mu,
                                     arc_error *error);
/* Computes the friction coefficient for the state of a run, and checks that friction can carry the
 * tangential force. */
arc_status arc_wear_friction(const arc_wear *w, const arc_wear_record *state, double *mu,
                             arc_error *error);

#endif
