"""What is asked at a place that energy leads to, where the speed through closed loops has no formula in one piece.

With the angles of the loops at the start and there, each by its own names, and the reduced mass M,

    M u^2/2 + V = M_0 u_0^2/2 + V_0.
"""

from __future__ import annotations

from freebody.errors import CannotAnswer
from freebody.language.expression import Call, Expr, Symbol, add, divide, multiply, negate, number, power, substitute
from freebody.language.notation import compared, reworded
from freebody.language.sentences import Message
from freebody.questions.event_base import QuestionEvent
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.chain import ChainBuilder
from freebody.study.answering.crosscheck import MOTION_TOLERANCE, CrossCheck
from freebody.study.answering.draws import Draw
from freebody.study.answering.evidence import LONGEST
from freebody.study.answering.in_names import in_numbers, told
from freebody.study.answering.named_formulas import NamedFormula
from freebody.study.answering.numbers import at_event
from freebody.study.answering.witness import patience
from freebody.study.setup import Setup
from freebody.symbolic.first_integrals import is_driven
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.staged import shortened
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.zeros import solve_linear


def answer_by_energy(setup: Setup, question: Question) -> Answer | None:
    """At the place of the one coordinate that the question names; None for other questions. Raises CannotAnswer where
    energy does not lead there."""
    q, model, event = question.quantity, setup.model, question.event
    place = _place(setup, question)
    if (
        place is None
        or event is None
        or not q.is_of_state
        or q.wanted is not None
        or question.options
        or is_driven(model)
    ):
        return None
    (c,) = model.coordinates
    builder = ChainBuilder(setup, {c.index: place})
    energy = _Energy(setup, builder, c)
    builder.between = energy.name
    found = builder.chain(q)
    if found is None:
        return None
    route = Message("numerical integration from the start to the event")
    check, in_order = CrossCheck(question.text, route, MOTION_TOLERANCE), list[Draw]()

    def compare(draw: Draw) -> None:
        exact, start = in_numbers(setup, found, draw, draw.start()), draw.start()
        check.compare(draw, exact, at_event(setup, q, draw, start, patience(start, LONGEST), event))
        in_order.append(draw)

    evidence = check.gather(setup.draw_stream(), compare).evidence()
    if setup.has_values and setup.draws[0] not in in_order:
        raise CannotAnswer(Message("'{event}' does not come at the model's own values", event=event.text))
    return told(setup, question, found, evidence, [energy.condition])


def _place(setup: Setup, question: Question) -> Ratio | None:
    """The value of the one coordinate at the event, where that names it alone."""
    event, model = question.event, setup.model
    if not isinstance(event, QuestionEvent) or event.order or len(model.coordinates) != 1:
        return None
    value = model.value_of(event.measure) - model.geometry.scalar(event.value)
    (c,) = model.coordinates
    if model.field.ingredients(value) & {d.index for d in model.dependent}:
        return None
    return solve_linear(value, c.index)


class _Energy:
    """The speed of a coordinate by the energy of the start."""

    def __init__(self, setup: Setup, builder: ChainBuilder, c: Coordinate) -> None:
        self.setup, self.builder, self.c = setup, builder, c
        self.field, self.start = setup.model.field, setup.start
        self._as_mass: dict[str, Expr] = {}  # the reduced mass of the start has its name from the energy
        self.sense = setup.motion.sense(c)
        taken = builder.taken
        self.names = {key: self._fresh(key) for key in ("V", "V_0", "M_0")}
        loops = [e.value.numerator() for e in setup.model.loops]
        self.potential = shortened(setup.motion.integrals.potential_by_loads(), loops)
        self.at_start = ChainBuilder(setup, {c.index: self.start.of(c.index)}, taken)
        enough = compared(self._total(), ">", self.names["V"])
        words = Message("on all of the way there {condition} (it gets there)", condition=enough)
        self.condition = reworded(words, enough)

    def _fresh(self, key: str) -> Symbol:
        while key in self.builder.taken:
            key += "_"
        self.builder.taken.add(key)
        return Symbol(key)

    @property
    def _is_at_rest(self) -> bool:
        return self.start.of(self.c.speed).is_zero()

    def _total(self) -> Expr:
        """The energy of the start."""
        if self._is_at_rest:
            return self.names["V_0"]
        u = tidy(self.start.of(self.c.speed))
        return add(self.names["V_0"], divide(multiply(self.names["M_0"], power(u, number(2))), number(2)))

    def name(self, builder: ChainBuilder) -> None:
        """Potential energies, and by them the speed."""
        builder.steps[:0] = self._steps_of_start()
        V, mass = self.names["V"], builder.mass
        builder.steps.append(NamedFormula(V, tidy(builder.here(self.potential))))
        square = divide(multiply(number(2), add(self._total(), negate(V))), mass)
        root = Call("sqrt", square)
        shown = self.field.generators[self.c.speed].display
        builder.steps.append(NamedFormula(shown, root if self.sense > 0 else negate(root)))

    def _steps_of_start(self) -> list[NamedFormula]:
        """What is known at the start, each name with a 0."""
        first = self.at_start
        first.name_angles()
        if not self._is_at_rest:
            staged = first.staged()
            first.name_motion(staged.ratios, staged.inertias)
            if isinstance(first.mass, Symbol) and any(step.name == first.mass for step in first.steps):
                self._as_mass = {first.mass.name: self.names["M_0"]}
            else:
                first.steps.append(NamedFormula(self.names["M_0"], first.mass))
        first.steps.append(NamedFormula(self.names["V_0"], tidy(first.here(self.potential))))
        own = {step.name.name: step.name for step in first.steps if isinstance(step.name, Symbol)}
        kept = {name.name for name in self.names.values()}
        other = {name: self._fresh(f"{name.rstrip('_')}_0") for name in own if name not in kept} | self._as_mass
        return [NamedFormula(substitute(step.name, other), substitute(step.formula, other)) for step in first.steps]
