"""Pictures and animations of systems in space.

A `Scene` is what to draw, in numbers; a `Drawing` is that on its way through poses, made of convex pieces; a `View`
puts them on paper; the painter draws them from the farthest to the nearest. Stills, films and the player page share
all of it.
"""
