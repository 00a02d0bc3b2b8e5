"""Questions about rest under dry friction: whether it holds, up to which value of a parameter, and how it fails.

range of F that keeps it at rest        least mu | largest theta so that it stays at rest
does it tip or slide as F grows         does it hold        range of normal force of floor [at leg2]
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from freebody.language.units import DIMENSIONLESS, FORCE, LENGTH, TORQUE, Dimension
from freebody.model.elements import Held
from freebody.model.names import Names, did_you_mean

if TYPE_CHECKING:
    from freebody.model.question import Quantity

Path = tuple[str | int, ...]
Which = Literal["range", "least", "largest"]


@dataclass(frozen=True)
class RestLimit:
    """The values of a parameter with which the system stays at rest, or one end of them."""

    parameter: str
    which: Which
    dimension: Dimension


@dataclass(frozen=True)
class FirstFailure:
    """Which failure comes first as a parameter grows."""

    parameter: str
    dimension: Dimension


@dataclass(frozen=True)
class Holds:
    """Whether the system stays at rest."""

    dimension: Dimension = DIMENSIONLESS


@dataclass(frozen=True)
class ReactionRange:
    """Between which values a reaction lies that rest leaves open: that of the row that touches at the start, of several
    that could."""

    rows: tuple[str, ...]
    reaction: str
    dimension: Dimension


RestQuantity = RestLimit | FirstFailure | Holds | ReactionRange

# -- the grammar ------------------------------------------------------------------------------
Reader = Callable[[Names, dict[str, Any], Path], "Quantity | None"]
_NAME = r"[A-Za-z_]\w*"
_REST = (
    r"(?:(?:so )?that|for which|with which|such that)? ?(?:it|the system|everything|the [a-z]+)? ?"
    r"(?:(?:stays?|remains?|is|keeps?|can stay)(?: (?:it|the system))? (?:at rest|in equilibrium|in place)"
    r"|holds?|does not (?:slip|slide|tip|move|fall)|neither slips nor tips|(?:keeps|holds) (?:it|the system) at rest)"
)
_KIND = (
    r"(?:(?:coefficient of (?:static )?friction|friction coefficient|force|torque|mass|angle|value|distance) )?(?:of )?"
)
_WHICH: dict[str, Which] = {
    **dict.fromkeys(("least", "smallest", "minimum", "minimal", "lowest"), "least"),
    **dict.fromkeys(("largest", "greatest", "maximum", "maximal", "highest"), "largest"),
}


def _range(names: Names, found: dict[str, Any], path: Path) -> Quantity | None:
    return _limit(names, found["of"], "range", path)


def _end(names: Names, found: dict[str, Any], path: Path) -> Quantity | None:
    return _limit(names, found["of"], _WHICH[found["which"]], path)


def _limit(names: Names, name: str, which: Which, path: Path) -> RestLimit | None:
    dimension = _parameter(names, name, path)
    return None if dimension is None else RestLimit(name, which, dimension)


def _failure(names: Names, found: dict[str, Any], path: Path) -> Quantity | None:
    name = found["of"]
    if name is None:
        names.problem("say as what grows: does it tip or slide as F grows", None, *path)
        return None
    dimension = _parameter(names, name, path)
    return None if dimension is None else FirstFailure(name, dimension)


def _parameter(names: Names, name: str, path: Path) -> Dimension | None:
    parameter = names.parameters.get(name)
    if parameter is None:
        names.problem(f"there is no parameter {name}.{did_you_mean(name, names.parameters)}", None, *path)
        return None
    if parameter.form is not None:
        names.problem(f"{name} is a function of time; ask for a parameter", None, *path)
        return None
    return parameter.dimension


def _holds(names: Names, found: dict[str, Any], path: Path) -> Quantity | None:
    return Holds()


def _reaction_range(names: Names, found: dict[str, Any], path: Path) -> Quantity | None:
    of, what, at = found["of"], found["what"], found["at"]
    if of not in names.connections:
        names.problem(f"there is no connection {of}.{did_you_mean(of, names.connections)}", None, *path)
        return None
    rows = [row for row in names.held if row.connection == of]
    kinds = sorted({row.reaction for row in rows})
    if what not in kinds:
        names.problem(f"{of} has no {what}.{did_you_mean(what, kinds)}", None, *path)
        return None
    matching = [row for row in rows if row.reaction == what and (at is None or _is_at(_ends(row), at))]
    if not matching:
        known = [row for row in rows if row.reaction == what and row.ends]
        places = ", ".join(dict.fromkeys(_ends(row)[-1 if row.stretches else 0] for row in known))
        is_before = any(_is_at(stretch.places, at or "") for row in known for stretch in row.stretches)
        why = (
            f"the range of {what} before a drum is not looked for, only"
            if is_before
            else f"{of} has no {what} at {at}; there is one"
        )
        names.problem(f"{why} at {places}", None, *path)
        return None
    dimension = FORCE if matching[0].measure.dimension == LENGTH else TORQUE
    return ReactionRange(tuple(row.name for row in matching), what, dimension)


def _ends(row: Held) -> tuple[str, ...]:
    """The places of a row's own reaction: of a string with friction those behind the last drum."""
    return row.stretches[-1].places if row.stretches else row.ends


def _is_at(ends: tuple[str, ...], at: str) -> bool:
    """`leg2`, `table.leg2` or the name of a body."""
    return any(at == end or at == end.rpartition(".")[2] for end in ends)


FRICTION_FORMS: tuple[tuple[str, str, Reader], ...] = (
    (
        "range of PARAMETER that keeps it at rest",
        rf"(?:range|interval|values) of {_KIND}(?P<of>{_NAME})(?: {_REST})?",
        _range,
    ),
    (
        "least | largest PARAMETER so that it stays at rest",
        rf"(?P<which>{'|'.join(_WHICH)}) {_KIND}(?P<of>{_NAME}) {_REST}",
        _end,
    ),
    (
        "does it tip or slide as PARAMETER grows",
        rf"[Dd]oes (?:it|the {_NAME}) (?:first )?(?:tip|slide|slip)(?: first)?(?: or (?:tip|slide|slip))?(?: first)?"
        rf"(?: as (?:the )?(?:force |torque |angle )?(?P<of>{_NAME}) (?:grows|increases))?\??",
        _failure,
    ),
    (
        "does it hold",
        rf"(?:[Dd]oes (?:it|the {_NAME}) (?:hold|stay at rest|remain at rest)"
        rf"|[Ii]s (?:it|the {_NAME}) (?:at rest|in equilibrium))\??",
        _holds,
    ),
    (
        "range of normal force | friction force of CONNECTION [at PLACE]",
        rf"(?:range|interval|bounds) of (?:the )?(?P<what>[a-z]+ (?:force|torque)|tension|force|moment) (?:of|in|at) "
        rf"(?P<of>{_NAME})(?: (?:at|on) (?P<at>{_NAME}(?:\.\w+)?))?",
        _reaction_range,
    ),
)
