"""Symbols that a derivation introduces: names that are free, legends, and what is asked."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from freebody.language.expression import Symbol, rate_key
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.script import Legend, Script, Sentence
from freebody.narrative.questions.instant import asked_symbol, names_of
from freebody.questions.reading import Question


def fresh(context: Context, *names: str) -> str:
    """The first of some names that the model has not got for something else."""
    return context.symbol(*names).name


def named(context: Context, script: Script, *meanings: Meaning) -> None:
    """Introduces symbols in a legend; in another derivation they may mean something else."""
    for meaning in meanings:
        context.glossary.redefine(meaning)
    script.add(Legend(tuple((m.symbol, m.what, m.unit) for m in meanings)))


def asked_as(context: Context, question: Question, read: Callable[[World], float] | None = None) -> Symbol:
    """The symbol for what is asked, with a reader of its own where it is no property of an instant."""
    symbol = asked_symbol(context, question)
    if read is not None:
        context.glossary.redefine(replace(context.glossary.meanings[rate_key(symbol)], read=read))
    return symbol


def asked_entry(symbol: Symbol, question: Question, unit: str = "", n: int = 1) -> Legend:
    """The legend of what is asked, or of its n components."""
    names = (symbol,) if n == 1 else names_of(symbol, n)
    what = Sentence("symbol.asked", {"question": question.text})
    return Legend(tuple((name, what, unit) for name in names))


def component_names(name: str) -> tuple[Symbol, Symbol, Symbol]:
    """name_x, name_y, name_z"""
    x, y, z = (Symbol(f"{name}_{axis}") for axis in "xyz")
    return x, y, z
