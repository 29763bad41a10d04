-- Tests wrong calls of every public function, made from the help entries. Each wrong value gives an error
-- with the function, the argument, the expected and the given value, and with the position of the user's
-- call.
-- Ordinary collector settings: even under sanitizers this file is run without continuous garbage collection,
-- because it only checks error messages.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local help, names = require "archard.help", require "archard.names"

local folder = os.tmpname()
os.remove(folder)
assert(os.execute("mkdir " .. folder))
local function path(name) return folder .. "/" .. name end

local calls = dofile(here .. "/lib/calls.lua")(folder)
local objects, before, beside, callee = calls.objects, calls.before, calls.beside, calls.callee
local copy, put, w = calls.copy, calls.put, calls.wear

-- --- wrong values --------------------------------------------------------------------------------

local wrong = { true, -1, 0 / 0, math.huge, path "nonsense", path "a\0b", "", {}, { "a" }, { nonsense = 1 }, { {} },
  function() end, coroutine.create(print), io.stderr, material{}, w, objects.profile }

-- --- messages ------------------------------------------------------------------------------------

-- Words in messages that state the expected value, or the reason to refuse a value of the right kind.
local reasons = { "expected", "unknown field", "by name", "must be", "needs", "no column", "known:", "did you mean",
  "No such file", "nothing to draw", "no points", "not varied", "of its wear box", "contains another", "holds another", "holds a ",
  "not a run file", "belongs to", "only allowed for", "is almost 0", "has no surface stored", "no scar is", "do not overlap" }

local function has_one(text, list)
  for _, words in ipairs(list) do
    if text:find(words, 1, true) then return true end
  end
  return false
end

-- Returns the strings of which a message must contain at least one: the parts of the field's path, or strings that
-- replace the path.
local function names_of(field)
  local list = { "unknown field", "panel ", "curve ", "cannot read", "holds a " }
  for part in field:gmatch "[^.]+" do list[#list + 1] = part end
  return list
end

-- Returns the part that is missing in the message of a failed call, or nil.
local function lack(err, address, field)
  if type(err) ~= "table" or not err.message then return "an error object" end
  local text = tostring(err)
  if text:find "^scripts/" or text:find "[^%w]scripts/" then return "a position in the user's script" end
  if not err.where:find(address:match("[^.]+$"), 1, true) then return "the function's name" end
  if field and not has_one(err.message, names_of(field)) then return "the field's name" end
  if err.message:find "expected" and not has_one(err.message, { "got", "holds" }) then return "the value" end
  if err.message:find "%-nan" then return "NaN without a sign" end
  return not has_one(err.message, reasons) and "the expected value" or nil
end

local refused, lacking = 0, {} -- by function

local function try(f, address, field, value, ...)
  local fine, err = pcall(f, ...)
  lacking[address] = lacking[address] or {}
  if fine then return end
  refused = refused + 1
  local what, list = lack(err, address, field), lacking[address]
  if what then
    list[#list + 1] = ("%s <- %s lacks %s: %s"):format(field or "argument", names.shown(value), what, tostring(err))
  end
end

-- Returns true for calls that are valid but need much time.
local function would_work(address, value)
  if type(value) ~= "table" or getmetatable(value) then return false end
  return address == "study.figures" or address == "study.converge" and next(value) == nil
end

-- Calls a function with each wrong value as the first argument.
local function try_arguments(entry)
  local f = callee(entry)
  for _, value in ipairs(f and wrong or {}) do
    if not would_work(entry.address, value) then try(f, entry.address, nil, value, value) end
  end
end

-- Calls a function with each wrong value in the field of its table that a help entry describes.
local function try_field(entry)
  local owner, field = entry.owner, (entry.path ~= "" and entry.path .. "." or "") .. entry.name
  local f = callee(help.entry(owner))
  for _, value in ipairs(f and wrong or {}) do
    if not (field == "base" and would_work(owner, value)) then
      local list = table.move(before[owner] or {}, 1, 9, 1, {})
      list[#list + 1] = put(copy(beside[owner] or {}), field, value)
      try(f, owner, field, value, table.unpack(list))
    end
  end
end

-- --- main loop -----------------------------------------------------------------------------------

-- Discards the output and pictures of calls that succeed.
local kept = print
print = function() end
io.output "/dev/null"
local callable = { ["function"] = true, method = true, constructor = true }
for _, entry in ipairs(help.all()) do
  if callable[entry.kind] and entry.name ~= "close" then try_arguments(entry) end
  if entry.kind == "option" then try_field(entry) end
end
io.output(io.stdout)
print = kept

local addresses = {}
for address in pairs(lacking) do addresses[#addresses + 1] = address end
table.sort(addresses)
for _, address in ipairs(addresses) do
  if not tap.ok(#lacking[address] == 0, address) then tap.note(table.concat(lacking[address], "\n")) end
end
tap.ok(refused > 6000, ("%d wrong calls are refused with complete messages"):format(refused))
os.execute("rm -rf " .. folder)
