"""Angular velocities of space as vectors: successive rotations add up, and both ways around a loop give the same.

    omega = sum of q' e        over the angles q from the ground to the body, e the unit vector along the axis of q.

Source: Ginsberg, Engineering Dynamics, 2008, sec. 3.3.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass

from freebody.language.expression import Expr, Symbol, VectorSymbol, add, multiply, number
from freebody.language.sentences import Argument, Sentence
from freebody.measures.geometry import Direction
from freebody.model.rotations import applied
from freebody.narrative.lines.glossary import World
from freebody.narrative.lines.script import Diagram, Legend
from freebody.narrative.principles.sides import positive_first, scaled
from freebody.narrative.space.spatial_frames import Frames, Vector
from freebody.narrative.space.spatial_loops import AngularLoop, AngularLoops, LoopNormal, Turning
from freebody.questions.motion import AngularVelocity, rates_of
from freebody.questions.vectors import components_of, dot
from freebody.symbolic.tidy import tidy


@dataclass(frozen=True)
class LoopProjection:
    """The scalar product of a loop with a vector, in which of the unknown rates only the wanted one is left."""

    loop: AngularLoop
    normal: LoopNormal
    wanted: str
    sides: tuple[Expr, Expr]


class VectorSums:
    """Writes sums of angular velocities as vectors. The unit vector of an angle has one number in all derivations."""

    def __init__(self, frames: Frames, given: Collection[str]) -> None:
        """given: angles whose rates need no loop."""
        self.frames, self.system, self.glossary, self.field = frames, frames.system, frames.glossary, frames.field
        self.given, self.loops = given, AngularLoops(frames, given)
        self._numbers = {name: k + 1 for k, name in enumerate(self.loops.measures)}
        self._told: set[str] = set()

    # -- symbols ------------------------------------------------------------------------------
    def unit_vector(self, name: str) -> VectorSymbol:
        """The unit vector along the axis of an angle."""
        taken = {*self.system.parameters, *self.glossary.measures}
        k = self._numbers[name]
        return VectorSymbol(f"e_{k}" if f"e_{k}" not in taken else f"u_{k}")

    def contribution(self, name: str) -> Expr:
        """q' e"""
        return multiply(rates_of(name, 1), self.unit_vector(name))

    def _introduce(self, turnings: Sequence[Turning]) -> None:
        """Unit vectors along axes, each explained once."""
        entries: list[tuple[Expr, Sentence, str]] = []
        new = [t for t in turnings if self.unit_vector(t.name).name not in self._told]
        new.sort(key=lambda t: self._numbers[t.name])
        what = Sentence("space.unit_vector", {"name": Symbol(new[0].name)}) if new else Sentence("")
        if len(new) > 1:
            what = Sentence("space.unit_vectors", {"names": tuple(Symbol(t.name) for t in new)})
        for turning in new:
            symbol = self.unit_vector(turning.name)
            self.glossary.introduce_vector(symbol, what, self._reads(turning))
            entries.append((symbol, what, ""))
            self._told.add(symbol.name)
        if entries:
            self.frames.script.add(Legend(tuple(entries)))

    def _reads(self, turning: Turning) -> Callable[[World], Sequence[float]]:
        """An axis in numbers: of a joint that closes a loop, as its own bodies have it."""
        for a in self.loops.cut:
            for k, (axis, _own, _measure) in enumerate(a.turns):
                if self.loops.label(a, k) == turning.name:
                    on_first, on_second = (a.first, applied(a.before, axis)), (a.second, applied(a.after, axis))
                    fixed = Direction(*(on_first if k == 0 else on_second))
                    return lambda world: tuple(map(float, components_of(fixed, world.snapshot, 3)))
        along = tuple(map(self.frames.express, turning.axes[0]))
        return lambda world: [float(self.field.evaluate(x, world.numbers)) for x in along]

    def _draw(self, turnings: Sequence[Turning], caption: str, **args: Argument) -> None:
        """The system with angular velocities along their axes."""
        self.frames.script.add(Diagram((), Sentence(caption, args), turning=tuple(t.name for t in turnings)))

    # -- along a chain ------------------------------------------------------------------------
    def added(self, body: str, names: Sequence[str]) -> int:
        """The angular velocity of a body as the sum over the angles by which it turns; the line."""
        turnings = [t for t in self.loops.chain(body) if t.name in names]
        symbol, quantity = VectorSymbol(f"omega_{body}"), AngularVelocity(body, 1)

        def reads(world: World) -> Sequence[float]:
            return tuple(quantity.value(self.system, world.snapshot))

        what = Sentence("space.omega_vector", {"body": body})
        self.glossary.introduce_vector(symbol, what, reads)
        self.frames.script.add(Legend(((symbol, what, "rad/s"),)))
        self._introduce(turnings)
        self._draw(turnings, "figure.turning", body=body)
        total = add(*(self.contribution(t.name) for t in turnings))
        return self.frames.script.line(symbol, total, why="space.vectors_added")

    # -- around a loop ------------------------------------------------------------------------
    def projection(self, wanted: str) -> LoopProjection | None:
        """The first loop that gives the rate of an angle by one scalar product; None where there is none."""
        for a in self.loops.cut:
            loop = self.loops.loop(a)
            names = [t.name for t in loop.all]
            if wanted not in names:
                continue
            unknown = [name for name in names if name not in self.given and name != wanted]
            normal = self.loops.normal(loop, wanted, unknown)
            if normal is None:
                continue
            sides = [self._projected(way, normal) for way in ((*loop.first, *loop.over), loop.second)]
            if sides[0] is not None and sides[1] is not None:
                return LoopProjection(loop, normal, wanted, (sides[0], sides[1]))
        return None

    def _projected(self, way: Sequence[Turning], normal: LoopNormal) -> Expr | None:
        """sum of q' (e . n), without the angles to whose axes n is perpendicular; None where an axis is not known."""
        terms: list[Expr] = []
        for turning in way:
            if turning.name in normal.across:
                continue
            axis = self.loops.free(turning)
            if axis is None:
                return None
            size = self.field.lowest_terms(self.field.element(dot(axis, normal.n)))
            terms += [] if size.is_zero() else [scaled(size, rates_of(turning.name, 1))]
        return positive_first(terms) if terms else number(0)

    def write(self, found: LoopProjection) -> int:
        """The sum around the loop, the axes, and the scalar product; the line of the last."""
        script, loop, normal = self.frames.script, found.loop, found.normal
        self._introduce(loop.all)
        self._draw(loop.all, "figure.turning_loop", body=loop.joint.second)
        one, other = (
            add(*(self.contribution(t.name) for t in way)) for way in ((*loop.first, *loop.over), loop.second)
        )
        start = script.line(one, other, why="space.vector_loop", args={"body": loop.joint.second})
        axes = [self._axis(t, self.loops.free(t)) for t in loop.all]
        told = tuple(line for line in axes if line is not None)
        n, shown = self._normal(normal), self.frames.shown(normal.n)
        across = tuple(self.unit_vector(name) for name in normal.across)
        args: dict[str, Argument] = {"n": n, "own": self.unit_vector(found.wanted), "across": across}
        if normal.beside is None:
            place = script.line(n, shown, why="space.normal", args=args, uses=told)
        else:
            share, name = normal.beside
            beside = self.unit_vector(name)
            args["beside"] = beside
            args["other"] = next((e for e in across if e != beside), beside)
            why = "space.normal_of_cross" if len(across) == 2 else "space.normal_beside"
            difference = add(self.unit_vector(found.wanted), multiply(tidy(-share), beside))
            place = script.line(n, difference, shown, why=why, args=args, uses=told)
        args = {"line": start, "n": n, "across": across}
        return script.line(*found.sides, why="space.scalar_product", args=args, uses=(start, *told, place))

    def _axis(self, turning: Turning, axis: Vector | None) -> int | None:
        """The components of a unit vector, as a line, where they are known."""
        if axis is None:
            return None
        e = self.unit_vector(turning.name)
        return self.frames.script.line(e, self.frames.shown(axis), why="space.axes_known")

    def _normal(self, normal: LoopNormal) -> VectorSymbol:
        taken = {*self.system.parameters, *self.glossary.measures}
        symbol = VectorSymbol("n" if "n" not in taken else "n_1")

        def reads(world: World) -> Sequence[float]:
            return [float(self.field.evaluate(x, world.numbers)) for x in normal.n]

        across = tuple(self.unit_vector(name) for name in normal.across)
        what = Sentence("space.normal_vector", {"across": across})
        self.glossary.introduce_vector(symbol, what, reads)
        self.frames.script.add(Legend(((symbol, what, ""),)))
        return symbol
