"""A law of the user's own: a named measure pushed by an expression."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from freebody.language.expression import Expr, free_symbols, replace_rates, substitute
from freebody.language.units import DIMENSIONLESS, FORCE, TIME, TORQUE, Dimension
from freebody.loads.base import Load
from freebody.measures.base import Measure
from freebody.model.elements import RATE, VALUE, Push
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names

Used = tuple[tuple[str, Measure], ...]


def law(names: Names, value: Any, dimension: Dimension, *path: str | int) -> tuple[Expr, Used]:
    """An expression in parameters, time `t`, named measures and their rates."""
    extra = {"t": TIME} | {n: m.dimension for n, m in names.measures.items()}
    expr = names.formula(value, dimension, *path, extra=extra)
    return expr, tuple((n, names.measures[n]) for n in sorted(free_symbols(expr) & set(names.measures)))


class Law(Load, kind="law"):
    """`law: {measure: stretch, force: -k*stretch^3}`: the force (or torque, for an angle) in the direction in
    which the measure grows, as an expression in measures, their rates (`rate(x)`) and time `t`."""

    measure: str | dict[str, Any]
    force: Formula

    stores_energy = True
    example = """
bodies: {ball: {particle: {mass: 1 kg}}}
measures: {x: x of ball}
parameters: {k: 5 N/m^3}
loads: {it: {law: {measure: x, force: -k*x^3}}}
"""

    def pushes(self, names: Names) -> list[Push]:
        measure = names.measure(self.measure, "measure")
        if measure is None:
            return []
        dimension = TORQUE if measure.dimension == DIMENSIONLESS else FORCE
        expr, used = law(names, self.force, dimension, "force")
        own = [name for name, other in used if other == measure]
        for name in own:  # the law of the measure itself, not of another one
            expr = substitute(replace_rates(expr, {name: RATE}), {name: VALUE})
        return [Push("", measure, expr, tuple(item for item in used if item[0] not in own))]
