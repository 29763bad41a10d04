-- Runs a function in a transaction of a run file: either all of its writes are stored or none.

local collect = collectgarbage

-- Calls work(...) in a transaction of `store`. On an error, all writes are undone and the error is raised
-- again. No garbage is collected meanwhile: a finalizer could open and close the same file, after which the
-- system releases the file's locks.
return function(store, work, ...)
  store:begin()
  local collects = collect "isrunning"
  collect "stop"
  local fine, why = pcall(work, ...)
  if fine then fine, why = pcall(store.commit, store) else store:rollback() end
  if collects then collect "restart" end
  if not fine then error(why, 0) end
end
