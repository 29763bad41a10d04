-- Checks that print TAP lines. Each check returns true if it has passed, so a test can stop after a failure.

local tap = {}
local number = 0

function tap.ok(held, what)
  number = number + 1
  print((held and "ok " or "not ok ") .. number .. " - " .. what)
  return held
end

function tap.note(text)
  print("# " .. tostring(text):gsub("\n", "\n# "))
end

function tap.is(got, expected, what)
  if tap.ok(got == expected, what) then return true end
  tap.note("expected " .. tostring(expected) .. ", got " .. tostring(got))
  return false
end

-- Checks |got - expected| <= share |expected|, or |got| <= share if `expected` is zero.
function tap.near(got, expected, share, what)
  local tolerance = share * (expected == 0 and 1 or math.abs(expected))
  if tap.ok(type(got) == "number" and math.abs(got - expected) <= tolerance, what) then return true end
  tap.note(("expected %.17g, got %s"):format(expected, tostring(got)))
  return false
end

-- Checks that the text contains all parts (plain strings, not patterns).
function tap.holds(text, parts, what)
  text = tostring(text)
  for _, part in ipairs(type(parts) == "table" and parts or { parts }) do
    if not text:find(part, 1, true) then
      tap.ok(false, what)
      tap.note("no '" .. part .. "' in: " .. text)
      return false
    end
  end
  return tap.ok(true, what)
end

-- Checks that the function fails with an error that contains all `parts`; returns the error.
function tap.fails(f, parts, what)
  local done, err = pcall(f)
  if done then
    tap.ok(false, what)
    tap.note("no error")
    return nil
  end
  tap.holds(err, parts, what)
  return err
end

return tap
