"""Questions about equilibrium and small free oscillations about it.

natural frequencies      period of small oscillations [of MEASURE]      mode shapes      mode 2
equilibrium of MEASURE      stability of equilibrium      damping ratio      damped frequency      logarithmic decrement
critical damping of PARAMETER      QUANTITY in equilibrium
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, Literal

from freebody.language.expression import Symbol, free_symbols, number
from freebody.language.sentences import Message, Sentence
from freebody.language.units import ANGULAR_VELOCITY, DIMENSIONLESS, TIME, Dimension
from freebody.measures.base import Measure
from freebody.model.elements import RATE
from freebody.model.phrases import measure_of
from freebody.questions.base import Described, Path, Quantity, angular_unit
from freebody.questions.forms import NAME, Found, asked
from freebody.questions.grammar import read_quantity
from freebody.questions.turned_round import ValueFor

if TYPE_CHECKING:
    from freebody.model.names import Names

RANK_AT_REST = 92  # above that of a force at a body, or of a vector in a basis


@dataclass(frozen=True)
class SmallOscillations(Quantity, kind="small oscillations"):
    """Natural frequencies or period of small oscillations about the equilibrium.

    measure: whose oscillations are meant; None: those of the whole system. number: of which mode, counted from the
    slowest, or with -1 the fastest; None: of all that oscillate."""

    is_told_by_principles = True
    is_frequency = True

    what: Literal["frequencies", "frequency", "period"]
    measure: Measure | None = None
    name: str = ""
    number: int | None = None

    example = """
bodies: {bob: {particle: {mass: 1 kg}}}
connections: {rod: {link: [ground.O, bob, 1 m]}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {theta: {angle of line from ground.O to bob from down}}
start: {theta: 60 deg}
questions: {it: period of small oscillations}
"""
    scope = "small motion"
    is_about_stable = True

    @property
    def dimension(self) -> Dimension:
        return TIME if self.what == "period" else ANGULAR_VELOCITY

    @property
    def unit(self) -> str:
        return angular_unit(self.dimension)

    @property
    def is_of_whole(self) -> bool:
        return True

    def sentence(self, system: Described) -> Sentence:
        if self.number is not None:
            return Sentence(f"what.{self.what}_of_mode", {"k": self.number})
        if self.measure is None:
            return Sentence(f"what.{self.what}")
        of = Symbol(self.name) if self.name in system.measures else self.name
        return Sentence("what.small_period_of" if self.what == "period" else "what.small_frequency_of", {"of": of})


@dataclass(frozen=True)
class Equilibrium(Quantity, kind="equilibrium"):
    """The value of a measure at rest."""

    is_place_of_rest = True

    measure: Measure
    name: str

    example = """
bodies: {bob: {particle: {mass: 1 kg}}}
connections: {rod: {link: [ground.O, bob, 1 m]}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {theta: {angle of line from ground.O to bob from down}}
start: {theta: 60 deg}
questions: {it: equilibrium of theta}
"""
    scope = "small motion"

    @property
    def dimension(self) -> Dimension:
        return self.measure.dimension

    @property
    def unit(self) -> str:
        is_angle = self.dimension == DIMENSIONLESS
        return angular_unit(self.dimension) if is_angle else str(self.dimension)

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.equilibrium", {"of": Symbol(self.name) if self.name in system.measures else self.name})


@dataclass(frozen=True)
class RestValue(Quantity, kind="value at rest"):
    """A quantity while the system rests in the equilibrium that is meant."""

    of: Quantity

    example = """
bodies: {bob: {particle: {mass: 1 kg}}}
connections: {rod: {link: [ground.O, bob, 1 m]}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {theta: {angle of line from ground.O to bob from down}}
start: {theta: 60 deg}
questions: {it: tension of rod in equilibrium}
"""
    scope = "small motion"

    @property
    def dimension(self) -> Dimension:
        return self.of.dimension

    @property
    def unit(self) -> str:
        return self.of.unit

    @property
    def at_rest(self) -> Quantity:
        return self.of

    @property
    def inner(self) -> tuple[Quantity, ...]:
        return (self.of,)

    def sentence(self, system: Described) -> Sentence | None:
        of = self.of.sentence(system)
        return None if of is None else Sentence("what.in_equilibrium", {"of": of})


class OfSmallMotion(Quantity):
    """What is asked of small motions of the whole system about its equilibrium."""

    scope = "small motion"
    is_about_stable = True

    @property
    def is_of_whole(self) -> bool:
        return True


@dataclass(frozen=True)
class ModeShapes(OfSmallMotion, kind="mode shapes"):
    """The components of a natural mode along the coordinates, the first that moves being 1; of all modes one after the
    other, the slowest first."""

    is_ratio: ClassVar[bool] = False  # of two amplitudes

    number: int | None = None

    example = """
parameters: {m: 1 kg, k: 100 N/m}
bodies: {A: {particle: {mass: m}}, B: {particle: {mass: m}}}
connections: {a: {slider: {body: A, along: right}}, b: {slider: {body: B, along: right}}}
measures: {x1: x of A, x2: x of B}
loads: {l: {law: {measure: x1, force: -k*x1}}, m: {law: {measure: {expression: x2 - x1}, force: -k*(x2 - x1)}}}
start: {x1: 0, x2: 0}
questions: {it: mode shapes}
"""

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.modes") if self.number is None else Sentence("what.mode", {"k": self.number})


@dataclass(frozen=True)
class EquilibriumStability(OfSmallMotion, kind="stability of equilibrium"):
    """Whether the system stays near its equilibrium: the squares of the exponents of small disturbances."""

    example = """
parameters: {m: 2 kg, L: 1 m, k: 30 N m, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}, angle: 90 deg}}
connections: {hinge: {pin: [ground.O, rod.start]}}
loads: {weight: {gravity: g}, spring: {torsional_spring: {body: rod, stiffness: k, angle: 90 deg}}}
measures: {theta: angle of rod from up}
start: {theta: 0}
questions: {it: stability of equilibrium}
"""
    measured_in = DIMENSIONLESS / TIME**2
    is_verdict = True
    is_about_stable = False

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.stability")


Damped = Literal["ratio", "ratios", "frequency", "frequencies", "period", "decrement", "decrements", "quality"]


@dataclass(frozen=True)
class Damping(OfSmallMotion, kind="damping"):
    """How small oscillations die away: damping ratio, damped frequency or period, logarithmic decrement, quality
    factor 1/(2 zeta)."""

    what: Damped

    is_told_by_principles_of_one = True
    example = """
parameters: {m: 2 kg, k: 200 N/m, c: 4 N s/m}
bodies: {block: {particle: {mass: m}}}
connections: {guide: {slider: {body: block, along: right}}}
measures: {x: x of block}
loads: {spring: {law: {measure: x, force: -k*x}}, damper: {law: {measure: x, force: -c*rate(x)}}}
start: {x: 0.1 m}
questions: {it: damping ratio}
"""

    @property
    def dimension(self) -> Dimension:
        return {"period": TIME}.get(self.what, ANGULAR_VELOCITY if self.what.startswith("freq") else DIMENSIONLESS)

    @property
    def unit(self) -> str:
        return "1" if self.dimension == DIMENSIONLESS else angular_unit(self.dimension)

    @property
    def letter(self) -> str:
        letters = {"ratio": "zeta", "decrement": "delta"}
        return letters.get(self.what.removesuffix("s"), super().letter)

    @property
    def is_of_all(self) -> bool:
        """Whether it is asked of every mode."""
        return self.what in ("ratios", "frequencies", "decrements")

    def sentence(self, system: Described) -> Sentence:
        return Sentence(f"what.damping_{self.what}")


ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth")


# -- words ------------------------------------------------------------------------------------
@asked(
    "natural frequencies | natural frequency [of MEASURE] | period of small oscillations",
    r"natural (?P<f>frequency|frequencies)|natural frequency of (?P<of>(?!mode \d|.* about ).+)",
    rank=70,
    example="""
bodies: {bob: {particle: {mass: 1 kg}}}
connections: {rod: {link: [ground.O, bob, 1 m]}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: {it: natural frequency}
""",
)
def _frequencies(names: Names, found: Found, path: Path) -> Quantity | None:
    if found["of"] is None:
        return SmallOscillations("frequency" if found["f"] == "frequency" else "frequencies")
    measure = measure_of(names, found["of"], *path)
    return None if measure is None else SmallOscillations("frequency", measure, str(found["of"]))


@asked(
    "period of small oscillations [of MEASURE]",
    r"period(?: of(?: small)? oscillations?)?|period of small oscillations of (?P<of>(?!.* about ).+)",
    rank=70,
)
def _period(names: Names, found: Found, path: Path) -> Quantity | None:
    if found["of"] is None:
        return SmallOscillations("period")
    measure = measure_of(names, found["of"], *path)
    return None if measure is None else SmallOscillations("period", measure, str(found["of"]))


@asked(
    "natural frequency of mode K | period of mode K",
    r"(?P<what>(?:natural )?frequency|period) of mode (?P<k>[1-9]\d?)"
    rf"|(?P<th>{'|'.join(ORDINALS)}|lowest|highest) (?P<of>natural frequency)",
    rank=75,
    example="""
parameters: {m: 1 kg, k: 100 N/m}
bodies: {A: {particle: {mass: m}}, B: {particle: {mass: m}}}
connections: {a: {slider: {body: A, along: right}}, b: {slider: {body: B, along: right}}}
measures: {x1: x of A, x2: x of B}
loads: {l: {law: {measure: x1, force: -k*x1}}, m: {law: {measure: {expression: x2 - x1}, force: -k*(x2 - x1)}}}
start: {x1: 0, x2: 0}
questions: {it: natural frequency of mode 2}
""",
)
def _of_mode(names: Names, found: Found, path: Path) -> Quantity | None:
    if found["k"]:
        return SmallOscillations("period" if found["what"] == "period" else "frequency", number=int(found["k"]))
    ends = {"lowest": 1, "highest": -1}
    return SmallOscillations("frequency", number=ends.get(found["th"]) or ORDINALS.index(found["th"]) + 1)


@asked("equilibrium of MEASURE", r"equilibrium(?: value)? of (?P<of>.+)", rank=25)
def _equilibrium(names: Names, found: Found, path: Path) -> Quantity | None:
    measure = measure_of(names, found["of"], *path)
    return None if measure is None else Equilibrium(measure, str(found["of"]))


@asked(
    "QUANTITY in equilibrium | at rest",
    r"(?!.*\b(?:that|which|whether|does|is|stays?|stay|keeps?|holds?|with|until|when|stability|range|least|largest)\b)"
    r"(?P<of>.+?) (?:(?:in|at) (?:the |its )?equilibrium(?: position)?|at rest|in (?:the |its )?rest position)",
    rank=RANK_AT_REST,
)
def _in_equilibrium(names: Names, found: Found, path: Path) -> Quantity | None:
    text = str(found["of"])
    if text in names.measures:
        return Equilibrium(names.measures[text], text)
    of = read_quantity(names, text, path)
    if of is None or (of.is_of_state and of.scope == "instant"):
        return of and RestValue(of)
    names.problem(Message("'{text}' is no property of one instant", text=text), *path)
    return None


@asked(
    "mode shapes | mode K | mode shape K",
    rf"(?P<all>(?:natural |normal )?modes|(?:natural |normal )?mode shapes?)"
    rf"|mode (?:shape )?(?P<k>[1-9]\d?)|(?P<th>{'|'.join(ORDINALS)}) (?:natural |normal )?mode(?: shape)?",
    rank=70,
)
def _shapes(names: Names, found: Found, path: Path) -> Quantity | None:
    if found["all"]:
        return ModeShapes()
    return ModeShapes(int(found["k"]) if found["k"] else ORDINALS.index(found["th"]) + 1)


@asked("stability of equilibrium", r"stability of (?:the )?equilibrium|is (?:the )?equilibrium stable\??", rank=85)
def _is_stable(names: Names, found: Found, path: Path) -> Quantity | None:
    return EquilibriumStability()


_DAMPED: dict[str, tuple[Damped, Damped]] = {
    "damping ratio": ("ratio", "ratios"),
    "degree of damping": ("ratio", "ratios"),
    "damped frequency": ("frequency", "frequencies"),
    "damped period": ("period", "period"),
    "logarithmic decrement": ("decrement", "decrements"),
    "quality factor": ("quality", "quality"),
}


@asked(
    "damping ratio | damped frequency | damped period | logarithmic decrement | quality factor",
    r"(?P<what>damping ratio|degree of damping|damped (?:natural |angular )?frequency|damped period"
    r"|logarithmic decrement|quality factor)"
    r"|(?P<all>damping ratio|damped (?:natural |angular )?frequencie|logarithmic decrement)s",
    rank=75,
)
def _damping(names: Names, found: Found, path: Path) -> Quantity | None:
    words = re.sub("natural |angular ", "", str(found["what"] or found["all"].replace("cie", "cy")))
    return Damping(_DAMPED[words][0 if found["what"] else 1])


@asked(
    "critical damping of PARAMETER",
    rf"critical (?P<what>damping|value) of (?P<of>{NAME})",
    rank=75,
    example="""
parameters: {m: 2 kg, k: 200 N/m, c: 4 N s/m}
bodies: {block: {particle: {mass: m}}}
connections: {guide: {slider: {body: block, along: right}}}
measures: {x: x of block}
loads: {spring: {law: {measure: x, force: -k*x}}, damper: {law: {measure: x, force: -c*rate(x)}}}
start: {x: 0.1 m}
questions: {it: critical damping of c}
""",
)
def _critical(names: Names, found: Found, path: Path) -> Quantity | None:
    """The value of a damper's parameter for which the damping ratio is one."""
    parameter = names.parameters.get(found["of"])
    if parameter is None or parameter.form is not None:
        names.unknown(found["of"], names.no_parameter(found["of"]), *path)
        return None
    if found["what"] == "value" and not any(
        {parameter.name, RATE.name} <= free_symbols(p.law) for p in names.applied_loads
    ):
        told = Message(
            "{name} damps nothing, so say for what its value is critical, e.g. range of {name} for which the "
            "equilibrium is stable",
            name=parameter.name,
        )
        names.problem(told, *path)
        return None
    unit = str(parameter.dimension)
    return ValueFor(parameter.name, Damping("ratio"), number(1), parameter.dimension, unit, "damping ratio")
