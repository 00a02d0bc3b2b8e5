"""Mistakes in the model and in its equations: what is left out, counted twice or given the wrong sign."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import singledispatch, singledispatchmethod

from freebody.errors import CannotAnswer
from freebody.language.sentences import Argument, Message, Sentence
from freebody.model.elements import AppliedLoad, RigidBody
from freebody.narrative.mistakes.marked import Marked, MarkedFactor
from freebody.narrative.mistakes.slips import Mistake
from freebody.questions.base import Quantity
from freebody.questions.clock import Clock
from freebody.questions.energy import Energy
from freebody.questions.event_base import QuestionEvent
from freebody.questions.reading import Question
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy

ROUND = {"disk": Fraction(1, 2), "sphere": Fraction(2, 5), "ring": Fraction(1), "shell": Fraction(2, 3)}  # I/(m r^2)
# what is called by its energy where an energy is asked for
OF_ENERGY = (
    *("inertia", "pulley", "parallel_axes", "inertia_of_mass", "mass_times_acceleration", "all_inertia"),
    *("inertia_turned", "mass_turned", "inertia_twice", "inertia_half", "mass_twice", "mass_half"),
    *("load", "load_turned", "load_on", "load_on_turned", "inertia_of_masses", "inertias", "all_inertias"),
    *("weight", "weight_turned", "weight_on", "weight_on_turned"),
)
END_OF_ROD = 4  # times the moment of inertia about its middle


class Omissions:
    """The mistakes that the factors of a marked system allow."""

    def __init__(
        self, marked: Marked, question: Question, *, is_uniform: bool, groups: Sequence[tuple[str, ...]]
    ) -> None:
        self.marked = marked
        self.question = question
        self.is_uniform = is_uniform
        self.groups = groups  # bodies that are copies of each other
        self.field = marked.model.field
        self.system = marked.setup.system

    def __iter__(self) -> Iterator[Mistake]:
        """The most common ones first."""
        for body in self.system.moving:
            yield from self._body(body)
        for load in self.system.loads:
            yield from self._load(load)
        yield from self._motion()
        for group in self.groups:
            yield from self._copies(group)
        for body in self.system.moving:
            yield from self._sizes(body)

    def _put(self, value: int | Fraction | Ratio, *factors: MarkedFactor) -> dict[int, Ratio]:
        """The same value for some factors, as far as the system has them."""
        known = self.marked.factors
        return {known[f]: self.field.element(value) for f in factors if f in known}

    def _mistake(
        self, key: str, value: int | Fraction | Ratio, *factors: MarkedFactor, is_common: bool = True, **said: Argument
    ) -> Iterator[Mistake]:
        values = self._put(value, *factors)
        if values:
            yield Mistake(Sentence(f"{_section(self.question.quantity, key)}.{key}", said), values, is_common=is_common)

    # -- bodies -------------------------------------------------------------------------------
    def _body(self, body: RigidBody) -> Iterator[Mistake]:
        mass, inertia = MarkedFactor("mass", body.name), MarkedFactor("inertia", body.name)
        weights = [MarkedFactor("load", p.name) for p in self._weights(body.name)]
        name = body.name
        if inertia in self.marked.factors:
            key = "pulley" if self._is_gripped(name) else "inertia"
            yield from self._mistake(key, 0, inertia, body=name)
        if mass in self.marked.factors:
            # the factor stands in all equations; only in that of moments it is the axis that is taken wrongly
            is_moment = self.marked.with_speeds and self._turns_about_a_point(name)
            key = "parallel_axes" if is_moment else "inertia_of_mass"
            yield from self._mistake(key if body.turns else "mass_times_acceleration", 0, mass, body=name)
        if mass in self.marked.factors and inertia in self.marked.factors:
            yield from self._mistake("all_inertia", 0, mass, inertia, body=name)
        if weights and mass in self.marked.factors:
            yield from self._mistake("massless", 0, mass, inertia, *weights, body=name)
        yield from self._mistake("inertia_turned", -1, inertia, body=name)
        yield from self._mistake("mass_turned", -1, mass, body=name)

    def _sizes(self, body: RigidBody) -> Iterator[Mistake]:
        """Factors that come from formulas remembered wrongly."""
        name = body.name
        inertia, mass = MarkedFactor("inertia", name), MarkedFactor("mass", name)
        if inertia in self.marked.factors:
            yield from self._shapes(body, inertia)
        speed, turning = MarkedFactor("speed", name), MarkedFactor("turning", name)
        for key, value in (("twice", 2), ("half", Fraction(1, 2))):
            yield from self._mistake(f"speed_{key}", value, speed, turning, is_common=False, body=name)
            yield from self._mistake(f"turning_{key}", value, turning, is_common=False, body=name)
            yield from self._mistake(f"inertia_{key}", value, inertia, is_common=False, body=name)
            yield from self._mistake(f"mass_{key}", value, mass, is_common=False, body=name)
        yield from self._mistake("turning_turned", -1, turning, is_common=False, body=name)

    def _shapes(self, body: RigidBody, inertia: MarkedFactor) -> Iterator[Mistake]:
        scalar = self.marked.setup.model.geometry.scalar
        given = self.system.document.data.get("bodies", {}).get(body.name)
        if isinstance(given, dict) and "rod" in given:
            yield from self._mistake("rod_about_end", END_OF_ROD, inertia, body=body.name)
            return
        if body.radius is None or scalar(body.mass).is_zero():
            return
        radius = scalar(body.radius)
        own = (scalar(body.inertia) / (scalar(body.mass) * radius * radius)).fraction()
        if own is None or own == 0:
            return
        for shape, other in ROUND.items():
            if other != own:
                yield from self._mistake(f"shape_{shape}", other / own, inertia, body=body.name)

    def _is_gripped(self, body: str) -> bool:
        """Whether a string that does not slip on the body would have the same tension on both sides without its
        inertia."""
        rows = [r for r in self.system.constraint_rows if r.reaction == "tension" and body in set(r.measure.bodies())]
        return any(sum(r.connection == other.connection for r in rows) > 1 for other in rows)

    def _turns_about_a_point(self, body: str) -> bool:
        """Whether a pin on the ground holds the body."""
        joints = [c for c in self.system.connections if self.system.connections[c].kind in ("pin", "revolute")]
        held = [row for row in self.system.constraint_rows if row.connection in joints]
        return any(body in set(row.measure.bodies()) and len(self._moving(row.measure.bodies())) == 1 for row in held)

    def _moving(self, names: Iterator[str]) -> set[str]:
        return {name for name in names if not self.system.bodies[name].fixed}

    # -- loads --------------------------------------------------------------------------------
    def _weights(self, body: str) -> list[AppliedLoad]:
        gravity = {name for name, load in self.system.loads.items() if load.kind == "gravity"}
        return [p for p in self.system.applied_loads if p.load in gravity and body in set(p.measure.bodies())]

    def _load(self, load: str) -> Iterator[Mistake]:
        applied_loads = [p for p in self.system.applied_loads if p.load == load]
        everywhere = [MarkedFactor("load", p.name) for p in applied_loads]
        key = "weight" if self.system.loads[load].kind == "gravity" else "load"
        yield from self._mistake(key, 0, *everywhere, load=load)
        yield from self._mistake(f"{key}_turned", -1, *everywhere, load=load)
        if len(applied_loads) > 1:
            for push in applied_loads:
                bodies = tuple(sorted(self._moving(push.measure.bodies())))
                factor = MarkedFactor("load", push.name)
                yield from self._mistake(f"{key}_on", 0, factor, load=load, bodies=bodies)
                yield from self._mistake(f"{key}_on_turned", -1, factor, load=load, bodies=bodies)

    def _motion(self) -> Iterator[Mistake]:
        """Terms with velocities, the start, the integration, the event."""
        event = self.question.event
        yield from self._mistake("bias", 0, MarkedFactor("bias"))
        yield from self._mistake("bias_turned", -1, MarkedFactor("bias"))
        loads = [MarkedFactor("load", p.name) for p in self.system.applied_loads]
        q, half = self.question.quantity, Fraction(1, 2)
        if event is not None:
            yield from self._mistake("start", 0, MarkedFactor("start"))
            yield from self._mistake("start_turned", -1, MarkedFactor("start"))
            if isinstance(event, Clock):
                yield from self._of_kind(q)
                return
            if event.order == 0 and self.is_uniform and q.is_of_event:
                yield from self._mistake("half_of_time", 2, *loads)
            elif event.order == 0 and q.kinematic_order == 1:
                yield from self._mistake("half_of_speed" if self.is_uniform else "half_of_energy", half, *loads)
            yield from self._event()
        yield from self._of_kind(q)

    @singledispatchmethod
    def _of_kind(self, q: Quantity) -> Iterator[Mistake]:
        """What is mistaken in one kind of question only."""
        yield from ()

    @_of_kind.register(Energy)
    def _of_energy(self, q: Energy) -> Iterator[Mistake]:
        moving = [MarkedFactor(what, b.name) for b in self.system.moving for what in ("mass", "inertia")]
        yield from self._mistake("half_of_energy", 2, *moving)
        yield from self._mistake("kinetic", 0, *moving)
        names = tuple(b.name for b in self.system.moving)
        for what, key in (("mass", "inertia_of_masses"), ("inertia", "inertias")):
            yield from self._mistake(key, 0, *(MarkedFactor(what, name) for name in names), bodies=names)

    def _event(self) -> Iterator[Mistake]:
        """A drop taken for a way along an incline, or the other way round."""
        assert isinstance(self.question.event, QuestionEvent)
        f = self.field
        with_angles = self.marked.setup.model.geometry.scalar(self.question.event.value)
        for cos, sin in f.pairs(with_angles.generators()):
            if f.generators[cos].kind != "cos":
                continue
            for index in (sin, cos):
                x = f.variable(index)
                if index in with_angles.generators():
                    times = x if index in with_angles.denominator().generators() else 1 / x
                    yield from self._mistake("way", times, MarkedFactor("event"), way=tidy(with_angles * times))
        yield from self._mistake("way_twice", 2, MarkedFactor("event"), is_common=False)

    # -- copies -------------------------------------------------------------------------------
    def _copies(self, group: tuple[str, ...]) -> Iterator[Mistake]:
        whats = ("mass", "inertia")
        others = [MarkedFactor(what, body) for body in group[1:] for what in whats]
        loads = [
            MarkedFactor("load", p.name) for p in self.system.applied_loads if set(group[1:]) & set(p.measure.bodies())
        ]
        yield from self._mistake("counted_once", 0, *others, *loads, bodies=group)
        for what, key in (("mass", "inertia_of_masses"), ("inertia", "inertias")):
            yield from self._mistake(key, 0, *(MarkedFactor(what, b) for b in group), bodies=group)
        both = [MarkedFactor(what, body) for body in group for what in whats]
        yield from self._mistake("all_inertias", 0, *both, bodies=group)
        moving = [MarkedFactor(what, body) for body in group for what in ("speed", "turning")]
        yield from self._mistake("speeds_twice", 2, *moving, bodies=group)


def marked_omissions(
    marked: Marked, question: Question, groups: Sequence[tuple[str, ...]]
) -> tuple[tuple[Ratio, ...], Omissions]:
    """The answer in the factors, and what can go wrong with them. Raises CannotAnswer without a closed form."""
    answers, is_uniform = marked.closed_form(question)
    if not answers:
        raise CannotAnswer(Message("nothing is asked"))
    return answers, Omissions(marked, question, is_uniform=is_uniform, groups=groups)


@singledispatch
def _section(q: Quantity, key: str) -> str:
    """The part of the catalogue with the sentence about a mistake."""
    return "mistake"


@_section.register(Energy)
def _section_of_energy(q: Energy, key: str) -> str:
    return "mistake_energy" if key in OF_ENERGY else "mistake"
