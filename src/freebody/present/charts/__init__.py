"""Charts of many numbers, as pictures that every format of report can show.

frame       axes with round numbers
diagram     a quantity along a line, with its values where they change, as on a board
lines       curves over one axis
cells       a plane of cells: numbers by their shade, or kinds by their colour
parallel    many names side by side, a line for each case
"""
