-- A coated plate whose coating of 0.4 um wears through. When the deepest point has reached the bare plate,
-- the plate receives most of the wear. Two variants are computed: a run with alpha as a function of the
-- state, which is evaluated in the middle of every update; and a run that ends at this depth and continues
-- with a new alpha. The coating changes only alpha here; examples "coating_wear_through" has a layer with
-- its own E and k.
--   archard examples/06_coating.lua

local thickness = 0.4e-3 -- mm
local coated, bare = 0.85, 0.3 -- alpha: the cylinder's share of the wear

local watched = wear{
  jump = 25,
  alpha = function(state) return state.depth_plate < thickness and coated or bare end,
}:run()

local exact = wear{ jump = 100, alpha = coated }
local _, why = exact:run{ depth = { plate = thickness } }
assert(why == "depth.plate", "the coating does not wear through in this run")
print(("the coating is through after %.1f mm of sliding, %.0f cycles"):format(exact.distance, exact.cycle))
local at_breakthrough = exact:clone()
exact:set{ alpha = bare }:run()

print(("final depths, alpha by a function: cylinder %.4f um, plate %.4f um"):format(1e3 * watched.depth.cylinder,
  1e3 * watched.depth.plate))
print(("final depths, run to the depth:    cylinder %.4f um, plate %.4f um\n"):format(1e3 * exact.depth.cylinder,
  1e3 * exact.depth.plate))

plot.profile(at_breakthrough, exact, "plate", { titles = { "coating through", "end" }, title = "Wear of the plate" })
plot.history(exact, "alpha", "depth_partition")
