"""The summary of a simulation as blocks: status, cost, violations, energy balance, events and final values."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from freebody.language.sentences import Message, in_turn
from freebody.language.units import ENERGY, TIME, unit_of
from freebody.present.report.blocks import Block, Entry, Section
from freebody.present.report.results import entries, entry, notes, table
from freebody.study.simulation.measured import MeasuredMotion

N_FIRST, N_LAST = 12, 5  # events that are listed, if there are more
N_LISTED = 8  # contacts; more are counted


def motion_blocks(result: MeasuredMotion) -> Iterator[Block]:
    summary = result.summary()
    yield from entries(*notes(result.simulator.assumptions, Message("assumed")), *_said(result, summary))
    if result.events:
        yield Section((Message("Events"),), tuple(table(_events(result))))
    final = summary["final"]["measures"]
    if final:
        values = ((name, f"= {value:.9g} {_unit(result, name)}") for name, value in final.items())
        yield Section((Message("At {t:.6g} s", t=result.t_end),), tuple(table(values)))


def _unit(result: MeasuredMotion, name: str) -> str:
    return unit_of(result.system.dimensions()[name])


def _said(result: MeasuredMotion, summary: dict[str, Any]) -> Iterator[Entry]:
    course = result.course
    status, why = str(result.status), result.message
    yield entry(
        Message("status"),
        Message("{status}: {why}", status=status, why=why) if why else Message("{status}", status=status),
    )
    took = Message(
        "{t:.6g} s in {n} steps, {m} evaluations, {wall:.3g} s computing time ({method}, tolerance {tolerance:g})",
        t=result.t_end,
        n=course.n_steps,
        m=course.n_evaluations,
        wall=course.wall_time,
        method=course.method,
        tolerance=result.tolerance,
    )
    yield entry(Message("time"), took)
    violated = Message(
        "at most {position:.1e} m and {velocity:.1e} m/s violated",
        position=summary["max_position_violation"],
        velocity=summary["max_velocity_violation"],
    )
    yield entry(Message("constraints"), violated)
    if "blow" in summary:
        yield entry(Message("blow"), *_blow(result, Message("at the start"), summary["blow"]))
    for blow in summary.get("blows", ()):
        yield entry(Message("blow"), *_blow(result, f"{blow['time']:.6g} s", blow))
    balance = Message(
        "energy balance error: {error:.1e} J (relative {relative:.1e})",
        error=summary["energy_error"],
        relative=summary["energy_error_relative"],
    )
    yield entry(Message("energy"), balance)
    open_ = [r.name for k, r in enumerate(result.rows) if not course.unique[:, k].all()]
    if open_:
        told = Message("{names}: connections hold the same thing more than once", names=", ".join(open_))
        yield entry(Message("not unique"), told)
    for row, time in result.other_flanks:
        assert row.pressed is not None
        told = row.pressed.is_left(row.connection, time, is_followed=result.follows_sides)
        yield entry(Message("teeth"), told)
    for purpose, time in result.not_valid:
        told = Message(
            "from {t:.4g} s on it is not so that {purpose}: there the model is not true", t=time, purpose=purpose
        )
        yield entry(Message("validity"), told)
    if course.contact is not None and (course.contact.bounds or course.contact.dry_friction):
        yield entry(Message("contact"), *_contacts(result, summary, open_))
    if result.trusted_until is not None:
        is_all = result.trusted_until >= result.t_end
        parted = Message("two tolerances diverge at {t:.4g} s", t=result.trusted_until)
        yield entry(Message("trust"), Message("to the end") if is_all else parted)


def _blow(result: MeasuredMotion, when: str, blow: dict[str, Any]) -> Iterator[str]:
    """What a blow takes, and the impulses of what is held."""
    lost = blow["energy_lost"]
    if lost < 0.0:  # an impulse that pushes, or what is driven, does work
        yield Message("{when}; kinetic energy gained {energy:.6g} J", when=when, energy=-lost)
    else:
        yield Message("{when}; kinetic energy lost {energy:.6g} J", when=when, energy=lost)
    rows = {row.name: row for row in result.system.rows}
    for name, value in list(blow["impulses"].items())[:N_LISTED]:
        unit = unit_of(ENERGY * TIME / rows[name].measure.dimension)
        yield Message("impulse of {name} {x:.6g} {unit}", name=name, x=value, unit=unit)
    if len(blow["impulses"]) > N_LISTED:
        yield Message("{n} more", n=len(blow["impulses"]) - N_LISTED)
    if "not_unique" in blow:
        yield Message("not unique: the impulses of {names}", names=", ".join(blow["not_unique"]))


def _contacts(result: MeasuredMotion, summary: dict[str, Any], open_: Sequence[str]) -> Iterator[str]:
    """States at the end, and between which bounds reactions lie that are not unique there."""
    states: dict[str, str] = {name: state for name, state in summary["contacts"].items() if state != "open"}
    told: list[str] = [
        Message("{contact} {state}", contact=name, state=state) for name, state in list(states.items())[:N_LISTED]
    ]
    if len(states) > N_LISTED:
        told.append(Message("{n} more", n=len(states) - N_LISTED))
    n_open = len(summary["contacts"]) - len(states)
    if n_open:
        told.append(Message("{n} open", n=n_open))
    if told:
        n, now = summary["phases"], in_turn(told)
        yield Message("1 phase; at the end {now}" if n == 1 else "{n} phases; at the end {now}", n=n, now=now)
    if open_ and result.status.is_complete and len(open_) <= N_LISTED:
        ranges = result.reaction_ranges()
        for name in [name for name in open_ if name in ranges]:
            low, high = ranges[name]
            yield Message("{name} between {low:.6g} and {high:.6g} N", name=name, low=low, high=high)


def _events(result: MeasuredMotion) -> Iterator[tuple[str, str]]:
    """All of them, or the first and the last."""
    n = len(result.events)
    left_out = range(N_FIRST, n - N_LAST) if n > N_FIRST + N_LAST + 1 else range(0)
    for k, event in enumerate(result.events):
        if k not in left_out:
            yield f"{event.time:.9g} s", Message("{event} ({occasion})", event=event.name, occasion=event.kind)
        elif k == left_out[0]:
            yield "...", Message("{n} more", n=len(left_out))
