-- The final values of the paper's cases from an independent solution of the same problem: the rows
-- that the page of figures compares with.
return require "archard.figures.independent".finals
