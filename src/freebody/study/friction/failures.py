"""How a system at rest fails: the states of its contacts in the motion that no reaction prevents, and in words."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, in_turn, listed
from freebody.model.elements import ConstraintRow, DryFriction, UnilateralConstraint
from freebody.numeric.friction_branches import margin
from freebody.numeric.friction_limits import Optimum, unresisted
from freebody.numeric.jets import Array
from freebody.numeric.rest_problem import RestProblem
from freebody.present.lines import number_text
from freebody.study.answering.draws import Draw
from freebody.study.friction.touching import TouchingAtRest, apart
from freebody.symbolic.active_set import Failure
from freebody.system.corners import in_words, position_of

_STILL = 1e-6  # a rate that is none, of the largest
_TWISTED = 1e-6  # a moment about the normal that is none
_TURNED = math.sin(math.radians(15))
_WAYS = {  # by the signs of what goes up and to the right
    (0, 1): Message("to the right"),
    (0, -1): Message("to the left"),
    (1, 0): Message("up"),
    (-1, 0): Message("down"),
    (1, 1): Message("up to the right"),
    (1, -1): Message("up to the left"),
    (-1, 1): Message("down to the right"),
    (-1, -1): Message("down to the left"),
}


@dataclass(frozen=True)
class SeenFailure:
    """A failure in numbers: the states of the contacts, the rate of every row, and what it is in words."""

    failure: Failure
    draw: Draw
    rates: Mapping[str, float]
    words: str


def seen(
    touching: TouchingAtRest, problem: RestProblem, optimum: Optimum, draw: Draw, asked: str | None = None
) -> SeenFailure:
    """What the motion of an optimum does at every contact: it opens where it parts faster than sliding apart along the
    edge of the friction cone would. A row whose reaction is asked for does neither."""
    insist_on_one_place(touching, problem, optimum.forces)
    v = optimum.motion
    raw = problem.J @ v
    sizes = np.linalg.norm(problem.J * problem.moves, axis=1)
    sizes = np.where(sizes > 0.0, sizes, 1.0)
    scaled = raw / sizes
    # beside the motion itself: where all contacts roll, their rates are rounding alone
    still = _STILL * max(float(np.abs(scaled).max(initial=0.0)), float(np.linalg.norm(v / problem.moves)))
    opens: set[str] = set()
    slips: dict[str, int] = {}
    for row, sign in problem.normals:
        if problem.names[row] == asked:
            continue
        opening = sign * raw[row]
        own = [cone for cone in problem.cones if cone.load and cone.load[0][0] == row]
        if any(cone.name == asked for cone in own) and sign * optimum.forces[row] > _STILL * problem.force:
            continue  # it is pressed, and friction that is asked for is at its limit
        sliding = sum((c.forward if raw[c.row] > 0 else c.backward) * c.size_of(raw) for c in own)
        if opening - sliding > still * sizes[row] and opening > still * sizes[row]:
            opens.add(problem.names[row])
    for cone in problem.cones:
        if cone.load and {problem.names[j] for j, _sign in cone.load} <= opens:
            continue
        if cone.name == asked:
            # its own cone limits it where its load would grow along the motion
            if any(sign * scaled[j] > still for j, sign in cone.load):
                slips[cone.name] = -1 if optimum.forces[cone.row] > 0 else 1
            continue
        if cone.size_of(scaled) > still:
            slips[cone.name] = 1 if raw[cone.row] > 0 or cone.across >= 0 else -1
    signs: dict[str, int] = {}
    for cone in problem.cones:
        # of two components the one that there is, where the other vanishes
        sizes_of = [abs(optimum.forces[j]) for j in cone.size]
        there = [j for j, size in zip(cone.size, sizes_of, strict=True) if size > _STILL * max(sizes_of)]
        if len(cone.size) == 1 or len(there) == 1:
            j = (there or cone.size)[0]
            signs[problem.names[j]] = 1 if optimum.forces[j] >= 0 else -1
    failure = Failure(frozenset(opens), tuple(sorted(slips.items())), tuple(sorted(signs.items())))
    rates = dict(zip(problem.names, map(float, raw), strict=True))
    return SeenFailure(failure, draw, rates, words(touching, problem, failure))


def how_it_fails(touching: TouchingAtRest, problem: RestProblem, draw: Draw) -> str:
    """The failure of a system that nothing can hold, or the one that is nearest, in words."""
    loose = unresisted(problem)
    if loose is not None:
        body = touching_most(touching, problem, loose)
        if apart := list(_open_contacts(touching, draw, body)):
            return Message("nothing resists {body}: {contacts}", body=body, contacts=listed(apart))
        return Message("nothing resists {body}", body=body)
    found = margin(problem)
    return "" if found is None else seen(touching, problem, found, draw).words


def _open_contacts(touching: TouchingAtRest, draw: Draw, body: str) -> Iterator[str]:
    """The contacts, stops and ropes of a body that are open in the start pose, and by how much."""
    reference, closed = draw.reference, {bound.name for bound in touching.bounds}
    own = [b for b in touching.system.bounds if body in _owners(b.row)]
    held = {b.row.connection for b in own if b.name in closed}
    gaps: dict[str, tuple[float, str]] = {}
    for gap, name in apart(reference, reference.geometry(draw.q, np.zeros_like(draw.q), 0.0), own).values():
        row = next(b.row for b in own if b.name == name)
        if row.connection not in held:
            unit = str(row.measure.dimension)
            gaps[row.connection] = min(gaps.get(row.connection, (math.inf, unit)), (gap, unit))
    for contact, (gap, unit) in gaps.items():
        yield Message("{contact} is open by {gap}", contact=contact, gap=f"{number_text(gap)} {unit}".strip())


def touching_most(touching: TouchingAtRest, problem: RestProblem, v: Array) -> str:
    """The body that moves most."""
    relative = np.abs(v) / problem.moves
    k, best, most = 0, "", -1.0
    for body in touching.held.moving:
        n = _n_coordinates(touching, turns=body.turns)
        if float(relative[k : k + n].max()) > most:
            best, most = body.name, float(relative[k : k + n].max())
        k += n
    return best


def _n_coordinates(touching: TouchingAtRest, *, turns: bool) -> int:
    return (6 if turns else 3) if touching.system.space else (3 if turns else 2)


# -- words ------------------------------------------------------------------------------------
def words(touching: TouchingAtRest, problem: RestProblem, failure: Failure) -> str:
    """What happens, as one says it: tips about a corner, slips to the right on the floor."""
    parts = list(dict.fromkeys(_parts(touching, problem, failure)))
    return in_turn(parts, "{first} and {second}") if parts else Message("equilibrium alone decides")


def _parts(touching: TouchingAtRest, problem: RestProblem, failure: Failure) -> Iterator[str]:
    tipping: dict[str, str] = {}
    for name in failure.opens:
        bound = _bound(touching, name)
        if bound is None:
            continue
        body = next((end for end in _owners(bound.row) if end in touching.held.bodies), "")
        about = _pivot(touching, failure, body)
        if body and about:
            tipping[body] = about
    for body, about in tipping.items():
        yield Message("{body} tips about {corner}", body=body, corner=about)
    for name in sorted(failure.opens):
        bound = _bound(touching, name)
        if bound is not None and any(end in tipping for end in _owners(bound.row)):
            continue
        yield _opening(touching, name)
    yield from _slips(touching, problem, failure)


def _slips(touching: TouchingAtRest, problem: RestProblem, failure: Failure) -> Iterator[str]:
    """Where dry friction gives way; corners of one body that slip alike, as the body."""
    groups: dict[tuple[str, str, str, str], list[str]] = {}
    flat = {rub.of for rub in touching.dry_friction if rub.is_tipping}
    for name, direction in failure.slips:
        rub = next(r for r in touching.dry_friction if r.name == name)
        row = rub.row
        if not rub.of or len(row.ends) < 2:
            what = "turns" if row.reaction == "friction torque" else "slips"
            if row.component.startswith("slip on "):  # a string round a drum
                what = "to start" if direction > 0 else "to end"
            groups.setdefault((row.connection, what, "", row.component.removeprefix("slip on ")), [])
        elif rub.is_tipping:
            groups.setdefault((row.ends[0].partition(".")[0], "tips on", "", row.ends[1]), [])
        elif row.component.startswith("rolling"):
            groups.setdefault((row.ends[0], "rolls", "", row.ends[1]), [])
        else:
            way = _heading(touching, problem, row, direction)
            body = row.ends[0].partition(".")[0]
            place = body if rub.of in flat else in_words(touching.system, row.ends[0])
            groups.setdefault((body, "slips on", way, row.ends[1]), []).append(place)
    for (who, what, way, other), places in groups.items():
        yield _gives_way(places[0] if len(places) == 1 else who, what, way, other)


def insist_on_one_place(touching: TouchingAtRest, problem: RestProblem, forces: Array) -> None:
    """Raises CannotAnswer where friction under a flat end must turn it about the normal as well.

    Pressure and friction of a flat end come to a force N and T in one place c of it, c x T being their moment about the
    normal in its middle, or they are spread over it in a way that is not known. A contact resists spinning by its
    spinning resistance alone, so that this moment must vanish: with M = c x N it is -(M . T)/N."""
    for tip in (rub for rub in touching.dry_friction if rub.is_tipping):
        slip = next((rub for rub in touching.dry_friction if rub.of == tip.of and _slides(rub)), None)
        if slip is None:
            continue
        moment, force = ([float(forces[problem.place(row.name)]) for row in rub.rows] for rub in (tip, slip))
        radius = next(cone.forward for cone in problem.cones if cone.name == tip.name)
        none = _TWISTED * (math.hypot(*moment) * math.hypot(*force) + _TWISTED * radius * problem.force**2)
        if abs(moment[0] * force[0] + moment[1] * force[1]) > none:
            raise CannotAnswer(
                Message(
                    "under {place} friction would have to resist a moment about the normal as well, and how it is "
                    "spread over a flat end is not known. Loads whose forces meet in one line leave none",
                    place=tip.row.ends[0],
                )
            )


def _slides(rub: DryFriction) -> bool:
    return rub.row.reaction.startswith("friction force")


def _gives_way(who: str, what: str, way: str, other: str) -> str:
    match what:
        case "turns":
            return Message("{joint} turns", joint=who)
        case "slips":
            return Message("{contact} slips", contact=who)
        case "to start":
            return Message("{string} slips on {drum} towards its start", string=who, drum=other)
        case "to end":
            return Message("{string} slips on {drum} towards its end", string=who, drum=other)
        case "tips on":
            return Message("{body} tips about its rim on {other}", body=who, other=other)
        case "rolls":
            return Message("{body} rolls on {other}", body=who, other=other)
        case _:
            if way:
                return Message("{body} slips {way} on {other}", body=who, way=way, other=other)
            return Message("{body} slips on {other}", body=who, other=other)


def _bound(touching: TouchingAtRest, name: str) -> UnilateralConstraint | None:
    return next((b for b in touching.bounds if b.name == name), None)


def _pivot(touching: TouchingAtRest, failure: Failure, body: str) -> str:
    """The corner about which a body turns that leaves its others: the one that stays and does not slip. What does not
    turn, a particle, has none."""
    if body not in touching.held.bodies or not touching.held.bodies[body].turns:
        return ""
    slipping = {rub.of for rub in touching.dry_friction if rub.name in dict(failure.slips)}
    touched = [b for b in touching.bounds if body in _owners(b.row)]
    stays = [b for b in touched if b.name not in failure.opens]
    opened = [b for b in touched if b.name in failure.opens]
    if not opened or any(b.name in slipping for b in stays):
        return ""
    if len({b.row.connection for b in (*stays, *opened)}) > 1 and len(touched) > 2:
        return ""
    if len(stays) == 2 and touching.system.space and all(b.row.ends[0].startswith(f"{body}.") for b in stays):
        one, other = (position_of(touching.system, b.row.ends[0]) for b in stays)
        return Message("its edge from {one} to {other}", one=one, other=other)
    return _place(touching, stays[0].row) if len(stays) == 1 else ""


def _owners(row: ConstraintRow) -> tuple[str, ...]:
    """The bodies that touch; on a plane the one whose corner does."""
    return (*row.ends, *(end.partition(".")[0] for end in row.ends[:1]))


def _place(touching: TouchingAtRest, row: ConstraintRow) -> str:
    """The corner that a row holds: `block.bottom_left` on the floor, a wheel on `ground.edge`."""
    corner = next((in_words(touching.system, end) for end in row.ends if "." in end), None)
    return corner or (row.ends[0] if row.ends else row.connection)


def _opening(touching: TouchingAtRest, name: str) -> str:
    row = next(r for r in touching.rows if r.name == name)
    if row.reaction == "tension":
        return Message("{contact} goes slack", contact=row.connection)
    if len(row.ends) >= 2:
        return Message("{body} leaves {other}", body=in_words(touching.system, row.ends[0]), other=row.ends[1])
    return Message("{contact} lifts off", contact=row.connection)


def _heading(touching: TouchingAtRest, problem: RestProblem, row: ConstraintRow, direction: int) -> str:
    """Which way the first body slips along the other one, in the plane."""
    if touching.system.space:
        return ""
    body = next((end for end in row.ends if end in touching.held.bodies), "")
    columns: list[int] = []
    k = 0
    for moving in touching.held.moving:
        n = 3 if moving.turns else 2
        if moving.name == body:
            columns = [k, k + 1]
        k += n
    if not columns:
        return ""
    gx, gy = (float(problem.J[problem.place(row.name), c]) * direction for c in columns)
    size = math.hypot(gx, gy)
    if size == 0.0:
        return ""
    across = 0 if abs(gx) < _TURNED * size else 1 if gx > 0 else -1
    up = 1 if gy > _TURNED * size else -1 if gy < -_TURNED * size else 0
    return _WAYS[up, across if up else 1 if gx > 0 else -1]
