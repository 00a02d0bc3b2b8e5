"""What a quantity is compared with: an expression, in which a number of hertz counts cycles.

An angular frequency of f = 2 Hz is omega = 2 pi f = 4 pi rad/s. The hertz is the unit of cycles in a second, and of an
angular frequency none. Source: BIPM, The International System of Units, 9th ed., table 4, note (d).
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from freebody.language.expression import Expr
from freebody.language.units import ANGULAR_VELOCITY, Dimension

if TYPE_CHECKING:
    from freebody.model.names import Names

_CYCLES = re.compile(r"\d[\d.]*(?:e-?\d+)? ?[kMm]?Hz")


def compared(names: Names, text: str, dimension: Dimension, *path: str | int) -> Expr:
    """The expression with which a quantity of a dimension is compared."""
    is_of_cycles = dimension == ANGULAR_VELOCITY and _CYCLES.fullmatch(text.strip()) is not None
    return names.formula(f"2*pi*({text})" if is_of_cycles else text, dimension, *path)
