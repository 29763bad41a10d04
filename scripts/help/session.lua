-- Help entries of the session: help, session, who, examples, time. help/engine.lua explains the form of an
-- entry.

return {
  { "help.search", kind = "function", use = 'help.search "units"',
    text = "Lists the topics and entries that contain all words of the text. Entries with the words in their names "
      .. "are first." },
  { "session", kind = "object", use = 'session.save "s.archard"',
    text = "Saves and restores all objects that have a global name: runs, models, contacts, studies, fits and "
      .. "other results, profiles, maps, materials, numbers and texts, and tables of these." },
  { "session.save", kind = "function", use = "session.save(path)",
    text = "Writes all objects into one run file. A session saved in this file is replaced; other files are "
      .. "refused. The default path is the file of the last session.save or session.open. Functions, "
      .. "stresses, and contacts on surfaces that no longer exist are not saved; a study with results "
      .. "remains in its own file. Returns a text that lists what was saved and what was not." },
  { "session.open", kind = "function", use = "session.open(path, { w = { k = f } })",
    text = "Restores all objects of the file as globals; runs continue with the same results. Functions are not "
      .. "stored: pass the functions of a run again under the name of the run, such as k of the run w above. If an "
      .. "object cannot be restored, nothing changes. An unsaved run with the name of a stored object is not "
      .. "overwritten. Returns a text that lists the objects." },
  { "wear.saved", kind = "field",
    text = "True if a file contains the present state of the run, written by w:save or session.save or read by "
      .. "wear.open." },
  { "who", kind = "function", use = "who()",
    text = "Lists the objects of the session with their names, classes, and short descriptions." },
  { "examples", kind = "function", use = 'examples "wear"',
    text = 'examples() lists the examples in the order in which to study them. examples "wear" or examples(3) '
      .. "shows one example by its name or number." },
  { "examples.names", kind = "function", use = "examples.names()",
    text = "Returns the names of the examples in the order in which to study them." },
  { "examples.run", kind = "function", use = 'examples.run "wear"',
    text = "Runs an example as a script. Arguments after the name are passed to the script. Its files are "
      .. "written to the current folder, and its globals remain." },
  { "time", kind = "function", use = "time(function() w:step() end)",
    text = "Calls the function, prints the elapsed time and the processor time, and returns the results of the "
      .. "function. Arguments after the function are passed to it." },
}
