-- Lua function export.pvd: writes a series of states of a run for ParaView. Each state has one .vtu file for
-- each body (in three dimensions, a .vti file of maps). The .pvd file lists all files with their sliding
-- distances.

local check = require "archard.lib.check"
local files = require "archard.files"
local joint_file = require "archard.joint.file"
local maps = require "archard.export.maps"
local vtk = require "archard.export.sphere".vtk
local xml = require "archard.export.xml"

local where = "export.pvd"

-- Writes the .pvd file, which lists the files of all states. It is rewritten after each state, so the list is
-- always complete.
local function write_list(path, parts)
  local lines = { '<?xml version="1.0"?>', '<VTKFile type="Collection" version="1.0">', "<Collection>" }
  for _, part in ipairs(parts) do
    lines[#lines + 1] = ('<DataSet timestep="%s" part="%d" file="%s"/>'):format(
      files.number(part.distance), part.number, xml(part.file:match("[^/]*$")))
  end
  lines[#lines + 1] = "</Collection>\n</VTKFile>\n"
  files.write(where, path, table.concat(lines, "\n"))
end

-- Writes the files of the run's current state and appends them to `parts`. number: number of the state, from
-- 0.
local function add_state(run, stem, parts, number)
  local name = ("%s-%05d"):format(stem, number)
  local is_map = run.model.geometry == "3-D"
  for i, file in ipairs(is_map and maps.bodies(where, run, name) or { check.as(where, vtk, run, name .. ".vtu") }) do
    parts[#parts + 1] = { file = file, number = i - 1, distance = run.distance, update = run.update }
  end
end

-- Checks the path of a .pvd file and returns it without the extension.
local function stem_of(path)
  if not check.file.test(path) then check.refuse(where, "path", "a file name", path) end
  local stem, ending = path:match("^(.-)(%.[^./]*)$")
  if ending and ending ~= ".pvd" then
    check.refuse(where, "path", "a file name that ends in .pvd", path)
  end
  if not utf8.len(path:match "[^/]*$") then
    check.refuse(where, "path", "a name in UTF-8, as required by XML", path)
  end
  return stem or path
end

-- export.pvd(run, path, { every= }) writes the current state and returns a function that adds states. The
-- returned function, called without arguments, adds the current state. As the progress function of w:run,
-- it adds a state after every n-th update (n = every, default 1) and at the end of the run.
return function(run, path, options)
  if check.shown(run) ~= "a wear object" and not joint_file.is_joint(run) then
    check.fail(where, "expected a wear object, got " .. check.shown(run))
  end
  local stem = stem_of(path)
  options = check.definition(where, options or {}, { every = check.whole(1) })
  local parts, states = {}, 0

  local function add()
    local last = parts[#parts]
    if last and last.update == run.update then return end
    add_state(run, stem, parts, states)
    states = states + 1
    write_list(stem .. ".pvd", parts)
  end

  add()
  io.stderr:write(("archard: %s: wrote %s.pvd with one state at %.6g mm; %s\n"):format(where, stem, run.distance,
    run.done and "the run has ended: for more states call export.pvd before the run and use its result as progress of w:run"
    or "the returned function adds states, as progress of w:run"))
  return function(run_now)
    if not run_now or run.update % (options.every or 1) == 0 or run.done then add() end
  end
end
