-- Searches the help entries, topics and examples for texts that contain all words of a phrase, and for texts that
-- answer a question.

local search = {}

-- Returns a text in lower case with blanks instead of hyphens and underscores: "cross-shear" then finds
-- cross_shear.
function search.plain(text) return (text:lower():gsub("[-_]", " ")) end

-- Returns a list of the words of a phrase in plain form, without the s of a plural.
function search.words(text)
  local words = {}
  for word in search.plain(text):gmatch("%S+") do words[#words + 1] = word:gsub("^(%a%a%a+[^aisu])s$", "%1") end
  return words
end

local meanings -- lists of addresses, indexed by the words of a synonym; nil before the first search
local function synonyms()
  if not meanings then
    meanings = {}
    for name, addresses in pairs(require "archard.help.synonyms") do
      meanings[table.concat(search.words(name), " ")] = addresses
    end
  end
  return meanings
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

-- Returns true if a text contains all words of a phrase, with any endings.
function search.contains(phrase, text)
  return contains(search.words(phrase), text, false)
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

-- Returns the position of each address in the list of a synonym, as a table indexed by address.
local function by_synonym(joined)
  local positions = {}
  for position, address in ipairs(synonyms()[joined] or {}) do
    positions[address] = position
  end
  return positions
end

-- Returns the entries found for a phrase, the best first, the number of good answers, and true if these are
-- from a synonym. Without a synonym, good answers are the entries that contain the whole words.
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
  return found, sure, next(meant) ~= nil
end

-- --- questions ---------------------------------------------------------------------------------

-- Removes the usual endings of a word. Returns a pattern that finds the remaining letters at the start of a word.
local function stem(word)
  local short = word:gsub("ing$", ""):gsub("ed$", ""):gsub("es?$", "")
  if #short < 4 then short = word end
  return "%f[%w]" .. short:gsub("%p", "%%%0")
end

-- Words of questions that do not describe the subject.
local fillers = {}
for word in ([[a about an and any apply are as at be both but by can cannot choose could define do does during each for from
  get give given has have how i if in into is it its just kind like make many mean means meaning me my need no not of on one
  only or our own please see set should show so specify such than that the their them then there they this to two us use used
  using value was we what when where whether which while who why will with without would you your archard program]]):gmatch "%S+" do
  fillers[word] = true
end

-- Returns the words of a question that are not fillers, or all words if there are only fillers. Each word is a
-- table with its pattern.
local function subject_of(question)
  local subject, all = {}, {}
  for _, word in ipairs(search.words(question:gsub("[?!,;:\"']", " "))) do
    local each = { pattern = stem(word) }
    all[#all + 1] = each
    if not fillers[word] then subject[#subject + 1] = each end
  end
  return subject[1] and subject or all
end

-- Sets the weight of each word, which is larger for words that fewer texts contain. Returns the sum of the weights of
-- all words that at least one text contains.
local function weigh(words, texts)
  local sum = 0
  for _, word in ipairs(words) do
    local count = 0
    for _, text in ipairs(texts) do
      if text:find(word.pattern) then count = count + 1 end
    end
    word.weight = math.log((#texts + 1) / (count + 1))
    sum = sum + (count > 0 and word.weight or 0)
  end
  return sum
end

-- Returns the factor by which an entry's score is multiplied. It is larger for topics, objects and functions,
-- because they explain more than single fields.
local function importance(entry)
  if entry.kind == "topic" then return 1.3 end
  if entry.kind == "example" then return 0.8 end
  if entry.kind ~= "option" and entry.kind ~= "field" then return 1.2 end
  return entry.owner and entry.owner:find(".", 1, true) and 0.7 or 0.9
end

-- Returns the score of an entry: the weights of the words in its text, smaller for a long text, and a multiple of the
-- weights of the words in its address.
local function score_of(words, entry, text, mean_length)
  local of_address, of_length, score = 1, 0.1, 0
  local address, length = search.plain(entry.address), 1 - of_length + of_length * #text / mean_length
  for _, word in ipairs(words) do
    if text:find(word.pattern) then score = score + word.weight / length end
    if address:find(word.pattern) then score = score + of_address * word.weight end
  end
  return importance(entry) * score
end

-- Returns the scores that synonyms add to entries, as a table indexed by address. A synonym counts if all its
-- words occur in the question.
local function scores_by_synonym(words, question)
  local of_synonym, scores = 2, {}
  question = search.plain(question)
  for key, addresses in pairs(synonyms()) do
    local sum, all = 0, true
    for part in key:gmatch "%S+" do all = all and question:find(stem(part)) end
    for _, word in ipairs(words) do
      if key:find(word.pattern) then sum = sum + word.weight end
    end
    for position, address in ipairs(all and addresses or {}) do
      scores[address] = math.max(scores[address] or 0, of_synonym * sum / position)
    end
  end
  return scores
end

-- Returns the entries that answer a question, the best first. Their scores exceed a third of the sum of the
-- weights of the question's words. Of entries with the same text, only the first one is returned.
function search.answers(entries, question)
  local words, texts, length = subject_of(question), {}, 0
  for i, entry in ipairs(entries) do
    texts[i] = search.plain(text_of(entry))
    length = length + #texts[i] / #entries
  end
  local all, by_meaning = weigh(words, texts), scores_by_synonym(words, question)
  local found, score = {}, {}
  for i, entry in ipairs(entries) do
    score[i] = score_of(words, entry, texts[i], length) + (by_meaning[entry.address] or 0)
    if score[i] > all / 3 then found[#found + 1] = i end
  end
  table.sort(found, function(a, b) return score[a] > score[b] or score[a] == score[b] and a < b end)
  local list, seen = {}, {}
  for _, i in ipairs(found) do
    local entry = entries[i]
    if not seen[entry.text] then list[#list + 1] = entry end
    seen[entry.text] = true
  end
  return list
end

return search
