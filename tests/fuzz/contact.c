/* Fuzz target for contact problems: any load and friction on any worn shape must give a solution
 * or an error. A solution must balance its load and have no tensile pressures. */
#include "fuzz.h"

#include <math.h>

#include "archard/contact.h"

static arc_model *shared_model(void) {
  static arc_model *model;
  arc_model_def def = arc_model_default();
  def.mesh.size = 0.08;
  def.mesh.height = 0.06;
  if (!model && arc_model_build(&def, &model, NULL) != ARC_OK) abort();
  return model;
}

/* Wears a surface to depths at a few points; positions and depths are realistic or arbitrary. */
static arc_status wear_down(arc_shape *shape, arc_body body, source *s) {
  enum { MOST = 12 };
  double x[MOST], h[MOST], depth[2000];
  const int wild = take_byte(s) % 4 == 0, count = 2 + (int)(take_byte(s) % (MOST - 1));
  for (int i = 0; i < count; i++) {
    x[i] = wild ? take_any(s) : -0.4 + 0.8 * i / (count - 1);
    h[i] = wild ? take_any(s) : take_in(s, 0, 0.004);
  }
  for (int i = 1; i < count; i++)
    if (!(x[i] > x[i - 1])) return ARC_ARGUMENT; /* the Lua binding requires increasing x */
  arc_error error = {0};
  arc_status status = arc_shape_sample(
      shape, body, (arc_depths){.x = x, .h = h, .count = (size_t)count}, depth, &error);
  return status == ARC_OK ? arc_shape_wear(shape, body, depth, &error) : status;
}

static void check(const arc_contact *contact) {
  arc_error error = {0};
  if (arc_contact_validate(contact, &error) != ARC_OK) FOUND("%s", error.message);
}

static void move(const arc_contact *from, source *s) {
  arc_error error = {0};
  arc_motion_def motion = arc_contact_motion(from);
  arc_contact *moved = NULL;
  motion.by_force = take_byte(s) % 2;
  motion.x = take_in(s, -0.1, 0.1);
  motion.tangential = take_in(s, -150, 150);
  motion.load = take_in(s, 0, 200);
  motion.increments = 1 + (int)(take_byte(s) % 6);
  if (arc_contact_move(from, &motion, NULL, &moved, &error) == ARC_OK)
    check(moved);
  else if (!error.message[0])
    FOUND("an error without a message");
  arc_contact_destroy(&moved);
}

static void solve(const arc_shape *shape, source *s) {
  arc_error error = {0};
  arc_contact_def def = arc_contact_default();
  arc_contact *contact = NULL;
  const int wild = take_byte(s) % 8 == 0;
  def.load = wild ? take_any(s) : take_in(s, 0.1, 200);
  /* a height of 1e-3 mm has a rounding error of 1e-19 mm, which changes the force at a node by
   * 1e-14 N; for loads below 1e-5 N this exceeds the tolerance of 1e-9 */
  if (fabs(def.load) < 1e-5) return;
  def.x = wild ? take_any(s) : take_in(s, -0.2, 0.2);
  def.friction = take_byte(s) % 2 ? take_in(s, 0, 1.5) : 0;
  def.increments = 1 + (int)(take_byte(s) % 6);
  def.press = take_byte(s) % 2 ? ARC_PRESS_FRICTION : ARC_PRESS_FRICTIONLESS;
  if (arc_contact_solve(shape, &def, NULL, &contact, &error) == ARC_OK) {
    check(contact);
    if (def.friction > 0) move(contact, s);
  } else if (!error.message[0]) {
    FOUND("an error without a message");
  }
  arc_contact_destroy(&contact);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  source s = {data, size};
  arc_shape *shape = NULL;
  const arc_geometry geometry = take_byte(&s) % 2 ? ARC_FROZEN : ARC_MOVING;
  if (arc_shape_create(shared_model(), geometry, 0.05, &shape, NULL) != ARC_OK) abort();
  const unsigned worn = take_byte(&s) % 4;
  arc_status status = ARC_OK;
  for (int body = 0; body < ARC_BODIES && status == ARC_OK; body++)
    if (worn & 1u << body) status = wear_down(shape, (arc_body)body, &s);
  if (status == ARC_OK) solve(shape, &s);
  arc_shape_destroy(&shape);
  return 0;
}
