-- All of what a function writes into a run file, or nothing of it. Leans on nothing.

-- (store, work, argument...): calls work(argument...) in a transaction of its own; an error takes back
-- what it wrote and goes on.
return function(store, work, ...)
  store:begin()
  local fine, why = pcall(work, ...)
  if not fine then
    store:rollback()
    error(why, 0)
  end
  store:commit()
end
