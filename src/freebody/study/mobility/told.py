"""The count of degrees of freedom and what is told of a motion, as blocks."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from freebody.language.expression import Expr, Number
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.measures.base import Measure
from freebody.numeric.mobility.path import MotionPath
from freebody.numeric.mobility.screw_axes import ScrewAxis
from freebody.present.lines import number_text
from freebody.present.report.blocks import Block, Entry, Formula, Section, Text
from freebody.present.report.results import entries, entry, line, notes, table
from freebody.study.mobility.centres import CentreOfPair
from freebody.study.mobility.grashof import FourBarNumbers, SliderCrankNumbers
from freebody.study.mobility.gruebler import Gruebler
from freebody.study.mobility.linkages import Linkage
from freebody.study.mobility.mechanism import Input, Motions
from freebody.tolerances import ROUNDED

_MOST = 24  # connections, centres ... that are listed
_WHERE_FORMULAS_HOLD = Message(
    "formulas: at this pose and on this branch, while the loops close and the roots are real"
)


def count_section(g: Gruebler) -> Section:
    """The Gruebler-Kutzbach count."""
    n = len(g.bodies) + len(g.particles)
    bodies = Message("1 moving body") if n == 1 else Message("{n} moving bodies", n=n)
    if g.particles:
        bodies = Message(
            "{bodies} (1 particle with {n} coordinates each)"
            if len(g.particles) == 1
            else "{bodies} ({k} particles with {n} coordinates each)",
            bodies=bodies,
            k=len(g.particles),
            n=g.n_point,
        )
    blocks: list[Block] = [line(Message("n = {n}, L = {bodies}", n=g.n, bodies=bodies))]
    rows: list[tuple[str, str, str, str]] = []
    for c in g.connections[:_MOST]:
        between: str = " – ".join(c.between)
        if c.is_driver:
            between = Message("{between} (driver)", between=between)
        elif c.is_nonholonomic:
            between = Message("{between} (velocities)", between=between)
        held = Message("1 constraint") if c.n == 1 else Message("{n} constraints", n=c.n)
        rows.append((c.connection, Message("{kind}", kind=c.kind), held, between))
    blocks += table(rows)
    if len(g.connections) > _MOST:
        blocks.append(line(Message("... and {n} more", n=len(g.connections) - _MOST)))
    if g.loads:
        told = Message(
            "{names}: a load, holds nothing" if len(g.loads) == 1 else "{names}: loads, hold nothing",
            names=", ".join(g.loads[:_MOST]),
        )
        blocks.append(line(told))
    if g.by_friction:
        told = Message(
            "{names}: friction holds as well, as long as it sticks; solve counts the freedoms without it",
            names=", ".join(g.by_friction[:_MOST]),
        )
        blocks.append(line(told))
    count = line(Message("DOF = n L - K = {count}", count=g.formula))
    return Section((Message("Gruebler-Kutzbach count"),), (*blocks, count))


# -- the motion -------------------------------------------------------------------------------
def motion_sections(motions: Motions) -> Iterator[Section]:
    for loop, numbers in motions.linkages:
        title = Message("{linkage}: {links}", linkage=loop.kind.capitalize(), links=", ".join(loop.links))
        yield Section((title,), tuple(entries(*_linkage(loop, numbers))))
    has_formulas = any(c.formula is not None for c in (*motions.centres, *motions.ratios))
    given, parts = motions.input, list[Section]()
    if motions.centres and len(motions.centres) <= _MOST:
        parts.append(Section((Message("Instant centres"),), tuple(table(map(_centre, motions.centres)))))
    if motions.screws and given is not None and len(motions.screws) <= _MOST:
        parts.append(
            Section((Message("Screw axes"),), tuple(table((s.body, _screw(s, given)) for s in motions.screws)))
        )
    if motions.ratios and given is not None and len(motions.ratios) <= _MOST:
        rates = ((r.name, _with_formula(_rate(r.value, r.unit), (r.formula,))) for r in motions.ratios)
        parts.append(Section((Message("Rates per unit rate of {name}", name=given.name),), tuple(table(rates))))
    if has_formulas and parts:
        last = parts.pop()
        parts.append(Section(last.title, (*last.blocks, line(_WHERE_FORMULAS_HOLD))))
    yield from parts
    if motions.path is not None and given is not None:
        yield _path(motions.path, given)
    if motions.modes:
        title = Message("Assembly modes")
        if given is not None:
            value = _value(given.value, given.measure)
            title = Message("Assembly modes at {name} = {value}", name=given.name, value=value)
        this, *others = (mode.name for mode in motions.modes)
        names = Message("{mode} (this one)", mode=this), *(Message("{mode}", mode=other) for other in others)
        choice = Message("choose one in the file with  {entry}", entry="start: {mode: NAME}")
        yield Section((title,), tuple(map(line, (*names, choice))))


def _linkage(loop: Linkage, numbers: FourBarNumbers | SliderCrankNumbers) -> Iterator[Entry]:
    plain = numbers.to_plain()
    yield entry(Message("case"), Message("{case}", case=str(plain["case"])))
    if "shortest_and_longest" in plain:
        s, p = plain["shortest_and_longest"], plain["other_two"]
        yield entry("Grashof", f"s + l = {number_text(s)} m, p + q = {number_text(p)} m")
    if plain["turning"]:
        yield entry(Message("turns fully"), ", ".join(plain["turning"]))
    if plain.get("transmission_angle") is not None:
        here = plain["transmission_angle_folded"], *plain["transmission_extremes"]
        folded, low, high = (number_text(angle, ROUNDED) for angle in here)
        told = Message(
            "{folded}° here, {low}° to {high}° over all poses of this loop alone", folded=folded, low=low, high=high
        )
        yield entry(Message("transmission angle"), told)


def _centre(c: CentreOfPair) -> tuple[str, Text]:
    if c.at is not None:
        where = f"({_numbers(c.at)}) m"
    elif c.direction is not None:
        where = Message("at infinity along ({direction})", direction=_numbers(c.direction))
    else:
        where = Message("undetermined")
    return " – ".join(c.pair), _with_formula(where, c.formula or ())


def _with_formula(number: str, exact: tuple[Expr | None, ...]) -> Text:
    """A number, or two of a place, and what it is exactly, where that says more."""
    parts = [part for part in exact if part is not None]
    if not parts or (len(parts) == 1 and isinstance(parts[0], Number)):
        return (number,)
    if len(parts) == 1:
        return number, " = ", Formula((parts[0],))
    return number, " = (", Formula((parts[0],)), ", ", Formula((parts[1],)), ")"


def _rate(value: float, unit: str) -> str:
    return number_text(value, ROUNDED) + ("" if unit in ("1", "") else f" {unit}")


def _screw(found: ScrewAxis, given: Input) -> str:
    screw, direction, rate = found.screw, _numbers(found.screw.direction), number_text(found.rate, ROUNDED)
    unit = "rad" if given.is_angle else str(given.measure.dimension)
    if screw.pitch is None:
        return Message(
            "travels along ({direction}), {rate} m per {unit} of {name}",
            direction=direction,
            rate=rate,
            unit=unit,
            name=given.name,
        )
    return Message(
        "through ({point}) m along ({direction}), {rate} rad per {unit} of {name}"
        if screw.pitch == 0.0
        else "through ({point}) m along ({direction}), pitch {pitch} m/rad, {rate} rad per {unit} of {name}",
        point=_numbers(screw.point),
        direction=direction,
        pitch=number_text(screw.pitch),
        rate=rate,
        unit=unit,
        name=given.name,
    )


def _numbers(v: Iterable[float]) -> str:
    return ", ".join(number_text(float(c), ROUNDED) for c in v)


def _path(path: MotionPath, given: Input) -> Section:
    if path.full_turn:
        reach = Message("turns fully")
    elif path.reach is None:
        reach = Message("unlimited")
    else:
        low, high = (_value(x, given.measure) for x in path.reach)
        reach = Message("{low} to {high}", low=low, high=high)
    points = [
        line(
            Message(
                "{singular} at {name} = {value}: {what}",
                singular=p.kind,
                name=given.name,
                value=_value(p.input, given.measure),
                what=p.what,
            )
        )
        for p in path.points
    ]
    note = entries(*notes([path.note] if path.note else []))
    return Section(
        (Message("Motion along {name}", name=given.name),), (*entries(entry(Message("reach"), reach)), *points, *note)
    )


def _value(x: float, measure: Measure) -> str:
    if not math.isfinite(x):
        return Message("infinity") if x > 0 else Message("-infinity")
    if measure.dimension == DIMENSIONLESS:
        return f"{number_text(math.degrees(x), 1e-9)}°"
    return f"{number_text(x, ROUNDED)} {measure.dimension}"
