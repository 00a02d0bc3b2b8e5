"""Symbols for reactions, with what they mean and how the numeric route reads them; in the plane and in space."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from freebody.language.expression import Symbol
from freebody.model.elements import ConstraintRow
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.naming import named
from freebody.narrative.lines.script import Argument, Script, Sentence
from freebody.system.symbols import reaction_symbols


def introduce_reactions(context: Context, script: Script, rows: Iterable[str], known: set[str]) -> None:
    """A legend of the reactions of some rows, without those in `known`, which grows."""
    symbols, held = reaction_symbols(context.system), {row.name: row for row in context.system.held}
    new = [name for name in dict.fromkeys(rows) if symbols[name].name not in known]
    known |= {symbols[name].name for name in new}
    if new:
        meanings = [
            Meaning(Symbol(symbols[n].name), words_of(context, held[n]), reader(n), _unit(held[n])) for n in new
        ]
        named(context, script, *meanings)


def words_of(context: Context, row: ConstraintRow) -> Sentence:
    """What a reaction is, in words."""
    args: dict[str, Argument] = {"reaction": f"@reaction.{row.reaction}", "connection": row.connection}
    axis = row.component.split()[-1]
    if axis in ("x", "y", "z"):
        return Sentence("space.reaction_component", {**args, "axis": f"@{axis}"})
    alike = [r for r in context.system.held if (r.connection, r.reaction) == (row.connection, row.reaction)]
    if len(alike) > 1:
        return Sentence("space.reaction_row", {**args, "row": f"@{row.component}"})
    return Sentence("symbol.reaction", args)


def _unit(row: ConstraintRow) -> str:
    return "N m" if "moment" in row.reaction or "torque" in row.reaction else "N"


def reader(name: str) -> Callable[[World], float]:
    """Reads the reaction of a row: its sign times its multiplier."""

    def read(world: World) -> float:
        held = next(r for r in world.snapshot.reference.system.held if r.name == name)
        return held.sign * world.snapshot.multiplier(held)

    return read
