-- Writes a ball on a flat as an input deck for CalculiX. A quarter of both bodies (x, z >= 0) is meshed with
-- bricks of 20 nodes that are small at the contact. Both bodies are blocks; the lower side of the upper block
-- has the shape of the ball. The bodies therefore differ from half-spaces only by their finite size. Lengths
-- are in mm, forces in N, stresses in MPa; y points up.

local deck = {}

-- Returns positions from 0 to `far`: `count` equal steps up to `fine`, then steps that grow by the factor
-- `growth`. The midpoints of all steps are included.
local function graded(fine, count, growth, far)
  local at, step, all = { 0 }, fine / count, {}
  for i = 1, count do at[#at + 1] = i * step end
  while at[#at] < far do
    step = step * growth
    at[#at + 1] = at[#at] + step
  end
  for i = 1, #at do
    all[2 * i - 1] = at[i]
    if i < #at then all[2 * i] = (at[i] + at[i + 1]) / 2 end
  end
  return all
end

-- Positions of the nodes of a brick, corners and edge midpoints, in CalculiX order on a lattice with two
-- steps per element. The second coordinate is y.
local order = {
  { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 }, { 0, 0, 2 }, { 2, 0, 2 }, { 2, 2, 2 }, { 0, 2, 2 },
  { 1, 0, 0 }, { 2, 1, 0 }, { 1, 2, 0 }, { 0, 1, 0 }, { 1, 0, 2 }, { 2, 1, 2 }, { 1, 2, 2 }, { 0, 1, 2 },
  { 0, 0, 1 }, { 2, 0, 1 }, { 2, 2, 1 }, { 0, 2, 1 },
}

-- Writes the nodes and elements of a body. surface(x, z) returns the height y of its surface. The layers
-- extend to the distance `far` above (upper body) or below the surface. Node and element numbers start after
-- `node` and `element`.
local function write_body(file, name, plan, layers, surface, side, far, node, element)
  local number = {}
  local function key(i, j, k) return (i * 1000 + j) * 1000 + k end
  local fixed, on_x, on_z = {}, {}, {}
  file:write("*NODE, NSET=", name, "\n")
  for i = 1, #plan do
    for k = 1, #plan do
      local top = surface(plan[i], plan[k])
      for j = 1, #layers do
        if (i + 1) % 2 + (j + 1) % 2 + (k + 1) % 2 < 2 then
          node = node + 1
          number[key(i, j, k)] = node
          file:write(("%d, %.12g, %.12g, %.12g\n"):format(node, plan[i], top + (side * far - top) * layers[j] / layers[#layers], plan[k]))
          if j == #layers then fixed[#fixed + 1] = node end
          if i == 1 then on_x[#on_x + 1] = node end
          if k == 1 then on_z[#on_z + 1] = node end
        end
      end
    end
  end
  local faces = {}
  file:write("*ELEMENT, TYPE=C3D20, ELSET=", name, "\n")
  for i = 1, #plan - 2, 2 do
    for k = 1, #plan - 2, 2 do
      for j = 1, #layers - 2, 2 do
        element = element + 1
        local words = { element }
        for _, at in ipairs(order) do
          local up = side > 0 and j + at[2] or j + 2 - at[2]
          words[#words + 1] = number[key(i + at[1], up, k + at[3])]
        end
        file:write(table.concat(words, ", ", 1, 11), ",\n", table.concat(words, ", ", 12), "\n")
        if j == 1 then faces[#faces + 1] = { element, plan[i], plan[k] } end
      end
    end
  end
  local function set(ending, list)
    file:write("*NSET, NSET=", name, ending, "\n", table.concat(list, ",\n"), "\n")
  end
  set("-fixed", fixed)
  set("-x", on_x)
  set("-z", on_z)
  return { last = node, element = element, faces = faces, fixed = fixed }
end

local function write_contact(file, name, body, reach, side)
  file:write("*SURFACE, NAME=", name, "-contact, TYPE=ELEMENT\n")
  for _, face in ipairs(body.faces) do
    if face[2] < reach and face[3] < reach then file:write(face[1], side > 0 and ", S3\n" or ", S5\n") end
  end
end

-- Writes an input deck in Abaqus format. Fields of `case`: upper and lower, functions (x, z) that return y
-- [mm]; E [MPa] and nu of both bodies; load [N]; expected approach and half_width of the contact [mm]; far,
-- the distance of the outer boundary [mm]. Returns the number of nodes of the ball and of both bodies.
function deck.write(path, case)
  local file <close> = assert(io.open(path, "w"))
  local fine, growth = 1.3 * case.half_width, 1.9
  local plan = graded(fine, case.elements, growth, case.far)
  local layers = graded(fine / case.elements, 1, growth, case.far)
  file:write("*HEADING\na quarter of a ball on a flat, units mm, N, MPa\n")
  local upper = write_body(file, "ball", plan, layers, case.upper, 1, case.far, 0, 0)
  local lower = write_body(file, "flat", plan, layers, case.lower, -1, case.far, upper.last, upper.element)
  write_contact(file, "ball", upper, 2 * case.half_width, 1)
  write_contact(file, "flat", lower, 2 * case.half_width, -1)
  for _, name in ipairs{ "ball", "flat" } do
    file:write(("*MATERIAL, NAME=%s\n*ELASTIC\n%.9g, %.9g\n*SOLID SECTION, ELSET=%s, MATERIAL=%s\n"):format(name, case.E, case.nu, name, name))
  end
  local base = lower.last + 1
  file:write("*NODE, NSET=base\n", base, ", 0, ", -case.far, ", 0\n")
  for _, node in ipairs(lower.fixed) do file:write(("*EQUATION\n2\n%d, 2, 1, %d, 2, -1\n"):format(node, base)) end
  file:write(("*SURFACE INTERACTION, NAME=frictionless\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n%.6g\n"):format(case.stiffness),
    "*CONTACT PAIR, INTERACTION=frictionless, TYPE=SURFACE TO SURFACE\nflat-contact, ball-contact\n")
  local held = "ball-fixed, 1, 3\nflat-fixed, 1, 1\nflat-fixed, 3, 3\nball-x, 1, 1\nflat-x, 1, 1\nball-z, 3, 3\nflat-z, 3, 3\nbase, 1, 1\nbase, 3, 3\n"
  file:write("*STEP, INC=200\n*STATIC\n1, 1\n*BOUNDARY\n", held, ("base, 2, 2, %.9g\n*END STEP\n"):format(case.approach))
  file:write("*STEP, INC=200\n*STATIC\n1, 1\n*BOUNDARY, OP=NEW\n", held, ("*CLOAD\nbase, 2, %.12g\n"):format(case.load / 4),
    "*NODE FILE\nU\n*EL FILE\nS\n*CONTACT FILE\nCDIS, CSTR\n*NODE PRINT, NSET=base\nU\n*NODE PRINT, NSET=ball-fixed, TOTALS=ONLY\nRF\n*END STEP\n")
  return upper.last, lower.last
end

return deck
