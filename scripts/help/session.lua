-- Help entries of the session itself: help, session, who, examples, time. Form: help/init.lua.

return {
  { "help.search", kind = "function", use = 'help.search "units"',
    text = "Lists the topics and entries in which all words of the text stand: topics and names first." },
  { "session", kind = "object", use = 'session.save "s.archard"',
    text = "All that a session has made: runs, models, studies, materials, numbers, texts and tables of them, by their "
      .. "global names." },
  { "session.save", kind = "function", use = "session.save(path)",
    text = "Writes everything into one run file; a session that was saved there before is replaced, anything else is "
      .. "refused. Without a path: where it was saved or opened last. Returns in words what was kept, and what was not "
      .. "(functions, stresses and the like; contacts, which contact{} and the same motions give again to the same bits). A study that has run stays in its own file, which is noted." },
  { "session.open", kind = "function", use = "session.open(path, { w = { k = f } })",
    text = "Makes everything in the file a global again; runs go on to the same numbers. Functions in a run's definition "
      .. "cannot be stored: the second table gives them again by the names of the runs. All of it or nothing: a run of "
      .. "that name that has not been saved is not overwritten. Returns in words what came." },
  { "wear.saved", kind = "field",
    text = "Whether a file holds the run as it stands: by w:save, session.save or wear.open, and not changed since." },
  { "who", kind = "function", use = "who()",
    text = "Lists what the session has made: name, class, and a few words on each." },
  { "examples", kind = "function", use = 'examples "wear"',
    text = "Lists the examples, a numbered course, with examples(); or shows one by its name or number." },
  { "examples.names", kind = "function", use = "examples.names()", text = "Their names, a list in the order of the course." },
  { "examples.run", kind = "function", use = 'examples.run "wear"',
    text = "Runs an example as a script of that name, with further arguments as its arguments. Files it writes go into the "
      .. "present folder; globals it makes stay." },
  { "time", kind = "function", use = "time(function() w:step() end)",
    text = "Calls the function, with further arguments as its own, and prints how long it took on the clock and how much "
      .. "time processors spent on it. Returns what the function does." },
}
