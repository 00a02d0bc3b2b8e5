"""The symbolic route: from a System to its motion in generalized coordinates, exactly.

1. Coordinates. The absolute coordinates (x, y, theta) of the bodies, the lengths and angles of the tangents in the
   held measures, and the named measures are unknowns; the held measures are equations; `Elimination` keeps the
   generalized coordinates q.
2. Speeds. Differentiating what is left (closed loops, nonholonomic rows) gives the dependent speeds by the
   independent ones, u.
3. Dynamics. With V the velocity of a mass centre and S = dV/du, d'Alembert's principle in Kane's form:
   sum_i S_i^T (m_i A_i) + S_w,i^T I_i alpha_i = sum over loads of law * d(rate of its measure)/du,
   which is M(q) du/dt = F(q, u, t). Source: Kane & Levinson, Dynamics: Theory and Applications (1985), ch. 6.
4. Reactions. Newton-Euler of every body, M_i A_i - loads = J^T lambda, solved for the multipliers.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.expression import Call, Expr, Symbol, differentiate, evaluate, free_symbols
from freebody.language.notation import to_text
from freebody.language.units import DIMENSIONLESS
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Bearing, Distance
from freebody.measures.geometry import GROUND, RIGHT, UP, Point, Pose, Vector
from freebody.measures.geometry import ZERO as NOTHING
from freebody.model.elements import AppliedLoad, ConstraintRow, NonholonomicForm
from freebody.symbolic.elimination import GIVEN, Elimination, RowEquation, TangentPair, Unknown
from freebody.symbolic.field import Field, Generator, NoValue, Ratio
from freebody.symbolic.functions import cos_sin
from freebody.symbolic.geometry import AnyPose, Dual, DualGeometry, FieldGeometry, Tangent, straight_tangent
from freebody.symbolic.linear import RHS, Row, Solved, solve
from freebody.symbolic.sample import Sample
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.start_pose import StartPose, known_poses, recognised
from freebody.system.order import in_one_order
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF

Parts = tuple[Ratio, ...]  # along the slots of a body
# Ranks of unknowns: the lowest is eliminated first.
POSITION, TANGENT_LENGTH, TANGENT_ANGLE, BODY_ANGLE, OFFERED, NAMED = range(6)
N_RATES = 5  # of a given function of time; an acceleration's rate needs three


@dataclass(frozen=True)
class Coordinate:
    """A generalized coordinate: its name, its generator and the generator of its speed."""

    name: str
    index: int
    speed: int
    is_angle: bool


class SymbolicModel:
    """Everything the symbolic route derives, each part when it is first asked for."""

    slots: tuple[str, ...] = ("x", "y", "angle")  # of a body: its velocity, its angular velocity
    n_places = 2  # of these, for a particle

    def __init__(self, system: System, samples: Sequence[Sample]) -> None:
        self.system = in_one_order(system)
        self.samples = tuple(samples)
        n = len(system.moving)
        self.field = Field(capacity=len(system.parameters) + 10 * n + 3 * len(system.measures) + 24)
        self._functions: dict[int, Expr] = {}  # given functions of time and their rates: what they are in numbers
        self.parameters = self._parameters()
        self.lengths: tuple[Expr, ...] = ()
        self.constants: dict[str, Ratio] = {}  # hidden start values of incremental rows, by row name
        self.given_constants: dict[int, Ratio] = {}  # of these: what they are in the parameters
        self.assumed: list[Ratio] = []  # elements taken to be positive, as they are at the first sample
        self._coordinate_measures: dict[int, Measure] = {}
        self.start_symbols: dict[int, Ratio] = {}  # by coordinate
        self._raw_poses: dict[str, AnyPose] = {}
        self._unknowns: dict[int, Unknown] = {}
        self._speeds: dict[int, int] = {}
        self._names: dict[int, str] = {}
        self._tangents: dict[Any, tuple[Ratio, Ratio]] = {}
        self._lines: list[TangentPair] = []
        self._defined: dict[int, Ratio] = {}  # named measures as coordinates: what they are
        self._tangent_label = ""
        self._tangent_of: Measure | None = None
        self._definitions: list[RowEquation] = []
        self._line_equations: dict[Any, list[RowEquation]] = {}
        self._defined_lines: set[Any] = set()
        self._made_for: dict[str, list[int]] = {}  # the unknowns that came with a measure, by its definition
        self._without_rate: set[int] = set()  # speeds of measures without a rate at a sample
        self._angles: set[int] = set()
        self._make_poses()
        self._raw = self._raw_geometry()
        self._sample_values = [self._values_at(sample) for sample in self.samples]
        self.extra: list[RowEquation] = []
        self._is_eliminated = False  # while coordinates are chosen nothing is known of loops
        self.elimination = self._eliminate([])
        self._finish_coordinates()
        # what the first pass found out may make the second one simpler; which rows are redundant is told by the first
        held = {row.name for row in self.system.held}  # what defines a line or a name of the user holds nothing
        redundant = [name for name in self.redundant if name in held]
        for found_out in (self._named_by_formula, self._constant_coordinates):
            equations = found_out()
            if equations:
                self._with_equations([*self.extra, *equations])
        self._put_in_equal_angles()
        self.redundant = self._not_by_construction(redundant)
        self.lengths = self._raw.scalars  # what the geometry is made of, in parameters

    def _with_equations(self, extra: list[RowEquation]) -> None:
        """Eliminates again, with equations that were found out."""
        self.extra = extra
        self._is_eliminated = False
        self.elimination = self._eliminate(extra)
        self._finish_coordinates()

    def _put_in_equal_angles(self) -> None:
        """Puts in the angles that the branch keeps equal (a parallelogram's), or opposite, up to right angles. That
        they follow from the loops is proved by the count: what has as many freedoms with them is the same motion."""
        equations, n, before = self._equal_angles(), len(self.coordinates), self.extra
        if equations:
            self._with_equations([*before, *equations])
            if len(self.coordinates) != n:
                self._with_equations(before)

    def _not_by_construction(self, redundant: list[str]) -> list[str]:
        """The rows that follow from others, without those that the choice of coordinates holds."""
        return redundant

    @property
    def singular_poses(self) -> tuple[str, ...]:
        """Where coordinates are not determined, in words."""
        return ()

    # -- generators ---------------------------------------------------------------------------
    def _raw_geometry(self) -> FieldGeometry:
        return FieldGeometry(self.field, self.parameters, self._raw_poses, self._raw_tangent)

    def _parameters(self) -> dict[str, Ratio]:
        names: dict[str, Ratio] = {}
        for p in self.system.parameters.values():
            if p.form is not None:
                names[p.name] = self._function_of_time(p.name, p.form)
                continue
            g = self.field.parameter(p.name, positive=p.sign == "positive")
            if p.acute:
                self.field.acute_angles.add(self.field.index(g))
            if p.sign == "nonnegative":
                self.field.nonnegative.add(self.field.index(g))
            names[p.name] = g
        names["t"] = self.field.time
        return names

    def _function_of_time(self, name: str, form: Expr) -> Ratio:
        """A generator for a function of time that stays general, and generators for its rates."""
        shown: Expr = Symbol(name)
        chain: list[Ratio] = []
        for _ in range(N_RATES + 1):
            chain.append(self.field.generator(Generator(shown, "time")))
            self._functions[self.field.index(chain[-1])] = form
            shown, form = Call("rate", shown), differentiate(form, "t")
        for function, rate in pairwise(chain):
            self.field.set_rate(function, rate)
        return chain[0]

    def _unknown(
        self,
        name: str,
        rank: tuple[int, int],
        *,
        compute: Callable[[Mapping[int, Any], Any], Any] | None = None,
        is_angle: bool = False,
    ) -> Ratio:
        shown = Symbol(name)
        g = self.field.generator(Generator(shown, "coordinate", compute=compute))
        speed = self.field.generator(Generator(Call("rate", shown), "speed"))
        self.field.set_rate(g, speed)
        index = self.field.index(g)
        self._unknowns[index] = Unknown(index, rank, name)
        self._speeds[index] = self.field.index(speed)
        self._names[index] = name
        if is_angle:
            self._angles.add(index)
        else:
            self.field.no_angles.add(index)
        return g

    def _known_unknown(self, name: str) -> Ratio | None:
        """The generator made for a named measure before, when the elimination is run again."""
        for index, known in self._names.items():
            if known == name and index in self._defined:
                return self.field.variable(index)
        return None

    def _make_poses(self) -> None:
        f = self.field
        zero = f.zero
        for k, body in enumerate(self.system.bodies.values()):
            if body.fixed:
                continue
            x = self._unknown(f"x_{body.name}", (POSITION, -k))
            y = self._unknown(f"y_{body.name}", (POSITION, -k))
            ix, iy = f.index(x), f.index(y)
            origin = Point(GROUND, (NOTHING, NOTHING))
            self._coordinate_measures[ix] = Displacement(body.mass_center, origin, RIGHT)
            self._coordinate_measures[iy] = Displacement(body.mass_center, origin, UP)
            old = self._unknowns[ix]
            self._unknowns[ix] = Unknown(ix, old.rank, old.name, partner=iy)
            if not body.turns:
                self._raw_poses[body.name] = Pose(x, y, zero, f.one, zero)
                continue
            angle = self._unknown(f"theta_{body.name}", (BODY_ANGLE, -k), is_angle=True)
            self._coordinate_measures[f.index(angle)] = Angle(body.name)
            self._raw_poses[body.name] = Pose(x, y, angle, *cos_sin(f, angle))
        plain = FieldGeometry(f, self.parameters, {}, straight_tangent(f, None))
        for body in self.system.bodies.values():
            if body.fixed and body.name != "ground":
                angle = zero if body.start.angle is None else plain.scalar(body.start.angle)
                c, s = cos_sin(f, angle)
                px = py = zero
                if body.start.at is not None:
                    point, (ax, ay) = body.start.at
                    rx, ry = (plain.scalar(e) for e in body.points[point])
                    px, py = plain.scalar(ax) - (c * rx - s * ry), plain.scalar(ay) - (s * rx + c * ry)
                self._raw_poses[body.name] = Pose(px, py, angle, c, s)

    def _raw_tangent(self, v: Vector[Ratio], offset: Ratio) -> tuple[Ratio, Ratio]:
        """New unknowns l and a with v = l e(a) + offset n(a), as two more equations."""
        key = (v.x.key(), v.y.key(), offset.key())
        if key in self._tangents:
            self._define_line(key)
            return self._tangents[key]
        f = self.field
        opposite = ((-v.x).key(), (-v.y).key(), offset.key())
        if opposite in self._tangents and offset.is_zero():
            self._define_line(opposite)
            length, angle = self._tangents[opposite]
            self._tangents[key] = length, angle + f.pi
            return self._tangents[key]

        def size(values: Mapping[int, Any], fn: Any) -> Any:
            x, y, r = (f.evaluate(e, values, fn) for e in (v.x, v.y, offset))
            return fn.sqrt(x * x + y * y - r * r)

        def turn(values: Mapping[int, Any], fn: Any) -> Any:
            x, y, r = (f.evaluate(e, values, fn) for e in (v.x, v.y, offset))
            return fn.atan2(y, x) - fn.atan2(r, fn.sqrt(x * x + y * y - r * r))

        k = len(self._tangents)
        label = self._new_label(self._tangent_label or f"line{k + 1}")
        length = self._unknown(f"length_{label}", (TANGENT_LENGTH, -k), compute=size)
        angle = self._unknown(f"phi_{label}", (TANGENT_ANGLE, -k), compute=turn, is_angle=True)
        c, s = cos_sin(f, angle)
        name = f"line {k}"
        self._line_equations[key] = [
            RowEquation(name, v.x - length * c + offset * s),
            RowEquation(name, v.y - length * s - offset * c),
        ]
        self._define_line(key)
        self._tangents[key] = length, angle
        if isinstance(self._tangent_of, Distance):
            of = self._tangent_of
            self._coordinate_measures[f.index(angle)] = Bearing(of.start, of.end)
            self._coordinate_measures[f.index(length)] = of
        self._lines.append(TangentPair(name, v.x, v.y, offset, f.index(length), f.index(angle)))
        return length, angle

    def _new_label(self, wanted: str) -> str:
        """What a line is called: by its connection, with a number where that has several."""
        taken = set(self._names.values())
        labels = (wanted, *(f"{wanted}{k}" for k in range(2, len(taken) + 3)))
        return next(label for label in labels if not {f"length_{label}", f"phi_{label}"} & taken)

    def _define_line(self, key: Any) -> None:
        """Adds the two equations of a line, once in every pass."""
        if key in self._line_equations and key not in self._defined_lines:
            self._defined_lines.add(key)
            self._definitions += self._line_equations[key]

    # -- positions ----------------------------------------------------------------------------
    def _named_by_formula(self) -> list[RowEquation]:
        """Named measures that are linear in an unnamed coordinate, and so can take its place."""
        found: list[RowEquation] = []
        taken: set[int] = set()
        for name, measure in self.system.measures.items():
            own = self._known_unknown(name)
            if own is None or name not in self._dropped:
                continue
            n_assumed, known_lines = len(self.assumed), set(self._straight)
            try:
                value = self.value_of(measure)
            except (CannotAnswer, ZeroDivisionError):
                self._forget(n_assumed, known_lines)
                continue  # too long to write, so no coordinate
            for c in self.coordinates:
                if c.index in taken or c.name in self.system.measures:
                    continue
                if self.field.ingredients(value.denominator()) & self._unknowns.keys():
                    continue
                slope = self.field.partial(value, c.index)
                inside = self.field.ingredients(value)
                if slope.is_constant() and not slope.is_zero() and len(inside & self._unknowns.keys()) == 1:
                    found.append(RowEquation(f"define {name}", own - value))
                    taken.add(c.index)
                    break
            else:
                self._forget(n_assumed, known_lines)
        return found

    def _forget(self, n_assumed: int, known_lines: set[Any]) -> None:
        """What was assumed in looking at a measure that became no coordinate is assumed only by who asks for it."""
        del self.assumed[n_assumed:]
        for key in self._straight.keys() - known_lines:
            del self._straight[key]

    def _constant_coordinates(self) -> list[RowEquation]:
        """Dependent coordinates that do not move: their start values, where these are known, are their values."""
        f = self.field
        lines = {line.length for line in self._lines} | {line.angle for line in self._lines}
        still = [c for c in self.dependent if self.vanishes(self._dependent_speeds[c.speed])]
        values: dict[int, Ratio] = {}
        if len(still) == len(self.dependent) and not self.coordinates:
            values = {i: x for i, x in self._given_poses().items() if self._stands_still(i)}
        for c in still:
            if c.index not in values and c.index not in lines:
                value = self.given_start(c)
                if value is None:
                    value = self.recognised_start(c)
                if value is not None:
                    values[c.index] = value
        return [RowEquation(GIVEN, f.variable(index) - value) for index, value in values.items()]

    def _equal_angles(self) -> list[RowEquation]:
        """Angles bound by closed loops that differ from others by the same multiple of a right angle at all samples, or
        whose sum does."""
        found: list[RowEquation] = []
        kept = [c for c in self.coordinates if c.is_angle]
        general = any(not s.is_start for s in self.samples)
        for c in self.dependent if general and self.elimination.loops else ():
            if not c.is_angle:
                continue
            for other, sign in ((k, s) for k in kept for s in (1, -1)):
                difference = self.field.variable(c.index) - sign * self.field.variable(other.index)
                values = list(self._at(difference, range(len(self.samples))))
                constant = recognised(self.field, values, is_angle=True)
                if constant is not None:
                    found.append(RowEquation(GIVEN, difference - constant))
                    break
            else:
                kept.append(c)
        return found

    def _stands_still(self, index: int) -> bool:
        """Whether an absolute coordinate keeps its value, which a driver may change."""
        return self.vanishes(self.rate(self.elimination.express(self.field.variable(index))))

    def recognised_start(self, c: Coordinate) -> Ratio | None:
        """A start value that is a multiple of a right angle (zero for a length) at all samples."""
        return recognised(self.field, self.start_numbers(c.index), is_angle=c.is_angle)

    @property
    def _given_angles(self) -> set[str]:
        """Measures that are unknowns from the beginning."""
        return set()

    def _holds_by_construction(self, row: ConstraintRow) -> bool:
        return False

    def _held_value(self, measure: Measure) -> Ratio:
        """A held measure in absolute coordinates."""
        return measure.value(self._raw)

    def _eliminate(self, given: list[RowEquation]) -> Elimination:
        """Tries the named and offered measures as coordinates; one that only adds a loop of its own is dropped."""
        self._defined_lines = set()
        equations: list[RowEquation] = list(given)
        for row in self.system.held:
            if not isinstance(row.measure, NonholonomicForm) and not self._holds_by_construction(row):
                self._tangent_label, self._tangent_of = row.connection, row.measure
                equations.append(RowEquation(row.name, self._held_value(row.measure) - self._target(row)))
        constraints = equations + self._definitions
        self._definitions = []
        measures = self.system.measures
        # wanted in the one order of measures; one that is at an extreme at the start is no coordinate there: last
        wanted = sorted(measures, key=lambda n: any(n in sample.still for sample in self.samples))
        candidates = [(f"define {n}", n, m, (NAMED, -wanted.index(n))) for n, m in measures.items()]
        named = {m for _d, _n, m, _r in candidates}
        candidates = [c for c in candidates if c[1] not in self._given_angles]
        taken = set(self.system.measures) | set(self.parameters) | self._given_angles
        for k, (name, measure) in enumerate(self.system.offered):
            if measure not in named and name not in taken:
                candidates.append((f"define {name}", name, measure, (OFFERED, -k)))
        defined: list[tuple[str, list[RowEquation], list[int]]] = []
        for label, name, measure, rank in candidates:
            before = set(self._unknowns)
            self._tangent_label, self._tangent_of = name, measure
            try:
                value = measure.value(self._raw)
            except (CannotAnswer, ZeroDivisionError):
                continue
            own = self._known_unknown(name) or self._unknown(
                name,
                rank,
                compute=lambda v, fn, value=value: self.field.evaluate(value, v, fn),
                is_angle=measure.dimension == DIMENSIONLESS,
            )
            self._defined[self.field.index(own)] = value
            self._coordinate_measures[self.field.index(own)] = measure
            made = [RowEquation(label, own - value)] + [RowEquation(label, e.value) for e in self._definitions]
            self._definitions = []
            # made in the first pass: those of a measure that is dropped in a later one go with it
            new = self._made_for.setdefault(label, [i for i in self._unknowns if i not in before])
            defined.append((label, made, new))
        self._sample_values = [self._values_at(sample) for sample in self.samples]
        # a measure without a value at a sample, as the bearing of points that coincide there, is no coordinate
        without = {label for label, _made, new in defined if not all(map(self._has_values, new))}
        # measures that bring lines of their own are taken only where they add no loop
        fewest: int | None = None
        with_lines = {d[0] for d in defined if len(d[1]) > 1} - without
        dropped: set[str] = with_lines | without
        replaced = {e.name for e in given}
        n_assumed = len(self.assumed)
        while True:
            del self.assumed[n_assumed:]  # what a choice of measures assumed that is not taken
            chosen = [d for d in defined if d[0] not in dropped and d[0] not in replaced]
            out = {i for d in defined if d[0] in dropped and d[0] not in replaced for i in d[2]}
            unknowns = {i: u for i, u in self._unknowns.items() if i not in out}
            elimination = Elimination(
                self.field,
                unknowns,
                constraints + [e for d in chosen for e in d[1]],
                self._lines,
                self.vanishes,
                straight_tangent(self.field, self.is_negative),
                OFFERED,
                self._angle_by if self.system.space else None,
            )
            bad = {e.name for e in elimination.loops if e.name.startswith("define ")}
            if bad:
                dropped |= bad
                continue
            if fewest is not None and len(elimination.loops) > fewest:
                dropped |= with_lines
                with_lines = set[str]()
                continue
            if with_lines and fewest is None:
                fewest = len(elimination.loops)
                dropped -= with_lines
                continue
            self._dropped = {label.removeprefix("define ") for label in dropped}
            return elimination

    def _has_values(self, index: int) -> bool:
        """Whether an unknown has a value at every sample; the length of a line must not be zero, or it has no angle."""
        lengths = {line.length for line in self._lines}
        for values in self._sample_values:
            value = values.get(index)
            if value is None or not math.isfinite(value) or (index in lengths and abs(value) < ROUND_OFF):
                return False
        return True

    def _angle_by(self, index: int, a: Ratio, b: Ratio, d: Ratio) -> Ratio | None:
        """The angle q with a cos q + b sin q + d = 0, on the branch of the samples; None where that is not clear."""
        return None

    def _target(self, row: ConstraintRow) -> Ratio:
        """What a row is held at; the start value of an incremental one is a constant of its own unless it is
        zero at every sample."""
        if row.in_symbols is not None:
            return self._raw.scalar(row.in_symbols)
        if not row.measure.incremental:  # type: ignore[union-attr]
            return self.field.zero
        if all(abs(s.constants.get(row.name, 0.0)) < ROUND_OFF for s in self.samples):
            return self.field.zero
        given = self._given_value(row.measure, row.name)  # type: ignore[arg-type]
        if given is not None and (len(self.field.terms(given.num)) == 1 or self._is_placed(row.measure)):  # type: ignore[arg-type]
            return given
        name = row.name.replace(".", "_").replace(" ", "_")
        constant = self.field.parameter(f"{name}_0")
        self.constants[row.name] = constant
        if given is not None:  # as one symbol until an answer contains it: it may stand in many sines
            self.given_constants[self.field.index(constant)] = given
        return constant

    def _is_placed(self, measure: Measure) -> bool:
        """Whether the model gives the places and angles of all bodies of a measure."""
        given = self._given_poses()
        poses = (self._raw_poses[name] for name in measure.bodies() if name != GROUND)
        return all(e.generators() <= given.keys() for pose in poses for e in _pose_elements(pose))

    def _values_at(self, sample: Sample) -> dict[int, Any]:
        """Values of all generators at a sample; speeds and accelerations that it does not tell are arbitrary."""
        f = self.field
        values: dict[int, Any] = {}
        for name, g in self.parameters.items():
            if f.index(g) not in self._functions:
                values[f.index(g)] = sample.time if name == "t" else sample.parameters[name]
        for index, form in self._functions.items():
            values[index] = float(evaluate(form, {**sample.parameters, "t": sample.time}))
        for name, g in self.constants.items():
            values[f.index(g)] = sample.constants[name]
        self._add_poses(values, sample)
        values = f.complete(values)
        if sample.velocities:
            self._add_speeds(values)
        self._add_arbitrary(values)
        return f.complete(values)

    def _add_arbitrary(self, values: dict[int, Any]) -> None:
        """Speeds and accelerations that nothing tells: by their names, so that no order of questions changes them."""
        for index, generator in self.field.generators.items():
            is_free = index not in values and index not in self._without_rate
            if is_free and generator.kind in ("speed", "acceleration"):
                values[index] = random.Random(to_text(generator.display)).uniform(0.5, 1.5)

    def _add_poses(self, values: dict[int, Any], sample: Sample) -> None:
        """Poses of the bodies, and their velocities where the sample tells them."""
        for body, pose in sample.poses.items():
            motion = sample.velocities.get(body, ())
            for k, element in enumerate(_pose_elements(self._raw_poses[body])):
                if element.generators():
                    index = self.field.index(element)
                    values[index] = pose[k]
                    if motion:
                        values[self._speeds[index]] = motion[k]

    def _add_speeds(self, values: dict[int, Any]) -> None:
        """Speeds of lines, by l da/dt = n . dv/dt and dl/dt = e . dv/dt + offset da/dt, and of named measures. Some
        have none, as the rate of a distance has where its ends coincide: nothing else waits for them."""
        f = self.field
        for line in self._lines:
            # a line without length has no direction that could turn
            if not values.get(line.length) or line.angle not in values:
                self._without_rate |= {self._speeds[line.angle], self._speeds[line.length]}
                continue
            vx, vy = (f.evaluate(f.rate(c), values) for c in (line.x, line.y))
            cos, sin = math.cos(values[line.angle]), math.sin(values[line.angle])
            turning = (cos * vy - sin * vx) / values[line.length]
            values[self._speeds[line.angle]] = turning
            values[self._speeds[line.length]] = cos * vx + sin * vy + f.evaluate(line.offset, values) * turning
        for index, value in self._defined.items():
            try:
                values[self._speeds[index]] = f.evaluate(f.rate(value), values)
            except (NoValue, ZeroDivisionError):
                self._without_rate.add(self._speeds[index])

    def numbers(self, sample: Sample, start: Sample | None = None) -> dict[int, Any]:
        """Values of all generators at a sample with velocities, for evaluating results there; `start` is the same
        draw at the start, for symbols of start values."""
        values = self._values_at(sample)
        if self.start_symbols:
            first = values if start is None else self._values_at(start)
            for index, symbol in self.start_symbols.items():
                values[self.field.index(symbol)] = first[index]
            values = self.field.complete(values)
        return values

    def _values(self, k: int) -> dict[int, Any]:
        """Sample k, with the atoms made since."""
        known = self._sample_values[k]
        if len(known) < len(self.field.generators):
            self._add_arbitrary(known)
            self._sample_values[k] = self.field.complete(known)
        return self._sample_values[k]

    def at_samples(self, x: Ratio) -> list[float]:
        """The element in numbers at the start poses of all samples; nan where it has no real value."""
        return list(self._at(x, [k for k, s in enumerate(self.samples) if s.is_start]))

    def at_start_with(self, x: Ratio, number: int, changed: Mapping[int, float]) -> float:
        """The element at the start pose of that number, with other values of some generators; nan if it is not real."""
        f = self.field
        k = [k for k, s in enumerate(self.samples) if s.is_start][number]
        known = self._values(k)
        needed = f.ingredients(x)
        values = {g: v for g, v in known.items() if not f.generators[g].made_of & changed.keys()} | dict(changed)
        try:
            for g in sorted(needed - values.keys()):
                compute = f.generators[g].compute
                assert compute is not None
                values[g] = compute(values, math)
            return float(f.evaluate(x, values))
        except (KeyError, ValueError, ArithmeticError):
            return math.nan

    def _at(self, x: Ratio, which: Sequence[int]) -> Iterator[float]:
        for k in which:
            try:
                yield float(self.field.evaluate(x, self._values(k)))
            except (KeyError, ValueError, ArithmeticError):
                yield math.nan

    def vanishes(self, x: Ratio) -> bool:
        """True if the element is zero on the motion: formally, or at all samples where coordinates are bound by
        closed loops."""
        if x.is_zero():
            return True
        fraction = x.fraction()
        if fraction is not None or not self.samples:
            return False
        if not self._is_looped(x):
            return False
        # poses in general position, since an entry may vanish at the start and nowhere else
        general = [k for k, s in enumerate(self.samples) if not s.is_start]
        # what does not vanish shows it at the first of them, nearly always
        return all(self._vanishes_at(x, k) for k in general or range(len(self.samples)))

    def _vanishes_at(self, x: Ratio, k: int) -> bool:
        """Whether the terms of an element cancel at a sample: beside their own sizes, so in all units."""
        try:
            value, size = self.field.numerator_and_size(x, self._values(k))
        except (KeyError, ValueError, ArithmeticError):
            return False
        return abs(value) <= ROUND_OFF * size

    def _is_looped(self, x: Ratio) -> bool:
        if not self._is_eliminated:
            return True
        return bool(self.elimination.loops)

    def is_negative(self, x: Ratio) -> bool:
        """The sign at the first sample, where formulas do not tell; the choice is noted as an assumption."""
        if sign_of(x) in (Sign.POSITIVE, Sign.NONNEGATIVE):
            return False
        values = self.at_samples(x)
        negative = bool(values) and values[0] < 0
        assumed = -x if negative else x
        if all(assumed != other for other in self.assumed):
            self.assumed.append(assumed)
        return negative

    def is_turned(self, x: Ratio) -> bool | None:
        """The same; None where speeds stand in it: what moves one way at an instant may move the other at the next."""
        if sign_of(x) in (Sign.POSITIVE, Sign.NONNEGATIVE):
            return False
        kinds = {self.field.generators[g].kind for g in self.field.ingredients(x)}
        return None if kinds & {"speed", "acceleration"} else self.is_negative(x)

    # -- coordinates and speeds ---------------------------------------------------------------
    def _finish_coordinates(self) -> None:
        self._is_eliminated = True
        f = self.field
        express = self.elimination.express
        self.poses = {name: self._expressed(p, express) for name, p in self._raw_poses.items()}
        straight = straight_tangent(f, self.is_negative)
        gone = set(self._unknowns) - set(self.elimination.unknowns)
        cache = self._straight = dict[Any, tuple[Ratio, Ratio]]()
        for line in self._lines:
            if not gone & {line.length, line.angle}:
                key = (express(line.x).key(), express(line.y).key(), line.offset.key())
                cache[key] = express(f.variable(line.length)), express(f.variable(line.angle))

        def tangent(v: Vector[Ratio], offset: Ratio) -> tuple[Ratio, Ratio]:
            key = (v.x.key(), v.y.key(), offset.key())
            if key not in cache:
                opposite = ((-v.x).key(), (-v.y).key(), offset.key())
                if opposite in cache and offset.is_zero():
                    cache[key] = cache[opposite][0], cache[opposite][1] + f.pi
                else:
                    cache[key] = straight(v, offset)
            return cache[key]

        self.geometry = self._plain_geometry(tangent)
        self.dual = DualGeometry(self.geometry, {b.name: b.turns for b in self.system.bodies.values()})
        kept = [
            Coordinate(u.name, u.index, self._speeds[u.index], u.index in self._angles) for u in self.elimination.kept
        ]
        self._solve_speeds(kept)

    def _expressed(self, p: AnyPose, express: Callable[[Ratio], Ratio]) -> AnyPose:
        assert isinstance(p, Pose)
        return Pose(*(express(v) for v in (p.x, p.y, p.angle, p.cos, p.sin)))

    def _plain_geometry(self, tangent: Tangent) -> FieldGeometry:
        return FieldGeometry(self.field, self.parameters, self.poses, tangent)

    def _solve_speeds(self, kept: list[Coordinate]) -> None:
        """Which speeds are independent, and the others by them: J u = b, and J du/dt = db/dt - dJ/dt u."""
        f = self.field
        for speed in self._speeds.values():
            f.clear_rate(speed)  # of an earlier pass
        totals: list[tuple[str, Ratio]] = [(loop.name, f.rate(loop.value)) for loop in self.elimination.loops]
        for row in self.system.held:
            if isinstance(row.measure, NonholonomicForm):
                total = f.zero if row.in_symbols is None else -self.geometry.scalar(row.in_symbols)
                for coefficient, measure in row.measure.terms:
                    total = total + coefficient.value(self.geometry) * f.rate(self.value_of(measure))
                totals.append((row.name, total))
        names = [name for name, _total in totals]
        preference = [c.speed for c in sorted(kept, key=lambda c: self._unknowns[c.index].rank)]
        rows = [self._speed_row(total, preference) for _name, total in totals]
        solved = solve(f, rows, preference, self.vanishes, in_order=True)
        if solved.contradictory:
            raise CannotAnswer(
                f"the constraints contradict each other in {', '.join(names[k] for k in solved.contradictory)}"
            )
        self.redundant = [*self.elimination.redundant, *(names[k] for k in solved.redundant)]
        self.speed_rows = [rows[k] for k in range(len(rows)) if k not in solved.redundant]
        free = set(solved.free)
        self.coordinates = tuple(c for c in kept if c.speed in free)
        self.dependent = tuple(c for c in kept if c.speed not in free)
        self._dependent_speeds = {speed: self._sum_of(row) for speed, row in solved.pivots.items()}
        self._still_speeds = {speed: f.zero for speed, x in self._dependent_speeds.items() if self.vanishes(x)}
        for k in range(len(self.samples)):
            values = self._values(k)
            for speed, expression in self._dependent_speeds.items():
                try:
                    values[speed] = f.evaluate(expression, self._values(k))
                except ZeroDivisionError:  # the formula fails in the pose of this sample
                    values[speed] = math.nan
        self.accelerations: list[int] = []
        for c in self.coordinates:
            a = f.generator(Generator(Call("rate", f.generators[c.speed].display), "acceleration"))
            f.set_rate(f.variable(c.speed), a)
            self.accelerations.append(f.index(a))
        if self.dependent:
            self._solve_dependent_accelerations([totals[k][1] for k in range(len(rows)) if k not in solved.redundant])

    def _solve_dependent_accelerations(self, totals: Sequence[Ratio]) -> None:
        speeds = [c.speed for c in self.dependent]
        rows: list[Row] = []
        for total in totals:
            row: Row = {s: x for s in speeds if not (x := self.field.partial(total, s)).is_zero()}
            rest = self.field.rate(total)  # the dependent speeds have no rate yet, so theirs are missing
            if not rest.is_zero():
                row[RHS] = -rest
            rows.append(row)
        solved = solve(self.field, rows, speeds, self.vanishes)
        if len(solved.pivots) < len(speeds):
            raise CannotAnswer("the loops determine the speeds, but not the accelerations that go with them")
        for speed in speeds:
            self.field.set_rate(self.field.variable(speed), self._sum_of(solved.pivots[speed]))

    def _sum_of(self, row: Row) -> Ratio:
        total = row.get(RHS, self.field.zero)
        for column, coefficient in row.items():
            if column != RHS:
                total = total + coefficient * self.field.variable(column)
        return total

    def _speed_row(self, total: Ratio, speeds: Sequence[int]) -> Row:
        row: Row = {}
        rest = total
        for speed in speeds:
            coefficient = self.field.partial(total, speed)
            if not coefficient.is_zero():
                row[speed] = coefficient
                rest = rest - coefficient * self.field.variable(speed)
        if not rest.is_zero():
            row[RHS] = -rest
        return row

    def value_of(self, measure: Measure) -> Ratio:
        """A measure in coordinates."""
        return measure.value(self.geometry)

    def measure_of(self, c: Coordinate) -> Measure | None:
        """The measure that a coordinate is; None for a length or angle of a line that is none by itself."""
        if c.index in self._coordinate_measures:
            return self._coordinate_measures[c.index]
        return None

    # -- start values -------------------------------------------------------------------------
    def given_start(self, c: Coordinate) -> Ratio | None:
        """The start value of a coordinate where the start of the model tells it."""
        values = dict(self._start_pose_values)
        defined = self._defined.get(c.index)
        x = self.field.variable(c.index) if defined is None else defined
        for line in self._lines:
            if {line.length, line.angle} & self.field.ingredients(x):
                place = self.field.follow(line.x, values), self.field.follow(line.y, values)
                if not any(self.field.ingredients(p) & self._unknowns.keys() for p in place):
                    length, angle = straight_tangent(self.field, self.is_negative)(Vector(*place), line.offset)
                    values |= {line.length: length, line.angle: angle}
        needed = self.field.ingredients(x) & self._unknowns.keys()
        if not needed <= values.keys():
            return None
        return self.field.follow(x, values)

    def given_start_speed(self, c: Coordinate, start: Mapping[int, Ratio]) -> Ratio | None:
        """The start value of a speed where the velocities given for the bodies tell it."""
        speeds: dict[int, Ratio] = {}
        for body in self.system.moving:
            pose = self._raw_poses[body.name]
            assert isinstance(pose, Pose)
            for elements, given in (
                ((pose.x, pose.y), body.start.velocity),
                (
                    (pose.angle,),
                    # a particle has no angle of which this could be the rate
                    None if body.start.angular_velocity is None or not body.turns else (body.start.angular_velocity,),
                ),
            ):
                if given is not None:
                    for element, expr in zip(elements, given, strict=True):
                        speeds[self._speeds[self.field.index(element)]] = self.geometry.scalar(expr)
        if not speeds:
            return None
        # each given velocity is an equation in the independent speeds
        for raw_index, speed in self._speeds.items():
            if speed in speeds:
                own = self.rate(self.elimination.express(self.field.variable(raw_index)))
                own = self.field.follow(own, {k: v for k, v in start.items() if k != c.speed})
                if own.generators() & {k.speed for k in self.coordinates} == frozenset({c.speed}):
                    slope = self.field.partial(own, c.speed)
                    rest = own - slope * self.field.variable(c.speed)
                    return (speeds[speed] - rest) / slope
        return None

    def wanted_rates(self, known: Mapping[str, Expr]) -> list[tuple[Ratio, Ratio]]:
        """The rates that the start gives, of named measures and of bodies, each with what it is."""
        scalar = self.geometry.scalar
        wanted = [(self.rate(self.value_of(self.system.measures[n])), scalar(e)) for n, e in known.items()]
        for body in self.system.moving:
            x, y, turning = self.velocities[body.name]
            wanted += [(v, scalar(e)) for v, e in zip((x, y), body.start.velocity or (), strict=False)]
            if body.start.angular_velocity is not None and body.turns:
                wanted.append((turning, scalar(body.start.angular_velocity)))
        return wanted

    def start_speeds(self, known: Mapping[str, Expr], start: Mapping[int, Ratio]) -> dict[int, Ratio] | None:
        """All independent speeds at the start together, where the model has them so."""
        return None

    def _given_value(self, measure: Measure, name: str) -> Ratio | None:
        """The start value of a measure where the poses given for its bodies tell it, as they do at all samples."""
        poses = known_poses(self.field, self._raw_poses, self._start_pose_values)
        start = FieldGeometry(self.field, self.parameters, poses, straight_tangent(self.field, self.is_negative))
        try:
            value = measure.value(start)
        except (CannotAnswer, ZeroDivisionError):
            return None
        if self.field.ingredients(value) & self._unknowns.keys():
            return None
        starts = [s for s in self.samples if s.is_start]
        for number, sample in zip(self.at_samples(value), starts, strict=True):
            if not _is_same(number, sample.constants.get(name, 0.0)):
                return None
        return value

    @cached_property
    def _start_pose_values(self) -> dict[int, Ratio]:
        """The absolute coordinates at the start, where the model tells them."""
        absolute = {
            self.field.index(element)
            for body in self.system.moving
            for element in _pose_elements(self._raw_poses[body.name])
            if element.generators()
        }
        unknowns = {index: self._unknowns[index] for index in absolute}
        try:
            start = StartPose(
                self.system,
                self.field,
                self._raw_poses,
                self.parameters,
                unknowns,
                self.is_negative,
                self.at_samples,
            )
            return start.values(self.start_numbers)
        except CannotAnswer:  # too long to write
            return self._given_poses()

    def _value_from_start(self, measure: Measure, name: str) -> Ratio | None:
        """The same from the start values of the coordinates."""
        f = self.field
        values: dict[int, Ratio] = {f.index(f.time): f.zero}
        for c in (*self.coordinates, *self.dependent):
            if c.name in self.system.start:
                values[c.index] = self.geometry.scalar(self.system.start[c.name])
                continue
            value = self.given_start(c)
            if value is None:
                value = self.recognised_start(c)
            if value is None:
                return None
            values[c.index] = value
        x = f.follow(self.value_of(measure), values)
        starts = [s for s in self.samples if s.is_start]
        same = all(
            _is_same(number, sample.constants.get(name, 0.0))
            for number, sample in zip(self.at_samples(x), starts, strict=True)
        )
        return x if same else None

    def _given_poses(self) -> dict[int, Ratio]:
        values: dict[int, Ratio] = {}
        f, scalar = self.field, self._raw.scalar
        for body in self.system.moving:
            pose, start = self._raw_poses[body.name], body.start
            assert isinstance(pose, Pose)
            angle = None
            if not body.turns:
                angle = f.zero
            elif start.angle is not None:
                angle = scalar(start.angle)
                values[f.index(pose.angle)] = angle
            if start.at is None:
                continue
            point, (ax, ay) = start.at
            rx, ry = (scalar(e) for e in body.points[point])
            if angle is None and not (rx.is_zero() and ry.is_zero()):
                continue
            c, s = cos_sin(f, f.zero if angle is None else angle)
            values[f.index(pose.x)] = scalar(ax) - (c * rx - s * ry)
            values[f.index(pose.y)] = scalar(ay) - (s * rx + c * ry)
        return values

    def start_numbers(self, index: int) -> list[float]:
        """The start value of a generator at every sample that is a start pose."""
        return [float(self._values(k)[index]) for k, s in enumerate(self.samples) if s.is_start]

    def start_parameter(self, c: Coordinate, numbers: Sequence[float]) -> Ratio:
        """A symbol for a start value that follows from the assembly only."""
        symbol = self.field.parameter(f"{c.name}_0")
        starts = iter(numbers)
        last = numbers[0] if numbers else 0.0
        for k, sample in enumerate(self.samples):
            last = next(starts, last) if sample.is_start else last
            self._sample_values[k][self.field.index(symbol)] = last
        self.start_symbols[c.index] = symbol
        return symbol

    @property
    def degrees_of_freedom(self) -> int:
        return len(self.coordinates)

    @property
    def loops(self) -> tuple[RowEquation, ...]:
        """Equations among the coordinates that remain: the closed loops."""
        return tuple(self.elimination.loops)

    def rate(self, x: Ratio) -> Ratio:
        """Total time derivative; speeds of dependent coordinates stay as they are, but for those that are zero."""
        return self.field.substitute(self.field.rate(x), self._still_speeds)

    def in_independent_speeds(self, x: Ratio) -> Ratio:
        """The same with the speeds of dependent coordinates put in."""
        return self.field.substitute(x, self._dependent_speeds)

    def dependent_speed(self, c: Coordinate) -> Ratio:
        return self._dependent_speeds[c.speed]

    # -- kinematics of the bodies -------------------------------------------------------------
    @cached_property
    def velocities(self) -> dict[str, Parts]:
        """Velocity of the mass centre and angular velocity of every body, along its slots."""
        found: dict[str, Parts] = {}
        for b in self.system.moving:
            p = self.poses[b.name]
            assert isinstance(p, Pose)
            found[b.name] = self.rate(p.x), self.rate(p.y), self.rate(p.angle)
        return found

    @cached_property
    def partial_velocities(self) -> dict[str, list[Parts]]:
        """d(velocity of the mass centre, angular velocity)/du_k, for every body and independent speed."""
        return {
            name: [tuple(self.slope(part, c) for part in v) for c in self.coordinates]
            for name, v in self.velocities.items()
        }

    def slope(self, x: Ratio, c: Coordinate) -> Ratio:
        """Derivative by an independent speed, the dependent speeds following it."""
        f = self.field
        total = f.partial(x, c.speed)
        for speed, expression in self._dependent_speeds.items():
            if speed in x.generators():
                total = total + f.partial(x, speed) * f.partial(expression, c.speed)
        return total

    @cached_property
    def body_accelerations(self) -> dict[str, Parts]:
        """With the accelerations du/dt as generators."""
        return {name: tuple(map(self.rate, v)) for name, v in self.velocities.items()}

    @cached_property
    def inertias(self) -> dict[str, Parts]:
        """Mass and moment of inertia of every body, along its slots."""
        scalar = self.geometry.scalar
        return {b.name: (m, m, scalar(b.inertia)) for b in self.system.moving for m in (scalar(b.mass),)}

    def momentum(self, body: str, velocity: Parts) -> Parts:
        """The mass matrix of a body times a velocity of its, along its slots."""
        return tuple(m * v for m, v in zip(self.inertias[body], velocity, strict=True))

    def turning_momentum(self, body: str) -> Parts:
        """What the rate of a body's momentum has beside mass times acceleration: nothing in the plane."""
        return (self.field.zero,) * len(self.slots)

    def inertia_force(self, body: str, acceleration: Sequence[Ratio]) -> Parts:
        """The rate of a body's momentum, along its slots."""
        changing = self.momentum(body, tuple(acceleration))
        return tuple(p + q for p, q in zip(changing, self.turning_momentum(body), strict=True))

    # -- dynamics -----------------------------------------------------------------------------
    @cached_property
    def mass_matrix(self) -> list[list[Ratio]]:
        n = len(self.coordinates)
        f = self.field
        M = [[f.zero] * n for _ in range(n)]
        for name, partials in self.partial_velocities.items():
            momenta = [self.momentum(name, partial) for partial in partials]
            for slot in range(len(self.slots)):
                for j in range(n):
                    weighted = momenta[j][slot]
                    if weighted.is_zero():
                        continue
                    for k in range(j, n):
                        if not partials[k][slot].is_zero():
                            M[j][k] = f.lowest_terms(M[j][k] + weighted * partials[k][slot])
        for j in range(n):
            for k in range(j):
                M[j][k] = M[k][j]
        return M

    @cached_property
    def forcing(self) -> list[Ratio]:
        """F of M du/dt = F: generalized forces of the loads minus the velocity terms of the inertia."""
        f = self.field
        still = dict.fromkeys(self.accelerations, f.zero)
        forces = [f.zero for _ in self.coordinates]
        for name, wrench in self.load_wrenches.items():
            bias = [f.substitute(a, still) for a in self.body_accelerations[name]]
            push = [w - p for w, p in zip(wrench, self.inertia_force(name, bias), strict=True)]
            for k, partial in enumerate(self.partial_velocities[name]):
                for p, s in zip(push, partial, strict=True):
                    if not s.is_zero() and not p.is_zero():
                        forces[k] = f.lowest_terms(forces[k] + p * s)
        return forces

    @cached_property
    def load_wrenches(self) -> dict[str, list[Ratio]]:
        """Force and moment about the mass centre of all loads on every body, along its slots."""
        f = self.field
        total: dict[str, list[Ratio]] = {b.name: [f.zero] * len(self.slots) for b in self.system.moving}
        for push in self.system.pushes:
            law = self.law(push)
            for (body, slot), slope in self.gradient(push.measure).items():
                if body not in total:
                    continue  # what the ground feels moves nothing
                k = self.slots.index(slot)
                total[body][k] = total[body][k] + law * slope
        return total

    def gradient(self, measure: Measure | NonholonomicForm) -> dict[tuple[str, str], Ratio]:
        """Derivatives of a measure by the coordinates of the bodies (of its rate by their velocities)."""
        if measure not in self._gradients:
            self._gradients[measure] = self._gradient(measure)
        return self._gradients[measure]

    @cached_property
    def _gradients(self) -> dict[Any, dict[tuple[str, str], Ratio]]:
        return {}

    def _gradient(self, measure: Measure | NonholonomicForm) -> dict[tuple[str, str], Ratio]:
        if isinstance(measure, NonholonomicForm):
            total: dict[tuple[str, str], Ratio] = {}
            for coefficient, part in measure.terms:
                c = coefficient.value(self.geometry)
                for slot, slope in self._gradient(part).items():
                    total[slot] = total.get(slot, self.field.zero) + c * slope
            return total
        dual: Dual = measure.value(self.dual)
        return {slot: slope for slot, slope in dual.slope.items() if not slope.is_zero()}

    def law(self, push: AppliedLoad) -> Ratio:
        """Generalized force of a load; in coordinates, speeds and time."""
        return self.geometry.apply(push.in_symbols, self._law_values(push))

    def law_needs(self, push: AppliedLoad) -> list[tuple[Ratio, str]]:
        """(element, relation to 0) without which the law has no value as it is written."""
        return self.geometry.needs(push.in_symbols, self._law_values(push))

    def _law_values(self, push: AppliedLoad) -> dict[str, Ratio]:
        values: dict[str, Ratio] = {}
        needed = free_symbols(push.in_symbols)
        if not isinstance(push.measure, NonholonomicForm):
            if "@value" in needed:
                value = self.value_of(push.measure)
                values["@value"] = value - self.start_constant(push)
            if "@rate" in needed:
                values["@rate"] = self.rate(self.value_of(push.measure))
        for name, measure in push.measures:
            value = self.value_of(measure)
            values[name] = value
            values[f"rate({name})"] = self.rate(value)
        return values

    def start_constant(self, push: AppliedLoad) -> Ratio:
        """The start value of a measure of which only changes count (a spring relaxed at the start)."""
        if isinstance(push.measure, NonholonomicForm) or not push.measure.incremental:
            return self.field.zero
        if all(abs(s.constants.get(push.name, 0.0)) < ROUND_OFF for s in self.samples):
            return self.field.zero
        now = self.value_of(push.measure)
        if not self.field.ingredients(now) & (self._changing):
            return now  # it never changes
        given = self._given_value(push.measure, push.name)
        if given is None:
            given = self._value_from_start(push.measure, push.name)
        if given is not None:
            return given
        if push.name not in self.constants:
            name = push.name.replace(".", "_").replace(" ", "_")
            self.constants[push.name] = self.field.parameter(f"{name}_0")
            index = self.field.index(self.constants[push.name])
            for k, sample in enumerate(self.samples):
                self._sample_values[k][index] = sample.constants[push.name]
        return self.constants[push.name]

    @property
    def _changing(self) -> set[int]:
        """What may change with time: coordinates, time itself and given functions of it."""
        return {*self._unknowns, *self._functions, self.field.index(self.field.time)}

    @cached_property
    def solved_accelerations(self) -> dict[int, Ratio]:
        """du/dt in coordinates, speeds and time, by acceleration generator."""
        rows: list[Row] = []
        for line, force in zip(self.mass_matrix, self.forcing, strict=True):
            row: Row = {a: m for a, m in zip(self.accelerations, line, strict=True) if not m.is_zero()}
            if not force.is_zero():
                row[RHS] = force
            rows.append(row)
        solved = solve(self.field, rows, self.accelerations, self.vanishes)
        if solved.free:
            names = ", ".join(
                c.name for c, a in zip(self.coordinates, self.accelerations, strict=True) if a in solved.free
            )
            raise CannotAnswer(
                f"nothing with mass moves with {names}, so its acceleration is not determined. Give the body "
                "a mass or an inertia, or connect it"
            )
        return {a: solved.pivots[a].get(RHS, self.field.zero) for a in self.accelerations}

    # -- reactions ----------------------------------------------------------------------------
    @cached_property
    def _multipliers(self) -> tuple[Solved, dict[str, int]]:
        """J^T lambda = M A - loads, body by body."""
        f = self.field
        columns = {row.name: k for k, row in enumerate(self.system.held)}
        by_slot: dict[tuple[str, str], Row] = {}
        for row in self.system.held:
            for slot, slope in self.gradient(row.measure).items():
                by_slot.setdefault(slot, {})[columns[row.name]] = slope
        rows: list[Row] = []
        for body in self.system.moving:
            accelerations = [f.substitute(a, self.solved_accelerations) for a in self.body_accelerations[body.name]]
            changing = self.inertia_force(body.name, accelerations)
            for k, slot in enumerate(self.slots if body.turns else self.slots[: self.n_places]):
                row = dict(by_slot.get((body.name, slot), {}))
                if not row:
                    continue
                rest = changing[k] - self.load_wrenches[body.name][k]
                if not rest.is_zero():
                    row[RHS] = rest
                rows.append(row)
        return solve(f, rows, list(columns.values()), self.vanishes), columns

    def multiplier(self, row: ConstraintRow) -> Ratio:
        """The multiplier of a row. Raises CannotAnswer naming the connections where it is not unique."""
        solved, columns = self._multipliers
        column = columns[row.name]
        names = {k: name for name, k in columns.items()}
        if column in solved.free:
            with_it = [column] + [c for c, r in solved.pivots.items() if column in r]
        else:
            with_it = [column] + [c for c in solved.pivots[column] if c != RHS]
        if column in solved.free or len(with_it) > 1:
            rows = ", ".join(sorted(names[c] for c in with_it))
            raise CannotAnswer(
                f"the reaction {row.name} is not unique: the constraints {rows} depend on each other, so rigid-body "
                "mechanics fixes only a combination of their reactions. Remove one of them or make one part flexible"
            )
        return solved.pivots[column].get(RHS, self.field.zero)


def _pose_elements(pose: AnyPose) -> tuple[Ratio, ...]:
    assert isinstance(pose, Pose)
    return pose.x, pose.y, pose.angle


def _is_same(a: float, b: float) -> bool:
    """Whether a formula gives the number that was found by assembling the start, a length of 1e12 m as one of 1 m."""
    return math.isclose(a, b, rel_tol=1e-7, abs_tol=1e-7)
