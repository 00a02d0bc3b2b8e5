"""What is the size of something: a root whose square is taken apart more easily."""

from __future__ import annotations

from collections.abc import Sequence

from freebody.symbolic.field import Field
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.unknowns import Coordinate


def moves(g: int, coordinates: Sequence[Coordinate], f: Field) -> bool:
    """Whether a generator changes along some coordinates."""
    return any({c.index, c.speed} & f.generators[g].made_of for c in coordinates)


def is_size(model: SymbolicModel, x: Ratio, *along: Coordinate) -> bool:
    """Whether it is a root that changes along the coordinates, or a product of some, as |sin(phi)| |cos(phi)|, with a
    factor that is positive, or does not move and is so at all samples."""
    f = x.field
    roots = [g for g in x.generators() if f.generators[g].kind == "root" and moves(g, along, f)]
    if not roots or not x.denominator().generators().isdisjoint(roots):
        return False
    factor = x.numerator()
    for root in roots:
        (rest, *slopes) = factor.coefficients(root)
        if not rest.is_zero() or len(slopes) != 1:
            return False
        factor = slopes[0]
    factor = factor / x.denominator()
    own = {k for c in along for k in (c.index, c.speed)}
    is_still = not any(g in own or moves(g, along, f) for g in f.ingredients(factor))
    is_positive = sign_of(factor) in (Sign.POSITIVE, Sign.NONNEGATIVE)
    is_positive |= is_still and all(v > 0 for v in model.samples.at_starts(factor))
    return is_positive
