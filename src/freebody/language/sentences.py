"""What is said, before it is put into words: the only text that a layer below the catalogues hands on.

A `Sentence` of a derivation has a key and is put into words by a catalogue alone. A `Message` is said in English at
once and remembers of what; errors are made of them as well, so they stand below the language (`freebody.messages`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from freebody.language.expression import Expr
from freebody.messages import Message, as_found, further, in_turn, lines, listed, turns


@dataclass(frozen=True)
class Sentence:
    """What is said: a key of the catalogue and what it names. A text argument is a name of the model; one that begins
    with '@' is a word of the catalogue."""

    key: str
    args: Mapping[str, Argument] = field(default_factory=dict[str, "Argument"])


Argument = str | int | Expr | Sentence | tuple["Argument", ...]
NOTHING: Argument = ""

__all__ = ["NOTHING", "Argument", "Message", "Sentence", "as_found", "further", "in_turn", "lines", "listed", "turns"]
