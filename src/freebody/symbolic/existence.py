"""Where a closed form has a real, finite value: what stands below a bar, under a root, in an arc or a logarithm, at any
depth of it.

    p/q             q != 0
    sqrt(r)         r >= 0
    asin u, acos u  -1 <= u <= 1
    log u           u > 0
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from freebody.language.sentences import Message
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.ratio import Ratio

DIVISOR, ROOT, LOG = Message("divisor"), Message("under the root"), Message("logarithm of a positive number")
MODULUS = Message("the modulus of the elliptic integral is below one")
_ARC = Message("a sine or cosine of at most 1"), Message("a sine or cosine of at least -1")
FORMAL = (DIVISOR, ROOT, LOG, MODULUS, *_ARC)


def exists(elements: Iterable[Ratio]) -> list[Condition]:
    """The conditions under which all elements are real and finite; none that always hold. One that never holds is
    among them."""
    found: list[Condition] = []
    seen: set[int] = set()
    for x in elements:
        for element, relation, purpose in _needs(x, seen):
            condition, _possible = require(element, relation, purpose)
            if condition is not None:
                found.append(condition)
    return found


def _needs(x: Ratio, seen: set[int]) -> Iterator[tuple[Ratio, str, str]]:
    f = x.field
    if x.den is not None:
        yield x.denominator(), "!=", DIVISOR
    for g in sorted(x.generators() - seen):
        seen.add(g)
        kind = f.generators[g].kind
        if kind == "root":
            yield from _needs(f.radicand(g), seen)
            if g not in f.real_roots:
                yield f.radicand(g), ">=", ROOT
        elif kind in ("cos", "sin"):
            angle = f.angles.get(g if kind == "cos" else g - 1)
            if angle is not None:
                yield from _needs(angle, seen)
        elif g in f.known_pairs:
            shown = (f.arcs[g][1],) if g in f.arcs else ()
            for part in (*f.known_pairs[g], *shown):
                yield from _needs(part, seen)
        elif g in f.moduli:
            _phi, k = f.moduli[g]  # an amplitude is real wherever the motion gets
            yield from _needs(k, seen)
            yield 1 - k * k, ">", MODULUS
        elif g in f.arguments:
            name, u = f.arguments[g]
            yield from _needs(u, seen)  # Lambert's W is real wherever the motion gets, as its law says
            if name in ("asin", "acos"):
                yield 1 - u, ">=", _ARC[0]
                yield 1 + u, ">=", _ARC[1]
            elif name == "log":
                yield u, ">", LOG
