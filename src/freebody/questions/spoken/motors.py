"""The parameters of a motor by what they are called: its torque falls from the stall torque at rest to nothing at the
no-load speed."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from freebody.language.expression import Symbol, free_symbols, substitute
from freebody.language.units import ANGULAR_VELOCITY, TORQUE
from freebody.measures.geometry import ZERO
from freebody.model.elements import RATE

if TYPE_CHECKING:
    from freebody.model.names import Names

_NEAR = 1e-9  # of a torque to none
NO_LOAD, STALL = "no load", "stall"


def called(names: Names) -> Iterator[tuple[str, str]]:
    """Parameters and what they are called, where one motor alone has them."""
    laws = [load.law for load in names.applied_loads if "motor" in names.called.get(load.load, ())]
    laws = [law for law in laws if RATE.name in free_symbols(law)]
    for law in laws if len(laws) == 1 else ():
        for name in sorted(free_symbols(law) & names.parameters.keys()):
            dimension, value = names.parameters[name].dimension, names.numeric(Symbol(name))
            at_it, at_rest = (names.numeric(substitute(law, {RATE.name: rate})) for rate in (Symbol(name), ZERO))
            if dimension == ANGULAR_VELOCITY and at_it is not None and abs(at_it) <= _NEAR * abs(at_rest or 0.0):
                yield name, f"{NO_LOAD} speed"
            elif dimension == TORQUE and value is not None and value == at_rest:
                yield name, f"{STALL} torque"
