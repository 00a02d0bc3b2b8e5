"""Units that are not in the table, asked of pint, to the precision of a float.

Importing pint takes 0.4 s, longer than most answers, so this module is imported when such a name is met.
"""

from __future__ import annotations

import math
from difflib import get_close_matches
from fractions import Fraction
from importlib import import_module
from typing import Any

from freebody.errors import UnitError
from freebody.language.sentences import Message
from freebody.language.units.dimension import Dimension
from freebody.language.units.table import UNITS, Unit

_registry: Any = None


def unit_of_pint(name: str) -> Unit:
    global _registry
    if name.lower() in ("nan", "inf", "infinity"):
        raise UnitError(Message("'{name}' is not a unit, and quantities must be finite", name=name))
    pint: Any = import_module("pint")
    if _registry is None:
        _registry = pint.UnitRegistry()
    try:
        quantity: Any = _registry.Quantity(1.0, _registry.Unit(name)).to_base_units()
    except pint.UndefinedUnitError:
        raise _unknown(name) from None
    except (pint.PintError, ValueError, TypeError, AttributeError, AssertionError) as error:
        raise UnitError(Message("the unit '{name}' cannot be used here", name=name)) from error
    exponents: dict[str, float] = dict(quantity.dimensionality)
    known = [Fraction(exponents.pop(f"[{base}]", 0)).limit_denominator(12) for base in ("mass", "length", "time")]
    if exponents:
        others = ", ".join(sorted(base.strip("[]") for base in exponents))
        raise UnitError(
            Message(
                "the unit '{name}' measures {others}; mechanics has only mass, length and time",
                name=name,
                others=others,
            )
        )
    factor = float(quantity.magnitude)
    if not (math.isfinite(factor) and factor > 0):
        raise UnitError(Message("the unit '{name}' cannot be used here", name=name))
    is_angle = "radian" in str(quantity.units) and known == [0, 0, 0]
    return Unit(Dimension(*known), Fraction(factor), is_angle=is_angle, is_exact=False)


def _unknown(name: str) -> UnitError:
    usual = [*UNITS, *(prefix + unit for prefix in ("k", "c", "m") for unit in ("g", "m", "s", "N"))]
    close = get_close_matches(name, usual, n=1) or get_close_matches(name.lower(), usual, n=1)
    guess = Message("; perhaps {x} is meant", x=close[0]) if close else ""
    return UnitError(Message("the unit '{name}' is not known{guess}", name=name[:40], guess=guess))
