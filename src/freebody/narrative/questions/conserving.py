"""Whether, and when, a quantity is conserved: the principle that governs it, its rate, and each coefficient of that.

Coordinates and speeds may have any values at an instant; so a rate vanishes for every motion if and only if every
coefficient does with which products of these stand in it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import singledispatch, singledispatchmethod

from freebody.errors import CannotAnswer
from freebody.language.expression import Call, Expr, Symbol, add, n_operations, number
from freebody.language.sentences import Argument, Message, Sentence
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.naming import fresh, named
from freebody.narrative.lines.rates import rate_of
from freebody.narrative.lines.script import DerivationStage, FormulaTable, Listing, Script, ready
from freebody.narrative.principles.formal import FormalState
from freebody.narrative.principles.loops import all_bound
from freebody.narrative.principles.motion_equations import motion_equations
from freebody.narrative.principles.reactions import name_reactions
from freebody.numeric.jets import Array
from freebody.numeric.start_velocities import start_velocities
from freebody.questions.base import Quantity
from freebody.questions.conservation import Conserved, GeneralizedMomentum
from freebody.questions.momentum import AngularMomentum, Momentum
from freebody.questions.reading import Question
from freebody.questions.vectors import Group, is_among
from freebody.study.answering.answer import Answer
from freebody.study.answering.crosscheck import element_at
from freebody.study.conservation.balance import RateBalance, RatePrinciple
from freebody.study.conservation.judge import Judge
from freebody.study.conservation.vanishing_rates import ConservationFinding
from freebody.symbolic.tidy import tidy
from freebody.symbolic.vanishing import cases_where_zero, motion_terms, texts_of
from freebody.system.system import System

MOST_OPERATIONS = 70  # of a formula that is shown on the way
MOST_ROWS = 8  # of the table of coefficients


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The rate of the quantity and where it vanishes. Raises CannotAnswer where there is no formula of it."""
    refuse(method, (), "conservation")
    asked = question.quantity
    assert isinstance(asked, Conserved)
    if answer.expression is None:
        raise CannotAnswer(answer.reason or Message("its rate has no closed form"))
    telling = _ConservingTelling(context, asked, answer)
    telling.tell()
    return telling.script.stages


@dataclass
class _Part:
    """One scalar whose rate is looked at: the quantity itself, or a component of a vector."""

    quantity: Quantity
    name: str
    symbol: Symbol
    finding: ConservationFinding
    lines: list[int] = field(default_factory=list[int])

    @property
    def rate(self) -> Expr:
        return Call("rate", self.symbol)

    def words(self, system: System) -> Argument:
        """What it is called."""
        return self.quantity.sentence(system) or f"@{self.name}"


class _ConservingTelling:
    """Writes one derivation."""

    def __init__(self, context: Context, asked: Conserved, answer: Answer) -> None:
        self.context, self.answer = context, answer
        self.system, self.model = context.system, context.setup.model
        self.script: Script = context.script()
        self.rates = Judge(context.setup).rates
        self.known: set[str] = set()
        self.words: Argument = asked.of.sentence(self.system) or f"@{asked.name}"
        self.parts = self._parts(asked)

    def _parts(self, asked: Conserved) -> list[_Part]:
        letter = asked.of.letter
        of, components = asked.of, asked.of.components(self.system)
        if not components:
            symbol = Symbol(fresh(self.context, letter, f"{letter}_c"))
            return [_Part(of, asked.name, symbol, self.rates.finding(of, asked.name))]
        found: list[_Part] = []
        for axis, q in components:
            symbol = Symbol(fresh(self.context, f"{letter}_{axis}", f"{letter}_{axis}_c"))
            found.append(_Part(q, f"{asked.name} along {axis}", symbol, self.rates.finding(q, asked.name)))
        return found

    # -- in order -----------------------------------------------------------------------------
    def tell(self) -> None:
        script = self.script
        with script.stage("conserved.quantity", "conserved.quantity_hint"):
            named(self.context, script, *(self._meaning(p) for p in self.parts))
            for part in self.parts:
                self._value(part)
        with script.stage("conserved.principle", "conserved.principle_hint"):
            self._state_principle(self.parts[0])
            rates = [Meaning(p.rate, Sentence("conserved.rate", {"name": p.symbol}), self._rate(p)) for p in self.parts]
            named(self.context, script, *rates)
            for part in self.parts:
                self._by_principle(part)
        open_ = [p for p in self.parts if p.finding.is_conserved is not True]
        if any(self._needs_motion(p) for p in self.parts):
            self._along_the_motion()
        with script.stage("conserved.coefficients", "conserved.coefficients_hint"):
            for part in open_:
                self._coefficients(part)
            self._verdict(open_)

    # -- the quantity -------------------------------------------------------------------------
    def _meaning(self, part: _Part) -> Meaning:
        said = Sentence("conserved.what", {"name": part.words(self.system)})
        return Meaning(part.symbol, said, self._read(part))

    def _read(self, part: _Part) -> Callable[[World], float]:
        return reader_of(self.context, part.quantity, part.finding.balance)

    def _rate(self, part: _Part) -> Callable[[World], float]:
        return rate_of(self._read(part))

    def _value(self, part: _Part) -> None:
        """The quantity in coordinates and speeds, body by body where there are several."""
        try:
            value = part.finding.balance.value
        except CannotAnswer:
            return
        shown = tidy(value)
        if n_operations(shown) > MOST_OPERATIONS / len(self.parts):
            return
        sides: list[Expr] = [part.symbol]
        summed = self._by_bodies(part)
        if summed is not None and summed != shown:
            sides.append(summed)
        part.lines.append(self.script.line(*sides, shown, why=_key(part.quantity, "value")))

    def _by_bodies(self, part: _Part) -> Expr | None:
        f = self.model.field
        terms: list[Expr] = []
        for body in self.system.moving:
            share = part.quantity.share(body.name)
            if share is None:
                continue
            x = f.lowest_terms(f.element(share.value(self.system, self.context.setup.state)))
            if not x.is_zero():
                terms.append(tidy(x))
        return add(*terms) if len(terms) > 1 else None

    # -- the principle ------------------------------------------------------------------------
    def _state_principle(self, part: _Part) -> None:
        self._say_principle(part.quantity, part.finding.principle)
        principle = part.finding.principle
        if principle is not None and any("de/dt" in name for name, _x in principle.parts):
            self.script.say("conserved.turning_direction")

    @singledispatchmethod
    def _say_principle(self, q: Quantity, principle: RatePrinciple | None) -> None:
        self.script.say(_key(q, "principle"))

    @_say_principle.register(AngularMomentum)
    def _say_of_moments(self, q: AngularMomentum, principle: RatePrinciple | None) -> None:
        moves = principle is not None and any("v × P" in name for name, _x in principle.parts)
        own_centre = q.about is None and isinstance(q.body, str)
        key = "conserved.about_moving" if moves else "conserved.about_centre" if own_centre else "conserved.about"
        about = "" if own_centre or q.about is None else str(q.about)
        self.script.say(key, point=about or Message("the origin"))
        if moves:
            self.script.say("conserved.why_moving", point=about or Message("the origin"))

    def _by_principle(self, part: _Part) -> None:
        """The rate as a sum over what acts, reactions as symbols."""
        principle = self._formal(part)
        if principle is None:
            return
        self._silent(part, principle)
        f = self.model.field
        used = {g for _n, x in principle.parts for g in f.ingredients(x)}
        acting = self.context.acting
        rows = [row for row in acting.rows if acting.generator(row) in used]
        name_reactions(self.script, self.context.glossary, acting, rows, self.known)
        terms: list[Expr] = []
        said: list[Sentence] = []
        for name, x in principle.parts:
            x = f.lowest_terms(self.model.in_independent_speeds(f.element(x)))
            if not x.is_zero() or "de/dt" in name:
                said.append(Sentence("conserved.part", {"part": _said(name), "value": tidy(x)}))
            if not x.is_zero():
                terms.append(tidy(x))
        if said:
            self.script.add(Listing(tuple(said)))
        sides = [part.rate, add(*terms) if terms else number(0)]
        total = f.lowest_terms(part.finding.balance.rate) if part.finding.is_conserved is not True else f.zero
        if not rows and tidy(total) != sides[-1]:
            sides.append(tidy(total))
        part.lines.append(self.script.line(*sides, why="conserved.together", uses=part.lines[-1:]))

    def _formal(self, part: _Part) -> RatePrinciple | None:
        """The principle with reactions as symbols; None for a quantity that has none of its own."""
        if part.finding.principle is None and part.finding.is_conserved is not True:
            return None
        state = FormalState(self.context.acting)
        try:
            return RateBalance(part.quantity, self.system, state, part.name).by_principle()
        except CannotAnswer:
            return None

    def _silent(self, part: _Part, principle: RatePrinciple) -> None:
        """Connections and loads that act from outside and do not appear."""
        q = part.quantity
        if not principle.total(self.model.field.zero).generators():
            self.script.say(_key(q, "nothing"))
        acts = _acting_on(q)
        if acts is None:
            return
        key, group = acts
        heard = " ".join(name for name, _x in principle.parts)
        acting = [
            name
            for name in (*self.system.connections, *self.system.loads)
            if self._touches(name, group, part.finding.balance) and f"{name}" not in heard.split()
        ]
        if acting:
            self.script.say(key, names=tuple(acting))

    def _touches(self, name: str, group: Group, balance: RateBalance) -> bool:
        """Whether a connection or load acts on the bodies that are meant, from outside."""
        moving = {b.name for b in self.system.moving}
        rows = [row for row in self.system.constraint_rows if row.connection == name]
        for push in (p for p in self.system.applied_loads if p.load == name):
            touched = {b for b in push.measure.bodies() if b in moving}
            if any(is_among(b, group) for b in touched) and (
                len(touched) == 1 or not all(is_among(b, group) for b in touched)
            ):
                return True
        return any(balance.reaches_outside(row, group) for row in rows)

    # -- along the motion ---------------------------------------------------------------------
    def _needs_motion(self, part: _Part) -> bool:
        """Whether the rate is not told in coordinates and speeds yet."""
        return self._last(part) is not None

    def _last(self, part: _Part) -> Expr | None:
        """The rate as it has to come out, where no line ends in it."""
        rate = number(0) if part.finding.is_conserved is True else tidy(part.finding.balance.rate)
        items = [i for s in self.script.stages for i in s.items if getattr(i, "number", None) in part.lines[-1:]]
        sides = getattr(items[-1], "sides", ()) if items else ()
        return None if sides and sides[0] == part.rate and sides[-1] == rate else rate

    def _along_the_motion(self) -> None:
        """By differentiation, the accelerations put in."""
        lines: list[int] = []
        with self.script.stage("conserved.motion", "conserved.motion_hint"):
            try:
                lines += all_bound(self.context.setup, self.script)
                lines += [row.number for row in motion_equations(self.context, self.script)]
            except CannotAnswer as error:
                self.script.say("conserved.no_equations", reason=ready(str(error)))
            for part in self.parts:
                rate = self._last(part)
                if rate is not None:
                    uses = (*part.lines, *lines)
                    args: dict[str, Argument] = {"lines": tuple(lines), "name": part.symbol}
                    key = "conserved.differentiated" if lines else "conserved.differentiated_plain"
                    part.lines.append(self.script.line(part.rate, rate, why=key, args=args, uses=uses))

    # -- when it vanishes ---------------------------------------------------------------------
    def _coefficients(self, part: _Part) -> None:
        """What stands before each product of what moves, and when it is zero."""
        rate = part.finding.balance.rate
        terms = motion_terms(rate, self.rates.is_parameter)
        moving = sorted({g for m, _c in terms for g in m.generators()})
        names = tuple(self.model.field.generators[g].display for g in moving)
        line = part.lines[-1] if part.lines else 0
        self.script.say("conserved.each" if names else "conserved.constant", names=names, line=line)
        rows: list[tuple[Sentence | Expr | str, ...]] = []
        for m, c in terms[:MOST_ROWS]:
            cases = cases_where_zero([c], self.rates.may_vanish)
            when = _either(texts_of(cases)) if cases else Sentence("conserved.never_zero")
            rows.append((tidy(m), tidy(c), when))
        header = tuple(Sentence(f"conserved.table_{n}") for n in ("before", "coefficient", "zero"))
        if names or len(rows) > 1:
            self.script.add(FormulaTable(header, tuple(rows)))
        if len(terms) > MOST_ROWS:
            self.script.say("conserved.more", n=len(terms) - MOST_ROWS)
        provided = self.rates.provided(part.finding)
        if provided:
            self.script.say("conserved.provided", names=tuple(Symbol(n) for n in provided))

    def _verdict(self, open_: Sequence[_Part]) -> None:
        if not open_:
            self.script.say("conserved.always", name=self.words)
            return
        for part in open_:
            found = part.finding
            if found.is_conserved is False:
                self.script.say("conserved.never", name=part.words(self.system))
            else:
                exact = "conserved.exactly_if" if found.is_exact else "conserved.if"
                self.script.say(exact, name=part.words(self.system), conditions=_either(texts_of(found.cases)))


def _said(name: str) -> Sentence:
    """A part of a principle in words."""
    for start, key in (
        ("moment of ", "moment_of"),
        ("power of ", "power_of"),
        ("generalized force along ", "force_along"),
    ):
        if name.startswith(start):
            return Sentence(f"conserved.{key}", {"name": name.removeprefix(start)})
    if "v × P" in name:
        return Sentence("conserved.carried")
    if "de/dt" in name:
        return Sentence("conserved.by_turning")
    if name.startswith("dT/d"):
        return Sentence("conserved.slope_of_energy", {"name": Symbol(name.removeprefix("dT/d"))})
    return Sentence("conserved.force_of", {"name": name})


def _either(cases: Sequence[str]) -> Sentence:
    """a or b or c"""
    first, *rest = cases
    if not rest:
        return Sentence("conserved.case", {"case": ready(first)})
    return Sentence("conserved.or", {"first": ready(first), "rest": _either(rest)})


@singledispatch
def _acting_on(q: Quantity) -> tuple[str, Group] | None:
    """What changes a momentum from outside: the sentence that there is none, and the bodies that are meant."""
    return None


@_acting_on.register(Momentum)
def _forces_on(q: Momentum) -> tuple[str, Group]:
    return "conserved.no_force", q.body


@_acting_on.register(AngularMomentum)
def _moments_on(q: AngularMomentum) -> tuple[str, Group]:
    return "conserved.no_moment" if q.along is None else "conserved.no_moment_along", q.body


def _key(q: Quantity, what: str) -> str:
    return f"conserved.{q.principle}_{what}"


def reader_of(context: Context, q: Quantity, balance: RateBalance) -> Callable[[World], float]:
    """How the numeric route reads a quantity that may be conserved."""
    return _reader(q, context, balance)


@singledispatch
def _reader(q: Quantity, context: Context, balance: RateBalance) -> Callable[[World], float]:
    """Over the numbers; by its formula where it is one of coordinates or potentials."""
    setup = context.setup
    if q.is_of_coordinates or q.is_up_to_constant:
        return lambda world: element_at(setup, (balance.value,), world.draw, world.snapshot)[0]
    return lambda world: float(q.value(setup.system, world.snapshot))


@_reader.register(GeneralizedMomentum)
def _reader_of_conjugate(q: GeneralizedMomentum, context: Context, balance: RateBalance) -> Callable[[World], float]:
    """p = sum of m v . dv/du, the slopes by velocities that the numeric route finds."""
    setup, model = context.setup, context.setup.model
    measures = {c.name: model.measure_of(c) for c in model.coordinates}
    if any(m is None for m in measures.values()):
        return lambda world: element_at(setup, (balance.value,), world.draw, world.snapshot)[0]

    def conjugate(world: World) -> float:
        here = world.snapshot
        reference = here.reference
        standing = reference.geometry(here.q, 0.0 * here.v, here.t)

        def velocity(of: str) -> Array:
            wanted = [(m, 1.0 if name == of else 0.0) for name, m in measures.items() if m is not None]
            return start_velocities(reference, standing, wanted, with_start=False)

        slope = velocity(q.coordinate) - velocity("")
        return float((reference.masses * here.v) @ slope)

    return conjugate
