"""The formulas within ready-made texts: a condition as it is compared, an expression or a relation in a message."""

from __future__ import annotations

from string import Formatter
from typing import cast

from freebody.language.expression import Expr
from freebody.language.notation import Stated
from freebody.language.raising import typeset_words
from freebody.messages import Message, Shown
from freebody.present.report.blocks import Formula, Piece, Relation, Text


def typeset(words: str) -> Text:
    """A text with its formulas as such, where it remembers them: 'needs μ ≥ tan(α)' with a formula behind a word; its
    numbers and units as they are printed."""
    found: list[Piece] = []
    for piece in _pieces(words):
        if isinstance(piece, str) and found and isinstance(found[-1], str):
            found[-1] += piece
        elif piece != "":
            found.append(piece)
    return tuple(typeset_words(piece) if isinstance(piece, str) else piece for piece in found)


def _pieces(words: str) -> Text:
    if isinstance(words, Stated):
        if words.sides is None:
            return _pieces(words.words) if words.words is not words else (str.__str__(words),)
        left, relation, right = words.sides
        return (Formula((left, right), (cast("Relation", relation),)),)
    if isinstance(words, Message):
        return tuple(piece for part in _filled(words) for piece in part)
    if isinstance(words, Shown) and isinstance(words.of, Expr):
        return (Formula((words.of,)),)
    return (str.__str__(words),)


def _filled(message: Message) -> list[Text]:
    """The parts of a message: its own words, and what was put between them."""
    parts: list[Text] = []
    for literal, name, spec, conversion in Formatter().parse(message.template):
        parts.append((literal,))
        if name is None:
            continue
        value = message.arguments[name]
        if isinstance(value, str) and not spec and not conversion:
            parts.append(_pieces(value))
        else:
            parts.append(
                (
                    f"{{{name}{f'!{conversion}' if conversion else ''}{f':{spec}' if spec else ''}}}".format(
                        **message.arguments
                    ),
                )
            )
    return parts
