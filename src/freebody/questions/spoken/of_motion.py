"""Where something is, how fast it moves, and how it is accelerated, in the grammar."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.measures.distance import Distance
from freebody.measures.geometry import GROUND
from freebody.questions.spoken import along_lines, driving, farthest, joining, lookup, losing, of_axles, polar, poses
from freebody.questions.spoken.composing import ALONG, SILENT, Groups, said_of, without_owners
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names


MASS_CENTER = "mass center of system"  # which the grammar knows, and no model names
_SLOPES = {"uphill": "up", "downhill": "down"}


@said_of("velocity", "speed", "acceleration", "angular velocity", "angular acceleration")
def motion(names: Names, quantity: str, rest: Clause) -> Groups:
    """A velocity or an acceleration of a body, a point or a measure, along a direction, relative to another body."""
    if (turned := _other_way(names, rest)) is not None:  # down a slope whose line points up
        yield from ([f"-({text})" for text in group] for group in motion(names, quantity, turned))
        return
    if rest.has("part", "size"):
        without = Clause([word for word in rest.words if word != Word("part", "size")])
        yield from ([f"size of {text}" for text in group] for group in motion(names, quantity, without))
        return
    found = _directed(names, rest)
    if found is None or not rest.only("name", "part", *SILENT):
        return
    of, relative, along = found
    if len(of) > 1 or (rest.has("part", "initial", "only", "driving")):
        return
    end = f"{relative}{along}"
    if quantity == "speed" and any(before == "about" and "." in name for before, name in rest.names):
        quantity = "angular velocity"
    quantity = "velocity" if quantity == "speed" and along else quantity  # which has a sign
    if not of and rest.has("pronoun", "system"):  # which is one body, or has one angle
        whole = lookup.massive(names)
        whole = lookup.turning(names) if quantity.startswith("angular") and len(whole) > 1 else whole
        angles = lookup.angles(names, "") if quantity.startswith("angular") else []
        if len(whole) == 1 and not lookup.turning(names) and len(angles) == 1 and not end:
            yield [f"{quantity.removeprefix('angular ')} of {angles[0]}"]
        elif len(whole) == 1:
            yield [f"{quantity} of {whole[0]}{end}"]
        elif len(names.measures) == 1 and not end and names.measures.keys() <= {*lookup.places(names, "")}:
            yield [f"{quantity} of {measure}" for measure in names.measures]  # of what moves as one
        return
    if not of and quantity.startswith("angular") and not lookup.turning(names) and not end:
        yield [f"{quantity.removeprefix('angular ')} of {angle}" for angle in lookup.angles(names, "")]
        return
    if not of:
        moving = lookup.moving(names)
        if not (quantity == "speed" or along or quantity.startswith("angular")):
            moving = _with_ends(names, lookup.of_places(names)) or moving
        turned = [name for name in moving if of_axles.axle_of(names, name) == "center" and not end]
        plain = quantity.removeprefix("angular ")
        yield [
            f"angular {'velocity' if plain == 'speed' else plain} of {n}" if n in turned else f"{quantity} of {n}{end}"
            for n in moving
        ]
        return
    [name] = of
    if quantity in ("speed", "velocity") and not end and (running := polar.of_belts(names, name)):
        yield running
        return
    if name in names.loads and quantity.split()[-1] in ("velocity", "speed"):  # of the motor: of what it drives
        acted = {body for p in names.applied_loads if p.load == name for body in p.measure.bodies()} - {GROUND}
        name = next(iter(acted)) if len(acted) == 1 else name
        quantity = "angular velocity" if of_axles.axle_of(names, name) == "center" else quantity
    carrier = along.removeprefix(" along ")
    if quantity == "velocity" and not relative and carrier in lookup.moving(names) and name != carrier:
        own = [m for m in lookup.places(names, name) if along_lines.is_along(names, m, carrier)]
        yield [f"rate of {m}" for m in own] or [f"{quantity} of {name} relative to {carrier}"]  # of what goes along it
        return
    axle = of_axles.axle_of(names, name) if not end and not quantity.startswith("angular") else ""
    if quantity == "speed" and axle:  # what turns about its centre has no other speed
        yield [f"angular velocity of {name}", *([f"speed of {name}"] if axle == "beside" else [])]
        return
    if quantity == "acceleration" and axle == "center":
        yield [f"angular acceleration of {name}"]
        return
    if quantity.startswith("angular") and name in names.bodies and not names.bodies[name].turns and not end:
        yield [f"{quantity.removeprefix('angular ')} of {angle}" for angle in lookup.hung(names, name)]
    if (
        quantity.startswith("angular") and not end
    ):  # of a rod without mass: of the line from one of its ends to the other
        yield [f"{quantity.removeprefix('angular ')} of {angle}" for angle in joining.turned_with(names, name)]
    yield [f"{quantity} of {name}{end}"]
    is_measure = name in names.measures and name not in names.bodies
    if relative and not along and is_measure and quantity in ("velocity", "acceleration"):  # along the same line
        other = relative.removeprefix(" relative to ")
        yield [f"{quantity} of {a} - {quantity} of {b}" for a, b in lookup.alike(names, name, other)]
    if quantity == "speed":
        yield [f"|velocity of {name}|"] if not end else []
    if quantity.startswith("angular "):
        yield [f"{quantity.removeprefix('angular ')} of {name}{end}"] if name in names.measures else []
    elif name in names.bodies and quantity != "speed":
        yield [f"{quantity} of {name}{end}"]


def _with_ends(names: Names, measures: list[str]) -> list[str]:
    """Measures, and for a distance what moves at its ends: its rate is only what its velocity has along the line."""
    found: list[str] = []
    for name in measures:
        measure = names.measures.get(name)
        ends = {*measure.bodies()} - {GROUND} if isinstance(measure, Distance) else set[str]()
        found += sorted(ends & {*lookup.massive(names)}) or [name]
    return list(dict.fromkeys(found))


@said_of("tangential acceleration", "normal acceleration", "radius of curvature")
def along_the_path(names: Names, quantity: str, rest: Clause) -> Groups:
    """What a point has along its path: of the one that is named, or of each that moves."""
    if rest.only("name", *SILENT) and len(rest.names) <= 1:
        of = [name for _, name in rest.names] or lookup.massive(names)
        if quantity == "radius of curvature" and any("cam" in names.called.get(name, ()) for name in of):
            yield [f"{quantity} of {name}" for name in of]  # of its edge
            return
        yield [f"{quantity} of {'the path of ' if quantity == 'radius of curvature' else ''}{name}" for name in of]


def _other_way(names: Names, rest: Clause) -> Clause | None:
    """The words with the other way along the only slope or a line, where that does not point the way that is said."""
    ways = rest.all("updown")
    if len(ways) == 1 and not rest.has("part") and _directed(names, rest) is None:
        other = {"up": "down", "down": "up"}[ways[0]]
        turned = Clause([Word("updown", other) if word.kind == "updown" else word for word in rest.words])
        return turned if _directed(names, turned) is not None else None
    line = joining.sloping(names)
    said = [part for part in rest.all("part") if part in _SLOPES]
    if len(said) != 1 or not line or joining.points(names, line, _SLOPES[said[0]]):
        return None
    other = {"uphill": "downhill", "downhill": "uphill"}[said[0]]
    return Clause([Word("part", other) if word == Word("part", said[0]) else word for word in rest.words])


def _directed(names: Names, rest: Clause) -> tuple[list[str], str, str] | None:
    """What a clause names: things, `relative to` which, `along` which direction; None where these contradict."""
    of: list[str] = []
    relative, along = "", ""
    is_said = len(rest.names) > 1 or not names.connections.keys() & {name for _, name in rest.names}
    for before, name in rest.names:  # of the guide alone: of what is guided
        line = joining.direction(names, name)
        if before in ("", "of") and (point := joining.riding(names, name)):
            of.append(point)
            continue
        is_line = line is not None
        if before == "relative" and not is_line and not relative:
            relative = f" relative to {name}"
        elif before == "about" and "." in name and not lookup.is_known_point(names, name) and not along:
            along = f" along {name}"
        elif before == "in" and names.space and name in names.bodies and of and not relative:
            relative = f" in {name}"  # by its components there
        elif before in ("along", "up", "down") or (
            is_line and before in ("on", "in", "of", "from", "over") and not along and (before != "of" or is_said)
        ):
            if along or (before in ("up", "down") and not joining.points(names, line or name, before)):
                return None
            along = f" along {line or name}"
        else:
            of.append(name)
    named = [before for before, _ in rest.names]
    dangling = [way for way in rest.all("updown") if way not in named]  # it moves up
    for part in (part for part in rest.all("part") if part in _SLOPES):
        line = joining.sloping(names)
        if along or not line or not joining.points(names, line, _SLOPES[part]):
            return None
        along = f" along {line}"
    for part in (*rest.all("part"), *dangling):
        if part in ALONG:
            if along:
                return None
            along = f" along {ALONG[part]}"
    of = [joining.joined_at(names, name) for name in without_owners(of)]
    owned = {body for name in of if name in names.measures for body in names.measures[name].bodies()}
    of = [name for name in of if name not in owned]
    return of, relative, along


@said_of("relative velocity")
def _relative(names: Names, quantity: str, rest: Clause) -> Groups:
    """The velocity of one thing less that of another: of points, or along a line on which both are measured."""
    of = [name for _, name in rest.names]
    if rest.only("name", *SILENT) and len(of) == 2:
        yield [f"velocity of {of[0]} relative to {of[1]}"] if all(one in names.bodies for one in of) else []
        yield [f"(velocity of {one} - velocity of {other})" for one, other in lookup.alike(names, of[0], of[1])]


@said_of("closing speed")
def _closing(names: Names, quantity: str, rest: Clause) -> Groups:
    """How fast two things come nearer to each other: both that are named, or the only two that move."""
    of = [name for _, name in rest.names] or lookup.massive(names)
    if rest.only("name", *SILENT) and len(of) == 2 and {*of} <= {*names.bodies}:
        yield [f"-(velocity of distance from {of[0]} to {of[1]})"]


@said_of("common speed")
def _common(names: Names, quantity: str, rest: Clause) -> Groups:
    """The speed of what a clutch, or a blow, has joined: of one of the bodies, for it is that of all."""
    if not rest.only("name", *SILENT):
        return
    joints = losing.clutches(names)
    if joints and len(joints) == 1:
        taken = sorted(names.connections[joints[0]].mentions(names) & {*lookup.turning(names)})
        yield [f"angular velocity of {taken[-1]}"] if taken else []
        return
    joined = (*names.struck_at_start, *names.closing_later, *losing.taking_along(names))
    struck = [name for name in joined if name in names.connections]
    bodies = [body for joint in struck for body in lookup.massive(names) if joining.touches(names, joint, body)]
    led = [body for body in bodies if any(body in own for own, _ in joining.led_round(names))]
    measured = [*motion(names, "velocity", rest)]
    named = [[text for text in group if text.rpartition(" ")[2] in names.measures] for group in measured]
    yield from (group[:1] for group in named if len(group) == 1 or len(bodies) == len(group))
    yield [f"speed of {body}" for body in (led or bodies)[:1]]
    yield from measured


@said_of("deceleration", "angular deceleration")
def _slowing(names: Names, quantity: str, rest: Clause) -> Groups:
    """How strongly something is slowed down: its acceleration against the way in which it sets out, the size of that
    where the way is not known."""
    of = [name for _, name in rest.names]
    who = next(iter(of), "")
    turns = quantity.startswith("angular") or of_axles.axle_of(names, who) == "center"
    if rest.only("name", *SILENT) and len(of) <= 1:
        measures = lookup.angles(names, who) if turns else lookup.places(names, who)
        yield [_slowing_of(names, measure) for measure in measures]
        alone = [who] if who in names.bodies else lookup.massive(names)
        yield [f"|acceleration of {alone[0]}|"] if not (measures or turns) and len(alone) == 1 else []
        yield [f"|angular acceleration of {who}|"] if turns and who in names.bodies else []


def _slowing_of(names: Names, measure: str) -> str:
    if lookup.rises(names, measure, 1):
        return f"-acceleration of {measure}"
    return f"acceleration of {measure}" if lookup.rises(names, measure, -1) else f"|acceleration of {measure}|"


def slowed_most(names: Names, quantity: str, rest: Clause) -> Groups:
    """The greatest deceleration over a motion: against the way in which it sets out, for speeding up is none; of what
    is driven to and fro, against the way in which it goes. What may set out either way is refused."""
    of = [name for _, name in rest.names]
    who = next(iter(of), "")
    if driving.driven(names) and rest.only("name", *SILENT) and who in lookup.moving(names) and len(of) == 1:
        yield [f"greatest -tangential acceleration of {who}"] if not quantity.startswith("angular") else []
    if driving.driven(names) or not rest.only("name", *SILENT) or len(of) > 1:
        return
    turns = quantity.startswith("angular") or of_axles.axle_of(names, who) == "center"
    sloping = dict(lookup.inclined(names, who))
    for way in lookup.angles(names, who) if turns else lookup.places(names, who):
        falls = -sloping.get(way, 0) if names.lets_go_from_rest and not lookup.driving(names) else 0
        if falls > 0 or lookup.rises(names, way, 1):
            yield [f"greatest -acceleration of {way}"]
        elif falls < 0 or lookup.rises(names, way, -1):
            yield [f"greatest acceleration of {way}"]


@said_of("position")
def _position(names: Names, quantity: str, rest: Clause) -> Groups:
    found = _directed(names, rest)
    if found is None or not rest.only("name", "part", *SILENT) or len(found[0]) > 1 or found[1]:
        return
    of, _, along = found
    name = next(iter(of), "")
    if name == MASS_CENTER or name.endswith(".mass_center") or (along and name):
        yield [f"position of {name}{along}"]
    elif name and not lookup.places(names, name) and not lookup.angles(names, name):
        yield [f"position of {name} along {guide}" for guide in joining.guides(names, name)]
    elif not along:
        yield lookup.places(names, name)
        yield lookup.angles(names, name)


@said_of("horizontal range", "flight time")
def _of_flight(names: Names, quantity: str, rest: Clause) -> Groups:
    """How far something comes sideways, or how long it takes, until it is as low as at the start, or lands."""
    named = [name for _, name in rest.names if name != GROUND and name not in names.bodies[GROUND].lines]
    of = next(iter(named), "")
    if rest.only("name", *SILENT) and len(named) <= 1 and (not of or of in lookup.moving(names)):
        is_far = quantity == "horizontal range"
        heads = lookup.level(names, of) if is_far else ["time"]
        flying = [] if names.space else lookup.flying(names, of)
        heads = heads if flying or lookup.flies(names, of) else []
        heads = heads or [f"x of {name}" for name in flying if is_far]
        yield [f"{head} when it lands" for head in heads] if joining.strikes(names) else []
        aside = is_far and any(lookup.starts_aside(names, name) for name in flying)
        told = "change of {} until" if aside else "{} when"
        yield [f"{told.format(head)} {height} = 0" for head in heads for height in lookup.falling(names, of)]


@said_of("equation of motion")
def _equation_of_motion(names: Names, quantity: str, rest: Clause) -> Groups:
    """The acceleration of what is measured of something, or of all that the file starts with."""
    of = next((name for _, name in rest.names), "")
    if rest.only("name", *SILENT) and len(rest.names) <= 1:
        own = [*lookup.places(names, of), *lookup.angles(names, of), *lookup.hung(names, of)]
        own = list(dict.fromkeys(own if of else names.measures))
        started = [name for name in own if name in names.start_rates]
        yield [f"acceleration of {name}" for name in started or own]
        turning = [name for name in ([of] if of else lookup.moving(names)) if name in lookup.turning(names)]
        yield [f"angular acceleration of {name}" for name in turning]


@said_of("farthest place")
def _farthest(names: Names, quantity: str, rest: Clause) -> Groups:
    """Where what moves along a line turns back."""
    of = [name for _, name in rest.names if name in lookup.moving(names) or name in names.measures]
    if rest.only("name", *SILENT) and len(of) <= 1 and not lookup.rests(names):
        yield [f"{way} when rate({way}) = 0" for way in lookup.ways(names, next(iter(of), ""))]


_HEADINGS = {
    "angle of descent": "angle of velocity of {} below the horizontal",
    "angle to the horizontal": "angle of velocity of {} to the horizontal",
    "direction of motion": "direction of velocity of {}",
}


@said_of(*_HEADINGS)
def _heading(names: Names, quantity: str, rest: Clause) -> Groups:
    """Where the velocity of a body points; below the horizontal, where it comes down."""
    of = [name for _, name in rest.names if name in lookup.massive(names)]
    if rest.only("name", *SILENT) and len(of) == len(rest.names) <= 1:
        bodies = of or lookup.massive(names)
        yield [_HEADINGS[quantity].format(body) for body in bodies]


@said_of("Coriolis acceleration")
def _coriolis(names: Names, quantity: str, rest: Clause) -> Groups:
    size = "size of " * rest.has("part", "size")
    rest = rest.without("part", "size")
    found = _directed(names, rest)
    if found is not None and rest.only("name", *SILENT) and len(found[0]) <= 1:
        of, relative, along = found
        riding = [point for joint in names.connections if (point := joining.riding(names, joint))]
        yield [f"{size}Coriolis acceleration of {point}{relative}{along}" for point in of or dict.fromkeys(riding)]


@said_of("bounce height")
def _bounce(names: Names, quantity: str, rest: Clause) -> Groups:
    """How high it comes when it turns back after it has struck for the first time."""
    of = [name for _, name in rest.names if name in lookup.moving(names)]
    if rest.only("name", "degree", *SILENT) and joining.strikes(names) and len(of) <= 1:
        falls = [name for name, sense in lookup.heights(names, next(iter(of), "")) if sense > 0]
        falls = [name for name in falls if not lookup.rises(names, name, 1)]
        yield [f"{name} when rate({name}) = 0" for name in falls]


@said_of("centripetal acceleration")
def _centripetal(names: Names, quantity: str, rest: Clause) -> Groups:
    """v^2/l towards the point of the ground about which a link leads a body."""
    of = [name for _, name in rest.names]
    if rest.only("name", *SILENT) and len(of) <= 1:
        led = [(body, length) for body, length in joining.led_round(names) if not of or body == of[0]]
        divisors = [(body, length if length.isidentifier() else f"({length})") for body, length in led]
        yield [f"(speed of {body})^2/{length}" for body, length in divisors]


@said_of("deflection")
def _deflection(names: Names, quantity: str, rest: Clause) -> Groups:
    """How far a spring is compressed or stretched: what its force is in proportion to."""
    of = [name for _, name in rest.names]
    if rest.only("name", *SILENT) and len(of) <= 1:
        yield lookup.deflections(names, next(iter(of), ""))


@said_of("displacement", "distance travelled")
def _displacement(names: Names, quantity: str, rest: Clause) -> Groups:
    of = [name for _, name in rest.names]
    who = next(iter(of), "")
    if quantity == "distance travelled":  # which is longer where the way turns back: until when has to be said
        return
    if rest.only("name", *SILENT) and len(of) <= 1 and (who in names.measures or not lookup.is_free(names, who)):
        yield lookup.ways(names, who)


@said_of("angle")
def _angle(names: Names, quantity: str, rest: Clause) -> Groups:
    found = _directed(names, rest)
    if found is None or not rest.only("name", *SILENT) or len(found[0]) > 1 or found[2]:
        return
    of, relative, _ = found
    name = next(iter(of), "")
    if not relative:
        yield lookup.angles(names, name)
    yield [f"angle of {name}{relative}"] if name else []


@said_of("angle from the vertical", "angle from the horizontal")
def _inclination(names: Names, quantity: str, rest: Clause) -> Groups:
    """An angle by the measure that counts from there."""
    of = [name for _, name in rest.names if name != GROUND]
    if rest.only("name", *SILENT) and len(of) <= 1:
        way = quantity.rpartition(" ")[2]
        yield poses.counting_from(names, lookup.angles(names, next(iter(of), "")), way)


@said_of("height")
def _height(names: Names, quantity: str, rest: Clause) -> Groups:
    of = [name for _, name in rest.names if name != GROUND]
    if rest.only("name", *SILENT) and len(of) <= 1:
        name = next(iter(of), "")
        of_points = lookup.heights_of_points(names, name)  # that of its upper end may be meant as well
        yield [*(f"height of {body}" for body in ([name] if name else lookup.moving(names))), *of_points]
        yield [height for height, sense in lookup.heights(names, name) if sense > 0]


@said_of("depth")
def _depth(names: Names, quantity: str, rest: Clause) -> Groups:
    """How far something is below, by what measures it downwards."""
    of = [name for _, name in rest.names if name != GROUND]
    below = [name for name in of if name.startswith(f"{GROUND}.")]
    of = [name for name in of if name not in below]
    if rest.only("name", *SILENT) and len(of) <= 1 >= len(below):
        found = [name for name, sense in lookup.heights(names, next(iter(of), "")) if sense < 0]
        origins = {name: str(getattr(names.measures[name], "origin", "")) for name in found}
        yield [name for name in found if not below or origins[name] == below[0]]


@said_of("highest place", "lowest place")
def _extreme_place(names: Names, quantity: str, rest: Clause) -> Groups:
    """How high or how low something comes, by the height that is measured."""
    of = [name for _, name in rest.names if name != GROUND and name not in names.bodies[GROUND].lines]
    if rest.only("name", *SILENT) and len(of) <= 1:
        up, found = quantity == "highest place", lookup.heights(names, next(iter(of), ""))
        if up and of and not found and (risen := farthest.risen_from_below(names, of[0])):
            yield risen  # of what hangs at the start
            return
        yield [f"{'greatest' if (sense > 0) == up else 'least'} {name}" for name, sense in found]
        yield [f"{'greatest' if up else 'least'} height of {name}" for name in of if not found]


@said_of("distance")
def _distance(names: Names, quantity: str, rest: Clause) -> Groups:
    of = [name for _, name in rest.names]
    if len(of) == 2 and rest.only("name", *SILENT):
        yield [f"distance from {of[0]} to {of[1]}"]
    elif len(of) < 2 and rest.only("name", *SILENT):  # from the sun: of what the file measures it
        measured = {name: m for name, m in names.measures.items() if isinstance(m, Distance)}
        yield [name for name, m in measured.items() if not of or of[0] in (m.start.name, m.end.name)]
