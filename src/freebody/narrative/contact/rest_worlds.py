"""Limits of rest in numbers: where the lines of a derivation about rest are looked at.

At every draw that fails the same way the parameter is put to its limit; the forces are those of the linear programs.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from functools import cached_property

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.language.sentences import Message, Sentence
from freebody.narrative.lines.glossary import Glossary, Meaning, TrueWhen, World
from freebody.numeric.friction_branches import margin
from freebody.numeric.reference import Reference
from freebody.numeric.rest_problem import rest_problem
from freebody.numeric.snapshot import Snapshot
from freebody.study.answering.draws import Draw
from freebody.study.friction.cases import Compared, Ends, FailureCase, HoldingLimit

N_WORLDS = 5


class RestWorld(World):
    """A draw at its limit, with the multipliers there by row."""

    def __init__(self, glossary: Glossary, draw: Draw, snapshot: Snapshot, forces: Mapping[str, float]) -> None:
        super().__init__(glossary, draw, snapshot)
        self.forces = forces


class RestGlossary(Glossary):
    """The symbols of one limit. parameter: what is put to its limit; nothing where a reaction is asked for."""

    def __init__(self, ends: Ends, limit: HoldingLimit, case: FailureCase, parameter: str) -> None:
        super().__init__(ends.setup)
        self.touching = ends.touching
        self.is_linear = ends.is_linear
        self.limit = limit
        self.case = case
        self.parameter = parameter

    def worlds(self, when: TrueWhen) -> Iterator[World]:
        yield from self._limits

    @cached_property
    def _limits(self) -> list[World]:
        found: list[World] = []
        for c in self.limit.compared:
            if c.case is self.case and len(found) < N_WORLDS:
                with suppress(CannotAnswer, ArithmeticError, ValueError):
                    found.append(self._world(c))
        return found

    def _world(self, c: Compared) -> World:
        values = dict(c.draw.values)
        if self.parameter:
            assert c.exact is not None
            values[self.parameter] = c.exact
        reference = Reference(self.touching.held, values)
        q = reference.assemble(guess=c.draw.q)
        draw = Draw(values, reference, q)
        problem, optimum = c.edge.problem, c.edge.optimum
        if not self.is_linear:  # there the forces known are those just beyond the end
            problem = rest_problem(reference, q, self.touching.dry_friction)
            found = margin(problem)
            if found is None:
                raise CannotAnswer(Message("nothing holds the system at its limit"))
            optimum = found
        forces = dict(zip(problem.names, map(float, optimum.forces), strict=True))
        return RestWorld(self, draw, reference.snapshot(q, np.zeros_like(q)), forces)

    def introduce_reaction(self, row: str, symbol: Expr, what: Sentence, sign: int) -> None:
        """The symbol of a reaction, sign times its multiplier, read from the linear programs."""
        self.introduce(Meaning(symbol, what, _reads(sign, row), ""))


def _reads(sign: int, row: str) -> Callable[[World], float]:
    def read(world: World) -> float:
        assert isinstance(world, RestWorld)
        return sign * world.forces[row]

    return read
