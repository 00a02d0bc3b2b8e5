"""What the start of a model says about speeds: rates of named measures and velocities of bodies, linear in the
independent speeds."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping

from freebody.language.expression import Expr
from freebody.measures.geometry import Pose
from freebody.symbolic.bodies import Bodies
from freebody.symbolic.configuration import Configuration
from freebody.symbolic.kinematics import SymbolicKinematics
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.speeds import Speeds
from freebody.symbolic.unknowns import Coordinate

WantedRates = list[tuple[Ratio, Ratio]]  # a rate, and what it is


class StartSpeeds(ABC):
    """The speeds that a model gives at the start."""

    def __init__(
        self, bodies: Bodies, configuration: Configuration, speeds: Speeds, kinematics: SymbolicKinematics
    ) -> None:
        self.bodies, self.configuration, self.speeds, self.kinematics = bodies, configuration, speeds, kinematics
        self.system, self.unknowns, self.field = bodies.system, bodies.unknowns, bodies.field

    @property
    def scalar(self) -> Callable[[Expr], Ratio]:
        return self.configuration.geometry.scalar

    def wanted_rates(self, known: Mapping[str, Expr]) -> WantedRates:
        """The rates that the start gives, of named measures and of bodies, each with what it is."""
        rate, value_of, measures = self.speeds.rate, self.configuration.value_of, self.system.all_measures
        named = [(rate(value_of(measures[n])), self.scalar(e)) for n, e in known.items()]
        return [*named, *self._wanted_of_bodies()]

    @abstractmethod
    def _wanted_of_bodies(self) -> WantedRates:
        """The velocities that bodies are given."""

    @abstractmethod
    def together(self, known: Mapping[str, Expr], start: Mapping[int, Ratio]) -> dict[int, Ratio]:
        """All independent speeds at once from the rates of named measures and the velocities given to bodies; nothing
        where they are found one by one."""

    @abstractmethod
    def of_coordinate(self, c: Coordinate, start: Mapping[int, Ratio]) -> Ratio | None:
        """The start value of one speed where the velocities given for the bodies tell it."""


class PlanarStartSpeeds(StartSpeeds):
    """The speeds at the start in the plane, one by one."""

    def _wanted_of_bodies(self) -> WantedRates:
        wanted: WantedRates = []
        for body in self.system.all_moving:
            x, y, turning = self.kinematics.velocities[body.name]
            wanted += [(v, self.scalar(e)) for v, e in zip((x, y), body.start.velocity or (), strict=False)]
            if body.start.angular_velocity is not None and body.turns:
                wanted.append((turning, self.scalar(body.start.angular_velocity)))
        return wanted

    def together(self, known: Mapping[str, Expr], start: Mapping[int, Ratio]) -> dict[int, Ratio]:
        return {}

    def of_coordinate(self, c: Coordinate, start: Mapping[int, Ratio]) -> Ratio | None:
        given = self._given()
        # each given velocity is an equation in the independent speeds
        for index, speed in self.unknowns.speeds.items() if given else ():
            if speed in given:
                own = self.speeds.rate(self.configuration.express(self.field.variable(index)))
                own = self.field.follow(own, {k: v for k, v in start.items() if k != c.speed})
                if own.generators() & {k.speed for k in self.speeds.coordinates} == frozenset({c.speed}):
                    slope = self.field.partial(own, c.speed)
                    rest = own - slope * self.field.variable(c.speed)
                    return (given[speed] - rest) / slope
        return None

    def _given(self) -> dict[int, Ratio]:
        """The speeds of absolute coordinates that bodies are given."""
        found: dict[int, Ratio] = {}
        for body in self.system.all_moving:
            pose, start = self.bodies.poses[body.name], body.start
            assert isinstance(pose, Pose)
            given = list(zip((pose.x, pose.y), start.velocity or (), strict=False))
            if (
                start.angular_velocity is not None and body.turns
            ):  # a particle has no angle of which it could be the rate
                given.append((pose.angle, start.angular_velocity))
            for element, expr in given:
                found[self.unknowns.speeds[self.field.index(element)]] = self.scalar(expr)
        return found
