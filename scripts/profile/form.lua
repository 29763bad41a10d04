-- Fits a line or a circle (the form of the surface) to heights by least squares of the vertical distances,
-- with standard errors. A circle is described by a height, a slope and a curvature, which suits almost
-- straight traces too.

local solve = require "archard.lib.linear"
local strict = require "archard.strict"

local form = { kinds = { "line", "circle" }, parameters = { line = 2, circle = 3 } }
local shape = {} -- methods of a fitted form
local class = { __name = "form", __methods = shape, __fields = {} }

-- Functions that return the height of a form at position u, followed by its derivatives with respect to the
-- parameters p. Lengths are in units of half the trace's length; u is measured from the middle of the trace.
local models = {}

function models.line(u, p) return p[1] + p[2] * u, 1, u end

-- Returns the height of a circle at u and its derivatives with respect to the parameters p: height at u = 0,
-- sine of the slope at u = 0, and curvature. Returns nil if u is outside the circle.
function models.circle(u, p)
  local t, k = p[2], p[3]
  local q = t + k * u
  if math.abs(t) >= 1 or math.abs(q) >= 1 then return nil end
  local c, d = math.sqrt(1 - t * t), math.sqrt(1 - q * q)
  local sum, rise = c + d, u * (2 * t + k * u)
  return p[1] + rise / sum, 1, 2 * u / sum + rise * (t / c + q / d) / sum ^ 2,
    u * u / sum + rise * q * u / d / sum ^ 2
end

-- Returns the sums J'J, J'r and r'r over the points for the normal equations, and the number of points. r:
-- residuals; J: derivatives of the form. Returns nil if a point is outside the circle.
local function normal(self, x, z, is_used)
  local a11, a12, a13, a22, a23, a33, b1, b2, b3, rr, count = 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0
  local model, p, middle, half = models[self.kind], self.p, self.middle, self.half
  for i = 1, #x do
    if not is_used or is_used(x[i]) then
      local value, g1, g2, g3 = model((x[i] - middle) / half, p)
      if not value then return nil end
      g3 = g3 or 0
      local r = z[i] / half - value
      a11, a12, a13 = a11 + g1 * g1, a12 + g1 * g2, a13 + g1 * g3
      a22, a23, a33 = a22 + g2 * g2, a23 + g2 * g3, a33 + g3 * g3
      b1, b2, b3, rr, count = b1 + g1 * r, b2 + g2 * r, b3 + g3 * r, rr + r * r, count + 1
    end
  end
  if self.kind == "line" then return { { a11, a12 }, { a12, a22 } }, { { b1 }, { b2 } }, rr, count end
  return { { a11, a12, a13 }, { a12, a22, a23 }, { a13, a23, a33 } }, { { b1 }, { b2 }, { b3 } }, rr, count
end

-- Makes one Gauss-Newton step. The step is halved until all points are inside the circle and the residual
-- does not increase. Returns J'J, J'r and r'r after the step, and the size of the step, or nil on failure.
local function advance(self, x, z, is_used, a, b, rr)
  local step, old = solve(a, b, 1e-280), self.p
  if not step then return nil end
  local share, size = 1, 0
  for _ = 1, 40 do
    self.p, size = {}, 0
    for i = 1, #old do
      self.p[i] = old[i] + share * step[i][1]
      size = math.max(size, math.abs(share * step[i][1]))
    end
    local a2, b2, rr2, count = normal(self, x, z, is_used)
    if a2 and rr2 <= rr * (1 + 1e-9) + 1e-28 * count then return a2, b2, rr2, size end
    share = share / 2
  end
  self.p = old
  return nil
end

local function identity(n)
  local rows = {}
  for i = 1, n do
    rows[i] = {}
    for c = 1, n do rows[i][c] = i == c and 1 or 0 end
  end
  return rows
end

-- Fits a form ("line" or "circle") to the points for which is_used(x) is true, or to all points without
-- is_used. Returns the form, or nil if the points do not determine it.
function form.fit(kind, x, z, is_used)
  local self = setmetatable({ kind = kind, middle = (x[1] + x[#x]) / 2, half = (x[#x] - x[1]) / 2,
    p = kind == "line" and { 0, 0 } or { 0, 0, 0 } }, class)
  local a, b, rr, count = normal(self, x, z, is_used)
  if count <= #self.p then return nil end
  self.p[1] = b[1][1] / count -- starting at the mean avoids loss of digits for large heights
  a, b, rr = normal(self, x, z, is_used)
  for _ = 1, 50 do
    local size
    local a2, b2, rr2, moved = advance(self, x, z, is_used, a, b, rr)
    if not a2 then break end
    a, b, rr, size = a2, b2, rr2, moved
    if size < 1e-13 then break end
  end
  a = normal(self, x, z, is_used)
  self.inverse = solve(a, identity(#self.p), 1e-280)
  self.count, self.deviation = count, self.half * math.sqrt(rr / math.max(1, count - #self.p))
  return self.inverse and self or nil
end

-- Returns the height of the form at x [mm], or nil if x is outside the circle.
function shape:height(x)
  local value = models[self.kind]((x - self.middle) / self.half, self.p)
  return value and value * self.half
end

-- Returns the curvature [1/mm], which is negative for a convex body and 0 for a line.
function shape:curvature() return (self.p[3] or 0) / self.half end
-- Returns the radius [mm], which is infinite for a line.
function shape:radius() return 1 / math.abs(self:curvature()) end

-- Returns the variance of the sum of weights[i] * height(x[i]). The fitted heights are assumed to be
-- independent with a variance of 1.
function shape:variance(x, weights)
  local g = {}
  for c = 1, #self.p do g[c] = 0 end
  for i = 1, #x do
    local derivatives = { select(2, models[self.kind]((x[i] - self.middle) / self.half, self.p)) }
    for c = 1, #self.p do g[c] = g[c] + weights[i] * derivatives[c] end
  end
  local sum = 0
  for r = 1, #g do for c = 1, #g do sum = sum + g[r] * self.inverse[r][c] * g[c] end end
  return sum
end

strict.class(class)
return form
