/* Members of arc_wear, and functions on them. */
#ifndef WEAR_RUN_H
#define WEAR_RUN_H

#include "core/pair/kind.h"

/* Workspace of a call. */
typedef struct wear_work {
  wear_rate rate;
  wear_depths depth;
} wear_work;

/* Cached wear of a cycle on the present surfaces, with which the next update starts. Does not
 * change results. */
typedef struct wear_start {
  const wear_block *block; /* NULL: unknown */
  wear_rate rate;
  int solutions;         /* it took, and no record counts yet */
  wear_tangent *tangent; /* NULL: none was ever wanted */
  int linear;            /* the tangent belongs to it */
  double mu;             /* coefficient of friction of its computation */
} wear_start;

/* Inputs of the cached stability limit. */
typedef struct wear_judged {
  const wear_block *block; /* NULL: not yet */
  double k[ARC_BODIES];    /* [mm2/N] */
  double p_center;         /* [MPa] */
  double eigenvalue;       /* [1/cycle] */
  int warned;
} wear_judged;

struct arc_wear {
  arc_model *model;
  const arc_kind *kind;

  /* the stored state, from which a restored run continues to the same bits */
  arc_wear_def def; /* series and loading are own copies */
  arc_shape *shape;
  size_t records, capacity;
  arc_wear_record *history;

  /* derived from the definition */
  wear_manner manner;
  int blocks;
  wear_block *block;

  /* solver objects, without influence on results */
  int nc, np; /* sites of the upper and of the lower body */
  void *own;  /* the kind's */
  wear_work work;
  int warned; /* 1: warnings about this definition were given */
  int coarse; /* 1: the warning about coarse sites was given */
  wear_judged judged;
  wear_start start;
};

/* True if every increment of a cycle has an update. */
static inline int splits_cycles(const arc_wear *w) {
  return w->def.update == ARC_UPDATE_INCREMENT && w->manner.procedure == ARC_SP;
}

/* Wear coefficients of the sites; 0 for bodies that wear evenly. */
static inline double sites_k(const arc_wear *w, const double k[ARC_BODIES], int body) {
  return body == ARC_LOWER && w->manner.even ? 0 : k[body];
}

static inline int sites_of(const arc_wear *w, int body) {
  return body == ARC_UPPER ? w->nc : w->np;
}

/* Parts of a vector over the sites. */
static inline double *sites_from(const arc_wear *w, double *vector, int body) {
  return body == ARC_UPPER ? vector : vector + w->nc;
}

/* --- definition.c ----------------------------------------------------------------------------- */
/* Deep copy of series and loading into *copy; frees with arc_wear_def_free. ARC_MEMORY leaves
 * nothing to free. */
arc_status arc_wear_def_copy(const arc_wear_def *def, arc_wear_def *copy);
void arc_wear_def_free(arc_wear_def *def);
/* True if only the upper body ever wears. */
int arc_wear_alpha_stays_one(const arc_wear_def *def);
int arc_wear_jump_is_auto(const arc_wear_def *def);
/* True for a run with friction; true if its coefficient is constant. */
int arc_wear_has_friction(const arc_wear_def *def);
int arc_wear_friction_is_known(const arc_wear_def *def);

/* --- wear.c ----------------------------------------------------------------------------------- */
/* Sets all depths, [n] of the sites and the others, to zero. */
void arc_wear_rate_clear(wear_rate *rate, int n);
void arc_wear_rate_copy(const wear_rate *from, wear_rate *to, int n);
/* Swaps two depths. */
void arc_wear_exchange(arc_wear *a, arc_wear *b);

/* --- block.c ---------------------------------------------------------------------------------- */
/* The blocks of a checked definition: block [count], freed by arc_wear_blocks_free. */
arc_status arc_wear_blocks_create(const arc_wear_def *def, const arc_model_def *model,
                                  wear_block **block, int *count);
void arc_wear_blocks_free(wear_block **block, int count);
/* Distance at the end of a block [mm]. */
double arc_wear_block_end(const wear_block *block);
/* The block of the state at `cycle`. */
const wear_block *arc_wear_block_at(const arc_wear *w, double cycle);

/* --- coefficient.c ---------------------------------------------------------------------------- */
/* Wear coefficients of both bodies [mm2/N], averaged over distances [from, to]; functions are
 * evaluated with `state`. */
arc_status arc_wear_coefficients(const arc_wear *w, double from, double to,
                                 const arc_wear_record *state, double k[ARC_BODIES],
                                 arc_error *error);
/* A table at a distance [mm]. */
double arc_wear_series(const arc_series *s, double distance);
/* Evaluates a function for a quantity and checks the range of the result. */
arc_status arc_wear_evaluate_function(const arc_wear *w, const arc_setting *what,
                                      arc_state_fn function, const arc_wear_record *state,
                                      double *value, arc_error *error);
/* Wear coefficients of the present state. */
arc_status arc_wear_coefficients_now(const arc_wear *w, double k[ARC_BODIES], arc_error *error);
int arc_wear_has_state_functions(const arc_wear *w);
/* k and alpha of a record from the bodies' coefficients. */
void arc_wear_note_coefficients(const double k[ARC_BODIES], arc_wear_record *record);
/* Wear rate of the law [MPa]: pressure times its factor. */
double arc_wear_law(const arc_wear *w, double p);
/* The same with friction, which the energy law multiplies. */
double arc_wear_law_rubbed(const arc_wear *w, double p, double mu);
/* The local factors of one body at sites under pressures p [sites], to factor [sites]; 1 where the
 * run has none. */
arc_status arc_wear_local(const arc_wear *w, const arc_wear_record *state, arc_body body,
                          const wear_sites *on, const double *p, double *factor, arc_error *error);
/* dq/dp of the law at a node. */
double arc_wear_law_slope(const arc_wear *w, double p, double q);

/* Like arc_wear_create, without a check of the zones. */
arc_status arc_wear_create_on(arc_model *model, const arc_wear_def *def, const arc_shape *start,
                              arc_wear **wear, arc_error *error);

/* --- record.c --------------------------------------------------------------------------------- */
/* Loads and travel of a record: a cycle of a block, or increment `first` of a generic one. */
void arc_wear_note_motion(const arc_wear *w, const wear_block *block, int first,
                          arc_wear_record *record);
arc_status arc_wear_append(arc_wear *w, const arc_wear_record *record, arc_error *error);

/* --- friction_coefficient.c ------------------------------------------------------------------- */
/* True if the coefficient of friction is a table or a function. */
int arc_wear_friction_changes(const arc_wear *w);
/* The coefficient of friction of a state. Errors of the function. */
arc_status arc_wear_friction_of(const arc_wear *w, const arc_wear_record *state, double *mu,
                                arc_error *error);
/* ARC_ARGUMENT if friction does not carry the tangential force at a state. */
arc_status arc_wear_friction_carries(const arc_wear *w, const arc_wear_record *state, double mu,
                                     arc_error *error);
/* Both. */
arc_status arc_wear_friction(const arc_wear *w, const arc_wear_record *state, double *mu,
                             arc_error *error);

#endif
