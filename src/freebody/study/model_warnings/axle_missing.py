"""A planet that no axle carries, beside a body that turns about the middle of its train and carries nothing; and a
wheel without an axle where that of another body is."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import hypot

from freebody.connections.gear_mesh import GearMesh
from freebody.language.sentences import Message
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import AXES, GROUND, Point
from freebody.model.elements import RigidBody
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind


class AxleMissing(WarningKind, name="axle missing"):
    """Teeth alone hold a wheel where it is; which body carries it round they do not say. An arm on the axle of a wheel
    with which it meshes that carries nothing else is meant to."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        system = model.system
        if system.space:
            return
        rows = [row for row in system.rows if not row.is_driven]
        joined = {
            body.name: {row.connection for row in rows if body.name in row.measure.bodies()} for body in system.moving
        }
        meshes = {name for name, each in system.connections.items() if isinstance(each, GearMesh)}
        arms = [body for body in system.moving if len(joined[body.name]) == 1 and not joined[body.name] & meshes]
        for wheel in system.moving:
            own = joined[wheel.name]
            if not own or not own <= meshes:
                continue
            partners = {
                other
                for row in rows
                if row.connection in own
                for other in row.measure.bodies()
                if other not in (wheel.name, GROUND)
            }
            if (held := self._held_there(model, wheel)) is not None:
                point, other = held
                told = Message(
                    "teeth alone hold {wheel}, so that it can leave {point}, about which {other} turns: if {wheel} "
                    "turns there, too, give it a bearing: {{pin: [{point}, {wheel}]}}",
                    wheel=wheel.name,
                    point=point,
                    other=other,
                )
                yield self.warning(told, "bodies", wheel.name, about=frozenset((wheel.name, other)))
                continue
            for arm in arms:
                about = self._axis(model, arm, joined[arm.name], partners)
                if about is None or arm.name == wheel.name:
                    continue
                apart = hypot(*(model.start.value(Displacement(wheel.center, about, e)) for e in AXES[:2]))
                x, y = (model.start.value(Displacement(about, arm.center, replace(e, body=arm.name))) for e in AXES[:2])
                place = ", ".join("0" if abs(each) <= model.close else f"{each:.5g} m" for each in (x + apart, y))
                told = Message(
                    "teeth alone hold {wheel}, and {arm} carries nothing: if {wheel} turns on {arm}, join them, as "
                    "axle: {{pin: [{arm}.P, {wheel}]}}, with {arm}: {{..., points: {{P: [{place}]}}}}",
                    wheel=wheel.name,
                    arm=arm.name,
                    place=place,
                )
                yield self.warning(told, "bodies", wheel.name, about=frozenset((wheel.name, arm.name)))
                break

    def _held_there(self, model: Opened, wheel: RigidBody) -> tuple[str, str] | None:
        """The point of the ground at which the middle of a wheel is, if a joint holds another body there; and that
        body."""
        for row in model.system.rows:
            own = row.measure
            if row.is_driven or not isinstance(own, Displacement) or wheel.name in own.bodies():
                continue
            ends = {point.body: point for point in (own.of, own.origin)}
            others = [body for body in ends if body != GROUND]
            if GROUND not in ends or len(others) != 1 or model.system.bodies[others[0]].fixed:
                continue
            middle = model.system.bodies[others[0]].center
            there = (ends[GROUND], ends[others[0]], middle)
            if all(
                abs(model.start.value(Displacement(wheel.center, p, e))) <= model.close for p in there for e in AXES[:2]
            ):
                return ends[GROUND].name or GROUND, others[0]
        return None

    def _axis(self, model: Opened, arm: RigidBody, joints: set[str], wheels: set[str]) -> Point | None:
        """The point about which an arm turns, if one of some wheels turns about it, too."""
        rows = [row for row in model.system.rows if row.connection in joints]
        held = [row.measure for row in rows if isinstance(row.measure, Displacement)]
        points = [point for each in held for point in (each.of, each.origin) if point.body == arm.name]
        for point in points:
            for wheel in wheels:
                center = model.system.bodies[wheel].center
                if all(abs(model.start.value(Displacement(point, center, e))) <= model.close for e in AXES[:2]):
                    return point
        return None
