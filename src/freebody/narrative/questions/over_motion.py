"""The greatest or least value over a motion: the quantity as a function of the place, where its slope vanishes, and the
turns."""

from __future__ import annotations

from collections.abc import Sequence

from freebody.errors import CannotAnswer, SaysNothing
from freebody.language.expression import Symbol, number, power
from freebody.language.sentences import Argument, Message, Sentence
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.naming import asked_as, asked_entry, fresh, named
from freebody.narrative.lines.script import DerivationStage, FormulaTable, Script
from freebody.narrative.principles.momentum import by_momentum, parts_of
from freebody.narrative.questions.course_by_energy import first_integral, say_first_integral, square_line
from freebody.narrative.questions.kept_momenta import tell_momenta
from freebody.questions.event_base import QuestionEvent
from freebody.questions.extent import ExtremeOfMotion
from freebody.questions.reading import Question
from freebody.study.answering.crosscheck import holds
from freebody.study.answering.extremes_until import extreme_in_numbers
from freebody.study.answering.motion_extremes import Along, Stationary, along, along_until
from freebody.symbolic.tidy import tidy


def tell_extreme(context: Context, question: Question, q: ExtremeOfMotion, method: Method) -> list[DerivationStage]:
    """The quantity as a function of the place, by energy; where its slope vanishes, and its values there and at the
    turns."""
    setup, model = context.setup, context.setup.model
    refuse(method, ("energy",), Message("what is greatest over a motion"))
    f, script = model.field, context.script()
    with setup.motion.on_one_side():
        seen = _seen(context, question, q)
        found = seen.candidates()
        chosen = seen.best(found, q.side)
    parts, unknowns = parts_of(context, q.of)
    forces = by_momentum(context, script, unknowns) if unknowns else {}
    lines = first_integral(context, script)
    lines += tell_momenta(script, setup.motion.integrals_of(seen.c), seen.c, lines, "start")
    with script.stage("stage.event", "hint.event"):
        say_first_integral(context, script, seen.c)
        square = square_line(context, script, seen.c, lines, "start")
    with script.stage("steady.motion", "steady.motion_hint"):
        symbol = Symbol(fresh(context, "y", "y_motion"))
        named(context, script, Meaning(symbol, Sentence("steady.followed_all", {"name": Symbol(seen.c.name)}), q.of))
        general = f.lowest_terms(f.follow(parts[0], {u: value for u, (value, _line) in forces.items()}))
        uses = tuple(line for _value, line in forces.values())
        first = script.line(symbol, tidy(general), why="steady.quantity", args={"lines": uses}, uses=uses)
        args: dict[str, Argument] = {"line": square}
        x = f.lowest_terms(seen.even + seen.odd * f.variable(seen.c.speed))
        left = symbol if not seen.is_root else power(symbol, number(2))
        last = script.line(left, tidy(x), why="steady.by_energy", args=args, uses=(first, square), when="start")
        table_of_places(context, script, seen, found)
    with script.stage("stage.value"):

        def read(world: World) -> float:
            if not all(holds(setup, c, world.draw, world.draw.start()) for c in seen.conditions):
                raise SaysNothing(Message("the motion is another one there"))
            if question.event is not None:
                return extreme_in_numbers(setup, world.draw, q, question.event)
            low, high = seen.in_numbers(q.of, world.draw)
            return low if q.side < 0 else high

        name = asked_as(context, question, read)
        script.add(asked_entry(name, question))
        args = {"line": last}
        why = "steady.greatest" if q.side > 0 else "steady.lowest"
        script.line(name, tidy(seen.value_of(chosen)), why=why, args=args, uses=(last,), when="never")
    return script.stages


def _seen(context: Context, question: Question, q: ExtremeOfMotion) -> Along:
    """The quantity along all of a motion that repeats itself, or up to an event."""
    setup = context.setup
    if isinstance(question.event, QuestionEvent):
        return along_until(setup, q.of, setup.motion.reach(question.event))
    if question.event is not None:
        raise CannotAnswer(Message("there is no closed form"))
    seen = along(setup, q.of)
    seen.add_needs()
    return seen


def table_of_places(context: Context, script: Script, seen: Along, found: Sequence[Stationary]) -> None:
    """The places of the motion at which the quantity can be extreme, with its values."""
    places = "steady.places_of_motion" if seen.repeats else "steady.places_of_way"
    script.say(places, name=Symbol(seen.c.name))
    header = (Sentence("steady.table_place"), Sentence("steady.table_value"))
    rows = [(at, tidy(seen.value_of(s))) for s in found if seen.is_inside(s) for at in seen.place_texts(s)]
    script.add(FormulaTable(header, tuple(rows)))
