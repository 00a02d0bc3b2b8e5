"""The constraint doctor: how many freedoms, which constraints depend on each other and why, what the pose is.

The Gruebler-Kutzbach count is compared with the rank of the constraint Jacobian: at the pose where dimensions are
given, at random values where they are symbols, in generic geometry where a file leaves them open. Where the two
differ, the minimal dependent sets are named, and whether a dependence is generic, due to special geometry, or of this
pose alone.
"""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import numpy as np

from freebody.assess.counts import judge_count
from freebody.assess.verdict import Judgement
from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, in_turn
from freebody.model.elements import NonholonomicForm, Start
from freebody.numeric.jets import Array
from freebody.numeric.mobility.coordinates import independent_measures
from freebody.numeric.mobility.described import described
from freebody.numeric.mobility.generic import generic_rank
from freebody.numeric.mobility.idle import idle_motions
from freebody.numeric.mobility.kinds import Dependence, dependences
from freebody.numeric.mobility.rank import Rank, rank_at
from freebody.numeric.mobility.reachable import reachable_dimensions
from freebody.numeric.reference import Reference
from freebody.questions.reading import Question
from freebody.study.answering.draws import SEED, draws
from freebody.study.mobility.conflicts import conflict
from freebody.study.mobility.found import Basis, Mobility, asked
from freebody.study.mobility.gruebler import Gruebler, gruebler
from freebody.study.mobility.mechanism import WantedFigures, motions_of
from freebody.study.worded import in_words
from freebody.system.system import System

_MOST_DRAWN = 8  # bodies without dimensions, up to which coordinates are named
_N_NEARBY = 4  # nearby poses more than freedoms
_NEARBY = 0.2  # how far they are, by the size or in radians
_STEP = 0.02  # part of that which counts as a motion


@in_words
def mobility(system: System, along: str | None = None, *, assembly_modes: bool = False) -> Mobility:
    """Examines a system. `along`: a driver, or a named measure, along which its motion is followed whatever its size;
    `assembly_modes`: look for those of a large mechanism, too.

    What touches at the start is held in touch, and what sticks where it is.

    Raises InputError for an unknown name, CannotAnswer if the motion cannot be followed along it."""
    rubbing = tuple(dict.fromkeys(rub.row.connection for rub in system.dry_friction))
    if system.bounds or rubbing:
        from freebody.study.settled import settled

        system = settled(system, forces=False)
    system = system.without_states
    count = gruebler(system, rubbing)
    if system.unspecified:
        if along is not None:
            raise CannotAnswer(
                Message(
                    "to follow {along}, dimensions are needed: {names} are open",
                    along=along,
                    names=", ".join(system.unspecified),
                )
            )
        # in space the directions of axes count, and these are given: lengths alone are drawn
        return _answered(_of_symbols(system, count) if system.space else _of_topology(system, count))
    if not system.has_values:
        if along is not None:
            missing = [p.name for p in system.parameters.values() if p.value is None and p.form is None]
            raise CannotAnswer(
                Message("to follow {along}, numbers need a value for {names}", along=along, names=", ".join(missing))
            )
        return _answered(_of_symbols(system, count))
    reference = Reference(system)
    try:
        q = reference.assemble()
    except CannotAnswer as error:
        return _answered(_contradictory(system, count, error, along))
    return _answered(_at_pose(system, count, reference, q, "pose", WantedFigures(along, assembly_modes)))


# -- where -----------------------------------------------------------------------------------
def _of_topology(system: System, count: Gruebler) -> Mobility:
    rank = generic_rank(system)
    found = tuple(
        Dependence(
            rows, tuple(dict.fromkeys(r.split(".")[0] for r in rows)), "generic", Message("holds for any dimensions")
        )
        for rows in rank.circuits
    )
    note = Message(
        "{names} are open: the rank holds for all but special dimensions", names=in_turn([*system.unspecified])
    )
    return Mobility(system, count, "topology", rank, None, found, {}, _drawn(system, rank), None, None, notes=(note,))


def _drawn(system: System, rank: Rank) -> tuple[str, ...]:
    """Independent coordinates at random dimensions, where some are found that fit together."""
    if len(system.moving) > _MOST_DRAWN or not rank.n_freedoms or system.space:
        return ()
    try:
        draw = draws(system, 1)[0]
        names = tuple(name for name, _measure in independent_measures(draw.reference, draw.q))
    except CannotAnswer:
        return ()
    return names if len(names) == rank.n_freedoms else ()


def _of_symbols(system: System, count: Gruebler) -> Mobility:
    """At random values of the symbols; what they share (a length, an angle) they share there too."""
    try:
        found = draws(system, 1)[0]
    except CannotAnswer as error:
        note = Message(
            "no values of the symbols were found that fit together ({why}): the rank is that of {what} that do",
            why=error,
            what=Message("dimensions and directions" if system.space else "dimensions"),
        )
        return replace(_of_topology(system, count), notes=(note,))
    q = found.q
    if not system.start and all(b.start.angle is None for b in system.moving):
        q = found.anywhere(SEED, 0.0, 0.3).q  # nobody meant the angles to be zero
    study = _at_pose(system, count, found.reference, q, "symbols", WantedFigures())
    return replace(study, notes=(Message("parameters without a value have random ones"), *study.notes))


def _contradictory(system: System, count: Gruebler, error: CannotAnswer, along: str | None) -> Mobility:
    """A system that cannot be assembled: because of its start, or at all."""
    found = conflict(system)
    if found is None or along is not None:
        raise error  # something else is the matter, or there is no motion to follow
    if not found.is_geometric:
        loose = _without_start(system)
        reference = Reference(loose)
        try:
            q = reference.assemble(guess=described(reference))
        except CannotAnswer:
            pass
        else:
            study = _at_pose(system, count, reference, q, "pose", WantedFigures())
            note = Message("looked at a pose that can be assembled, not at the start of the file")
            return replace(study, contradiction=found, notes=(note, *study.notes))
    rank = generic_rank(system)
    note = Message("the rank is that of the same connections with dimensions that fit together")
    return Mobility(system, count, "topology", rank, None, (), {}, (), found, None, notes=(note,))


def _without_start(system: System) -> System:
    """The system with its start as a guess only."""
    bodies = {
        name: body if body.fixed else replace(body, start=Start(near=body.start.with_guess()))
        for name, body in system.bodies.items()
    }
    return replace(system, bodies=bodies, start={}, start_rates={})


# -- at a pose --------------------------------------------------------------------------------
def _at_pose(
    system: System, count: Gruebler, reference: Reference, q: Array, basis: Basis, wanted: WantedFigures
) -> Mobility:
    rank = rank_at(reference, q)
    found = dependences(reference, q, rank)
    idle = idle_motions(reference, q)
    n_idle = sum(map(len, idle.values()))
    nearby = max(n_idle, _nearby(reference, q, rank))
    if nearby < rank.n_freedoms and all(d.kind != "momentary" for d in found):
        # nothing nearby: the rows are as dependent as the count says, but what they leave is no motion
        found = tuple(replace(d, kind="momentary", is_shaky=True) for d in found)
    independent = independent_measures(reference, q)
    motions = motions_of(system, reference, q, count, nearby, independent, wanted) if basis == "pose" else None
    notes: list[str] = []
    loose = [b.name for b in system.moving if all(b.name not in row.measure.bodies() for row in system.constraint_rows)]
    if loose:
        notes.append(Message("connected with nothing: {names}", names=in_turn(loose)))
    if count.drivers:
        free = len(q) - rank_at(reference, q, without=count.drivers).rank
        without = in_turn([*count.drivers])
        if free == 1:
            notes.append(Message("without {names}: 1 degree of freedom", names=without))
        else:
            notes.append(Message("without {names}: {n} degrees of freedom", names=without, n=free))
    if system.space and motions is not None and n_idle and nearby - n_idle == 1:
        notes.append(Message("the motion is not followed, since idle freedoms come with it"))
    holds_rates = any(isinstance(row.measure, NonholonomicForm) for row in system.constraint_rows)
    reachable = reachable_dimensions(reference, q) if holds_rates and not count.drivers else None
    over_driven = _over_driven(reference, q) if len(count.drivers) > 1 and rank.circuits else None
    if over_driven is not None:
        notes.append(over_driven)
    return Mobility(
        system,
        count,
        basis,
        rank,
        nearby,
        found,
        {body: in_turn(what, "{first} and {second}") for body, what in idle.items()},
        tuple(n for n, _m in independent),
        None,
        motions,
        n_idle,
        reachable,
        notes=tuple(notes),
        is_over_driven=over_driven is not None,
    )


def _over_driven(reference: Reference, q: Array) -> Message | None:
    """That drivers lead the same freedom at different rates, if they do."""
    try:
        reference.velocities(q, with_start=False)
    except CannotAnswer as error:
        return Message("over-driven: {why}", why=error)
    return None


def _nearby(reference: Reference, q: Array, rank: Rank) -> int:
    """Freedoms of the motions that start here: as many as nearby poses have, and as directions in which there are any.
    What moves to first order only is not among them."""
    if not rank.circuits or not rank.n_freedoms:
        return rank.n_freedoms
    free: list[int] = []
    moves: list[Array] = []
    for seed in range(rank.n_freedoms + _N_NEARBY):
        try:
            there, _v = reference.wander(q, np.random.default_rng(seed), _NEARBY)
        except CannotAnswer:
            continue
        move = reference.frame.difference(there, q) / reference.sizes.unit_moves
        if float(np.abs(move).max()) > _STEP * _NEARBY:
            free.append(rank_at(reference, there).n_freedoms)
            moves.append(move / np.linalg.norm(move))
    if not moves:
        return 0
    reached = int(np.linalg.matrix_rank(np.array(moves), tol=_STEP))
    return min(*free, reached, rank.n_freedoms)


# -- answers and advice -----------------------------------------------------------------------
def _answered(found: Mobility) -> Mobility:
    """With the questions of the file on degrees of freedom answered."""
    answers = {q.id: judge_count(q, found.finite_freedom, _mistakes(found)) for q in asked(found.system)}
    return replace(found, answers=answers)


def judged(system: System, question: Question, n: int) -> Judgement:
    """Options on degrees of freedom, judged where the number n is known; what leads to wrong ones is told."""
    return judge_count(question, n, _mistakes_of(system))


@lru_cache(maxsize=8)
def _mistakes_of(system: System) -> dict[int, str]:
    return _mistakes(mobility(system))


def _mistakes(found: Mobility) -> dict[int, str]:
    """Wrong numbers that a known mistake leads to."""
    n, count = found.finite_freedom, found.gruebler
    told: dict[int, str] = {}
    for k in range(1, len(count.loads) + 1):
        told[n - k] = Message("loads ({loads}) remove no degree of freedom", loads=", ".join(count.loads))
    if len(count.loads) == 1:
        told[n - 1] = Message("{load} is a load and removes no degree of freedom", load=count.loads[0])
    pins = [c for c in count.connections if c.n == 2]
    slots = [c.connection for c in count.connections if c.n == 1 and not c.is_driver]
    if slots and not count.space:
        told[n - len(slots)] = Message(
            "would be so if {slots} were fixed points; each holds one direction only", slots=", ".join(slots)
        )
    if count.drivers:
        told[n + len(count.drivers)] = Message(
            "is without {drivers}, which is led and holds one freedom", drivers=", ".join(count.drivers)
        )
    if len(pins) > 1:
        told.setdefault(n + 1, Message("is one too many: a constraint was not counted"))
    if found.n_idle:
        who = in_turn(
            [Message("{body} {does}", body=body, does=what) for body, what in found.idle.items()],
            "{first} and {second}",
        )
        told[found.useful_freedom] = Message("leaves out that {who} with nothing else moving", who=who)
    told[count.n_coordinates] = Message("counts the bodies as if nothing joined them")
    if count.count != n:
        told[count.count] = (
            Message(
                "is the count n L - K, which does not see that {rows} depend on each other",
                rows=", ".join(found.redundant[0]),
            )
            if found.redundant
            else Message("is the count n L - K")
        )
    told.pop(n, None)
    return told
