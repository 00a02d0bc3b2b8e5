"""Metamorphic relations: changes of a model that must not change what is true of it.

No answer needs to be known: the model and the changed model are both asked, and must agree. Each relation is a function
from a model to changed models, each with the way its answers are read back (`Reading`). A relation that says nothing of
a model (no planar model, a crowd of contacts) returns none.

Source: Chen, Cheung and Yiu 1998, "Metamorphic testing"; that answers scale by their dimensions is Buckingham's
Pi theorem.
"""

from __future__ import annotations

import copy
import random
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, cast

from freebody.api import System
from freebody.errors import FreebodyError
from freebody.language.units import DIMENSIONLESS, Dimension
from freebody.model.shapes.base import Shape
from freebody.questions.reading import Question
from freebody.questions.reserved import reserved_words
from freebody.testing import documents
from freebody.testing.documents import Data, section
from freebody.testing.observing import Observed, Reading, differences, observed
from freebody.testing.turning import mirror_image, quarter_turn

SHORT = 0.05  # s, of a motion that is compared
_STRANGER = "zz_far"  # a name that no model has


@dataclass(frozen=True)
class Changed:
    """A changed model, and how its answers are read."""

    data: Data
    reading: Reading


Change = Callable[[System, random.Random], Sequence[Changed]]


@dataclass(frozen=True)
class Relation:
    """A change that must not change what is true."""

    name: str
    about: str
    change: Change


@dataclass(frozen=True)
class RelationVerdict:
    """What came of one relation on one model. `differences` is empty where it holds; `applies` is False where the
    relation says nothing of the model."""

    relation: str
    applies: bool
    differences: tuple[str, ...] = ()

    @property
    def holds(self) -> bool:
        return not self.differences

    @property
    def word(self) -> str:
        return "not applicable" if not self.applies else "pass" if self.holds else "FAIL"


RELATIONS: dict[str, Relation] = {}


def _relation(name: str) -> Callable[[Change], Change]:
    def register(change: Change) -> Change:
        RELATIONS[name] = Relation(name, (change.__doc__ or "").strip(), change)
        return change

    return register


def check(relation: Relation, system: System, *, seed: int = 0, before: Observed | None = None) -> RelationVerdict:
    """Asks the model and the changed models. before: what the model answers, where that is known already."""
    rng = random.Random(f"{relation.name} {seed}")
    changes = [c for c in relation.change(system, rng) if _is_readable(c.data)]
    if not changes:
        return RelationVerdict(relation.name, False)
    before = observed(system, until=SHORT) if before is None else before
    found: list[str] = []
    for changed in changes:
        until = SHORT * changed.reading.time if before.numbers else None
        after = observed(System.from_data(changed.data), until=until, studies=before.facts)
        found += differences(before, after, changed.reading)
    return RelationVerdict(relation.name, True, tuple(found))


def _is_readable(data: Data) -> bool:
    """A change may leave what the format can say (a name that is taken, a massless body at rest)."""
    try:
        System.from_data(data)
    except FreebodyError:
        return False
    return True


# -- names and order --------------------------------------------------------------------------
@_relation("rename")
def renamed(system: System, rng: random.Random) -> list[Changed]:
    """Bodies, connections, loads, measures and parameters have other names, in another alphabetical order."""
    data = documents.prepared(system)
    if documents.has_options(data):
        for question in data["questions"]:
            question.pop("options", None)
            question.pop("key", None)
    # a belt that is called belt transmits a belt force, whatever its name
    reactions = {word for row in system.rows for word in row.reaction.split()}
    taken = reserved_words() | reactions
    names = [n for part in documents.NAMED for n in section(data, part) if n.lower() not in taken]
    letters = rng.sample("abcdefhklnquvw", 14)
    new = {n: f"{letters[k % 14]}qx{k}" for k, n in enumerate(dict.fromkeys(names))}
    back = {v: k for k, v in new.items()}

    def read(text: str) -> str:
        return re.sub(r"[a-z]qx\d+", lambda w: back.get(w[0], w[0]), text)

    return [Changed(documents.renamed(data, new), Reading(read, same_coordinates=False))] if new else []


@_relation("order")
def permuted(system: System, rng: random.Random) -> list[Changed]:
    """Bodies, connections, loads, measures and questions stand in another order: the same text is printed."""
    data = documents.prepared(system)
    changed = documents.shuffled(data, rng)
    return [] if repr(changed) == repr(data) else [Changed(changed, Reading(same_text=True))]


@_relation("alone")
def alone(system: System, rng: random.Random) -> list[Changed]:
    """Each question is the only one."""
    data = documents.prepared(system)
    questions = data.get("questions", [])
    if len(questions) < 2:
        return []
    return [Changed({**data, "questions": [question]}, Reading(same_text=True)) for question in questions]


# -- units and sizes --------------------------------------------------------------------------
def _sized(system: System, size: Callable[[Dimension], Fraction], units: tuple[str, str, str]) -> Data | None:
    data = documents.prepared(system)
    for name, entry in section(data, "parameters").items():
        if "function" in _entry(entry):
            return None
        if _entry(entry).get("value") is not None and entry.get("unit"):
            rest = {k: v for k, v in cast("Data", entry).items() if k != "unit"}
            data["parameters"][name] = rest | {"value": f"{entry['value']} {entry['unit']}"}
    return documents.rescaled(data, size, units)


@_relation("units")
def in_other_units(system: System, rng: random.Random) -> list[Changed]:
    """Lengths in mm, masses in g, times in ms, angles in radians."""

    def size(d: Dimension) -> Fraction:
        return Fraction(1000) ** int(d.mass + d.length + d.time)

    data = _sized(system, size, ("g", "mm", "ms"))
    if data is None or repr(data) == repr(documents.prepared(system)):
        return []
    return [Changed(data, Reading())]


def _scaled(system: System, mass: int = 1, length: int = 1, time: int = 1) -> list[Changed]:
    """All masses, lengths and times so many times as large: answers follow by their dimensions."""
    if not _says_all_units(documents.prepared(system)):
        return []

    def size(d: Dimension) -> Fraction:
        return Fraction(mass) ** int(d.mass) * Fraction(length) ** int(d.length) * Fraction(time) ** int(d.time)

    data = _sized(system, size, ("kg", "m", "s"))
    if data is None or repr(data) == repr(documents.prepared(system)):
        return []
    scaled = Reading(scale=lambda d: float(size(d)), formulas=False, time=float(time))
    return [Changed(data, scaled)]


@_relation("lengths")
def with_lengths(system: System, rng: random.Random) -> list[Changed]:
    """All lengths twice as large: answers follow by their dimensions."""
    return _scaled(system, length=2)


@_relation("masses")
def with_masses(system: System, rng: random.Random) -> list[Changed]:
    """All masses five times as large."""
    return _scaled(system, mass=5)


@_relation("times")
def with_times(system: System, rng: random.Random) -> list[Changed]:
    """All times four times as long."""
    return _scaled(system, time=4)


def _entry(value: Any) -> Data:
    """A parameter's entry where it has one."""
    return cast("Data", value) if isinstance(value, dict) else {}


def _says_all_units(data: Data) -> bool:
    """True if no number other than zero stands in the model without a unit, outside of formulas with parameters."""
    bare: list[Any] = []

    def scalar(path: documents.Path, value: Any) -> Any:
        if isinstance(value, bool) or path[0] in ("freebody", "measures", "questions"):
            return value
        if isinstance(value, (int, float)) and value != 0:
            bare.append(value)
        if isinstance(value, str) and re.fullmatch(r"\s*[-+]?[\d.]+(e[-+]?\d+)?\s*", value) and float(value) != 0:
            bare.append(value)
        return value

    documents.mapped(data, scalar)
    in_texts = repr(data.get("measures", "")) + repr(data.get("questions", ""))
    return not bare and not re.search(r"[=+\-]\s*[\d.]*[1-9]", in_texts)


# -- strangers --------------------------------------------------------------------------------
def of_the_whole(question: Question) -> bool:
    """True for what is asked of all bodies together."""
    q = question.quantity
    return any(part.is_of_whole or part.is_of_coordinates or part.scope == "small motion" for part in (q, *q.inner))


@_relation("unrelated measure")
def with_measure(system: System, rng: random.Random) -> list[Changed]:
    """One more measure is named: a distance of a body, which nothing uses."""
    data = documents.prepared(system)
    bodies = [b.name for b in system.moving]
    text = f"distance from ground.origin to {rng.choice(bodies)}" if bodies else "x of ground.origin"
    data["measures"] = {**section(data, "measures"), _STRANGER: text}
    return [Changed(data, Reading(same_coordinates=False))]


@_relation("unrelated body")
def with_body(system: System, rng: random.Random) -> list[Changed]:
    """One more body slides far away, touched by nothing."""
    data = documents.prepared(system)
    if _touches_all(data):
        return []
    if system.space:
        data["bodies"][_STRANGER] = {"box": {"mass": "3 kg", "size": ["1 m", "1 m", "1 m"]}}
        guide: Data = {"prismatic": {"first": f"ground.{_STRANGER}", "second": _STRANGER, "along": "x"}}
    else:
        data["bodies"][_STRANGER] = {"particle": {"mass": "3 kg"}, "at": ["100 m", "70 m"]}
        guide = {"slider": {"body": _STRANGER, "along": "right", "through": f"ground.{_STRANGER}"}}
    _add_ground_point(data, _STRANGER, ["100 m", "70 m"] + (["30 m"] if system.space else []))
    data["connections"] = {**section(data, "connections"), _STRANGER: guide}
    apart = Reading(concerns=lambda q: not of_the_whole(q), freedoms=1, same_coordinates=False)
    return [Changed(data, apart)]


def _touches_all(data: Data) -> bool:
    return any("among" in repr(entry) for entry in section(data, "connections").values())


def _add_ground_point(data: Data, name: str, place: list[str]) -> None:
    """Declares a point; those that were not declared are declared at the origin, where they are."""
    ground = data["ground"] = dict(section(data, "ground"))
    points = ground.get("points")
    if points is None or isinstance(points, dict):
        used = {w for w in re.findall(r"ground\.([A-Za-z_]\w*)", repr(data)) if w != name}
        lines = {*section(ground, "lines"), *section(ground, "planes"), "origin", "x", "y", "z"}
        declared = dict(cast("Data", points or {}))
        open_points = used - set(declared) - lines
        declared |= {w: [0] * len(place) for w in sorted(open_points)}
        ground["points"] = declared | {name: place}


@_relation("massless frame")
def with_frame(system: System, rng: random.Random) -> list[Changed]:
    """A body without mass is welded to a body."""
    data = documents.prepared(system)
    turning = [b for b in system.moving if b.turns]
    if _touches_all(data) or not turning:
        return []
    body = rng.choice(turning)
    data["bodies"][_STRANGER] = {"body": {}}
    weld = {"weld": [body.name, f"{_STRANGER}.origin"]}
    data["connections"] = {**section(data, "connections"), _STRANGER: weld}
    return [
        Changed(
            data,
            Reading(concerns=lambda q: not of_the_whole(q) or q.quantity.scope == "structure", same_coordinates=False),
        )
    ]


@_relation("two halves")
def in_halves(system: System, rng: random.Random) -> list[Changed]:
    """One body is two of half its mass, in the same place, welded together."""
    data = documents.prepared(system)
    asked = repr(data.get("questions", "")) + repr(data.get("loads", ""))
    able = [
        b.name
        for b in system.moving
        if b.turns
        and not re.search(rf"(energy|momentum|turn|spin|mass|inertia|gyration)[^'\"]* of [^'\"]*\b{b.name}\b", asked)
    ]
    if _touches_all(data) or not able:
        return []
    name = rng.choice(able)
    entry = cast("Data", data["bodies"][name])
    kind = next(k for k in entry if k in Shape.kinds)
    fields = Shape.kinds[kind].from_plain(entry[kind])
    if kind == "composite" or isinstance(fields.get("inertia"), list) or "mass" not in fields:
        return []
    half = dict(fields)
    for key in ("mass", "inertia"):
        if key in half and half[key] not in (0, "0", None):
            value = _halved(half[key])
            if value is None:
                return []
            half[key] = value
    begins = {k: v for k, v in entry.items() if k in ("angle", "at", "near", "velocity", "angular_velocity")}
    data["bodies"] = dict(data["bodies"]) | {
        name: entry | {kind: half},
        _STRANGER: {kind: copy.deepcopy(half)} | begins,
    }
    point = system.bodies[name].default_point
    data["connections"] = {
        **section(data, "connections"),
        _STRANGER: {"weld": [f"{name}.{point}", f"{_STRANGER}.{point}"]},
    }
    return [Changed(data, Reading(concerns=lambda q: q.quantity.scope != "rest", same_coordinates=False))]


def _halved(value: Any) -> str | float | None:
    """Half of a quantity or of a formula."""
    if isinstance(value, (int, float)):
        return value / 2
    text = str(value)
    if not documents.is_quantity(text):
        return f"({text})/2"
    number = re.match(r"\s*[-+]?[\d.]+(?:[eE][-+]?\d+)?", text)
    if number is None:
        return None
    half = documents.decimal(Fraction(number[0].strip()) / 2)
    return None if half is None else half + text[number.end() :]


# -- turning ----------------------------------------------------------------------------------
@_relation("quarter turn")
def turned(system: System, rng: random.Random) -> list[Changed]:
    """The whole planar model, gravity too, is turned by a quarter counter-clockwise."""
    if system.space:
        return []
    data = quarter_turn(documents.prepared(system), system)
    return [] if data is None else [Changed(data, Reading(turned=True, same_coordinates=False))]


@_relation("mirror")
def mirrored(system: System, rng: random.Random) -> list[Changed]:
    """The whole planar model, gravity too, is seen in a level mirror."""
    if system.space:
        return []
    data = mirror_image(documents.prepared(system), system)
    return [] if data is None else [Changed(data, Reading(mirrored=True, same_coordinates=False))]


__all__ = ["DIMENSIONLESS", "RELATIONS", "Changed", "Relation", "RelationVerdict", "check"]
