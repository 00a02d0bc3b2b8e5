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
from collections.abc import Callable, Mapping
from typing import Any, TypeAlias, cast

import numpy as np
from numpy.typing import NDArray

from freebody.language.expression import FLOAT_FUNCTIONS

Array = NDArray[np.float64]
Gradient: TypeAlias = "Array | GradientEntries | None"
TIME = "t"
LARGE = 400  # more coordinates than this: gradients by their entries, and sparse matrices of them


class GradientEntries:
    """A gradient of which few entries are not zero, by coordinate: what the jets of a large system carry."""

    __slots__ = ("of",)
    __array_ufunc__: None = None  # numbers of NumPy leave the product to it

    def __init__(self, of: dict[int, float]) -> None:
        self.of = of

    def __add__(self, other: GradientEntries) -> GradientEntries:
        total = dict(self.of)
        for k, x in other.of.items():
            total[k] = total.get(k, 0.0) + x
        return GradientEntries(total)

    def __sub__(self, other: GradientEntries) -> GradientEntries:
        total = dict(self.of)
        for k, x in other.of.items():
            total[k] = total.get(k, 0.0) - x
        return GradientEntries(total)

    def __neg__(self) -> GradientEntries:
        return GradientEntries({k: -x for k, x in self.of.items()})

    def __rmul__(self, c: float) -> GradientEntries:
        return GradientEntries({k: c * x for k, x in self.of.items()})

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
        if isinstance(self.gradient, GradientEntries):
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
            _sum(times(self.value, other.gradient), times(other.value, self.gradient)),
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
                return function_of("exp", other * function_of("log", self))
            other = other.value
        n, x = float(other), self.value
        if x < 0.0 and not n.is_integer():
            raise ValueError(f"{x} has no real power with a broken exponent")
        if self.is_constant:
            return Jet(x**n)
        return self.chain(x**n, _power(n, x, n - 1.0), _power(n * (n - 1.0), x, n - 2.0))

    def __rpow__(self, other: Any, /) -> Jet:
        return function_of("exp", self * math.log(float(other)))

    def scaled(self, c: float) -> Jet:
        """c f with a number c."""
        if c == 1.0:
            return self
        if c == 0.0:
            return Jet(0.0)
        return Jet(c * self.value, times(c, self.gradient), c * self.rate, c * self.bias)

    def chain(self, f: float, f1: float, f2: float) -> Jet:
        """phi(self) from the value and the first two derivatives of phi."""
        return Jet(f, times(f1, self.gradient), f1 * self.rate, f2 * self.rate**2 + f1 * self.bias)

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


def times(c: float, a: Any) -> Any:
    """A gradient times a number."""
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
    "fresnel_c": lambda x, y: (math.cos(math.pi / 2 * x * x), -math.pi * x * math.sin(math.pi / 2 * x * x)),
    "fresnel_s": lambda x, y: (math.sin(math.pi / 2 * x * x), math.pi * x * math.cos(math.pi / 2 * x * x)),
}


def function_of(name: str, x: Any) -> Any:
    """A function by its name, of a jet or a number."""
    value = float(x.value if isinstance(x, Jet) else x)
    y = cast("float", FLOAT_FUNCTIONS[name](value))
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
    return lambda x: function_of(name, x)


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
        _sum(times(cx, x.gradient), times(cy, y.gradient)),
        rate,
        cx * x.bias + cy * y.bias - 2.0 * stretch * rate,
    )
