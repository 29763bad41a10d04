-- Tests the C modules below the classes, loaded by require: refused arguments, worker processes.
-- Ordinary collector settings: even under sanitizers this file is run without continuous garbage collection,
-- because it mostly starts other programs.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails = tap.ok, tap.is, tap.near, tap.fails

local process, gnuplot = require "archard.process", require "archard.gnuplot"
local random, term = require "archard.random", require "archard.term"

-- --- worker processes ----------------------------------------------------------------------------

for _, count in ipairs{ 0, 257 } do
  fails(function() process.pool(count, {}) end, "expected from 1 to 256 workers", count .. " workers")
end
fails(function() process.pool(1, { {} }) end, "argument 1 is not a text", "a table as argument of a worker")

-- Returns all lines that a worker running `chunk` has written, and how the worker ended.
local function worker(chunk, line)
  local pool <close> = process.pool(1, { "-e", chunk })
  pool:send(1, line or "go")
  local lines = {}
  for _ = 1, 600 do
    for _, event in ipairs(pool:wait(0.1)) do
      if event.ended then return lines, event end
      lines[#lines + 1] = event.line
    end
  end
end

do
  local pool <close> = process.pool(2, { "-e", "print(io.read())" })
  is(tostring(pool), "a pool of worker processes", "print of a worker pool")
  for _, which in ipairs{ 0, 3 } do
    fails(function() pool:send(which, "x") end, "no such worker",
      "a line sent to worker " .. which .. " of 2")
  end
  for _, text in ipairs{ ("x"):rep(1000), "one\ntwo" } do
    fails(function() pool:send(1, text) end, "expected one line of less than 1000 bytes",
      #text .. " characters as a line")
  end
  for _, seconds in ipairs{ -1, 2e6, 0 / 0 } do
    fails(function() pool:wait(seconds) end, "expected 0 to 1e6 seconds",
      "waiting for " .. seconds .. " seconds")
    fails(function() process.pause(seconds) end, "expected 0 to 1e6 seconds",
      "a pause of " .. seconds .. " seconds")
  end
  is(#pool:wait(0), 0, "no lines from workers without requests")
end

local lines, event = worker("print(io.read()) os.exit()", "word")
is(lines[1], "word", "a line is sent to a worker and returned")
is(event.ended, "exit status 0", "a worker that ends normally")
_, event = worker("io.stderr:write(('a'):rep(300), ('b'):rep(700), '!') os.exit(3)")
is(event.ended, "exit status 3", "exit status of a worker")
is(event.words, ("b"):rep(399) .. "!", "the last 400 characters of a worker's error output")
_, event = worker("os.execute 'kill -9 $PPID'")
ok(event.ended:find("^signal 9 %("), "a worker ended by a signal: " .. event.ended)
lines = worker("print(('x'):rep(5000)) print 'after' os.exit()")
is(lines[#lines], "after", "a line that is too long does not stop reading")
ok(#lines[1] < 4096, "a line that is too long is truncated")

do
  local pool <close> = process.pool(1, { "-e", "io.stderr:close() io.read() print 'closed' io.flush() io.read()" })
  pool:send(1, "go")
  while not pool:wait(1)[1] do end
  local start = term.clock()
  for _ = 1, 3 do pool:wait(0.1) end
  ok(term.clock() - start > 0.25, "the pool waits for a worker that has closed its standard error")
end

do
  local folder = os.tmpname()
  local made, why = process.make_folder(folder)
  ok(not made and why == "File exists", "make_folder fails if the name is a file")
  os.remove(folder)
  ok(process.make_folder(folder) and process.make_folder(folder), "make_folder succeeds if the folder exists")
  is(#process.files(folder), 2, "an empty folder lists itself and its parent only")
  os.remove(folder)
  is(process.files(folder), nil, "files of a missing folder are nil")
end

-- --- pictures ------------------------------------------------------------------------------------

local function figure(change)
  local curve = { x = { 1, 2 }, y = { 1, 2 } }
  local panel = { x = {}, y = {}, curves = { curve } }
  local whole = { panels = { panel } }
  change(whole, panel, curve)
  return function() gnuplot.draw(whole, { medium = "text", width = 60, height = 20 }) end
end
for told, change in pairs{
  ["figure without panels"] = function(f) f.panels = nil end,
  ["panel 1 is not a table"] = function(f) f.panels = { 7 } end,
  ["title must be a string, got table"] = function(f) f.title = {} end,
  ["rows must be a whole number from 0 to 100000"] = function(f) f.rows = 1.5 end,
  ["columns must be a whole number from 0 to 100000"] = function(f) f.columns = 1e6 end,
  ["rows must be a number, got string"] = function(f) f.rows = "2" end,
  ["levels must be a whole number from 0 to 100000"] = function(_, p) p.levels = -1 end,
  ["key: unknown value 'nowhere'"] = function(_, p) p.key = "nowhere" end,
  ["panel 1: curve 1 is not a table"] = function(_, p) p.curves = { 7 } end,
  ["x must be a list of numbers, got nil"] = function(_, _, c) c.x = nil end,
  ["y[2] must be a number, got string"] = function(_, _, c) c.y[2] = "2" end,
  ["x has 2 numbers, y has 1: expected equal lengths"] = function(_, _, c) c.y = { 1 } end,
  ["x has 2 numbers, error has 3: expected equal lengths"] = function(_, _, c) c.error = { 1, 1, 1 } end,
  ["field: expected a multiple of 4 corners, got 3"] = function(_, p)
    p.field = { x = { 1, 2, 3 }, y = { 1, 2, 3 }, value = { 1, 2, 3 } }
  end,
  ["axis without tick labels"] = function(_, p) p.x.places = { at = { 1 } } end,
  ["axis: tick 1 has no label"] = function(_, p) p.x.places = { at = { 1 }, words = { 7 } } end,
} do fails(figure(change), told, told) end
fails(function() gnuplot.animate({ 7 }, 0.1, { medium = "file", file = "x.gif" }) end, "frame 1 is not a table",
  "a frame of an animation that is not a figure")

-- --- numbers -------------------------------------------------------------------------------------

for _, count in ipairs{ 0, 10000001 } do
  fails(function() random.points("sobol", count, 1, 1) end, "expected 1 to 10000000", count .. " points")
end
for _, dimensions in ipairs{ 0, 41 } do
  fails(function() random.points("sobol", 1, dimensions, 1) end, "expected 1 to 40", dimensions .. " dimensions")
end
fails(function() random.points("grid", 1, 1, 1) end, [["sobol", "latin" or "random"]], "an unknown design")
-- Student's distribution with one degree of freedom is Cauchy's; with two it has a closed form
near(random.student_quantile(0.975, 1), math.tan(math.pi * 0.475), 1e-12,
  "quantile of Student's distribution, one degree of freedom")
near(random.student_quantile(0.975, 2), 0.95 * math.sqrt(2 / (1 - 0.95 ^ 2)), 1e-12,
  "quantile of Student's distribution, two degrees of freedom")
near(random.rank_correlation({ 1, 2, 2, 4 }, { 10, 30, 20, 40 }), math.sqrt(0.9), 1e-12,
  "rank correlation with equal values")
fails(function() random.rank_correlation({ 1, 2 }, { 1 }) end, "as long as the first list",
  "rank correlation of lists of different length")
