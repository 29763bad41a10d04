-- Returns a text in UTF-8 without the byte order mark. A text that is not valid UTF-8 is read as Latin-1, which is
-- usual under Windows.

local byte_order_mark = "\xEF\xBB\xBF"

return function(text)
  if not utf8.len(text) then text = text:gsub("[\x80-\xFF]", function(letter) return utf8.char(letter:byte()) end) end
  return (text:gsub("^" .. byte_order_mark, ""))
end
