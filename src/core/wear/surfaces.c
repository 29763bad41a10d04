/* The surfaces of a run as they are now. Leans on the shape's profiles and a contact solution. */
#include "archard/wear.h"

#include <stdlib.h>
#include <string.h>

static arc_surface *allocate(const arc_profile profile[ARC_BODIES], double **numbers) {
  size_t count = 0;
  for (int b = 0; b < ARC_BODIES; b++) count += (size_t)profile[b].count;
  arc_surface *block = malloc(ARC_BODIES * sizeof *block + 4 * count * sizeof **numbers);
  if (block) *numbers = (double *)(void *)(block + ARC_BODIES);
  return block;
}

static const double *copy(double **to, const double *from, size_t count) {
  double *start = memcpy(*to, from, count * sizeof *from);
  *to += count;
  return start;
}

arc_status arc_wear_surfaces(const arc_wear *wear, arc_surface **surfaces, arc_error *error) {
  arc_contact *contact;
  double *numbers;
  *surfaces = NULL;
  arc_status status = arc_wear_contact(wear, &contact, error);
  if (status != ARC_OK) return status;
  const arc_wear_record *last = arc_wear_last(wear);
  arc_profile profile[ARC_BODIES];
  for (int b = 0; b < ARC_BODIES; b++)
    profile[b] = arc_shape_profile(arc_wear_shape(wear), (arc_body)b);
  arc_surface *made = allocate(profile, &numbers);
  for (int b = 0; b < ARC_BODIES && made; b++) {
    const size_t n = (size_t)profile[b].count;
    const double *p = arc_contact_pressure(contact, (arc_body)b).p;
    made[b] = (arc_surface){.body = (arc_body)b,
                            .update = last->update,
                            .distance = last->distance,
                            .count = n,
                            .x = copy(&numbers, profile[b].x, n),
                            .h = copy(&numbers, profile[b].h, n),
                            .y = copy(&numbers, profile[b].y, n),
                            .p = copy(&numbers, p, n)};
  }
  arc_contact_destroy(&contact);
  *surfaces = made;
  return made ? ARC_OK : arc_fail(error, ARC_MEMORY, "out of memory for the surfaces of a run");
}
