"""The generators of a symbolic model: parameters, given functions of time, and the unknowns of its pose.

Unknowns are the absolute coordinates of the bodies, the lengths and angles of the tangents in the held measures, and
the named measures; each has a generator of its own for its rate, the speed. Which of them are generalized coordinates
is chosen later, in the order of their ranks.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from freebody.language.expression import Call, Expr, Symbol, differentiate
from freebody.measures.base import Measure
from freebody.model.states import shown_rate
from freebody.symbolic.elimination import TangentPair, Unknown
from freebody.symbolic.field import Field, Generator
from freebody.symbolic.ratio import Ratio
from freebody.system.system import System

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


class ModelUnknowns:
    """What the field of a model is made of."""

    def __init__(self, field: Field, system: System) -> None:
        self.field = field
        self.functions: dict[int, Expr] = {}  # given functions of time and their rates: what they are in numbers
        self.parameters = self._parameters(system)
        self.constants: dict[str, Ratio] = {}  # hidden start values of incremental rows and loads, by name
        self.given_constants: dict[int, Ratio] = {}  # of these: what they are in the parameters
        self.found: dict[int, Unknown] = {}
        self.speeds: dict[int, int] = {}  # of the unknowns
        self.names: dict[int, str] = {}
        self.angles: set[int] = set()
        self.measures: dict[int, Measure] = {}  # that unknowns are
        self.defined: dict[int, Ratio] = {}  # named measures as coordinates: what they are
        self.lines: list[TangentPair] = []
        self.roots: dict[int, Ratio] = {}  # lengths in space: what their square is

    def new(
        self,
        name: str,
        rank: tuple[int, int],
        *,
        compute: Callable[[Mapping[int, Any], Any], Any] | None = None,
        is_angle: bool = False,
    ) -> Ratio:
        """One more unknown and its speed."""
        shown = Symbol(name)
        g = self.field.generator(Generator(shown, "coordinate", compute=compute))
        speed = self.field.generator(Generator(shown_rate(name), "speed"))
        self.field.set_rate(g, speed)
        index = self.field.index(g)
        self.found[index] = Unknown(index, rank, name)
        self.speeds[index] = self.field.index(speed)
        self.names[index] = name
        if is_angle:
            self.angles.add(index)
        else:
            self.field.no_angles.add(index)
        return g

    def join(self, x: Ratio, y: Ratio) -> None:
        """Notes that two unknowns are x and y of one body, which two equations may give away together."""
        ix = self.field.index(x)
        old = self.found[ix]
        self.found[ix] = Unknown(ix, old.rank, old.name, partner=self.field.index(y))

    def defined_as(self, name: str) -> Ratio | None:
        """The generator made for a named measure before, when the elimination is run again."""
        for index, known in self.names.items():
            if known == name and index in self.defined:
                return self.field.variable(index)
        return None

    def coordinate(self, u: Unknown) -> Coordinate:
        return Coordinate(u.name, u.index, self.speeds[u.index], u.index in self.angles)

    def inside(self, x: Ratio) -> frozenset[int] | set[int]:
        """The unknowns that an element contains."""
        return self.field.ingredients(x) & self.found.keys()

    @property
    def changing(self) -> set[int]:
        """What may change with time: coordinates, time itself and given functions of it."""
        return {*self.found, *self.functions, self.field.index(self.field.time)}

    # -- parameters and given functions of time -----------------------------------------------
    def _parameters(self, system: System) -> dict[str, Ratio]:
        names: dict[str, Ratio] = {}
        for p in system.parameters.values():
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
            self.functions[self.field.index(chain[-1])] = form
            shown, form = Call("rate", shown), differentiate(form, "t")
        for function, rate in pairwise(chain):
            self.field.set_rate(function, rate)
        return chain[0]
