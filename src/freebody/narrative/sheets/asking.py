"""A question of a model as a sentence of an exercise."""

from __future__ import annotations

from functools import singledispatch

from freebody.errors import ExpressionError
from freebody.language.expression import Expr, Symbol
from freebody.language.parser import parse
from freebody.language.units import DIMENSIONLESS
from freebody.measures.angle import Angle
from freebody.measures.geometry import GROUND, Direction
from freebody.narrative.lines.script import Argument, Sentence
from freebody.narrative.principles.kinematics import rates_of
from freebody.questions.base import Quantity
from freebody.questions.centres import InstantCentre
from freebody.questions.conservation import Conserved, GeneralizedMomentum, JacobiIntegral
from freebody.questions.course import Change, EnergyLost, Turns, When
from freebody.questions.energy import Energy
from freebody.questions.freedom import Freedom
from freebody.questions.loads import LoadForce, Power, Work
from freebody.questions.momentum import Group, Momentum, Spin
from freebody.questions.motion import OfMeasure, OfPoint, Turning
from freebody.questions.ratio import RatioOf
from freebody.questions.reactions import Multiplier, Wrench
from freebody.questions.reading import Question
from freebody.questions.small_motion import Equilibrium, Small
from freebody.system.system import System

NOTHING: Argument = ""


def asking(system: System, question: Question) -> Sentence:
    """What is to be found, in a sentence. What has no words of its own is quoted from the model."""
    return _asking(question.quantity, system, question)


@singledispatch
def _asking(q: Quantity, system: System, question: Question) -> Sentence:
    of = what(q, system)
    if of is None:
        return Sentence("ask.any", {"text": question.text})
    return Sentence("ask.find", {"what": of, "when": _when(question)})


@_asking.register(Conserved)
def _asking_conserved(q: Conserved, system: System, question: Question) -> Sentence:
    return Sentence("ask.conserved", {"what": what(q.of, system) or q.name})


def headline(system: System, question: Question) -> Sentence:
    """What is asked for, as a title has it."""
    of = what(question.quantity, system)
    if of is None:
        return Sentence("ask.quoted", {"text": question.text})
    return Sentence("ask.headline", {"what": of, "when": _when(question)})


def _when(question: Question) -> Argument:
    """At which instant it is meant."""
    q = question.quantity
    word = "time" if q.is_of_event else "until" if q.scope == "course" else "when"
    if question.at_start:
        return Sentence("ask.at_start")
    if question.transition is not None:
        return Sentence(f"ask.{word}_transition", {"text": question.transition.text})
    if question.event is None:
        return NOTHING
    left, equals, _right = question.event.text.partition("=")
    try:
        if equals:
            reached = {"left": parse(left.strip()), "right": question.event.value}
            return Sentence(f"ask.{word}", reached)
    except ExpressionError:
        pass
    return Sentence("ask.when_transition", {"text": question.event.text})


def what(q: object, system: System) -> Sentence | None:
    """A quantity in words; None for one that the catalogue has no words for."""
    along: Direction | None = getattr(q, "along", None)
    if getattr(q, "basis", None) is not None or (along is not None and not along.name):
        return None
    return _words(q, system)


@singledispatch
def _words(q: object, system: System) -> Sentence | None:
    return None


@_words.register
def _(q: OfMeasure, system: System) -> Sentence:
    is_angle = q.measure.dimension == DIMENSIONLESS
    if isinstance(q.measure, Angle) and q.order and q.name not in system.measures:
        origin = q.measure.origin
        relative = NOTHING if origin == GROUND else Sentence("what.relative", {"body": origin})
        args: dict[str, Argument] = {"body": q.measure.of, "relative": relative, "along": NOTHING}
        return Sentence(f"what.turning_{q.order}", args)
    if q.name in system.measures:
        kind = "angle" if is_angle else "measure"
        return Sentence(f"what.{kind}_{q.order}", {"symbol": rates_of(q.name, q.order)})
    return Sentence(f"what.phrase_{q.order}", {"phrase": q.name})


@_words.register
def _(q: OfPoint, system: System) -> Sentence:
    size = "size_" if q.size else ""
    return Sentence(f"what.{size}point_{q.order}", {"point": str(q.point), "along": _along(q.along)})


@_words.register
def _(q: Turning, system: System) -> Sentence:
    relative = NOTHING if q.relative_to == GROUND else Sentence("what.relative", {"body": q.relative_to})
    size = "size_" if q.size else ""
    args: dict[str, Argument] = {"body": q.body, "relative": relative, "along": _along(q.along)}
    return Sentence(f"what.{size}turning_{q.order}", args)


@_words.register
def _(q: InstantCentre, system: System) -> Sentence:
    relative = NOTHING if q.relative_to == GROUND else Sentence("what.relative", {"body": q.relative_to})
    return Sentence("what.centre", {"body": q.body, "relative": relative})


@_words.register
def _(q: Multiplier, system: System) -> Sentence:
    at = Sentence("what.at", {"places": q.at}) if q.at else NOTHING
    args: dict[str, Argument] = {"reaction": f"@reaction.{q.reaction}", "connection": q.connection, "at": at}
    return Sentence("what.reaction", args)


@_words.register
def _(q: Wrench, system: System) -> Sentence:
    kind = "moment" if q.moment else "force"
    on = NOTHING if q.on is None else Sentence("what.on", {"body": q.on})
    about = NOTHING if q.about is None else Sentence("what.about", {"point": str(q.about)})
    size = "size_" if q.size else ""
    args: dict[str, Argument] = {"connection": q.connection, "on": on, "along": _along(q.along), "about": about}
    return Sentence(f"what.{size}{kind}", args)


@_words.register
def _(q: LoadForce, system: System) -> Sentence:
    return Sentence("what.load", {"load": q.load})


@_words.register
def _(q: Energy, system: System) -> Sentence:
    return Sentence(f"what.{q.what}_energy", {"of": _of(q.body)})


@_words.register
def _(q: Momentum, system: System) -> Sentence:
    return Sentence("what.momentum", {"of": _of(q.body), "along": _along(q.along)})


@_words.register
def _(q: Spin, system: System) -> Sentence:
    about = NOTHING if q.about is None else Sentence("what.about", {"point": str(q.about)})
    return Sentence("what.spin", {"of": _of(q.body), "about": about, "along": _along(q.along)})


@_words.register
def _(q: Power, system: System) -> Sentence:
    return Sentence("what.power", {"of": q.of})


@_words.register
def _(q: Work, system: System) -> Sentence:
    return Sentence("what.work", {"of": q.of})


@_words.register
def _(q: RatioOf, system: System) -> Sentence | None:
    top, bottom = what(q.top, system), what(q.bottom, system)
    return None if top is None or bottom is None else Sentence("what.ratio", {"top": top, "bottom": bottom})


@_words.register(When)
def _(q: When, system: System) -> Sentence:
    return Sentence("what.time")


@_words.register
def _(q: Small, system: System) -> Sentence:
    return Sentence(f"what.{q.what}")


@_words.register
def _(q: Equilibrium, system: System) -> Sentence:
    named = q.name in system.measures
    return Sentence("what.equilibrium", {"of": Symbol(q.name) if named else q.name})


@_words.register
def _(q: Freedom, system: System) -> Sentence:
    return Sentence("what.freedom")


@_words.register
def _(q: GeneralizedMomentum, system: System) -> Sentence:
    of: Expr = Symbol(q.coordinate)
    return Sentence("what.generalized_momentum", {"of": of})


@_words.register
def _(q: JacobiIntegral, system: System) -> Sentence:
    return Sentence("what.jacobi")


@_words.register
def _(q: EnergyLost, system: System) -> Sentence:
    return Sentence("what.lost")


@_words.register
def _(q: Turns, system: System) -> Sentence:
    return Sentence("what.turns", {"body": q.body})


@_words.register
def _(q: Change, system: System) -> Sentence:
    return Sentence("what.change", {"of": Symbol(q.name) if q.name in system.measures else q.name})


def _along(direction: Direction | None) -> Argument:
    if direction is None:
        return NOTHING
    if direction.name in ("right", "up", "left", "down"):
        return Sentence(f"what.along_{direction.name}")
    return Sentence("what.along", {"direction": direction.name}) if direction.name else NOTHING


def _of(group: Group) -> Sentence:
    if group is None:
        return Sentence("what.of_system")
    return Sentence("what.of", {"bodies": group if isinstance(group, tuple) else (group,)})
