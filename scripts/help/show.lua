-- Formats help entries as text that fits the terminal.

local search = require "archard.help.search"
local term = require "archard.term"

local show = {}

local function page_width()
  return math.min((term.size()), 100)
end

local function heading(text)
  return term.colour() and "\27[1m" .. text .. "\27[0m" or text
end

-- Wraps paragraphs, which are separated by empty lines, to the width. Lines that begin with two spaces are not changed.
local function fill(text, width, margin)
  local lines = {}
  local line = ""
  local function flush()
    if line ~= "" then lines[#lines + 1] = margin .. line end
    line = ""
  end
  for source in (text .. "\n"):gmatch("(.-)\n") do
    if source:find("^  ") or source == "" then
      flush()
      lines[#lines + 1] = source == "" and "" or margin .. source
    else
      for word in source:gmatch("%S+") do
        if line ~= "" and #margin + #line + 1 + #word > width then flush() end
        line = line == "" and word or line .. " " .. word
      end
    end
  end
  flush()
  return (table.concat(lines, "\n"):gsub("\n+$", ""))
end

-- Returns the type or the values, the unit and the default of an entry as text, as far as the entry has them.
function show.facts(entry)
  local facts = {}
  if entry.type then
    facts[#facts + 1] = entry.type
  elseif entry.values then
    facts[#facts + 1] = '"' .. table.concat(entry.values, '", "') .. '"'
  end
  if entry.unit then facts[#facts + 1] = "in " .. entry.unit end
  if entry.default ~= nil then facts[#facts + 1] = "default " .. tostring(entry.default) end
  return table.concat(facts, ", ")
end

-- Shortens a text to at most `most` characters, at the end of a word.
local function shortened(text, most)
  if #text <= (most or math.huge) then return text end
  return text:sub(1, most):match("^(.*)%s") .. " ..."
end

function show.first_sentence(text, most)
  local flat = text:gsub(":\n\n.*", "."):gsub("%s+", " ")
  return shortened(flat:match("^(.-[.])%s%u") or flat, most)
end

-- Returns how many of the given words a sentence contains. A word with an ending also counts, such as "wears"
-- for "wear".
local function count_words(words, sentence)
  local count = 0
  sentence = " " .. search.plain(sentence)
  for _, word in ipairs(words) do
    if sentence:find("%W" .. word:gsub("%p", "%%%0")) then count = count + 1 end
  end
  return count
end

-- Returns the sentence of a text that contains the most words of a phrase; among equal sentences, the first
-- one.
local function best_sentence(text, words, most)
  local best, sentence = 0, nil
  for each in (text:gsub("%s+", " ") .. " "):gsub("([.]) (%u)", "%1\n%2"):gmatch("[^\n]+") do
    local count = count_words(words, each)
    if count > best then best, sentence = count, each end
  end
  return sentence and shortened(sentence:match("^(.-)%s*$"), most) or show.first_sentence(text, most)
end

-- Returns a list of entries as text, with a title. Each entry has its name, the first sentence of its text,
-- and its type, unit and default.
local function listing(title, entries, width)
  if #entries == 0 then return nil end
  width = width or page_width()
  local size = 0
  for _, entry in ipairs(entries) do size = math.max(size, #entry.name) end
  local lines = { heading(title) }
  for _, entry in ipairs(entries) do
    local facts = show.facts(entry)
    local text = show.first_sentence(entry.text)
    if facts ~= "" then text = text:gsub("%.?$", "") .. " (" .. facts .. ")." end
    local name = "  " .. entry.name .. (" "):rep(size - #entry.name + 2)
    local body = fill(text, width, (" "):rep(#name))
    lines[#lines + 1] = name .. body:sub(#name + 1)
  end
  return table.concat(lines, "\n")
end

show.listing = listing

-- Returns the first `most` entries of a list as { name=, text= }: the address of each entry, and the
-- sentence that sentence_of selects from its text.
local function shown_by_address(entries, most, sentence_of)
  local list = {}
  for i = 1, math.min(#entries, most) do
    local entry = entries[i]
    local title = entry.kind == "topic" and ('help "%s"'):format(entry.address) or entry.address
    list[i] = { name = title, text = sentence_of(entry.text) }
  end
  return list
end

local longest_sentence = 200 -- characters

-- Returns a text with the first `most` entries found for a phrase. Each entry is shown with its sentence
-- that contains the most words of the phrase.
function show.found(found, text, most)
  local words = search.words(text)
  local list = shown_by_address(found, most or #found, function(each) return best_sentence(each, words, longest_sentence) end)
  local left = #found - #list
  return listing(("%d about %s"):format(#list, text), list)
    .. (left > 0 and ('\n\nmore: help.search "%s"'):format(text) or "")
end

-- Returns a text with the first `most` entries of a list. Each entry is shown with its first sentence.
function show.others(entries, most)
  return listing("See also", shown_by_address(entries, most, function(each) return show.first_sentence(each, longest_sentence) end))
end

local function of_kind(entries, wanted)
  local list = {}
  for _, entry in ipairs(entries) do
    if (entry.kind == "method" or entry.kind == "function") == wanted then
      list[#list + 1] = entry
    end
  end
  return list
end

-- Returns the whole help text of an entry, including its fields and functions. help: the module in
-- help/init.lua.
function show.entry(help, entry)
  local width = page_width()
  local parts = { heading(entry.use or entry.address) }
  local facts = show.facts(entry)
  if facts ~= "" then parts[1] = parts[1] .. "\n" .. fill(facts, width, "  ") end
  parts[#parts + 1] = fill(entry.text, width, "  ")
  local definition
  if entry.kind == "option" then
    local path = (entry.path ~= "" and entry.path .. "." or "") .. entry.name
    definition = help.definition(entry.owner, path)
  else
    definition = help.definition(entry.address)
  end
  local members = entry.kind == "option" and {} or help.members(entry.address)
  parts[#parts + 1] = listing("Fields of the definition", definition, width)
  parts[#parts + 1] = listing("Fields", of_kind(members, false), width)
  parts[#parts + 1] = listing("Functions", of_kind(members, true), width)
  return table.concat(parts, "\n\n")
end

local overview = [[
archard simulates the wear of two sliding bodies, by default a half cylinder and
a plate. Lengths are in mm, forces in N, pressures in MPa.

Describe     material{}  hertz{}  model{}
  bodies     body.punch{ flat=4 }  body.cylinder{ layers={...} }  body.ring{}
  in 3-D     model{ geometry="3-D", upper=body.ball{} }  w:map("block")  map{}
  joints     joint{}:wear{ loading=gait "iso" }
Contact      c = contact{ load=100 }   c.p_max  c:pressure("plate")  c:stress()
  friction   contact{ friction=0.6 }:move{ tangential=30 }  plot.shear(c)
Wear         w = wear{ alpha=0.5 }        w:step()  w:step(10)  w:run()
  results    w  w.history  w:profile("plate")  w:pressure("cylinder")
  stop at    w:run{ depth={ plate=1e-3 } }   w:run{ stop_when=f }
  change     w:set{ load=200, alpha=0.3 }
  varying    wear{ k=function(state) ... end }  wear{ loading={ x=f, load=g } }
  save       w:clone()  w:save("run.archard")  wear.open("run.archard")
Plot         plot.pressure(w)  plot.profile(w)  plot.history(w, "p_center")
             plot.mesh(m)  plot.stress(c)  plot{ {x=..., y=...} }
Many cases   study{ base=..., vary=... }  study.paper()  study.converge{}
Measured     calibrate{ volume={...}, load=100, distance=1320 }
             fit{ unknown={...}, data={...} }  fit.design{}  plot.fit(f)
             profile.read("trace.csv"):depth()  map.read("scar.sdf")
Files        csv.read("m.csv")  export.csv(w, "w.csv")  export.vtk(c, "c.vtu")
             export.pvd(w, "w.pvd")  export.inp(w, "w.inp")
             export.json(w, "w.json")
Session      who()  session.save("s.archard")  session.open("s.archard")
             examples()  examples.run("wear")  time(f)
Topics       help "units"  "running in"  "files"  "meshes"  "gmsh"  "3-D"
             "steps"  "accuracy"  "fretting"  "pin on disc"  "coating"
             "measured surface"  "continue"  "warning"  "limits"  "glossary"
             "run time"  "prompt"  "troubleshooting"  "citation"

help(wear) explains an object, help(w.step) a method, help "jump" a name,
help "fretting map" any words; help.search "stability" searches all texts.
Tab completes names, also the fields inside wear{ }. The last value is in _ .
Ctrl-C stops a run after its step, Ctrl-D exits.]]

function show.overview()
  return overview
end

return show
