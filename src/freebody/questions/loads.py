"""Questions about loads and drivers: their force, their power, their work."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from freebody.errors import CannotAnswer
from freebody.language.expression import (
    ZERO,
    Expr,
    add,
    differentiate,
    divide,
    free_symbols,
    multiply,
    negate,
    substitute,
)
from freebody.language.sentences import Message, Sentence
from freebody.language.units import ENERGY, LENGTH, POWER, TORQUE, Dimension
from freebody.measures.base import Measure
from freebody.model.elements import VALUE, AppliedLoad, NonholonomicForm
from freebody.model.noting import did_you_mean
from freebody.model.state import State
from freebody.questions.base import Described, Passage, Path, Quantity
from freebody.questions.course import Counted
from freebody.questions.forms import NAME, Found, asked

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class LoadForce(Quantity, kind="load"):
    """Force or torque of a load; a spring's or damper's is positive when it pulls. is_thrust: the opposite, a
    compressive force. only_pushes: whether it never pulls, as a buffer; its greatest force is the greatest thrust.
    either_way: what pulls and pushes by its own law, as a spring; its greatest force is that of its size."""

    load: str
    pushes_with: Dimension
    is_thrust: bool = False
    only_pushes: bool = False
    either_way: bool = False
    is_size: bool = False

    example = """
bodies: {ball: {particle: {mass: 1 kg}, at: [2 m, 0]}}
loads: {spring: {spring: {first: ground.A, second: ball, stiffness: 5 N/m, length: 1 m}}}
questions: {it: force in spring}
"""

    @property
    def dimension(self) -> Dimension:
        return self.pushes_with

    def value(self, system: Described, state: State[Any]) -> Any:
        applied_loads = [p for p in system.applied_loads if p.load == self.load]
        force = system.loads[self.load].pulls_with([state.law(p) for p in applied_loads], state.sqrt)
        if force is None:
            raise CannotAnswer(Message("{load} acts on several bodies; ask for one body's part", load=self.load))
        if self.is_size:
            return state.absolute(force)
        return -force if self.is_thrust else force

    @property
    def remarks(self) -> tuple[Message, ...]:
        return (Message("of its size: {load} pulls and pushes", load=self.load),) if self.is_size else ()

    @property
    def with_sign(self) -> Quantity:
        return replace(self, is_size=False)

    def sized(self, *, space: bool, most: bool = False) -> Quantity:
        if most and self.either_way and not self.is_thrust:
            return replace(self, is_size=True)
        return replace(self, is_thrust=True) if self.only_pushes else self

    def place_of(self, names: Names, value: Expr) -> tuple[Measure, Expr] | None:
        found = _spring(names, self.load)
        return None if found is None else found.length_at(negate(value) if self.is_thrust else value)

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.thrust" if self.is_thrust else "what.load", {"load": self.load})


@dataclass(frozen=True)
class Extension(Quantity, kind="extension"):
    """By how much a spring is longer than without force, or shorter (its compression): its force over its stiffness.
    What acts on one side only, as an elastic string, has none where it exerts no force."""

    force: LoadForce
    stiffness: Expr
    is_compression: bool = False

    example = """
bodies: {ball: {particle: {mass: 1 kg}, at: [2 m, 0]}}
loads: {spring: {spring: {first: ground.A, second: ball, stiffness: 5 N/m, length: 1 m}}}
questions: {it: extension of spring at start}
"""
    measured_in = LENGTH

    def value(self, system: Described, state: State[Any]) -> Any:
        return self.by_force(self.force.value(system, state), state)

    def by_force(self, force: Any, state: State[Any]) -> Any:
        """l - l0 = F/k, with the law F = k (l - l0) of a spring; a preload F0 at l_1 is one at another l0."""
        return (-1 if self.is_compression else 1) * force / state.scalar(self.stiffness)

    def place_of(self, names: Names, value: Expr) -> tuple[Measure, Expr] | None:
        found = _spring(names, self.force.load)
        force = multiply(self.stiffness, negate(value) if self.is_compression else value)
        return None if found is None else found.length_at(force)

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.compression" if self.is_compression else "what.extension", {"load": self.force.load})


@dataclass(frozen=True)
class _Spring:
    """What pulls with F = k (l - l0) at every length l."""

    length: Measure
    stiffness: Expr
    pull_at_zero: Expr  # -k l0

    def length_at(self, force: Expr) -> tuple[Measure, Expr]:
        return self.length, divide(add(force, negate(self.pull_at_zero)), self.stiffness)


def _spring(names: Names, load: str) -> _Spring | None:
    """The load, if it is one linear spring that pulls and pushes."""
    pushes = [p for p in names.applied_loads if p.load == load]
    if len(pushes) != 1 or "spring" not in names.called.get(load, ()) or pushes[0].one_sided is not None:
        return None
    (push,) = pushes
    stiffness = stiffness_of(push)
    if stiffness is None or isinstance(push.measure, NonholonomicForm):
        return None
    return _Spring(push.measure, stiffness, negate(substitute(push.law, {VALUE.name: ZERO})))


def stiffness_of(push: AppliedLoad) -> Expr | None:
    """The slope of a law that is linear in a length; None of others, and of what acts on one side with a preload, whose
    force does not tell how far it is compressed before it is touched."""
    law = push.law if push.one_sided is None else push.one_sided.law
    slope = differentiate(law, VALUE.name)
    is_linear = VALUE.name not in free_symbols(slope) and push.measure.dimension == LENGTH
    is_told = push.one_sided is None or substitute(law, {VALUE.name: ZERO}) == ZERO
    return negate(slope) if is_linear and is_told and slope != ZERO else None


@dataclass(frozen=True)
class Power(Quantity, kind="power"):
    """Power of a load or a driver."""

    of: str

    example = """
bodies: {ball: {particle: {mass: 2 kg}}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: power of weight}
"""
    measured_in = POWER

    @property
    def may_jump(self) -> bool:
        return True

    def value(self, system: Described, state: State[Any]) -> Any:
        total: Any = 0
        for push in system.applied_loads:
            if push.load == self.of:
                total = total + state.law(push) * state.rate(push.measure)
        for row in system.constraint_rows:
            if row.connection == self.of:
                total = total + state.multiplier(row) * state.rate(row.measure)
        return total

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.power", {"of": self.of})


@dataclass(frozen=True)
class Work(Counted, kind="work"):
    """Work of a load from the start to the event, or of dry friction, which is negative."""

    of: str

    example = """
bodies: {ball: {particle: {mass: 2 kg}}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {y: y of ball}
questions: {it: work of weight until y = -5 m}
"""
    measured_in = ENERGY
    until = "x = h"

    @property
    def letter(self) -> str:
        return "W"

    @property
    def unit(self) -> str:
        return "J"

    def counted(self, passage: Passage[Any]) -> Any:
        return passage.work(self.of)

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.work", {"of": self.of})


# -- words ------------------------------------------------------------------------------------
@asked(
    "[compressive] force in SPRING | of LOAD [on BODY] [along DIRECTION]",
    rf"(?P<thrust>compressive |compression |pushing )?(?P<what>force|torque) (?:in|of) (?:the )?(?P<of>{NAME})",
    rank=45,
)
def _load_force(names: Names, found: Found, path: Path) -> Quantity | None:
    of = str(found["of"])
    if of not in names.loads:
        reactions = dict.fromkeys(row.reaction for row in names.constraint_rows if row.connection == of)
        if of in names.connections and reactions:
            ways = "; ".join(f"{reaction} of {of}" for reaction in reactions)
            names.problem(Message("{of} is a connection; ask for: {ways}", of=of, ways=ways), *path)
        else:
            names.unknown(
                of, Message("there is no load {name}.{hint}", name=of, hint=did_you_mean(of, names.loads)), *path
            )
        return None
    if found["what"] == "torque" and names.loads[of] != TORQUE:
        names.problem(Message("{of} exerts a force and no torque; ask for: force in {of}", of=of), *path)
        return None
    return replace(load_force(names, of), is_thrust=bool(found["thrust"]))


def load_force(names: Names, load: str) -> LoadForce:
    """The force of a load that is known."""
    sides = [p.one_sided for p in names.applied_loads if p.load == load]
    only_pushes = bool(sides) and all(side is not None and not side.pulls for side in sides)
    either_way = _spring(names, load) is not None
    return LoadForce(load, names.loads[load], only_pushes=only_pushes, either_way=either_way)


@asked(
    "extension | compression of SPRING",
    rf"(?P<what>extension|elongation|compression) of (?:the )?(?P<of>{NAME})",
    rank=70,
)
def _extension(names: Names, found: Found, path: Path) -> Quantity | None:
    of = str(found["of"])
    springs = {
        p.load: k
        for p in names.applied_loads
        if "spring" in names.called.get(p.load, ()) and (k := stiffness_of(p)) is not None
    }
    is_spring = "spring" in names.called.get(of, ()) and of not in springs
    if is_spring and any(p.load == of and p.one_sided is not None for p in names.applied_loads):
        told = Message("{name} is compressed before it is touched; ask for: force in {name}", name=of)
        names.problem(told, *path)
        return None
    if of not in springs:
        told = Message("{name} is no spring with a stiffness.{hint}", name=of, hint=did_you_mean(of, [*springs]))
        names.unknown(of, told, *path)
        return None
    return Extension(LoadForce(of, names.loads[of]), springs[of], found["what"] == "compression")


@asked("power | work of LOAD", rf"(?P<what>power|work) of (?P<of>{NAME})", rank=30)
def _power(names: Names, found: Found, path: Path) -> Quantity | None:
    of = str(found["of"])
    known = [*names.loads, *names.connections]
    if of not in known:
        told = Message("there is no load or driver {name}.{hint}", name=of, hint=did_you_mean(of, known))
        names.unknown(of, told, *path)
        return None
    return Power(of) if found["what"] == "power" else Work(of)
