-- help.search(text): the topics and entries in which all words of a text stand, the nearest first.

-- Whether all words stand in the text; nil where one does not.
local function holds(words, text)
  text = text:lower()
  for _, word in ipairs(words) do
    if not text:find(word, 1, true) then return nil end
  end
  return true
end

-- 1: its own name, 2: a topic, 3: names, 4: texts; nil: not at all.
local function rank(words, joined, entry)
  if entry.name:lower() == joined then return 1 end
  local place = holds(words, entry.address)
  if entry.kind == "topic" and (place or holds(words, entry.text)) then return 2 end
  if place then return 3 end
  return holds(words, entry.address .. " " .. (entry.use or "") .. " " .. (entry.unit or "") .. " " .. entry.text) and 4
end

-- search(entries, text) -> list of entries
return function(entries, text)
  local words, found = {}, {}
  for word in text:lower():gmatch("[^%s]+") do words[#words + 1] = word end
  if not words[1] then return found end
  local joined = table.concat(words, " ")
  for order, entry in ipairs(entries) do
    local place = rank(words, joined, entry)
    if place then found[#found + 1] = { entry = entry, key = place * 1e6 + order } end
  end
  table.sort(found, function(a, b) return a.key < b.key end)
  for i, each in ipairs(found) do found[i] = each.entry end
  return found
end
