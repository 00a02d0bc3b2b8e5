"""How a motion is followed, as one value: made where a user asks for it, read where it is used."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from enum import Enum

from freebody.errors import InputError
from freebody.language.sentences import Message, listed
from freebody.numeric.engine.integrators import integrator, integrators

MOST_STEPS = 10_000_000
MOST_OUTPUTS = 2_000_000
STEPPING = "moreau"
FINEST, COARSEST = 1e-14, 1e-1  # tolerances


def methods() -> tuple[str, ...]:
    """By which a motion can be followed."""
    return "auto", *integrators(), STEPPING


def has_step(method: str) -> bool:
    """Whether a method takes the step that it is given, and does not choose its own."""
    return method == STEPPING or (method != "auto" and not integrator(method).is_adaptive)


class ImpactLaw(Enum):
    """How an impact restores what it compresses."""

    NEWTON = "newton"
    POISSON = "poisson"
    KELLER = "keller"


@dataclass(frozen=True, kw_only=True)
class SimulationOptions:
    """How a motion is followed, how often it is looked at, and when it is given up.

    tolerance: error allowed in a step, relative to the size of the system. method: "auto" (an explicit method of order
    8, an implicit one where the motion is stiff), one of `integrators()`, or "moreau": time stepping for many contacts
    and dry friction, of first order in the `step`, which does not locate events. step: of a method without error
    control [s]. every: distance of output times [s], a thousandth of the whole if nothing is said. max_step: no step is
    longer [s]. max_steps: the motion ends after so many steps, on every computer at the same place; max_seconds: after
    so long by the clock [s], compiling not counted. impact: the law of impact, "newton", "poisson" or "keller". jams:
    where no contact force is consistent (Painleve), go on with an impulse that ends the slip. verify: a second run, a
    hundred times as exact, tells from when on they part.

    Raises InputError for values without sense."""

    tolerance: float = 1e-9
    method: str = "auto"
    step: float | None = None
    every: float | None = None
    max_step: float | None = None
    max_seconds: float = math.inf
    max_steps: int = MOST_STEPS
    verify: bool = False
    impact: str = ImpactLaw.NEWTON.value
    jams: bool = False

    def __post_init__(self) -> None:
        if not 0.0 < self.tolerance <= COARSEST:
            raise _bad_tolerance(self.tolerance)
        if self.method not in methods():
            raise InputError(
                Message("there is no method {method}; take {methods}", method=self.method, methods=", ".join(methods()))
            )
        if self.by_steps and self.step is None:
            raise InputError(Message("time stepping needs a step, such as 1 ms: short beside the time between impacts"))
        if self.max_steps < 1:
            raise InputError(Message("max_steps must be at least 1, not {max_steps}", max_steps=self.max_steps))
        for name in ("step", "every", "max_step", "max_seconds"):
            value: float | None = getattr(self, name)
            if value is not None and not value > 0.0:
                raise InputError(Message("{name} must be positive, not {value:g} s", name=name, value=value))
        if self.step is not None and not has_step(self.method):
            raise InputError(
                Message(
                    "a step of {step:g} s is for the methods {names}; {method} chooses its steps by the tolerance",
                    step=self.step,
                    names=listed(list(filter(has_step, methods()))),
                    method=self.method,
                )
            )
        if self.impact not in [law.value for law in ImpactLaw]:
            raise InputError(
                Message(
                    "there is no law of impact {impact}; take {names}",
                    impact=self.impact,
                    names=", ".join(law.value for law in ImpactLaw),
                )
            )
        if self.by_steps and self.verify:
            raise InputError(Message("time stepping has no tolerance to verify; compare two steps"))

    def check_asked(self, until: float) -> None:
        """Raises InputError where a user may not ask for a motion to `until` [s]: it has no length or too many output
        times, or a tolerance at which nothing finer is left to compare with."""
        if self.tolerance < FINEST:
            raise _bad_tolerance(self.tolerance)
        if not (math.isfinite(until) and until > 0.0):
            raise InputError(Message("the motion must last for a positive time, not {until:g} s", until=until))
        if self.every is not None and until / self.every > MOST_OUTPUTS:
            raise InputError(
                Message(
                    "every {every:g} s up to {until:g} s is more than {most:,} output times",
                    every=self.every,
                    until=until,
                    most=MOST_OUTPUTS,
                )
            )

    @property
    def by_steps(self) -> bool:
        """Whether contacts are stepped over, not followed one by one."""
        return self.method == STEPPING

    @property
    def finer(self) -> SimulationOptions:
        """The same motion a hundred times as exact: by the tolerance, or by the step, with whose power the error of a
        method goes. It is not given up early."""
        step = None if self.step is None else self.step / 100.0 ** (1.0 / integrator(self.method).order)
        unlimited = replace(self, max_seconds=math.inf, max_steps=MOST_STEPS, verify=False)
        return replace(unlimited, tolerance=self.tolerance / 100.0, step=step)

    @property
    def law(self) -> ImpactLaw:
        return ImpactLaw(self.impact)

    @property
    def longest(self) -> float:
        """The longest step [s], infinite where nothing is said."""
        return self.max_step or math.inf


def _bad_tolerance(tolerance: float) -> InputError:
    return InputError(
        Message(
            "the tolerance must be between {finest:g} and {coarsest:g}, not {tolerance:g}",
            finest=FINEST,
            coarsest=COARSEST,
            tolerance=tolerance,
        )
    )
