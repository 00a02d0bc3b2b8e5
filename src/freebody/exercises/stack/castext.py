r"""Texts and blocks as CASText: HTML with LaTeX between \( \), in which STACK looks for {@...@}, {#...#} and [[...]].

None of these may come of a text or a formula: in words the signs stand by their numbers, in LaTeX they are kept apart.
What differs between the variants stands in [[if]] blocks, by the number of the variant.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from html import escape

from freebody.exercises.markup import Dialect, latex_dialect
from freebody.language.plain_text import plain
from freebody.present.report.blocks import Equation, Formula, Text

VARIANT = "fbn"  # the variable with the number of the variant

_SPECIAL = re.compile(r"[\\$@#{}\[\]]")
_MADE = re.compile(r"\{(?=[@#])|[@#](?=\})|\[(?=\[)|\](?=\])")
_GAP = re.compile(r"\\\\\[[0-9.]+pt\]")  # of rows: STACK would take the bracket for that of a displayed formula


def words(text: str) -> str:
    """Plain words, in which nothing is markup."""
    return _SPECIAL.sub(lambda sign: f"&#{ord(sign.group())};", escape(plain(text)))


_PLAIN = latex_dialect((r"\(", r"\)"), (r"\[", r"\]"), words)


def _formula(formula: Formula) -> str:
    return _apart(_PLAIN.formula(formula))


def _displayed(equations: Sequence[Equation], text: Callable[[Text], str]) -> str:
    return _apart(_PLAIN.displayed(equations, text))


def _apart(latex: str) -> str:
    return _MADE.sub(lambda sign: f"{sign.group()} ", _GAP.sub(r"\\\\ ", latex))


DIALECT = Dialect(_formula, _displayed, words)


def by_variant(written: Sequence[str]) -> str:
    """One text, or one for each variant where they differ."""
    if len(set(written)) <= 1:
        return written[0] if written else ""
    parts = "".join(
        f'[[{"if" if n == 1 else "elif"} test="is({VARIANT}={n})"]]{text}' for n, text in enumerate(written, 1)
    )
    return f"{parts}[[/if]]"


def string(text: str) -> str:
    """A string of Maxima."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'
