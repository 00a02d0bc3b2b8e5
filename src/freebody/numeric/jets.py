"""Numbers that carry their derivatives, and the geometry that statements of measures see through them.

A system stands at the pose q with the velocity v at the time t. A `Jet` follows one scalar f along the motion
that leaves there without acceleration, s -> (q + v s, t + s), and across it by its gradient:

    value     f(q, t)
    gradient  df/dq, one entry for each absolute coordinate (x, y, theta of every moving body; see `spatial` for space)
    rate      df/ds    = gradient . v + df/dt
    bias      d2f/ds2  = v . (Hess f) v + 2 v . d(gradient)/dt + d2f/dt2

so that with any accelerations a the second time derivative is  gradient . a + bias.  The chain rule closes:
phi(f) has the gradient phi' grad f, the rate phi' f' and the bias phi'' f'^2 + phi' f''.
Source: Griewank & Walther, Evaluating Derivatives, 2nd ed. 2008, ch. 3 and 13 (Taylor arithmetic).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, TypeAlias, cast

import numpy as np
from numpy.typing import NDArray

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, evaluate, free_symbols
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.geometry import NO_DIRECTION, Direction, Point, Pose, SpatialPose, Vector
from freebody.model.elements import Component, NonholonomicForm
from freebody.numeric import spatial
from freebody.numeric.rotation import matrix

Array = NDArray[np.float64]
Gradient: TypeAlias = "Array | Entries | None"
TIME = "t"
LARGE = 400  # more coordinates than this: gradients by their entries, and sparse matrices of them


class Entries:
    """A gradient of which few entries are not zero, by coordinate: what the jets of a large system carry."""

    __slots__ = ("of",)
    __array_ufunc__ = None  # numbers of NumPy leave the product to it

    def __init__(self, of: dict[int, float]) -> None:
        self.of = of

    def __add__(self, other: Entries) -> Entries:
        total = dict(self.of)
        for k, x in other.of.items():
            total[k] = total.get(k, 0.0) + x
        return Entries(total)

    def __sub__(self, other: Entries) -> Entries:
        total = dict(self.of)
        for k, x in other.of.items():
            total[k] = total.get(k, 0.0) - x
        return Entries(total)

    def __neg__(self) -> Entries:
        return Entries({k: -x for k, x in self.of.items()})

    def __rmul__(self, c: float) -> Entries:
        return Entries({k: c * x for k, x in self.of.items()})

    def row(self, n: int) -> Array:
        """All n entries."""
        found = np.zeros(n)
        found[list(self.of)] = list(self.of.values())
        return found


class Jet:
    """A value, its gradient (None: zero), and its first and second derivative along the motion."""

    __slots__ = ("bias", "gradient", "rate", "value")

    def __init__(self, value: float, gradient: Gradient = None, rate: float = 0.0, bias: float = 0.0) -> None:
        self.value = value
        self.gradient: Any = gradient
        self.rate = rate
        self.bias = bias

    def __repr__(self) -> str:
        return f"Jet({self.value}, {self.gradient}, {self.rate}, {self.bias})"

    @property
    def is_constant(self) -> bool:
        return self.gradient is None and self.rate == 0.0 and self.bias == 0.0

    def row(self, n: int) -> Array:
        """The gradient with n entries."""
        if isinstance(self.gradient, Entries):
            return self.gradient.row(n)
        return np.zeros(n) if self.gradient is None else self.gradient

    # -- arithmetic ---------------------------------------------------------------------------
    def __neg__(self) -> Jet:
        return self.scaled(-1.0)

    def __add__(self, other: Any, /) -> Jet:
        if not isinstance(other, Jet):
            return Jet(self.value + float(other), self.gradient, self.rate, self.bias)
        return Jet(
            self.value + other.value,
            _sum(self.gradient, other.gradient),
            self.rate + other.rate,
            self.bias + other.bias,
        )

    __radd__ = __add__

    def __sub__(self, other: Any, /) -> Jet:
        if not isinstance(other, Jet):
            return Jet(self.value - float(other), self.gradient, self.rate, self.bias)
        return Jet(
            self.value - other.value,
            _difference(self.gradient, other.gradient),
            self.rate - other.rate,
            self.bias - other.bias,
        )

    def __rsub__(self, other: Any, /) -> Jet:
        return -self + other

    def __mul__(self, other: Any, /) -> Jet:
        if not isinstance(other, Jet):
            return self.scaled(float(other))
        # constants as in `is_constant`, written out where it is asked most
        if other.gradient is None and other.rate == 0.0 and other.bias == 0.0:
            return self.scaled(other.value)
        if self.gradient is None and self.rate == 0.0 and self.bias == 0.0:
            return other.scaled(self.value)
        return Jet(
            self.value * other.value,
            _sum(_times(self.value, other.gradient), _times(other.value, self.gradient)),
            self.value * other.rate + other.value * self.rate,
            self.value * other.bias + 2.0 * self.rate * other.rate + other.value * self.bias,
        )

    __rmul__ = __mul__

    def __truediv__(self, other: Any, /) -> Jet:
        if not isinstance(other, Jet):
            return self.scaled(1.0 / float(other))
        return self * other._inverse()

    def __rtruediv__(self, other: Any, /) -> Jet:
        return self._inverse() * other

    def __pow__(self, other: Any, /) -> Jet:
        if isinstance(other, Jet):
            if not other.is_constant:
                return _call("exp", other * _call("log", self))
            other = other.value
        n, x = float(other), self.value
        if x < 0.0 and not n.is_integer():
            raise ValueError(f"{x} has no real power with a broken exponent")
        if self.is_constant:
            return Jet(x**n)
        return self.chain(x**n, _power(n, x, n - 1.0), _power(n * (n - 1.0), x, n - 2.0))

    def __rpow__(self, other: Any, /) -> Jet:
        return _call("exp", self * math.log(float(other)))

    def scaled(self, c: float) -> Jet:
        """c f with a number c."""
        if c == 1.0:
            return self
        if c == 0.0:
            return Jet(0.0)
        return Jet(c * self.value, _times(c, self.gradient), c * self.rate, c * self.bias)

    def chain(self, f: float, f1: float, f2: float) -> Jet:
        """phi(self) from the value and the first two derivatives of phi."""
        return Jet(f, _times(f1, self.gradient), f1 * self.rate, f2 * self.rate**2 + f1 * self.bias)

    def _inverse(self) -> Jet:
        y = 1.0 / self.value
        return self.chain(y, -y * y, 2.0 * y * y * y)


# of gradients, both of the same kind
def _sum(a: Any, b: Any) -> Any:
    if a is None:
        return b
    return a if b is None else a + b


def _difference(a: Any, b: Any) -> Any:
    if b is None:
        return a
    return -b if a is None else a - b


def _times(c: float, a: Any) -> Any:
    return None if a is None else c * a


def _power(c: float, x: float, n: float) -> float:
    """c x^n, and 0 for c = 0 even where x^n is not defined."""
    return 0.0 if c == 0.0 else c * x**n


# Functions --------------------------------------------------------------------------------------

# phi'(x) and phi''(x), from x and y = phi(x)
_SLOPES: Mapping[str, Callable[[float, float], tuple[float, float]]] = {
    "sqrt": lambda x, y: (0.5 / y, -0.25 / y**3),
    "sin": lambda x, y: (math.cos(x), -y),
    "cos": lambda x, y: (-math.sin(x), -y),
    "tan": lambda x, y: (1.0 + y * y, 2.0 * y * (1.0 + y * y)),
    "asin": lambda x, y: (1.0 / math.sqrt(1.0 - x * x), x / math.sqrt(1.0 - x * x) ** 3),
    "acos": lambda x, y: (-1.0 / math.sqrt(1.0 - x * x), -x / math.sqrt(1.0 - x * x) ** 3),
    "atan": lambda x, y: (1.0 / (1.0 + x * x), -2.0 * x / (1.0 + x * x) ** 2),
    "exp": lambda x, y: (y, y),
    "log": lambda x, y: (1.0 / x, -1.0 / (x * x)),
    "sinh": lambda x, y: (math.cosh(x), y),
    "cosh": lambda x, y: (math.sinh(x), y),
    "tanh": lambda x, y: (1.0 - y * y, -2.0 * y * (1.0 - y * y)),
}


def _call(name: str, x: Any) -> Any:
    value = float(x.value if isinstance(x, Jet) else x)
    y = cast("float", getattr(math, name)(value))
    if not isinstance(x, Jet):
        return y
    return Jet(y) if x.is_constant else x.chain(y, *_SLOPES[name](value, y))


def _abs(x: Any) -> Any:
    if not isinstance(x, Jet):
        return abs(x)
    if x.value == 0.0 and not x.is_constant:
        raise ValueError("abs has no slope at 0")
    return -x if x.value < 0.0 else x


def _sign(x: Any) -> float:
    value = float(x.value if isinstance(x, Jet) else x)
    return float((value > 0.0) - (value < 0.0))


def _function(name: str) -> Callable[[Any], Any]:
    return lambda x: _call(name, x)


# for `evaluate`: numbers stay plain floats, which all functions take as well
JET_FUNCTIONS: Mapping[str, Any] = {
    **{name: _function(name) for name in _SLOPES},
    "abs": _abs,
    "sign": _sign,
    "pi": math.pi,
    "number": float,
}


def arc_tangent(y: Jet, x: Jet) -> Jet:
    """atan2(y, x), the angle of the vector (x, y); its rate is (x y' - y x')/r^2."""
    r2 = x.value**2 + y.value**2
    cx, cy = -y.value / r2, x.value / r2
    rate = cx * x.rate + cy * y.rate
    stretch = (x.value * x.rate + y.value * y.rate) / r2
    return Jet(
        math.atan2(y.value, x.value),
        _sum(_times(cx, x.gradient), _times(cy, y.gradient)),
        rate,
        cx * x.bias + cy * y.bias - 2.0 * stretch * rate,
    )


# Geometry ---------------------------------------------------------------------------------------

Branch = tuple[int, int]  # which measure, and which of the angles in its statement


@dataclass(frozen=True)
class Frame:
    """What the geometry at every instant has in common: where the coordinates of a body stand in q, where
    the fixed bodies are, and the values of the parameters."""

    columns: Mapping[str, tuple[int, ...]]  # x, y and, if the body turns, theta
    fixed: Mapping[str, tuple[float, ...]]
    values: Mapping[str, float]
    space: bool = False  # x, y, z and, if the body turns, a rotation vector; see `spatial`
    principal: Mapping[str, Array] = field(default_factory=dict[str, Array])  # principal axes in body components
    _constants: dict[int, tuple[Expr, Jet]] = field(default_factory=dict[int, tuple[Expr, Jet]], repr=False)
    _seen: dict[int, tuple[object, int]] = field(default_factory=dict[int, tuple[object, int]], repr=False)
    _numbers: dict[object, int] = field(default_factory=dict[object, int], repr=False)
    # points and directions that stay as they are: of fixed bodies, with components that do not know the time
    lasting: dict[int, tuple[object, Vector[Jet]]] = field(
        default_factory=dict[int, tuple[object, Vector["Jet"]]], repr=False
    )

    @property
    def n(self) -> int:
        return sum(map(len, self.columns.values()))

    def only(self, bodies: Iterable[str]) -> tuple[Frame, list[int]]:
        """The frame of some of the bodies, without the others, and where their coordinates stand in q."""
        columns: dict[str, tuple[int, ...]] = {}
        own: list[int] = []
        for body in bodies:
            columns[body] = tuple(range(len(own), len(own) + len(self.columns[body])))
            own += self.columns[body]
        return replace(self, columns=columns), own

    def released(self, body: str) -> Frame:
        """The same frame in which a fixed body may move: its coordinates are the last three."""
        kept = {name: pose for name, pose in self.fixed.items() if name != body}
        own = tuple(range(self.n, self.n + (6 if self.space else 3)))
        return replace(self, columns={**self.columns, body: own}, fixed=kept, lasting={})

    def moved(self, q: Array, step: Array) -> Array:
        """The pose a small step from q, by the speeds' directions."""
        return spatial.moved(q, step, self.columns.values()) if self.space else q + step

    def difference(self, q: Array, q0: Array) -> Array:
        """The step that leads from q0 to q."""
        return spatial.difference(q, q0, self.columns.values()) if self.space else q - q0

    def slope(self, q: Array, v: Array) -> Array:
        """dq/dt of the speeds v."""
        return spatial.slope(q, v, self.columns.values()) if self.space else v

    def constant(self, expr: Expr) -> Jet | None:
        """Value of an expression in the parameters; None where time is in it."""
        known = self._constants.get(id(expr))
        if known is None:
            if TIME in free_symbols(expr):
                return None
            known = expr, Jet(float(evaluate(expr, self.values)))
            self._constants[id(expr)] = known
        return known[1]

    def number(self, measure: object) -> int:
        """The same number for equal measures."""
        known = self._seen.get(id(measure))
        if known is None:
            known = measure, self._numbers.setdefault(measure, len(self._numbers))
            self._seen[id(measure)] = known
        return known[1]


def entries_of(columns: Sequence[int], values: Array, n: int) -> Gradient:
    """A gradient of n entries with those of some coordinates."""
    if n > LARGE:
        return Entries(dict(zip(columns, values.tolist(), strict=True)))
    row = np.zeros(n)
    row[list(columns)] = values
    return row


class JetGeometry:
    """A `Geometry[Jet]` at the pose q with the velocity v at the time t.

    Angles of tangents are counted from the nearest of `near`, the angles of an earlier instant; those met
    here are in `angles`."""

    def __init__(self, frame: Frame, q: Array, v: Array, t: float, near: Mapping[Branch, float]) -> None:
        self.frame = frame
        self.time = Jet(t, None, 1.0, 0.0)
        self.angles: dict[Branch, float] = dict(near)
        self.q, self.v = q, v
        self.least = 0.0  # [m] a line must be longer than this to have a direction
        self._q, self._v = q.tolist(), v.tolist()
        n = len(self._q)
        self._unit_rows = None if n > LARGE else np.eye(n)
        self._poses: dict[str, Pose[Jet] | SpatialPose[Jet]] = {}
        self.memory: dict[int, tuple[object, Vector[Jet]]] = {}  # of points and directions
        self._measure, self._n_tangents = -1, 0
        self._known: dict[int, tuple[int, Jet]] = {}  # by number of a measure: how many angles of lines are in it

    def of(self, measure: Measure | NonholonomicForm | Component) -> Jet:
        """The jet of a measure. One that is only a rate has the value 0, and as gradient the coefficients of
        the velocities in it."""
        if isinstance(measure, NonholonomicForm):
            return self._of_rate(measure)
        number = self._measure = self.frame.number(measure)
        if number not in self._known:
            self._n_tangents = 0
            jet = measure.value(self)
            self._known[number] = self._n_tangents, jet
        self._n_tangents, jet = self._known[number]
        return jet

    def of_near(self, measure: Measure | NonholonomicForm, target: float) -> Jet:
        """The jet of a measure, its angles counted so that the value comes nearest to the target."""
        jet = self.of(measure)
        branches = [(self._measure, k) for k in range(self._n_tangents)]
        for turn in (math.tau, -math.tau):
            while branches and abs(jet.value - target) > math.pi:
                before = {branch: self.angles[branch] for branch in branches}
                self.angles |= {branch: angle + turn for branch, angle in before.items()}
                self._forget(measure)
                turned = self.of(measure)
                if abs(turned.value - target) >= abs(jet.value - target):
                    self.angles |= before
                    self._forget(measure)
                    break
                jet = turned
        return jet

    def _forget(self, measure: Measure | NonholonomicForm) -> None:
        """Its angles are counted otherwise from here on."""
        self._known.pop(self.frame.number(measure), None)

    def _of_rate(self, measure: NonholonomicForm) -> Jet:
        # d/dt (c m') = c m'' + c' m'
        total = Jet(0.0)
        for coefficient, term in measure.terms:
            c, m = self.of(coefficient), self.of(term)
            bias = c.value * m.bias + c.rate * m.rate
            total = total + Jet(0.0, _times(c.value, m.gradient), c.value * m.rate, bias)
        return total

    # -- what statements use ------------------------------------------------------------------
    def scalar(self, expr: Expr) -> Jet:
        known = self.frame.constant(expr)
        return self.apply(expr, {}) if known is None else known

    def apply(self, expr: Expr, values: dict[str, Jet]) -> Jet:
        names: dict[str, Any] = {**self.frame.values, TIME: self.time, **values}
        result = evaluate(expr, names, JET_FUNCTIONS)
        return result if isinstance(result, Jet) else Jet(float(result))

    def pose(self, body: str) -> Pose[Jet] | SpatialPose[Jet]:
        known = self._poses.get(body)
        if known is None:
            known = self._poses[body] = self._in_space(body) if self.frame.space else self._pose(body)
        return known

    def _unit_row(self, k: int) -> Gradient:
        return Entries({k: 1.0}) if self._unit_rows is None else self._unit_rows[k]

    def lasting(self, what: Point | Direction, made: Callable[[], Vector[Jet]]) -> Vector[Jet]:
        """Of a fixed body what was made at an earlier instant, unless time is in it."""
        if what.body not in self.frame.fixed:
            return made()
        known = self.frame.lasting.get(id(what))
        if known is None:
            known = what, made()
            own = what.offset if isinstance(what, Point) else what.components
            if all(self.frame.constant(expr) is not None for expr in own):
                self.frame.lasting[id(what)] = known
        return known[1]

    def root(self, x: Jet) -> Jet:
        if x.value <= self.least**2:
            raise CannotAnswer(NO_DIRECTION)
        return cast("Jet", _call("sqrt", x))

    def _in_space(self, body: str) -> SpatialPose[Jet]:
        columns, principal = self.frame.columns.get(body), self.frame.principal.get(body, spatial.UNIT)
        if columns is None:
            place = self.frame.fixed[body]
            axes = matrix(np.array(place[3:]))
            center = Vector(*(Jet(c) for c in place[:3]))
            x, y, z = (Vector(*(Jet(float(c)) for c in axes[:, j])) for j in range(3))
            return SpatialPose(center, (x, y, z))
        center = Vector(*(Jet(self._q[k], self._unit_row(k), self._v[k]) for k in columns[:3]))
        own = list(columns[3:])
        if not own:
            x, y, z = (Vector(*(Jet(float(c)) for c in row)) for row in spatial.UNIT)
            return SpatialPose(center, (x, y, z))
        R, omega = matrix(self.q[own]), np.array([self._v[k] for k in own])
        axes = [spatial.axis_jets(R, u, omega) for u in principal]  # rows: the body's axes along the principal ones
        vectors: list[Vector[Jet]] = []
        for value, slopes, rate, bias in axes:
            parts: list[Jet] = []
            for i in range(3):
                row = entries_of(own, slopes[i], len(self._q))
                parts.append(Jet(float(value[i]), row, float(rate[i]), float(bias[i])))
            vectors.append(Vector(*parts))
        x, y, z = vectors
        return SpatialPose(center, (x, y, z))

    def _pose(self, body: str) -> Pose[Jet]:
        columns = self.frame.columns.get(body)
        if columns is None:
            x, y, theta = self.frame.fixed[body]
            return Pose(Jet(x), Jet(y), Jet(theta), Jet(math.cos(theta)), Jet(math.sin(theta)))
        x, y, *turning = (Jet(self._q[k], self._unit_row(k), self._v[k]) for k in columns)
        if not turning:
            return Pose(x, y, Jet(0.0), Jet(1.0), Jet(0.0))
        theta = turning[0]
        c, s = math.cos(theta.value), math.sin(theta.value)
        return Pose(x, y, theta, theta.chain(c, -s, -c), theta.chain(s, c, -s))

    def tangent(self, v: Vector[Jet], offset: Jet) -> tuple[Jet, Jet]:
        # v = l e(a) + offset n(a):  l = sqrt(|v|^2 - offset^2),  a = atan2(v_y, v_x) - atan2(offset, l)
        distance2 = v.dot(v)
        square = distance2.value - offset.value**2
        if distance2.value <= self.least**2:
            raise CannotAnswer(NO_DIRECTION)
        if square <= 0.0:
            raise CannotAnswer(
                Message(
                    "the circles overlap: their centres are {apart:.6g} m apart, their "
                    "tangent needs more than {least:.6g} m",
                    apart=math.sqrt(distance2.value),
                    least=abs(offset.value),
                )
            )
        length = cast("Jet", _call("sqrt", distance2 - offset * offset))
        angle = arc_tangent(v.y, v.x)
        if offset.value != 0.0 or not offset.is_constant:
            angle = angle - arc_tangent(offset, length)
        branch = self._measure, self._n_tangents
        self._n_tangents += 1
        turns = round((self.angles.get(branch, angle.value) - angle.value) / math.tau)
        angle = angle + math.tau * turns
        self.angles[branch] = angle.value
        return length, angle
