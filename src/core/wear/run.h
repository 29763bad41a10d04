/* Inside of arc_wear: what one run holds. */
#ifndef WEAR_RUN_H
#define WEAR_RUN_H

#include "archard/wear.h"
#include "core/contact/pose.h"

/* Wear of one cycle per unit of wear coefficient, at the surface nodes: sum of p ds over the
 * strokes [MPa mm]. */
typedef struct wear_rate {
  double *node[ARC_BODIES]; /* [surface of the body] */
  double even;              /* the plate's, where it wears evenly (Eq. 27) */
} wear_rate;

struct arc_wear {
  arc_model *model;
  arc_wear_def def;
  arc_procedure procedure; /* SP or NSP */
  double strokes;          /* r of Eq. (21) */
  int over_plate;          /* the stroke is the whole plate's width */
  arc_shape *shape;
  arc_shape *next; /* the shape under construction in a step */
  int poses;       /* contact solutions a cycle takes */
  pose *pose;      /* [poses] at the increments' plate positions */
  pose reference;  /* plate at x = 0, nominal load */
  long *condensed; /* [poses + 1] state of the shape's compliance each pose was stiffened with */
  int started;     /* [poses] are placed */
  wear_rate rate;
  double *work; /* [4 * (nc + np)] */
  size_t records, capacity;
  arc_wear_record *history;
};

/* SP or NSP as in the flow chart of Fig. 7. */
arc_procedure wear_choose_procedure(const arc_wear_def *def, const arc_model_def *model);
int wear_over_plate(const arc_wear_def *def, const arc_model_def *model);

/* Fills w->rate from contact solutions on w->shape: cycle.c. */
arc_status wear_cycle(arc_wear *w, arc_stop_fn stop, void *context, arc_error *error);
/* Brings a pose up to date with a shape: position, gaps, and stiffness where it is stale. */
arc_status wear_prepare_pose(arc_wear *w, int index, const arc_shape *shape, arc_error *error);
/* The plate position of increment i [mm]. */
double wear_position(const arc_wear *w, int i);
/* Wear coefficient of one body [mm2/N]. */
double wear_coefficient(const arc_wear_def *def, arc_body body);

/* The record of the state after a step: measure.c. `before` NULL: the first. */
arc_status wear_measure(arc_wear *w, const arc_shape *shape, const arc_wear_record *before,
                        arc_wear_record *record, arc_error *error);

#endif
