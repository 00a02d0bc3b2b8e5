"""The count of degrees of freedom and what is told of a motion, as blocks."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from freebody.language.expression import Expr, Number
from freebody.language.units import DIMENSIONLESS
from freebody.measures.base import Measure
from freebody.numeric.mobility.path import MotionPath
from freebody.numeric.mobility.screw_axes import ScrewAxis
from freebody.present.lines import number_text, plural
from freebody.present.report.blocks import Block, Entry, Formula, Section, Text
from freebody.present.report.results import entries, entry, line, notes, table
from freebody.study.mobility.centres import CentreOfPair
from freebody.study.mobility.grashof import FourBarNumbers, SliderCrankNumbers
from freebody.study.mobility.gruebler import Gruebler
from freebody.study.mobility.linkages import Linkage
from freebody.study.mobility.mechanism import Input, Motions
from freebody.tolerances import ROUNDED

_MOST = 24  # connections, centres ... that are listed
_WHERE_FORMULAS_HOLD = "formulas: at this pose and on this branch, while the loops close and the roots are real"


def count_section(g: Gruebler) -> Section:
    """The Gruebler-Kutzbach count."""
    particles = f" ({plural(len(g.particles), 'particle')} with {g.n_point} coordinates each)" if g.particles else ""
    bodies = plural(len(g.bodies) + len(g.particles), "moving body", "moving bodies")
    blocks: list[Block] = [line(f"n = {g.n}, L = {bodies}{particles}")]
    rows: list[tuple[str, str, str, str]] = []
    for c in g.connections[:_MOST]:
        extra = " (driver)" if c.is_driver else " (velocities)" if c.is_nonholonomic else ""
        rows.append((c.connection, c.kind, plural(c.n, "constraint"), f"{' - '.join(c.between)}{extra}"))
    blocks += table(rows)
    if len(g.connections) > _MOST:
        blocks.append(line(f"... and {len(g.connections) - _MOST} more"))
    if g.loads:
        what = "a load, holds nothing" if len(g.loads) == 1 else "loads, hold nothing"
        blocks.append(line(f"{', '.join(g.loads[:_MOST])}: {what}"))
    return Section(("Gruebler-Kutzbach count",), (*blocks, line(f"DOF = n L - K = {g.formula}")))


# -- the motion -------------------------------------------------------------------------------
def motion_sections(motions: Motions) -> Iterator[Section]:
    for loop, numbers in motions.linkages:
        title = f"{loop.kind.capitalize()}: {', '.join(loop.links)}"
        yield Section((title,), tuple(entries(*_linkage(loop, numbers))))
    has_formulas = any(c.formula is not None for c in (*motions.centres, *motions.ratios))
    given, parts = motions.input, list[Section]()
    if motions.centres and len(motions.centres) <= _MOST:
        parts.append(Section(("Instant centres",), tuple(table(map(_centre, motions.centres)))))
    if motions.screws and given is not None and len(motions.screws) <= _MOST:
        parts.append(Section(("Screw axes",), tuple(table((s.body, _screw(s, given)) for s in motions.screws))))
    if motions.ratios and given is not None and len(motions.ratios) <= _MOST:
        rates = ((r.name, _with_formula(_rate(r.value, r.unit), (r.formula,))) for r in motions.ratios)
        parts.append(Section((f"Rates per unit rate of {given.name}",), tuple(table(rates))))
    if has_formulas and parts:
        last = parts.pop()
        parts.append(Section(last.title, (*last.blocks, line(_WHERE_FORMULAS_HOLD))))
    yield from parts
    if motions.path is not None and given is not None:
        yield _path(motions.path, given)
    if motions.modes:
        held = "" if given is None else f" at {given.name} = {_value(given.value, given.measure)}"
        names = [f"{mode.name}{' (this one)' if k == 0 else ''}" for k, mode in enumerate(motions.modes)]
        choice = "choose one in the file with  start: {mode: NAME}"
        yield Section((f"Assembly modes{held}",), tuple(map(line, (*names, choice))))


def _linkage(loop: Linkage, numbers: FourBarNumbers | SliderCrankNumbers) -> Iterator[Entry]:
    plain = numbers.to_plain()
    yield entry("case", str(plain["case"]))
    if "shortest_and_longest" in plain:
        s, p = plain["shortest_and_longest"], plain["other_two"]
        yield entry("Grashof", f"s + l = {number_text(s)} m, p + q = {number_text(p)} m")
    if plain["turning"]:
        yield entry("turns fully", ", ".join(plain["turning"]))
    if plain.get("transmission_angle") is not None:
        here = plain["transmission_angle_folded"], *plain["transmission_extremes"]
        folded, low, high = (number_text(angle, ROUNDED) for angle in here)
        told = f"{folded}° here, {low}° to {high}° over all poses of this loop alone"
        yield entry("transmission angle", told)


def _centre(c: CentreOfPair) -> tuple[str, Text]:
    if c.at is not None:
        where = f"({_numbers(c.at)}) m"
    elif c.direction is not None:
        where = f"at infinity along ({_numbers(c.direction)})"
    else:
        where = "undetermined"
    return " - ".join(c.pair), _with_formula(where, c.formula or ())


def _with_formula(number: str, exact: tuple[Expr | None, ...]) -> Text:
    """A number, or two of a place, and what it is exactly, where that says more."""
    parts = [part for part in exact if part is not None]
    if not parts or (len(parts) == 1 and isinstance(parts[0], Number)):
        return (number,)
    if len(parts) == 1:
        return f"{number} = ", Formula((parts[0],))
    return f"{number} = (", Formula((parts[0],)), ", ", Formula((parts[1],)), ")"


def _rate(value: float, unit: str) -> str:
    return number_text(value, ROUNDED) + ("" if unit in ("1", "") else f" {unit}")


def _screw(found: ScrewAxis, given: Input) -> str:
    screw, per = found.screw, f"per {'rad' if given.is_angle else str(given.measure.dimension)} of {given.name}"
    along = f"along ({_numbers(screw.direction)})"
    if screw.pitch is None:
        return f"travels {along}, {number_text(found.rate, ROUNDED)} m {per}"
    pitch = "" if screw.pitch == 0.0 else f", pitch {number_text(screw.pitch)} m/rad"
    return f"through ({_numbers(screw.point)}) m {along}{pitch}, {number_text(found.rate, ROUNDED)} rad {per}"


def _numbers(v: Iterable[float]) -> str:
    return ", ".join(number_text(float(c), ROUNDED) for c in v)


def _path(path: MotionPath, given: Input) -> Section:
    if path.full_turn:
        reach = "turns fully"
    elif path.reach is None:
        reach = "unlimited"
    else:
        reach = " to ".join(_value(x, given.measure) for x in path.reach)
    points = [line(f"{p.kind} at {given.name} = {_value(p.input, given.measure)}: {p.what}") for p in path.points]
    note = entries(*notes([path.note] if path.note else []))
    return Section((f"Motion along {given.name}",), (*entries(entry("reach", reach)), *points, *note))


def _value(x: float, measure: Measure) -> str:
    if not math.isfinite(x):
        return "infinity" if x > 0 else "-infinity"
    if measure.dimension == DIMENSIONLESS:
        return f"{number_text(math.degrees(x), 1e-9)}°"
    return f"{number_text(x, ROUNDED)} {measure.dimension}"
