-- Contact of a cylinder and a plate, unworn: pressure, width and stresses, compared with Hertz' formulas.
--   archard examples/01_contact.lua

local c = contact{ model = { radius = 10 }, load = 100 } -- mm, N; default material: steel on steel
local closed = hertz{ radius = 10, load = 100 }
local field = c:stress()

-- The largest von Mises stress under a line contact is 0.7 half widths below the surface. On half-planes
-- with nu = 0.3 it is 0.5575 of the pressure at the centre; in a body of finite size with supports it is
-- slightly larger.
local deepest = { mises = 0 }
for i, mises in ipairs(field.plate.mises) do
  if mises > deepest.mises then deepest = { mises = mises, y = field.plate.y[i] } end
end

print(("%-32s %10s %10s"):format("", "elements", "Hertz"))
local function row(name, form, mine, theirs)
  print(("%-32s %10s %10s"):format(name, form:format(mine), form:format(theirs)))
end
row("pressure at the centre [MPa]", "%.1f", c.p_center, closed.p_max)
row("half width [mm]", "%.4f", c.half_width, closed.half_width)
row("von Mises stress, plate [MPa]", "%.1f", deepest.mises, 0.5575 * closed.p_max)
row("depth of this stress [mm]", "%.4f", -deepest.y, 0.704 * closed.half_width)
print()

plot.stress(c, { title = "Von Mises stress, unworn contact" })
