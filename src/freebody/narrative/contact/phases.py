"""Motion in phases: contacts that slide, roll and open, one mode after the other, up to what is asked.

Every phase is told in the same order: which contacts are closed and what friction does there, momentum and moments with
the law of friction, the motion, and the event that ends it with the state there, in which the next phase begins.
"""

from __future__ import annotations

from itertools import compress

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, add, n_operations, negate
from freebody.language.sentences import Argument, Message, Sentence
from freebody.narrative.contact.phase_answer import asked_side, tell_answer
from freebody.narrative.contact.phase_blow import tell_sudden_blow
from freebody.narrative.contact.phase_conditions import tell_conditions, tell_sticking
from freebody.narrative.contact.phase_contacts import tell_contacts
from freebody.narrative.contact.phase_event import happening, is_endless, said_event, tell_event
from freebody.narrative.contact.phase_impact import tell_impact
from freebody.narrative.contact.phase_motion import require_course, tell_motion
from freebody.narrative.contact.phase_way import PhaseSegment, PhaseSequence, on_the_way
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.lines.naming import own_symbols, written
from freebody.narrative.lines.script import DerivationStage, FormulaTable, Script, ready
from freebody.narrative.questions.blow import MOST_OPERATIONS
from freebody.questions.energy import Energy
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.phases.in_blow import after_in_formulas
from freebody.study.phases.quantities import plain
from freebody.study.phases.words import action, is_of_all
from freebody.symbolic.phases.course import UniformMotion
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate

Values = dict[int, tuple[Ratio, int]]


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The derivation of a question about a system with contacts or dry friction. Raises CannotAnswer where there is
    none."""
    refuse(method, ("newton",), Message("a motion in phases"))
    if answer.expression is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    way = PhaseSequence(context.system, question)
    edges = [leg.first for leg in way.legs if leg.first is not None and leg.first.watch.kind == "edge ends"]
    if edges:
        raise CannotAnswer(Message("the answer lies behind the end of an edge, of which no derivation is written yet"))
    script = Script(way.legs[0].glossary, context.next_number)
    if way.piece.first is None:
        if way.legs[0].node.impact is not None:
            return _at_first_impact(context, way, script, answer)
        context.glossary = way.legs[0].glossary if question.transition is None else way.legs[0].course
        return _at_instant(context, way, script, answer)
    context.glossary = way.legs[-1].course
    _overview(script, way)
    ends: list[dict[str, int]] = []
    forces: Values = {}
    before: tuple[int, ...] = ()
    slips: tuple[int, ...] = ()
    for leg in way.legs:
        script.glossary = leg.glossary
        if leg.node.impact is not None:
            require_course(leg)
            before = _tell_blow(script, way, leg, before)
        end, forces, signs = _tell_phase(script, way, leg, before)
        slips += signs
        ends.append(end)
        before = tuple(end.values())
    happens = tuple(end.get("time") or end.get("place", 0) for end in ends)
    sticks = _after(script, way)
    if way.piece.after is not None:
        lines = {"happens": happens, "before": happens, "slips": slips}
        return _behind_blow(context, way, script, answer, before, lines)
    tell_conditions(script, way, {"happens": happens, "before": happens, "slips": slips, "sticks": sticks})
    tell_answer(context, script, way, question, answer, ends, forces)
    return script.stages


def _tell_blow(script: Script, way: PhaseSequence, leg: PhaseSegment, before: tuple[int, ...]) -> tuple[int, ...]:
    """The blow or the collision with which a phase begins; returns the lines of the state after it."""
    impact = leg.node.impact
    assert impact is not None
    if impact.sudden is not None and not impact.hits:
        return tell_sudden_blow(script, way, leg, impact.sudden, before)
    return tell_impact(script, way, leg, before).after


def _energies_beside(way: PhaseSequence, leg: PhaseSegment) -> Expr:
    """The kinetic energy just before an impact less that just after."""
    state = after_in_formulas(way.tree, leg.node, way.legs[0].node)
    after = Energy("kinetic").value(plain(leg.phase.system), leg.phase.start_instant)
    return add(way.shown(leg, state.energy_before), negate(way.shown(leg, after)))


# -- just after a blow ------------------------------------------------------------------------
def _at_first_impact(context: Context, way: PhaseSequence, script: Script, answer: Answer) -> list[DerivationStage]:
    """The motion begins with an impact, and what is asked is of it or comes just after it."""
    if not way.piece.in_blow and not way.piece.at_start:
        raise CannotAnswer(Message("the motion begins with an impact, and what follows it is derived at an event only"))
    leg = way.legs[0]
    context.glossary = leg.course
    told = _collision(script, way, leg, ())
    tell_conditions(script, way, {"sticks": told, "slips": told})
    return _value_behind(context, way, leg, script, answer, told)


def _behind_blow(
    context: Context,
    way: PhaseSequence,
    script: Script,
    answer: Answer,
    before: tuple[int, ...],
    lines: dict[str, tuple[int, ...]],
) -> list[DerivationStage]:
    """What is asked is of the blow that ends the last phase, or comes just after it. before: lines of its end."""
    after = way.piece.after
    assert after is not None
    leg = way.leg(way.legs[-1].number + 1, after, None, None, len(way.legs))
    script.glossary, context.glossary = leg.glossary, leg.course
    told = _collision(script, way, leg, before)
    tell_conditions(script, way, {**lines, "sticks": told})
    return _value_behind(context, way, leg, script, answer, told)


def _collision(script: Script, way: PhaseSequence, leg: PhaseSegment, before: tuple[int, ...]) -> tuple[int, ...]:
    """The lines of the impulses as well, which may be asked for."""
    assert leg.node.impact is not None
    if leg.node.impact.sudden is not None:
        return _tell_blow(script, way, leg, before)
    return tell_impact(script, way, leg, before).lines


def _value_behind(
    context: Context, way: PhaseSequence, leg: PhaseSegment, script: Script, answer: Answer, told: tuple[int, ...]
) -> list[DerivationStage]:
    """What is asked, from the state just after the blow."""
    q, newton, values = way.question.quantity, leg.newton, Values()
    if not way.piece.in_blow and q.scope != "course":
        unknowns = newton.unknowns_in(newton.asked(q))
        with on_the_way(script, leg.glossary):
            values = newton.write(script, newton.plan(unknowns), unknowns) if unknowns else {}
    with script.stage("stage.value", "hint.value"), on_the_way(script, leg.course):
        left = asked_side(context, way, leg, script, way.question)
        assert answer.expression is not None
        uses = (*told, *(line for _v, line in values.values()))
        key, middle = "impact.with", tuple[Expr, ...]()
        if q.is_energy_lost_at_once:
            key, middle = "impact.lost", (_energies_beside(way, leg),)
        is_short = [side != answer.expression and n_operations(side) <= MOST_OPERATIONS for side in middle]
        sides = (left, *compress(middle, is_short), answer.expression)
        script.line(*sides, why=key, args={"lines": uses}, uses=uses, when="start")
    return script.stages


def _overview(script: Script, way: PhaseSequence) -> None:
    """The phases one after the other."""
    with script.stage("stage.phases", "hint.phases"):
        first, system = way.legs[0], way.system
        if len(way.legs) == 1 and first.first is not None:
            key = "phases.only" if is_of_all(first.phase) else "phases.only_named"
            script.say(key, what=ready(action(first.phase)), end=_end_words(way, first))
            return
        is_of_contacts = bool(system.bounds or system.dry_friction) or not system.blows
        script.say("phases.plan" if is_of_contacts else "phases.plan_of_blows")
        header = (Sentence("phases.table_number"), Sentence("phases.table_what"), Sentence("phases.table_end"))
        rows = tuple(
            (str(leg.number), Sentence("phases.does", {"what": ready(action(leg.phase))}), _end_words(way, leg))
            for leg in way.legs
        )
        script.add(FormulaTable(header, rows))


def _end_words(way: PhaseSequence, leg: PhaseSegment) -> Sentence:
    if leg.first is None or is_endless(way, leg):
        return Sentence("phases.lasts")
    watch = leg.first.watch
    what: Argument = said_event(way, leg, watch) if watch.kind == "is reached" else f"@{watch.connection}"
    return Sentence(f"phases.until_{happening(leg.phase, watch)}", {"connection": what})


def _tell_phase(
    script: Script, way: PhaseSequence, leg: PhaseSegment, before: tuple[int, ...]
) -> tuple[dict[str, int], Values, tuple[int, ...]]:
    """One phase, from its contacts to the state at its end."""
    require_course(leg)
    with script.stage("stage.phase_contacts", "hint.phase_contacts", phase=f"@{leg.number}"):
        slips, signs = tell_contacts(script, way, leg, before)
    moving, places = _needed(way, leg)
    wanted = _wanted(way, leg, moving)
    values: Values = {}
    plan = leg.newton.plan(wanted)
    if wanted and plan.principles:
        values = leg.newton.write(script, plan, wanted)
    lines = {c.name: values[a][1] for c, a in _accelerations(leg) if a in values}
    told = tell_motion(script, way, leg, lines, before, moving, places)
    by_name = {
        name: values[leg.newton.acting.generator(name)][1]
        for name in leg.newton.acting.rows
        if leg.newton.acting.generator(name) in values
    }
    signs = [*signs, *(lines.values() if not signs else ())]  # from rest the acceleration tells the sense of the slip
    return tell_event(script, way, leg, told, {**slips, **by_name}), values, tuple(signs)


def _accelerations(leg: PhaseSegment) -> list[tuple[Coordinate, int]]:
    return list(zip(leg.phase.model.coordinates, leg.phase.model.accelerations, strict=True))


def _needed(way: PhaseSequence, leg: PhaseSegment) -> tuple[set[str], set[str]]:
    """Coordinates whose motion is needed, and those of which the place is, not only the velocity."""
    model, assert_first = leg.phase.model, leg.first
    assert assert_first is not None
    f = model.field
    is_last = leg is way.legs[-1] and way.piece.after is None
    if not is_last or not isinstance(leg.phase.course, UniformMotion):
        moving = [c for c in model.coordinates if _moves(leg, c)]
        placed = {c.name for c in moving if c.index not in model.unfollowed}  # how a ball is turned has no number
        return {c.name for c in moving}, placed
    element = model.in_independent_speeds(assert_first.watch.element)
    used = f.ingredients(f.follow(element, leg.phase.course.still))
    q = way.question.quantity
    if q.scope == "course" and not q.is_of_event:
        used |= {k for c in model.coordinates for k in (c.index, c.speed)}
    elif q.scope != "course":
        for part in leg.newton.asked(q):
            used |= f.ingredients(part)
            used |= {
                g
                for a in f.ingredients(part) & set(model.accelerations)
                for g in f.ingredients(model.dynamics.solved_accelerations[a])
            }
    moving = {c.name for c in model.coordinates if used & {c.index, c.speed} and _moves(leg, c)}
    placed = used - model.unfollowed
    places = {c.name for c in model.coordinates if c.index in placed and c.name in moving}
    return moving, places


def _moves(leg: PhaseSegment, c: Coordinate) -> bool:
    course = leg.phase.course
    if not isinstance(course, UniformMotion):
        return True
    return not (course.start.of(c.speed).is_zero() and course.accelerations[c.speed].is_zero())


def _wanted(way: PhaseSequence, leg: PhaseSegment, moving: set[str]) -> list[int]:
    """Accelerations and reactions that the phase needs."""
    assert leg.first is not None
    watch, newton, found = leg.first.watch, leg.newton, list[int]()
    if isinstance(leg.phase.course, UniformMotion):
        found += [a for c, a in _accelerations(leg) if c.name in moving]
    if watch.kind in ("opens", "slips") and watch.name not in leg.phase.base.borders:
        found.append(newton.acting.generator(watch.name))
    if watch.kind == "slips":
        found += [newton.acting.generator(n) for n in leg.phase.dry_friction[watch.name].load]
    is_last = leg is way.legs[-1] and way.piece.after is None
    if is_last and way.question.quantity.scope != "course":
        found += newton.unknowns_in(newton.asked(way.question.quantity))
    return list(dict.fromkeys(found))


def _after(script: Script, way: PhaseSequence) -> tuple[int, ...]:
    """Whether what follows can be what is said: that rolling goes on needs friction enough."""
    asked, node = way.question.transition, way.following
    if asked is None or asked.kind != "rolls" or node is None:
        return ()
    last = way.legs[-1]
    leg = way.leg(last.number + 1, node, None, None, len(way.legs))
    script.glossary = leg.glossary
    found = tell_sticking(script, way, leg)
    script.glossary = last.glossary
    return tuple(found)


def _without_forces(context: Context, question: Question) -> tuple[str, tuple[int, ...]]:
    """Why something is so in which no force is: a law of what connects, the blow at the start, or the motion."""
    if question.quantity.is_of_parameters and question.quantity.is_by_law:
        return "answer.by_law", ()
    if question.at_start:
        after = context.after_blow if context.setup.system.is_struck else ()
        return ("value.just_after" if after else "value.at_start"), after
    return "value.is", ()


# -- one instant ------------------------------------------------------------------------------
def _at_instant(context: Context, way: PhaseSequence, script: Script, answer: Answer) -> list[DerivationStage]:
    """In the phase in which the motion begins."""
    leg, question = way.legs[0], way.question
    with script.stage("stage.phase_contacts", "hint.phase_contacts", phase="@1"):
        _slips, signs = tell_contacts(script, way, leg, ())
    f, newton = leg.phase.model.field, leg.newton
    sticks = tuple(tell_sticking(script, way, leg))
    parts: tuple[Ratio, ...] = () if question.quantity.is_of_event else newton.asked(question.quantity)
    unknowns = newton.unknowns_in(parts)
    plan = newton.plan(unknowns)
    values = newton.write(script, plan, unknowns) if unknowns else {}
    general = tuple(f.lowest_terms(f.follow(p, {u: v for u, (v, _l) in values.items()})) for p in parts)
    lines = tuple(line for _v, line in values.values())
    tell_conditions(script, way, {"sticks": sticks, "slips": tuple(signs)})
    assert answer.expression is not None
    own = own_symbols(parts, values) if values and not question.at_start else None
    if own is not None and len(parts) == 1:  # its lines end in what is asked
        context.own = own
        return script.stages
    drawn_back = next((u for u in values if len(parts) == 1 and (parts[0] + f.variable(u)).is_zero()), None)
    with script.stage("stage.value", "hint.value") if drawn_back is None else script.stage("stage.counted"):
        left = asked_side(context, way, leg, script, question)
        if not parts:
            kind = "" if question.transition is None else question.transition.kind
            why = f"answer.{kind}_at_once" if kind in ("slips", "opens") else "answer.at_once"
            script.line(left, answer.expression, why=why, when="start")
            return script.stages
        shown = written(general)
        key, when = ("answer.at_start", "start") if question.at_start else ("answer.at_instant", "always")
        sides = (left, answer.expression) if shown == answer.expression else (left, shown, answer.expression)
        if not lines:
            key, lines = _without_forces(context, question)
        args: dict[str, Argument] = {"lines": lines, "given": lines}
        if drawn_back is not None:
            force = tidy(f.variable(drawn_back))
            key, args, sides = "value.counted", {**args, "force": force}, (left, -force, answer.expression)
        script.line(*sides, why=key, args=args, uses=lines, when="start" if when == "start" else "always")
    return script.stages
