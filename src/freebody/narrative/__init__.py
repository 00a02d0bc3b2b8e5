"""Derivations: how an answer is found, step by step, each step checked, and told in words.

script       lines of a derivation; a line is checked against the numeric route before it is taken
glossary     what symbols mean, and their values at random motions
table        the table of principles: which equation contains which unknowns
planner      the cheapest closed set of them that contains what is asked
telling      a derivation as a report, in the words of a catalogue
"""
