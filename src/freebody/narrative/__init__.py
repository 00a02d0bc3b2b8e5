"""Derivations: how an answer is found, step by step, each step checked, and told in words.

explain        the worked solution of every question: opening, derivation by kind of question, closing
lines/         lines of a derivation, the symbols in them, and how they are checked
principles/    the table of momenta and moments, the planner, the algebra of their solution; Lagrange, energy
questions/     derivations by what is asked: instants, states, events, freedoms, conservation, small motions
contact/       motions in phases, and rest under dry friction
space/         derivations in space
steady/        motion that goes on evenly
mistakes/      which mistake leads to a wrong option
telling/       the catalogue of a language, and derivations told as reports
words/         what is said, one file per language
sheets/        exercise sheets
"""
