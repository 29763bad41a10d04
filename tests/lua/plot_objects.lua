-- Tests plot.pressure, plot.profile, plot.history, plot.mesh, plot.stress and plot.animate with tables that
-- replace the engine's objects.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local pictures = dofile(here .. "/lib/pictures.lua")
local ok, has, refused = tap.ok, tap.holds, tap.fails
local folder, read, picture_of, stand_in = pictures.folder, pictures.read, pictures.picture_of, pictures.stand_in

-- --- objects ------------------------------------------------------------------------------------

local one = stand_in { alpha = 0.25, stroke = 0.11, load = 100 }
local two = stand_in { alpha = 0.75, stroke = 0.11, load = 100 }

do
  local text = picture_of(function(file) plot.pressure(one, { file = file }) end)
  has(text, "p / MPa", "plot.pressure has units")
  has(text, "contact pressure of the cylinder: s = 0.11 mm, α = 0.25", "the title shows body and settings")
  text = picture_of(function(file) plot.pressure(one, two, { file = file }) end)
  local coarse = { pressure = function()
    return { x = { -3, -1, 0, 1, 3 }, p = { 0, 300, 400, 300, 0 } }
  end }
  plot.pressure(setmetatable(coarse, {}), { file = folder .. "/z.gp" })
  local low, high = (read("z.gp") or ""):match("set xrange %[([%d.-]+):([%d.-]+)%]")
  ok(low and tonumber(low) <= -3 and tonumber(high) >= 3,
    "the x range contains the zero pressures at both sides")
  has(text, "α = 0.25", "titles of several objects show the differing setting")
  ok(text:find("α = 0.75") and not text:find("0.11"), "titles show only the settings that differ")
  text = picture_of(function(file) plot.pressure(one, "plate", { scaled = true, file = file }) end)
  has(text, "p / p_H", "scaled pressures are divided by the Hertz pressure")
  has(text, "x / a", "scaled positions are divided by the half width")
  ok(text:match("\n +1%.0 [+|]"), "the largest pressure of this plate is the Hertz pressure")
  text = picture_of(function(file)
    plot.pressure(one, two, { titles = { "before", "after" }, file = file })
  end)
  ok(text:find("before") and text:find("after"), "titles given by the user")
  refused(function() plot.pressure(one, { titles = { "a", "b" } }) end, "expected one for each of 1",
    "more titles than objects")
  refused(function() plot.pressure() end, "at least one object", "plot.pressure without an object")
  refused(function() plot.pressure(7) end, "argument 1", "plot.pressure of a number")
  refused(function() plot.pressure(one, "plat") end, '"cylinder" or "plate"', "an unknown body")
  refused(function() plot.pressure(one, { scale = true }) end, "did you mean 'scaled'",
    "an unknown option")
end

do
  local text = picture_of(function(file) plot.profile(one, { file = file }) end)
  ok(text:find("* cylinder", 1, true) and text:find("# plate", 1, true), "plot.profile draws both bodies")
  has(text, "wear depth / µm", "wear depths in um")
  local zero, two_um = text:find("\n +0%.0 [+]"), text:find("\n +2%.0 [+]")
  ok(zero and two_um and zero < two_um, "depth increases downwards")
  text = picture_of(function(file) plot.profile(one, "plate", { file = file }) end)
  has(text, "wear of the plate", "the title names a single body")
  text = picture_of(function(file) plot.profile(one, two, { file = file, size = { 100, 30 } }) end)
  ok(text:match("%(a%) cylinder +%(b%) plate\n"), "profiles of two objects have a panel for each body")
end

do
  local text = picture_of(function(file) plot.history(one, { file = file }) end)
  has(text, "pressure at the centre / MPa", "plot.history draws the centre pressure by default")
  has(text, "distance / mm", "plot.history draws over the distance by default")
  refused(function() plot.history(one, { "p_center", "p_max" }) end, 'plot.history(w, "p_center", { ... })',
    "columns in a table")
  text = picture_of(function(file)
    plot.history(one, two, "p_center", "depth_plate", "depth_cylinder", "depth_partition",
      { file = file, against = "cycle", size = { 100, 70 } })
  end)
  has(text, "pressure at the centre / MPa", "a history with several columns: panel of the pressure")
  has(text, "wear depth / µm", "a history with several columns: panel of the depths")
  has(text, "wear depth partition", "a history with several columns: panel of the depth partition")
  has(text, "plate, α = 0.75", "titles show the column and the object")
  has(text, "cycles", "a history drawn over the cycles")
  local k = function() return 1e-8 end
  local first = stand_in { k = k, jump = "auto", scheme = "explicit" }
  local second = stand_in { k = 1e-8, jump = 100, scheme = "implicit" }
  text = picture_of(function(file)
    plot.history(first, second, { file = file, size = { 120, 30 } })
  end)
  has(text, "k by function, jump auto, scheme explicit",
    "the title of a curve shows all settings that differ")
  has(text, "k = 1e-08 mm²/N, jump 100, scheme implicit",
    "the title of the other curve shows all settings that differ")
  first.history.jump = { 0, 40, 60 }
  plot.history(first, "jump", { file = folder .. "/jump.gp" })
  ok((read("jump.gp") or ""):find("END\n10 40\n20 60\nEND", 1, true),
    "the jump is drawn from the first update on")
  refused(function() plot.history(one, "p_centre") end, "did you mean 'p_center'",
    "an unknown column")
  refused(function() plot.history(one, "pressure") end, "no column 'pressure' in the history",
    "an unknown column without a similar name")
end

do
  local many = {}
  for i = 1, 10 do many[i] = stand_in { alpha = i / 10, stroke = 0.11, load = 100 } end
  many[11] = { file = folder .. "/s.gp" }
  plot.pressure(table.unpack(many))
  has(read("s.gp"), "linecolor palette cb 0.5 ", "many runs with different alpha have a colour scale")
  has(read("s.gp"), 'set cblabel "α"', "the colour scale has the label alpha")
  local sp = stand_in { stroke = 0.11, procedure = "SP", cycle = 9 }
  local nsp = stand_in { stroke = 20, procedure = "NSP", cycle = 7 }
  local text = picture_of(function(file) plot.pressure(sp, nsp, { file = file }) end)
  ok(text:find("s = 20 mm") and not text:find("SP") and not text:find("cycles"),
    "titles omit settings that follow from others")
  local a, b = stand_in { stroke = 1, cycle = 10 }, stand_in { stroke = 1, cycle = 20 }
  text = picture_of(function(file) plot.pressure(a, b, { file = file }) end)
  has(text, "20 cycles", "titles show the cycles if nothing else differs")
end

-- Tests the titles of a run whose load has changed.
do
  local changed = stand_in { alpha = 0.5, stroke = 0.11, load = 150 }
  changed.history.load = { 0, 100, 150 }
  local text = picture_of(function(file) plot.pressure(changed, { file = file }) end)
  has(text, "load 100 to 150 N", "a changed load is shown as a range")
  changed.alpha, changed.load, changed.stroke = 0.9, 10, 0.3
  changed.history.alpha, changed.history.travel = { 0.5, 0.5, 0.5 }, { 0.11, 0.11, 0.11 }
  text = picture_of(function(file) plot.pressure(changed, { file = file }) end)
  has(text, "s = 0.11 mm, α = 0.5, load 100 to 150 N", "a setting for the next update is not in the title")
  changed.history.load = nil
  local loaded = stand_in { alpha = 0.5, stroke = 0.11, load = 100, loading = {} }
  text = picture_of(function(file) plot.pressure(loaded, { file = file }) end)
  ok(text:find("α = 0.5") and not text:find("0.11") and not text:find("100 N"),
    "the title of a run with a loading shows no stroke or load")
  loaded.history.load, loaded.history.load_low = { 150, 150 }, { 50, 50 }
  loaded.history.load_reference = { 150, 150 }
  text = picture_of(function(file) plot.pressure(loaded, { file = file }) end)
  ok(text:find("load 50 to 150 N", 1, true) and not text:find "under",
    "a load that varies in a cycle is shown as a range")
  loaded.history.load_reference = { 20, 20 }
  text = picture_of(function(file) plot.pressure(loaded, { file = file }) end)
  has(text, "pressures under 20 N", "the title shows the load of the pressures if it differs")
end

for _, name in ipairs{ "pressure", "profile", "history", "stress", "mesh" } do
  for _, value in ipairs{ 5, "x", true } do
    refused(function() plot[name]{ [name] = value } end, "plot." .. name .. ": expected ",
      "plot." .. name .. " of a table whose field " .. name .. " is not a function")
  end
end
refused(function() plot.profile(one, { titles = setmetatable({}, { __len = function() return 2^61 end }) }) end,
  "field 'titles': expected a table, got a table with a __len metamethod", "a list with a __len metamethod")

-- --- meshes and fields --------------------------------------------------------------------------

-- Returns a mesh of two squares, of which the second is divided into triangles. The squares are above (side
-- 1) or below (side -1) y = 0.
local function stand_in_mesh(side)
  local x, y = { 0, 1, 1, 0, 2, 2 }, { 0, 0, side, side, 0, side }
  return { nodes = 6, rows = 1, node = function(_, i) return x[i], y[i] end,
    elements = function() return { 1, 2, 3, 4, 2, 5, 6, 0, 2, 6, 3, 0 } end,
    box = function() return { 1, 4, 2, 3, 5, 6 } end }
end
local model_ = { mesh = { cylinder = stand_in_mesh(1), plate = stand_in_mesh(-1) } }

local function stand_in_field(side)
  return { x = { 0, 1, 1, 0, 2, 2 }, y = { 0, 0, side, side, 0, side },
    ux = { 0, 0, 0, 0, 0, 0 }, uy = { 0, 0, 0, 0, 0, 0 },
    elements = { 1, 2, 3, 4, 2, 5, 6, 0, 2, 6, 3, 0 }, mises = { 0, 1, 2, 1, 2, 3 },
    sxy = { -1, 0, 1, 0, 1, 2 } }
end
local contact_ = { stress = function()
  return { cylinder = stand_in_field(1), plate = stand_in_field(-1) }
end }

do
  local text = picture_of(function(file) plot.mesh(model_, { file = file }) end)
  has(text, "mesh: 12 nodes, 6 elements", "plot.mesh shows the numbers of nodes and elements")
  ok(text:find("cylinder") and text:find("plate"), "a mesh plot shows both bodies")
  text = picture_of(function(file) plot.mesh(model_, { body = "plate", file = file }) end)
  ok(not text:find("cylinder") and text:find("plate"), "a mesh plot of one body")
  text = picture_of(function(file) plot.mesh(model_, { zoom = "wear box", file = file }) end)
  has(text, "cylinder", "a mesh plot of the wear box")
  plot.mesh(model_, { file = folder .. "/m.gp" })
  local edges = select(2, (read("m.gp") or ""):gsub("[%d%-. ]+\n[%d%-. ]+\n\n", ""))
  ok(edges == 2 * 8, "every edge is drawn once (" .. edges .. ")")
  refused(function() plot.mesh(7) end, "expected a model", "plot.mesh of a number")
  refused(function() plot.mesh(model_, { zoom = { 5, 6, 5, 6 } }) end, "no element lies in",
    "a zoom without elements")
  local x, peak, wide = {}, {}, {}
  for i = 1, 101 do x[i] = (i - 51) / 50 end
  for i, a in ipairs(x) do
    for k, b in ipairs(x) do
      peak[(i - 1) * 101 + k], wide[(i - 1) * 101 + k] = math.exp(-(a ^ 2 + b ^ 2) / 4e-3), math.exp(-(a ^ 2 + b ^ 2))
    end
  end
  for _, each in ipairs{ { peak, false, "no number hides a small contour line" }, { wide, true, "large contour lines have numbers" } } do
    plot.map(map{ x = x, z = x, y = each[1], unit = "MPa" }, { file = folder .. "/n.gp" })
    ok((read("n.gp"):find("$n0 << END\nEND", 1, true) == nil) == each[2], each[3])
  end
  refused(function() plot.mesh(model_, { zom = 1 }) end, "did you mean 'zoom'", "a misspelt option")
end

do
  local text = picture_of(function(file) plot.stress(contact_, { file = file }) end)
  has(text, "von Mises stress / MPa", "plot.stress draws von Mises' stress by default")
  has(text, "2.67 to 3", "a stress plot in characters has levels")
  text = picture_of(function(file) plot.stress(contact_, { component = "sxy", file = file }) end)
  has(text, "1.56 to 2", "highest level of a stress with both signs")
  has(text, "-2 to -1.56", "lowest level of a stress with both signs")
  plot.stress(contact_, { file = folder .. "/stress.png" })
  ok(read("stress.png"), "a stress plot in colour")
  text = picture_of(function(file) plot.stress(contact_.stress(), { file = file }) end)
  has(text, "von Mises stress / MPa", "plot.stress of a stress table")
  text = picture_of(function(file) plot.stress(wear { model = { mesh = { size = 0.04 } } }, { file = file }) end)
  has(text, "von Mises stress / MPa", "stress of a run, from its present contact")
  refused(function() plot.stress({}) end, "expected a contact, its stress() or a run",
    "plot.stress of an empty table")
  refused(function() plot.stress(material {}) end, "got a material", "a material instead of a contact")
  refused(function() plot(material {}) end, "got a material", "plot of an object names its class")
  refused(function() plot.stress(contact_, { component = "misses" }) end, "field 'component'",
    "an unknown stress component")
end

-- --- animation ----------------------------------------------------------------------------------

do
  local steps = 0
  local w = stand_in { alpha = 0.5, distance = 0 }
  local running = setmetatable({}, { __index = function(_, name)
    if name == "distance" then return 10 * math.min(steps, 5) end
    if name == "step" then return function() steps = steps + 1 end end
    return w[name]
  end })
  plot.animate(running, { what = "both", file = folder .. "/run.gif" })
  local gif = read("run.gif") or ""
  ok(gif:sub(1, 6) == "GIF89a", "plot.animate writes a gif")
  ok(steps == 6, "the animation ends with the run")
  ok(select(2, gif:gsub("\33\249\4", "")) >= 6, "the animation has a picture before and after every step")
  refused(function() plot.animate(running, { file = folder .. "/run.png" }) end, "ends in .gif",
    "an animation in a .png file")
end

pictures.remove()
