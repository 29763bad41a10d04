-- fit and fit.design: what they refuse, what they find, what they say of it, run files, pictures.

local tap = require "tests.lua.lib.tap"
