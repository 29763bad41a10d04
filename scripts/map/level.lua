-- t:level subtracts a plane or a sphere from a map. The form is fitted to all points or only to the unworn
-- part of the map.

local check = require "archard.lib.check"
local form = require "archard.map.form"
local map = require "archard.map.class"
local strict = require "archard.strict"

local level = { kind = check.one_of(form.kinds), scar = check.kind("{ x0, x1, z0, z1 } in mm, x0 < x1, z0 < z1",
  check.box.test) }

local function outside(scar)
  return scar and function(x, z) return x < scar[1] or x > scar[2] or z < scar[3] or z > scar[4] end
end

local function refuse(where, kind, scar)
  check.fail(where, ("field 'level': the points of this map do not determine a %s%s"):format(kind,
    scar and " outside the scar" or ""))
end

-- Returns the map t minus a form (plane or sphere) that is fitted to its points outside the scar. scar:
-- { x0, x1, z0, z1 } [mm], or nil to fit all points.
function level.off(where, t, kind, scar)
  local found, y = form.fit(kind, t.x, t.z, t.y, outside(scar)), {}
  if not found then refuse(where, kind, scar) end
  for i, x in ipairs(t.x) do
    for j, z in ipairs(t.z) do
      local k, height = (i - 1) * #t.z + j, found:height(x, z)
      if not height then refuse(where, kind, scar) end
      y[k] = t.y[k] - height
    end
  end
  return map.derived(t, t.x, t.z, y, { form = kind, radius = found:radius() })
end

function map.methods:level(kind, scar)
  local where = "map:level"
  map.self(where, self)
  kind = kind or "plane"
  if not level.kind.test(kind) then check.refuse(where, "level", level.kind.expected, kind) end
  if scar ~= nil and not level.scar.test(scar) then check.refuse(where, "scar", level.scar.expected, scar) end
  return level.off(where, self, kind, scar)
end

strict.class(map.class)

return level
