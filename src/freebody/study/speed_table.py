"""The speed table of a planetary gear (Willis): everything turns with the carrier, and against it while it is held.

With the angular velocities w_C of the carrier, w_S of one central gear S and the train ratio k of another gear b while
the carrier is held,

    w_b = w_C + k_b (w_S - w_C),       k_b = (w_b - w_C)/(w_S - w_C).

One more condition, that a gear is held, gives every ratio. The torques of three central members S, b, C have the sum
zero; with the efficiency eta of the train whose carrier is held, T_b = -T_S eta^(+1)/k where S drives against the
carrier, and eta^(-1) where b does. The power that rolls in the teeth is T_S (w_S - w_C): where it is more than what
goes through, power circulates (see `questions.gear_trains`). Source: R. Willis, Principles of Mechanism, 1841;
Norton, Design of Machinery, 5th ed. 2012, sec. 9.7-9.11; Mueller, Die Umlaufgetriebe, 2nd ed. 1998, ch. 4.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import combinations, permutations
from typing import Any

from freebody.errors import CannotAnswer, InputError
from freebody.language.expression import ZERO, Expr, Symbol, add, evaluate, multiply
from freebody.language.notation import to_text
from freebody.language.sentences import Message, further
from freebody.measures.angle import Angle
from freebody.model.gear_train import GearTrain, gear_trains
from freebody.present.lines import number_text
from freebody.present.report.blocks import Block, Report, Section
from freebody.present.report.result import Result
from freebody.present.report.results import entries, entry, summary, table
from freebody.questions.gear_trains import OfRollingPower, passed_on
from freebody.study.setup import Setup
from freebody.study.worded import in_words
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF

_AGREES = 1e-8  # of both routes
_ETA = "eta"  # the efficiency in formulas


@dataclass(frozen=True)
class HeldMember:
    """What is so while one central member is held. ratio: turns of `driving` for one of `driven`; efficiency: of the
    power from `driving` to `driven`, None where no efficiency of the teeth is given; rolling: the power that rolls in
    the teeth over what goes through, without losses."""

    held: str
    driving: str
    driven: str
    ratio: Expr
    ratio_value: float | None
    efficiency: Expr | None = None
    efficiency_value: float | None = None
    rolling: float | None = None


@dataclass(frozen=True)
class SpeedTable(Result):
    """The speed table of a gear train. relative: turns of each body against the carrier for one of the `reference`;
    further: the tables of the other carriers, where a model has several (two planetary gears that share members)."""

    system: System
    carrier: str
    reference: str
    relative: dict[str, Expr]
    values: dict[str, float | None]
    cases: tuple[HeldMember, ...]
    difference: float
    further: tuple[SpeedTable, ...] = ()

    @property
    def report(self) -> Report:
        """The table, and the ratios with one member held."""
        return summary(self.system.title, (block for each in self._all() for block in each.blocks()))

    def _all(self) -> tuple[SpeedTable, ...]:
        return (self, *self.further)

    def blocks(self) -> Iterator[Block]:
        """The report of this carrier alone."""
        x, y = Symbol("x"), Symbol("y")
        rows = [[b, "x", to_text(multiply(k, y)), to_text(add(x, multiply(k, y)))] for b, k in self.relative.items()]
        head = (Message("body"), Message("with the carrier"), Message("carrier held"), Message("together"))
        turns = Message(
            "{carrier}: all turn x with it, then {gear} turns y against it", carrier=self.carrier, gear=self.reference
        )
        agree = Message("both routes agree: largest relative difference {gap:.0e}", gap=self.difference)
        yield from entries(entry(Message("carrier"), turns), entry(Message("evidence"), agree))
        yield Section((Message("Speed table"),), tuple(table(rows, head)))
        ratios = [[c.held, f"{c.driving} : {c.driven}", to_text(c.ratio), _number(c.ratio_value)] for c in self.cases]
        held, value = Message("held"), Message("value")
        title = Message("Ratios with one member held")
        yield Section((title,), tuple(table(ratios, (held, Message("ratio"), "", value))))
        if any(c.efficiency is not None for c in self.cases):
            columns = (held, Message("from, to"), "", value, "")
            yield Section((Message("Efficiency"),), tuple(table(map(_flow, self.cases), columns)))

    def to_plain(self) -> dict[str, Any]:
        """Plain data: carrier, reference, relative turns, cases; `further` tables where there are several carriers."""
        further = {"further": [each.to_plain() for each in self.further]} if self.further else {}
        return {
            "title": self.system.title,
            "carrier": self.carrier,
            "reference": self.reference,
            "relative": {b: {"formula": to_text(k), "value": self.values[b]} for b, k in self.relative.items()},
            "cases": [
                {
                    "held": c.held,
                    "driving": c.driving,
                    "driven": c.driven,
                    "ratio": to_text(c.ratio),
                    "ratio_value": c.ratio_value,
                    "efficiency": None if c.efficiency is None else to_text(c.efficiency),
                    "efficiency_value": c.efficiency_value,
                    "rolling": c.rolling,
                }
                for c in self.cases
            ],
            "worst_relative_difference": self.difference,
            **further,
        }

    def ratio(self, driving: str, driven: str, held: str) -> HeldMember:
        """The case of one pair. Raises InputError where there is none."""
        for case in (case for each in self._all() for case in each.cases):
            if (case.driving, case.driven, case.held) == (driving, driven, held):
                return case
        told = Message("{a}, {b} and {held} are no three members of the train", a=driving, b=driven, held=held)
        raise InputError(told)


def _number(value: float | None) -> str:
    return "" if value is None else number_text(value)


def _flow(c: HeldMember) -> list[str]:
    way = Message("{driving} to {driven}", driving=c.driving, driven=c.driven)
    if c.efficiency is None or c.efficiency_value is None or c.rolling is None:
        return [c.held, way, "", "", ""]
    rolls: str = Message("{share} of the power rolls", share=number_text(c.rolling))
    if c.efficiency_value <= 0:
        rolls = further(rolls, Message("locks itself"))
    elif c.rolling > 1.0 + ROUND_OFF:
        rolls = further(rolls, Message("power circulates"))
    return [c.held, way, to_text(c.efficiency), number_text(c.efficiency_value), rolls]


@in_words
def speed_table(system: System, *, efficiency: float | None = None) -> SpeedTable:
    """The speed table of the planetary gear of a system. efficiency: that of the train whose carrier is held, between
    two central gears. Raises CannotAnswer where no carrier bears a gear."""
    if efficiency is not None and not 0.0 < efficiency <= 1.0:
        raise InputError(Message("an efficiency is between 0 and 1, found {eta:g}", eta=efficiency))
    if system.space:
        raise CannotAnswer(Message("speed tables are for gears with parallel axes, in models of the plane"))
    first, *others = (_Train(system, train, efficiency).table() for train in gear_trains(system.names))
    return replace(first, further=tuple(others))


class _Train:
    """One carrier with its gears: the speeds of both routes."""

    def __init__(self, system: System, train: GearTrain, efficiency: float | None) -> None:
        self.system, self.efficiency = system, efficiency
        self.carrier, self.planets, self.members = train.carrier, train.planets, train.members
        self.setup = Setup(system)
        self.field = self.setup.model.field
        self.values = {name: p.value for name, p in system.parameters.items() if p.value is not None}
        self.reference = next((b for b in self.members if not self._against(b).is_zero()), "")
        if not self.reference:
            raise CannotAnswer(Message("nothing turns against the carrier {carrier}", carrier=self.carrier))

    def _against(self, body: str) -> Ratio:
        """The angular velocity against the carrier."""
        state = self.setup.state
        own = self.field.zero if self.system.bodies[body].fixed else state.rate(Angle(body))
        return own - state.rate(Angle(self.carrier))

    def table(self) -> SpeedTable:
        bodies = [*self.members, *self.planets]
        turns = {b: self.field.lowest_terms(self._against(b) / self._against(self.reference)) for b in bodies}
        speeds = {c.speed for c in self.setup.model.coordinates}
        loose = [b for b, k in turns.items() if self.field.ingredients(k) & speeds]
        if loose:
            told = Message("{body} does not turn in a fixed ratio to the others of the train", body=loose[0])
            raise CannotAnswer(told)
        relative = {b: tidy(k) for b, k in turns.items()}
        relative[self.carrier] = ZERO
        cases = tuple(self._cases(turns))
        return SpeedTable(
            self.system,
            self.carrier,
            self.reference,
            relative,
            {b: self._number(k) for b, k in relative.items()},
            cases,
            self._difference(turns),
        )

    def _number(self, formula: Expr) -> float | None:
        try:
            return float(evaluate(formula, self.values))
        except (KeyError, ArithmeticError, ValueError):
            return None

    def _difference(self, turns: dict[str, Ratio]) -> float:
        """Of both routes at random configurations. Raises CannotAnswer where they disagree."""
        worst = 0.0
        for k, draw in enumerate(self.setup.draws):
            seen = draw.anywhere(k, 0.0, 0.3)
            numbers = self.setup.model.samples.numbers(draw.sample(seen, is_start=False))
            speed = {b: 0.0 if self.system.bodies[b].fixed else seen.rate(Angle(b)) for b in (*turns, self.carrier)}
            for body, turn in turns.items():
                against = [speed[b] - speed[self.carrier] for b in (body, self.reference)]
                exact = float(self.field.evaluate(turn, self.field.complete(numbers)))
                if abs(against[1]) > ROUND_OFF:
                    worst = max(worst, abs(against[0] / against[1] - exact) / max(1.0, abs(exact)))
        if worst > _AGREES:
            raise CannotAnswer(Message("the routes disagree on the speeds by {worst:.1e}", worst=worst))
        return worst

    def _cases(self, turns: dict[str, Ratio]) -> Iterator[HeldMember]:
        """Each two of three central members, the third held: w = x + k y."""
        one, zero = self.field.one, self.field.zero
        k = {self.carrier: zero, **{b: turns[b] for b in self.members}}
        members = sorted(self.members, key=lambda b: b != self.reference)  # the reference first
        for one_gear, other in combinations(members, 2):
            three = (one_gear, other, self.carrier)
            for held in reversed(three):
                w = {b: one if held == self.carrier and b == self.carrier else k[b] - k[held] for b in three}
                if held == self.carrier:
                    w[self.carrier] = zero
                for driving, driven in permutations([b for b in three if b != held]):
                    if not w[driven].is_zero() and not w[driving].is_zero():
                        yield self._case(three, w, held, driving, driven)

    def _case(
        self, three: tuple[str, str, str], w: dict[str, Ratio], held: str, driving: str, driven: str
    ) -> HeldMember:
        f = self.field
        ratio = tidy(f.lowest_terms(w[driving] / w[driven]))
        case = HeldMember(held, driving, driven, ratio, self._number(ratio))
        numbers = {b: self._number(tidy(f.lowest_terms(x))) for b, x in w.items()}
        if self.efficiency is None or any(x is None for x in numbers.values()):
            return case
        eta = f.parameter(_ETA, positive=True)
        case_of = OfRollingPower(driving, driven, held, three[2], *sorted(three[:2], key=lambda b: b == held))
        central = [w[b] - w[three[2]] for b in (case_of.central, case_of.other)]
        at = {**self.values, _ETA: self.efficiency}
        if held == three[2]:
            return HeldMember(held, driving, driven, ratio, case.ratio_value, Symbol(_ETA), self.efficiency, 1.0)
        # (w_S - w_C)/w_S: T_S has the sign of w_S where S drives, and the other one where it is driven
        rolls = float(evaluate(tidy(f.lowest_terms(central[0] / w[case_of.central])), at))
        puts_in = (rolls > 0.0) == (driving == case_of.central)
        gain = passed_on(case_of, eta if puts_in else f.one / eta, central, [w[driving], w[driven]])
        formula = tidy(f.lowest_terms(gain))
        found = float(evaluate(formula, at))
        return HeldMember(held, driving, driven, ratio, case.ratio_value, formula, found, abs(rolls))
