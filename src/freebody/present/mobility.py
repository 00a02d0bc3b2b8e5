"""The report of the constraint doctor, as text for a terminal."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from freebody.language.expression import Number
from freebody.language.notation import to_text
from freebody.language.units import DIMENSIONLESS
from freebody.measures.base import Measure
from freebody.numeric.mobility.path import MotionPath
from freebody.present.lines import number_text, option_lines, plural, wrapped

if TYPE_CHECKING:
    from freebody.numeric.mobility.screw_axes import ScrewAxis
    from freebody.study.mobility.mechanism import Input, Motions
    from freebody.study.mobility.mobility import Mobility

_RULE = "─"
_MOST = 24  # connections, centres ... that are listed


def mobility_lines(found: Mobility) -> Iterator[str]:
    """The whole report."""
    title = found.system.title
    yield title
    yield _RULE * min(len(title), 78)
    yield from _count(found)
    yield from _rank(found)
    if found.motions is not None:
        yield from _motions(found.motions)
    yield ""
    yield from wrapped("advice", found.advice)
    for question in found.system.questions:
        if question.id in found.answers:
            yield ""
            yield f"{question.id}  {question.text}: {found.finite_freedom}"
            judgement = found.answers[question.id]
            yield from option_lines(judgement.choice, judgement.options)
            for note in judgement.notes:
                yield from wrapped("to author", note)


def _count(found: Mobility) -> Iterator[str]:
    g = found.gruebler
    yield "Gruebler-Kutzbach count"
    particles = f" ({plural(len(g.particles), 'particle')} with {g.n_point} coordinates each)" if g.particles else ""
    yield f"    n = {g.n}, L = {plural(len(g.bodies) + len(g.particles), 'moving body', 'moving bodies')}{particles}"
    for c in g.connections[:_MOST]:
        extra = " (driver)" if c.is_driver else " (velocities)" if c.is_nonholonomic else ""
        yield f"    {c.connection:<14} {c.kind:<18} {plural(c.n, 'constraint'):<15} {' - '.join(c.between)}{extra}"
    if len(g.connections) > _MOST:
        yield f"    ... and {len(g.connections) - _MOST} more"
    if g.loads:
        yield (
            f"    {', '.join(g.loads[:_MOST])}: a load, holds nothing"
            if len(g.loads) == 1
            else (f"    {', '.join(g.loads[:_MOST])}: loads, hold nothing")
        )
    yield f"    DOF = n L - K = {g.formula}"


def _rank(found: Mobility) -> Iterator[str]:
    rank = found.rank
    yield "Rank"
    yield f"    {rank.rank} of {found.gruebler.n_constraints} constraints are independent"
    yield from wrapped("found by", rank.how)
    yield f"    mobility    {rank.n_coordinates} - {rank.rank} = {found.degrees_of_freedom}"
    if found.nearby is not None and found.nearby < found.degrees_of_freedom:
        if any(d.is_shaky for d in found.dependences):
            yield from wrapped("", f"motions that start here {found.nearby}: the rest gives way to first order only")
        else:
            yield from wrapped(
                "", f"at nearby poses {found.nearby}: the pose is singular, motions branch (bifurcation)"
            )
    if found.contradiction is not None:
        what = "cannot be assembled" if found.contradiction.is_geometric else "cannot be assembled at its start"
        yield from wrapped("conflict", f"{what}: {', '.join(found.contradiction.names)}")
        yield from wrapped("", f"at best {found.contradiction.gap}")
    for d in found.dependences:
        yield from wrapped("redundant", f"{', '.join(d.rows)} depend on each other ({d.kind})")
        yield from wrapped("", d.why)
    if found.dependences:
        yield from wrapped("not unique", f"the reactions {', '.join(found.indeterminate)}")
    for body, what in found.idle.items():
        yield from wrapped("idle", f"{body} {what}, and nothing else moves")
    if found.n_idle:
        useful = f"{found.finite_freedom} - {found.n_idle} = {found.useful_freedom} without what is idle"
        yield from wrapped("useful", useful)
    if found.reachable is not None:
        yield from wrapped("velocities", _reachable(found))
    if found.independent_coordinates:
        yield from wrapped("coordinates", ", ".join(found.independent_coordinates))
    for note in found.notes:
        yield from wrapped("note", note)


def _reachable(found: Mobility) -> str:
    n, m = found.degrees_of_freedom, found.reachable
    held = [c.connection for c in found.gruebler.connections if c.is_nonholonomic]
    verb = "holds" if len(held) == 1 else "hold"
    what = f"{', '.join(held)} {verb} velocities: {plural(n, 'freedom')} at a pose"
    if m == n:
        return f"{what}, and poses in {plural(n, 'dimension')} are reached, so they can be integrated (holonomic)"
    return f"{what}, but poses in {m} dimensions are reached (nonholonomic)"


# -- the motion -------------------------------------------------------------------------------
def _motions(motions: Motions) -> Iterator[str]:
    for loop, numbers in motions.linkages:
        yield f"{loop.kind.capitalize()}: {', '.join(loop.links)}"
        plain = numbers.to_plain()
        yield f"    case        {plain['case']}"
        if "shortest_and_longest" in plain:
            s, p = plain["shortest_and_longest"], plain["other_two"]
            yield f"    Grashof     s + l = {number_text(s)} m, p + q = {number_text(p)} m"
        if plain["turning"]:
            yield f"    turns fully {', '.join(plain['turning'])}"
        if plain.get("transmission_angle") is not None:
            low, high = plain["transmission_extremes"]
            yield (
                f"    transmission angle {number_text(_clean(plain['transmission_angle_folded']))}° here, "
                f"{number_text(_clean(low))}° to {number_text(_clean(high))}° over all poses of this loop alone"
            )
    if motions.centres and len(motions.centres) <= _MOST:
        yield "Instant centres"
        for c in motions.centres:
            where = (
                f"({number_text(_clean(c.at[0]))}, {number_text(_clean(c.at[1]))}) m"
                if c.at is not None
                else f"at infinity along ({number_text(c.direction[0])}, {number_text(c.direction[1])})"
                if c.direction is not None
                else "undetermined"
            )
            exact = "" if c.formula is None else f" = ({', '.join(map(to_text, c.formula))})"
            yield f"    {' - '.join(c.pair):<24} {where}{exact}"
    if motions.screws and motions.input is not None and len(motions.screws) <= _MOST:
        yield "Screw axes"
        yield from (f"    {s.body:<14} {_screw(s, motions.input)}" for s in motions.screws)
    if any(c.formula is not None for c in motions.centres) or any(r.formula is not None for r in motions.ratios):
        yield "    formulas: at this pose and on this branch, while the loops close and the roots are real"
    if motions.ratios and motions.input is not None and len(motions.ratios) <= _MOST:
        yield f"Rates per unit rate of {motions.input.name}"
        for r in motions.ratios:
            unit = "" if r.unit in ("1", "") else f" {r.unit}"
            exact = "" if r.formula is None or isinstance(r.formula, Number) else f" = {to_text(r.formula)}"
            yield f"    {r.name:<24} {number_text(_clean(r.value))}{unit}{exact}"
    if motions.path is not None and motions.input is not None:
        yield from _path(motions.path, motions.input)
    for what in motions.singular:
        assert motions.input is not None
        yield from wrapped("this pose", f"is a {what} of {motions.input.name}")
    if motions.modes:
        held = (
            ""
            if motions.input is None
            else f" at {motions.input.name} = {_value(motions.input.value, motions.input.measure)}"
        )
        yield f"Assembly modes{held}"
        for k, mode in enumerate(motions.modes):
            yield f"    {mode.name}{' (this one)' if k == 0 else ''}"
        yield "    choose one in the file with  start: {mode: NAME}"
    for note in motions.notes:
        yield from wrapped("note", note)


def _screw(found: ScrewAxis, given: Input) -> str:
    screw, per = found.screw, f"per {'rad' if given.is_angle else str(given.measure.dimension)} of {given.name}"
    along = f"along ({_numbers(screw.direction)})"
    if screw.pitch is None:
        return f"travels {along}, {number_text(_clean(found.rate))} m {per}"
    pitch = "" if screw.pitch == 0.0 else f", pitch {number_text(screw.pitch)} m/rad"
    return f"through ({_numbers(screw.point)}) m {along}{pitch}, {number_text(_clean(found.rate))} rad {per}"


def _numbers(v: Iterable[float]) -> str:
    return ", ".join(number_text(_clean(float(c))) for c in v)


def _path(path: MotionPath, given: Input) -> Iterator[str]:
    yield f"Motion along {given.name}"
    if path.full_turn:
        yield "    reach       turns fully"
    elif path.reach is None:
        yield "    reach       unlimited"
    else:
        low, high = (_value(x, given.measure) for x in path.reach)
        yield f"    reach       {low} to {high}"
    for p in path.points:
        yield f"    {p.kind} at {given.name} = {_value(p.input, given.measure)}: {p.what}"
    if path.note:
        yield from wrapped("note", path.note)


def _value(x: float, measure: Measure) -> str:
    if not math.isfinite(x):
        return "infinity" if x > 0 else "-infinity"
    if measure.dimension == DIMENSIONLESS:
        return f"{number_text(_clean(math.degrees(x), 1e-9))}°"
    return f"{number_text(_clean(x))} {measure.dimension}"


def _clean(x: float, zero: float = 1e-12) -> float:
    """Without round-off of a zero."""
    return 0.0 if abs(x) < zero else x
