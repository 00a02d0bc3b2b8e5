"""What loads push with: their laws in coordinates, speeds and time, and the wrench on every body."""

from __future__ import annotations

from functools import cached_property

from freebody.errors import CannotAnswer
from freebody.language.expression import free_symbols
from freebody.model.elements import AppliedLoad, NonholonomicForm
from freebody.symbolic.bodies import Bodies
from freebody.symbolic.configuration import Configuration
from freebody.symbolic.given_start import GivenStart
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.samples import Samples
from freebody.symbolic.speeds import Speeds
from freebody.symbolic.unknowns import Coordinate, ModelUnknowns
from freebody.system.system import System

_MOST_TERMS = 60  # of a start value that is told by a formula


class SymbolicLoads:
    """The loads of a system over one configuration."""

    def __init__(
        self,
        system: System,
        unknowns: ModelUnknowns,
        bodies: Bodies,
        configuration: Configuration,
        speeds: Speeds,
        samples: Samples,
        start: GivenStart,
    ) -> None:
        self._system, self._unknowns, self._bodies = system, unknowns, bodies
        self._configuration, self._speeds = configuration, speeds
        self._samples, self._start = samples, start
        self.field = unknowns.field

    @cached_property
    def wrenches(self) -> dict[str, list[Ratio]]:
        """Force and moment about the mass centre of all loads on every body, along its slots."""
        slots = self._bodies.slots
        total: dict[str, list[Ratio]] = {b.name: [self.field.zero] * len(slots) for b in self._system.all_moving}
        for push in self._system.all_loads:
            law = self.law(push)
            for (body, slot), slope in self._configuration.gradient(push.measure).items():
                if body not in total:
                    continue  # what the ground feels moves nothing
                k = slots.index(slot)
                total[body][k] = total[body][k] + law * slope
        return total

    def law(self, push: AppliedLoad) -> Ratio:
        """Generalized force of a load; in coordinates, speeds and time."""
        return self._configuration.geometry.apply(push.in_symbols, self._values(push))

    def needs(self, push: AppliedLoad) -> list[tuple[Ratio, str]]:
        """(element, relation to 0) without which the law has no value as it is written."""
        return self._configuration.geometry.needs(push.in_symbols, self._values(push))

    def _values(self, push: AppliedLoad) -> dict[str, Ratio]:
        """What the law of a load is written in: its measure and the others that it names, and their rates."""
        value_of, rate = self._configuration.value_of, self._speeds.rate
        values: dict[str, Ratio] = {}
        needed = free_symbols(push.in_symbols)
        if not isinstance(push.measure, NonholonomicForm):
            if "@value" in needed:
                value = value_of(push.measure)
                values["@value"] = value - self.start_constant(push)
            if "@rate" in needed:
                values["@rate"] = rate(value_of(push.measure))
        for name, measure in push.measures:
            value = value_of(measure)
            values[name] = value
            values[f"rate({name})"] = rate(value)
        return values

    # -- measures of which only changes count -------------------------------------------------
    def start_constant(self, push: AppliedLoad) -> Ratio:
        """The start value of a measure of which only changes count (a spring relaxed at the start)."""
        if isinstance(push.measure, NonholonomicForm) or not push.measure.incremental:
            return self.field.zero
        if self._samples.starts_at_zero(push.name):
            return self.field.zero
        now = self._configuration.value_of(push.measure)
        if not self.field.ingredients(now) & self._unknowns.changing:
            return now  # it never changes
        given = self._start.of_measure(push.measure, push.name)
        if given is None:
            given = self._from_coordinates(now, push.name)
        if given is not None:
            return given
        constants = self._unknowns.constants
        if push.name not in constants:
            name = push.name.replace(".", "_").replace(" ", "_")
            constants[push.name] = self.field.parameter(f"{name}_0")
            found = [sample.constants[push.name] for sample in self._samples.points]
            self._samples.put_in(self.field.index(constants[push.name]), found)
        return constants[push.name]

    def _from_coordinates(self, now: Ratio, name: str) -> Ratio | None:
        """The start value of a measure from those of the coordinates, and of what loops bind there, as it is at all
        samples; None where it has no short formula."""
        f = self.field
        values: dict[int, Ratio] = {f.index(f.time): f.zero}
        for c in (*self._speeds.coordinates, *self._speeds.dependent):
            value = self._at_start(c)
            if value is not None:
                values[c.index] = value
        bound = {d.index for d in self._speeds.dependent} - values.keys()
        if any(c.index not in values for c in self._speeds.coordinates):
            return None
        if bound & f.ingredients(now):
            try:
                values |= self._start.by_loops(values)
            except (CannotAnswer, ZeroDivisionError):
                return None
        x = f.follow(now, values)
        is_told = x.n_terms <= _MOST_TERMS and not f.ingredients(x) & self._unknowns.changing
        return x if is_told and self._samples.is_start_value(x, name) else None

    def _at_start(self, c: Coordinate) -> Ratio | None:
        """The start value of a coordinate, where the model tells it or it is a multiple of a right angle."""
        if c.name in self._system.all_start:
            return self._configuration.geometry.scalar(self._system.all_start[c.name])
        value = self._start.of_coordinate(c)
        return self._start.recognised(c) if value is None else value
