-- Contains independent solutions of the paper's problem for comparison. None of them was computed
-- with archard. Two solutions are closed forms: Hertz, and Eq. (27). The other values come from a
-- frictionless boundary element solution for two elastic half-planes, with cells of 5 um and fine
-- steps and increments. These values are converged to about 0.1 %, except the pressures at the edges
-- of scars, which increase as the cells become smaller.
local independent = {}

independent.hertz = { half_width = 0.107641, p_max = 591.431 } -- mm, MPa

-- Each row contains the stroke [mm], alpha, the depths of cylinder and plate [um] and the pressure at
-- the centre [MPa] after 1320 mm of sliding. Rows with three more values also contain the depth
-- partition alpha-tilde: its first value, its mean and its last value.
independent.finals = {
  { 0.11, 0, 0, 3.4265, 235.3 },
  { 0.11, 0.25, 0.9461, 2.5410, 202.1, 0.259, 0.268, 0.271 },
  { 0.11, 0.5, 1.8269, 1.6945, 188.0, 0.512, 0.517, 0.519 },
  { 0.22, 0.25, 1.0728, 2.2418, 253.7, 0.303, 0.322, 0.324 },
  { 0.44, 0.25, 1.2079, 1.7517, 290.7, 0.464, 0.427, 0.408 },
  { 20, 0.25, 1.3199, 0.0495, 298.3, 0.975, 0.969, 0.964 },
  { 0.11, 1, 3.5408, 0, 185.0 }, { 0.22, 1, 3.5408, 0, 185.0 }, { 0.44, 1, 3.5408, 0, 185.0 },
  { 20, 1, 3.5408, 0, 185.0 },
}

-- For each alpha, the largest pressure divided by the pressure at the centre, in the final state with
-- the plate at x = 0 and stroke a.
independent.edges = { [0.25] = 1.04, [0.5] = 1.02, [0.75] = 1.41, [1] = 1.00 }

-- Returns the final values of a case as a table with named fields, or nil if there is no independent
-- solution of this case. The stroke is in mm.
function independent.case(stroke, alpha)
  for _, row in ipairs(independent.finals) do
    if row[1] == stroke and row[2] == alpha then
      return { depth_cylinder = row[3], depth_plate = row[4], p_center = row[5], first = row[6],
        mean = row[7], last = row[8] }
    end
  end
end

return independent
