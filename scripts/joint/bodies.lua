-- Names of the bodies of a joint, in the form in which archard.measure expects the bodies of a model.
return { upper = { name = "head" }, lower = { name = "cup" } }
