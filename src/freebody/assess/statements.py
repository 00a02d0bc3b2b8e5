"""Options that state when something is so, judged by logic.

    always | never | [if | only if | if and only if] CONDITION [and CONDITION]
    CONDITION: EXPRESSION = EXPRESSION | EXPRESSION is zero | EXPRESSION is constant | POINT coincides with POINT

A condition is sufficient if every coefficient of the rate vanishes where it holds, necessary if it holds in every case
in which the coefficients vanish. An option is right if it is both. Where no option is, one that says "if" and is
sufficient is right, and one that says "only if" and is necessary.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

from freebody.assess.names import NameTable, named_in
from freebody.assess.verdict import Judgement, Verdict, judgement_of
from freebody.assess.words import is_readable
from freebody.errors import CannotAnswer, ExpressionError, UnitError
from freebody.language.expression import ZERO, Expr
from freebody.language.notation import to_text
from freebody.language.parser import parse
from freebody.language.sentences import Message, in_turn
from freebody.language.units import dimension_of
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import RIGHT, UP, Point
from freebody.model.noting import did_you_mean
from freebody.questions.reading import Question
from freebody.symbolic.functions import element
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.symbolic.vanishing import (
    ALWAYS,
    VanishingCase,
    cases_where_zero,
    implies,
    motion_coefficients,
    texts_of,
)
from freebody.system.system import System

Word = Literal["if", "only if", "iff"]


@dataclass(frozen=True)
class Claim:
    """What was derived: the coefficients that must vanish, and the cases in which they do."""

    coefficients: Sequence[Ratio]
    cases: tuple[VanishingCase, ...]
    rates: tuple[Ratio, ...]  # of a vector one for each component; none where there is no formula
    is_parameter: Callable[[int], bool]
    is_exact: bool  # False: there may be more cases
    is_proved: bool = True  # False: in the cases it is constant in all simulated motions, without a formula

    @property
    def is_always(self) -> bool:
        return any(not case.equalities for case in self.cases)


@dataclass(frozen=True)
class OptionStatement:
    """An option as read: the cases in which its condition holds (None: never), and how it is put."""

    word: Word
    equalities: tuple[Ratio, ...] | None
    cases: tuple[VanishingCase, ...]


class NoCondition(Exception):
    """An option that states no condition."""


def judge_statements(question: Question, claim: Claim, model: SymbolicModel, system: System) -> Judgement:
    """Judges every option of a question on when something is so."""
    reader = _OptionReader(claim, model, system)
    verdicts: dict[str, Verdict] = {}
    lesser: dict[str, bool] = {}  # options that are true as they are put, without being equivalent
    for letter, text in question.options.items():
        try:
            verdicts[letter], lesser[letter] = _verdict(reader.read(text), claim)
        except NoCondition as error:
            verdicts[letter], lesser[letter] = (
                Verdict("unreadable", Message("is no condition: {why}", why=error)),
                False,
            )
    if all(v.verdict != "right" for v in verdicts.values()):
        for letter in (k for k, is_true in lesser.items() if is_true):
            verdicts[letter] = Verdict("right", verdicts[letter].reason)
    return judgement_of(verdicts, question.key)


def _verdict(statement: OptionStatement, claim: Claim) -> tuple[Verdict, bool]:
    """The verdict, and whether the option is true as it is put."""
    if statement.equalities is None:
        return _never(claim)
    if not claim.rates and not claim.is_always:
        return _by_simulation(statement, claim), False
    left = [(case, _left_over(claim, case)) for case in statement.cases]
    open_case = next(((case, x) for case, x in left if x is not None), None)
    is_sufficient = open_case is None and bool(left)
    uncovered = None if claim.is_always and not statement.equalities else _uncovered(statement, claim)
    is_necessary = uncovered is None
    own = _any_of(statement.cases) or Message("always")
    if not left:
        return Verdict("wrong", Message("states what cannot be so")), False
    derived = _any_of(claim.cases) or Message("always")
    if is_sufficient and is_necessary and (claim.is_exact or claim.is_always):
        if not statement.equalities:
            return Verdict("right", _always(claim)), False
        return Verdict("right", Message("equivalent to the derived condition {case}", case=derived)), False
    if is_sufficient:
        why = _only_sufficient(_case_text(uncovered)) if uncovered else Message("is sufficient")
        return Verdict("wrong", why), statement.word == "if"
    assert open_case is not None or not left
    if not statement.equalities:
        told = Message("not always: the rate is {rate}", rate=_rates(claim))
        if claim.cases:
            told = Message("{what}, and vanishes only for {case}", what=told, case=derived)
        return Verdict("wrong", told), False
    rate = "" if open_case is None else _shown(open_case[1])
    remains = Message("with {own} the rate is still {rate}", own=own, rate=rate)
    if not claim.cases:
        told = Message("{what}; there is no condition under which it vanishes", what=remains)
        return Verdict("wrong", told), False
    if is_necessary:
        return Verdict("wrong", Message("is necessary only: {what}", what=remains)), statement.word == "only if"
    told = Message(
        "neither sufficient nor necessary: {what}; and for {case} it is conserved anyway",
        what=remains,
        case=_case_text(uncovered),
    )
    return Verdict("wrong", told), False


def _any_of(cases: Sequence[VanishingCase]) -> str:
    return in_turn(texts_of(cases), "{first} or {second}")


def _only_sufficient(case: str) -> str:
    return Message("is sufficient only: it is also conserved for {case}", case=case)


def _by_simulation(statement: OptionStatement, claim: Claim) -> Verdict:
    """Without a formula: against the conditions that simulations found."""
    if not statement.equalities:
        return Verdict("wrong", Message("it changes in a simulated motion"))
    covered = all(any(implies(own, case) for case in claim.cases) for own in statement.cases)
    needed = all(any(implies(case, own) for own in statement.cases) for case in claim.cases)
    if covered and needed and claim.cases:
        return Verdict("right", Message("the condition that simulations found"))
    if covered and claim.cases:
        return Verdict("wrong", _only_sufficient(_any_of(claim.cases)))
    return Verdict(
        "wrong", Message("it changes in a simulated motion, and no such condition was found to prevent that")
    )


def _always(claim: Claim) -> str:
    if claim.is_proved:
        return Message("the rate vanishes for every motion")
    return Message("it is constant in every simulated motion")


def _rates(claim: Claim) -> str:
    return in_turn([_shown(rate) for rate in claim.rates], "{first} and {second}") or Message("not zero")


def _never(claim: Claim) -> tuple[Verdict, bool]:
    if not claim.cases and not claim.rates:
        return Verdict(
            "right", Message("it changes in simulated motions, and no condition was found under which it does not")
        ), False
    if not claim.cases:
        return Verdict(
            "right", Message("the rate is {rate} and vanishes under no condition", rate=_rates(claim))
        ), False
    if claim.is_always:
        return Verdict("wrong", _always(claim)), False
    return Verdict("wrong", Message("it is conserved for {case}", case=_any_of(claim.cases))), False


def _left_over(claim: Claim, case: VanishingCase) -> Ratio | None:
    """What remains of the rate in a case; None if nothing does."""
    try:
        for rate in claim.rates:
            if not case.kills(rate):
                return rate.field.lowest_terms(case.put_in(rate))
        return None
    except CannotAnswer:  # the rate has no value there, its coefficients may
        return next((c for c in claim.coefficients if not case.kills(c)), None)


def _uncovered(statement: OptionStatement, claim: Claim) -> VanishingCase | None:
    """A case in which it is conserved although the option's condition does not hold."""
    for case in claim.cases:
        if not any(implies(case, own) for own in statement.cases):
            return case
    return None


def _case_text(case: VanishingCase | None) -> str:
    return Message("every motion") if case is None or not case.equalities else texts_of([case])[0]


def _shown(x: Ratio) -> str:
    expression = tidy(x)
    return to_text(expression) if is_readable(expression) else Message("not zero")


class _OptionReader:
    """Reads options of one question."""

    def __init__(self, claim: Claim, model: SymbolicModel, system: System) -> None:
        self.claim, self.model, self.system = claim, model, system
        self.names = NameTable(model, system)

    def read(self, text: str) -> OptionStatement:
        """Raises NoCondition, saying why."""
        words = " ".join(text.strip().rstrip(".").split())
        words = re.sub(r"^(?:it is |is )?(?:conserved|constant) ", "", words, flags=re.IGNORECASE)
        words = re.sub(r"^it is ", "", words, flags=re.IGNORECASE)
        if re.fullmatch(r"(?:always|for (?:every|any) motion|unconditionally)(?: conserved)?", words, re.IGNORECASE):
            return OptionStatement("iff", (), (ALWAYS,))
        if re.fullmatch(r"(?:never|not)(?: conserved)?(?: (?:under|for) any.*)?", words, re.IGNORECASE):
            return OptionStatement("iff", None, ())
        word: Word = "iff"
        starts = {"if and only if ": "iff", "iff ": "iff", "only if ": "only if", "if ": "if", "when ": "if"}
        starts |= {"provided that ": "if", "provided ": "if", "for ": "if"}
        starts |= {"only for ": "only if", "only when ": "only if"}
        for start, own_word in starts.items():
            if words.lower().startswith(start):
                word, words = own_word, words[len(start) :]  # pyrefly: ignore[bad-assignment]
                break
        words = re.sub(r"^(?:both|either) ", "", re.sub(r"\s*\((?:[^()]*) is constant\)", "", words))
        equalities: list[Ratio] = []
        cases: list[VanishingCase] = []
        for alternative in re.split(r",? or ", words):
            own: list[Ratio] = []
            for part in re.split(r",? and |, ", alternative):
                own += self._equalities(part.strip())
            for x in own:
                self._refuse_motion(x)
            cases += cases_where_zero([x for x in own if not x.is_zero()], self._may)
            equalities += own
        return OptionStatement(word, tuple(equalities), tuple(cases))

    def _refuse_motion(self, x: Ratio) -> None:
        """A condition is on parameters and given functions; one on the motion is none."""
        field = self.model.field
        for index in field.ingredients(x):
            if field.generators[index].kind in ("coordinate", "speed", "acceleration"):
                what = to_text(field.generators[index].display)
                raise NoCondition(Message("restricts the motion ({what}), not the system", what=what))

    def _may(self, index: int) -> bool:
        """What an option says is zero may be."""
        return self.model.field.generators[index].kind == "parameter"

    def _equalities(self, text: str) -> list[Ratio]:
        """The elements that a condition says are zero."""
        for pattern in (r"(.+?) (?:coincides with|is at|=) (.+)",):
            found = re.fullmatch(pattern, text)
            if found and all(self._is_point(word) for word in found.groups()):
                return self._coincide(*(self._point(word) for word in found.groups()))
        found = re.fullmatch(r"(.+?) coincides with (.+)", text)
        if found:
            wrong = next(word for word in found.groups() if not self._is_point(word))
            known = [f"{b.name}.{p}" for b in self.system.bodies.values() for p in b.points]
            raise NoCondition(
                Message("there is no point {point}.{instead}", point=wrong, instead=did_you_mean(wrong, known))
            )
        found = re.fullmatch(r"(.+?) (?:is )?(?:a )?constant(?: in time)?", text)
        if found:
            x = self._element(found[1], None)
            return [self.names.rate(x)] if not x.is_constant() else []
        found = re.fullmatch(r"(.+?) (?:is zero|vanishes|is 0)", text)
        left, right = (found[1], "0") if found else self._sides(text)
        a = self._element(left, right)
        b = self._element(right, left)
        return [(a - b).numerator()]

    def _sides(self, text: str) -> tuple[str, str]:
        if re.search(r"[<>≤≥≠]|!=", text):
            raise NoCondition(
                Message("'{text}' is an inequality; a condition is an equality, such as d = 0", text=text)
            )
        left, equals, right = text.replace("==", "=").replace(" equals ", " = ").partition("=")
        if not equals or "=" in right:
            raise NoCondition(
                Message("'{text}'; write always, never, d = 0, x is constant, or A coincides with B", text=text)
            )
        return left.strip(), right.strip()

    def _element(self, text: str, other: str | None) -> Ratio:
        expr = self._parsed(text)
        if other is not None and other.strip() != "0" and text.strip() != "0":
            try:
                mine = dimension_of(expr, self.names.dimensions)
                its = dimension_of(self._parsed(other), self.names.dimensions)
            except UnitError as error:
                raise NoCondition(str(error)) from None
            if mine != its and ZERO not in (expr, self._parsed(other)):
                raise NoCondition(
                    Message("{a} has the unit {own}, {b} the unit {its}", a=text, own=mine, b=other, its=its)
                )
        values = {key: self.names.element(key) for key in named_in(expr)}
        try:
            return element(self.model.field, expr, values)
        except (CannotAnswer, ZeroDivisionError) as error:
            raise NoCondition(str(error)) from None

    def _parsed(self, text: str) -> Expr:
        text = re.sub(r"^\|(.+)\|$", r"\1", text.strip())  # |v| = 0 and |v| constant say the same of v
        text = re.sub(r"^([\d.]+)\s*(?:deg|°)$", r"\1*pi/180", text)
        try:
            expr = self.names.with_rates(parse(text))
        except ExpressionError as error:
            raise NoCondition(str(error)) from None
        for key in named_in(expr):
            if key not in self.names:
                raise NoCondition(
                    Message("{name} is unknown.{instead}", name=key, instead=did_you_mean(key, self.names.dimensions))
                )
        return expr

    # -- points -------------------------------------------------------------------------------
    def _is_point(self, text: str) -> bool:
        body, _, point = text.strip().partition(".")
        known = self.system.bodies.get(body)
        return known is not None and (not point or point in known.points)

    def _point(self, text: str) -> Point:
        body, _, point = text.strip().partition(".")
        return self.system.bodies[body].point(point or None)

    def _coincide(self, a: Point, b: Point) -> list[Ratio]:
        g, m = self.model.geometry, self.model
        parts = [m.field.element(Displacement(a, b, axis).value(g)) for axis in (RIGHT, UP)]
        # at every instant, so that each coefficient of the motion vanishes
        open_ = [p for p in parts if not m.samples.vanishes(p)]
        return [c for p in open_ for c in motion_coefficients(p, self.claim.is_parameter)]
