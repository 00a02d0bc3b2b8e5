"""What is asked of a parameter: for which values of it something is so, where a quantity is largest, what it tends to.

value of P for which QUANTITY = VALUE     range of P for which QUANTITY > VALUE     QUANTITY as P grows
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from typing import Literal

from freebody.language.expression import ZERO, Expr
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.model.elements import Parameter
from freebody.model.names import Names
from freebody.questions.arithmetic import is_vector
from freebody.questions.compared import compared
from freebody.questions.event import read_event
from freebody.questions.forms import NAME
from freebody.questions.happening import ExistingSteadyMotion, Happening, StableSteadyMotion, read_happening
from freebody.questions.linkages import ASSEMBLES, TURNS_FULLY, Assembly, OfLinkage, full_turn
from freebody.questions.motion import OfMeasure, Staying
from freebody.questions.operands import event_at_end, has_quantities, without_start
from freebody.questions.reading_when import Meant, as_timed
from freebody.questions.turned_round import (
    INFINITE,
    IS_EXTREMAL,
    REACHED,
    REACHES_PLACE,
    SO,
    ExtremalFor,
    ExtremalForOnTheWay,
    LimitOf,
    LimitOfOnTheWay,
    RangeFor,
    RangeForAtRest,
    RangeForOnTheWay,
    RangeForSmallMotion,
    ValueFor,
    ValueForOnTheWay,
    inequality_of,
    locking,
    over_the_motion,
    reached_in,
    relation_of,
    staying,
    steadily,
    without_just,
)

End = Literal["", "least", "largest"]  # of the values of a parameter that which is asked for
Read = Callable[[Names, str, object], Meant | None]  # what a phrase asks for, with what the file says beside it
Reaching = Callable[[Names, Parameter, str, End], Meant | None]  # for which values a measure reaches a value


def read_turned_round(
    read: Read, reaching: Reaching, names: Names, name: str, relation: str, when: object, end: End
) -> Meant | None:
    """For which value of a parameter an equation holds, or for which values an inequality does. end: of these values
    the one that is asked for."""
    with names.one_number():
        return _turned_round(read, reaching, names, name, relation, when, end)


def _turned_round(
    read: Read, reaching: Reaching, names: Names, name: str, relation: str, when: object, end: End
) -> Meant | None:
    parameter = names.parameters.get(name)
    if parameter is None and name in names.measures and not end and when is None and inequality_of(relation) is None:
        return read(names, f"{name} when {relation}", None)  # of what moves it is the value at an event
    if parameter is None or parameter.form is not None:
        names.unknown(name, names.no_parameter(name), "find")
        return None
    # what is to be so: a quantity largest, an inequality, a full turn, something that happens, a place that is reached
    relation, is_just = without_just(as_timed(locking(names, steadily(relation))))
    relation = _as_force(names, relation)
    if when is None and event_at_end(names, relation)[1] is None and without_start(relation) == relation:
        relation = over_the_motion(relation)
    if when is None and (at := REACHES_PLACE.match(relation)) is not None and _moves(names, at["who"], at["what"]):
        relation = f"{at['what']} reaches {at['value']}"  # the sled reaches x = L
    extremal = IS_EXTREMAL.match(relation)
    if extremal is not None and not end:
        return read_extremal(read, names, parameter, extremal, when, asks_place=True)
    if (stays := staying(relation)) is not None and not end and when is None:
        return _staying(read, names, parameter, stays)
    inequality = inequality_of(relation)
    if inequality is not None:
        return _range(read, names, parameter, inequality, when, end)
    turns = re.fullmatch(TURNS_FULLY, relation)
    if turns is not None and when is None:
        return _turning(names, parameter, str(turns["of"]), relation, end)
    if re.fullmatch(ASSEMBLES, relation) and when is None:
        return _so(parameter, Assembly(), relation, end)
    happening = read_happening(names, relation, ("find",)) if when is None else None
    if happening is not None:
        return _happening(parameter, happening, end)
    head, condition = event_at_end(names, relation) if when is None else (relation, None)
    lasting = read_happening(names, head, ("find",)) if condition is not None else None
    if condition is not None and isinstance(lasting, ExistingSteadyMotion | StableSteadyMotion):
        return replace(_happening(parameter, lasting, end), event=read_event(names, condition, ("find",)))
    if (event := reached_in(relation)) is not None and when is None:
        return reaching(names, parameter, event, end)
    if end or is_just:
        told = (
            Message("write an inequality: {end} {name} so that acceleration of x >= 0", end=end, name=name)
            if end
            else Message("say what is just so: value of {name} for which x just reaches d", name=name)
        )
        names.problem(told, "find")
        return None
    # else an equation
    return _value(read, names, parameter, relation, when)


_PULLED = re.compile(
    rf"(?:the )?(?P<of>{NAME}) (?:always )?(?:stays|remains|keeps|is always) "
    r"(?:(?P<pulls>taut|tight|stretched|(?:in|under) tension)|(?:in|under) compression)"
)


def _as_force(names: Names, relation: str) -> str:
    """That a rod, which also pushes, stays in tension or in compression, as the sign of its force all the time; of a
    string it is that it stays taut."""
    found = _PULLED.fullmatch(relation)
    rows = [] if found is None else [r for r in names.constraint_rows if r.connection == found["of"]]
    if found is None or not any(row.reaction == "tension" for row in rows):
        return relation
    if found["pulls"] and any(row.unilateral for row in rows):
        return f"{found['of']} stays taut"
    if not any(row.is_driven for row in names.constraint_rows) and not any(
        body.mass != ZERO for body in names.bodies.values() if body.name != GROUND
    ):  # where nothing has mass the pose is all
        return f"tension of {found['of']} {'>=' if found['pulls'] else '<='} 0"
    return f"tension of {found['of']} stays {'above' if found['pulls'] else 'below'} 0"


def _moves(names: Names, who: str | None, measure: str) -> bool:
    """Whether a measure tells where a body is."""
    return measure in names.measures and (who is None or who in names.measures[measure].bodies())


_BESIDE = rf"(?:before|after) the (?:impact|blow)(?: of {NAME})?"
_IN_BARS = re.compile(rf"\|([^|]+)( {_BESIDE})\|")  # |x before the impact| is |x| before the impact
_BOTH_SIDES = re.compile(rf"(?P<left>[^=<>]+ {_BESIDE}\|?) = (?P<right>[^=<>]+ {_BESIDE}\|?)")


def _value(read: Read, names: Names, parameter: Parameter, relation: str, when: object) -> Meant | None:
    """The value of a parameter for which an equation holds."""
    name = parameter.name
    if (both := _BOTH_SIDES.fullmatch(relation)) is not None:  # each side at an instant of its own
        left, right = (_IN_BARS.sub(r"|\1|\2", both[side]) for side in ("left", "right"))
        relation = f"({left}) - ({right}) = 0"
    head, condition = (relation, None) if when is not None else event_at_end(names, relation)
    starts = condition is None and without_start(head) != head  # else these words belong to what is last
    found = relation_of(without_start(head) if starts else head, condition)
    if found is None:
        told = Message("write an equation: value of {name} for which acceleration of x = 0", name=name)
        names.problem(told, "find")
        return None
    # the left side is asked for when it is meant; what stands on the right is its value, or taken from it
    left, right, condition = found
    timed = f" when {condition}" if condition is not None else " at start" if starts else ""
    asked = read(names, left + timed, when)
    if asked is None:
        return None
    target: Expr = ZERO
    if has_quantities(names, right):
        left = f"({left}) - ({right})"
        asked = read(names, left + timed, when)
        if asked is None:
            return None
    elif right != "zero":
        target = compared(names, right, asked.quantity.dimension, "find")
    of = asked.quantity
    if of.scope == "instant":
        of = of.sized(space=names.space)  # a vector vanishes with its size, and is as large as it
    kind = ValueForOnTheWay if of.scope == "course" else ValueFor
    unit = "rad" if parameter.is_angle else str(parameter.dimension)
    return replace(asked, quantity=kind(name, of, target, parameter.dimension, unit, left + timed))


def _staying(read: Read, names: Names, parameter: Parameter, measure: str) -> Meant | None:
    """The value of a parameter for which a measure stays as it is at the start."""
    text = f"acceleration of {measure} at start"
    asked = read(names, text, None)
    if asked is None:
        return None
    of = asked.quantity
    if not isinstance(of, OfMeasure):
        names.problem(Message("{name} is no measure", name=measure), "find")
        return None
    unit = "rad" if parameter.is_angle else str(parameter.dimension)
    stays = Staying(of.measure, name=of.name)
    return replace(asked, quantity=ValueFor(parameter.name, stays, ZERO, parameter.dimension, unit, text))


def _range(
    read: Read,
    names: Names,
    parameter: Parameter,
    inequality: tuple[str, str, str],
    when: object,
    end: End,
) -> Meant | None:
    """The values of a parameter for which an inequality holds."""
    left, sign, right = inequality
    whole = right
    right, condition = (right, None) if when is not None else event_at_end(names, right)
    starts = condition is None and without_start(right) != right
    timed = f" when {condition}" if condition is not None else " at start" if starts else ""
    right = without_start(right) if starts else right
    if has_quantities(names, right):
        left, right = f"({left}) - ({right})", "0"
    asked = read(names, left + timed, when)
    if asked is not None and asked.quantity.scope == "instant" and whole.endswith(f" until {condition}"):
        left, timed = f"{'greatest' if sign in ('<', '<=') else 'least'} ({left})", f" until {condition}"
        asked = read(names, left + timed, when)  # what is so until an event is so all the way to it
    if asked is not None and is_vector(asked.quantity, space=names.space):  # less than a value is its size
        left = f"size of {left}"
        asked = replace(asked, quantity=asked.quantity.sized(space=names.space))
    if asked is None:
        return None
    target = compared(names, right, asked.quantity.dimension, "find") if right not in ("0", "zero") else ZERO
    kind = RangeForOnTheWay if asked.quantity.scope == "course" else RangeFor
    unit = "rad" if parameter.is_angle else str(parameter.dimension)
    quantity = kind(
        parameter.name, asked.quantity, target, parameter.dimension, unit, left + timed, relation=sign, end=end
    )
    return replace(asked, quantity=quantity)


def _turning(names: Names, parameter: Parameter, link: str, text: str, end: End) -> Meant | None:
    """The values of a parameter for which a link turns fully."""
    of = full_turn(names, link, ("find",))
    return None if of is None else _so(parameter, of, text, end)


def _so(parameter: Parameter, of: OfLinkage, text: str, end: End) -> Meant:
    """The values of a parameter for which something is so of a loop."""
    unit = "rad" if parameter.is_angle else str(parameter.dimension)
    return Meant(RangeFor(parameter.name, of, ZERO, parameter.dimension, unit, text, relation=REACHED, end=end))


def read_extremal(
    read: Read, names: Names, parameter: Parameter, found: re.Match[str], when: object, *, asks_place: bool
) -> Meant | None:
    """The value of a parameter for which a quantity is largest or least, or the quantity there."""
    text = found["of"] + (found["timed"] or "")
    asked = read(names, text, when)
    if asked is None:
        return None
    of, end = asked.quantity, "largest" if found["largest"] else "least"
    if is_vector(of, space=names.space):
        of = of.sized(space=names.space)  # of vectors the one of the largest size is the largest
    kind = ExtremalForOnTheWay if of.scope == "course" else ExtremalFor
    unit = "rad" if parameter.is_angle else str(parameter.dimension)
    measured, shown = (parameter.dimension, unit) if asks_place else (of.dimension, of.unit)
    quantity = kind(parameter.name, of, ZERO, measured, shown, text, end=end, asks_place=asks_place)
    return replace(asked, quantity=quantity)


def read_limit(read: Read, names: Names, found: re.Match[str], when: object) -> Meant | None:
    """A quantity as a parameter tends to a value."""
    parameter = names.parameters[found["parameter"]]
    if parameter.form is not None:
        names.problem(Message("{name} is no parameter.{hint}", name=parameter.name, hint=""), "find")
        return None
    value = "0" if found["small"] else (found["value"] or "").strip()
    grows = found["large"] is not None or value in INFINITE
    text = found["of"] + (found["timed"] or "")
    asked = read(names, text, when)
    if asked is None:
        return None
    target = ZERO if grows or value == "0" else names.formula(value, parameter.dimension, "find")
    of = asked.quantity
    kind = LimitOfOnTheWay if of.scope == "course" else LimitOf
    end = "grows" if grows else ""
    return replace(asked, quantity=kind(parameter.name, of, target, of.dimension, of.unit, text, end=end))


def _happening(parameter: Parameter, happening: Happening, end: End) -> Meant:
    """The values of a parameter for which something is so of the motion."""
    unit = "rad" if parameter.is_angle else str(parameter.dimension)
    kinds = {"rest": RangeForAtRest, "small motion": RangeForSmallMotion}
    kind = kinds.get(happening.scope, RangeFor)
    return Meant(kind(parameter.name, happening, ZERO, parameter.dimension, unit, happening.text, relation=SO, end=end))
