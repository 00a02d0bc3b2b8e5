"""Driver: a measure follows a prescribed function of time."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.connections.base import Connection, as_written
from freebody.connections.standing import begun_by, is_parallel, same_way
from freebody.language.expression import ZERO, Expr, Symbol, add, multiply, negate, substitute
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH, TIME
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND, Direction, Point
from freebody.measures.turn import Turn
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow
from freebody.model.glyphs import Glyph
from freebody.model.phrases import measure_of
from freebody.model.polynomials import cross, polynomial
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


_LED = ("on", "drive", "wheel", "shaft", "link", "gear", "member", "of")  # what people call the body that is led


class Driver(Connection, kind="driver"):
    """`driver: {measure: theta, follows: omega*t}`. The driving force or torque does positive work when it pushes
    the measure up (1 row). `speed: omega` in place of a law: it goes on evenly from where it starts; `body: crank` in
    place of a measure: the angle of that body."""

    called: ClassVar[tuple[str, ...]] = ("drive", "motor")
    also: ClassVar[tuple[str, ...]] = ("drive", "motor", "input", "Antrieb")

    elsewhere: ClassVar[Mapping[str, str]] = {
        "joint": Message("it leads the angle of a body, or a measure: {{body: arm, speed: w}}"),
        **dict.fromkeys(
            ("angular_acceleration", "acceleration"), Message("a law in the time says it: {{follows: a*t^2/2}}")
        ),
        **dict.fromkeys(
            ("x", "y", "z", "phi", "theta"),
            Message("it leads a measure: {{measure: y of cart, follows: Y*sin(Omega*t)}}"),
        ),
    }

    more_words: ClassVar[Mapping[str, tuple[str, ...]]] = {
        **dict.fromkeys(_LED, ("body",)),
        **dict.fromkeys(("rpm", "n"), ("speed",)),
    }

    measure: str | dict[str, Any] | None = None
    follows: Formula | None = None
    body: str | None = None
    speed: Formula | None = None

    is_chosen = True
    example = """
bodies: {rod: {rod: {mass: 1 kg, length: 1 m}}}
connections: {p: {pin: [ground.A, rod.start]}, it: {driver: {measure: angle of rod, follows: w*t}}}
parameters: {w: 2 rad/s}
"""

    @classmethod
    def from_plain(cls, value: object) -> dict[str, Any]:
        """`{on: crank, rpm: 3000}` and `{crank: 300 rpm}` as what is led and its speed."""
        given = super().from_plain(value)
        if isinstance(value, dict) and "measure" not in given:
            word = next((word for word in _LED if isinstance(given.get(word), str)), None)
            if word is not None and "body" not in given and len(given) > 1:
                given["body"] = given.pop(word)
            if (rpm := given.get("rpm")) is not None and "speed" not in given and not isinstance(rpm, bool):
                given["speed"] = f"{given.pop('rpm')} rpm" if isinstance(rpm, int | float) else given.pop("rpm")
            if "n" in given and "speed" not in given:
                given["speed"] = given.pop("n")
            known = {*cls.model_fields, *cls.elsewhere}
            if len(given) == 1 and not given.keys() & known:
                ((name, speed),) = given.items()
                own = speed if isinstance(speed, dict) else {"speed": speed}
                given = {"body": name, **super().from_plain(own)} if name.isidentifier() else given
        return given

    def rows(self, names: Names) -> list[ConstraintRow]:
        if (self.measure is None) == (self.body is None):
            names.problem(Message("a driver leads a measure, or the angle of a body: give one of measure and body"))
            return []
        if (self.follows is None) == (self.speed is None):
            names.problem(Message("give the law that a driver follows, or its speed, e.g. follows: w*t, or speed: w"))
            return []
        measure = self._led(names)
        if measure is None:
            return []
        target = self._target(names, measure)
        what = {LENGTH: "driving force", DIMENSIONLESS: "driving torque"}
        return [ConstraintRow("drive", what.get(measure.dimension, "driving force"), measure, target)]

    def _led(self, names: Names) -> Measure | None:
        is_body = isinstance(self.measure, str) and self.measure in names.bodies
        if self.measure is not None and not is_body:
            return measure_of(names, self.measure, "measure")
        body = names.body(str(self.measure if is_body else self.body), "body")
        if not body.turns:
            names.problem(Message("{body} is a particle and does not turn", body=body.name), "body")
            return None
        led = measure_of(names, f"angle of {body.name}", "body")
        carriers = () if led is None else sorted({*led.bodies()} - {body.name, GROUND})
        for carrier in carriers:
            told = Message(
                "{connection}: {body} is led relative to {carrier}, which carries it. Where its motion against the "
                "ground is meant, write measure: angle of {body} about x (the axis)",
                connection=self.own_name(names),
                body=body.name,
                carrier=carrier,
            )
            if told not in names.assumptions:
                names.assumptions.append(told)
        return led

    def _target(self, names: Names, measure: Measure) -> Expr:
        """What it is led by: a law, or w t from its value at the start."""
        if self.follows is not None:
            return names.formula(self.follows, measure.dimension, "follows", extra={"t": TIME})
        speed = names.formula(self.speed, measure.dimension / TIME, "speed")
        return add(self._begun(names, measure), multiply(speed, Symbol("t")))

    def _begun(self, names: Names, measure: Measure) -> Expr:
        """Where the file lets it start: at the value of its name, at the angle of its body, else at zero."""
        named = (value for name, value in names.placed_at_start.items() if names.measures.get(name) == measure)
        turned = (names.known(body).start.angle for body in measure.bodies() if measure == Angle(body))
        return next((value for value in (*named, *turned, _turned(names, measure)) if value is not None), ZERO)

    def bears_at(self, names: Names, point: Point, normal: Direction) -> Expr | None:
        """Where what it leads starts, at t = 0."""
        with names.quietly():
            measure = self._led(names)
            if measure is None or point.body not in set(measure.bodies()):
                return None
            target = self._target(names, measure)
        return begun_by(names, measure, substitute(target, {"t": ZERO}), point, normal)

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        measure = self._led(names)
        if measure is None:
            return
        text = as_written(self.measure) if self.measure is not None else f"angle of {self.body}"
        law = f"{text} = {self.follows}" if self.follows is not None else f"{self._rate(text)} = {self.speed}"
        for body in list(measure.bodies())[:1]:
            yield glyphs.Equation(names.known(body).center, law)

    def _rate(self, text: str) -> str:
        return f"{text}'" if text.isidentifier() else f"rate of {text}"


def _turned(names: Names, measure: Measure) -> Expr | None:
    """In space: how far a body is turned at the start against one that is not, about the axis of its angle alone."""
    if not isinstance(measure, Turn) or measure.of.components != measure.start.components or measure.reference != ZERO:
        return None
    body, base = names.known(measure.of.body), names.known(measure.start.body)
    if base.start.turned or body.start.turned is None or len(body.start.turned) != 1:
        return None
    (rotation,) = body.start.turned
    start, side = ([polynomial(c) for c in each.components] for each in (measure.start, measure.side))
    axis = Direction(GROUND, tuple(c.expression() for c in cross(start, side)))
    if not is_parallel(names, axis, own := Direction(GROUND, rotation.axis)):
        return None
    return rotation.by if same_way(names, axis, own) else negate(rotation.by)
