"""Gear trains with one member held: ratio, efficiency, and the share of the power that rolls in the teeth.

Seen from the member h that is held, a turns with w_a - w_h: the ratio of two others is (w_a - w_h)/(w_b - w_h), however
the train moves in fact (Willis). Only what rolls in the teeth is lost. With the basic efficiency eta of the train whose
carrier C is held and the central gears S, b, where S is not held, T_b = -T_S eta^(+-1) (w_S - w_C)/(w_b - w_C), and
T_C = -T_S - T_b. The upper sign holds where S puts in what rolls, T_S (w_S - w_C) > 0; T_S has the sign of w_S where S
drives, and the other one where it is driven. Less than nothing comes out where the train locks itself. Source: R.
Willis, Principles of Mechanism, 1841; Mueller, Die Umlaufgetriebe, 2nd ed. 1998, ch. 4; Norton, Design of Machinery,
sec. 9.7-9.11.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from freebody.errors import CannotAnswer
from freebody.language.parser import parse
from freebody.language.sentences import Message, Sentence
from freebody.language.units import DIMENSIONLESS
from freebody.measures.angle import Angle
from freebody.model.gear_train import gear_trains
from freebody.model.noting import did_you_mean
from freebody.model.state import State
from freebody.questions.arithmetic import quotient
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import NAME, Found, asked

if TYPE_CHECKING:
    from collections.abc import Sequence

    from freebody.model.names import Names

_HELD = rf"with (?:the )?(?P<held>{NAME}) (?:held|fixed|at rest|braked)"
_BETWEEN = rf"(?:the )?(?P<first>{NAME}) to (?:the )?(?P<second>{NAME})"
RANK = 77
TRAIN = """
parameters: {m: 2 mm, z_S: 24, z_P: 18, eta: 0.98}
bodies:
  sun: {body: {inertia: 1 g m^2, radius: m*z_S/2}}
  planet: {body: {mass: 0.1 kg, radius: m*z_P/2}}
  carrier: {body: {inertia: 1 g m^2}, points: {axle: [m*(z_S + z_P)/2, 0]}}
  ring: {ring: {mass: 1 kg, radius: m*(z_S + 2*z_P)/2}}
connections:
  a: {pin: [ground.S, sun]}
  b: {pin: [ground.S, carrier]}
  c: {pin: [carrier.axle, planet]}
  d: {pin: [ground.S, ring]}
  inner: {gear_mesh: {first: sun, second: planet, module: m, teeth: [z_S, z_P]}}
  outer: {gear_mesh: {first: ring, second: planet, internal: true, module: m, teeth: [z_S + 2*z_P, z_P]}}
"""


@dataclass(frozen=True)
class OfHeldTrain(Quantity):
    """What is asked of a gear train of the plane with a member held."""

    driving: str
    driven: str
    held: str

    @property
    def unit(self) -> str:
        return "1"

    @property
    def is_of_pose_in_motion(self) -> bool:
        return True

    @property
    def kinematic_order(self) -> int:
        return 1

    def sentence(self, system: Described) -> Sentence:
        args = {"first": self.driving, "second": self.driven, "held": self.held}
        return Sentence(f"what.{self.kind.replace(' ', '_')}", args)


@dataclass(frozen=True)
class HeldRatio(OfHeldTrain, kind="ratio with a member held"):
    """Turns of one member for a turn of another, seen from a third one."""

    example = f"{TRAIN}questions: {{it: ratio of sun to carrier with ring held}}\n"

    def value(self, system: Described, state: State[Any]) -> Any:
        return quotient(
            _against(system, state, self.driving, self.held), _against(system, state, self.driven, self.held)
        )


@dataclass(frozen=True)
class OfRollingPower(OfHeldTrain):
    """What is asked of the power that rolls in the teeth of a planetary gear. central: a central gear that is not held;
    other: the other one."""

    carrier: str
    central: str
    other: str

    def _rolling(self, system: Described, state: State[Any]) -> Any:
        """(w_S - w_C)/w_S, where the power that rolls is T_S (w_S - w_C)."""
        return quotient(
            _against(system, state, self.central, self.carrier), _against(system, state, self.central, self.held)
        )


@dataclass(frozen=True)
class HeldEfficiency(OfRollingPower, kind="efficiency with a member held"):
    """The share of the power that comes out, by the basic efficiency between the two central gears."""

    basic: str  # a parameter, or a number

    example = f"{TRAIN}questions: {{it: efficiency from sun to carrier with ring held and basic efficiency eta}}\n"

    def value(self, system: Described, state: State[Any]) -> Any:
        eta = state.scalar(parse(self.basic))
        if self.held == self.carrier:
            return eta
        turn = self._rolling(system, state)
        # eta where S puts in what rolls, else 1/eta
        way = quotient(turn, state.absolute(turn)) * (1 if self.driving == self.central else -1)
        loss = (eta + 1 / eta) / 2 + way * (eta - 1 / eta) / 2
        central = [_against(system, state, body, self.carrier) for body in (self.central, self.other)]
        speeds = [_against(system, state, body, self.held) for body in (self.driving, self.driven)]
        return passed_on(self, loss, central, speeds)

    @property
    def remarks(self) -> tuple[Message, ...]:
        return (Message("the train locks itself where it is not positive"),)


@dataclass(frozen=True)
class RollingShare(OfRollingPower, kind="rolling power with a member held"):
    """The power that rolls in the teeth over what goes through, without losses; where it is more than 1, power
    circulates."""

    example = f"{TRAIN}questions: {{it: rolling power from sun to carrier with ring held}}\n"

    def value(self, system: Described, state: State[Any]) -> Any:
        return state.absolute(self._rolling(system, state))

    @property
    def remarks(self) -> tuple[Message, ...]:
        return (Message("over the power that goes through, without losses; where it is more than 1, power circulates"),)


def passed_on(train: OfRollingPower, loss: Any, central: Sequence[Any], speeds: Sequence[Any]) -> Any:
    """The power that comes out over what goes in. central: speeds of both central gears against the carrier; speeds:
    of what drives and what is driven against what is held; loss: eta where the first central gear puts in what rolls,
    else 1/eta."""
    bears = -loss * quotient(*central)  # T_b for T_S = 1
    torque = {train.central: 1, train.other: bears, train.carrier: -1 - bears}
    return -torque[train.driven] * quotient(speeds[1], speeds[0]) / torque[train.driving]


def _against(system: Described, state: State[Any], body: str, other: str) -> Any:
    """The angular velocity of a body against another one."""
    own, its = (0 if system.bodies[name].fixed else state.rate(Angle(name)) for name in (body, other))
    return own - its


# -- words ------------------------------------------------------------------------------------
@asked(
    "ratio of BODY to BODY with BODY held",
    rf"(?:gear |speed |transmission )?ratio (?:of|from) {_BETWEEN} {_HELD}",
    rank=RANK,
)
def _ratio(names: Names, found: Found, path: Path) -> Quantity | None:
    three = _three(names, found, path)
    return None if three is None else HeldRatio(*three)


@asked(
    "efficiency from BODY to BODY with BODY held and basic efficiency PARAMETER | NUMBER",
    rf"efficiency from {_BETWEEN} {_HELD} (?:and|with|by|at) (?:the )?"
    rf"basic efficiency (?P<basic>{NAME}|[01](?:\.[0-9]+)?)",
    rank=RANK,
)
def _efficiency(names: Names, found: Found, path: Path) -> Quantity | None:
    basic = names.parameters.get(found["basic"])
    is_number = found["basic"][0].isdigit() and 0.0 < float(found["basic"]) <= 1.0
    if not is_number and (basic is None or basic.dimension != DIMENSIONLESS or basic.form is not None):
        hint = did_you_mean(found["basic"], names.parameters)
        told = Message(
            "the basic efficiency is a number over 0 and up to 1, or a parameter for it; {name} is neither.{hint}",
            name=found["basic"],
            hint=hint,
        )
        names.unknown(found["basic"], told, *path)
        return None
    parts = _parts(names, found, path)
    return None if parts is None else HeldEfficiency(*parts, found["basic"])


@asked("rolling power from BODY to BODY with BODY held", rf"rolling power from {_BETWEEN} {_HELD}", rank=RANK)
def _rolling_power(names: Names, found: Found, path: Path) -> Quantity | None:
    parts = _parts(names, found, path)
    return None if parts is None else RollingShare(*parts)


def _three(names: Names, found: Found, path: Path) -> tuple[str, str, str] | None:
    """The member that drives, the one that is driven, and the one that is held."""
    if names.space:
        names.problem(
            Message("ratios with a member held are for gears with parallel axes, in models of the plane"), *path
        )
        return None
    bodies = [names.body(found[key], *path) for key in ("first", "second", "held")]
    first, second, held = (body.name for body in bodies)
    still = next((body.name for body in bodies if not (body.turns or body.fixed)), None)
    if still is not None:
        names.problem(Message("{body} does not turn", body=still), *path)
        return None
    if len({first, second, held}) < 3:
        names.problem(Message("name three members: one that drives, one that is driven, and one that is held"), *path)
        return None
    return first, second, held


def _parts(names: Names, found: Found, path: Path) -> tuple[str, str, str, str, str, str] | None:
    """The same with the carrier and the two central gears of the train."""
    three = _three(names, found, path)
    if three is None:
        return None
    try:
        trains = gear_trains(names)
    except CannotAnswer as error:
        names.problem(str(error), *path)
        return None
    train = next((t for t in trains if t.carrier in three and set(three) <= {t.carrier, *t.members}), None)
    if train is None:
        meant = next((t for t in trains if t.carrier in three), trains[0])
        told = Message(
            "power goes between the carrier {carrier} and two of the gears that mesh with its planets: {members}",
            carrier=meant.carrier,
            members=", ".join(meant.members),
        )
        names.problem(told, *path)
        return None
    central = [body for body in three if body != train.carrier]
    central.sort(key=lambda body: body == three[2])  # one that is not held stands first
    return *three, train.carrier, central[0], central[1]
