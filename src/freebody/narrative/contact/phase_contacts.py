"""Which contacts are closed in a phase, what friction does there, and why: the first thing to say of a phase."""

from __future__ import annotations

from freebody.language.expression import Call, Expr, Symbol
from freebody.language.sentences import Sentence
from freebody.model.elements import DryFriction
from freebody.model.one_sided import GAP_OF_BUFFER
from freebody.narrative.contact.phase_way import PhaseSegment, PhaseSequence, on_the_way
from freebody.narrative.lines.glossary import Meaning
from freebody.narrative.lines.script import Listing, Script
from freebody.narrative.principles.sides import ZERO
from freebody.study.phases.words import label, rolls
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.relations import readable
from freebody.symbolic.tidy import tidy


def tell_contacts(
    script: Script, way: PhaseSequence, leg: PhaseSegment, before: tuple[int, ...]
) -> tuple[dict[str, int], list[int]]:
    """States and reasons; returns the lines of the slip velocities by friction, and those of their signs. before: lines
    with the state in which the phase begins."""
    phase = leg.phase
    states = tuple(_states(leg))
    if states:
        script.add(Listing(states))
    found: dict[str, int] = {}
    signs: list[int] = []
    for name, state in phase.mode.states.items():
        if state:
            found[name], sign = _slip(script, way, leg, phase.dry_friction[name], state, before)
            signs += [sign] if sign else []
    return found, signs


def _states(leg: PhaseSegment) -> list[Sentence]:
    """One sentence for every bound, ideal string and friction."""
    phase, found = leg.phase, list[Sentence]()
    unilateral = [row for row in phase.base.constraint_rows if row.unilateral]
    rubbing = {rub.of: phase.mode.states[name] for name, rub in phase.dry_friction.items() if name in phase.mode.states}
    for row in (*unilateral, *(bound.row for bound in phase.base.bounds)):
        args = {"connection": label(row.name)}
        closed = row.name in phase.mode.closed
        if row.reaction == "tension":
            found.append(Sentence("contact.taut" if closed else "contact.slack", args))
        elif not closed:
            if len(phase.base.bounds) < 3 or row.name in leg.starting:
                found.append(Sentence("contact.open", args))
        elif row.name not in rubbing:
            grips = any(h.needs and f"{h.connection}.{h.needs}" == row.name for h in phase.base.constraint_rows)
            found.append(Sentence("contact.grips" if grips else "contact.touches", args))
    for name, acts in phase.mode.acting:
        is_buffer = phase.base.borders[name].component == GAP_OF_BUFFER
        keys = ("compressed", "untouched") if is_buffer else ("taut", "slack")
        found.append(Sentence(f"contact.{keys[not acts]}", {"connection": label(name)}))
    for name, state in phase.mode.states.items():
        rub = phase.dry_friction[name]
        key = "slides" if state else "rolls" if rolls(rub) else "sticks"
        if not (rub.load or rub.of):  # a force of its own, as of a belt: nothing touches
            key = "gives_way" if state else "runs"
        found.append(Sentence(f"contact.{key}", {"connection": label(rub.of or name)}))
    return found


def _slip(
    script: Script, way: PhaseSequence, leg: PhaseSegment, rub: DryFriction, state: int, before: tuple[int, ...]
) -> tuple[int, int]:
    """The slip velocity in the coordinates, and its sign at the start of the phase."""
    phase = leg.phase
    rate = phase.model.field.lowest_terms(phase.state.rate(rub.row.measure))
    symbol = slip_symbol(leg, rub)
    line = 0
    if isinstance(symbol, Symbol):
        what = Sentence("symbol.slip", {"connection": label(rub.of or rub.name)})
        script.introduce(Meaning(symbol, what, lambda world: world.snapshot.rate(rub.row.measure), "m/s"))
        line = script.line(symbol, tidy(rate), why="slip.velocity")
    begin = way.home(leg, phase.start_instant.here(rate))
    if begin.is_zero():
        script.say("slip.from_rest", connection=label(rub.of or rub.name))
        return line, 0
    with on_the_way(script, leg.course):
        uses = tuple(n for n in (line, *before) if n)
        sign = script.line(
            symbol,
            readable(begin),
            ZERO,
            relations=("=", ">" if state > 0 else "<"),
            why="slip.start",
            args={"connection": label(rub.of or rub.name)},
            uses=uses,
            when="start",
        )
    return line, sign


def slip_symbol(leg: PhaseSegment, rub: DryFriction) -> Expr:
    """How the slip velocity is written: as the rate of a coordinate where it is one."""
    plain = coordinate_rate(leg, leg.phase.state.rate(rub.row.measure))
    if plain is not None:
        return plain
    others = [r for r in leg.phase.dry_friction.values() if r.name in leg.phase.mode.states]
    name = "v_s" if len(others) == 1 else f"v_s_{rub.row.connection}_{others.index(rub) + 1}"
    return Symbol(leg.free_name(name))


def coordinate_rate(leg: PhaseSegment, x: Ratio) -> Expr | None:
    """The rate of a coordinate by its symbol, where an element is one."""
    f = leg.phase.model.field
    for c in leg.phase.model.coordinates:
        if (x - f.variable(c.speed)).is_zero():
            return Call("rate", Symbol(c.name))
    return None
