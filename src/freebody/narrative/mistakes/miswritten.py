"""Mistakes in the equations of single bodies: a reaction forgotten or turned round on one body, or its moment.

Newton and Euler for every body, sum over rows of direction * reaction = inertia force - loads, are solved again with
one entry changed; in numbers first, then exactly.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Argument, Message, Sentence
from freebody.model.elements import ConstraintRow
from freebody.narrative.context import Context
from freebody.numeric.jets import Array
from freebody.questions.reactions import said_of_reaction
from freebody.questions.reading import Question
from freebody.symbolic.linear import RHS, Row, solve
from freebody.symbolic.ratio import Ratio
from freebody.tolerances import ROUND_OFF

MOST_EQUATIONS = 18


@dataclass(frozen=True)
class Miswritten:
    """One entry of the equations of a body: the slots in which a row has another factor."""

    said: Sentence
    row: str
    body: str
    slots: tuple[str, ...]
    factor: int


class BodyEquations:
    """The equations of all bodies for what a question asks about an instant. Raises CannotAnswer where they do not
    determine it one by one."""

    def __init__(self, context: Context, question: Question) -> None:
        system = context.system
        if question.event is not None or question.at_start or question.transition is not None:
            raise CannotAnswer(Message("equations of bodies are for the general instant"))
        if system.space or system.bounds or system.dry_friction:
            raise CannotAnswer(Message("equations of bodies are for systems in the plane that do not change"))
        self.newton = context.newton
        self.model = context.setup.model
        self.field = self.model.field
        self.acting = self.newton.acting
        if self.newton.symmetry.merged or self.model.redundant:
            raise CannotAnswer(Message("reactions depend on each other"))
        self.parts = self.newton.asked(question.quantity)
        self.reactions = {name: self.acting.generator(name) for name in self.acting.rows}
        self.columns = [*self.model.accelerations, *self.reactions.values()]
        if not self.field.ingredients(sum(self.parts[1:], self.parts[0])) & set(self.columns):
            raise CannotAnswer(Message("what is asked follows from the state"))
        places = [(b, slot) for b in self.model.system.moving for slot in ("x", "y", "angle")[: 3 if b.turns else 2]]
        self.places = [(b.name, slot) for b, slot in places]
        if not len(self.columns) == len(self.places) <= MOST_EQUATIONS:
            raise CannotAnswer(Message("there are not as many equations as unknowns"))
        self.rows = [self._row(body, slot) for body, slot in self.places]

    def _row(self, body: str, slot: str) -> Row:
        model, f = self.model, self.field
        k = model.bodies.slots.index(slot)
        rest = (
            model.dynamics.inertia_force(body, model.kinematics.body_accelerations[body])[k]
            - model.loads.wrenches[body][k]
        )
        row: Row = {}
        for a in model.accelerations:
            slope = f.partial(rest, a)
            if not slope.is_zero():
                row[a] = -slope
                rest = rest - slope * f.variable(a)
        for name, index in self.reactions.items():
            push = self.acting.directions[name].get((body, slot))
            if push is not None:
                row[index] = push
        if not rest.is_zero():
            row[RHS] = rest
        return row

    def mistakes(self) -> Iterator[Miswritten]:
        """A reaction turned round or left out on one body, wholly or in its moment only."""
        for name, held in self.acting.rows.items():
            force = _words(held)
            for body in dict.fromkeys(b for b, _slot in self.acting.directions[name]):
                slots = tuple(s for b, s in self.acting.directions[name] if b == body)
                for factor, mark in ((-1, "_turned"), (0, "")):
                    args: dict[str, Argument] = {"force": force, "body": body}
                    yield Miswritten(Sentence(f"mistake.reaction{mark}", args), name, body, slots, factor)
                    if "angle" in slots and len(slots) > 1:
                        yield Miswritten(Sentence(f"mistake.moment_of{mark}", args), name, body, ("angle",), factor)

    # -- in numbers ---------------------------------------------------------------------------
    def at(self, point: Mapping[int, Any]) -> tuple[Array, Array]:
        """Matrix and right-hand side at a point."""
        n = len(self.columns)
        matrix, right = np.zeros((n, n)), np.zeros(n)
        for k, row in enumerate(self.rows):
            for column, x in row.items():
                value = float(self.field.evaluate(x, point))
                if column == RHS:
                    right[k] = value
                else:
                    matrix[k, self.columns.index(column)] = value
        return matrix, right

    def numbers(self, m: Miswritten, equations: tuple[Array, Array], point: Mapping[int, Any]) -> tuple[float, ...]:
        """What is asked, with a mistake; nan where it is not determined."""
        matrix = equations[0].copy()
        column = self.columns.index(self.reactions[m.row])
        for k, (body, slot) in enumerate(self.places):
            if body == m.body and slot in m.slots:
                matrix[k, column] *= m.factor
        try:
            if abs(np.linalg.det(matrix)) < ROUND_OFF:
                return (float("nan"),) * len(self.parts)
            solved = np.linalg.solve(matrix, equations[1])
            values = {**point, **dict(zip(self.columns, map(float, solved), strict=True))}
            return tuple(float(self.field.evaluate(p, values)) for p in self.parts)
        except (np.linalg.LinAlgError, ArithmeticError, ValueError, KeyError):
            return (float("nan"),) * len(self.parts)

    # -- exactly ------------------------------------------------------------------------------
    def exactly(self, m: Miswritten) -> Sequence[Ratio]:
        """What is asked, as elements. Raises CannotAnswer where the equations do not tell."""
        rows: list[Row] = []
        index = self.reactions[m.row]
        for (body, slot), row in zip(self.places, self.rows, strict=True):
            changed = dict(row)
            if body == m.body and slot in m.slots and index in changed:
                changed[index] = changed[index] * m.factor
            rows.append(changed)
        solved = solve(self.field, rows, self.columns, self.model.samples.vanishes)
        if solved.free or solved.contradictory:
            raise CannotAnswer(Message("the equations do not tell"))
        values = {column: row.get(RHS, self.field.zero) for column, row in solved.pivots.items()}
        found = (self.field.substitute(part, values) for part in self.parts)
        return [self.field.lowest_terms(self.model.in_independent_speeds(x)) for x in found]


def _words(row: ConstraintRow) -> Sentence:
    """What a reaction is called."""
    of = said_of_reaction(row.reaction)
    args: dict[str, Argument] = {"reaction": f"@{of}.{row.reaction}", "connection": row.connection}
    axis = row.component.split()[-1]
    if axis in ("x", "y"):
        return Sentence(f"symbol.{of}_component", {**args, "axis": f"@{axis}"})
    at: Argument = Sentence("what.at", {"places": tuple(row.ends)}) if row.ends else ""
    return Sentence(f"what.{of}", {**args, "at": at})
