"""Motions and answers found beforehand, for the sliders of a page that has nobody to ask: of all values of some names,
as a sweep varies them, and of the file's own."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import product
from math import prod
from typing import Any

import numpy as np

from freebody.errors import FreebodyError, InputError
from freebody.language.units import parse_quantity
from freebody.messages import Message
from freebody.numeric.jets import Array
from freebody.studio.moving import curves_of, followed, motion_of
from freebody.studio.reading import Places, document_of, parameters_of
from freebody.studio.telling import told
from freebody.studio.wire.around import Reply
from freebody.studio.wire.studies import Moved, ShareRequest, Slider, Valued
from freebody.study.given import ranges_of
from freebody.study.sweeps.answers import AnswerEvaluator
from freebody.study.sweeps.plan import plan
from freebody.study.sweeps.statuses import CODES, NOT_DONE, NUMBERS
from freebody.study.sweeps.varied import Varied, with_values
from freebody.system.system import System

_STEPS = 11  # of a range whose steps are not counted
_FRAMES = 121  # of a motion
_MOST = 600  # motions of a page
_NUMBER = re.compile(r"[-+]?[\d.]+(?:[eE][-+]?\d+)?")
_DIGITS = 5  # of an answer
_ROUND_OFF = 1e-12
_SAME = 1e-9  # relative: a value that is the file's own


def moved_beforehand(system: System, request: ShareRequest, own: dict[str, Any]) -> Moved:
    """own: the motion of the file's values. Raises InputError for ranges that cannot be read, or too many motions."""
    ranges = {name: _counted(text) for name, text in ranges_of(request.vary).items()}
    planned = plan(system, ranges, {}, None, 0)
    owns = [_own(planned.system, of) for of in planned.names]
    axes = [_with_own(planned.axes[of.name].tolist(), x) for of, x in zip(planned.names, owns, strict=True)]
    n = prod(map(len, axes))
    if n > _MOST:
        raise InputError(
            Message("{n} motions; a page has at most {most}: give fewer values, as L=0.5..2 m:5", n=n, most=_MOST)
        )
    few = request.model_copy(update={"frames": min(request.frames, _FRAMES)})
    cases = list(product(*axes))
    at = {of.parameter: np.array(column) for of, column in zip(planned.names, zip(*cases, strict=True), strict=True)}
    replies: list[Reply] = []
    curves: list[Reply] = []
    for values in cases:
        case = with_values(planned.system, {of.parameter: x for of, x in zip(planned.names, values, strict=True)})
        for found, each in zip((replies, curves), _replies(case, few, own), strict=True):
            found.append(each)
    written = {p.name: p.text for p in parameters_of(document_of(request.text), system, Places(request.text))}
    sliders = [
        Slider(name=of.name, values=_written(axis, _unit(written.get(of.name, ""), of)), own=axis.index(own_value))
        for of, axis, own_value in zip(planned.names, axes, owns, strict=True)
    ]
    answers = list(_answers(planned.system, at, request.language))
    return Moved(sliders=sliders, replies=replies, curves=curves, answers=answers)


def _answers(system: System, at: dict[str, Array], language: str) -> Iterator[Valued]:
    """To the questions of the file: by the formula where it is known to hold, else by the numeric route, else why there
    is none. at: (n,) the values of the parameters that vary"""
    for question in system.questions:
        evaluator = AnswerEvaluator(system, question)
        cases = [_answer(evaluator, at, i) for i in range(len(next(iter(at.values()))))]
        sizes = np.max([np.abs(found) for found in cases if not isinstance(found, str)] or [[0.0]], axis=0)
        units = [column.unit for column in evaluator.columns]
        values = [told(f, language) if isinstance(f, str) else _in_units(f, units, sizes) for f in cases]
        yield Valued(id=question.id, text=question.text, values=values)


def _answer(evaluator: AnswerEvaluator, at: dict[str, Array], i: int) -> tuple[float, ...] | str:
    """The numbers of one case, or why there are none."""
    one = {name: x[i : i + 1] for name, x in at.items()}
    numbers, codes = evaluator.together(one, 1)
    if codes[0] != CODES[NOT_DONE]:
        return tuple(numbers[0].tolist())
    found = evaluator.alone({name: float(x[0]) for name, x in one.items()})
    return found.numbers if found.status == NUMBERS else found.why


def _in_units(numbers: tuple[float, ...], units: list[str], sizes: Array) -> str:
    """In words. sizes: of the numbers of all cases, beside which round-off is nothing"""
    parts: list[str] = []
    for x, unit, size in zip(numbers, units, sizes, strict=True):
        number = f"{0.0 if abs(x) <= _ROUND_OFF * size else x:.{_DIGITS}g}"
        parts.append(f"{number} {'' if unit == '1' else unit}".strip())
    return "; ".join(parts)


def _counted(text: str) -> str:
    return f"{text}:{_STEPS}" if ".." in text and ":" not in text else text


def _own(system: System, of: Varied) -> float:
    value = system.parameters[of.parameter].value
    if value is None:
        raise InputError(Message("{name} has no value in the file, at which its slider could begin", name=of.name))
    return value


def _with_own(axis: list[float], own: float) -> list[float]:
    """The values in order, the file's own among them."""
    return sorted({own, *(x for x in axis if abs(x - own) > _SAME * max(abs(x), abs(own)))})


def _replies(case: System, request: ShareRequest, own: dict[str, Any]) -> tuple[Reply, Reply]:
    """The motion of a case, and its curves."""
    try:
        found = followed(case, request)
        answer = motion_of(found, request).model_dump(mode="json")
        curves = curves_of(found, request.language).model_dump(mode="json")
    except FreebodyError as error:
        refused = Reply(status="refused", message=told(str(error), request.language))
        return refused, refused
    player = {name: value for name, value in answer["player"].items() if value != own["player"].get(name)}
    return Reply(status="done", answer={**answer, "player": player}), Reply(status="done", answer=curves)


def _unit(written: str, of: Varied) -> str:
    """In which the file has a value, or in which it is calculated."""
    unit = _NUMBER.sub("", written, count=1).strip()
    return unit or ("" if of.unit == "1" else of.unit)


def _written(values: list[float], unit: str) -> list[str]:
    size = parse_quantity(f"1 {unit}".strip()).value
    return [f"{x / size:.6g} {unit}".strip() for x in values]
