-- Runs a function in a transaction of a run file: either all of its writes are stored or none.

-- Calls work(...) in a transaction of `store`. On an error, all writes are undone and the error is raised
-- again.
return function(store, work, ...)
  store:begin()
  local fine, why = pcall(work, ...)
  if not fine then
    store:rollback()
    error(why, 0)
  end
  store:commit()
end
