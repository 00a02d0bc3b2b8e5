"""The summary of a simulation as blocks: status, cost, violations, energy balance, events and final values."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from freebody.language.units import ENERGY, TIME, unit_of
from freebody.present.report.blocks import Block, Entry, Section
from freebody.present.report.results import entries, entry, notes, table
from freebody.study.simulation.measured import MeasuredMotion

N_FIRST, N_LAST = 12, 5  # events that are listed, if there are more
N_LISTED = 8  # contacts; more are counted


def motion_blocks(result: MeasuredMotion) -> Iterator[Block]:
    summary = result.summary()
    yield from entries(*notes(result.simulator.assumptions, "assumed"), *_said(result, summary))
    if result.events:
        yield Section(("Events",), tuple(table(_events(result))))
    final = summary["final"]["measures"]
    if final:
        values = ((name, f"= {value:.9g} {_unit(result, name)}") for name, value in final.items())
        yield Section((f"At {result.t_end:.6g} s",), tuple(table(values)))


def _unit(result: MeasuredMotion, name: str) -> str:
    return unit_of(result.system.dimensions()[name])


def _said(result: MeasuredMotion, summary: dict[str, Any]) -> Iterator[Entry]:
    course = result.course
    yield entry("status", str(result.status) + (f": {result.message}" if result.message else ""))
    yield entry(
        "time",
        f"{result.t_end:.6g} s in {course.n_steps} steps, {course.n_evaluations} evaluations, "
        f"{course.wall_time:.3g} s computing time ({course.method}, tolerance {result.tolerance:g})",
    )
    violated = (f"{summary['max_position_violation']:.1e} m", f"{summary['max_velocity_violation']:.1e} m/s")
    yield entry("constraints", f"at most {' and '.join(violated)} violated")
    if "blow" in summary:
        yield entry("blow", *_blow(result, "at the start", summary["blow"]))
    for blow in summary.get("blows", ()):
        yield entry("blow", *_blow(result, f"{blow['time']:.6g} s", blow))
    error, relative = summary["energy_error"], summary["energy_error_relative"]
    yield entry("energy", f"energy balance error: {error:.1e} J (relative {relative:.1e})")
    open_ = [r.name for k, r in enumerate(result.rows) if not course.unique[:, k].all()]
    if open_:
        yield entry("not unique", f"{', '.join(open_)}: connections hold the same thing more than once")
    for mesh, time in result.other_flanks:
        yield entry("teeth", f"from {time:.4g} s {mesh} bears on its other flank: there its radial force is reversed")
    for purpose, time in result.not_valid:
        yield entry("validity", f"from {time:.4g} s on it is not so that {purpose}: there the model is not true")
    if course.contact is not None and (course.contact.bounds or course.contact.dry_friction):
        yield entry("contact", *_contacts(result, summary, open_))
    if result.trusted_until is not None:
        is_all = result.trusted_until >= result.t_end
        yield entry("trust", "to the end" if is_all else f"two tolerances diverge at {result.trusted_until:.4g} s")


def _blow(result: MeasuredMotion, when: str, blow: dict[str, Any]) -> Iterator[str]:
    """What a blow takes, and the impulses of what is held."""
    yield f"{when}; kinetic energy lost {blow['energy_lost']:.6g} J"
    rows = {row.name: row for row in result.system.rows}
    for name, value in list(blow["impulses"].items())[:N_LISTED]:
        yield f"impulse of {name} {value:.6g} {unit_of(ENERGY * TIME / rows[name].measure.dimension)}"
    if len(blow["impulses"]) > N_LISTED:
        yield f"{len(blow['impulses']) - N_LISTED} more"
    if "not_unique" in blow:
        yield f"not unique: the impulses of {', '.join(blow['not_unique'])}"


def _contacts(result: MeasuredMotion, summary: dict[str, Any], open_: Sequence[str]) -> Iterator[str]:
    """States at the end, and between which bounds reactions lie that are not unique there."""
    states: dict[str, str] = {name: state for name, state in summary["contacts"].items() if state != "open"}
    listed = [f"{name} {state}" for name, state in list(states.items())[:N_LISTED]]
    if len(states) > N_LISTED:
        listed.append(f"{len(states) - N_LISTED} more")
    n_open = len(summary["contacts"]) - len(states)
    if n_open:
        listed.append(f"{n_open} open")
    if listed:
        n = summary["phases"]
        yield f"{n} phase{'' if n == 1 else 's'}; at the end {', '.join(listed)}"
    if open_ and result.status.is_complete and len(open_) <= N_LISTED:
        ranges = result.reaction_ranges()
        for name in [name for name in open_ if name in ranges]:
            low, high = ranges[name]
            yield f"{name} between {low:.6g} and {high:.6g} N"


def _events(result: MeasuredMotion) -> Iterator[tuple[str, str]]:
    """All of them, or the first and the last."""
    n = len(result.events)
    left_out = range(N_FIRST, n - N_LAST) if n > N_FIRST + N_LAST + 1 else range(0)
    for k, event in enumerate(result.events):
        if k not in left_out:
            yield f"{event.time:.9g} s", f"{event.name} ({event.kind})"
        elif k == left_out[0]:
            yield "...", f"{len(left_out)} more"
