"""Poses that have a name: what goes round a point of the ground hangs straight down, stands upright, lies level.

What goes round is a body at the end of a line whose angle is measured, or one that turns about an axle beside its mass
centre: the line from the axle to the mass centre is meant. A pose is where the measure of that angle has a value.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.language.expression import Symbol, differentiate, free_symbols, substitute
from freebody.language.units import LENGTH
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Bearing
from freebody.measures.geometry import GROUND, ZERO
from freebody.model.curves import LevelPlace
from freebody.model.solids import ROD
from freebody.questions.spoken import driving, joining, lookup, of_axles, strings

if TYPE_CHECKING:
    from freebody.model.names import Names

_AT_PLACE = re.compile(r"\b(?:when|until) (?P<measure>[^\W\d]\w*) = (?P<value>[^=<>]+)$")
_TIME = "t"
_NEAR = 1e-6  # degrees: of an angle that people name


@dataclass(frozen=True)
class _Going:
    """A measure by which a line from the ground goes round: it points at sense * measure + offset, counter-clockwise
    from the right, in degrees."""

    measure: str
    sense: int
    offset: float

    def value(self, pointing: float) -> float:
        """The value of the measure where the line points so, within half a turn."""
        value = (self.sense * (pointing - self.offset)) % 360.0
        return value - 360.0 if value > 180.0 + _NEAR else value


def tops(names: Names, body: str) -> list[str]:
    """The condition that a body has risen as far as it does at first, swings no further, or is led no higher."""
    ways = [*lookup.heights(names, body), *lookup.inclined(names, body)]
    rising = dict.fromkeys(f"rate({name}) = 0" for name, sense in ways if lookup.rises(names, name, sense))
    turning_back = [f"rate({going.measure}) = 0" for going in _on_lines(names, body)]
    over = [] if lookup.rests(names) and turning_back else uppermost(names, body)  # what is let go does not go over
    goes = driving.is_led(names) or (names.space and not names.lets_go_from_rest)
    led = [f"{name} is greatest" for name, sense in lookup.heights(names, body) if sense > 0 and goes]
    return [*rising] or [*over, *turning_back] or _flown(names, body) or named_by_file(names, body, 1) or led


def _flown(names: Names, body: str) -> list[str]:
    """That what is thrown is highest, where no measure tells its height."""
    thrown = [name for name in ([body] if body else lookup.massive(names)) if lookup.flies(names, name)]
    thrown = [name for name in thrown if name in names.bodies and names.bodies[name].start.velocity is not None]
    return [f"height of {name} is greatest" for name in thrown]


def turning(names: Names, body: str) -> list[str]:
    """The condition that what is measured of something turns back."""
    found = lookup.places(names, body) or lookup.angles(names, body) or lookup.hung(names, body)
    return [f"rate({name}) = 0" for name in found]


def uppermost(names: Names, body: str) -> list[str]:
    """The condition that what goes round a point of the ground is straight above it."""
    return _conditions(names, body, 90.0) or _on_curves(names, body, lowest=False)


def begins_uppermost(names: Names, body: str) -> bool:
    """Whether the file places a body straight above the point of the ground that it goes round, or where its curve is
    highest."""
    body = body or (lookup.massive(names)[0] if len(lookup.massive(names)) == 1 else "")
    if begins_level(names, body, lowest=False):
        return True
    if body not in names.bodies:
        return False
    placed = names.bodies[body].start.at
    for measure in names.measures.values():
        own, _ = _signed(measure)
        if placed is None or not isinstance(own, Bearing) or own.end.body != body or own.start.body != GROUND:
            continue
        across, rise = (names.numeric(a - o) for a, o in zip(placed[1][:2], own.start.offset[:2], strict=True))
        if across is not None and rise is not None and abs(across) < _NEAR < rise:
            return True
    return False


def to_the_right(names: Names, body: str) -> list[str]:
    """The condition that the line from what something goes round to its mass centre points to the right."""
    return _conditions(names, body, 0.0)


def to_the_left(names: Names, body: str) -> list[str]:
    return _conditions(names, body, 180.0)


def lowermost(names: Names, body: str) -> list[str]:
    """The condition that what goes round a point of the ground is straight below it, or at the bottom of a curve."""
    is_led = body in names.bodies and joining.keeps_height(names, body)
    goes_round = body in lookup.turning(names) and bool(_conditions(names, body, -90.0))
    if is_led and not goes_round:  # of a cart: that is where the bob hangs
        if driving.is_driven(names):  # of a piston there is none
            return []
        body = ""
    round_ = _conditions(names, body, -90.0) or _on_curves(names, body, lowest=True)
    return round_ or _caught(names, body) or named_by_file(names, body, -1) or _swinging(names, body)


def _swinging(names: Names, body: str) -> list[str]:
    """The condition that the mass centre of what rocks, or swings, from rest is lowest, where no line tells it; in
    space, whatever it starts with: it goes round, up and down."""
    moving = lookup.massive(names)
    if moving not in ([body], [moving[0]] if moving and not body else None):
        return []
    weighs = any("gravity" in names.called.get(load, ()) for load in names.loads)
    hung = {*lookup.springs(names)} if lookup.heights(names, moving[0]) else set[str]()  # it goes up and down on them
    is_free = weighs and len({*names.loads} - hung) == 1 and not driving.is_driven(names)
    goes_round = bool(names.connections) if names.space else bool(lookup.angles(names, moving[0]))
    is_led = bool(hung) or (goes_round and not lookup.ways(names, moving[0]))
    if not is_free or not is_led or not (names.space or lookup.rests(names)):
        return []
    return [f"height of {lookup.mass_center_of(names, moving[0])} is least"]


def named_by_file(names: Names, body: str, sense: int) -> list[str]:
    """The condition that something has come as far down (sense -1) or up (1) as the file's own questions ask of it,
    where they say one such place alone; else as far as the only length that the file gives for no other use. What a
    spring catches, or may turn back, has none."""
    if lookup.springs(names) or lookup.elastic_strings(names):
        return []
    going = {name for name, own in (*lookup.inclined(names, body), *lookup.heights(names, body)) if own == sense}
    told = (_AT_PLACE.finditer(question) for question in names.usual_questions)
    places = [found for each in told for found in each if found["measure"] in going]
    said = dict.fromkeys(f"{one['measure']} = {one['value']}" for one in places if re.search(r"[^\W\d]", one["value"]))
    return ([*said] if len(said) == 1 else []) if said else _to_be_covered(names, body, sense)


def _to_be_covered(names: Names, body: str, sense: int) -> list[str]:
    """The condition that something has come down (sense -1) or up (1) by the only length that nothing else of the
    model has a use for."""
    spare = [name for name in names.unused if names.parameters[name].dimension == LENGTH]
    if len(spare) != 1 or names.space:
        return []
    inclined = [] if spare[0][0] in "hH" else lookup.inclined(names, body)  # a height is no way along a slope
    going = dict.fromkeys((*inclined, *lookup.heights(names, body)))
    along = [name for name, own in going if own == sense and name in names.started_at_zero]
    hung = lookup.climbed(names, body, spare[0], sense) if body in strings.hanging(names) and not going else []
    return [f"{name} = {spare[0]}" for name in along] or hung


def _caught(names: Names, body: str) -> list[str]:
    """The condition that what falls onto a spring, or into an elastic string, is caught there: it turns back."""
    catches = any(p.one_sided is not None for p in names.applied_loads)
    falling = [(name, sense) for name, sense in lookup.heights(names, body) if not lookup.rises(names, name, sense)]
    return [f"rate({name}) = 0" for name, _ in falling] if catches else []


def _on_curves(names: Names, body: str, *, lowest: bool) -> list[str]:
    """The condition that what is on a curve is where this is lowest, or highest: of a closed one, at the next such
    place on the way on which it starts."""
    found: list[str] = []
    for name, place in _level_places(names, body, lowest=lowest):
        if not place.recurs:
            found.append(f"{name} = 0")
            continue
        start, rate = _start_of(names, name), names.numeric(names.start_rates.get(name, ZERO))
        if start is not None and rate:
            turns = (start / math.pi - place.half_turns) / 2.0
            n = math.floor(turns + _NEAR) + 1 if rate > 0.0 else math.ceil(turns - _NEAR) - 1
            n_half = place.half_turns + 2 * n
            found.append(f"{name} = {'0' if n_half == 0 else f'{n_half}*pi'}".replace(" 1*pi", " pi"))
    return found


def begins_at(names: Names, body: str, *, lowest: bool) -> bool:
    """Whether the motion begins where something hangs straight down, or is lowest on its curve; or is uppermost."""
    if not lowest:
        return begins_uppermost(names, body)
    return begins_level(names, body, lowest=True) or _starts(names, body, -90.0)


def hangs_by_its_angle(names: Names, body: str) -> bool:
    """Whether the file lets a body that turns about an axle of the ground start with its mass centre straight below."""
    angle = names.bodies[body].start.angle if body in lookup.turning(names) and not names.space else None
    turned = None if angle is None else names.numeric(angle)
    arm = _arm(names, body) if turned is not None else None
    return arm is not None and abs(math.remainder(math.degrees(turned or 0.0) + arm + 90.0, 360.0)) < _NEAR


def _arm(names: Names, body: str) -> float | None:
    """The direction from the only axle of a body, of the ground or of what only moves level, to its mass centre, in the
    body [degrees]; None where there is no such axle, or none beside the mass centre."""
    pins = of_axles.axle_points(names, body, later=True) or of_axles.axle_points_on_level(names, body)
    if len(pins) != 1:
        return None
    centre = names.bodies[body].points["mass_center"]
    x, y = (names.numeric(c - p) for c, p in zip(centre, next(iter(pins)), strict=True))
    return None if x is None or y is None or math.hypot(x, y) == 0.0 else math.degrees(math.atan2(y, x))


def begins_level(names: Names, body: str, *, lowest: bool) -> bool:
    """Whether the file places something where its curve is lowest, or highest."""
    for name, place in _level_places(names, body, lowest=lowest):
        start = _start_of(names, name)
        if start is not None:
            away = start - math.pi * place.half_turns
            return abs(math.remainder(away, 2.0 * math.pi) if place.recurs else away) < _NEAR
    return False


def _start_of(names: Names, name: str) -> float | None:
    """Where the file lets a measure start."""
    placed = names.placed_at_start.get(name, ZERO if name in names.started_at_zero else None)
    return None if placed is None else names.numeric(placed)


def _level_places(names: Names, body: str, *, lowest: bool) -> list[tuple[str, LevelPlace]]:
    """The lowest, or the highest places of curves, by the named measures that tell them."""
    with names.quietly():
        joints = [spec for name, spec in names.connections.items() if _is_on(names, name, body)]
        places = [place for spec in joints for place in spec.level_places(names) if place.is_lowest == lowest]
    named = ((name, measure, place) for place in places for name, measure in names.measures.items())
    return [(name, place) for name, measure, place in named if _is_same(measure, place.measure)]


def _is_same(one: Measure, other: Measure) -> bool:
    """Whether measures are the same, whatever their direction is called."""
    if not (isinstance(one, Displacement) and isinstance(other, Displacement)):
        return one == other
    along = (one.along.body, one.along.components) == (other.along.body, other.along.components)
    return along and one.of == other.of and one.origin.offset == other.origin.offset


def _is_on(names: Names, joint: str, body: str) -> bool:
    return body in ("", joint) or body not in names.bodies or joining.touches(names, joint, body)


def upright(names: Names, body: str) -> list[str]:
    """The condition that something is vertical: it hangs, where its weight takes it down from rest; else it may be
    above as well. What starts so is meant at the start or above, who knows."""
    if _starts(names, body, -90.0):
        return []
    weighs = any("gravity" in names.called.get(load, ()) for load in names.loads)
    both = [] if weighs and not driving.is_driven(names) else _conditions(names, body, 90.0)
    return [*lowermost(names, body), *both]


def begins_hanging(names: Names, body: str) -> bool:
    """Whether the motion starts, from rest, where something hangs straight down."""
    return _starts(names, body, -90.0) and lookup.rests(names)


def begins_upright(names: Names, body: str) -> bool:
    """Whether the motion starts where something stands straight above what it goes round."""
    return _starts(names, body, 90.0)


def begins_lying(names: Names, body: str = "") -> bool:
    """Whether something that goes round starts level."""
    return any(_starts(names, body, pointing) for pointing in (0.0, 180.0))


def begins_standing(names: Names) -> bool:
    """Whether something that goes round starts straight above, or below, what it goes round."""
    return any(_starts(names, "", pointing) for pointing in (90.0, -90.0))


def level(names: Names, body: str) -> list[str]:
    """The condition that something is horizontal: from a start aslant whichever way comes first, else on the side to
    which it is pushed, or its angle counts; none for what starts so."""
    found: list[str] = []
    for going in _going(names, body):
        both = sorted(going.value(pointing) for pointing in (0.0, 180.0))
        if _starts(names, body, 0.0) or _starts(names, body, 180.0):
            continue
        start = _start_of(names, going.measure)
        if start is not None and _is_aslant(going.sense * math.degrees(start) + going.offset):
            if not _is_aslant(going.offset):  # sin(theta) or cos(theta)
                function = "cos" if _is_upright(going.offset) else "sin"
                found.append(f"{function}({going.measure}) = 0")
            continue
        rate = names.numeric(names.start_rates.get(going.measure, ZERO))
        if start is not None and rate:  # upright, and pushed to one side
            both = [math.degrees(start) + (90.0 if rate > 0.0 else -90.0)]
        found += [f"{going.measure} = {_told(value)}" for value in both[-1:] if _is_told(value)]
    return found or _lying(names, body)


def _lying(names: Names, body: str) -> list[str]:
    """The condition that a rod lies level which starts aslant and turns about no axle, where no measure tells its
    angle: on the side to which it leans, where its weight lets it fall from rest, else on that to which it turns."""
    rods = [one for one in lookup.turning(names) if names.bodies[one].solid is ROD and body in ("", one)]
    if len(rods) != 1 or names.space or _going(names, rods[0]) or lookup.angles(names, rods[0]):
        return []
    begun = names.bodies[rods[0]].start
    pointing, turns = (names.numeric(one or ZERO) for one in (begun.angle, begun.angular_velocity))
    if begun.angle is None or pointing is None or turns is None or not _is_aslant(math.degrees(pointing)):
        return []
    half_turns = pointing / math.pi
    if turns:
        n_half = math.ceil(half_turns) if turns > 0.0 else math.floor(half_turns)
    elif lookup.rests(names) and not driving.is_driven(names):
        n_half = round(half_turns)
    else:
        return []
    return [f"angle of {rods[0]} = {_told(180.0 * n_half)}"]


def counting_from(names: Names, angles: list[str], way: str) -> list[str]:
    """Those of some angles that are zero where what they tell of is level (way horizontal), or upright (vertical);
    all where no way is said."""
    pointing = {"horizontal": 0.0, "vertical": 90.0}.get(way)
    if pointing is None:
        return angles
    found: list[str] = []
    for angle in angles:
        told = [going.value(pointing) for going in _going(names, angle) if going.measure == angle]
        own, _ = _signed(names.measures[angle]) if angle in names.measures else (None, 1)
        if not told and isinstance(own, Angle) and (reference := names.numeric(own.reference)) is not None:
            told = [pointing - math.degrees(reference)]  # of a wheel, that of its own axis
        found += [angle] if any(abs(math.remainder(value, 180.0)) < _NEAR for value in told) else []
    return found


def _is_aslant(pointing: float) -> bool:
    """Whether a line that points so is neither level nor upright."""
    return abs(math.remainder(pointing, 90.0)) > _NEAR


def _is_upright(pointing: float) -> bool:
    return abs(math.remainder(pointing - 90.0, 180.0)) < _NEAR


def _starts(names: Names, body: str, pointing: float) -> bool:
    """Whether the motion starts where a line points so."""
    begun = (going for going in _going(names, body) if going.measure in names.started_at_zero)
    return any(abs(going.value(pointing)) < _NEAR for going in begun)


def _conditions(names: Names, body: str, pointing: float) -> list[str]:
    values = [(going.measure, going.value(pointing)) for going in _going(names, body)]
    values = [(measure, value + _turns_before(names, measure, value)) for measure, value in values]
    return [f"{measure} = {_told(value)}" for measure, value in values if _is_told(value)]


def _turns_before(names: Names, measure: str, value: float) -> float:
    """The turns after which a drive that goes on from the start comes to a pose: angles are counted on."""
    led = [row.target for row in names.constraint_rows if row.is_driven and row.measure == names.measures[measure]]
    if len(led) != 1 or led[0] is None:
        return 0.0
    start, rate = (names.numeric(substitute(one, {_TIME: ZERO})) for one in (led[0], differentiate(led[0], _TIME)))
    if start is None or not rate or _TIME in free_symbols(differentiate(led[0], _TIME)):
        return 0.0
    past = (value - math.degrees(start)) * math.copysign(1.0, rate)
    return math.copysign(360.0, rate) if past < _NEAR else 0.0


def _is_told(value: float) -> bool:
    return abs(value - round(value)) < _NEAR


def _told(value: float) -> str:
    return f"{round(value)} deg" if round(value) else "0"


def _going(names: Names, body: str) -> list[_Going]:
    return [*_on_lines(names, body), *_about_axles(names, body)]


def _on_lines(names: Names, body: str) -> list[_Going]:
    """Angles of lines to a body from the ground, or from what only moves level."""
    found: list[_Going] = []
    for name, measure in names.measures.items():
        own, sense = _signed(measure)
        if not isinstance(own, Bearing) or body not in ("", name, own.end.body):
            continue
        stands = own.start.body == GROUND or joining.keeps_height(names, own.start.body)
        if own.origin == GROUND and stands:
            reference = names.numeric(own.reference)
            found += [_Going(name, sense, math.degrees(reference))] if reference is not None else []
    return found


def _about_axles(names: Names, body: str) -> list[_Going]:
    """Angles of bodies that turn about an axle beside their mass centre, of the ground or of what only moves level."""
    found: list[_Going] = []
    for name, measure in names.measures.items():
        own, sense = _signed(measure)
        if not isinstance(own, Angle) or own.origin != GROUND or body not in ("", name, own.of):
            continue
        arm, reference = _arm(names, own.of), names.numeric(own.reference)
        if arm is not None and reference is not None:
            found.append(_Going(name, sense, math.degrees(reference) + arm))
    return found


def _signed(measure: Measure) -> tuple[Measure, int]:
    """A measure, or the one that it is the negative of, which counts clockwise."""
    if isinstance(measure, Composed) and len(measure.measures) == 1:
        [(symbol, own)] = measure.measures
        if measure.expression == -Symbol(symbol):
            return own, -1
    return measure, 1
