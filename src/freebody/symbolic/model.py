"""The symbolic route: from a System to its motion in generalized coordinates, exactly.

    unknowns       the generators of the field: parameters, absolute coordinates, lines, named measures
    bodies         how bodies are placed, move and carry momentum: the plane or space, which all parts ask
    samples        numbers for all generators, and the signs and zeros that they decide
    given_start    start values in the parameters
    lines          tangents (and roots) as unknowns, and written out
    coordinates    the choice: held measures give unknowns away, the others are the generalized coordinates q
    configuration  poses and measures in coordinates, their gradients
    speeds         the independent speeds u, and the dependent ones by them
    kinematics     velocities, partial velocities and accelerations of the bodies
    loads          laws and wrenches
    dynamics       M(q) du/dt = F(q, u, t)
    reactions      the multipliers of the held rows
    start_speeds   the speeds at the start

Each part takes those above that it needs. The model puts them together; it says itself what belongs to the coordinates,
which every reader needs, and shows the other parts.
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from freebody.language.expression import Expr
from freebody.measures.base import Measure
from freebody.measures.geometry import AXES
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.model.spins import spin
from freebody.symbolic.bodies import Bodies, Parts, PlanarBodies
from freebody.symbolic.configuration import Configuration
from freebody.symbolic.coordinates import CoordinateChoice
from freebody.symbolic.dynamics import SymbolicDynamics
from freebody.symbolic.elimination import RowEquation
from freebody.symbolic.geometry import AnyPose, FieldGeometry, Slot
from freebody.symbolic.given_start import GivenStart, PlanarGivenStart
from freebody.symbolic.kinematics import SymbolicKinematics
from freebody.symbolic.lines import Lines
from freebody.symbolic.loads import SymbolicLoads
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reactions import Reactions
from freebody.symbolic.sample import Sample
from freebody.symbolic.samples import Samples
from freebody.symbolic.signed_field import SignedField
from freebody.symbolic.spatial.bodies import SpatialBodies
from freebody.symbolic.spatial.given_start import SpatialGivenStart
from freebody.symbolic.spatial.lines import SpatialLines
from freebody.symbolic.spatial.start_speeds import SpatialStartSpeeds
from freebody.symbolic.speeds import Speeds
from freebody.symbolic.start_speeds import PlanarStartSpeeds, StartSpeeds
from freebody.symbolic.unknowns import Coordinate, ModelUnknowns
from freebody.system.order import in_one_order
from freebody.system.system import System


@dataclass(frozen=True)
class Ambient:
    """Who is asked where plane and space differ."""

    bodies: Callable[[System, ModelUnknowns], Bodies]
    lines: Callable[[ModelUnknowns, Samples], Lines]
    start: Callable[[Bodies, Samples, FieldGeometry], GivenStart]
    start_speeds: Callable[[Bodies, Configuration, Speeds, SymbolicKinematics], StartSpeeds]


PLANE = Ambient(PlanarBodies, Lines, PlanarGivenStart, PlanarStartSpeeds)
SPACE = Ambient(SpatialBodies, SpatialLines, SpatialGivenStart, SpatialStartSpeeds)


class SymbolicModel:
    """Everything the symbolic route derives. Raises CannotAnswer where formulas would be too long."""

    def __init__(self, system: System, points: Sequence[Sample]) -> None:
        self.system = system = in_one_order(system)
        ambient = SPACE if system.space else PLANE
        n = len(system.all_moving)
        self.field = SignedField(capacity=len(system.parameters) + 10 * n + 3 * len(system.all_measures) + 24)
        # the unknowns, and what is known of them
        self._unknowns = unknowns = ModelUnknowns(self.field, system)
        self.bodies = bodies = ambient.bodies(system, unknowns)
        self.samples = samples = Samples(unknowns, bodies, points)
        lines = ambient.lines(unknowns, samples)
        absolute = bodies.geometry(bodies.poses, lines.tangent, lines.unknown_root(), samples.is_negative)
        self.start = ambient.start(bodies, samples, absolute)
        # the coordinates among them
        self._choice = CoordinateChoice(bodies, lines, samples, self.start, absolute)
        self.lengths = absolute.scalars  # what the geometry is made of, in parameters
        self._speeds = self._choice.chosen.speeds
        self._configuration = self._choice.chosen.configuration
        # motion and forces
        self.kinematics = SymbolicKinematics(bodies, self._configuration, self._speeds)
        self.loads, self.dynamics, self.reactions = self._forces()
        self.start_speeds = ambient.start_speeds(bodies, self._configuration, self._speeds, self.kinematics)

    def _forces(
        self, accelerations: Mapping[int, Ratio] | None = None
    ) -> tuple[SymbolicLoads, SymbolicDynamics, Reactions]:
        """The parts that stand on the motion of the bodies. accelerations: of the coordinates, where they are given."""
        here, u = self._configuration, self._speeds
        system, bodies, motion, samples = self.system, self.bodies, self.kinematics, self.samples
        loads = SymbolicLoads(system, self._unknowns, bodies, here, u, samples, self.start)
        dynamics = SymbolicDynamics(system, bodies, here, u, motion, loads, samples, accelerations)
        return loads, dynamics, Reactions(system, bodies, here, motion, loads, dynamics, samples)

    # -- the pose in coordinates --------------------------------------------------------------
    @property
    def parameters(self) -> dict[str, Ratio]:
        """The generators of the parameters, and time as t."""
        return self._unknowns.parameters

    @property
    def functions_of_time(self) -> Mapping[int, Expr]:
        """The generators that are given functions of time, and their rates: what they are in parameters."""
        return self._unknowns.functions

    @property
    def constants(self) -> dict[str, Ratio]:
        """Hidden start values of incremental rows and loads, by name."""
        return self._unknowns.constants

    @property
    def given_constants(self) -> dict[int, Ratio]:
        """Of these: what they are in the parameters."""
        return self._unknowns.given_constants

    @property
    def geometry(self) -> FieldGeometry:
        """The statements of measures over the poses in coordinates."""
        return self._configuration.geometry

    @property
    def poses(self) -> Mapping[str, AnyPose]:
        return self._configuration.poses

    def value_of(self, measure: Measure) -> Ratio:
        """A measure in coordinates."""
        return self._configuration.value_of(measure)

    @property
    def unfollowed(self) -> frozenset[int]:
        """Of the generators of the coordinates those on whose values nothing depends: the turns of balls."""
        turns = (self.bodies.unfollowed_turns(name) for name in self.system.unfollowed)
        return frozenset(self.field.index(turn) for parts in turns for turn in parts)

    def rate_of(self, measure: Measure | NonholonomicForm) -> Ratio:
        """The rate of a measure, with the speeds of dependent coordinates as they are."""
        return self._configuration.rate_of(measure)

    def gradient(self, measure: Measure | NonholonomicForm) -> dict[Slot, Ratio]:
        """Derivatives of a measure by the coordinates of the bodies (of its rate by their velocities)."""
        return self._configuration.gradient(measure)

    def express(self, x: Ratio) -> Ratio:
        """An element in unknowns by the coordinates that stay."""
        return self._configuration.express(x)

    def equation(self, row: ConstraintRow) -> Ratio:
        """What a row holds at zero, in the unknowns before any of them is eliminated."""
        return self._choice.equation(row)

    # -- coordinates and speeds ---------------------------------------------------------------
    @property
    def coordinates(self) -> tuple[Coordinate, ...]:
        """Those whose speeds are independent."""
        return self._speeds.coordinates

    @property
    def dependent(self) -> tuple[Coordinate, ...]:
        """The others, which closed loops and nonholonomic rows bind."""
        return self._speeds.dependent

    @property
    def accelerations(self) -> list[int]:
        """The generators of the rates of the independent speeds."""
        return self._speeds.accelerations

    @property
    def degrees_of_freedom(self) -> int:
        return len(self.coordinates)

    @property
    def moving(self) -> set[int]:
        """The generators that change along a motion: coordinates, speeds, the time and given functions of it."""
        in_time = {g for g, generator in self.field.generators.items() if generator.kind == "time"}
        return in_time | {g for c in (*self.coordinates, *self.dependent) for g in (c.index, c.speed)}

    @property
    def loops(self) -> tuple[RowEquation, ...]:
        """Equations among the coordinates that remain: the closed loops, without those that follow from others."""
        return tuple(e for e in self._choice.chosen.elimination.loops if not e.value.is_zero())

    @property
    def has_equal_angles(self) -> bool:
        """Whether angles are put in that are equal on the branch of the start, and not on others."""
        return self._choice.has_equal_angles

    @property
    def redundant(self) -> list[str]:
        """The held rows that follow from others."""
        return self._choice.redundant

    def measure_of(self, c: Coordinate) -> Measure | None:
        """The measure that a coordinate is; None for a length or angle of a line that is none by itself."""
        return self._unknowns.measures.get(c.index)

    def form_of(self, c: Coordinate) -> Measure | NonholonomicForm | None:
        """What the rate of a coordinate is the rate of: its measure, or of a ball whose orientation is left open the
        angular velocity about an axis of the ground."""
        for body in sorted(self.system.unfollowed):
            for axis, turn in zip(AXES, self.bodies.unfollowed_turns(body), strict=True):
                if self.field.index(turn) == c.index:
                    return spin(body, axis)
        return self.measure_of(c)

    def rate(self, x: Ratio) -> Ratio:
        """Total time derivative; speeds of dependent coordinates stay as they are, but for those that are zero."""
        return self._speeds.rate(x)

    def in_independent_speeds(self, x: Ratio) -> Ratio:
        """The same with the speeds of dependent coordinates put in."""
        return self._speeds.in_independent_speeds(x)

    def dependent_speed(self, c: Coordinate) -> Ratio:
        """The speed of a dependent coordinate by the independent ones."""
        return self._speeds.dependent_speed(c)

    # -- other motions on the same coordinates ------------------------------------------------
    def without_accelerations(self) -> SymbolicModel:
        """The same where the independent speeds stay as they are, whatever the loads would change."""
        other = copy.copy(self)
        still = dict.fromkeys(self.accelerations, self.field.zero)
        other.loads, other.dynamics, other.reactions = self._forces(still)
        return other

    def in_names(
        self,
        velocities: Mapping[str, Parts],
        dependent: Mapping[int, Ratio],
        accelerations: Mapping[int, Ratio] | None = None,
    ) -> SymbolicModel:
        """The same motion in other words: velocities of the bodies that equal those of the model where the loops close,
        other formulas of the dependent speeds, or none, and accelerations that may be given."""
        other = copy.copy(self)
        other._speeds = self._speeds.with_dependent(dependent)
        other.kinematics = SymbolicKinematics(self.bodies, self._configuration, other._speeds, velocities)
        other.loads, other.dynamics, other.reactions = other._forces(accelerations)
        return other

    def kept_going(self, driven: System) -> SymbolicModel:
        """The same where the drives of a system keep the independent speeds as they are, whatever the loads would
        change. driven: this system with the rows of those drives, which are no rows of the model: their reactions are
        among what is found."""
        other = self.without_accelerations()
        other.reactions = Reactions(
            driven, self.bodies, self._configuration, self.kinematics, other.loads, other.dynamics, self.samples
        )
        return other

    def with_bodies(
        self,
        system: System,
        names: Mapping[str, Ratio],
        velocities: Mapping[str, Parts],
        body_accelerations: Mapping[str, Parts],
    ) -> SymbolicModel:
        """The same coordinates for a system with other inertias and loads, in which more names stand for elements, and
        for bodies that are taken to move otherwise. What is assumed there is not assumed here."""
        other = copy.copy(self)
        other.system = system
        other.samples = self.samples.copy()
        other._configuration = self._configuration.with_names(names)
        other.kinematics = SymbolicKinematics(
            self.bodies, other._configuration, self._speeds, velocities, body_accelerations
        )
        other.loads, other.dynamics, other.reactions = other._forces()
        return other
