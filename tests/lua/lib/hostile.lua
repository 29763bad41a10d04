-- Hostile values and actions: metamethods, callbacks and finalizers that act during a call. All values and
-- actions are drawn by math.random, so a seed reproduces them.

-- Returns hostile values and actions for the given world. world.objects: objects to attack, by class;
-- world.target: the object of the call; world.again(class): creates a new object; world.closed: list of closed
-- objects; world.path(name): returns a file name.
return function(world)
  local hostile = {}
  local random, objects = math.random, world.objects

  local function one_of(list) return list[random(#list)] end

  -- Errors raised by hostile code, which a call may return to its caller.
  local raised = setmetatable({}, { __mode = "k" })
  local spoken = "hostile words"

  function hostile.is_own(err)
    return raised[err] ~= nil or type(err) == "string" and err:find(spoken, 1, true) ~= nil
  end

  local function raise()
    local value = one_of{ 1, 2, 3, 4, 5 }
    if value == 1 then error(spoken) end
    if value == 2 then error(spoken, 0) end
    local err = value == 3 and {} or value == 4 and setmetatable({}, { __tostring = function() return 5 end })
      or setmetatable({}, { __tostring = function() error(spoken) end, __concat = error, __name = 7 })
    raised[err] = true
    error(err)
  end

  -- --- actions --------------------------------------------------------------------------------

  local classes = {}
  for class in pairs(objects) do classes[#classes + 1] = class end
  table.sort(classes)

  -- Returns an object, mostly the object of the call.
  local function victim()
    if random(2) == 1 then return world.target end
    return objects[one_of(classes)]
  end
  hostile.victim = victim

  local function quietly(f, ...) return pcall(f, ...) end

  local depth, budget = 0, 0 -- depth of nested actions; number of actions left for the call
  local given = {} -- tables passed to the call

  local deeds = {
    function() quietly(function() objects.wear:close() end) world.again "wear" end,
    function() quietly(function() victim():close() end) end,
    function() quietly(function() objects.wear:step() end) end,
    function() quietly(function() objects.wear:run{ distance = objects.wear.distance + 11, progress = false } end) end,
    function() quietly(function() objects.wear:set{ distance = 44, k = 1e-8, alpha = random() } end) end,
    function() quietly(function() objects.wear:set{ mesh = { size = 0.12 } } end) end,
    function() quietly(function() objects.wear:save(world.path "hostile.archard") end) end,
    function() quietly(function() return objects.wear:clone():step() end) end,
    function() quietly(function() return objects.wear.history, objects.wear:profile "plate", objects.wear.mesh end) end,
    function() quietly(function() return objects.contact:stress(), objects.contact:pressure() end) end,
    function() quietly(function() return tostring(victim()) end) end,
    function() quietly(function() objects.store:close() end) end,
    function() quietly(function() return objects.store:values(1), objects.store:cases() end) end,
    function() quietly(wear.open, world.path "hostile.archard") end,
    function() collectgarbage "step" end,
    function() collectgarbage "step" end,
    function()
      for _, value in ipairs(given) do
        for name in next, value do value[name] = nil end
      end
      collectgarbage "step"
    end,
    function()
      for _, value in ipairs(given) do
        for i = 1, 50 do value["more" .. i], value[i] = i, i end
      end
    end,
    function()
      local value = victim()
      local metatable = debug.getmetatable(value)
      if type(value) ~= "userdata" then return end
      debug.setmetatable(value, one_of{ {}, debug.getmetatable(objects.model), debug.getmetatable(objects.material) })
      quietly(function() return value.distance, value.radius, value:step(), value:node(1), tostring(value) end)
      debug.setmetatable(value, metatable)
    end,
    function() coroutine.yield(victim()) end,
    function() coroutine.wrap(function() objects.wear:step() coroutine.yield() end)() end,
    raise,
    function() hostile.call() end,
  }

  local function act()
    if depth >= 3 or budget == 0 then return end
    depth, budget = depth + 1, budget - 1
    local fine, err = pcall(one_of(deeds))
    depth = depth - 1
    if not fine then error(err, 0) end
  end
  hostile.act = act

  -- --- values -------------------------------------------------------------------------------------

  local numbers = { 0, -1, 1, 2, 0.5, 3, 7, 12, 0 / 0, -(0 / 0), math.huge, -math.huge, 2^53, -2^61,
    -- omits values that give small steps or fine meshes, which are slow
    math.maxinteger, math.mininteger, 1e300, -1e-300 }
  local texts = { "", "cylinder", "plate", "auto", "a\0b", ("x"):rep(300), "\27[31m", "%s%n", "100", "implicit" }

  -- Returns random values for a callback to return.
  local function answer(...)
    local choice = random(10)
    if choice <= 3 then return 1e-8 end
    if choice == 4 then return one_of(numbers) end
    if choice == 5 then return hostile.value() end
    if choice == 6 then return ... end
    if choice == 7 then return (select(-1, ...)) end
    return random()
  end

  -- Returns a function that sometimes performs an action before it returns.
  local function callback()
    local often = random(3)
    return function(...)
      if random(often) == 1 then act() end
      if select("#", ...) == 0 then return random() end
      return answer(...)
    end
  end
  hostile.callback = callback

  local function do_and(value)
    return function() act() return value end
  end

  local metamethods = {
    __len = function() return one_of{ function() return 2^61 end, function() return 1 << 61 end, function() return -1 end,
      function() return "10" end, raise, do_and(3), function() return {} end } end,
    __index = function() return one_of{ callback(), function(_, key) act() return rawget(world.plain, key) end,
      do_and(nil), do_and(1), victim(), world.plain } end,
    __newindex = function() return callback() end,
    __pairs = function() return one_of{ raise, do_and(next), callback() } end,
    __tostring = function() return one_of{ raise, do_and "text", do_and(5), callback() } end,
    __call = function() return callback() end,
    __eq = function() return one_of{ raise, do_and(true) } end,
    __lt = function() return one_of{ raise, do_and(true) } end,
    __concat = function() return one_of{ raise, do_and "text" } end,
    __gc = function() return function() quietly(act) end end,
    __close = function() return function() quietly(act) end end,
    __name = function() return one_of{ "wear", "model", 5, "" } end,
    __worn = function() return one_of{ do_and{ x = { -1, 1 }, h = { 0, 1e-3 } }, do_and(5), raise, callback() } end,
    __metatable = function() return one_of{ false, 5, "locked", {} } end,
    __mode = function() return one_of{ "k", "v", "kv" } end,
    __fields = function() return one_of{ 5, {} } end,
    __plain = function() return true end,
  }
  local events = {}
  for name in pairs(metamethods) do events[#events + 1] = name end
  table.sort(events)

  -- Returns the table with some hostile metamethods added.
  local function armed(value)
    local metatable = {}
    for _ = 1, random(3) do
      local name = one_of(events)
      metatable[name] = metamethods[name]()
    end
    return setmetatable(value, metatable)
  end
  hostile.armed = armed

  local function plain_list()
    local list = {}
    for i = 1, random(0, 6) do list[i] = random(4) == 1 and one_of(numbers) or i end
    return list
  end

  local function items()
    local list = {}
    for i = 1, random(3) do list[i] = hostile.value() end
    return list
  end

  local nested = 0
  local kinds = {
    function() return one_of(numbers) end,
    function() return one_of(numbers) end,
    function() return one_of(texts) end,
    function() return random(2) == 1 end,
    callback, callback, callback,
    victim, victim,
    function() return world.closed[random(#world.closed)] end,
    plain_list,
    function() return armed(plain_list()) end,
    function() return armed{} end,
    items,
    function() return armed(items()) end,
    function() return coroutine.create(callback()) end,
    function() return coroutine.wrap(callback()) end,
    function() return io.stderr end,
    function() return { x = plain_list(), h = plain_list(), y = callback(), t = plain_list() } end,
    function() return armed{ x = armed{ -1, 0, 1 }, h = armed{ 0, 1e-3, 0 }, p = { 1, 2, 3 } } end,
    function() return { cylinder = hostile.value(), plate = hostile.value() } end,
    function() return { distance = armed{ 0, 100 }, value = { 1e-8, 1e-8 } } end,
    function() local t = {} t[1], t.t = t, t return t end,
    function() return world.path "hostile.archard" end,
  }

  function hostile.value()
    if nested > 3 then return one_of(numbers) end
    nested = nested + 1
    local fine, value = pcall(one_of(kinds))
    nested = nested - 1
    if not fine then value = nil end
    if type(value) == "table" and getmetatable(value) == nil then given[#given + 1] = value end
    return value
  end

  -- Stores a table that is passed to a call, so actions can change it.
  function hostile.hand_over(value)
    if type(value) == "table" and debug.getmetatable(value) == nil then given[#given + 1] = value end
    return value
  end

  function hostile.begin()
    for i = #given, 1, -1 do given[i] = nil end
    depth, nested, budget = 0, 0, 30
  end

  -- Creates garbage whose finalizers act during the next call.
  function hostile.lay_mines()
    for _ = 1, random(4) do
      setmetatable({}, { __gc = function() quietly(act) end })
    end
  end

  return hostile
end
