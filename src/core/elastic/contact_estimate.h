/* Estimates the width of unworn contacts. */
#ifndef ELASTIC_CONTACT_ESTIMATE_H
#define ELASTIC_CONTACT_ESTIMATE_H

#include "archard/model.h"
#include "core/mesh/waves.h"

/* Contact of a pair under a load. All lengths are in mm. */
typedef struct contact_estimate {
  double half_width; /* half width of the contact, see arc_model_half_width */
  double flat;       /* width of the part that touches without load */
  double at;         /* position x of the middle of the contact, which is not 0 for some profiles */
  double edge; /* half width of a cylinder's or ball's contact with an equally steep fall of the
                  pressure at its edges; differs from half_width only for rounded edges and kinks */
  double wave; /* length of the shortest waves that change the pressure; INFINITY without waves */
  double spot; /* width of the contact spots on the crests of waves; INFINITY without waves */
} contact_estimate;

/* Gap between the unworn surfaces of a pair, for estimates under any number of loads. The members
 * `at` and `form`, and `least` for profiles, are computed again for each load. */
typedef struct contact_pair {
  const arc_model_def *def; /* model definition, which must outlive the estimate */
  int round;                /* true: the contact is a spot on the axis of revolution */
  arc_body_def solid[ARC_BODIES];
  double crest[ARC_BODIES];
  body_waves waves[ARC_BODIES];
  double hole, clearance;  /* [mm] radius of the hole (0: no hole), radial clearance of the pin */
  double least;            /* [mm] half width of the part that touches without load */
  double most;             /* [mm] assumed half width of the largest contact */
  double form[ARC_BODIES]; /* [mm] radius of curvature used instead of the heights of a rough
                              profile; 0: the heights are used */
  double at;               /* [mm] position where the surfaces touch */
  double load;             /* [N] load of the stored result `answer`; NAN: no result yet */
  contact_estimate answer;
} contact_pair;
contact_pair arc_model_pair(const arc_model_def *def);
/* Estimates the contact under a load. The result for the last load is stored and used again. */
contact_estimate arc_pair_estimate(contact_pair *pair, double load);
contact_estimate arc_model_estimate(const arc_model_def *def, double load);

/* Returns true if the contact is a spot on the axis of revolution. */
int arc_model_is_round(const arc_model_def *def);

#endif
