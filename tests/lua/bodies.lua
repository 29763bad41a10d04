-- Tests wear coefficients of bodies: k_cylinder and k_plate of wear{}, and k of a material.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local is, ok, near, fails, holds = tap.is, tap.ok, tap.near, tap.fails, tap.holds

local coarse = { size = 0.04 }
local w = wear{ k_cylinder = 1e-8, k_plate = 3e-8, model = { mesh = coarse } }
near(w.k, 4e-8, 1e-15, "k is the sum of both bodies' coefficients")
near(w.alpha, 0.25, 1e-15, "alpha is the cylinder's fraction of k")
near(w.k_cylinder, 1e-8, 1e-15, "w.k_cylinder")
near(w.k_plate, 3e-8, 1e-15, "w.k_plate")
w:step()
near(w.volume.plate / w.volume.cylinder, 3, 1e-9, "the volumes have the ratio of the coefficients")

local same = wear{ model = { cylinder = { k = 1e-8 }, plate = material{ k = 3e-8 }, mesh = coarse } }
is(same.model.plate.k, 3e-8, "the coefficient of a material")
holds(tostring(same.model.plate), "k 3e-08 mm2/N", "print(material)")
same:step()
is(same.p_center, w.p_center, "coefficients of materials give the same bits as k_cylinder and k_plate")
is(same.volume.plate, w.volume.plate, "the volume is the same to the bit, too")
local hard = wear{ model = { cylinder = { k = 0 }, plate = { k = 1e-8 }, mesh = coarse } }
is(hard.alpha, 0.0, "a body with k = 0 does not wear")
is(wear{ model = { cylinder = { k = 1e-8 }, mesh = coarse } }.alpha, 1.0, "a body without a coefficient does not wear")

w:set{ k_plate = 0 }
near(w.k, 1e-8, 1e-15, "w:set of one coefficient does not change the other")
is(w.alpha, 1.0, "with k_plate = 0 only the cylinder wears")
w:set{ k = function() return 2e-8 end }
w:set{ k_cylinder = 1e-8, k_plate = 1e-8 }
near(w.k, 2e-8, 1e-15, "numbers replace a function as k")

fails(function() wear{ k = 1e-8, k_cylinder = 1e-8, k_plate = 0 } end, "fields 'k' and 'k_cylinder'", "k together with k_cylinder")
fails(function() wear{ alpha = 0.5, k_plate = 1e-8, k_cylinder = 0 } end, "fields 'alpha' and 'k_cylinder'",
  "alpha together with k_cylinder")
fails(function() wear{ k_plate = 1e-8 } end, { "field 'k_cylinder'", "mm2/N", "together with 'k_plate'" },
  "k_plate without k_cylinder")
fails(function() wear{ k_plate = -1, k_cylinder = 0 } end, { "field 'k_plate'", ">= 0 mm2/N", "got -1" },
  "a coefficient below zero")
fails(function() wear{ k_plate = "1", k_cylinder = 0 } end, "field 'k_plate'", "a text as coefficient")
fails(function() wear{ alpha = 0.2, model = { plate = { k = 1e-8 } } } end, { "'alpha'", "model.plate.k" },
  "alpha together with a coefficient of a material")
fails(function() material{ k = -1 } end, "field 'k'", "a material with a coefficient below zero")

for field, expected in pairs{ diameter = "did you mean 'flat', the diameter", width = "did you mean 'flat', the width" } do
  fails(function() body.punch{ [field] = 4 } end, expected, "the " .. field .. " of a pin")
end
-- Tests element sizes: automatic sizes, fineness and limits.
fails(function() model{ mesh = { size = 0.02, fineness = 2 } } end, { "mesh.size", "mesh.fineness" },
  "element size and fineness together")
fails(function() model{ radius = 1e14 } end, { "field 'mesh.size': expected at least radius / 5e+08 = 200000 mm" },
  "too many elements to be counted")
is(model{ mesh = { size = "auto", fineness = 2 } }.mesh.size, 0.01,
  "fineness = 2 halves the reference paper's element size")
ok(contact{ model = { radius = 0.5 } }.p_center > 0, "contact of a cylinder with a small radius")
is(model{ radius = 0.5 }.mesh.far, 0.05, "the largest element size is proportional to the radius")
local copy = study{ base = { model = model{ mesh = { fineness = 0.5 } }, distance = 22 } }
local file = os.tmpname()
os.remove(file)
copy:run{ file = file, workers = 1, progress = false }
is(copy:cases()[1].status, "done", "a study of a model with an automatic mesh size")
copy:close()
os.remove(file)
-- Tests that a study keeps the fineness of a model without a mesh size.
do
  local spatial = model{ geometry = "3-D", mesh = { fineness = 0.5 } }
  local fine = study{ base = { model = spatial, load = 10, stroke = 0.1, distance = 2 } }
  fine:run{ file = file, workers = 1, progress = false }
  is(fine:cases()[1]:wear().model.mesh.fineness, 0.5, "a study in 3-D keeps the fineness of a model object")
  fine:close()
  os.remove(file)
end
