"""Drag: what a fluid resists a body by, in proportion to its speed (Stokes) or to the square of it (Newton).

    linear       F = -c v           quadratic       F = -k |v| v,    k = rho c_w A/2

Of a fall from rest with quadratic drag v = v_t tanh(g t/v_t), v_t^2 = m g/k; of what coasts v = v_0/(1 + k v_0 t/m).
Source: Beer, Johnston & Cornwell, Vector Mechanics for Engineers: Dynamics, sec. 12.1; Marion & Thornton, Classical
Dynamics of Particles and Systems, sec. 2.4.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.language.expression import Call, Expr, Symbol, multiply, negate
from freebody.language.sentences import Message
from freebody.language.units import DAMPING, FORCE, VELOCITY
from freebody.loads.base import Load
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import AXES, Point
from freebody.model import glyphs
from freebody.model.elements import RATE, AppliedLoad
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names

_QUADRATIC = FORCE / VELOCITY**2


class Drag(Load, kind="drag"):
    """`drag: {body: ball, linear: c}`: resists the velocity of the mass centre with c v; `quadratic: k`: with k v^2;
    both may be given. `body: boat.bow` is a point of a body. `along` a direction: only the motion along it is resisted,
    as of what slides on a track."""

    called: ClassVar[tuple[str, ...]] = ("air resistance", "resistance", "air drag", "air")
    also: ClassVar[tuple[str, ...]] = ("air_resistance", "air_drag")

    spread_over = "whole"

    body: str
    linear: Formula | None = None
    quadratic: Formula | None = None
    along: Heading | None = None

    pulling_sign = -1
    resists = True
    example = """
bodies: {ball: {particle: {mass: 1 kg}, velocity: [3 m/s, 4 m/s]}}
loads: {it: {drag: {body: ball, linear: 0.2 kg/s, quadratic: 0.1 kg/m}}}
"""

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        point = self._point(names)
        if self.linear is None and self.quadratic is None:
            names.problem(Message("give linear: c (force c v), quadratic: k (force k v^2), or both"))
            return []
        c = names.optional(self, "linear", DAMPING)
        k = names.optional(self, "quadratic", _QUADRATIC)
        origin = names.ground_origin
        if self.along is not None:
            along = Displacement(point, origin, names.direction(self.along, "along"))
            return [AppliedLoad("", along, _resisted(c, k, Call("abs", RATE)))]
        parts = {
            f"@{axis}": Displacement(point, origin, along)
            for axis, along in zip("xyz" if names.space else "xy", AXES, strict=False)
        }
        rates = [Call("rate", Symbol(name)) for name in parts]
        square: Expr = rates[0] * rates[0]
        for rate in rates[1:]:
            square = square + rate * rate
        used = () if k is None else tuple(parts.items())
        return [
            AppliedLoad(name[1:], part, _resisted(c, k, Call("sqrt", square)), used) for name, part in parts.items()
        ]

    def pulls_with(self, laws: Sequence[Any], sqrt: Callable[[Any], Any]) -> Any:
        """What resists: along its direction, else its size."""
        return super().pulls_with(laws, sqrt) if self.along is not None else sqrt(sum(x * x for x in laws))

    def _point(self, names: Names) -> Point:
        """A named point, or the mass centre."""
        return names.point(self.body, "body") if "." in self.body else names.body(self.body, "body").mass_center

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        # at rest it has no direction: what it does is written beside its point
        parts = [f"({given})*{of}" for given, of in ((self.linear, "v"), (self.quadratic, "v^2")) if given is not None]
        yield glyphs.Equation(self._point(names), f"drag = {' + '.join(parts)}")


def _resisted(c: Expr | None, k: Expr | None, speed: Expr) -> Expr:
    """-(c + k |v|) times a component of the velocity."""
    factor = c if k is None else multiply(k, speed) if c is None else c + multiply(k, speed)
    assert factor is not None
    return negate(multiply(factor, RATE))
