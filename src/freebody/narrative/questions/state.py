"""Questions that a pose and velocities answer without any law of motion: energies, momenta, velocities, centres."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import singledispatch
from typing import Any, Protocol

from freebody.language.expression import Expr, Symbol, add, multiply, n_operations, number, power
from freebody.language.sentences import Sentence
from freebody.measures.geometry import ZERO, Point
from freebody.model.elements import AppliedLoad, BodyPart, RigidBody
from freebody.model.state import State
from freebody.narrative.context import Context, Method
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.script import Script
from freebody.narrative.principles.kinematics import Term
from freebody.narrative.principles.sides import positive_first, scaled
from freebody.narrative.space.spatial_kinematics import SpatialKinematics
from freebody.questions.base import Quantity
from freebody.questions.centres import InstantCentre, motion_at_origin
from freebody.questions.energy import Energy, is_lossy
from freebody.questions.inertia import MomentOfInertia, squared_distance
from freebody.questions.momentum import SYSTEM_CENTER, AngularMomentum, Momentum, point_about
from freebody.questions.motion import OfPoint
from freebody.questions.reading import Question
from freebody.questions.seen_from_body import SeenFromBody
from freebody.questions.vectors import ORIGIN, is_among, place
from freebody.symbolic.tidy import tidy


@dataclass(frozen=True)
class AnswerParts:
    """Lines that an answer follows from, and the symbols whose sum it is."""

    lines: tuple[int, ...]
    total: Expr | tuple[Expr, ...] | None = None


class StateTelling(Protocol):
    """What a quantity is made of that follows from pose and velocities, told in a script."""

    @property
    def kinematics(self) -> SpatialKinematics | None:
        """What is told of the motion, in space."""
        ...

    @property
    def is_formal(self) -> bool:
        """Whether a sum is told by symbols that have values at the start."""
        ...

    def parts(self, q: Quantity) -> AnswerParts:
        """Lines, and the sum that the quantity is. Written inside stages of their own."""
        ...

    def before(self, q: Quantity, method: Method) -> AnswerParts:
        """What is told before its accelerations and reactions are."""
        ...

    def tells_all(self, question: Question, method: Method) -> bool:
        """Whether the answer needs no more, and was told."""
        ...


class PlanarTelling:
    """The same in the plane."""

    kinematics: None = None
    is_formal = False

    def __init__(self, context: Context, script: Script) -> None:
        self.context, self.script = context, script

    def parts(self, q: Quantity) -> AnswerParts:
        uses = self.context.rates.loops(self.context.setup, self.script)
        lines, symbols = _told(q, self.context, self.script)
        return AnswerParts(tuple(dict.fromkeys((*uses, *lines))), add(*symbols) if symbols else None)

    def before(self, q: Quantity, method: Method) -> AnswerParts:
        if method in ("auto", "newton"):
            self.context.rates.loops(self.context.setup, self.script)
        return AnswerParts(())

    def tells_all(self, question: Question, method: Method) -> bool:
        return False


@singledispatch
def _told(q: Quantity, context: Context, script: Script) -> tuple[list[int], list[Expr]]:
    """Lines, and the symbols of the parts whose sum it is: by default the constraints of the bodies that it reads."""
    bodies = [b for b in q.bodies_in_motion if b in context.setup.model.kinematics.velocities]
    lines: list[int] = []
    alike: dict[str, str] = {}
    with script.stage("stage.kinematics", "hint.velocities"):
        for b in bodies:
            first = context.rates.symmetry.stand_in(b)
            if first == b:
                lines += context.rates.constraints_of(script, b)
            else:  # where it is differs, so how its place changes is told as well
                lines += context.rates.leading_to(script, first)
                alike[b] = first
    with script.stage("stage.value", "hint.value"):
        for b, first in alike.items():
            script.say("symmetry.alike", first=first, other=b)
    return lines, []


@_told.register(SeenFromBody)
def _seen(q: SeenFromBody, context: Context, script: Script) -> tuple[list[int], list[Expr]]:
    """The composition of motions, then how both bodies move."""
    with script.stage("stage.kinematics", "hint.velocities"):
        what = "coriolis" if q.is_coriolis else "velocity" if q.order == 1 else "acceleration"
        script.say(f"seen.{what}", body=q.body, point=str(q.point))
    return _told.dispatch(Quantity)(q, context, script)


# -- velocities -------------------------------------------------------------------------------
@_told.register(OfPoint)
def _of_point(q: OfPoint, context: Context, script: Script) -> tuple[list[int], list[Expr]]:
    """The constraints where these tell the velocity of a mass centre, else its place differentiated."""
    body = context.system.bodies[q.point.body]
    is_carried = body.fixed or context.rates.is_led(body.name) or context.setup.model.dependent
    if q.order != 1 or q.point != body.mass_center or is_carried:
        return _told.dispatch(Quantity)(q, context, script)
    with script.stage("stage.kinematics", "hint.velocities"):
        x, y = _velocity(context, body.name)
        return context.rates.explain_velocities(script, [*x, *y]), []
    return [], []


def _velocity(context: Context, body: str) -> tuple[list[Term], list[Term]]:
    """The velocity of a mass centre as terms to be squared and added: one along its path, else two components."""
    kin, f = context.rates.kinematics, context.setup.model.field
    x = kin.along(body, (f.one, f.zero), 1)
    y = kin.along(body, (f.zero, f.one), 1)
    return x, y


def _square(context: Context, body: str) -> tuple[Expr | None, list[Term]]:
    """v^2 in symbols; None where the mass centre is at rest."""
    x, y = _velocity(context, body)
    terms = [*x, *y]
    if not terms:
        return None, []
    f = context.setup.model.field
    if len({t.symbol for t in terms}) == 1:
        size = f.lowest_terms(sum((t.coefficient * t.coefficient for t in terms), f.zero))
        return multiply(tidy(size), power(terms[0].symbol, number(2))), terms[:1]
    squares = [power(positive_first([t.expression for t in group]), number(2)) for group in (x, y) if group]
    return add(*squares), terms


def name_of(context: Context, letter: str, of: str) -> Symbol:
    """T_left, or E_kin_left where one of T_left, T_right ... is a tension: all parts of a sum are called alike."""
    long = {"T": "E_kin", "V": "E_pot", "H": "L"}[letter]
    system = context.system
    parts = [*system.loads] if letter == "V" else [body.name for body in system.moving]
    is_free = all(context.symbol(f"{letter}_{part}").name == f"{letter}_{part}" for part in parts)
    return context.symbol(*([f"{letter}_{of}"] if is_free else []), f"{long}_{of}")


# -- energy -----------------------------------------------------------------------------------
@_told.register(Energy)
def _energy(q: Energy, context: Context, script: Script) -> tuple[list[int], list[Expr]]:
    """Lines, and the symbols of the parts."""
    system = context.system
    lines: list[int] = []
    symbols: list[Expr] = []
    with script.stage("stage.parts", "hint.parts"):
        if q.what in ("kinetic", "total"):
            meant = [body for body in system.moving if q.body is None or q.body == body.name]
            for body in meant:
                context.rates.explain_velocities(script, kinetic_terms(context, body.name)[1])
            for body in meant:
                more = kinetic_of(context, script, body.name)
                lines += more
                symbols += [name_of(context, "T", body.name)] if more else []
        if q.what in ("potential", "total"):
            lines += stored(context, script, q.body, symbols)
    return lines, symbols


def kinetic_terms(context: Context, body: str) -> tuple[list[Expr], list[Term]]:
    """m v^2/2 and I w^2/2 of one body, and the velocities in them."""
    square, terms = _square(context, body)
    turning = context.rates.kinematics.turning(body, 1) if context.system.bodies[body].turns else None
    mass, _m, inertia = context.setup.model.dynamics.inertias[body]
    parts: list[Expr] = []
    if square is not None and not mass.is_zero():
        parts.append(multiply(tidy(mass / 2), square))
    if turning is not None and not inertia.is_zero():
        parts.append(multiply(tidy(inertia / 2), power(turning.symbol, number(2))))
        terms = [*terms, turning]
    return parts, terms if parts else []


def kinetic_of(context: Context, script: Script, body: str) -> list[int]:
    """T = m v^2/2 + I w^2/2 of one body, after the constraints that its velocity obeys."""
    parts, terms = kinetic_terms(context, body)
    if not parts:
        return []
    velocities = context.rates.explain_velocities(script, terms)
    symbol = name_of(context, "T", body)
    what = Sentence("symbol.kinetic_of", {"body": body})
    script.introduce(Meaning(symbol, what, Energy("kinetic", body), "J"))
    context.rates.announce(script, terms)
    written, f = add(*parts), context.setup.model.field
    value = f.element(Energy("kinetic", body).value(context.system, context.setup.state))
    inserted = tidy(f.lowest_terms(value))
    sides = (written, inserted) if velocities and n_operations(inserted) <= n_operations(written) else (written,)
    return [script.line(symbol, *sides, why="energy.of_body", args={"body": body}, uses=velocities), *velocities]


def stored(context: Context, script: Script, body: str | None, terms: list[Expr]) -> list[int]:
    """What each load stores, in one body or in all, as lines and terms of the sum."""
    system, lines = context.system, list[int]()
    for load in system.loads:
        own = [p for p in system.applied_loads if p.load == load and (body is None or body in set(p.measure.bodies()))]
        own = [p for p in own if not is_lossy(p)]
        if own and system.loads[load].stores_energy:
            lines.append(_stored_by(context, script, load, own))
            terms.append(name_of(context, "V", load))
    return lines


def _stored_by(context: Context, script: Script, load: str, applied_loads: Sequence[AppliedLoad]) -> int:
    """The energy that a load stores."""
    state, f = context.setup.state, context.setup.model.field
    total = sum((state.potential(push) for push in applied_loads), f.zero)
    symbol = name_of(context, "V", load)

    def read(world: World) -> float:
        return float(sum(world.snapshot.potential(push) for push in applied_loads))

    what = Sentence("symbol.potential_of", {"load": load})
    script.introduce(Meaning(symbol, what, read, "J"))
    return script.line(symbol, tidy(f.lowest_terms(total)), why="energy.of_load", args={"load": load})


# -- momentum ---------------------------------------------------------------------------------
@_told.register(Momentum)
def _momentum(q: Momentum, context: Context, script: Script) -> tuple[list[int], list[Expr]]:
    """The velocities of the mass centres that are meant."""
    lines: list[int] = []
    with script.stage("stage.parts", "hint.parts"):
        for body in context.system.moving:
            if is_among(body.name, q.body):
                x, y = _velocity(context, body.name)
                context.rates.announce(script, [*x, *y])
                lines += context.rates.explain_velocities(script, [*x, *y])
    return lines, []


@_told.register(AngularMomentum)
def _spin(q: AngularMomentum, context: Context, script: Script) -> tuple[list[int], list[Expr]]:
    """H = I w + r x m v of every body that is meant, and the symbols of these parts."""
    if q.about == SYSTEM_CENTER:
        return [], []
    lines: list[int] = []
    symbols: list[Expr] = []
    with script.stage("stage.parts", "hint.parts"):
        for body in context.system.moving:
            if is_among(body.name, q.body):
                more = _spin_of(context, script, q, body)
                lines += more
                symbols += [name_of(context, "H", body.name)] if more else []
    return lines, symbols


def _spin_of(context: Context, script: Script, q: AngularMomentum, body: RigidBody) -> list[int]:
    system, f = context.system, context.setup.model.field
    mass, _m, inertia = context.setup.model.dynamics.inertias[body.name]
    x, y = _velocity(context, body.name)
    turning = context.rates.kinematics.turning(body.name, 1) if body.turns else None
    about, _v = point_about(system, context.setup.state, q)
    arm = [a - b for a, b in zip(place(system, context.setup.state, body.mass_center), about, strict=True)]
    shown: list[Expr] = []
    if turning is not None and not inertia.is_zero():
        shown.append(scaled(f.lowest_terms(inertia * turning.coefficient), turning.symbol))
    for terms, factor in ((x, -arm[1] * mass), (y, arm[0] * mass)):
        if not factor.is_zero():
            shown += [scaled(f.lowest_terms(factor * t.coefficient), t.symbol) for t in terms]
    if not shown:
        return []
    point = q.about if isinstance(q.about, Point) else body.mass_center if isinstance(q.body, str) else None
    symbol, what = name_of(context, "H", body.name), Sentence("symbol.spin_of", {"body": body.name})
    script.introduce(Meaning(symbol, what, AngularMomentum(body.name, point or ORIGIN), "kg m^2/s"))
    moving = [*x, *y, *([turning] if turning is not None else [])]
    context.rates.announce(script, moving)
    own = script.line(symbol, positive_first(shown), why="momentum.of_body", args={"body": body.name})
    return [own, *context.rates.explain_velocities(script, moving)]


# -- moments of inertia -----------------------------------------------------------------------
@_told.register(MomentOfInertia)
def _inertia(q: MomentOfInertia, context: Context, script: Script) -> tuple[list[int], list[Expr]]:
    """I = I_S + m d^2 of every body, or of the parts of which it is composed."""
    lines: list[int] = []
    symbols: list[Expr] = []
    with script.stage("stage.parts", "hint.parts"):
        script.say("inertia.principle")
        for body in q.meant(context.system):
            own = (BodyPart("", body.mass, body.inertia if body.turns else ZERO, (ZERO, ZERO)),)
            for part in body.parts or own:
                lines.append(_inertia_of(context, script, q, body, part))
                symbols.append(_inertia_symbol(context, q, body, part))
    return lines, ([] if q.is_radius else symbols)


def _inertia_symbol(context: Context, q: MomentOfInertia, body: RigidBody, part: BodyPart) -> Symbol:
    """I_rim_A: each axis has its own, as a sheet may ask for several."""
    about = "S" if q.about is None else str(q.about).removeprefix(f"{body.name}.").replace(".", "_")
    name = f"{part.name or body.name}_{about}"
    return context.symbol(f"I_{name}", f"I_{body.name}_{name}")


def _inertia_of(context: Context, script: Script, q: MomentOfInertia, body: RigidBody, part: BodyPart) -> int:
    system, f = context.system, context.setup.model.field
    middle = Point(body.name, part.center)

    def about(state: State[Any]) -> tuple[Any, Any, Any]:
        distance = squared_distance(system, state, middle, q.through(system, state))
        return state.scalar(part.inertia), state.scalar(part.mass), distance

    def read(world: World) -> float:
        inertia, mass, distance = about(world.snapshot)
        return float(inertia + mass * distance)

    symbol = _inertia_symbol(context, q, body, part)
    what = Sentence("symbol.inertia_of", {"part": part.name or body.name})
    script.introduce(Meaning(symbol, what, read, "kg m^2"))
    inertia, mass, distance = (f.lowest_terms(f.element(one)) for one in about(context.setup.state))
    moved = multiply(tidy(mass), tidy(distance))
    return script.line(symbol, add(tidy(inertia), moved), why="inertia.of_part")


# -- instant centres --------------------------------------------------------------------------
@_told.register(InstantCentre)
def _centre(q: InstantCentre, context: Context, script: Script) -> tuple[list[int], list[Expr]]:
    """The velocity of the point of each body at the origin, and its angular velocity."""
    lines: list[int] = []
    with script.stage("stage.parts", "hint.centre"):
        script.say("centre.principle")
        for body in (q.body, q.relative_to):
            if context.system.bodies[body].fixed:
                continue
            for k, (letter, key) in enumerate((("u", "x"), ("u", "y"), ("omega", ""))):
                lines.append(_of_body(context, script, body, k, f"{letter}_{body}{f'_{key}' if key else ''}"))
    return lines, []


def _of_body(context: Context, script: Script, body: str, k: int, name: str) -> int:
    def read(world: World) -> float:
        return float(motion_at_origin(context.system, world.snapshot, body)[k])

    f = context.setup.model.field
    what = Sentence("symbol.turning_1" if k == 2 else "symbol.at_origin", {"body": body, "axis": f"@axis.{'xyz'[k]}"})
    script.introduce(Meaning(Symbol(name), what, read, "rad/s" if k == 2 else "m/s"))
    value = motion_at_origin(context.system, context.setup.state, body)[k]
    return script.line(Symbol(name), tidy(f.lowest_terms(f.element(value))), why="kinematics.seen")
