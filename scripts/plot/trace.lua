-- plot.profile for measured traces: draws heights or depths over x, with one curve for each trace.

local check = require "archard.lib.check"
local draw = require "archard.plot.draw"
local is_profile = require "archard.profile.class".is
local scaled = require "archard.plot.shapes".scaled

local function split(where, ...)
  local traces, options = { ... }, {}
  local last = traces[#traces]
  if type(last) == "table" and not getmetatable(last) then options = table.remove(traces) end
  for i, p in ipairs(traces) do
    if not is_profile(p) or (p.z == nil) ~= (traces[1].z == nil) then
      check.fail(where, ("argument %d: expected a profile of %s like the first, or a table of options as the last "
        .. "argument, got %s"):format(
        i, traces[1].z and "heights" or "depths", is_profile(p) and "one of " .. (p.z and "heights" or "depths") or check.shown(p)))
    end
  end
  return traces, draw.options(where, options, { titles = check.table })
end

-- Draws profiles. Arguments: name of the function in error messages, profiles p1, p2, ..., and { titles=, ...
-- }.
return function(where, ...)
  local traces, options = split(where, ...)
  local heights, given = traces[1].z ~= nil, {}
  for i, p in ipairs(traces) do
    given[i] = { x = p.x, y = scaled(p.z or p.h, 1000), title = options.titles and options.titles[i]
      or #traces > 1 and (p.path and p.path:match("[^/]*$") or ("trace %d"):format(i)) or nil }
  end
  given.xlabel, given.ylabel, given.ydown = "x / mm", heights and "height / µm" or "wear depth / µm", not heights
  given.title = #traces > 1 and "measured profiles" or "measured profile"
  draw.draw(where, draw.over(given, options))
end
