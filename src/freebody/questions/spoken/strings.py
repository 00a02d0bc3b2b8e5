"""What strings of a model have for words: what hangs on them, between what they run level, or straight up."""

from __future__ import annotations

from collections import Counter
from itertools import pairwise
from typing import TYPE_CHECKING, cast

from freebody.language.notation import to_python
from freebody.measures.angle import Angle
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ZERO
from freebody.questions.spoken import lookup
from freebody.questions.spoken.joining import given_of, joined_by, touches
from freebody.questions.spoken.lexicon import Word

if TYPE_CHECKING:
    from freebody.model.elements import ConstraintRow
    from freebody.model.names import Names

_LEVEL = 1e-9  # of a direction that is level, or straight up


def hanging(names: Names) -> frozenset[str]:
    """Bodies that hang on strings alone, straight below where these leave them."""
    rows = [row for row in names.constraint_rows if row.reaction == "sideways force" and len(row.ends) == 1]
    down = [row for row in rows if isinstance(row.measure, Displacement) and _is_along(names, row.measure, level=True)]
    strings = {row.connection for row in names.constraint_rows if row.reaction == "tension"}
    others = {
        body for name in names.connections if name not in strings for body in names.connections[name].mentions(names)
    }
    return frozenset(body for row in down for body in row.ends) - others


def cables(names: Names) -> list[str]:
    """Cables that sag, whose tension changes along them."""
    return [name for name in names.connections if "hanging cable" in names.called.get(name, ())]


def run_off(names: Names, of: str) -> list[str]:
    """The condition that a rope with mass has left its drum, or the edge that it runs over: all of it hangs."""
    return hung_down(names, of, "{}")


def hung_down(names: Names, of: str, length: str) -> list[str]:
    """The condition that a length of a rope with mass hangs from its drum, or over an edge: {} is all of it."""
    found: list[str] = []
    for name, spec in names.connections.items():
        given = given_of(spec)
        rope, over, drum = str(given.get("rope")), given.get("over"), given.get("wound_on")
        n_places = (len(cast("list[object]", over)) if isinstance(over, list) else 0) + (drum is not None)
        is_free = rope in names.bodies and n_places == 1 and given.get("start") is None
        if is_free and of in ("", rope, name):
            whole = to_python(names.bodies[rope].sizes[0]).replace("**", "^")
            whole = whole if whole.isidentifier() or length == "{}" else f"({whole})"
            found += [f"{way} = {length.format(whole)}" for way in lookup.places(names, rope)]
    return found


def pulls_in_rope(names: Names, rope: str, at: list[str]) -> list[str]:
    """The tension of a rope with mass where it runs over something: at the edge."""
    found: list[str] = []
    for name, spec in names.connections.items():
        given = given_of(spec)
        over = given.get("over")
        places = [str(place) for place in cast("list[object]", over)] if isinstance(over, list) else []
        named = [place for place in places if place in at]  # along the rope it is not the same
        if given.get("rope") == rope and len(named) == 1:
            found.append(f"tension in {name} at {named[0]}")
    return found


def sections(names: Names, string: str, *, level: bool) -> list[tuple[str, ...]]:
    """What the stretches of a string that are level, or straight up, run between."""
    found: list[tuple[str, ...]] = []
    for row in names.constraint_rows:
        measure = row.measure
        if row.connection != string or row.reaction != "tension" or len(row.ends) != 2:
            continue
        parts = [part for _, part in measure.terms] if isinstance(measure, Combination) else [measure]
        leads = [part for part in parts if not isinstance(part, Angle)]
        if leads and all(isinstance(lead, Displacement) and _is_along(names, lead, level=level) for lead in leads):
            found.append(row.ends)
    return found


def spans(names: Names, string: str) -> list[str]:
    """Where the parts of a string are, in the words of the grammar: at the body at its end, or between two."""
    rows = [row for row in names.constraint_rows if row.connection == string and row.reaction == "tension"]
    pairs = [pair for row in rows for pair in (_rubbed(names, row) if len(row.stretches) > 1 else pairwise(row.ends))]
    found: list[str] = []
    for pair in pairs:
        plain = [end for end in pair if end in names.bodies and not names.bodies[end].is_wheel and end != GROUND]
        is_end = len(plain) == 1 and sum(plain[0] in other for other in pairs) == 1
        found.append(f"at {plain[0]}" if is_end else f"between {' and '.join(pair)}")
    return list(dict.fromkeys(found))


def _rubbed(names: Names, row: ConstraintRow) -> list[tuple[str, str]]:
    """The bodies at the ends of the parts of a string that has another tension behind each drum on which it rubs; of a
    body to which both ends are tied, its points."""
    ends = [end for stretch in row.stretches for end in (stretch.places[0], _last(stretch.places))]
    n_ends = Counter(end.partition(".")[0] for end in ends)
    bodies = [end.partition(".")[0] for end in ends]
    tied = {body for body in bodies if n_ends[body] > 1 and names.bodies[body].radius is None}
    told = [end if body in tied else body for end, body in zip(ends, bodies, strict=True)]
    return [*zip(told[::2], told[1::2], strict=True)]


def _last(places: tuple[str, ...]) -> str:
    """The last place, as its point where a body is there by one of its own."""
    return places[-2] if places[-2].startswith(f"{places[-1]}.") else places[-1]


def _is_along(names: Names, measure: Displacement, *, level: bool) -> bool:
    """Whether what is measured is so along a level line of the ground, or along one straight up."""
    across = names.numeric(measure.along.components[1 if level else 0])
    return (
        measure.along.body == GROUND
        and len(measure.along.components) == 2
        and across is not None
        and abs(across) <= _LEVEL
    )


def greatest_torques(names: Names, belts: list[str], of: list[str]) -> list[str]:
    """The greatest torque that a belt can transmit, on each of its pulleys, or on that which is named."""
    named = [name for name in of if name not in belts]
    belts = [belt for belt in belts if belt in of or (not set(of) & {*belts} and named)]
    found: list[str] = []
    for belt in belts:
        pulleys = [body for body in joined_by(names, belt) if names.bodies[body].radius is not None]
        pulleys = [body for body in pulleys if body in named] if named else pulleys
        if not set(named) <= {*pulleys}:
            return []
        sizes = dict.fromkeys(to_python(names.bodies[body].radius or ZERO).replace("**", "^") for body in pulleys)
        found += [
            f"greatest belt force of {belt} * ({size})"
            if not size.isidentifier()
            else f"greatest belt force of {belt} * {size}"
            for size in sizes
        ]
    return found


def running_over(names: Names, words: list[Word]) -> list[Word]:
    """The words without what only says where a string runs, the one that passes over the pulley: that is no instant at
    which it gets there. Nothing where it runs elsewhere."""
    that, passes = Word("pronoun", "that"), Word("verb", "reach")
    for k in range(1, len(words) - 2):
        string = words[k - 1]
        if words[k : k + 2] != [that, passes] or string.kind != "name" or string.what not in names.connections:
            continue
        behind = (j for j in range(k + 2, len(words)) if words[j].kind not in ("preposition", "filler"))
        j = next(behind, k)
        if words[j].kind == "name" and words[j].what in names.bodies:
            return [*words[:k], *words[j + 1 :]] if touches(names, string.what, words[j].what) else []
    return words
