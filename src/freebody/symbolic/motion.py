"""Motion in closed form, for one degree of freedom or coordinates that move independently.

Three laws of motion are integrated:

    q'' = a                          q = q0 + u0 t + a t^2/2,           u^2 = u0^2 + 2 a (q - q0)
    q'' = a - w^2 (q - ...), linear  harmonic, exponential              (constant coefficients)
    d(M u^2/2 + V)/dt = 0            u^2 = (M0 u0^2 + 2 V0 - 2 V)/M     (first integral of energy)

Every root that solves an equation but not the problem is reported with the reason.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Symbol
from freebody.language.notation import Stated, compared, joined, reworded, to_python, to_text
from freebody.measures.geometry import Pose
from freebody.model.elements import RateMeasure
from freebody.model.question import Event
from freebody.symbolic.field import Ratio
from freebody.symbolic.functions import cos_sin, functions
from freebody.symbolic.geometry import AnyPose, FieldGeometry, straight_tangent
from freebody.symbolic.model import Coordinate, SymbolicModel
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy


@dataclass(frozen=True)
class StartState:
    """Start values of the coordinates and speeds, as elements, by generator."""

    values: dict[int, Ratio]

    def of(self, index: int) -> Ratio:
        return self.values[index]


@dataclass
class Reached:
    """An event in closed form: when, and the state there; `notes` name the rejected roots."""

    time: Ratio | None
    coordinate: Coordinate
    at: Ratio  # value of the coordinate
    speed: Ratio | None
    notes: list[str] = field(default_factory=list[str])
    conditions: list[Ratio] = field(default_factory=list[Ratio])  # must be positive
    why_no_time: str = ""


def start_state(model: SymbolicModel, known: dict[str, Expr], known_rates: dict[str, Expr]) -> StartState:
    """Start values from the named measures and the bodies' start poses; what nobody said starts at zero.
    Raises CannotAnswer where the coordinates follow from the pose only by solving loops."""
    values: dict[int, Ratio] = {}
    f = model.field
    scalar = model.geometry.scalar
    for c in model.coordinates:
        q = scalar(known[c.name]) if c.name in known else _start_of(model, c, known)
        values[c.index] = q
    values |= model.start_speeds(known_rates, values) or {}
    for c in sorted(model.coordinates, key=lambda c: c.name not in known_rates):
        if c.speed not in values:
            u = scalar(known_rates[c.name]) if c.name in known_rates else None
            values[c.speed] = u if u is not None else _start_speed(model, c, known_rates, values)
    for c in model.dependent:
        given = scalar(known[c.name]) if c.name in known else model.given_start(c)
        if given is None:
            given = model.recognised_start(c)
        if given is not None:
            values[c.index] = given
    values[f.index(f.time)] = f.zero
    return StartState(values)


def start_from_bodies(model: SymbolicModel) -> StartState:
    """Start values where the model gives a full pose and motion of every body: of the measure that a coordinate is, and
    of its gradient times the velocities. Raises CannotAnswer for a coordinate that is no measure."""
    if model.system.space:
        raise CannotAnswer("the start of a phase is put together from bodies in the plane only")
    f, scalar = model.field, model.geometry.scalar
    poses: dict[str, AnyPose] = {}
    velocities: dict[tuple[str, str], Ratio] = {}
    for body in model.system.moving:
        start = body.start
        assert start.at is not None
        assert start.velocity is not None
        point, (ax, ay) = start.at
        angle = f.zero if start.angle is None else scalar(start.angle)
        c, s = cos_sin(f, angle)
        rx, ry = (scalar(e) for e in body.points[point])
        poses[body.name] = Pose(scalar(ax) - (c * rx - s * ry), scalar(ay) - (s * rx + c * ry), angle, c, s)
        velocities[body.name, "x"], velocities[body.name, "y"] = (scalar(e) for e in start.velocity)
        velocities[body.name, "angle"] = f.zero if start.angular_velocity is None else scalar(start.angular_velocity)
    for name, pose in model.poses.items():
        poses.setdefault(name, pose)
    there = FieldGeometry(f, model.parameters, poses, straight_tangent(f, model.is_negative))
    values: dict[int, Ratio] = {f.index(f.time): f.zero}
    everything = (*model.coordinates, *model.dependent)
    measures = {c.index: model.measure_of(c) for c in everything}
    for c in everything:
        measure = measures[c.index]
        if measure is None:
            raise CannotAnswer(f"{c.name} is no measure of the model, so its value at the start is not known")
        values[c.index] = f.lowest_terms(measure.value(there))
    for c in everything:
        measure = measures[c.index]
        assert measure is not None
        speed = f.zero
        for slot, slope in model.gradient(measure).items():
            if slot in velocities:
                speed = speed + f.follow(slope, values) * velocities[slot]
        values[c.speed] = f.lowest_terms(speed)
    return StartState(values)


def _start_of(model: SymbolicModel, c: Coordinate, known: dict[str, Expr]) -> Ratio:
    """The start value of a coordinate from another named measure that is linear in it, or from the poses that
    the bodies were given; zero if nothing was said."""
    f = model.field
    for name, expr in known.items():
        value = model.value_of(model.system.measures[name])
        solved = _solve_linear(value - model.geometry.scalar(expr), c.index)
        if solved is not None and not (f.ingredients(solved) & {k.index for k in model.coordinates}):
            return solved
    given = model.given_start(c)
    if given is not None:
        return given
    numbers = model.start_numbers(c.index)
    if all(abs(v) < 1e-9 for v in numbers):
        return f.zero
    return model.start_parameter(c, numbers)


def _start_speed(model: SymbolicModel, c: Coordinate, known: dict[str, Expr], values: dict[int, Ratio]) -> Ratio:
    f = model.field
    for name, expr in known.items():
        rate = model.rate(model.value_of(model.system.measures[name]))
        rate = f.follow(rate, {k: v for k, v in values.items() if k != c.speed})
        solved = _solve_linear(rate - model.geometry.scalar(expr), c.speed)
        if solved is not None and not (f.ingredients(solved) & {k.speed for k in model.coordinates}):
            return solved
    given = model.given_start_speed(c, values)
    return f.zero if given is None else given


def _solve_linear(x: Ratio, index: int) -> Ratio | None:
    """The value of a generator that makes x vanish, if x is linear in it."""
    field = x.field
    if index not in x.generators() or index in x.denominator().generators():
        return None
    parts = x.numerator().coefficients(index)
    if len(parts) != 2 or any(index in field.ingredients(p) for p in parts):
        return None
    return -parts[0] / parts[1]


class Motion:
    """The closed-form motion of a model from its start."""

    def __init__(self, model: SymbolicModel, start: StartState) -> None:
        self.model = model
        self.start = start
        self.field = model.field
        f = functions(model.field, model.is_negative)
        self._sqrt, self._acos, self._asin, self._log = (f[n] for n in ("sqrt", "acos", "asin", "log"))

    # -- the event ----------------------------------------------------------------------------
    def reach(self, event: Event, *, need_time: bool = True) -> Reached:
        """The first time after the start at which a measure or its rate reaches a value."""
        value = self.model.value_of(event.measure)
        target = self.model.geometry.scalar(event.value)
        if event.order == 1:
            return self._reach_rate(self.model.rate(value), target)
        c = self._only_coordinate(value, event.text)
        at = self._value_of_coordinate(value - target, c, event)
        return self._reach_coordinate(c, at, need_time)

    def _only_coordinate(self, value: Ratio, text: str) -> Coordinate:
        present = self.field.ingredients(value)
        found = [c for c in self.model.coordinates if c.index in present]
        bound = [c for c in self.model.dependent if c.index in present]
        if len(found) != 1 or bound:
            raise CannotAnswer(
                f"'{text}' involves {len(found) + len(bound)} coordinates"
                f" ({', '.join(c.name for c in (*found, *bound)) or 'none'}); there is a closed form for one only"
            )
        return found[0]

    def _value_of_coordinate(self, difference: Ratio, c: Coordinate, event: Event) -> Ratio:
        solved = _solve_linear(difference, c.index)
        if solved is None:
            raise CannotAnswer(
                f"'{event.text}' is not linear in the coordinate {c.name}; name a measure that is, or ask for "
                f"the value of {c.name}"
            )
        return solved

    # -- laws of motion -----------------------------------------------------------------------
    def _acceleration(self, c: Coordinate) -> Ratio:
        k = self.model.coordinates.index(c)
        return self.model.solved_accelerations[self.model.accelerations[k]]

    def _reach_coordinate(self, c: Coordinate, at: Ratio, need_time: bool) -> Reached:
        a = self.field.lowest_terms(self._acceleration(c))
        q0, u0 = self.start.of(c.index), self.start.of(c.speed)
        if a.is_constant():
            return self._uniform(c, a, q0, u0, at)
        linear = self._linear_law(a, c)
        if linear is not None:
            reached = self._linear_motion(c, linear, q0, u0, at)
            if reached is not None:
                return reached
        speed = self._speed_from_energy(c, at)
        return Reached(
            None,
            c,
            at,
            speed,
            why_no_time=f"the time is the integral of d{c.name}/speed, which has no elementary closed form here; "
            "simulate the motion for a number",
        )

    def _uniform(self, c: Coordinate, a: Ratio, q0: Ratio, u0: Ratio, at: Ratio) -> Reached:
        distance = at - q0
        notes: list[str] = []
        if a.is_zero():
            if u0.is_zero():
                raise CannotAnswer(f"{c.name} does not move: it starts at rest and nothing accelerates it")
            return Reached(distance / u0, c, at, u0, conditions=[distance / u0])
        square = u0 * u0 + 2 * a * distance
        # at rest at the start, t = sqrt(2 d/a) reads better than sqrt(2 a d)/a
        if u0.is_zero():
            time = self._sqrt(2 * distance / a)
            speed = a * time
            notes.append("the root with the negative sign is a time before the start and is rejected")
            return Reached(time, c, at, speed, notes, [distance / a])
        root = self._sqrt(square)
        plus, minus = (-u0 + root) / a, (-u0 - root) / a
        values = zip(self.model.at_samples(plus), self.model.at_samples(minus), strict=True)
        # samples where the place is out of reach have no root at all
        picks = {self._first_positive(p, m) for p, m in values if not math.isnan(p)} or {None}
        if len(picks) != 1:
            raise CannotAnswer(
                f"which root is the first time at which {c.name} is reached depends on the parameter values"
            )
        pick = picks.pop()
        if pick is None:
            raise CannotAnswer(f"{c.name} never reaches {to_text(tidy(at))} after the start at these parameter values")
        chosen, other = (plus, minus) if pick == 0 else (minus, plus)
        speed = root if pick == 0 else -root
        other_values = self.model.at_samples(other)
        shown = to_text(tidy(other))
        if all(v < 0 for v in other_values):
            words = f"rejected root: t = {shown} is negative, a time before the start"
        else:
            words = f"other root: t = {shown} is later, when {c.name} passes again on the way back"
        notes.append(Stated(words, to_python(tidy(other))))
        # the product of the roots is -2 d/a: opposite signs need d/a > 0
        conditions = [square]
        if sign_of(distance / a) is not Sign.POSITIVE:
            conditions.append(chosen)
        return Reached(chosen, c, at, speed, notes, conditions)

    @staticmethod
    def _first_positive(plus: float, minus: float) -> int | None:
        good = [(t, k) for k, t in enumerate((plus, minus)) if t > 0]
        return min(good)[1] if good else None

    def _linear_law(self, a: Ratio, c: Coordinate) -> tuple[Ratio, Ratio, Ratio] | None:
        """(alpha, beta, gamma) with a = alpha + beta q + gamma u, constant coefficients."""
        present = self.field.ingredients(a)
        others = {k.index for k in self.model.coordinates} | {k.speed for k in self.model.coordinates}
        others |= {self.field.index(self.field.time)}
        if present & (others - {c.index, c.speed}) or a.denominator().generators() & {c.index, c.speed}:
            return None
        zero = self.field.zero
        beta, gamma = self.field.partial(a, c.index), self.field.partial(a, c.speed)
        alpha = a - beta * self.field.variable(c.index) - gamma * self.field.variable(c.speed)
        if all(x.is_constant() for x in (alpha, beta, gamma)):
            return alpha + zero, beta, gamma
        return None

    def _linear_motion(
        self, c: Coordinate, law: tuple[Ratio, Ratio, Ratio], q0: Ratio, u0: Ratio, at: Ratio
    ) -> Reached | None:
        alpha, beta, gamma = law
        if not gamma.is_zero() or beta.is_zero():
            return None
        center = -alpha / beta
        sign = sign_of(beta)
        x0, x = q0 - center, at - center
        if sign is Sign.NEGATIVE:
            w = self._sqrt(-beta)
            speed = self._with_sign(u0 * u0 + beta * (x * x - x0 * x0), c, at)
            if u0.is_zero() and not x0.is_zero():
                return Reached(self._acos(x / x0) / w, c, at, speed, conditions=[1 - (x / x0) ** 2])
            if x0.is_zero() and not u0.is_zero():
                return Reached(self._asin(w * x / u0) / w, c, at, speed, conditions=[1 - (w * x / u0) ** 2])
            return None
        if sign is Sign.POSITIVE and u0.is_zero() and not x0.is_zero():
            # x = x0 cosh(k t)
            k, ratio = self._sqrt(beta), x / x0
            time = self._log(ratio + self._sqrt(ratio * ratio - 1)) / k
            speed = self._with_sign(beta * (x * x - x0 * x0), c, at)
            return Reached(time, c, at, speed, conditions=[ratio - 1])
        return None

    def _reach_rate(self, rate: Ratio, target: Ratio) -> Reached:
        speeds = [c for c in self.model.coordinates if c.speed in rate.generators()]
        if len(speeds) != 1 or self.field.ingredients(rate) & {c.index for c in self.model.coordinates}:
            raise CannotAnswer("the rate depends on several coordinates; there is a closed form for one only")
        (c,) = speeds
        wanted = _solve_linear(rate - target, c.speed)
        assert wanted is not None
        a = self.field.lowest_terms(self._acceleration(c))
        q0, u0 = self.start.of(c.index), self.start.of(c.speed)
        if a.is_constant():
            if a.is_zero():
                raise CannotAnswer(f"the rate of {c.name} is constant")
            time = (wanted - u0) / a
            at = q0 + (wanted * wanted - u0 * u0) / (2 * a)
            return Reached(time, c, at, wanted, conditions=[time])
        linear = self._linear_law(a, c)
        if linear is not None and linear[1].is_zero():
            # u' = alpha + gamma u
            alpha, _beta, gamma = linear
            ratio = (alpha + gamma * wanted) / (alpha + gamma * u0)
            time = self._log(ratio) / gamma
            at = q0 + (wanted - u0 - alpha * time) / gamma
            return Reached(time, c, at, wanted, conditions=[time])
        raise CannotAnswer(f"the law of motion of {c.name} has no elementary closed form; simulate for a number")

    # -- first integral -----------------------------------------------------------------------
    def _speed_from_energy(self, c: Coordinate, at: Ratio) -> Ratio:
        """u at q = at from M u^2/2 + V = const, with the sign of the way there."""
        return self._with_sign(self.speed_squared(c, at), c, at)

    def _with_sign(self, square: Ratio, c: Coordinate, at: Ratio) -> Ratio:
        root = self._sqrt(square)
        ways = {v > 0 for v in self.model.at_samples(at - self.start.of(c.index))}
        if len(ways) > 1:
            raise CannotAnswer(f"whether {c.name} grows or shrinks on the way depends on the parameter values")
        return root if not ways or ways.pop() else -root

    def speed_squared(self, c: Coordinate, at: Ratio) -> Ratio:
        """u^2 at q = at."""
        if self.model.degrees_of_freedom != 1:
            raise CannotAnswer(
                f"there are {self.model.degrees_of_freedom} degrees of freedom; energy alone gives the speed of one"
            )
        if self.model.dependent:
            names = ", ".join(d.name for d in self.model.dependent)
            raise CannotAnswer(f"{names} follow from {c.name} only through the closed loop")
        values = {c.index: at}
        M, M0 = (self.field.follow(self.model.mass_matrix[0][0], v) for v in (values, self.start.values))
        V, V0 = (self._potential(v) for v in (values, self.start.values))
        u0 = self.start.of(c.speed)
        return (M0 * u0 * u0 + 2 * (V0 - V)) / M

    def _potential(self, values: dict[int, Ratio]) -> Ratio:
        """Minus the work function of all loads; each must be a function of its own measure."""
        state = SymbolicState(self.model, values)
        if any(
            isinstance(row.measure, RateMeasure)
            or row.general is not None
            or (row.target is not None and _moves(row.target))
            for row in self.model.system.held
        ):
            raise CannotAnswer("a driver or a velocity constraint is at work, so energy is no first integral")
        total = self.field.zero
        for push in self.model.system.pushes:
            total = total + state.potential(push)
        return total


def _moves(target: Expr) -> bool:
    from freebody.language.expression import free_symbols

    return "t" in free_symbols(target)


# -- small oscillations -----------------------------------------------------------------------
@dataclass(frozen=True)
class Small:
    """Small oscillations about an equilibrium: squared angular frequencies and the equilibrium values."""

    squares: tuple[Ratio, ...]
    equilibrium: dict[int, Ratio]
    notes: tuple[str, ...] = ()


def small_oscillations(model: SymbolicModel, start: StartState) -> Small:
    """M x'' + K x = 0 about the equilibrium that is stable (else nearest to the start); roots of
    det(K - s M) = 0, in closed form where its factors are linear or quadratic."""
    if model.dependent:
        names = ", ".join(c.name for c in model.dependent)
        raise CannotAnswer(f"{names} follow only through a closed loop; there is no closed form of the frequencies")
    equilibrium, notes = find_equilibrium(model, start)
    M, K = linearised(model, equilibrium)
    n = len(M)
    s = model.field.parameter("@s")
    determinant = _determinant([[K[j][k] - s * M[j][k] for k in range(n)] for j in range(n)])
    roots: list[Ratio] = []
    index = model.field.index(s)
    _unit, factors = model.field.factor(determinant.num)
    for base, exponent in factors:
        if index in base.generators():
            roots += _polynomial_roots(model, base.coefficients(index)) * exponent
    ordered = sorted(roots, key=lambda r: (model.at_samples(r) or [0.0])[0])
    return Small(tuple(ordered), equilibrium, tuple(notes))


def linearised(model: SymbolicModel, at: dict[int, Ratio]) -> tuple[list[list[Ratio]], list[list[Ratio]]]:
    """Mass and stiffness matrices at an equilibrium: K = -dF/dq."""
    f = model.field
    n = len(model.coordinates)
    still = at | {c.speed: f.zero for c in model.coordinates}
    M = [[f.follow(model.mass_matrix[j][k], still) for k in range(n)] for j in range(n)]
    K = [[-f.follow(f.derivative(model.forcing[j], c.index), still) for c in model.coordinates] for j in range(n)]
    return M, K


def _determinant(A: list[list[Ratio]]) -> Ratio:
    """Laplace expansion; systems here are small."""
    if len(A) == 1:
        return A[0][0]
    if len(A) > 6:
        raise CannotAnswer("more than six degrees of freedom; ask for numbers")
    total = A[0][0].field.zero
    for k, entry in enumerate(A[0]):
        if not entry.is_zero():
            minor = [row[:k] + row[k + 1 :] for row in A[1:]]
            total = total + (-1) ** k * entry * _determinant(minor)
    return total


def _polynomial_roots(model: SymbolicModel, c: list[Ratio]) -> list[Ratio]:
    if len(c) == 2:
        return [-c[0] / c[1]]
    if len(c) == 3:
        root = model.field.sqrt(c[1] * c[1] - 4 * c[0] * c[2], model.is_negative)
        return [(-c[1] - root) / (2 * c[2]), (-c[1] + root) / (2 * c[2])]
    raise CannotAnswer(
        f"the frequencies are roots of a polynomial of degree {len(c) - 1} in the squared frequency, which does not "
        "factor; ask for numbers"
    )


def find_equilibrium(
    model: SymbolicModel, start: StartState, *, stable_first: bool = True
) -> tuple[dict[int, Ratio], list[str]]:
    """Coordinates at which the forcing vanishes at rest. Tries the start, then solves factor by factor for one
    coordinate at a time."""
    f = model.field
    rest = {c.speed: f.zero for c in model.coordinates} | {f.index(f.time): f.zero}
    forces = [f.follow(F, rest) for F in model.forcing]
    at_start = {c.index: start.of(c.index) for c in model.coordinates}
    if all(model.vanishes(f.follow(F, at_start)) for F in forces):
        if _is_stable(model, at_start):
            return at_start, []
        if not stable_first:
            return at_start, ["this equilibrium is not stable"]
    solutions = [s for s in _zeros(model, forces, list(model.coordinates)) if _is_held(model, s)]
    if not solutions:
        raise CannotAnswer("no equilibrium could be found in closed form; start the model at one")
    stable = [s for s in solutions if _is_stable(model, s)]
    chosen = min(stable or solutions, key=lambda s: _distance(model, s, at_start))
    shown = joined((compared(Symbol(c.name), "=", tidy(chosen[c.index])) for c in model.coordinates), ", ")
    notes = [reworded(f"about the equilibrium {shown}", shown)]
    if not stable:
        notes.append("this equilibrium is not stable")
    return chosen, notes


def _is_held(model: SymbolicModel, at: dict[int, Ratio]) -> bool:
    """At rest there, no contact pulls and no string pushes, at any sample."""
    state = SymbolicState(model, at | {c.speed: model.field.zero for c in model.coordinates})
    for row in model.system.held:
        if row.unilateral:
            try:
                force = row.sign * state.multiplier(row)
            except CannotAnswer:
                continue
            if any(v < -1e-9 for v in model.at_samples(force)):
                return False
    return True


def _distance(model: SymbolicModel, a: dict[int, Ratio], b: dict[int, Ratio]) -> float:
    total = 0.0
    for k, value in a.items():
        values = model.at_samples(value - b[k])
        total += abs(values[0]) if values else 0.0
    return total


def _is_stable(model: SymbolicModel, at: dict[int, Ratio]) -> bool:
    """All leading minors of K positive: formally, else at the samples."""
    _M, K = linearised(model, at)
    for n in range(1, len(K) + 1):
        minor = _determinant([row[:n] for row in K[:n]])
        sign = sign_of(minor)
        if sign in (Sign.NEGATIVE, Sign.NONPOSITIVE):
            return False
        if sign is not Sign.POSITIVE and not all(v > 0 for v in model.at_samples(minor)):
            return False
    return True


def _zeros(model: SymbolicModel, forces: list[Ratio], left: list[Coordinate]) -> list[dict[int, Ratio]]:
    """All common zeros found by solving for one coordinate after the other."""
    if not left:
        return [{}] if all(model.vanishes(F) for F in forces) else []
    found: list[dict[int, Ratio]] = []
    for F in forces:
        present = model.field.ingredients(F)
        candidates = [c for c in left if c.index in present]
        if F.is_zero() or not candidates:
            continue
        for c in candidates:
            for value in zeros_of(model, F, c):
                rest = [model.field.follow(G, {c.index: value}) for G in forces]
                for more in _zeros(model, rest, [k for k in left if k is not c]):
                    value_now = model.field.follow(value, more)
                    found.append({c.index: value_now, **more})
            if found:
                return found
    if not found and all(F.is_zero() for F in forces):
        return [{c.index: model.field.zero for c in left}]  # indifferent: anywhere
    return found


def zeros_of(model: SymbolicModel, F: Ratio, c: Coordinate) -> list[Ratio]:
    """Zeros of F in one coordinate: linear factors, and a cos + b sin + r = 0."""
    f = model.field
    found: list[Ratio] = []
    _unit, factors = f.factor(F.num)
    for base, _exponent in factors:
        if c.index not in f.ingredients(base):
            continue
        linear = _solve_linear(base, c.index)
        if linear is not None:
            found.append(linear)
            continue
        found += _trigonometric_zeros(model, base, c)
    return found


def _trigonometric_zeros(model: SymbolicModel, base: Ratio, c: Coordinate) -> list[Ratio]:
    """a cos(q) + b sin(q) + r = 0 with r = 0, or one of a, b zero."""
    f = model.field
    pairs = [p for p in f.pairs(base.generators()) if f.generators[p[0]].made_of == frozenset({c.index})]
    if len(pairs) != 1 or c.index in base.generators():
        return []
    cos, sin = pairs[0]
    if f.variable(cos) != functions(f)["cos"](f.variable(c.index)):
        return []
    in_cos = base.coefficients(cos)
    if len(in_cos) > 2:
        return []
    a = in_cos[1] if len(in_cos) == 2 else f.zero
    in_sin = in_cos[0].coefficients(sin)
    if len(in_sin) > 2 or {cos, sin} & a.generators():
        return []
    b, r = (in_sin[1] if len(in_sin) == 2 else f.zero), in_sin[0]
    pi, fn = f.pi, functions(f, model.is_negative)
    if r.is_zero():
        if a.is_zero():
            return [f.zero, pi]
        if b.is_zero():
            return [pi / 2, -pi / 2]
        angle = fn["atan"](-a / b)
        return [angle, angle + pi]
    if b.is_zero():
        angle = fn["acos"](-r / a)
        return [angle, -angle]
    if a.is_zero():
        angle = fn["asin"](-r / b)
        return [angle, pi - angle]
    # (r - a) T^2 + 2 b T + r + a = 0 with T = tan(q/2)
    if (r - a).is_zero():
        return [2 * fn["atan"](-a / b), pi]
    root = fn["sqrt"](a * a + b * b - r * r)
    return [2 * fn["atan"]((-b - root) / (r - a)), 2 * fn["atan"]((-b + root) / (r - a))]
