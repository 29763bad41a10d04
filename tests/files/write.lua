-- Writes the run files of format N, with which later releases are tested. Run this script with the program of the
-- release that writes format N:
--   archard tests/files/write.lua tests/files/format-N.
local prefix = arg and arg[1]
local base = { geometry = "frozen", increments = 8, distance = 88, jump = 100,
  model = { mesh = { size = 0.06, height = 0.06 } } }

-- older releases name the field `snapshots` "looks"
local snapshots = pcall(study, { base = base, looks = 1, vary = { alpha = { 0 } } }) and "looks" or "snapshots"
local function new_study() return study{ name = "old", base = base, [snapshots] = 1,
  vary = { alpha = { 0.25, 0.5 } } } end

local function new_wear(jump)
  local definition = {}
  for name, value in pairs(base) do definition[name] = value end
  definition.scheme, definition.jump = "explicit", jump or base.jump
  return wear(definition)
end

if arg and arg[0] and arg[0]:find "write%.lua$" then
  local run = new_wear()
  run:step(2)
  run:save(prefix .. "wear")
  local auto = new_wear "auto"
  auto:step(2)
  auto:save(prefix .. "auto")
  new_study():run{ file = prefix .. "study", workers = 1, progress = false }
  new_study():run{ file = prefix .. "share", workers = 1, shard = "1/2", progress = false }
end

return { study = new_study, wear = new_wear }
