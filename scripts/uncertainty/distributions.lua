-- Distributions of uncertain numbers: uniform{}, normal{} and lognormal{}. The quantile function of a
-- distribution converts a cumulative probability to a value.

local check = require "archard.lib.check"
local random = require "archard.random"
local strict = require "archard.strict"

local class = strict.class{ __name = "distribution", __fields = { "kind", "mean", "deviation", "low", "high" } }

-- Returns a distribution as text, such as "normal{ mean=100, deviation=5 }". The text is Lua code that
-- creates an equal distribution.
function class.__tostring(self)
  local parts = {}
  for _, name in ipairs{ "mean", "deviation", "low", "high" } do
    local value = rawget(self, name)
    if value and math.abs(value) < math.huge then
      parts[#parts + 1] = ("%s=%s"):format(name, ("%.15g"):format(value))
    end
  end
  return ("%s{ %s }"):format(self.kind, table.concat(parts, ", "))
end

-- Returns true if `text` has the format of class.__tostring.
local kinds = { uniform = true, normal = true, lognormal = true }
local function is_text(text)
  local kind, inside = text:match "^(%a+){ ([^{}]*) }$"
  if not kinds[kind] then return false end
  for part in (inside .. ", "):gmatch "(.-), " do
    local name, value = part:match "^(%a+)=(%S+)$"
    if not (name and tonumber(value)) then return false end
  end
  return true
end

-- --- the fields ----------------------------------------------------------------------------------

-- Returns the fields of a distribution by name. The user may give the first two fields by position.
local function read(kind, order, fields, given)
  if type(given) ~= "table" then
    check.fail(kind, ("expected a table, %s{ %s=, %s= }, got %s"):format(kind, order[1], order[2],
      check.shown(given)))
  end
  local named = {}
  for key, value in pairs(given) do
    local name = order[key] or key
    local twice = named[name] ~= nil and ("%s twice"):format(name)
    if twice or type(name) ~= "string" then
      check.fail(kind, ("expected two numbers, %s and %s, or fields by name; got %s"):format(order[1], order[2],
        twice or ("a value at index %s"):format(tostring(key))))
    end
    named[name] = value
  end
  return check.fields(kind, named, fields)
end

local function required(kind, given, name, what)
  if given[name] == nil then
    check.fail(kind, ("field '%s': expected %s, got none"):format(name, what))
  end
end

-- Raises an error if low >= high.
local function ordered(kind, low, high)
  if low >= high then
    check.fail(kind, ("fields 'low' and 'high': expected low < high, got %g and %g"):format(low, high))
  end
end

-- Returns the standard deviation: the field `deviation`, or the field `variation` times |mean|.
local function spread_of(kind, given)
  required(kind, given, "mean", "the mean")
  if (given.deviation == nil) == (given.variation == nil) then
    check.fail(kind, ("fields 'deviation' and 'variation' (deviation / mean): expected one of them, "
      .. "got %s"):format(given.deviation and "both" or "neither"))
  end
  return given.deviation or given.variation * math.abs(given.mean)
end

-- --- the distributions ---------------------------------------------------------------------------

local function same(x) return x end

-- Returns a distribution in which the transformed value (the logarithm for lognormal{}) is normally
-- distributed. Values are truncated to [low, high]. middle, width: mean and standard deviation of the
-- transformed value before truncation; to_scale, from_scale: the transformation and its inverse.
local function bell(kind, given, middle, width, to_scale, from_scale)
  local low, high = given.low or -math.huge, given.high or math.huge
  ordered(kind, low, high)
  local function share(value) return random.normal_share((to_scale(value) - middle) / width) end
  local from, to = share(low), share(high)
  if to - from < 1e-6 then
    check.fail(kind, ("fields 'low' and 'high': the probability of values between %g "
      .. "and %g is almost 0"):format(low, high))
  end
  local cut = from > 0 or to < 1
  return setmetatable({ kind = kind, mean = given.mean, deviation = spread_of(kind, given),
    low = given.low, high = given.high, value = function(p)
      local z = random.normal_quantile(cut and from + p * (to - from) or p)
      return math.max(low, math.min(high, from_scale(middle + width * z)))
    end }, class)
end

local distributions = {}

local bell_fields = { mean = check.number, deviation = check.positive, variation = check.positive,
  low = check.number, high = check.number }

function distributions.normal(given)
  given = read("normal", { "mean", "deviation" }, bell_fields, given)
  return bell("normal", given, given.mean, spread_of("normal", given), same, same)
end

local widest = 10 -- largest accepted deviation / mean; a larger deviation was probably meant as variation

-- Returns a lognormal distribution. Its mean and deviation refer to the values, not to their logarithms.
function distributions.lognormal(given)
  given = read("lognormal", { "mean", "deviation" }, bell_fields, given)
  local deviation = spread_of("lognormal", given)
  if given.mean <= 0 then check.refuse("lognormal", "mean", "a number > 0", given.mean) end
  if deviation > widest * given.mean then
    check.fail("lognormal", ("field 'deviation': expected at most %g times the mean %g, got %g; for deviation / "
      .. "mean use variation="):format(widest, given.mean, deviation))
  end
  local width = math.sqrt(math.log(1 + (deviation / given.mean) ^ 2))
  local middle = math.log(given.mean) - width * width / 2
  return bell("lognormal", given, middle, width,
    function(value) return value > 0 and math.log(value) or -math.huge end, math.exp)
end

function distributions.uniform(given)
  given = read("uniform", { "low", "high" }, { low = check.number, high = check.number }, given)
  required("uniform", given, "low", "the lower end")
  required("uniform", given, "high", "the upper end")
  ordered("uniform", given.low, given.high)
  local low, high = given.low, given.high
  return setmetatable({ kind = "uniform", low = low, high = high,
    value = function(p) return low + p * (high - low) end }, class)
end

function distributions.is(value) return getmetatable(value) == class end

distributions.is_text = is_text

return distributions
