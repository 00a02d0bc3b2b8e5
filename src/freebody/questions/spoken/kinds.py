"""Whether an answer is of the kind that words ask for: a velocity is no angular velocity, an angle no length.

Each word for a quantity, and each question word that stands for one, says of which dimensions its value can be
(`measured` in the lexicon); what is understood has one of those that the main clause says. A word that says none (a
value, a limit) leaves it open. What is measured by an angle alone may be said to have a speed or a way: they are those
of the angle.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from freebody.language.expression import ZERO
from freebody.language.units import DIMENSIONLESS, ENERGY, FORCE, LENGTH, MASS, POWER, STIFFNESS, TIME, Dimension
from freebody.language.units.dimension import ACCELERATION, ANGULAR_MOMENTUM, MOMENTUM, TORQUE, VELOCITY
from freebody.questions.spoken import driving, lookup, of_axles
from freebody.questions.spoken.accounting import TURNED_ROUND
from freebody.questions.spoken.lexicon import Word, measured_in
from freebody.questions.spoken.sentence import parted

if TYPE_CHECKING:
    from freebody.model.names import Names
    from freebody.questions.base import Quantity

_RATE, _RATE_2 = DIMENSIONLESS / TIME, DIMENSIONLESS / TIME**2
_DIMENSIONS: dict[str, Dimension] = {
    "velocity": VELOCITY,
    "angular velocity": _RATE,
    "acceleration": ACCELERATION,
    "angular acceleration": _RATE_2,
    "length": LENGTH,
    "angle": DIMENSIONLESS,
    "time": TIME,
    "force": FORCE,
    "torque": TORQUE,
    "energy": ENERGY,
    "power": POWER,
    "momentum": MOMENTUM,
    "angular momentum": ANGULAR_MOMENTUM,
    "mass": MASS,
    "stiffness": STIFFNESS,
}  # by what the lexicon calls them
_VERDICTS = ("does ", "is ", "when ", "whether ")
# of what turns: the same of its angle
_OF_ANGLE = {VELOCITY: _RATE, ACCELERATION: _RATE_2, LENGTH: DIMENSIONLESS, FORCE: TORQUE, MOMENTUM: ANGULAR_MOMENTUM}


def _is_along_a_heavy_rod(names: Names, text: str) -> bool:
    """Whether the greatest force along a rod of some mass is told, which pulls or presses: its greatest tension is
    another one."""
    body = names.bodies.get(text.removeprefix("greatest axial force of "))
    return body is not None and body.mass != ZERO


def is_of_kind(names: Names, words: Sequence[Word], text: str, asked: Iterable[Quantity]) -> bool:
    """Whether each quantity that is understood has a dimension which the main clause of some words leaves open.

    text: what is understood, in words of the grammar."""
    turned = TURNED_ROUND.match(text)
    sentence = parted(list(words))
    main = list(words) if sentence is None else sentence.main.words
    said = [word for word in main if word.kind in ("quantity", "ask")]
    if _is_along_a_heavy_rod(names, text) and {Word("quantity", "tension"), Word("quantity", "compression")} & {*said}:
        return False
    is_named = turned is not None and Word("name", turned["parameter"]) in main  # other words say what it is for
    is_ratio = Word("verb", "compare") in main and text.startswith("ratio ")
    if is_named or is_ratio or Word("ask", "where") in main or text.startswith(_VERDICTS):
        return True
    if (named := _named_behind_ask(names, main)) is not None:  # at which y is it fastest: y is asked for
        return all(names.measures[named].dimension == quantity.dimension for quantity in asked)
    allowed: set[Dimension] = {dimension for word in said for dimension in _dimensions(word)}
    if turned and Word("quantity", "friction force") in said:  # the friction with which it holds
        allowed.add(DIMENSIONLESS)
    if Word("quantity", "compression") in said and "axial force of " in text:  # in a rod, which is none of its length
        allowed.add(FORCE)
    if turned and turned["parameter"] in driving.drive_parameters(names):  # the speed of what turns
        allowed |= {_OF_ANGLE[of] for of in allowed & _OF_ANGLE.keys()}
    if Word("verb", "accelerate") in main:  # at what rate it spins up
        allowed |= {ACCELERATION, _RATE_2}
    if any(_turns_about_centre(names, word) for word in main):
        allowed |= {_OF_ANGLE[of] for of in allowed & {VELOCITY, ACCELERATION}}
    if allowed and Word("ask", "when") in main:  # when has it half its final speed
        allowed.add(TIME)
    if not allowed or any(word.kind == "quantity" and not measured_in(word) for word in said):
        return True
    if _is_about_angles(names, words):
        allowed |= {_OF_ANGLE[of] for of in allowed & _OF_ANGLE.keys()}
    return all(quantity.scope == "every motion" or quantity.dimension in allowed for quantity in asked)


def _named_behind_ask(names: Names, main: Sequence[Word]) -> str | None:
    """The measure that is asked for by its name: at which y, for what theta."""
    said = [word for word in main if word.kind != "filler"]
    is_asked = len(said) > 1 and said[0].kind == "ask" and said[0].what in ("with", "for", "what")
    return said[1].what if is_asked and said[1].kind == "name" and said[1].what in names.measures else None


def _turns_about_centre(names: Names, word: Word) -> bool:
    """Whether a word names a body whose centre rests on its axle: it has no speed but that of turning."""
    is_body = word.kind == "name" and word.what in lookup.moving(names)
    return is_body and of_axles.axle_of(names, word.what) == "center"


def _dimensions(word: Word) -> tuple[Dimension, ...]:
    """What a quantity or a question word can be measured in; nothing where it leaves that open."""
    return tuple(_DIMENSIONS[dimension] for dimension in measured_in(word))


def _is_about_angles(names: Names, words: Sequence[Word]) -> bool:
    """Whether something is named that is an angle, or nothing but angles is measured."""
    angles = {name for name, measure in names.measures.items() if measure.dimension == DIMENSIONLESS}
    is_named = any(word.what in angles for word in words if word.kind == "name")
    return is_named or (bool(angles) and len(angles) == len(names.measures))
