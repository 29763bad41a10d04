-- Names of a joint's bodies, in the form of a model, for archard.measure.
return { upper = { name = "head" }, lower = { name = "cup" } }
