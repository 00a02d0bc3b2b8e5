"""Questions about motion that goes on evenly: steady motion, what a turn brings, and whether a disturbance grows.

rate of psi in steady motion                       extremes of QUANTITY [over a turn of ANGLE]
stability of the spin of BODY about x | y | z      stability of steady motion
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from freebody.language.units import DIMENSIONLESS, TIME, Dimension
from freebody.model.names import Names, did_you_mean

if TYPE_CHECKING:
    from freebody.model.question import Quantity

Path = tuple[str | int, ...]
Axis = Literal["x", "y", "z"]
PER_TIME_SQUARED = DIMENSIONLESS / TIME**2


@dataclass(frozen=True)
class SteadyValue:
    """A quantity while the system moves steadily."""

    of: Quantity

    @property
    def dimension(self) -> Dimension:
        return self.of.dimension


@dataclass(frozen=True)
class Extremes:
    """The least and the largest value of a quantity over a turn of an angle; None: of the one angle it depends on."""

    of: Quantity
    over: str | None

    @property
    def dimension(self) -> Dimension:
        return self.of.dimension


@dataclass(frozen=True)
class SpinStability:
    """Whether a small disturbance of a spin about an axis of a body grows: the square of its exponent."""

    body: str
    axis: Axis
    dimension: Dimension = PER_TIME_SQUARED


@dataclass(frozen=True)
class SteadyStability:
    """Whether a small disturbance of the steady motion at the start grows: the squares of its exponents."""

    dimension: Dimension = PER_TIME_SQUARED


SteadyQuantity = SteadyValue | Extremes | SpinStability | SteadyStability

# -- the grammar ------------------------------------------------------------------------------
Reader = Callable[[Names, dict[str, Any], Path], "Quantity | None"]
_NAME = r"[A-Za-z_]\w*"


def _inner(names: Names, text: str, path: Path) -> Quantity | None:
    """The quantity inside a question, if it is a property of one instant."""
    from freebody.model.question import Conserved, read_quantity

    of = read_quantity(names, text, path)
    if of is None or not isinstance(of, (Conserved, SteadyValue, Extremes, SpinStability, SteadyStability)):
        return of
    names.problem(f"'{text}' is no property of one instant; ask for a measure, a velocity or a force", None, *path)
    return None


def _steady(names: Names, found: dict[str, Any], path: Path) -> Quantity | None:
    of = _inner(names, found["of"], path)
    return None if of is None else SteadyValue(of)


def _extremes(names: Names, found: dict[str, Any], path: Path) -> Quantity | None:
    over = found["over"]
    if over is not None:
        measure = names.measures.get(over)
        if measure is None or measure.dimension != DIMENSIONLESS:
            angles = [name for name, m in names.measures.items() if m.dimension == DIMENSIONLESS]
            what = "is no angle" if measure is not None else "is no measure"
            names.problem(f"{over} {what} of the model.{did_you_mean(over, angles)}", None, *path)
            return None
    of = _inner(names, found["of"], path)
    return None if of is None else Extremes(of, over)


def _spin(names: Names, found: dict[str, Any], path: Path) -> Quantity | None:
    body = names.body(found["of"], *path)
    owner, _, axis = found["axis"].rpartition(".")
    if not names.space:
        names.problem("in the plane a body turns about one axis only: write space: true", None, *path)
        return None
    if owner not in ("", body.name):
        names.problem(f"the spin of {body.name} is about an axis of its own: x, y or z", None, *path)
        return None
    if not body.turns or body.fixed:
        names.problem(f"{body.name} does not spin: it is {'fixed' if body.fixed else 'a particle'}", None, *path)
        return None
    return SpinStability(body.name, axis)


def _stability(names: Names, found: dict[str, Any], path: Path) -> Quantity | None:
    return SteadyStability()


STEADY_FORMS: tuple[tuple[str, str, Reader], ...] = (
    (
        "stability of the spin of BODY about x | y | z",
        rf"stability of (?:the )?(?:spin|rotation) of (?:the )?(?P<of>{_NAME}) about (?:its )?"
        rf"(?P<axis>(?:{_NAME}\.)?[xyz])(?: axis)?",
        _spin,
    ),
    ("stability of steady motion", r"stability of (?:the )?steady motion", _stability),
    ("QUANTITY in steady motion", r"(?P<of>.+) in (?:the )?steady (?:motion|precession|turning)", _steady),
    (
        "extremes of QUANTITY [over a turn of ANGLE]",
        rf"(?:extremes|extreme values|least and largest value) of (?:the )?(?P<of>.+?)"
        rf"(?: over (?:a|one|a full) (?:turn|revolution) of (?:the )?(?P<over>{_NAME}))?",
        _extremes,
    ),
)
