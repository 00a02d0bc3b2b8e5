"""Free small oscillations about an equilibrium: frequencies, mode shapes, damping, stability.

Undamped, M x'' + K x = 0 has motions x = v cos(omega t) with

    (K - s M) v = 0,    det(K - s M) = 0,    s = omega^2.

Forces with a potential make M and K symmetric, and M is positive definite, so all roots s are real. Those of a factor
of degree 3, s^3 + p s^2 + q s + r, are then by Vieta

    s_k = -p/3 + 2 w cos((arccos(u) + 2 pi k)/3),    w^2 = (p^2 - 3 q)/9,    u = (9 p q - 27 r - 2 p^3)/(54 w^3).

The components of a mode are cofactors of one row of K - s M; they are rational in s, so they are found modulo the
factor to which s belongs. Where the damping is proportional, C M^-1 K = K M^-1 C (Caughey), the modes are those without
damping, and with c_k = v.C v/(v.M v) each of them moves by

    z'' + c_k z' + s_k z = 0:    zeta = c_k/(2 omega),    omega_d^2 = s_k - c_k^2/4,    delta = pi c_k/omega_d.

The equilibrium is stable if all roots s are positive (Lagrange and Dirichlet). A factor whose roots are all real has
positive ones only if and only if its coefficients change signs throughout (Descartes). A root zero is neutral where
equilibria go on along it. Source: Meirovitch, Elements of Vibration Analysis, 2nd ed. 1986, ch. 4; Caughey, J. Applied
Mechanics 27, 1960; Merkin, Introduction to the Theory of Stability, 1997, ch. 3.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol
from freebody.language.notation import compared, joined, reworded
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.states import state_name
from freebody.symbolic.equilibrium import GYROSCOPIC, WITH_STATES, ClosedFormRest, find_equilibrium
from freebody.symbolic.functions import functions
from freebody.symbolic.linear import determinant, solve
from freebody.symbolic.linearised import Linearised, swing_of
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.quadratic import roots
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.residues import Coefficients, ResidueField
from freebody.symbolic.start import StartState
from freebody.symbolic.tidy import tidy

MOST_ROOTS = 3  # of a factor that has a closed form


def place_of_mode(n_modes: int, number: int) -> int:
    """Where a mode stands among all of them, the slowest first. Raises CannotAnswer where there are not so many."""
    if number > n_modes:
        raise CannotAnswer(Message("there are {n} modes only", n=n_modes))
    return number - 1 if number > 0 else n_modes + number


@dataclass(frozen=True)
class ModeFactor:
    """An irreducible factor of det(K - s M): its coefficients from the constant term up, and how often it occurs."""

    coefficients: tuple[Ratio, ...]
    times: int

    @property
    def degree(self) -> int:
        return len(self.coefficients) - 1

    @property
    def is_zero(self) -> bool:
        """Whether its root is zero."""
        return self.degree == 1 and self.coefficients[0].is_zero()


@dataclass(frozen=True)
class Mode:
    """One natural mode: the square of its frequency, and the factor whose root it is."""

    square: Ratio
    factor: ModeFactor

    @property
    def residues(self) -> ResidueField:
        return ResidueField(self.factor.coefficients)


@dataclass(frozen=True)
class FreeOscillations:
    """Small oscillations about an equilibrium."""

    model: SymbolicModel
    rest: ClosedFormRest
    notes: tuple[str, ...] = ()

    @property
    def equilibrium(self) -> dict[int, Ratio]:
        return self.rest.values

    @cached_property
    def linear(self) -> Linearised:
        return self.rest.linear or Linearised(self.model, self.rest.values)

    @cached_property
    def factors(self) -> tuple[ModeFactor, ...]:
        return tuple(ModeFactor(c, times) for c, times in self.linear.factors)

    # -- frequencies --------------------------------------------------------------------------
    @cached_property
    def modes(self) -> tuple[Mode, ...]:
        """By ascending frequency at the model's own values. Raises CannotAnswer where a factor has no closed form."""
        found = [Mode(s, factor) for factor in self.factors for s in self._roots(factor) * factor.times]
        samples = self.model.samples
        return tuple(sorted(found, key=lambda mode: (samples.at_starts(mode.square) or [0.0])[0]))

    @property
    def squares(self) -> tuple[Ratio, ...]:
        return tuple(mode.square for mode in self.modes)

    @property
    def swinging(self) -> tuple[int, ...]:
        """Which of them oscillate: where a square is zero nothing drives back to first order."""
        return tuple(k for k, square in enumerate(self.squares) if not square.is_zero())

    @property
    def are_real_by_symmetry(self) -> bool:
        """Whether roots stand in arcs whose arguments need no condition, since M and K are symmetric."""
        return any(factor.degree == MOST_ROOTS for factor in self.factors)

    def signs(self, factor: ModeFactor) -> list[Ratio]:
        """What has to be positive so that all roots of a factor, which are real, are so: its coefficients change signs
        throughout. Nothing for a root zero."""
        if factor.is_zero:
            return []
        n, leading = factor.degree, factor.coefficients[-1]
        short = self.model.field.lowest_terms
        return [short((-1) ** (n - k) * x / leading) for k, x in enumerate(factor.coefficients[:-1])]

    def positive(self, mode: Mode) -> list[Ratio]:
        """What has to be positive so that a mode oscillates: the square of its frequency; for roots in arcs, where that
        is not decided, all of its factor are."""
        return [mode.square] if mode.factor.degree < MOST_ROOTS else self.signs(mode.factor)

    def _roots(self, factor: ModeFactor) -> list[Ratio]:
        c, f = factor.coefficients, self.model.field
        found = roots(c, self.model.samples.is_negative)
        if found is not None:
            return found
        if factor.degree == MOST_ROOTS and self.linear.is_symmetric(self.linear.stiffness):
            return self._by_vieta(*(f.lowest_terms(x / c[3]) for x in reversed(c[:3])))
        raise CannotAnswer(
            Message(
                "the frequencies are roots of a polynomial of degree {n} in the squared frequency, which does not "
                "factor; ask for numbers",
                n=factor.degree,
            )
        )

    def _by_vieta(self, p: Ratio, q: Ratio, r: Ratio) -> list[Ratio]:
        """Three real roots of s^3 + p s^2 + q s + r, ascending: w is positive, since the roots differ."""
        f, positive = self.model.field, self.model.samples.is_negative
        fn = functions(f, positive)
        w = f.sqrt(f.lowest_terms((p * p - 3 * q) / 9), positive)
        u = f.lowest_terms((9 * p * q - 27 * r - 2 * p * p * p) / (54 * w * w * w))
        arc = fn["acos"](u) / 3
        return [-p / 3 + 2 * w * fn["cos"](arc + 2 * k * f.pi / 3) for k in (1, 2, 0)]

    def is_without_neutral(self, slopes: Sequence[Ratio]) -> bool:
        """Whether a motion that nothing drives back to first order leaves a sum of the coordinates as it is. slopes:
        of that sum. False where several of them go on together."""
        for mode in {mode.factor: mode for mode in self.modes if mode.square.is_zero()}.values():
            if mode.factor.times > 1:
                return False
            parts = [mode.residues.at(x, mode.square) for x in self.shape(mode)]
            if not self.linear.vanishes(sum((a * b for a, b in zip(slopes, parts, strict=True)), mode.square)):
                return False
        return True

    def slopes(self, measure: Measure) -> list[Ratio]:
        """Of a measure along the coordinates, at rest."""
        f, value = self.model.field, self.model.value_of(measure)
        at = self.linear.still | self.linear.at
        return [f.follow(f.derivative(value, c.index), at) for c in self.model.coordinates]

    def swinging_with(self, slopes: Sequence[Ratio]) -> tuple[int, ...]:
        """The places of the modes that oscillate in which a sum of the coordinates moves. slopes: of that sum."""
        return tuple(k for k in self.swinging if self._moves(self.modes[k], slopes))

    def _moves(self, mode: Mode, slopes: Sequence[Ratio]) -> bool:
        """Whether a sum of the coordinates moves in a mode, or in any of those that have its frequency; so it is taken
        to be where these are not known."""
        if mode.factor.times > 1 and mode.factor.degree == 1:
            shapes = self._eigenspace(mode.square)
        else:
            try:
                shapes = [[mode.residues.at(x, mode.square) for x in self.shape(mode)]]
            except CannotAnswer:
                return True
        zero = 0 * mode.square
        sums = (sum((a * b for a, b in zip(slopes, shape, strict=True)), zero) for shape in shapes)
        return not all(map(self.linear.vanishes, sums))

    # -- shapes -------------------------------------------------------------------------------
    def parts(self, k: int) -> list[Ratio]:
        """The components of the k-th mode along the coordinates, the first that moves being 1. Of modes with one
        frequency any combination is a mode: these are the first of `basis`."""
        mode = self.modes[k]
        if mode.factor.times == 1:
            return [mode.residues.at(x, mode.square) for x in self.shape(mode)]
        before = sum(other.square == mode.square for other in self.modes[:k])
        return self.basis(mode)[before]

    def basis(self, mode: Mode) -> list[list[Ratio]]:
        """Independent shapes with one squared frequency, v_i . M v_j = 0, by Gram and Schmidt from those that begin as
        late as they can. Raises CannotAnswer where there are fewer than the frequency occurs."""
        f, found = self.model.field, list[list[Ratio]]()
        mass = [[f.lowest_terms(x) for x in row] for row in self.linear.mass]
        for v in self._eigenspace(mode.square):
            for u in found:
                along = self._paired(mass, u, v) / self._paired(mass, u, u)
                v = [f.lowest_terms(x - along * y) for x, y in zip(v, u, strict=True)]
            first = next(x for x in v if not self.linear.vanishes(x))
            found.append([f.lowest_terms(x / first) for x in v])
        if len(found) != mode.factor.times:
            raise CannotAnswer(Message("several modes have this frequency: any combination of them is a mode"))
        return found

    def _paired(self, A: list[list[Ratio]], u: list[Ratio], v: list[Ratio]) -> Ratio:
        """u . A v"""
        zero = self.model.field.zero
        terms = (x * a * y for x, row in zip(u, A, strict=True) for a, y in zip(row, v, strict=True))
        return self.model.field.lowest_terms(sum(terms, start=zero))

    def _eigenspace(self, square: Ratio) -> list[list[Ratio]]:
        """Independent solutions of (K - s M) v = 0 for a squared frequency: one for each coordinate that stays free
        when the last ones are expressed by the first, so that its first component that moves is 1."""
        f, columns = self.model.field, [c.index for c in self.model.coordinates]
        rows = [dict(zip(columns, map(f.lowest_terms, row), strict=True)) for row in self.linear.pencil(square)]
        solved = solve(f, rows, columns[::-1], self.linear.vanishes, in_order=True)
        return [
            [f.one if c == free else solved.pivots.get(c, {}).get(free, f.zero) for c in columns]
            for free in solved.free[::-1]
        ]

    def shape(self, mode: Mode) -> list[Coefficients]:
        """The components along the coordinates, the first that moves being 1, as elements rational in s. Raises
        CannotAnswer where several modes have one frequency."""
        if mode.factor.times > 1:
            raise CannotAnswer(
                Message("several modes have this frequency: any combination of them is a mode, so none is singled out")
            )
        residues = mode.residues
        rows = self._cofactors(residues)
        n = len(rows)
        for first in range(n):
            # among the rows that tell the first component the one with the shortest divisor
            told = [row for row in rows if row[first]]
            if told:
                row = min(told, key=lambda row: (len(row[first]), sum(len(x.terms()[0]) for x in row[first])))
                by = residues.inverse(row[first])
                return [residues.one if k == first else residues.multiply(row[k], by) for k in range(n)]
        raise CannotAnswer(Message("several modes have this frequency: any combination of them is a mode"))

    def _cofactors(self, residues: ResidueField) -> list[list[Coefficients]]:
        """Those of K - s M, modulo a factor of its determinant."""
        f, s = self.model.field, self.model.field.parameter("@s")
        A = self.linear.pencil(s)
        index, n = f.index(s), len(A)

        def cofactor(j: int, k: int) -> Coefficients:
            minor = [[x for i, x in enumerate(row) if i != k] for h, row in enumerate(A) if h != j]
            value = f.one if n == 1 else f.lowest_terms(determinant(minor))
            sign, below = (-1) ** (j + k), value.denominator()
            parts = value.numerator().coefficients(index) if index in value.generators() else [value.numerator()]
            return residues.reduced([sign * x / below for x in parts])

        return [[cofactor(j, k) for k in range(n)] for j in range(n)]

    def along(self, mode: Mode, A: list[list[Ratio]], v: list[Coefficients]) -> Coefficients:
        """v . A v of a mode."""
        residues, total = mode.residues, list[Ratio]()
        for j, row in enumerate(A):
            for k, entry in enumerate(row):
                if not self.linear.vanishes(entry):
                    product = residues.multiply(v[j], v[k])
                    total = residues.add(total, [entry * x for x in product])
        return total

    # -- damping ------------------------------------------------------------------------------
    @cached_property
    def damping_is_proportional(self) -> bool:
        """C M^-1 K symmetric: the modes without damping are those with it."""
        linear, n = self.linear, len(self.linear.mass)
        if n == 1:
            return True
        adjugate = _adjugate(linear.mass)
        product = _times(_times(linear.damping, adjugate), linear.stiffness)
        return linear.is_symmetric(product) and not determinant(linear.mass).is_zero()

    def decay(self, mode: Mode) -> Ratio:
        """c_k of z'' + c_k z' + s_k z = 0. Raises CannotAnswer where the damping couples the modes."""
        if not self.damping_is_proportional:
            raise CannotAnswer(
                Message(
                    "the damping couples the modes (it is not proportional), so the damped motions have no simple "
                    "closed form; ask for numbers: freebody modes has them"
                )
            )
        v, residues = self.shape(mode), mode.residues
        part = residues.multiply(
            self.along(mode, self.linear.damping, v), residues.inverse(self.along(mode, self.linear.mass, v))
        )
        return residues.at(part, mode.square)


def _times(A: list[list[Ratio]], B: list[list[Ratio]]) -> list[list[Ratio]]:
    zero = A[0][0].field.zero
    columns = list(zip(*B, strict=True))
    return [[sum((x * y for x, y in zip(row, c, strict=True)), start=zero) for c in columns] for row in A]


def _adjugate(A: list[list[Ratio]]) -> list[list[Ratio]]:
    n = len(A)

    def cofactor(j: int, k: int) -> Ratio:
        return (-1) ** (j + k) * determinant([[*row[:k], *row[k + 1 :]] for i, row in enumerate(A) if i != j])

    return [[cofactor(j, k) for j in range(n)] for k in range(n)]


def free_oscillations(model: SymbolicModel, start: StartState, rest: ClosedFormRest | None = None) -> FreeOscillations:
    """About the equilibrium that is stable (else nearest to the start). rest: that, where it is known. Raises
    CannotAnswer where there is none in closed form, or where forces that are linear in the speeds and do no work mix
    the motions."""
    if not model.coordinates:
        raise CannotAnswer(Message("nothing can move, so nothing oscillates"))
    if any(state_name(c.name) for c in model.coordinates):
        raise CannotAnswer(WITH_STATES)
    notes: list[str] = []
    rest = small_motion_about(model, start) if rest is None else rest
    if rest.moves_evenly:
        notes.append(Message("there is no rest: these are the vibrations beside a motion with constant acceleration"))
    if not _is_start(model, rest, start):
        shown = joined((compared(Symbol(c.name), "=", tidy(rest.values[c.index])) for c in model.coordinates), ", ")
        notes.append(reworded(Message("about the equilibrium {place}", place=shown), shown))
    found = FreeOscillations(model, rest, tuple(notes))
    found.linear.check_is_steady()
    if notes and (names := found.linear.bound):
        raise CannotAnswer(
            Message(
                "{names} follow only through a closed loop; no closed form of the frequencies is found", names=names
            )
        )
    if found.linear.is_gyroscopic:
        raise CannotAnswer(GYROSCOPIC)
    return found


def small_motion_about(model: SymbolicModel, start: StartState, *, stable_first: bool = True) -> ClosedFormRest:
    """The equilibrium, else the start where small motions are those beside an even motion. Raises CannotAnswer."""
    try:
        return find_equilibrium(model, start, stable_first=stable_first)
    except CannotAnswer:
        moving = _beside_even_motion(model, start)
        if moving is None:
            raise
        return moving


def _beside_even_motion(model: SymbolicModel, start: StartState) -> ClosedFormRest | None:
    """The pose of the start, where no place is one of rest since all go on together with constant acceleration, and the
    equations are linear: M q'' + C q' + K q = f with constant matrices has the modes of its homogeneous part, beside
    any solution. None where they are not linear."""
    f, coordinates = model.field, model.coordinates
    if model.dependent or swing_of(model) is not None:
        return None
    at = {c.index: start.of(c.index) for c in coordinates}
    linear = Linearised(model, at)
    moving = {g for c in coordinates for g in (c.index, c.speed)} | {f.index(f.time)}
    forces = model.dynamics.forcing_near_rest
    slopes = [f.lowest_terms(f.derivative(F, c.index)) for F in forces for c in coordinates]
    slopes += [f.lowest_terms(f.partial(F, c.speed)) for F in forces for c in coordinates]
    masses = [f.lowest_terms(x) for row in model.dynamics.mass_matrix for x in row]
    if any(f.ingredients(x) & moving for x in (*slopes, *masses)) or determinant(linear.mass).is_zero():
        return None
    return ClosedFormRest(at, moves_evenly=True, linear=linear)


def _is_start(model: SymbolicModel, rest: ClosedFormRest, start: StartState) -> bool:
    return all(rest.values[c.index] == start.of(c.index) for c in model.coordinates)
