-- Writes files of all kinds to the folder arg[1], for tests in which writing fails. Prints a line for each kind
-- of file: its name, and the error or "fine". arg[2] is the shard "i/n" of the study to compute (default: the
-- whole study).
warn "@off"
local folder, share = arg[1], arg[2]
local small = { radius = 10, mesh = { size = 0.08, height = 0.06 } }
w = wear{ model = model(small), distance = 400, increments = 10, jump = 20 }
w:step()
height = map{ x = { 0, 1, 2 }, z = { 0, 1 }, y = { 0, 1, 2, 3, 4, 5 } }
local worn = wear{ model = joint{ mesh = { size = 8 } }, k = 1e-9, cycles = 1e3, updates = 2 }
local s = study{ snapshots = 1, base = { model = small, increments = 10, jump = 100, distance = 100 }, vary = { alpha = { 0, 1 } } }

local works = {
  { "save", function() w:save(folder .. "run.archard") end },
  { "joint", function() worn:save(folder .. "joint.archard") end },
  { "session", function() session.save(folder .. "all.archard") end },
  { "svg", function() plot.profile(w, { file = folder .. "p.svg" }) end },
  { "png", function() plot.profile(w, { file = folder .. "p.png" }) end },
  { "gp", function() plot.profile(w, { file = folder .. "p.gp" }) end },
  { "csv", function() export.csv(w.history, folder .. "h.csv") end },
  { "vtu", function() export.vtk(w, folder .. "w.vtu") end },
  { "inp", function() export.inp(w, folder .. "w.inp") end },
  { "gsf", function() export.gsf(height, folder .. "m.gsf") end },
  { "vti", function() export.vti(height, folder .. "m.vti") end },
  { "json", function() export.json(w, folder .. "w.json") end },
  { "study", function()
    s:run{ file = folder .. "study.archard", workers = 1, progress = false, shard = share }
    assert(#s.failed == 0, s.failed[1] and s.failed[1].message)
  end },
}
for _, work in ipairs(works) do
  local fine, why = pcall(work[2])
  print(("%s: %s"):format(work[1], fine and "fine" or tostring(why):gsub("^[^:]*:%d+: ", "")))
end
