-- What other solutions of the paper's problem give, to be compared with. Nothing here comes from
-- archard. Closed forms: Hertz, and Eq. (27). The rest: two elastic half-planes by boundary
-- elements, frictionless, cells of 5 um, fine steps and increments; converged to about 0.1 %, but
-- for pressures at the edges of scars, which grow as the cells get smaller.
local independent = {}

independent.hertz = { half_width = 0.107641, p_max = 591.431 } -- mm, MPa

-- Rows: stroke [mm], alpha, depths of cylinder and plate [um], pressure at the centre [MPa],
-- alpha-tilde first, mean, last; each at the end of 1320 mm.
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

-- Largest pressure over that at the centre at the end, plate at x = 0, stroke a; by alpha.
independent.edges = { [0.25] = 1.04, [0.5] = 1.02, [0.75] = 1.41, [1] = 1.00 }

-- The row of a case, by the names of its values; nil: there is none.
function independent.case(stroke, alpha)
  for _, row in ipairs(independent.finals) do
    if row[1] == stroke and row[2] == alpha then
      return { depth_cylinder = row[3], depth_plate = row[4], p_center = row[5], first = row[6],
        mean = row[7], last = row[8] }
    end
  end
end

return independent
