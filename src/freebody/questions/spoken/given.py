"""Parameters that are meant by what they are of: the mass of a body, the force of a load, the only angle.

Some kinds are known by where they are written (the mass of a body, the stiffness of a spring), others by their units
alone. One table says of each which words name it, how it is known, and whether rest can end as it changes.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

from freebody.language.expression import Symbol, free_symbols, multiply, negate
from freebody.language.units import ACCELERATION, DIMENSIONLESS, ENERGY, FORCE, LENGTH, MASS, TIME, TORQUE, Dimension
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ZERO
from freebody.model.elements import VALUE, Parameter
from freebody.model.solids import BOX, ROD
from freebody.questions.spoken import lookup
from freebody.questions.spoken.joining import given_of, is_at, is_joined

if TYPE_CHECKING:
    from freebody.model.names import Names


_TIME = "t"
_SYMBOL = re.compile(r"[^\W\d]\w*")
_SAYS_NO_MORE = ("the", "of", "a", "an", "its", "value", "coefficient", "radius")  # beside a key and a name


@dataclass(frozen=True)
class ParameterKind:
    """words: those that name it; asks: adjectives that ask for it; written: the key of an element under which it
    stands; dimension: of all that are of this kind; ends_rest: rest can end as it changes."""

    words: tuple[str, ...]
    asks: tuple[str, ...] = ()
    written: str = ""
    dimension: Dimension | None = None
    is_angle: bool = False
    ends_rest: bool = False

    @property
    def is_push(self) -> bool:
        """Whether it is how hard something is pushed or turned."""
        return self.dimension in (FORCE, TORQUE)

    @property
    def ends_rest_by_growing(self) -> bool:
        """Whether rest ends where it gets too large: how hard something is pushed, how fast it goes round a curve."""
        return self.is_push or self.dimension in (LENGTH / TIME, DIMENSIONLESS / TIME, ACCELERATION)

    def has(self, parameter: Parameter) -> bool:
        """Whether the unit of a parameter says that it is one."""
        return parameter.is_angle if self.is_angle else parameter.dimension == self.dimension


KINDS = (
    ParameterKind(("mass",), ("heavy",), written="mass", ends_rest=True),
    ParameterKind(("stiffness",), written="stiffness"),
    ParameterKind(("friction coefficient", "friction force"), ("rough",), written="friction", ends_rest=True),
    ParameterKind(("length",), written="length"),
    ParameterKind(("radius",), written="radius"),
    ParameterKind(("force", "tension", "driving force", "braking force"), dimension=FORCE, ends_rest=True),
    ParameterKind(("reaction",), dimension=FORCE),
    ParameterKind(("torque", "moment", "driving torque"), dimension=TORQUE, ends_rest=True),
    ParameterKind(("impulse",), dimension=FORCE * TIME),
    ParameterKind(("angular impulse",), dimension=TORQUE * TIME),
    ParameterKind(("speed", "velocity"), ("fast",), dimension=LENGTH / TIME, ends_rest=True),
    ParameterKind(("acceleration",), dimension=ACCELERATION, ends_rest=True),
    ParameterKind(("angular velocity",), dimension=DIMENSIONLESS / TIME, ends_rest=True),
    ParameterKind(("height",), ("high",), dimension=LENGTH, ends_rest=True),
    ParameterKind(("distance",), ("far",), dimension=LENGTH, ends_rest=True),
    ParameterKind(("angle",), ("steep", "flat"), is_angle=True, ends_rest=True),
)
_DRIVING = frozenset(("motor", "drive", "engine", "traction", "driving", "propulsion"))
BRAKING = frozenset(("brake", "brakes", "braking", "pad", "pads"))
# what is asked for by who pushes: of which kind it is, and what that is called
ROLES = {
    "driving torque": ("torque", _DRIVING),
    "driving force": ("force", _DRIVING),
    "braking force": ("force", BRAKING),
}
KIND_OF = {word: kind for kind in KINDS for word in kind.words}
ASKED_BY = {ask: kind for kind in KINDS for ask in kind.asks}


def is_written(word: str) -> bool:
    """Whether a word names a kind that is known by where it is written."""
    return word in KIND_OF and bool(KIND_OF[word].written)


def is_by_unit(word: str) -> bool:
    """Whether a word names a kind that is known by its unit: it only says what a name is, the force F."""
    return word in KIND_OF and not KIND_OF[word].written


def can_end_rest(word: str) -> bool:
    """Whether a word names a kind of which rest has a limit."""
    return word in KIND_OF and KIND_OF[word].ends_rest


def parameters(names: Names, kind: str, of: str) -> list[str]:
    """Parameters that are the mass of a body, the stiffness of a spring, the coefficient of friction."""
    if kind == "mass":
        masses = [body.mass for name, body in names.bodies.items() if name == of or (not of and not body.fixed)]
        symbols = dict.fromkeys(mass.name for mass in masses if isinstance(mass, Symbol))
        return [*symbols] if of or len(symbols) == 1 else []
    if kind == "stiffness":
        return [name for name, parameter in names.parameters.items() if parameter.dimension == FORCE / LENGTH]
    if kind == "length" and not of:  # of the only thing that has one
        sizes = [body.sizes[0] for body in names.bodies.values() if body.solid is ROD and body.sizes]
        own = {str(given_of(spec).get("length")) for spec in names.connections.values()} | {str(size) for size in sizes}
        return [name for name in names.parameters if name in own]
    if kind == "length" and of in names.loads:  # the length of a cord, or of a spring, without force
        own = [load for load in names.applied_loads if load.load == of]
        ends = [load.one_sided.limit for load in own if load.one_sided is not None]  # where it goes taut
        used = frozenset[str]().union(*map(free_symbols, (*(load.law for load in own), *ends)))
        return [name for name, told in names.parameters.items() if told.dimension == LENGTH and name in used]
    word = KIND_OF[kind].written if kind in KIND_OF else kind
    own = [spec for name, spec in names.connections.items() if not of or name == of or is_at(names, name, of)]
    given = [value for spec in own for key, value in given_of(spec).items() if word in key]
    each = (cast("dict[str, object]", value).values() if isinstance(value, dict) else (value,) for value in given)
    written = {str(value) for some in each for value in some}
    return [name for name in names.parameters if name in written]


def stiffness(names: Names, spring: str) -> str | None:
    """The parameter that is the stiffness of a spring whose force is in proportion to its extension."""
    own = [load for load in names.applied_loads if load.load == spring]
    laws = [load.law if load.one_sided is None else load.one_sided.law for load in own]
    found = parameters(names, "stiffness", "")
    return next((k for k in found if laws and all(law == negate(multiply(Symbol(k), VALUE)) for law in laws)), None)


def exerts(names: Names, load: str, kind: str) -> bool:
    """Whether what a load exerts is of a kind: a torque, an impulse."""
    struck = (ENERGY / push.measure.dimension * TIME for push in names.strikes if push.load == load)
    return KIND_OF[kind].dimension == next(struck, names.loads.get(load))


def of_kind(names: Names, kind: str) -> list[str]:
    """Parameters that are a force, an angle, a speed, as their units say."""
    given = [parameter for parameter in names.parameters.values() if parameter.form is None]
    found = [parameter.name for parameter in given if is_by_unit(kind) and KIND_OF[kind].has(parameter)]
    return [name for name in found if kind != "acceleration" or name not in weighed_by(names)]


def weighed_by(names: Names) -> frozenset[str]:
    """The parameters in the laws of gravity."""
    weights = [load.law for load in names.applied_loads if "gravity" in names.called.get(load.load, ())]
    return frozenset[str]().union(*map(free_symbols, weights))


def growing(names: Names, things: list[str]) -> list[str]:
    """What may grow until rest ends, where nobody says what: the only force, torque, speed or acceleration that can be
    chosen; else the only angle by which a plane, or a fixed body, is raised. things: what is named."""
    kinds = ("force", "torque", "speed", "acceleration")
    pushed = [name for kind in kinds for name in chosen(names, KIND_OF[kind], things)]
    ground = names.bodies[GROUND]
    ways = [line.direction for line in ground.lines.values()] + [plane.normal for plane in ground.planes.values()]
    raised = frozenset[str]().union(*(free_symbols(x) for way in ways for x in way.components))
    for body in names.bodies.values():
        if body.fixed and not pushed:
            turns = [body.start.angle or ZERO, *(turn.by for turn in body.start.turned or ())]
            raised |= frozenset[str]().union(*map(free_symbols, turns))
    return pushed or [name for name in chosen(names, KIND_OF["angle"], things) if name in raised]


def leaning_by(names: Names, name: str) -> frozenset[str]:
    """What is in the angle by which a line of the ground, or a fixed body, leans."""
    ground, body = names.bodies[GROUND], names.bodies.get(name)
    ways = [ground.lines[name].direction] if name in ground.lines else []
    ways += [ground.planes[name].normal] if name in ground.planes else []
    turns = [body.start.angle or ZERO, *(t.by for t in body.start.turned or ())] if body and body.fixed else []
    return frozenset[str]().union(*map(free_symbols, (*(x for way in ways for x in way.components), *turns)))


def _upright_side(names: Names, body: str) -> list[str]:
    """The parameter that is the height of a block, by itself."""
    is_block = body in names.bodies and names.bodies[body].solid is BOX and len(names.bodies[body].sizes) > 1
    side = names.bodies[body].sizes[1] if is_block else None
    return [side.name] if isinstance(side, Symbol) and side.name in names.parameters else []


def started_with(names: Names, bodies: list[str]) -> list[str]:
    """Parameters that are speeds with which the file lets bodies start."""
    used = frozenset[str]()
    for body in bodies:
        if body in names.bodies:
            for component in names.bodies[body].start.velocity or ():
                used |= free_symbols(component)
        for name, rate in names.start_rates.items():
            own = set(names.measures[name].bodies()) if name in names.measures else set[str]()
            is_on_curve = bool(own) and not (own - {GROUND}) & names.bodies.keys()  # of the foot of what runs along it
            if body == name or body in own or (is_on_curve and len(bodies) == 1):
                used |= free_symbols(rate)
    return [name for name in of_kind(names, "speed") if name in used]


def in_role(names: Names, asked: str, of: list[str]) -> list[str]:
    """The only parameter of the loads, or of those on some bodies, that are called as who pushes: motor, brake."""
    kind, words = ROLES[asked]
    loads = [load for load in names.loads if {load, lookup.acted_on(names, load)} & words]
    loads = [load for load in loads if not of or {load, lookup.acted_on(names, load)} & {*of}] or loads
    found = chosen(names, KIND_OF[kind], loads) if loads else []
    return found if len(found) == 1 else []


def chosen(names: Names, kind: ParameterKind, of: list[str]) -> list[str]:
    """Parameters that are of a kind and can be chosen: a force that a load exerts, a length that is no size of a body.

    of: what is named beside it."""
    given = [parameter for parameter in names.parameters.values() if parameter.form is None]
    held = [load for load in names.applied_loads if load.load in of]
    if kind.written == "mass" and held and not any(name in names.bodies for name in of):  # how heavy a load is
        weights = frozenset[str]().union(*(free_symbols(load.law) for load in held))
        return [p.name for p in given if p.name in weights and p.dimension in (MASS, FORCE)]
    if kind.written == "mass":
        own = [name for body in of for name in parameters(names, "mass", body)]
        bodies = frozenset[str]().union(*(free_symbols(body.mass) for body in names.bodies.values()))
        others = [p.name for p in given if p.dimension == MASS and p.name not in bodies]
        masses = [p.name for p in given if p.dimension == MASS]
        others = others or (masses if len(masses) == 1 else [])
        return own or ([] if any(name in names.bodies for name in of) else others)
    if kind.written:
        return parameters(names, kind.words[0], next((name for name in of if is_joined(names, name)), ""))
    if kind is KIND_OF["height"] and (upright := [p for body in of for p in _upright_side(names, body)]):
        return upright
    found = of_kind(names, kind.words[0])
    if kind is KIND_OF["height"]:  # how high something sits is not how far to the side
        aside = [names.placed_at_start[way] for way in lookup.level(names, "") if way in names.placed_at_start]
        found = [name for name in found if all(name not in free_symbols(place) for place in aside)]
        laws = frozenset[str]().union(*(free_symbols(load.law) for load in names.applied_loads))
        found = [name for name in found if name not in laws]  # the radius of a curve, of which only a force knows
    if kind in (KIND_OF["impulse"], KIND_OF["angular impulse"]):
        struck = [push for push in names.strikes if push.load in of] or names.strikes
        return [name for name in found if any(name in free_symbols(push.law) for push in struck)]
    if kind.is_push:
        exerted = [load for load in names.applied_loads if "gravity" not in names.called.get(load.load, ())]
        loads = [load for load in exerted if load.load in of]
        loads = loads or [load for load in exerted if not {*of}.isdisjoint(load.measure.bodies())] or exerted
        laws = [free_symbols(load.law) for load in loads]  # what is in one of a motion is a stiffness, a damping
        pushed = frozenset[str]().union(*(law for law in laws if law <= names.parameters.keys() | {_TIME}))
        return [name for name in found if name in pushed]
    sizes = frozenset[str]().union(
        *(
            free_symbols(size)
            for body in names.bodies.values()
            for size in (body.inertia, body.radius or ZERO, *body.sizes)
        )
    )
    held = frozenset(
        symbol
        for spec in names.connections.values()
        for value in given_of(spec).values()
        for symbol in _SYMBOL.findall(str(value))
    )
    found = [name for name in found if kind.is_angle or name not in sizes]
    return [name for name in found if kind.is_angle or name not in held] or found


def by_key(names: Names, words: list[str]) -> list[str]:
    """Parameters that a file gives under a key which words say: the base circle, the pretension of the belt. Other
    words name an element, or say no more."""
    things = {*names.bodies, *names.connections, *(part for name in names.connections for part in name.split("_"))}
    said = ["radius" if word == "circle" else word for word in words]
    found: dict[str, None] = {}
    for spec in names.connections.values():
        for key, value in given_of(spec).items():
            parts = key.split("_")
            if str(value) not in names.parameters or not {*parts} <= {*said, "radius"} or {*parts} <= {"radius"}:
                continue
            if {*said} - {*parts} <= things | {
                *_SAYS_NO_MORE,
                *(w for n in names.called.values() for one in n for w in one.split()),
            }:
                found[str(value)] = None
    return [*found]


def teeth(names: Names, of: str) -> list[str]:
    """Parameters that are numbers of teeth: of the body that is named, whose radius they tell."""
    radius = names.bodies[of].radius if of in names.bodies else None
    own = frozenset[str]() if radius is None else free_symbols(radius)
    return [name for name in sorted(names.counts) if not of or name in own]


def load_of(names: Names, parameter: str) -> str:
    """The only load that pushes, or turns, with what a parameter says; nothing where there is none, or several."""
    loads = {push.load for push in names.applied_loads if push.law in (Symbol(parameter), negate(Symbol(parameter)))}
    return loads.pop() if len(loads) == 1 else ""


def placing(names: Names, load: str) -> list[str]:
    """Lengths that say where on a body a load acts, and that are no size of it."""
    pushed = [push.measure for push in names.applied_loads if push.load == load]
    points = [m.of for m in pushed if isinstance(m, Displacement)]
    within = frozenset[str]().union(*(free_symbols(x) for point in points for x in point.offset))
    sizes = frozenset[str]().union(*(free_symbols(x) for point in points for x in names.known(point.body).sizes))
    lengths = [p.name for p in names.parameters.values() if p.dimension == LENGTH and p.form is None]
    return [name for name in lengths if name in within - sizes]


def counts_from_level(names: Names, parameter: str) -> bool:
    """Whether a parameter is the angle of a body, or of a line of the ground, which counts from the horizontal."""
    lying = [body.start.angle for name, body in names.bodies.items() if name != GROUND]
    led = [line.direction for line in names.bodies[GROUND].lines.values()]
    sloping = any(parameter in free_symbols(part) for way in led for part in way.components)
    return sloping or any(angle == Symbol(parameter) for angle in lying)
