"""Mistakes as substitutions: what becomes of the answer if something in it is taken for something else.

A mistake replaces generators by elements (a factor by 0, a sine by the cosine, R by 2 R), takes a power, multiplies the
result, or turns the sign of its root. Two mistakes that replace different generators can be made together.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import singledispatch
from itertools import permutations
from typing import Any

from freebody.assess.setting import Setting
from freebody.language.expression import Symbol
from freebody.language.sentences import Sentence
from freebody.language.units import DIMENSIONLESS, INERTIA, LENGTH, MASS
from freebody.questions.base import Quantity
from freebody.questions.reading import Question
from freebody.questions.small_motion import SmallOscillations
from freebody.symbolic.field import Field
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio


@dataclass(frozen=True)
class Mistake:
    """What somebody does wrong, in words, and what it makes of an answer."""

    said: Sentence
    values: Mapping[int, Ratio] = field(default_factory=dict[int, Ratio])
    factor: Ratio | None = None  # of the result
    power: int = 1
    turns_root: bool = False
    is_common: bool = True  # common enough to be looked for together with another one
    breaks_units: bool = False

    @property
    def is_of_sign(self) -> bool:
        """Whether a sign is wrong."""
        return self.turns_root or any(x == -1 for x in self.values.values())

    def of(self, x: Ratio) -> Ratio:
        """The answer with this mistake. Raises CannotAnswer or ZeroDivisionError where it has none."""
        f = x.field
        y = f.follow(x, self.values)
        if self.turns_root:
            y = f.substitute(y, {g: -f.variable(g) for g in roots_in(y)})
        y = y**self.power
        return f.lowest_terms(y if self.factor is None else y * self.factor)

    def and_then(self, other: Mistake) -> Mistake | None:
        """Both together; None where they exclude each other."""
        if self.values.keys() & other.values.keys() or (self.factor is not None and other.factor is not None):
            return None
        if self.power != 1 or other.power != 1 or (self.turns_root and other.turns_root):
            return None
        if self.is_of_sign and other.is_of_sign:  # nobody learns from two wrong signs
            return None
        said = Sentence("mistake.leads_two", {"first": self.said, "second": other.said})
        factor = other.factor if self.factor is None else self.factor
        turns = self.turns_root or other.turns_root
        breaks = self.breaks_units or other.breaks_units
        return Mistake(said, {**self.values, **other.values}, factor, turns_root=turns, breaks_units=breaks)


class PointAnswers:
    """Answers in numbers at one point, quickly for many mistakes."""

    def __init__(self, answers: Sequence[Ratio], base: Mapping[int, Any]) -> None:
        self.base = base
        self.answers = answers
        f = answers[0].field
        self.field: Field = f
        self._terms = [(f.terms(x.num), None if x.den is None else f.terms(x.den)) for x in answers]
        used = sorted({g for x in answers for g in x.generators()})
        self._atoms = self._with_atoms(used)
        self._roots = frozenset(g for x in answers for g in roots_in(x))

    def _with_atoms(self, used: Iterable[int]) -> list[int]:
        """What has to be computed again when something changes, in order."""
        generators = self.field.generators
        found = {g for index in used for g in (index, *generators[index].made_of) if generators[g].made_of}
        return sorted(found)

    def of(self, mistake: Mistake) -> tuple[float, ...]:
        """The answers with a mistake; nan where they have no value."""
        f = self.field
        try:
            values = dict(self.base)
            changed = set(mistake.values)
            values |= {g: f.evaluate(x, self.base) for g, x in mistake.values.items()}
            for g in self._atoms:
                generator = f.generators[g]
                if g not in mistake.values and generator.compute is not None and generator.made_of & changed:
                    values[g] = generator.compute(values, math)
            if mistake.turns_root:
                values |= {g: -values[g] for g in self._roots}
            factor = 1.0 if mistake.factor is None else float(f.evaluate(mistake.factor, self.base))
            return tuple(factor * _value(*terms, values) ** mistake.power for terms in self._terms)
        except (ArithmeticError, ValueError, KeyError, TypeError):
            return (math.nan,) * len(self._terms)


Terms = Mapping[tuple[tuple[int, int], ...], int]


def _value(top: Terms, below: Terms | None, values: Mapping[int, Any]) -> float:
    over = 1.0 if below is None else _sum(below, values)
    return _sum(top, values) / over


def _sum(terms: Terms, values: Mapping[int, Any]) -> float:
    total = 0.0
    for monomial, coefficient in terms.items():
        term = float(coefficient)
        for g, exponent in monomial:
            term *= values[g] ** exponent
        total += term
    return total


def roots_in(x: Ratio) -> list[int]:
    """The square roots in an element that are no numbers."""
    f = x.field
    kinds = [g for g in sorted(x.generators()) if f.generators[g].kind == "root"]
    return [g for g in kinds if f.radicand(g).fraction() is None]


# -- slips in an answer -----------------------------------------------------------------------
def slips(question: Question, setting: Setting, answers: Sequence[Ratio], *, breaks_units: bool) -> Iterator[Mistake]:
    """What can go wrong when the answer is written down. breaks_units: also what changes its unit."""
    model, f = setting.model, setting.field
    used = sorted({g for x in answers for g in f.ingredients(x)})
    yield from _exchanged(f, answers)
    if any(len(roots_in(x)) == 1 for x in answers) and all(len(roots_in(x)) <= 1 for x in answers):
        yield Mistake(Sentence("mistake.root"), turns_root=True)
    if setting.dimension == DIMENSIONLESS and len(answers) == 1:
        yield Mistake(Sentence("mistake.inverted"), power=-1)
    yield from _of_kind(question.quantity, f)
    yield from _special(setting, used)
    names = _parameters(model, setting, used)
    for p in names:
        yield from _of_parameter(setting, p)
    yield from _mixed_up(setting, names)
    if breaks_units:
        yield from _with_other_units(model, setting, used)


@singledispatch
def _of_kind(q: Quantity, f: Field) -> Iterator[Mistake]:
    """What is mistaken in one kind of question only."""
    yield from ()


@_of_kind.register(SmallOscillations)
def _of_frequencies(q: SmallOscillations, f: Field) -> Iterator[Mistake]:
    """Revolutions taken for radians, or the other way round."""
    key = "mistake.turn" if q.what == "period" else "mistake.hertz"
    yield Mistake(Sentence(key), factor=1 / (2 * f.pi))


def _exchanged(f: Field, answers: Sequence[Ratio]) -> Iterator[Mistake]:
    used = {g for x in answers for g in f.ingredients(x)}
    for cos, sin in f.pairs(used):
        if f.generators[cos].kind == "cos" and f.generators[sin].kind == "sin":
            angle = f.expression(f.angles[cos])
            values = {cos: f.variable(sin), sin: f.variable(cos)}
            yield Mistake(Sentence("mistake.exchanged", {"angle": angle}), values)


def _special(setting: Setting, used: Sequence[int]) -> Iterator[Mistake]:
    """An angle taken at one place only."""
    f = setting.field
    coordinates = {c.index for c in setting.model.coordinates if c.is_angle}
    for g in used:
        if g not in setting.angles:
            continue
        shown = {"angle": f.generators[g].display}
        moves = g in coordinates
        yield Mistake(Sentence("mistake.at_zero" if moves else "mistake.ignored", shown), {g: f.zero}, is_common=False)
        if moves:
            yield Mistake(Sentence("mistake.at_right_angle", shown), {g: f.pi / 2}, is_common=False)


def _parameters(model: SymbolicModel, setting: Setting, used: Sequence[int]) -> list[str]:
    known = {f: name for name, x in model.parameters.items() for f in x.generators()}
    return [known[g] for g in used if g in known and known[g] in setting.names.dimensions and known[g] != "t"]


def _of_parameter(setting: Setting, name: str) -> Iterator[Mistake]:
    """A parameter left out, or a length taken for its double or half."""
    f, model = setting.field, setting.model
    x = model.parameters[name]
    g, unit = f.index(x), setting.names.dimensions[name]
    shown = {"p": Symbol(name)}
    if unit in (MASS, INERTIA) or (unit == DIMENSIONLESS and g not in setting.angles):
        yield Mistake(Sentence("mistake.zero", shown), {g: f.zero})
    if unit == DIMENSIONLESS and g not in setting.angles:
        yield Mistake(Sentence("mistake.sense", shown), {g: -x}, is_common=False)
    if unit == LENGTH:
        yield Mistake(Sentence("mistake.twice", shown), {g: 2 * x}, is_common=False)
        yield Mistake(Sentence("mistake.half", shown), {g: x / 2}, is_common=False)


def _mixed_up(setting: Setting, names: Sequence[str]) -> Iterator[Mistake]:
    """A parameter in the place of another of its kind, and two that have changed places: a wrong arm, a wrong mass."""
    f, known, units = setting.field, setting.model.parameters, setting.names.dimensions
    for a, b in permutations(names, 2):
        if units[a] != units[b] or (f.index(known[a]) in setting.angles) != (f.index(known[b]) in setting.angles):
            continue
        shown = {"p": Symbol(a), "q": Symbol(b)}
        if names.index(a) < names.index(b):
            both = {f.index(known[a]): known[b], f.index(known[b]): known[a]}
            yield Mistake(Sentence("mistake.swapped", shown), both, is_common=False)
        yield Mistake(Sentence("mistake.instead", shown), {f.index(known[a]): known[b]}, is_common=False)


def _with_other_units(model: SymbolicModel, setting: Setting, used: Sequence[int]) -> Iterator[Mistake]:
    """Factors that are missing or too many, and a parameter in the place of its product with another."""
    f = setting.field
    names = _parameters(model, setting, used)
    present = {**{n: model.parameters[n] for n in names}}
    free = {n: x for n, x in present.items() if f.index(x) not in setting.angles}
    for name, x in free.items():
        yield Mistake(Sentence("mistake.lacks", {"factor": Symbol(name)}), factor=1 / x, breaks_units=True)
    for name, x in free.items():
        yield Mistake(Sentence("mistake.too_many", {"factor": Symbol(name)}), factor=x, breaks_units=True)
    yield Mistake(Sentence("mistake.not_rooted"), power=2, breaks_units=True)
    for name, x in free.items():
        for other, y in free.items():
            if name == other:
                continue
            for key, value in (("mistake.for_quotient", x * y), ("mistake.for_product", x / y)):
                said = Sentence(key, {"p": Symbol(name), "q": Symbol(other)})
                yield Mistake(said, {f.index(x): value}, is_common=False, breaks_units=True)
