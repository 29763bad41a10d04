-- Searches the help entries, topics and examples for texts that contain all words of a phrase.

local synonyms = require "archard.help.synonyms"

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

local meanings = {} -- address lists of the synonyms, by their words
for name, addresses in pairs(synonyms) do meanings[table.concat(search.words(name), " ")] = addresses end

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
-- 2: it is a topic or an example; 3: its address contains the words; 4: its text contains the words; 5 to
-- 7: the same as 2 to 4 for parts of words.
local function rank(words, joined, entry)
  if search.plain(entry.name) == joined then return 1 end
  local text = table.concat({ entry.address, entry.use or "", entry.unit or "", entry.text }, " ")
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

-- Returns a table from the addresses that a synonym lists to their positions in the list.
local function by_synonym(joined)
  local positions = {}
  for position, address in ipairs(meanings[joined] or {}) do
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

-- Returns the beginning of a word without its usual endings, as a pattern that finds it at the start of a word.
local function stem(word)
  local short = word:gsub("ing$", ""):gsub("ed$", ""):gsub("es?$", "")
  if #short < 4 then short = word end
  return "%f[%w]" .. short:gsub("%p", "%%%0")
end

-- Returns the entries that contain at least half of the words of a phrase, the best first. Words that few
-- entries contain weigh more. fillers: set of words that do not count.
function search.nearly(entries, text, fillers)
  local words, texts, score = {}, {}, {}
  for _, word in ipairs(search.words(text)) do
    if not fillers[word] then words[#words + 1] = { stem = stem(word), among = {} } end
  end
  for i, entry in ipairs(entries) do
    texts[i] = search.plain(table.concat({ entry.address, entry.use or "", entry.text }, " "))
  end
  local all = 0
  for _, word in ipairs(words) do
    for i in ipairs(entries) do
      if texts[i]:find(word.stem) then table.insert(word.among, i) end
    end
    local weight = math.log(#entries / math.max(#word.among, 1))
    all = all + (word.among[1] and weight or 0)
    for _, i in ipairs(word.among) do score[i] = (score[i] or 0) + weight end
  end
  local found = {}
  for i in ipairs(entries) do
    if score[i] and score[i] > all / 2 then found[#found + 1] = i end
  end
  table.sort(found, function(a, b)
    if score[a] ~= score[b] then return score[a] > score[b] end
    return a < b
  end)
  for k, i in ipairs(found) do found[k] = entries[i] end
  return found
end

return search
