"""What takes energy away in a model: dry friction, dampers, brakes, a blow."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.measures.geometry import GROUND
from freebody.questions.spoken import driving, joining, lookup, poses, rubbing, strings
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.sentence import Sentence
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_PAIR = 2


def is_all_that_rubs(names: Names, connection: str) -> bool:
    """Whether nothing but a connection takes energy away: no other is rough, and nothing is damped."""
    rough = {row.connection for row in names.constraint_rows if row.reaction == "friction force"} - {connection}
    return connection in names.connections and not rough and not damped(names) and not joining.strikes(names)


def damped(names: Names) -> list[str]:
    """Loads that are dampers."""
    return [name for name in names.loads if "damper" in (*names.called.get(name, ()), name.lower())]


def only_loses_in_the_blow(names: Names) -> bool:
    """Whether nothing but the blow at the start, or what closes on the way, takes energy away; an impulse that is
    applied takes none."""
    stops = [name for name in names.connections if "stop" in names.called.get(name, ())]
    at_start = joining.is_struck_at_start_alone(names) and not names.struck_at_start <= names.impulses
    is_alone = joining.goes_on(names) and (at_start or bool(names.closing_later and not names.struck_at_start))
    return is_alone and not _takes_energy(names) and not stops


def in_the_blow(names: Names, sentence: Sentence) -> Sentence:
    """What is lost when the bullet hits the block, when the peg catches the rod: in the blow in which both are joined,
    where the model has no other."""
    if [mark for mark, _ in sentence.others] != ["when"] or sentence.main.has("instant"):
        return sentence
    [(_, hit)] = sentence.others
    joined = sorted({*names.struck_at_start, *names.struck_when} & names.connections.keys())
    bounces = {row.connection for row in names.constraint_rows if row.unilateral and row.reaction != "tension"}
    joined = sorted(bounces) if bounces and not joined else joined  # up to the blow nothing is lost yet
    if len(joined) != 1 or (bounces and joined != [*bounces]) or hit.all("verb") != ["hit"]:
        return sentence
    own = {joined[0], GROUND, *names.connections[joined[0]].mentions(names), *joining.ends_of(names, joined[0])}
    is_plain = hit.without("degree", "first").only("verb", "name", "pronoun", "preposition")
    if not is_plain or any(name not in own for _, name in hit.names):
        return sentence
    return Sentence(Clause([*sentence.main.words, Word("instant", "in the impact")]), ())


def runs_down(names: Names) -> list[str]:
    """What turns at the start, or after a push, where nothing drives it and a brake, or dry friction, stops it."""
    rubs = any(row.reaction == "friction torque" for row in names.constraint_rows)
    if not rubs or not names.loads.keys() <= names.impulses:
        return []
    pushed = {body for p in names.strikes for body in p.measure.bodies() if body != GROUND}
    return lookup.started(names) or [body for body in lookup.massive(names) if body in pushed]


def comes_to_roll(names: Names) -> bool:
    """Whether what moves is one round body that slips on the one rough thing there is, and is not driven."""
    return _slides_by_itself(names) and rubbing.rolls(names)


def comes_to_rest(names: Names) -> bool:
    """Whether what moves is one body that slides on the one rough thing there is, cannot roll, and is not driven."""
    return _slides_by_itself(names) and not rubbing.rolls(names)


def _slides_by_itself(names: Names) -> bool:
    one = len(lookup.massive(names)) == 1 and len(rubbing.rough(names, "")) == 1
    driven = [
        name for name in names.loads if "gravity" not in names.called.get(name, ()) and name not in names.impulses
    ]
    moves = bool(names.impulses) or not lookup.rests(names)
    return one and moves and not (driven or braked(names)) and not joining.goes_on(names)


def braked(names: Names) -> bool:
    """Whether a brake acts between something that moves and the ground."""
    brakes = {name for name in names.connections if "brake" in names.called.get(name, ())}
    return bool(brakes - {*clutches(names)})


def clutches(names: Names) -> list[str]:
    """Brakes between two bodies that move."""
    brakes = [name for name in names.connections if "brake" in names.called.get(name, ())]
    free = {*lookup.moving(names)}
    return [name for name in brakes if len(free & names.connections[name].mentions(names)) > 1]


def taking_along(names: Names) -> list[str]:
    """The one rough contact in which one of two bodies that move takes the other along, where nothing drives them."""
    rough = rubbing.rough(names, "")
    driven = [name for name in names.loads if "gravity" not in names.called.get(name, ())]
    is_alone = len(rough) == 1 and joining.is_between(names, rough[0]) and len(lookup.massive(names)) == _PAIR
    return rough if is_alone and not driven and not driving.is_driven(names) and not lookup.rests(names) else []


def engaged(names: Names, _body: str = "") -> list[str]:
    """The condition that what a clutch joins turns alike: it no longer slips."""
    ends = [f"slipping of {name} ends" for name in clutches(names)]
    return ends or (["slipping ends"] if comes_to_roll(names) else [])


def in_balance(names: Names, of: str) -> list[str]:
    """The condition that something passes its equilibrium, where nothing accelerates it: of what is not damped, rubs
    nowhere, is not forced and has one measure."""
    free = not (damped(names) or rubbing.rubs(names) or lookup.is_forced(names))
    measures = lookup.places(names, of) or lookup.angles(names, of) or lookup.hung(names, of)
    return [f"acceleration of {name} = 0" for name in measures if free and len(names.measures) == 1]


def fastest_at(names: Names, of: str) -> list[str]:
    """Where the only body that moves is fastest, by the one measure that says where it is."""
    body = of or next(iter(lookup.moving(names)), "")
    one = len(names.measures) == 1 and lookup.is_all_that_moves(names, body)
    return [f"{name} when speed of {body} is greatest" for name in names.measures if one]


def separated(names: Names, _body: str = "") -> list[str]:
    """The condition that what touches parts."""
    return ["contact is lost"] if joining.strikes(names) else []


def at_the_end(names: Names, body: str = "") -> list[str]:
    """The condition that all of a rope hangs; else what comes of a motion that something keeps from going ever faster.
    Of another one nothing says where it ends, but for the place that the file's own questions name."""
    lasting = ["t grows"] if lookup.is_controlled(names) or damped(names) else []
    named = [place for sense in (-1, 1) for place in poses.named_by_file(names, body, sense)]
    if not named and not lookup.ways(names, body) and len(lookup.ways(names, "")) == 1:  # what turns as a weight falls
        named = [place for sense in (-1, 1) for place in poses.named_by_file(names, "", sense)]
    return strings.run_off(names, "") or lasting or named


def has_kinetic_energy_alone(names: Names) -> bool:
    """Whether no load but weight acts, and all ways that are measured are level."""
    if not names.loads and not lookup.places(names, ""):
        return True
    weights = {name for name in names.loads if "gravity" in names.called.get(name, ())}
    measures = lookup.places(names, "")
    return bool(measures) and weights == set(names.loads) and set(lookup.level(names, "")) == set(measures)


def _takes_energy(names: Names) -> bool:
    return (
        bool(damped(names))
        or any(row.reaction.startswith("friction") for row in names.constraint_rows)
        or any("brake" in names.called.get(name, ()) for name in names.connections)
    )
