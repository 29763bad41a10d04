-- Figures for print: the style of journals, greys, titles, panels side by side, and the details that an editor looks at, as
-- they stand in gnuplot's commands.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local pictures = dofile(here .. "/lib/pictures.lua")
local ok, has, refused = tap.ok, tap.holds, tap.fails
local folder, read, script_of, line = pictures.folder, pictures.read, pictures.script_of, pictures.line

local run = pictures.stand_in { k = 1e-8 }

local function lacks(text, word, what) ok(not text:find(word, 1, true), what) end

-- --- the style of journals -----------------------------------------------------------------------

local function png_size(name)
  local png = read(name)
  return string.unpack(">I4", png, 17), string.unpack(">I4", png, 21)
end

do
  local both = { "p_center", "depth_plate" }
  local function history(options)
    return script_of(function(file)
      options.file = file
      plot.history(run, both[1], both[2], options)
    end)
  end
  has(history {}, "history", "on the screen a plot has its own title")
  plot.style "journal"
  local script = history {}
  lacks(script, "history", "a journal has none")
  has(history { title = "Mine" }, "Mine", "but the one that is given")
  lacks(history { title = false }, "history", "title=false")
  plot.history(run, "p_center", "depth_plate", { file = folder .. "/h.png" })
  local width, height = png_size "h.png"
  ok(width == 4016 and height < 0.5 * width, "two panels stand side by side on the page's 170 mm")
  plot.style { width = "column" }
  plot.history(run, "p_center", "depth_plate", { file = folder .. "/h.png" })
  width, height = png_size "h.png"
  ok(width == 2008 and height > width, "and below each other in a column")
  plot.style { "journal", width = "page" }
  plot { panels = { { line }, { line } }, layout = { 2, 1 }, file = folder .. "/h.png" }
  width, height = png_size "h.png"
  ok(height < width, "a page is not as high as it could be")
  plot.style "screen"
end

-- --- greys ---------------------------------------------------------------------------------------

-- Whether all colours of a script are greys.
local function is_grey(script)
  for r, g, b in script:gmatch "#%x?%x?(%x%x)(%x%x)(%x%x)'" do
    if r ~= g or g ~= b then return false end
  end
  return script:find "#" ~= nil
end

local function coloured(options)
  return script_of(function(file)
    plot { line, { x = { 1, 2 }, y = { 1, 2 }, colour = "orange" }, file = file, colour = options }
  end)
end

do
  ok(not is_grey(coloured()), "colours as a rule")
  ok(is_grey(coloured "grey"), 'colour = "grey"')
  ok(is_grey(coloured(false)), "colour = false")
  has(coloured "grey", "#adadad", "a named colour by its luminance")
  plot.style { "journal", colour = "grey" }
  ok(is_grey(coloured()), "by the style")
  ok(not is_grey(coloured(true)), "a call has the last word")
  plot.style "screen"
  local field = script_of(function(file)
    plot { { x = { 0, 1, 1, 0 }, y = { 0, 0, 1, 1 }, value = { 0, 1, 2, 3 } }, file = file, colour = "grey" }
  end)
  ok(is_grey(field:match "set palette[^\n]*"), "the colours of a field")
  refused(function() plot { line, colour = "gray" } end, "grey", "a word that is none")
end

pictures.remove()
