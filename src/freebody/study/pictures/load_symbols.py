"""What stands beside a load in a diagram: its law, in symbols of the model and without its sign."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction

from freebody.errors import FreebodyError
from freebody.language.expression import (
    FLOAT_FUNCTIONS,
    Call,
    Expr,
    Number,
    PowerOf,
    ProductOf,
    Sum,
    Symbol,
    add,
    children,
    divide,
    evaluate,
    free_symbols,
    multiply,
    negate,
    number,
    power,
    substitute,
)
from freebody.language.notation import to_text
from freebody.language.raising import typeset
from freebody.language.units import DIMENSIONLESS
from freebody.loads.gravity import Gravity
from freebody.measures.combination import Composed
from freebody.measures.geometry import GROUND
from freebody.model.elements import RATE, VALUE, AppliedLoad, ConstraintRow
from freebody.model.states import as_told
from freebody.present.picture.label import Label, Run, beside, formula, name
from freebody.symbolic.functions import element
from freebody.symbolic.signed_field import SignedField
from freebody.symbolic.tidy import tidy
from freebody.system.symbols import ReactionSymbol
from freebody.system.system import System

LONGEST = 28  # letters of a law beside an arrow: a longer one would hide the picture
_MOST_DIGITS = 7  # of a number in it
_LOAD = "@load of "  # the symbol of what sliding friction is pressed with, before the name of its row


@dataclass(frozen=True)
class LoadSymbols:
    """symbols: of reactions, by row; given: other names, by the name of a load; senses: as by `load_senses`."""

    system: System
    symbols: Mapping[str, ReactionSymbol]
    given: Mapping[str, str]
    senses: Mapping[str, int]

    def of(self, push: AppliedLoad) -> tuple[Label, int]:
        """The label, and whether its force acts with the gradient of the measure (+1) or against it."""
        given = self.given.get(push.name, self.given.get(push.load))
        law, sign = self.law(push)
        if law is None:
            sign = getattr(self.system.loads.get(push.load), "drawn_sign", 1) * self.senses.get(push.name, 1)
        if given is not None:
            return name(given), sign
        if law is not None and (number_told := self._in_units(push, law)) is not None:
            return number_told, sign
        is_short = law is not None and len(to_text(law)) <= LONGEST
        return (formula(shorter(law)) if law is not None and is_short else self._named_after(push)), sign

    def _in_units(self, push: AppliedLoad, law: Expr) -> Label | None:
        """What is a number in the file, with its unit: 20 kg g, which is no weight of 20 grams, and 100 N."""
        if not free_symbols(law):
            unit = "N\u2009m" if push.measure.dimension == DIMENSIONLESS else "N"
            return _measured(law, unit)
        weighed = [self.system.bodies[body].mass for body in push.measure.bodies() if body != GROUND]
        is_weight = isinstance(self.system.loads.get(push.load), Gravity) and len(weighed) == 1
        if not is_weight or free_symbols(weighed[0]):
            return None
        return beside(_measured(weighed[0], "kg"), formula(divide(law, weighed[0])), "\u2009")

    def _named_after(self, push: AppliedLoad) -> Label:
        """F, or M of what turns, with the load as index, or with the connection that rubs."""
        letter = "M" if push.measure.dimension == DIMENSIONLESS else "F"
        called = push.load if push.load in self.system.loads else push.load.partition(".")[0]
        return name(f"{letter}_{re.sub(r'[^0-9A-Za-z]', '_', called)}")

    def law(self, push: AppliedLoad) -> tuple[Expr | None, int]:
        """The law and its sign as for `of`; None where the model has no name for what it depends on."""
        law = as_told(push.in_symbols, self.system.states)
        for symbol in sorted(s for s in free_symbols(law) if s.startswith(_LOAD)):
            row = self._pressed(symbol.removeprefix(_LOAD))
            if row is None:
                return None, 1
            law = substitute(law, {symbol: Symbol(self.symbols[row.name].name)})
        measure = push.measure
        if free_symbols(law) & {VALUE.name, RATE.name}:
            called = next((n for n, m in self.system.measures.items() if m == measure), None)
            if called is not None:
                law = substitute(law, {VALUE.name: Symbol(called), RATE.name: Call("rate", Symbol(called))})
            elif isinstance(measure, Composed) and RATE.name not in free_symbols(law):
                if not {n for n, _m in measure.measures} <= set(self.system.measures):
                    return None, 1
                law = substitute(law, {VALUE.name: measure.expression})
            else:
                return None, 1
        return without_sign(law)

    def _pressed(self, rub: str) -> ConstraintRow | None:
        """The row whose reaction presses where something rubs."""
        connection, _, component = rub.partition(".")
        own = [row for row in self.system.rows if row.connection == connection and row.reaction == "normal force"]
        if len(own) > 1:
            own = [row for row in own if row.component == component.removeprefix("slip of ")]
        return own[0] if len(own) == 1 else None


def _measured(value: Expr, unit: str) -> Label:
    told = typeset(f"{evaluate(value, {}, FLOAT_FUNCTIONS):.4g}")
    units = unit.replace("\u2009", r"\,")
    return Label((Run(f"{told}\u2009{unit}"),), rf"{told}\,\mathrm{{{units}}}")


def shorter(law: Expr) -> Expr:
    """A formula of names alone in lowest terms, where that says the same with less: 3 M/4 for M - M/4."""
    law = _rounded(law)
    names = free_symbols(law) - {"pi"}
    if any(isinstance(part, Call) and part.function != "sqrt" for part in _parts(law)) or not names:
        return law
    field = SignedField()
    values = {"pi": field.pi} | {called: field.parameter(called, positive=True) for called in sorted(names)}
    try:
        tidied = tidy(field.lowest_terms(element(field, law, values)))
    except (FreebodyError, ArithmeticError, ValueError):
        return law
    return tidied if len(to_text(tidied)) < len(to_text(law)) else law


def _rounded(law: Expr) -> Expr:
    """With three digits of every decimal that has more of them than a picture has room for: a volume of a mesh."""
    match law:
        case Number(value) if len(to_text(law)) > _MOST_DIGITS:
            return number(Fraction(f"{float(value):.3g}"))
        case Sum(terms):
            return add(*map(_rounded, terms))
        case ProductOf(factors):
            return multiply(*map(_rounded, factors))
        case PowerOf(base, exponent):
            return power(_rounded(base), exponent)
        case Call():
            return law.of(_rounded)
        case _:
            return law


def _parts(expr: Expr) -> Iterator[Expr]:
    yield expr
    for part in children(expr):
        yield from _parts(part)


def without_sign(law: Expr) -> tuple[Expr, int]:
    """A law, or its opposite where that has no minus sign."""
    match law:
        case Number(value) | ProductOf((Number(value), *_)) if value < 0:
            return negate(law), -1
        case _:
            return law, 1
