-- Tests rough profiles: default meshes, Westergaard's waves in partial contact, and the decay of waves in
-- full contact.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within = figures.within

local length, height = 0.1, 1e-4
local star = math.pi * 109890.1 * height / length -- mean pressure for full contact [MPa]

-- Tests the default meshes, which have eight elements per wave and five in the width of a single contact
-- spot. For Westergaard's pressures, (p / cos(pi x / l))^2 is linear in sin^2(pi x / l) and zero at the edge
-- of the spot.
local function wavy(radius, fineness, zone)
  return model{ upper = body.profile{ width = 4, height = 2,
      y = function(x) return height * math.cos(2 * math.pi * x / length) - x * x / (2 * radius) end },
    lower = body.block{ width = 4, height = 2 }, mesh = { fineness = fineness, far = 0.2, zone = { cylinder = zone, plate = zone } } }
end
local smooth = contact{ load = 100, model = { upper = body.profile{ width = 4, height = 2, y = function(x) return -x * x / 200 end },
  lower = body.block{ width = 4, height = 2 } } }
local touching = 2 * length / math.pi * math.asin(math.sqrt(100 / (2 * smooth.half_width) / star))
within(wavy(100, 1, 1).mesh.size, touching / 5, 0.02,
  "waves with separate spots: five elements in a spot [mm]")
within(wavy(22, 1, 1).mesh.size, length / 8, 1e-3, "waves in full contact: eight elements per wave [mm]")
local fine = contact{ load = 45, average = 0, model = wavy(220, 4, 0.9) }
local size = fine.model.mesh.size
local at, force = fine:pressure("profile"), 0
for i, x in ipairs(at.x) do force = force + math.max(0, math.min(1, (length / 2 - math.abs(x)) / size + 0.5)) * at.p[i] * size end
local mean = force / length
local middle = #at.x // 2 + 1
local last = middle
while at.p[last + 2] > 0 do last = last + 1 end
local function line(i)
  local phase = math.pi * at.x[i] / length
  return math.sin(phase) ^ 2, (at.p[i] / math.cos(phase)) ^ 2
end
local s0, q0 = line(middle)
local s1, q1 = line(last)
within(2 / math.pi * math.asin(math.sqrt(s0 + q0 * (s1 - s0) / (q0 - q1))), 2 / math.pi * math.asin(math.sqrt(mean / star)), 0.01,
  "waves: fraction of the length in contact")
within(fine.p_center, 2 * math.sqrt(mean * star), 0.01,
  "waves with 48 elements each: pressure at a crest [MPa]")

-- Tests waves with heights of 1 and 2 um against a finer mesh: the crest in the middle, and the crest beside
-- it.
for _, row in ipairs{ { 1e-3, 0.05 }, { 2e-3, 0.1 } } do
  local deep, long = table.unpack(row)
  local function crests(finer)
    local c = contact{ load = 100, average = 0, model = { mesh = { fineness = finer }, lower = body.block{ width = 4, height = 2 },
      upper = body.profile{ width = 4, height = 2, y = function(x) return deep / 2 * math.cos(2 * math.pi * x / long) - x * x / 20 end } } }
    local p, beside = c:pressure("profile"), 0
    for k, x in ipairs(p.x) do if math.abs(x - long) < long / 2 then beside = math.max(beside, p.p[k]) end end
    return c.p_center, beside
  end
  local middle_crest, next_crest = crests(1)
  local fine_middle, fine_next = crests(2)
  within(middle_crest, fine_middle, 0.01,
    ("separate waves of %g um: pressure on the middle crest [MPa]"):format(1e3 * deep))
  within(next_crest, fine_next, 0.04, "separate waves: pressure on the next crest [MPa]")
end

-- Tests the decay of waves in full contact: their amplitude, without the form of the profile, decreases as
-- exp(-d / d_c) with d_c = l / (pi k E*).
local decay = length / (math.pi * 1e-8 * 109890.1)
local flattened = wear{ model = wavy(22, 2, 1.2), load = 400, k_cylinder = 1e-8, k_plate = 0, stroke = 0.01, scheme = "explicit",
  geometry = "frozen", distance = decay / 2 }
flattened:run()
local h = flattened:profile("profile").h
middle = #h // 2 + 1
local function dip(nodes) return h[middle] - (h[middle + nodes] + h[middle - nodes]) / 2 end
-- a wave has sixteen elements: dip(16) depends on the form alone, dip(8) on the form and the wave
local lost = (dip(8) - dip(16) / 4) / 2
within(-math.log(1 - lost / height), 0.5, 0.01, "waves in full contact: exponent of the decay")
