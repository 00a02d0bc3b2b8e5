"""Reading questions: what is asked, when it is meant, and the options to choose from.

    QUANTITY [at start | when MEASURE = VALUE | at t = TIME | as t grows]        time when MEASURE = VALUE

The grammar of quantities is the table `FORMS`; error messages and the documentation list it.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal, cast

from freebody.language.expression import ZERO, Expr
from freebody.language.plain_text import plain
from freebody.language.sentences import Message
from freebody.model.elements import Parameter
from freebody.model.names import Names, did_you_mean
from freebody.model.phrases import PHRASES, phrase_text, read_measure
from freebody.questions import turned_round
from freebody.questions.arithmetic import AtStart, read_calculated
from freebody.questions.base import FORMS, Path, Quantity
from freebody.questions.blow import BesideBlow
from freebody.questions.clock import by_the_clock, time_asked
from freebody.questions.course import Counted, Transition, When, as_condition, read_transition
from freebody.questions.event import AskedEvent, QuestionEvent, read_event
from freebody.questions.happening import Happening, read_happening
from freebody.questions.linkages import TURNS_FULLY, full_turn
from freebody.questions.motion import OfMeasure
from freebody.questions.operands import (
    Operands,
    event_at_end,
    has_quantities,
    operands_of,
    ratio_as_quotient,
    without_start,
)
from freebody.questions.rest import asks_for_rest
from freebody.questions.spoken.understanding import understood
from freebody.questions.sudden import by_blows, side_of_blow
from freebody.questions.turned_round import (
    EXTREME_FOR,
    INFINITE,
    IS_EXTREMAL,
    LIMIT,
    OVER_PARAMETER,
    REACHED,
    SO,
    VALUE_FOR,
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
    reached_in,
    relation_of,
    steadily,
    without_just,
)


@dataclass(frozen=True)
class Question:
    """A quantity that is asked for, when it is meant, and the options to choose from."""

    id: str
    text: str
    quantity: Quantity
    event: AskedEvent | None = None
    at_start: bool = False
    options: Mapping[str, str] = field(default_factory=dict[str, str])
    key: str | None = None
    transition: Transition | None = None  # instead of an event: a contact changes its state
    understood: str = ""  # the question in the words of the grammar
    words: str = ""  # in which a sheet asks it, where its author has written them
    points: float | None = None


# -- reading ----------------------------------------------------------------------------------
def read_quantity(names: Names, text: str, path: Path) -> Quantity | None:
    if text in names.measures:
        return OfMeasure(names.measures[text], 0, text)
    rate = re.fullmatch(r"rate\((\w+)\)", text)
    if (text if rate is None else rate[1]) in names.broken:
        return None
    if any(phrase.pattern.match(text) for phrase in PHRASES) and not text.startswith("angle of"):
        measure = read_measure(names, text, *path)
        return None if measure is None else OfMeasure(measure, 0, text)
    for form in FORMS:
        found = form.pattern.match(text)
        if found:
            return form.read(names, found.groupdict(), path)
    words = text.split(" of ", maxsplit=1)[0]
    openings = {w: f.form for f in FORMS for w in re.split(r"[|,;]", f.form.split(" of ")[0])}
    close = difflib.get_close_matches(words, [w.strip() for w in openings], n=1, cutoff=0.8)
    if rate is not None and rate[1] in names.measures:
        names.problem(
            Message("cannot read '{text}'. Did you mean: velocity of {measure}", text=text, measure=rate[1]), *path
        )
    elif close:
        form = next(f for w, f in openings.items() if w.strip() == close[0])
        names.problem(Message("cannot read '{text}'. Did you mean: {form}", text=text, form=form), *path)
    elif any(isinstance(p.message, Message) and "askable" in p.message.arguments for p in names.problems):
        names.problem(Message("cannot read '{text}'", text=text), *path)
    else:
        askable = "\n    ".join((*(f.form for f in FORMS), turned_round.FORM))
        names.unknown(
            text, Message("cannot read '{text}'. One can ask for\n    {askable}", text=text, askable=askable), *path
        )
    return None


def read_calculation(names: Names, text: str, path: Path) -> Quantity | None:
    """A quantity, or what is calculated from several at one instant."""
    operands = operands_of(names, text)
    if operands is None:
        return read_quantity(names, text, path)
    read: dict[int, Quantity] = {}
    for k, operand in operands.phrases.items():
        quantity = read_quantity(names, operand.phrase, path)
        if quantity is None:
            return None
        read[k] = quantity
    return read_calculated(names, text, read, path, operands.runs)


def read_questions(names: Names, given: Any) -> tuple[Question, ...]:
    """The questions of a model; a question is a text, or a mapping with find, id, when, options, key, and
    for exercise sheets text and points."""
    if given is None:
        return ()
    if isinstance(given, dict):
        pairs = list(cast("dict[str, Any]", given).items())
    elif isinstance(given, list):
        pairs = [(f"q{k}", v) for k, v in enumerate(cast("list[Any]", given), 1)]
    else:
        names.problem(Message("questions is a list, e.g. questions: [{{find: acceleration of x}}]"), "questions")
        return ()
    found: list[Question] = []
    for k, (name, value) in enumerate(pairs):
        place = name if isinstance(given, dict) else k
        with names.at("questions", place):
            question = _question(names, name, value)
        if question is not None:
            if any(other.id == question.id for other in found):
                names.problem(Message("two questions have the id {id}", id=question.id), "questions", place, "id")
            found.append(question)
    return tuple(found)


def _question(names: Names, name: str, value: Any) -> Question | None:
    known = ("find", "id", "when", "options", "key", "text", "points")
    phrased = phrase_text(value)
    entry: dict[str, Any] = {}
    if phrased is not None:
        entry = {"find": phrased}
    elif isinstance(value, dict):
        entry = cast("dict[str, Any]", value)
    if not isinstance(entry.get("find"), str):
        names.problem(Message("a question needs find, e.g. {{find: acceleration of x}}"))
        return None
    for key in entry:
        if key not in known:
            names.problem(Message("a question has no {key}.{hint}", key=key, hint=did_you_mean(key, known)), key)
    text = " ".join(str(entry["find"]).split())
    understood = _understood(names, text, entry.get("when"))
    if understood is None:
        return None
    found, canonical = understood
    quantity, event, at_start, transition = found.quantity, found.event, found.at_start, found.transition
    condition = event or transition
    if quantity.scope == "every motion" and (condition is not None or at_start):
        names.problem(Message("what is conserved is so at every instant; leave out 'at start' and 'when'"), "find")
        return None
    if isinstance(quantity, Counted) and condition is None:
        names.problem(Message("say until when: {phrase} until {until}", phrase=text, until=quantity.until), "find")
    options: Any = entry.get("options") or {}
    if isinstance(options, list):
        letters = "abcdefghijklmnopqrstuvwxyz"
        options = dict(zip(letters, cast("list[Any]", options), strict=False))
    if not isinstance(options, dict):
        names.problem(Message("options is a mapping, e.g. options: {{a: g/2, b: g}}"), "options")
        options = {}
    shown = {plain(str(k)): plain(_option_text(v)) for k, v in cast("dict[Any, Any]", options).items()}
    key = entry.get("key")
    if key is not None and str(key) not in shown:
        names.problem(Message("key {key} is not among the options {shown}", key=key, shown=", ".join(shown)), "key")
    return Question(
        plain(str(entry.get("id", name))),
        plain(text),
        quantity,
        event,
        at_start,
        shown,
        None if key is None else str(key),
        transition,
        plain(canonical),
        plain(" ".join(str(entry.get("text", "")).split())),
        _points(names, entry.get("points")),
    )


def _points(names: Names, given: object) -> float | None:
    """What an answer is worth."""
    if given is None:
        return None
    if isinstance(given, bool) or not isinstance(given, (int, float)) or given < 0:
        names.problem(Message("points is a number, e.g. points: 2, not {given}", given=str(given)), "points")
        return None
    return float(given)


def _understood(names: Names, text: str, when: object) -> tuple[_Asked, str] | None:
    """What a text asks for, and the words of the grammar in which it does."""
    found = understood(names, text, lambda words: _asked(names, as_condition(names, words.rstrip(" ?!")), when))
    return None if found is None else (found[0], as_condition(names, found[1]))


def _timed(phrase: str) -> str:
    """Words for instants of the clock and for the two sides of a blow as conditions."""
    return by_the_clock(by_blows(phrase))


@dataclass(frozen=True)
class _Asked:
    """A quantity, and when it is meant."""

    quantity: Quantity
    event: AskedEvent | None = None
    at_start: bool = False
    transition: Transition | None = None


def _asked(names: Names, phrase: str, when: object) -> _Asked | None:
    """What a phrase asks for. when: what the file says of it beside the phrase."""
    extreme = EXTREME_FOR.match(phrase)
    turned = extreme or VALUE_FOR.match(phrase)
    if turned is not None and not asks_for_rest(phrase):
        least = extreme is not None and extreme["least"] is not None
        end = "" if extreme is None else "least" if least else "largest"
        return _turned_round(names, turned["parameter"], turned["relation"], when, end)
    over = OVER_PARAMETER.match(phrase)
    if over is not None and over["parameter"] in names.parameters:
        return _extremal(names, names.parameters[over["parameter"]], over, when, asks_place=False)
    limit = LIMIT.match(phrase)
    if limit is not None and limit["parameter"] in names.parameters and not phrase.lower().startswith("does "):
        return _limit(names, limit, when)
    if when is not None:
        path: Path = ("when",)
        phrase, condition = _timed(phrase), _timed(f" {when}").removeprefix(" when ").strip()
        phrase, at_start = without_start(phrase), False
        if condition in ("start", "at start"):
            condition, at_start = None, True
    else:
        path = ("find",)
        phrase, condition = event_at_end(names, ratio_as_quotient(names, _timed(phrase)))
        at_start = condition is None and without_start(phrase) != phrase
        phrase = without_start(phrase)
    operands = operands_of(names, phrase)
    if operands is not None:
        return _calculated(names, phrase, operands, condition, at_start, path)
    return _meant(names, phrase, condition, at_start, path)


def _turned_round(
    names: Names, name: str, relation: str, when: object, end: Literal["", "least", "largest"]
) -> _Asked | None:
    """For which value of a parameter an equation holds, or for which values an inequality does. end: of these values
    the one that is asked for."""
    parameter = names.parameters.get(name)
    if parameter is None or parameter.form is not None:
        told = Message("{name} is no parameter.{hint}", name=name, hint=did_you_mean(name, names.parameters))
        names.unknown(name, told, "find")
        return None
    relation, is_just = without_just(_timed(steadily(relation)))
    extremal = IS_EXTREMAL.match(relation)
    if extremal is not None and not end:
        return _extremal(names, parameter, extremal, when, asks_place=True)
    inequality = inequality_of(relation)
    if inequality is not None:
        return _range(names, parameter, inequality, when, end)
    turns = re.fullmatch(TURNS_FULLY, relation)
    if turns is not None and when is None:
        return _turning(names, parameter, str(turns["of"]), relation, end)
    happening = read_happening(names, relation, ("find",)) if when is None else None
    if happening is not None:
        return _happening(parameter, happening, end)
    if (event := reached_in(relation)) is not None and when is None:
        return _reaching(names, parameter, event, end)
    if end or is_just:
        told = (
            Message("write an inequality: {end} {name} so that acceleration of x >= 0", end=end, name=name)
            if end
            else Message("say what is just so: value of {name} for which x just reaches d", name=name)
        )
        names.problem(told, "find")
        return None
    head, condition = (relation, None) if when is not None else event_at_end(names, relation)
    starts = condition is None and without_start(head) != head  # else these words belong to what is last
    found = relation_of(without_start(head) if starts else head, condition)
    if found is None:
        told = Message("write an equation: value of {name} for which acceleration of x = 0", name=name)
        names.problem(told, "find")
        return None
    left, right, condition = found
    timed = f" when {condition}" if condition is not None else " at start" if starts else ""
    asked = _asked(names, left + timed, when)
    if asked is None:
        return None
    target: Expr = ZERO
    if has_quantities(names, right):
        left = f"({left}) - ({right})"
        asked = _asked(names, left + timed, when)
        if asked is None:
            return None
    elif right != "zero":
        target = names.formula(right, asked.quantity.dimension, "find")
    kind = ValueForOnTheWay if asked.quantity.scope == "course" else ValueFor
    unit = "rad" if parameter.is_angle else str(parameter.dimension)
    return replace(asked, quantity=kind(name, asked.quantity, target, parameter.dimension, unit, left + timed))


def _range(
    names: Names,
    parameter: Parameter,
    inequality: tuple[str, str, str],
    when: object,
    end: Literal["", "least", "largest"],
) -> _Asked | None:
    """The values of a parameter for which an inequality holds."""
    left, sign, right = inequality
    right, condition = (right, None) if when is not None else event_at_end(names, right)
    starts = condition is None and without_start(right) != right
    timed = f" when {condition}" if condition is not None else " at start" if starts else ""
    right = without_start(right) if starts else right
    if has_quantities(names, right):
        left, right = f"({left}) - ({right})", "0"
    asked = _asked(names, left + timed, when)
    if asked is None:
        return None
    target = names.formula(right, asked.quantity.dimension, "find") if right not in ("0", "zero") else ZERO
    kind = RangeForOnTheWay if asked.quantity.scope == "course" else RangeFor
    unit = "rad" if parameter.is_angle else str(parameter.dimension)
    quantity = kind(
        parameter.name, asked.quantity, target, parameter.dimension, unit, left + timed, relation=sign, end=end
    )
    return replace(asked, quantity=quantity)


def _turning(
    names: Names, parameter: Parameter, link: str, text: str, end: Literal["", "least", "largest"]
) -> _Asked | None:
    """The values of a parameter for which a link turns fully."""
    of = full_turn(names, link, ("find",))
    unit = "rad" if parameter.is_angle else str(parameter.dimension)
    if of is None:
        return None
    return _Asked(RangeFor(parameter.name, of, ZERO, parameter.dimension, unit, text, relation=REACHED, end=end))


def _reaching(names: Names, parameter: Parameter, event: str, end: Literal["", "least", "largest"]) -> _Asked | None:
    """The values of a parameter for which a measure reaches a value."""
    placed = _placed(names, When(), event, False, ("find",))
    if placed is None or not isinstance(placed.event, QuestionEvent):
        return None
    unit = "rad" if parameter.is_angle else str(parameter.dimension)
    of = OfMeasure(placed.event.measure, placed.event.order, placed.event.text)
    quantity = RangeFor(
        parameter.name, of, placed.event.value, parameter.dimension, unit, event, relation=REACHED, end=end
    )
    return replace(placed, quantity=quantity)


def _extremal(
    names: Names, parameter: Parameter, found: re.Match[str], when: object, *, asks_place: bool
) -> _Asked | None:
    """The value of a parameter for which a quantity is largest or least, or the quantity there."""
    text = found["of"] + (found["timed"] or "")
    asked = _asked(names, text, when)
    if asked is None:
        return None
    of, end = asked.quantity, "largest" if found["largest"] else "least"
    kind = ExtremalForOnTheWay if of.scope == "course" else ExtremalFor
    unit = "rad" if parameter.is_angle else str(parameter.dimension)
    measured, shown = (parameter.dimension, unit) if asks_place else (of.dimension, of.unit)
    quantity = kind(parameter.name, of, ZERO, measured, shown, text, end=end, asks_place=asks_place)
    return replace(asked, quantity=quantity)


def _limit(names: Names, found: re.Match[str], when: object) -> _Asked | None:
    """A quantity as a parameter tends to a value."""
    parameter = names.parameters[found["parameter"]]
    if parameter.form is not None:
        names.problem(Message("{name} is no parameter.{hint}", name=parameter.name, hint=""), "find")
        return None
    value = "0" if found["small"] else (found["value"] or "").strip()
    grows = found["large"] is not None or value in INFINITE
    text = found["of"] + (found["timed"] or "")
    asked = _asked(names, text, when)
    if asked is None:
        return None
    target = ZERO if grows or value == "0" else names.formula(value, parameter.dimension, "find")
    of = asked.quantity
    kind = LimitOfOnTheWay if of.scope == "course" else LimitOf
    end = "grows" if grows else ""
    return replace(asked, quantity=kind(parameter.name, of, target, of.dimension, of.unit, text, end=end))


def _happening(parameter: Parameter, happening: Happening, end: Literal["", "least", "largest"]) -> _Asked:
    """The values of a parameter for which something is so of the motion."""
    unit = "rad" if parameter.is_angle else str(parameter.dimension)
    kinds = {"rest": RangeForAtRest, "small motion": RangeForSmallMotion}
    kind = kinds.get(happening.scope, RangeFor)
    return _Asked(
        kind(parameter.name, happening, ZERO, parameter.dimension, unit, happening.text, relation=SO, end=end)
    )


def _calculated(
    names: Names, phrase: str, operands: Operands, condition: str | None, at_start: bool, path: Path
) -> _Asked | None:
    """What is calculated from operands, which may say themselves when they are meant: all at one event, or at the
    start."""
    read: dict[int, Quantity] = {}
    for k, operand in operands.phrases.items():
        quantity = read_quantity(names, operand.phrase, ("find",))
        if quantity is None:
            return None
        read[k] = quantity
    if any(map(is_of_start, read.values())):
        return _with_blow(names, phrase, operands, read, condition, at_start)
    events = {o.condition for o in operands.phrases.values() if o.condition is not None}
    if condition is not None:
        events.add(condition)
    if len(events) > 1:
        told = Message("{events} are two events; ask for what belongs to each alone", events=", ".join(sorted(events)))
        names.problem(told, *path)
        return None
    condition = next(iter(events), None)
    starts = [o.at_start for o in operands.phrases.values()]
    if condition is None and any(starts) and not (at_start or all(starts)):
        names.problem(Message("say of each quantity in '{text}' when it is meant", text=phrase), "find")
        return None
    for k, operand in operands.phrases.items():
        if condition is not None and (operand.at_start or (at_start and k == max(operands.phrases))):
            read[k] = AtStart(read[k])  # words at the very end belong to the last one where another has an event
    at_start = condition is None and (at_start or all(starts))
    quantity = read_calculated(names, phrase, read, ("find",), operands.runs)
    if quantity is None:
        return None
    return _placed(names, quantity, condition, at_start, path)


def _with_blow(
    names: Names, phrase: str, operands: Operands, read: dict[int, Quantity], condition: str | None, at_start: bool
) -> _Asked | None:
    """What is calculated with impulses, or with the energy lost in a blow: of everything else it is said on which side
    of the blow it is meant, or that it is so at the start."""
    last, struck = max(operands.phrases), frozenset[str]().union(*(q.struck for q in read.values()))
    for k, operand in operands.phrases.items():
        own = condition if operand.condition is None and k == last else operand.condition
        starts = operand.at_start or (at_start and k == last)
        side = None if own is None else side_of_blow(own)
        if is_of_start(read[k]) and own is None:
            continue
        if side is not None and side[1] is not None and side[1] not in struck:
            told = Message("leave out of what the blow is: it is that of what is asked beside it")
            names.problem(told, "find")
            return None
        if is_of_start(read[k]) or (own is not None and side is None):
            names.problem(Message("impulses act in a blow; leave out 'when' and 'until'"), "find")
            return None
        if side is None and not starts:
            told = Message(
                "say when '{phrase}' is meant in '{text}': before the blow, after the blow, or at the start",
                phrase=operand.phrase,
                text=phrase,
            )
            names.problem(told, "find")
            return None
        read[k] = BesideBlow(read[k], "start" if side is None else "before" if side[0] == "before" else "after")
    quantity = read_calculated(names, phrase, read, ("find",), operands.runs)
    return None if quantity is None else _Asked(quantity, at_start=True)


def _meant(names: Names, phrase: str, condition: str | None, at_start: bool, path: Path) -> _Asked | None:
    """One quantity."""
    if phrase in ("time", "the time"):
        if condition is None:
            names.problem(Message("say of what: time when x = h"), "find")
            return None
        if time_asked(condition) is not None and "t" not in names.measures:
            names.problem(Message("the time of an instant by the clock is given; ask for another quantity then"), *path)
            return None
        return _placed(names, When(), condition, at_start, path)
    # the event is read first: what is wrong with it is said first
    placed = _placed(names, When(), condition, at_start, path)
    quantity = None if placed is None else read_quantity(names, phrase, ("find",))
    return None if quantity is None or placed is None else _placed(names, quantity, condition, at_start, path)


def _placed(names: Names, quantity: Quantity, condition: str | None, at_start: bool, path: Path) -> _Asked | None:
    """A quantity at the event that a condition states, or at the start."""
    of_start = is_of_start(quantity)
    if condition is None:
        return _Asked(quantity, at_start=at_start or of_start)
    if of_start:
        told = Message("impulses act in a blow; leave out 'when' and 'until'")
        names.problem(told, *path)
        return None
    transition = read_transition(names, condition, path)
    if transition is not None and transition.kind == "after" and _is_at_start(names, transition):
        return _Asked(quantity, at_start=True)
    event = None if transition is not None else read_event(names, condition, path)
    if event is None and transition is None:
        return None
    return _Asked(quantity, event, at_start, transition)


def _is_at_start(names: Names, transition: Transition) -> bool:
    """Whether the blow that is meant is that of the start."""
    struck = names.struck_at_start
    return bool(struck) and struck.issuperset(transition.of)


def is_of_start(quantity: Quantity) -> bool:
    """Whether a quantity, or one that it is made of, belongs to the blow at the start."""
    return quantity.is_of_start or any(map(is_of_start, quantity.inner))


def _option_text(value: Any) -> str:
    """An option as text; a vector may be written as a list."""
    if isinstance(value, list):
        return "[" + ", ".join(map(str, cast("list[Any]", value))) + "]"
    return str(value)
