"""Typed answers judged against a solved question: what is right, in which way, and why what is not is wrong.

The order is that of the options (`options`): the reading, its names, its units, equality. What is not equal is looked
at once more: whether something is counted the other way (`conventions`), whether it is right under a condition
(`provisos`); only what was seen to differ is called incorrect. What can be neither proved nor refuted is undecided.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal, cast

from freebody.assess.comparing import ComponentPair, surely_differs
from freebody.assess.conventions import other_convention
from freebody.assess.counterexample import counterexample
from freebody.assess.names import named_in
from freebody.assess.numbers import Tolerance, are_near, fault_of
from freebody.assess.options import Compared, compared
from freebody.assess.points import EvaluationPoint, is_free, real, working_precision
from freebody.assess.provisos import proviso
from freebody.assess.reading import check_dimensions, shape
from freebody.assess.reasons import why_wrong
from freebody.assess.rounded import numbers_in, rounded_by
from freebody.assess.setting import Setting
from freebody.assess.solved import SolvedAnswer
from freebody.assess.verdict import Settled
from freebody.assess.wanted import Policy, Wanted
from freebody.assess.words import of_component
from freebody.errors import CannotAnswer, ExpressionError
from freebody.language.expression import Expr, Symbol, free_symbols
from freebody.language.notation import to_text
from freebody.language.sentences import Message, listed
from freebody.language.typed import TypedAnswer, TypedNumber, Vocabulary, read_typed
from freebody.language.units import DIMENSIONLESS
from freebody.model.noting import did_you_mean
from freebody.symbolic.tidy import tidy

TypedVerdict = Literal[
    "correct", "other_form", "other_convention", "correct_only_if", "incorrect", "undecided", "unreadable"
]
MOST_TERMS = 2_000  # of an answer that is multiplied out; beyond, numbers decide


@dataclass(frozen=True)
class TypedJudgement:
    """The verdict on an answer, why, and how that was decided. exprs: as it was read, where it is a formula."""

    verdict: TypedVerdict
    reason: str = ""
    condition: str = ""
    counterexample: str = ""
    decided_by: str = ""
    mistake: str = ""
    answer: TypedAnswer | None = None
    equations: tuple[tuple[Expr, Expr], ...] = ()  # as they were read, where equations are the answer
    forces: tuple[str, ...] = ()  # the entries of a free-body diagram
    is_of_form: bool = False  # the reason is seen without the answer: its unit, how many parts it has

    @property
    def exprs(self) -> tuple[Expr, ...]:
        parts = () if self.answer is None or self.answer.is_number else self.answer.parts
        return cast("tuple[Expr, ...]", parts)


class AnswerJudge:
    """Judges what people type as the answer to one question."""

    def __init__(self, solved: SolvedAnswer, wanted: Wanted, policy: Policy | None = None) -> None:
        self.solved, self.wanted = solved, wanted
        self.policy = policy or Policy()
        self.setting: Setting = solved.setting(is_typed=True)
        assert self.setting.answers is not None
        self.answers = self.setting.answers
        self.vocabulary = Vocabulary(self.setting.names.all_names)

    def with_policy(self, policy: Policy) -> AnswerJudge:
        """The same judge for another author."""
        other = object.__new__(type(self))
        other.__dict__.update(self.__dict__)
        other.policy = policy
        return other

    def judge(self, text: str) -> TypedJudgement:
        """The verdict on an answer as it is typed."""
        try:
            with working_precision():
                found = self._read(text)
                return replace(self._judged(found), answer=found)
        except ExpressionError as error:
            return TypedJudgement("unreadable", str(error))
        except _Unreadable as error:
            return TypedJudgement("unreadable", error.reason, answer=error.answer)

    # -- reading ------------------------------------------------------------------------------
    def _read(self, text: str) -> TypedAnswer:
        """The reading whose units fit, where there are several. Raises ExpressionError, or _Unreadable where more than
        one does."""
        found = [self._with_rates(answer) for answer in read_typed(text, self.vocabulary, len(self.answers))]
        fitting = [answer for answer in found if self._fits(answer)]
        formulas = [answer for answer in fitting if not answer.is_number]
        if len(formulas) > 1:
            pairs = zip(*(cast("tuple[Expr, ...]", answer.parts) for answer in formulas[:2]), strict=True)
            first, second = next(tuple(map(to_text, pair)) for pair in pairs if pair[0] != pair[1])
            told = Message("can be read as {first} or as {second}: write brackets", first=first, second=second)
            raise _Unreadable(told)
        plain = [a for a in found if not a.is_number or any(n.n_digits for n in a.parts if isinstance(n, TypedNumber))]
        return (fitting or plain or found)[0]

    def _with_rates(self, answer: TypedAnswer) -> TypedAnswer:
        parts = tuple(p if isinstance(p, TypedNumber) else self.setting.names.with_rates(p) for p in answer.parts)
        return replace(answer, parts=parts)

    def _fits(self, answer: TypedAnswer) -> bool:
        if answer.is_number:
            return all(
                isinstance(n, TypedNumber) and (n.dimension == self.solved.dimension or not n.has_unit)
                for n in answer.parts
            )
        exprs = cast("tuple[Expr, ...]", answer.parts)
        if self._missing(exprs):
            return False
        try:
            self._check_units(exprs)
        except Settled:
            return False
        return True

    def _check_units(self, exprs: tuple[Expr, ...]) -> None:
        """Raises Settled where the units of a formula do not fit."""
        if not self.wanted.hides_units:
            check_dimensions(self.setting, exprs)

    def _missing(self, exprs: Sequence[Expr]) -> list[str]:
        """Names that the problem does not have."""
        return list(
            dict.fromkeys(
                shown.name if isinstance(shown, Symbol) else to_text(shown)
                for expr in exprs
                for key, shown in named_in(expr).items()
                if key not in self.setting.names
            )
        )

    # -- the verdict --------------------------------------------------------------------------
    def _judged(self, answer: TypedAnswer) -> TypedJudgement:
        exprs = () if answer.is_number else cast("tuple[Expr, ...]", answer.parts)
        if missing := self._missing(exprs):
            raise _Unreadable(self._unknown(missing), answer)
        if len(answer.relations) == 1 and answer.relations[0] != "=" and len(answer.parts) == 1:
            if not self.wanted.bound:
                raise _Unreadable(Message("an inequality is no answer here: write the value alone, or after ="), answer)
            if answer.relations[0][0] != self.wanted.bound:
                return TypedJudgement("incorrect", Message("the inequality points the wrong way"), is_of_form=True)
        if len(answer.parts) != len(self.answers):
            return TypedJudgement("incorrect", self._other_shape(len(answer.parts)), is_of_form=True)
        if answer.is_number:
            return self._number(cast("tuple[TypedNumber, ...]", answer.parts))
        try:
            self._check_units(exprs)
            return self._formula(exprs)
        except Settled as settled:
            if (number := self._put_in(exprs)) is not None:
                raise _Unreadable(Message("{x} seems to be {name}: write {name}", **number), answer) from None
            return TypedJudgement("incorrect", settled.verdict.reason, decided_by=Message("units"), is_of_form=True)

    def _other_shape(self, n: int) -> str:
        if not self.wanted.has_order:
            return Message("gives {n} of {all} values", n=n, all=len(self.answers))
        return Message("is {mine}, the answer is {its}", mine=shape(n), its=shape(len(self.answers)))

    def _unknown(self, missing: Sequence[str]) -> str:
        names = sorted(n for n in self.setting.names.all_names if not n.startswith("_"))
        hint = did_you_mean(missing[0], names)
        if len(missing) > 1:
            return Message("{names} are not quantities of this problem.{hint}", names=listed(list(missing)), hint=hint)
        return Message("{names} is not a quantity of this problem.{hint}", names=missing[0], hint=hint)

    def _put_in(self, exprs: Sequence[Expr]) -> dict[str, str] | None:
        """A number in a formula that is the value of a parameter, as 9.81 is that of g."""
        numbers = {abs(float(x.value)) for expr in exprs for x in numbers_in(expr)}  # as written
        if not any(free_symbols(expr) for expr in exprs):
            return None
        for p in self.solved.system.parameters.values():
            if p.value is None or not numbers:
                continue
            for x in numbers:
                if x not in (0.0, 1.0, 2.0) and abs(x - abs(p.value)) <= 1e-3 * abs(p.value):
                    return {"x": f"{x:g}", "name": to_text(Symbol(p.name))}
        return None

    # -- formulas -----------------------------------------------------------------------------
    def _formula(self, exprs: tuple[Expr, ...]) -> TypedJudgement:
        found = self._compared(exprs)
        if found.equality is not None:
            return self._equal(found)
        pair, where = found.different[0], found.different[1] if self.wanted.has_order else ""
        if not surely_differs(pair):
            return TypedJudgement("undecided", Message("neither proved nor refuted: it has no value at most points"))
        if self.policy.form == "number" and not any(free_symbols(e) for e in exprs):
            return TypedJudgement("incorrect", of_component(where, why_wrong(pair)))
        off = rounded_by(found.pairs, exprs)
        if off is not None:
            told = Message("agrees to {off:.1g} relative: a coefficient is rounded", off=off)
            return TypedJudgement("other_form", told, decided_by=self._at_points())
        if self.wanted.is_signed and (said := other_convention(found.pairs, self.wanted.measure)) is not None:
            told = Message("correct with {convention}", convention=said)
            return TypedJudgement("other_convention", told, condition=said, decided_by=Message("proved in the field"))
        if (condition := self._case(exprs) or proviso(found.pairs)) is not None:
            told = Message("correct only if {condition}", condition=condition)
            differs = counterexample(pair)
            return TypedJudgement("correct_only_if", told, condition, differs, self._how_different(pair))
        reason = of_component(where, why_wrong(pair))
        return TypedJudgement("incorrect", reason, "", counterexample(pair), self._how_different(pair))

    def _compared(self, exprs: tuple[Expr, ...]) -> Compared:
        """In the order that fits, where the parts have none."""
        found = compared(self.setting, exprs, MOST_TERMS)
        if found.equality is None and not self.wanted.has_order and 1 < len(exprs) <= 3:
            other = compared(self.setting, exprs[::-1], MOST_TERMS)
            return other if other.equality is not None else found
        return found

    def _equal(self, found: Compared) -> TypedJudgement:
        assert found.equality is not None
        how = found.equality.words if not found.equality.is_proved else Message("proved in the field")
        needs = [f"{to_text(tidy(c))} > 0" for pair in found.pairs for c in pair.option.conditions]
        if needs and found.equality.is_proved and not self._hold(found.pairs):
            condition = listed(needs)
            return TypedJudgement(
                "correct_only_if", Message("correct only if {condition}", condition=condition), condition, "", how
            )
        if self.policy.form == "number" and self.solved.dimension != DIMENSIONLESS:
            return TypedJudgement("other_form", Message("right as a formula; a number is asked for"), decided_by=how)
        return TypedJudgement("correct", found.equality.words, decided_by=how)

    def _hold(self, pairs: Sequence[ComponentPair]) -> bool:
        """Whether what the roots of an answer need is so wherever the right one has a value."""
        for point in self.setting.points():
            for pair in pairs:
                has_value = point.number(pair.answer).is_finite()
                if has_value and not all(point.number(c) > 0 for c in pair.option.conditions):
                    return False
        return True

    def _case(self, exprs: tuple[Expr, ...]) -> str | None:
        """The conditions of another case of the answer that this is."""
        for case, conditions in self.wanted.cases:
            if len(case) != len(exprs):
                continue
            try:
                differences = [self.setting.difference(a, b) for a, b in zip(case, exprs, strict=True)]
            except (CannotAnswer, ExpressionError, ZeroDivisionError, Settled, KeyError):
                continue
            if all(x.is_zero() for x in differences) and conditions:
                return listed([str(c) for c in conditions])
        return None

    def _how_different(self, pair: ComponentPair) -> str:
        if pair.is_looped:
            return Message("they differ in poses of the mechanism")
        return Message("they differ at random points in the declared domain, by enclosures without zero")

    def _at_points(self) -> str:
        return Message("agreement at random points in the declared domain")

    # -- numbers ------------------------------------------------------------------------------
    def _number(self, given: tuple[TypedNumber, ...]) -> TypedJudgement:
        wanted, policy = self.solved.dimension, self.policy
        if (exact := self._exactly(given)) is not None:
            return exact
        if any(free for free in self._state_names()):
            return self._at_start(given)
        values = self.wanted.value
        if values is None:
            return TypedJudgement("undecided", Message("the model gives no number to compare with"))
        by_unit = next((n for n in given if n.has_unit and n.dimension != wanted), None)
        tolerance = policy.tolerance
        if by_unit is not None:
            if are_near([n.value for n in given], values, tolerance):
                told = Message(
                    "the magnitude is right, the unit is not: {own} instead of {its}", own=by_unit.unit, its=wanted
                )
            else:
                told = Message("has the unit {own}, the answer has {wanted}", own=by_unit.dimension, wanted=wanted)
            return TypedJudgement("incorrect", told, decided_by=Message("units"))
        how = Message(
            "compared with {value}, tolerance {tolerance}",
            value=", ".join(f"{v:.5g}" for v in values),
            tolerance=self._tolerance,
        )
        for right in (values, *self._with_gravity()):
            if are_near([n.value for n in given], right, tolerance):
                return self._right_number(given, how)
        fault = fault_of(given, values, wanted, tolerance, self._known_wrong())
        return TypedJudgement("incorrect", fault.reason, decided_by=how, mistake=fault.mistake)

    def _right_number(self, given: tuple[TypedNumber, ...], how: str) -> TypedJudgement:
        policy = self.policy
        if policy.needs_unit and self.solved.dimension != DIMENSIONLESS and any(not n.has_unit for n in given):
            told = Message("the magnitude is right, the unit {unit} is missing", unit=self.solved.dimension)
            return TypedJudgement("incorrect", told, decided_by=how)
        if policy.form == "formula" and self._has_names:
            return TypedJudgement("other_form", Message("right as a number; a formula is asked for"), decided_by=how)
        return TypedJudgement("correct", Message("right within the tolerance"), decided_by=how)

    @property
    def _tolerance(self) -> str:
        t = self.policy.tolerance
        if t.digits:
            return Message("{n} digits", n=t.digits)
        return f"{100 * t.relative:g} %" if t.relative else f"{t.absolute:g}"

    @cached_property
    def _has_names(self) -> bool:
        """Whether the answer is more than a number."""
        field, pi = self.setting.field, self.setting.field.index(self.setting.field.pi)
        inside = frozenset[int]().union(*map(field.ingredients, self.answers))
        return any(g != pi and is_free(field, g) for g in inside)

    def _exactly(self, given: tuple[TypedNumber, ...]) -> TypedJudgement | None:
        """Of an answer without names, as 5/7 or pi/6, the number itself."""
        if self._has_names or any(n.has_unit and n.dimension != self.solved.dimension for n in given):
            return None
        point = EvaluationPoint(self.setting.field, real)
        values = [float(point.number(x)) for x in self.answers]
        if not are_near([n.value for n in given], values, Tolerance(relative=1e-12)):
            return None
        return TypedJudgement("correct", Message("identical to the result"), decided_by=Message("compared in numbers"))

    def _state_names(self) -> list[int]:
        """What changes in the motion and stands in the answer."""
        field = self.setting.field
        inside = frozenset[int]().union(*map(field.ingredients, self.answers))
        return [g for g in inside if field.generators[g].kind in ("coordinate", "speed", "acceleration", "time")]

    def _at_start(self, given: tuple[TypedNumber, ...]) -> TypedJudgement:
        values = self.wanted.value
        if values is not None and are_near([n.value for n in given], values, self.policy.tolerance):
            at_start = Message("the system is at its start")
            told = Message("correct only if {condition}", condition=at_start)
            return TypedJudgement("correct_only_if", told, at_start, decided_by=Message("compared in numbers"))
        told = Message("is a number; the answer changes with the motion")
        return TypedJudgement("incorrect", told, decided_by=Message("compared in numbers"))

    # -- other numbers of the model -----------------------------------------------------------
    def _gravity(self) -> list[int]:
        """The parameters that are an acceleration of about 9.81 m/s^2."""
        field = self.setting.field
        return [
            g
            for name, x in self.setting.model.parameters.items()
            if str(self.setting.names.dimensions.get(name)) == "m/s^2"
            and (g := field.index(x)) in self.setting.own_numbers
            and abs(self.setting.own_numbers[g] - 9.81) < 0.3
        ]

    def _with_gravity(self) -> list[tuple[float, ...]]:
        """The values with the other accelerations of gravity that are accepted."""
        found = [self.setting.value_with(dict.fromkeys(self._gravity(), x)) for x in self.policy.gravity]
        return [values for values in found if values is not None]

    def _known_wrong(self) -> Mapping[str, Sequence[float]]:
        """Values that follow from mistakes with numbers."""
        found: dict[str, Sequence[float]] = {}
        gravity = self._gravity()
        if gravity and (values := self.setting.value_with(dict.fromkeys(gravity, 10.0))) is not None:
            found[Message("g is taken as 10 m/s^2")] = values
        if gravity and (values := self.setting.value_with(dict.fromkeys(gravity, 1.0))) is not None:
            found[Message("g is missing")] = values
        angles = {
            g: float(x) * 57.29577951308232 for g, x in self.setting.own_numbers.items() if g in self.setting.angles
        }
        if angles and (values := self.setting.value_with(angles)) is not None:
            found[Message("angles in degrees are put into functions of radians")] = values
        return found


class _Unreadable(Exception):
    """Nothing that could be judged."""

    def __init__(self, reason: str, answer: TypedAnswer | None = None) -> None:
        self.reason, self.answer = reason, answer
