"""Generalized coordinates: which coordinates the held measures leave free, the others in terms of these.

An equation that is linear in a coordinate, with a coefficient that does not move, gives that coordinate away; so do
two equations linear in the position (x, y) of one body whose determinant does not move (a bead on a turning
rod). Coordinates go in the order of their rank: what a person would rather not see goes first. What is left
over are closed loops: equations among the coordinates that stay.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from dataclasses import field as initial

from freebody.errors import CannotAnswer
from freebody.measures.geometry import Vector
from freebody.symbolic.field import Field
from freebody.symbolic.functions import known_angle
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of

# the name of equations that state a known value; they go before all others
GIVEN = "given"
MOST_OF_A_PRODUCT = 200  # terms of an equation that is looked at for factors
MOST_OF_AN_ANGLE = 8  # terms of an equation by which a closed loop is solved for an angle


@dataclass(frozen=True)
class Unknown:
    """A coordinate before elimination; a lower rank is eliminated first."""

    index: int
    rank: tuple[int, int]
    name: str
    partner: int | None = None  # y of the same body, for x


@dataclass(frozen=True)
class RowEquation:
    """value = 0, from the row of that name. defines: it says where something is in coordinates of its own, and goes
    before what is held there."""

    name: str
    value: Ratio
    defines: bool = False


@dataclass(frozen=True)
class TangentPair:
    """A tangent in the held measures, (x, y) = length e(angle) + offset n(angle): two equations that carry its
    name, and two unknowns."""

    name: str
    x: Ratio
    y: Ratio
    offset: Ratio
    length: int
    angle: int


EliminationStep = tuple[list[RowEquation], dict[int, Ratio]]  # the equations used up, and what follows


@dataclass
class Elimination:
    """Runs on creation; afterwards `kept`, `loops`, `redundant` and `express` tell the outcome."""

    field: Field
    unknowns: dict[int, Unknown]
    equations: list[RowEquation]
    lines: list[TangentPair]
    is_zero: Callable[[Ratio], bool]
    straight: Callable[[Vector[Ratio], Ratio], tuple[Ratio, Ratio]]
    named_rank: int  # coordinates of this rank and above are wanted; rather solve a line by a root
    is_of_motion: bool = True  # not of one pose, in which places tell the lines
    angle_by: Callable[[int, Ratio, Ratio, Ratio], Ratio | None] | None = None  # q from a cos q + b sin q + d = 0
    solved: list[tuple[int, Ratio]] = initial(default_factory=list[tuple[int, Ratio]])
    loops: list[RowEquation] = initial(default_factory=list[RowEquation])
    redundant: list[str] = initial(default_factory=list[str])

    def __post_init__(self) -> None:
        _ = self.field.time  # made here if it was not yet
        in_time = {index for index, g in self.field.generators.items() if g.kind == "time"}
        self._moving = frozenset(self.unknowns) | in_time
        # by identity; the equation is kept so that its identity is not given away again
        self._options: dict[int, tuple[RowEquation, list[tuple[tuple[int, int], int, Ratio]]]] = {}
        open_equations = self._unsettled(self.equations)
        while True:
            step = self._next_step(open_equations)
            if step is None:
                shorter = [self._without_factors(e) for e in open_equations]
                if any(e is not s for e, s in zip(open_equations, shorter, strict=True)):
                    open_equations = self._unsettled(shorter)
                    continue
                step = self._over_what_never_vanishes(open_equations)
            if step is None:
                break
            used, values = step
            rest = [e for e in open_equations if all(e is not u for u in used)]
            open_equations = [self._insert(e, values, cancels=any(u.defines for u in used)) for e in rest]
            self.solved += list(values.items())
            open_equations = self._unsettled(open_equations)
        self.loops = self._through_fewest(open_equations)
        gone = {index for index, _value in self.solved}
        self.kept = sorted(
            (u for u in self.unknowns.values() if u.index not in gone), key=lambda u: u.rank, reverse=True
        )
        self._values: dict[int, Ratio] = {}
        # what was solved last contains only what stays; whole angles go in at once, so that their terms combine
        for index, value in reversed(self.solved):
            self._values[index] = self.field.follow(value, self._values)

    def express(self, x: Ratio) -> Ratio:
        """An element in terms of the coordinates that stay."""
        return self.field.follow(x, self._values)

    def _so_far(self, x: Ratio) -> Ratio:
        for index, value in self.solved:
            x = self.field.follow(x, {index: value})
        return x

    # -- loops --------------------------------------------------------------------------------
    def _through_fewest(self, loops: list[RowEquation]) -> list[RowEquation]:
        """Each loop through as few coordinates as it can: where two share links, their difference is a loop round
        both, as that of crank, pitman and back plate of a crusher, which has no part of the jaw."""
        found = list(loops)
        for k, one in enumerate(found):
            shorter = (x for other in found if other is not one for x in self._round_both(one.value, other.value))
            best = min(shorter, key=self._n_coordinates, default=one.value)
            if self._n_coordinates(best) < self._n_coordinates(one.value):
                found[k] = replace(one, value=best)
                return self._through_fewest(found)
        return found

    def _n_coordinates(self, x: Ratio) -> int:
        return len(self.field.ingredients(x) & self.unknowns.keys())

    def _round_both(self, x: Ratio, y: Ratio) -> Iterator[Ratio]:
        """Sums of multiples of two equations in which a cosine, a sine or a length that both are linear in is gone."""
        for g in sorted(x.generators() & y.generators()):
            if not (self.field.ingredients(self.field.variable(g)) & self.unknowns.keys()):
                continue
            first, second = (e.numerator().coefficients(g) for e in (x, y))
            if len(first) == len(second) == 2 and self._is_still(first[1]) and self._is_still(second[1]):
                yield self.field.lowest_terms(x - y * first[1] / second[1]).numerator()

    # -- steps --------------------------------------------------------------------------------
    def _next_step(self, open_equations: list[RowEquation]) -> EliminationStep | None:
        """What is solved for next: positions one by one, then lines that turn out to be known, then whatever is linear;
        where only wanted coordinates are left rather two at once or a line by a root; at last the angle of a loop."""
        step = (
            self._line_along(open_equations) if self.is_of_motion else None
        )  # before places are told by lines to them
        if step is not None:
            return step
        step = single = self._best_single(open_equations)
        rank = 99 if single is None else self.unknowns[min(single[1])].rank[0]
        if rank > 0:
            # positions are done: lines may have turned out to be known ones
            step = self._known_line(open_equations)
            if step is None and rank >= self.named_rank:
                step = self._best_pair(open_equations) or self._explicit_line(open_equations)
            step = step or single or self._best_pair(open_equations)
        if step is None and self.angle_by is not None:
            step = self._known_turn(open_equations) or self._explicit_angle(open_equations)
        return step

    def _over_what_never_vanishes(self, equations: list[RowEquation]) -> EliminationStep | None:
        """A position from an equation that is linear in it, with a coefficient of one sign everywhere: (1 + x^2) y = h,
        exp(x) y = h."""
        for unknown in sorted(self.unknowns.values(), key=lambda u: u.rank):
            if unknown.rank[0] > 0:
                break
            for equation in equations:
                linear = self._linear(equation.value, unknown.index)
                if linear is not None and sign_of(linear[0]) in (Sign.POSITIVE, Sign.NEGATIVE):
                    return [equation], {unknown.index: self.field.lowest_terms(-linear[1] / linear[0])}
        return None

    def _unsettled(self, equations: list[RowEquation]) -> list[RowEquation]:
        """The equations that still say something; redundant ones are noted."""
        return [e for e in equations if not self._is_settled(e)]

    def _is_settled(self, equation: RowEquation) -> bool:
        """True for 0 = 0, which is a redundant row; it is noted."""
        if self.field.ingredients(equation.value) & self._moving:
            return False
        if self.is_zero(equation.value):
            self.redundant.append(equation.name)
            return True
        return False

    def _insert(self, equation: RowEquation, values: dict[int, Ratio], *, cancels: bool) -> RowEquation:
        """cancels: more that will be put in takes out what stands below, as of a height over a curve."""
        if not self.field.ingredients(equation.value) & values.keys():
            return equation
        value = self.field.follow(equation.value, values)
        return replace(equation, value=self.field.lowest_terms(value) if cancels else value.numerator())

    def _without_factors(self, equation: RowEquation) -> RowEquation:
        """An equation without the factors that do not vanish on the branch: sqrt(1 + f'^2) (y - f) = 0 says y = f. The
        length l of a line is sqrt(l^2)."""
        plain = self._with_plain_lengths(equation.value)
        if plain is not None:
            return replace(equation, value=plain)
        value = equation.value.numerator()
        if len(value.num) > MOST_OF_A_PRODUCT:
            return equation
        _unit, factors = self.field.factor(value.num)
        kept = [base for base, _exponent in factors if self.is_zero(base)]
        if len(kept) != 1 or kept[0] == value or not self.field.ingredients(kept[0]) & self._moving:
            return equation
        return replace(equation, value=kept[0])

    def _with_plain_lengths(self, value: Ratio) -> Ratio | None:
        """With the lengths of lines for the roots of their squares; None where there is no such root."""
        f = self.field
        squares = {(x := f.variable(line.length)) * x: x for line in self.lines}
        roots = [g for g in value.generators() if f.generators[g].kind == "root"]
        lengths = {g: squares[square] for g in roots if (square := f.radicand(g)) in squares}
        return f.follow(value, lengths) if lengths else None

    def _is_still(self, x: Ratio) -> bool:
        return not self.field.ingredients(x) & self._moving

    def _linear(self, equation: Ratio, index: int) -> tuple[Ratio, Ratio] | None:
        """(c, r) with equation = c u + r, both free of u; None if it is not of that form."""
        if index not in equation.generators():
            return None
        parts = equation.numerator().coefficients(index)
        if len(parts) != 2:
            return None
        if any(index in self.field.ingredients(part) for part in parts):
            return None
        return parts[1], parts[0]

    def _single_options(self, equation: RowEquation) -> list[tuple[tuple[int, int], int, Ratio]]:
        if id(equation) not in self._options:
            found: list[tuple[tuple[int, int], int, Ratio]] = []
            for index in equation.value.generators() & self.unknowns.keys():
                linear = self._linear(equation.value, index)
                if linear is None or linear[0].is_zero():
                    continue
                slope = linear[0]
                if equation.defines:  # rather x = X(s) + h n(s) than h from it: what stands below counts
                    slope = self.field.lowest_terms(slope / equation.value.denominator())
                if self._is_still(slope):
                    found.append((self.unknowns[index].rank, index, -linear[1] / linear[0]))
            self._options[id(equation)] = equation, sorted(found, key=lambda item: item[0])
        return self._options[id(equation)][1]

    def _best_single(self, equations: list[RowEquation]) -> EliminationStep | None:
        """The equation and coordinate of lowest rank; equations of lines last, since a line between bodies on
        guides is better solved for the line."""
        best: tuple[tuple[int, int], bool] | None = None
        found: tuple[RowEquation, dict[int, Ratio]] | None = None
        names = {line.name for line in self.lines}
        for equation in equations:
            for rank, index, value in self._single_options(equation)[:1]:
                is_first = equation.name == GIVEN or equation.defines
                key = (-1, 0) if is_first else rank, equation.name in names
                if best is None or key < best:
                    best, found = key, (equation, {index: value})
        return None if found is None else ([found[0]], found[1])

    def _open_lines(
        self, equations: list[RowEquation]
    ) -> Iterator[tuple[TangentPair, Ratio, Ratio, list[RowEquation]]]:
        gone = {index for index, _value in self.solved}
        for line in self.lines:
            if line.angle in self.unknowns and not {line.angle, line.length} & gone:
                used = [e for e in equations if e.name == line.name]
                yield line, self._so_far(line.x), self._so_far(line.y), used

    def _known_line(self, equations: list[RowEquation]) -> EliminationStep | None:
        """A line between places that stand still, one that turns with a known angle at a constant length, or one
        between the same places as an earlier line. The equations of such a line go."""
        seen: dict[object, tuple[TangentPair, bool]] = {}
        for line, x, y, used in self._open_lines(equations):
            own = {line.length, line.angle}
            if self._is_still(x) and self._is_still(y):
                length, angle = self.straight(Vector(x, y), line.offset)
                return used, {line.length: length, line.angle: angle}
            square = x * x + y * y
            if self._is_still(square) and not own & self.field.ingredients(x):
                is_known = known_angle(self.field, y, x, self.field.sqrt(square)) is not None
                if is_known and line.offset.is_zero():
                    length, angle = self.straight(
                        Vector(x, y), line.offset
                    )  # of R - r the sign that it has at the start
                    return used, {line.length: length, line.angle: angle}
            key = (x.key(), y.key(), line.offset.key())
            opposite = ((-x).key(), (-y).key(), line.offset.key())
            if key not in seen:
                seen[key] = line, False
                if line.offset.is_zero():
                    seen[opposite] = line, True
                continue
            first, is_reversed = seen[key]
            angle = self.field.variable(first.angle)
            if is_reversed:
                angle = angle + self.field.pi
            return used, {line.length: self.field.variable(first.length), line.angle: angle}
        return None

    def _line_along(self, equations: list[RowEquation]) -> EliminationStep | None:
        """A line in a direction that stands still, as a string along the guide of a body, or along the slope down which
        the drum rolls or slides that it is wound on."""
        for line, x, y, used in self._open_lines(equations):
            if {line.length, line.angle} & (self.field.ingredients(x) | self.field.ingredients(y)):
                continue
            for along in [Vector(x, y)] if line.offset.is_zero() else self._from_touching_points(line, x, y):
                if (found := self._along_itself(line, along)) is not None:
                    return used, found
        return None

    def _from_touching_points(self, line: TangentPair, x: Ratio, y: Ratio) -> Iterator[Vector[Ratio]]:
        """A tangent to a round body from where it touches, if it has the direction in which that body goes: what is
        left of (x, y) without offset n(d) is along d, the one sense of it or the other."""
        for index in sorted((x.generators() | y.generators()) & self.unknowns.keys()):
            in_x, in_y = (self._linear(part, index) for part in (x, y))
            scales = x.denominator(), y.denominator()
            if in_x is None or in_y is None or not all(map(self._is_still, (in_x[0], in_y[0], *scales))):
                continue
            slope = self.field.lowest_terms(in_x[0] * scales[1] / (in_y[0] * scales[0]))
            along = Vector(slope.numerator(), slope.denominator())  # of which the size is short: (cos, sin) has 1
            size, _angle = self.straight(along, self.field.zero)
            for sense in (self.field.one, -self.field.one):
                offset = sense * line.offset / size
                way = Vector(*map(self.field.lowest_terms, (x + offset * along.y, y - offset * along.x)))
                ahead = sense * (way.x * along.x + way.y * along.y)
                if self.straight(Vector(ahead, self.field.zero), self.field.zero)[0] == ahead:  # else behind the circle
                    yield way

    def _along_itself(self, line: TangentPair, way: Vector[Ratio]) -> dict[int, Ratio] | None:
        """Length and angle of a line whose direction stands still; None if it turns, or has no length."""
        if way.x.is_zero() and way.y.is_zero():
            return None
        if way.x.is_zero() or way.y.is_zero():
            length, angle = self.straight(way, self.field.zero)
            return {line.length: length, line.angle: angle}
        slope = self.field.lowest_terms(way.x / way.y)
        return self._inclined(line, slope, way.y) if self._is_still(slope) else None

    def _inclined(self, line: TangentPair, slope: Ratio, y: Ratio) -> dict[int, Ratio]:
        """(x, y) = y (slope, 1): a length that is a multiple of |y|, which the root of x^2 + y^2 would not show."""
        rise, _upright = self.straight(Vector(self.field.zero, y), self.field.zero)
        if rise not in (y, -y):  # its sign is not known
            size, angle = self.straight(Vector(slope * y, y), self.field.zero)
            return {line.length: size, line.angle: angle}
        one = self.field.one if rise == y else -self.field.one
        size, angle = self.straight(Vector(slope * one, one), self.field.zero)
        return {line.length: self.field.lowest_terms(size * rise), line.angle: angle}

    def _explicit_line(self, equations: list[RowEquation]) -> EliminationStep | None:
        """A line whose length changes, by l = sqrt(x^2 + y^2 - offset^2) in the coordinates that stay."""
        for line, x, y, used in self._open_lines(equations):
            if {line.length, line.angle} & (self.field.ingredients(x) | self.field.ingredients(y)):
                continue
            length, angle = self.straight(Vector(x, y), line.offset)
            return used, {line.length: length, line.angle: angle}
        return None

    def _known_turn(self, equations: list[RowEquation]) -> EliminationStep | None:
        """A line of constant length that turns with a known angle, where its own angle is decided already: then the two
        are equal."""
        for line in self.lines:
            used = [e for e in equations if e.name == line.name]
            if line.length not in self.unknowns or any(index == line.length for index, _value in self.solved):
                continue
            x, y = self._so_far(line.x), self._so_far(line.y)
            square = self.field.lowest_terms(x * x + y * y)
            if not used or not line.offset.is_zero() or not self._is_still(square):
                continue
            if known_angle(self.field, y, x, self.field.sqrt(square)) is None:
                continue
            length, known = self.straight(Vector(x, y), line.offset)  # its sign as above
            difference = RowEquation(line.name, self._so_far(self.field.variable(line.angle)) - known)
            options = self._single_options(difference)
            if not options:
                continue
            _rank, index, value = options[0]
            return used, {line.length: length, index: value}
        return None

    def _explicit_angle(self, equations: list[RowEquation]) -> EliminationStep | None:
        """An angle that an equation contains by its cosine and sine alone, both linearly and with short
        coefficients."""
        if self.angle_by is None:
            return None
        found: list[tuple[tuple[int, ...], RowEquation, int, tuple[Ratio, Ratio, Ratio]]] = []
        for unknown in self.unknowns.values():
            pair = self.field.pair_of(unknown.index)
            if pair is None or unknown.rank[0] > self.named_rank:
                continue
            for equation in equations:
                parts = self._plane(equation.value, *pair)
                if parts is None or any(unknown.index in self.field.ingredients(part) for part in parts):
                    continue
                size = sum(len(part.num) for part in parts)
                if size <= MOST_OF_AN_ANGLE:
                    others = self.field.ingredients(equation.value) & self.unknowns.keys()
                    found.append(((len(others), size, *unknown.rank), equation, unknown.index, parts))
        for _key, equation, index, parts in sorted(found, key=lambda item: item[0]):
            with suppress(CannotAnswer):  # too long to write
                angle = self.angle_by(index, *parts)
                if angle is not None:
                    return [equation], {index: angle}
        return None

    def _best_pair(self, equations: list[RowEquation]) -> EliminationStep | None:
        """Two equations linear in x and y of one body, solved together (Cramer)."""
        for unknown in sorted(self.unknowns.values(), key=lambda u: u.rank):
            if unknown.partner is None:
                continue
            x, y = unknown.index, unknown.partner
            rows: list[tuple[RowEquation, Ratio, Ratio, Ratio]] = []
            for equation in equations:
                row = self._plane(equation.value, x, y)
                if row is not None:
                    rows.append((equation, *row))
            for k, (e1, a1, b1, r1) in enumerate(rows):
                for e2, a2, b2, r2 in rows[k + 1 :]:
                    det = a1 * b2 - a2 * b1
                    if det.is_zero() or not self._is_still(det):
                        continue
                    return [e1, e2], {x: (b1 * r2 - b2 * r1) / det, y: (a2 * r1 - a1 * r2) / det}
        return None

    def _plane(self, value: Ratio, x: int, y: int) -> tuple[Ratio, Ratio, Ratio] | None:
        """(a, b, r) with value = a x + b y + r, all free of x and y."""
        zero = self.field.zero
        if not value.generators() & {x, y}:
            return None
        in_x = self._linear(value, x) if x in value.generators() else (zero, value)
        if in_x is None or y in self.field.ingredients(in_x[0]):
            return None
        rest = in_x[1]
        in_y = self._linear(rest, y) if y in rest.generators() else (zero, rest)
        if in_y is None or {x, y} & self.field.ingredients(in_y[1]):
            return None
        return in_x[0], in_y[0], in_y[1]
