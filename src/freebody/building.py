"""Models written in Python, with names instead of texts.

    import freebody as fb

    model = fb.Model("Ball on an incline")
    m, R, alpha, g = model.parameters(m="2 kg", R="0.1 m", alpha="30 deg", g="9.81 m/s^2")
    incline = model.line("incline", along=-alpha)
    ball = model.body("ball", fb.Sphere(m, R))
    model.connect("contact", fb.Rolling(ball, incline))
    model.load("weight", fb.Gravity(g))
    s = model.measure("s", ball.travel(along=incline))
    model.ask(s.acceleration)
    model.system().solve()

Parameters and measures are formulas: `-alpha`, `m*g/2`, `F*cos(Omega*model.time)`. Bodies have their points as
attributes: `rod.end`. A model is put together in the order of the lines; `system` reads it and tells all mistakes at
once.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, cast

from freebody.api import System
from freebody.connections.base import Connection
from freebody.language.expression import Call, Expr, Symbol, symbol
from freebody.language.written import Written, as_text
from freebody.loads.base import Load
from freebody.model.shapes.base import Shape
from freebody.model.spec import Formula

Given = Formula | Expr  # a formula, a quantity with its unit, or an SI number
Along = Given | Written | Sequence[Given]  # a direction


class Place(Written):
    """A point, from which measures are made."""

    def __call__(self, *_given: object, **_named: object) -> Any:
        raise TypeError(
            f"{self.text} is a point. What the ground has is declared by model.point(name, x, y) and model.line(name, "
            "along=...), what a body has where that is made: model.body(name, shape, points={...})"
        )

    def travel(self, along: Along, start: Place | str | None = None) -> Written:
        """How far it is along a direction, from a point, else from the origin of the ground."""
        return _phrase(f"travel of {self} along {_direction(along)}", start, "from")

    def height(self, above: Place | str | None = None) -> Written:
        """How far it is above a point, else above the origin of the ground."""
        return _phrase(f"height of {self}", above, "above")

    def drop(self, below: Place | str | None = None) -> Written:
        """How far it is below a point, else below the origin of the ground."""
        return _phrase(f"drop of {self}", below, "below")

    def coordinate(self, axis: str, start: Place | str | None = None) -> Written:
        """Its coordinate along x, y or z of the ground."""
        return _phrase(f"{axis} of {self}", start, "from")

    def distance(self, to: Place | str) -> Written:
        """Its distance from another point."""
        return Written(f"distance from {self} to {to}")

    def bearing(self, to: Place | str, counted_from: Along = "right", *, clockwise: bool = False) -> Written:
        """The angle of the line from here to another point, from a direction."""
        sense = " clockwise" if clockwise else ""
        return Written(f"angle of line from {self} to {to} from {_direction(counted_from)}{sense}")

    @property
    def velocity(self) -> Written:
        """A question."""
        return Written(f"velocity of {self}")

    @property
    def acceleration(self) -> Written:
        """A question."""
        return Written(f"acceleration of {self}")


class Body(Place):
    """A body; its points, axes and lines are its attributes: `rod.end`, `rod.x`."""

    def __getattr__(self, name: str) -> Place:
        if name.startswith("_"):
            raise AttributeError(name)
        return self.point(name)

    def point(self, name: str, *place: object) -> Place:
        """One of its points by name: for names that are those of a method. Raises TypeError for a place: the points of
        a body are declared with it."""
        if place:
            raise TypeError(
                f"a point is declared with its body: model.body({self.text!r}, ..., points={{{name!r}: ...}})"
            )
        return Place(f"{self.text}.{name}")

    def angle(
        self, counted_from: Along | None = None, *, relative_to: Body | None = None, clockwise: bool = False
    ) -> Written:
        """The angle of its x axis, from a direction (else from `right`), or from the x axis of another body."""
        reference = f" relative to {relative_to}" if relative_to is not None else ""
        if counted_from is not None:
            reference = f" from {_direction(counted_from)}"
        return Written(f"angle of {self}{reference}{' clockwise' if clockwise else ''}")

    @property
    def angular_velocity(self) -> Written:
        """A question."""
        return Written(f"angular velocity of {self}")

    @property
    def angular_acceleration(self) -> Written:
        """A question."""
        return Written(f"angular acceleration of {self}")


class Measure(Symbol):  # pyrefly: ignore[bad-class-definition]
    """A named measure: a formula, and what can be asked of it."""

    __slots__ = ()

    def __str__(self) -> str:
        return self.name

    @property
    def rate(self) -> Expr:
        """Its time derivative, in formulas and in `start`."""
        return Call("rate", Symbol(self.name))

    @property
    def velocity(self) -> Written:
        """A question."""
        return Written(f"velocity of {self.name}")

    @property
    def acceleration(self) -> Written:
        """A question."""
        return Written(f"acceleration of {self.name}")


@dataclass(frozen=True)
class Joined(Written):
    """A connection or a load by its name, and what can be asked of it."""

    def force(self, what: str, at: Body | str | None = None) -> Written:
        """What it transmits, by its name: `rope.force("tension", at=left)`."""
        return _phrase(f"{what} of {self}", at, "at")

    def reaction(self, on: Body | str | None = None, along: Along | None = None) -> Written:
        """Its force on a body, a vector or its component along a direction."""
        component = f" along {_direction(along)}" if along is not None else ""
        return Written(f"{_phrase(f'reaction of {self}', on, 'on')}{component}")


# What one tries first to add something to a model.
_ADDED = {
    **dict.fromkeys(("add_joint", "add_connection", "add_constraint", "joint", "connection"), "connect"),
    **dict.fromkeys(("add_force", "add_torque", "add_gravity"), "load"),
    **dict.fromkeys(("add_question", "question", "find"), "ask"),
}


class Model:
    """A model that is being written. title, about: what it shows; space: three dimensions."""

    def __init__(self, title: str = "", about: str = "", *, space: bool = False, **other: Any) -> None:
        if other:
            given = ", ".join(f"{name}={value!r}" for name, value in other.items())
            raise TypeError(f"Model takes title, about and space; parameters are given by model.parameters({given})")
        head = {"title": title, "about": about, "space": space}
        self._data: dict[str, Any] = {name: value for name, value in head.items() if value}
        self._questions: list[dict[str, Any]] = []

    time: Symbol = Symbol("t")
    ground = Body("ground")

    def __getattr__(self, name: str) -> Any:
        """Who asks a model asks the system that it describes; what a model has is told by its kind."""
        meant = f": write model.system().{name}" if not name.startswith("_") and hasattr(System, name) else ""
        if hasattr(type(self), own := _ADDED.get(name, name.removeprefix("add_"))) and own != name:
            meant = f": write model.{own}(...)"
        for kinds, example in (
            (Shape.kinds, "model.body(name, fb.{kind}({fields}))"),
            (Connection.kinds, "model.connect(name, fb.{kind}({fields}))"),
            (Load.kinds, "model.load(name, fb.{kind}({fields}))"),
        ):
            kind = next((spec for word, spec in kinds.items() if name in (word, *spec.also)), None)
            if kind is not None and not meant:
                needed = [f.alias or key for key, f in kind.model_fields.items() if f.is_required()]
                fields = ", ".join(needed or [*kind.model_fields][:2])
                meant = f": write {example.format(kind=_class_name(kind), fields=fields)}"
        raise AttributeError(f"a Model has no {name}{meant}")

    def parameters(self, *names: str, **values: Formula) -> tuple[Symbol, ...]:
        """Parameters with their values, as quantities with units: m="2 kg"; names alone, "M m L", are symbols without
        values, in the units in which they are used. Returns a symbol for each, in order."""
        bare = [name for text in names for name in text.replace(",", " ").split()]
        return tuple(self.parameter(name, value) for name, value in (dict.fromkeys(bare) | values).items())

    def parameter(self, name: str, value: Formula | None = None, **more: str) -> Symbol:
        """One parameter. more: `sign="any"`, `unit="m"` for one without a value. Raises ExpressionError for a name that
        no formula can have."""
        made = symbol(name)
        entry = {key: text for key, text in (("value", value), *more.items()) if text is not None}
        self._section("parameters")[name] = entry if more else value
        return made

    def point(self, name: str, *at: Given | Sequence[Given]) -> Place:
        """A point of the ground at x, y, in space z, or at a list of these; without a place its position is open."""
        if len(at) == 1 and isinstance(at[0], list | tuple):
            at = tuple(at[0])
        self._section("ground").setdefault("points", {})[name] = as_text(at) if at else [None, None]
        return Place(f"ground.{name}")

    def line(
        self,
        name: str,
        along: Along | None = None,
        through: Sequence[Given] | None = None,
        *,
        angle: Along | None = None,
    ) -> Written:
        """A line of the ground along a direction or at an angle, through a point, else through the origin. Raises
        TypeError where neither or both are given."""
        if (along is None) == (angle is None):
            raise TypeError(f"a line has a direction: model.line({name!r}, along='right'), or an angle")
        along = angle if along is None else along
        given = {"along": as_text(along)} | ({} if through is None else {"through": as_text(through)})
        self._section("ground").setdefault("lines", {})[name] = given
        return Written(f"ground.{name}")

    def body(self, name: str, shape: Shape | None = None, **more: Any) -> Body:
        """A body with its shape. more: what else stands there in a file, such as `at`, `angle`, `points`, `fixed`.
        Raises TypeError without a shape."""
        if shape is None:
            given = ", ".join(f"{key}={value!r}" for key, value in more.items())
            able = [
                _class_name(spec)
                for spec in Shape.kinds.values()
                if not spec.space_only and {*more} <= {*spec.model_fields}
            ]
            others = f" (or {', '.join(able[1:4])})" if len(able) > 1 else ""
            raise TypeError(
                f"a body needs its shape: model.body({name!r}, fb.{(able or ['Disk'])[0]}({given})){others}"
            )
        self._section("bodies")[name] = {shape.kind: shape.model_dump(exclude_defaults=True, by_alias=True)} | as_text(
            more
        )
        return Body(name)

    def connect(self, name: str, connection: Connection | None = None, closes: str | None = None) -> Joined:
        """A connection. closes: `at start`, or `when EVENT`. Raises TypeError without a name."""
        if connection is None:
            raise TypeError("a connection needs a name, by which questions know it: model.connect(name, fb.Pin(...))")
        entry = {connection.kind: connection.model_dump(exclude_defaults=True, by_alias=True)}
        self._section("connections")[name] = entry | ({} if closes is None else {"closes": closes})
        return Joined(name)

    def load(self, name: str, load: Load | None = None) -> Joined:
        """A load. Raises TypeError without a name."""
        if load is None:
            raise TypeError("a load needs a name, by which questions know it: model.load(name, fb.Gravity(...))")
        self._section("loads")[name] = {load.kind: load.model_dump(exclude_defaults=True, by_alias=True)}
        return Joined(name)

    def measure(self, name: str, of: Written | Expr | str) -> Measure:
        """A measure with a name: a phrase, as bodies and points make it, or a formula in other measures."""
        text = as_text(of)
        self._section("measures")[name] = text if isinstance(of, (Written, str)) else {"expression": text}
        return Measure(name)

    def state(self, name: str, rate: Written | Expr | str) -> Expr:
        """A state of a controller, by its rate: a formula in measures, their rates, states and the time."""
        self._section("states")[name] = as_text(rate)
        return Symbol(name)

    def start(self, values: Mapping[Measure | Expr | str, Given] | None = None, **named: Given) -> None:
        """Values of measures and their rates at the start: `{s: 0, s.rate: v0}`; of measures by their names as well,
        `start(s=0)`."""
        self._section("start").update(as_text(dict(values or {}) | named))

    def ask(
        self,
        find: Written | str,
        *,
        id: str | None = None,
        when: str | None = None,
        options: Mapping[str, Given] | None = None,
        key: str | None = None,
    ) -> None:
        """A question, with options to choose from and the letter of the right one. Raises TypeError for a condition
        that is no text."""
        if isinstance(when, bool):
            raise TypeError("when is a text, not a comparison: model.ask(x, when='y = 0')")
        given = {"find": str(find), "id": id, "when": when, "options": as_text(options), "key": key}
        self._questions.append({name: value for name, value in given.items() if value is not None})

    def system(self) -> System:
        """What is written so far, read. Raises ModelError with all its mistakes."""
        return System.from_data(self._data | ({"questions": self._questions} if self._questions else {}))

    def __repr__(self) -> str:
        parts = ((name, cast("dict[str, Any]", x)) for name, x in self._data.items() if isinstance(x, dict))
        sizes = ", ".join(f"{len(part)} {name}" for name, part in parts)
        return f"<Model {self._data.get('title', '')!r}: {sizes or 'empty'}>"

    def _repr_html_(self) -> str:
        """For notebooks: as the system shows itself."""
        shown: Any = self.system()
        return shown._repr_html_()

    def _section(self, name: str) -> dict[str, Any]:
        return self._data.setdefault(name, {})


def _phrase(text: str, other: Written | str | None, word: str) -> Written:
    return Written(text if other is None else f"{text} {word} {other}")


def _direction(along: Along) -> str:
    text = as_text(along)
    return f"[{', '.join(map(str, cast('list[Any]', text)))}]" if isinstance(text, list) else str(text)


def _class_name(kind: type) -> str:
    return kind.__name__
