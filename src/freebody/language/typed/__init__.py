"""What people type as an answer, as an expression: lenient where the files of models are strict, and never executed.

characters  one way to write what keyboards and word processors write in several
latex       LaTeX mathematics in plain notation
words       runs of letters as names of a problem
grammar     plain notation with products side by side, arguments without brackets and the forks that these leave
statement   labels, relations, vectors, intervals, numbers with units
"""

from __future__ import annotations

from freebody.language.typed.statement import TypedAnswer, TypedNumber, read_equation, read_equations, read_typed
from freebody.language.typed.words import Vocabulary

__all__ = ["TypedAnswer", "TypedNumber", "Vocabulary", "read_equation", "read_equations", "read_typed"]
