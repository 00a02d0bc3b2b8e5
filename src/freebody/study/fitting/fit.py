"""Parameters, start values and offsets from measured motions, by least squares.

The motion is followed at each trial of the unknowns, and what it gives at the times of the measurements is compared
with them, each difference by its standard deviation. The Jacobian is exact, from the tangents of the motions; where a
motion has none (or one that does not exist everywhere, at an impact that comes to rest, say), it is by central
differences of motions, which are followed far more exactly than the steps of the differences are wide.
Source: Branch, Coleman & Li, SIAM J. Sci. Comput. 21, 1999, 1-23 (the trust-region method of SciPy, with bounds).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer, FreebodyError, InputError
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.numeric.options import SimulationOptions
from freebody.study.fitting.data import Run, Series, read_run
from freebody.study.fitting.estimate import estimated
from freebody.study.fitting.result import Fit, Residuals
from freebody.study.fitting.unknowns import Unknown, unknowns
from freebody.study.given import each
from freebody.study.simulation.recorded import series_units
from freebody.study.simulation.simulate import with_steps
from freebody.study.simulation.tangents import MotionTangents
from freebody.study.sweeps.records.base import Followed
from freebody.study.worded import FAILED, in_words
from freebody.system.system import System

TOLERANCE = 1e-11  # of the motions
_SLOPES = 1e-9  # tolerance of motions in the Jacobian, where residuals need not be so exact
_STEP = 1e-4  # of the size of an unknown, in differences
_FAR = 1e3  # of the scatter of the data: how far off a motion counts that cannot be followed
_MOST = 200  # trials of the unknowns


@in_words
def fit(
    system: System,
    data: str | Path | Sequence[str | Path],
    free: str | Sequence[str],
    *,
    tolerance: float = TOLERANCE,
    method: str = "auto",
) -> Fit:
    """Fits a model to measured motions.

    data: tables of measurements, one for each run (see `study/fitting/data.py`); free: parameters, named measures or
    their rates (the start of each run), and `offset(x)` of a measured series; tolerance, method: of the motions. Raises
    InputError for what cannot be read and for fewer data than unknowns, CannotAnswer if the motion cannot be followed
    with the numbers to begin with."""
    units = series_units(system)
    files = [data] if isinstance(data, str | Path) else list(data)
    if not files:
        raise InputError(Message("there are no data: give a table of measurements"))
    runs = [read_run(Path(file), units) for file in files]
    seen, wanted = unknowns(system, list(dict.fromkeys(each(free))), runs, units)
    n = sum(len(s.values) for run in runs for s in run.series)
    if n < len(wanted):
        raise InputError(Message("{n} measured values cannot tell {m} unknowns", n=n, m=len(wanted)))
    problem = _Problem(seen, runs, wanted, SimulationOptions(tolerance=tolerance, method=method))
    return problem.solved(system)


@dataclass
class _Problem:
    """Residuals as a function of the unknowns, each counted by its size."""

    system: System
    runs: Sequence[Run]
    wanted: Sequence[Unknown]
    options: SimulationOptions
    n_motions: int = 0
    n_tangents: int = 0
    why_differences: str = ""  # why the Jacobian is not exact

    def __post_init__(self) -> None:
        self.sizes = np.array([u.size for u in self.wanted])
        self._last: dict[int, tuple[Any, Followed]] = {}  # of each run the motion that was followed last
        self.bounds = tuple(np.array([getattr(u, end) for u in self.wanted]) / self.sizes for end in ("low", "high"))

    def solved(self, system: System) -> Fit:
        optimize: Any = import_module("scipy.optimize")
        z0 = np.array([u.start for u in self.wanted]) / self.sizes
        self._modelled(z0 * self.sizes)  # says why, where the motion cannot be followed at all
        found = optimize.least_squares(
            self._residuals,
            z0,
            jac=self._jacobian,
            bounds=self.bounds,
            xtol=1e-12,
            ftol=1e-12,
            gtol=1e-12,
            max_nfev=_MOST,
        )
        residuals: Array = np.asarray(found.fun, dtype=np.float64)
        best: Array = np.asarray(found.x, dtype=np.float64)
        values, jacobian = best * self.sizes, self._jacobian(best)
        names = [u.name for u in self.wanted]
        own = np.where(np.abs(values) > 1e-9 * self.sizes, np.abs(values), self.sizes)  # shares are of what was found
        estimate = estimated(jacobian * (own / self.sizes), residuals, names, own)
        modelled = self._modelled(values)
        told = [
            Residuals(run.file, s.name, series_units(system)[s.name], s.times, s.values, own)
            for run, of_run in zip(self.runs, modelled, strict=True)
            for s, own in zip(run.series, of_run, strict=True)
        ]
        at_bound = tuple(
            u.name
            for u, z, low, high in zip(self.wanted, best, *self.bounds, strict=True)
            if z - low < 1e-6 or high - z < 1e-6
        )
        return Fit(
            system,
            tuple(self.wanted),
            values,
            estimate,
            tuple(told),
            bool(found.status > 0),
            at_bound,
            len(residuals),
            self.n_motions,
            self.n_tangents,
            self.why_differences,
        )

    # -- residuals ----------------------------------------------------------------------------
    def _residuals(self, z: Array) -> Array:
        """(n,) each by its standard deviation; far off where a motion cannot be followed."""
        every = [s for run in self.runs for s in run.series]
        try:
            modelled = [x for of_run in self._modelled(z * self.sizes) for x in of_run]
        except (FreebodyError, ValueError, *FAILED):
            return np.concatenate([np.full(len(s.values), _FAR * _scatter(s)) / s.spreads for s in every])
        return np.concatenate([(x - s.values) / s.spreads for s, x in zip(every, modelled, strict=True)])

    def _jacobian(self, z: Array) -> Array:
        """(n, p), exact where all motions have derivatives; by differences from the first one on that has none."""
        if not self.why_differences:
            try:
                return self._tangents(z * self.sizes) * self.sizes
            except (FreebodyError, ValueError, *FAILED) as error:
                self.why_differences = str(error) or type(error).__name__
        return self._differences(z)

    def _differences(self, z: Array) -> Array:
        """(n, p) by central differences, one-sided where a bound is nearer than a step."""
        columns: list[Array] = []
        for k in range(len(z)):
            ahead, behind = z.copy(), z.copy()
            ahead[k] = min(z[k] + _STEP, self.bounds[1][k])
            behind[k] = max(z[k] - _STEP, self.bounds[0][k])
            columns.append((self._residuals(ahead) - self._residuals(behind)) / (ahead[k] - behind[k]))
        return np.column_stack(columns)

    def _tangents(self, values: Array) -> Array:
        """(n, p) derivatives of the residuals by the unknowns. Raises CannotAnswer where there are none."""
        rows: list[Array] = []
        followed = replace(self.options, tolerance=max(self.options.tolerance, _SLOPES))
        for k, run in enumerate(self.runs):
            own = {u.parameter: i for i, u in enumerate(self.wanted) if u.parameter and u.run in (-1, k)}
            tangents = None
            if own:
                self.n_tangents += 1
                motion = self._motion(k, run, values).result
                tangents = MotionTangents(motion, list(own), run.end, followed, run.times)
            for s in run.series:
                part = np.zeros((len(s.values), len(self.wanted)))
                if tangents is not None:
                    part[:, list(own.values())] = tangents.along(s.name, s.times)
                part[:, [i for i, u in enumerate(self.wanted) if u.series == s.name]] = 1.0
                rows.append(part / s.spreads[:, None])
        return np.concatenate(rows)

    def _modelled(self, values: Array) -> list[list[Array]]:
        """What the model gives of each series of each run. Raises CannotAnswer where a motion cannot be followed."""
        return [self._of_run(k, run, values) for k, run in enumerate(self.runs)]

    def _motion(self, k: int, run: Run, values: Array) -> Followed:
        """A run with values of the unknowns. Raises CannotAnswer where it cannot be followed."""
        own = {
            u.parameter: float(x) for u, x in zip(self.wanted, values, strict=True) if u.parameter and u.run in (-1, k)
        }
        key = k, tuple(own.values())
        if self._last.get(k, (None,))[0] == key:
            return self._last[k][1]
        until = max(run.end, 1e-9)
        self.n_motions += 1
        options = replace(self.options, every=until)
        result = with_steps(self.system, until, options, values=own, at=run.times)
        if not result.is_complete:
            raise CannotAnswer(
                Message("the motion of {file} cannot be followed: {why}", file=run.file, why=result.message)
            )
        self._last[k] = key, Followed(result)
        return self._last[k][1]

    def _of_run(self, k: int, run: Run, values: Array) -> list[Array]:
        motion = self._motion(k, run, values)
        found: list[Array] = []
        for s in run.series:
            series = motion.series(s.name)[np.searchsorted(motion.times, s.times)]
            offset = sum(float(x) for u, x in zip(self.wanted, values, strict=True) if u.series == s.name)
            if not np.isfinite(series).all():
                raise CannotAnswer(Message("{name} has no value at some of the measured times", name=s.name))
            found.append(series + offset)
        return found


def _scatter(s: Series) -> float:
    return float(np.ptp(s.values)) or float(np.abs(s.values).max()) or 1.0
