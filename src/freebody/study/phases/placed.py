"""Where a phase begins, and its system for given parameter sets."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace

from freebody.errors import CannotAnswer
from freebody.language.expression import ZERO, Expr, free_symbols, n_operations
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, TIME
from freebody.model.elements import Parameter, Start
from freebody.study.answering.draws import SEED, Draw
from freebody.study.setup import Setup
from freebody.symbolic.model import SymbolicModel
from freebody.system.modes import counted_from, depends_on_time
from freebody.system.system import System


@dataclass(frozen=True)
class Placed:
    """The state in which a phase begins: that of the file, or poses and velocities of every body as formulas. since:
    the time of the motion then, where something depends on it; the phase counts its own from there. lengths: of what
    is held at the length that it has at the start of the file, by row, as far as a formula tells it."""

    bodies: Mapping[str, Start] | None = None
    since: Expr | None = None
    lengths: Mapping[str, Expr] = field(default_factory=dict[str, Expr])

    @property
    def n_operations(self) -> int:
        """How long the formulas of the state are."""
        found = 0
        for start in (self.bodies or {}).values():
            place = () if start.at is None else start.at[1]
            turned = (start.angle or ZERO, start.angular_velocity or ZERO)
            found += sum(map(n_operations, (*place, *(start.velocity or ()), *turned, *(start.rates or ()))))
        return found

    def put_into(self, system: System) -> System:
        if self.bodies is None:
            return system
        bodies = {n: replace(b, start=self.bodies.get(n, b.start)) for n, b in system.bodies.items()}
        parameters = dict(system.parameters)
        for start in self.bodies.values():
            for name in sorted(free_symbols(start.angle or ZERO) - parameters.keys()):
                parameters[name] = Parameter(name, DIMENSIONLESS, None, "any")
        if self.since is not None:
            system = counted_from(system, self.since)
            for name in sorted(free_symbols(self.since) - parameters.keys()):
                parameters[name] = Parameter(name, TIME, None, "nonnegative")
        rows = tuple(replace(row, closes=False) if row.closes else row for row in system.constraint_rows)
        return replace(
            system,
            bodies=bodies,
            parameters=parameters,
            start={},
            start_rates={},
            mode=None,
            constraint_rows=rows,
            impulses=(),
        )


_INSTANTS = (0.37, 0.037)  # [s] at which poses in general position are looked at


class Given(Setup):
    """A system set up for given parameter sets, without drawing. model: of the same system, where there is one."""

    def __init__(
        self, system: System, values: Sequence[Mapping[str, float]], model: SymbolicModel | None = None
    ) -> None:
        self.system = system
        self.draws = []
        for chosen in values:
            with suppress(CannotAnswer):
                own = {name: value for name, value in chosen.items() if name in system.parameters}
                self.draws.append(Draw.of(system, own))
        if not self.draws:
            raise CannotAnswer(Message("the phase cannot be assembled at its start"))
        if model is not None:
            self._made = model
            return
        starts = [d.sample() for d in self.draws]
        # what drivers lead is elsewhere at other instants alone: a lever that starts level, with sin(th) = 0
        instants = _INSTANTS if depends_on_time(system) else (0.0, 0.0)
        looked_at = zip(self.draws, instants, strict=False)
        general = [d.sample(d.anywhere(SEED, t, 0.1), is_start=False) for d, t in looked_at]
        self._made = SymbolicModel(system, [*starts, *general])
