"""The grammar of questions: what is asked, and when it is meant.

    QUANTITY [at start | when MEASURE = VALUE | at t = TIME | as t grows]
    time when MEASURE = VALUE

Quantities are the table `FORMS`; error messages and the documentation list it.
"""

from __future__ import annotations

import difflib
import re
from dataclasses import replace
from functools import partial

from freebody.language.sentences import Message
from freebody.model.elements import Parameter
from freebody.model.names import Names
from freebody.model.phrases import PHRASES, read_measure
from freebody.questions import turned_round
from freebody.questions.arithmetic import AtStart, is_vector, read_calculated
from freebody.questions.at_events import between_events, is_at_several, read_at_events
from freebody.questions.base import Path, Quantity
from freebody.questions.blow import BesideBlow, lost_where_it_strikes
from freebody.questions.clock import time_asked
from freebody.questions.course import Counted, When
from freebody.questions.event_base import QuestionEvent
from freebody.questions.forms import FORMS
from freebody.questions.half_swings import swings_as_rests
from freebody.questions.motion import OfMeasure
from freebody.questions.nth_impact import read_nth
from freebody.questions.operands import (
    TIME_ALONE,
    Operand,
    Operands,
    between_bars,
    event_at_end,
    extreme_until,
    is_between_bars,
    operands_of,
    ratio_as_quotient,
    without_bars,
    without_size,
    without_start,
)
from freebody.questions.reading_of_parameters import End, read_extremal, read_limit, read_turned_round
from freebody.questions.reading_when import Meant, as_timed, is_of_start, placed_at
from freebody.questions.rest import asks_for_rest
from freebody.questions.sudden import side_of_blow
from freebody.questions.turned_round import (
    EXTREME_FOR,
    LIMIT,
    OVER_PARAMETER,
    PARAMETER_FOR,
    PARAMETER_IS,
    REACHED,
    VALUE_FOR,
    RangeFor,
)
from freebody.questions.with_change import asks_for_change, read_change


def read_quantity(names: Names, text: str, path: Path) -> Quantity | None:
    if text in names.measures:
        return OfMeasure(names.measures[text], 0, text)
    rate = re.fullmatch(r"rate\((\w+)\)", text)
    if rate is not None and rate[1] in names.measures:
        return OfMeasure(names.measures[rate[1]], 1, rate[1])
    if text in names.states:
        state = names.states[text]
        return OfMeasure(state.integral, 1, state.carrier)
    if (text if rate is None else rate[1]) in names.broken:
        return None
    told_apart = next((form for form in FORMS if form.is_told_apart and form.found_in(text, names)), None)
    is_phrase = any(phrase.pattern.match(text) for phrase in PHRASES) and not text.startswith("angle of")
    if is_phrase and told_apart is None:
        measure = read_measure(names, text, *path)
        return None if measure is None else OfMeasure(measure, 0, text)
    if (of := without_size(text)) != text:
        with names.quietly():
            inner = read_quantity(names, of, path)
        if inner is not None and inner.scope == "instant":  # others have words of their own for it
            return _size(names, inner, of, path)
    for form in FORMS:
        found = form.found_in(text, names)
        if found is not None:
            return form.read(names, found, path)
    words = text.split(" of ", maxsplit=1)[0]
    openings = {opening: form.form for form in FORMS for opening in form.openings}
    close = difflib.get_close_matches(words, openings, n=1, cutoff=0.8)
    if close:
        told = Message("cannot read '{text}'. Did you mean: {form}", text=text, form=openings[close[0]])
        names.problem(told, *path)
    elif any(isinstance(p.message, Message) and "askable" in p.message.arguments for p in names.problems):
        names.problem(Message("cannot read '{text}'", text=text), *path)
    else:
        askable = "\n    ".join((*(f.form for f in FORMS), turned_round.FORM))
        names.unknown(
            text, Message("cannot read '{text}'. One can ask for\n    {askable}", text=text, askable=askable), *path
        )
    return None


def _size(names: Names, of: Quantity, text: str, path: Path) -> Quantity | None:
    """The size of a vector, or of what has a sign."""
    sized = of.sized(space=names.space)
    return sized if sized is not of else read_calculated(names, f"|{text}|", {1: of}, path, ("|", text, "|"))


def read_calculation(names: Names, text: str, path: Path) -> Quantity | None:
    """A quantity, or what is calculated from several at one instant."""
    operands = operands_of(names, text)
    if operands is None:
        return read_quantity(names, text, path)
    read: dict[int, Quantity] = {}
    for k, operand in operands.phrases.items():
        with names.one_number(wanted=not is_between_bars(operands, k)):
            quantity = read_quantity(names, operand.phrase, path)
        if quantity is None:
            return None
        read[k] = quantity
    return read_calculated(names, text, read, path, operands.runs)


def read_phrase(names: Names, phrase: str, when: object) -> Meant | None:
    """What a phrase asks for, if it says all of it: what is counted, until when."""
    meant = _asked(names, phrase, when)
    if meant is None or not isinstance(meant.quantity, Counted) or meant.event or meant.transition:
        return meant
    until = meant.quantity.until
    names.problem(Message("say until when: {phrase} until {until}", phrase=phrase, until=until), "find")
    return None


def _asked(names: Names, phrase: str, when: object) -> Meant | None:
    """What a phrase asks for. when: what the file says of it beside the phrase."""
    phrase = lost_where_it_strikes(names, swings_as_rests(names, phrase))
    if (nth := read_nth(names, phrase, lambda words: _asked(names, words, when))) is not None:
        return nth
    extreme = EXTREME_FOR.match(phrase)
    turned = extreme or VALUE_FOR.match(phrase) or _of_parameter(names, phrase)
    if turned is not None and not asks_for_rest(phrase):
        least = extreme is not None and extreme["least"] is not None
        end = "" if extreme is None else "least" if least else "largest"
        return read_turned_round(_asked, _reaching, names, turned["parameter"], turned["relation"], when, end)
    over = OVER_PARAMETER.match(phrase)
    if over is not None and over["parameter"] in names.parameters:
        with names.one_number():
            return read_extremal(_asked, names, names.parameters[over["parameter"]], over, when, asks_place=False)
    if asks_for_change(names, phrase):
        return read_change(_asked, names, phrase, when)
    phrase = _with_its_value(names, phrase)
    limit = LIMIT.match(phrase)
    if (
        limit is not None
        and limit["parameter"] in names.parameters
        and not phrase.lower().startswith(("does ", "which "))
    ):
        return read_limit(_asked, names, limit, when)
    if when is not None:
        path: Path = ("when",)
        phrase, condition = as_timed(phrase), as_timed(f" {when}").removeprefix(" when ").strip()
        phrase, at_start = without_start(phrase), False
        if condition in ("start", "at start"):
            condition, at_start = None, True
    else:
        path = ("find",)
        phrase = _of_whole(
            names, ratio_as_quotient(names, between_events(names, as_timed(phrase)), partial(_is_vector, names))
        )
        phrase, condition = event_at_end(names, phrase)
        at_start = condition is None and without_start(phrase) != phrase
        phrase = without_start(phrase)
    operands = operands_of(names, phrase)
    if operands is not None:
        return _calculated(names, phrase, operands, condition, at_start, path)
    return _meant(names, phrase, condition, at_start, path)


def _with_its_value(names: Names, phrase: str) -> str:
    """What has no instant of its own, as an amplitude or a natural frequency, when a parameter has a value: as that
    tends to it."""
    found = PARAMETER_IS.fullmatch(phrase)
    if found is None or found["parameter"] not in names.parameters or found["parameter"] in names.measures:
        return phrase
    with names.quietly(), names.one_number():
        quantity = read_quantity(names, found["of"], ("find",))
    if quantity is None or quantity.scope != "small motion" or quantity.is_verdict:
        return phrase
    return f"{found['of']} as {found['parameter']} -> {found['value']}"


def _is_vector(names: Names, phrase: str) -> bool:
    """Whether a phrase asks for something that has components."""
    with names.quietly(), names.one_number():
        quantity = read_quantity(names, phrase, ("find",))
    return quantity is not None and is_vector(quantity, space=names.space)


def _of_whole(names: Names, phrase: str) -> str:
    """An extreme until an event is one of all that is calculated where nothing in it is counted until then: `greatest
    A/B until E`, and not `greatest A` over the work until E."""
    whole, parts = extreme_until(names, phrase)
    with names.quietly():
        read = [read_quantity(names, part, ("find",)) for part in parts]
    return whole if all(q is not None and q.scope == "instant" for q in read) else phrase


def _of_parameter(names: Names, phrase: str) -> re.Match[str] | None:
    """`T for which ...`, `mu so that ...`: the value of a parameter."""
    found = PARAMETER_FOR.match(phrase)
    return found if found is not None and found["parameter"] in names.parameters else None


def _reaching(names: Names, parameter: Parameter, event: str, end: End) -> Meant | None:
    """The values of a parameter for which a measure reaches a value."""
    placed = placed_at(names, When(), event, False, ("find",))
    if placed is None or not isinstance(placed.event, QuestionEvent):
        return None
    unit = "rad" if parameter.is_angle else str(parameter.dimension)
    of = OfMeasure(placed.event.measure, placed.event.order, placed.event.text)
    quantity = RangeFor(
        parameter.name, of, placed.event.value, parameter.dimension, unit, event, relation=REACHED, end=end
    )
    return replace(placed, quantity=quantity)


def _calculated(
    names: Names, phrase: str, operands: Operands, condition: str | None, at_start: bool, path: Path
) -> Meant | None:
    """What is calculated from operands, which may say themselves when they are meant: all at one event, or each at its
    own, or at the start."""
    read: dict[int, Quantity] = {}
    as_said = operands
    for k, operand in operands.phrases.items():
        if TIME_ALONE.fullmatch(operand.phrase):
            break
        with names.one_number(wanted=not is_between_bars(operands, k)):
            quantity = read_quantity(names, operand.phrase, ("find",))
        if quantity is None:
            return None
        read[k] = between_bars(names, operands, k, quantity)
        if getattr(read[k], "size", False) is True:
            operands = without_bars(operands, k)
    if any(map(is_of_start, read.values())):
        return _with_blow(names, phrase, operands, read, condition, at_start)
    said = [o.condition for o in operands.phrases.values()]
    wholes = {k for k, q in read.items() if q.scope == "whole motion" and operands.phrases[k].condition is None}
    beside = len(wholes) < len(said) and any(one is not None for one in (*said, condition))  # (greatest y) - (x when E)
    if is_at_several(operands, condition) or (wholes and beside):
        at_end = Operand("", condition, at_start)
        return read_at_events(
            names, phrase, as_said, at_end, lambda o: _meant(names, o.phrase, o.condition, o.at_start, path), wholes
        )
    events = {o.condition for o in operands.phrases.values()} - {None}
    condition = next(iter(events), condition)
    if condition is None and any(q.scope == "whole motion" for q in read.values()):
        return _of_motion(names, phrase, operands, read, at_start)
    starts = [o.at_start for o in operands.phrases.values()]
    if condition is None and any(starts) and not (at_start or all(starts)):
        names.problem(Message("say of each quantity in '{text}' when it is meant", text=phrase), "find")
        return None
    for k, operand in operands.phrases.items():
        if condition is not None and (operand.at_start or (at_start and k == max(operands.phrases))):
            read[k] = AtStart(read[k])  # words at the very end belong to the last one where another has an event
    at_start = condition is None and (at_start or all(starts))
    if len(operands.runs) == 3 and 1 in read and getattr(read[1], "size", False) is True:
        return placed_at(names, read[1], condition, at_start, path)
    quantity = read_calculated(names, phrase, read, ("find",), operands.runs)
    if quantity is None:
        return None
    return placed_at(names, quantity, condition, at_start, path)


def _of_motion(
    names: Names, phrase: str, operands: Operands, read: dict[int, Quantity], at_start: bool
) -> Meant | None:
    """What is calculated with extremes of the motion; every other quantity is meant at the start."""
    last = max(operands.phrases)
    for k, operand in operands.phrases.items():
        starts = operand.at_start or (at_start and k == last)
        if starts == (read[k].scope == "whole motion"):
            told = Message("say of each quantity in '{text}' when it is meant", text=phrase)
            names.problem(told, "find")
            return None
        read[k] = AtStart(read[k]) if starts else read[k]
    quantity = read_calculated(names, phrase, read, ("find",), operands.runs)
    return None if quantity is None else Meant(quantity)


def _with_blow(
    names: Names, phrase: str, operands: Operands, read: dict[int, Quantity], condition: str | None, at_start: bool
) -> Meant | None:
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
    return None if quantity is None else Meant(quantity, at_start=True)


def _meant(names: Names, phrase: str, condition: str | None, at_start: bool, path: Path) -> Meant | None:
    """One quantity."""
    if phrase in ("time", "the time"):
        if condition is None:
            names.problem(Message("say of what: time when x = h"), "find")
            return None
        if time_asked(condition) is not None and "t" not in names.measures:
            names.problem(Message("the time of an instant by the clock is given; ask for another quantity then"), *path)
            return None
        return placed_at(names, When(), condition, at_start, path)
    # the event is read first: what is wrong with it is said first
    placed = placed_at(names, When(), condition, at_start, path)
    quantity = None if placed is None else read_quantity(names, phrase, ("find",))
    return None if quantity is None or placed is None else placed_at(names, quantity, condition, at_start, path)
