-- Runs an input deck in CalculiX and reads its results, for `make peer` and the tests. Lengths are in mm,
-- stresses in MPa, forces in N.

local ccx = {}

-- Returns true if CalculiX is installed.
function ccx.there() return os.execute("command -v ccx >/dev/null 2>&1") == true end

-- Runs the deck NAME.inp in a folder on one thread. Returns true on success, the output of CalculiX, and the
-- CPU seconds.
local function run(folder, name)
  local pipe = assert(io.popen(("cd '%s' && OMP_NUM_THREADS=1 ccx %s 2>&1; times"):format(folder, name)))
  local said = pipe:read("a")
  pipe:close()
  local seconds = 0
  for minutes, rest in said:match("[^\n]*\n?$"):gmatch("(%d+)m([%d.]+)s") do seconds = seconds + 60 * minutes + rest end
  return said:find("Job finished", 1, true) and not said:find("*ERROR", 1, true), said, seconds
end

-- Returns the node number and the list of values in a result line. Each value is twelve characters wide.
local function numbers_in(line)
  local values = {}
  for at = 14, #line - 11, 12 do values[#values + 1] = tonumber(line:sub(at, at + 11)) end
  return tonumber(line:sub(4, 13)), values
end

-- Reads the results of the last step from an .frd file. Returns the tables DISP, STRESS, CONTACT and NODES
-- (the positions) with the values of each node by its number.
local function read_frd(path)
  local blocks, block = {}, nil
  for line in io.lines(path) do
    if line:find("^    2C") then
      block = {}
      blocks.NODES = block
    elseif line:find("^ %-4") then
      block = {}
      blocks[line:match("%S+", 4)] = block
    elseif line:find("^ %-1") and block then
      local node, values = numbers_in(line)
      block[node] = values
    elseif line:find("^ %-3") then
      block = nil
    end
  end
  return blocks
end

-- Returns the last force on the cylinder and the last displacement of the base, both along y, as printed in
-- the .dat file.
local function prints_in(path)
  local file = assert(io.open(path))
  local text = file:read("a")
  file:close()
  local force, way
  for fy in text:gmatch("total force[^\n]*\n%s*\n%s*%S+%s+(%S+)") do force = tonumber(fy) end
  for uy in text:gmatch("set BASE[^\n]*\n%s*\n%s*%S+%s+%S+%s+(%S+)") do way = tonumber(uy) end
  return -force, way
end

local function mises(s)
  local x, y, z, xy, yz, zx = table.unpack(s)
  return math.sqrt(((x - y) ^ 2 + (y - z) ^ 2 + (z - x) ^ 2) / 2 + 3 * (xy * xy + yz * yz + zx * zx))
end

-- Returns the largest von Mises stress of each body. owner(node) returns the body of a node.
local function largest_mises(stress, owner)
  local largest = {}
  for node, s in pairs(stress) do
    local body = owner(node)
    largest[body] = math.max(largest[body] or 0, mises(s))
  end
  return largest
end

-- Returns the contact pressure at x = 0, where the loaded surface has a node, and the largest pressure.
local function pressures(blocks)
  local center, largest = 0 / 0, 0
  for node, c in pairs(blocks.CONTACT) do
    local p, at = c[4], blocks.NODES[node]
    largest = math.max(largest, p)
    if p > 0 and math.abs(at[1]) < 1e-9 and at[3] == 0 then center = p end
  end
  return center, largest
end

-- Returns the stresses normal to the surface at the nodes of the lower body on the axis x = z = 0, as a list
-- of { y=, syy= } with the deepest node first.
local function below_axis(blocks, cylinder)
  local list = {}
  for node, s in pairs(blocks.STRESS) do
    local at = blocks.NODES[node]
    if node > cylinder and at[1] == 0 and at[3] == 0 then list[#list + 1] = { y = at[2], syy = s[2] } end
  end
  table.sort(list, function(a, b) return a.y < b.y end)
  return list
end

-- Solves an input deck. cylinder: number of nodes of the cylinder; both: number of nodes of both bodies.
-- Returns { p_center=, p_max=, mises={ cylinder=, plate= }, force=, approach=, seconds=, increments=, axis=
-- }, or nil and the output of CalculiX.
function ccx.solve(folder, name, cylinder, both)
  local done, said, seconds = run(folder, name)
  if not done then return nil, said end
  local blocks = read_frd(("%s/%s.frd"):format(folder, name))
  local center, largest = pressures(blocks)
  local force, approach = prints_in(("%s/%s.dat"):format(folder, name))
  local _, increments = said:gsub("increment %d+ attempt", "")
  return { axis = below_axis(blocks, cylinder), p_center = center, p_max = largest, seconds = seconds, increments = increments,
    force = force, approach = approach, mises = largest_mises(blocks.STRESS, function(node)
      return (node - 1) % both < cylinder and "cylinder" or "plate"
    end) }
end

return ccx
