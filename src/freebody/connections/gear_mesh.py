"""Gear mesh: pitch circles roll on each other, outside or inside a ring gear, on fixed or moving centres.

An efficiency eta is dry friction mu F along r_1 theta_1 - r_2 theta_2 (both seen from the line of centres), F the tooth
force: whichever gear drives gives (1 + mu) F r and the other one gets (1 - mu) F r, so that mu = (1 - eta)/(1 + eta).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Self, cast

from freebody.connections.circles import look_at_fit, own_radius, touching
from freebody.connections.shared_by_copies import SharedByCopies, gathered
from freebody.connections.standing import distance_between, is_near, number_of
from freebody.connections.teeth import parting_slope, parts_of_tooth_force, read_pressure_angle
from freebody.language.expression import ONE, ZERO, Expr, add, divide, free_symbols, multiply, negate, number
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow, DryFriction, RigidBody, UnilateralConstraint
from freebody.model.glyphs import Glyph
from freebody.model.pressed_side import Flank
from freebody.model.spec import Formula
from freebody.tolerances import ROUNDED

if TYPE_CHECKING:
    from freebody.model.names import Names


class GearMesh(SharedByCopies, kind="gear_mesh"):
    """`gear_mesh: [sun, planet]`, `gear_mesh: {first: ring, second: planet, internal: true}` with the ring gear
    first. The tooth force acts along the common tangent of the pitch circles and is positive when it resists a
    counter-clockwise turn of the first gear. With a `pressure_angle` the teeth part the gears as well, by its tangent
    times the tooth force, which is positive then, or negative with `other_flank: true`. The distance of the centres is
    held too where no carrier or bearing holds it already (1 or 2 rows). `first_radius`, `second_radius` for a wheel
    with several gears on it, or `module: m, teeth: [z1, z2]`: the pitch circles have the diameters m z, as those of
    bodies that are gears (`gear: {teeth: z, module: m}`) have. `efficiency: eta` of the teeth, whichever of the two
    drives: of the power that goes through the mesh, as seen from the line of centres, so much comes out."""

    called: ClassVar[tuple[str, ...]] = ("mesh", "gear")
    also: ClassVar[tuple[str, ...]] = (
        "gear",
        "gears",
        "mesh",
        "transmission",
        "gearbox",
        "gear_train",
        "Zahneingriff",
        "Eingriff",
        "Getriebe",
    )
    elsewhere: ClassVar[Mapping[str, str]] = {
        "ratio": Message(
            "gears of which the ratio alone is known, as in a box, are a constraint of measured angles: measures: "
            "{{phi: angle of rotor, psi: angle of drum}}, connections: {{gears: {{constraint: phi - 30*psi}}}}; else "
            "give both a radius"
        )
    }

    first: str
    second: str
    internal: bool = False
    first_radius: Formula | None = None
    second_radius: Formula | None = None
    module: Formula | None = None
    teeth: list[Formula] | None = None
    pressure_angle: Formula | None = None
    other_flank: bool = False
    efficiency: Formula | None = None

    in_plane = True
    has_contact_point = True
    example = """
bodies: {a: {disk: {mass: 1 kg, radius: 1 m}}, b: {disk: {mass: 1 kg, radius: 1 m}, at: [2 m, 0]}}
ground: {points: {A: [0, 0], B: [2 m, 0]}}
connections: {p: {pin: [ground.A, a]}, q: {pin: [ground.B, b]}, it: {gear_mesh: [a, b]}}
"""

    @classmethod
    def length_of(cls, entry: Mapping[str, Any], body: str, field: str) -> str | None:
        """The pitch circle of a gear that has no radius of its own."""
        module, teeth = entry.get("module"), entry.get("teeth")
        gears = entry.get("first"), entry.get("second")
        if field != "radius" or module is None or not isinstance(teeth, list) or body not in gears:
            return None
        own = dict(zip(gears, cast("list[Any]", teeth), strict=False)).get(body)
        return None if own is None else f"({module})*({own})/2"

    def as_meant(self, names: Names) -> Self:
        """With the ring gear first."""
        first, second = names.bodies.get(self.first), names.bodies.get(self.second)
        if first is None or second is None or first.has_inner_teeth or not second.has_inner_teeth:
            return self
        swapped = {
            "first": self.second,
            "second": self.first,
            "first_radius": self.second_radius,
            "second_radius": self.first_radius,
            "teeth": None if self.teeth is None else self.teeth[::-1],
        }
        return self.model_copy(update=swapped)

    def rows(self, names: Names) -> list[ConstraintRow]:
        first, second = names.body(self.first, "first"), names.body(self.second, "second")
        if first.name == second.name:
            names.problem(Message("{first} cannot mesh with itself", first=first.name))
            return []
        self._look_at_modules(names)
        radii = self._radii(names)
        slope = parting_slope(read_pressure_angle(names, self))
        flank = -1 if self.other_flank else 1
        internal = self._is_internal(names)
        # teeth of a ring gear pull the two centres together
        parting = slope if internal == (flank > 0) else -slope
        terms: list[tuple[Expr, Measure]] = []
        apart: list[tuple[Expr, Measure]] = []
        centers: list[ConstraintRow] = []
        for k, (one, other) in enumerate(self._pairs(names)):
            distance, total, rolled = touching(one.center, radii[0], other.center, radii[1], internal=internal)
            if k == 0:
                self._look_at_distance(names, (first, second), radii, total)
            terms += rolled.terms
            apart += [] if slope == ZERO else [(parting, distance)]
            name = "centers" if k == 0 else f"centers {k + 1}"
            centers.append(ConstraintRow(name, "radial force", distance, total, if_needed=True))
        teeth = ConstraintRow(
            "teeth",
            "tooth force",
            Combination(gathered([*terms, *apart]), LENGTH),
            sign=-1,
            pressed=None
            if slope == ZERO
            else Flank(flank, Combination(gathered([*terms, *((negate(c), d) for c, d in apart)]), LENGTH)),
        )
        turns = {name: Angle(name) for pair in self.pairs_of_gears(names) for name in pair}
        return [teeth, *self.alike(names, turns), *centers]

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        if self.efficiency is None:
            return [], []
        eta = names.formula(self.efficiency, DIMENSIONLESS, "efficiency")
        if (n := names.numeric(eta)) is not None and not 0.0 < n <= 1.0:
            names.problem(Message("an efficiency is between 0 and 1, found {eta:g}", eta=n), "efficiency")
            return [], []
        with names.quietly():
            radii, internal = self._radii(names), self._is_internal(names)
            ways = [
                touching(one.center, radii[0], other.center, radii[1], internal=not internal)[2]
                for one, other in self._pairs(names)
            ]
        slip = Combination(gathered(term for way in ways for term in way.terms), LENGTH)
        row = ConstraintRow("friction", "friction force", slip, connection=connection)
        mu = divide(ONE - eta, ONE + eta)
        return [], [DryFriction(row, mu, mu, (f"{connection}.teeth",))]

    def _pairs(self, names: Names) -> list[tuple[RigidBody, RigidBody]]:
        return [(names.known(one), names.known(other)) for one, other in self.pairs_of_gears(names)]

    def _is_internal(self, names: Names) -> bool:
        """Whether the first gear is a ring gear."""
        return self.internal or names.known(self.first).has_inner_teeth

    def _counts(self, names: Names) -> tuple[Expr, ...]:
        """The numbers of teeth, as far as they are said here or with the gears."""
        if self.teeth is not None:
            counts = tuple(names.formula(z, DIMENSIONLESS, "teeth", k) for k, z in enumerate(self.teeth))
            names.counts.update(*map(free_symbols, counts))
            return counts
        own = (names.known(gear).teeth for gear in (self.first, self.second))
        return tuple(teeth.count for teeth in own if teeth is not None)

    def teeth_with(self, names: Names, body: str) -> tuple[float, float, int] | None:
        if body not in (self.first, self.second):
            return None
        with names.quietly():
            counts = [z for z in map(names.numeric, self._counts(names)) if z is not None]
        if len(counts) != 2:
            return None
        first, second = counts
        sense = 1 if self._is_internal(names) else -1
        return (first, second, sense) if body == self.second else (second, first, sense)

    def _look_at_distance(
        self, names: Names, gears: tuple[RigidBody, RigidBody], radii: tuple[Expr, Expr], total: Expr
    ) -> None:
        """What is put where its pitch circles do not touch is not passed over in silence: what lies inside the other is
        refused, of the rest it is said that only the radii count."""
        apart = distance_between(names, gears[0].center, gears[1].center)
        if apart is None or is_near(apart, needed := abs(number_of(names, total))):
            return
        first, second = (gear.name for gear in gears)
        if not self._is_internal(names) and is_near(apart, abs(number_of(names, add(radii[0], negate(radii[1]))))):
            names.problem(
                Message(
                    "where {first} and {second} are put, one pitch circle lies inside the other, as in a ring gear. "
                    "Write internal: true, with the ring gear first",
                    first=first,
                    second=second,
                )
            )
            return
        me = self.own_name(names)
        if self.module is not None:
            names.problem(
                Message(
                    "with these teeth the centres of {first} and {second} are {needed:.4g} m apart, and the model puts "
                    "them {apart:.4g} m apart: change their places, or take the module {module:.4g} m",
                    first=first,
                    second=second,
                    needed=needed,
                    apart=apart,
                    module=number_of(names, names.formula(self.module, LENGTH)) * apart / needed,
                ),
                "module",
            )
            return
        names.assumptions.append(
            Message(
                "{connection}: the pitch circles of {first} and {second} do not touch where these are put ({apart:.4g} "
                "m between the centres instead of {needed:.4g} m); only the ratio of the radii counts",
                connection=me,
                first=first,
                second=second,
                apart=apart,
                needed=needed,
            )
        )

    def _radii(self, names: Names) -> tuple[Expr, Expr]:
        if self.module is None and self.teeth is None:
            radii = own_radius(names, self, "first"), own_radius(names, self, "second")
            if self._is_internal(names):
                look_at_fit(names, self.second, radii[1], self.first, radii[0], "first")
            return radii
        if self.module is None or self.teeth is None or len(self.teeth) != 2:
            names.problem(Message("module and teeth go together, e.g. module: 2 mm, teeth: [17, 51]"), "teeth")
            return ONE, ONE
        module = names.positive(self, "module", LENGTH)
        teeth = self._counts(names)
        self._look_at_teeth(names, teeth)
        first, second = (divide(multiply(module, z), number(2)) for z in teeth)
        for key, radius in (("first", first), ("second", second)):
            self._look_at_radius(names, key, radius)
        return first, second

    def _look_at_modules(self, names: Names) -> None:
        """Of gears by teeth and module: one module, and the ring gear first."""
        first, second = names.known(self.first), names.known(self.second)
        if second.has_inner_teeth:
            told = Message(
                "{ring} is a ring gear: write it first, [{ring}, {planet}]", ring=second.name, planet=first.name
            )
            names.problem_once(told)
        if first.teeth is None or second.teeth is None:
            return
        one, other = (names.numeric(body.teeth.module) for body in (first, second) if body.teeth is not None)
        if one is not None and other is not None and not is_near(one, other):
            names.problem_once(
                Message(
                    "{first} has the module {one:.4g} m, {second} {other:.4g} m: only teeth of one module mesh",
                    first=first.name,
                    one=one,
                    second=second.name,
                    other=other,
                )
            )

    def _look_at_teeth(self, names: Names, teeth: Sequence[Expr]) -> None:
        """Numbers of teeth are whole, and a ring gear has more than what runs in it."""
        numbers = [names.numeric(z) for z in teeth]
        for k, z in enumerate(numbers):
            if z is not None and (z < 1 or abs(z - round(z)) > ROUNDED):
                near = max(1, round(z))
                names.problem(
                    Message("{z:g} teeth: a number of teeth is whole, e.g. {near}", z=z, near=near), "teeth", k
                )
        ring, planet = numbers
        if self._is_internal(names) and ring is not None and planet is not None and ring <= planet:
            names.problem(
                Message(
                    "the ring gear comes first and has more teeth than what runs in it: at least {least:g}, found "
                    "{ring:g}",
                    least=planet + 1,
                    ring=ring,
                ),
                "teeth",
            )

    def _look_at_radius(self, names: Names, key: str, radius: Expr) -> None:
        """A body with a radius of its own has that of its teeth; of several gears on one shaft that of one of them."""
        own = names.known(getattr(self, key)).radius
        drawn, needed = None if own is None else names.numeric(own), names.numeric(radius)
        if drawn is None or needed is None or is_near(drawn, needed):
            return
        if not any(is_near(drawn, other) for other in self._radii_by_teeth(names, getattr(self, key))):
            names.problem(
                Message(
                    "{body} has the radius {drawn:.4g} m, and module and teeth give {needed:.4g} m; leave its radius "
                    "out, or make it a body without one",
                    body=getattr(self, key),
                    drawn=drawn,
                    needed=needed,
                ),
                key,
            )

    def _radii_by_teeth(self, names: Names, body: str) -> Iterator[float]:
        """What the module and the teeth of all meshes of a body give."""
        meshes = [mesh for mesh in names.connections.values() if isinstance(mesh, GearMesh)]
        for mesh in meshes:
            if mesh.module is None or mesh.teeth is None or body not in (mesh.first, mesh.second):
                continue
            with names.quietly():
                module = names.numeric(names.formula(mesh.module, LENGTH))
                teeth = [names.numeric(names.formula(z, DIMENSIONLESS)) for z in mesh.teeth]
            z = dict(zip((mesh.first, mesh.second), teeth, strict=False)).get(body)
            if module is not None and z is not None:
                yield module * z / 2.0

    def parts(self, names: Names) -> dict[str, Expr]:
        return parts_of_tooth_force(read_pressure_angle(names, self))

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        r1, r2 = self._radii(names)
        radii = (r1, negate(r2) if self._is_internal(names) else r2)
        for first, second in self._pairs(names):
            yield glyphs.Wheels(first.center, second.center, radii, is_toothed=True)
