-- The pictures of examples/gallery/, drawn by `make gallery`. A folder's name after the script's changes where to.

local folder = (arg and arg[1]) or "examples/gallery"
local function to(name) return folder .. "/" .. name .. ".png" end

local m = model{}
plot.mesh(m, { file = to "mesh", size = { 900, 900 }, title = "Half cylinder and plate" })
plot.mesh(m, { file = to "wear_box", zoom = "wear box", size = { 900, 700 }, title = "The wear boxes and what is around them" })

-- Pressure as wear goes on: the run is cloned at some distances.
local w = wear{ model = m, stroke = 0.11, alpha = 0.5 }
local states = { w:clone() }
for _, cycles in ipairs{ 200, 600, 1500, 3000, 6000 } do
  w:run{ cycles = cycles, progress = false }
  states[#states + 1] = w:clone()
end
local pressures = table.move(states, 1, #states, 1, {})
pressures[#pressures + 1] = { file = to "pressure", scaled = true, size = { 900, 600 }, title = "Contact pressure, s = a, \\alpha = 0.5" }
plot.pressure(table.unpack(pressures))

plot.profile(w, { file = to "profiles", size = { 900, 600 }, title = "Wear profiles after 1320 mm, s = a, \\alpha = 0.5" })
plot.history(w, "p_center", { file = to "p_center", size = { 900, 600 }, title = "Pressure at the centre" })
plot.stress(contact{ model = m }, { file = to "mises", size = { 900, 800 }, title = "Von Mises stress, unworn contact" })
