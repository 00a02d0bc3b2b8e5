"""An option of a question as it is shown."""

from __future__ import annotations

from freebody.errors import CannotAnswer, ExpressionError, ModelError
from freebody.language.expression import Expr, Symbol
from freebody.language.parser import parse
from freebody.narrative.telling.catalogue import SYMBOL
from freebody.narrative.telling.dollars import with_rates
from freebody.present.report.blocks import Formula, Text


def shown(option: str, said: str) -> Text:
    """An option as a formula where it is one, else in the words of a language: what has a translation is no formula."""
    if said != option:
        return tuple(with_rates(said))
    text = option.strip()
    try:
        if text.startswith("[") and text.endswith("]"):
            parts: tuple[Expr, ...] = tuple(parse(part.strip()) for part in text[1:-1].split(","))
            return (Formula((parts,)),)
        if " " in text and not any(sign in text for sign in "+-*/^()="):
            return tuple(with_rates(text))
        found = parse(text)
        is_word = isinstance(found, Symbol) and not SYMBOL.fullmatch(found.name)  # always, never, infinity
        return (text,) if is_word else (Formula((found,)),)
    except (ExpressionError, CannotAnswer, ModelError):
        return tuple(with_rates(text))
