"""What has ends in a system at rest: a parameter with which it holds, a reaction that rest leaves open."""

from __future__ import annotations

import math

from freebody.errors import CannotAnswer
from freebody.language.expression import add, free_symbols, stands_in
from freebody.language.sentences import Message, in_turn
from freebody.language.units import FORCE, TORQUE
from freebody.numeric.friction_branches import spread
from freebody.numeric.friction_limits import Optimum
from freebody.numeric.rest_problem import rest_problem
from freebody.study.answering.draws import Draw
from freebody.study.friction.carried import carried
from freebody.study.friction.cases import Ends
from freebody.study.friction.failures import how_it_fails
from freebody.study.friction.limits import HoldingEnd, Parametric
from freebody.study.friction.touching import TouchingAtRest
from freebody.study.setup import Setup
from freebody.symbolic.active_set import RestEquations
from freebody.symbolic.field import Field
from freebody.symbolic.ratio import Ratio

_LARGE = 1e6  # a coefficient of friction that is as good as any


class ParameterEnds(Ends):
    """The ends of the values of one parameter with which a system holds."""

    def __init__(self, touching: TouchingAtRest, setup: Setup, name: str) -> None:
        super().__init__(touching, setup)
        self.name = name
        self.index = self.field.index(self.model.parameters[name])
        self.equations = RestEquations(setup.start_instant, touching.dry_friction, carried(touching, setup))
        self.parametric = self._enters()
        self.is_linear, self.low = self.parametric.is_linear, self.parametric.low
        self.is_coefficient = self.parametric.is_friction
        if not self.is_linear:
            self.n_wide = 6

    def _enters(self) -> Parametric:
        """How the parameter enters, decided on the formulas."""
        p, eq = self.index, self.equations
        coefficients = [(rub, eq.coefficient(rub, d)) for rub in self.touching.dry_friction for d in (1, -1)]

        def depends(x: Ratio) -> bool:
            return p in self.field.ingredients(x)

        in_geometry = any(depends(x) for slopes in eq.gradients.values() for x in slopes.values())
        in_friction = any(depends(c) for rub, c in coefficients if rub.load)
        laws = [*eq.loads.values(), *(c for rub, c in coefficients if not rub.load)]
        in_loads = any(map(depends, laws))
        if not (in_geometry or in_friction or in_loads):
            why = Message("{x} has no part in whether the system stays at rest", x=self.name)
            raise CannotAnswer(self._open() or why)
        is_linear = not in_geometry and not in_friction and all(is_linear_in(self.field, x, p) for x in laws)
        is_friction = in_friction and not in_geometry and not in_loads
        parameter = self.touching.system.parameters[self.name]
        low = -math.inf if parameter.sign == "any" or parameter.dimension in (FORCE, TORQUE) else 0.0
        return Parametric(
            self.name, is_linear, is_friction, parameter.is_angle, parameter.acute, low, self._is_in_pose()
        )

    def _is_in_pose(self) -> bool:
        """Whether anything about places and directions is stated with it."""
        system = self.touching.system
        rows = [(row.measure, row.target) for row in self.touching.held.constraint_rows]
        gaps = [(b.row.measure, b.row.target, b.within, b.lost) for b in system.bounds]
        placed = [(body.start, body.chain) for body in system.bodies.values()]
        return stands_in(self.name, (rows, gaps, placed))

    def _open(self) -> str:
        """That the friction of which it is a coefficient does not act, where nothing touches; empty where it would."""
        rubbing = {rub.name for rub in self.touching.dry_friction}
        apart = [
            rub.row.connection
            for rub in self.touching.system.dry_friction
            if rub.of and rub.name not in rubbing and self.name in free_symbols(add(rub.static, rub.kinetic))
        ]
        if not apart:
            return ""
        if not self.touching.bounds:
            return Message("nothing touches at the start, so no friction acts, and {x} decides nothing", x=self.name)
        return Message(
            "open at the start: {contacts}; no friction acts there, and {x} decides nothing",
            contacts=in_turn(list(dict.fromkeys(apart))),
            x=self.name,
        )

    def edge(self, draw: Draw, sign: int, near: float | None) -> HoldingEnd | None:
        return self.parametric.edge(self.touching, draw, sign, near)

    def why_never(self, draw: Draw) -> str:
        value = _LARGE if self.parametric.is_friction else draw.values[self.name]
        problem = self.parametric.problem(self.touching, draw, value)
        why = "" if problem is None else how_it_fails(self.touching, problem, draw)
        if not (self.parametric.is_linear or self.parametric.is_friction):
            return Message("no value of {x} that was tried keeps the system at rest: {words}", x=self.name, words=why)
        return Message("no value of {x} keeps the system at rest: {words}", x=self.name, words=why)


class ReactionEnds(Ends):
    """The ends of one reaction among all that hold a system; positive as people count it."""

    def __init__(self, touching: TouchingAtRest, setup: Setup, row: str) -> None:
        super().__init__(touching, setup)
        self.asked = row
        symbol = self.field.parameter(f"@{row}")
        self.index = self.field.index(symbol)
        self.is_linear = True
        self.equations = RestEquations(
            setup.start_instant, touching.dry_friction, carried(touching, setup), (row, symbol)
        )

    def edge(self, draw: Draw, sign: int, near: float | None) -> HoldingEnd | None:
        problem = rest_problem(draw.reference, draw.q, self.touching.dry_friction)
        assert self.asked is not None
        place = problem.place(self.asked)
        ends = spread(problem, place)
        if ends is None:
            return None
        own = self.equations.rows[self.asked].sign
        found = ends[1] if sign * own > 0 else ends[0]
        return HoldingEnd(own * found.value, problem, Optimum(own * found.value, found.forces, found.motion))


def is_linear_in(field: Field, x: Ratio, generator: int) -> bool:
    """Whether an element is a polynomial of degree 0 or 1 in a generator."""
    if generator not in field.ingredients(x):
        return True
    return generator in x.generators() and generator not in field.ingredients(field.partial(x, generator))
