"""The choice of generalized coordinates.

The absolute coordinates of the bodies, the lengths and angles of the tangents in the held measures, and the named
measures are unknowns; the held measures are equations; `Elimination` keeps the generalized coordinates q. It is run
again where the first outcome shows what makes the next one simpler: named measures that are linear in an unnamed
coordinate, coordinates that do not move, and angles that the branch keeps equal.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from freebody.errors import CannotAnswer
from freebody.language.units import DIMENSIONLESS
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.geometry import GROUND
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.symbolic.bodies import Bodies
from freebody.symbolic.configuration import Configuration
from freebody.symbolic.elimination import GIVEN, Elimination, RowEquation
from freebody.symbolic.geometry import FieldGeometry, straight_tangent
from freebody.symbolic.given_start import GivenStart
from freebody.symbolic.lines import KnownTangents, Lines
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.samples import Samples
from freebody.symbolic.speeds import Speeds
from freebody.symbolic.start_pose import recognised
from freebody.symbolic.unknowns import NAMED, OFFERED, Coordinate


@dataclass(frozen=True)
class Candidate:
    """A measure that may become a coordinate."""

    name: str
    measure: Measure
    rank: tuple[int, int]

    @property
    def label(self) -> str:
        """The name of the equations that define it."""
        return _label(self.name)


@dataclass(frozen=True)
class Definition:
    """The equations by which a candidate is what it is, and the unknowns that came with it."""

    label: str
    equations: tuple[RowEquation, ...]
    made: tuple[int, ...]

    @property
    def has_lines(self) -> bool:
        return len(self.equations) > 1


@dataclass(frozen=True)
class Chosen:
    """The outcome of one elimination."""

    extra: tuple[RowEquation, ...]  # equations that were found out before
    elimination: Elimination
    dropped: frozenset[str]  # measures that are no coordinates
    tangents: KnownTangents
    configuration: Configuration
    speeds: Speeds


class CoordinateChoice:
    """Chooses on creation; afterwards `chosen` and `redundant` tell the outcome."""

    def __init__(
        self, bodies: Bodies, lines: Lines, samples: Samples, start: GivenStart, absolute: FieldGeometry
    ) -> None:
        """absolute: the statements of measures over the unknowns."""
        self._bodies, self._lines, self._samples, self._start = bodies, lines, samples, start
        self._absolute = absolute
        self._system, self._unknowns, self._field = bodies.system, bodies.unknowns, bodies.field
        self._made_for: dict[str, tuple[int, ...]] = {}  # the unknowns that came with a measure, by its definition
        self.chosen = self._choose([])
        # what the first pass found out may make the second one simpler; which rows are redundant is told by the first
        held = {row.name for row in self._system.constraint_rows}  # what defines a line or a name holds nothing
        redundant = [name for name in self.chosen.speeds.redundant if name in held]
        for found_out in (self._named_by_formula, self._constant_coordinates):
            equations = found_out()
            if equations:
                self.chosen = self._choose([*self.chosen.extra, *equations])
        self.has_equal_angles = self._put_in_equal_angles()
        self.redundant = bodies.really_redundant(redundant)

    def _choose(self, extra: Sequence[RowEquation]) -> Chosen:
        """One pass, with equations that were found out."""
        self._samples.has_loops = True
        elimination, dropped = self._eliminate(extra)
        self._samples.has_loops = bool(elimination.loops)
        express, bodies = elimination.express, self._bodies
        poses = {name: bodies.expressed(pose, express) for name, pose in bodies.poses.items()}
        tangents = KnownTangents(self._unknowns, elimination, self._samples)
        root = self._lines.known_root(elimination)
        geometry = bodies.geometry(poses, tangents, root, self._samples.is_negative)
        configuration = Configuration(bodies, elimination, geometry)
        speeds = Speeds(self._unknowns, elimination, self._system.constraint_rows, configuration, self._samples)
        return Chosen(tuple(extra), elimination, dropped, tangents, configuration, speeds)

    # -- equations ----------------------------------------------------------------------------
    def _held_equations(self) -> list[RowEquation]:
        """What the held rows say in absolute coordinates, and the lines that they are written with."""
        self._lines.begin()
        found: list[RowEquation] = []
        for row in self._system.constraint_rows:
            if isinstance(row.measure, NonholonomicForm) or row.name in self._bodies.rows_by_construction:
                continue
            self._lines.made_for(row.connection, row.measure)
            angle = self._bodies.angle_of(row.measure)
            value = row.measure.value(self._absolute) if angle is None else angle
            found.append(RowEquation(row.name, value - self._target(row), defines=not row.transmits))
        return found + self._lines.new_equations()

    def equation(self, row: ConstraintRow) -> Ratio:
        """What a row holds at zero, in the named angles and positions before any of them is eliminated."""
        assert not isinstance(row.measure, NonholonomicForm)
        return row.measure.value(self._absolute) - self._target(row)

    def _target(self, row: ConstraintRow) -> Ratio:
        """What a row is held at; the start value of an incremental one is a constant of its own unless it is
        zero at every sample."""
        measure = row.measure
        assert not isinstance(measure, NonholonomicForm)
        if row.in_symbols is not None:
            return self._absolute.scalar(row.in_symbols)
        if not measure.incremental or self._samples.starts_at_zero(row.name):
            return self._field.zero
        given = self._start.of_measure(measure, row.name)
        if given is not None and (len(given.num) == 1 or self._start.is_placed(measure)):
            return given
        name = row.name.replace(".", "_").replace(" ", "_")
        constant = self._field.parameter(f"{name}_0")
        self._unknowns.constants[row.name] = constant
        if given is not None:  # as one symbol until an answer contains it: it may stand in many sines
            self._unknowns.given_constants[self._field.index(constant)] = given
        return constant

    # -- measures as coordinates --------------------------------------------------------------
    def _candidates(self) -> list[Candidate]:
        """The measures that the user names, then those that connections offer."""
        measures = self._of_use()
        # wanted in the one order of measures, those before which they are made of; one that is at an extreme at the
        # start is no coordinate there: last
        points = self._samples.points
        wanted = sorted(measures, key=lambda n: (any(n in s.still for s in points), _is_made_of(measures, n)))
        turned_by = set(self._bodies.angle_names)
        found = [Candidate(n, m, (NAMED, -wanted.index(n))) for n, m in measures.items() if n not in turned_by]
        named = set(measures.values())
        taken = set(measures) | set(self._unknowns.parameters) | turned_by
        for k, (name, measure) in enumerate(self._system.offered):
            if measure not in named and name not in taken:
                found.append(Candidate(name, measure, (OFFERED, -k)))
        return found

    def _of_use(self) -> dict[str, Measure]:
        """The named measures but those of lines between bodies of which nothing else knows a line: neither the start,
        nor a load, nor what is held, and that nothing leads. A length that is only watched, as that of a slack string,
        is no coordinate of what flies freely: its motion has a short law in x and y, and none in a distance and an
        angle."""
        system, measures = self._system, self._system.all_measures
        known = [measures[n] for n in {*system.all_start, *system.all_start_rates} if n in measures]
        known += [m for push in system.all_loads for m in (push.measure, *(m for _name, m in push.measures))]
        known += [row.measure for row in system.constraint_rows]
        on_lines = {body for m in known if not isinstance(m, NonholonomicForm) for body in _ends(m)}
        led = {body for row in system.constraint_rows for body in row.measure.bodies()}
        return {n: m for n, m in measures.items() if not (own := _ends(m)) or own & on_lines or own <= led}

    def _define(self, c: Candidate) -> Definition | None:
        """An unknown for a measure with its equations; None for one that cannot be written."""
        before = set(self._unknowns.found)
        self._lines.made_for(c.name, c.measure)
        try:
            value = c.measure.value(self._absolute)
        except (CannotAnswer, ZeroDivisionError):
            return None
        own = self._unknowns.defined_as(c.name) or self._unknowns.new(
            c.name,
            c.rank,
            compute=lambda values, functions: self._field.evaluate(value, values, functions),
            is_angle=c.measure.dimension == DIMENSIONLESS,
        )
        self._unknowns.defined[self._field.index(own)] = value
        self._unknowns.measures[self._field.index(own)] = c.measure
        lines = (RowEquation(c.label, e.value) for e in self._lines.new_equations())
        # made in the first pass: those of a measure that is dropped in a later one go with it
        made = self._made_for.setdefault(c.label, tuple(i for i in self._unknowns.found if i not in before))
        return Definition(c.label, (RowEquation(c.label, own - value), *lines), made)

    # -- elimination --------------------------------------------------------------------------
    def _eliminate(self, given: Sequence[RowEquation]) -> tuple[Elimination, frozenset[str]]:
        """Tries the named and offered measures as coordinates; one that only adds a loop of its own is dropped, and
        those that bring lines of their own are taken only where they add no loop."""
        constraints = [*given, *self._held_equations()]
        definitions = [d for c in self._candidates() if (d := self._define(c)) is not None]
        self._samples.read_again()
        # a measure without a value at a sample, as the bearing of points that coincide there, is no coordinate
        without = {d.label for d in definitions if not all(map(self._samples.has_values, d.made))}
        with_lines = {d.label for d in definitions if d.has_lines} - without
        # of a measure that is given by a formula the lines are as little needed as of one that is dropped
        replaced = {e.name for e in given}
        open_ = [d for d in definitions if d.label not in replaced]
        idle = {i for d in definitions if d.label in replaced for i in d.made} - self._unknowns.defined.keys()
        n_assumed = len(self._samples.assumed)
        dropped = with_lines | without

        def settled() -> Elimination:
            """Drops what only adds loops of its own, one elimination after the other."""
            while True:
                del self._samples.assumed[n_assumed:]  # what a choice of measures assumed that is not taken
                dropped.update(self._without_lines(open_, dropped, idle))
                elimination = self._run(constraints, open_, dropped, idle)
                bad = {e.name for e in elimination.loops if e.name.startswith(_label(""))}
                if not bad:
                    return elimination
                dropped.update(bad)

        elimination = settled()
        if with_lines:
            fewest, started = len(elimination.loops), self._started(elimination)
            dropped -= with_lines
            elimination = settled()
            # nor where they take the place of measures that the start is given in
            if len(elimination.loops) > fewest or not started <= self._started(elimination):
                dropped |= with_lines
                elimination = settled()
        return elimination, frozenset(label.removeprefix(_label("")) for label in dropped)

    def _started(self, elimination: Elimination) -> set[str]:
        """The coordinates that the start of the model says something of."""
        known = {n: self._unknowns.defined_as(n) for n in (*self._system.all_start, *self._system.all_start_rates)}
        return {n for n, own in known.items() if own is not None and elimination.express(own) == own}

    def _without_lines(self, definitions: list[Definition], dropped: set[str], idle: set[int]) -> set[str]:
        """The measures that are written with a line of one that is dropped or given by a formula."""
        gone = idle | {index for d in definitions if d.label in dropped for index in d.made}
        found = {d.label for d in definitions if any(gone & self._unknowns.inside(e.value) for e in d.equations)}
        return found if found <= dropped else self._without_lines(definitions, dropped | found, idle)

    def _run(
        self, constraints: list[RowEquation], definitions: list[Definition], dropped: set[str], idle: set[int]
    ) -> Elimination:
        """With the measures that are not dropped. idle: unknowns that nothing needs."""
        out = idle | {index for d in definitions if d.label in dropped for index in d.made}
        return Elimination(
            self._field,
            {index: u for index, u in self._unknowns.found.items() if index not in out},
            constraints + [e for d in definitions if d.label not in dropped for e in d.equations],
            self._unknowns.lines,
            self._samples.vanishes,
            straight_tangent(self._field, self._samples.is_negative),
            OFFERED,
            angle_by=self._lines.angle_by(),
        )

    # -- what an elimination shows ------------------------------------------------------------
    def _named_by_formula(self) -> list[RowEquation]:
        """Measures that are linear in an unnamed coordinate, and so can take its place: those that were dropped, and
        those that the elimination could only tell by it, as a distance from an axis by the length of a line."""
        found: list[RowEquation] = []
        taken: set[int] = set()
        for c in self._candidates():
            own, measure = self._unknowns.defined_as(c.name), c.measure
            if own is None or self._is_coordinate(own):
                continue
            n_assumed, known_lines = len(self._samples.assumed), self.chosen.tangents.known
            value = self._written(measure)
            replaced = None if value is None else self._linear_in(value, taken, is_named=c.rank[0] == NAMED)
            if value is None or replaced is None:
                # what was assumed in looking at a measure that became no coordinate is assumed only by who asks for it
                del self._samples.assumed[n_assumed:]
                self.chosen.tangents.keep(known_lines)
                continue
            found.append(RowEquation(c.label, own - value))
            taken.add(replaced.index)
        return found

    def _is_coordinate(self, own: Ratio) -> bool:
        return any(c.index == self._field.index(own) for c in self.chosen.speeds.coordinates)

    def _written(self, measure: Measure) -> Ratio | None:
        """A measure in coordinates; None where that is too long to write."""
        try:
            return self.chosen.configuration.value_of(measure)
        except (CannotAnswer, ZeroDivisionError):
            return None

    def _linear_in(self, value: Ratio, taken: set[int], *, is_named: bool) -> Coordinate | None:
        """The coordinate of no name in which alone a value is linear, with a constant slope; one that a connection
        offers gives way to what is named only. So does one whose rate alone is bound, by rows of velocities."""
        speeds = self.chosen.speeds
        binds_rates = any(isinstance(row.measure, NonholonomicForm) for row in self._system.constraint_rows)
        for c in (*speeds.coordinates, *(speeds.dependent if binds_rates else ())):
            is_offered = c.index in self._unknowns.defined and not is_named
            if c.index in taken or c.name in self._system.all_measures or is_offered:
                continue
            if self._unknowns.inside(value.denominator()):
                continue
            slope = self._field.partial(value, c.index)
            if slope.is_constant() and not slope.is_zero() and len(self._unknowns.inside(value)) == 1:
                return c
        return None

    def _constant_coordinates(self) -> list[RowEquation]:
        """Dependent coordinates that do not move: their start values, where these are known, are their values."""
        speeds, start = self.chosen.speeds, self._start
        lines = {index for line in self._unknowns.lines for index in (line.length, line.angle)}
        still = [c for c in speeds.dependent if self._samples.vanishes(speeds.dependent_speed(c))]
        values: dict[int, Ratio] = {}
        if len(still) == len(speeds.dependent) and not speeds.coordinates:
            values = {i: x for i, x in start.places().items() if self._stands_still(i)}
        for c in still:
            if c.index not in values and c.index not in lines:
                value = start.of_coordinate(c)
                if value is None:
                    value = start.recognised(c)
                if value is not None:
                    values[c.index] = value
        return [RowEquation(GIVEN, self._field.variable(index) - value) for index, value in values.items()]

    def _stands_still(self, index: int) -> bool:
        """Whether an absolute coordinate keeps its value, which a driver may change."""
        here = self.chosen.configuration.express(self._field.variable(index))
        return self._samples.vanishes(self.chosen.speeds.rate(here))

    def _put_in_equal_angles(self) -> bool:
        """Puts in the angles that the branch keeps equal (a parallelogram's), or opposite, up to right angles. That
        they follow from the loops is proved by the count: what has as many freedoms with them is the same motion.
        True where there are such: on another branch (a parallelogram that has folded over) they are not equal."""
        equations, before = self._equal_angles(), self.chosen
        if not equations:
            return False
        self.chosen = self._choose([*before.extra, *equations])
        if len(self.chosen.speeds.coordinates) == len(before.speeds.coordinates):
            return True
        self.chosen = self._choose(before.extra)
        return False

    def _equal_angles(self) -> list[RowEquation]:
        """Angles bound by closed loops that differ from others by the same multiple of a right angle at all samples, or
        whose sum does."""
        found: list[RowEquation] = []
        speeds = self.chosen.speeds
        kept = [c for c in speeds.coordinates if c.is_angle]
        general = any(not s.is_start for s in self._samples.points)
        for c in speeds.dependent if general and self.chosen.elimination.loops else ():
            if not c.is_angle:
                continue
            for other, sign in ((k, s) for k in kept for s in (1, -1)):
                difference = self._field.variable(c.index) - sign * self._field.variable(other.index)
                constant = recognised(self._field, self._samples.everywhere(difference), is_angle=True)
                if constant is not None:
                    found.append(RowEquation(GIVEN, difference - constant))
                    break
            else:
                kept.append(c)
        return found


def _ends(measure: Measure) -> set[str]:
    """The moving bodies at the ends of its lines. A line of one body turns as that does, and has no length to tell."""
    ends = [{point.body for point in line} for line in measure.lines()]
    return set[str]().union(*(bodies for bodies in ends if len(bodies) > 1)) - {GROUND}


def _label(name: str) -> str:
    return f"define {name}"


def _is_made_of(measures: Mapping[str, Measure], name: str) -> bool:
    """Whether a measure is an expression in several others that have names of their own."""
    measure = measures[name]
    return isinstance(measure, Composed) and sum(part in measures.values() for _name, part in measure.measures) > 1
