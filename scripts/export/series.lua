-- export.pvd: a run as it wears, a .vtu for each body and state beside a .pvd that lists them by
-- travelled distance. Leans on archard.files for both.

local check = require "archard.lib.check"
local files = require "archard.files"

local where = "export.pvd"
local escapes = { ["&"] = "&amp;", ["<"] = "&lt;", ['"'] = "&quot;" }

-- The list of all states so far: a reader finds a whole series at any time.
local function write_list(path, parts)
  local lines = { '<?xml version="1.0"?>', '<VTKFile type="Collection" version="1.0">', "<Collection>" }
  for _, part in ipairs(parts) do
    lines[#lines + 1] = ('<DataSet timestep="%s" part="%d" file="%s"/>'):format(
      files.number(part.distance), part.number, (part.file:match("[^/]*$"):gsub('[&<"]', escapes)))
  end
  lines[#lines + 1] = "</Collection>\n</VTKFile>\n"
  files.write(where, path, table.concat(lines, "\n"))
end

-- The files of the present state, added to `parts`; state numbers count from 0.
local function add_state(run, stem, parts, number)
  for i, file in ipairs{ check.as(where, files.vtk, run, ("%s-%05d.vtu"):format(stem, number)) } do
    parts[#parts + 1] = { file = file, number = i - 1, distance = run.distance, update = run.update }
  end
end

-- The path without its ending, which is .pvd.
local function stem_of(path)
  if not check.file.test(path) then check.refuse(where, "path", "a file name", path) end
  local stem, ending = path:match("^(.-)(%.[^./]*)$")
  if ending and ending ~= ".pvd" then
    check.refuse(where, "path", "a file name that ends in .pvd", path)
  end
  if not utf8.len(path:match "[^/]*$") then
    check.refuse(where, "path", "a name in UTF-8, since no other stands in XML", path)
  end
  return stem or path
end

-- (run, path, { every= }) -> a function that adds the present state: always when it is called by
-- itself, where one is due as the progress function of w:run
return function(run, path, options)
  if check.shown(run) ~= "a wear object" then
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
  io.stderr:write(("archard: %s: wrote %s.pvd, of one state at %.6g mm; %s\n"):format(where, stem, run.distance,
    run.done and "the run has ended: more states need export.pvd before the run, as progress of w:run"
    or "w:run{ progress = the function returned } adds the next ones"))
  return function(asked_by)
    if not asked_by or run.update % (options.every or 1) == 0 or run.done then add() end
  end
end
