"""What the other studies say of a model, in a form in which two models can be compared: numbers with their dimension,
and words in which no name stands."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from freebody.api import System
from freebody.errors import FreebodyError
from freebody.language.units import DIMENSIONLESS, TIME, Dimension


@dataclass(frozen=True)
class Fact:
    """words and numbers stand in an order that no name decides."""

    words: tuple[str, ...] = ()
    numbers: tuple[float, ...] = ()
    dimension: Dimension = DIMENSIONLESS


def _modes(system: System) -> Fact:
    found = system.modes()
    rates = sorted((abs(mode.rate.imag), mode.rate.real) for mode in found.modes)
    return Fact(
        (found.stability, *sorted(m.kind for m in found.modes)),
        tuple(x for r in rates for x in r),
        DIMENSIONLESS / TIME,
    )


def _mobility(system: System) -> Fact:
    found = system.mobility()
    kinds = sorted(d.kind for d in found.dependences)
    return Fact((f"{found.degrees_of_freedom} degrees of freedom", f"singular: {found.is_singular}", *kinds))


def _conserved(system: System) -> Fact:
    listed = (v for v in system.conserved().quantities if not v.same_as)
    return Fact(tuple(sorted(f"{v.principle or 'quantity'}: {v.is_conserved}" for v in listed)))


def _explain(system: System) -> Fact:
    told = sorted((d.question.id, "refused" if d.reason else "derived") for d in system.explain().derivations)
    return Fact(tuple(f"{question} {word}" for question, word in told))


STUDIES: dict[str, Callable[[System], Fact]] = {
    "modes": _modes,
    "mobility": _mobility,
    "conserved": _conserved,
    "explain": _explain,
}
OF_THE_WHOLE = ("modes", "mobility", "conserved")  # another body changes them


def fact(study: str, system: System) -> Fact:
    """What a study says of a model, or that it is refused."""
    try:
        return STUDIES[study](system)
    except FreebodyError:
        return Fact(("refused",))
