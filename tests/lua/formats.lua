-- Tests run files of older releases (in tests/files, written by write.lua there): they are read correctly,
-- continued and merged. tests/unit/test_store_format.c checks their tables.
-- Ordinary collector settings: even under sanitizers this file is run without continuous garbage collection,
-- because it mostly compares texts.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local content = dofile(here .. "/lib/content.lua")
local fresh = dofile(here .. "/../files/write.lua")
local is, ok = tap.is, tap.ok

local folder = os.tmpname()
os.remove(folder)
assert(os.execute("mkdir " .. folder))
local function path(name) return folder .. "/" .. name end

-- Copies a file of tests/files and returns its new path, or nil if the file does not exist.
local function copy(name, to)
  local from = io.open(here .. "/../files/" .. name, "rb")
  if not from then return nil end
  local file = assert(io.open(path(to), "wb"))
  file:write(from:read "a")
  file:close()
  from:close()
  return path(to)
end

-- The columns of the history in the first format; old files have no values of later columns. Old files
-- contain the element type CPE4, which "auto" now chooses for these bodies.
local first = {}
for name in ("update cycle distance jump k alpha p_center p_max half_width depth_cylinder depth_plate "
  .. "volume_cylinder volume_plate depth_partition error solutions"):gmatch "%S+" do
  first[name] = true
end

-- Returns the name of the setting in a line. Settings added later are missing in an old file's definition, so
-- only common settings are compared. `refresh` is ignored: its default has changed, without effect on frozen
-- geometry.
local function definition_of(line) return line:match "^(.*definition%.[%w_.]+) " end

local function settings_in(text)
  local found = {}
  for line in text:gmatch "[^\n]+" do found[definition_of(line) or ""] = true end
  return found
end

local function without_later(text, settings)
  local lines = {}
  for line in text:gmatch "[^\n]+" do
    local column, setting = line:match "history%.([%w_]+)%.%d+ ", definition_of(line)
    line = line:gsub("( definition%.model%.mesh%.element) CPE4$", "%1 auto")
    if (not column or first[column]) and (not setting or settings[setting] and not setting:find "%.refresh$") then
      lines[#lines + 1] = line
    end
  end
  return table.concat(lines, "\n")
end

-- Compares the texts of two files. They must be identical if rounding is the same as on the machine that
-- wrote the old file. Otherwise numbers may differ by 1e-6, because other processors and elimination orders
-- round differently. Checksums guarantee that the bits read are the bits written. Half widths on the coarse
-- elements of these files may differ by 10 %, a fifth of an element: older releases had
-- larger errors at the edges of scars.
local function same(got, expected, what)
  local in_got, in_expected = settings_in(got), settings_in(expected)
  got, expected = without_later(got, in_expected), without_later(expected, in_got)
  if got == expected then return ok(true, what) end
  tap.note(what .. ": numbers may differ by rounding on this machine")
  local theirs = expected:gmatch "[^\n]+"
  for line in got:gmatch "[^\n]+" do
    local name, a = line:match "^(.*) (%S+)$"
    local other_name, b = (theirs() or ""):match "^(.*) (%S+)$"
    local x, y = tonumber(a), tonumber(b)
    local allowed = name and name:find "half_width" and 0.1 or 1e-6
    local near = a == b or x and y and math.abs(x - y) <= allowed * math.max(1e-9, math.abs(y))
    if name ~= other_name or not near then return is(line, name .. " " .. tostring(b), what) end
  end
  return ok(theirs() == nil, what)
end

local function history_of(run)
  local lines = {}
  for name, column in pairs(run.history) do
    for i, value in ipairs(column) do
      lines[#lines + 1] = ("history.%s.%d %s"):format(name, i, value ~= value and "nan" or ("%a"):format(value))
    end
  end
  table.sort(lines)
  return table.concat(lines, "\n")
end

local whole = content(fresh.study():run{ file = path "fresh", workers = 1, progress = false })
fresh.study():run{ file = path "rest", workers = 1, shard = "2/2", progress = false }

local function test_format(format)
  local function file(kind) return "format-" .. format .. "." .. kind end
  local function of(what) return ("format %d: %s"):format(format, what) end

  same(content(study.open(copy(file "study", "study"))), whole, of "a study is opened")
  local seconds = study.open(path "study"):cases()[1].seconds
  local again = fresh.study():run{ file = path "study", workers = 1, progress = false }
  is(again:cases()[1].seconds, seconds, of "a finished study is not computed again")
  same(content(again), whole, of "a finished study is not changed by running it again")

  copy(file "share", "share")
  local merged = study.merge(path "share", path "rest", { file = path "merged" })
  same(content(merged), whole, of "a shard is merged with a shard of the present format")
  is(study.open(path "share"):cases()[2].status, "waiting", of
    "a case that was not computed has the status waiting")
  same(content(fresh.study():run{ file = path "share", workers = 2, progress = false }), whole,
    of "an interrupted study is continued")

  local run, direct = wear.open(copy(file "wear", "wear")), fresh.wear()
  direct:step(2)
  same(history_of(run), history_of(direct), of "history of a saved run")
  local peak, travel = run.p_peak, run.travel
  run:run()
  ok((format > 2 or peak ~= peak) and run.p_peak >= run.p_max, of
    "the largest pressure of a cycle is NaN in old files and computed in later steps")
  ok((format > 3 or travel ~= travel) and run.travel == 0.11 and run.history.load[#run.history.load] == 100,
    of "load and travel are NaN in old files and computed in later steps")
  direct:run()
  same(history_of(run), history_of(direct), of "a saved run is continued")
  is(run:save(path "wear"), run, of "a continued run is saved to the same file")
  is(wear.open(path "wear").update, direct.update, of "the saved file has the present format")

  if not copy(file "auto", "auto") then return end
  local automatic, like = wear.open(path "auto"), fresh.wear "auto"
  is(automatic.jump, "auto", of "a saved run with automatic steps")
  automatic:run()
  like:run()
  same(history_of(automatic), history_of(like), of "a saved run with automatic steps is continued")
end

local format = 1
while io.open(here .. "/../files/format-" .. format .. ".wear") do
  test_format(format)
  format = format + 1
end

os.execute("rm -r " .. folder)
