-- Writes the manual page archard-file(5) to standard output. The number of the file format is read from the C
-- header of run files, the history columns from the help entry of histories.
--
--   archard scripts/tools/manfile.lua include/archard/store.h > build/man/archard-file.5

local help = require "archard.help"

local function format_of(header)
  local file <close> = assert(io.open(header))
  return assert(file:read "a":match("#define ARC_STORE_FORMAT (%d+)"), "no format in " .. header)
end

-- Returns the history columns as items of the manual page, read from the lines "  name  [unit] text" of the
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
Studies and saved runs are stored in SQLite databases, which
.Xr sqlite3 1
can read.
Their application id is 1634886504, the letters
.Dq arch ;
user_version is the number of the format, now @FORMAT.
The program and the library of this release read the formats 1 to @FORMAT.
A file of another program, a file of a newer format and a damaged file are
rejected and not changed.
A file of an older format is converted when it is opened for writing; a program
that only reads the file does not change it.
Each case is written in one synchronous transaction: a program that is killed
loses the case that it was computing, but no stored case.
Several processes may use a file at the same time.
.Pp
A run is saved by
.Li w:save(path)
and opened by
.Li wear.open(path) ,
a study is saved by
.Li s:run{ file=path }
and opened by
.Li study.open(path) ,
a session is saved by
.Li session.save(path)
and opened by
.Li session.open(path) ;
see
.Xr archard-lua 7 .
.Sh VIEWS
The views are intended for users:
.Bl -tag -width "case_results" -compact
.It Li case_results
One row for each case: case_id, label, status, message, warning, created,
finished, seconds, its settings
.Pq Li load_N , stroke_mm No and so on
and the last row of its history
.Pq Li p_center_MPa , depth_plate_mm , volume_total_mm3 No and so on .
A setting without a value has its default
.Pq in a case that has not been computed
or varies during the run.
.It Li history_of
case_id, label, step and a column for each column of
.Li w.history .
.It Li surfaces
case_id, updates, distance_mm, body, node, x_mm (unworn position), h_mm (wear
depth), y_mm (present height), p_MPa (pressure with the plate at x = 0).
The last update is the final state.
.It Li units
name, unit and text (description) of these columns.
.El
.Pp
The names end in the unit.
The number of updates is called updates, because update is a keyword of SQL.
Times are in UTC.
.Ss Columns of the history
.Bl -tag -width "volume_cylinder_mm3" -compact
@COLUMNS
.El
.Sh TABLES
The views read these tables:
.Bl -tag -width "definition" -compact
.It Li info
Properties of the file, by name: kind
.Pq Li study No or Li wear ,
name, looks
.Pq number of snapshots ,
task, program.
.It Li cases
id, label, status
.Pq Li waiting , running , done No or Li failed ,
message, seconds, created, finished, checksum
.Pq FNV-1a, 64 bit
of all data of a finished case.
A case that does not match its checksum is rejected.
If the program is killed, a running case becomes waiting at the next start.
.It Li settings
case_id, name, value: the fields of
.Li wear{}
as given by the user.
The names of nested fields are joined by points, as in
.Li model.mesh.size .
.It Li definition
The same columns: all fields of the run and its model, as used by the engine.
.It Li results
The same columns: the results of a task other than a run.
.It Li history
case_id, step and the columns of history_of.
.It Li arrays
case_id, part, updates, distance_mm, body, name, rows, columns, numbers.
The BLOB numbers contains rows times columns numbers, row by row.
If part is surface, the arrays are x, h, y and p of the view surfaces.
If part is state, the arrays are the data from which a run continues with
identical results.
.It Li texts
name, text: long texts, each stored once.
Values refer to a text by its name, which is the checksum of the text.
Imported meshes are stored here as Gmsh files:
.Li model.mesh
in settings,
.Li model.msh
in definitions.
.El
.Pp
Values are numbers (REAL), texts, flags (INTEGER 0 or 1) or lists of numbers
(BLOB: doubles in the byte order of the machine).
A NaN is stored as NULL.
.Sh EXAMPLES
.Bd -literal -offset indent
$ sqlite3 -box study.archard "select label, p_center_MPa, depth_plate_mm
    from case_results"
$ sqlite3 -csv study.archard "select x_mm, h_mm from surfaces
    where case_id = 9 and body = 'plate' and updates = 60"
.Ed
.Pp
In Python, the numbers of an array are read by
.Li numpy.frombuffer(numbers).reshape(rows, columns) .
.Sh SEE ALSO
.Xr archard 1 ,
.Xr sqlite3 1 ,
.Xr archard-lua 7]]

print((page:gsub("@(%u+)", { FORMAT = format_of(arg[1]), COLUMNS = columns() })))
