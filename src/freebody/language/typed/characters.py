"""One way to write what keyboards and word processors write in several: signs, fractions, indices, dots over names."""

from __future__ import annotations

import re
import unicodedata

from freebody.language.plain_text import plain

_SAME = {
    **dict.fromkeys("−–—‐‑", "-"),
    **dict.fromkeys("·⋅×∙•∗✕", "*"),
    **dict.fromkeys("÷⁄∕", "/"),
    **dict.fromkeys("’′‘´`ʹ", "'"),
    **dict.fromkeys("\u00a0\u2002\u2003\u2009\u202f\u200a", " "),
    **dict.fromkeys("≤≦⩽", "<="),
    **dict.fromkeys("≥≧⩾", ">="),
    **dict.fromkeys("≅≃", "≈"),
    "″": "''",
    "º": "°",
    "∠": "",
    "\ufeff": "",
    "\u200b": "",
    "½": "(1/2)",
    "⅓": "(1/3)",
    "⅔": "(2/3)",
    "¼": "(1/4)",
    "¾": "(3/4)",
    "⅕": "(1/5)",
    "⅖": "(2/5)",
    "⅗": "(3/5)",
    "⅘": "(4/5)",
    "⅙": "(1/6)",
    "⅚": "(5/6)",
    "⅛": "(1/8)",
    "⅜": "(3/8)",
    "⅝": "(5/8)",
    "⅞": "(7/8)",
}
_LETTER_INDICES: dict[str, str] = dict(zip("ₐₑₒₓₕₖₗₘₙₚₛₜᵢⱼᵣᵤᵥ", "aeoxhklmnpstijruv", strict=True))
_INDEX_RUN = re.compile(f"[{''.join(_LETTER_INDICES)}]+")
_DOTS = {"\u0307": 1, "\u0308": 2, "\u20db": 3}
_OVER = "\u0300-\u036f\u20d0-\u20ff"  # marks above and below letters
_MARKED = re.compile(rf"([A-Za-z\u0370-\u03ff])([{_OVER}]+)((?:_\{{[^{{}}]*\}}|_[A-Za-z0-9]+|[0-9₀-₉]+)?)")


def normalized(text: str) -> str:
    """The text in the characters of the grammar. Dots above a letter become primes behind its index: ẋ₁ is x₁'."""
    text = plain(text)
    if text.isascii():
        return text.replace("`", "'").replace("´", "'")
    text = unicodedata.normalize("NFD", text)
    text = _MARKED.sub(_primes_last, text)
    text = "".join(_SAME.get(c, c) for c in text)
    return _INDEX_RUN.sub(lambda run: "_" + "".join(_LETTER_INDICES[c] for c in run.group()), text)


def _primes_last(found: re.Match[str]) -> str:
    letter, marks, index = found.groups()
    return letter + index + "'" * sum(_DOTS.get(mark, 0) for mark in marks)
