/* Computes the "auto" values in the definition of a model for its contact. All lengths in the
 * mesh of the reference paper are scaled with the half width of the contact, so that the
 * relative error is the same for every contact. */
#include "core/elastic/mesh_size.h"
#include "core/elastic/contact_estimate.h"
#include "core/mesh/mesh.h"

#include <math.h>

double arc_model_size_for(double half_width) {
  const arc_hertz_def paper = arc_hertz_default();
  arc_hertz hertz = {0};
  arc_hertz_solve(paper.radius, paper.thickness, paper.load, paper.material, &hertz, NULL);
  return arc_mesh_default().size * (half_width / hertz.half_width);
}

/* Returns the smallest dimension of the two bodies [mm], which limits the element sizes. */
static double least_measure(const arc_model_def *def) {
  const arc_body_def upper = arc_model_solid(def, ARC_UPPER),
                     lower = arc_model_solid(def, ARC_LOWER);
  return fmin(arc_body_measure(&upper), arc_body_measure(&lower));
}

double arc_model_deepest_box(const arc_model_def *def) {
  return least_measure(def) / 4;
}

double arc_model_widest_zone(const arc_model_def *def, arc_body body) {
  const arc_body_def solid = arc_model_solid(def, body);
  return arc_body_widest_zone(&solid);
}

/* Returns the largest automatic element size [mm]. With this size the height of a row is at most
 * a tenth, and the depth of the wear box at most a quarter, of the smallest dimension of the
 * bodies. */
static double largest_size(const arc_model_def *def) {
  const arc_mesh_def paper = arc_mesh_default();
  const double stretch = paper.height / paper.size;
  const double measure = least_measure(def);
  return fmin(measure / 10 / stretch, measure / 4 / stretch / def->mesh.rows);
}

/* Largest automatic number of columns for a contact with sharp edges. A limit is necessary
 * because elements have the same size over the whole zone, which is as deep as it is wide. */
static const double most_columns = 320;

static double smallest_size(const contact_estimate *e) {
  return 2 * ARC_CONTACT_MARGIN * (e->half_width + e->edge) / most_columns;
}

/* Returns the element size [mm] that resolves the edges of the contact as finely as the mesh of
 * the reference paper. For round spots the size is halved; otherwise the pressure on the axis is
 * 0.3 % too low. A flat is divided so that its ends are nodes. */
static double contact_size(const arc_model_def *def, const contact_estimate *e) {
  const double fine = arc_model_size_for(e->edge) / (arc_model_is_round(def) ? 2 : 1);
  const double size = fmax(fine, smallest_size(e)), flat = e->flat / 2;
  return flat > size ? flat / ceil(flat / size) : size;
}

/* Returns the element size [mm] for a rough profile, which has eight elements per wave and five
 * elements in each contact spot. */
static double size_of_waves(const contact_estimate *e) {
  enum { a_wave = 8, a_spot = 5 };
  return fmin(e->wave / a_wave, fmax(e->spot / a_spot, smallest_size(e)));
}

static void fit_size(arc_model_def *def, const contact_estimate *e) {
  arc_mesh_def *mesh = &def->mesh;
  if (mesh->fineness == 0) mesh->fineness = 1;
  mesh->size =
      fmin(fmin(contact_size(def, e), size_of_waves(e)) / mesh->fineness, largest_size(def));
}

/* Limits the height of rows [mm] so that soft, nearly incompressible layers contain two rows. A
 * single row locks where the layer is squeezed out sideways. Much thinner layers are ignored,
 * because they are as stiff as the material below them and would need very flat rows. */
static double height_in_layers(const arc_model_def *def, double height) {
  static const double incompressible = 0.4;
  const double flattest = def->mesh.size / 16;
  for (int b = 0; b < ARC_BODIES; b++) {
    const arc_body_def *solid = &def->body[b];
    const int layers = arc_body_layers(solid);
    for (int l = 0; l < layers; l++) {
      const arc_layer *layer = &solid->layer[l];
      const double below = l + 1 < layers ? layer[1].material.E : def->material[b].E;
      const int squeezed = layer->material.nu > incompressible && layer->material.E < below;
      if (squeezed && layer->thickness / 2 >= flattest) height = fmin(height, layer->thickness / 2);
    }
  }
  return height;
}

static void fit_to(arc_model_def *def, const contact_estimate *e) {
  const arc_mesh_def paper = arc_mesh_default();
  arc_mesh_def *mesh = &def->mesh;
  if (mesh->size == 0) fit_size(def, e);
  if (mesh->height == 0)
    mesh->height = height_in_layers(def, paper.height * (mesh->size / paper.size));
  if (mesh->far == 0) mesh->far = fmax(least_measure(def) / 10, fmax(mesh->size, mesh->height));
}

void arc_model_fit(arc_model_def *def, double load) {
  contact_estimate e = {0};
  if (def->mesh.size == 0) e = arc_model_estimate(def, load);
  fit_to(def, &e);
}

void arc_model_fit_friction(arc_model_def *def, double load) {
  static const double finer = 5;
  contact_estimate e = {0};
  if (def->mesh.size == 0) {
    e = arc_model_estimate(def, load);
    fit_size(def, &e);
    const double zone = fmax(def->mesh.zone[ARC_UPPER], def->mesh.zone[ARC_LOWER]);
    const double least = fmax(smallest_size(&e), zone / most_columns) / fmax(1, def->mesh.fineness);
    def->mesh.size = fmin(def->mesh.size, fmax(def->mesh.size / finer, least));
  }
  fit_to(def, &e);
}

void arc_zone_for(double reach, double half_width, double size, double zone[ARC_BODIES]) {
  const arc_mesh_def paper = arc_mesh_default();
  const double contact = ARC_CONTACT_MARGIN * half_width, scale = size / paper.size;
  zone[ARC_CYLINDER] = fmax(scale * paper.zone[ARC_CYLINDER], 2 * contact);
  zone[ARC_PLATE] = fmax(scale * paper.zone[ARC_PLATE], 2 * (reach + contact));
}

/* Rounds the width of a zone [mm] up to a multiple of ten elements, so that similar computations
 * can use the same model. */
static double rounded_zone(const arc_model_def *def, arc_body body, double needed) {
  const double unit = 10 * def->mesh.size, rounded = ceil(needed / unit - 1e-9) * unit;
  return fmin(rounded, arc_model_widest_zone(def, body));
}

void arc_model_fit_zones(arc_model_def *def, const double needed[ARC_BODIES]) {
  for (int b = 0; b < ARC_BODIES; b++)
    if (def->mesh.zone[b] == 0) def->mesh.zone[b] = rounded_zone(def, (arc_body)b, needed[b]);
}

void arc_model_fit_alone(arc_model_def *def) {
  const double load = arc_hertz_default().load;
  const contact_estimate e = arc_model_estimate(def, load);
  double zone[ARC_BODIES];
  fit_to(def, &e);
  arc_zone_for(0, fabs(e.at) + e.half_width + e.edge, arc_model_size_for(e.edge), zone);
  for (int b = 0; b < ARC_BODIES; b++)
    if (def->mesh.zone[b] == 0)
      def->mesh.zone[b] = fmin(zone[b], arc_model_widest_zone(def, (arc_body)b));
}

/* --- cost */

/* Returns the approximate memory of one body [bytes]: its stiffness, the factor of the
 * stiffness, and dense matrices over the wear box. The numerical factors were fitted to meshes
 * with elements of 20 to 2.5 um. */
static double body_memory(const arc_model_def *def, arc_body body) {
  const arc_body_def solid = arc_model_solid(def, body);
  const double nodes = arc_mesh_nodes(&def->mesh, body, &solid);
  const double surface = def->mesh.zone[body] / def->mesh.size + 1, rows = def->mesh.rows;
  const double rim = 2 * (surface + 2 * rows), inner = 2 * surface * rows;
  const double dense = inner * (rim + 2 * surface) + 4 * rim * rim + 10 * surface * surface;
  return 150 * nodes * log2(nodes) + 8 * dense;
}

double arc_model_memory(const arc_model_def *def) {
  return body_memory(def, ARC_CYLINDER) + body_memory(def, ARC_PLATE);
}
