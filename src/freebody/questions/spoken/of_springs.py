"""Springs in the grammar: force, energy and how much longer they are."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.questions.spoken import given, lookup, transmitting
from freebody.questions.spoken.composing import SILENT, Groups, said_of
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names


@said_of("spring force")
def in_spring(names: Names, quantity: str, rest: Clause) -> Groups:
    """The force of a spring, which is named or the only one."""
    of = [name for _, name in rest.names]
    if rest.only("name", *SILENT) and len(of) <= 1:
        yield [f"force in {name}" for name in of or lookup.springs(names)]


@said_of("spring energy")
def _in_springs(names: Names, quantity: str, rest: Clause) -> Groups:
    """F^2/(2 k) of a spring whose force is in proportion to its extension."""
    of = [name for _, name in rest.names if name in names.loads]
    if not rest.only("name", *SILENT) or len(rest.names) > 1:
        return
    found = [(name, given.stiffness(names, name)) for name in of or lookup.springs(names)]
    yield [f"(force in {name})^2 / (2*{k})" for name, k in found if k]


@said_of(*lookup.STRETCHED)
def _extension(names: Names, quantity: str, rest: Clause) -> Groups:
    """By how much a spring is longer, or shorter, than without force."""
    of = [name for _, name in rest.names]
    if quantity == "compression" and (rods := transmitting.rods(names, "axial force", rest)):
        yield [f"axial force of {rod}" for rod in rods]
        return
    if len(of) <= 1 and rest.only("name", *SILENT):
        yield [f"{quantity} of {spring}" for spring in lookup.springs(names) if spring in (of or [spring])]
