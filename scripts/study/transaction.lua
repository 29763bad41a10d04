-- Runs a function in a transaction of a run file: its writes are either all stored or all undone.

-- Called as transaction(store, work, argument...): calls work(argument...). On an error the writes are rolled
-- back and the error is raised again.
return function(store, work, ...)
  store:begin()
  local fine, why = pcall(work, ...)
  if not fine then
    store:rollback()
    error(why, 0)
  end
  store:commit()
end
