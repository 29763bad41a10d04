-- Prints a run file of a study as text, without times; equal texts mean identical bits. Usage:
--   archard tests/lua/lib/content.lua FILE

local function add(lines, name, value)
  if type(value) == "table" then
    local keys = {}
    for key in pairs(value) do keys[#keys + 1] = key end
    table.sort(keys, function(a, b)
      if type(a) == type(b) then return a < b end
      return type(a) == "number"
    end)
    for _, key in ipairs(keys) do add(lines, name .. "." .. key, value[key]) end
  elseif value ~= value then
    lines[#lines + 1] = name .. " nan"
  else
    lines[#lines + 1] = name .. " " .. (type(value) == "number" and ("%a"):format(value)
      or tostring(value))
  end
end

-- Returns the content of a study as text. `every` = n checks the continuation state only in every n-th case;
-- nil: in all cases.
local function content(s, every)
  local lines = {}
  for _, case in ipairs(s:cases()) do
    add(lines, case.id .. " status", case.status)
    add(lines, case.id .. " settings", case.settings)
    add(lines, case.id .. " definition", case.definition)
    add(lines, case.id .. " history", case.history or "none")
    add(lines, case.id .. " surfaces", case.surfaces)
    if case.status == "done" and case.id % (every or 1) == 0 then
      -- checks the continuation state by continuing the run
      local run <close> = case:wear()
      run:set{ distance = 2 * run.distance }
      run:step()
      add(lines, case.id .. " next", { run.p_center, run.depth.plate, run.distance })
    end
  end
  return table.concat(lines, "\n")
end

if arg and arg[0] and arg[0]:find("content%.lua$") then
  print(content(study.open(arg[1])))
else
  return content
end
