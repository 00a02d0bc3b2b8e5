"""A machine that one load of open size holds in the pose of its start, as a chain of names.

The angles of the loops come first and the ratios of speeds k = d theta_i/d q, then the load by virtual power,

    sum of Q_j ds_j/dq = 0,

and by it what is asked: reactions by the balance of the bodies, each in these names.
Source: Goldstein, Poole & Safko, Classical Mechanics, 3rd ed. 2002, sec. 1.4.
"""

from __future__ import annotations

from contextlib import suppress

from freebody.language.expression import Symbol
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.questions.base import Quantity
from freebody.questions.reading import Question
from freebody.study.answering import loops
from freebody.study.answering.about_rest import balancing, is_given_pose, open_loads
from freebody.study.answering.answer import Answer, made
from freebody.study.answering.at_equilibrium import AT_REST, seen_at_rest
from freebody.study.answering.chain import ChainBuilder, InNamesState
from freebody.study.answering.crosscheck import CrossCheck, as_parts
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import NO_FORM
from freebody.study.answering.in_names import in_numbers
from freebody.study.answering.named_formulas import InNames, NamedFormula
from freebody.study.mobility.centres import moving_for
from freebody.study.setup import Setup
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.staged import StagedMotion
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.validity import texts


def answer_at_rest(setup: Setup, question: Question) -> Answer | None:
    """What is asked of forces in the pose of the start, where a load balances the others; None for other questions."""
    q = question.quantity.at_rest or question.quantity
    if question.event is not None or question.options or q.scope != "instant" or not q.is_of_state:
        return None
    if q.kinematic_order is not None or not (q is not question.quantity or setup.model.dynamics.moves_no_mass):
        return None
    return next((found for name in open_loads(setup) if (found := _answer(setup, question, name, q)) is not None), None)


def load_at_rest(setup: Setup, question: Question, name: str) -> Answer | None:
    """The size of the load that balances the others in the pose of the start; None where no chain of names has it."""
    return None if question.options else _answer(setup, question, name, None)


def _answer(setup: Setup, question: Question, name: str, q: Quantity | None) -> Answer | None:
    """Of a quantity, or, without one, of the load itself; name: of the load that balances the others."""
    if not setup.model.loops or len(setup.model.coordinates) != 1 or not is_given_pose(setup):
        return None
    with suppress(*NO_FORM, KeyError, ValueError, ArithmeticError):
        found, load = _chain(setup, name, q), _chain(setup, name, None)
        return None if found is None or load is None else _told(setup, question, name, q, found, load)
    return None


class StateInNames(InNamesState):
    """The pose at rest in the names of a chain, lengths of rams, struts and springs among them: the direction of one is
    (x, y)/s then, and not a root of all that its ends depend on."""

    def __init__(self, chain: ChainBuilder, staged: StagedMotion, letter: str) -> None:
        super().__init__(chain, staged, letter)
        self._lengths: dict[int, Ratio] = {}  # roots, by the names of lengths
        for push in staged.model.system.applied_loads:
            if not isinstance(push.measure, NonholonomicForm):
                self._name_length(f"s_{push.name}".replace(".", "_").replace(" ", "_"), push.measure)

    def _name_length(self, name: str, measure: Measure) -> None:
        f, value = self.model.field, self._chain.here(self.model.value_of(measure))
        roots = [g for g in value.generators() if f.generators[g].kind == "root" and f.generators[g].made_of]
        if len(roots) == 1 and roots[0] not in self._lengths:
            root = f.variable(roots[0])
            per_length = f.lowest_terms(root / value)
            if roots[0] not in f.ingredients(per_length):
                named = self._staged.named(name, value, positive=True)
                self._chain.name_motion([named])
                self._lengths[roots[0]] = f.variable(named.index) * per_length

    def here(self, x: Ratio) -> Ratio:
        f, x = self.model.field, self._chain.here(super().here(x))
        for root, length in self._lengths.items():
            even, odd = (*x.numerator().coefficients(root), f.zero)[:2]
            if not odd.is_zero():  # a direction b r/d is b (r^2/d)/r
                along = f.lowest_terms(odd * f.radicand(root) / x.denominator())
                x = f.lowest_terms(even / x.denominator()) + along / length
        return x

    def multiplier(self, row: ConstraintRow) -> Ratio:
        return self.model.reactions.at_rest(row, self.here)

    def force(self, c: Coordinate) -> Ratio:
        """Along a coordinate, by virtual power."""
        model, k = self.model, self.model.coordinates.index(c)
        total = model.field.zero
        for body, wrench in model.loads.wrenches.items():
            for part, slope in zip(wrench, model.kinematics.partial_velocities[body][k], strict=True):
                total = total + self.here(part) * self.here(slope)
        return model.field.lowest_terms(total)


def _chain(setup: Setup, name: str, q: Quantity | None) -> InNames | None:
    (c,) = setup.model.coordinates
    builder = ChainBuilder(setup, {c.index: setup.start.of(c.index), c.speed: setup.model.field.zero})
    staged = builder.staged(is_still=True)
    builder.name_angles()
    builder.name_motion(staged.ratios)
    state = StateInNames(builder, staged, "" if q is None else q.letter)
    size = balancing(setup, state.force(c), name)
    if size is None or q is None:
        return None if size is None else builder.told(size)
    builder.steps.append(NamedFormula(Symbol(name), tidy(size)))
    return builder.told(q.value(setup.system, state))


def _told(setup: Setup, question: Question, name: str, q: Quantity | None, found: InNames, load: InNames) -> Answer:
    """load: the chain of the load, which not everything depends on. Raises CannotAnswer where it could not be
    checked."""
    route = Message("floating-point solve of all bodies and constraints at rest there")
    check = CrossCheck(question.text, route, AT_REST)

    def compare(draw: Draw) -> None:
        exact = in_numbers(setup, found, draw, draw.start())
        (size,) = in_numbers(setup, load, draw, draw.start())
        held = draw.with_values({**draw.values, name: size})
        seen = seen_at_rest(held, held.q, 0.0 * held.q)
        numeric = exact if q is None else as_parts(q.value(setup.system, moving_for(q, seen)))
        check.compare(draw, (*exact, 1.0), (*numeric, 1.0 + float(abs(seen.accelerations).max(initial=0.0))))

    evidence = check.gather(setup.draw_stream(), compare).evidence()
    balance = Message("in the pose of the start, where {name} balances the other loads", name=name)
    others = (p for p in setup.system.parameters.values() if p.name != name)
    has_values = all(p.value is not None or p.form is not None for p in others)
    draw = setup.draws[0]
    value = in_numbers(setup, found, draw, draw.start()) if has_values else None
    result = found.chain.result
    return made(
        question,
        result if len(result) > 1 else result[0],
        value if value is None or len(result) > 1 else value[0],
        conditions=[*found.closing, *texts(found.needs)],
        notes=[*([] if q is None else [balance]), *loops.branch(found.sides)],
        evidence=evidence,
        chain=found.chain,
    )
