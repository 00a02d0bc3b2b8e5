"""What a bare word of YAML means: nothing, true or false, a plain decimal number, else text.

The YAML 1.2 core schema, narrowed: `on`, `010`, `0x10`, `1_000`, `12:30` and dates are text.
Source: YAML 1.2.2, section 10.3.
"""

from __future__ import annotations

import math
import re

from freebody.language.document.tree import Scalar

_INTEGER = re.compile(r"[-+]?(0|[1-9][0-9]*)")
_DECIMAL = re.compile(r"[-+]?((0|[1-9][0-9]*)(\.[0-9]*)?|\.[0-9]+)([eE][-+]?[0-9]+)?")
_NOT_FINITE = re.compile(r"[-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)")
_WORDS: dict[str, bool | None] = {
    **dict.fromkeys(("", "~", "null", "Null", "NULL")),
    **dict.fromkeys(("true", "True", "TRUE"), True),
    **dict.fromkeys(("false", "False", "FALSE"), False),
}


def resolved(text: str) -> Scalar:
    """What a plain scalar means; a number too large for a float is infinite, for the caller to refuse."""
    if text in _WORDS:
        return _WORDS[text]
    if _DECIMAL.fullmatch(text):
        value = float(text)
        return int(text) if _INTEGER.fullmatch(text) and math.isfinite(value) else value
    if _NOT_FINITE.fullmatch(text):
        return math.nan if text[-1] in "nN" else math.inf
    return text
