-- Reads a study from its run file, which may be untrusted. All values that other modules use are checked
-- here; the store has already checked the rows.

local check = require "archard.lib.check"
local design = require "archard.uncertainty.design"

local function damaged(where, store, what, ...)
  check.fail(where, ("%s: the file is damaged: " .. what):format(store.path, ...), "FORMAT")
end

-- Raises an error if a number is not finite, or if a setting with a value is part of another setting with a
-- value, such as "alpha.x" and "alpha".
local function check_case(where, store, id, flat)
  for name, value in pairs(flat) do
    local owner = name:match "^(.*)%."
    while owner do
      if flat[owner] ~= nil then damaged(where, store, "case %d has the settings '%s' and '%s'", id, owner, name) end
      owner = owner:match "^(.*)%."
    end
    if type(value) == "number" and not check.number.test(value) then
      damaged(where, store, "case %d: '%s' is not a finite number", id, name)
    end
  end
end

-- Returns the flat settings of the cases in a list. The ids of the cases must be 1, 2, ...
local function cases_of(where, store)
  local list = {}
  for i, case in ipairs(store:cases()) do
    if case.id ~= i then damaged(where, store, "it has a case %d, but no case %d", case.id, i) end
    list[i] = store:values(i, "settings")
    check_case(where, store, i, list[i])
  end
  if #list == 0 then damaged(where, store, "it has no cases") end
  return list
end

local function sample_of(where, store, flat)
  local text = store:info("sample")
  if not text then return nil end
  local sample = design.parse(text)
  local missing = sample and design.missing(sample, flat)
  if not sample or missing then damaged(where, store, "%s", missing or "invalid samples: " .. check.plain(text:sub(1, 60))) end
  return sample
end

local function snapshots_of(where, store)
  local text = store:info("looks")
  local snapshots = text and math.tointeger(tonumber(text))
  if text and (not snapshots or snapshots < 0) then damaged(where, store, "%s looks", text) end
  return snapshots
end

local tasks = check.one_of{ "wear", "converge" }

local function task_of(where, store)
  local task = store:info("task")
  if task and not tasks.test(task) then damaged(where, store, "unknown task '%s'", task) end
  return task
end

-- An empty file is read as a study without cases. Such a file remains if a program is killed during its
-- start.
local function read(where, store)
  local kind = store:info("kind")
  if not kind and #store:cases() == 0 then return { flat = {} } end
  if kind ~= "study" then
    check.fail(where, ("%s: expected a run file of kind study, got %s"):format(store.path, tostring(kind)), "FORMAT")
  end
  local name, flat = store:info("name"), cases_of(where, store)
  return { name = name and check.plain(name), snapshots = snapshots_of(where, store), task = task_of(where, store),
    flat = flat, sample = sample_of(where, store, flat) }
end

-- Reads the study in the run file `store`. Returns { name=, snapshots=, task=, flat=, sample= }.
return function(where, store) return check.as(where, read, where, store) end
