-- Merges the run files of the shares of a study into one file. Files of different studies are refused, and so
-- are cases that are finished in two files with different results.

local stores = require "archard.store"
local check = require "archard.lib.check"

local function missing(store)
  local ids = {}
  for _, case in ipairs(store:cases()) do
    if case.status ~= "done" then ids[#ids + 1] = case.id end
  end
  return ids
end

local function refuse_gaps(path, ids)
  local shown = table.concat(ids, ", ", 1, math.min(#ids, 12)) .. (#ids > 12 and ", ..." or "")
  check.fail("study.merge", ("%s: %d cases are not finished in any of the files: %s"):format(path,
    #ids, shown))
end

-- Returns the files that have cases. A file has no cases if the program that wrote it was killed during its
-- start.
local function begun(files)
  local list = {}
  for _, file in ipairs(files) do
    local store <close> = stores.open(file, "read")
    if store:info "kind" or #store:cases() > 0 then list[#list + 1] = file end
  end
  if #list > 0 then return list end
  check.fail("study.merge", ("%s: the file has no cases%s"):format(files[1], files[2]
    and ", nor do the other files" or ""))
end

-- Writes the merged study to `path` and returns it. open(path): function that reads a study; write(study,
-- store): function that stores the definitions of a study.
return function(files, path, open, write)
  files = begun(files)
  local first = open(files[1])
  first:close()
  local store <close> = stores.replace(path, "study")
  write(first, store)
  for _, file in ipairs(files) do store:merge(file) end
  local gaps = missing(store)
  if #gaps > 0 then refuse_gaps(path, gaps) end
  store:publish()
  return open(path)
end
