"""A long answer as a chain of named sub-formulas, each short, in the order in which it is computed by hand.

Angles of closed loops come first, then the ratios of speeds, the reduced mass and force, the accelerations, and last
what is asked, in these names. What is still long has its numerator, denominator and repeated parts named. Beside a
whole formula the chain is evaluated at the poses of the draws, and left out where the two differ.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any

from freebody.errors import CannotAnswer, ExpressionError
from freebody.language.expression import (
    Call,
    Expr,
    Symbol,
    add,
    divide,
    multiply,
    n_operations,
    negate,
    number,
    power,
    rate_key,
)
from freebody.language.notation import compared, reworded
from freebody.language.sentences import Message
from freebody.numeric.snapshot import Snapshot
from freebody.questions.base import Quantity
from freebody.study.answering.crosscheck import INSTANT_TOLERANCE, element_at
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import NO_FORM, Elements
from freebody.study.answering.named_formulas import Chain, InNames, NamedFormula
from freebody.study.answering.short_lines import Names, broken_up, keys_in
from freebody.study.setup import Setup
from freebody.symbolic.closure import Closure
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.existence import exists
from freebody.symbolic.loop_angles import ByCoefficients, ByCosine, ByHalf, BySine, LoopAngle, LoopAngles
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.staged import NamedElement, StagedMotion
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate

_MOST_STEPS = 60  # of a chain that anybody would follow
_WORD = 32  # bits of a number that is read like a name
LONG = 70  # operations, some twelve terms: what is longer is not read at a glance
FEW_TERMS, MOST_TERMS = 8, 60  # of sums, multiplied out: so few are short, and more than so many are not
_MOST_TERMS_OF_A_STEP = 300  # of one name, multiplied out: nobody would follow more


@dataclass(frozen=True)
class ElementNamed:
    """A name and the element that it stands for, which is written where it is needed."""

    name: Expr
    value: Ratio

    @cached_property
    def formula(self) -> Expr:
        return tidy(self.value)


def chain_of(setup: Setup, quantity: Quantity, whole: Elements, state: SymbolicState) -> InNames | None:
    """Of what is asked of an instant; None where the whole is short, or no chain is found that comes to the same."""
    parts = whole if isinstance(whole, tuple) else (whole,)
    bound = {d.index for d in setup.model.dependent}
    is_long = is_long_formula(parts)
    if not is_long and not any(x.field.ingredients(x) & bound for x in parts):
        return None
    try:
        builder = ChainBuilder(setup, state.values)
        found = builder.chain(quantity) if is_long else builder.of_angles(parts)
    except (*NO_FORM, KeyError):
        return None
    return found if found is not None and _comes_to_same(setup, found, parts, state) else None


def chain_alone(setup: Setup, quantity: Quantity, state: SymbolicState) -> InNames | None:
    """Of what has no whole formula that anybody could make. Raises CannotAnswer where the names have no formulas."""
    return ChainBuilder(setup, state.values).chain(quantity)


def is_long_formula(parts: Sequence[Ratio]) -> bool:
    """Whether it is more than is read at a glance."""
    n_terms = sum(map(n_terms_in_all, parts))
    return n_terms > MOST_TERMS or (n_terms > FEW_TERMS and sum(n_operations(tidy(x)) for x in parts) > LONG)


def n_terms_in_all(x: Ratio) -> int:
    """The terms of an element, and of what stands under its roots; a number of many digits counts as several."""
    f = x.field
    roots = [g for g in f.ingredients(x) if f.generators[g].kind == "root" and f.generators[g].made_of]
    digits = sum(int(c).bit_length() // _WORD for c in x.num.coeffs())
    return x.n_terms + digits + sum(f.radicand(g).n_terms for g in roots)


def inputs(setup: Setup, numbers: Mapping[int, float]) -> dict[str, float]:
    """The names that a chain begins with, by the numbers of the generators."""
    found: dict[str, float] = {}
    for index, generator in setup.model.field.generators.items():
        if generator.kind in ("parameter", "coordinate", "speed", "time") and index in numbers:
            with suppress(ExpressionError):
                found[rate_key(generator.display)] = float(numbers[index])
    return found


def is_assembled(setup: Setup, found: InNames, draw: Draw, snapshot: Snapshot) -> bool:
    """Whether the loops are assembled at a snapshot as a chain has them."""
    return all(side > 0.0 for side in element_at(setup, found.sides, draw, snapshot))


def _comes_to_same(setup: Setup, found: InNames, whole: Sequence[Ratio], state: SymbolicState) -> bool:
    """Whether chain and whole agree at the poses of all draws that are assembled so."""
    seen = 0
    starts = [draw.start() for draw in setup.draws]
    for draw, snapshot in zip(setup.draws, starts if state.values else setup.anywhere, strict=True):
        with suppress(CannotAnswer, ArithmeticError, ValueError, ExpressionError):
            if not is_assembled(setup, found, draw, snapshot):
                continue
            wanted = element_at(setup, tuple(whole), draw, snapshot)
            known = inputs(setup, setup.model.samples.numbers(draw.sample(snapshot), draw.sample()))
            size = max(map(abs, wanted), default=0.0)
            pairs = zip(found.chain.numbers(known), wanted, strict=True)
            if any(abs(a - b) > INSTANT_TOLERANCE * max(size, abs(a)) for a, b in pairs):
                return False
            seen += 1
    return seen > 0


def _short(setup: Setup, d: Coordinate) -> str:
    """A name for subscripts: of an angle that nobody named the body's."""
    body = d.name.removeprefix("theta_")
    return body if body in setup.system.bodies and d.name not in setup.system.measures else d.name


class ChainBuilder:
    """Puts the names of one question in order."""

    def __init__(self, setup: Setup, values: Mapping[int, Ratio], taken: set[str] | None = None) -> None:
        """values: of the coordinates, their speeds and the time, where they have some; taken: names that mean something
        else."""
        self.setup, self.model, self.field = setup, setup.model, setup.model.field
        model = self.model
        system = setup.system
        self.taken: set[str] = set() if taken is None else taken
        self.taken |= {*system.parameters, *system.measures, *system.bodies, "pi", "t"}
        self.taken |= {c.name for c in (*model.coordinates, *model.dependent)}
        kept = {g for c in model.coordinates for g in (c.index, c.speed)} | {self.field.index(self.field.time)}
        self.values = {g: x for g, x in values.items() if g in kept}
        self.steps: list[NamedFormula | ElementNamed] = []
        self.between: Callable[[ChainBuilder], None] | None = None  # names what stands before the speeds
        self.closure = Closure(self.model)
        self._closing: dict[str, str] = {}  # that loops close, by the angles that tell it
        self._mass: int | None = None
        self._below: dict[str, Ratio] = {}  # the divisors of steps, by their names
        self._plain: dict[int, Ratio] = {}  # names whose formulas are so short that they need none

    def chain(self, quantity: Quantity) -> InNames | None:
        f = self.field
        staged = self.staged()
        self.name_angles()
        self.name_motion(staged.ratios, staged.inertias)
        if self.between is not None:
            self.between(self)
        self.name_motion(staged.speeds, staged.biases, staged.forces, staged.accelerations)
        with f.other_rates(staged.rates()):
            value = quantity.value(self.setup.system, InNamesState(self, staged, quantity.letter))
        return self.told(value)

    def told(self, value: Any) -> InNames | None:
        """A quantity, or the parts of a vector, in the names that there are."""
        elements: tuple[Any, ...] = value if isinstance(value, tuple) else (value,)
        result = [self.here(self.field.element(x)) for x in elements]
        chain = self._ordered(list(map(tidy, result)))
        return None if chain is None else self._found(chain, self._needs(chain, result))

    def _needs(self, chain: Chain, result: Sequence[Ratio]) -> tuple[Condition, ...]:
        """That what is divided by does not vanish."""
        below = [self._below[key] for step in chain.named if (key := rate_key(step.name)) in self._below]
        below += [x.denominator() for x in result]
        found = (require(x, "!=", Message("divisor"))[0] for x in below)
        return tuple(c for c in found if c is not None)

    def of_angles(self, parts: Sequence[Ratio]) -> InNames | None:
        """The angles of loops that a short formula contains."""
        self.name_angles()
        chain = self._ordered(list(map(tidy, parts)))
        return None if chain is None else self._found(chain, tuple(exists(parts)))

    def in_order(self, result: Sequence[Expr]) -> InNames | None:
        """What is asked in the names that there are; None where that is no chain."""
        chain = self._ordered(result)
        return None if chain is None else self._found(chain, self._needs(chain, []))

    def _found(self, chain: Chain, needs: tuple[Condition, ...]) -> InNames:
        told = {rate_key(step.name) for step in chain.named}
        closing = tuple(text for name, text in self._closing.items() if name in told)
        return InNames(chain, needs, tuple(self.closure.sides), closing)

    def staged(self, *, is_still: bool = False) -> StagedMotion:
        """The motion in names of this chain; is_still: a pose at rest."""
        staged = StagedMotion(self.model, self.taken, partial(_short, self.setup), is_still=is_still)
        self._mass = staged.inertias[0].index if len(staged.inertias) == 1 else None
        return staged

    @property
    def mass(self) -> Expr:
        """The one reduced mass, by its name, or by what it is where that is as short."""
        assert self._mass is not None
        return tidy(self.here(self.field.variable(self._mass)))

    def name_motion(self, *groups: Sequence[NamedElement]) -> None:
        for group in groups:
            for e in group:
                self._name(e.index, self.here(e.value))

    def here(self, x: Ratio) -> Ratio:
        """An element at the instant, without the names that need no name."""
        f = self.field
        x = f.follow(x, {**self.model.given_constants, **self.values})
        return f.lowest_terms(f.substitute(x, self._plain))

    def _name(self, index: int, value: Ratio) -> None:
        if value.n_terms <= 1 and len(value.generators()) <= 1:
            self._plain[index] = value
            return
        name = self.field.generators[index].display
        self.steps.append(ElementNamed(name, value))
        self._below[rate_key(name)] = value.denominator()

    # -- angles of loops ----------------------------------------------------------------------
    def name_angles(self) -> None:
        if not self.model.loops:
            return
        for step in LoopAngles(self.closure).found:
            name = Symbol(step.angle.name)
            formula = self._angle(step)
            turns = self._turns(step, formula)
            self.steps.append(NamedFormula(name, formula if not turns else add(formula, turns)))

    def _angle(self, step: LoopAngle) -> Expr:
        match step:
            case BySine(_, sine, is_turned):
                arc = Call("asin", tidy(self.here(sine)))
                return add(Symbol("pi"), negate(arc)) if is_turned else arc
            case ByCosine(_, cosine, is_turned):
                arc = Call("acos", tidy(self.here(cosine)))
                return negate(arc) if is_turned else arc
            case ByHalf(_, tangent):
                return multiply(number(2), Call("atan", tidy(self.here(tangent))))
            case ByCoefficients(angle, coefficients, side):
                return self._by_coefficients(angle.name, _short(self.setup, angle), self._primitive(coefficients), side)

    def _primitive(self, coefficients: Sequence[Ratio]) -> tuple[Ratio, ...]:
        """Without what all of them share, but for its sign."""
        f = self.field
        shared = next(x for x in coefficients if not x.is_zero()).num
        for x in coefficients:
            shared = shared if x.is_zero() else shared.gcd(f.lift(x, f.one)[0])
        divisor = Ratio(f, shared, None)
        numbers = self.model.samples.at_starts(divisor)
        if not all(x > 0 for x in numbers):  # divided by what may be negative the branch would be another one
            return tuple(coefficients)
        return tuple(f.lowest_terms(x / divisor) for x in coefficients)

    def _by_coefficients(self, key: str, angle: str, coefficients: Sequence[Ratio], side: int) -> Expr:
        names: list[Expr] = []
        for letter, x in zip("ABC", coefficients, strict=True):
            if (value := self.here(x)).is_zero():
                names.append(number(0))
                continue
            name = f"{letter}_{angle}"
            while name in self.taken:
                name += "_"
            self.taken.add(name)
            self.steps.append(NamedFormula(Symbol(name), tidy(value)))
            names.append(Symbol(name))
        A, B, C = names
        two = number(2)
        room = compared(add(power(A, two), power(B, two)), ">=", power(C, two))
        self._closing[key] = reworded(Message("{condition} (can be assembled)", condition=room), room)
        root = Call("sqrt", add(power(A, two), power(B, two), negate(power(C, two))))
        above = add(root, negate(B)) if side > 0 else negate(add(B, root))
        return multiply(two, Call("atan", divide(above, add(C, negate(A)))))

    def _turns(self, step: LoopAngle, formula: Expr) -> Expr | None:
        """The whole turns by which the angle differs at the start from its formula."""
        draw = self.setup.draws[0]
        numbers = self.model.samples.numbers(draw.sample(draw.start()), draw.sample())
        try:
            told = tuple(NamedFormula(step.name, step.formula) for step in self.steps)
            values = Chain(told, (formula,)).numbers(inputs(self.setup, numbers))
        except (ArithmeticError, ValueError) as error:  # a root or an arc of what has none
            said = Message(
                "at the model's own values the loop of {angle} cannot be assembled there", angle=step.angle.name
            )
            raise CannotAnswer(said) from error
        n = round((numbers[step.angle.index] - values[0]) / math.tau)
        return multiply(number(2 * n), Symbol("pi")) if n else None

    # -- what is shown ------------------------------------------------------------------------
    def _ordered(self, result: Sequence[Expr]) -> Chain | None:
        """The steps that the result needs, none of them long, in their order."""
        needed: list[NamedFormula | ElementNamed] = []
        wanted = {key for part in result for key in keys_in(part)}
        for step in reversed(self.steps):
            if rate_key(step.name) in wanted:
                if isinstance(step, ElementNamed) and step.value.n_terms > _MOST_TERMS_OF_A_STEP:
                    return None
                needed.append(step)
                wanted |= keys_in(step.formula)
        found: list[NamedFormula] = []
        names = Names(self.taken)
        for step in needed[::-1]:
            letter = step.name.name.split("_")[0] if isinstance(step.name, Symbol) else "S"
            parts, (rest,) = broken_up([step.formula], names, letter)
            found += [*(NamedFormula(name, x) for name, x in parts), NamedFormula(step.name, rest)]
        parts, rest = broken_up(result, names, "S")
        found += [NamedFormula(name, x) for name, x in parts]
        return Chain(tuple(found), tuple(rest)) if 0 < len(found) <= _MOST_STEPS else None


class InNamesState(SymbolicState):
    """An instant told in the names of a chain, in which components get names before the size of a vector is taken."""

    def __init__(self, chain: ChainBuilder, staged: StagedMotion, letter: str) -> None:
        super().__init__(staged.model, chain.values)
        self._chain, self._staged, self._letter = chain, staged, letter

    def size(self, vector: tuple[Any, ...]) -> Ratio:
        f, square = self.model.field, self.model.field.zero
        for axis, part in zip("xyz", vector, strict=False):
            x = self._chain.here(f.element(part))
            if x.n_terms > 1:
                named = self._staged.named(f"{self._letter}_{axis}", x)
                self._chain.name_motion([named])
                x = f.variable(named.index)
            square = square + x * x
        return self.sqrt(square)


def loop_angles(setup: Setup, chain: Chain) -> list[tuple[str, float]]:
    """The angles of loops in a chain, by their names, in numbers at the model's own numbers."""
    if not setup.has_values:
        return []
    draw = setup.draws[0]
    bound = {d.name for d in setup.model.dependent if d.is_angle}
    with suppress(ArithmeticError, ValueError, ExpressionError):
        numbers = setup.model.samples.numbers(draw.sample(draw.start()), draw.sample())
        values = chain.values(inputs(setup, numbers))
        return [(key, values[key]) for step in chain.named if (key := rate_key(step.name)) in bound]
    return []
