-- Computes the effect of friction on the paper's cases, which have no friction. The contacts slide with a
-- coefficient of friction of 0.3. Changes are printed in percent of the results without friction.
--
--   archard scripts/tools/rubbing.lua

local paper = require "archard.study.paper"

local function finished(case, friction)
  case.friction = friction
  local w = wear(case)
  return w:run{ progress = false }
end

local function change(with, without)
  if without == 0 then return "-" end
  return ("%+.2f"):format(100 * (with / without - 1))
end

io.write("| s / mm | alpha | volume | depth of the cylinder | depth of the plate | p centre | half width |\n|---|---|---|---|---|---|---|\n")
for _, case in ipairs(paper.cases()) do
  local without, with = finished(case, 0), finished(case, 0.3)
  io.write(("| %g | %g | %s | %s | %s | %s | %s |\n"):format(case.stroke, case.alpha,
    change(with.volume.total, without.volume.total), change(with.depth.cylinder, without.depth.cylinder),
    change(with.depth.plate, without.depth.plate), change(with.p_center, without.p_center),
    change(with.half_width, without.half_width)))
  io.flush()
end
