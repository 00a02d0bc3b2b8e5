"""Resolves what a user wrote to what it means, and gathers every problem on the way.

A resolver never stops at the first mistake: it notes the problem with its place and goes on with something
harmless, so that one message can list them all.
"""

from __future__ import annotations

import difflib
import math
import re
from collections.abc import Generator, Iterable, Mapping
from contextlib import contextmanager, suppress
from fractions import Fraction
from typing import Any, Protocol, cast

from freebody.errors import ExpressionError, InputError, NoQuantity, Problem, UnitError
from freebody.language.expression import (
    FUNCTIONS,
    Call,
    Expr,
    ProductOf,
    Symbol,
    evaluate,
    free_symbols,
    negate,
    number,
    substitute,
)
from freebody.language.parser import parse
from freebody.language.sentences import Message
from freebody.language.units import (
    DIMENSIONLESS,
    FORCE,
    LARGEST,
    LENGTH,
    MASS,
    TIME,
    Dimension,
    dimension_of,
    is_unit,
    parse_quantity,
    quantities_within,
)
from freebody.measures.base import Measure
from freebody.measures.geometry import COMPASS, GROUND, ONE, Components, Direction, Point
from freebody.model.elements import AppliedLoad, Attitude, BodyPlane, ConstraintRow, Line, Parameter, RigidBody
from freebody.model.rotations import UNIT, Columns, applied
from freebody.model.spec import Spec
from freebody.tolerances import LEAST

ZERO = number(0)
PI = Symbol("pi")
_QUANTITY = re.compile(r"\s*[+-]?[\d.]+([eE][+-]?\d+)?\s*[A-Za-zµμ°%]")
_WITH_UNIT = re.compile(r"(?<![\w.])[\d.]+([eE][+-]?\d+)?\s+(?P<unit>[A-Za-zµμ°%]+)")


def placeholder(name: str) -> RigidBody:
    """Stands in for a body that could not be read; anything may be asked of it."""
    return RigidBody(name, ZERO, ZERO, {"center": (ZERO, ZERO)}, "center", radius=number(1), is_placeholder=True)


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """' Did you mean x?', or the list of what there is. Of several that a name begins (gear_mesh, gear_pair for gear)
    none is preferred."""
    options = sorted(set(known))
    if len(begun := [option for option in options if option.startswith(f"{name}_")]) > 1:
        return Message(" Did you mean one of {names}?", names=", ".join(begun))
    close = difflib.get_close_matches(name, options, n=1, cutoff=0.6)
    if close:
        return Message(" Did you mean {x}?", x=close[0])
    if not options:
        return ""
    shown = ", ".join(options[:12]) + (" ..." if len(options) > 12 else "")
    return Message(" There is: {names}.", names=shown)


class Joining(Protocol):
    """What the description asks of connections while it is read."""

    @property
    def is_one_force(self) -> bool:
        """Whether what it transmits at several places is one force to people."""
        ...

    def rows(self, names: Names) -> list[ConstraintRow]:
        """The measures that it holds."""
        ...

    def attitude(self, names: Names) -> Attitude | None:
        """In space: how one of its bodies is turned from the other."""
        ...

    def keeps_at(self, names: Names, point: Point, along: Direction, seen: frozenset[str]) -> Expr | None:
        """How far along a direction of the ground it keeps a point of one of its bodies."""
        ...

    def mentions(self, names: Names) -> set[str]:
        """Names of the bodies that it joins."""
        ...


class Names:
    """The names of one model in the making."""

    def __init__(self) -> None:
        self.parameters: dict[str, Parameter] = {}
        self.bodies: dict[str, RigidBody] = {}
        self.measures: dict[str, Measure] = {}
        self.problems: list[Problem] = []
        self.assumptions: list[str] = []
        self._path: tuple[str | int, ...] = ()
        self.connections: Mapping[str, Joining] = {}
        self.called: dict[str, tuple[str, ...]] = {}  # words for the kind of each body, connection and load
        self.broken: set[str] = set()  # what could not be read: told where it stands, and nowhere else
        self.is_cut_short = False  # a whole section of names could not be read
        self.started_at_zero: set[str] = set()  # named measures that the file lets start at zero
        self.starts_away = False  # a named measure, or its rate, starts away from zero
        self.start_rates: dict[str, Expr] = {}  # of named measures, as the file gives them
        self.constraint_rows: list[ConstraintRow] = []
        self.loads: dict[str, Dimension] = {}  # the dimension of what each load exerts
        self.impulses: frozenset[str] = frozenset()  # the loads that act in no time
        self.struck_at_start: frozenset[str] = frozenset()  # what closes and strikes at the start
        self.applied_loads: list[
            AppliedLoad
        ] = []  # what the loads push, known before the connections say what they hold
        self.free_ground_points: dict[str, tuple[str | int, ...]] = {}
        self.laying: list[Joining] = []  # strings whose way is being found, which place nothing yet
        self.space = False
        self.up: Components = (ZERO, ONE)
        self.frames: dict[str, tuple[str, Columns]] = {}  # the body each is fixed in, and its axes there

    @property
    def compass(self) -> dict[str, Direction]:
        """What directions are called, on the ground."""
        if not self.space:
            return COMPASS
        named = {axis: UNIT[k] for k, axis in enumerate("xyz")}
        named |= {"right": UNIT[0], "left": tuple(-c for c in UNIT[0])}
        named |= {"up": self.up, "down": tuple(-c for c in self.up)}
        named |= {f"-{axis}": tuple(-c for c in UNIT[k]) for k, axis in enumerate("xyz")}
        return {name: Direction(GROUND, components, name) for name, components in named.items()}

    @property
    def origin(self) -> Components:
        """The components of zero."""
        return (ZERO, ZERO, ZERO) if self.space else (ZERO, ZERO)

    @property
    def _example(self) -> str:
        return "[x, y, z]" if self.space else "[x, y]"

    @property
    def ground_origin(self) -> Point:
        return Point(GROUND, self.origin, "ground.origin")

    # -- problems -----------------------------------------------------------------------------
    @contextmanager
    def at(self, *path: str | int) -> Generator[None]:
        """Problems noted inside stand at this place of the model."""
        before = self._path
        self._path = before + path
        try:
            yield
        finally:
            self._path = before

    @contextmanager
    def reading(self, section: str, name: str, *path: str | int) -> Generator[None]:
        """As `at`; a name of which a problem is noted inside is broken."""
        n_before = len(self.problems)
        with self.at(section, name, *path):
            yield
        if len(self.problems) > n_before:
            self.broken.add(name)

    @contextmanager
    def quietly(self) -> Generator[None]:
        """Problems noted inside are told elsewhere."""
        n_before = len(self.problems)
        try:
            yield
        finally:
            del self.problems[n_before:]

    def is_broken_in(self, text: str) -> bool:
        """Whether a text names what could not be read: it is told where that stands."""
        return self.is_cut_short or any(name in self.broken for name in re.findall(r"\w+", text))

    def unknown(self, name: str, message: str, *path: str | int) -> None:
        """Notes a problem of a name that stands for nothing, but not where that follows from another problem."""
        if name not in self.broken and not self.is_cut_short:
            self.problem(message, *path)

    def problem(self, message: str, *path: str | int) -> None:
        noted = Problem(self._path + path, message)
        if noted not in self.problems:
            self.problems.append(noted)

    # -- expressions --------------------------------------------------------------------------
    def dimensions(self, *, in_time: bool = False) -> dict[str, Dimension]:
        """Of the parameters; functions of time are among them where time may be."""
        return {p.name: p.dimension for p in self.parameters.values() if p.form is None or in_time}

    def angle(self, value: Any, *path: str | int) -> Expr:
        """A formula for an angle; a number of more than a full turn needs a unit, since degrees are nearly always
        meant."""
        expr = self.formula(value, DIMENSIONLESS, *path)
        plain = expr.factors[1] if isinstance(expr, ProductOf) and expr.factors[0] == number(-1) else expr
        parameter = self.parameters.get(plain.name) if isinstance(plain, Symbol) else None
        bare = _as_number(value) if parameter is None else None if parameter.is_angle else parameter.value
        if bare is not None and abs(bare) > math.tau:
            told = Message("the angle {value} has no unit: write {value} deg, or {value} rad", value=f"{bare:g}")
            if parameter is not None:
                told = Message(
                    "{name} is used as an angle, and its value {value} has no unit: write {value} deg, or {value} rad",
                    name=parameter.name,
                    value=f"{bare:g}",
                )
            self.problem(told, *path)
        return expr

    def formula(
        self,
        value: Any,
        dimension: Dimension,
        *path: str | int,
        extra: Mapping[str, Dimension] | None = None,
    ) -> Expr:
        """An expression in the parameters (and `extra` names), or a quantity with its unit."""
        known = self.dimensions(in_time="t" in (extra or {})) | dict(extra or {})
        if isinstance(value, str) and (mixed := self._with_quantities(value, dimension, known)) is not None:
            return mixed
        if isinstance(value, bool) or not isinstance(value, (str, int, float)):
            self.problem(Message("expected a number or an expression, found {value}", value=repr(value)), *path)
            return ZERO
        if isinstance(value, (int, float)):
            if not math.isfinite(value):
                self.problem(Message("{value} is not a finite number", value=value), *path)
                return ZERO
            if abs(value) > LARGEST:
                self.problem(
                    Message(
                        "{value} is too large to calculate with: sizes go up to {most:.0e}", value=value, most=LARGEST
                    ),
                    *path,
                )
                return ZERO
            return number(value)
        try:
            expr = parse(value)
        except ExpressionError as error:
            return self._quantity(value, dimension, path, str(error))
        unknown = sorted(free_symbols(expr) - set(known))
        if free_symbols(expr) & self.broken or (unknown and self.is_cut_short):
            return ZERO
        if unknown and unknown[0] in self.parameters:
            message = Message(
                "{name} is a function of time; it may stand in drivers and in the laws of loads only", name=unknown[0]
            )
            return self._quantity(value, dimension, path, message)
        if unknown:
            message = Message(
                "{name} in '{value}' is not a parameter.{hint} Add it under parameters, e.g. {name}: 1",
                name=unknown[0],
                value=value,
                hint=did_you_mean(unknown[0], known),
            )
            return self._quantity(value, dimension, path, message)
        try:
            found = dimension_of(expr, known)
        except UnitError as error:
            return self._quantity(value, dimension, path, Message("in '{text}': {error}", text=value, error=error))
        if found != dimension and expr != ZERO:
            return self._quantity(value, dimension, path, _unit_differs(value, found, dimension))
        return expr

    def _with_quantities(self, text: str, dimension: Dimension, known: Mapping[str, Dimension]) -> Expr | None:
        """An expression in which numbers have units, where it reads as no other: 180 deg - alpha."""
        named, quantities = quantities_within(text, known)
        if not quantities:
            return None
        dimensions = {**known, **{name: q.dimension for name, q in quantities.items()}}

        def fits(written: str) -> Expr | None:
            with suppress(ExpressionError, UnitError):
                expr = parse(written)
                if free_symbols(expr) <= dimensions.keys() and dimension_of(expr, dimensions) == dimension:
                    return expr
            return None

        found = None if fits(text) is not None else fits(named)
        values = {name: quantity_expression(q) for name, q in quantities.items()}
        return None if found is None else substitute(found, values)

    def _quantity(self, text: str, dimension: Dimension, path: tuple[str | int, ...], why_not: str) -> Expr:
        quantity = None
        if _QUANTITY.match(text):
            try:
                quantity = parse_quantity(text)
            except NoQuantity:  # then it is meant as an expression
                pass
            except UnitError as error:
                why_not = str(error)
        if quantity is None:
            self.problem(self._mixed(text) or why_not, *path)
            return ZERO
        if quantity.dimension != dimension:
            self.problem(_unit_differs(text, quantity.dimension, dimension), *path)
            return ZERO
        return quantity_expression(quantity)

    def _mixed(self, text: str) -> Message | None:
        """What to say of an expression in which a value with its unit stands beside other things."""
        names = {*self.parameters, *FUNCTIONS}
        if not names.intersection(re.findall(r"\w+", text)) and not re.search(r"\S\s*\+|\s-\s", text):
            return None
        for found in _WITH_UNIT.finditer(text):
            if found["unit"] not in self.parameters and is_unit(found["unit"]):
                return Message(
                    "'{value}' in '{text}': a value with its unit does not fit here. Give it a name with its unit "
                    "under parameters, and write that name here",
                    value=found.group(),
                    text=text,
                )
        return None

    def positive(self, spec: Spec, field: str, dimension: Dimension) -> Expr:
        """A formula that must not be negative."""
        expr = self.formula(getattr(spec, field), dimension, field)
        value = self.numeric(expr)
        if value is not None and value < 0:
            self.problem(
                Message(
                    "{field} is negative ({value:g} {dimension}); give a positive one",
                    field=field,
                    value=value,
                    dimension=dimension,
                ),
                field,
            )
        return expr

    def optional(self, spec: Spec, field: str, dimension: Dimension) -> Expr | None:
        return None if getattr(spec, field) is None else self.positive(spec, field, dimension)

    def numeric(self, expr: Expr) -> float | None:
        """Its value, where all parameters in it have values."""
        values = {p.name: p.value for p in self.parameters.values() if p.value is not None}
        try:
            result = evaluate(expr, values)
        except (InputError, ZeroDivisionError, OverflowError, ValueError):
            return None
        return float(result)

    def vector(self, spec: Spec, field: str, dimension: Dimension) -> Components | None:
        value = getattr(spec, field)
        return None if value is None else self.components(value, dimension, field)

    def components(self, value: Any, dimension: Dimension, *path: str | int) -> Components:
        """[x, y], or [x, y, z] in space, where z may be left out."""
        items = cast("list[Any]", value) if isinstance(value, (list, tuple)) else []
        if self.space and len(items) == 2:
            items = [*items, 0]
        if len(items) != len(self.origin):
            wanted = Message("three components [x, y, z]" if self.space else "two components [x, y]")
            hint = Message(". For a model in space write space: true") if len(items) == 3 else ""
            self.problem(
                Message("expected {wanted}, found {value}{hint}", wanted=wanted, value=f"{value!r}", hint=hint),
                *path,
            )
            return self.origin
        return tuple(self.formula(item, dimension, *path, k) for k, item in enumerate(items))

    def vectors(self, spec: Spec, field: str, dimension: Dimension) -> list[Components]:
        return [self.components(v, dimension, field, k) for k, v in enumerate(getattr(spec, field))]

    # -- bodies, points, directions -----------------------------------------------------------
    def body(self, name: str, *path: str | int) -> RigidBody:
        found = self.bodies.get(name)
        if found is None:
            hint = did_you_mean(name, self.bodies)
            self.unknown(name, Message("there is no body {name}.{hint}", name=name, hint=hint), *path)
            return placeholder(name)
        return found

    def known(self, name: str) -> RigidBody:
        """A body that was looked up before; a stand-in if that failed."""
        return self.bodies.get(name) or placeholder(name)

    def point(self, text: Any, *path: str | int) -> Point:
        """`body.point`, or `body` for its reference point. A ground point that is not declared is the origin."""
        if not isinstance(text, str):
            self.problem(Message("expected a point such as rod.end, found {text}", text=repr(text)), *path)
            return self.bodies[GROUND].point("origin")
        body_name, _, point_name = text.strip().partition(".")
        body = self.body(body_name, *path)
        if body_name not in self.bodies or body.is_placeholder:
            return body.point()
        if not point_name:
            if body_name == GROUND:
                self.problem(Message("a place on the ground needs a name, e.g. ground.A, or ground.origin"), *path)
            return body.point()
        if point_name in body.points:
            return body.point(point_name)
        if body_name == GROUND:
            self.free_ground_points.setdefault(point_name, (*self._path, *path))
            return Point(GROUND, self.origin, text.strip())
        self.problem(
            Message(
                "{body_name} has no point {point_name}.{hint} Points of your own: {body_name}: {{points: "
                "{{{point_name}: {example}}}}}",
                body_name=body_name,
                point_name=point_name,
                hint=did_you_mean(point_name, body.points),
                example=self._example,
            ),
            *path,
        )
        return body.point()

    def line(self, text: Any, *path: str | int) -> Line | None:
        """`body.line`; of the ground also plain `line`."""
        if not isinstance(text, str):
            return None
        body_name, _, line_name = text.strip().partition(".")
        if not line_name:
            return self.bodies[GROUND].lines.get(body_name)
        body = self.bodies.get(body_name)
        return None if body is None else body.lines.get(line_name)

    def plane(self, text: Any, *path: str | int) -> BodyPlane | None:
        """`body.plane`; of the ground also plain `plane`."""
        if not isinstance(text, str):
            return None
        owner, _, name = text.strip().rpartition(".")
        body = self.bodies.get(owner or GROUND)
        return None if body is None else body.planes.get(name)

    def direction(self, value: Any, *path: str | int, body: str = GROUND) -> Direction:
        """right, left, up, down; an angle from the x axis; components; a line; `body.x` for a body's axis, `frame.x`
        for that of a frame."""
        if isinstance(value, (list, tuple)):
            n_before = len(self.problems)
            along = self.components(cast("list[Any]", value), DIMENSIONLESS, *path)
            if len(self.problems) > n_before:
                return self.compass["right"]
            return self.unit_direction(body, along, *path)
        if isinstance(value, str):
            text = value.strip()
            for prefix in ("against ", "opposite to ", "opposite of "):
                if text.startswith(prefix):
                    return self.direction(text.removeprefix(prefix), *path, body=body).reversed()
            for prefix in ("normal to ", "normal of ", "perpendicular to "):
                if text.startswith(prefix):
                    return self.direction(text.removeprefix(prefix), *path, body=body).normal()
            text = text.removeprefix("along ")
            if text.startswith("[") and text.endswith("]"):
                parts: list[Any] = [part.strip() for part in text[1:-1].split(",")]
                return self.direction(parts, *path, body=body)
            compass = self.compass
            if text in compass:
                if text in self.bodies[GROUND].lines:
                    told = Message(
                        "{name} is a direction and a line of the ground; call the line something else", name=text
                    )
                    self.problem(told, *path)
                return self.fixed_in(body, compass[text].components, text)
            line, plane = self.line(text), self.plane(text)
            if line is not None:
                return line.direction
            if plane is not None:
                return plane.normal
            owner, _, axis = text.partition(".")
            if axis == "axis" and self.axis_of(owner):
                return Direction(owner, self.axis_of(owner), text)
            if axis in compass and (owner in self.bodies or owner in self.frames):
                return self.fixed_in(owner, compass[axis].components, text)
            if text in self.bodies and self.axis_of(text):
                return Direction(text, self.axis_of(text), f"{text}.axis")
            if re.fullmatch(r"[A-Za-z_]+(\.[A-Za-z_]\w*)?", text) and text not in self.parameters and text != "pi":
                known = [*compass, *self.bodies[GROUND].lines, *self.bodies[GROUND].planes]
                known += [f"{b.name}.{line}" for b in self.bodies.values() for line in b.lines]
                self.problem(
                    Message(
                        "{text} is no direction.{hint} Write right, left, up, down, an angle such as 30 deg, "
                        "components [1, 2], a line, or body.x",
                        text=text,
                        hint=did_you_mean(text, known),
                    ),
                    *path,
                )
                return self.compass["right"]
        angle = self.angle(value, *path)
        shown = str(value)
        along = (Call("cos", angle), Call("sin", angle), *self.origin[2:])
        return self.fixed_in(body, along, shown)

    def fixed_in(self, owner: str, along: Components, name: str = "") -> Direction:
        """A direction by components along the axes of a body or of a frame."""
        if owner in self.frames:
            body, axes = self.frames[owner]
            return Direction(body, applied(axes, along), name)
        return Direction(owner, along, name)

    def axis_of(self, name: str) -> Components:
        """The axis of a round body in space; empty where there is none."""
        return self.bodies[name].axis if name in self.bodies else ()

    def unit_direction(self, body: str, along: Components, *path: str | int) -> Direction:
        numbers = [self.numeric(c) for c in along]
        if all(n is not None and abs(n) < LEAST for n in numbers):
            self.problem(Message("a direction must not be {x}; it needs a length", x=[0] * len(along)), *path)
            return self.compass["right"]
        square: Expr = ZERO
        for c in along:
            square = square + c * c
        if sum(c != ZERO for c in along) == 1 and None not in numbers:
            return self.fixed_in(body, tuple(number((n > 0) - (n < 0)) for n in numbers if n is not None))
        size = Call("sqrt", square)
        return self.fixed_in(body, tuple(c / size for c in along))

    def radius(self, name: str, *path: str | int) -> Expr:
        body = self.body(name, *path)
        if body.radius is None:
            self.problem(
                Message("{name} has no radius; make it a disk, ring or sphere, or give its body a radius", name=name),
                *path,
            )
            return number(1)
        return body.radius

    def length_or(self, spec: Spec, field: str, fallback: Expr | None = None) -> Expr | None:
        value = getattr(spec, field)
        return fallback if value is None else self.positive(spec, field, LENGTH)


def quantity_expression(quantity: Any) -> Expr:
    """A quantity in SI as an exact expression; degrees as fractions of pi."""
    if quantity.degrees is not None:
        return PI * Fraction(quantity.degrees, 180)
    if quantity.exact is not None:
        return number(quantity.exact)
    return number(quantity.value)


def _unit_differs(text: str, found: Dimension, wanted: Dimension) -> Message:
    kinds = {
        LENGTH: Message("a length"),
        MASS: Message("a mass"),
        TIME: Message("a time"),
        FORCE: Message("a force"),
    }
    kind = kinds.get(wanted, Message("a quantity"))
    if wanted == DIMENSIONLESS:
        return Message(
            "{text} must be a pure number or an angle, but is given in {dimension}", text=text, dimension=found
        )
    if found == DIMENSIONLESS:
        return Message("{text} must be {kind} ({unit}), but has no unit", text=text, kind=kind, unit=wanted)
    return Message(
        "{text} must be {kind} ({unit}), but is given in {dimension}",
        text=text,
        kind=kind,
        unit=wanted,
        dimension=found,
    )


def _as_number(value: Any) -> float | None:
    """A number without a unit; None for anything else."""
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return float(value)
    try:
        return float(value)
    except (TypeError, ValueError):
        return None


__all__ = ["Names", "did_you_mean", "negate", "quantity_expression"]
