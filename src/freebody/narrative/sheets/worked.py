"""A worked solution as it stands under its exercise: without what the exercise has shown, numbered on from it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass, replace
from typing import Any, cast

from freebody.present.report.blocks import (
    Block,
    Equation,
    Figure,
    Formula,
    Paragraph,
    Reference,
    Section,
    Table,
)


def as_solution(blocks: tuple[Block, ...], drawn: Sequence[int], *, equations: int, figures: int) -> tuple[Block, ...]:
    """A worked solution, one level below, without what the exercise has shown already: words, picture and bodies.

    drawn: the numbers of the exercise's own figures, to which it refers; equations, figures: how many there were."""
    shown = figure_numbers(_statement(blocks))
    others = [n for n in dict.fromkeys(figure_numbers(blocks)) if n not in shown]
    numbers = dict(zip(shown, drawn, strict=False)) | {n: figures + k for k, n in enumerate(others, 1)}
    return _lowered(_without_statement(_renumbered(blocks, equations, numbers)))


def figure_numbers(part: Any) -> list[int]:
    """Of all figures within, as they stand on the paper."""
    if isinstance(part, tuple):
        return [n for item in cast("tuple[Any, ...]", part) for n in figure_numbers(item)]
    if isinstance(part, Figure):
        return [part.number]
    if is_dataclass(part) and not isinstance(part, (type, Formula)):
        return [n for f in fields(part) for n in figure_numbers(getattr(part, f.name))]
    return []


def _lowered(blocks: tuple[Block, ...]) -> tuple[Block, ...]:
    """Sections one level below."""
    return tuple(replace(b, level=b.level + 1) if isinstance(b, Section) else b for b in blocks)


def _statement(blocks: tuple[Block, ...]) -> tuple[Block, ...]:
    """What the exercise shows as well."""
    kept = [block for block in blocks if not isinstance(block, Paragraph)]
    if not kept or not isinstance(kept[0], Section):
        return ()
    return tuple(b for b in kept[0].blocks if isinstance(b, (Figure, Table)))


def _without_statement(blocks: tuple[Block, ...]) -> tuple[Block, ...]:
    shown = _statement(blocks)
    kept = [block for block in blocks if not isinstance(block, Paragraph)]
    if kept and isinstance(kept[0], Section):
        kept[0] = replace(kept[0], blocks=tuple(b for b in kept[0].blocks if b not in shown))
    return tuple(kept)


def _renumbered(blocks: tuple[Block, ...], equations: int, figures: Mapping[int, int]) -> tuple[Block, ...]:
    """Blocks with the numbers of equations moved on, and other ones for their figures."""

    def moved(x: Any) -> Any:
        match x:
            case tuple():
                return tuple(map(moved, cast("tuple[Any, ...]", x)))
            case Reference(number, what):
                return Reference(number + equations if what == "equation" else figures.get(number, number), what)
            case Equation():
                number = None if x.number is None else x.number + equations
                return replace(x, number=number, note=moved(x.note))
            case Figure():
                return replace(x, number=figures.get(x.number, x.number), caption=moved(x.caption))
            case Formula() | str():
                return x
            case _ if is_dataclass(x) and not isinstance(x, type):
                return replace(x, **{f.name: moved(getattr(x, f.name)) for f in fields(x)})
            case _:
                return x

    return cast("tuple[Block, ...]", moved(blocks))
