"""A worked solution as it stands under its exercise: without what the exercise has shown, numbered on from it."""

from __future__ import annotations

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


def lowered(blocks: tuple[Block, ...]) -> tuple[Block, ...]:
    """Sections one level below."""
    return tuple(replace(b, level=b.level + 1) if isinstance(b, Section) else b for b in blocks)


def without_statement(blocks: tuple[Block, ...]) -> tuple[Block, ...]:
    """A worked solution without what the exercise has shown already: words, picture and bodies."""
    kept = [block for block in blocks if not isinstance(block, Paragraph)]
    if kept and isinstance(kept[0], Section):
        said = tuple(b for b in kept[0].blocks if not isinstance(b, (Figure, Table)))
        kept[0] = replace(kept[0], blocks=said)
    return tuple(kept)


def renumbered(blocks: tuple[Block, ...], equations: int, figures: int) -> tuple[Block, ...]:
    """Blocks with all numbers of equations and figures moved on."""

    def moved(x: Any) -> Any:
        match x:
            case tuple():
                return tuple(map(moved, cast("tuple[Any, ...]", x)))
            case Reference(number, what):
                return Reference(number + (equations if what == "equation" else figures), what)
            case Equation():
                number = None if x.number is None else x.number + equations
                return replace(x, number=number, note=moved(x.note))
            case Figure():
                return replace(x, number=x.number + figures, caption=moved(x.caption))
            case Formula() | str():
                return x
            case _ if is_dataclass(x) and not isinstance(x, type):
                return replace(x, **{f.name: moved(getattr(x, f.name)) for f in fields(x)})
            case _:
                return x

    return cast("tuple[Block, ...]", moved(blocks))
