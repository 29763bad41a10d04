-- Tests csv.read: separators, quotes, names, numbers, refused files.
-- Ordinary collector settings: even under sanitizers this file is run without continuous garbage collection,
-- which would only slow it down.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local is, near, fails = tap.is, tap.near, tap.fails

local path = os.tmpname()
local function file(text)
  local f = assert(io.open(path, "wb"))
  f:write(text)
  f:close()
  return path
end

local t = csv.read(file "t,x,load\n0,-0.05,100\n1,5e-2,120\n")
is(#t.t, 2, "the file has two rows")
is(t.x[1], -0.05, "a number")
is(t.x[2], 0.05, "a number with an exponent")
is(t.load[2], 120, "the last column")
t = csv.read(file "\xEF\xBB\xBFt [s];x\r\n# measured\r\n\r\n 0,5 ; 1 \r\n1;-2,25")
is(t.t[1], 0.5, "semicolons, decimal commas, blanks, a byte order mark, no end of the last line")
is(t.x[2], -2.25, "a negative number with a decimal comma")
is(#t.x, 2, "comments and empty lines are skipped")
is(csv.read(file "t [s]\tx\n0,5\t1,25\n").x[1], 1.25, "tabs with decimal commas")
is(csv.read(file "x [mm];z [\xb5m]\n0;1,5\n").z[1], 1.5e-3, "a unit in the Latin-1 encoding")
t = csv.read(file 'name\tcycles\n"a ""b"",\tc"\t3\nd\t4\n')
is(t.name[1], 'a "b",\tc', "a quoted text that contains quotes and a tab")
is(t.name[2], "d", "a column of texts")
is(t.cycles[2], 4, "a column of numbers beside a column of texts")
t = csv.read(file "time,position\n0,1\n1,2\n", { t = "time", x = 2 })
is(t.t[2], 1, "a column by its name")
is(t.x[1], 1, "a column by its number")
is(rawget(t, "time"), nil, "only the chosen columns are read")

-- Tests that units in column names are recognized.
t = csv.read(file "x [mm],h [um],p (GPa),T [K],w/h,\"\"\"a\"\" [nm]\"\n1,0.3,0.5,300,2,7\n2,-1.7,0.25,301,3,8\n")
is(t.x[2], 2, "mm are not converted")
is(t.h[1], 0.0003, "um are converted to mm, rounded once")
is(t.h[2], -0.0017, "a negative value in um")
is(t.p[1], 500, "GPa to MPa")
is(t["T [K]"][1], 300, "an unknown unit stays in the name")
is(t["w/h"][2], 3, "a name with a slash has no unit")
is(t['"a"'][1], 7e-6, "a unit in a quoted name")
t = csv.read(file "s [mm],h [um]\n1,5\n", { x = "s", h = "h [um]", again = 2 })
is(t.x[1], 1, "a column chosen by its name without the unit")
is(t.h[1], 0.005, "a column chosen by its name with the unit")
is(t.again[1], 0.005, "a column with a unit, chosen by its number")
t = csv.read(file "x [\xC2\xB5m],t [min]\n1500,2\n")
is(t.x[1], 1.5, "a unit with the micro sign")
is(t.t[1], 120, "minutes")
t = csv.read(file "x [in],h [mm3/Nm],a [%]\n2,1e-5,35\n")
is(t.x[1], 50.8, "inches")
local u = csv.read(file "x [inch],d [km],v [m^3],w [mm³]\n2,3,1,4\n")
is(u.x[1] .. " " .. u.d[1] .. " " .. u.v[1] .. " " .. u.w[1], "50.8 3000000.0 1000000000.0 4",
  "inch, km, m^3 and mm³ are converted")
is(t.h[1], 1e-8, "a wear coefficient in mm3/Nm is converted to mm2/N")
is(t.a[1], 0.35, "per cent")
t = csv.read(file "part [mm],x\nlid,1\n")
is(t.part[1], "lid", "a column of texts has no unit")
fails(function() csv.read(file "x [mm],x [um]\n1,2\n") end, "column 2: expected a unique name, got \"x\" again",
  "two columns whose names differ by the unit only")
is(csv.read(file "x [mm],x [um]\n1,2\n", { x = "x [um]" }).x[1], 0.002,
  "one of two such columns can be chosen")
fails(function() csv.read(file "x [furlong]\n1\n", { x = "x" }) end, { 'column "x [furlong]"', "expected one of the units",
  "um" }, "an unknown unit of a chosen column")

-- Tests a measured profile, and an exported history that is read back.
local measured = csv.read(file "x [mm];h [um]\n-0,2;0\n-0,1;1,5\n0;2\n0,1;1,5\n0,2;0\n")
local start = wear{ worn = { plate = measured } }
near(start.depth.plate, 0.002, 1e-6, "a measured profile as initial worn shape")
local worn = wear{ increments = 20 }
worn:step(3)
export.csv(worn, path)
t = csv.read(path)
local same, columns = true, 0
for name, values in pairs(worn.history) do
  columns = columns + 1
  for i, value in ipairs(values) do
    local got = t[name] and t[name][i]
    same = same and (got == value or value ~= value and got ~= got)
  end
end
is(columns, #require "archard.settings".columns, "the file has all columns of the history")
tap.ok(same, "the columns are read back with identical bits")

-- Tests a loading read from a file, and refused files.
local w = wear{ loading = csv.read(file "t,x,load\n0,-0.05,100\n3,0.05,50\n4,-0.05,100\n"), cycles = 3 }
is(w.loading[1].load[2], 50, "a loading read from a file")
near(w.total_distance, 0.6, 1e-12, "sliding distance of a loading read from a file")

local function refused(text, parts, what) fails(function() csv.read(file(text)) end, parts, what) end
refused("", "the file is empty", "an empty file")
refused("\n# only this\n", "the file is empty", "a file with comments only")
refused("1,2\n3,4\n", { ":1: expected a line of names first, got the number 1" },
  "a first line of numbers instead of names")
refused("a,a\n1,2\n", { ":1: column 2: expected a unique name, got \"a\"" }, "a name that occurs twice")
refused("a,\n1,2\n", "column 2: expected a unique name", "a column without a name")
refused("a,b\n1,2\n3\n", { ":3: expected 2 cells, as many as names in line 1, got 1" }, "a line with too few cells")
refused("a,b\n1,2\n3,x\n", { ":3: column \"b\": expected a number, got \"x\"" },
  "a text in a column of numbers")
refused("a,b\n1,2\n3,\n", { "column \"b\": expected a number, got \"\"" },
  "an empty cell in a column of numbers")
refused("a,b\n1,2\n3,0x10\n", "expected a number, got \"0x10\"", "a hexadecimal number")
fails(function() csv.read(file "a,b\n1,2\n", { t = "c" }) end, "no column \"c\"; the columns are a, b",
  "a column with an unknown name")
fails(function() csv.read(file "a,b\n1,2\n", { t = 3 }) end, "no column 3",
  "a column number beyond the last column")
refused("a,b\n1,1e999\n", { ":2: column \"b\": expected a number in the range of doubles, got \"1e999\"" },
  "a number above the range of doubles")
refused("a,b\n1,2\n1,-1e400\n", { ":3: column \"b\"", "got \"-1e400\"" },
  "a number below the range of doubles")

-- Returns the number of Lua instructions that f executes, in thousands, and the result of f.
local function counted(f)
  local count = 0
  debug.sethook(function() count = count + 1 end, "", 1000)
  local result = f()
  debug.sethook()
  return count, result
end

-- Returns the number of instructions, in thousands, for reading all columns of a file by name.
local function count_for(columns)
  local names, numbers, choice = {}, {}, {}
  for i = 1, columns do
    names[i], numbers[i] = "c" .. i, tostring(i)
    choice["n" .. i] = "c" .. i
  end
  file(table.concat(names, ",") .. "\n" .. table.concat(numbers, ",") .. "\n")
  local count, got = counted(function() return csv.read(path, choice) end)
  is(got["n" .. columns][1], columns, columns .. " columns")
  return count
end
local few = count_for(5000)
tap.ok(few > 10 and count_for(50000) < 20 * few,
  "ten times the columns need less than 20 times the instructions")

-- Tests a cell with many blanks. A reading time that grows with the square of their number would exceed the
-- time limit.
local blanks = (" "):rep(2000000)
is(csv.read(file("a,b\n1,x" .. blanks .. "y" .. blanks .. "\n")).b[1]:sub(-1), "y",
  "a cell with two million blanks before and after a letter")

os.remove(path)
os.execute("mkfifo " .. path)
fails(function() csv.read(path) end, { "csv.read: ", "not a file" }, "a pipe instead of a file")
fails(function() model{ mesh = path } end, { "not a file" }, "a pipe instead of a mesh file")
fails(function() csv.read "/dev/zero" end, { "csv.read: ", "not a file" }, "a device instead of a file")
os.remove(path)
fails(function() csv.read(path) end, { "csv.read: ", "No such file" }, "a missing file")
fails(function() csv.read("/") end, { "csv.read: ", "directory" }, "a folder instead of a file")
fails(function() csv.read(3) end, "expected the path of a file, got 3", "a number instead of a path")
fails(function() csv.read(path, "x") end, "expected a table { name = column, ... }, got \"x\"",
  "a text instead of the table of columns")
