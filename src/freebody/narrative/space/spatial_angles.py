"""Angles that connections of space bind: the equation of each loop, differentiated, and the rate that follows."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from freebody.connections.shared_by_copies import copy_of_row
from freebody.errors import CannotAnswer
from freebody.language.expression import Call, Expr, Symbol
from freebody.language.sentences import Argument, Sentence
from freebody.measures.base import Measure
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.narrative.lines.glossary import Meaning
from freebody.narrative.lines.script import Legend
from freebody.narrative.principles.sides import balanced, readable
from freebody.narrative.space.spatial_frames import Frames
from freebody.narrative.space.spatial_vectors import VectorSums
from freebody.questions.motion import AngularVelocity, OfMeasure, rates_of
from freebody.questions.vectors import AXES
from freebody.study.eom import primitive_part
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy


class Angles:
    """Rates of the angles by which bodies are turned, each explained once."""

    def __init__(self, frames: Frames, introduced: Collection[str] = ()) -> None:
        """introduced: names that need no legend."""
        self.frames, self.system, self.glossary = frames, frames.system, frames.glossary
        self.model, self.bodies, self.field = frames.model, frames.bodies, frames.field
        self.independent = {c.name for c in self.model.coordinates}
        self.bound = {c.name for c in self.model.dependent}
        self.lines: dict[tuple[str, bool], tuple[int, ...]] = {}  # where a rate is told, with its angle or without
        self.tangents: dict[str, int] = {}  # by angle: where it is told by its tangent
        self._pending: dict[str, ConstraintRow] = {}  # what is being told, and by which row
        self._n_left_open = 0  # how often the telling of one angle came upon another one that is being told
        self._introduced: set[str] = set(introduced)
        self.vectors = VectorSums(frames, {n for n, m in self.bodies.tree.angles.items() if self._is_given(n, m)})

    def _is_given(self, name: str, measure: Measure) -> bool:
        """Whether the rate of an angle is free, or that of a driver."""
        driven = any(row.measure == measure and row.target is not None for row in self.system.constraint_rows)
        return driven or name in self.independent

    # -- symbols ------------------------------------------------------------------------------
    def introduce(self, names: Iterable[str]) -> None:
        """Joint angles that are no measures of the model, with their rates."""
        entries: list[tuple[Expr, Sentence, str]] = []
        for name in names:
            if name in self.system.measures:
                continue
            if name in self.bodies.turns_of_balls:
                self._introduce_turn(*self.bodies.turns_of_balls[name], name)
                continue
            measure = self.vectors.loops.measures[name]
            for order in (0, 1, 2):
                symbol = rates_of(name, order)
                what = self._meaning_of(name)
                self.glossary.introduce(Meaning(symbol, what, OfMeasure(measure, order, name)))
            if name not in self._introduced:
                entries.append((Symbol(name), self._meaning_of(name), "rad"))
                self._introduced.add(name)
        if entries:
            self.frames.script.add(Legend(tuple(entries)))

    def _introduce_turn(self, body: str, k: int, name: str) -> None:
        """Of what a component of the angular velocity is the rate: only that has a meaning in numbers."""
        said = Sentence("space.turn_of_ball", {"body": body, "axis": f"@{'xyz'[k]}"})
        for order in (1, 2):
            self.glossary.introduce(Meaning(rates_of(name, order), said, AngularVelocity(body, order, along=AXES[k])))

    def _meaning_of(self, name: str) -> Sentence:
        for a in self.system.attitudes:
            if any(self.vectors.loops.label(a, k) == name for k in range(len(a.turns))):
                return Sentence("space.joint_angle", {"connection": a.connection})
        return Sentence("space.free_angle")

    # -- rates --------------------------------------------------------------------------------
    def explain(self, names: Iterable[str], *, rates_only: bool = False) -> tuple[int, ...]:
        """Lines that tell the rates of angles that are not free; those that only velocities bind are left out.
        rates_only: nothing is wanted of where the angles are, so vectors will do where they lead there at once."""
        found: list[int] = []
        for name in names:
            if name in self.independent or name in self.bound:
                continue
            if name in self._pending:
                self._n_left_open += 1
                continue
            key, n_before = (name, rates_only), self._n_left_open
            lines = self.lines.get(key)
            if lines is None:
                lines = (self._by_vectors(name) if rates_only else None) or self._explained(name)
                if n_before == self._n_left_open or not self._pending:
                    self.lines[key] = lines
            found += lines
        return tuple(dict.fromkeys(found))

    def value(self, name: str) -> Ratio:
        """An angle in the coordinates that are left."""
        return self.frames.express(self.bodies.angle(name))

    def rate(self, name: str) -> Ratio:
        """Its rate in independent speeds."""
        return self.field.lowest_terms(self.model.in_independent_speeds(self.model.rate(self.value(name))))

    def _by_vectors(self, name: str) -> tuple[int, ...] | None:
        """By the sum of angular velocities around a loop; None where that does not lead there at once."""
        found = self.vectors.projection(name)
        if found is None:
            return None
        angles = [t.name for t in found.loop.all]
        self.introduce(angles)
        line = self.vectors.write(found)
        before = self.explain([n for n in angles if n in self.vectors.given])
        value, uses = readable(self.rate(name)), (line, *before)
        args: dict[str, Argument] = {"line": line, "lines": uses[1:]}
        why = "space.loop_solved" if len(uses) == 1 else "space.loop_solved_with"
        return (self.frames.script.line(rates_of(name, 1), tidy(value), why=why, args=args, uses=uses),)

    def _explained(self, name: str) -> tuple[int, ...]:
        row = self._row_for(name)
        if row is None:
            value = readable(self.rate(name))
            return (self.frames.script.line(rates_of(name, 1), tidy(value), why="space.rate_known"),)
        equation = self.model.equation(row)
        others = [n for n in self._angles_in(equation) if n != name]
        self.introduce([name, *others])
        # several that equations bind together are solved for with the last of these: the others are left open in it
        n_before = self._n_left_open
        self._pending[name] = row
        before = self.explain(others)
        del self._pending[name]
        is_left_open = bool(self._pending) and n_before != self._n_left_open
        args: dict[str, Argument] = {"connection": row.connection, "component": f"@{row.component}"}
        is_driven = row.reaction.startswith("driving ")
        why = f"constraint.{row.reaction.replace(' ', '_')}" if is_driven else "space.loop"
        if copy := copy_of_row(row.component):
            why, args["copy"] = "constraint.copy", copy
        place = self.frames.script.line(*balanced(tidy(primitive_part(equation))), why=why, args=args)
        lines = [place]
        tangent = self._tangent(equation, name, place)
        if tangent is not None:
            lines.append(tangent)
            self.tangents[name] = tangent
        raw = self.field.lowest_terms(self.field.rate(equation))
        sides, value = balanced(tidy(raw.numerator())), readable(self.rate(name))
        rate_line = self.frames.script.line(*sides, why="space.loop_rate", args={"line": place}, uses=(place,))
        if is_left_open:
            return (*before, rate_line)
        if sides == (rates_of(name, 1), tidy(value)):
            return (rate_line,)
        places = (self.tangents[n] for n in others if n in self.tangents)
        uses = tuple(dict.fromkeys((rate_line, *lines[1:], *places, *before)))
        key: dict[str, Argument] = {"line": rate_line, "lines": uses[1:]}
        why = "space.loop_solved" if len(uses) == 1 else "space.loop_solved_with"
        left = rates_of(name, 1)
        return (self.frames.script.line(left, tidy(value), why=why, args=key, uses=uses),)

    def _tangent(self, equation: Ratio, name: str, place: int) -> int | None:
        """a cos q + b sin q = 0 as tan q = -a/b."""
        pair = self.field.pair_of(self.field.index(self.bodies.angle(name)))
        if pair is None or self.field.index(self.bodies.angle(name)) in equation.generators():
            return None
        numerator = equation.numerator()
        in_cos = numerator.coefficients(pair[0])
        if len(in_cos) != 2 or pair[1] in in_cos[1].generators():
            return None
        in_sin = in_cos[0].coefficients(pair[1])
        if len(in_sin) != 2 or not in_sin[0].is_zero():
            return None
        value = tidy(self.field.lowest_terms(-in_cos[1] / in_sin[1]))
        left = Call("tan", Symbol(name))
        return self.frames.script.line(left, value, why="space.tangent", args={"line": place}, uses=(place,))

    # -- which equation -----------------------------------------------------------------------
    def _row_for(self, name: str) -> ConstraintRow | None:
        """The held row that binds an angle with the fewest others that are bound as well."""
        best: tuple[tuple[int, int], ConstraintRow] | None = None
        for row in self.system.constraint_rows:
            if isinstance(row.measure, NonholonomicForm) or row.name in self.bodies.tree.rows:
                continue
            if any(row is other for other in self._pending.values()):
                continue
            try:
                equation = self.model.equation(row)
            except (CannotAnswer, ZeroDivisionError):
                continue
            angles = self._angles_in(equation)
            if name not in angles or not self._only_angles(equation):
                continue
            if row.if_needed and angles[0] == name:
                continue  # that others are like it tells these
            rank = len([a for a in angles if a not in self.independent and a != name]), len(equation.num)
            if best is None or rank < best[0]:
                best = rank, row
        return None if best is None else best[1]

    def _angles_in(self, x: Ratio) -> list[str]:
        inside = self.field.ingredients(x)
        return [n for n in self.bodies.tree.angles if self.field.index(self.bodies.angle(n)) in inside]

    def _only_angles(self, x: Ratio) -> bool:
        """Whether nothing else moves in an equation."""
        own = {self.field.index(self.bodies.angle(n)) for n in self.bodies.tree.angles}
        return all(self.field.generators[g].kind != "coordinate" or g in own for g in self.field.ingredients(x))
