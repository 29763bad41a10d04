-- The entries, topics and examples in which all words of a text stand, the nearest first.

local synonyms = require "archard.help.synonyms"

-- Whether all words stand in the text, whole or as parts of others.
local function holds(words, text, whole)
  text = text:lower()
  for _, word in ipairs(words) do
    local at, last = text:find(word, 1, true)
    while whole and at and (text:find("^[%w_]", last + 1) or at > 1 and text:find("^[%w_]", at - 1)) do
      at, last = text:find(word, last + 1, true)
    end
    if not at then return false end
  end
  return true
end

-- 1: its own name, 2: a topic or an example, 3: names, 4: texts, 5 to 7: the same for parts of words; nil: not at all.
local function rank(words, joined, entry)
  if entry.name:lower() == joined then return 1 end
  local text = table.concat({ entry.address, entry.use or "", entry.unit or "", entry.text }, " ")
  for _, whole in ipairs{ true, false } do
    local behind = whole and 0 or 3
    local named = holds(words, entry.address, whole)
    if (entry.kind == "topic" or entry.kind == "example") and (named or holds(words, entry.text, whole)) then
      return 2 + behind
    end
    if named then return 3 + behind end
    if holds(words, text, whole) then return 4 + behind end
  end
end

-- The places of a word's synonyms in the list, by address.
local function by_synonym(joined)
  local places = {}
  for place, address in ipairs(synonyms[joined] or synonyms[joined:gsub("s$", "")] or {}) do places[address] = place end
  return places
end

-- search(entries, text) -> list of entries; how many of them are surely meant: those of a synonym, else
-- those with the whole words.
return function(entries, text)
  local words, found = {}, {}
  for word in text:lower():gmatch("[^%s]+") do words[#words + 1] = word end
  if not words[1] then return found, 0 end
  local joined = table.concat(words, " ")
  local meant, sure = by_synonym(joined), 0
  for order, entry in ipairs(entries) do
    local first = meant[entry.address]
    local place = not first and rank(words, joined, entry)
    if first or place then found[#found + 1] = { entry = entry, key = first or place * 1e6 + order } end
    if first or not next(meant) and place and place < 5 then sure = sure + 1 end
  end
  table.sort(found, function(a, b) return a.key < b.key end)
  for i, each in ipairs(found) do found[i] = each.entry end
  return found, sure
end
