"""Where a way through the phases is the one that happens: every inequality with what it comes from."""

from __future__ import annotations

from collections.abc import Mapping
from typing import cast

from freebody.language.expression import Call, Expr, Symbol, add, negate, number, power
from freebody.language.sentences import Argument, Message, Sentence, turns
from freebody.model.elements import DryFriction
from freebody.narrative.contact.phase_way import PhaseSegment, PhaseSequence, on_the_way
from freebody.narrative.lines.script import Script, ready
from freebody.narrative.principles.sides import ZERO, parted
from freebody.present.report.blocks import Relation as Sign
from freebody.study.phases.result import relations
from freebody.study.phases.words import label
from freebody.symbolic.conditions import require
from freebody.symbolic.phases.friction import pressing
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.relations import SolvedRelation, readable
from freebody.symbolic.tidy import tidy

_SIGNS: dict[str, Sign] = {">": ">", ">=": "≥", "<": "<", "<=": "≤", "!=": "≠"}
_TURNED: dict[str, Sign] = {">": "<", "≥": "≤", "<": ">", "≤": "≥", "≠": "≠"}
# what an inequality is for, by the template of the message that says so
_PURPOSES = {
    "{contact} keeps touching": "touches",
    "{contact} does not slip": "sticks",
    "{contact} slips this way": "slips_so",
    "{contact} slips": "slips",
    "{string} stays taut": "taut",
    "a larger one does not hold": "beyond",
    "a smaller one does not hold": "beyond",
    "friction is needed": "needed",
    "such a value exists": "within",
    "there is such a limit": "real",
    "there is a lower limit": "lowest",
    "{contact} is open at the start": "open",
    "{contact} opens": "opens",
    "{string} fits": "fits",
    "it happens": "happens",
    "before {contact} {event}": "before",
    "as at the start": "branch",
    "{contact} is pressed on this side": "pressed",
    "friction forces exist": "exists",
    "no event ends it": "never",
    "{contact} rebounds": "rebounds",
    "{contact} does not rebound": "stays",
}
_HAPPENS = {"opens": "opens", "touches": "touches", "slips": "slips", "slip ends": "slip_ends"}


def tell_sticking(script: Script, way: PhaseSequence, leg: PhaseSegment) -> list[int]:
    """What friction that holds must transmit when a phase begins: no slip needs |F| <= mu N. Returns the lines."""
    found: list[int] = []
    sticking = [
        leg.phase.dry_friction[n] for n, s in leg.phase.mode.states.items() if s == 0 and n not in leg.phase.dropped
    ]
    for rub in sticking:
        shared = leg.phase.shared.get(rub.name, [])
        if shared:
            script.say("condition.shared", connection=label(rub.name))
            continue
        found.append(_tell_limit(script, way, leg, rub))
    return found


def _tell_limit(script: Script, way: PhaseSequence, leg: PhaseSegment, rub: DryFriction) -> int:
    f, newton = leg.phase.model.field, leg.newton
    names = newton.acting.symbols
    connection = label(rub.of or rub.name)
    with script.stage("stage.supposed", "hint.supposed", connection=connection):
        script.say("condition.supposed", connection=connection)
    with on_the_way(script, leg.glossary):
        pressed = [row.name for row, _x in pressing(leg.phase.model, rub, leg.phase.rows)] or list(rub.load[:1])
        unknowns = [newton.acting.generator(n) for n in (*(row.name for row in rub.rows), *pressed)]
        values = newton.write(script, newton.plan(unknowns), unknowns)
    frictions = [values[unknown][0] for unknown in unknowns[: len(rub.rows)]]
    squares = [power(Symbol(names[name].name), number(2)) for name in pressed]
    size: Expr = Symbol(names[pressed[0]].name) if len(pressed) == 1 else Call("sqrt", add(*squares))
    load = values[unknowns[-1]][0] if len(pressed) == 1 else leg.phase.load(rub)
    lines = tuple(line for _v, line in values.values())
    here = leg.phase.start_instant.here

    def strongest(direction: int) -> tuple[Expr, Ratio]:
        """What it can carry against slip in a direction, by what presses it and at the start of the phase."""
        c = f.lowest_terms(leg.phase.coefficient(rub, direction, at_rest=True))
        return tidy(c) * size if pressed else tidy(c), way.home(leg, f.lowest_terms(here(c * load)))

    def carried(direction: int) -> tuple[Expr, Expr]:
        written, most = strongest(direction)
        return written, readable(most)

    solved: SolvedRelation | None = None
    with script.stage("stage.holds", "hint.holds", connection=connection):
        symbols = [Symbol(names[row.name].name) for row in rub.rows]
        parts = [way.home(leg, f.lowest_terms(here(friction))) for friction in frictions]
        symbol, force = symbols[0], parts[0]
        known = way.tree.numbers(force)[way.piece.sets]
        # against slip that grows the force of the row is negative, F >= -c N, against the other way F <= c' N
        falls, rises = bool((known < 0).all()), not bool((known < 0).any())
        counted = names[rub.name].sign  # of the symbol, as the row counts it
        if rub.across is not None:  # by its size in the plane
            square = force.field.lowest_terms(sum((x * x for x in parts), force.field.zero))
            (written, most), size = carried(1), readable(way.tree.home.state.sqrt(square))
            first: tuple[Expr, ...] = (Call("sqrt", add(*(power(s, number(2)) for s in symbols))), written)
            then = (first[0], size, most)
            signs: tuple[Sign, ...] = ("=", "≤")
        elif falls or rises or rub.static_back is None:
            shown = readable(-force if falls else force)
            written, limit_force = strongest(-counted if rises else counted)
            most = readable(limit_force)
            if falls or rises:
                solved = _solved(way, limit_force + (force if falls else -force))
            first = (Call("abs", symbol), written)
            then = (Call("abs", symbol), shown if falls or rises else Call("abs", shown), most)
            signs = ("=", "≤")
        else:
            (back, least), (ahead, most) = carried(counted), carried(-counted)
            first = (negate(back), symbol, ahead)
            then = (negate(least), readable(force), most)
            signs = ("≤", "≤")
        with on_the_way(script, leg.course):
            args: dict[str, Argument] = {"connection": connection}
            bounds: tuple[Sign, ...] = ("≤",) * (len(first) - 1)
            limit = script.line(*first, relations=bounds, why="condition.coulomb", args=args, uses=lines, when="start")
            found = script.line(
                *then,
                relations=signs,
                why="condition.put_in",
                args={"lines": lines, "line": limit},
                uses=(limit, *lines),
                when="start",
            )
            if solved is None:
                return found
            left, sign, right = _sides(solved)
            return script.line(left, right, relations=(sign,), why="condition.hence", uses=(found,), when="start")


def _solved(way: PhaseSequence, reserve: Ratio) -> SolvedRelation | None:
    """reserve >= 0 solved for a coefficient of friction; None where that is not possible."""
    condition, _possible = require(reserve, ">=", "")
    found = [] if condition is None else relations(way.tree, [condition])
    return found[0] if len(found) == 1 and found[0].bound is not None else None


def tell_conditions(script: Script, way: PhaseSequence, lines: Mapping[str, tuple[int, ...]]) -> None:
    """The inequalities of the answer, solved. lines: from which they follow, by the key of what they are for."""
    found = relations(way.tree, way.piece.conditions)
    if not found:
        return
    with script.stage("stage.conditions", "hint.conditions"):
        still = all(leg.newton.acting.stands_still for leg in way.legs)
        script.say("condition.intro_at_rest" if still else "condition.intro")
        for r in found:
            left, sign, right = _sides(r)
            key, args = _purpose(r)
            uses = tuple(n for n in lines.get(key.rpartition(".")[2], ()) if n)
            if uses:
                key += "_from"
            with on_the_way(script, way.legs[-1].course):
                script.line(left, right, relations=(sign,), why=key, args={**args, "lines": uses}, uses=uses)


def _sides(r: SolvedRelation) -> tuple[Expr, Sign, Expr]:
    if r.unknown is not None and r.bound is not None:
        return r.element.field.generators[r.unknown].display, _SIGNS[r.relation], readable(r.bound)
    if (sides := r.text().sides) is not None:
        left, sign, right = sides
        return left, cast("Sign", sign), right
    return sides_of(readable(r.element), r.relation)


def sides_of(e: Expr, relation: str) -> tuple[Expr, Sign, Expr]:
    """e relation 0 with its terms on the sides on which they are positive."""
    left, right = parted(e)
    sign = _SIGNS[relation]
    return (left, sign, right) if left != ZERO else (right, _TURNED[sign], left)


def _purpose(r: SolvedRelation) -> tuple[str, dict[str, Argument]]:
    return told_purpose(r.purposes[0] if r.purposes else "")


def told_purpose(purpose: str) -> tuple[str, dict[str, Argument]]:
    """What an inequality is for, as a key of the catalogue."""
    parts = turns(purpose)
    if len(parts) > 1 and all(isinstance(part, Message) for part in parts):
        return "condition.together", {"purposes": ready(purpose)}
    first = next(iter(parts), "")
    if not isinstance(first, Message) or first.template not in _PURPOSES:
        return "condition.other", {}
    named = first.arguments.get("contact", first.arguments.get("string", ""))
    if "event" in first.arguments:  # what else could end the phase
        happens = _HAPPENS.get(str(first.arguments["event"]), "passes")
        what = Sentence(f"phases.until_{happens}", {"connection": str(named)})
        return f"condition.{_PURPOSES[first.template]}", {"what": what}
    return f"condition.{_PURPOSES[first.template]}", {"connection": str(named)}
