-- A study as its run file has it. The file may be a stranger's: all that the rest relies on is checked
-- here, once. Leans on archard.store, which has checked its rows.

local check = require "archard.lib.check"
local design = require "archard.uncertainty.design"

local function damaged(where, store, what, ...)
  check.fail(where, ("%s: the file is damaged: " .. what):format(store.path, ...), "FORMAT")
end

-- Settings that lie in a value, "alpha.x" beside "alpha", or are no finite numbers are none of a study.
local function check_case(where, store, id, flat)
  for name, value in pairs(flat) do
    local owner = name:match "^(.*)%."
    while owner do
      if flat[owner] ~= nil then damaged(where, store, "case %d has the settings '%s' and '%s'", id, owner, name) end
      owner = owner:match "^(.*)%."
    end
    if type(value) == "number" and not check.number.test(value) then
      damaged(where, store, "case %d: '%s' is no finite number", id, name)
    end
  end
end

-- The flat settings of the cases, which count from 1.
local function cases_of(where, store)
  local list = {}
  for i, case in ipairs(store:cases()) do
    if case.id ~= i then damaged(where, store, "it has a case %d, but no case %d", case.id, i) end
    list[i] = store:values(i, "settings")
    check_case(where, store, i, list[i])
  end
  if #list == 0 then damaged(where, store, "it has no case") end
  return list
end

local function sample_of(where, store, flat)
  local text = store:info("sample")
  if not text then return nil end
  local sample = design.parse(text)
  local missing = sample and design.missing(sample, flat)
  if not sample or missing then damaged(where, store, "%s", missing or "its samples are none: " .. check.plain(text:sub(1, 60))) end
  return sample
end

local function looks_of(where, store)
  local text = store:info("looks")
  local looks = text and math.tointeger(tonumber(text))
  if text and (not looks or looks < 0) then damaged(where, store, "%s looks", text) end
  return looks
end

local tasks = check.one_of{ "wear", "converge" }

local function task_of(where, store)
  local task = store:info("task")
  if task and not tasks.test(task) then damaged(where, store, "the task '%s' is none of a study", task) end
  return task
end

-- A program that was killed as it began leaves a file with nothing in it: a study without cases.
local function read(where, store)
  local kind = store:info("kind")
  if not kind and #store:cases() == 0 then return { flat = {} } end
  if kind ~= "study" then
    check.fail(where, ("%s: expected a run file of kind study, got %s"):format(store.path, tostring(kind)), "FORMAT")
  end
  local name, flat = store:info("name"), cases_of(where, store)
  return { name = name and check.plain(name), looks = looks_of(where, store), task = task_of(where, store),
    flat = flat, sample = sample_of(where, store, flat) }
end

-- (where, store) -> { name=, looks=, task=, flat=, sample= } of a study.
return function(where, store) return check.as(where, read, where, store) end
