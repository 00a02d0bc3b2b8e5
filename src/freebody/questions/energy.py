"""Questions about energies."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, cast

from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate, free_symbols, replace_rates, substitute
from freebody.language.sentences import Sentence
from freebody.language.units import ENERGY
from freebody.measures.geometry import ZERO
from freebody.model.elements import RATE, VALUE, AppliedLoad, RigidBody
from freebody.model.spins import body_axes
from freebody.model.state import State
from freebody.model.tensors import entries
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import NAME, Found, asked
from freebody.questions.vectors import Vector, angular_velocity, dot, place, said_of, turning_rate

if TYPE_CHECKING:
    from freebody.model.names import Names

_SOME = 1.7  # a value for a parameter


@dataclass(frozen=True)
class Energy(Quantity, kind="energy"):
    """Kinetic, potential or total energy, of the system or one body."""

    what: Literal["kinetic", "potential", "total"]
    body: str | None = None

    example = """
bodies: {ball: {particle: {mass: 2 kg}}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: kinetic energy}
"""
    measured_in = ENERGY
    may_be_conserved = True

    @property
    def unit(self) -> str:
        return "J"

    @property
    def principle(self) -> str:
        return "energy" if self.what == "total" and self.body is None else "other"

    @property
    def letter(self) -> str:
        return {"kinetic": "T", "potential": "V", "total": "E"}[self.what]

    @property
    def is_of_whole(self) -> bool:
        return self.body is None

    @property
    def is_up_to_constant(self) -> bool:
        return self.what != "kinetic"

    def value(self, system: Described, state: State[Any]) -> Any:
        """Kinetic energy m v^2/2 + I w^2/2; potential energy of the loads that store energy."""
        total: Any = 0
        if self.what != "potential":
            for b in system.moving:
                if self.body in (None, b.name):
                    total = total + kinetic_energy(system, state, b)
        if self.what != "kinetic":
            for push in system.applied_loads:
                own = self.body is None or self.body in set(push.measure.bodies())
                if own and system.loads[push.load].stores_energy and not is_lossy(push):
                    total = total + state.potential(push)
        return total

    def sentence(self, system: Described) -> Sentence:
        return Sentence(f"what.{self.what}_energy", {"of": said_of(self.body)})


def is_lossy(push: AppliedLoad) -> bool:
    """Whether a law hangs on the rate of its measure, or on the time: like a damper, it stores nothing."""
    return not push.measures and bool({RATE.name, "t"} & free_symbols(push.in_symbols))


def resists(system: Described, load: str) -> bool:
    """Whether a load resists motion and stores nothing: drag, a damper, what vanishes where nothing moves, as a law
    -c*rate(s)^2 or a force of that magnitude."""
    pushes = [push for push in system.applied_loads if push.load == load]
    return system.loads[load].resists or (bool(pushes) and all(map(_vanishes_at_rest, pushes)))


def goes_by_rates(system: Described, load: str) -> bool:
    """Whether a load depends on how fast something moves, and does not only resist."""
    pushes = [push for push in system.applied_loads if push.load == load]
    return not resists(system, load) and any(_at_rest(push) != push.in_symbols for push in pushes)


def mixes(system: Described, load: str) -> bool:
    """Whether a load goes by places and by rates at once, so that what it takes and what it stores are not told
    apart: a spring and a damper in one law."""
    pushes = [push for push in system.applied_loads if push.load == load]  # the parts of its law
    goes = any(_at_rest(push) != push.in_symbols for push in pushes)
    places = (free_symbols(_at_rest(push)) & {VALUE.name, *(name for name, _ in push.measures)} for push in pushes)
    return not system.loads[load].resists and goes and any(places)


def _at_rest(push: AppliedLoad) -> Expr:
    """A law where nothing moves."""
    rates = {name: ZERO for name, _measure in push.measures}
    return substitute(replace_rates(push.in_symbols, rates), {RATE.name: ZERO})


def _vanishes_at_rest(push: AppliedLoad) -> bool:
    law, at_rest = push.in_symbols, _at_rest(push)
    if at_rest == law or "t" in free_symbols(law):
        return False
    values = {name: _SOME + k / _SOME for k, name in enumerate(sorted(free_symbols(law)))}
    try:
        is_still = evaluate(at_rest, values, FLOAT_FUNCTIONS) == 0.0
        if push.measures:
            return is_still
        forth, back = (evaluate(law, values | {RATE.name: rate}, FLOAT_FUNCTIONS) for rate in (1.0, -1.0))
        return is_still and (forth < 0.0 or back > 0.0)  # else it drives on what moves
    except (ArithmeticError, ValueError, KeyError):
        return False


def kinetic_energy(system: Described, state: State[Any], b: RigidBody) -> Any:
    """Of one body."""
    total = translational_energy(system, state, b)
    if b.turns and system.space:
        omega = angular_velocity(system, state, b.name, body_axes(b.name))
        total = total + dot(omega, times_tensor(b, state, omega)) / 2
    elif b.turns:
        w = turning_rate(state, b.name)
        total = total + state.scalar(b.inertia) * w * w / 2
    return total


def translational_energy(system: Described, state: State[Any], b: RigidBody) -> Any:
    """Of the motion of one body with its mass centre."""
    v = place(system, state, b.mass_center, 1)
    return state.scalar(b.mass) * dot(v, v) / 2


def times_tensor(body: RigidBody, state: State[Any], omega: Vector) -> Vector:
    """I omega along the body's axes."""
    return tuple(dot(tuple(state.scalar(e) for e in row), omega) for row in entries(body.tensor or (ZERO,) * 6))


@asked(
    "kinetic | potential | total energy [of BODY]",
    rf"(?P<what>kinetic|potential|total|mechanical) energy(?: of (?:the )?(?P<of>{NAME}))?",
    rank=40,
)
def _energy(names: Names, found: Found, path: Path) -> Quantity | None:
    of = found["of"]
    body = None if of is None or of == "system" else names.body(of, *path).name
    what = str(found["what"]).replace("mechanical", "total")
    return Energy(cast("Any", what), body)
