-- Help topics, which explain subjects that several objects share. Each topic is { title, text }, in the order
-- of the overview. Lines of a text that begin with two spaces are not wrapped.

return {
  { "units", [[
Lengths are in mm, forces in N, pressures and moduli in MPa (N/mm2), wear coefficients in mm2/N, volumes in mm3, angles in
degrees. In 2-D a load acts on the whole thickness of the bodies, 1 mm by default (model{ thickness= }); on bodies of revolution and in
three dimensions it is the total force.

The travelled distance d [mm] counts both strokes of a cycle (to and fro): d = cycles * strokes * stroke, with two strokes per
cycle; with track = r a cycle is a revolution, d = cycles * 2 pi r. If the stroke is 2 * radius, the width of the
cylinder, the plate slides in one direction only, and a cycle has one stroke. Depths are in mm; tables and plots in um have this unit in
their labels.

Time, speed and frequency are no settings: t seconds at a frequency f [Hz] are f * t cycles, and t seconds at a speed v [mm/s]
are the distance v * t.

k = 1e-8 mm2/N means that both bodies together lose 1e-8 mm3 per N of load and mm of sliding. Other units of k:

  1e-5 mm3/(N m)     is 1e-8 mm2/N: divide by 1000
  1e-14 m2/N         is 1e-8 mm2/N; 1 m2/N = 1 m3/(N m) = 1e6 mm2/N
  1e-5 mm3/J         is 1e-8 mm3/(N mm) = 1e4 um3/J, for law = "energy"
  K, dimensionless   k = K / H with the hardness H in MPa (9.81 times HV)

calibrate{} computes k (specific wear rate) from measured volumes (mass loss divided by density); there is no table of typical values.
A coefficient measured on one body belongs to this body: wear{ k_plate = 1e-8, k_cylinder = 0 }
if the cylinder does not wear.

Columns of run files have units in their names (half_width_mm); the view `units` lists them.]] },

  { "glossary", [[
Terms, each with its symbol in the paper and its unit in brackets. Equation numbers in the help refer to this paper: Mattei and Di Puccio,
"Influence of the wear partition factor on wear evolution modelling of sliding surfaces". In the help and in names of results, "cylinder" is
the upper body and "plate" the lower body, whatever their shapes; results also have the names of the bodies, such as w.depth.ball.

  alpha          [alpha] wear partition factor k_c / (k_c + k_p): the upper
                 body's share of the wear; 0 to 1
  alpha-tilde    depth partition factor: largest depth of the cylinder divided
                 by the sum of the largest depths of both bodies
  approach       rigid displacement of one body towards the other [mm]
  cycle          one period of the motion; [N] is the number of cycles
  depth          [h] wear depth, normal to the surface [mm]; [h_c], [h_p] of
                 the cylinder and of the plate
  distance       [d] travelled distance, both strokes counted [mm]; its value
                 at the end of the run is [d_t]
  E_star         [E*] contact modulus [MPa]
  gross slip     the whole contact slips; partial slip: only its edges do
  half width     [b] half the width of the contact [mm]; [a] if unworn
  increment      one of [n_c] parts of a cycle, with one contact problem each
  jump           [N-bar] number of cycles of one update
  k              [k] wear coefficient of the couple, volume per force and
                 distance [mm2/N]; [k_c], [k_p] of one body
  load           [L_N] normal force [N]
  mu             coefficient of friction, the field friction
  p_center       [p_max] pressure at the centre of the contact [MPa], [p_H] if
                 unworn. In archard, p_max is the largest pressure with the
                 plate at x = 0, p_peak the largest pressure in a cycle
  procedure      [SP] simulates the stroke by increments; [NSP] solves one
                 contact problem per update
  radius         [R] of the cylinder [mm]
  ripple         sawtooth of the surfaces due to a jump above the stability
                 limit
  scar           worn part of a surface
  slip           [s] relative tangential displacement of the surfaces [mm]
  stick zone     part of the contact that does not slip, contact.stick
  stroke         [s_t] distance between the ends of the motion [mm]
  strokes        [r] number of strokes in a cycle, 2 or 1
  thickness      [t] of the bodies along z [mm]
  update         one change of the geometry by wear; [n_u] is the number of
                 updates
  volume         [V] wear volume [mm3], V = k L_N d
  wear box       regular elements below the surface, whose nodes move with the
                 wear
  zone           contact zone: the part of a surface with small elements]] },

  { "axisymmetric", [[
model{ geometry = "axisymmetric" } defines bodies of revolution about a vertical axis: a cylinder becomes a ball, a block a disc, and
a punch a pin with a flat end. Loads are total forces, volumes [mm3] are those of the whole circumference, and half_width is the radius
of the contact. With axis = 40 the axis is 40 mm left of x = 0, and 40 mm is the mean radius of a thrust ring.

The contact has a fixed position, and the bodies slide along z, the circumferential direction. wear{} therefore needs slide = "z" and one of these:

  alpha = 1        a pin on a disc: all points of the pin slide the same
                   distance, and the disc does not wear
  track = 20       a pin on a disc, where a cycle is a revolution at a radius
                   of 20 mm. The disc may wear too and remains flat: its depth
                   is the mean over the track, which is as wide as the contact
  spin = 1         rotation about the axis: the slip at the radius r is r/spin
                   times the stroke; with spin = 1 a distance of 1 mm means a
                   rotation of 1 rad
  model.axis > 0   a ring: all points of the ring slide the same distance;
                   with spin the distance grows with r

  w = wear{ model = { geometry = "axisymmetric" }, load = 50, slide = "z",
    alpha = 1, track = 20, cycles = 1000 }

Strokes along x, friction in the section, holes, a thickness, and profiles that differ at x and -x are refused. A mesh from Gmsh must contain
both halves of the section, with mesh lines on the axis. With spin the pressure on the axis grows without limit as the bodies wear.

For thin plates use geometry = "plane stress".]] },
  { "running in", [[
New surfaces often wear faster at first. Define k as a function of the state, or as a table over the distance:

  k = function(state) return 1e-8 + 4e-8 * math.exp(-state.distance / 100) end
  k = { distance = { 0, 200, 1320 }, value = { 5e-8, 1e-8, 1e-8 } }

Functions and tables are integrated over every update; an update ends at a jump of a table. A function with a short peak (0.1 mm of
1320 mm) may be sampled only beside it; use a table. alpha can be a function or a table too. For short
steps while k decreases and long ones afterwards keep jump = "auto", the default. calibrate{}
computes such tables from volumes measured at several distances. See help "state" and examples "running_in".]] },
  { "files", [[
  w:save, wear.open           complete runs, which can be continued
  s:run{ file= }, study.open  cases of a study, stored one by one
  session.save, session.open  runs, models, studies, values by name
  export.csv, .vtk, .inp      tables, fields, input decks for other programs
  csv.read                    measured loadings and profiles
  plot{ ..., file= }          pictures: .png, .svg, .pdf, .eps, .txt
  plot.save                   the last picture, and its data as CSV

Run files are SQLite databases: sqlite3 run.archard "select * from history_of". Files of older releases can be continued.
If the program is killed, a run that was not saved is lost: help "wear.save". Studies store each finished case.
Functions of a definition are not stored; give them again when the file is opened. examples "files" shows most formats. The
prompt offers to save a session with unsaved runs before it ends.]] },
  { "meshes", [[
model{} meshes both bodies and condenses their stiffness to the surface nodes, once for all contacts and runs. Elements in the
contact zone are mesh.size wide and mesh.height high; outside they are larger, up to mesh.far. By default the half width of the
expected contact, whose estimate includes layers, has 5.4 elements (10.8 for a ball). In these cases the elements are smaller,
with at least this number of elements:

  5.4   in each rounded edge of a punch
  8     in each wave of a rough profile, 5 in each spot that touches
  27    in the half width of contact{} with friction (40 cells in 3-D)
  5     in each slip zone of wear runs with friction

mesh.fineness = 2 halves the size. If you set mesh.size, use at least four elements per half width, which hertz{} computes.
plot.mesh(m, { zoom = "wear box" }) shows the elements.

mesh.zone is the full width of the contact zone of each body, automatic by default. If a scar outgrows the zone or the wear box,
the run continues on new meshes with a message; automatic elements grow with the scar without one, and print(w) shows their size; contact{ model=m } is solved on wider meshes too, with a warning.
In 3-D the cells of a run double when its contact is 2.5 times as wide as at first, unless mesh.size, friction, layers or a map determine them.
study.converge{} searches for the size, the jump and the increments of a case. Pressures at edges of scars (p_max, p_peak) grow as the mesh is refined; p_average converges.]] },
  { "gmsh", [[
model{ mesh = "pair.msh" } reads both bodies from a Gmsh file: text, version 4.1 or 2.2, in mm and in the plane z = 0,
triangles and quadrilaterals of first order. Physical groups name the parts:

  upper, lower      surfaces: the bodies, in contact without load; upper is
                    the cylinder of other models, lower the plate
  upper.contact     the curve that may touch the other body, in one piece and
                    with one y for each x; the same for lower.contact
  upper.fixed       curves that are fixed or on the rigid base; the same for
                    lower.fixed
  upper.NAME        surfaces of another material, up to 4 materials; the same
                    for lower.NAME

The bodies must not share points, even in the contact. Errors name the element or node and its coordinates. Materials are assigned by
the names of their groups; where a material is at the surface, it wears with its own k. Elements without a name have the body's own
E, nu and k:

  model{ mesh = "pair.msh", upper = body.gmsh{ name = "roller", E = 210e3,
    materials = { coating = { E = 400e3, k = 1e-9 } } } }

For a pin in a hole, define the shapes as well: upper = body.disc{ radius= }, lower = body.ring{ inner=, outer= }, with materials if
needed. Other shapes are refused. model{ radius= } is used in estimates; it is by default the radius of the unworn gap. Imported meshes have no wear box, so
they need wear{ geometry = "frozen" }. Run files, studies and sessions contain the mesh. export.msh writes meshes by archard;
examples/gmsh_pair.geo is an example for Gmsh:

  gmsh -2 -order 1 -format msh41 -o gmsh_pair.msh gmsh_pair.geo]] },
  { "steps", [[
One update of the geometry represents many cycles (cycle jump). These fields of wear{} set the number of cycles:

  jump = "auto"        default: the lengths of the steps follow an estimate
                       of their error, which tolerance (1e-3) limits. The
                       steps are implicit or, for example with friction,
                       explicit: see scheme
  scheme = "explicit"  explicit steps of several stages
  jump = 50            explicit steps of 50 cycles. For elements of 20 um, the
                       paper uses 100 cycles in most cases with a stroke of
                       0.11 mm, and 20 to 50 cycles for longer strokes

A fixed jump above a stability limit causes ripples, which make the surfaces rough; w:stability() computes the limit. A run above
the limit prints a warning and ends when ripples appear. The limit decreases with longer strokes and smaller elements. A jump below
the limit may still be too long: compare with a run with half the jump.

increments is the number of parts of a cycle; with "auto" the plate moves by at most an eighth of the half width in each part.
w:step() makes one update, w:run() all updates; Ctrl-C stops after the current step, and w:run() continues. examples "steps" compares the choices.]] },

  { "coating", [[
A coating is a layer of a body, with a thickness in mm and a material with its own E, nu and k. The body below it has its own k.
Example: 2 um of DLC on a steel plate, worn until the coating is worn through, and then to the end of the run:

  dlc = material{ name="DLC", E=200e3, nu=0.25, k=2e-9 }
  w = wear{ load=100, stroke=0.2, distance=6000, model={
      lower=body.block{ k=2e-8,
        layers={{ thickness=2e-3, material=dlc }} } } }
  w:run{ depth={ plate=2e-3 } }
  print(w.distance, w.cycle)     -- mm and cycles until it is worn through
  w:run()                        -- the body wears below the coating
  plot.profile(w)

layers lists up to four layers from the surface inwards; layers={{ ... }} of the upper body coats the cylinder. Bodies of
geometry = "3-D" have layers too. s:failure{} computes the scatter of this life for uncertain thickness and k. See examples
"coating_wear_through", "coating", "coating_3d"; the first has a hard coating on a soft body, the last a ball.]] },

  { "pin on disc", [[
A ball on a rotating disc in three dimensions; both wear, and the disc gets a track:

  w = wear{ model={ geometry="3-D", upper=body.ball{ radius=3 },
      lower=body.block{} }, load=5, track=10,
      k_cylinder=2e-9, k_plate=2e-8, cycles=1000 }
  w:run()
  print(w.depth.ball, w.depth.block, w.volume.ball, w.volume.block) -- mm, mm3
  plot.profile(w)                -- sections along and across the motion

track is the mean radius of the track in mm; a cycle is a revolution, so a distance d in mm is cycles = d / (2 * math.pi * track).
k_cylinder is the wear coefficient of the pin, k_plate that of the disc, in mm2/N (help "units").

Without E and nu bodies are of steel, 200 GPa and 0.3; body.ball{ radius=3, E=310e3, nu=0.23 } is one of ceramics. Speed is not used:
results depend on the distance.

A pin with a flat end of 4 mm, with edges of radius 0.5 mm:

  w = wear{ model={ geometry="axisymmetric",
      upper=body.punch{ flat=4, radius=0.5 }, mesh={ size=0.1 } },
      load=50, slide="z", track=20, k_cylinder=1e-7, k_plate=1e-8,
      cycles=1000, scheme="implicit" }

A warning about the edges concerns the pressures of the unworn pin; with elements a sixth as wide the final depth is 0.5 % smaller. The
disc remains flat: its depth is the mean over the track. With alpha = 1 only the pin wears. A flat pin in reciprocating motion is
body.punch on body.block in a plane section, with a stroke; see help "body.punch" for the largest depth. See help "axisymmetric". k from
measured volumes: calibrate{}. See examples "pin_on_disc_3d".]] },

  { "measured surface", [[
A trace of a profilometer is read by profile.read, a measured area by map.read. Both remove tilt, outliers and missing points, and
convert units to mm. A trace is a text file with two columns; the first line has their names and units:

  x [mm],z [um]
  -0.800,10.8137
  -0.799,10.8022

To compare a run with a measured scar:

  p = profile.read("trace.csv"):depth()    -- depths below the unworn surface
  print(p:volume().area, w.volume.plate)   -- area [mm2], volume [mm3]
  plot.profile(w, "plate", { measured=p })

To start a run with measured surfaces:

  w = wear{ worn={ plate=p }, load=100 }   -- depths on the default plate
  lower = body.profile{ y=profile.read "shape.csv" }   -- shape of a body, 2-D
  ball = map.read("ball.sdf", { level="sphere", fill=true })
  upper = body.map{ y=ball, radius=5 }                 -- shape in 3-D

The bodies are then used in model{ upper=, lower= }; body.map needs geometry = "3-D". fit{ data= } finds k and alpha from profiles and
maps. Files of .x3p and .gwy are not read; save them as .sdf or .gsf. See examples "measured_profile", "rough_ball", "fit_scar".]] },

  { "wear rate", [[
A run computes wear volumes and depths; plot.history(w, "volume_plate") draws a volume over the distance, and w.history has all columns.
The rate is a difference of two updates; for the volume of the plate in mm3 per mm of sliding:

  d, v, rate = w.history.distance, w.history.volume_plate, { 0 / 0 }
  for i = 2, #d do rate[i] = (v[i] - v[i - 1]) / (d[i] - d[i - 1]) end
  plot{ { x=d, y=rate }, xlabel="distance / mm", ylabel="rate / mm²" }

Divided by the load it is k, the specific wear rate in mm2/N: 1e-8 mm2/N = 1e-5 mm3/(N m). The time of a cycle count at f Hz is
cycles / f seconds.]] },
  { "continue", [[
At the prompt, Ctrl-C stops a run after its present step, and w:run() continues it. A script is ended by Ctrl-C or killed; what it
did not save is lost. To continue in another session:

  w:save("run.archard")              -- writes the run to a file
  w = wear.open("run.archard")       -- later: reads it
  w:run()                            -- continues with the same results
  w:run{ cycles=20000 }              -- continues a finished run

A run is stored only by w:save. To store it regularly, in a script too, for example each 1000 cycles:

  for n = 1000, 20000, 1000 do w:run{ cycles=n } w:save("run.archard") end

s:run{ file= } stores each case of a study when it ends; after an interruption study.open(file):run() computes the rest.
session.save("s.archard") stores all objects of the prompt, session.open("s.archard") restores them.]] },

  { "prompt", [[
The prompt runs Lua 5.4; its history of inputs is kept between sessions. An expression is printed, and its value is in _ . A table or a loop can have several lines; a local variable
exists only in its own input. Tab completes names and fields; the arrow keys recall earlier inputs, Ctrl-R searches them.

  help "jump"   ?jump       explains a name; help "fretting map" any words
  who()                     lists the objects of the session
  !ls                       runs a command of the system
  clear                     clears the screen
  w = nil                   deletes an object
  Ctrl-C                    stops a run after its step; w:run() continues it
                            (a script is ended)
  Ctrl-D   quit   exit      exits, after a question if results are not saved

There is no undo: w2 = w:clone() before a change keeps the state of a run, w:set changes fields, and session.save stores all objects.
Errors of scripts name the file and the line; print shows any value. archard script.lua runs a script without the prompt.]] },

  { "fretting", [[
Fretting is a motion so short that the elastic deformation is as large as the slip, so friction matters. Example: a cylinder
is pressed with 100 N on a plate, which is moved by an oscillating force of 30 N:

  w = wear{ friction=0.6, tangential=30, load=100, k=1e-8, cycles=1e5 }
  w:run()
  print(w.gross, w.cycle_energy)     -- 0: partial slip; N mm in each cycle
  plot.loop(w)                       -- tangential force over displacement

tangential is the amplitude of the force, which must be less than friction times load; stroke=0.02, instead of a force, is the full motion in mm, twice the
amplitude. If the force is small, the middle of the contact sticks and only its edges slip and wear: partial slip. Beyond friction times load the whole contact
slips: gross slip, w.gross is 1. study.fretting_map{} computes both regimes for many loads and motions.

contact{ friction=, load= }:move{ x=, tangential= } computes single motions: c.stick, c:shear(), c:slip(), plot.shear, plot.slip.
In 2-D the displacement under a force includes the whole body down to its fixed side, so it grows slowly with the size of the body:
here by 5 % if width and height of the plate are doubled. Stick width and energy change by less than 0.1 %.
law = "energy" computes the wear from the friction energy. Balls on flats: geometry = "3-D" in the model. See examples
"fretting_loop", "fretting_ball", "fretting_map", "mccoll".]] },

  { "limits", [[
Bodies are linear elastic with small strains; each body and layer has E and nu. Materials are defined by their numbers, such as
material{ E=3600, nu=0.4, name="PEEK" }; there is no library of materials.

Plastic flow is not simulated, also not at the peaks of rough surfaces, and causes no warning: compare the largest von Mises stress
with the yield stress (help "contact.stress"). A plasticity index is not computed.

Not simulated are debris and third bodies, lubrication, humidity, heat and temperature, adhesion, seizure and scuffing. Known effects
on wear can be included in k: a number for each body, a function of distance, or local_factor, a function of pressure and position. k
is a measured value for abrasive or adhesive wear. In 3-D, each layer wears with its own k, and the compliance is computed for the
unworn layers.

Not simulated are creep (except as a function in joint{}), viscoelastic and anisotropic materials, cracks and fatigue (exported
stresses can be used in criteria such as SWT or Dang Van).

Results depend on sliding distance, not on speed or frequency; therefore PV limits are not predicted. Forces of inertia and impacts
are not simulated.

Rolling is not simulated. For gears, cams and rolling bearings, one point of the surface can be computed: a cylinder on a plate with
radius = 1/(1/R1 + 1/R2), the load at this point, and as stroke the distance by which the surfaces slide while it is in contact.

Bodies in 3-D are half-spaces: the contact must be small compared with the radii. A half width above a fifth of the radius causes a warning. For
conforming bodies use joint{} (a ball in a socket) or a pin in a bush in 2-D: examples "pin_in_bush". Bodies do not tilt under
load; a misaligned flat or roller (edge loading) is a sloping profile, body.profile{ y=function(x) return 1e-3 * x end }.

Ra, Rq and other parameters of profiles are computed (profile.roughness), but no areal parameters such as Sq. There is no generator
of random rough surfaces; a function y(x, z) in map{} can add waves, as in examples "rough_ball".

Wear is a volume in mm3: the mass loss divided by the density. For example, 1 mg of steel (7.85 g/cm3) is 0.127 mm3. Convert a measured
mass loss to a volume for calibrate{}.]] },

  { "accuracy", [[
Errors of a run are due to the mesh, to the steps, and to the data. To estimate these errors:

  mesh    repeat the run with model = { mesh = { fineness = 2 } }; the change
          of a depth is about its error
  steps   set tolerance = 1e-4, a tenth of the default; with explicit
          steps, halve a fixed jump or compare with scheme = "implicit"
  both    study.converge{ base = {...} } searches for the size and the jump

On automatic meshes with automatic steps, depths of homogeneous bodies without friction have errors below 1 % in the tests of
archard, usually below 0.1 %. Pressures at edges of scars (p_max, p_peak) grow as the mesh is refined. A warning is printed if the
mesh does not resolve friction or a layer. An unworn contact{} on its automatic mesh can be compared with hertz{}. Measured values
have errors too: w:sensitivity{} shows the effect of a change of k, load or E, study{ sample = } the scatter of results, and fit{}
the standard errors of k and alpha.]] },

  { "run time", [[
Typical times on one core: 0.03 s for 6000 cycles of a cylinder on a plate, 2 s for 6000 mm of a ball of 5 mm on a flat in 3-D.
A long run prints its progress and the remaining time; Ctrl-C keeps the last complete step.

To estimate a run, make one update with time(function() w:step() end). The number of updates depends on the wear, not on the
number of cycles. Runs are faster with

  mesh                    model = { mesh = { fineness = 0.5 } }: elements
                          twice as large, for first results; long strokes
                          in 3-D need a tenth of the time
  geometry = "frozen"     the mesh does not change: for wear that is small
                          compared with layers and radii
  a larger tolerance      with implicit steps, the default without friction
  fewer increments        if the stroke is long, see help "increments"
  workers = 2             threads of a 3-D run; s:run{ workers = 4 } computes
                          cases of a study at the same time]] },

  { "citation", [[
To cite archard, use the file CITATION.cff of its sources. Please cite the paper whose method archard computes, too:

  L. Mattei and F. Di Puccio, Influence of the wear partition factor on wear
  evolution modelling of sliding surfaces

The help calls it the paper, and the numbers of equations are those of this paper.]] },

  { "warning", [[
A warning is printed once, and the run continues. The most frequent warnings, in short:

  past the stability limit     the jump is too long: help "steps"
  outgrows its mesh            the run continues on new meshes; nothing to do
  k = 1e-5 mm2/N: was 1e-8 meant?
                               k was probably given in mm3/(N m): help "units"
  cells or elements too large  the friction or a layer is not resolved: use a
                               smaller mesh.size, or omit it
  contact beyond half-spaces   in 3-D the half width exceeds a fifth of the
                               radius: results are approximate

A study stores the warning of each case; case.warning is the text. A single run prints its
warnings but does not store them. An error, in contrast, stops the call and changes nothing.]] },

  { "3-D", [[
model{ geometry = "3-D" } has balls, crowned rollers, ellipsoids, and measured or computed maps on flats, as elastic half-spaces. x is the
direction of the motion, y is up, z is across. A ball on a flat:

  w = wear{ model = { geometry = "3-D", upper = body.ball{ radius = 5 },
      lower = body.block{} }, load = 5, stroke = 2, k = 1e-8, cycles = 1000 }
  w:run()
  print(w.depth.ball, w.depth.block, w.volume.block)   -- mm, mm3
  plot.map(w, { body = "block" })

track = 20 makes the flat a disc with a track of radius 20 mm. Friction and fretting have the fields friction and tangential.
map.read and body.map are for measured topographies, w:profile("block", { z = 0 }) is a section, and export.vti and export.pvd write
files. See examples "ball_on_flat",
"pin_on_disc_3d", "fretting_ball", "rough_ball".]] },

  { "troubleshooting", [[
"no global 'x'": no value has the name x. rawget(_G, "x") returns nil without an error. With archard --lax, all unknown names
are nil.

"no field ... did you mean ...": an object has no such field or method. help(wear) lists the fields and methods of a run.

Rough profiles, ripples, sawtooth or oscillating pressures from node to node: the jump is above the stability limit. Use jump = "auto",
or a jump below w:stability(). See help "steps".

Zone too narrow: omit the model in contact{}, or increase the mesh.zone named in the message. Runs enlarge the zone automatically.

Too coarse for the contact: fewer than four elements per half width. Give a smaller mesh.size, or omit it; see help "meshes".

A contact, step or fit that does not converge raises an error that describes the problem. For a contact, check the units and the
shape of worn surfaces. For a step, use shorter steps, or jump = "auto". For a fit, use better start values, bounds, or fewer
unknowns. To check if mesh and steps are fine enough, use study.converge{}, or compare with mesh.fineness = 2.

Out of memory: print(m.bytes) shows the memory of a model in bytes. Use larger elements (mesh.size) or, in 3-D, larger cells and fewer
increments; in a study fewer workers, s:run{ workers=2 }, because each has its own model.

Slow runs: time(function() w:step() end) measures a step. Use larger elements, fewer increments, longer steps. Studies use all
processors by default.

No picture: install gnuplot. plot{ ..., file = "p.png" } draws to a file; plot.default.term chooses the terminal.]] },
}
