"""Questions about rest under dry friction: whether it holds, up to which value of a parameter, and how it fails.

range of F that keeps it at rest        least mu | largest theta so that it stays at rest
does it tip or slide as F grows         does it hold        range of normal force of floor [at leg2]
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from freebody.language.expression import free_symbols
from freebody.language.sentences import Message
from freebody.language.units import FORCE, LENGTH, TORQUE, Dimension
from freebody.measures.geometry import GROUND, ZERO
from freebody.model.elements import ConstraintRow, Parameter
from freebody.model.noting import did_you_mean
from freebody.questions.base import Path, Quantity, angular_unit
from freebody.questions.forms import NAME, Found, asked
from freebody.questions.reactions import has_connection

if TYPE_CHECKING:
    from freebody.model.names import Names

Which = Literal["range", "least", "largest"]
RANK = 88


class AtRest(Quantity):
    """What is asked of the start pose with all that touches held there."""

    scope = "rest"

    @property
    def is_of_whole(self) -> bool:
        return True


@dataclass(frozen=True)
class RestLimit(AtRest, kind="limit of rest"):
    """The values of a parameter with which the system stays at rest, or one end of them."""

    parameter: str
    which: Which
    of_parameter: Dimension
    is_angle: bool = False
    is_of_slip: bool = False  # that nothing slips is asked for, in words that hold of what moves as well
    without: tuple[str, ...] = ()  # loads that are left out

    example = """
parameters: {F: 20 N}
ground: {lines: {floor: {along: right}}}
bodies: {block: {rectangle: {mass: 20 kg, width: 0.6 m, height: 1 m}}}
connections: {touch: {contact: {between: [block, floor], friction: 0.35}}}
loads: {weight: {gravity: 9.81 m/s^2}, pull: {force: {at: block, along: right, magnitude: F}}}
questions: {it: range of F that keeps it at rest}
"""

    @property
    def dimension(self) -> Dimension:
        return self.of_parameter

    @property
    def unit(self) -> str:
        return angular_unit(self.dimension) if self.is_angle else str(self.dimension)

    @property
    def asks_no_slip(self) -> bool:
        return self.is_of_slip

    @property
    def loads_left_out(self) -> tuple[str, ...]:
        return self.without

    @property
    def ends(self) -> tuple[int, ...]:
        """Which ends of the values are asked for: -1 the least, 1 the largest."""
        return {"range": (-1, 1), "least": (-1,), "largest": (1,)}[self.which]


@dataclass(frozen=True)
class FirstFailure(AtRest, kind="first failure"):
    """Which failure comes first as a parameter grows."""

    parameter: str
    of_parameter: Dimension
    is_angle: bool = False

    example = """
parameters: {F: 20 N}
ground: {lines: {floor: {along: right}}}
bodies: {block: {rectangle: {mass: 20 kg, width: 0.6 m, height: 1 m}}}
connections: {touch: {contact: {between: [block, floor], friction: 0.35}}}
loads: {weight: {gravity: 9.81 m/s^2}, pull: {force: {at: block, along: right, magnitude: F}}}
questions: {it: does it tip or slide as F grows}
"""

    @property
    def dimension(self) -> Dimension:
        return self.of_parameter

    @property
    def unit(self) -> str:
        return angular_unit(self.dimension) if self.is_angle else str(self.dimension)


@dataclass(frozen=True)
class Holds(AtRest, kind="holds"):
    """Whether the system stays at rest."""

    without: tuple[str, ...] = ()

    example = """
parameters: {F: 20 N}
ground: {lines: {floor: {along: right}}}
bodies: {block: {rectangle: {mass: 20 kg, width: 0.6 m, height: 1 m}}}
connections: {touch: {contact: {between: [block, floor], friction: 0.35}}}
loads: {weight: {gravity: 9.81 m/s^2}, pull: {force: {at: block, along: right, magnitude: F}}}
questions: {it: does it hold}
"""
    is_verdict = True
    verdict = "rest.verdict"

    @property
    def loads_left_out(self) -> tuple[str, ...]:
        return self.without


@dataclass(frozen=True)
class ReactionRange(AtRest, kind="range of a reaction"):
    """Between which values a reaction lies that rest leaves open: that of the row that touches at the start, of several
    that could."""

    rows: tuple[str, ...]
    reaction: str
    transmits: Dimension

    example = """
ground: {lines: {floor: {along: right}, wall: {along: up, through: [0, 0]}}}
bodies: {ladder: {rod: {mass: 12 kg, length: 4 m}, angle: 65 deg}}
connections:
  floor: {contact: {between: [ladder, ground.floor], friction: 0.4}}
  wall: {contact: {between: [ladder, ground.wall], friction: 0.4}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: range of normal force of wall}
"""

    @property
    def dimension(self) -> Dimension:
        return self.transmits


# -- the grammar ------------------------------------------------------------------------------
_REST = (
    r"(?:(?:so )?that|for which|with which|such that|at which)? ?(?:it|the system|everything|the (?P<who>[a-z]+))? ?"
    r"(?:(?:stays?|remains?|is|keeps?|can stay)(?: (?:it|the system))? (?:at rest|in equilibrium|in place)"
    r"|holds?|does not (?:move|fall)|neither slips nor tips|(?:keeps|holds) (?:it|the system) at rest"
    r"|nothing moves|(?P<slips>does not (?:slip|slide)|nothing (?:slips|slides)))"
)
# what is to hold by itself, as a wedge that is not driven, is asked for without a load
_WITHOUT = rf"(?:,? without (?:the )?(?:force |torque |load |moment )?(?P<without>{NAME}))?"
_KIND = (
    r"(?:(?:coefficient of (?:static )?friction|friction coefficient|force|torque|mass|angle|value|distance) )?(?:of )?"
)
_WHICH: dict[str, Which] = {
    **dict.fromkeys(("least", "smallest", "minimum", "minimal", "lowest"), "least"),
    **dict.fromkeys(("largest", "greatest", "maximum", "maximal", "highest"), "largest"),
}


_RANGE = rf"(?:range|interval|values) of {_KIND}(?P<of>{NAME})"
_END = rf"(?P<which>{'|'.join(_WHICH)}) {_KIND}(?P<of>{NAME}) {_REST}"
_ENDED = _END.replace("(?P<of>", "(?:").replace("(?P<slips>", "(?:").replace("(?P<who>", "(?:")
_STAYS = re.compile(rf"^(?:the )?(?:{_RANGE} {_REST}|{_ENDED}){_WITHOUT}$")


def asks_for_rest(phrase: str) -> bool:
    """Whether it is rest for which values of a parameter are asked for."""
    return _STAYS.match(phrase) is not None


@asked(
    "range of PARAMETER that keeps it at rest",
    rf"{_RANGE}(?: {_REST})?{_WITHOUT}",
    rank=RANK,
)
def _range(names: Names, found: Found, path: Path) -> Quantity | None:
    return _limit(names, found, "range", path)


@asked(
    "least | largest PARAMETER so that it stays at rest",
    f"{_END}{_WITHOUT}",
    rank=RANK,
    example="""
parameters: {mu: 0.35}
ground: {lines: {slope: {along: 15 deg}}}
bodies: {block: {particle: {mass: 20 kg}}}
connections: {touch: {contact: {between: [block, slope], friction: mu}}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: least mu so that it stays at rest}
""",
)
def _end(names: Names, found: Found, path: Path) -> Quantity | None:
    return _limit(names, found, _WHICH[found["which"]], path)


def _is_all(names: Names, who: str | None, path: Path) -> bool:
    """Whether what is said to rest is all that moves; notes that it is not."""
    moving = [name for name, body in names.bodies.items() if name != GROUND and not body.fixed and body.mass != ZERO]
    if who in (None, "system") or len(moving) == 1:
        return True
    told = Message(
        "rest is asked of the whole system, and {who} is not all of it; ask for what slips, e.g. largest F so that "
        "CONNECTION does not slip",
        who=who,
    )
    names.problem(told, *path)
    return False


def _limit(names: Names, found: Found, which: Which, path: Path) -> RestLimit | None:
    if not _is_all(names, found["who"], path):
        return None
    name = found["of"]
    p, without = _parameter(names, name, path), _left_out(names, found["without"], path)
    if p is None or without is None:
        return None
    if without and name in _symbols_of(names, without):
        names.problem(Message("{name} is what {load} acts with, which is left out", name=name, load=without[0]), *path)
        return None
    return RestLimit(name, which, p.dimension, p.is_angle, found["slips"] is not None, without)


def _left_out(names: Names, name: str | None, path: Path) -> tuple[str, ...] | None:
    """The load of a name, or that which a parameter alone gives; None after noting that there is none."""
    if name is None:
        return ()
    found = loads_by(names, name)
    if len(found) != 1:
        hint = did_you_mean(name, names.loads)
        names.unknown(name, Message("{name} is no load that could be left out.{hint}", name=name, hint=hint), *path)
        return None
    return (found[0],)


def loads_by(names: Names, name: str) -> list[str]:
    """The load of a name, or those that vanish with a parameter."""
    return [name] if name in names.loads else [load for load in names.loads if name in _symbols_of(names, (load,))]


def _symbols_of(names: Names, loads: Sequence[str]) -> set[str]:
    """The forces and torques among the parameters with which loads act."""
    used = {x for push in names.applied_loads if push.load in loads for x in free_symbols(push.law)}
    return {x for x in used if (p := names.parameters.get(x)) is not None and p.dimension in (FORCE, TORQUE)}


@asked(
    "does it tip or slide | which wheel slips or lifts first as PARAMETER grows",
    rf"(?:[Dd]oes (?:it|the {NAME}) (?:(?P<only>(?:tip|fall) over|tip(?=\??$))"
    r"|(?!(?:slide|slip)\??$)(?:first )?(?:tip|slide|slip)(?: first)?"
    r"(?: or (?:tip|slide|slip))?(?: first)?)"
    r"|[Ww]hich (?:wheel|foot|contact|end)s? (?:first )?(?:slip|slide|spin|lift)s?(?: off)?"
    r"(?: or (?:slip|slide|spin|lift)s?(?: off)?)?(?: first)?)"
    rf"(?: as (?:the )?(?:force |torque |angle )?(?P<of>{NAME}) (?:grows|increases))?\??",
    rank=RANK,
)
def _failure(names: Names, found: Found, path: Path) -> Quantity | None:
    name = found["of"]
    if name is None and found["only"] is not None:
        if not any(row.unilateral for row in names.constraint_rows):
            names.problem(
                Message("nothing here stands on something, so that it could tip; ask for stability of steady motion"),
                *path,
            )
            return None
        return Holds()  # it says whether, and what happens else
    if name is None:
        names.problem(
            Message(
                "say as what grows: does it tip or slide as F grows; or ask whether anything moves at all: does it hold"
            ),
            *path,
        )
        return None
    p = _parameter(names, name, path)
    return None if p is None else FirstFailure(name, p.dimension, p.is_angle)


def _parameter(names: Names, name: str, path: Path) -> Parameter | None:
    parameter = names.parameters.get(name)
    if parameter is None:
        names.unknown(name, names.no_parameter(name), *path)
        return None
    if parameter.form is not None:
        names.problem(Message("{name} is a function of time; ask for a parameter", name=name), *path)
        return None
    return parameter


@asked(
    "does it hold",
    rf"(?:[Dd]oes (?:it|the (?P<who>{NAME})) (?:hold|stay at rest|remain at rest)"
    rf"|[Ii]s (?:it|the (?P<whose>{NAME})) (?:at rest|in equilibrium)){_WITHOUT}\??",
    rank=RANK,
)
def _holds(names: Names, found: Found, path: Path) -> Quantity | None:
    without = _left_out(names, found["without"], path)
    is_all = without is not None and _is_all(names, found["who"] or found["whose"], path)
    return Holds(without or ()) if is_all else None


@asked(
    "range of normal force | friction force of CONNECTION [at PLACE]",
    rf"(?:range|interval|bounds) of (?:the )?(?P<what>[a-z]+ (?:force|torque)|tension|force|moment) (?:of|in|at) "
    rf"(?P<of>{NAME})(?: (?:at|on) (?P<at>{NAME}(?:\.\w+)?))?",
    rank=RANK,
)
def _reaction_range(names: Names, found: Found, path: Path) -> Quantity | None:
    of, what, at = found["of"], found["what"], found["at"]
    if not has_connection(names, of, path):
        return None
    rows = [row for row in names.constraint_rows if row.connection == of]
    kinds = sorted({row.reaction for row in rows})
    if what not in kinds:
        names.problem(Message("{of} has no {what}.{hint}", of=of, what=what, hint=did_you_mean(what, kinds)), *path)
        return None
    matching = [row for row in rows if row.reaction == what and (at is None or _is_at(_ends(row), at))]
    if not matching:
        known = [row for row in rows if row.reaction == what and row.ends]
        places = ", ".join(dict.fromkeys(_ends(row)[-1 if row.stretches else 0] for row in known))
        is_before = any(_is_at(stretch.places, at or "") for row in known for stretch in row.stretches)
        told = Message(
            "the range of {what} before a drum is not looked for, only at {places}"
            if is_before
            else "{of} has no {what} at {at}; there is one at {places}",
            of=of,
            what=what,
            at=at,
            places=places,
        )
        names.problem(told, *path)
        return None
    dimension = FORCE if matching[0].measure.dimension == LENGTH else TORQUE
    return ReactionRange(tuple(row.name for row in matching), what, dimension)


def _ends(row: ConstraintRow) -> tuple[str, ...]:
    """The places of a row's own reaction: of a string with friction those behind the last drum."""
    return row.stretches[-1].places if row.stretches else row.ends


def _is_at(ends: tuple[str, ...], at: str) -> bool:
    """`leg2`, `table.leg2` or the name of a body."""
    return any(at == end or at == end.rpartition(".")[2] for end in ends)
