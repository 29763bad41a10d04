-- Common parts of the picture tests: a temporary folder, reading of pictures in characters, and replacements
-- for the engine's objects.

local pictures = { folder = os.tmpname() }
os.remove(pictures.folder)
os.execute("mkdir " .. pictures.folder)

-- Returns the content of a file in the folder, or nil if the file does not exist.
function pictures.read(name)
  local file = io.open(pictures.folder .. "/" .. name, "rb")
  if not file then return nil end
  local text = file:read("a")
  file:close()
  return text
end

-- Returns the picture, in characters, that the function `draw` writes to the given file.
function pictures.picture_of(draw)
  os.remove(pictures.folder .. "/p.txt")
  draw(pictures.folder .. "/p.txt")
  return pictures.read("p.txt") or ""
end

-- Returns the gnuplot script that the function `draw` writes to the given file.
function pictures.script_of(draw)
  draw(pictures.folder .. "/s.gp")
  return pictures.read("s.gp") or ""
end

pictures.line = { x = { 0, 1, 2, 3 }, y = { 0, 1, 4, 9 }, title = "squares" }

-- Returns a table that replaces a wear object in tests. It has the given fields and fixed results. To read an
-- unknown name is an error, as with a wear object.
function pictures.stand_in(fields)
  fields.pressure = function(_, body)
    return { x = { -0.2, -0.1, 0, 0.1, 0.2 }, p = { 0, 300, body == "plate" and 500 or 400, 300, 0 } }
  end
  fields.profile = function(_, body)
    return { x = { -0.2, -0.1, 0, 0.1, 0.2 }, h = { 0, 1e-3, body == "plate" and 2e-3 or 1.5e-3,
      1e-3, 0 }, y = { 0, 0, 0, 0, 0 } }
  end
  fields.history = { distance = { 0, 10, 20 }, cycle = { 0, 100, 200 }, p_center = { 570, 300, 250 },
    depth_plate = { 0, 1e-3, 2e-3 }, depth_cylinder = { 0, 1e-3, 1.5e-3 },
    depth_partition = { 0 / 0, 0.5, 0.51 } }
  fields.hertz = { half_width = 0.1, p_max = 500 }
  return setmetatable({}, { __index = function(_, name)
    local value = fields[name]
    if value == nil then error("no field " .. name) end
    return value
  end })
end

function pictures.remove() os.execute("rm -rf " .. pictures.folder) end

return pictures
