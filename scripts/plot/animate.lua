-- plot.animate: advances a run and draws wear profiles or contact pressures after each step, in the terminal
-- or as an animated gif.

local check = require "archard.lib.check"
local draw = require "archard.plot.draw"
local curves = require "archard.plot.curves"
local map = require "archard.plot.map"
local process = require "archard.process"
local naming = require "archard.plot.naming"
local term = require "archard.term"

local own = {
  file = draw.fields.file, size = draw.fields.size, term = draw.fields.term,
  colour = draw.fields.colour, frames = check.count, every = check.count, delay = check.positive,
  what = check.one_of { "profile", "pressure", "both", "stroke" },
}

-- --- one frame ----------------------------------------------------------------------------------

local function profile_panel(w)
  local panel = curves.profile_panel("plot.animate", { w }, {}, { "upper", "lower" })
  panel.xlabel, panel.ylabel, panel.ydown = "x / mm", "wear depth / µm", true
  panel.title = "wear"
  return panel
end

local function pressure_panel(w)
  local pressure = w:pressure(naming.bodies(w)[1])
  return { { x = pressure.x, y = pressure.p }, xlabel = "x / mm", ylabel = "p / MPa",
    title = "contact pressure" }
end

-- Widens the range limits[name] to include `low` and `high`. Ranges never become narrower during an
-- animation.
local function hold(panel, limits, name, low, high)
  limits[name] = limits[name] or { low, high }
  local range = limits[name]
  range[1], range[2] = math.min(range[1], low), math.max(range[2], high)
  return panel
end

local function span(panel)
  local low, high = math.huge, -math.huge
  for _, curve in ipairs(panel) do
    for i = 1, #curve.y do low, high = math.min(low, curve.y[i]), math.max(high, curve.y[i]) end
  end
  return low, high
end

local function frame_of(w, what, limits)
  local panels = {}
  if what ~= "pressure" then
    local panel = profile_panel(w)
    local range = panel.xrange or { -1e-9, 1e-9 }
    hold(panel, limits, "reach", range[1], range[2])
    hold(panel, limits, "depth", span(panel))
    panels[#panels + 1] = panel
  end
  if what ~= "profile" then
    local panel = pressure_panel(w)
    local _, high = span(panel)
    hold(panel, limits, "pressure", 0, 1.05 * high)
    panels[#panels + 1] = panel
  end
  return panels, curves.summary(w)
end

-- Returns the options of plot{} for one frame. The axis ranges include all frames up to now.
local function options_of(panels, title, limits)
  for _, panel in ipairs(panels) do
    local reach = limits.reach
    panel.xrange = reach and reach[2] > 1e-6 and { reach[1], reach[2] } or nil
    if panel.title == "contact pressure" then
      panel.yrange = { limits.pressure[1], limits.pressure[2] }
    elseif limits.depth[2] > 0 then
      panel.yrange = { limits.depth[2], 0 } -- the depth axis points down
    end
  end
  if #panels == 1 then
    panels[1].title = title
    return panels[1]
  end
  return { panels = panels, layout = { 1, #panels }, title = title }
end

-- --- output of the frames -----------------------------------------------------------------------

-- Draws a frame in the terminal over the previous frame, and clears the rest of each line.
local function show(options, first)
  local picture = draw.picture("plot.animate", options)
  if not picture then return end
  io.write(first and "\27[H\27[2J" or "\27[H", (picture:gsub("\n", "\27[K\n")), "\27[J")
  io.flush()
end

local function film(frames, limits, delay, given)
  local list = {}
  for i, frame in ipairs(frames) do list[i] = options_of(frame[1], frame[2], limits) end
  draw.film("plot.animate", list, delay, given)
end

-- --- a stroke in three dimensions ---------------------------------------------------------------

-- Draws the contact pressure between the worn surfaces at `count` positions of the plate, from one end of the
-- stroke to the other.
local function stroke_film(w, count, delay, given)
  local where = "plot.animate"
  if curves.get(w.model, "geometry") ~= "3-D" then check.refuse(where, "what", '"profile", "pressure" or "both", because geometry is not "3-D"', "stroke") end
  local list, contact, most, half_x, half_z = {}, w:contact(), 0, 0, 0
  for i = 1, count do
    local x = w.stroke * (count > 1 and (i - 1) / (count - 1) - 0.5 or 0)
    local t = contact:move{ x = x }:pressure()
    list[i] = map.panel(t)
    list[i].title = ("x = %+.4f mm, %.6g mm of sliding"):format(x, w.distance)
    half_x, half_z = math.max(half_x, t.x[#t.x]), math.max(half_z, t.z[#t.z])
    for _, p in ipairs(t.y) do most = math.max(most, p) end
  end
  for _, panel in ipairs(list) do
    panel.vrange, panel.xrange, panel.yrange = { 0, most }, { -half_x, half_x }, { -half_z, half_z }
  end
  if given.file then return draw.film(where, list, delay, given) end
  for i, panel in ipairs(term.movable() and list or { list[#list] }) do
    panel.term, panel.size, panel.colour = given.term, given.size, given.colour
    if not term.movable() then return draw.draw(where, panel) end
    show(panel, i == 1)
    process.pause(delay)
  end
end

-- Returns the number of updates between two frames, chosen so that about `frames` frames cover the rest of
-- the run.
local function updates_between(w, frames)
  local cycles, cycle, jump = curves.get(w, "cycles"), curves.get(w, "cycle"),
    curves.get(w, "jump")
  if type(jump) ~= "number" or type(cycles) ~= "number" then return 1 end
  return math.max(1, math.ceil((cycles - cycle) / jump / frames - 1e-9))
end

-- Advances the run by `every` updates at a time, at most `frames` times, and stops at the end of the run.
-- Calls visit() at the start and after each step.
local function each_frame(w, every, frames, visit)
  visit()
  for _ = 1, frames do
    local before = w.distance
    w:step(every)
    if w.distance <= before then return end
    visit()
  end
end

-- plot.animate(w, { frames=30, every=, what="profile", delay=0.1, file="run.gif", ... }) draws the animation.
return function(w, given)
  local where = "plot.animate"
  if not (curves.get(w, "step") and curves.get(w, "profile")) then
    check.fail(where, "expected a wear object as the first argument, got " .. check.shown(w))
  end
  given = check.fields(where, given or {}, own)
  local what, delay, limits, kept = given.what or "profile", given.delay or 0.1, {}, {}
  if what == "stroke" then return stroke_film(w, given.frames or 30, delay, given) end
  local every = given.every or updates_between(w, given.frames or 30)
  local in_place = not given.file and term.movable()
  each_frame(w, every, given.frames or math.huge, function()
    local panels, title = frame_of(w, what, limits)
    if in_place then
      local options = options_of(panels, title, limits)
      options.term, options.size, options.colour = given.term, given.size, given.colour
      show(options, not kept[1])
      process.pause(delay)
      kept[1] = kept[1] or true
    elseif given.file then
      kept[#kept + 1] = { panels, title }
    else
      kept[1] = { panels, title } -- if the output is not a terminal, only the last frame is drawn
    end
  end)
  if given.file then
    film(kept, limits, delay, given)
  elseif not in_place then
    local options = options_of(kept[1][1], kept[1][2], limits)
    options.term, options.size, options.colour = given.term, given.size, given.colour
    draw.draw(where, options)
  end
end
