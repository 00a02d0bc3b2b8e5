"""Equations of motion in generalized coordinates: M(q) q'' = F(q, q', t), with loop constraints."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

from freebody.language.expression import Call, Expr, Symbol, add, multiply, number
from freebody.language.notation import to_latex, to_python
from freebody.language.sentences import Message
from freebody.model.elements import NonholonomicForm
from freebody.model.states import shown_rate, state_name
from freebody.present.lines import system_line
from freebody.present.report.blocks import Block, Formula, Paragraph, Remark, Report, Section
from freebody.present.report.result import Result
from freebody.present.report.results import line, summary, table
from freebody.study.setup import Setup
from freebody.study.worded import in_words
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.system.system import System


@dataclass(frozen=True)
class Equations(Result):
    """M du/dt = F, with the closed loops that bind further coordinates."""

    system: System
    coordinates: tuple[str, ...]
    dependent: tuple[str, ...]
    mass_matrix: tuple[tuple[Expr, ...], ...]
    forcing: tuple[Expr, ...]
    loops: tuple[Expr, ...]
    dependent_rates: dict[str, Expr]
    velocity_constraints: tuple[Expr, ...]
    redundant: tuple[str, ...]
    singular: tuple[str, ...] = ()  # poses in which named angles of space are not determined

    def lines(self) -> Iterator[tuple[Expr, Expr]]:
        """Every equation as (left, right)."""
        for row, force in zip(self.mass_matrix, self.forcing, strict=True):
            terms = [
                multiply(m, Call("rate", shown_rate(c)))
                for m, c in zip(row, self.coordinates, strict=True)
                if m != number(0)
            ]
            yield add(*terms), force

    def to_plain(self) -> dict[str, Any]:
        """Plain data: the JSON document of `freebody eom`."""
        return {
            "title": self.system.title,
            "degrees_of_freedom": len(self.coordinates) - len(self.system.states),
            "coordinates": list(self.coordinates),
            "dependent_coordinates": list(self.dependent),
            "mass_matrix": [[to_python(e) for e in row] for row in self.mass_matrix],
            "forcing": [to_python(e) for e in self.forcing],
            "equations": [f"{to_python(a)} = {to_python(b)}" for a, b in self.lines()],
            "latex": [f"{to_latex(a)} = {to_latex(b)}" for a, b in self.lines()],
            "constraints": [to_python(e) for e in self.loops],
            "velocity_constraints": [to_python(e) for e in self.velocity_constraints],
            "dependent_rates": {k: to_python(e) for k, e in self.dependent_rates.items()},
            "redundant": list(self.redundant),
            "singular": list(self.singular),
        }

    def to_latex(self) -> str:
        """An `align` environment, loops first."""
        rows = [f"0 &= {to_latex(e)}" for e in (*self.loops, *self.velocity_constraints)]
        rows += [f"{to_latex(a)} &= {to_latex(b)}" for a, b in self.lines()]
        body = " \\\\\n    ".join(rows)
        return "\\begin{align}\n    " + body + "\n\\end{align}"

    @property
    def report(self) -> Report:
        return summary(self.system.title, self._blocks())

    def _blocks(self) -> Iterator[Block]:
        def zero(e: Expr) -> Paragraph:
            return line(Formula((number(0), e), ("=",)))

        yield line(
            system_line(self.system, len(self.coordinates) - len(self.system.states), self.coordinates, self.dependent)
        )
        if self.dependent:
            told = Message("Closed loops (the dependent coordinates follow from them)")
            yield Section((told,), tuple(map(zero, self.loops)))
            rates = ((Call("rate", Symbol(name)), rate) for name, rate in self.dependent_rates.items())
            yield Section(
                (Message("Rates of the dependent coordinates"),), tuple(line(Formula(r, ("=",))) for r in rates)
            )
        if self.velocity_constraints:
            yield Section((Message("Velocity constraints"),), tuple(map(zero, self.velocity_constraints)))
        equations = tuple(line(Formula(sides, ("=",))) for sides in self.lines())
        still = Remark((Message("Nothing can move, so there are no equations of motion."),))
        yield Section((Message("Equations of motion"),), equations or (still,))
        own = [k for k, name in enumerate(self.coordinates) if not state_name(name)]  # states have no mass
        if len(own) > 1:
            rows = (((Formula((self.mass_matrix[j][k],)),) for k in own) for j in own)
            yield Section((Message("Mass matrix"),), tuple(table(rows)))
        if self.redundant:
            yield line(Message("redundant constraints: {names}", names=", ".join(self.redundant)))
        yield from (line(Message("not at {pose}", pose=pose)) for pose in self.singular)


@in_words
def equations_of_motion(system: System) -> Equations:
    """Derives the equations; of a system with contacts those that hold at the start. Raises ModelError if the system
    cannot be assembled, CannotAnswer if friction slides at the start."""
    if system.bounds or system.dry_friction:
        from freebody.study.settled import settled

        return equations_of_motion(settled(system))
    if not any(
        getattr(item.measure, "incremental", False) for item in (*system.constraint_rows, *system.applied_loads)
    ):
        # nothing counts from the start; without loops no numbers are needed either, but where nothing can be assembled
        with suppress(ZeroDivisionError):
            model = SymbolicModel(system, [])
            if not model.loops and not model.redundant:
                return _equations(system, model)
    return _equations(system, Setup(system, 2).model)


def _equations(system: System, model: SymbolicModel) -> Equations:
    state = SymbolicState(model)
    rows = [row.measure for row in system.constraint_rows if isinstance(row.measure, NonholonomicForm)]
    velocity = [tidy(model.field.lowest_terms(state.raw_rate(measure))) for measure in rows]
    forcing = [model.field.lowest_terms(model.in_independent_speeds(f)) for f in model.dynamics.forcing]
    return Equations(
        system,
        tuple(c.name for c in model.coordinates),
        tuple(c.name for c in model.dependent),
        _symmetric(model.dynamics.mass_matrix),
        tuple(map(tidy, forcing if system.space else model.dynamics.forcing)),
        tuple(tidy(primitive_part(e.value)) for e in model.loops),
        {c.name: tidy(model.dependent_speed(c)) for c in model.dependent},
        tuple(e for e in velocity if e != number(0)),
        tuple(model.redundant),
        model.bodies.singular_poses,
    )


def _symmetric(M: list[list[Ratio]]) -> tuple[tuple[Expr, ...], ...]:
    """The tidy mass matrix; equal entries are put in order once."""
    upper = {(j, k): tidy(x) for j, row in enumerate(M) for k, x in enumerate(row) if j <= k}
    return tuple(tuple(upper[min(j, k), max(j, k)] for k in range(len(M))) for j in range(len(M)))


def primitive_part(x: Ratio) -> Ratio:
    """A loop equation without factors that cannot vanish."""
    field = x.field
    _unit, factors = field.factor(x.num)
    result = field.one
    for base, _exponent in factors:
        if not base.is_constant():
            result = result * base
    return result
