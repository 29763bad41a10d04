-- Blocks of variable amplitude, which are read from a table. Each block is a sine under its own load.
--   archard examples/08_block_program.lua [file.csv]

local path = arg[1] or (arg[0]:match("^(.*)/") or ".") .. "/08_block_program.csv"
local program = csv.read(path, { name = "block", amplitude = "amplitude [mm]", load = "load [N]", cycles = "cycles" })

local blocks = {}
for i, amplitude in ipairs(program.amplitude) do
  blocks[i] = {
    x = function(t) return amplitude * math.sin(2 * math.pi * t) end,
    load = program.load[i],
    cycles = program.cycles[i],
    increments = 60,
  }
end

local w = wear{ loading = blocks, load = 100, jump = 50 }
local ends = { w:clone() }
print(("%-8s %10s %12s %14s %14s %12s"):format("block", "cycles", "sliding [mm]", "cylinder [um]", "plate [um]", "volume [mm3]"))
for i, block in ipairs(blocks) do
  -- The sliding distance of a block is four amplitudes per cycle.
  local goal = w.distance + 4 * program.amplitude[i] * block.cycles
  w:run{ distance = math.min(goal, w.total_distance) }
  print(("%-8s %10.0f %12.1f %14.4f %14.4f %12.3e"):format(program.name[i], w.cycle, w.distance,
    1e3 * w.depth.cylinder, 1e3 * w.depth.plate, w.volume.total))
  ends[#ends + 1] = w:clone()
end
print()

local titles = { "unworn" }
for i, name in ipairs(program.name) do titles[i + 1] = i .. " " .. name end
plot.pressure(ends[1], ends[2], ends[4], ends[6], { titles = { titles[1], titles[2], titles[4], titles[6] },
  title = "Pressure after some blocks, under 100 N" })
