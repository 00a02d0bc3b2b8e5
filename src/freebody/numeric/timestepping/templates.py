"""Templates: the places where outlines of two classes can touch, with symbols for their numbers.

They are read off the model's own elements of a pair of stand-ins: every gap is one measure, every slip a combination of
measures. Numbers of measures, coefficients and limits are linear in the symbols, so a matrix product fills them in for
many pairs at once.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody.connections.pairs import ContactSurface, OutlinePair
from freebody.errors import CannotAnswer
from freebody.language.expression import ONE, ZERO, Expr, Symbol, differentiate, evaluate, free_symbols, substitute
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.geometry import Direction, Point
from freebody.model.elements import DryFriction, UnilateralConstraint
from freebody.model.friction import Friction
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.kernels.candidates import N_SPANS, N_TERMS
from freebody.numeric.kernels.measures_planar import KINDS, MAX_BODIES, MAX_NUMBERS
from freebody.numeric.timestepping.shapes import FIRST, SECOND, OutlineShape

SURFACE = ("static", "kinetic", "restitution", "arm")
_BODIES = {FIRST: 0, SECOND: 1}
_GROUND = 2


@dataclass(frozen=True)
class TemplateSite:
    """One place where two outlines can touch, by places of measures in the template; -1: none."""

    gap: int
    sign: int
    slip: tuple[int, ...]
    slip_sign: int
    turn: int  # the angle that rolling resistance resists
    spans: tuple[int, ...]
    edge: int  # places on the same straight part have the same number; -1: not on one
    side: int  # whose edge it is: 0 the first outline's, 1 the second's


class Template:
    """The sites of two classes of outlines."""

    def __init__(self, first: OutlineShape, second: OutlineShape) -> None:
        self.symbols = [*first.columns(FIRST), *second.columns(SECOND)]
        self._place = {name: k for k, name in enumerate(self.symbols)}
        self.kinds: list[int] = []
        self._bodies: list[tuple[int, ...]] = []
        self._known: dict[Measure, int] = {}
        self._exprs: list[Expr] = []
        self._number_at: list[int] = []
        pair = OutlinePair(
            "", first.stand_in(FIRST), second.stand_in(SECOND), _surface(), starts_closed=False, is_alone=False
        )
        bounds, dry_friction = pair.elements()
        by_bound = {
            bound.name: [friction for friction in dry_friction if friction.of == bound.name] for bound in bounds
        }
        edges: dict[str, int] = {}
        self.slips: list[list[Expr]] = []
        self.targets: list[Expr] = []
        self.spans: list[list[tuple[Expr | None, Expr | None]]] = []
        self.sites = [self._site(bound, by_bound[bound.name], edges) for bound in bounds]
        self.n_edges = len(edges)
        self._prepare()

    # -- reading ------------------------------------------------------------------------------
    def _site(
        self, bound: UnilateralConstraint, dry_friction: list[DryFriction], edges: dict[str, int]
    ) -> TemplateSite:
        row = bound.row
        assert not isinstance(row.measure, Combination)
        assert row.target is not None
        slip, turn = (
            friction.row for friction in dry_friction
        )  # friction and rolling resistance, as `_surface` has both
        terms = _terms(slip.measure)
        self.slips.append([coefficient for coefficient, _m in terms])
        self.targets.append(row.target)
        self.spans.append([(span.low, span.high) for span in bound.within])
        on = row.ends[1]  # the part on which a round part lies
        is_edge = ".straight" in on
        return TemplateSite(
            self._measure(row.measure),  # pyrefly: ignore[bad-argument-type]
            row.sign,
            tuple(self._measure(m) for _c, m in terms),
            slip.sign,
            self._measure(turn.measure),  # pyrefly: ignore[bad-argument-type]
            tuple(self._measure(span.measure) for span in bound.within),
            edges.setdefault(on, len(edges)) if is_edge else -1,
            0 if on.startswith(FIRST) else 1,
        )

    def _measure(self, measure: Measure) -> int:
        """The place of an elementary measure, entered when it is first met; fields as in `Packing`."""
        if measure in self._known:
            return self._known[measure]
        name = type(measure).__name__
        bodies: dict[str, int] = {}
        numbers: list[Expr] = []
        for f in fields(measure):  # pyrefly: ignore[bad-argument-type]
            value: Any = getattr(measure, f.name)
            if isinstance(value, Point):
                bodies[f.name] = _BODIES.get(value.body, _GROUND)
                numbers += value.offset
            elif isinstance(value, Direction):
                bodies[f.name] = _BODIES.get(value.body, _GROUND)
                numbers += value.components
            elif isinstance(value, str):
                bodies[f.name] = _BODIES.get(value, _GROUND)
            else:
                numbers.append(value)
        on_ground = {field for field, body in bodies.items() if body == _GROUND}
        fit = [k for k, kind in enumerate(KINDS) if kind.name == name and set(kind.fixed) <= on_ground]
        if not fit:
            raise CannotAnswer(
                Message("time stepping has no kernel for the measure {name}; run tools/write_kernels.py", name=name)
            )
        self._known[measure] = len(self.kinds)
        self.kinds.append(fit[0])
        own = [body for field, body in bodies.items() if field not in KINDS[fit[0]].fixed]
        self._bodies.append((*own, *(_GROUND,) * (MAX_BODIES - len(own))))
        self._number_at.append(len(self._exprs))
        self._exprs += [*numbers, *(ZERO,) * (MAX_NUMBERS - len(numbers))]
        return self._known[measure]

    # -- numbers ------------------------------------------------------------------------------
    def _prepare(self) -> None:
        """The matrix that makes the numbers of many pairs: measures, coefficients, targets, lows, highs."""
        n = len(self.sites)
        exprs = [*self._exprs]
        for slip in self.slips:
            exprs += [*slip, *(ZERO,) * (N_TERMS - len(slip))]
        exprs += self.targets
        constants: list[float] = []
        for k, side in ((0, -math.inf), (1, math.inf)):
            for spans in self.spans:
                ends = [span[k] for span in spans] + [None] * (N_SPANS - len(spans))
                exprs += [ZERO if end is None else end for end in ends]
                constants += [side if end is None else 0.0 for end in ends]
        self._matrix = np.zeros((len(self.symbols), len(exprs)))
        self._constant = np.zeros(len(exprs))
        for k, expr in enumerate(exprs):
            self._enter(k, expr)
        self._constant[len(exprs) - len(constants) :] += constants
        self.measure_bodies = np.array(self._bodies, np.intp)
        cuts = np.cumsum([len(self._exprs), N_TERMS * n, n, N_SPANS * n])
        self._cuts = [int(c) for c in cuts]
        self.columns = SiteColumns.of(self.sites)

    def _enter(self, k: int, expr: Expr) -> None:
        for name in free_symbols(expr):
            slope = differentiate(expr, name)
            assert not free_symbols(slope), "the numbers of sites are linear in those of outlines"
            self._matrix[self._place[name], k] = float(evaluate(slope, {}))
        self._constant[k] = float(evaluate(substitute(expr, dict.fromkeys(free_symbols(expr), ZERO)), {}))

    def fill(self, first: Floats, second: Floats) -> tuple[Floats, Floats, Floats, Floats, Floats]:
        """For m pairs with the numbers of their outlines: numbers of measures (m, n_measures, MAX_NUMBERS),
        coefficients of slips (m, n_sites, N_TERMS), targets (m, n_sites), lows and highs (m, n_sites, N_SPANS)."""
        m, n = len(first), len(self.sites)
        given = np.hstack([first, second])
        given[~np.isfinite(given)] = 0.0  # the length of a line without ends is in no expression
        found = given @ self._matrix + self._constant
        numbers, slips, targets, lows, highs = np.split(found, self._cuts, axis=1)
        return (
            numbers.reshape(m, len(self.kinds), MAX_NUMBERS),
            slips.reshape(m, n, N_TERMS),
            targets,
            lows.reshape(m, n, N_SPANS),
            highs.reshape(m, n, N_SPANS),
        )


@dataclass(frozen=True)
class SiteColumns:
    """The sites of a template in arrays of integers; -1: none."""

    gap: NDArray[np.intp]
    sign: NDArray[np.intp]
    slip: NDArray[np.intp]  # (n, N_TERMS)
    slip_sign: NDArray[np.intp]
    turn: NDArray[np.intp]
    spans: NDArray[np.intp]  # (n, N_SPANS)
    edge: NDArray[np.intp]
    side: NDArray[np.intp]

    @classmethod
    def of(cls, sites: list[TemplateSite]) -> SiteColumns:
        def padded(rows: list[tuple[int, ...]], width: int) -> NDArray[np.intp]:
            return np.array([(*r, *(-1,) * (width - len(r))) for r in rows], np.intp).reshape(-1, width)

        def column(name: str) -> NDArray[np.intp]:
            return np.array([getattr(s, name) for s in sites], np.intp)

        return cls(
            column("gap"),
            column("sign"),
            padded([s.slip for s in sites], N_TERMS),
            column("slip_sign"),
            column("turn"),
            padded([s.spans for s in sites], N_SPANS),
            column("edge"),
            column("side"),
        )


def _surface() -> ContactSurface:
    static, kinetic, restitution, arm = (Symbol(f"surface.{name}") for name in SURFACE)
    return ContactSurface(Friction(static, kinetic), restitution, arm)


def _terms(measure: Any) -> list[tuple[Expr, Measure]]:
    return list(measure.terms) if isinstance(measure, Combination) else [(ONE, measure)]
