"""Elements of the field as operations of a copy.

What hangs on parameters alone is summed first, so that it is computed once for a copy; what moves is nested by Horner's
scheme, the generator first that stands in most terms.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import SimpleNamespace
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, evaluate
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.numeric.engine.operations import ProgramNode
from freebody.numeric.ensemble.copies import CopyGraph
from freebody.numeric.kernels.operations import ARGUMENT, FUNCTIONS, SQRT
from freebody.symbolic.field import Field
from freebody.symbolic.polynomials import Terms
from freebody.symbolic.ratio import Ratio

Known = Callable[[], ProgramNode]
_Group = dict[tuple[tuple[int, int], ...], ProgramNode]  # coefficients by what moves


class NodesOfField(dict[int, ProgramNode]):
    """A node for each generator, made when it is first asked for. known: those that are not computed from others."""

    def __init__(self, field: Field, graph: CopyGraph, known: Mapping[int, Known]) -> None:
        super().__init__()
        self.field, self.graph, self._known = field, graph, dict(known)
        self.functions = _functions(graph)

    def add(self, known: Mapping[int, Known]) -> None:
        """More of those that are not computed from others."""
        self._known |= known

    def __missing__(self, index: int) -> ProgramNode:
        if index in self._known:
            node = self._known[index]()
        else:
            compute = self.field.generators[index].compute
            if compute is None:
                raise CannotAnswer(
                    Message(
                        "{x} has no value in the equations of motion",
                        x=to_text(self.field.generators[index].display),
                    )
                )
            node = self._node(compute(self, self.functions))
        self[index] = node
        return node

    def _node(self, x: Any) -> ProgramNode:
        return x if isinstance(x, ProgramNode) else self.graph.constant(float(x))

    def expression(self, expr: Expr, names: Mapping[str, ProgramNode]) -> ProgramNode:
        """An expression of named nodes."""
        return self._node(evaluate(expr, dict(names), vars(self.functions)))

    def of(self, x: Ratio) -> ProgramNode:
        """An element."""
        top, below = x.terms()
        node = self._polynomial(top)
        return node if x.den is None else node * (1.0 / self._polynomial(below))

    def _polynomial(self, terms: Terms) -> ProgramNode:
        groups: _Group = {}
        for monomial, coefficient in terms.items():
            still, moving = self.graph.constant(float(coefficient)), list[tuple[int, int]]()
            for index, exponent in monomial:
                if self.graph.moves(self[index].at):
                    moving.append((index, exponent))
                else:
                    still = still * self.graph.power(self[index], float(exponent))
            key = tuple(moving)
            groups[key] = groups[key] + still if key in groups else still
        return self._nested(groups)

    def _nested(self, groups: _Group) -> ProgramNode:
        """g (terms with g, by g) + the others."""
        counts: dict[int, int] = {}
        for monomial in groups:
            for index, _exponent in monomial:
                counts[index] = counts.get(index, 0) + 1
        if not counts:
            return groups.get((), self.graph.constant(0.0))
        most = max(counts, key=lambda index: (counts[index], -index))
        inside: _Group = {}
        others: _Group = {}
        for monomial, coefficient in groups.items():
            exponents = dict(monomial)
            if most not in exponents:
                others[monomial] = coefficient
                continue
            exponents[most] -= 1
            inside[tuple((k, e) for k, e in exponents.items() if e)] = coefficient
        product = self[most] * self._nested(inside)
        return product + self._nested(others) if others else product


def _functions(graph: CopyGraph) -> SimpleNamespace:
    """What generators and expressions are computed by."""

    def node(x: Any) -> ProgramNode:
        return x if isinstance(x, ProgramNode) else graph.constant(float(x))

    def function(op: int) -> Callable[[Any], ProgramNode]:
        return lambda x: graph.function(op, node(x))

    def angle(y: Any, x: Any) -> ProgramNode:
        return graph.node(ARGUMENT, node(x).at, node(y).at)

    known: dict[str, Any] = {name: function(SQRT + k) for k, name in enumerate(FUNCTIONS)}
    return SimpleNamespace(**known, atan2=angle, pi=3.141592653589793, number=float)
