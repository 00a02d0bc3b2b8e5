"""Random valid models of all connections, loads, shapes, measures and questions, in the plane and in space.

A model grows element by element: a body, a connection, a load, a measure, a question is drawn from the examples of the
kinds (`patterns`), and kept if the model with it can be read. What is drawn is small, since two bodies and two
connections meet most of what can go wrong; numbers are simple, so that coincidences happen, and now and then extreme.
"""

from __future__ import annotations

import copy
import random
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, cast

from freebody.api import System
from freebody.connections.base import Connection
from freebody.errors import FreebodyError
from freebody.language.units import (
    DIMENSIONLESS,
    FORCE,
    LENGTH,
    TORQUE,
    Dimension,
)
from freebody.loads.base import Load
from freebody.model.phrases import PHRASES
from freebody.model.shapes.base import Shape
from freebody.model.spec import Spec
from freebody.questions.forms import FORMS
from freebody.testing.patterns import PatternSlot, fields_of, filled, options_of, phrase, shape_fields

_SIZES = ("1", "2", "0.5", "0.2", "3", "0.125", "10", "1/3")
_EXTREME = ("0", "1e-12", "1e-9", "1e9", "1e12", "1e-50", "1e50", "-1")
_ANGLES = ("0", "30 deg", "45 deg", "90 deg", "-60 deg", "180 deg", "0.3", "pi/6")
_PLACES = ("0", "0", "1 m", "-1 m", "0.5 m", "2 m", "0.3 m")
_STARTS = {LENGTH: ("0", "0.5 m", "1 m", "-0.2 m"), DIMENSIONLESS: ("0", "0.3", "30 deg", "-pi/2")}
_RATES = {LENGTH: ("0", "1 m/s", "-1 m/s"), DIMENSIONLESS: ("0", "2 rad/s", "-0.5 rad/s")}
_EVENTS = (
    "MEASURE = LENGTH",
    "MEASURE = 0",
    "rate(MEASURE) = 0",
    "sliding begins",
    "rolling begins",
    "slip of CONNECTION = 0",
    "CONNECTION opens",
    "CONNECTION goes slack",
)
_TRIES = 6  # to fill one element so that it can be read


@dataclass(frozen=True)
class Taste:
    """What random models are like: chances, and the number of questions."""

    space: float = 0.25
    extreme: float = 0.04  # of a number
    symbol: float = 0.4  # of a number: it becomes a parameter
    open: float = 0.05  # of a parameter: it has no value
    n_questions: int = 2


class Maker:
    """Draws one model."""

    def __init__(self, rng: random.Random, taste: Taste) -> None:
        self.rng, self.taste = rng, taste
        self.is_space = rng.random() < taste.space
        self.is_extreme = rng.random() < 0.3  # extremes come together, most models have none
        self.data: dict[str, Any] = {"space": True} if self.is_space else {}
        self.system: System | None = None
        self.faults: list[tuple[dict[str, Any], Exception]] = []  # what could be neither read nor refused
        self._last = ""

    def model(self) -> dict[str, Any]:
        """A model that can be read: its data."""
        rng = self.rng
        for name in "ab"[: rng.choice((1, 1, 2))]:
            self._keep("ground", "points", name.upper(), self._place())
        if rng.random() < 0.6:
            section = "planes" if self.is_space else "lines"
            heading = rng.choice(("up", [1, 1, 0])) if self.is_space else rng.choice(("right", self._angle()))
            self._keep("ground", section, "floor", {"normal" if self.is_space else "along": heading})
        for name in ("p", "q", "r")[: rng.choice((1, 1, 1, 2, 2, 3))]:
            self._body(name)
        if rng.random() < 0.3:
            self._measures()
        for k, name in enumerate(self.bodies):
            if rng.random() < 0.85:
                self._element("connections", f"c{k}", name)
        if not self.data.get("measures"):
            self._measures()
        if rng.random() < 0.25:
            self._element("connections", "again", None)
        if rng.random() < 0.6:
            self._keep("loads", "weight", {"gravity": "9.81 m/s^2"})
        for k in range(rng.choice((0, 0, 1, 1, 2))):
            self._element("loads", f"f{k}", None)
        self._start()
        self._questions()
        return self.data

    # -- keeping ------------------------------------------------------------------------------
    def _keep(self, *path_and_value: Any) -> bool:
        """Puts a value at a path, if the model can be read with it (before there are bodies none can)."""
        *path, value = path_and_value
        data = copy.deepcopy(self.data)
        entry = data
        for part in path[:-1]:
            entry = entry.setdefault(part, {})
        entry[path[-1]] = value
        if "bodies" in data:
            try:
                self.system = System.from_data(data)
            except FreebodyError:
                return False
            except Exception as error:
                self.faults.append((data, error))
                return False
        self.data = data
        return True

    def _forget(self, parameters: dict[str, Any]) -> None:
        """Takes back the parameters of an element that could not be read."""
        if parameters or "parameters" in self.data:
            self.data["parameters"] = parameters

    @property
    def bodies(self) -> list[str]:
        return list(self.data.get("bodies", {}))

    # -- elements -----------------------------------------------------------------------------
    def _body(self, name: str) -> None:
        rng = self.rng
        for _ in range(_TRIES):
            parameters = dict(self.data.get("parameters", {}))
            kind = rng.choice(sorted(kind for kind, shape in Shape.kinds.items() if not shape.needs_file))
            entry: dict[str, Any] = {kind: filled(shape_fields(Shape.kinds[kind]), self._fill)}
            if rng.random() < 0.1 and "mass" in entry[kind]:
                del entry[kind]["mass"]
            place: dict[str, Any] = {}
            if rng.random() < 0.5:
                place["at"] = self._place()
            if rng.random() < 0.25:
                place["turned" if self.is_space else "angle"] = self._turned() if self.is_space else self._angle()
            entry |= place if rng.random() < 0.4 or not place else {"near": place}  # what is exact often contradicts
            if rng.random() < 0.1:
                entry["velocity"] = [rng.choice(("0", "1 m/s", "-2 m/s")) for _ in self._place()]
            if rng.random() < 0.1:
                entry["angular_velocity"] = ["0", "0", "3 rad/s"] if self.is_space else "2 rad/s"
            if rng.random() < 0.07:
                entry["fixed"] = True
            if rng.random() < 0.2:
                entry["points"] = {"tip": self._place()}
            if self._keep("bodies", name, entry):
                return
            self._forget(parameters)
        self._keep("bodies", name, {"particle": {"mass": "1 kg"}})

    def _element(self, section: str, name: str, body: str | None) -> None:
        """A connection or a load of a random kind; `body`: one that it should take hold of. Kinds that few fillings fit
        have as good a chance as the others: each is tried several times."""
        kinds: dict[str, type[Spec]] = dict(Connection.kinds) if section == "connections" else dict(Load.kinds)
        fitting = sorted(k for k, c in kinds.items() if self._fits(c))
        favourite = [body] if body else []
        for _ in range(_TRIES // 2):
            kind = kinds[self.rng.choice(fitting)]
            if self._needs_measure(fields_of(kind, section)) and not self.data.get("measures"):
                self._measures()
            for _ in range(_TRIES):
                parameters = dict(self.data.get("parameters", {}))
                fields = fields_of(kind, section)
                options = options_of(kind, fields)
                for option in options:
                    if self.rng.random() < (0.4 if self.is_space else 0.12):
                        fields[option] = options[option]
                value = filled(fields, lambda slot: self._fill(slot, favourite))
                if self._keep(section, name, {kind.kind: value}):
                    return
                self._forget(parameters)

    def _fits(self, kind: type[Spec]) -> bool:
        """Kinds whose example is spatial are for space, where those of the plane seldom fit."""
        return self.is_space == ("space: true" in getattr(kind, "example", "")) or (
            self.is_space and (issubclass(kind, Load) or self.rng.random() < 0.2)  # pyrefly: ignore[bad-argument-type]
        )

    def _needs_measure(self, slots: Any) -> bool:
        """Whether a law of measures stands among the fields."""
        if isinstance(slots, PatternSlot):
            return slots.role == "law" and bool(slots.given[1])
        if isinstance(slots, dict):
            slots = list(cast("dict[str, Any]", slots).values())
        return isinstance(slots, list) and any(map(self._needs_measure, cast("list[Any]", slots)))

    def _measures(self) -> None:
        for name in ("u", "w")[: self.rng.choice((0, 1, 1, 2))]:
            for _ in range(_TRIES):
                form = self.rng.choice(PHRASES).form
                text = phrase(form, self._word, self.rng)
                if self.rng.random() < 0.1 and self.data.get("measures"):
                    text = self.rng.choice(("2*u + 1 m", "u^2", "sin(u)", "abs(u)", "1/u", "sqrt(u)"))
                    if self._keep("measures", name, {"expression": text}):
                        break
                elif self._keep("measures", name, text):
                    break

    def _start(self) -> None:
        for name in self.data.get("measures", {}):
            dimension = self.system.measures[name].dimension if self.system is not None else DIMENSIONLESS
            if self.rng.random() < 0.3:
                self._keep("start", name, self.rng.choice(_STARTS.get(dimension, ("0",))))
            if self.rng.random() < 0.25:
                self._keep("start", f"rate({name})", self.rng.choice(_RATES.get(dimension, ("0",))))

    def _questions(self) -> None:
        asked: list[str] = []
        for _ in range(_TRIES):
            form = self.rng.choice(FORMS).form
            for _ in range(_TRIES // 2):
                if len(asked) == self.taste.n_questions:
                    return
                text = random_question(self.rng, self._word, form)
                if text not in asked and self._keep("questions", [{"find": t} for t in (*asked, text)]):
                    asked.append(text)
                    break

    # -- filling ------------------------------------------------------------------------------
    def _fill(self, slot: PatternSlot, favourite: Sequence[str] = ()) -> Any:
        rng = self.rng
        match slot.role:
            case "body" | "wheel":
                return self._another(slot, favourite)
            case "point":
                return self._point(favourite)
            case "surface":
                surfaces = self.data.get("ground", {})
                return rng.choice([*surfaces.get("lines", {}), *surfaces.get("planes", {}), *self.bodies, "ground.A"])
            case "measure" | "phrase":
                return self._word("MEASURE")
            case "direction":
                return self._word("DIRECTION")
            case "flag":
                return rng.random() < 0.5
            case "number":
                return slot.given if rng.random() < 0.6 else self._number()
            case "quantity":
                return self._quantity(slot.dimension)
            case "any quantity":
                return self._quantity(rng.choice((DIMENSIONLESS, DIMENSIONLESS, LENGTH, FORCE, TORQUE)))
            case "name":
                return rng.choice((*self.bodies, self._point(favourite), "floor", "ground"))
            case "law":
                text, names, parameters = slot.given
                self.data["parameters"] = parameters | self.data.get("parameters", {})
                named = list(self.data.get("measures", {})) or ["u"]
                return re.sub(r"[A-Za-z_]\w*", lambda w: rng.choice(named) if w[0] in names else w[0], text)
            case _:
                return slot.given

    def _another(self, slot: PatternSlot, favourite: Sequence[str]) -> str:
        """A body, seldom the last one; a round one where the example has one, ground where the example has it."""
        rng = self.rng
        able = [b for b in self.bodies if slot.role == "body" or "radius" in repr(self.data["bodies"][b])]
        able += [b for b in favourite if b in able and rng.random() < 0.8]
        if slot.given == "ground" or rng.random() < 0.15:
            able += ["ground"] * max(1, len(able)) if slot.given == "ground" else ["ground"]
        others = [b for b in able if b != self._last.partition(".")[0]]
        self._last = rng.choice((others if rng.random() < 0.9 else able) or ["ground"])
        return self._last

    def _number(self) -> Any:
        rng = self.rng
        if self.is_extreme and rng.random() < 4 * self.taste.extreme:
            return rng.choice(_EXTREME)
        return rng.choice((0, 0.5, 1, 2, 0.3))

    def _quantity(self, dimension: Dimension) -> Any:
        """A quantity of a dimension: written out, or a parameter."""
        rng = self.rng
        size = rng.choice(_SIZES)
        if self.is_extreme and rng.random() < 4 * self.taste.extreme:
            size = rng.choice(_EXTREME)
        unit = "" if dimension == DIMENSIONLESS else str(dimension)
        if "/" in size:
            return size if not unit else f"{size}*{self._parameter('1 ' + unit)}"
        text = f"{size} {unit}".strip()
        return self._parameter(text) if rng.random() < self.taste.symbol else text

    def _parameter(self, text: str) -> str:
        """The name of a new parameter, or of an old one with the same value."""
        parameters = self.data.setdefault("parameters", {})
        for name, value in parameters.items():
            if value == text and self.rng.random() < 0.5:
                return name
        name = f"k{len(parameters) + 1}"
        _size, _, unit = text.partition(" ")
        parameters[name] = (unit or text) if unit and self.rng.random() < self.taste.open else text
        if text.startswith(("0", "-")) and not text.startswith("0."):
            parameters[name] = {"value": text, "sign": "any"}
        return name

    def _angle(self) -> str:
        return self.rng.choice(_ANGLES)

    def _turned(self) -> list[str]:
        axis = self.rng.choice("xyz")
        return self.rng.choice(
            ([f"30 deg about {axis}"], [f"90 deg about {axis}"], [f"psi_{len(self.bodies)} about {axis}"])
        )

    def _place(self) -> list[str]:
        place = [self.rng.choice(_PLACES) for _ in range(3 if self.is_space else 2)]
        if self.is_extreme and self.rng.random() < 4 * self.taste.extreme:
            place[0] = f"{self.rng.choice(_EXTREME)} m"
        return place

    def _point(self, favourite: Sequence[str] = ()) -> str:
        """A point, seldom of the owner of the last one."""
        rng = self.rng
        points = [f"ground.{p}" for p in self.data.get("ground", {}).get("points", {})]
        for body in self.system.moving if self.system is not None else ():
            if not favourite or body.name in favourite or rng.random() < 0.3:
                points += [body.name] * 3 + [f"{body.name}.{p}" for p in body.points]
        owner = self._last.partition(".")[0]
        others = [p for p in points if p.partition(".")[0] != owner]
        self._last = rng.choice(others if others and rng.random() < 0.9 else points)
        return self._last

    def _word(self, place: str) -> str:
        """A text for a place of a phrase or question."""
        rng, data = self.rng, self.data
        named = {
            "BODY": self.bodies,
            "CONNECTION": list(data.get("connections", {})),
            "LOAD": [*data.get("loads", {}), *data.get("connections", {})],
            "SPRING": list(data.get("loads", {})),
            "MEASURE": [m for m in data.get("measures", {}) for _ in range(3)],
            "COORDINATE": list(data.get("measures", {})),
            "PARAMETER": list(data.get("parameters", {})),
            "BASIS": [*self.bodies, "ground"],
            "PLACE": self.bodies,
            "LENGTH": ["0", "1 m", "0.5 m", "30 deg"],
            "ANGLE": list(data.get("measures", {})),
            "DIRECTION": ["right", "up", "left", "down", "30 deg", "floor", *(f"{b}.x" for b in self.bodies)],
        }
        if place == "POINT":
            return self._point()
        if place == "EVENT":
            return phrase(rng.choice(_EVENTS), self._word, rng)
        if place == "QUANTITY":
            return random_quantity(rng, self._word)
        if place == "MEASURE" and (not named["MEASURE"] or rng.random() < 0.3):
            return phrase(rng.choice(PHRASES).form, self._word, rng)
        return rng.choice(named.get(place) or ["p"])


def random_quantity(rng: random.Random, word: Any) -> str:
    """A quantity that may be asked for."""
    return phrase(rng.choice(FORMS).form, word, rng)


def random_question(rng: random.Random, word: Any, form: str) -> str:
    """A question of a form: a quantity, now and then at the start or at an event."""
    text = phrase(form, word, rng)
    chance = rng.random()
    if chance < 0.15:
        return f"{text} at start"
    if chance < 0.3:
        event = phrase(rng.choice(_EVENTS), word, rng)
        return f"{rng.choice(('time', text))} when {event}"
    return text


def is_assembled(system: System, seconds: float = 1.0) -> bool:
    """Whether the start of a model can be put together, found with little work. What cannot be ends in the same refusal
    in every study, after a long search, and few such models are enough."""
    from freebody.numeric.reference import Reference
    from freebody.testing.outcomes import OutOfWork, limited

    if not system.has_values:
        return True
    try:
        with limited(seconds):
            Reference(system).assemble()
    except (Exception, OutOfWork):
        return False
    return True


def maker(seed: int | str, taste: Taste | None = None) -> Maker:
    """What draws the model of a seed; `faults` are the elements on which reading itself failed."""
    return Maker(random.Random(f"freebody {seed}"), taste or Taste())


def random_model(seed: int | str, taste: Taste | None = None) -> System:
    """A random valid model; the same seed gives the same model."""
    return System.from_data(maker(seed, taste).model())
