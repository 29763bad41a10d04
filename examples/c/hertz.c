/* Solves an unworn contact with finite elements and compares it with Hertz' closed form.
 *   cc hertz.c $(pkg-config --cflags --libs archard) -o hertz
 * Units: mm, N, MPa. */
#include <archard/contact.h>

#include <stdio.h>

int main(void) {
  const double load = 100; /* [N] on the whole thickness */
  arc_error why = {0};
  arc_model *model = NULL;
  arc_shape *shape = NULL;
  arc_contact *contact = NULL;
  arc_hertz hertz;

  /* Limits BLAS to one thread, because matrices of this size are slower with more threads. */
  arc_single_threaded();

  /* The default definition is a steel cylinder of radius 10 mm on a steel plate. The model is
   * meshed and condensed once. Shapes and contacts refer to the model. */
  arc_model_def def = arc_model_default();
  def.mesh.size = 0.01;
  def.mesh.height = 0.0125;
  arc_status status = arc_model_build(&def, &model, &why);

  /* Creates the unworn surfaces and solves their contact with the plate at x = 0. */
  if (status == ARC_OK) status = arc_shape_create(model, ARC_MOVING, 0.05, &shape, &why);
  const arc_contact_def problem = {.load = load};
  if (status == ARC_OK) status = arc_contact_solve(shape, &problem, NULL, &contact, &why);
  if (status == ARC_OK)
    status = arc_hertz_solve(def.radius, def.thickness, load, def.material, &hertz, &why);

  if (status == ARC_OK) {
    const arc_contact_result r = arc_contact_get(contact);
    printf("                   elements     Hertz\n");
    printf("largest pressure   %8.2f  %8.2f  MPa\n", r.p_max, hertz.p_max);
    printf("half width         %8.5f  %8.5f  mm\n", r.half_width, hertz.half_width);
  } else {
    fprintf(stderr, "hertz: %s: %s\n", arc_status_text(status), why.message);
  }

  /* The caller destroys every object that it created. The functions accept pointers to NULL. */
  arc_contact_destroy(&contact);
  arc_shape_destroy(&shape);
  arc_model_release(&model);
  return status == ARC_OK ? 0 : 1;
}
