-- Help entries of the session itself: help, session, who, examples, time. Form: help/init.lua.

return {
  { "help.search", kind = "function", use = 'help.search "units"',
    text = "Lists the topics and entries in which all words of the text stand: topics and names first." },
  { "session", kind = "object", use = 'session.save "s.archard"',
    text = "All objects of a session by their global names: runs, models, contacts, studies, fits and other results, "
      .. "profiles, maps, materials, numbers, texts and tables of these." },
  { "session.save", kind = "function", use = "session.save(path)",
    text = "Writes everything into one run file. A session that was saved there before is replaced; any other file is "
      .. "refused. Without a path: the file of the last save or open. A contact is kept as the calls that made it. Not "
      .. "kept: functions, stresses, and contacts on surfaces that are gone. A study that has run stays in its own file. "
      .. "Returns a text that lists what was kept and what was not." },
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
