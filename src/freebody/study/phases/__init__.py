"""Motion in phases: which modes follow each other, where in the space of parameters, and what is asked of them."""
