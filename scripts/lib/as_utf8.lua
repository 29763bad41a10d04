-- Returns a text in UTF-8. A text that is not valid UTF-8 is read as Latin-1, which is usual under Windows: each byte
-- above 127 is the Unicode character with this number.

return function(text)
  if utf8.len(text) then return text end
  return (text:gsub("[\x80-\xFF]", function(letter) return utf8.char(letter:byte()) end))
end
