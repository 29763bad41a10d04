-- Jaeger's superposition: the shear of a contact under a load P(t) and a force Q(t) is a sum over slices of
-- load. A slice between P and P + dP carries the shear eta dP and moves the contact by eta dP compliance(P).
-- Slices slip from the outermost inwards, with eta = +-mu. This is exact for similar bodies and any path.
local slices = {}

-- Returns slices without load. `most` is the largest load; compliance(P) is the displacement per unit of
-- shear of a slice at the load P.
function slices.new(number, most, mu, compliance)
  local s = { n = 0, step = most / number, mu = mu, eta = {}, force = 0, motion = 0, compliance = {} }
  for i = 1, number do s.eta[i], s.compliance[i] = 0, compliance((i - 0.5) * s.step) end
  return s
end

local function set(s, i, eta)
  local change = (eta - s.eta[i]) * s.step
  s.force, s.motion, s.eta[i] = s.force + change, s.motion + change * s.compliance[i], eta
end

-- Changes load and force to new values, in proportion to each other.
function slices.change(s, load, force)
  local mu, n = s.mu, math.floor(load / s.step + 0.5)
  local share = n > s.n and (force - s.force) / ((n - s.n) * s.step) or 0
  for i = s.n + 1, n do set(s, i, math.max(-mu, math.min(mu, share))) end
  for i = s.n, n + 1, -1 do set(s, i, 0) end
  s.n = n
  local i, most = n, force > s.force and mu or -mu
  while math.abs(force - s.force) > 1e-9 * mu * load and i > 0 do
    local needed = s.eta[i] + (force - s.force) / s.step
    set(s, i, math.max(-mu, math.min(mu, needed)))
    if math.abs(needed) > mu and math.abs(s.eta[i] - most) > 1e-12 then error "a slice did not slip" end
    i = i - 1
  end
end

return slices
