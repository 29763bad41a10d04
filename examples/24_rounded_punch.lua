-- A punch with rounded edges on a block. The pressure rises towards the edges; this rise is smaller for a
-- larger radius.
--   archard examples/24_rounded_punch.lua

local contacts, titles = {}, {}
for i, radius in ipairs{ 1, 2, 5 } do -- mm
  local c = contact{ load = 200, model = {
    upper = body.punch{ flat = 1, radius = radius, height = 10 },
    lower = body.block{ width = 20, height = 10 } } }
  print(("edges of %.1f mm: %.1f MPa in the middle, %.1f MPa at most, %.4f mm half width"):format(radius, c.p_center,
    c.p_max, c.half_width))
  contacts[i], titles[i] = c, ("R = %g mm"):format(radius)
end
plot.pressure(contacts[1], contacts[2], contacts[3], { titles = titles, title = "A punch under 200 N" })
