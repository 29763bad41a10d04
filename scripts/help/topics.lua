-- Topics of help: what belongs to no single name. { title, text }, in the order of the overview. Lines
-- that begin with two spaces stay as they are.

return {
  { "units", [[
Lengths are in mm, forces in N, pressures and moduli in MPa (N/mm2), wear coefficients in mm2/N, volumes in mm3, angles in
degrees. Loads count for the thickness, which is 1 mm unless model{ thickness= } says otherwise; those on bodies of revolution
are whole forces.

Travelled distance d is the way of the plate in mm, both strokes counted: d = cycles * strokes * stroke, with two strokes a
cycle, or one at a stroke of 2 radius. Depths are in mm everywhere; tables and plots show um where they say so.

k = 1e-8 mm2/N is 1e-8 mm3 of wear for each N and mm of sliding, both bodies together. In mm3/(N m) the same k is a thousand
times the number: 1e-8 mm2/N = 1e-5 mm3/(N m).

Run files carry units in the names of columns (half_width_mm), and have a view of them all (units).]] },

  { "glossary", [[
Terms, with the symbol of the paper where it has one.

  alpha          wear partition factor k_c / (k_c + k_p): the upper body's
                 share of the wear
  alpha-tilde    depth partition factor: the upper body's share of the depth
  approach       rigid displacement of one body towards the other [mm]
  cycle          one period of the motion, N of them in a run
  gross slip     the whole contact slips; partial slip: only its rims do
  half width     b, half the width of the contact [mm]
  increment      a part of a cycle, n_c of them; one contact problem each
  jump           N-bar, cycles worn off together in one update
  k              wear coefficient k_c + k_p [mm2/N]; volume per force and
                 distance
  load           L, normal force [N]
  mu             friction
  p_center       pressure at the deepest point, p_max the largest, p_peak
                 the largest over a cycle [MPa]
  procedure      SP: the sliding plate is simulated; NSP: one contact
                 problem an update
  ripple         sawtooth in worn surfaces, by a jump past the stability limit
  scar           the worn part of a surface
  sliding        d_t, travelled distance, both strokes counted [mm]
  slip           tangential displacement of one surface over the other [mm]
  stick zone     the part of a contact that does not slip
  stroke         s_t, from one end of the motion to the other [mm]
  update         one change of the geometry by wear
  volume         V, wear volume [mm3]; V = k L d_t
  zone           the part of a body's surface with contact elements]] },

  { "axisymmetric", [[
model{ geometry = "axisymmetric" } turns the section about a vertical axis: the cylinder is a ball, the block a disc, a punch a
pin with a flat end; loads are whole forces, volumes mm3 of the whole ring, and half_width is the radius of the contact. With
axis = 40 the axis lies 40 mm left of x = 0, as far as the mean radius of a thrust ring. "plane stress" is for thin plates.

The contact stays where it is, so wear{} needs slide = "z", and one of these:

  alpha = 1        a pin on a disc: all its points go as far, the disc is flat
  track = 20       the same, a cycle being a revolution at 20 mm; the disc may
                   wear too, and stays flat: its depth is the mean over the
                   track, as wide as the contact is by then
  spin = 1         both turn on the axis: slip is r / spin times the stroke;
                   with spin = 1 distances are angles
  model.axis > 0   a ring: all its points go as far; with spin those outside
                   go farther

  w = wear{ model = { geometry = "axisymmetric" }, load = 50, slide = "z",
    alpha = 1, track = 20, cycles = 1000, jump = "auto" }

Refused: strokes along x, friction in the section, holes, plates of another thickness; profiles that differ at x and -x. A mesh
from Gmsh has both halves of the section, with mesh lines on the axis between them. Pressures on the axis have no bound under a spin.]] },
  { "running in", [[
Fresh surfaces often wear faster and then settle. Give k as a function of the state, or as a table over the distance:

  k = function(state) return 1e-8 + 4e-8 * math.exp(-state.distance / 100) end
  k = { distance = { 0, 200, 1320 }, value = { 5e-8, 1e-8, 1e-8 } }

Both are integrated along every update, and an update ends where a table jumps. alpha takes the same forms. Short steps while
k falls, long ones after: scheme = "implicit" with tolerance = 1e-3, or jump = "auto". calibrate{} makes such tables out of
volumes measured on the way. See help "state", and examples "running_in".]] },
  { "files", [[
  w:save, wear.open           runs with all they need to go on
  s:run{ file= }, study.open  cases, each stored as it ends
  session.save, session.open  runs, models, studies, values by name
  export.csv, .vtk, .inp      tables, fields, input decks for other programs
  csv.read                    measured loadings and profiles
  plot{ ..., file= }          pictures: .png, .svg, .pdf, .eps, .txt
  plot.save                   the last picture, and its data beside it

Run files are SQLite databases: sqlite3 run.archard "select * from history_of". Files of older releases go on. Functions in a
definition cannot be stored: they are given again when the file is opened. examples "files" writes and reads most
of these. On leaving the prompt with runs that are in no file it asks whether to save the session.]] },
  { "meshes", [[
A model{} meshes both bodies and condenses them once; contact and wear then work on the surfaces alone. Elements under the
contact are mesh.size wide and mesh.height high, and grow towards mesh.far. Where no size is given it follows the contact that
the model is built for, layers and all: 5.4 elements to the half width, twice as many of a ball, as many to the rounded edge of a
punch, eight to a wave of a rough profile, in wear runs five to a rim that slips; mesh.fineness = 2 halves them. Where you give a size, four to the half width are the least that makes sense.
plot.mesh(m, { zoom = "wear box" }) shows them, hertz{} tells the half width.

mesh.zone is the full width of the fine contact zone of each body; without a model it suits. A run that outgrows its zone or its
wear box goes on, on new meshes, and says so; a single contact{} names the zone to widen. study.converge{} finds a size, a jump
and increments for a case. Pressures at edges of scars (p_max, p_peak) grow as elements shrink: p_average settles.]] },
  { "gmsh", [[
model{ mesh = "pair.msh" } takes both bodies from a Gmsh file: text, version 4.1 or 2.2, in mm and in the plane z = 0,
triangles and quadrilaterals of first order. Physical groups name the parts:

  upper, lower      surfaces: the bodies, which touch without load;
                    upper is what is called cylinder, lower the plate
  upper.contact     curve that may come into contact, in one piece, one y for
                    each x; lower.contact too
  upper.fixed       curves built in or tied to the rigid base; lower.fixed too
  upper.NAME        surfaces of another material (up to 4); lower.NAME too

Bodies share no points, not even where they touch. What does not fit is refused with its number and place. Materials come by
their names, k as deep as they reach in the mesh; what has no name is of the body's own E, nu and k:

  model{ mesh = "pair.msh", upper = body.gmsh{ name = "roller", E = 210e3,
    materials = { coating = { E = 400e3, k = 1e-9 } } } }

Of a pin in a hole the shapes tell the arc: upper = body.disc{ radius= }, lower = body.ring{ inner=, outer= }; they take
materials, too. Any other shape beside the mesh is refused. radius is that of the unworn gap where it is not given; estimates need it. Such a mesh has no wear box:
wear{ geometry = "frozen" } alone works on it. Runs, studies and sessions are stored with the mesh itself. export.msh writes
archard's own meshes, examples/gmsh_pair.geo shows how to make one:

  gmsh -2 -order 1 -format msh41 -o gmsh_pair.msh gmsh_pair.geo]] },
  { "steps", [[
One update of the geometry wears many cycles together. How many:

  jump = "auto"        the default: explicit steps that follow an estimate of
                       their error
  scheme = "implicit"  long steps by tolerance, 1e-3 where none is given
  jump = 50            fixed, as the paper does: 100 for most at 0.11 mm,
                       20 to 50 for longer strokes, at elements of 20 um

Past a limit a fixed jump lets ripples grow that make the surfaces rough: w:stability() computes it, and runs past it warn.
Longer strokes and smaller elements have lower limits.

increments divide a cycle: "auto" takes enough of them that the plate moves by less than an eighth of the half width in each.
w:step() makes one update, w:run() all; Ctrl-C stops after the running step, and w:run() goes on. examples "steps" compares them.]] },
  { "troubleshooting", [[
"no global 'x'": a name that nothing was assigned to. rawget(_G, "x") asks without an error; archard --lax reads nil instead.

"no field ... did you mean ...": an object has no such field or method. help(wear) lists those of runs.

Rough profiles, ripples, pressures that saw: the jump is too large. See help "steps".

A zone too narrow: leave the model out of contact{}, or widen the mesh.zone that the message names. Runs widen it themselves.

Too coarse for the contact: fewer than four elements to the half width. Smaller mesh.size, or none; see help "meshes".

It takes long: time(function() w:step() end) tells how long a step takes. Larger elements, fewer increments, longer steps;
studies use all processors by themselves.

No picture: gnuplot has to be installed. plot{ ..., file = "p.png" } draws to a file, plot.default.term chooses the terminal.]] },
}
