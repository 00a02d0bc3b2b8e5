"""How a string lies over the wheels of its way: where its leads run, and in which sense it goes round each wheel."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from freebody.connections.standing import (
    apart_at_start,
    ground_line_under,
    is_parallel,
    number_of,
    place_of,
    stands_at,
    starts_at,
    vanishes,
)
from freebody.connections.string.hanging import Hook, hooks_of
from freebody.connections.string.node import StringNode, aside
from freebody.language.expression import (
    FLOAT_FUNCTIONS,
    Expr,
    add,
    evaluate,
    free_symbols,
    multiply,
    negate,
    number,
)
from freebody.language.sentences import Message
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import DOWN, GROUND, RIGHT, UP, ZERO, Direction, Point
from freebody.model.spec import Heading
from freebody.tolerances import ROUND_OFF, ROUNDED

if TYPE_CHECKING:
    from freebody.model.names import Names

_SHARES = (0.04, 0.3, 0.7, 0.96)  # of the range of a parameter
_SIDES = {"left": (-1.0, 0.0), "right": (1.0, 0.0), "top": (0.0, 1.0), "bottom": (0.0, -1.0)}


@dataclass(frozen=True)
class StringRun:
    """A string on its way: a place more than leads."""

    way: list[StringNode]
    leads: list[Direction | None]  # constant directions; None along the common tangent
    turns: list[int]  # +1 where it runs counter-clockwise round the place, -1 clockwise, 0 at a point
    arms: list[Expr]  # at which it pulls on the circles: s R

    def held_turn(self, k: int) -> tuple[tuple[Expr, Measure], ...]:
        """- rho a of a lead that keeps its direction on a body that turns; what is zero: see `swivel`."""
        along, rho = self.leads[k], self.aside(k)
        if along is None or along.body == GROUND or rho == ZERO:
            return ()
        return ((negate(rho), Angle(along.body)),)

    def aside(self, k: int) -> Expr:
        """rho of lead k."""
        return aside(self.way, self.arms, k)

    @property
    def hooks(self) -> dict[str, Hook]:
        """The bodies that its leads place."""
        return hooks_of(self.way, self.leads, self.arms)


@dataclass(frozen=True)
class StringLead:
    """A lead as what it carries sees it. place, called: its other end, and the names of that; length: from one to the
    other, None where it changes its direction; across, arm: how far what it carries is aside of the other end, and
    has to be."""

    body: str
    place: str
    called: tuple[str, ...]
    length: Displacement | None
    across: Displacement | None
    arm: Expr


def leads_of(run: StringRun) -> Iterator[StringLead]:
    """The leads from what a string carries at one of its places to the next place on its way."""
    for k, along in enumerate(run.leads):
        a, b = run.way[k], run.way[k + 1]
        length = None if along is None else Displacement(b.point, a.point, along)
        across = None if along is None else Displacement(b.point, a.point, along.normal())
        arm = run.aside(k)
        for own, other in ((a, b), (b, a)):
            if own.body != GROUND and own.way in ("end", "under") and own.body != other.body:
                place = other.called[0] if other.body == GROUND else other.body
                ground = (place.partition(".")[2],) if other.body == GROUND else ()
                yield StringLead(own.body, place, (*other.called, *ground), length, across, arm)


def run_over(names: Names, way: list[StringNode], given: list[Heading] | None) -> StringRun:
    """How a string lies. Bodies that the model puts where they would hang do so, and a lead runs along the guide of a
    body that is put where it does. given: the directions of the leads, if the model states them."""
    for k, node in enumerate(way):
        hung = [*way[:k], replace(node, hangs=True), *way[k + 1 :]]
        if node.is_put and _is_straight_below(names, _run(names, hung, given), k):
            way = hung
        led = [*way[:k], replace(way[k], guide=node.track), *way[k + 1 :]]
        if node.track is not None and _runs_along(names, _run(names, led, given), k):
            way = led
    return _run(names, way, given)


def _run(names: Names, way: list[StringNode], given: list[Heading] | None) -> StringRun:
    leads = _leads(names, way) if given is None else _stated(names, given, len(way) - 1)
    turns = [_turn(names, way, leads, k) for k in range(len(way))]
    arms = [multiply(number(s), n.radius) if s else ZERO for s, n in zip(turns, way, strict=True)]
    return StringRun(way, leads, turns, arms)


def _runs_along(names: Names, run: StringRun, k: int) -> bool:
    """Whether the leads to a guided body run along its guide from what they lead to, however long the parameters are.
    Where the body gets there the distance from a point has no slope, and the way along the guide has one."""
    way, arms = run.way, run.arms
    for j in (j for j in (k - 1, k) if 0 <= j < len(run.leads)):
        if way[j].hangs or way[j + 1].hangs:
            continue  # it runs up or down
        lead, first, second = run.leads[j], way[j].point, way[j + 1].point
        if lead is None or lead.body != GROUND:
            return False
        across = [_across(names, point, lead.normal()) for point in (first, second)]
        ends = [where_at_start(names, node) for node in way[j : j + 2]]
        if across[0] is None or across[1] is None or ends[0] is None or ends[1] is None:
            return False
        if not vanishes(names, add(across[1], negate(across[0]), arms[j], negate(arms[j + 1]))):
            return False
        ex, ey = _in_numbers(names, lead)
        if (ends[1][0] - ends[0][0]) * ex + (ends[1][1] - ends[0][1]) * ey <= 0.0:
            return False
    return True


def _across(names: Names, point: Point, normal: Direction) -> Expr | None:
    """How far aside a point stands: where it is kept, or on a line of the ground where it is put."""
    kept = stands_at(names, point, normal)
    on_line = kept is None and ground_line_under(names, point.body) is not None
    return starts_at(names, point, normal) if on_line else kept


def _is_straight_below(names: Names, run: StringRun, k: int) -> bool:
    """Whether a body is put where it would hang, below what carries it."""
    hook, here = run.hooks[run.way[k].body], run.way[k].place
    if here is None:
        return False
    for lead in hook.leads:
        aside, level = lead.place(names, RIGHT, frozenset()), stands_at(names, lead.other, UP)
        if aside is None or abs(number_of(names, aside) - here[0]) > ROUND_OFF:
            return False
        if level is None or number_of(names, level) <= here[1]:
            return False
    return True


def check_ends(names: Names, run: StringRun) -> None:
    """A lead along the common tangent of two circles needs them apart at the start."""
    for k, ((first, second), lead) in enumerate(zip(itertools.pairwise(run.way), run.leads, strict=True)):
        places = [place_of(names, node.point) for node in (first, second)]
        if lead is not None or places[0] is None or places[1] is None or first.body == second.body:
            continue
        apart = math.dist(places[0], places[1])
        arm = abs(number_of(names, run.aside(k)))
        if apart <= arm + ROUND_OFF:
            wanted = Message("more than {arm:.6g} m apart", arm=arm) if arm else Message("apart")
            names.problem(
                Message(
                    "at the start {first} and {second} are {apart:.6g} m from each other, where the string between "
                    "them has no direction: put them {wanted} (at)",
                    first=first.point,
                    second=second.point,
                    apart=apart,
                    wanted=wanted,
                )
            )
            return


def is_sure(names: Names, run: StringRun, field: str) -> bool:
    """Whether it is told how the string goes round its drums and the wheels that it carries; else a problem is noted.
    field: of the model, where wheels are written."""
    if (drum := loose_drum(names, run)) is not None:
        names.problem(_either_hand(drum), "path")
        return False
    if (missed := unwrapped(names, run)) is not None:
        names.problem(_not_round(missed), field)
        return False
    return True


def _either_hand(drum: StringNode) -> Message:
    """What is told of a drum whose side leaves open how the string goes round it."""
    return Message(
        "at the {side} of {drum} the string comes off to either hand: write 'wound on {drum} clockwise' or "
        "'counterclockwise', the sense in which it goes round it",
        side=drum.side or "right",
        drum=drum.body,
    )


def _not_round(wheel: StringNode) -> Message:
    """What is told of a wheel that hangs on a string which would pass it."""
    if wheel.way == "under":
        return Message(
            "both leads of the string run up on the same side of {wheel}, so it would not go round it: between wheels "
            "that hang it runs over something above them, path: [..., over pulley, under {wheel}, ...]",
            wheel=wheel.body,
        )
    return Message(
        "both leads of the string run to the same side of {wheel}, so it would not go round it: a string that carries "
        "a wheel from below runs under it, path: [..., under {wheel}, ...]",
        wheel=wheel.body,
    )


def unwrapped(names: Names, run: StringRun) -> StringNode | None:
    """A wheel that hangs on the string or is led along it, although the string passes it straight on."""
    for node, before, after in zip(run.way[1:-1], run.leads, run.leads[1:], strict=False):
        is_carried = node.hangs or node.guide is not None
        if node.radius == ZERO or not is_carried or before is None or after is None:
            continue
        (ax, ay), (bx, by) = _in_numbers(names, before), _in_numbers(names, after)
        if abs(ax * by - ay * bx) <= ROUND_OFF and ax * bx + ay * by > 0.0:
            return node
    return None


# -- where the leads run ----------------------------------------------------------------------
def _stated(names: Names, given: list[Heading], n: int) -> list[Direction | None]:
    """The directions of the leads that the model states."""
    if len(given) != n:
        told = Message("there are {n} leads, {given} directions are given", n=n, given=len(given))
        names.problem(told, "leads")
        return [None] * n
    return [names.direction(d, "leads", k) for k, d in enumerate(given)]


def _leads(names: Names, way: Sequence[StringNode]) -> list[Direction | None]:
    """The constant direction of each lead, or None where it is the common tangent."""
    found: list[Direction | None] = []
    for a, b in itertools.pairwise(way):
        along = a.guide or b.guide
        if a.hangs or b.hangs:
            found.append(_of_hanging(a, b))
        elif along is None or (a.guide and b.guide and not is_parallel(names, a.guide, b.guide)):
            found.append(None)
        elif abs(_in_numbers(names, along)[1]) > ROUNDED and any(n.guide and n.radius != ZERO for n in (a, b)):
            rises = (_of_hanging(a, b) is UP) == (_in_numbers(names, along)[1] > 0.0)  # a wheel that is led up and down
            found.append(along if rises else along.reversed())
        elif (runs := _sense_at_start(names, a, b, along)) is not None:
            found.append(along if runs > 0.0 else along.reversed())
        else:
            into_pulley = a.way == "end" and b.way != "end"
            ex, ey = _in_numbers(names, along)
            rising = ey if abs(ey) > ROUNDED else ex
            leaving = -ey if abs(ey) > ROUNDED else ex
            found.append(along if (rising if into_pulley else leaving) > 0 else along.reversed())
    return found


def _sense_at_start(names: Names, a: StringNode, b: StringNode, along: Direction) -> float | None:
    """How far a lead to a wheel that is led runs along a line at the start [m]; None where nobody has said."""
    if not any(node.guide is not None and node.radius != ZERO for node in (a, b)):
        return None
    start, end = (where_at_start(names, node) for node in (a, b))
    if start is None or end is None:
        return None
    ex, ey = _in_numbers(names, along)
    far = (end[0] - start[0]) * ex + (end[1] - start[1]) * ey
    return far if abs(far) > ROUNDED else None


def _of_hanging(a: StringNode, b: StringNode) -> Direction:
    """Up to what the string runs over or from what it runs under, else down to what hangs."""
    if b.way == "over" or a.way == "under":
        return UP
    if a.way == "over" or b.way == "under":
        return DOWN
    return DOWN if b.hangs else UP


# -- in which sense it goes round ---------------------------------------------------------------
def _turn(names: Names, way: Sequence[StringNode], leads: Sequence[Direction | None], k: int) -> int:
    """+1 where the string, followed from its start, runs counter-clockwise round place k, -1 clockwise, 0 at a
    point."""
    node = way[k]
    if node.radius == ZERO:
        return 0
    if node.turn is not None:
        return _sense(node, None)
    before = _heading(names, way, leads, k - 1) if k > 0 else None
    after = _heading(names, way, leads, k) if k < len(way) - 1 else None
    if node.way == "drum":
        return _sense(node, before or after)
    # the way it bends between leads that are known, or round the shorter side
    bend = before[0] * after[1] - before[1] * after[0] if before and after else 0.0
    is_end = before is None or after is None
    is_known = node.way == "around" or (not is_end and leads[k - 1] is not None and leads[k] is not None)
    if is_known and abs(bend) > ROUND_OFF:
        return 1 if bend > 0 else -1
    # over the top from the left to the right it runs clockwise
    is_leftward = k not in (0, len(way) - 1) and _goes_left(names, way[k - 1], node, way[k + 1])
    over = 1 if is_leftward else -1
    return -over if node.way == "under" else over


def _sense(drum: StringNode, heading: tuple[float, float] | None) -> int:
    """In which sense a lead goes round its drum: it touches at -s R n from the centre, n the heading turned by a
    quarter turn."""
    if drum.turn is not None:
        return -1 if drum.turn == "clockwise" else 1
    return -1 if _aside_of_drum(drum, heading) > 0 else 1


def _aside_of_drum(drum: StringNode, heading: tuple[float, float] | None) -> float:
    """How far the side at which a string leaves a drum is to the left of its lead; an unknown one hangs."""
    (sx, sy), (ex, ey) = _SIDES[drum.side or "right"], heading or (0.0, -1.0)
    return ex * sy - ey * sx


def sense_of_drum(names: Names, drum: StringNode, along: Direction) -> int:
    """+1 where a cord that leaves a drum in a direction runs counter-clockwise round it, -1 clockwise; 0 where its side
    leaves that open, which is a problem."""
    heading = _in_numbers(names, along)
    if drum.turn is None and not _is_on_one_hand(names, drum, along):
        names.problem(_either_hand(drum), "at")
        return 0
    return _sense(drum, heading)


def _is_on_one_hand(names: Names, drum: StringNode, along: Direction) -> bool:
    """Whether the side at which a cord leaves a drum is on the same hand of its direction wherever the parameters of
    that are: an acute angle stays one, another may be any."""
    used = sorted(frozenset[str]().union(*map(free_symbols, along.components)) & names.parameters.keys())
    senses = set[int]()
    for shares in itertools.product(_SHARES, repeat=len(used)):
        values = {"pi": math.pi}
        for name, share in zip(used, shares, strict=True):
            known = names.parameters[name]
            turn = math.pi / 2 * share if known.acute else math.pi * (2 * share - 1)
            size = 2 * share - 1 if known.sign == "any" else share
            values[name] = turn if known.is_angle else size
        x, y, *_ = (float(evaluate(c, values, FLOAT_FUNCTIONS)) for c in along.components)
        aside = _aside_of_drum(drum, (x, y))
        senses.add(0 if abs(aside) <= ROUND_OFF * math.hypot(x, y) else 1 if aside > 0 else -1)
    return len(senses) == 1 and 0 not in senses


def loose_drum(names: Names, run: StringRun) -> StringNode | None:
    """A drum whose side does not say in which sense the string is wound on it: it is ahead of it, or behind."""
    for k, lead in ((0, 0), (len(run.way) - 1, len(run.leads) - 1)):
        node = run.way[k]
        if node.way == "drum" and node.turn is None and node.radius != ZERO:
            heading = _heading(names, run.way, run.leads, lead)
            if abs(_aside_of_drum(node, heading)) <= ROUND_OFF * math.hypot(*(heading or (1.0, 0.0))):
                return node
    return None


def _goes_left(names: Names, before: StringNode, wheel: StringNode, after: StringNode) -> bool:
    """Whether a string comes to a wheel from the right, and goes on to the left. What hangs follows: it is on the other
    side than what stands beside the wheel; nobody has put that elsewhere than at the origin, if it has no place."""
    if before.way == after.way == "drum" and before.body == after.body:  # two drums on one shaft
        first, last = (_SIDES[drum.side or "right"][0] * number_of(names, drum.radius) for drum in (before, after))
        return last - first < -ROUNDED
    start, end, here = before.place, after.place, place_of(names, wheel.point)
    if start is not None and end is not None:
        return end[0] - start[0] < -ROUNDED
    if before.track is not None or after.track is not None:
        apart = apart_at_start(names, before.point, after.point, RIGHT)
        if apart is not None:
            return number_of(names, apart) < -ROUNDED
    if here is None or before.hangs == after.hangs:
        return False
    beside = number_of(names, wheel.radius) + ROUNDED
    if after.hangs:
        return (0.0 if start is None else start[0]) - here[0] > beside
    return here[0] - (0.0 if end is None else end[0]) > beside


def _heading(
    names: Names, way: Sequence[StringNode], leads: Sequence[Direction | None], k: int
) -> tuple[float, float] | None:
    """Direction of lead k in numbers, from its stated direction or from where its ends are."""
    lead = leads[k]
    if lead is not None:
        return _in_numbers(names, lead)
    a, b = (where_at_start(names, node) for node in way[k : k + 2])
    return None if a is None or b is None else (b[0] - a[0], b[1] - a[1])


def where_at_start(names: Names, node: StringNode) -> tuple[float, ...] | None:
    """Where a place of a string is in numbers: as it is put, else as it is held, else as it is guessed to be; a drum is
    at the origin as long as nobody has put it elsewhere."""
    found = node.place or place_of(names, node.point) or _started(names, node.point)
    near = names.known(node.body).start.near
    if found is not None or near is None or near.at is None:
        return found if found is not None or node.way != "drum" else (0.0, 0.0)
    (x, y), known = near.at[1][:2], names.known(node.body).points[near.at[0]] == node.point.offset
    return (number_of(names, x), number_of(names, y)) if known else None


def _started(names: Names, point: Point) -> tuple[float, float] | None:
    """Where a point that is put nowhere starts: along the line on which it lies, and aside of that."""
    along = ground_line_under(names, point.body) or RIGHT
    far, aside = starts_at(names, point, along), starts_at(names, point, along.normal())
    if far is None or aside is None:
        return None
    (ex, ey), (u, v) = _in_numbers(names, along), (number_of(names, far), number_of(names, aside))
    return u * ex - v * ey, u * ey + v * ex


def _in_numbers(names: Names, direction: Direction) -> tuple[float, float]:
    x, y, *_ = (number_of(names, c) for c in direction.components)
    return x, y
