-- Fits a plane or a sphere to the heights of a map by least squares of the vertical distances. The
-- parameters of the sphere are a height, two slopes and a curvature, which also describe almost plane
-- surfaces.

local solve = require "archard.lib.linear"

local form = { kinds = { "plane", "sphere" } }
local models = {}

-- Returns the height of a plane with the parameters p at (u, v), and its derivatives with respect to p. Lengths are
-- in units of half the map's length; u and v are measured from the middle of the map.
function models.plane(u, v, p) return p[1] + p[2] * u + p[3] * v, 1, u, v end

-- Returns the height of a sphere at (u, v) and its derivatives with respect to p, or nil outside the
-- sphere. p: height, sines of both slopes in the middle, and curvature.
function models.sphere(u, v, p)
  local t, s, k = p[2], p[3], p[4]
  local q, r = t + k * u, s + k * v
  local c2, d2 = 1 - t * t - s * s, 1 - q * q - r * r
  if c2 <= 0 or d2 <= 0 then return nil end
  local c, d = math.sqrt(c2), math.sqrt(d2)
  local sum, far = c + d, u * u + v * v
  local rise = 2 * (t * u + s * v) + k * far
  return p[1] + rise / sum, 1, 2 * u / sum + rise * (t / c + q / d) / sum ^ 2, 2 * v / sum + rise * (s / c + r / d) / sum ^ 2,
    far / sum + rise * (q * u + r * v) / d / sum ^ 2
end

local function zeros(n)
  local list = {}
  for i = 1, n do list[i] = 0 end
  return list
end

-- Returns the means over all points of J'J, J'r and r'r, where r are the residuals and J the derivatives of
-- the form. Returns nil if a point is outside the form.
local function normal(self, points, p)
  local n, a, b, rr = #p, {}, zeros(#p), 0
  for i = 1, n do a[i] = zeros(n) end
  local model, u, v, y = models[self.kind], points.u, points.v, points.y
  for k = 1, #y do
    local value, g1, g2, g3, g4 = model(u[k], v[k], p)
    if not value then return nil end
    local r, g = y[k] - value, points.g
    g[1], g[2], g[3], g[4] = g1, g2, g3, g4
    for i = 1, n do
      local row, gi = a[i], g[i]
      b[i] = b[i] + gi * r
      for c = i, n do row[c] = row[c] + gi * g[c] end
    end
    rr = rr + r * r
  end
  for i = 1, n do
    b[i] = b[i] / #y
    for c = i, n do a[i][c] = a[i][c] / #y a[c][i] = a[i][c] end
  end
  return a, b, rr / #y
end

-- Makes one Gauss-Newton step of the fit of the form. The step is halved until the form is defined at all points and
-- the residual does not increase. Returns the new results of normal() and the size of the step, or nil on failure.
local function advance(self, points, a, b, rr)
  local right = {}
  for i = 1, #b do right[i] = { b[i] } end
  local step = solve(a, right, 1e-12)
  if not step then return nil end
  for halvings = 0, 40 do
    local p, size = {}, 0
    for i = 1, #step do
      p[i] = self.p[i] + step[i][1] / 2 ^ halvings
      size = math.max(size, math.abs(p[i] - self.p[i]))
    end
    local a2, b2, rr2 = normal(self, points, p)
    if a2 and rr2 <= rr * (1 + 1e-9) + 1e-30 then
      self.p = p
      return a2, b2, rr2, size
    end
  end
end

-- Returns the points with lengths in units of half the map's length, measured from its middle. The mean
-- height is subtracted. Only points for which is_used(x, z) returns true are included.
local function scaled(self, x, z, y, is_used)
  local points, sum = { u = {}, v = {}, y = {}, g = {} }, 0
  for i = 1, #x do
    for j = 1, #z do
      if not is_used or is_used(x[i], z[j]) then
        local k = #points.y + 1
        points.u[k], points.v[k] = (x[i] - self.x) / self.half, (z[j] - self.z) / self.half
        points.y[k] = y[(i - 1) * #z + j] / self.half
        sum = sum + points.y[k]
      end
    end
  end
  self.mean = sum / math.max(1, #points.y)
  for k = 1, #points.y do points.y[k] = points.y[k] - self.mean end
  return points
end

local shape = {}
shape.__index = shape

-- Fits a form ("plane" or "sphere") to the points for which is_used(x, z) returns true; without is_used, to
-- all points. Returns the form, or nil if the points do not determine it.
function form.fit(kind, x, z, y, is_used)
  local self = setmetatable({ kind = kind, x = (x[1] + x[#x]) / 2, z = (z[1] + z[#z]) / 2,
    half = math.max(x[#x] - x[1], z[#z] - z[1]) / 2, p = zeros(kind == "plane" and 3 or 4) }, shape)
  local points = scaled(self, x, z, y, is_used)
  if #points.y <= #self.p then return nil end
  local a, b, rr = normal(self, points, self.p)
  local size
  for _ = 1, 50 do
    a, b, rr, size = advance(self, points, a, b, rr)
    if not a then return nil end
    if size < 1e-13 or self.kind == "plane" and size < 1e-9 then break end
  end
  return self
end

-- Returns the height of the form at a point [mm], or nil outside a sphere.
function shape:height(x, z)
  local value = models[self.kind]((x - self.x) / self.half, (z - self.z) / self.half, self.p)
  return value and (value + self.mean) * self.half
end

-- Returns the radius of the sphere [mm], or nil for a plane.
function shape:radius() return self.p[4] and self.half / math.abs(self.p[4]) end

return form
