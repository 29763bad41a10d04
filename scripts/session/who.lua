-- who(): lists the globals of the session, one per line.

local names = require "archard.names"
local own = require "archard.session.own"
local pretty = require "archard.lib.pretty"
local term = require "archard.term"

-- Functions by class. Each returns a short text that distinguishes objects of this class. Values of other
-- classes are shown by the first line of their printed form.
local tell = {}

function tell.wear(w)
  return ("cycle %.6g of %.6g, %d update%s%s"):format(w.cycle, w.cycles, math.tointeger(w.update) or 0,
    w.update == 1 and "" or "s", w.update > 0 and (w.saved and ", saved" or ", not saved") or "")
end

tell["function"] = function(f)
  local where = debug.getinfo(f, "S")
  return where.what == "C" and "in C" or ("%s:%d"):format(where.short_src, where.linedefined)
end

local function words(each)
  local fine, text = pcall(tostring, each.value)
  if fine and text:find("%(closed%)$") then return "closed" end
  if tell[each.class] then return tell[each.class](each.value) end
  if each.class ~= "string" or not fine then text = pretty.format(each.value, { width = 1000 }) end
  return (text:match("^[^\n]*"):gsub("^" .. each.class .. ":? ", ""))
end

local function cut(text, room)
  return utf8.len(text) and utf8.len(text) > room
    and text:sub(1, utf8.offset(text, room - 2) - 1) .. "..." or text
end

-- Returns the list of globals as text, cut to the width of the terminal.
local function lines()
  local rows, wide, class_wide = own.list(), 0, 0
  for _, each in ipairs(rows) do
    wide, class_wide = math.max(wide, #each.name), math.max(class_wide, #each.class)
  end
  local width = term.size()
  for i, each in ipairs(rows) do
    local head = each.name .. (" "):rep(wide - #each.name + 2)
      .. each.class .. (" "):rep(class_wide - #each.class + 2)
    rows[i] = head .. cut(words(each), math.max(20, width - #head))
  end
  return rows[1] and table.concat(rows, "\n") or "no variables yet; w = wear{} creates a run"
end

return function() print(names.plain(lines())) end
