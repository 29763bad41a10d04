-- Writes an HTML page with the figures and tables of a study. Each figure has a description, a caption
-- and the commands that draw it. The page needs no other files except the pictures and linked data
-- files in its folder.

local files = require "archard.files"

local page = {}

local escapes = { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ['"'] = "&quot;" }
local function text(value) return (tostring(value):gsub('[&<>"]', escapes)) end

local style = [[
:root { --ink: #1d2129; --soft: #5b6472; --line: #d9dde3; --back: #ffffff; --code: #f4f6f8; }
* { box-sizing: border-box; }
body { margin: 0; background: var(--back); color: var(--ink);
  font: 16px/1.55 system-ui, "DejaVu Sans", sans-serif; }
main { max-width: 66rem; margin: 0 auto; padding: 2.5rem 1.25rem 5rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .5rem; }
h2 { font-size: 1.25rem; margin: 3.5rem 0 .5rem; padding-top: 1rem;
  border-top: 1px solid var(--line); }
p { max-width: 46rem; margin: .6rem 0; }
.lead, figcaption, .how { color: var(--soft); }
nav { margin: 1.25rem 0 0; }
nav a { display: inline-block; margin: 0 .9rem .3rem 0; }
a { color: #0b5cad; }
figure { margin: 1rem 0; }
figure img { display: block; width: 100%; height: auto; border: 1px solid var(--line);
  background: #fff; }
figcaption { font-size: .93rem; margin-top: .6rem; max-width: 46rem; }
pre, code { font: .88rem/1.5 ui-monospace, "DejaVu Sans Mono", monospace; background: var(--code); }
pre { padding: .7rem .9rem; overflow-x: auto; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: .88rem; font-variant-numeric: tabular-nums; }
th, td { padding: .25rem .6rem; text-align: right; white-space: nowrap;
  border-bottom: 1px solid var(--line); }
th { font-weight: 600; }
th:first-child, td:first-child { text-align: left; }
]]

-- --- parts ---------------------------------------------------------------------------------------

local function base_name(path) return path:match("[^/]*$") end

-- Returns the HTML of a figure's picture and of links to all its files. The picture is the SVG file if
-- there is one, otherwise the first file.
local function picture(figure)
  local shown, links = nil, {}
  for _, file in ipairs(figure.files) do
    local name = base_name(file)
    if not shown or name:find("%.svg$") then shown = name end
    links[#links + 1] = ('<a href="%s">%s</a>'):format(text(name),
      text(name:match("%.(%w+)$"):upper()))
  end
  return ('<a href="%s"><img src="%s" alt="%s" loading="lazy"></a>'):format(text(shown),
    text(shown), text(figure.title)), table.concat(links, " ")
end

local function figure_section(figure, how)
  local image, links = picture(figure)
  return table.concat({
    ('<h2 id="%s">%s</h2>'):format(text(figure.name), text(figure.title)),
    figure.shows ~= "" and ("<p>%s</p>"):format(text(figure.shows)) or "",
    "<figure>", image,
    ("<figcaption>%s %s</figcaption>"):format(text(figure.caption), links),
    "</figure>",
    how and ("<p class=\"how\">Commands that draw this figure:</p><pre>%s</pre>"):format(text(how)) or "",
  }, "\n")
end

-- Returns an HTML table from a list of rows. The first row contains the column headings.
local function html_table(lines)
  local out = { '<div class="scroll"><table>' }
  for i, line in ipairs(lines) do
    local tag, cells = i == 1 and "th" or "td", {}
    for c, cell in ipairs(line) do cells[c] = ("<%s>%s</%s>"):format(tag, text(cell), tag) end
    out[#out + 1] = "<tr>" .. table.concat(cells) .. "</tr>"
  end
  out[#out + 1] = "</table></div>"
  return table.concat(out, "\n")
end

local function data_link(file)
  return file and (' <a href="%s">All digits</a>'):format(text(file)) or ""
end

-- --- the page ------------------------------------------------------------------------------------

-- Returns the HTML text of the page. `content` is a table { title=, lead=, tables = { { title=, text=,
-- rows=, file= } }, figures= }. `figures` is a list of figures returned by study:figures; the field `how`
-- of a figure contains the commands that draw it.
function page.html(content)
  local links, sections = {}, {}
  for i, each in ipairs(content.tables or {}) do
    links[#links + 1] = ('<a href="#table%d">%s</a>'):format(i, text(each.title))
    sections[#sections + 1] = ('<h2 id="table%d">%s</h2>\n<p>%s%s</p>\n%s'):format(i,
      text(each.title), text(each.text), data_link(each.file), html_table(each.rows))
  end
  for _, figure in ipairs(content.figures) do
    links[#links + 1] = ('<a href="#%s">%s</a>'):format(text(figure.name),
      text(figure.title:match("^[^.]*")))
    sections[#sections + 1] = figure_section(figure, figure.how)
  end
  return table.concat({
    "<!DOCTYPE html>", '<html lang="en">', "<head>", '<meta charset="utf-8">',
    '<meta name="viewport" content="width=device-width, initial-scale=1">',
    ("<title>%s</title>"):format(text(content.title)), "<style>", style .. "</style>", "</head>",
    "<body>", "<main>", ("<h1>%s</h1>"):format(text(content.title)),
    ('<p class="lead">%s</p>'):format(text(content.lead)),
    "<nav>" .. table.concat(links, "\n") .. "</nav>", table.concat(sections, "\n"),
    "</main>", "</body>", "</html>" }, "\n")
end

function page.write(path, content) files.write("figures", path, page.html(content) .. "\n") end

return page
