"""The phases of a system as plain values: a case distinction, each case a sequence of phases."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path as FilePath
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import Call, Expr, Symbol, add, free_symbols, replace_rates, substitute
from freebody.language.notation import stated_plain
from freebody.language.sentences import Message, in_turn, listed
from freebody.language.units import TIME
from freebody.model.elements import ConstraintRow
from freebody.present.lines import system_line
from freebody.present.report.blocks import Block, Report, Section
from freebody.present.report.result import Result
from freebody.present.report.results import entries, line, notes, summary
from freebody.study.phases.case import PhaseCase, PhaseResult
from freebody.study.phases.nodes import PhaseEnd, PhaseImpact, PhaseNode
from freebody.study.phases.numbers import Chosen, coefficients_of_friction
from freebody.study.phases.phase import Phase
from freebody.study.phases.quantities import reaction
from freebody.study.phases.regions import RegionCase, Regions, regions
from freebody.study.phases.told import phase_section
from freebody.study.phases.tree import PhaseTree, tree_of
from freebody.study.phases.words import action, happening, label, states
from freebody.study.worded import in_words
from freebody.symbolic.conditions import Condition, relation_text, require, with_purposes
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.phases.course import ClosedFormMotion, MotionInTime, UniformMotion
from freebody.symbolic.phases.energy_motion import EnergyMotion
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.relations import SolvedRelation, generators_of, readable, simplified
from freebody.symbolic.state import SymbolicState
from freebody.system.system import System


@dataclass(frozen=True)
class Phases(Result):
    """All cases; that of the model's own values first."""

    system: System
    cases: tuple[PhaseCase, ...]
    n_sets: int
    reasons: tuple[str, ...]  # modes that could not be looked at, and why
    between: tuple[str, ...]  # equations on which nothing slips at the start, between cases
    missing: str  # why there is no case at some parameter sets; empty where there is one at all
    tree: PhaseTree = field(compare=False, repr=False)

    def to_plain(self) -> dict[str, Any]:
        return {
            "cases": [c.to_plain() for c in self.cases],
            "parameter_sets": self.n_sets,
            "left_out": list(self.reasons),
            "between": list(map(stated_plain, self.between)),
            "missing": self.missing or None,
        }

    @property
    def is_complete(self) -> bool:
        return not self.missing

    @property
    def report(self) -> Report:
        return summary(self.system.title, self._blocks())

    def _blocks(self) -> Iterator[Block]:
        yield line(system_line(self.system, None))
        yield from (line(Message("assumed: {text}", text=text)) for text in self.system.assumptions)
        yield self.section
        yield from entries(*notes(self.reasons, Message("left out")))

    @property
    def section(self) -> Section:
        """What is said of the phases in the report of a solution."""
        return phase_section(self.cases, self.missing, self.between)

    @property
    def first_model(self) -> SymbolicModel:
        """Of the phase in which the motion begins at the model's own values."""
        return self.tree.roots[0].phase.model if self.tree.roots else self.tree.home.model

    def regions(self, x: str, y: str, n: int = 120) -> Regions:
        """Which case holds where in the plane of two parameters, the others at the model's values."""
        cases = [RegionCase(c.what, c.conditions, tuple(c.relations)) for c in self.cases]
        return regions(self.tree, cases, x, y, n)

    def plot(self, x: str, y: str, path: str | FilePath | None = None, n: int = 240) -> Any:
        """A figure of the regions of the cases over two parameters; saved if a path is given. n: points each way."""
        from freebody.present.plots import save
        from freebody.present.region_picture import region_picture

        r = self.regions(x, y, n)
        cases = [f"{case}: {where}" for case, where in zip(r.cases, r.conditions, strict=True)]
        figure = region_picture(r.x, r.y, r.index, cases, r.labels)
        if path is not None:
            save(figure, path)
        return figure


@in_words
def phases(system: System) -> Phases:
    """The phases of a system with contacts or dry friction, in closed form. Raises CannotAnswer where it has none."""
    return phases_of(tree_of(system))


@lru_cache(maxsize=4)
def phases_of(tree: PhaseTree) -> Phases:
    """The cases of a tree, path by path; kept as long as trees are, as every question asks for them."""
    ends = (tree.system.bounds, tree.system.dry_friction, tree.closed, tree.system.blows, tree.system.borders)
    if not any(ends):
        raise CannotAnswer(Message("the system has no contact, no stop and no dry friction: its motion has one phase"))
    told: dict[tuple[int, ...], PhaseResult] = {}  # ways share their first phases
    cases = [_case(tree, path, told) for path in paths(tree.roots)]
    cases.sort(key=lambda case: not case.is_own)
    between = tuple(_equation(x) for x in tree.boundaries)
    reasons = tuple(dict.fromkeys(tree.reasons))
    return Phases(tree.system, tuple(cases), tree.sets.n, reasons, between, _missing(tree, reasons), tree)


def _missing(tree: PhaseTree, reasons: Sequence[str]) -> str:
    """Why no case was found at some parameter sets."""
    covered = np.concatenate([tree.indices[:0], *(_sets(path) for path in paths(tree.roots))])
    if tree.sets.left_out[np.setdiff1d(tree.indices, covered)].all():
        return ""
    if (lost := dict.fromkeys(tree.lost.values())) and len(lost) == 1:
        return next(iter(lost))
    return reasons[-1] if reasons else Message("no state of the contacts was found that is consistent with the start")


def _sets(path: Path) -> Chosen:
    node, edge = path[-1]
    return node.sets if edge is None else edge.sets


def _equation(x: Ratio) -> str:
    """x = 0 with the factors that are not zero left out."""
    condition, _possible = require(x, "!=")
    element = x.numerator() if condition is None else condition.element
    return relation_text(readable(element), "=")


Path = list[tuple[PhaseNode, PhaseEnd | None]]


def paths(nodes: list[PhaseNode]) -> list[Path]:
    """All ways through the tree."""
    found: list[Path] = []
    for node in nodes:
        if not node.edges:
            found.append([(node, None)])
        for edge in node.edges:
            if not edge.nodes:
                found.append([(node, edge)])
            found += [[(node, edge), *rest] for rest in paths(edge.nodes)]
    return found


def path_conditions(tree: PhaseTree, path: Path) -> list[Condition]:
    """All that makes a path the one that happens."""
    found = list(tree.assumed)
    for node, edge in path:
        found += node.conditions + (edge.conditions if edge is not None else [])
    return found


def relations(tree: PhaseTree, conditions: list[Condition]) -> list[SolvedRelation]:
    """Conditions solved for times, as that until which something lasts, and for the coefficients of friction."""
    model, system = tree.home.model, tree.system
    times = [name for name, known in system.parameters.items() if known.dimension == TIME]
    unknowns = generators_of(model.field, (*times, *coefficients_of_friction(system)), model.parameters)
    return simplified(conditions, unknowns)


def _case(tree: PhaseTree, path: Path, told: dict[tuple[int, ...], PhaseResult]) -> PhaseCase:
    found = relations(tree, path_conditions(tree, path))
    sets = _sets(path)
    shown: list[PhaseResult] = []
    for k, (node, edge) in enumerate(path):
        following = path[k + 1][0] if k + 1 < len(path) else None
        key = id(node), id(edge), id(following)
        if key not in told:
            told[key] = _phase(tree, node, edge, following)
        shown.append(told[key])
    is_own = tree.system.has_values and 0 in sets
    texts = tuple(r.text() for r in found)
    is_exact = all(n.is_exact and (e is None or e.is_exact) for n, e in path)
    return PhaseCase(_title(shown), texts, tuple(shown), is_own, len(sets), is_exact, tuple(found))


def _title(shown: Sequence[PhaseResult]) -> str:
    """slides, then rolls"""
    words: list[str] = []
    for k, phase in enumerate(shown):
        word = phase.what
        if phase.begins == "blow" and k and word == shown[k - 1].what:
            word = Message("{does} on", does=word)
        elif phase.begins == "impact":
            word = Message("rebounds") if word == "flies" else Message("{does} after the impact", does=word)
        elif word == "slides" and k and shown[k - 1].what == "slides":
            word = Message("slides back")
        words.append(word)
    return in_turn(words, "{first}, then {second}")


def _phase(tree: PhaseTree, node: PhaseNode, edge: PhaseEnd | None, following: PhaseNode | None) -> PhaseResult:
    phase = node.phase
    texts = tuple(_with_purpose(r) for r in relations(tree, node.conditions))
    equations, motion = _motion(tree, phase)
    event, duration, place, why = "", None, None, node.reason
    happens: tuple[str, ...] = ()
    if edge is not None:
        why = edge.stops or why
        happens = tuple(r.text() for r in relations(tree, edge.conditions))
        if edge.first is not None and edge.watch is not None:
            event = happening(edge.watch, None if following is None else following.phase)
            duration = None if edge.time is None else readable(edge.time)
            if edge.first.zero.at is not None and isinstance(phase.course, EnergyMotion):
                c = phase.course.coordinate
                place = Symbol(c.name), readable(edge.first.zero.at)
    return PhaseResult(
        action(phase),
        states(phase),
        texts,
        equations,
        motion,
        _forces(tree, phase),
        event,
        duration,
        place,
        happens,
        why,
        "" if node.impact is None else node.impact.words,
        () if node.impact is None else _impulses(tree, node.impact),
        edge is None or edge.is_proved,
        "" if node.impact is None else "impact" if node.impact.hits else "blow",
    )


def _impulses(tree: PhaseTree, impact: PhaseImpact) -> tuple[tuple[str, Expr], ...]:
    """Impulses as their reactions are counted: at a bound a push is positive."""
    rows = {row.name: row for row in tree.system.rows}

    def name_of(row: str) -> str:
        told = Message("{reaction} of {connection}", reaction=rows[row].reaction, connection=label(row))
        return Message("impulse of {force}", force=told)

    return tuple((name_of(row), readable(rows[row].sign * x)) for row, x in impact.impulses.items())


def _with_purpose(r: SolvedRelation) -> str:
    return with_purposes(r.text(), r.purposes)


def _motion(tree: PhaseTree, phase: Phase) -> tuple[tuple[tuple[Expr, Expr], ...], tuple[tuple[Expr, Expr], ...]]:
    """Accelerations, and their integrals in the time since the phase began."""
    model = phase.model
    course = _course(phase)
    equations: list[tuple[Expr, Expr]] = []
    for c, a in zip(model.coordinates, model.accelerations, strict=True):
        second = Call("rate", Call("rate", Symbol(c.name)))
        x = model.dynamics.open_accelerations[a]
        if (x - model.field.variable(a)).is_zero():  # nothing with mass moves with it, and nothing pushes it
            continue
        equations.append((second, _with_places(tree, readable(x if course is None else course.plain(x)))))
    motion: list[tuple[Expr, Expr]] = []
    if isinstance(course, UniformMotion):
        t = tree.home.model.field.time
        for c in model.coordinates:
            values = course.start.of(c.index), course.start.of(c.speed), course.accelerations[c.speed]
            try:
                q0, u0, a = (tree.to_home(phase, x) for x in values)
            except CannotAnswer:  # it starts where only the assembly says
                continue
            motion.append((Symbol(c.name), add(readable(q0), readable(u0 * t), readable(a * t * t / 2))))
    elif isinstance(course, MotionInTime):
        values = course.values(phase.model.field.time)
        for c in model.coordinates:
            with suppress(CannotAnswer):
                motion.append((Symbol(c.name), readable(tree.to_home(phase, values[c.index]))))
    elif isinstance(course, EnergyMotion):
        motion.append((Call("rate", Symbol(course.coordinate.name)) ** 2, _with_places(tree, readable(course.square))))
    return tuple(equations), tuple(motion)


def _with_places(tree: PhaseTree, e: Expr) -> Expr:
    """Without the symbols that stand for angles and times at which later phases begin: cos(asin(u)) is sqrt(1 - u^2).
    What moves stands there as a symbol meanwhile."""
    met = sorted(free_symbols(e) & tree.later.keys())
    if not met:
        return e
    model, f = tree.home.model, tree.home.model.field
    moving = sorted(free_symbols(e) - {*met, *model.geometry.names})
    rates = {f"@rate of {name}": name for name in moving}
    places = {f"@place of {name}": name for name in moving}
    plain = replace_rates(e, {name: Symbol(stand_in) for stand_in, name in rates.items()})
    values = {stand_in: f.parameter(stand_in) for stand_in in rates} | {
        name: f.parameter(stand_in) for stand_in, name in places.items()
    }
    try:
        shown = readable(f.lowest_terms(model.geometry.apply(plain, {**values, **tree.later})))
    except (CannotAnswer, ArithmeticError):
        return substitute(e, {name: readable(tree.later[name]) for name in met})
    back = {stand_in: Call("rate", Symbol(name)) for stand_in, name in rates.items()}
    return substitute(shown, back | {stand_in: Symbol(name) for stand_in, name in places.items()})


def _course(phase: Phase) -> ClosedFormMotion | None:
    try:
        return phase.course
    except CannotAnswer:
        return None


def _shown(tree: PhaseTree, phase: Phase, x: Ratio) -> Expr:
    """By the parameters alone where nothing moves in it."""
    if phase.model.field.ingredients(x) & phase.model.moving:
        return _with_places(tree, readable(x))
    return readable(tree.to_home(phase, x))


def _forces(tree: PhaseTree, phase: Phase) -> tuple[tuple[str, Expr], ...]:
    """Reactions of bounds and frictions in this mode."""
    found: list[tuple[str, Expr]] = []
    state = SymbolicState(phase.model)
    acting = {row.name for row in phase.system.constraint_rows} | {p.load for p in phase.system.applied_loads}
    special = {b.name for b in phase.base.bounds} | {row.name for r in phase.base.dry_friction for row in r.rows}
    together = {row.name: row.together for row in phase.system.constraint_rows if row.together}
    for row in phase.base.rows:
        if row.name not in special and not row.unilateral:
            continue
        if row.name not in acting:
            continue
        course = _course(phase)
        for where, less in _stretches(row):
            try:
                whole = frozenset(together.get(row.name, ()))
                force = reaction(row.name, less, phase.base, phase.system, state, whole)
            except CannotAnswer:
                continue
            force = phase.model.field.lowest_terms(force) if course is None else course.plain(force)
            names = listed([label(one) for one in together.get(row.name, (row.name,))])
            name = Message("{reaction} of {connection}", reaction=row.reaction, connection=names + where)
            found.append((name, _shown(tree, phase, force)))
    return tuple(found)


def _stretches(row: ConstraintRow) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Where the reaction of a row has a value of its own, in words, and the rows that it is less by there."""
    if len(row.stretches) < 2:
        yield "", ()
        return
    for stretch in row.stretches:
        yield f" {stretch}", tuple(f"{row.connection}.{component}" for component in stretch.less)
