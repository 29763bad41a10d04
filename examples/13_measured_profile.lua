-- A profilometer's trace across a wear scar: area of the scar with its uncertainty, compared with a
-- simulated run.
--   archard examples/13_measured_profile.lua [trace.csv]
--   archard examples/13_measured_profile.lua make trace.csv    writes such a trace
-- The trace of this example is generated and not measured, so that the results can be checked: it is the
-- plate of a run with a tilt, grinding waves and noise from a seeded generator.

local settings = { stroke = 0.22, alpha = 0.4, jump = 50, distance = 660 }

local function run()
  local w = wear(settings)
  w:run()
  return w
end

-- Returns the depth of a profile at x by linear interpolation between its nodes.
local function depth_at(profile, x)
  for i = 2, #profile.x do
    if x >= profile.x[i - 1] and x <= profile.x[i] then
      local share = (x - profile.x[i - 1]) / (profile.x[i] - profile.x[i - 1])
      return profile.h[i - 1] + share * (profile.h[i] - profile.h[i - 1])
    end
  end
  return 0
end

local function make(path)
  math.randomseed(21920)
  local worn = run():profile "plate"
  local lines = { "# not measured: made by 13_measured_profile.lua make", "x [mm],z [um]" }
  for i = 0, 1600 do
    local x = -0.8 + i * 0.001
    local noise = math.sqrt(-2 * math.log(1 - math.random())) * math.cos(2 * math.pi * math.random())
    local ground = 0.03 * math.sin(2 * math.pi * x / 0.043) + 0.02 * math.sin(2 * math.pi * x / 0.017 + 1)
    lines[#lines + 1] = ("%.3f,%.4f"):format(x, 12 + 1.5 * x + ground + 0.02 * noise - 1000 * depth_at(worn, x))
  end
  local file <close> = assert(io.open(path, "w"))
  file:write(table.concat(lines, "\n"), "\n")
end

if arg[1] == "make" then return make(assert(arg[2], "expected the name of a file to write")) end

local trace = profile.read(arg[1] or (arg[0]:match("^(.*)/") or ".") .. "/13_measured_profile.csv")
local depth = trace:depth() -- below a line beside the scar
print(depth)
print()

local scar, w = depth:volume(), run()
print(("measured:  %.4g +- %.2g mm2 over %.3f mm (scatter %.2g, levelling %.2g), %.3f um deep"):format(scar.area,
  scar.error, scar.width, scar.scatter, scar.level, 1000 * scar.depth))
print(("simulated: %.4g mm2, %.3f um deep"):format(w.volume.plate, 1000 * w.depth.plate))

local rough = trace:cut(-0.8, scar.from):roughness{ cutoff = 0.08 }
print(("beside the scar: Ra %.4f um, Rq %.4f um, Rz %.3f um, of which noise %.4f um"):format(1000 * rough.Ra,
  1000 * rough.Rq, 1000 * rough.Rz, 1000 * rough.noise))

-- The contact of a plate that starts with the measured trace instead of a smooth surface. The filter
-- removes waves that are shorter than a few elements.
local start = contact{ worn = { plate = trace:filter(0.08):depth() } }
print(("pressure on the measured scar: %.1f MPa, on the simulated one: %.1f MPa (plate worn alone)"):format(start.p_max,
  contact{ worn = { plate = w:profile "plate" } }.p_max))
print()
plot.profile(w, "plate", { measured = depth, title = "Wear of the plate, simulated and measured" })
