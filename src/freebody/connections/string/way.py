"""The way of a string as people write it: ends, pulleys and drums, and what is known of where they stand."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Protocol

from freebody.connections.standing import (
    begins_at,
    carriage_line,
    ground_guide_of,
    ground_line_under,
    is_parallel,
    is_zero,
)
from freebody.connections.standing_in_space import axes_at_start
from freebody.connections.string.node import StringNode
from freebody.language.expression import Call, Expr, add, multiply, negate
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import GROUND, ZERO, Direction, Point
from freebody.model.elements import NonholonomicForm, RigidBody
from freebody.model.rotations import applied
from freebody.tolerances import ROUND_OFF

if TYPE_CHECKING:
    from freebody.model.names import Names

_NODE = re.compile(
    r"(?:(?P<way>over|under|around) )?(?P<wound>wound on )?(?P<what>[A-Za-z_]\w*(?:\.\w+)?)"
    r"(?: radius (?P<radius>.+?))?"
    r"(?: at (?P<side>left|right|top|bottom))?(?: (?P<turn>clockwise|counterclockwise))?"
)


class GivenWay(Protocol):
    """The fields in which people write a way."""

    @property
    def start(self) -> str | None: ...
    @property
    def to(self) -> str | None: ...
    @property
    def over(self) -> list[str]: ...
    @property
    def under(self) -> list[str]: ...
    @property
    def path(self) -> list[str]: ...


def places_given(of: GivenWay) -> list[tuple[str, tuple[str | int, ...]]]:
    """The places on a way, and where in the model each is written."""
    if of.path:
        return [(text, ("path", k)) for k, text in enumerate(of.path)]
    start = [(t, (key,)) for t, key in ((of.start, "from"), (of.to, "to")) if t is not None]
    middle = [(f"over {p}", ("over",)) for p in of.over] + [(f"under {p}", ("over",)) for p in of.under]
    return [*start[:1], *middle, *start[1:]]


def is_way_given(names: Names, of: GivenWay) -> bool:
    """Whether the fields tell one way from one end to the other; else a problem is noted."""
    if of.path and (of.start or of.to or of.over or of.under):
        names.problem(Message("give the way either as path, or as from, over, under, to"))
        return False
    if of.over and of.under:
        met = ", ".join(text for text, _field in places_given(of))
        told = Message(
            "over and under together leave open what the string meets first: give its places in their order, "
            "path: [{met}]",
            met=met,
        )
        names.problem(told, "under")
        return False
    if len(places_given(of)) < 2 or not (of.path or (of.start and of.to)):
        names.problem(Message("a string needs two ends: from and to"))
        return False
    return not any([*_ends_within_its_wheel(names, places_given(of))])


def _ends_within_its_wheel(
    names: Names, places: Sequence[tuple[str, tuple[str | int, ...]]]
) -> Iterator[tuple[str | int, ...]]:
    """Where an end is tied to the middle of the wheel over which the string comes; a problem is noted."""
    if len({place_named(text) for text, _field in places}) == 1:
        return  # nothing but that wheel, of a model that is not meant
    for (end, field), (beside, _field) in ((places[0], places[1]), (places[-1], places[-2])):
        wheel, found = place_named(beside), _NODE.fullmatch(" ".join(beside.split()))
        is_tied = end.strip() in (wheel, f"{wheel}.center") and found is not None and found["way"]
        if len(places) > 2 and is_tied and wheel in names.bodies:
            told = Message(
                "the string runs over the rim of {wheel} and ends in its middle; what is fastened to a drum is wound "
                "on it: {field}: wound on {wheel}, with nothing over it",
                wheel=wheel,
                field=str(field[0]),
            )
            names.problem(told, *field)
            yield field


def place_named(text: str) -> str:
    """The body or point that a place on a way names."""
    found = _NODE.fullmatch(" ".join(text.split()))
    return text if found is None else found["what"]


def is_round(names: Names, text: str) -> bool:
    """Whether a string that is given this place on its way runs round it: a drum, or a wheel by its name."""
    found = _NODE.fullmatch(" ".join(text.split()))
    if found is None or found["wound"]:
        return found is not None
    return bool(found["way"]) and (found["radius"] is not None or _has_circle(names, found["what"]))


def _has_circle(names: Names, text: str) -> bool:
    """Whether it names a wheel, or a round part of one about its middle."""
    name, _, part = text.partition(".")
    body = names.bodies.get(name)
    return body is not None and (part in body.middle_circles if part else body.is_wheel)


def runs_round(of: GivenWay) -> set[str]:
    """The bodies round which a way is written to run."""
    found = (_NODE.fullmatch(" ".join(text.split())) for text, _field in places_given(of))
    return {match["what"] for match in found if match and (match["wound"] or match["way"])}


def is_tied_to(of: GivenWay) -> list[tuple[str, tuple[str | int, ...]]]:
    """What its ends name and is not wound on, and where in the model each is written."""
    places = places_given(of)
    ends = [(text.strip(), field) for text, field in (*places[:1], *places[1:][-1:])]
    return [(text, field) for text, field in ends if text not in runs_round(of)]


def named_on(texts: Iterable[str]) -> set[str]:
    """The bodies that a way names."""
    found = (_NODE.fullmatch(" ".join(text.split())) for text in texts)
    return {match["what"].partition(".")[0] for match in found if match}


def read_way(
    names: Names, texts: Sequence[str], fields: Sequence[tuple[str | int, ...]], *, swings: bool
) -> list[StringNode] | None:
    """The places on a way, in its order; None with problems noted. fields: where in the model each is written. swings:
    bodies that nothing else holds are not taken to hang straight down."""
    last = len(texts) - 1
    nodes = [
        _read_node(names, text, field, is_end=k in (0, last), swings=swings)
        for k, (text, field) in enumerate(zip(texts, fields, strict=True))
    ]
    way = [node for node in nodes if node is not None]
    return way if len(way) == len(nodes) else None


def unwinds_from(names: Names, text: str, field: str) -> StringNode | None:
    """The drum from which a cord is pulled, at its outer end, in a given direction; None with problems noted."""
    return _read_node(names, text, (field,), is_end=True, swings=True)


def _read_node(
    names: Names, text: str, field: tuple[str | int, ...], *, is_end: bool, swings: bool
) -> StringNode | None:
    found = _NODE.fullmatch(" ".join(text.split()))
    if found is None:
        names.problem(
            Message(
                "'{text}' is no place on a string; write a point, 'over pulley', 'under pulley' or 'wound on "
                "drum at right'",
                text=text,
            ),
            *field,
        )
        return None
    # a wheel by its name and a way over it, a point by its own
    if found["wound"] or (found["way"] and ("." not in found["what"] or _has_circle(names, found["what"]))):
        place = _round(names, found, field)
    else:
        place = _point(names, found["what"], field, is_end=is_end)
    if place is None:
        return None
    body, point, radius = place
    way = "drum" if found["wound"] else "end" if is_end else (found["way"] or "over")
    if not is_end and found["wound"]:
        names.problem(Message("only an end can be wound on a drum, '{text}' is in the middle", text=text), *field)
    # what nothing else holds hangs; what a guide leads is led by it
    is_given = body.start.at is not None
    is_free = not (is_held(names, body.name) or body.fixed or swings or body.name == GROUND)
    is_free = is_free and hangs_straight(names, body, point) and not _is_pushed_aside(names, body.name)
    guide = ground_guide_of(names, body.name, turning=False)
    carried = None if names.space or radius == ZERO else carriage_line(names, point)
    line = guide or carried or ground_line_under(names, body.name)
    is_started = line is not None and begins_at(names, point, line) is not None
    may_lie = is_given or (guide is None and (found["wound"] is not None or carried is not None or is_started))
    return StringNode(
        point,
        radius,
        way,
        found["side"],
        found["turn"],
        hangs=is_free and not is_given,
        is_put=is_free and is_given and body.start.velocity is None,
        guide=None if is_given else guide,
        track=line if may_lie else None,
        place=_place(names, point),
    )


def _round(names: Names, found: re.Match[str], field: tuple[str | int, ...]) -> tuple[RigidBody, Point, Expr] | None:
    """A wheel that the string runs round, its centre and its radius; None with a problem noted."""
    n_before = len(names.problems)
    whole, _, part = found["what"].partition(".")
    known = names.bodies.get(whole)
    circles = {} if known is None or whole == GROUND else known.middle_circles
    if part and known is not None and whole != GROUND and part not in circles:
        told = Message(
            "a string runs round a body, not round a part of it: in place of {what} write {body}, and for another "
            "circle than its rim its radius, as in '{body} radius r'",
            what=found["what"],
            body=whole,
        )
        names.unknown(found["what"], told, *field)
        return None
    body = names.body(whole if part in circles else found["what"], *field)
    if len(names.problems) > n_before:
        return None
    given = found["radius"]
    own = circles[part] if part else names.radius(body.name, *field) if not given else None
    radius = names.formula(given, LENGTH, *field) if given else own
    return None if len(names.problems) > n_before or radius is None else (body, body.center, radius)


def _point(
    names: Names, what: str, field: tuple[str | int, ...], *, is_end: bool
) -> tuple[RigidBody, Point, Expr] | None:
    """A point that the string is tied to or runs through; None with a problem noted."""
    point = names.point(what, *field)
    body = names.known(point.body)
    if not is_end and body.name == what and body.is_wheel and not body.is_placeholder:
        names.problem(
            Message(
                "{wheel} is round, and the string could run over it or through its centre: write "
                "'over {wheel}', 'under {wheel}' or {wheel}.center",
                wheel=what,
            ),
            *field,
        )
        return None
    return body, point, ZERO


def is_held(names: Names, body: str) -> bool:
    """Whether anything but strings, and a floor on which it may land, holds a body, or one that it is welded to: what
    is welded to it, or a particle in its middle, and free otherwise hangs on the string with it."""
    unit = _one_with(names, body)
    for other in names.connections.values():
        if other.is_floor_below(names, body):
            continue
        mentioned = set[str]() if other.keeps_as_one(names) or other.keeps_flat(names) else other.mentions(names)
        if mentioned & (unit - {body} if other.lets_hang else unit):
            return True
    others = [names.known(name) for name in sorted(unit - {body})]
    return any(b.fixed or b.name == GROUND or b.start.at is not None for b in others)


def _one_with(names: Names, body: str) -> set[str]:
    """A body and all that is welded to it."""
    unit, joints = {body}, [c.mentions(names) for c in names.connections.values() if c.keeps_as_one(names)]
    while any(joined & unit and joined - unit for joined in joints):
        unit = unit.union(*(joined for joined in joints if joined & unit))
    return unit


def _is_pushed_aside(names: Names, body: str) -> bool:
    """Whether a load pushes a body, or one that it is welded to, in a direction which is not straight up or down. No
    string holds it against that, so it swings."""
    unit = _one_with(names, body)
    return any(set(load.measure.bodies()) & unit and _is_askew(names, load.measure) for load in names.applied_loads)


def _is_askew(names: Names, pushed: Measure | NonholonomicForm) -> bool:
    """Whether the force of a load has a part along the level: by its direction, or in the plane by where the ends of
    its line are put."""
    if isinstance(pushed, Displacement):
        return not is_parallel(names, _as_on_ground(names, pushed.along), Direction(GROUND, names.up, "up"))
    if not isinstance(pushed, Distance) or names.space:
        return False
    start, end = _place(names, pushed.start), _place(names, pushed.end)
    if start is None or end is None:
        return False
    return abs(end[0] - start[0]) > ROUND_OFF * math.dist(start, end)


def _as_on_ground(names: Names, along: Direction) -> Direction:
    """A direction of a fixed body in space as one of the ground."""
    body = names.known(along.body)
    if not names.space or not body.fixed or along.body == GROUND:
        return along
    return Direction(GROUND, applied(axes_at_start(body), along.components), along.name)


def hangs_straight(names: Names, body: RigidBody, point: Point) -> bool:
    """Whether a point by which a body hangs goes straight up and down, from rest, without a force that keeps it from
    going aside: the body does not turn, or its mass centre is at the point, above it or below it, or beside it at the
    same height where it hangs on several strings. In any other pose the point goes aside when the body begins to turn,
    and no string keeps it."""
    if not body.turns:
        return True
    if names.space:
        aside = [c for c, up in zip(point.offset, names.up, strict=False) if up == ZERO]
        turned = body.start.turned or ()
        return all(is_zero(names, c) for c in (point.offset if turned else aside))
    x, y = point.offset
    cos, sin = (Call(name, body.start.angle or ZERO) for name in ("cos", "sin"))
    if is_zero(names, add(multiply(cos, x), negate(multiply(sin, y)))):
        return True
    strings = [c for c in names.connections.values() if c.lets_hang and body.name in c.mentions(names)]
    return len(strings) > 1 and is_zero(names, add(multiply(sin, x), multiply(cos, y)))


def _place(names: Names, point: Point) -> tuple[float, float] | None:
    """Where a point P is at the start, if the model says so: r_A + R(angle) (P - A), A the point that `at` names."""
    body, start = names.known(point.body), names.known(point.body).start
    if body.name == GROUND:
        return _in_numbers(names, point.offset)
    if start.at is None:
        return None
    named, place = start.at
    if body.points[named] == point.offset:
        return _in_numbers(names, place)
    base, own, here = (_in_numbers(names, v) for v in (place, body.points[named], point.offset))
    angle = 0.0 if start.angle is None else names.numeric(start.angle)
    if start.turned or base is None or own is None or here is None or angle is None:
        return None
    x, y = here[0] - own[0], here[1] - own[1]
    return base[0] + x * math.cos(angle) - y * math.sin(angle), base[1] + x * math.sin(angle) + y * math.cos(angle)


def _in_numbers(names: Names, components: Sequence[Expr]) -> tuple[float, float] | None:
    x, y = (names.numeric(c) for c in components[:2])
    return None if x is None or y is None else (x, y)
