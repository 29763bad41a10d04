-- Returns a text as XML requires it between quotes: in UTF-8, with &, < and quotes escaped.

local as_utf8 = require "archard.lib.as_utf8"

local escapes = { ["&"] = "&amp;", ["<"] = "&lt;", ['"'] = "&quot;" }

return function(text) return (as_utf8(text):gsub('[&<"]', escapes)) end
