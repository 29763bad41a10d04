-- Simulates power cuts: replays the operations of a program on a folder, recorded by tests/memory/power.c,
-- computes states that a disk may have after a power cut, and checks each state.
--   archard tests/trust/power.lua BEFORE LOG WORK COUNT SEED TARGET...
-- BEFORE is a copy of the folder at the start, LOG the record of the operations, WORK a folder for the computed
-- states, COUNT the approximate number of states, SEED the seed of the random numbers. Each TARGET must have its initial content or the content after
-- one of the program's own commits. Prints the errors found and the number of states checked.
--
-- Model of the disk: a sector of 512 bytes is written completely or not at all. Data written since the last
-- fsync of a file may be on the disk in any part and order. The length of a file is one of the lengths since
-- the last fsync. Names change in the order of the operations and are certain after the fsync of their
-- folder.

local stores = require "archard.store"

local SECTOR = 512
local before, log, work, count, seed = arg[1], arg[2], arg[3], tonumber(arg[4]), tonumber(arg[5])
local targets = table.move(arg, 6, #arg, 1, {})
math.randomseed(seed)

local function bytes_of(path)
  local file <close> = io.open(path, "rb")
  return file and file:read "a"
end

-- --- the list ------------------------------------------------------------------------------------

local function parse(text)
  local list, at = {}, 1
  while at <= #text do
    local what, device, inode, offset, length, first, second, next_at = string.unpack("<c1i8i8i8i8i8i8", text, at)
    local bytes = text:sub(next_at, next_at + length - 1)
    next_at = next_at + length
    list[#list + 1] = { what = what, id = device .. ":" .. inode, offset = offset, bytes = bytes,
      path = text:sub(next_at, next_at + first - 1), other = text:sub(next_at + first, next_at + first + second - 1) }
    at = next_at + first + second
  end
  return list
end

-- --- files ---------------------------------------------------------------------------------------

-- Returns the state of a file: the synchronized sectors and length, and the later writes in order. A write is
-- { sector =, bytes = } with all bytes of the sector, or { length = }.
local function new_file(content)
  local file = { sure = {}, length = #content, now = {}, now_length = #content, pending = {} }
  for s = 0, (#content - 1) // SECTOR do
    file.sure[s] = content:sub(s * SECTOR + 1, (s + 1) * SECTOR)
    file.now[s] = file.sure[s]
  end
  return file
end

local function padded(sector) return (sector or "") .. ("\0"):rep(SECTOR - #(sector or "")) end

local function note(file, write)
  file.pending[#file.pending + 1] = write
  if write.length then file.now_length = write.length end
  if write.sector then file.now[write.sector] = write.bytes end
end

local function write(file, offset, bytes)
  if offset + #bytes > file.now_length then note(file, { length = offset + #bytes }) end
  local at = 1
  while at <= #bytes do
    local s, from = (offset + at - 1) // SECTOR, (offset + at - 1) % SECTOR
    local part = bytes:sub(at, at + SECTOR - from - 1)
    local old = padded(file.now[s])
    note(file, { sector = s, bytes = old:sub(1, from) .. part .. old:sub(from + #part + 1) })
    at = at + #part
  end
end

local function truncate(file, length)
  if length < file.now_length then
    for s = length // SECTOR, (file.now_length - 1) // SECTOR do
      local keep = math.max(0, length - s * SECTOR)
      if file.now[s] then note(file, { sector = s, bytes = padded(file.now[s]:sub(1, keep)) }) end
    end
  end
  note(file, { length = length })
end

local function now(file)
  local list = {}
  for s = 0, (file.now_length - 1) // SECTOR do list[#list + 1] = padded(file.now[s]) end
  return table.concat(list):sub(1, file.now_length)
end

-- Adds the writes of stdio, which the recorder cannot record.
local function compare(file, content)
  if now(file) == content then return end
  if #content ~= file.now_length then truncate(file, #content) end
  for s = 0, (#content - 1) // SECTOR do
    local part = content:sub(s * SECTOR + 1, (s + 1) * SECTOR)
    if padded(file.now[s]) ~= padded(part) then note(file, { sector = s, bytes = padded(part) }) end
  end
end

local function bring(file)
  file.sure, file.length, file.pending = {}, file.now_length, {}
  for s, bytes in pairs(file.now) do file.sure[s] = bytes end
end

-- Returns a possible content of the file after a power cut: each later write is on the disk with the
-- probability `chance`, and the length is one of the later lengths. chance = 1: all writes are on the disk.
local function left_of(file, chance)
  local sectors, length, lengths = {}, file.length, { file.length }
  for s, bytes in pairs(file.sure) do sectors[s] = bytes end
  for _, each in ipairs(file.pending) do
    if each.length then lengths[#lengths + 1] = each.length end
    if each.sector and (chance == 1 or math.random() < chance) then sectors[each.sector] = each.bytes end
  end
  length = chance == 1 and file.now_length or chance == 0 and file.length or lengths[math.random(#lengths)]
  local list = {}
  for s = 0, (length - 1) // SECTOR do list[#list + 1] = padded(sectors[s]) end
  return table.concat(list):sub(1, length)
end

-- --- the folder ----------------------------------------------------------------------------------

local files, names, sure_names, changes = {}, {}, {}, {}

local function rename(list, change)
  if change.what == "U" then list[change.path] = nil end
  if change.what == "N" then list[change.path] = change.file end
  if change.what == "L" or change.what == "R" then list[change.other] = list[change.path] end
  if change.what == "R" then list[change.path] = nil end
end

local function change_names(op, file)
  local change = { what = op.what, path = op.path, other = op.other, file = file }
  changes[#changes + 1] = change
  rename(names, change)
end

local apply = {
  N = function(op) files[op.id] = new_file "" change_names(op, files[op.id]) end,
  W = function(op) write(files[op.id], op.offset, op.bytes) end,
  T = function(op) truncate(files[op.id], op.offset) end,
  C = function(op) compare(files[op.id], op.bytes) end,
  S = function(op) bring(files[op.id]) end,
  R = change_names, L = change_names, U = change_names,
  D = function()
    for _, change in ipairs(changes) do rename(sure_names, change) end
    changes = {}
  end,
}

-- ignores fsync on request: the test must then find wrong states
if os.getenv "POWER_BLIND" then apply.S = function() end end

-- --- checks --------------------------------------------------------------------------------------

local function lines_of(lines, name, value)
  if type(value) ~= "table" then
    lines[#lines + 1] = name .. " " .. (math.type(value) == "float" and ("%a"):format(value) or tostring(value))
    return
  end
  local keys = {}
  for key in pairs(value) do keys[#keys + 1] = key end
  table.sort(keys, function(a, b) return tostring(a) < tostring(b) end)
  for _, key in ipairs(keys) do lines_of(lines, name .. "." .. tostring(key), value[key]) end
end

-- Returns all data of a run file as text.
local function said_by(path)
  local store <close> = stores.open(path, "read")
  store:check()
  local lines = { "kind " .. tostring(store:info "kind") }
  for _, case in ipairs(store:cases()) do
    lines_of(lines, "case", case)
    for _, use in ipairs { "settings", "definition", "results" } do lines_of(lines, use, store:values(case.id, use)) end
    lines_of(lines, "history", store:history(case.id))
    lines_of(lines, "surfaces", store:surfaces(case.id))
  end
  return table.concat(lines, "\n")
end

-- Returns the state of a target: "absent", the bytes of a file that is not an SQLite file, or the text of a
-- run file.
local function look(content)
  if not content then return "absent" end
  if content:sub(1, 15) ~= "SQLite format 3" then return content end
  local fine, said = pcall(said_by, work .. "/target")
  return fine and said or error(said, 0)
end

local function put(name, content)
  os.remove(work .. "/" .. name)
  if not content then return end
  local file <close> = assert(io.open(work .. "/" .. name, "wb"))
  file:write(content)
end

-- Returns a possible state of a target after a power cut. chance: probability that a write is on the disk;
-- cut: number of changes of names before the power cut.
local function state_of(target, chance, cut)
  local list = {}
  for name, file in pairs(sure_names) do list[name] = file end
  for i = 1, cut do rename(list, changes[i]) end
  local file, journal = list[target], list[target .. "-journal"]
  local content = file and left_of(file, chance)
  put("target", content)
  put("target-journal", journal and left_of(journal, chance))
  return look(content)
end

-- --- replays -------------------------------------------------------------------------------------

local allowed, tried, wrong, seen = {}, 0, 0, 0

-- Reads the recorded operations. A file that existed at the start is created when its first operation is
-- replayed.
local ops = parse(bytes_of(log))
assert(#ops > 0, "nothing was written")
local function known(op)
  if op.what == "N" or op.id == "0:0" or files[op.id] or op.what == "D" then return end
  files[op.id] = names[op.path] or new_file(bytes_of(before .. "/" .. op.path)
    or error("a write to a file that nobody made: " .. op.what .. " " .. op.path))
end

local function step(op)
  known(op)
  apply[op.what](op)
end

-- Checks that a state equals one of the states of the uninterrupted program.
local function try(target, chance, cut, at)
  tried = tried + 1
  local fine, found = pcall(state_of, target, chance, cut)
  if fine and allowed[target][found] then return end
  wrong = wrong + 1
  print(("# %s after %d of %d (%s), %g of what was written kept, %d of %d names changed: %s"):format(target, at, #ops,
    ops[at] and ops[at].what or "-", chance, cut, #changes, fine and "neither the old nor the new one" or found))
end

for _, target in ipairs(targets) do allowed[target] = {} end

-- Replays all operations and calls visit(at) at the start and after each operation. The first pass collects
-- the states without a power cut after each change of names, because the removal of a journal is a commit.
local function pass(visit)
  files, changes = {}, {}
  names, sure_names = {}, {}
  for _, target in ipairs(targets) do
    local content = bytes_of(before .. "/" .. target)
    local file = content and new_file(content)
    names[target], sure_names[target] = file, file
  end
  visit(0)
  for at, op in ipairs(ops) do
    step(op)
    visit(at)
  end
end

pass(function(at)
  if at > 0 and not ("ULRN"):find(ops[at].what) then return end
  for _, target in ipairs(targets) do
    local found = state_of(target, 1, #changes)
    if not allowed[target][found] then seen = seen + 1 end
    allowed[target][found] = true
  end
end)

local chances = { 0, 1, 0.5, 0.1, 0.9 }
local share = count / (#ops * #targets)
pass(function(at)
  for _, target in ipairs(targets) do
    local times = math.floor(share) + (math.random() < share % 1 and 1 or 0)
    for _ = 1, times do
      try(target, chances[math.random(#chances)], math.random(0, #changes), at)
    end
  end
end)
print(("%d states, %d ways to stand, %d wrong"):format(tried, seen, wrong))
