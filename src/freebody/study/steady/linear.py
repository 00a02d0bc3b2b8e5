"""The linearised equations about one steady motion, and which motion that is."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property

from freebody.errors import CannotAnswer
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.study.setup import Setup
from freebody.study.steady.motion import SteadyMotion, is_quarter
from freebody.symbolic.linear import RHS, Row, determinant, solve
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.symbolic.zeros import reals

_SMALL = 1e-6  # [SI] a rate at the start that is none


@dataclass
class Linear:
    """The linearised equations about one steady motion. `place`: what stays constant at a known value, by generator;
    `rates`: the cyclic rates that follow from the others, or are zero. What is in neither stays a symbol. `moved`: the
    coordinates that are not where the start has them, which is no steady motion."""

    steady: SteadyMotion
    place: dict[int, Ratio]
    rates: dict[int, Ratio] = field(default_factory=dict[int, Ratio])
    moved: frozenset[int] = frozenset()

    @property
    def exists(self) -> list[Ratio]:
        """What is not negative where there is this motion: what stands under the roots of its place and in its arcs."""
        values = (*(self.place[index] for index in sorted(self.moved)), *self.rates.values())
        return [x for value in values for x in reals(value)]

    def here(self, x: Ratio) -> Ratio:
        """In the steady motion."""
        f = self.steady.model.field
        x = f.follow(x, self.place | self.steady.still)
        return f.lowest_terms(f.follow(x, self.rates))

    @cached_property
    def matrix(self) -> list[list[Ratio]]:
        """M s^2 - F_u s - F_x, in the parameter s; of a cyclic coordinate the column of its rate."""
        m, f, s = self.steady.model, self.steady.model.field, self.exponent
        rows: list[list[Ratio]] = []
        for k, force in enumerate(self.steady.forces):
            row: list[Ratio] = []
            for j, c in enumerate(m.coordinates):
                entry = self.here(m.dynamics.mass_matrix[k][j]) * s - self.here(f.partial(force, c.speed))
                if c in self.steady.others:
                    entry = entry * s - self.here(f.derivative(force, c.index))
                row.append(entry)
            rows.append(row)
        return rows

    @cached_property
    def characteristic(self) -> Ratio:
        """The determinant of the matrix."""
        found = determinant(self.matrix)
        if found.is_zero():
            raise CannotAnswer(Message("the coordinates are singular at the start; describe the body by other angles"))
        return found

    @property
    def exponent(self) -> Ratio:
        return self.steady.model.field.parameter("@s")

    @property
    def coefficients(self) -> list[Ratio]:
        """Of the characteristic polynomial, from the constant term up."""
        f = self.steady.model.field
        return self.characteristic.numerator().coefficients(f.index(self.exponent))

    @cached_property
    def factors(self) -> list[list[Ratio]]:
        """Coefficients of the factors that have other roots than zero."""
        s = self.steady.model.field.index(self.exponent)
        return [base.coefficients(s) for base in self.bases]

    @cached_property
    def bases(self) -> list[Ratio]:
        """Those factors."""
        f, s = self.steady.model.field, self.steady.model.field.index(self.exponent)
        found = [base for base, _exponent in f.factor(self.characteristic.num)[1] if s in base.generators()]
        return [base for base in found if base != self.exponent]

    def moves(self, k: int, base: Ratio) -> bool:
        """Whether the coordinate with a number takes part in the disturbances whose exponents are roots of a factor:
        the cofactors of its column, which are what it has of them, do not all have that factor."""
        f, n = self.steady.model.field, len(self.matrix)
        for left_out in range(n):
            minor = [[x for j, x in enumerate(row) if j != k] for i, row in enumerate(self.matrix) if i != left_out]
            cofactor = f.one if n == 1 else f.lowest_terms(determinant(minor))
            if not cofactor.is_zero() and all(base != own for own, _n in f.factor(cofactor.num)[1]):
                return True
        return False

    @property
    def n_zero(self) -> int:
        """Roots that are zero, beside those of neighbouring steady motions."""
        factors = self.steady.model.field.factor(self.characteristic.num)[1]
        return sum(n for base, n in factors if base == self.exponent) - len(self.steady.cyclic)


def linear_at_start(setup: Setup, steady: SteadyMotion) -> Linear:
    """The steady motion of the start, as general as possible: in any pose with any rates; in the pose of the start;
    with one rate such that it is steady; at the place nearest to it at which it is steady with its rates; as it is;
    where something is given, with a rate that the start has at zero. Else what is zero, or a quarter of a turn, stays
    so, and so does what is given (`SteadyMotion.asked`)."""
    model, start, given = setup.model, setup.start, steady.given
    bound = [d.name for d in model.dependent if d.index in steady.needed]
    if bound:
        raise CannotAnswer(
            Message(
                "{names} follow only through a closed loop; the equations have no closed linear form",
                names=", ".join(bound),
            )
        )
    if not steady.others and not any(steady.feels(c) for c in steady.cyclic):
        raise CannotAnswer(
            Message("all coordinates are cyclic: every disturbance leads to a neighbouring steady motion")
        )
    _check_rest(setup, steady)
    pose = {c.index: given.get(c.index, start.of(c.index)) for c in steady.others}
    places = [{index: x for index, x in pose.items() if is_quarter(x) or index in given}, pose]
    rates = {c.speed: x for c in steady.cyclic if (x := given.get(c.speed, start.of(c.speed))).is_zero()}
    rates |= {c.speed: given[c.speed] for c in steady.cyclic if c.speed in given}
    put = frozenset(c.index for c in steady.others if c.index in given)
    for place in places:
        if not _unbalanced(Linear(steady, place, rates)):
            return Linear(steady, place, rates, put)
    for place in places:
        for c in steady.cyclic:
            solved = _solved_for(Linear(steady, place, rates, put), c.speed)
            if solved is not None:
                return solved
        solved = _solved_together(Linear(steady, place, {c: x for c, x in rates.items() if c in given}, put))
        if solved is not None:
            return solved
    for place in places:
        moved = _moved(Linear(steady, place, rates, put))
        if moved is not None:
            return moved
    fixed = {index: x for index, x in pose.items() if index in given}
    settled = _solved_together(Linear(steady, fixed, {c: x for c, x in rates.items() if c in given}, put))
    if settled is not None:
        return settled
    # a quarter of a turn that is no rest was only where the start happens to be
    swung_out = _moved(Linear(steady, fixed, rates, put))
    if swung_out is not None:
        return swung_out
    exact = Linear(steady, pose, {c.speed: start.of(c.speed) for c in steady.cyclic} | rates, put)
    left = _unbalanced(exact)
    if not left:
        return exact
    for place in places if given else []:
        for zero in (c.speed for c in steady.cyclic if c.speed in rates and c.speed not in given):
            others = {c: x for c, x in rates.items() if c != zero}
            begun = _solved_for(Linear(steady, place, others, put), zero)
            if begun is not None:
                return begun
    raise CannotAnswer(
        Message(
            "the start is no steady motion: 0 = {x} does not hold there. Start the model in one, as "
            "the question for a rate in steady motion gives it",
            x=to_text(tidy(left[0])),
        )
    )


def _check_rest(setup: Setup, steady: SteadyMotion) -> None:
    """Raises CannotAnswer where something moves at the start that has to rest in a steady motion."""
    start = setup.draws[0].start()
    for c in steady.others:
        if c.index in steady.given:
            continue
        measure = steady.model.measure_of(c)
        rate = 0.0 if measure is None else start.rate(measure)
        if not setup.start.of(c.speed).is_zero() or abs(rate) > _SMALL:
            raise CannotAnswer(
                Message(
                    "{x} moves at the start, and the equations of motion depend on it: the motion is not steady. "
                    "Of a free body ask for stability of the spin of BODY about x",
                    x=c.name,
                )
            )


def _unbalanced(linear: Linear) -> list[Ratio]:
    """Forces that are left over in the steady motion."""
    return [x for force in linear.steady.forces if not linear.steady.model.samples.vanishes(x := linear.here(force))]


def _solved_for(linear: Linear, speed: int) -> Linear | None:
    """With one rate such that the motion is steady, where there is one, or one in either sense."""
    left = _unbalanced(linear)
    if speed in linear.rates or len(left) != 1:
        return None
    model, f = linear.steady.model, left[0].field
    for base, _exponent in f.factor(left[0].num)[1]:
        c = base.coefficients(speed) if speed in base.generators() else []
        value: Ratio | None = None
        if len(c) == 2 and not c[0].is_zero():
            value = -c[0] / c[1]
        if len(c) == 3 and c[1].is_zero():
            value = f.sqrt(-c[0] / c[2], model.samples.is_negative)
        if value is not None:
            found = replace(linear, rates=linear.rates | {speed: value})
            return None if _unbalanced(found) else found
    return None


def _solved_together(linear: Linear) -> Linear | None:
    """With all open rates and places such that the motion is steady, where the conditions are linear in them and leave
    one value for each: what a controller with states of its own settles at."""
    steady, left = linear.steady, _unbalanced(linear)
    rates = [c.speed for c in steady.cyclic if c.speed not in linear.rates]
    places = [c.index for c in steady.others if c.index not in linear.place]
    open_ = [*rates, *places]
    if len(left) != len(open_):
        return None
    f, rows = steady.model.field, list[Row]()
    for x in left:
        row: Row = {k: f.partial(x, k) for k in open_}
        if any(f.ingredients(slope) & set(open_) for slope in row.values()):
            return None
        rest = f.lowest_terms(f.follow(x, dict.fromkeys(open_, f.zero)))
        rows.append({k: v for k, v in row.items() if not v.is_zero()} | {RHS: -rest})
    solved = solve(f, rows, open_, steady.model.samples.vanishes)
    if solved.free or solved.contradictory:
        return None
    values = {k: row.get(RHS, f.zero) for k, row in solved.pivots.items()}
    found = replace(
        linear,
        rates=linear.rates | {k: values[k] for k in rates},
        place=linear.place | {k: values[k] for k in places},
        moved=linear.moved | frozenset(places),
    )
    return None if _unbalanced(found) else found


def _moved(linear: Linear) -> Linear | None:
    """With each coordinate that a condition leaves open where the motion is steady, nearest to the start, as of two
    arms that swing out by themselves; None where a condition leaves more, or a place has no closed form."""
    found, f = linear, linear.steady.model.field
    for condition in _unbalanced(linear):
        inside = f.ingredients(condition)
        open_ = [c for c in linear.steady.others if c.index in inside and c.index not in linear.steady.given]
        if len(open_) != 1 or open_[0].index in found.moved:
            return None
        place = linear.steady.nearest_place(condition, open_[0])
        if place is None:
            return None
        index = open_[0].index
        found = replace(found, place=found.place | {index: place}, moved=found.moved | {index})
    return None if found is linear or _unbalanced(found) else found
