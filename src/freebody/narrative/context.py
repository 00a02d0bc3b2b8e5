"""What the derivations of one system share, and the way from a question to the derivation of its kind."""

from __future__ import annotations

from collections.abc import Callable, Container, Generator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Symbol
from freebody.language.sentences import Message
from freebody.narrative.contact.settings import changes_at_borders_alone, first_mode, has_phases, setup_of
from freebody.narrative.lines.glossary import Glossary
from freebody.narrative.lines.script import DerivationStage, Script
from freebody.narrative.principles.acting import Acting
from freebody.narrative.principles.newton import AT_REST_WORDS, Newton, Solved
from freebody.narrative.principles.planar_rates import PlanarRates
from freebody.narrative.principles.planner import OF_STRUCTURES
from freebody.narrative.principles.symmetry import Symmetry
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.senses import drawn_symbols
from freebody.study.setup import Setup
from freebody.symbolic.ratio import Ratio
from freebody.system.symbols import reaction_symbols
from freebody.system.system import System

Method = Literal["auto", "newton", "lagrange", "energy"]
METHODS: tuple[Method, ...] = ("auto", "newton", "lagrange", "energy")


@dataclass
class Context:
    """One system on both routes. Each derivation is written as if it stood alone, but for the accelerations and forces
    that those before it have found; `sharing` leaves out what has been told. `next_number` runs through all."""

    system: System
    next_number: int = 1
    introduced: set[str] = field(default_factory=set[str])  # by the opening: parameters, measures
    found: Solved = field(default_factory=dict[int, tuple[Ratio, int]])  # by derivations so far
    new: Solved = field(default_factory=dict[int, tuple[Ratio, int]])  # by the one that is being written
    after_blow: tuple[int, ...] = ()  # lines of the opening: the speeds just after the blow at the start
    own: Expr | tuple[Expr, ...] | None = None  # in which the derivation of a phase has ended: no name of the answer
    at_places: dict[str, Context] = field(
        default_factory=dict[str, "Context"]
    )  # of functions of the place, by question
    drawn: System | None = None  # the system of the pictures, where `system` is one mode of it

    @cached_property
    def setup(self) -> Setup:
        return setup_of(self.system)

    @cached_property
    def glossary(self) -> Glossary:
        return Glossary(self.setup)

    @cached_property
    def acting(self) -> Acting:
        return Acting(self.setup.model, symbols=drawn_symbols(self.setup.model.system, base=self.drawn))

    @cached_property
    def rates(self) -> PlanarRates:
        """What moves how in the plane."""
        return PlanarRates(self.acting, self.glossary, Symmetry(self.acting, self.glossary))

    @cached_property
    def newton(self) -> Newton:
        """Principles of the plane; where nothing can move they are the conditions of equilibrium."""
        if not self.acting.stands_still:
            return Newton(self.acting, self.glossary, self.rates, self.rates.symmetry)
        return Newton(
            self.acting,
            self.glossary,
            self.rates,
            self.rates.symmetry,
            words=AT_REST_WORDS,
            preferences=OF_STRUCTURES,
        )

    def script(self) -> Script:
        """A derivation of its own, with numbers that go on."""
        if "rates" in self.__dict__:  # not made for a system in space
            self.newton.begin()
        return Script(self.glossary, self.next_number)

    def keep_found(self, again: Mapping[int, int], shown: Container[int]) -> None:
        """What the derivation has found is known to the next ones. again: lines that stand elsewhere already; shown:
        all that a reader sees."""
        for unknown, (value, line) in self.new.items():
            if (number := again.get(line, line)) in shown:
                self.found.setdefault(unknown, (value, number))
        self.new.clear()

    @contextmanager
    def as_if_alone(self) -> Generator[None]:
        """Nothing has been found before."""
        found, new = self.found, self.new
        self.found, self.new = {}, {}
        try:
            yield
        finally:
            self.found, self.new = found, new

    def of_question(self, question: Question) -> Context:
        """What is meant of one law of motion is told, with contacts or dry friction, of the mode with which the motion
        begins."""
        quantity = question.quantity
        is_told_whole = quantity.scope in ("structure", "rest") or quantity.is_of_state or quantity.jump is not None
        if is_told_whole or not has_phases(self.system):
            return self
        if changes_at_borders_alone(self.system):
            return self._of_both_sides
        self._first_mode.next_number = self.next_number
        return self._first_mode

    @cached_property
    def _of_both_sides(self) -> Context:
        """With the law that loads have on both sides of their borders."""
        made = Context(self.system, self.next_number, self.introduced)
        made.setup = Setup(self.system)
        return made

    @cached_property
    def _first_mode(self) -> Context:
        """A system of its own. Raises CannotAnswer where the motion begins with none."""
        setup = first_mode(self.system)
        made = Context(setup.system, self.next_number, self.introduced, drawn=self.system)
        made.setup = setup
        return made

    def symbol(self, *wishes: str) -> Symbol:
        """The first of some names that means nothing else in this system, as a symbol."""
        taken = {*self.system.parameters, *self.glossary.measures, "t", "pi", "e"}
        taken |= {reaction.name for reaction in reaction_symbols(self.system).values()}
        return Symbol(next((name for name in wishes if name not in taken), f"{wishes[-1]}_1"))


Derive = Callable[[Context, Question, Answer, Method], list[DerivationStage]]


def refuse(method: Method, allowed: tuple[Method, ...], what: str) -> None:
    """Raises CannotAnswer for a method by which a kind of question has no derivation."""
    if method != "auto" and method not in allowed:
        raise CannotAnswer(
            Message(
                "{what} is not derived by the method {method}; there is: {others}",
                what=what,
                method=method,
                others=", ".join(("auto", *allowed)),
            )
        )
