"""What is said, before it is put into words: the only text that a layer below the catalogues hands on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from freebody.language.expression import Expr


@dataclass(frozen=True)
class Sentence:
    """What is said: a key of the catalogue and what it names. A text argument is a name of the model; one that begins
    with '@' is a word of the catalogue."""

    key: str
    args: Mapping[str, Argument] = field(default_factory=dict[str, "Argument"])


Argument = str | int | Expr | Sentence | tuple["Argument", ...]
NOTHING: Argument = ""
