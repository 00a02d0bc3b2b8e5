"""Motion in phases: one mode of contacts and dry friction after the other, in closed form."""
