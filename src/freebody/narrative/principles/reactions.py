"""Symbols for reactions: what they mean in words, where they act, and how the numeric route reads them."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from freebody.connections.shared_by_copies import copy_of_row
from freebody.language.expression import Expr
from freebody.language.sentences import Argument, Sentence
from freebody.language.units import ENERGY
from freebody.model.elements import ConstraintRow
from freebody.narrative.lines.glossary import Glossary, Meaning, World
from freebody.narrative.lines.script import Legend, Script
from freebody.narrative.principles.acting import Acting
from freebody.questions.reactions import said_of_reaction


def name_reactions(script: Script, glossary: Glossary, acting: Acting, rows: Iterable[str], known: set[str]) -> None:
    """A legend of the reactions of some rows, without those whose symbols are in `known`, which grows."""
    entries: list[tuple[Expr, Sentence, str]] = []
    for name in _components_in_order(acting, dict.fromkeys(rows)):
        symbol = acting.symbol(name)
        if symbol.name not in known:
            known.add(symbol.name)
            meaning = Meaning(symbol, words_of(acting, name), reader(name, acting.sign(name)), _unit(acting.rows[name]))
            glossary.introduce(meaning)
            entries.append((symbol, meaning.what, meaning.unit))
    if entries:
        script.add(Legend(tuple(entries)))


def _components_in_order(acting: Acting, rows: Iterable[str]) -> list[str]:
    """The same rows; the components of a force or moment along x, y, z, where the first of them stands."""
    groups: dict[tuple[str, ...], list[str]] = {}
    for name in rows:
        row = acting.rows[name]
        groups.setdefault((row.connection, _without_axis(row)) if row.axis else (name,), []).append(name)
    return [name for own in groups.values() for name in sorted(own, key=lambda name: acting.rows[name].axis)]


def _without_axis(row: ConstraintRow) -> str:
    """What a reaction is, or the force of which it is a component."""
    return row.reaction.removesuffix(f" {row.axis}") if row.axis else row.reaction


def words_of(acting: Acting, name: str) -> Sentence:
    """What a reaction is, in words."""
    row = acting.rows[name]
    axis = row.axis
    kind = _without_axis(row)
    of = said_of_reaction(kind)
    args: dict[str, Argument] = {"reaction": f"@{of}.{kind}", "connection": row.connection}
    if copy := copy_of_row(row.component):
        return Sentence("symbol.couple_of_copy", {"copy": copy, "connection": row.connection})
    alike = [r for r in acting.rows.values() if (r.connection, r.reaction) == (row.connection, row.reaction)]
    has_contact_point = acting.system.connections[row.connection].has_contact_point
    place = place_of(row)
    is_one_of_several = len(alike) > 1 or f"{place} on " in row.component
    if row.ends and is_one_of_several and has_contact_point and place != row.connection:
        return Sentence(f"symbol.{of}_at", {**args, "place": place})
    if axis in ("x", "y", "z"):
        return Sentence(f"symbol.{of}_component", {**args, "axis": f"@{axis}"})
    if kind != row.reaction:
        return Sentence(f"symbol.{of}_row", {**args, "row": f"@{axis}"})
    if len(alike) > 1 and acting.system.space:
        return Sentence(f"symbol.{of}_row", {**args, "row": f"@{row.component.removeprefix(f'{row.reaction} ')}"})
    if row.ends and len(alike) > 1:
        return Sentence(f"symbol.{of}_between", {**args, "ends": tuple(row.ends)})
    return Sentence(f"symbol.{of}", args)


def place_of(row: ConstraintRow) -> str:
    """Where a contact acts, as a person names it: block.bottom_left where that is a point of a body, else the name of
    the connection."""
    return row.ends[0] if row.ends and "." in row.ends[0] else row.connection


def _unit(row: ConstraintRow) -> str:
    """A reaction times the change of what its row holds is work."""
    return str(ENERGY / row.measure.dimension)


def reader(name: str, sign: int) -> Callable[[World], float]:
    """Reads the reaction of a row: its sign, as it is written, times its multiplier."""

    def read(world: World) -> float:
        held = next(r for r in world.snapshot.reference.system.constraint_rows if r.name == name)
        return sign * world.snapshot.multiplier(held)

    return read
