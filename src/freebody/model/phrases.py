"""The phrases in which measures are stated, e.g. `drop of left below ground.axle`.

Each phrase is one pattern and one reader; the table is also what error messages and documentation list.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, cast

from freebody.errors import ExpressionError, UnitError
from freebody.language.expression import Call, Expr, Number, Symbol, children, free_symbols, number
from freebody.language.notation import to_python
from freebody.language.sentences import Message, as_found
from freebody.language.units import DIMENSIONLESS, dimension_of
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination, Composed
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Bearing, Distance
from freebody.measures.geometry import AXES, GROUND, ONE, RIGHT, UP, ZERO, Direction, Point
from freebody.measures.turn import Alignment, Turn
from freebody.model.elements import Attitude
from freebody.model.names import Names
from freebody.model.noting import did_you_mean
from freebody.model.rotations import perpendiculars
from freebody.model.surfaces import SurfacePlace, from_axis

Path = tuple[str | int, ...]
Found = dict[str, str | None]


@dataclass(frozen=True)
class MeasurePhrase:
    """One way to state a measure. example: the smallest model with such a measure; the docstring of `read` says what it
    is. Documentation shows both."""

    form: str
    pattern: re.Pattern[str]
    read: Callable[[Names, Found, Path], Measure]
    example: str


_POINT = r"[A-Za-z_]\w*(?:\.\w+)?"
PHRASES: list[MeasurePhrase] = []


def _phrase(
    form: str, pattern: str, example: str
) -> Callable[[Callable[[Names, Found, Path], Measure]], Callable[[Names, Found, Path], Measure]]:
    def register(
        read: Callable[[Names, Found, Path], Measure],
    ) -> Callable[[Names, Found, Path], Measure]:
        PHRASES.append(MeasurePhrase(form, re.compile(rf"^(?:{pattern})$"), read, example))
        return read

    return register


def _origin(names: Names, text: str | None, path: Path) -> Point:
    return names.ground_origin if text is None else names.point(text, *path)


@_phrase(
    "drop of POINT [below POINT]",
    rf"drop of (?P<of>{_POINT})(?: (?:below|from) (?P<origin>{_POINT}))?",
    """
bodies: {ball: {particle: {mass: 1 kg}}}
measures: {s: drop of ball below ground.A}
""",
)
def _drop(names: Names, found: Found, path: Path) -> Measure:
    """How far a point is below another one, else below the origin of the ground; it grows as the point sinks."""
    return Displacement(names.point(found["of"], *path), _origin(names, found["origin"], path), names.compass["down"])


@_phrase(
    "height of POINT [above POINT]",
    rf"height of (?P<of>{_POINT})(?: (?:above|over) (?P<origin>{_POINT}))?",
    """
bodies: {ball: {particle: {mass: 1 kg}}}
measures: {h: height of ball above ground.A}
""",
)
def _height(names: Names, found: Found, path: Path) -> Measure:
    """How far a point is above another one, else above the origin of the ground."""
    return Displacement(names.point(found["of"], *path), _origin(names, found["origin"], path), names.compass["up"])


@_phrase(
    "x of POINT [from POINT]",
    rf"(?P<axis>[xyz]) of (?P<of>{_POINT})(?: from (?P<origin>{_POINT}))?",
    """
bodies: {ball: {particle: {mass: 1 kg}}}
measures: {x: x of ball}
""",
)
def _coordinate(names: Names, found: Found, path: Path) -> Measure:
    """A coordinate of a point along x, y or (in space) z of the ground, from another point, else from the origin."""
    name = found["axis"] or "x"
    if name not in names.compass:
        names.problem(Message("there is no z in the plane; for a model in space write space: true"), *path)
        name = "x"
    axis = {"x": RIGHT, "y": UP}.get(name, names.compass[name])
    return Displacement(names.point(found["of"], *path), _origin(names, found["origin"], path), axis)


@_phrase(
    "travel of POINT along DIRECTION [from POINT]",
    rf"(?:travel|displacement|position) of (?P<of>{_POINT}) along (?P<along>.+?)(?: from (?P<origin>{_POINT}))?",
    """
ground: {lines: {incline: {along: -30 deg}}}
bodies: {ball: {particle: {mass: 1 kg}}}
measures: {s: travel of ball along incline}
""",
)
def _travel(names: Names, found: Found, path: Path) -> Measure:
    """How far a point is along a direction, which may be one of a body, from another point, else from the origin."""
    along = names.direction(found["along"], *path)
    return Displacement(names.point(found["of"], *path), _origin(names, found["origin"], path), along)


@_phrase(
    "parameter of CONNECTION",
    r"parameter of (?P<of>[A-Za-z_]\w*)",
    """
bodies: {bead: {particle: {mass: 1 kg}}}
parameters: {R: 1 m}
connections: {wire: {curved_rail: {point: bead, x: R*(s + sin(s)), y: R*(1 - cos(s))}}}
measures: {s: parameter of wire}
""",
)
def _parameter(names: Names, found: Found, path: Path) -> Measure:
    """The parameter s of a curve where a point or the contact of a body is on it."""
    connection = names.connections.get(cast("str", found["of"]))
    with names.quietly():
        place = None if connection is None else connection.curve_place(names)
    if place is None:
        told = Message("{name} is no rail along a curve in a parameter, x: ..., y: ... in s", name=found["of"])
        names.unknown(cast("str", found["of"]), told, *path)
        return Displacement(names.ground_origin, names.ground_origin, RIGHT)
    return place.parameter


@_phrase(
    "axis distance|azimuth of CONNECTION",
    r"(?P<which>axis distance|azimuth) of (?P<of>[A-Za-z_]\w*)",
    """
space: {up: z}
parameters: {k: 1 1/m, r: 0.1 m}
bodies: {ball: {sphere: {mass: 1 kg, radius: r}, near: {at: [0.3 m, 0, 0.2 m]}}}
connections: {bowl: {rolling_on_surface: {body: ball, z: k*rho^2}}}
measures: {rho: axis distance of bowl}
""",
)
def _of_contact(names: Names, found: Found, path: Path) -> Measure:
    """Where a sphere touches the surface on which it rolls: how far from the axis of that, and at which angle round it,
    counted from x towards y."""
    connection = names.connections.get(cast("str", found["of"]))
    with names.quietly():
        place = None if connection is None else connection.foot(names)
    if not isinstance(place, SurfacePlace):
        told = Message("{name} is no surface z = f(x, y) on which a sphere rolls", name=found["of"])
        names.unknown(cast("str", found["of"]), told, *path)
        return Displacement(names.ground_origin, names.ground_origin, RIGHT)
    return place.polar[found["which"] == "azimuth"]


@_phrase(
    "distance from POINT to POINT",
    rf"distance (?:(?:from|of) (?P<start>{_POINT}) (?:to|from)|(?:of|between) (?P<one>{_POINT}) and) (?P<end>{_POINT})",
    """
bodies: {a: {particle: {mass: 1 kg}}, b: {particle: {mass: 1 kg}, at: [1 m, 0]}}
measures: {d: distance from a to b}
""",
)
def _distance(names: Names, found: Found, path: Path) -> Measure:
    """The distance between two points, never negative."""
    return Distance(names.point(found["start"] or found["one"], *path), names.point(found["end"], *path))


@_phrase(
    "distance of POINT from the x|y|z axis",
    rf"distance of (?P<of>{_POINT}) from the (?P<axis>[xyz]) axis",
    """
space: true
bodies: {ball: {particle: {mass: 1 kg}, at: [0.3 m, 0.4 m, 0]}}
measures: {rho: distance of ball from the z axis}
""",
)
def _from_axis(names: Names, found: Found, path: Path) -> Measure:
    """In space: how far a point is from an axis of the ground through the origin, never negative."""
    if not names.space:
        names.problem(Message("the distance from an axis is for models in space: write space: true"), *path)
    k = "xyz".index(found["axis"] or "z")
    turned = (AXES[(k + 1) % 3], AXES[(k + 2) % 3], AXES[k])
    return from_axis(names.point(found["of"], *path), names.ground_origin, turned)


def _clockwise(measure: Measure, clockwise: str | None) -> Measure:
    """An angle counted clockwise is the negative of the measure."""
    if clockwise is None:
        return measure
    return Composed(number(-1) * Symbol("angle"), (("angle", measure),), DIMENSIONLESS)


def direction_angle(direction: Direction) -> Expr:
    """The angle of a direction from the x axis of its body."""
    x, y, *_ = direction.components  # in space the plane of x and y is meant
    if isinstance(x, Call) and x.function == "cos" and isinstance(y, Call) and y.argument == x.argument:
        return x.argument
    quarter = {(1, 0): 0, (0, 1): 1, (-1, 0): 2, (0, -1): -1}
    if isinstance(x, Number) and isinstance(y, Number) and (int(x.value), int(y.value)) in quarter:
        return Symbol("pi") * number(quarter[int(x.value), int(y.value)]) / 2
    # atan2 by the half angle; fails only against the x axis, where [-1, 0] is written `left`
    return 2 * Call("atan", y / (Call("sqrt", x * x + y * y) + x))


@_phrase(
    "angle of line from POINT to POINT [from DIRECTION] [clockwise]",
    rf"angle of (?:the )?line from (?P<start>{_POINT}) to (?P<end>{_POINT})"
    r"(?P<cw1> clockwise(?= from ))?(?: from (?P<ref>.+?))?(?P<cw> clockwise)?",
    """
bodies: {ball: {particle: {mass: 1 kg}}}
measures: {theta: angle of line from ground.O to ball from down}
""",
)
def _bearing(names: Names, found: Found, path: Path) -> Measure:
    """The angle of the line from one point to another, counter-clockwise from a direction (else from `right`)."""
    ref = RIGHT if found["ref"] is None else names.direction(found["ref"], *path)
    start, end = names.point(found["start"], *path), names.point(found["end"], *path)
    return _of_line(start, end, ref, found["cw"] or found["cw1"])


def _of_line(start: Point, end: Point, ref: Direction, clockwise: str | None) -> Measure:
    if len(ref.components) > 2 and ref.components[2] != number(0):
        return _inclination(start, end, ref)
    return _clockwise(Bearing(start, end, ref.body, direction_angle(ref)), clockwise)


def _line_of(names: Names, name: str) -> tuple[Point, Point] | None:
    """The line of a connection that is straight, from the ground on."""
    if name in names.bodies or name not in names.connections:
        return None
    ends = names.connections[name].straight_between(names)
    return ends if ends is None or ends[1].body != GROUND else (ends[1], ends[0])


def _inclination(start: Point, end: Point, ref: Direction) -> Measure:
    """The angle between a line in space and a direction out of the plane of x and y, from 0 to 180 degrees: no sense of
    turning is told apart there."""
    share = Symbol("along") / Symbol("length")
    parts = ("along", Displacement(end, start, ref)), ("length", Distance(start, end))
    return Composed(Call("acos", share), parts, DIMENSIONLESS)


@_phrase(
    "angle of BODY about DIRECTION [relative to BODY]",
    r"(?:angle|turn) of (?P<of>[A-Za-z_]\w*) about (?P<axis>.+?)(?: (?:relative to|against) (?P<rel>[A-Za-z_]\w*))?",
    """
space: true
bodies: {wheel: {disk: {mass: 1 kg, radius: 0.2 m, axis: x}}}
connections: {axle: {revolute: {first: ground.O, second: wheel, about: x}}}
measures: {psi: angle of wheel about x}
""",
)
def _turn(names: Names, found: Found, path: Path) -> Measure:
    """In space: how far a body has turned about an axis of the ground or of another body, relative to which it is then
    meant where nothing else is said, by the right-hand rule."""
    body, base = names.body(cast("str", found["of"]), *path), names.body(found["rel"] or GROUND, *path)
    if not names.space:
        names.problem(Message("an angle about an axis is for models in space: write space: true"), *path)
        return Angle(body.name, base.name)
    axis = names.direction(found["axis"], *path, body=base.name)
    if found["rel"] is None and axis.body != body.name:
        base = names.known(axis.body)
    if axis.body not in (body.name, base.name):
        names.problem(
            Message(
                "the axis is fixed in {owner}; it must be in {base} or {body}",
                owner=axis.body,
                base=base.name,
                body=body.name,
            ),
            *path,
        )
    return _of_joint(names, body.name, base.name, axis) or _about(body.name, base.name, axis)


def _of_joint(names: Names, body: str, base: str, axis: Direction) -> Measure | None:
    """The angle of the joint between two bodies, if it turns about that axis; it counts from where the joint is at
    zero."""
    joints = (joint for joint in _hinges(names, body, base) if joint.before[2] == axis.components)
    return next((joint.turns[0][2] for joint in joints), None) if axis.body == base else None


def _out_of_plane(names: Names, body: str, base: str | None) -> Measure | None:
    """The angle of the one joint in space about which a body turns against another (any, if none is named), if that is
    not about z."""
    joints = list(_hinges(names, body, base)) if names.space else []
    plain = all(joint.before[2][:2] == (ZERO, ZERO) for joint in joints)
    return None if plain or len(joints) != 1 else joints[0].turns[0][2]


def _hinges(names: Names, body: str, base: str | None) -> Iterator[Attitude]:
    """What joins a body to another one (any, if none is named) so that it turns against that about one axis."""
    both = {body} if base is None else {body, base}
    for connection in names.connections.values():
        with names.quietly():  # of a connection they are told where it stands
            joint = connection.attitude(names) if both <= connection.mentions(names) | {GROUND} else None
        if joint is None or joint.second != body or base not in (None, joint.first) or len(joint.turns) != 1:
            continue
        if joint.turns[0][0] == (ZERO, ZERO, ONE):
            yield joint


def _about(body: str, base: str, axis: Direction) -> Measure:
    """How far a body has turned about an axis from where it stands parallel to another one."""
    b, c = perpendiculars(axis.components)
    return Turn(Direction(body, b), Direction(base, b), Direction(base, c))


@_phrase(
    "angle between DIRECTION and DIRECTION",
    r"angle between (?P<one>.+?) and (?P<other>.+)",
    """
space: true
bodies: {top: {body: {mass: 1 kg, inertia: [1 kg m^2, 1 kg m^2, 2 kg m^2]}}}
measures: {theta: angle between top.z and up}
""",
)
def _between(names: Names, found: Found, path: Path) -> Measure:
    """The angle between two directions, from 0 to 180 degrees."""
    one, other = names.direction(found["one"], *path), names.direction(found["other"], *path)
    return Composed(Call("acos", Symbol("c")), (("c", Alignment(one, other)),), DIMENSIONLESS)


@_phrase(
    "alignment of DIRECTION and DIRECTION",
    r"alignment of (?P<one>.+?) (?:and|with) (?P<other>.+)",
    """
space: true
bodies: {top: {body: {mass: 1 kg, inertia: [1 kg m^2, 1 kg m^2, 2 kg m^2]}}}
measures: {c: alignment of top.z and up}
""",
)
def _alignment(names: Names, found: Found, path: Path) -> Measure:
    """The cosine of the angle between two directions."""
    return Alignment(names.direction(found["one"], *path), names.direction(found["other"], *path))


@_phrase(
    "angle of BODY | of LINK [from DIRECTION | relative to BODY] [clockwise]",
    r"(?P<cw1>clockwise )?angle of (?P<of>[A-Za-z_]\w*)(?P<cw2> clockwise(?= from | relative to | against ))?"
    r"(?: from (?P<ref>.+?)| (?:relative to|against) (?P<rel>[A-Za-z_]\w*))?(?P<cw> clockwise)?",
    """
bodies: {rod: {rod: {mass: 1 kg, length: 1 m}}}
measures: {theta: angle of rod from down}
""",
)
def _angle(names: Names, found: Found, path: Path) -> Measure:
    """The angle of the x axis of a body, counter-clockwise from a direction (else from `right`), or from the x axis of
    another body. In space it is the angle of the one joint about whose axis the body turns, if that is not z. That of a
    link, or of a string between two points, is that of its line, from what stands to what moves."""
    if (line := _line_of(names, cast("str", found["of"]))) is not None and found["rel"] is None:
        clockwise = found["cw"] or found["cw1"] or found["cw2"]
        return _of_line(*line, RIGHT if found["ref"] is None else names.direction(found["ref"], *path), clockwise)
    body = names.body(cast("str", found["of"]), *path)
    if not body.turns:
        told = Message(
            "{body} is a particle and has no angle; write angle of line from ground.O to {body}", body=body.name
        )
        names.problem(told, *path)
    clockwise = found["cw"] or found["cw1"] or found["cw2"]
    base = None if found["rel"] is None else names.body(found["rel"], *path).name
    if found["ref"] is None and (turned := _out_of_plane(names, body.name, base)) is not None:
        return _clockwise(turned, clockwise)
    if found["rel"] is not None:
        return _clockwise(Angle(body.name, names.body(found["rel"], *path).name), clockwise)
    ref = RIGHT if found["ref"] is None else names.direction(found["ref"], *path)
    return _clockwise(Angle(body.name, ref.body, direction_angle(ref)), clockwise)


def phrase_text(value: Any) -> str | None:
    """The phrase in `text`, or in `{text}`, which YAML reads as a mapping with an empty value."""
    if isinstance(value, str):
        return " ".join(value.split())
    if isinstance(value, dict):
        items = list(cast("dict[Any, Any]", value).items())
        if len(items) == 1 and items[0][1] is None and isinstance(items[0][0], str):
            return " ".join(items[0][0].split())
    return None


def measure_of(names: Names, name: Any, *path: str | int) -> Measure | None:
    """A named measure, or a phrase that states one."""
    if isinstance(name, str) and name.strip() in names.measures:
        return names.measures[name.strip()]
    return read_measure(names, name, *path)


# what programs write behind a body and a dot
_OF_A_BODY = {"x": "x", "y": "y", "z": "z", **dict.fromkeys(("angle", "theta", "phi"), "angle")}


def read_measure(names: Names, value: Any, *path: str | int) -> Measure | None:
    """The measure that a phrase, a name or `{expression: ...}` states; None after noting a problem."""
    text = phrase_text(value)
    if text is None:
        if isinstance(value, dict) and set(cast("dict[str, Any]", value)) == {"expression"}:
            return composed(names, str(cast("dict[str, Any]", value)["expression"]), *path, "expression")
        names.problem(
            Message("expected a phrase such as 'height of A', found {value}", value=as_found(cast("object", value))),
            *path,
        )
        return None
    if text in names.measures:
        return names.measures[text]
    for phrase in PHRASES:
        found = phrase.pattern.match(text)
        if found:
            return phrase.read(names, found.groupdict(), path)
    if _is_expression_of_measures(names, text):
        return composed(names, text, *path)
    words = text.split()
    if words[:2] == ["turn", "of"] and words[2:] and words[2] in names.connections:
        names.unknown(
            text,
            Message(
                "a connection has no turn; give the body one that is a coordinate, as turned: [phi about z], or write "
                "angle of BODY about AXIS"
            ),
            *path,
        )
        return None
    of, dot, coordinate = text.partition(".")
    if dot and of in names.bodies and (meant := _OF_A_BODY.get(coordinate)):
        return read_measure(names, f"{meant} of {of}", *path)
    if re.fullmatch(r"rate\(\w+\)|\w+'", text):
        names.unknown(text, _is_a_rate(text), *path)
        return None
    if rate := re.fullmatch(r"(?P<angular>angular )?(?:velocity|speed|acceleration) of (?P<body>\w+)", text):
        what = f"{'angle' if rate['angular'] else 'x'} of {rate['body']}"
        told = Message(
            "'{text}' is a rate: name what changes, {{s: {what}}}, and write rate(s) for it", text=text, what=what
        )
        names.unknown(text, told, *path)
        return None
    if text.isidentifier() and names.measures:
        told = Message("there is no measure {name}.{hint}", name=text, hint=did_you_mean(text, names.measures))
        names.unknown(text, told, *path)
        return None
    first = text.split()[0] if text else ""
    import difflib

    if names.is_broken_in(text):
        names.broken.add(text)
    close = difflib.get_close_matches(first, [p.form.split()[0] for p in PHRASES], n=1)
    forms = [p.form for p in PHRASES if not close or p.form.split()[0] == close[0]]
    meant = f"{close[0]}{text[len(first) :]}" if close and close[0] != first else text
    if meant != text:
        with names.quietly():
            forms = [meant] if read_measure(names, meant, *path) is not None else forms
    names.unknown(
        text,
        Message(
            "cannot read the measure '{text}'. Did you mean: {forms}"
            if close
            else "cannot read the measure '{text}'. Write one of: {forms}",
            text=text,
            forms="; ".join(forms),
        ),
        *path,
    )
    return None


def _is_expression_of_measures(names: Names, text: str) -> bool:
    """Whether a text is an expression, as `x2 - x1`, whose names are measures and parameters."""
    try:
        used = free_symbols(names.parsed(text))
    except ExpressionError:
        return False
    return bool(used & names.measures.keys()) and used <= names.measures.keys() | names.parameters.keys()


def _is_a_rate(text: str) -> Message:
    return Message("a measure has its rate beside it: {text} may stand in start and in questions", text=text)


def _rate_in(e: Expr) -> str:
    """A rate that stands in an expression; empty where none does."""
    if isinstance(e, Call) and e.function == "rate":
        return to_python(e)
    return next(filter(None, map(_rate_in, children(e))), "")


def composed(names: Names, text: str, *path: str | int) -> Measure | None:
    """An expression in other measures. One that is linear in them with constant coefficients is a combination."""
    try:
        expr = names.parsed(text)
    except ExpressionError as error:
        if not names.is_broken_in(text):
            names.problem(str(error), *path)
        return None
    if free_symbols(expr) & names.broken:
        return None
    if rate := _rate_in(expr):
        names.unknown(text, _is_a_rate(rate), *path)
        return None
    used = sorted(free_symbols(expr) & set(names.measures))
    dimensions = names.dimensions() | {n: m.dimension for n, m in names.measures.items()}
    try:
        dimension = dimension_of(expr, dimensions)
    except UnitError as error:
        names.problem(Message("in '{text}': {error}", text=text, error=error), *path)
        return None
    if not used:
        names.problem(Message("'{text}' contains no measure", text=text), *path)
        return None
    return Composed(expr, tuple((n, names.measures[n]) for n in used), dimension or DIMENSIONLESS)


__all__ = ["PHRASES", "Combination", "composed", "direction_angle", "phrase_text", "read_measure"]
