"""How words for a quantity and for what it is of are put into the grammar: each kind of quantity says it in its room.

A function gives groups of texts: those of a group are ways to mean the same words, of which the model has several; a
later group is tried where nothing of an earlier one can be read. What no room speaks of is asked as the grammar writes
most quantities: alone, or `of` what is named.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

Groups = Iterator[list[str]]
Compose = Callable[["Names", str, Clause], Groups]
SILENT = ("filler", "pronoun", "preposition", "updown")  # kinds of words that ask for nothing by themselves
ALONG = {"horizontal": "right", "vertical": "up", "upward": "up", "downward": "down", "up": "up", "down": "down"}
JOINT = "; "  # between several questions, in the words of the grammar
_ROOMS: dict[str, Compose] = {}


def said_of(*quantities: str) -> Callable[[Compose], Compose]:
    """Lets a function put some quantities into the grammar."""

    def add(compose: Compose) -> Compose:
        _ROOMS.update(dict.fromkeys(quantities, compose))
        return compose

    return add


def composed(names: Names, quantity: str, rest: Clause) -> Groups:
    """A quantity in the grammar. rest: the other words of its clause."""
    yield from _ROOMS.get(quantity, _written)(names, quantity, rest)


def _written(names: Names, quantity: str, rest: Clause) -> Groups:
    """A quantity alone, or of what is named; of a system that moves as one, a body is not named."""
    of = [name for before, name in rest.names if before != "relative"]
    relative = "".join(f" relative to {name}" for before, name in rest.names if before == "relative")
    if not rest.only("name", "part", *SILENT) or set(rest.all("part")) - {"small"} or len(of) > 1:
        return
    if of:
        yield [f"{quantity} of {of[0]}{relative}"]
    if not relative:
        yield [quantity]


def ended(text: str, end: str) -> str:
    """A question, or each of several, with what is said of when."""
    return JOINT.join(f"{one}{end}" for one in text.split(JOINT))


def without_owners(of: list[str]) -> list[str]:
    """A point is named with its body: the end A of the rod."""
    points = [name for name in of if "." in name]
    return [name for name in of if not any(point.startswith(f"{name}.") for point in points)]
