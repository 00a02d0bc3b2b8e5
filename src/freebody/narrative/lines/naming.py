"""Symbols that a derivation introduces: names that are free, legends, and what is asked."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from functools import partial

from freebody.language.expression import Expr, Symbol, rate_key
from freebody.language.notation.parts import LETTER_OF, split_name
from freebody.language.sentences import Sentence
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import ASKED, Meaning, World
from freebody.narrative.lines.script import Legend, Script
from freebody.questions.reading import Question
from freebody.study.answering.numbers import integral_until, turns_until, work_until
from freebody.study.answering.passage import smooth_numbers
from freebody.study.mobility.centres import moving_for
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.system.symbols import reaction_symbols


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
    what = _words_of(question)
    return Legend(tuple((name, what, unit) for name in names))


def component_names(name: str) -> tuple[Symbol, Symbol, Symbol]:
    """name_x, name_y, name_z"""
    x, y, z = (Symbol(f"{name}_{axis}") for axis in "xyz")
    return x, y, z


def asked_name(context: Context, question: Question) -> str:
    """What is asked, as formulas name it: by the id of the question where that is a symbol, as v_f and T1 are; else by
    the letter of the quantity, with the id as its index where the letter alone would not do."""
    own, letter = question.id, question.quantity.letter
    if _is_symbol(own) and own not in context.system.bodies:  # v_piston, not piston, for a velocity
        return context.symbol(own, f"{own}_asked").name
    unnamed = re.fullmatch(r"q(\d+)", own)
    index = unnamed[1] if unnamed else own if own.isidentifier() else "asked"
    is_plain = _is_plain(question) and own not in context.system.bodies
    others = [q for q in context.system.questions if q.id != own and q.quantity.letter == letter]
    is_only = not any(_is_plain(q) for q in others) and all(q.id != letter for q in context.system.questions)
    wishes = [letter] if is_plain and is_only and _is_free(context, letter) else []
    return context.symbol(*wishes, f"{letter.partition('_')[0]}_{index}", f"{letter}_asked").name


def _is_plain(question: Question) -> bool:
    """Whether its id says no more than the letter of the quantity: time, for the time of an event."""
    return question.id in question.text.split() or re.fullmatch(r"q\d+", question.id) is not None


def _is_symbol(name: str) -> bool:
    """Whether it is a name as on paper: a Latin letter or a Greek one, with an index or none."""
    letters, _index = split_name(name)
    return name.isidentifier() and (len(letters) == 1 or letters in LETTER_OF) and not re.fullmatch(r"q\d+", name)


def _is_free(context: Context, name: str) -> bool:
    """Whether no line means something else by it."""
    meaning = context.glossary.meanings.get(name)
    return meaning is None or meaning.what.key == ASKED


def _words_of(question: Question) -> Sentence:
    """What a symbol for what is asked means: another thing in every question."""
    return Sentence(ASKED, {"id": question.id, "text": question.text})


def asked_symbol(context: Context, question: Question, n: int = 1) -> Symbol:
    """A symbol for what is asked, and one for each of n components."""
    own = asked_name(context, question)
    reactions = {r.name for r in reaction_symbols(context.system).values()}
    if n > 1 and any(name.name in reactions for name in names_of(Symbol(own), n)):
        own = f"{own}_asked"
    symbol = Symbol(own)
    what = _words_of(question)
    quantity, system = question.quantity, context.system

    def part(k: int) -> Callable[[World], float]:
        return lambda world: float(quantity.value(system, world.snapshot)[k])

    def counted(world: World) -> float:
        assert question.event is not None
        setup, end = context.setup, world.snapshot.t
        work = partial(work_until, setup, draw=world.draw, event=question.event, end=end)
        over_time = partial(integral_until, setup, draw=world.draw, event=question.event, end=end)
        turned = partial(turns_until, draw=world.draw, end=end)
        passage = smooth_numbers(setup, world.draw.start(), world.snapshot, work, over_time=over_time, turned=turned)
        return float(quantity.counted(passage))

    def of_pose(world: World) -> float:
        return float(quantity.value(system, moving_for(quantity, world.snapshot)))

    read = counted if quantity.scope == "course" else of_pose if quantity.is_of_pose_in_motion else quantity
    context.glossary.introduce(Meaning(symbol, what, read))
    for k, name in enumerate(names_of(symbol, n) if n > 1 else ()):
        context.glossary.introduce(Meaning(name, what, part(k)))
    return symbol


def written(parts: Sequence[Ratio]) -> Expr | tuple[Expr, ...]:
    """A scalar as it is written, or the components of a vector."""
    shown = tuple(map(tidy, parts))
    return shown[0] if len(shown) == 1 else shown


def own_symbols(parts: Sequence[Ratio], among: Collection[int]) -> Expr | tuple[Expr, ...] | None:
    """The symbols of what is asked, where each part is one of some unknowns, or None: A_x and A_y need no other
    name."""
    f = parts[0].field
    are_own = all(any((part - f.variable(u)).is_zero() for u in among) for part in parts)
    return written(parts) if are_own else None


def names_of(name: Symbol, n: int) -> tuple[Symbol, ...]:
    """The names of the components of a vector."""
    return tuple(Symbol(f"{name.name}_{axis}") for axis in "xyz"[:n])


def side_of(name: Symbol, n: int) -> Expr | tuple[Expr, ...]:
    """The name of a scalar, or of the components of a vector."""
    return name if n == 1 else names_of(name, n)
