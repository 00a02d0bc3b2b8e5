"""How formulas are compared in numbers: in Maxima, within the question, and the same in Python for our own reader.

STACK's AlgEquiv knows neither the range for which an exercise asks nor its mechanics: x1 and x2 of one string are two
names to it. At states of the model both are known, so a formula that agrees with another one at all of them to seven
digits is taken for the same. Measured in units that are 2, 3 and 5 times smaller (kg, m, s), a quantity of the
dimension kg^a m^b s^c is 2^a 3^b 5^c times larger; what is not has another dimension.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from freebody.errors import FreebodyError
from freebody.exercises.sampling import Sampling, State
from freebody.exercises.stack.maxima import MaximaNames
from freebody.language.expression import Expr, evaluate
from freebody.language.units import Dimension, parse_unit

SAME = 1e-7  # relative
NOTHING = 1e-12  # relative to the largest value
_LARGER = {"mass": 2, "length": 3, "time": 5}

# In Maxima. fbnum: a value, or false; fbseries: the values of all components at the states fbp, or their changes up to
# the states fbq; fbplain: what stands right of an = or is written as a tuple. Names that people type do not begin so.
_SOURCE = """
fbplain(fbe):=if safe_op(fbe)="=" then rhs(fbe) elseif safe_op(fbe)="ntuple" then args(fbe) else fbe;
fbnum(fbe,fbp):=block([fbv], fbv:errcatch(float(subst(fbp,fbe))), if fbv=[] then false else first(fbv));
fbminus(fba,fbb):=if numberp(fba) and numberp(fbb) then fba-fbb else false;
fbseries(fbe,fbp,fbq):=if listp(fbe) then apply(append,maplist(lambda([fbx],fbseries(fbx,fbp,fbq)),fbe))
    elseif fbq=[] then maplist(lambda([fbx],fbnum(fbe,fbx)),fbp)
    else makelist(fbminus(fbnum(fbe,fbq[fbi]),fbnum(fbe,fbp[fbi])),fbi,1,length(fbp));
fbknown(fbl):=is(sublist(fbl,lambda([fbx],not numberp(fbx)))=[]);
fbalike(fba,fbb):=fbknown(fba) and fbknown(fbb) and is(length(fba)=length(fbb));
fbnear(fba,fbb,fbs):=is(abs(fba-fbb)<=1.0e-7*max(abs(fba),abs(fbb))+1.0e-12*fbs);
fbclose(fba,fbb):=if not fbalike(fba,fbb) then false else block([fbs], fbs:lmax(maplist(abs,fbb)),
    is(sublist(makelist(fbnear(fba[fbi],fbb[fbi],fbs),fbi,1,length(fba)),lambda([fbx],not fbx))=[]));
fbsame(fba,fbb):=fbclose(fbseries(fba,fbpoints,fblater),fbseries(fbb,fbpoints,fblater));
fbdot(fbl,fbm):=sum(fbl[fbi]*fbm[fbi],fbi,1,length(fbm));
fbratio(fbl,fbm):=if not fbalike(fbl,fbm) then false elseif is(abs(fbdot(fbl,fbm))<=0) then false
    else fbclose(fbl,fbm*fbdot(fbl,fbm)/fbdot(fbm,fbm));
fbvalued(fbe):=fbknown(fbseries(fbe,fbpoints,fblater));
fbfactor(fba,fbb):=fbratio(fbseries(fba,fbpoints,fblater),fbseries(fbb,fbpoints,fblater));
fbscale(fbl,fbm):=if fbalike(fbl,fbm) then fbclose(fbl,fblarger*fbm) else true;
fbfirst(fbl):=if fbl=[] then [] else [first(fbl)];
fbunits(fbe):=fbscale(fbseries(fbe,fbscaled,fbscaledlater),fbseries(fbe,fbfirst(fbpoints),fbfirst(fblater)));
"""
PLAIN, *COMPARING = (" ".join(statement.split()) + ";" for statement in _SOURCE.split(";") if statement.strip())


@dataclass(frozen=True)
class Points:
    """States with values by our names; scaled: the first one in smaller units, None where the dimension cannot be told;
    larger: how much larger an answer of the right dimension is there."""

    states: tuple[State, ...]
    later: tuple[State, ...] = ()
    scaled: State | None = None
    scaled_later: State | None = None
    larger: Fraction = Fraction(1)

    def series(self, parts: Sequence[Expr]) -> tuple[float | None, ...]:
        """Of each component its values at the states, or its changes."""
        return tuple(x for part in parts for x in _changes(part, self.states, self.later))

    def same(self, a: Sequence[Expr], b: Sequence[Expr], sign: float = 1.0) -> bool:
        return close([None if x is None else sign * x for x in self.series(a)], self.series(b))

    def is_multiple(self, a: Sequence[Expr], b: Sequence[Expr]) -> bool:
        """Whether one is the other times a constant."""
        mine, its = self.series(a), self.series(b)
        if len(mine) != len(its) or None in mine or None in its:
            return False
        along, size = (sum(x * y for x, y in zip(c, its, strict=True) if x and y) for c in (mine, its))
        return bool(along) and close(mine, [None if x is None else x * along / size for x in its])

    def has_dimension(self, parts: Sequence[Expr]) -> bool:
        """Whether an answer has the right dimension; also where that cannot be told."""
        if self.scaled is None:
            return True
        later = () if self.scaled_later is None else (self.scaled_later,)
        there = tuple(x for part in parts for x in _changes(part, (self.scaled,), later))
        here = tuple(x for part in parts for x in _changes(part, self.states[:1], self.later[:1]))
        if None in there or None in here:
            return True
        return close(there, [None if x is None else float(self.larger) * x for x in here])

    def written(self, names: MaximaNames) -> Iterator[str]:
        """The variables of the functions, a line each."""
        yield f"fbpoints:[{','.join(_equations(s, names) for s in self.states)}];"
        yield f"fblater:[{','.join(_equations(s, names) for s in self.later)}];"
        if self.scaled is not None:
            yield f"fbscaled:[{_equations(self.scaled, names)}];"
            later = "" if self.scaled_later is None else _equations(self.scaled_later, names)
            yield f"fbscaledlater:[{later}];"
            yield f"fblarger:{self.larger};"


def points_of(sampling: Sampling, names: Iterable[str], key: Sequence[Expr], unit: str) -> Points:
    """names: those that have values. What the model does not know, and a wrong answer names, has some. unit: of the
    answer."""
    listed = list(names)
    states, later = (
        tuple({name: state.get(name, _unknown(k)) for k, name in enumerate(listed)} for state in some)
        for some in (sampling.states, sampling.later)
    )
    plain = Points(states, later)
    if not states:
        return plain
    try:
        factors = {name: _factor(parse_unit(u or "1").dimension) for name, u in sampling.units.items()}
        larger = _factor(parse_unit(unit or "1").dimension)
    except (FreebodyError, ValueError):
        return plain
    scaled = [
        {name: float(factors[name]) * x for name, x in some[0].items() if name in factors} if some else None
        for some in (states, later)
    ]
    full = Points(states, later, scaled[0], scaled[1], larger)
    return full if full.has_dimension(key) and None not in full.series(key) else plain


def _unknown(k: int) -> float:
    return 1.0 + 0.37 * (k % 7)


def close(a: Sequence[float | None], b: Sequence[float | None]) -> bool:
    """Whether values are known and the same."""
    if len(a) != len(b) or None in a or None in b:
        return False
    pairs = [(x, y) for x, y in zip(a, b, strict=True) if x is not None and y is not None]
    room = NOTHING * max((abs(y) for _, y in pairs), default=0.0)
    return all(abs(x - y) <= SAME * max(abs(x), abs(y)) + room for x, y in pairs)


def _changes(part: Expr, states: Sequence[State], later: Sequence[State]) -> Iterator[float | None]:
    for k, state in enumerate(states):
        value = _value(part, state)
        if later:
            after = _value(part, later[k])
            value = None if value is None or after is None else after - value
        yield value


def _value(part: Expr, state: Mapping[str, float]) -> float | None:
    try:
        found = float(evaluate(part, state))
    except (FreebodyError, ValueError, ArithmeticError, TypeError):
        return None
    return found if math.isfinite(found) else None


def _factor(dimension: Dimension) -> Fraction:
    """Raises ValueError for a dimension with a broken exponent."""
    found = Fraction(1)
    for base, factor in _LARGER.items():
        exponent: Fraction = getattr(dimension, base)
        if exponent.denominator != 1:
            raise ValueError(dimension)
        found *= Fraction(factor) ** int(exponent)
    return found


def _equations(state: State, names: MaximaNames) -> str:
    return "[" + ",".join(f"{names.maxima[name]}={value!r}" for name, value in state.items()) + "]"
