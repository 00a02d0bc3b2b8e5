"""The equilibria of a system: where it rests, whether it stays there, and what holds it.

A rest is a pose in which the loads do no work on any motion that the connections allow (virtual power); there the
connections carry what is left of them, Q + J^T lambda = 0. Reactions have the sign that people give them: a string
pulls, a contact pushes with a positive one. See `numeric.equilibrium` for how rests are found, `numeric.vibration`
for what stability means. Angles in rad, SI units.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import free_symbols
from freebody.language.sentences import Message, in_turn
from freebody.measures.base import Measure
from freebody.measures.distance import Bearing
from freebody.model.elements import NonholonomicForm
from freebody.model.states import state_name
from freebody.numeric.equilibrium import RestSearch
from freebody.numeric.families import goes_on, nearest_of_family
from freebody.numeric.instant import UNIQUE
from freebody.numeric.jet_geometry import JetGeometry
from freebody.numeric.jets import TIME, Array
from freebody.numeric.reference import Reference
from freebody.numeric.rest import CountedPose, LoadBalance
from freebody.numeric.small_motion import LinearisationPoint, SmallMotion, gradient_of
from freebody.numeric.vibration import Stability, stability
from freebody.study.given import formula, named_measure
from freebody.study.settled import without_friction
from freebody.study.small_motion.found import Equilibria, FoundEquilibrium, unit_of
from freebody.study.where_true import left_at
from freebody.study.worded import in_words
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF, ROUNDED

Guess = Mapping[str, str | float]
_TURNED = 1e-9  # of an angle of a line: half a turn is half a turn to the left


@in_words
def equilibria(system: System, guesses: Sequence[Guess] = ()) -> Equilibria:
    """The equilibria of a system; with guesses (values of named measures, as numbers in SI or as text such as
    "20 deg") only those to which searches from there lead.

    Without guesses the search starts from the model's start and from tours along its free coordinates: with one degree
    of freedom that is the whole branch, with more it is a sample. Parameters need values. Drivers are held at t = 0.
    Raises CannotAnswer where there is none, naming what keeps accelerating."""
    search = _EquilibriumSearch(without_friction(system))
    return search.found(search.from_guesses(guesses) if guesses else search.statics.rests(), bool(guesses))


@in_words
def nearest_equilibrium(system: System, guess: Guess | None = None) -> Equilibria:
    """The equilibrium nearest to the start, or the one to which a guess leads, alone. Raises as `equilibria`."""
    search = _EquilibriumSearch(without_friction(system))
    if guess is not None:
        return search.found(search.from_guesses([guess]), True)
    statics = search.statics
    balances = statics.rests() if search.dof == 1 else (statics.near_start() or statics.rests())
    found = search.found(balances, False)
    return replace(found, rests=found.rests[:1])


def refuse_out_of_bounds(system: System, reference: Reference, q: Array) -> None:
    """Raises CannotAnswer for a rest in which the model is not true: beyond a stop, or where its strings, loads and
    contacts say that they end."""
    there = reference.snapshot(q, np.zeros_like(q), 0.0)
    if (left := left_at(system, reference, there)) is not None:
        raise CannotAnswer(Message("at the equilibrium it is not so that {purpose}", purpose=left.purpose))
    for stop in system.bounds:
        if stop.within or isinstance(stop.row.measure, NonholonomicForm):
            continue
        target = 0.0 if stop.row.target is None else reference.number(stop.row.target)
        if stop.row.sign * (float(there.value(stop.row.measure)) - target) < -ROUNDED:
            raise CannotAnswer(Message("the equilibrium lies beyond {stop}", stop=stop.name))


def about_rest(system: System, reference: Reference, pose: CountedPose) -> SmallMotion:
    """The small motions of a system about a rest, which `reference` has found. The states of controllers, which statics
    takes for places, are the rates of their integrals."""
    at = LinearisationPoint(pose.q, np.zeros_like(pose.q), 0.0, pose.branches, frozen=True)
    if not system.states:
        return SmallMotion(reference, at)
    q, v = pose.q.copy(), np.zeros_like(pose.q)
    for state in system.states.values():
        own = list(reference.columns(state.carrier))
        v[own], q[own] = pose.q[own], 0.0
    in_motion = Reference(system)
    in_motion.assemble()
    return SmallMotion(in_motion, replace(at, q=q, v=v))


class _EquilibriumSearch:
    """The equilibria of one system."""

    def __init__(self, system: System) -> None:
        self.system = system.at_rest
        self.reference = Reference(self.system)
        self._in_motion = system
        self.statics = RestSearch(self.reference)
        self.dof = len(self.statics.balance(self.statics.start).residual)

    def found(self, balances: list[LoadBalance], guessed: bool) -> Equilibria:
        """What there is to say of some rests; without guesses the nearest to the start come first."""
        if not balances:
            raise CannotAnswer(self._why_none(guessed))
        if not guessed:
            balances = [nearest_of_family(self.statics, b, self.statics.start) for b in balances]
        judged = [(b, *self._judged(b)) for b in balances]
        if not guessed:
            judged.sort(key=lambda found: self._distance(found[0], found[1]))
        rests = tuple(self._rest(b, s, why) for b, s, why in judged)
        searched = "" if guessed else self._searched()
        notes = tuple(dict.fromkeys(note for note in (searched, *self._notes()) if note))
        return Equilibria(self.system, self.dof - len(self.system.states), rests, notes, self.reference, searched)

    def from_guesses(self, guesses: Sequence[Guess]) -> list[LoadBalance]:
        found: list[LoadBalance] = []
        for guess in guesses:
            wanted = [
                (name, named_measure(self.system, name), self.reference.number(formula(self.system, name, value)))
                for name, value in guess.items()
            ]
            near = self.statics.at_measures(self.statics.start, wanted)
            rest = self.statics.rest_near(near) or self.statics.lowest_near(near)
            if rest is not None and all(not self.statics.is_same(rest, other) for other in found):
                found.append(rest)
        return found

    def _distance(self, b: LoadBalance, s: Stability) -> tuple[float, bool]:
        """From the start; of two as near the stable one comes first."""
        return round(self.statics.apart(b.pose, self.statics.start), 6), s.verdict != "stable"

    # -- stability ----------------------------------------------------------------------------
    def _stability(self, b: LoadBalance) -> Stability:
        return stability(about_rest(self._in_motion, self.reference, b.pose))

    def _judged(self, b: LoadBalance) -> tuple[Stability, str]:
        """The stability, with neutral meant only where rests go on in every direction without stiffness; and why there
        is no linearisation to decide on it, as where a buffer is just reached."""
        try:
            s = self._stability(b)
        except CannotAnswer as error:
            return Stability("undecided by the linearisation", None, "", None), str(error)
        family = tuple(x for x in s.soft if goes_on(self.statics, b, x))
        if s.verdict == "neutral" and len(family) < len(s.soft):
            return replace(s, verdict="undecided by the linearisation", soft=family), ""
        return replace(s, soft=family), ""

    # -- one rest -----------------------------------------------------------------------------
    def _rest(self, b: LoadBalance, s: Stability, why_undecided: str) -> FoundEquilibrium:
        system, reference = self.system, self.reference
        g = self.statics.geometry(b.pose)
        values: dict[str, float] = {}
        for name, measure in system.all_measures.items():
            if gradient_of(reference, g, name, measure) is not None:  # a line without length has no angle
                values[state_name(name) or name] = _turned(reference.jet(g, measure, name).value, measure)
        reactions, shared = self._reactions(b)
        notes = [
            Message(
                "{connection} would have to push there ({reaction} {N:.6g} N), so it does not hold this pose"
                if row.reaction == "tension"
                else "{connection} would have to pull there ({reaction} {N:.6g} N), so it does not hold this pose",
                connection=row.connection,
                reaction=row.reaction,
                N=reactions[row.name],
            )
            for row in system.constraint_rows
            if row.unilateral and (reactions[row.name] or 0.0) < -ROUND_OFF * float(np.abs(b.forces).max(initial=0.0))
        ]
        if why_undecided:
            notes.append(Message("its stability is not decided: {why}", why=why_undecided))
        neutral = tuple(dict.fromkeys(self._named_direction(b, x) for x in s.soft))
        if neutral:
            notes.append(Message("one of a family: free to rest anywhere along {names}", names=in_turn(neutral)))
        scale = b.scale or 1.0
        return FoundEquilibrium(
            values,
            {body.name: reference.pose(b.pose.q, body.name) for body in system.moving},
            s.verdict,
            s.eigenvalue,
            s.of,
            "" if s.motion is None else self._named_direction(b, s.motion),
            neutral,
            reactions,
            shared,
            b.error / scale,
            tuple(notes),
            b.pose,
        )

    def _reactions(self, b: LoadBalance) -> tuple[dict[str, float | None], tuple[str, ...]]:
        """Reactions by row, and the names of those that the loads do not determine."""
        empty = b.split.left_null
        found: dict[str, float | None] = {}
        for k, row in enumerate(self.system.constraint_rows):
            if state_name(row.connection):
                continue
            is_unique = float(np.linalg.norm(empty[k])) <= UNIQUE
            found[row.name] = row.sign * float(b.multipliers[k]) + 0.0 if is_unique else None
        return found, tuple(name for name, value in found.items() if value is None)

    def _named_direction(self, b: LoadBalance, motion: Array) -> str:
        """The measure, else the body, that a motion moves most."""
        return moved_most(self.reference, self.statics.geometry(b.pose), motion)

    # -- what to say --------------------------------------------------------------------------
    def _searched(self) -> str:
        if self.dof < 2 or self.statics.is_single:
            return ""
        if self.system.states:
            return Message("found by {n} searches; there may be more", n=self.statics.n_searches)
        return Message(
            "found by {n} searches; with {dof} degrees of freedom there may be more",
            n=self.statics.n_searches,
            dof=self.dof,
        )

    def _notes(self) -> Iterator[Message]:
        for row in self.system.constraint_rows:
            if isinstance(row.measure, NonholonomicForm):
                yield Message(
                    "{connection} binds velocities only, so the system rests in other poses as well",
                    connection=row.connection,
                )
        if self.dof == 0:
            yield Message("nothing can move (0 degrees of freedom): this is the one pose, with its reactions")
        for row in self.system.constraint_rows:
            if row.is_driven:
                yield Message("{connection} is held at its value at t = 0", connection=row.connection)
        for push in self.system.applied_loads:
            if TIME in free_symbols(push.law):
                yield Message("{load} has its value at t = 0", load=push.load)

    def _why_none(self, guessed: bool) -> str:
        """What keeps accelerating, from the start at rest."""
        start = self.statics.start
        s = self.reference.snapshot(start.q, self.reference.velocities(start.q, with_start=False))
        try:
            a = s.accelerations
        except CannotAnswer as error:
            return Message("no equilibrium was found; at the start {why}", why=error)
        name = moved_most(self.reference, self.statics.geometry(start), a)
        measure = self.system.measures.get(name)
        if measure is not None:
            unit = {"m": "m/s^2", "rad": "rad/s^2"}.get(unit_of(measure), f"{unit_of(measure)}/s^2")
            told = Message(
                "{x} keeps accelerating (at {a:.6g} {unit} from rest at the start)",
                x=name,
                a=s.acceleration(measure),
                unit=unit,
            )
        else:
            told = Message("{x} keeps accelerating", x=name)
        if guessed:
            return Message("no guess leads to an equilibrium; {what}. Guess other values", what=told)
        if self.dof == 1:
            return Message(
                "there is no equilibrium on the branch of the start: {what}. Guess a pose if there should be one",
                what=told,
            )
        return Message(
            "there is no equilibrium in reach of the start: {what}. Guess a pose if there should be one", what=told
        )


def moved_most(reference: Reference, g: JetGeometry, motion: Array) -> str:
    """The named measure with the largest part in a motion, by the size of the system; else the body."""
    best, most = "", 1e-6 * float(reference.sizes.relative(motion).max(initial=0.0))
    for name, measure in reference.system.all_measures.items():
        row = gradient_of(reference, g, name, measure)
        if row is None:
            continue
        part = abs(float(row @ motion))
        if unit_of(measure) == "m":
            part /= reference.sizes.length
        if part > most * (1.0 + ROUND_OFF):
            best, most = state_name(name) or name, part
    return best or reference.most_moved(motion)


def _turned(value: float, measure: Measure) -> float:
    """The angle of a line a half turn to the right as one to the left."""
    if isinstance(measure, Bearing) and abs(value + math.pi) < _TURNED:
        return math.pi
    return value + 0.0
