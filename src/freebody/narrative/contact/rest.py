"""Rest under dry friction: the limit at which a contact slips or opens, and with which values the system stays at rest.

Equilibrium alone leaves the frictions open. At the limit the contacts that give way say what their forces are; then
equilibrium has more equations than unknown forces, and what is left is a condition on the parameters. The way to fail
that comes first is the one of the study (`study/friction`), whose motion decides which contacts slip and which open.
"""

from __future__ import annotations

from contextlib import suppress
from functools import singledispatchmethod

from freebody.errors import CannotAnswer, RoutesDisagree
from freebody.language.expression import Call, Expr, Symbol, add, free_symbols, number, power
from freebody.language.sentences import Message, Sentence
from freebody.narrative.contact.phase_conditions import sides_of, told_purpose
from freebody.narrative.contact.phase_event import solved_argument
from freebody.narrative.contact.rest_cone import tell_cone, tell_feet, turning
from freebody.narrative.contact.rest_forces import acting_at_rest
from freebody.narrative.contact.rest_newton import RestNewton
from freebody.narrative.contact.rest_worlds import RestGlossary
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.lines.script import DerivationStage, Listing, Script, ready
from freebody.narrative.principles.reactions import place_of
from freebody.narrative.principles.sides import ZERO, balanced
from freebody.present.report.blocks import Relation
from freebody.questions.base import Quantity
from freebody.questions.reading import Question
from freebody.questions.rest import FirstFailure, Holds, ReactionRange, RestLimit
from freebody.study.answering.answer import Answer
from freebody.study.friction.answers import prepared
from freebody.study.friction.cases import Ends, FailureCase, HoldingLimit
from freebody.study.friction.ends import ParameterEnds
from freebody.study.friction.touching import TouchingAtRest
from freebody.study.phases.numbers import coefficients_of_friction
from freebody.study.senses import drawn_symbols
from freebody.symbolic.active_set import Failure, RestEquations
from freebody.symbolic.linear import RHS
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.system.corners import in_words

_AT: dict[int, Relation] = {1: "≤", -1: "≥"}


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The derivation of a question about rest. Raises CannotAnswer where there is none."""
    refuse(method, ("newton",), Message("rest under dry friction"))
    if answer.expression is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    telling = _RestTelling(context, question, answer)
    telling.tell()
    return telling.script.stages


class _RestTelling:
    """One question about rest, while it is told."""

    def __init__(self, context: Context, question: Question, answer: Answer) -> None:
        if question.quantity.loads_left_out:
            raise CannotAnswer(Message("of what rests without one of its loads no derivation is written yet"))
        self.context = context
        self.question = question
        self.answer = answer
        self.rest = prepared(context.system)
        self.touching = self.rest.touching
        self.symbols = drawn_symbols(self.touching.system)
        self.script = Script(context.glossary, context.next_number)

    def tell(self) -> None:
        self._tell(self.question.quantity)

    @singledispatchmethod
    def _tell(self, q: Quantity) -> None:
        raise CannotAnswer(Message("this is no question about rest"))

    @_tell.register(RestLimit)
    def _limit(self, q: RestLimit) -> None:
        ends = self.rest.parameter(q.parameter)
        self._contacts(ends)
        self._ends(ends, Symbol(q.parameter), q.parameter, q.ends)

    @_tell.register(ReactionRange)
    def _reaction(self, q: ReactionRange) -> None:
        row = next(r for r in self.touching.rows if r.name in q.rows)
        ends = self.rest.reaction(row.name)
        self._contacts(ends)
        drawn = self.symbols[row.name]
        self._ends(ends, drawn.sign * row.sign * Symbol(drawn.name), "", (-1, 1), row.name)

    @_tell.register(FirstFailure)
    def _failure(self, q: FirstFailure) -> None:
        ends = self.rest.parameter(q.parameter)
        self._contacts(ends)
        self._first(ends, q.parameter)

    # -- what touches -------------------------------------------------------------------------
    def _contacts(self, ends: Ends) -> None:
        """What touches, with the laws that its forces obey, and whether equilibrium alone determines them."""
        found: list[Sentence] = []
        symbols = self.symbols
        for row in self.touching.held.constraint_rows:
            if row.unilateral:
                symbol = Symbol(symbols[row.name].name)
                key = "rest.taut" if row.reaction == "tension" else "rest.touches"
                found.append(Sentence(key, {"place": in_words(self.touching.system, place_of(row)), "force": symbol}))
        for rub in self.touching.dry_friction:
            symbol = Symbol(symbols[rub.name].name)
            place = in_words(self.touching.system, place_of(rub.row))
            if rub.between_tensions:
                round_drum = {"connection": rub.row.connection, "drum": rub.row.ends[0]}
                found.append(Sentence(f"rest.{rub.between_tensions}", round_drum))
            elif len(rub.load) <= 1:
                limit = tidy(ends.equations.coefficient(rub, 1))
                limit = limit * Symbol(symbols[rub.load[0]].name) if rub.load else limit
                squares = [power(Symbol(symbols[row.name].name), number(2)) for row in rub.rows]
                size = Call("abs", symbol) if rub.across is None else Call("sqrt", add(*squares))
                found.append(Sentence("rest.friction", {"place": place, "force": size, "limit": limit}))
        if not found:  # equilibrium alone
            return
        with self.script.stage("stage.touching", "hint.touching"):
            self.script.say("rest.laws_along" if ends.equations.inertia else "rest.laws")
            self.script.add(Listing(tuple(found)))
            free = ends.equations.reactions(Failure()).free
            if free:
                self.script.say("rest.not_unique", n=len(free))

    # -- ends ---------------------------------------------------------------------------------
    def _ends(self, ends: Ends, symbol: Expr, name: str, signs: tuple[int, ...], row: str = "") -> None:
        """Every end that there is, then all together."""
        told: list[tuple[int, FailureCase, int, RestGlossary]] = []
        for sign in signs:
            limit = ends.limit(sign)
            if limit.main is None or limit.first is None:
                if limit.first is None or limit.first.edge.value > ends.low:
                    self.script.say("rest.no_limit")
                continue
            if told and limit.main.failure == Failure() and limit.main.element == told[0][1].element:
                told.append((sign, *told[0][1:]))  # both ends are what equilibrium alone decides
                continue
            line, glossary = self._case(ends, limit, limit.main, symbol, name, row)
            told.append((sign, limit.main, line, glossary))
        if not told:
            raise CannotAnswer(Message("no end of the values with which it stays at rest has a derivation"))
        with self.script.stage("stage.value", "hint.rest_value"):
            self._together(symbol, told)

    def _together(self, symbol: Expr, told: list[tuple[int, FailureCase, int, RestGlossary]]) -> None:
        """low <= p <= high"""
        lines = tuple(line for _s, _c, line, _g in told)
        self.script.glossary = told[-1][3]
        shown = [tidy(case.element) for _s, case, _l, _g in told]
        expected = self.answer.expression if isinstance(self.answer.expression, tuple) else (self.answer.expression,)
        if len(shown) == 2 and shown[0] == shown[1]:
            shown = shown[:1]  # at one value alone
        if tuple(shown) != tuple(expected):
            raise RoutesDisagree(
                Message("the derivation ends in another formula than the solver. This is a defect of freebody")
            )
        if len(shown) == 2:
            sides: tuple[Expr, ...] = (shown[0], symbol, shown[1])
            relations: tuple[Relation, ...] = ("≤", "≤")
        elif len(told) == 2 or told[0][1].failure == Failure():  # no inequality decides it
            sides, relations = (symbol, shown[0]), ("=",)
        else:
            sides, relations = (symbol, shown[0]), (_AT[told[0][0]],)
        self.script.line(*sides, relations=relations, why="rest.values", args={"lines": lines}, uses=lines)
        self.context.glossary = told[-1][3]

    def _case(
        self, ends: Ends, limit: HoldingLimit, case: FailureCase, symbol: Expr, name: str, row: str = ""
    ) -> tuple[int, RestGlossary]:
        """One way to fail: equilibrium with the states of its contacts, down to the limit."""
        script = self.script
        glossary = RestGlossary(ends, limit, case, name)
        script.glossary = glossary
        equations = _plain_equations(ends, self.touching)
        acting = acting_at_rest(self.touching, equations, case.failure)
        newton = RestNewton(acting, glossary, equations.inertia)
        with script.stage("stage.failure", "hint.failure"):
            end = "upper" if limit.sign > 0 else "lower"
            key = "alone" if case.failure == Failure() else f"{'extreme' if row else 'fails'}_{end}"
            script.say(f"rest.{key}", words=ready(case.words), name=symbol)
        if not row and (rub := turning(equations, case.failure)) is not None:
            names = (*(r.name for r in rub.rows), *rub.load)
            symbols: dict[str, Expr] = {name: Symbol(self.symbols[name].name) for name in names}
            if len(equations.together(rub, case.failure)) > 1:
                line, rest = tell_feet(script, newton, equations, rub, case.failure)
            else:
                line, rest = tell_cone(script, newton, equations, rub, symbols)
            with script.stage("stage.solution", "hint.solution", n=len(names)):
                line = self._solved(case, symbol, line, is_root=_has_roots(rest, ends.index))
            self._conditions(case, newton, equations, line)
            return line, glossary
        rows, said = newton.tell(script, (row,) if row else ())
        with script.stage("stage.solution", "hint.solution", n=len(rows) + len(said)):
            solver = newton.eliminator(script)
            if row:
                unknown = newton.acting.generator(row)
                value, line = solver.solve(solver.with_said(rows, said), [unknown])[unknown]
                is_drawn_back = newton.acting.sign(row) != newton.acting.rows[row].sign
                if not ((-value if is_drawn_back else value) - case.element).is_zero():
                    raise RoutesDisagree(Message("the derivation ends in another formula than the solver's"))
            else:
                line = solver.residual(rows, said)
                if solver.condition != (symbol, tidy(case.element)):
                    line = self._solved(case, symbol, line, is_root=_has_roots(solver.rest, ends.index))
        self._conditions(case, newton, equations, line)
        return line, glossary

    def _solved(self, case: FailureCase, symbol: Expr, line: int, *, is_root: bool) -> int:
        """The condition solved for the parameter."""
        argument = solved_argument(case.element)
        if argument is not None:
            function, inner = argument
            line = self.script.line(
                Call(function, symbol), tidy(inner), why="solve.divide", args={"line": line}, uses=(line,)
            )
        key = "rest.root" if is_root else "rest.limit"
        return self.script.line(symbol, tidy(case.element), why=key, args={"line": line}, uses=(line,))

    def _conditions(self, case: FailureCase, newton: RestNewton, equations: RestEquations, limit_line: int) -> None:
        """Where this way to fail comes first: what the other contacts transmit at this limit is what they can."""
        for condition in case.conditions:
            key, args = told_purpose(condition.purpose)
            lines: tuple[int, ...] = ()
            if key in ("condition.touches", "condition.sticks", "condition.taut"):
                with suppress(CannotAnswer):
                    is_stuck, place = key == "condition.sticks", str(args["connection"])
                    lines = self._forces(case, newton, equations, place, is_stuck)
            with self.script.stage("stage.conditions", "hint.rest_conditions"):
                left, sign, right = sides_of(tidy(condition.element), condition.relation)
                uses = (*lines, limit_line)
                self.script.line(
                    left,
                    right,
                    relations=(sign,),
                    why=f"{key}_from" if lines else key,
                    args={**args, "lines": uses},
                    uses=uses if lines else (),
                )

    def _forces(
        self, case: FailureCase, newton: RestNewton, eq: RestEquations, place: str, sticks: bool
    ) -> tuple[int, ...]:
        """The lines of what a contact transmits at the limit. Raises CannotAnswer where that is not unique."""
        bounds = (r for r in newton.acting.rows.values() if r.unilateral)
        row = next((r for r in bounds if in_words(self.touching.system, place_of(r)) == place), None)
        rub = next(
            (r for r in self.touching.dry_friction if r.load and row is not None and r.load[0] == row.name), None
        )
        if row is None or (sticks and rub is None):
            raise CannotAnswer(Message("there is no such contact"))
        asked = (row.name, *(r.name for r in rub.rows)) if sticks and rub is not None else (row.name,)
        reduced = eq.reactions(case.failure)
        if any(set(reduced.pivots.get(eq.columns[n], {eq.columns[n]: None})) - {RHS} for n in asked):
            raise CannotAnswer(Message("it is not unique"))
        again = RestNewton(newton.acting, newton.limit_glossary, eq.inertia)
        trial = Script(newton.limit_glossary, self.script.next_number)
        trial.stages = [*self.script.stages]  # what has been said there is not said again
        n_told = len(trial.stages)
        rows, said = again.tell(trial, asked)
        solver = again.eliminator(trial)
        with trial.stage("stage.solution", "hint.solution", n=len(rows) + len(said)):
            indices = [newton.acting.generator(n) for n in asked]
            found = solver.solve(solver.with_said(rows, said), indices)
        trial.stages = trial.stages[n_told:]
        self.script.take(trial)
        return tuple(line for _value, line in found.values())

    # -- other questions ----------------------------------------------------------------------
    def _first(self, ends: ParameterEnds, name: str) -> None:
        """Every way to fail as the parameter grows; the smallest limit comes first."""
        limit = ends.limit(1)
        if limit.main is None:
            raise CannotAnswer(Message("the failure that comes first has no closed form"))
        symbol = Symbol(name)
        told: list[tuple[FailureCase, int, RestGlossary]] = []
        for case in sorted(limit.cases, key=lambda c: c is limit.main):
            try:
                told.append((case, *self._case(ends, limit, case, symbol, name)))
            except CannotAnswer:
                if case is limit.main:
                    raise
        main, line, glossary = told[-1]
        with self.script.stage("stage.value", "hint.rest_value"):
            self.script.glossary = glossary
            for other, _line, _glossary in told[:-1]:
                self.script.line(
                    tidy(main.element),
                    tidy(other.element),
                    relations=("≤",),
                    why="rest.earlier",
                    args={"lines": (line, _line), "words": ready(main.words)},
                    uses=(line, _line),
                )
            self.script.line(symbol, tidy(main.element), why="rest.first", args={"line": line}, uses=(line,))
        self.context.glossary = glossary

    @_tell.register(Holds)
    def _holds(self, q: Holds) -> None:
        """The reserve vanishes at the limit of a coefficient of friction: with more friction it is positive."""
        answer = self.answer.expression
        assert answer is not None
        assert not isinstance(answer, tuple)
        name = next((n for n in coefficients_of_friction(self.context.system) if n in free_symbols(answer)), "")
        if not name:
            raise CannotAnswer(
                Message("the reserve contains no coefficient of friction that could be followed to its limit")
            )
        ends = self.rest.parameter(name)
        self._contacts(ends)
        limit = ends.limit(-1)
        if limit.main is None:
            raise CannotAnswer(Message("the limit of friction has no closed form"))
        line, glossary = self._case(ends, limit, limit.main, Symbol(name), name)
        self.script.glossary = glossary
        with self.script.stage("stage.value", "hint.rest_value"):
            self.script.line(
                *balanced(answer), why="rest.reserve", args={"line": line, "name": Symbol(name)}, uses=(line,)
            )
            self.script.line(
                answer, ZERO, relations=("≥",), why="rest.holds", args={"name": Symbol(name)}, uses=(line,)
            )
        self.context.glossary = glossary


def _has_roots(rest: Ratio, index: int) -> bool:
    """Whether an equation is of higher degree in a generator."""
    numerator = rest.numerator()
    return index in numerator.generators() and len(numerator.coefficients(index)) > 2


def _plain_equations(ends: Ends, touching: TouchingAtRest) -> RestEquations:
    """Equilibrium without a reaction that is taken as given."""
    eq = ends.equations
    return eq if ends.asked is None else RestEquations(eq.state, touching.dry_friction, eq.inertia)
