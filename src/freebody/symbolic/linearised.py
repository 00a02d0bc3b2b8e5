"""What is linear about an equilibrium: M x'' + C x' + K x = 0.

With F(q, u, t) the right-hand side of M(q) du/dt = F, at the equilibrium q_e and at rest

    K = -dF/dq,        C = -dF/du.

Coordinates that follow the independent ones through closed loops follow them here too: with q_d(q) and
du_d = (dq_d/dq) du,

    dF/dq_k in all = dF/dq_k + sum over d of dF/dq_d * dq_d/dq_k.

At an equilibrium the speeds vanish, so that M, which multiplies accelerations, needs no derivative.

Loads and drivers that swing harmonically leave an equilibrium of their mean, about which the motion is forced:
F = F_0 + F_c cos(Omega t) + F_s sin(Omega t) has the mean F_0. Drives that enter otherwise do so to the first order in
their amplitude (`system/small_drives`). Anything else that varies in time is taken as it is at t = 0.
Source: Meirovitch, Elements of Vibration Analysis, 2nd ed. 1986, sec. 4.2 and 2.2.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

from freebody.errors import CannotAnswer, FormulaTooLong
from freebody.language.sentences import Message
from freebody.symbolic.linear import determinant
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.parameter_roots import slope
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.unknowns import Coordinate
from freebody.system.modes import depends_on_time
from freebody.system.small_drives import SCALE

Matrix = list[list[Ratio]]


@dataclass(frozen=True)
class Swing:
    """cos(Omega t) and sin(Omega t) of what is harmonic in time: their generators, and Omega. size: the generator that
    scales drives of which only the first order counts."""

    cos: int
    sin: int
    frequency: Ratio
    size: int | None = None

    def parts(self, x: Ratio) -> tuple[Ratio, Ratio, Ratio] | None:
        """The mean of an element and what multiplies the cosine and the sine; None where it is not linear in them."""
        f = x.field
        if self.size is not None:
            none = {self.size: f.zero}
            by_size = slope(f, x, self.size)
            if by_size is None:
                return None
            mean, swing = f.follow(x, none), f.lowest_terms(f.follow(by_size, none))
            parts = replace(self, size=None).parts(swing)
            return (mean, *parts[1:]) if parts is not None and parts[0].is_zero() else None
        mean, cos, sin = (f.substitute(x, self._at(x, c, s)) for c, s in ((0, 0), (1, 0), (0, 1)))
        cos, sin = cos - mean, sin - mean
        return (mean, cos, sin) if x == mean + cos * f.variable(self.cos) + sin * f.variable(self.sin) else None

    @property
    def mean(self) -> tuple[int, ...]:
        """The generators that vanish where everything has its mean."""
        return (self.cos, self.sin) if self.size is None else (self.size,)

    def _at(self, x: Ratio, c: int, s: int) -> dict[int, Ratio]:
        return {self.cos: x.field.element(c), self.sin: x.field.element(s)}


def timed_in(model: SymbolicModel, x: Ratio) -> set[int]:
    """The generators in an element that vary in time by themselves."""
    f, t = model.field, model.field.index(model.field.time)
    return {g for g in x.generators() if g == t or t in f.generators[g].made_of}


def swing_of(model: SymbolicModel) -> Swing | None:
    """How loads and drivers swing; None where nothing varies in time, or not in one sine."""
    f = model.field
    if not depends_on_time(model.system):
        return None
    entries = [*model.dynamics.forcing_near_rest, *model.dynamics.parts_of_inertia]
    timed = set[int]().union(*(timed_in(model, x) for x in entries))
    size = model.parameters.get(SCALE)
    if size is not None:  # roots vary with the waves in them, and not by themselves
        timed = {g for g in timed if f.generators[g].kind != "root"}
    pair = next((p for p in f.pairs(timed) if timed <= set(p)), None) if timed else None
    if pair is None:
        return None
    frequency = -f.rate(f.variable(pair[0])) / f.variable(pair[1])
    found = Swing(*pair, frequency, None if size is None else f.index(size))
    if not frequency.is_constant() or any(found.parts(x) is None for x in model.dynamics.forcing_near_rest):
        return None
    return found


def stand_still(model: SymbolicModel) -> dict[int, Ratio]:
    """What stands for the time at an equilibrium: nothing for what swings about its mean, else t = 0."""
    f, swing = model.field, swing_of(model)
    if swing is None:
        return {f.index(f.time): f.zero}
    return dict.fromkeys(swing.mean, f.zero)


def vanishes_at_start(model: SymbolicModel, x: Ratio) -> bool:
    """Whether an element vanishes: formally, or at all starts where it stands in what closed loops decide."""
    if x.is_zero():
        return True
    inside = x.field.ingredients(x)
    return any(d.index in inside for d in model.dependent) and model.samples.vanishes_at_starts(x)


@dataclass(frozen=True)
class Linearised:
    """The linear equations about an equilibrium. at: the coordinates there, by generator."""

    model: SymbolicModel
    at: dict[int, Ratio]

    @cached_property
    def still(self) -> dict[int, Ratio]:
        """The equilibrium, at rest."""
        m = self.model
        rest = {c.speed: m.field.zero for c in (*m.coordinates, *m.dependent)}
        return {**stand_still(m), **self.at, **rest}

    def here(self, x: Ratio) -> Ratio:
        """In the equilibrium; what loops bind comes last, when elements have become short."""
        f = self.model.field
        free = {c.index for c in self.model.coordinates}
        bound = {g: value for g, value in self.at.items() if g not in free}
        x = f.lowest_terms(f.follow(x, {g: value for g, value in self.still.items() if g not in bound}))
        return self._with_short_roots(f.lowest_terms(f.follow(x, bound))) if bound else x

    def _with_short_roots(self, x: Ratio) -> Ratio:
        """Roots of squares by the sign that they have at the start: how the loop is assembled."""
        f = self.model.field
        roots = [g for g in sorted(x.generators()) if f.generators[g].kind == "root"]
        taken = {g: f.sqrt(f.radicand(g), self.model.samples.is_negative) for g in roots}
        return f.lowest_terms(f.substitute(x, taken))

    def slope(self, x: Ratio, c: Coordinate) -> Ratio:
        """Along a coordinate, what follows it through loops following it; at rest, where elements are shorter."""
        m, f = self.model, self.model.field
        x = f.follow(x, dict.fromkeys((d.speed for d in (*m.coordinates, *m.dependent)), f.zero))
        inside = f.ingredients(x)
        try:
            own = f.derivative(x, c.index)
            following = [(d, f.derivative(x, d.index)) for d in m.dependent if d.index in inside]
        except FormulaTooLong:
            slopes = [self._slope_here(x, d) * self._ratio(d, c) for d in m.dependent if d.index in inside]
            return f.lowest_terms(sum(slopes, self._slope_here(x, c)))
        try:  # in the pose, where each part is short
            parts = (self.here(slope) * self._ratio(d, c) for d, slope in following)
            return f.lowest_terms(sum(parts, self.here(own)))
        except ZeroDivisionError:  # of parts that have a value there only together
            wholes = (slope * f.partial(m.dependent_speed(d), c.speed) for d, slope in following)
            return self.here(sum(wholes, own))

    def _slope_here(self, x: Ratio, c: Coordinate) -> Ratio:
        """Along a coordinate alone, of what is too long in general: (N' D - N D')/D^2 of parts taken in the pose."""
        f = self.model.field
        num, den = f.parts(x)
        N, D = self.here(num), self.here(den)
        slope = f.zero
        for index, rate in f.directions(x, c.index).items():
            dN, dD = (self.here(f.partial(part, index)) for part in (num, den))
            slope = slope + (dN * D - N * dD) / (D * D) * self.here(rate)
        return f.lowest_terms(slope)

    def _ratio(self, d: Coordinate, c: Coordinate) -> Ratio:
        """How fast what loops bind runs there with the speed 1 of a coordinate."""
        if (d.index, c.index) not in self._ratios:
            self._ratios[d.index, c.index] = self.here(self.model.field.partial(self.model.dependent_speed(d), c.speed))
        return self._ratios[d.index, c.index]

    @cached_property
    def _ratios(self) -> dict[tuple[int, int], Ratio]:
        return {}

    def speed_slope(self, x: Ratio, c: Coordinate) -> Ratio:
        """Along the speed of a coordinate, at rest."""
        m, f = self.model, self.model.field
        pose = stand_still(m) | self.at
        try:  # in the pose, where it is short
            following = {d.speed: f.follow(m.dependent_speed(d), pose) for d in m.dependent}
            return self.here(f.partial(f.substitute(f.follow(x, pose), following), c.speed))
        except ZeroDivisionError:  # of parts that have no value there
            return self.here(f.partial(m.in_independent_speeds(x), c.speed))

    # -- the matrices -------------------------------------------------------------------------
    @cached_property
    def mass(self) -> Matrix:
        return self.model.dynamics.mass_matrix_in(self.here)

    @cached_property
    def stiffness(self) -> Matrix:
        return self._each(lambda force, c: -self.slope(force, c))

    @cached_property
    def damping(self) -> Matrix:
        return self._each(lambda force, c: -self.speed_slope(force, c))

    def _each(self, entry: Callable[[Ratio, Coordinate], Ratio]) -> Matrix:
        m = self.model
        return [[entry(force, c) for c in m.coordinates] for force in m.dynamics.forcing_near_rest]

    # -- the characteristic polynomial --------------------------------------------------------
    def pencil(self, s: Ratio) -> Matrix:
        """K - s M."""
        pairs = zip(self.stiffness, self.mass, strict=True)
        return [[k - s * m for k, m in zip(*rows, strict=True)] for rows in pairs]

    @cached_property
    def factors(self) -> tuple[tuple[tuple[Ratio, ...], int], ...]:
        """The irreducible factors of det(K - s M) in s: coefficients from the constant term up, and how often each
        occurs. Raises CannotAnswer where it vanishes for every s: nothing decides the motion."""
        f, s = self.model.field, self.model.field.parameter("@s")
        found = determinant(self.pencil(s))
        if found.is_zero():
            raise CannotAnswer(
                Message("something moves with neither mass nor stiffness, so that its motion is not determined")
            )
        index = f.index(s)
        _unit, factors = f.factor(found.num)
        return tuple((tuple(base.coefficients(index)), n) for base, n in factors if index in base.generators())

    # -- what they are like -------------------------------------------------------------------
    def vanishes(self, x: Ratio) -> bool:
        """Whether an element vanishes at the equilibrium: formally, or at all starts where it stands in what closed
        loops decide, so that the start is the equilibrium."""
        return vanishes_at_start(self.model, x)

    def is_symmetric(self, A: Matrix) -> bool:
        return all(self.vanishes(A[j][k] - A[k][j]) for j in range(len(A)) for k in range(j))

    @property
    def is_gyroscopic(self) -> bool:
        """Forces that are linear in the speeds and do no work can hold what the stiffness pushes away."""
        return not self.is_symmetric(self.damping)

    @property
    def is_damped(self) -> bool:
        return any(not self.vanishes(x) for row in self.damping for x in row)

    @property
    def bound(self) -> str:
        """The names of what follows through closed loops and stands in the matrices."""
        m = self.model
        entries = [x for A in (self.mass, self.stiffness, self.damping) for row in A for x in row]
        inside = frozenset[int]().union(*map(m.field.ingredients, entries)) if entries else frozenset[int]()
        return ", ".join(d.name for d in m.dependent if d.index in inside)

    def check_is_steady(self) -> None:
        """Raises CannotAnswer where masses or stiffnesses vary in time (parametric excitation)."""
        if any(timed_in(self.model, x) for A in (self.mass, self.stiffness, self.damping) for row in A for x in row):
            raise CannotAnswer(
                Message(
                    "mass or stiffness varies in time by what is driven (parametric excitation), so there are no "
                    "frequencies of free oscillations; simulate the motion"
                )
            )
