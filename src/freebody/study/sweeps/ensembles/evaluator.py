"""Motions in many cases by equations of their own; what these do not bring to its end the engine follows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from freebody.errors import CannotAnswer, FreebodyError
from freebody.numeric.engine.course import Status
from freebody.numeric.engine.integrators import integrator
from freebody.numeric.engine.motion import EXPLICIT
from freebody.numeric.ensemble.devices import Compiled, check_device
from freebody.numeric.ensemble.source import source_of
from freebody.numeric.jets import Array
from freebody.numeric.options import SimulationOptions
from freebody.study.sweeps.ensembles.equations import EquationsOfCopies
from freebody.study.sweeps.ensembles.refusals import check_can_follow, refused
from freebody.study.sweeps.evaluators import Codes
from freebody.study.sweeps.motions import MotionEvaluator
from freebody.study.sweeps.records.base import Seen
from freebody.study.sweeps.statuses import CODES, NOT_DONE
from freebody.study.worded import FAILED
from freebody.system.system import System


@dataclass(frozen=True)
class Ensemble:
    """Some records of many copies of a model, compiled for a device. watched: series that are looked at at asked times;
    extremes: all along."""

    equations: EquationsOfCopies
    compiled: Compiled
    until: float
    watched: tuple[str, ...]
    extremes: tuple[Seen, ...]

    @classmethod
    def of(
        cls, system: System, varied: Sequence[str], seen: Sequence[Seen], until: float, device: str, threads: int
    ) -> Ensemble:
        """Raises CannotAnswer where the symbolic route has no such equations, InputError where the device is not
        there."""
        check_device(device)
        equations = EquationsOfCopies(system, varied)
        watched = tuple(dict.fromkeys(s.series for s in seen))
        extremes = tuple(dict.fromkeys(s for s in seen if s.side))
        text = source_of(equations.copies(watched, extremes), integrator(EXPLICIT).tableau)
        return cls(equations, Compiled(text, len(watched), len(extremes), device, threads), until, watched, extremes)

    def size_of(self, series: str) -> float:
        """That of the system in the unit of a series: its length, or a radian, a rate by the time of the motion."""
        return self.equations.size_of(series) / self.until ** self.equations.series(series).order

    def begun(self, values: Mapping[str, Array], n: int) -> tuple[Array, NDArray[np.bool_]]:
        """(n, n_parameters) parameters of copies, starts without a formula among them, and (n,) whether each has a
        start."""
        n_varied, is_good = len(self.equations.varied), np.ones(n, dtype=bool)
        given = np.empty((n, n_varied + len(self.equations.open)))
        for k, name in enumerate(self.equations.varied):
            given[:, k] = values[name]

        def assemble(i: int) -> None:
            try:
                given[i, n_varied:] = self.equations.given({name: float(x[i]) for name, x in values.items()})
            except (FreebodyError, ValueError, KeyError, *FAILED):
                is_good[i] = False

        if self.equations.open:
            with ThreadPoolExecutor(self.compiled.threads, thread_name_prefix="freebody-starts") as pool:
                list(pool.map(assemble, range(n)))
        return given, is_good

    def follow(self, given: Array, seen: Sequence[Seen], tolerance: float) -> tuple[Array, NDArray[np.bool_]]:
        """(n, n_seen) numbers, and (n,) whether a copy came to its end and has them all. given: (n, n_parameters);
        seen: of the series that are watched, at any times."""
        times = sorted({self.until} | {s.time for s in seen if s.time is not None and s.time <= self.until})
        found = self.compiled.follow(given, np.array(times), tolerance)
        numbers, is_done = np.full((len(given), len(seen)), np.nan), found.is_done
        for k, one in enumerate(seen):
            if one.time is not None and one.time > self.until:
                continue  # the motion does not come to it
            if one.side:
                numbers[:, k] = found.extremes[:, self.extremes.index(one)]
            else:
                at = times.index(self.until if one.time is None else one.time)
                numbers[:, k] = found.watched[:, at, self.watched.index(one.series)]
            is_done = is_done & np.isfinite(numbers[:, k])
        return numbers, is_done


class EnsembleEvaluator(MotionEvaluator):
    """What is recorded of the motion up to a time, in all cases together."""

    def __init__(
        self,
        system: System,
        records: Sequence[str],
        until: float,
        options: SimulationOptions,
        read: System | None,
        varied: Sequence[str],
        device: str,
        threads: int,
    ) -> None:
        """varied: the parameters that differ from case to case. Raises InputError for records that cannot be read and
        devices that are not there, CannotAnswer for what an ensemble does not follow."""
        super().__init__(system, records, until, options, (), read)
        check_can_follow(system, self.records, options)
        self.seen = tuple(record.seen for record in self.records if record.seen is not None)
        try:
            self.ensemble = Ensemble.of(system, varied, self.seen, until, device, threads)
        except CannotAnswer as error:
            raise CannotAnswer(refused([str(error)])) from error

    def together(self, values: Mapping[str, Array], n: int) -> tuple[Array, Codes]:
        numbers, codes = super().together(values, n)
        here = np.flatnonzero(codes == CODES[NOT_DONE])
        given, is_good = self.ensemble.begun({name: x[here] for name, x in values.items()}, len(here))
        here = here[is_good]
        found, is_done = self.ensemble.follow(given[is_good], self.seen, self.options.tolerance)
        numbers[here[is_done]] = found[is_done]
        codes[here[is_done]] = CODES[str(Status.FINISHED)]
        return numbers, codes
