"""Measures: the phrases that state them, each with a model in which it is read."""

from __future__ import annotations

from collections.abc import Iterator

import freebody as fb
from freebody.model.phrases import PHRASES, MeasurePhrase
from reference.page import NothingSaid, Page, block, joined, prose, words_of

_HEAD = """A measure is a scalar that the configuration determines. Those under `measures` have names of their
own: they become the coordinates (first those with a start value), appear in answers, and may stand in loads,
drivers and events, with their rates `rate(x)`. The same phrases stand wherever a measure is asked for. Capitals
stand for names of the model, brackets for what may be left out.

An expression in other measures is a measure as well: `gap: {expression: x2 - x1}`."""


def pages() -> Iterator[Page]:
    text = joined(["# Measures", _HEAD, *map(_section, PHRASES)])
    yield Page("measures", "Measures", "lengths, angles and coordinates with a name", 40, text)


def _section(phrase: MeasurePhrase) -> str:
    if not phrase.example.strip():
        raise NothingSaid(f"the measure '{phrase.form}' has no example")
    system = fb.System.from_text(phrase.example)
    (measure,) = system.measures.values()
    unit = {"1": "rad for an angle, else a number"}.get(str(measure.dimension), str(measure.dimension))
    said = words_of(phrase.read, f"the measure '{phrase.form}'")
    return joined([f"## {prose(phrase.form)}", said, f"Unit: {unit}.", block("yaml", phrase.example)])
