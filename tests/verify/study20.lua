-- The twenty cases of the paper: invariants, final values, findings; and their figures.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/../lua/lib/tap.lua")
local ok, near, holds = tap.ok, tap.near, tap.holds

local folder = os.tmpname()
os.remove(folder)
assert(os.execute("mkdir " .. folder))

local s = study.paper():run{ workers = 2, file = folder .. "/study", progress = false }
local cases = s:cases()
local function case_of(stroke, alpha)
  for _, case in ipairs(cases) do
    if case.stroke == stroke and case.alpha == alpha then return case end
  end
end

-- --- invariants --------------------------------------------------------------------------------
local worst_volume, worst_share, worst_mirror, done = 0, 0, 0, 0
for _, case in ipairs(cases) do
  if case.status == "done" then done = done + 1 end
  worst_volume = math.max(worst_volume, math.abs(case.volume.total / 1.32e-3 - 1))
  worst_share = math.max(worst_share,
    math.abs(case.volume.cylinder / case.volume.total - case.alpha))
  for _, body in ipairs{ "cylinder", "plate" } do
    local p, h = case:pressure(body).p, case:profile(body).h
    for i = 1, #p do
      worst_mirror = math.max(worst_mirror, math.abs(p[i] - p[#p + 1 - i]) / case.p_max,
        math.abs(h[i] - h[#h + 1 - i]) / 3.5e-3)
    end
  end
end
ok(done == 20, "all cases are done")
ok(worst_volume < 1e-9, ("every volume is k L d (to %.1e)"):format(worst_volume))
ok(worst_share < 1e-9, ("the cylinder's share of it is alpha (to %.1e)"):format(worst_share))
ok(worst_mirror < 1e-8, ("mirror images about x = 0 (to %.1e)"):format(worst_mirror))

-- --- final values: an independent solution of the same problem -----------------------------------
for _, row in ipairs(dofile(here .. "/lib/finals.lua")) do
  local case = case_of(row[1], row[2])
  local name = ("s = %g, alpha = %g: "):format(row[1], row[2])
  near(1e3 * case.depth.cylinder, row[3], 0.003, name .. "depth of the cylinder")
  near(1e3 * case.depth.plate, row[4], 0.003, name .. "depth of the plate")
  near(case.p_center, row[5], 0.01, name .. "pressure at the centre")
  if row[6] then
    local course = case.history.depth_partition
    local sum = 0
    for i = 2, #course do sum = sum + course[i] end
    near(course[2], row[6], 0.02, name .. "first alpha-tilde")
    near(sum / (#course - 1), row[7], 0.02, name .. "mean alpha-tilde")
    near(course[#course], row[8], 0.02, name .. "last alpha-tilde")
  end
end
near(1e3 * case_of(20, 0.25).depth.plate, 0.0495, 1e-9, "2R: the plate wears evenly")
near(case_of(20, 0).p_center, hertz{}.p_max, 1e-9, "2R, alpha = 0: Hertz' pressure stays")

-- --- findings ------------------------------------------------------------------------------------
local reference = case_of(0.11, 0.5)
local fall = 1 - reference.p_center / reference.history.p_center[1]
ok(fall > 0.63 and fall < 0.71, ("s = a: the pressure falls by about two thirds (%.3f)"):format(fall))
local lowest, highest = math.huge, 0
for _, alpha in ipairs{ 0, 0.25, 0.5, 0.75, 1 } do
  local sum = case_of(0.11, alpha):combined().h
  local middle = sum[(#sum + 1) // 2]
  lowest, highest = math.min(lowest, middle), math.max(highest, middle)
end
ok(highest / lowest < 1.04, ("s = a: the sum of depths hardly depends on alpha (%.3f)"):format(
  highest / lowest))
for _, alpha in ipairs{ 0.25, 0.5, 0.75 } do
  local case = case_of(0.11, alpha)
  local worst = 0
  for i = 2, #case.history.depth_partition do
    worst = math.max(worst, math.abs(case.history.depth_partition[i] / alpha - 1))
  end
  ok(worst < 0.086, ("s = a, alpha = %g: alpha-tilde within 8 %% of alpha (%.3f)"):format(alpha,
    worst))
  local over = case_of(20, alpha).history.depth_partition
  ok(over[#over] > 0.96, ("2R, alpha = %g: alpha-tilde beyond 0.96"):format(alpha))
end
local share = case_of(0.11, 0.5):local_partition()
for i, x in ipairs(share.x) do
  if math.abs(x) < 0.108 and math.abs(share.value[i] - 0.519) > 0.01 then
    ok(false, ("alpha-tilde along the surface is uniform; %.4f at %.3f mm"):format(share.value[i], x))
  end
end
local straight = case_of(0.44, 0).history
local n = #straight.p_center
local bow = straight.p_center[(n + 1) // 2] - (straight.p_center[1] + straight.p_center[n]) / 2
ok(math.abs(bow) < 0.15 * (straight.p_center[1] - straight.p_center[n]),
  "s = 4a, alpha = 0: the pressure falls almost in a straight line")

-- --- figures -------------------------------------------------------------------------------------
local trials = study.trials():run{ workers = 2, file = folder .. "/trials", progress = false }
local function size_of(path)
  local file = io.open(path)
  local text = file and file:read("a") or ""
  if file then file:close() end
  return #text, text
end
for _, each in ipairs{ { s, 6 }, { trials, 3 } } do
  local drawn = each[1]:figures{ dir = folder .. "/figures", term = { "svg" } }
  ok(#drawn == each[2], ("%d figures of study %s"):format(each[2], each[1].name))
  for _, figure in ipairs(drawn) do
    local size, text = size_of(figure.files[1])
    ok(size > 8000 and text:find("</svg>", 1, true), figure.title)
  end
end
local page = require "archard.figures.page".html{ title = "A & B", lead = "<i>",
  figures = s:figures{ dir = folder .. "/figures" } }
holds(page, { "A &amp; B", "&lt;i&gt;", 'src="fig14.svg"', "</html>" }, "a page around them")

os.execute("rm -r " .. folder)
