-- Lists the texts in the sources that have three or more words: comments, and string literals (help,
-- messages) outside of tests.
--
--   git ls-files src include scripts tests | archard scripts/tools/texts.lua list
--   git ls-files src include scripts tests | archard scripts/tools/texts.lua draw NUMBER SEED
--   git ls-files src include scripts tests | archard scripts/tools/texts.lua count WORD...
--
-- `list` prints each text after its file and line. `draw` prints NUMBER texts chosen at random. `count`
-- prints how often each Lua pattern WORD occurs as a whole word, in comments and in literals.

local texts = {}

local function words(text) return select(2, text:gsub("%a%a+", "")) end

local function add(kind, file, line, text)
  text = text:gsub("%s+", " "):gsub("^ ", ""):gsub(" $", "")
  if words(text) < 3 or not text:find(" ") then return end
  texts[#texts + 1] = { kind = kind, file = file, line = line, text = text }
end

-- Reads the string literal whose opening quote is at position `at`. Returns its text and the position after
-- it.
local function quoted(source, at)
  local quote, stop = source:sub(at, at), at + 1
  while source:sub(stop, stop) ~= quote and stop <= #source do
    stop = stop + (source:sub(stop, stop) == "\\" and 2 or 1)
  end
  return source:sub(at + 1, stop - 1):gsub("\\n", " "):gsub("\\(.)", "%1"), stop + 1
end

-- Languages by file ending. token(source, at): returns kind, text and end of the token at position `at`;
-- first: set of characters that can begin a token; joint: pattern of the code between two literals that form
-- one text.
local languages = {}

local function c_token(source, at)
  local text, stop = source:match("^//([^\n]*)()", at)
  if text then return "line", text, stop end
  text, stop = source:match("^/%*(.-)%*/()", at)
  if text then return "comment", text:gsub("\n%s*%*", "\n"), stop end
  stop = source:match("^'\\?[^\n]'()", at) or source:match("^#%s*include[^\n]*()", at)
  if stop then return "other", "", stop end
  if source:sub(at, at) == '"' then return "literal", quoted(source, at) end
end
languages.c = { token = c_token, first = "[/'\"#]", joint = "^[%s\\]*$" }
languages.h = languages.c

local function lua_token(source, at)
  local dashes, level, start = source:match("^(%-?%-?)%[(=*)%[()", at)
  if level and (dashes == "" or dashes == "--") then
    local text, stop = source:match("^(.-)%]" .. level .. "%]()", start)
    return dashes == "" and "literal" or "comment", text, stop
  end
  local text, stop = source:match("^%-%-([^\n]*)()", at)
  if text then return "line", text, stop end
  if source:find("^[\"']", at) then return "literal", quoted(source, at) end
end
languages.lua = { token = lua_token, first = "[-'\"%[]", joint = "^%s*%.%.%s*$" }

-- Appends a token to the list, or joins it to the last token. Comments on consecutive lines are joined to one
-- comment, adjacent literals to one literal.
local function append(list, token, between, joint)
  local last = list[#list]
  local joins = last and last.kind == token.kind
    and (token.kind == "line" and last.alone and between:find("^\n[ \t]*$")
      or token.kind == "literal" and between:find(joint))
  if joins then
    last.text, last.stop = last.text .. "\n" .. token.text, token.stop
  else
    list[#list + 1] = token
  end
end

local function tokens(source, language)
  local list, seen, line = {}, 1, 1
  local at = source:find(language.first)
  while at do
    local kind, text, stop = language.token(source, at)
    if kind then
      local between = source:sub(seen, at - 1)
      local alone = at == 1 or between:find("\n[ \t]*$") ~= nil
      line = line + select(2, between:gsub("\n", ""))
      local token = { kind = kind, text = text, line = line, stop = stop, alone = alone }
      append(list, token, between, language.joint)
      line = line + select(2, source:sub(at, stop - 1):gsub("\n", ""))
      seen = stop
    end
    at = source:find(language.first, stop or at + 1)
  end
  return list
end

local function read(name)
  local language = languages[name:match("%.(%a+)$")]
  if not language then return end
  local file = assert(io.open(name))
  for _, token in ipairs(tokens(file:read("a"), language)) do
    local skipped = token.kind == "other" or token.kind == "literal" and name:find("^tests/")
    if not skipped then
      add(token.kind == "literal" and "literal" or "comment", name, token.line, token.text)
    end
  end
  file:close()
end

local function show(text)
  print(("%s:%d: %s: %s"):format(text.file, text.line, text.kind, text.text))
end

local actions = {}

function actions.list()
  for _, text in ipairs(texts) do show(text) end
end

function actions.draw(number, seed)
  math.randomseed(math.tointeger(seed))
  for i = 1, math.min(math.tointeger(number), #texts) do
    local j = math.random(i, #texts)
    texts[i], texts[j] = texts[j], texts[i]
    show(texts[i])
  end
end

function actions.count(...)
  print(("%-16s %8s %8s"):format("word", "comment", "literal"))
  for _, pattern in ipairs{ ... } do
    local sums = { comment = 0, literal = 0 }
    for _, text in ipairs(texts) do
      for word in text.text:lower():gmatch("%a+") do
        if word:find("^" .. pattern .. "$") then sums[text.kind] = sums[text.kind] + 1 end
      end
    end
    print(("%-16s %8d %8d"):format(pattern, sums.comment, sums.literal))
  end
end

local action = actions[arg[1]]
if not action then error("texts.lua: list, draw NUMBER SEED or count WORD..., not " .. tostring(arg[1])) end
for name in io.lines() do read(name) end
action(table.unpack(arg, 2))
