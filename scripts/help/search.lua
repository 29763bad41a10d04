-- Searches the help entries, topics and examples for texts that contain all words of a phrase.

local search = {}

-- Returns a text in lower case with blanks instead of hyphens and underscores: "cross-shear" then finds
-- cross_shear.
function search.plain(text) return (text:lower():gsub("[-_]", " ")) end

-- Returns the words of a phrase in plain form, without the s of a plural.
function search.words(text)
  local words = {}
  for word in search.plain(text):gmatch("%S+") do words[#words + 1] = word:gsub("^(%a%a%a+[^aisu])s$", "%1") end
  return words
end

local meanings -- address lists of the synonyms, by their words; nil before the first search
local function addresses_of(joined)
  if not meanings then
    meanings = {}
    for name, addresses in pairs(require "archard.help.synonyms") do
      meanings[table.concat(search.words(name), " ")] = addresses
    end
  end
  return meanings[joined] or {}
end

-- Returns the text in which an entry's words are searched.
local function text_of(entry)
  return table.concat({ entry.address, entry.use or "", entry.unit or "", entry.text }, " ")
end

-- Returns true if the text from `first` to `last` is a whole word or its plural.
local function is_whole(text, first, last)
  local after = text:find("^s%f[%W]", last + 1) and last + 2 or last + 1
  return not text:find("^%w", after) and (first == 1 or not text:find("^%w", first - 1))
end

-- Returns true if a text contains all words. whole: true if only whole words count, false if parts of words
-- count too.
local function contains(words, text, whole)
  text = search.plain(text)
  for _, word in ipairs(words) do
    local at, last = text:find(word, 1, true)
    while whole and at and not is_whole(text, at, last) do at, last = text:find(word, last + 1, true) end
    if not at then return false end
  end
  return true
end

-- Returns the rank of an entry, or nil if the entry does not contain the words. 1: its name is the phrase;
-- 2: it is a topic or an example that contains the words; 3: its address contains them; 4: its text contains
-- them; 5 to 7: as 2 to 4, but with parts of words.
local function rank(words, joined, entry)
  if search.plain(entry.name) == joined then return 1 end
  local text = text_of(entry)
  for _, whole in ipairs{ true, false } do
    local behind = whole and 0 or 3
    local named = contains(words, entry.address, whole)
    if (entry.kind == "topic" or entry.kind == "example") and (named or contains(words, entry.text, whole)) then
      return 2 + behind
    end
    if named then return 3 + behind end
    if contains(words, text, whole) then return 4 + behind end
  end
end

-- Returns a table with the position of each address in the list of a synonym.
local function by_synonym(joined)
  local positions = {}
  for position, address in ipairs(addresses_of(joined)) do
    positions[address] = position
  end
  return positions
end

-- Returns the entries found for a phrase, the best first, and the number of good answers. Good answers are
-- the entries that a synonym lists or, without a synonym, the entries that contain the whole words.
function search.find(entries, text)
  local words, found = search.words(text), {}
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

-- Removes the usual endings of a word. Returns a pattern that finds the remaining letters at the start of a word.
local function stem(word)
  local short = word:gsub("ing$", ""):gsub("ed$", ""):gsub("es?$", "")
  if #short < 4 then short = word end
  return "%f[%w]" .. short:gsub("%p", "%%%0")
end

local fillers = { a = 1, an = 1, ["and"] = 1, by = 1, can = 1, ["do"] = 1, does = 1, ["for"] = 1, from = 1, how = 1, i = 1,
  ["in"] = 1, is = 1, it = 1, my = 1, ["not"] = 1, of = 1, on = 1, ["or"] = 1, the = 1, to = 1, what = 1, with = 1 }

-- Returns the entries that contain more than half of a phrase, measured by the weights of its words, the best
-- first. A word has a larger weight if fewer entries contain it.
function search.nearly(entries, text)
  local texts, score, all = {}, {}, 0
  for i, entry in ipairs(entries) do texts[i], score[i] = search.plain(text_of(entry)), 0 end
  for _, word in ipairs(search.words(text)) do
    local among, pattern = {}, stem(word)
    for i = 1, fillers[word] and 0 or #entries do
      if texts[i]:find(pattern) then among[#among + 1] = i end
    end
    local weight = among[1] and math.log(#entries / #among) or 0
    all = all + weight
    for _, i in ipairs(among) do score[i] = score[i] + weight end
  end
  local found = {}
  for i in ipairs(entries) do
    if score[i] > all / 2 then found[#found + 1] = i end
  end
  table.sort(found, function(a, b) return score[a] > score[b] or score[a] == score[b] and a < b end)
  for k, i in ipairs(found) do found[k] = entries[i] end
  return found
end

return search
