-- Runs the examples and saves the last picture of each as FOLDER/NN_name.png. `make gallery` runs this script
-- in a folder for the other files that the examples write.
--
--   archard scripts/tools/gallery.lua FOLDER [NAME ...]

local folder = assert(arg[1], "expected the folder for the pictures")
local wanted = { table.unpack(arg, 2) }
if #wanted == 0 then wanted = examples.names() end

for _, name in ipairs(wanted) do
  io.stderr:write(name, "\n")
  examples.run(name)
  local picture = folder .. "/" .. name
  plot.save(picture .. ".png", { size = { 900, 600 } })
  os.remove(picture .. ".csv") -- removes the CSV file that plot.save wrote with the picture
end
