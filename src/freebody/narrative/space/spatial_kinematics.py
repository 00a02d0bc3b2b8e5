"""Velocities in space: angular velocities added up axis by axis, places differentiated, rolling without slip.

    omega = sum over the joints from the ground of (rate of angle) * (axis),        v_P = dr_P/dt,
    v_contact = v_centre + omega x r = 0    where a body rolls on what is at rest.

Source: Ginsberg, Engineering Dynamics, 2008, sec. 3.3-3.6.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence

from freebody.language.expression import Call, Expr, Symbol, add, number, rate_key
from freebody.language.sentences import Argument, Sentence
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, Direction, Point
from freebody.model.elements import BodyPlane, NonholonomicForm, RigidBody
from freebody.narrative.lines.glossary import Glossary, Meaning, World
from freebody.narrative.lines.rates import rate_of
from freebody.narrative.lines.script import Script
from freebody.narrative.principles.loops import bound_speeds, closed_loops, velocity_constraints
from freebody.narrative.principles.rolling import contact_arm, rolling_body
from freebody.narrative.principles.sides import scaled
from freebody.narrative.space.spatial_angles import Angles
from freebody.narrative.space.spatial_frames import Axes, Frames, Vector, axes_of
from freebody.questions.motion import AngularVelocity, OfPoint, rates_of
from freebody.questions.vectors import AXES, ORIGIN, components_of, cross, dot
from freebody.study.setup import Setup
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.system.system import System


class SpatialKinematics(Frames):
    """Writes what moves how, each vector once for each set of axes."""

    def __init__(self, setup: Setup, glossary: Glossary, script: Script, introduced: Collection[str] = ()) -> None:
        """introduced: names of angles that need no legend."""
        super().__init__(setup, glossary, script)
        self.angles = Angles(self, introduced)
        self.told: dict[tuple[str, ...], tuple[tuple[Expr, ...], int]] = {}  # components and line
        self.velocity_lines: tuple[int, ...] | None = None  # what binds velocities alone
        self._axes_told: set[tuple[str, str]] = set()  # of angles, and along the axes of which body

    def begin(self) -> None:
        """A derivation begins: nothing has been told in it yet."""
        self.told.clear()
        self._axes_told.clear()
        self.angles.lines.clear()
        self.angles.tangents.clear()
        self.velocity_lines = None

    # -- turning ------------------------------------------------------------------------------
    def turning(self, body: str) -> list[tuple[str, Vector]]:
        """The angles that change between the ground and a body, and their axes by ground components."""
        found: list[tuple[str, Vector]] = []
        for name, axis in self.bodies.turning_axes(body):
            if not self.model.samples.vanishes(self.angles.rate(name)):
                self.angles.introduce([name])
                found.append((name, tuple(map(self.express, axis))))
        return found

    def rate_element(self, name: str) -> Ratio:
        """The rate of an angle; of what velocities bind as it is."""
        return self.field.lowest_terms(self.model.rate(self.angles.value(name)))

    def omega(self, body: str, axes: Axes) -> tuple[tuple[Expr, ...], int]:
        """Symbols for the angular velocity of a body along axes, and the line that adds it up."""
        key = "omega", body, axes.body
        if key not in self.told:
            angles = [(name, self.along(axis, axes)) for name, axis in self.turning(body)]
            added = self._added(body, angles)
            if not self._is_ball(body):
                self._say_axes(angles, axes)
            terms = [(rates_of(name, 1), axis) for name, axis in angles]
            named = self._name_of_omega(body, axes)
            symbols = self.introduce(named, "omega", body, axes, _turning(self.system, body), "rad/s")
            sides = tuple(
                _sum([scaled(axis[k], rate) for rate, axis in terms if not axis[k].is_zero()]) for k in range(3)
            )
            args: dict[str, Argument] = {"body": body, "axes": axes.words, "lines": added}
            why = "space.added" if added else "space.of_ball" if self._is_ball(body) else "space.one_axis"
            self.told[key] = symbols, self.script.line(symbols, sides, why=why, args=args, uses=added)
        return self.told[key]

    def _name_of_omega(self, body: str, axes: Axes) -> str:
        """omega_body along its own axes or the fixed ones, whichever are told first; else with the axes as an index."""
        if axes.body in (body, GROUND):
            other = GROUND if axes.body == body else body
            if ("omega", body, other) not in self.told:
                return f"omega_{body}"
        return f"omega_{body}_{'0' if axes.body == GROUND else axes.body}"

    def omega_rates(self, body: str, axes: Axes) -> tuple[Expr, ...]:
        """The angular acceleration along axes: rates of the components, and what the turning of the axes adds."""
        symbols, _line = self.omega(body, axes)
        rates: list[Expr] = []
        for symbol in symbols:
            read = self.glossary.meanings[rate_key(symbol)].read
            assert callable(read)
            rate, said = Call("rate", symbol), Sentence("space.rate_of", {"name": symbol})
            self.glossary.redefine(Meaning(rate, said, rate_of(read), "rad/s^2"))
            rates.append(rate)
        if axes.body in (GROUND, body):
            return tuple(rates)
        turning, _line = self.omega(axes.body, axes)
        return tuple(add(rate, *_cross_terms(turning, symbols, k)) for k, rate in enumerate(rates))

    def _is_ball(self, body: str) -> bool:
        """Whether its orientation is left open: it turns about the axes of the ground, with no angle between."""
        return body in self.system.unfollowed

    def _added(self, body: str, angles: Sequence[tuple[str, Vector]]) -> tuple[int, ...]:
        """The line in which angular velocities are added up as vectors, where there are several."""
        if len(angles) < 2 or self._is_ball(body):
            return ()
        key = "vectors", body
        if key not in self.told:
            self.told[key] = (), self.angles.vectors.added(body, [name for name, _axis in angles])
        return (self.told[key][1],)

    def _say_axes(self, angles: Sequence[tuple[str, Vector]], axes: Axes) -> None:
        """Which angle turns about which axis."""
        self.angles.introduce(name for name, _axis in angles)
        new = [(name, axis) for name, axis in angles if (name, axes.body) not in self._axes_told]
        self._axes_told |= {(name, axes.body) for name, _axis in new}
        shown = [Sentence("space.vector", dict(zip("xyz", map(tidy, axis), strict=True))) for _name, axis in new]
        if len(angles) > 1 and new:
            unit = [self.angles.vectors.unit_vector(name) for name, _axis in new]
            each = (Sentence("space.vector_is", {"e": e, "axis": axis}) for e, axis in zip(unit, shown, strict=True))
            self.script.say("space.unit_vectors_are", axes=axes.words, vectors=tuple(each))
        elif new:
            alone = "space.turns_about" if axes.body == GROUND else "space.turns_about_own"
            self.script.say(alone, name=Symbol(new[0][0]), axis=shown[0], axes=axes.words)

    def component(self, body: str, along: Direction) -> Expr:
        """The angular velocity of a body along one direction, as a sum over its angles."""
        e = components_of(along, self.state, 3)
        angles = self.turning(body)
        self._added(body, angles)
        if not self._is_ball(body):
            self._say_axes(angles, axes_of(None))
        parts = [
            (rates_of(name, 1), self.field.lowest_terms(self.field.element(dot(axis, e)))) for name, axis in angles
        ]
        return _sum([scaled(c, rate) for rate, c in parts if not c.is_zero()])

    def bound(self, body: str, *, rates_only: bool = False) -> tuple[int, ...]:
        """Lines that tell the rates by which a body is turned, where they are not free; rates_only as in `Angles`."""
        names = [name for name, _axis in self.turning(body)]
        lines = self.angles.explain(names, rates_only=rates_only)
        if any(n in self.angles.bound for n in names):
            lines += self.velocities_bound()
        return lines

    # -- what binds velocities ----------------------------------------------------------------
    def velocities_bound(self) -> tuple[int, ...]:
        """Rolling and closed loops, solved for the bound rates."""
        if self.velocity_lines is None:
            self.velocity_lines = ()  # what is needed on the way does not ask for them
            self.velocity_lines = self._bind()
        return self.velocity_lines

    def _bind(self) -> tuple[int, ...]:
        lines = closed_loops(self.setup, self.script, in_rates=True)
        rolling = [row.connection for row in self.system.constraint_rows if isinstance(row.measure, NonholonomicForm)]
        for connection in dict.fromkeys(rolling):
            lines += self._rolling(connection)
        return tuple(bound_speeds(self.setup, self.script, lines))

    def _rolling(self, connection: str) -> list[int]:
        found = rolling_body(self.system, connection)
        if found is None:
            return velocity_constraints(self.setup, self.script, [connection])
        body, plane = found
        axes = axes_of(None) if self.model.coordinates else self._handy_axes(body)
        _r, r_line = self.arm_to_contact(body, plane, axes)
        _v, v_line = self.velocity(body, axes)
        _w, w_line = self.omega(body.name, axes)
        omega = [self.field.zero] * 3
        for name, axis in self.turning(body.name):
            rate = self.rate_element(name)
            omega = [w + rate * a for w, a in zip(omega, axis, strict=True)]
        arm = self.arm(body, plane)
        velocity = self._raw_velocity(body)
        slip = tuple(v + x for v, x in zip(velocity, cross(tuple(omega), arm), strict=True))
        shown = self.shown(self.along(slip, axes))
        zero = number(0)
        uses = (r_line, v_line, w_line)
        args: dict[str, Argument] = {"connection": connection, "lines": uses}
        return [self.script.line((zero, zero, zero), shown, why="space.no_slip", args=args, uses=uses)]

    def _handy_axes(self, body: RigidBody) -> Axes:
        """The axes of what carries a body: there its velocities are short."""
        link = next((link for link in self.bodies.tree.links if link.body == body.name), None)
        if link is None or link.parent == GROUND:
            return axes_of(None)
        x, y, z = (Direction(link.parent, e.components) for e in AXES)
        return Axes((x, y, z), link.parent)

    # -- vectors ------------------------------------------------------------------------------
    def arm_to_contact(self, body: RigidBody, plane: BodyPlane, axes: Axes) -> tuple[tuple[Expr, ...], int]:
        """From the centre to the point of contact."""

        def reads(world: World) -> Sequence[float]:
            return tuple(map(float, contact_arm(body, plane, world.snapshot)))

        arm = self.along(self.arm(body, plane), axes)
        symbols = self.introduce(f"r_{body.name}", "arm", body.name, axes, reads, "m")
        args: dict[str, Argument] = {"body": body.name, "axes": axes.words}
        return symbols, self.script.line(symbols, self.shown(arm), why="space.arm_is", args=args)

    def arm(self, body: RigidBody, plane: BodyPlane) -> Vector:
        found = contact_arm(body, plane, self.state)
        return tuple(self.field.lowest_terms(self.field.element(x)) for x in found)

    def velocity(self, body: RigidBody, axes: Axes) -> tuple[tuple[Expr, ...], int]:
        """The velocity of a centre, its place differentiated."""
        key = "v", body.name, axes.body
        if key not in self.told:

            def reads(world: World) -> Sequence[float]:
                return tuple(OfPoint(body.center, 1).value(self.system, world.snapshot))

            symbols, line = self._about_fixed_point(body, axes) or (None, 0)
            if symbols is not None:
                self.told[key] = symbols, line
                return self.told[key]
            place = self.place(body.center, str(body.name))
            raw = self.along(self._raw_velocity(body), axes)
            symbols = self.introduce(f"v_{body.name}", "velocity", body.name, axes, reads, "m/s")
            args: dict[str, Argument] = {"body": body.name, "line": place, "axes": axes.words}
            line = self.script.line(symbols, self.shown(raw), why="space.differentiated", args=args, uses=(place,))
            self.told[key] = symbols, line
        return self.told[key]

    def _about_fixed_point(self, body: RigidBody, axes: Axes) -> tuple[tuple[Expr, ...], int] | None:
        """v = omega x r along the axes of a body that turns about a point of the ground and has the centre fixed in it:
        so the arm r has constant components there. None where there is no such point."""
        if axes.body == GROUND:
            return None
        for name in sorted(self.system.bodies[GROUND].points, key=lambda n: n == "origin"):
            point = self.system.bodies[GROUND].point(name)
            arm = self.along([self.state.value(Displacement(body.center, point, a)) for a in AXES], axes)
            if all(self.field.lowest_terms(self.model.rate(x)).is_zero() for x in arm):
                return self._carried(body, point, name, arm, axes)
        return None

    def _carried(
        self, body: RigidBody, point: Point, name: str, arm: Vector, axes: Axes
    ) -> tuple[tuple[Expr, ...], int]:
        def reads(world: World) -> Sequence[float]:
            ends = (OfPoint(p, 0).value(self.system, world.snapshot) for p in (body.center, point))
            return [a - b for a, b in zip(*ends, strict=True)]

        def moves(world: World) -> Sequence[float]:
            return tuple(OfPoint(body.center, 1).value(self.system, world.snapshot))

        said: dict[str, Argument] = {"body": body.name, "point": name, "carrier": axes.body, "axes": axes.words}
        r = self.introduce(f"r_{name}_{body.name}", "arm_from", body.name, axes, reads, "m", point=name)
        r_line = self.script.line(r, self.shown(arm), why="space.arm_from_is", args=said)
        _w, w_line = self.omega(axes.body, axes)
        v = self.introduce(f"v_{body.name}", "velocity", body.name, axes, moves, "m/s")
        shown = self.shown(self.along(self._raw_velocity(body), axes))
        uses = (w_line, r_line, *self.bound(axes.body))
        return v, self.script.line(v, shown, why="space.transfer", args={"lines": uses}, uses=uses)

    def place(self, point: Point, name: str) -> int:
        """Where a point is, by ground components."""
        key = "place", name
        if key not in self.told:

            def reads(world: World) -> Sequence[float]:
                return tuple(OfPoint(point, 0).value(self.system, world.snapshot))

            value = [self.field.lowest_terms(self.state.value(Displacement(point, ORIGIN, a))) for a in AXES]
            label = name.replace(".", "_")
            symbols = self.introduce(f"p_{label}", "place", name, axes_of(None), reads, "m")
            line = self.script.line(symbols, self.shown(value), why="space.place_is", args={"body": name})
            self.told[key] = symbols, line
        return self.told[key][1]

    def _raw_velocity(self, body: RigidBody) -> Vector:
        return tuple(self.state.raw_rate(Displacement(body.center, ORIGIN, a)) for a in AXES)


def _turning(system: System, body: str) -> Callable[[World], Sequence[float]]:
    def reads(world: World) -> Sequence[float]:
        return tuple(AngularVelocity(body, 1).value(system, world.snapshot))

    return reads


def _sum(terms: Sequence[Expr]) -> Expr:
    return add(*terms) if terms else number(0)


def _cross_terms(w: Sequence[Expr], r: Sequence[Expr], k: int) -> tuple[Expr, Expr]:
    i, j = (k + 1) % 3, (k + 2) % 3
    return w[i] * r[j], -(w[j] * r[i])
