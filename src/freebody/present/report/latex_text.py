r"""Words in LaTeX: what TeX would take for markup is escaped, and signs that pdflatex has no letter for are mapped.

In mathematics words are \text{...}; signs that differ between TeX, MathJax and KaTeX stand outside of it.
"""

from __future__ import annotations

import re
import unicodedata

from freebody.language.parser import GREEK
from freebody.language.plain_text import plain

_ESCAPED = {
    **{"\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}", "<": r"\textless{}"},
    **{">": r"\textgreater{}", "|": r"\textbar{}", '"': r"\textquotedbl{}", "'": r"\textquotesingle{}"},
    **{"`": r"\textasciigrave{}", "-": "{-}"},
    **{c: "\\" + c for c in "#$%&_{}"},
}
_MATH_SIGNS = {
    **{"↓": r"\downarrow", "↑": r"\uparrow", "→": r"\rightarrow", "←": r"\leftarrow", "↔": r"\leftrightarrow"},
    **{"↗": r"\nearrow", "↘": r"\searrow", "↙": r"\swarrow", "↖": r"\nwarrow", "⇒": r"\Rightarrow"},
    **{"⇔": r"\Leftrightarrow", "↶": r"\curvearrowleft", "↷": r"\curvearrowright", "↺": r"\circlearrowleft"},
    **{"↻": r"\circlearrowright", "⟲": r"\circlearrowleft", "⟳": r"\circlearrowright", "−": "-", "±": r"\pm"},
    **{"×": r"\times", "·": r"\cdot", "⋅": r"\cdot", "≥": r"\ge", "≤": r"\le", "≠": r"\ne", "≈": r"\approx"},
    **{"≡": r"\equiv", "∞": r"\infty", "√": r"\surd", "∂": r"\partial", "∑": r"\sum", "∫": r"\int", "∈": r"\in"},
    **{"⊥": r"\perp", "∥": r"\parallel", "∠": r"\angle", "∝": r"\propto", "△": r"\triangle", "⊗": r"\otimes"},
    **{"⊙": r"\odot", "∧": r"\wedge", "∨": r"\vee", "¬": r"\neg", "∀": r"\forall", "∃": r"\exists", "′": "'"},
    **{"✓": r"\checkmark", "✗": r"\times", "▸": r"\triangleright", "□": r"\square", "°": r"^{\circ}", "″": "''"},
}
# Letters that look like Latin ones have no command of their own.
_LATIN_LOOKING = "ΑΒΕΖΗΙΚΜΝΟΡΤΥΧο"
_GREEK_COMMANDS = {
    **{c: rf"\{'lambda' if name == 'lam' else name}" for c, name in GREEK.items() if c not in _LATIN_LOOKING},
    **{"ϑ": r"\vartheta", "ϕ": r"\phi", "ϵ": r"\epsilon", "ς": r"\varsigma", "\u00b5": r"\mu", "\u2126": r"\Omega"},
}
_TEXT_SIGNS = {
    **{"–": "--", "—": "---", "…": r"\ldots{}", "•": r"\textbullet{}", "€": r"\texteuro{}", "\u00a0": "~"},
    **{"„": r"\quotedblbase{}", "“": r"\textquotedblleft{}", "”": r"\textquotedblright{}", "‚": r"\quotesinglbase{}"},
    **{"‘": r"\textquoteleft{}", "’": r"\textquoteright{}", "«": r"\guillemotleft{}", "»": r"\guillemotright{}"},
    **{"\u2009": r"\,", "\u202f": r"\,", "\u2011": "-", "\u2010": "-", "\u200b": ""},
}
_RAISED: dict[str, str] = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+", strict=True))
_LOWERED: dict[str, str] = dict(zip("₀₁₂₃₄₅₆₇₈₉₋₊", "0123456789-+", strict=True))
_RUNS = re.compile("[⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺]+|[₀₁₂₃₄₅₆₇₈₉₋₊]+|.", re.DOTALL)
# What stands outside \text{...}, because it is markup there for one of those who read it.
_OUTSIDE = {
    **{"\\": r"\backslash ", "^": r"{\wedge}", "<": r"\lt ", ">": r"\gt ", "~": r"{\sim}", "|": r"\vert "},
    **{"*": r"{\ast}", "`": r"\text{‘}"},
    **{c: "\\" + c for c in "#$%&_{}"},
}
_T1 = re.compile("[ -~¡-ÿĀ-ſ]")


def latex_words(text: str) -> str:
    """Words as text of a LaTeX document."""
    return "".join(_sign(found[0]) for found in _RUNS.finditer(plain(text)))


def math_words(text: str) -> str:
    r"""Words as mathematics for pdflatex: \text{...}."""
    return rf"\text{{{latex_words(text)}}}" if text else ""


def web_words(text: str) -> str:
    r"""Words as mathematics for MathJax and KaTeX, which read Unicode and differ in what they escape."""
    found = re.split(r"([\\^<>~|*#$%&_{}`])", plain(text))
    signs = [_OUTSIDE[sign] for sign in found[1::2]]
    pairs = zip(found[::2], [*signs, ""], strict=True)
    return "".join((rf"\text{{{words}}}" if words else "") + sign for words, sign in pairs)


def _sign(sign: str) -> str:
    if sign in _ESCAPED:
        return _ESCAPED[sign]
    if sign[0] in _RAISED:
        return rf"\ensuremath{{^{{{''.join(_RAISED[c] for c in sign)}}}}}"
    if sign[0] in _LOWERED:
        return rf"\ensuremath{{_{{{''.join(_LOWERED[c] for c in sign)}}}}}"
    if sign in _TEXT_SIGNS:
        return _TEXT_SIGNS[sign]
    if sign in _MATH_SIGNS or sign in _GREEK_COMMANDS:
        return rf"\ensuremath{{{_MATH_SIGNS.get(sign) or _GREEK_COMMANDS[sign]}}}"
    if _T1.fullmatch(sign):
        return sign
    # A letter without accents, or its number, rather than a page that does not compile.
    simple = "".join(c for c in unicodedata.normalize("NFKD", sign) if _T1.fullmatch(c))
    return "".join(_ESCAPED.get(c, c) for c in simple) if simple else f"[U+{ord(sign):04X}]"
