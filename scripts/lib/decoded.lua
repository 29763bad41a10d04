-- Returns the text of a file in UTF-8, without the byte order mark.

local as_utf8 = require "archard.lib.as_utf8"

return function(text) return (as_utf8(text):gsub("^\xEF\xBB\xBF", "")) end
