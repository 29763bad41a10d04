-- Tests unknown names: misspelt globals, fields and methods of objects and of tables give errors with the
-- nearest name. Names that Lua programs usually test for still give nil.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, fails, holds = tap.ok, tap.is, tap.fails, tap.holds

-- --- globals -------------------------------------------------------------------------------------

stroke = 0.2
fails(function() return wear{ stroke = strok } end, { "strict.lua:10: ", "no global 'strok'; did you mean 'stroke'?" },
  "a misspelt global raises an error")
fails(function() return quite_another_thing end, "no global 'quite_another_thing'",
  "an unknown global without a similar name")
fails(function() plott{} end, "did you mean 'plot'?", "a call of a misspelt global")
is(rawget(_G, "strok"), nil, "rawget of an unknown global")
nothing = nil
is(nothing, nil, "a global that was assigned nil can be read")
stroke = nil
is(stroke, nil, "a global set to nil can be read")
local function declare() inner = 3 end
declare()
is(inner, 3, "a global assigned in a function can be read")
is(_ or unpack or jit or setfenv, nil, "names by which Lua programs detect their version")
is(load("return strok", "=own", "t", {})(), nil, "environments of the user are not checked")
local count = 0
for _ in pairs(_G) do count = count + 1 end
ok(count > 30, "the globals can be listed")

-- --- objects -------------------------------------------------------------------------------------

local m = model{ mesh = { size = 0.04, height = 0.05 } }
local w = wear{ model = m, increments = 8, jump = 10 }
local row = w:step(2)
local c = w:contact()
local rubbed = contact{ model = m, friction = 0.3 }
local name = os.tmpname()
local file <close> = io.open(name, "w")
file:write("distance,k\n1,2\n")
file:flush()
local columns = csv.read(name)
os.remove(name)
local s = study{ vary = { alpha = { 0.25, 0.5 } } }
for _, each in ipairs{
  { function() return material{}.e_star end, "material: no field 'e_star'; did you mean 'E_star'?" },
  { function() return hertz{}.pmax end, "hertz: no field 'pmax'; did you mean 'p_max'?" },
  { function() return m.radios end, "model: no field 'radios'; did you mean 'radius'?" },
  { function() return m.mesh.plat end, "model.mesh: no field 'plat'; did you mean 'plate'?" },
  { function() return m.mesh.plate.node_count end, "mesh: no field 'node_count'" },
  { function() return w.p_centre end, "wear: no field 'p_centre'; did you mean 'p_center'?" },
  { function() w:runn() end, "wear: no field 'runn'; did you mean 'run'?" },
  { function() return c.pmax end, "contact: no field 'pmax'; did you mean 'p_max'?" },
  { function() return c:stress().cilinder end, "stress: no field 'cilinder'; did you mean 'cylinder'?" },
  { function() return c:stress().plate.mise end, "stress: no field 'mise'; did you mean 'mises'?" },
  { function() return s:caes() end, "study: no field 'caes'; did you mean 'cases'?" },
  { function() return s:cases()[1].p_centre end, "case: no field 'p_centre'; did you mean 'p_center'?" },
  -- fields of tables that objects return
  { function() return w.depth.cilinder end, "wear.depth: no field 'cilinder'" },
  { function() return w.volume.sum end, "wear.volume: no field 'sum' (known: cylinder, plate, total)" },
  { function() return w.history.p_centre end, "history: no field 'p_centre'; did you mean 'p_center'?" },
  { function() return row.p_centre end, "record: no field 'p_centre'; did you mean 'p_center'?" },
  { function() return w:profile("plate").depth end, "wear:profile: no field 'depth'" },
  { function() return w:pressure().P end, "pressure: no field 'P'; did you mean 'p'?" },
  { function() return w:combined().hh end, "combined: no field 'hh'" },
  { function() return w:stability().jumplimit end, "did you mean 'jump_limit'?" },
  { function() return m.mesh.plate:quality().aspekt end, "did you mean 'aspect'?" },
  { function() return rubbed.stick[1].lefft end, "zone: no field 'lefft'; did you mean 'left'?" },
  { function() return c.edges.rigt end, "zone: no field 'rigt'; did you mean 'right'?" },
  { function() return m.mesh.zone.plat end, "zone: no field 'plat'; did you mean 'plate'?" },
  { function() return plot.style().widht end, "plot.style: no field 'widht'; did you mean 'width'?" },
  { function() return columns.distanc end, "csv.read: no field 'distanc'; did you mean 'distance'?" },
  -- fields of Lua's own libraries
  { function() return math.sqr(2) end, "math: no field 'sqr'; did you mean 'sqrt'?" },
  { function() return string.fromat("%d", 1) end, "string: no field 'fromat'; did you mean 'format'?" },
  { function() return ("a"):uper() end, "string: no field 'uper'; did you mean 'upper'?" },
  -- functions of the program
  { function() plot.presure(w) end, "plot: no field 'presure'; did you mean 'pressure'?" },
  { function() export.cvs(w, "w.csv") end, "export: no field 'cvs'; did you mean 'csv'?" },
  { function() study.papr() end, "study: no field 'papr'; did you mean 'paper'?" },
  { function() help(wear.run) end, "wear: no field 'run' (known: open); for methods of the objects that wear{} makes: help \"wear.run\"" },
  { function() wear.opn "x" end, "wear: no field 'opn'; did you mean 'open'?" },
  { function() return require "archard".hertzz end, "did you mean 'hertz'?" },
} do
  fails(each[1], { "strict.lua:", each[2] }, each[2])
end
is(math.mod or table.getn or string.gfind, nil, "library names of other Lua versions")
is(plot.style().width, nil, "an unset option of a style")
is(s.file, nil, "a field without a value is nil")
is(s:cases()[1].message, nil, "the message of a case that did not fail")
is(w.history.distance[9], nil, "an index beyond the end of a list is nil")
is(#w.history.distance .. " " .. table.concat(w.history.distance, " "), "3 0.0 2.2 4.4", "a column of the history is a list")
local kept = 0
for _ in ipairs(w.history.distance) do kept = kept + 1 end
is(kept, 3, "ipairs of a column of the history")

-- --- as text -------------------------------------------------------------------------------------

is(tostring(hertz{}.cylinder), "material: E 200000 MPa, nu 0.3, E_star 219780 MPa", "print of a material")
is(tostring(w.history.distance), "{ 0, 2.2, 4.4 }", "print of a list is shown as at the prompt")
holds(tostring(w.depth), { "{ cylinder = ", "plate = " }, "print of a table with bodies")
holds(tostring(w:profile("plate")), { "worn_x = { ", " items)" }, "long lists are shortened")
fails(function() return body.pin{} end,
  "body: no field 'pin': a pin is a body.punch{}, a body.ball{} or a body.cylinder{}",
  "body.pin suggests other bodies")
