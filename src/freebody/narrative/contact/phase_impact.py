"""The collision with which a phase begins: restitution, friction in the impact, and impulse and momentum.

With P the impulse along the normal of a contact and F that of its friction, M u+ = M u- + J_n^T P + J_t^T F for the
speeds u of what moves, in the pose of the impact; Newton's law J_n u+ = -e J_n u-, and either J_t u+ = 0 (the slip ends
in the impact) or F = -s mu P (it goes on in the sense s). Forces of finite size have no impulse.
Source: Pfeiffer & Glocker, Multibody Dynamics with Unilateral Contacts, 1996, ch. 8; as every course has it in the
plane, e.g. Gross, Hauger, Schröder & Wall, Technische Mechanik 3, sec. 3.3.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

from freebody.errors import CannotAnswer
from freebody.language.expression import Call, Expr, Symbol, add
from freebody.language.sentences import Argument, Message, Sentence
from freebody.model.elements import ConstraintRow, DryFriction
from freebody.narrative.contact.phase_way import PhaseSegment, PhaseSequence, on_the_way
from freebody.narrative.contact.phase_worlds import CourseWorld
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.script import Legend, Script
from freebody.study.phases.evidence import impulses_in_numbers
from freebody.study.phases.impact import ClosedFormCollision
from freebody.study.phases.words import label
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.relations import readable
from freebody.symbolic.state import SymbolicState


@dataclass(frozen=True)
class ToldImpact:
    """The lines of a collision: of its impulses by row, and of the state just after it."""

    impulses: dict[str, int]
    after: tuple[int, ...]

    @property
    def lines(self) -> tuple[int, ...]:
        return (*self.impulses.values(), *self.after)


def tell_impact(script: Script, way: PhaseSequence, leg: PhaseSegment, before: tuple[int, ...]) -> ToldImpact:
    """The impulses of the collision with which a phase begins, and the places and speeds after it. before: lines of the
    state in which the phase before ended. Raises CannotAnswer where no closed form tells it."""
    impact = leg.node.impact
    if impact is None or impact.collision is None or impact.sudden is not None:
        raise CannotAnswer(
            Message("a blow and an impact at one instant have a closed form, but no derivation is written of it yet")
        )
    collision, impulses = impact.collision
    with script.stage("stage.impact", "hint.impact"), on_the_way(script, leg.course):
        return _Telling(script, way, leg, collision, dict(impulses), before).told()


@dataclass(frozen=True)
class _Telling:
    """One collision, line by line. impulses: in the field of the collision, by row."""

    script: Script
    way: PhaseSequence
    leg: PhaseSegment
    collision: ClosedFormCollision
    impulses: dict[str, Ratio]
    before: tuple[int, ...]

    def told(self) -> ToldImpact:
        script, names = self.script, tuple(dict.fromkeys(label(b.name) for b in self.collision.hits))
        script.say("impact.collides", names=names)
        script.say("impact.no_time")
        if self.before:
            script.say("blow.before_lines", lines=self.before)
        self._introduce_speeds()
        script.add(Legend(tuple((s, self._what(name), "") for name, s in self.symbols.items())))
        laws = (*self._restitution(), *self._friction(), *self._momenta())
        found = {name: self._impulse(name, laws) for name in self.symbols}
        return ToldImpact(found, self._after(laws, tuple(found.values())))

    # -- what is written ----------------------------------------------------------------------
    def shown(self, x: Ratio) -> Expr:
        """An element of the parameters, as it is in the pose of the impact."""
        return readable(self.way.tree.to_home(self.collision.setup, x))

    @cached_property
    def groups(self) -> dict[str, list[ConstraintRow]]:
        """The rows along which impulses act. What shares its impulses in more than one way, and drives all speeds
        alike, is one: the name of its first row, and all of them."""
        found: dict[str, list[ConstraintRow]] = {}
        for row in self.collision.struck:
            alike = [name for name, rows in found.items() if self._acts_alike(row, rows[0])]
            found.setdefault(alike[0] if alike else row.name, []).append(row)
        return found

    def _acts_alike(self, row: ConstraintRow, other: ConstraintRow) -> bool:
        shared = self.collision.shared_by
        if row.name not in shared or other.name not in shared or row.connection != other.connection:
            return False
        own, its = self._slopes(row), self._slopes(other)
        return all((row.sign * own[k] - other.sign * its[k]).is_zero() for k in own)

    @cached_property
    def symbols(self) -> dict[str, Expr]:
        """Of the impulses, by row; one for those that act alike."""
        one = len(self.groups) == 1 or len(self.collision.hits) == 1
        found: dict[str, Expr] = {}
        rubs = {rub.name for rub in self.collision.dry_friction}
        for row in (rows[0] for rows in self.groups.values()):
            letter = "F" if row.name in rubs else "P"
            name = letter if one else f"{letter}_{row.connection}"
            symbol = Symbol(self.leg.free_name(name))
            self.leg.glossary.introduce(Meaning(symbol, self._what(row.name), self._read(row), ""))
            found[row.name] = symbol
        return found

    def _what(self, name: str) -> Sentence:
        of = {rub.name: rub.of or rub.name for rub in self.collision.dry_friction}
        key = "symbol.impulse_of_friction" if name in of else "symbol.impulse_of"
        rows = self.groups[name]
        called = label(of.get(name, name)) if len(rows) == 1 else rows[0].connection
        return Sentence(key, {"connection": called})

    def _read(self, row: ConstraintRow) -> Callable[[World], float]:
        """The impulse in numbers, from the momenta before and after."""
        tree, node, place = self.way.tree, self.leg.node, self.leg.number - 1
        along = [part for one in self.groups[row.name] for part in self.collision.along(one)]
        parts = [(tree.numbers(tree.to_home(self.collision.setup, x)), r) for x, r in along]

        def read(world: World) -> float:
            assert isinstance(world, CourseWorld)
            last = world.run.seen[place - 1] if place else None
            total = impulses_in_numbers(tree, node, world.run.k, last)
            return self._sign(row.name) * total([(float(share[world.run.k]), part) for share, part in parts])

        return read

    def _sign(self, name: str) -> int:
        """Of the impulse along a row for the one that is written: a contact pushes, a string pulls."""
        return next((bound.row.sign for bound in self.collision.hits if bound.name == name), 1)

    def _introduce_speeds(self) -> None:
        """Coordinates that the phase after the impact has no more, where what collides stays together."""
        model, known = self.collision.model, self.leg.glossary
        for c in model.coordinates:
            measure = model.measure_of(c)
            if measure is not None and not known.is_known(c.name):
                what = Sentence("symbol.coordinate")
                known.introduce(
                    Meaning(Call("rate", Symbol(c.name)), what, lambda w, m=measure: float(w.snapshot.rate(m)), "")
                )

    def _in_speeds(self, slopes: dict[int, Ratio]) -> Expr:
        """sum of slope * speed, with the speeds just after the impact."""
        model = self.collision.model
        terms = [
            self.shown(slopes[c.speed]) * Call("rate", Symbol(c.name))
            for c in model.coordinates
            if c.speed in slopes and not slopes[c.speed].is_zero()
        ]
        return add(*terms)

    def _slopes(self, row: ConstraintRow) -> dict[int, Ratio]:
        """Of the rate of what a row measures, by the speeds, in the pose of the impact."""
        model, f = self.collision.model, self.collision.model.field
        rate = model.in_independent_speeds(SymbolicState(model).rate(row.measure))
        return {c.speed: self.collision.here(f.partial(rate, c.speed)) for c in model.coordinates}

    # -- the laws -----------------------------------------------------------------------------
    def _restitution(self) -> list[int]:
        """Newton: the gaps part at e times the speed at which they closed."""
        found: list[int] = []
        for bound in (b for b in self.collision.hits if b.name in self.groups):
            e = self.collision.here(self.collision.model.geometry.scalar(bound.restitution))
            rate = self.collision.rate(bound.row)
            key = "impact.stays" if e.is_zero() else "impact.restitution"
            rows = self.groups[bound.name]
            args: dict[str, Argument] = {"connection": label(bound.name) if len(rows) == 1 else rows[0].connection}
            left, right = self._in_speeds(self._slopes(bound.row)), self.shown(-e * rate)
            found.append(self.script.line(left, right, why=key, args=args, uses=self.before, when="start"))
        return found

    def _friction(self) -> list[int]:
        return [self._friction_of(rub) for rub in self.collision.dry_friction]

    def _friction_of(self, rub: DryFriction) -> int:
        """Whether the slip ends in the impact, or friction slides on at its limit."""
        f = self.collision.model.field
        slopes = self._slopes(rub.row)
        after = f.zero
        for c in self.collision.model.coordinates:
            total = self.collision.start.of(c.speed) + self.collision.total(self._acceleration(c.speed), self.impulses)
            after = after + slopes[c.speed] * total
        args: dict[str, Argument] = {"connection": label(rub.of or rub.name)}
        if f.lowest_terms(after).is_zero():
            left = self._in_speeds(slopes)
            return self.script.line(left, self.shown(f.zero), why="impact.slip_ends", args=args, when="start")
        ratio = f.lowest_terms(self.impulses[rub.name] / (self._sign(rub.of) * self.impulses[rub.of]))
        right = self.shown(ratio) * self.symbols[rub.of]
        return self.script.line(self.symbols[rub.name], right, why="impact.slides", args=args, when="start")

    def _acceleration(self, speed: int) -> Ratio:
        model = self.collision.model
        k = next(k for k, c in enumerate(model.coordinates) if c.speed == speed)
        return model.dynamics.solved_accelerations[model.accelerations[k]]

    @cached_property
    def struck(self) -> list[int]:
        """The coordinates to which impulses act, or which others that they act to carry along, by their places."""
        model = self.collision.model
        rows = [self._slopes(row) for row in self.collision.struck]
        table = [[not self.collision.here(x).is_zero() for x in row] for row in model.dynamics.mass_matrix]
        found = {k for k, c in enumerate(model.coordinates) if any(not row[c.speed].is_zero() for row in rows)}
        while more := {j for k in found for j, coupled in enumerate(table[k]) if coupled} - found:
            found |= more
        return sorted(found)

    def _momenta(self) -> list[int]:
        """For each coordinate: the momentum that belongs to it after the impact is that before and the impulses."""
        self.script.say("impact.momenta")
        return [self._momentum(k) for k in self.struck]

    def _momentum(self, k: int) -> int:
        model, f = self.collision.model, self.collision.model.field
        c, row = model.coordinates[k], model.dynamics.mass_matrix[k]
        entries = {d.speed: self.collision.here(x) for d, x in zip(model.coordinates, row, strict=True)}
        before = f.zero
        for d in model.coordinates:
            before = before + entries[d.speed] * self.collision.start.of(d.speed)
        brought: list[Expr] = []
        for one in (rows[0] for rows in self.groups.values()):
            slope = self._slopes(one)[c.speed]
            if not slope.is_zero():
                brought.append(self.shown(self._sign(one.name) * slope) * self.symbols[one.name])
        right = add(self.shown(f.lowest_terms(before)), *brought)
        args: dict[str, Argument] = {"name": Symbol(c.name)}
        return self.script.line(
            self._in_speeds(entries), right, why="impact.momentum", args=args, uses=self.before, when="start"
        )

    # -- what follows -------------------------------------------------------------------------
    def _impulse(self, name: str, laws: tuple[int, ...]) -> int:
        f, sign = self.collision.model.field, self._sign(name)
        value = self.shown(f.lowest_terms(sign * sum((self.impulses[r.name] for r in self.groups[name]), f.zero)))
        args: dict[str, Argument] = {"lines": laws}
        return self.script.line(self.symbols[name], value, why="blow.solved", args=args, uses=laws, when="start")

    def _after(self, laws: tuple[int, ...], impulses: tuple[int, ...]) -> tuple[int, ...]:
        """The places and speeds with which the phase begins."""
        start, found = self.leg.phase.start, list[int]()
        uses = (*laws, *impulses)
        names = [c.name for c in self.collision.model.coordinates]
        struck = {names[k] for k in self.struck}
        for c in self.leg.phase.model.coordinates:
            symbol, place, speed = Symbol(c.name), start.of(c.index), start.of(c.speed)
            if c.name in names and c.name not in struck and speed.is_zero():
                continue  # rests, and is not struck
            if not place.is_zero():
                value = self.way.shown(self.leg, place)
                found.append(self.script.line(symbol, value, why="blow.place", uses=self.before, when="start"))
            value = self.way.shown(self.leg, speed)
            found.append(
                self.script.line(
                    Call("rate", symbol), value, why="blow.solved", args={"lines": uses}, uses=uses, when="start"
                )
            )
        return tuple(found)
