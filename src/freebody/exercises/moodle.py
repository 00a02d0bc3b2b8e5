r"""What both of Moodle's formats share: HTML in which its MathJax filter finds formulas between \( and \)."""

from __future__ import annotations

import re
from html import escape

from freebody.exercises.markup import latex_dialect
from freebody.language.plain_text import plain

_MARK = re.compile(r"\\(?=[()\[\]])|\$(?=\$)")


def words(text: str) -> str:
    r"""Plain words, in which no \( or $$ begins a formula: an empty element stands between the two signs."""
    return _MARK.sub(lambda found: f"{found[0]}<span></span>", escape(plain(text)))


DIALECT = latex_dialect((r"\(", r"\)"), (r"\[", r"\]"), words)
