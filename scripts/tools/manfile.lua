-- Writes the manual page archard-file(5) to standard output. The number of the format comes from the header
-- of run files, the columns from the help entry of histories:
--   archard scripts/tools/manfile.lua include/archard/store.h > build/man/archard-file.5

local help = require "archard.help"

local function format_of(header)
  local file <close> = assert(io.open(header))
  return assert(file:read "a":match("#define ARC_STORE_FORMAT (%d+)"), "no format in " .. header)
end

-- Returns the columns of the history as items of the page, read from the lines " name [unit] text" of the
-- help entry. In run files the name of a column ends with its unit.
local function columns()
  local items = {}
  for name, text in help.entry("wear.history").text:gmatch("\n  ([%w_]+) +([^\n]+)") do
    local unit, rest = text:match("^%[(.-)%] (.*)$")
    local ending = unit and "_" .. unit:gsub("/", "_per_"):gsub(" ", "_") or ""
    items[#items + 1] = (".It Li %s\n%s"):format((name == "update" and "updates" or name) .. ending, rest or text)
  end
  return table.concat(items, "\n")
end

local page = [[
.\" Written by scripts/tools/manfile.lua.
.Dd November 22, 2026
.Dt ARCHARD-FILE 5
.Os
.Sh NAME
.Nm archard-file
.Nd run files of archard
.Sh DESCRIPTION
Studies and saved runs are kept in SQLite databases, which
.Xr sqlite3 1
can read as well.
Their application id is 1634886504, the letters
.Dq arch ;
user_version is the number of the format, now @FORMAT.
The program and the library of this release read the formats 1 to @FORMAT.
A file of another program, of a newer format or with damage is refused and left
as it is.
One of an older format becomes one of today's when it is written to; what only
reads it leaves it as it is.
Each case is written in one transaction, synchronously: a program that is killed
loses what it was computing and nothing that it stored.
Several processes may use a file at once.
.Pp
A run goes into a file with
.Li w:save(path)
and out of it with
.Li wear.open(path) ,
a study with
.Li s:run{ file=path }
and
.Li study.open(path) ,
a session with
.Li session.save(path)
and
.Li session.open(path) ;
see
.Xr archard-lua 7 .
.Sh VIEWS
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
.Ss Columns of the history
.Bl -tag -width "volume_cylinder_mm3" -compact
@COLUMNS
.El
.Sh TABLES
What the views rest on:
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
.It Li arrays
case_id, part, updates, distance_mm, body, name, rows, columns, numbers: rows times
columns numbers, row by row, in a BLOB.
Part is surface: the arrays x, h, y and p that the view surfaces shows, or state:
what a run needs to go on to the same bits.
.It Li texts
name, text: long texts, each once; values have the name, which is the checksum of
what it says.
Meshes from outside are Gmsh files here:
.Li model.mesh
of settings,
.Li model.msh
of definitions.
.El
.Pp
Values are numbers (REAL), texts, flags (INTEGER 0 or 1) or lists of numbers
(BLOB: doubles of this machine).
A NaN is stored as NULL.
.Sh EXAMPLES
.Bd -literal -offset indent
$ sqlite3 -box study.archard "select label, p_center_MPa, depth_plate_mm
    from case_results"
$ sqlite3 -csv study.archard "select x_mm, h_mm from surfaces
    where case_id = 9 and body = 'plate' and updates = 60"
.Ed
.Pp
In Python an array is
.Li numpy.frombuffer(numbers).reshape(rows, columns) .
.Sh SEE ALSO
.Xr archard 1 ,
.Xr sqlite3 1 ,
.Xr archard-lua 7]]

print((page:gsub("@(%u+)", { FORMAT = format_of(arg[1]), COLUMNS = columns() })))
