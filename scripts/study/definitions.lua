-- Writes the definitions of a study to its run file, and checks that an existing run file belongs to the same
-- study.

local check = require "archard.lib.check"
local design = require "archard.uncertainty.design"
local settings = require "archard.definition.settings"
local text_file = require "archard.lib.text_file"
local transaction = require "archard.study.transaction"

local definitions = {}

-- Opens a run file. Errors are reported as errors of `where`, the function that the user called.
function definitions.open(where, path, mode)
  return check.as(where, require "archard.store".open, path, mode)
end

-- Writes the definitions of a study and adds all cases with the status "waiting".
local function write(self, store)
  store:set_info("kind", "study")
  store:set_info("name", self.name)
  store:set_info("looks", tostring(self.snapshots))
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
  check.fail(where, ("%s contains another study (%s); give another file name, or remove the file")
    :format(store.path, what), "ARGUMENT")
end

-- Raises an error if the file contains another study. A file with the same study can be continued.
local function compare(where, self, store)
  local kind = store:info("kind")
  if kind ~= "study" then other_study(where, store, "its kind is " .. tostring(kind)) end
  local cases = store:cases()
  if #cases ~= #self.flat then
    other_study(where, store, ("it has %d cases, this study has %d"):format(#cases, #self.flat))
  end
  local carried = settings.carrier(where)
  for id, given in ipairs(self.flat) do
    local flat, there = carried(given), store:values(id, "settings")
    local name = settings.difference(flat, there)
    if name then
      other_study(where, store, ("case %d has %s = %s in the file, %s in this study"):format(id, name,
        settings.shown(there[name]), settings.shown(flat[name])))
    end
  end
end

local function write_or_compare(where, self, store)
  if #store:cases() == 0 and not store:info("kind") then write(self, store) else compare(where, self, store) end
end

-- Opens the run file of a study for writing. A new file receives the definitions; an existing file must
-- belong to the same study.
function definitions.for_run(where, self, path)
  local store = definitions.open(where, path, "create")
  store:check()
  transaction(store, write_or_compare, where, self, store)
  return store
end

-- --- default file name ---------------------------------------------------------------------------

-- Returns the default name of the run file without extension: the name of the study, else the name of the
-- script, else "study".
local function base_name(self)
  local script = type(arg) == "table" and type(arg[0]) == "string" and arg[0]:match "([^/]+)%.lua$"
  local name = self.named and self.name or script or "study"
  return (name:gsub("[^%w._-]+", "-"):gsub("^[.-]+", "")):sub(1, 100)
end

local function is_free(where, self, path)
  if not text_file.exists(path) then return true end
  return (pcall(function()
    local store <close> = definitions.open(where, path, "read")
    if #store:cases() > 0 or store:info "kind" then compare(where, self, store) end
  end))
end

-- Returns the default path of a study's run file: NAME.archard or, if this file contains other data,
-- NAME-2.archard, and so on.
function definitions.usual_path(where, self)
  local base = base_name(self)
  if base == "" then base = "study" end
  for i = 1, math.huge do
    local path = i == 1 and base .. ".archard" or ("%s-%d.archard"):format(base, i)
    if is_free(where, self, path) then
      if i > 1 then
        warn(("%s: %s.archard contains other data: the study is stored in %s"):format(where, base, path))
      end
      return path
    end
  end
end

return definitions
