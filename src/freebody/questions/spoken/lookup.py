"""What a model has for things that words mean without naming them: measures of a place, connections between two things.

Each function gives all that fit: where a model has several, each is a way to mean the words.
"""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING

from freebody.language.expression import free_symbols, negate, substitute
from freebody.language.notation import to_python
from freebody.language.units import ANGULAR_VELOCITY, DIMENSIONLESS, LENGTH
from freebody.measures.combination import Composed
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Bearing, Distance
from freebody.measures.geometry import GROUND, ZERO, Components
from freebody.model.elements import VALUE, RigidBody

FORCED = ("steady amplitude", "phase lag", "resonance frequency", "magnification factor")
STRETCHED = ("extension", "compression")  # quantities of what is longer, or shorter, than without force
_LEVEL = 1e-9  # of a direction that is level, or straight up


if TYPE_CHECKING:
    from freebody.language.expression import Expr
    from freebody.measures.base import Measure
    from freebody.model.names import Names


# -- bodies and measures ----------------------------------------------------------------------
def moving(names: Names) -> list[str]:
    """Bodies that are not held by themselves."""
    return [name for name, body in names.bodies.items() if name != GROUND and not body.fixed]


def turning(names: Names) -> list[str]:
    return [name for name in moving(names) if names.bodies[name].turns]


def started(names: Names) -> list[str]:
    """Bodies that turn as the motion begins, where the file says of one alone that it does."""
    turned = [name for name in names.start_rates if names.start_rates[name] != ZERO and name in angles(names, "")]
    found = {body for name in turned for body in names.measures[name].bodies()} - {GROUND}
    return sorted(found) if len(found) == 1 else []


def measured(names: Names) -> list[str]:
    """What is measured, or the bodies that move where nothing is."""
    return list(names.measures) or moving(names)


def can_roll(names: Names) -> bool:
    """Whether something round moves."""
    return any(names.bodies[name].is_wheel or names.bodies[name].round for name in turning(names))


def is_all_that_moves(names: Names, body: str) -> bool:
    """Whether nothing else has a mass or, where nothing has one, resists turning."""
    turned = [name for name in moving(names) if names.bodies[name].inertia != ZERO]
    return (massive(names) or turned) == [body]


def mass_center_of(names: Names, body: str) -> str:
    """The mass centre of a body, by its plain name where that means it."""
    own = names.bodies[body]
    return body if own.points["mass_center"] == own.points[own.default_point] else f"{body}.mass_center"


def massive(names: Names) -> list[str]:
    """Bodies that move and have a mass."""
    return [name for name in moving(names) if names.bodies[name].mass != ZERO]


def rests(names: Names) -> bool:
    """Whether nothing is given that would set the system in motion."""
    speeds = [x for body in names.bodies.values() for x in body.start.velocity or ()]
    return all(rate == ZERO for rate in (*names.start_rates.values(), *speeds))


def swings(names: Names) -> bool:
    """Whether the file lets the system start away from where its measures are zero, or in motion."""
    return names.starts_away


def ways(names: Names, body: str) -> list[str]:
    """Measures of how far a body has come from where the motion starts, or all such measures where none is named."""
    if body in names.measures:
        return [body] if body in names.started_at_zero else []
    lengths = [n for n, m in names.measures.items() if m.dimension != DIMENSIONLESS and n in names.started_at_zero]
    return _its_own(names, [n for n in lengths if not body or body in names.measures[n].bodies()], body)


def _its_own(names: Names, lengths: list[str], body: str) -> list[str]:
    """Without those that only count from a body the way of another one, where others are of it: how far the person has
    walked from the boat is no way of the boat."""
    counted = {n for n in lengths if isinstance(m := names.measures[n], Displacement) and m.of.body != body}
    own = [n for n in lengths if n not in counted]
    return own if body in names.bodies and own else lengths


def places(names: Names, body: str) -> list[str]:
    """Measures of where a body is along a line, or all such measures where none is named."""
    if body in names.measures:
        return [body]
    lengths = {name: measure for name, measure in names.measures.items() if measure.dimension != DIMENSIONLESS}
    ends = {name: (m.start.name, m.end.name) for name, m in lengths.items() if isinstance(m, Distance)}
    return [name for name, m in lengths.items() if not body or body in m.bodies() or body in ends.get(name, ())]


def begun(names: Names, body: str) -> list[tuple[str, Expr]]:
    """Measures of where a body is, or at which angle, with where the file lets them start."""
    found = places(names, body) or angles(names, body)
    return [(name, names.placed_at_start[name]) for name in found if name in names.placed_at_start]


def went(names: Names, body: str) -> list[str]:
    """Measures of how far a body has come, wherever it starts: along a straight line of the ground."""
    straight = [(name, names.measures[name]) for name in places(names, body)]
    fixed = [n for n, m in straight if isinstance(m, Displacement) and {m.origin.body, m.along.body} == {GROUND}]
    return ways(names, body) or fixed


def is_free(names: Names, body: str) -> bool:
    """Whether a body, or all that moves, has places along several directions: its path is as long as none of them."""
    straight = [names.measures[name] for name in places(names, body)]
    along = [(m.of.body, m.along) for m in straight if isinstance(m, Displacement)]
    return any(one[0] == other[0] and one[1] != other[1] for one in along for other in along)


def of_places(names: Names) -> list[str]:
    """What is measured and is no angle, or what moves where nothing is; with the angles where no place is that of a
    mass centre, but each one of a point of a body that turns."""
    found = [name for name in measured(names) if name not in angles(names, "")]
    of = [m.of if isinstance(m := names.measures.get(name), Displacement) else None for name in found]
    ends = [p for p in of if p is not None and p.offset != names.bodies[p.body].points.get("mass_center")]
    turned = {body for angle in angles(names, "") for body in names.measures[angle].bodies()}
    return measured(names) if found and len(ends) == len(found) and {p.body for p in ends} & turned else found


def angles(names: Names, body: str) -> list[str]:
    """Measures of how a body, or a straight link or string, is turned against the ground, or all angles where none is
    named."""
    if body in names.measures:
        return [body] if names.measures[body].dimension == DIMENSIONLESS else []
    found = [(name, measure) for name, measure in names.measures.items() if measure.dimension == DIMENSIONLESS]
    own = [name for name, measure in found if not body or {*measure.bodies()} - {GROUND} == {body}]
    return own or [name for name, _ in found if _is_along(names, name, body)]


def _is_along(names: Names, angle: str, connection: str) -> bool:
    """Whether an angle is that of the line of a link or of a string between two points."""
    line, of = bearing(names, angle), names.connections.get(connection)
    if line is None or of is None:
        return False
    with names.quietly():
        ends = of.straight_between(names)
    return ends is not None and {(p.body, p.offset) for p in ends} == {
        (p.body, p.offset) for p in (line.start, line.end)
    }


def hung(names: Names, body: str) -> list[str]:
    """Angles of lines that end at a body."""
    return [name for name in names.measures if (m := bearing(names, name)) is not None and m.end.body == body]


def farthest(names: Names, angle: str) -> str:
    """How far an angle gets: from zero and at rest it may go either way, or farther when it comes back; where the file
    names no angle it is counted from the start."""
    if angle in names.counted_from_right:
        return f"greatest change of {angle}"
    is_at_rest = names.start_rates.get(angle, ZERO) == ZERO and not names.struck_at_start
    return f"greatest {'change of ' if angle in names.started_at_zero and is_at_rest else ''}{angle}"


def farthest_way(names: Names, way: str) -> str:
    """How far something gets along a way: from zero and at rest it may set out to either side."""
    is_at_rest = names.start_rates.get(way, ZERO) == ZERO and not names.struck_at_start
    return f"greatest |{way}|" if way in names.started_at_zero and is_at_rest else f"greatest {way}"


def bearing(names: Names, name: str) -> Bearing | None:
    """The angle of a line that a measure is, which way round it may be counted."""
    measure = names.measures[name]
    if isinstance(measure, Composed) and len(measure.measures) == 1:
        [(_, measure)] = measure.measures
    return measure if isinstance(measure, Bearing) else None


def gone(names: Names, body: str, by: str, sense: int) -> list[str]:
    """The condition that a body has come so far up (sense 1) or down (-1) along its way."""
    return [come(names, name, by, own * sense) for name, own in sloping(names, went(names, body))]


def inclined(names: Names, body: str) -> list[tuple[str, int]]:
    """Measures of how far a body has come along a straight way that is not level: 1 where they count upwards."""
    return sloping(names, ways(names, body))


def sloping(names: Names, measures: list[str]) -> list[tuple[str, int]]:
    """Those of some measures that are along a straight way that is not level: 1 where they count upwards."""
    found: list[tuple[str, int]] = []
    for name in measures:
        measure = names.measures[name]
        if isinstance(measure, Displacement) and measure.along.body == GROUND:
            rise = names.numeric(measure.along.components[1])
            if rise is not None and abs(rise) > _LEVEL:
                found.append((name, 1 if rise > 0.0 else -1))
    return found


def alike(names: Names, one: str, other: str) -> list[tuple[str, str]]:
    """Measures of two things by how far they are along the same direction of the ground."""
    found = [[(name, names.measures[name]) for name in places(names, thing)] for thing in (one, other)]
    return [
        (a, b)
        for (a, first), (b, second) in product(*found)
        if isinstance(first, Displacement) and isinstance(second, Displacement)
        if first.along.components == second.along.components and first.along.body == second.along.body == GROUND
    ]


def level(names: Names, body: str) -> list[str]:
    """Measures of how far a body is along a straight line of the ground that is level."""
    found: list[str] = []
    for name in places(names, body):
        measure = names.measures[name]
        if isinstance(measure, Displacement) and measure.along.body == GROUND:
            rise = names.numeric(measure.along.components[1])
            found += [name] if rise is not None and abs(rise) <= _LEVEL else []
    return found


def flies(names: Names, body: str) -> bool:
    """Whether a body may be above where it lands: its height is measured, or it is placed."""
    bodies = [body] if body in names.bodies else moving(names)
    return bool(heights(names, body)) or any(names.bodies[name].start.at is not None for name in bodies)


# -- heights ----------------------------------------------------------------------------------
def heights(names: Names, body: str) -> list[tuple[str, int]]:
    """Measures of how high a body is, or of any body where none is named: 1 where they count upwards, -1 downwards."""
    senses = {names.compass["up"].components: 1, names.compass["down"].components: -1}
    found: list[tuple[str, int]] = []
    for name, measure in names.measures.items():
        if not isinstance(measure, Displacement) or body not in ("", name, measure.of.body):
            continue
        sense = senses.get(measure.along.components)
        if sense is not None and {measure.along.body, measure.origin.body} == {GROUND}:
            found.append((name, sense))
    return found


def heights_of_points(names: Names, body: str) -> list[str]:
    """Measures of how high points of a body are, beside its mass centre."""
    own = ((name, names.measures[name]) for name, sense in heights(names, body) if sense > 0)
    return [name for name, m in own if isinstance(m, Displacement) and m.of.name.endswith((".start", ".end"))]


def climbed(names: Names, body: str, by: str, sense: int) -> list[str]:
    """The condition that a body is higher (sense 1) or lower (-1) than at the start by a length."""
    body = massive(names)[0] if not body and len(massive(names)) == 1 else body
    measured = heights(names, body) or [(f"height of {name}", 1) for name in [body] if name in moving(names)]
    return [come(names, name, by, own * sense) for name, own in measured]


def come(names: Names, measure: str, by: str, sense: int = 1) -> str:
    """The condition that a measure is more (sense 1) or less (-1) than at the start by a value."""
    begins = "=" if measure in names.started_at_zero or measure in angles(names, "") else "has changed by"
    return f"{measure} {begins} {'' if sense == 1 else '-'}{_factor(by)}"


def gone_either_way(names: Names, measure: str, by: str) -> str:
    """The condition that a measure is so far from where it starts, on the side to which the motion begins: what is let
    go from rest goes where it is pulled, and what its own rate does not tell is found from the motion."""
    is_let_go = names.lets_go_from_rest and not is_forced(names) and not _may_fall(names, measure)
    if by.startswith("-") or is_let_go or rises(names, measure, 1):
        return come(names, measure, by)
    return come(names, measure, by, -1) if rises(names, measure, -1) else f"{measure} has moved {by}"


def _may_fall(names: Names, measure: str) -> bool:
    """Whether a measure counts up a slope, down which things slide, or along a line that moves."""
    own = names.measures[measure]
    if not all("gravity" in names.called.get(load, ()) for load in names.loads):
        return False  # it goes where it is pulled
    is_led = isinstance(own, Displacement) and own.along.body != GROUND
    return is_led or (measure, 1) in (*heights(names, ""), *inclined(names, ""))


def _factor(value: str) -> str:
    return f"({value})" if any(sign in value[1:] for sign in "+-") else value


def lifted(names: Names, body: str, value: str) -> list[str]:
    """The condition that a body is at a height."""
    return [f"{name} = {value}" for name, sense in heights(names, body) if sense > 0]


def rising(names: Names, body: str) -> list[str]:
    """Heights that start at zero."""
    return [name for name, sense in heights(names, body) if sense > 0 and name in names.started_at_zero]


def falling(names: Names, body: str) -> list[str]:
    """Heights at zero of which something that flies lands: those that start there, or above it."""
    places = names.placed_at_start
    above = [name for name in places if (names.numeric(places[name]) or 0.0) > 0.0]
    thrown = (
        []
        if rests(names) and all(own.start.velocity is None for own in names.bodies.values())
        else heights(names, body)
    )
    begun = [name for name, _ in thrown if name in names.started_at_zero or _put_at(names, name) == 0.0]
    above += [name for name, sense in heights(names, body) if sense * (_put_at(names, name) or 0.0) > 0.0]
    found = [name for name, sense in heights(names, body) if name in begun or (name in above and sense > 0)]
    return found or [f"height of {name}" for name in flying(names, body) if not heights(names, name)]


def flying(names: Names, body: str) -> list[str]:
    """Bodies that nothing holds, or the one of a name among them, that are thrown from the height zero or are above it
    at the start."""
    found: list[str] = []
    for name in [body] if body in names.bodies else moving(names):
        height = _place_along(names, names.bodies[name], names.up)
        thrown = names.bodies[name].start.velocity is not None
        if not _is_held(names, name) and height is not None and (height > 0.0 or (height == 0.0 and thrown)):
            found.append(name)
    return found


def starts_aside(names: Names, body: str) -> bool:
    """Whether a body is put elsewhere than above the origin."""
    return _place_along(names, names.bodies[body], names.compass["right"].components) != 0.0


def _is_held(names: Names, body: str) -> bool:
    return any(body in connection.mentions(names) for connection in names.connections.values())


def _place_along(names: Names, body: RigidBody, along: Components) -> float | None:
    """How far along a direction of the ground the file puts the reference point of a body, zero where it does not."""
    if body.start.at is None:
        return 0.0
    point, place = body.start.at
    parts = [names.numeric(c * e) for c, e in zip(place, along, strict=False)]
    return None if body.points[point] != body.center.offset or None in parts else sum(p for p in parts if p is not None)


def _put_at(names: Names, measure: str) -> float | None:
    """Where a displacement of a body from the origin starts, by the place that the file gives the body; None where
    something holds that, where the start says it otherwise, and of a body without velocity and place."""
    way = names.measures[measure]
    if not isinstance(way, Displacement) or measure in names.placed_at_start or _is_held(names, way.of.body):
        return None
    body = names.bodies[way.of.body]
    is_plain = way.origin.offset == names.origin and way.of.offset == body.center.offset
    if not is_plain or (body.start.velocity is None and body.start.at is None):
        return None
    return _place_along(names, body, way.along.components)


def rises(names: Names, measure: str, sense: int) -> bool:
    """Whether a height grows as the motion begins, at the numbers of the model."""
    if measure not in names.start_rates and (thrown := _thrown(names, names.measures[measure])) is not None:
        return sense * thrown > 0.0
    rate = names.numeric(names.start_rates.get(measure, ZERO))
    return rate is not None and sense * rate > 0.0


def _thrown(names: Names, measure: Measure) -> float | None:
    """The rate of a displacement along a direction of the ground, by the velocity that the body itself is given."""
    body = names.bodies.get(measure.of.body) if isinstance(measure, Displacement) else None
    velocity = None if body is None else body.start.velocity
    if not isinstance(measure, Displacement) or velocity is None or measure.along.body != GROUND:
        return None
    parts = [(names.numeric(v), names.numeric(c)) for v, c in zip(velocity, measure.along.components, strict=False)]
    return (
        None if any(None in part for part in parts) else sum(v * c for v, c in parts if v is not None and c is not None)
    )


def is_known(names: Names, name: str) -> bool:
    """Whether a name is that of a thing that the model has."""
    ground = names.bodies[GROUND]
    things = (names.bodies, names.connections, names.loads, names.measures, ground.lines, ground.planes)
    return any(name.partition(".")[0] in own for own in things)


def is_known_point(names: Names, name: str) -> bool:
    body, _, point = name.partition(".")
    return body in names.bodies and point in names.bodies[body].points


# -- loads ------------------------------------------------------------------------------------
def springs(names: Names) -> list[str]:
    """Loads that are springs: so called, or with a law of how far something has come."""
    laws = {p.load for p in names.applied_loads if p.measure.dimension == LENGTH and VALUE.name in free_symbols(p.law)}
    laws = {name for name in laws if "law" in names.called.get(name, ())}
    named = {
        name for name in names.loads if "spring" in (*names.called.get(name, ()), name.lower().rstrip("0123456789_"))
    }
    return [name for name in names.loads if name in named | laws]


def elastic_strings(names: Names) -> list[str]:
    """Loads that pull as strings do."""
    return [name for name in names.loads if {"string", "elastic"} & {*names.called.get(name, ())}]


def driving(names: Names) -> list[str]:
    """Loads that are no weight, no spring and no damper: forces and torques that something exerts."""
    passive = {"gravity", "spring", "damper"}
    plain = [name for name in names.loads if name not in springs(names)]
    return [name for name in plain if not passive & {word.split()[-1] for word in names.called.get(name, ())}]


def presses_on_ground(names: Names) -> bool:
    """Whether springs or dampers act between something that moves and the ground."""
    acting = [p for p in names.applied_loads if p.load in springs(names) or VALUE.name not in free_symbols(p.law)]
    return any(p.load in springs(names) and GROUND in p.measure.bodies() for p in acting)


def is_controlled(names: Names) -> bool:
    """Whether a controller, or what depends on the motion and is no spring, keeps it as it is: then it is a steady
    motion that is stable."""
    pushes = [p for p in names.applied_loads if p.load in driving(names)]
    return bool(names.states) or any(not free_symbols(p.law) <= names.parameters.keys() | {"t"} for p in pushes)


def acted_on(names: Names, thing: str) -> str:
    """The body that a load acts on, where that is one; else what is named: the motor turns the drum."""
    acted = {body for p in names.applied_loads if p.load == thing for body in p.measure.bodies()} - {GROUND}
    return next(iter(acted)) if thing in names.loads and len(acted) == 1 else thing


def stretched_at_rest(names: Names, spring: str) -> list[str]:
    """By how much a spring, or the only one, is longer in equilibrium than without force: its length less that."""
    found: list[str] = []
    for load in names.applied_loads:
        if load.load not in springs(names) or (spring in names.loads and load.load != spring):
            continue
        measure = load.measure
        if not isinstance(measure, Composed) or len(measure.measures) != 1:
            continue
        [(symbol, length)] = measure.measures
        if isinstance(length, Distance):
            natural = negate(substitute(measure.expression, {symbol: ZERO}))  # of: length - l_0
            ends = f"{length.start.name} to {length.end.name}"
            text = _factor(to_python(natural).replace("**", "^"))
            text = text if free_symbols(natural) else f"{text} m"  # a length that the file gives with its unit
            found.append(f"(equilibrium of distance from {ends}) - {text}")
    return found


def is_forced(names: Names) -> bool:
    """Whether a load is a function of time."""
    is_driven = any("drive" in names.called.get(name, ()) for name in names.connections)
    return is_driven or any(p.general is not None or "t" in free_symbols(p.law) for p in names.applied_loads)


def excitation(names: Names) -> str:
    """The parameter that is the frequency of the loads and drives that swing, where it is one; else nothing."""
    laws = [p.law for p in names.applied_loads] + [r.target for r in names.constraint_rows if r.target is not None]
    timed = {name for law in laws if "t" in free_symbols(law) for name in free_symbols(law)}
    found = [p.name for p in names.parameters.values() if p.name in timed and p.dimension == ANGULAR_VELOCITY]
    return found[0] if len(found) == 1 else ""


def catching(names: Names, *, pulls: bool) -> list[str]:
    """Loads that act on one side of a border only: elastic strings, which pull, or buffers, which push."""
    sides = {p.load: p.one_sided for p in names.applied_loads if p.one_sided is not None}
    return [name for name, side in sides.items() if side.pulls == pulls]


def deflected(names: Names, spring: str) -> str:
    """Whether springs, or the one that is named, are only stretched or only compressed, as one side of them says."""
    sides = [p.one_sided for p in names.applied_loads if p.load in springs(names) and spring in ("", p.load)]
    ways = {"" if side is None else STRETCHED[not side.pulls] for side in sides}
    return next(iter(ways)) if len(ways) == 1 else ""


def deflections(names: Names, spring: str) -> list[str]:
    """Named measures that the force of a spring, of the only one, or of that at a body, is in proportion to."""
    at = {p.load for p in names.applied_loads if spring in names.bodies and spring in p.measure.bodies()}
    named = [name for name in springs(names) if not spring or name == spring or name in at]
    own = [load.measure for load in names.applied_loads if load.load in named and load.load in springs(names)]
    return [name for name, measure in names.measures.items() if measure in own] if len(named) == 1 else []
