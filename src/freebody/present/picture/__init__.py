"""Pictures as one flat list of shapes and words, and their writers.

label      words and mathematical symbols with indices
shapes     lines, areas and words on paper, in points
picture    a finished picture: what is on it, in words too
sketch     one in the making
placer     where words find room
signs      arrows, arcs, dimension lines
svg, tikz, pixels   the writers

plane, space   drawings as shapes
whole      a system with its coordinates, dimensions, axes
coordinates, dimensions   the signs of these
forces, arrows   loads and reactions
bodies_free   bodies cut free
motion     velocities, accelerations, instant centres
"""
