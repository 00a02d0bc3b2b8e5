"""Dry friction of a given size: brakes, clutches, and any measure that resists with a Coulomb force."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.connections.base import Connection
from freebody.language.expression import free_symbols
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, FORCE, TIME, TORQUE, Dimension
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow, DryFriction, UnilateralConstraint
from freebody.model.friction import read_friction
from freebody.model.glyphs import Glyph
from freebody.model.phrases import measure_of
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class Brake(Connection, kind="brake"):
    """`brake: {between: [drum, ground], torque: T}`: dry friction against a relative turn; a clutch is one between two
    bodies that turn. torque: the largest torque, a formula in parameters, time `t` and named measures, or
    {static: ..., kinetic: ...}."""

    also: ClassVar[tuple[str, ...]] = ("clutch",)
    elsewhere: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("force", "friction", "mu", "normal_force", "pressed", "pressed_with"),
        Message(
            "a shoe that is pressed with N at the radius r brakes with mu*N*r: write torque: mu*N*r; where the bearing "
            "takes that force, or a lever presses the shoe, it is a contact"
        ),
    )

    between: list[str]
    torque: Formula | dict[str, Any]

    is_chosen = True
    in_plane = True
    example = """
bodies: {drum: {disk: {mass: 1 kg, radius: 0.1 m}}}
connections: {p: {pin: [ground.A, drum]}, it: {brake: {between: [drum, ground], torque: 0.1 N m}}}
"""

    @classmethod
    def from_plain(cls, value: object) -> dict[str, Any]:
        """`{on: drum, torque: T}`: a brake of one body is held by the ground."""
        given = super().from_plain(value)
        word = next((word for word in ("on", "body", "wheel", "drum") if isinstance(given.get(word), str)), None)
        if word is not None and "between" not in given:
            return {"between": [given[word], GROUND], **{key: each for key, each in given.items() if key != word}}
        return given

    more_words: ClassVar[Mapping[str, tuple[str, ...]]] = dict.fromkeys(("on", "body", "wheel", "drum"), ("between",))

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        if len(self.between) != 2:
            names.problem(Message("a brake is between two bodies, e.g. between: [drum, ground]"), "between")
            return [], []
        first, second = (names.body(name, "between", k) for k, name in enumerate(self.between))
        if first is second and first.name not in names.broken:
            told = Message("joins {body} to itself; name two bodies", body=first.name)
            names.problem(told, "between")
        for k, body in enumerate((first, second)):
            if not body.turns:
                names.problem(Message("{body} is a particle and does not turn", body=body.name), "between", k)
        measure = Angle(first.name, second.name)
        return [], [_rub(names, connection, "torque", measure, self.torque, TORQUE, "torque")]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        first, second = (names.body(name) for name in self.between)
        yield glyphs.Shoe(first.center, second.center)


class FrictionAlongMeasure(Connection, kind="dry_friction"):
    """`dry_friction: {measure: x, force: F}`: a Coulomb force (a torque for an angle) of a given size that resists
    the rate of a measure, and holds it where it can. force: as the torque of a brake."""

    measure: str | dict[str, Any]
    force: Formula | dict[str, Any]

    is_chosen = True
    in_plane = True
    example = """
bodies: {block: {particle: {mass: 1 kg}}}
measures: {x: x of block}
connections: {rail: {slider: {body: block, along: right}}, it: {dry_friction: {measure: x, force: 2 N}}}
"""

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        measure = measure_of(names, self.measure, "measure")
        if measure is None:
            return [], []
        dimension = TORQUE if measure.dimension == DIMENSIONLESS else FORCE
        return [], [_rub(names, connection, "friction", measure, self.force, dimension, "force")]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        measure = measure_of(names, self.measure)
        if measure is None:
            return
        force = self.force.get("static", "") if isinstance(self.force, dict) else self.force
        what = "torque" if measure.dimension == DIMENSIONLESS else "force"
        for body in list(measure.bodies())[:1]:
            yield glyphs.Equation(names.known(body).center, f"friction {what} <= {force}")


def _rub(
    names: Names, connection: str, component: str, measure: Measure, size: Any, dimension: Dimension, field: str
) -> DryFriction:
    extra = {"t": TIME} | {n: m.dimension for n, m in names.measures.items()}
    friction = read_friction(names, size, dimension, field, extra=extra)
    used = sorted((free_symbols(friction.static) | free_symbols(friction.kinetic)) & set(names.measures))
    reaction = "friction torque" if dimension == TORQUE else "friction force"
    row = ConstraintRow(component, reaction, measure, connection=connection)
    return DryFriction(row, friction.static, friction.kinetic, measures=tuple((n, names.measures[n]) for n in used))
