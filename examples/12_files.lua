-- Export of a run to files of other programs, a run that continues from its file, and a table that is read
-- from a file.
--   archard examples/12_files.lua [folder]

local folder = arg[1] or "."
local function to(ending) return folder .. "/reference" .. ending end

local w = wear{ distance = 660, jump = 100 }:run{ progress = false }
w:save(to ".archard")      -- the complete state, for wear.open and sqlite3
export.csv(w, to ".csv")   -- the history, each column with its unit
export.json(w, to ".json") -- definition, results and versions
export.inp(w, to ".inp")   -- the worn contact as a complete problem for CalculiX
local upper, lower = export.vtk(w, to ".vtu") -- a file for each body, for ParaView

for _, path in ipairs{ to ".archard", to ".csv", to ".json", to ".inp", upper, lower } do
  local file <close> = assert(io.open(path))
  print(("%-36s %7.0f kB"):format(path, file:seek "end" / 1000))
end

-- A run that continues from its file has exactly the same results as an uninterrupted run.
local again = wear.open(to ".archard"):run{ distance = 1320, progress = false }
local through = wear{ distance = 1320, jump = 100 }:run{ progress = false }
print(("\nplate %.9f um continued from the file, %.9f um without interruption\n"):format(1e3 * again.depth.plate,
  1e3 * through.depth.plate))

-- plot.points draws measured points over curves. These points are every fifth row of the .csv file of the
-- first half of the run.
local half = csv.read(to ".csv", { d = "distance [mm]", p = "p_center [MPa]" })
local d, p = {}, {}
for i = 1, #half.d, 5 do d[#d + 1], p[#p + 1] = half.d[i], half.p[i] end
plot.history(again, "p_center", { titles = { "run" }, title = "Pressure at the centre" })
plot.points{ x = d, y = p, title = "read from the file" }
