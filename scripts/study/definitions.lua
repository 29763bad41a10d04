-- The definitions of a study in its run file: writing them, and whether a file holds this very study.
-- Leans on archard.store.

local check = require "archard.lib.check"
local design = require "archard.uncertainty.design"
local settings = require "archard.definition.settings"
local transaction = require "archard.study.transaction"

local definitions = {}

-- Opens a run file; what fails is told of as the call that the user made.
function definitions.open(where, path, mode)
  return check.as(where, require "archard.store".open, path, mode)
end

-- As many cases as the study has, all waiting.
local function write(self, store)
  store:set_info("kind", "study")
  store:set_info("name", self.name)
  store:set_info("looks", tostring(self.looks))
  store:set_info("task", self.task)
  if self.sample then store:set_info("sample", self.sample.text or design.text(self.sample)) end
  store:set_info("program", "archard " .. require "archard".version)
  local carried = settings.carrier("study")
  for id, flat in ipairs(self.flat) do
    store:add(id, self.labels[id])
    store:set_values(id, "settings", carried(flat))
  end
end

function definitions.write(self, store) transaction(store, write, self, store) end

local function other_study(where, store, what)
  check.fail(where, ("%s holds another study (%s); name another file, or remove it")
    :format(store.path, what), "ARGUMENT")
end

-- Whether the file holds this very study: then it goes on.
local function compare(where, self, store)
  local kind = store:info("kind")
  if kind ~= "study" then other_study(where, store, "its kind is " .. tostring(kind)) end
  local cases = store:cases()
  if #cases ~= #self.flat then
    other_study(where, store, ("it has %d cases, this one %d"):format(#cases, #self.flat))
  end
  local carried = settings.carrier(where)
  for id, given in ipairs(self.flat) do
    local flat, there = carried(given), store:values(id, "settings")
    local name = settings.difference(flat, there)
    if name then
      other_study(where, store, ("case %d has %s = %s there, %s here"):format(id, name,
        settings.shown(there[name]), settings.shown(flat[name])))
    end
  end
end

local function write_or_compare(where, self, store)
  if #store:cases() == 0 and not store:info("kind") then write(self, store) else compare(where, self, store) end
end

-- The run file of a study, open for writing: a new one with its definitions, or one that holds them.
function definitions.for_run(where, self, path)
  local store = definitions.open(where, path, "create")
  store:check()
  transaction(store, write_or_compare, where, self, store)
  return store
end

return definitions
