-- Tests the study of the reference paper's twenty cases: invariants, final values, findings and figures.
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
ok(worst_volume < 1e-9, ("every volume is k L d (error %.1e)"):format(worst_volume))
ok(worst_share < 1e-9, ("the cylinder's fraction of the volume is alpha (error %.1e)"):format(worst_share))
ok(worst_mirror < 1e-8, ("profiles and pressures are symmetric (error %.1e)"):format(worst_mirror))

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
near(1e3 * case_of(20, 0.25).depth.plate, 0.0495, 1e-9, "2R: depth of uniform wear of the plate")
near(case_of(20, 0).p_center, hertz{}.p_max, 1e-9, "2R, alpha = 0: Hertz' pressure does not change")

-- --- findings ------------------------------------------------------------------------------------
local reference = case_of(0.11, 0.5)
local fall = 1 - reference.p_center / reference.history.p_center[1]
ok(fall > 0.63 and fall < 0.71, ("s = a: the pressure decreases by about two thirds (%.3f)"):format(fall))
local lowest, highest = math.huge, 0
for _, alpha in ipairs{ 0, 0.25, 0.5, 0.75, 1 } do
  local sum = case_of(0.11, alpha):combined().h
  local middle = sum[(#sum + 1) // 2]
  lowest, highest = math.min(lowest, middle), math.max(highest, middle)
end
ok(highest / lowest < 1.04, ("s = a: the sum of depths is almost independent of alpha (%.3f)"):format(
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
  ok(over[#over] > 0.96, ("2R, alpha = %g: alpha-tilde exceeds 0.96"):format(alpha))
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
  "s = 4a, alpha = 0: the pressure decreases almost linearly")

-- --- findings of examples/paper/findings.lua ---------------------------------------------------------------
local part = require "archard.lib.examples_folder".parts("study20", "paper")
local findings = part "findings"
local share = findings.partition(case_of(0.11, 0.25))
near(share.off, 0.0855, 0.02, "s = a, alpha = 0.25: alpha-tilde differs from alpha by up to 8.6 %")
near(share.mean, 0.268, 5e-3, "s = a, alpha = 0.25: mean of alpha-tilde")
near(findings.sum_spread(cases, 1), 0.0334, 0.03, "s = a: the sum of depths varies over alpha by 3.4 %")
near((findings.swap(cases, 1)), 0.106, 0.03, "s = a: depths with exchanged bodies differ by up to 10.6 %")
near(findings.pressure_spread(cases, 1), 235.3 / 185 - 1, 0.03,
  "s = a: centre pressures vary over alpha by 28 %")
local compared = findings.compared{ { title = "here", cases = cases } }
local columns, numbers = #compared[1], 0
for i, row in ipairs(compared) do
  if #row ~= columns then ok(false, "the comparison's row " .. i .. " has " .. #row .. " columns") end
  local got, known = row[3]:match("^[%d.]+"), row[4]:match("^[%d.]+")
  if i > 1 and got and known and row[1]:find("depth of the", 1, true) then
    numbers = numbers + 1
    near(tonumber(got), tonumber(known), 0.003, "archard against the independent solution: " .. row[1])
  end
end
ok(numbers >= 3, "the page compares at least three depths")
ok(#findings.finals{ { title = "here", cases = cases } } == 31,
  "the table of final values has three rows per case")
local table_1 = findings.table_1(cases)
ok(#table_1 == 21, "Table 1 has a row for each case")
for i, head in ipairs(table_1[1]) do
  if head:find "^Δh" then
    ok(table_1[2][i] == "0.10" and table_1[18][i] == "0.12", "first depths by Eq. (28) in Table 1")
  end
end

-- --- the integration rule determines the symmetry ----------------------------------------------------
local trials = study.trials():run{ workers = 2, file = folder .. "/trials", progress = false }
local function lopsided(increments, jump, rule, body)
  for _, case in ipairs(trials:cases()) do
    if case.increments == increments and case.jump == jump and case.rule == rule then
      return findings.asymmetry(case, body)
    end
  end
end
for increments, expected in pairs{ [16] = 0.10, [40] = 0.040, [100] = 0.016, [200] = 0.008 } do
  local what = ("n_c = %d: "):format(increments)
  near(lopsided(increments, 100, "simple", "plate"), expected, 0.03,
    what .. "asymmetry of the plate by Eq. (5)")
  ok(lopsided(increments, 100, "simple", "cylinder") < 1.2e-4, what .. "asymmetry of the cylinder by Eq. (5)")
  for _, body in ipairs{ "cylinder", "plate" } do
    ok(lopsided(increments, 100, "trapezoid", body) < 1e-12,
      what .. "no asymmetry of the " .. body .. " by Eq. (4)")
  end
end

-- --- figures -------------------------------------------------------------------------------------
local meshes = study.meshes():run{ workers = 2, file = folder .. "/meshes", progress = false }
local function size_of(path)
  local file = io.open(path)
  local text = file and file:read("a") or ""
  if file then file:close() end
  return #text, text
end
for _, each in ipairs{ { s, 8 }, { trials, 3 }, { meshes, 1 } } do
  local drawn = each[1]:figures{ dir = folder .. "/figures", term = { "svg" } }
  ok(#drawn == each[2], ("%d figures of study %s"):format(each[2], each[1].name))
  for _, figure in ipairs(drawn) do
    local size, text = size_of(figure.files[1])
    ok(size > 8000 and text:find("</svg>", 1, true), figure.title)
    ok((figure.shows .. figure.caption):find "%d" and not (figure.shows .. figure.caption):find "nan", "the caption contains numbers")
  end
end
local page = part("page").html{ title = "A & B", lead = "<i>",
  figures = s:figures{ dir = folder .. "/figures" } }
holds(page, { "A &amp; B", "&lt;i&gt;", 'src="fig14.svg"', "</html>" },
  "the page contains the title, the text and the figures")

os.execute("rm -r " .. folder)
