"""Tolerances that several files share, each stated once: of what it is a part, and why it is so large.

A tolerance that a single file needs stands at the head of that file, with the same two things said. Doubles carry 16
digits (2.2e-16); what is lost of them decides how small a number must be to count as none. Kernels have their own, in
`numeric/engine`, since each change to their sources compiles all of them anew.
"""

# Beside one, or beside the terms of a sum [1; SI for numbers of about one]. What vanishes in exact arithmetic leaves
# this in doubles: seven of sixteen digits may go, in sums of many terms and in solutions with condition numbers to 1e6.
ROUND_OFF = 1e-9

# Beside the terms it is made of [1; SI for numbers of about one]. What a few operations on doubles leave of an exact
# zero: four of sixteen digits, where nothing was solved for.
ROUNDED = 1e-12

# A divisor is at least this [any unit]: 0/0 becomes 0, and no other quotient of doubles changes.
LEAST = 1e-300

# Places nearer than this part of the size of a system are one [1]: poses are assembled to 1e-11 of it.
SAME_PLACE = 1e-9

# A gap below this part of the size of a system is none [1]: where poses are found by minimising, a gap that closes
# with its square is known to half the digits.
TOUCHES = 1e-8

# A force whose line of action misses a point by less than this part of the size of a system goes through it [1]:
# forces are solved for, and pictures show no more.
ON_LINE = 1e-6

# What is watched or guarded along a motion is zero below this part of its size [1]: dense output is a polynomial whose
# value is rounded in the thirteenth digit or before.
WATCHED_ZERO = 1e-12

# Zeros of it between which it stays below this part of its size are one touch [1]: a step is not more exact.
RESOLUTION = 1e-9
