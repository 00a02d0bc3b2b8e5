"""Questions: what is asked, in the words of the grammar below.

    QUANTITY [at start | when MEASURE = VALUE]        time when MEASURE = VALUE

The grammar is the table `FORMS`; error messages and the documentation list it.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal, cast

from freebody.language.expression import Expr
from freebody.language.plain_text import plain
from freebody.language.units import (
    ANGULAR_MOMENTUM,
    ANGULAR_VELOCITY,
    DIMENSIONLESS,
    ENERGY,
    FORCE,
    LENGTH,
    MOMENTUM,
    POWER,
    TIME,
    TORQUE,
    Dimension,
)
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND, RIGHT, UP, Direction, Point
from freebody.model.contact_questions import (
    CONTACT_FORMS,
    Change,
    EnergyLost,
    Transition,
    Turns,
    as_condition,
    read_transition,
)
from freebody.model.elements import Held, Stretch
from freebody.model.friction_questions import FRICTION_FORMS, RestQuantity
from freebody.model.names import Names, did_you_mean
from freebody.model.phrases import PHRASES, phrase_text, read_measure
from freebody.model.rotations import UNIT
from freebody.model.steady_questions import STEADY_FORMS, SteadyQuantity

Path = tuple[str | int, ...]
Order = Literal[0, 1, 2]


@dataclass(frozen=True)
class OfMeasure:
    """A measure, its rate or its acceleration."""

    measure: Measure
    order: Order
    name: str

    @property
    def dimension(self) -> Dimension:
        return self.measure.dimension / TIME**self.order


Basis = tuple[Direction, Direction, Direction]  # the axes along which a vector of space is wanted


@dataclass(frozen=True)
class OfPoint:
    """Position, velocity or acceleration of a point: a vector, a component, or its size."""

    point: Point
    order: Order
    along: Direction | None = None
    size: bool = False
    basis: Basis | None = None

    @property
    def dimension(self) -> Dimension:
        return LENGTH / TIME**self.order


@dataclass(frozen=True)
class Turning:
    """Angular velocity (order 1) or acceleration (2) of a body in space: a vector, a component, or its size."""

    body: str
    order: Literal[1, 2]
    relative_to: str = GROUND
    along: Direction | None = None
    size: bool = False
    basis: Basis | None = None

    @property
    def dimension(self) -> Dimension:
        return DIMENSIONLESS / TIME**self.order


@dataclass(frozen=True)
class InstantCentre:
    """The point of the plane where two bodies have the same velocity."""

    body: str
    relative_to: str = GROUND
    dimension: Dimension = LENGTH


@dataclass(frozen=True)
class Multiplier:
    """What one row of a connection transmits: tension, normal force, tooth force ..."""

    connection: str
    reaction: str
    row: str
    at: tuple[str, ...] = ()
    less: tuple[str, ...] = ()  # rows whose reactions are subtracted: the tension before a drum with friction

    dimension: Dimension = FORCE


@dataclass(frozen=True)
class Wrench:
    """Force or moment of a connection on a body: a vector, a component, the size, or the moment about the mass
    centre or a point."""

    connection: str
    on: str | None
    along: Direction | None = None
    size: bool = False
    moment: bool = False
    about: Point | None = None
    basis: Basis | None = None

    @property
    def dimension(self) -> Dimension:
        return TORQUE if self.moment else FORCE


@dataclass(frozen=True)
class LoadForce:
    """Force or torque of a load; a spring's or damper's is positive when it pulls."""

    load: str
    dimension: Dimension = FORCE


@dataclass(frozen=True)
class Energy:
    """Kinetic, potential or total energy, of the system or one body."""

    what: Literal["kinetic", "potential", "total"]
    body: str | None = None
    dimension: Dimension = ENERGY


# Of which bodies: None means all of them.
Group = str | tuple[str, ...] | None
SYSTEM_CENTER = "mass center"


@dataclass(frozen=True)
class Momentum:
    """Linear momentum of the system, of one body or of several: a vector or a component."""

    body: Group = None
    along: Direction | None = None
    dimension: Dimension = MOMENTUM


@dataclass(frozen=True)
class Spin:
    """Angular momentum of the system, of one body or of several about a point, or about the mass centre of those
    bodies (the default for one body; else the origin)."""

    body: Group = None
    about: Point | Literal["mass center"] | None = None
    dimension: Dimension = ANGULAR_MOMENTUM
    along: Direction | None = None  # in space
    size: bool = False
    basis: Basis | None = None


@dataclass(frozen=True)
class Power:
    """Power of a load or a driver."""

    of: str
    dimension: Dimension = POWER


@dataclass(frozen=True)
class Work:
    """Work of a load from the start to the event."""

    of: str
    dimension: Dimension = ENERGY


@dataclass(frozen=True)
class RatioOf:
    """One quantity over another."""

    top: Quantity
    bottom: Quantity

    @property
    def dimension(self) -> Dimension:
        return self.top.dimension / self.bottom.dimension


@dataclass(frozen=True)
class When:
    """The time of the event."""

    dimension: Dimension = TIME


@dataclass(frozen=True)
class Small:
    """Natural frequencies or period of small oscillations about the equilibrium."""

    what: Literal["frequencies", "frequency", "period"]

    @property
    def dimension(self) -> Dimension:
        return TIME if self.what == "period" else ANGULAR_VELOCITY


@dataclass(frozen=True)
class Equilibrium:
    """The value of a measure at rest."""

    measure: Measure
    name: str

    @property
    def dimension(self) -> Dimension:
        return self.measure.dimension


@dataclass(frozen=True)
class Freedom:
    """Degrees of freedom."""

    dimension: Dimension = DIMENSIONLESS


@dataclass(frozen=True)
class GeneralizedMomentum:
    """dL/du of a generalized coordinate."""

    coordinate: str
    dimension: Dimension


@dataclass(frozen=True)
class JacobiIntegral:
    """sum of u dL/du, minus L: the energy where nothing is driven."""

    dimension: Dimension = ENERGY


@dataclass(frozen=True)
class Conserved:
    """Whether, or when, a quantity stays constant."""

    of: Quantity
    name: str

    @property
    def dimension(self) -> Dimension:
        return self.of.dimension / TIME


Quantity = (
    OfMeasure
    | OfPoint
    | Turning
    | InstantCentre
    | Multiplier
    | Wrench
    | LoadForce
    | Energy
    | Momentum
    | Spin
    | Power
    | Work
    | RatioOf
    | When
    | Small
    | Equilibrium
    | Freedom
    | GeneralizedMomentum
    | JacobiIntegral
    | Conserved
    | EnergyLost
    | Turns
    | Change
    | RestQuantity
    | SteadyQuantity
)


@dataclass(frozen=True)
class Event:
    """A measure (or its rate) reaches a value."""

    measure: Measure
    order: Literal[0, 1]
    value: Expr
    text: str


@dataclass(frozen=True)
class Question:
    """A quantity that is asked for, when it is meant, and the options to choose from."""

    id: str
    text: str
    quantity: Quantity
    event: Event | None = None
    at_start: bool = False
    options: Mapping[str, str] = field(default_factory=dict[str, str])
    key: str | None = None
    transition: Transition | None = None  # instead of an event: a contact changes its state


# -- the grammar ------------------------------------------------------------------------------
Reader = Callable[[Names, dict[str, str | None], Path], Quantity | None]


@dataclass(frozen=True)
class Form:
    """One way to ask."""

    form: str
    pattern: re.Pattern[str]
    read: Reader


FORMS: list[Form] = []
_POINT = r"[A-Za-z_]\w*(?:\.\w+)?"
_NAME = r"[A-Za-z_]\w*"
_PLACE = rf"{_NAME}(?:\.\w+)?"
_GROUP = rf"{_NAME}(?:(?:, | and ){_NAME})*"
_OPENINGS = (
    "position",
    "velocity",
    "acceleration",
    "angular velocity",
    "angular acceleration",
    "speed",
    "instant centre",
    "angle",
    "reaction",
    "moment",
    "tension",
    "normal force",
    "friction force",
    "kinetic energy",
    "potential energy",
    "total energy",
    "linear momentum",
    "angular momentum",
    "power",
    "work",
    "equilibrium",
)
_ORDERS: dict[str, Order] = {"position": 0, "velocity": 1, "acceleration": 2, "value": 0, "rate": 1}


def _form(form: str, pattern: str) -> Callable[[Reader], Reader]:
    def register(read: Reader) -> Reader:
        FORMS.append(Form(form, re.compile(rf"^(?:the )?(?:{pattern})$"), read))
        return read

    return register


for _text, _pattern, _read in CONTACT_FORMS:
    _form(_text, _pattern)(_read)


for _text, _pattern, _read in FRICTION_FORMS:
    _form(_text, _pattern)(_read)


for _text, _pattern, _read in STEADY_FORMS:
    _form(_text, _pattern)(_read)


@_form("degrees of freedom", r"(?:number of )?degrees of freedom|mobility")
def _freedom(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    return Freedom()


@_form(
    "is QUANTITY conserved | when is QUANTITY conserved",
    r"(?:(?:[Ii]s|[Ww]hen is|whether) (?:the )?(?P<of>.+?) (?:is )?conserved\??"
    r"|conservation of (?:the )?(?P<named>.+))",
)
def _conserved(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    text = str(found["of"] or found["named"])
    of = read_quantity(names, text, path)
    if of is None or isinstance(of, (OfMeasure, OfPoint, Momentum, Spin, Energy, GeneralizedMomentum, JacobiIntegral)):
        return None if of is None else Conserved(of, text)
    names.problem(f"'{text}' is nothing that a motion keeps; ask for a momentum, an energy or a measure", None, *path)
    return None


@_form("generalized momentum of COORDINATE", rf"generali[sz]ed momentum of (?P<of>{_NAME})")
def _generalized_momentum(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    of = str(found["of"])
    measure = names.measures.get(of)
    unit = DIMENSIONLESS if measure is None else measure.dimension
    return GeneralizedMomentum(of, ENERGY * TIME / unit)


@_form("Jacobi integral", r"[jJ]acobi(?:'s)? integral|generali[sz]ed energy")
def _jacobi(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    return JacobiIntegral()


@_form("natural frequencies | period of small oscillations", r"natural (?P<f>frequency|frequencies)")
def _frequencies(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    return Small("frequency" if found["f"] == "frequency" else "frequencies")


@_form("period of small oscillations", r"period(?: of(?: small)? oscillations?)?")
def _period(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    return Small("period")


@_form("ratio of QUANTITY to QUANTITY", r"ratio of (?P<top>.+) to (?P<bottom>.+)")
def _ratio(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    top, bottom = (read_quantity(names, str(found[k]), path) for k in ("top", "bottom"))
    return None if top is None or bottom is None else RatioOf(top, bottom)


_IN = rf"(?: (?:in|along the axes of) (?:the )?(?:frame |basis )?(?P<basis>{_NAME}))?"


def _basis(names: Names, name: str | None, path: Path) -> Basis | None:
    """The axes of a body or of a frame."""
    if name is None or name == GROUND:
        return None
    if not names.space:
        names.problem("a basis is for vectors of space: write space: true", None, *path)
        return None
    if name not in names.bodies and name not in names.frames:
        known = [*names.bodies, *names.frames]
        names.problem(f"there is no body or frame {name}.{did_you_mean(name, known)}", None, *path)
        return None
    x, y, z = (names.fixed_in(name, along, f"{name}.{axis}") for along, axis in zip(UNIT, "xyz", strict=True))
    return x, y, z


@_form(
    "[size of] angular velocity | angular acceleration of BODY [relative to BODY] [along DIRECTION] [in BASIS]",
    rf"(?P<size>size of |magnitude of )?(?:the )?(?P<what>angular velocity|angular acceleration) of (?P<of>{_NAME})"
    rf"(?: relative to (?P<rel>{_NAME}))?(?: (?:along|about) (?P<along>.+?))?{_IN}",
)
def _turning(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    of, order = str(found["of"]), 1 if found["what"] == "angular velocity" else 2
    is_measure = of in names.measures and of not in names.bodies
    if not names.space or is_measure:
        if found["along"] or found["size"] or found["basis"]:
            names.problem(
                f"'{of}' turns in the plane and has one angular velocity; leave out the direction", None, *path
            )
            return None
        return _angular(names, found, path)
    body = names.body(of, *path)
    if not body.turns:
        names.problem(f"{of} is a particle and does not turn", None, *path)
    other = GROUND if found["rel"] is None else names.body(str(found["rel"]), *path).name
    along = None if found["along"] is None else names.direction(found["along"], *path)
    return Turning(body.name, order, other, along, found["size"] is not None, _basis(names, found["basis"], path))


@_form(
    "angle | angular velocity | angular acceleration of BODY [relative to BODY]",
    rf"(?P<what>angle|angular velocity|angular acceleration) of (?P<of>{_NAME})"
    rf"(?: relative to (?P<rel>{_NAME}))?",
)
def _angular(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    of = str(found["of"])
    order: Order = {"angle": 0, "angular velocity": 1, "angular acceleration": 2}[str(found["what"])]  # type: ignore[assignment]
    if of in names.measures and of not in names.bodies:
        return OfMeasure(names.measures[of], order, of)
    body = names.body(of, *path)
    if not body.turns:
        names.problem(f"{of} is a particle and has no angle", None, *path)
    if names.space:
        names.problem(
            f"in space a body has no one angle; ask for angle of {of} about z, or name angles with turned", None, *path
        )
    other = GROUND if found["rel"] is None else names.body(str(found["rel"]), *path).name
    return OfMeasure(Angle(body.name, other), order, f"angle of {of}")


@_form(
    "position | velocity | acceleration of MEASURE, or of POINT [along DIRECTION]",
    rf"(?P<what>position|velocity|acceleration|value|rate) of (?P<of>.+?)(?: along (?P<along>.+?))?{_IN}",
)
def _motion(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    of, order = str(found["of"]), _ORDERS[str(found["what"])]
    if of in names.measures:
        return OfMeasure(names.measures[of], order, of)
    body_name, _, _point_name = of.partition(".")
    if re.fullmatch(_POINT, of) and (body_name in names.bodies or not _is_phrase(of)):
        if of in names.broken:
            return None
        if body_name not in names.bodies:
            known = [*names.measures, *names.bodies]
            names.problem(f"{of} is no measure, body or point.{did_you_mean(body_name, known)}", None, *path)
            return None
        point = names.point(of, *path)
        along = None if found["along"] is None else names.direction(found["along"], *path)
        return OfPoint(point, order, along, basis=_basis(names, found["basis"], path))
    text = of if found["along"] is None else f"{of} along {found['along']}"
    measure = read_measure(names, text, *path)
    return None if measure is None else OfMeasure(measure, order, text)


def _is_phrase(text: str) -> bool:
    return " " in text


@_form("speed of POINT", rf"speed of (?P<of>{_POINT})")
def _speed(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    return OfPoint(names.point(found["of"], *path), 1, size=True)


@_form(
    "instant centre of BODY [relative to BODY]",
    r"(?:(?:instant|instantaneous) cent(?:re|er)(?: of (?:rotation|velocity))?|velocity pole)"
    rf" of (?P<of>{_NAME})(?: relative to (?P<rel>{_NAME}))?",
)
def _instant_centre(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    body = names.body(str(found["of"]), *path)
    other = names.body(str(found["rel"] or GROUND), *path)
    for one in (body, other):
        if not one.turns:
            names.problem(f"{one.name} is a particle and has no angle, so it has no instant centre", None, *path)
    if names.space:
        names.problem(
            "in space a body turns about a moving axis, not about a centre; ask for its angular velocity, or see "
            "freebody mobility for screw axes",
            None,
            *path,
        )
    if body.name == other.name:
        names.problem(f"{body.name} has no motion relative to itself; name another body", None, *path)
    return InstantCentre(body.name, other.name)


@_form(
    "reaction of CONNECTION [on BODY] [along DIRECTION]; x, y component of, size of",
    rf"(?:(?P<part>horizontal|vertical|size of|magnitude of|x component of|y component of) )?(?:the )?"
    rf"(?:reaction|force) of (?P<of>{_NAME})"
    rf"(?: on (?P<on>{_NAME}))?(?: along (?P<along>.+?))?{_IN}",
)
def _reaction(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    of = str(found["of"])
    if of in names.loads:
        return LoadForce(of, names.loads[of])
    if not _has_connection(names, of, path):
        return None
    on = None if found["on"] is None else names.body(str(found["on"]), *path).name
    part = str(found["part"] or "")
    along = None if found["along"] is None else names.direction(found["along"], *path)
    if part in ("horizontal", "x component of"):
        along = RIGHT
    if part in ("vertical", "y component of"):
        along = UP
    is_size = part in ("size of", "magnitude of")
    return Wrench(of, on, along, size=is_size, basis=_basis(names, found["basis"], path))


@_form(
    "moment of CONNECTION [on BODY] [about POINT] [along DIRECTION] [in BASIS]",
    rf"(?P<size>size of |magnitude of )?(?:the )?moment of (?P<of>{_NAME})(?: on (?P<on>{_NAME}))?"
    rf"(?: about (?P<about>{_POINT}))?(?: along (?P<along>.+?))?{_IN}",
)
def _moment(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    of = str(found["of"])
    if not _has_connection(names, of, path):
        return None
    on = None if found["on"] is None else names.body(str(found["on"]), *path).name
    about = None if found["about"] is None else names.point(found["about"], *path)
    along = None if found["along"] is None else names.direction(found["along"], *path)
    if not names.space and (along or found["size"]):
        names.problem("in the plane a moment has no direction; leave it out", None, *path)
    basis = _basis(names, found["basis"], path)
    return Wrench(of, on, along, found["size"] is not None, moment=True, about=about, basis=basis)


@_form("force in SPRING", rf"(?:force|torque) (?:in|of) (?P<of>{_NAME})")
def _load_force(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    of = str(found["of"])
    if of not in names.loads:
        known = [*names.loads, *names.connections]
        names.problem(f"there is no load {of}.{did_you_mean(of, known)}", None, *path)
        return None
    return LoadForce(of, names.loads[of])


@_form(
    "kinetic | potential | total energy [of BODY]",
    rf"(?P<what>kinetic|potential|total|mechanical) energy(?: of (?:the )?(?P<of>{_NAME}))?",
)
def _energy(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    of = found["of"]
    body = None if of is None or of == "system" else names.body(of, *path).name
    what = str(found["what"]).replace("mechanical", "total")
    return Energy(cast("Any", what), body)


@_form(
    "linear momentum [of BODY and BODY] [along DIRECTION]",
    rf"(?:linear )?momentum(?: of (?:the )?(?P<of>{_GROUP}))?(?: along (?P<along>.+))?",
)
def _momentum(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    body = _group(names, found["of"], path)
    return Momentum(body, None if found["along"] is None else names.direction(found["along"], *path))


@_form(
    "angular momentum [of BODY and BODY] [about POINT | about its mass center] [along DIRECTION] [in BASIS]",
    rf"angular momentum(?: of (?:the )?(?P<of>{_GROUP}))?"
    rf"(?: about (?:(?P<center>(?:its|their|the) (?:common )?(?:mass cent(?:er|re)|cent(?:er|re) of mass))"
    rf"|(?P<about>{_POINT})))?(?: along (?P<along>.+?))?{_IN}",
)
def _spin(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    body = _group(names, found["of"], path)
    along = None if found["along"] is None else names.direction(found["along"], *path)
    if along is not None and not names.space:
        names.problem("in the plane an angular momentum has no direction; leave it out", None, *path)
    basis = _basis(names, found["basis"], path)
    if found["center"] is not None:
        return Spin(body, SYSTEM_CENTER, along=along, basis=basis)
    about = None if found["about"] is None else names.point(found["about"], *path)
    return Spin(body, about, along=along, basis=basis)


def _group(names: Names, text: str | None, path: Path) -> Group:
    """The bodies of 'cart and bob'; None for the system."""
    if text is None or text == "system":
        return None
    bodies = tuple(names.body(word, *path).name for word in re.split(r", | and ", text))
    return bodies[0] if len(bodies) == 1 else bodies


@_form("power | work of LOAD", rf"(?P<what>power|work) of (?P<of>{_NAME})")
def _power(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    of = str(found["of"])
    known = [*names.loads, *names.connections]
    if of not in known:
        names.problem(f"there is no load or driver {of}.{did_you_mean(of, known)}", None, *path)
        return None
    return Power(of) if found["what"] == "power" else Work(of)


@_form("equilibrium of MEASURE", r"equilibrium(?: value)? of (?P<of>.+)")
def _equilibrium(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    measure = names.measure(found["of"], *path)
    return None if measure is None else Equilibrium(measure, str(found["of"]))


@_form(
    "tension | normal force | friction force | tooth force | ... of CONNECTION [at BODY | between BODY and BODY]",
    rf"(?P<what>[a-z][a-z ]*?) (?:of|in) (?P<of>{_NAME})"
    rf"(?: (?:at|on) (?P<at>{_PLACE})| between (?P<a>{_PLACE}) and (?P<b>{_PLACE}))?",
)
def _multiplier(names: Names, found: dict[str, str | None], path: Path) -> Quantity | None:
    of, what = str(found["of"]), str(found["what"])
    if of not in names.connections:
        close = difflib.get_close_matches(what, _OPENINGS, n=1, cutoff=0.7)
        if close and close[0] != what:
            names.problem(f"there is nothing called {what}. Did you mean: {close[0]} of {of}", None, *path)
            return None
        if of in names.bodies:
            known_forms = ", ".join(_OPENINGS[:7])
            names.problem(f"a body has no {what}; one can ask for its {known_forms}, momenta and energies", None, *path)
            return None
    if not _has_connection(names, of, path):
        return None
    rows = [row for row in names.held if row.connection == of]
    kinds = sorted({row.reaction for row in rows})
    if what not in kinds:
        names.problem(f"{of} has no {what}.{did_you_mean(what, kinds)} Or ask for: reaction of {of}", None, *path)
        return None
    at = tuple(_place(names, str(found[k]), path) for k in ("at", "a", "b") if found[k] is not None)
    places = [place for row in rows if row.reaction == what for place in _places(row)]
    matching = [place for place in places if set(at) <= set(place[1].places)]
    if len(matching) != 1:
        ends = "; ".join(" - ".join(_listed(stretch.places)) for _row, stretch in places)
        names.problem(
            f"{of} has {'several values' if matching else 'no value'} of {what}"
            f"{' at ' + ' and '.join(at) if at else ''}; say which: at BODY, or between BODY and BODY ({ends})",
            None,
            *path,
        )
        return None
    row, stretch = matching[0]
    dimension = FORCE if row.measure.dimension == LENGTH else TORQUE / row.measure.dimension * DIMENSIONLESS
    return Multiplier(of, what, row.name, at, tuple(f"{of}.{component}" for component in stretch.less), dimension)


def _listed(places: tuple[str, ...]) -> list[str]:
    """The places of a stretch, a body that is there by a point of its own as that point."""
    return [p for p in places if not any(other.startswith(f"{p}.") for other in places)]


def _place(names: Names, text: str, path: Path) -> str:
    """A body, or a point as `rod.end`, by the name that rows have for it."""
    return str(names.point(text, *path)) if "." in text else names.body(text, *path).name


def _places(row: Held) -> list[tuple[Held, Stretch]]:
    """The row with each of its stretches; one that is no string is one of its own."""
    bodies = row.ends or tuple(dict.fromkeys(row.measure.bodies()))
    return [(row, stretch) for stretch in row.stretches or (Stretch(bodies),)]


def _has_connection(names: Names, name: str, path: Path) -> bool:
    if name in names.connections:
        return True
    known = [*names.connections, *names.loads]
    names.problem(f"there is no connection {name}.{did_you_mean(name, known)}", None, *path)
    return False


# -- reading ----------------------------------------------------------------------------------
def read_quantity(names: Names, text: str, path: Path) -> Quantity | None:
    if text in names.measures:
        return OfMeasure(names.measures[text], 0, text)
    if text in names.broken:
        return None
    if any(phrase.pattern.match(text) for phrase in PHRASES) and not text.startswith("angle of"):
        measure = read_measure(names, text, *path)
        return None if measure is None else OfMeasure(measure, 0, text)
    for form in FORMS:
        found = form.pattern.match(text)
        if found:
            return form.read(names, found.groupdict(), path)
    words = text.split(" of ", maxsplit=1)[0]
    openings = {w: f.form for f in FORMS for w in re.split(r"[|,;]", f.form.split(" of ")[0])}
    close = difflib.get_close_matches(words, [w.strip() for w in openings], n=1, cutoff=0.6)
    if close:
        form = next(f for w, f in openings.items() if w.strip() == close[0])
        names.problem(f"cannot read '{text}'. Did you mean: {form}", None, *path)
    else:
        listed = "\n    ".join(f.form for f in FORMS)
        names.problem(f"cannot read '{text}'. One can ask for\n    {listed}", None, *path)
    return None


def _event(names: Names, text: str, path: Path) -> Event | None:
    found = re.match(r"^(?P<what>.+?)\s*(?:=| reaches | is | equals )\s*(?P<value>.+)$", text)
    if found is None:
        names.problem(f"cannot read the condition '{text}'; write for example x = h", None, *path)
        return None
    what = found["what"].strip()
    order: Literal[0, 1] = 0
    for pattern in (r"rate\((.+)\)", r"(?:rate|velocity|speed) of (.+)", r"(.+)'", r"(.+)_dot"):
        inner = re.fullmatch(pattern, what)
        if inner and what not in names.measures:
            order, what = 1, inner[1].strip()
            break
    measure = names.measure(what, *path)
    if measure is None:
        return None
    dimension = measure.dimension / TIME**order
    return Event(measure, order, names.formula(found["value"].strip(), dimension, *path), text)


def read_questions(names: Names, given: Any) -> tuple[Question, ...]:
    """The questions of a model; a question is a text, or a mapping with find, id, when, options, key."""
    if given is None:
        return ()
    if isinstance(given, dict):
        pairs = list(cast("dict[str, Any]", given).items())
    elif isinstance(given, list):
        pairs = [(f"q{k}", v) for k, v in enumerate(cast("list[Any]", given), 1)]
    else:
        names.problem("questions is a list, e.g. questions: [{find: acceleration of x}]", None, "questions")
        return ()
    found: list[Question] = []
    for k, (name, value) in enumerate(pairs):
        place = name if isinstance(given, dict) else k
        with names.at("questions", place):
            question = _question(names, name, value)
        if question is not None:
            if any(other.id == question.id for other in found):
                names.problem(f"two questions have the id {question.id}", None, "questions", place, "id")
            found.append(question)
    return tuple(found)


def _question(names: Names, name: str, value: Any) -> Question | None:
    known = ("find", "id", "when", "options", "key")
    phrased = phrase_text(value)
    entry: dict[str, Any] = {}
    if phrased is not None:
        entry = {"find": phrased}
    elif isinstance(value, dict):
        entry = cast("dict[str, Any]", value)
    if not isinstance(entry.get("find"), str):
        names.problem("a question needs find, e.g. {find: acceleration of x}")
        return None
    for key in entry:
        if key not in known:
            names.problem(f"a question has no {key}.{did_you_mean(key, known)}", None, key)
    text = " ".join(str(entry["find"]).split())
    phrase, at_start, event, transition = as_condition(names, text), False, None, None
    if phrase.endswith((" at start", " at the start")):
        phrase, at_start = re.sub(r" at (the )?start$", "", phrase), True
    condition = entry.get("when")
    if condition is None:
        for word in (" when ", " until ", " to reach "):
            if word in phrase:
                phrase, _, condition = phrase.partition(word)
                break
    elif str(condition) in ("start", "at start"):
        at_start, condition = True, None
    if condition is not None:
        where: Path = ("find",) if "when" not in entry else ("when",)
        transition = read_transition(names, str(condition), where)
        event = None if transition is not None else _event(names, str(condition), where)
        if event is None and transition is None:
            return None
    quantity: Quantity | None
    if phrase in ("time", "the time"):
        if event is None and transition is None:
            names.problem("say of what: time when x = h", None, "find")
            return None
        quantity = When()
    else:
        quantity = read_quantity(names, phrase, ("find",))
    if quantity is None:
        return None
    if isinstance(quantity, Conserved) and (condition is not None or at_start):
        names.problem("what is conserved is so at every instant; leave out 'at start' and 'when'", None, "find")
        return None
    if isinstance(quantity, Work) and condition is None:
        names.problem(f"say until when: work of {quantity.of} until x = h", None, "find")
    if isinstance(quantity, (EnergyLost, Turns, Change)) and condition is None:
        names.problem(f"say until when: {phrase} until rolling begins", None, "find")
    options: Any = entry.get("options") or {}
    if isinstance(options, list):
        letters = "abcdefghijklmnopqrstuvwxyz"
        options = dict(zip(letters, cast("list[Any]", options), strict=False))
    if not isinstance(options, dict):
        names.problem("options is a mapping, e.g. options: {a: g/2, b: g}", None, "options")
        options = {}
    shown = {plain(str(k)): plain(_option_text(v)) for k, v in cast("dict[Any, Any]", options).items()}
    key = entry.get("key")
    if key is not None and str(key) not in shown:
        names.problem(f"key {key} is not among the options {', '.join(shown)}", None, "key")
    return Question(
        plain(str(entry.get("id", name))),
        plain(text),
        quantity,
        event,
        at_start,
        shown,
        None if key is None else str(key),
        transition,
    )


def _option_text(value: Any) -> str:
    """An option as text; a vector may be written as a list."""
    if isinstance(value, list):
        return "[" + ", ".join(map(str, cast("list[Any]", value))) + "]"
    return str(value)
