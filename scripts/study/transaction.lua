-- Runs a function whose writes into a run file are either all stored or all undone.

-- (store, work, argument...): calls work(argument...) in a transaction; on an error, its writes are rolled back and the
-- error is raised again.
return function(store, work, ...)
  store:begin()
  local fine, why = pcall(work, ...)
  if not fine then
    store:rollback()
    error(why, 0)
  end
  store:commit()
end
