-- Writes the manual page archard(1) to standard output, its reference part from the help entries:
--   archard scripts/tools/manpage.lua > man/archard.1

local help = require "archard.help"
local show = require "archard.help.show"

local out = {}
local function put(...) out[#out + 1] = table.concat({ ... }) end

-- Text for roff: no line may look like a request, no backslash is roff's.
local function escape(text)
  return (text:gsub("\\", "\\e"):gsub("^([.'])", "\\&%1"):gsub("\n([.'])", "\n\\&%1"))
end

-- A new line for every sentence, and for every 76 characters.
local function put_filled(text)
  text = text:gsub("%s+", " ")
  local line = ""
  for word in text:gmatch("%S+") do
    if line ~= "" and #line + #word > 76 then
      put(escape(line))
      line = ""
    end
    line = line == "" and word or line .. " " .. word
    if word:find("[%l%d)\"][.]$") and not word:find("Eqs?%.$") and not word:find("%.%.%.$") then
      put(escape(line))
      line = ""
    end
  end
  if line ~= "" then put(escape(line)) end
end

local function put_text(text)
  local literal = false
  for line in (text:gsub("\n\n", "\n\0\n") .. "\n"):gmatch("(.-)\n") do
    local wanted = line:find("^  ") ~= nil
    if wanted ~= literal then put(wanted and ".Bd -literal" or ".Ed") end
    literal = wanted
    if wanted then
      put(escape(line))
    elseif line == "\0" then
      if not text:find("\n\n  ", 1, true) then put(".Pp") end
    elseif line ~= "" then
      put_filled(line)
    end
  end
  if literal then put(".Ed") end
end

-- What stands on the line of an item: never taken for macros.
local function item(text)
  local words = {}
  for word in escape(text):gmatch("%S+") do
    words[#words + 1] = "\\&" .. word:gsub('"', "\\(dq")
  end
  return ".It Li " .. table.concat(words, " ")
end

local function put_entry(entry, name)
  put(item(name))
  put_text(entry.text)
  local facts = show.facts(entry)
  if facts ~= "" then put_filled("(" .. facts .. ")") end
end

local function put_list(title, list, name_of)
  if #list == 0 then return end
  put(".Pp")
  put(title)
  put('.Bl -tag -width "xxxxxx" -compact')
  for _, entry in ipairs(list) do put_entry(entry, name_of(entry)) end
  put(".El")
end

local function option_name(entry)
  return (entry.path ~= "" and entry.path .. "." or "") .. entry.name
end

local function options_of(address)
  local list = {}
  for _, entry in ipairs(help.all()) do
    if entry.kind == "option" and entry.owner == address then list[#list + 1] = entry end
  end
  return list
end

-- Members of an object, those of its fields too: wear.depth.cylinder.
local function members_of(address, kind)
  local list = {}
  for _, entry in ipairs(help.all()) do
    local own = entry.kind ~= "option" and entry.address:sub(1, #address + 1) == address .. "."
    local called = entry.kind == "method" or entry.kind == "function"
    if own and (kind == "called") == called then list[#list + 1] = entry end
  end
  return list
end

local function put_object(entry)
  put(".Ss ", entry.name)
  put(".Dl ", escape(entry.use or entry.address))
  put(".Pp")
  put_text(entry.text)
  put_list("Fields of the definition:", options_of(entry.address), option_name)
  put_list("Fields:", members_of(entry.address, "read"), function(member)
    return member.address:sub(#entry.address + 2)
  end)
  local called = members_of(entry.address, "called")
  put_list("Functions:", called, function(member) return member.use or member.address end)
  for _, member in ipairs(called) do
    put_list(("In the table of %s:"):format(member.name), options_of(member.address), option_name)
  end
end

local head = [[
.\" Written by scripts/tools/manpage.lua from the help entries: change those, then "make man".
.Dd November 21, 2026
.Dt ARCHARD 1
.Os
.Sh NAME
.Nm archard
.Nd simulate the wear of sliding surfaces
.Sh SYNOPSIS
.Nm
.Op Fl i
.Op Fl -lax
.Op Fl e Ar chunk
.Op Fl l Ar module
.Op Ar script Op Ar argument ...
.Nm
.Fl v | Fl h
.Sh DESCRIPTION
.Nm
simulates how two rubbing surfaces, a half cylinder sliding on a plate, wear
each other away: a
finite element engine computes the contact, Archard's law with a wear
partition factor the wear.
It is driven by Lua 5.4, at a prompt or from a script, and draws with
.Xr gnuplot 1 .
Lengths are in mm, forces in N, pressures in MPa.
.Pp
With a
.Ar script
it runs that, with the arguments in
.Li arg
and
.Li ... ;
.Sq -
stands for standard input.
Without one it shows its prompt if standard input is a terminal, and otherwise
obeys standard input
line by line, as if it were typed: values are shown, the first error ends it.
.Pp
The options are as follows:
.Bl -tag -width "-e chunk"
.It Fl e Ar chunk
Run the Lua text
.Ar chunk .
May be given several times.
.It Fl l Ar module
Require
.Ar module
and put it into the global of that name.
.It Fl i
Go to the prompt after the script.
.It Fl -lax
Names that nobody has given are
.Li nil .
Without it, to read an undefined global, or an unknown field of an object or table of
.Nm ,
is an error that says the nearest name; a global may be declared by any assignment, and
.Li rawget(_G, name)
asks.
.It Fl v , Fl -version
Print the version.
.It Fl h , Fl -help
Print a short help.
.El
.Ss The prompt
A line is an expression, whose values are shown, or a statement; it goes on
for as many lines as it
needs.
The last value is in
.Li _ .
A local lives in its own chunk only.
Tab completes globals, fields, methods, the fields inside a constructor call
such as
.Li wear{ ,
their values inside quotes, and file names.
.Li help() ,
.Li help(wear) ,
.Li help(w.step) ,
.Li help \(dqjump\(dq
explain.
.Pp
Ctrl-C drops the line; in a run it stops at the last completed step, and the
run can go on later.
Ctrl-D,
.Li exit
or
.Li quit
leave; Ctrl-Z suspends.
.Sh OBJECTS
These are globals, and fields of
.Li require \(dqarchard\(dq .
A constructor takes one table of named fields; all have defaults, those of the
reference case.
An unknown name, a wrong type or a value out of range is an error.
Equation numbers are those of the article under
.Sx SEE ALSO .]]

local tail = [[
.Sh RUN FILES
Studies and saved runs are kept in SQLite databases, which
.Xr sqlite3 1
can read as well.
Their application id is 1634886504, the letters
.Dq arch ;
user_version is the number of the format, now 2.
A file of another program, of a newer format or with damage is refused and left
as it is.
One of an older format becomes one of today's when it is written to; what only
reads it leaves it as it is.
Each case is written in one transaction, synchronously: a program that is killed
loses what it was computing and nothing that it stored.
Several processes may use a file at once.
.Pp
What to look at:
.Bl -tag -width "case_results" -compact
.It Li case_results
A row for each case: case_id, label, status, message, warning, created, finished,
seconds, its settings
.Pq Li load_N , stroke_mm No and so on
and the last row of its history
.Pq Li p_center_MPa , depth_plate_mm , volume_total_mm3 No and so on .
A setting without a value is the default
.Pq of a case that has not run ,
or varies on the way.
.It Li history_of
case_id, label, step and a column for each column of
.Li w.history .
.It Li surfaces
case_id, updates, distance_mm, body, node, x_mm (unworn position), h_mm (wear
depth), y_mm (present height), p_MPa (pressure with the plate at x = 0).
The last update is the final state.
.It Li units
name, unit and text of these columns.
.El
.Pp
Names end in the unit.
The number of updates is called updates, since update is a word of SQL.
Times are UTC.
.Pp
What these rest on:
.Bl -tag -width "definition" -compact
.It Li info
Notes on the whole, by name: kind
.Pq Li study No or Li wear ,
name, looks, task, program.
.It Li cases
id, label, status
.Pq Li waiting , running , done No or Li failed ,
message, seconds, created, finished, checksum
.Pq FNV-1a, 64 bit
of all that a finished case holds: one that does not match is refused.
A case left running by a killed program waits again at the next start.
.It Li settings
case_id, name, value: the fields of
.Li wear{}
as given.
Fields within fields are joined by points,
.Li model.mesh.size .
.It Li definition
Likewise all fields of the run and its model, as the engine had them.
.It Li results
Likewise what another task than a run has found.
.It Li history
case_id, step and the columns of history_of.
.It Li state
case_id, body, condensed, even, h, xy, settled: what a run needs to go on to the
same bits.
.El
.Pp
Values are numbers (REAL), texts, flags (INTEGER 0 or 1) or lists of numbers
(BLOB: doubles of this machine).
A NaN is stored as NULL.
.Bd -literal -offset indent
$ sqlite3 -box study.archard "select label, p_center_MPa, depth_plate_mm
    from case_results"
$ sqlite3 -csv study.archard "select x_mm, h_mm from surfaces
    where case_id = 9 and body = 'plate' and updates = 60"
.Ed
.Sh ENVIRONMENT
.Bl -tag -width XDG_STATE_HOME
.It Ev ARCHARD_GNUPLOT
The gnuplot program to run instead of
.Xr gnuplot 1 .
.It Ev NO_COLOR
If set and not empty, no colours are used.
.It Ev TERM
With
.Li dumb
no colours are used, and nothing is redrawn.
.It Ev XDG_STATE_HOME
Where the history is kept; by default
.Pa ~/.local/state .
.It Ev LUA_PATH , LUA_CPATH
Where
.Li require
looks for modules.
.El
.Sh FILES
.Bl -tag -width "xxxx" -compact
.It Pa ~/.local/state/archard/history
What was typed at the prompt: the last 5000 entries, each once.
.It Pa ~/.inputrc
Key bindings of the prompt, see
.Xr readline 3 ;
.Li $if archard
addresses it alone.
.El
.Sh EXIT STATUS
.Bl -tag -width "130" -compact
.It 0
Done.
.It 1
An error; the message and a traceback are on standard error.
.It 2
Wrong usage.
.It 130
Interrupted by Ctrl-C.
.El
.Sh EXAMPLES
The reference case, its final state and a plot in the terminal:
.Bd -literal -offset indent
$ archard -e 'w = wear{} w:run() print(w) plot.pressure(w)'
.Ed
.Pp
The same at the prompt, in steps of 10 updates:
.Bd -literal -offset indent
> w = wear{}
> w:step(10)
> plot.profile(w)
.Ed
.Sh SEE ALSO
.Xr gnuplot 1 ,
.Xr lua 1 ,
.Xr sqlite3 1 ,
.Xr readline 3
.Rs
.%A L. Mattei
.%A F. Di Puccio
.%T Influence of the wear partition factor on wear evolution modelling of sliding surfaces
.Re]]

put(head)
for _, entry in ipairs(help.all()) do
  if entry.kind ~= "option" and not entry.address:find("[.{]") then put_object(entry) end
end
put(tail)
print(table.concat(out, "\n"))
