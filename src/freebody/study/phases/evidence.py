"""Every closed form of a motion in phases is compared with numbers that share only the statements of the measures.

The numbers come from `witness`: the one place where another simulation could be put in.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer, RoutesDisagree
from freebody.measures.angle import Angle
from freebody.model.contact_questions import Change, EnergyLost, Turns
from freebody.model.question import Event, Quantity, Question, When, Work
from freebody.study.answer import Evidence
from freebody.study.draws import SEED, Draw
from freebody.study.evidence import INSTANT_TOLERANCE, MOTION_TOLERANCE, Witness
from freebody.study.magnitude import magnitude
from freebody.study.phases.pieces import Piece
from freebody.study.phases.quantities import frictions, only_friction_takes_energy, plain, value_in_mode
from freebody.study.phases.tree import Tree
from freebody.study.phases.witness import MAX_TIME, NumericMode, Seen, follow
from freebody.study.quantities import energy

N_CHECKED = 5
_LONGEST = 400.0  # in units of the typical time of the sets; longer motions are left to other sets


def compare(tree: Tree, question: Question, piece: Piece) -> Evidence:
    """Raises RoutesDisagree on a difference, CannotAnswer if too little could be compared."""
    if piece.first is None and piece.time is not None and isinstance(question.quantity, When):
        return _slips(tree, question, piece)
    if piece.first is None:
        return _at_instants(tree, question, piece)
    return _along_motion(tree, question, piece)


# -- one instant ------------------------------------------------------------------------------
def _at_instants(tree: Tree, question: Question, piece: Piece) -> Evidence:
    at_start = question.at_start or piece.time is not None
    where = "at the start" if at_start else "at random poses and speeds"
    witness = Witness(question.text, f"floating-point solve of all bodies and contacts {where}", INSTANT_TOLERANCE)
    phase = piece.phase
    for n, k in enumerate(piece.sets):
        if len(witness.pairs) >= N_CHECKED:
            break
        values = tree.sets.one(int(k))
        mode = NumericMode(tree.system, phase, values)
        reference = mode.references[0]
        try:
            q, v = mode.start()
            begin = reference.snapshot(q, v)
            draw = Draw(mode.values, reference, q)
            if not at_start:
                q, v = reference.wander(q, np.random.default_rng(SEED + n), 0.1)
            now = mode.snapshot(q, v, 0.0)
            numeric = value_in_mode(question.quantity, tree.system, mode.system, now)
        except CannotAnswer:
            continue
        if piece.is_home:
            exact: Any = _home_numbers(tree, piece, int(k))
        else:
            numbers = phase.model.numbers(draw.sample(now), draw.sample(begin))
            parts = piece.value if isinstance(piece.value, tuple) else (piece.value,)
            exact = tuple(float(phase.model.field.evaluate(p, numbers)) for p in parts)
        witness.compare(draw, exact, numeric, partial(magnitude, question.quantity.dimension, now))
    return witness.evidence()


def _slips(tree: Tree, question: Question, piece: Piece) -> Evidence:
    """At rest at the start, the frictions that slide must be accelerated their way."""
    witness = Witness(question.text, "floating-point accelerations of the slips at the start", INSTANT_TOLERANCE)
    for k in piece.sets[:N_CHECKED]:
        mode = NumericMode(tree.system, piece.phase, tree.sets.one(int(k)))
        q, v = mode.start()
        now = mode.snapshot(q, v, 0.0)
        signs = [(s, now.acceleration(mode.rubs[n].row.measure)) for n, s in mode.mode.states.items() if s]
        time = 0.0 if all(s * a > 0 for s, a in signs) else np.inf
        witness.compare(Draw(mode.values, mode.references[0], q), _home_numbers(tree, piece, int(k)), time)
    return witness.evidence()


def _home_numbers(tree: Tree, piece: Piece, k: int) -> tuple[float, ...]:
    parts = piece.value if isinstance(piece.value, tuple) else (piece.value,)
    return tuple(float(tree.numbers(p)[k]) for p in parts)


# -- an event ---------------------------------------------------------------------------------
def _along_motion(tree: Tree, question: Question, piece: Piece) -> Evidence:
    route = "numerical integration, every phase to the event that ends it"
    witness = Witness(question.text, route, MOTION_TOLERANCE)
    assert piece.first is not None
    ends = None if piece.time is None else tree.numbers(piece.time)
    for k in piece.sets:
        if len(witness.pairs) >= N_CHECKED:
            break
        exact = _home_numbers(tree, piece, int(k))
        if not np.isfinite(exact).all() or (ends is not None and not 0 < ends[k] < _LONGEST):
            continue
        seen = run(tree, question.event, piece, int(k), None if ends is None else float(ends[k]))
        expected = piece.first.watch
        event = seen[-1].event
        draw = Draw(seen[0].mode.values, seen[0].mode.references[0], seen[0].q)
        if all(other[:2] != (expected.kind, expected.name) for other in seen[-1].together):
            found = "nothing" if event is None else f"{event[1]} {event[0]}"
            raise RoutesDisagree(
                f"'{question.text}': the closed form says that {expected.name} {expected.kind}, the numeric route that "
                f"{found} comes first. No answer is shown. This is a defect of freebody; please report the model"
            )
        numeric = _number(tree, question.quantity, piece, seen)
        witness.compare(draw, exact, numeric, partial(magnitude, question.quantity.dimension, seen[-1].snapshot()))
    return witness.evidence()


def run(tree: Tree, event: Event | None, piece: Piece, k: int, end: float | None) -> list[Seen]:
    """The motion of one parameter set up to the event of the piece; kept for other questions."""
    key = (
        tuple(id(n.phase) for n in piece.nodes),
        k,
        None if event is None else event.text,
        repr(piece.first and piece.first.watch.kind),
    )
    if key not in tree.seen:
        until = [MAX_TIME if end is None else 1.5 * end] * len(piece.nodes)
        phases = [n.phase for n in piece.nodes]
        tree.seen[key] = follow(tree.system, phases, tree.sets.one(k), until, event)
    return tree.seen[key]


def _number(tree: Tree, quantity: Quantity, piece: Piece, seen: list[Seen]) -> Any:
    last = seen[-1]
    now = last.snapshot()
    begin = seen[0].begin
    match quantity:
        case When():
            return last.time
        case Change(measure, _name):
            return now.value(measure) - begin.value(measure)
        case EnergyLost():
            if all(only_friction_takes_energy(s.mode.system) for s in seen):
                return _energy(tree, seen[0].mode, begin) - _energy(tree, last.mode, now)
            return sum(map(_heat, seen))
        case Work(of):
            pushes = [p for p in tree.system.pushes if p.load == of]
            return sum(begin.potential(p) - now.potential(p) for p in pushes)
        case Turns(body):
            marks = [begin.value(Angle(body)), *(s.snapshot().value(Angle(body)) for s in seen)]
            return float(np.abs(np.diff(marks)).sum()) / (2 * np.pi)
        case _:
            return value_in_mode(quantity, tree.system, last.mode.system, now)


def _heat(seen: Seen) -> float:
    """What friction turns into heat in one phase: its force by the way that it slips. Raises CannotAnswer where the
    force changes on the way."""
    begin, end = seen.mode.snapshot(seen.begin.q, seen.begin.v, seen.begin.t), seen.snapshot()
    total = 0.0
    for push in frictions(seen.mode.system):
        first, last = begin.law(push), end.law(push)
        if abs(last - first) > 1e-9 * max(abs(first), abs(last)):
            raise CannotAnswer("the friction changes along the motion, and its heat was not checked in numbers")
        total -= last * (end.value(push.measure) - begin.value(push.measure))  # type: ignore[arg-type]
    return total


def _energy(tree: Tree, mode: NumericMode, now: Any) -> float:
    return float(energy("total", None, plain(mode.system), now))
