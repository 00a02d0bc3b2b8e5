"""Pictures as one flat list of shapes and words, and their writers.

label      words and mathematical symbols with indices
shapes     lines, areas and words on paper, in points
picture    a finished picture: what is on it, in words too
svg, tikz, pixels   the writers
placer     where words find room
signs      arrows, arcs, dimension lines, axes
plane      a planar drawing as shapes
bodies_free   loads and reactions on bodies cut free
"""
