"""Motion told in names, in the order in which it is computed by hand.

With u the independent speeds and v those that loops bind,

    v = k u + r,     dv/dt = k du/dt + h,     M du/dt = Q     (M and Q in k, h and v),

every quantity is a short formula in angles, speeds and accelerations, each of which was told before it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from freebody.language.expression import Call, Symbol
from freebody.symbolic.dynamics import NothingWithMass
from freebody.symbolic.field import Generator, Kind
from freebody.symbolic.linear import RHS, Row, solve
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.polynomials import Monomial
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.unknowns import Coordinate


@dataclass(frozen=True)
class NamedElement:
    """A generator, and what it stands for, by parameters, coordinates and what was named before."""

    index: int
    value: Ratio


class StagedMotion:
    """The names of a model's motion in their order; `model` is the same model, and tells what is asked in them."""

    def __init__(
        self, model: SymbolicModel, taken: set[str], short: Callable[[Coordinate], str], *, is_still: bool = False
    ) -> None:
        """taken: names that mean something else, to which those of the motion are added; short: a coordinate as a
        subscript; is_still: nothing accelerates, whatever has mass. Raises CannotAnswer where the accelerations are not
        determined."""
        self._of, self.field = model, model.field
        self._taken, self._short = taken, short
        loops = [self.field.rate(e.value.numerator()) for e in model.loops]
        self._velocities = {
            name: tuple(shortened(v, loops) for v in parts) for name, parts in model.kinematics.velocities.items()
        }
        self.ratios: list[NamedElement] = []
        self.speeds: list[NamedElement] = []
        self.accelerations: list[NamedElement] = []
        self.inertias: list[NamedElement] = []
        self._dependent_rates: dict[int, Ratio] = {}
        self._name_speeds()
        if is_still:
            self.model = model.in_names(self._velocities, self._by_ratio)
            return
        self._dependent_rates = self._name_rates()
        self._name_accelerations()
        self.model = model.in_names(self._velocities, {}, {a: self.field.variable(a) for a in model.accelerations})

    def _fresh(self, name: str) -> str:
        """A name that nothing else has."""
        while name in self._taken:
            name += "_"
        self._taken.add(name)
        return name

    def rates(self) -> dict[int, Ratio]:
        """How the dependent speeds change, where what is asked is told."""
        return {e.index: self.field.variable(a) for e, a in zip(self.speeds, self._shown_rates, strict=True)}

    # -- names --------------------------------------------------------------------------------
    def named(self, name: str, value: Ratio, *, positive: bool = False) -> NamedElement:
        """Another name for an element in what was named before."""
        return self._of_display(Symbol(self._fresh(name)), value, "function", positive=positive)

    def _of_display(self, shown: Symbol | Call, value: Ratio, kind: Kind, *, positive: bool = False) -> NamedElement:
        f, constant = self.field, value.fraction()

        def compute(values: Mapping[int, Any], functions: Any) -> Any:
            if constant is None:
                return f.evaluate(value, values, functions)
            number = 0 * functions.pi + constant.numerator  # of the kind that is computed with
            return number / constant.denominator

        generator = Generator(
            shown,
            kind,
            positive,
            compute=compute,
            made_of=f.ingredients(value),
        )
        return NamedElement(f.index(f.generator(generator, key=("staged", shown, value.key()))), value)

    def _of_pair(self, letter: str, d: Coordinate, c: Coordinate) -> str:
        several = len(self._of.coordinates) > 1
        own = f"{letter}_{self._short(d)}"
        return f"{own}_{self._short(c)}" if several else own

    def _name_speeds(self) -> None:
        """v = k u + r"""
        f = self.field
        self._by_ratio: dict[int, Ratio] = {}
        for d in self._of.dependent:
            value = self._of.dependent_speed(d)
            total, rest = f.zero, value
            for c in self._of.coordinates:
                slope = f.lowest_terms(f.partial(value, c.speed))
                if slope.is_zero():
                    continue
                ratio = self.named(self._of_pair("k", d, c), slope)
                self.ratios.append(ratio)
                total = total + f.variable(ratio.index) * f.variable(c.speed)
                rest = rest - slope * f.variable(c.speed)
            total = total + f.lowest_terms(rest)
            self._by_ratio[d.speed] = total
            self.speeds.append(NamedElement(d.speed, total))

    def _name_rates(self) -> dict[int, Ratio]:
        """dv/dt = k du/dt + h"""
        f, found = self.field, dict[int, Ratio]()
        still = dict.fromkeys(self._of.accelerations, f.zero)
        self.biases: list[NamedElement] = []
        self._shown_rates: list[int] = []
        for d in self._of.dependent:
            rate = f.rate(f.variable(d.speed))
            bias = f.lowest_terms(f.substitute(rate, still))
            total = f.zero
            for c, a in zip(self._of.coordinates, self._of.accelerations, strict=True):
                k = f.partial(self._by_ratio[d.speed], c.speed)
                total = total + k * f.variable(a)
            if total.is_zero() or bias.is_zero():
                found[d.speed] = total + bias
                continue
            named = self.named(f"h_{self._short(d)}", bias)
            self.biases.append(named)
            found[d.speed] = total + f.variable(named.index)
        return found

    def _name_accelerations(self) -> None:
        """M du/dt = Q, then dv/dt"""
        f = self.field
        self.forces: list[NamedElement] = []
        with f.other_rates(self._dependent_rates):
            moved = self._of.in_names(self._velocities, self._by_ratio)
            mass, force = moved.dynamics.mass_matrix, moved.dynamics.forcing
        n = len(force)
        rows: list[Row] = []
        for j in range(n):
            row: Row = {}
            for k, b in enumerate(self._of.accelerations):
                if mass[j][k].is_zero():
                    continue
                name = "M_eff" if n == 1 else f"M_{min(j, k) + 1}{max(j, k) + 1}"
                row[b] = self._inertia(name, mass[j][k])
            if not force[j].is_zero():
                self.forces.append(self.named("Q_eff" if n == 1 else f"Q_{j + 1}", force[j]))
                row[RHS] = f.variable(self.forces[-1].index)
            rows.append(row)
        samples = self._of.samples
        solved = solve(f, rows, self._of.accelerations, samples.vanishes, is_last=samples.vanishes_at_starts)
        if solved.free:
            raise NothingWithMass(moved.dynamics.nothing_moves(solved.free))
        for a in self._of.accelerations:
            self.accelerations.append(NamedElement(a, solved.pivots[a].get(RHS, f.zero)))
        for d in self._of.dependent:
            shown = Call("rate", Call("rate", Symbol(d.name)))
            rate = self._of_display(shown, self._dependent_rates[d.speed], "acceleration")
            self._shown_rates.append(rate.index)
            self.accelerations.append(rate)

    def _inertia(self, name: str, value: Ratio) -> Ratio:
        """Named where it has no name yet: the mass matrix is symmetric."""
        known = next((e for e in self.inertias if e.value == value), None)
        if known is None:
            # one mass is not negative, and was divided by
            known = self.named(name, value, positive=name == "M_eff")
            self.inertias.append(known)
        return self.field.variable(known.index)

    @property
    def names(self) -> list[NamedElement]:
        """All of them, each after those that it is told by."""
        return [*self.ratios, *self.inertias, *self.speeds, *self.biases, *self.forces, *self.accelerations]


def shortened(x: Ratio, zeros: Sequence[Ratio]) -> Ratio:
    """The same with the fewest terms that adding multiples of what is zero leaves: by the links on its own side of a
    loop the centre of a crank has one term."""
    found = x
    if x.denominator().generators():
        return x
    while True:
        shorter = min(_with_multiples(found, zeros), key=lambda other: len(other.num), default=found)
        if len(shorter.num) >= len(found.num):
            return found
        found = shorter


def _with_multiples(x: Ratio, zeros: Sequence[Ratio]) -> Iterator[Ratio]:
    """x with one of its terms cancelled by a multiple of something that is zero."""
    f, own, below = x.field, x.terms()[0], x.denominator()
    for zero in zeros:
        tried = set[tuple[Monomial, Fraction]]()
        for m, coefficient in own.items():
            for n, other in zero.terms()[0].items():
                rest = dict(m)
                for g, exponent in n:
                    rest[g] = rest.get(g, 0) - exponent
                key = tuple(sorted((g, e) for g, e in rest.items() if e)), Fraction(coefficient, other)
                if key in tried or any(e < 0 for _g, e in key[0]):
                    continue
                tried.add(key)
                yield x - zero * f.polynomial({key[0]: 1}) * f.element(key[1]) / below
