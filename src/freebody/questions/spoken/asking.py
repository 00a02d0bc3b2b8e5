"""What is asked for: a main clause without an event, as quantities of the grammar.

Words may stand in any order; what a thing is to the quantity is said by the preposition before it, or by what it is."""

from __future__ import annotations

import re
from itertools import pairwise, product
from typing import TYPE_CHECKING

from freebody.measures.geometry import GROUND
from freebody.questions.spoken import (
    driving,
    farthest,
    given,
    joining,
    lookup,
    losing,
    of_axles,
    of_forces,
    of_motion,
    of_sections,
    of_springs,
    of_systems,
    of_transmissions,
    poses,
    rubbing,
    strings,
    transmitting,
)
from freebody.questions.spoken.composing import JOINT, SILENT, Groups, composed
from freebody.questions.spoken.frames import FORCES, MOTION, framed
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_NAMED_AS_FORCES = ("force", "torque", "drag", "buoyancy")  # kinds of loads of which a name alone is the force
_GEARED = ("tooth force", "belt force", "chain force")  # what turns one body by another
_OF_CONTACT = ("normal force", "friction force")
_OVER_FREQUENCY = ("steady amplitude", "magnification factor", "free amplitude", "transmissibility")
_OF_QUANTITY = (
    "stroke",
    "time ratio",
    "extremes",
    "steady amplitude",
    "phase lag",
    "resonance frequency",
    "magnification factor",
)
# the rooms of quantities are found when this is read
__all__ = ["of_forces", "of_motion", "of_sections", "of_springs", "of_systems", "of_transmissions", "quantities"]


_OF_MODE = {"first": "lowest", "least": "lowest", "greatest": "highest"}  # which of the natural frequencies
_SUM = re.compile(r"^[^()]+ [+-] ")  # of quantities: a + b


def quantities(names: Names, clause: Clause) -> Groups:
    """The quantities that a clause without an event can ask for."""
    clause = (
        clause.without("filler").without("verb", "act", "exert") if _is_of_force(clause) else clause.without("filler")
    )
    if clause.words and clause.words[-1] == Word("preposition", "and"):  # something is missing behind it
        return
    if clause.has("quantity", "bounce height"):  # which is greatest behind the bounce, and not before it
        clause = clause.without("degree", "greatest")
    if clause.has("relation") or clause.has("value") or clause.has("turns") or clause.has("other"):
        return
    if loaded := of_sections.greatest(names, clause):
        yield loaded
        return
    if clause.has("quantity", *FORCES) and _are_two_joints(names, clause):
        return  # the forces at A and B
    if clause.has("quantity", "ratio", "difference", "sum"):
        yield from _of_two(names, clause)
        return
    place = clause.has("quantity", "height", "position", "angle", "depth", "distance")
    place = place and clause.has("ask", "with", "where") and clause.has("degree")
    if place and (clause.has("verb", "move") or clause.words[-1].kind == "degree"):
        return  # at which height does it move fastest: the place is not what is greatest
    named = next((name for _, name in clause.names), "")
    if clause.has("ask", "where") and clause.all("degree") == ["greatest"] and not clause.has("quantity"):
        if clause.only("ask", "degree", "name", "verb", *SILENT) and set(clause.all("verb")) <= {"move", "turn"}:
            yield losing.fastest_at(names, named)  # where is it fastest
        return
    if clause.has("ask", "with", "where") and clause.has("degree") and _is_of_another(clause):
        return  # at which speed is the vibration greatest: the speed is not what is greatest
    clause = framed(names, clause)
    if clause.words and clause.words[-1] == Word("preposition", "and"):  # or what was behind it is taken for a verb
        return
    if clause.has("verb", "exert", "act"):
        clause = clause.without("verb", "exert", "act")
    if clause.all("degree") == ["range"] and clause.all("quantity") == ["transmission angle"]:
        if clause.only("degree", "quantity", "pronoun", "preposition"):
            yield [JOINT.join(f"{end} transmission angle" for end in ("least", "greatest"))]
        return
    if clause.all("degree") == ["range"] and clause.has("quantity", "normal force", "friction force"):
        for group in _plain(names, clause.without("degree")) if lookup.rests(names) else ():
            yield [f"range of {text}" for text in group]
        return
    if clause.all("degree") == ["range"] and clause.has("quantity", "force", "contact force", "reaction"):
        kept = [word for word in clause.words if word.kind not in ("degree", "quantity")]  # of both that it has
        both = [list(_plain(names, Clause([Word("quantity", kind), *kept]))) for kind in _OF_CONTACT]
        heads = [groups[0][0] for groups in both if groups and len(groups[0]) == 1]
        yield [JOINT.join(f"range of {head}" for head in heads)] if heads and lookup.rests(names) else []
        return
    degrees = [degree for degree in clause.all("degree") if degree != "value"]
    if degrees == ["greatest"] and clause.has("quantity", *_OVER_FREQUENCY) and (omega := lookup.excitation(names)):
        for group in _plain(names, clause.without("degree")):  # the greatest that any frequency of the excitation gives
            yield [f"largest {text} over {omega}" for text in group if text.startswith(_OVER_FREQUENCY)]
    if clause.all("quantity") == ["natural frequency"] and clause.only("quantity", "degree", *SILENT):
        yield from ([f"{_OF_MODE[which]} natural frequency"] for which in degrees if which in _OF_MODE)
    if degrees:
        yield from _extreme(names, clause.without("degree"), degrees)
        return
    yield from _plain(names, clause.without("degree"))


def _are_two_joints(names: Names, clause: Clause) -> bool:
    """Whether two connections, or points of some, are named side by side: of each of them a force is asked for."""
    pairs = [(one, other) for (_, one), (before, other) in pairwise(clause.names) if before == "and"]
    of_two = clause.has("preposition", "between") or clause.has("quantity", "ratio", "difference", "sum")
    return not of_two and any(all(name in names.connections or "." in name for name in pair) for pair in pairs)


def _is_of_another(clause: Clause) -> bool:
    """Whether what is greatest stands behind the quantity that is asked for, and is something else."""
    kinds = [word.kind for word in clause.words if word.kind in ("quantity", "name", "pronoun", "degree")]
    k = kinds.index("quantity") if "quantity" in kinds else len(kinds)
    return kinds[-1] == "degree" and "pronoun" in kinds[k:]


def _is_of_force(clause: Clause) -> bool:
    return clause.has("quantity") and not clause.has("ask", "fast", "far")


def _without_what_turns(names: Names, clause: Clause) -> tuple[Clause, str]:
    """Without `of the crank` behind `over a turn`, where a motor turns it, or `of theta`, which the turn is of."""
    words, turn = clause.words, Word("instant", "over a turn")
    k = words.index(turn) if turn in words else len(words)
    of, thing = [*words[k + 1 : k + 3], Word("", ""), Word("", "")][:2]
    is_driver = thing.what in lookup.turning(names) and len(clause.names) > 1
    if of != Word("preposition", "of") or not (is_driver or thing.what in names.measures):
        return clause, ""
    return Clause([*words[: k + 1], *words[k + 3 :]]), "" if is_driver else f" of {thing.what}"


def _extreme(names: Names, clause: Clause, degrees: list[str]) -> Groups:
    """The greatest or least of something over the motion."""
    if len(degrees) != 1 or degrees[0] not in ("greatest", "least"):
        return
    if rubbing.is_still(names) and clause.has("quantity", *MOTION):
        return  # the greatest acceleration that can be reached is none of a motion
    if len(clause.all("quantity")) > 1 and clause.has("preposition", "and"):
        return  # the largest of one, and another
    whole = " over the motion" if clause.has("instant", "over the motion") else ""
    is_turn = clause.has("instant", "over a turn")
    clause, angle = _without_what_turns(names, clause)
    whole = f" over a turn{angle}" if is_turn else whole
    clause = clause.without("instant", "over the motion", "over a turn")
    [degree] = degrees
    clause = clause.without("verb", "reach", "move")
    goes = set(clause.all("verb")) <= {"slide", "roll", "turn", "rise", "fly"}
    if degree == "greatest" and clause.has("ask", "far", "much") and not clause.has("quantity") and goes:
        found = lookup.angles if clause.has("verb", "turn") else lookup.places
        most = lookup.farthest if clause.has("verb", "turn") else lookup.farthest_way
        yield [most(names, measure) for measure in found(names, next((name for _, name in clause.names), ""))]
        return
    if clause.has("quantity", "transmission angle"):
        yield [f"{degree} transmission angle"] if clause.only("quantity", *SILENT) else []
        return
    of = [name for _, name in clause.names]
    if clause.all("quantity") == ["tension"] and not of and (cables := strings.cables(names)):
        yield [f"{degree} tension of {cable}" for cable in cables]  # which is not the same along them
        return
    if (
        clause.has("quantity", "friction force", "friction coefficient")
        and lookup.rests(names)
        and not lookup.swings(names)
    ):
        return  # the least friction with which it rests is no least over a motion
    if degree == "greatest" and clause.has("quantity", "distance", "displacement") and clause.has("updown", "up"):
        bodies = [name for name in of if name in lookup.moving(names)]
        who = next(iter(bodies), "")
        yield [f"greatest {way}" for way, sense in lookup.inclined(names, who) if sense > 0]
        return
    if degree == "least" and clause.all("quantity") == ["height"] and not of and not whole:
        return  # the least height from which it goes round is no height of the motion
    if degree == "greatest" and clause.has("quantity", "height") and clause.only("quantity", "name", *SILENT):
        moved = [name for name in of if name in lookup.moving(names) or name not in names.bodies]
        if len(moved) == 1 and (risen := farthest.risen_from_below(names, moved[0])):
            yield risen
            return
        yield [f"greatest height of {name}" for name in moved or lookup.moving(names)]
        yield [
            f"{name} when {top}" for name in lookup.rising(names, next(iter(of), "")) for top in poses.tops(names, name)
        ]
        return
    if (
        degree == "greatest" and clause.all("quantity") == ["displacement"] and clause.has("ask")
    ):  # which one it reaches
        clause = clause.without("ask")
    if clause.has("quantity", "position", "distance", "angle", "deflection") and len(of) <= 1:
        found = lookup.angles if clause.has("quantity", "angle") else lookup.places
        found = lookup.deflections if clause.has("quantity", "deflection") else found
        who = next(iter(of), "")
        hung = lookup.hung(names, who) if clause.has("quantity", "angle") else []
        if degree == "greatest" and clause.has("quantity", "angle") and not whole:
            yield [lookup.farthest(names, angle) for angle in found(names, who) or hung]
            is_let_go = who in lookup.turning(names) and not (found(names, who) or hung or driving.is_driven(names))
            yield [f"greatest change of angle of {who}"] if is_let_go else []
            return
        is_way = degree == "greatest" and clause.all("quantity") == ["distance"]
        most = [lookup.farthest_way(names, m) if is_way else f"{degree} {m}" for m in found(names, who) or hung]
        yield [f"{measure}{whole}" for measure in most]
        return
    if clause.has("quantity", "horizontal range"):  # over what can be chosen: the angle
        angles = given.of_kind(names, "angle")
        end = "largest" if degree == "greatest" else degree
        for group in _plain(names, clause) if len(angles) == 1 else ():
            yield [f"{end} {text} over {angles[0]}" for text in group]
        return
    belts = transmitting.having(names, "greatest belt force") if degree == "greatest" else []
    is_torque = clause.all("quantity") in (["torque"], ["moment"], ["driving torque"])
    is_torque = is_torque and clause.without("verb", "carry").only("quantity", "name", "ask", *SILENT)
    if is_torque and (torques := strings.greatest_torques(names, belts, of)):
        yield [JOINT.join(torques)]
        return
    belts = transmitting.having(names, "greatest power")
    if degree == "greatest" and clause.has("quantity", "power", "transmitted power") and {*of} <= {*belts}:
        yield [f"greatest power of {belt}" for belt in belts if belt in (of or [belt])]
    if degree == "greatest" and (slowing := clause.all("quantity")) in (["deceleration"], ["angular deceleration"]):
        yield from of_motion.slowed_most(names, slowing[0], clause.without("quantity"))
        return
    is_way = degree == "greatest" and clause.all("quantity") == ["displacement"]
    for group in _plain(names, clause):
        told = [text for text in group if JOINT not in text]
        sums = {text: f"({text})" if _SUM.search(text) else text for text in told}
        most = [lookup.farthest_way(names, text) if is_way else f"{degree} {sums[text]}" for text in told]
        yield [f"{text}{whole}" for text in most]


def _of_two(names: Names, clause: Clause) -> Groups:
    """The ratio of two quantities, their difference, their sum."""
    kind = next(word.what for word in clause.words if word.what in ("ratio", "difference", "sum"))
    k = next(k for k, word in enumerate(clause.words) if word == Word("quantity", kind))
    said = [word for word in clause.words[:k] if word.kind not in (*SILENT, "ask")]
    rest = clause.words[k + 1 :]
    if kind == "difference" and all(word.kind in SILENT for word in rest):  # by how much do the tensions differ
        rest, said = [word for word in clause.words[:k] if word.kind != "ask"], []
    if clause.has("ask", "fast") and kind == "ratio" and [w.kind for w in rest if w.kind not in SILENT] == ["name"]:
        own = Word("quantity", "angular velocity" if clause.has("verb", "turn") else "speed")
        first = [w for w in clause.words[:k] if w.kind == "name"]
        rest = [own, *first, Word("preposition", "to"), *[w for w in rest if w.kind == "name"]]
        said = []
    if any(word.kind != "quantity" for word in said) or len(said) > 1:
        return
    signs = ("to",) if kind == "ratio" else ("and",)
    between = {"preposition"}
    cuts = [j for j, w in enumerate(rest) if w.kind in between and (w.what in signs or w.what == "and")]
    operator = {"ratio": "/", "difference": "-", "sum": "+"}[kind]
    if not cuts:
        yield from _of_sides(names, Clause([*said, *rest]), kind)
    for cut in cuts:
        first, second = Clause(rest[:cut]), Clause(rest[cut + 1 :])
        first = Clause([*said, *first.words])
        if with_parameter := list(_beside_parameter(names, first, second, operator)):
            yield from with_parameter  # by how much the cable is longer than the span l
            continue
        if kind == "ratio" and _are_geared(names, first, second):  # sun to carrier
            first = Clause([Word("quantity", "angular velocity"), *first.words])
        own = [w for w in first.words if w.kind == "quantity"]
        is_lent = len({first.has("quantity"), second.has("quantity")}) == 2
        if is_lent and not (first.names and second.names):  # of the weight and the tension none is at the other
            continue
        if not second.has("quantity"):  # the rope force on the left to that on the right
            joints = [w for w in first.words if w.kind == "name" and w.what in names.connections]
            carried = joints if second.has("pronoun", "that") else []
            second = Clause([*carried, *own, *second.without("pronoun", "that").words])
        if not first.has("quantity"):
            first = Clause([*[w for w in second.words if w.kind == "quantity"], *first.words])
        for one, other in product(list(quantities(names, first)), list(quantities(names, second))):
            alike = [(a, b) for a in one for b in other if a.partition(" of ")[0] == b.partition(" of ")[0]]
            pairs = [(a, b) for a, b in alike or product(one, other) if a != b]
            if all(texts[0].startswith("angular velocity") for texts in (one, other) if texts):
                pairs = pairs[:1]  # speeds of what turns about axles
            yield [f"ratio of {a} to {b}" if operator == "/" else f"{a} {operator} {b}" for a, b in pairs]


def _beside_parameter(names: Names, first: Clause, second: Clause, operator: str) -> Groups:
    """The difference, the sum, or the ratio of a quantity and a parameter."""
    sides = (first, second)
    given_ = [
        side.names[0][1]
        if side.only("name", *SILENT) and len(side.names) == 1 and side.names[0][1] in names.parameters
        else ""
        for side in sides
    ]
    if bool(given_[0]) == bool(given_[1]):
        return
    for group in quantities(names, sides[0] if given_[1] else sides[1]):
        both = ((given_[0] or text, given_[1] or text) for text in group)
        yield [f"ratio of {a} to {b}" if operator == "/" else f"{a} {operator} {b}" for a, b in both]


def _are_geared(names: Names, *sides: Clause) -> bool:
    """Whether only two bodies are named of which one turns the other."""
    is_plain = all(side.only("name", *SILENT) and len(side.names) == 1 for side in sides)
    turned = {body for row in names.constraint_rows if row.reaction in _GEARED for body in row.measure.bodies()}
    arms = {body for body in lookup.turning(names) if of_axles.planets(names)}
    return is_plain and all(name in turned | arms for side in sides for _, name in side.names)


def _of_sides(names: Names, clause: Clause, kind: str) -> Groups:
    """The difference of the forces at the two ends of a rope, their sum, or their ratio."""
    asked, of = clause.all("quantity"), [name for _, name in clause.names]
    if len(asked) != 1 or len(of) > 1 or not clause.only("quantity", "name", *SILENT):
        return
    belts = {row.connection for row in names.constraint_rows if row.reaction == "belt force"}
    if asked == ["tension"] and belts and set(of) <= belts and kind == "difference":  # of both runs
        yield from composed(names, "belt force", clause.without("quantity"))
        return
    rows = [
        row for row in names.constraint_rows if row.reaction == asked[0] and row.connection in (of or [row.connection])
    ]
    if rows and all(len(row.ends) == 2 and row.connection == rows[0].connection for row in rows):
        first, second = (f"{asked[0]} of {rows[0].connection} at {end}" for end in (rows[0].ends[0], rows[-1].ends[1]))
        ratios = [f"ratio of {first} to {second}", f"ratio of {second} to {first}"]  # which to which is not said
        yield [JOINT.join(ratios) if kind == "ratio" else f"{first} {'+' if kind == 'sum' else '-'} {second}"]


def _plain(names: Names, clause: Clause) -> Groups:
    """One quantity."""
    asked = clause.all("quantity")
    if clause.has("ask") or clause.has("verb") or clause.has("degree") or clause.has("not") or clause.has("instant"):
        return
    if not asked:
        yield from _bare(names, clause)
        return
    if (
        len(asked) > 1
        and asked[0] in ("power", "work")
        and asked[1] in ("force", "torque", "spring force", "friction force")
    ):
        asked = asked[:1] if clause.names else asked
    if "resonance frequency" in asked and set(asked) <= {
        "resonance frequency",
        "angular velocity",
        "natural frequency",
    }:
        asked = ["resonance frequency"]  # at what speed does it resonate
    if asked[0] == "phase lag" and set(asked[1:]) <= {"force", "displacement", "position"} and len(names.measures) == 1:
        if clause.only("quantity", "name", *SILENT):  # of the displacement against the force
            yield [f"phase lag of {measure}" for measure in names.measures]
        return
    if asked == ["stroke"] and clause.only("quantity", "name", *SILENT) and len(clause.names) <= 1:
        yield [f"stroke of {position}" for position in _guided(names, [name for _, name in clause.names])]
    if len(asked) > 1 and asked[0] in _OF_QUANTITY:
        inner = Clause([w for w in clause.words if w != Word("quantity", asked[0])])
        for group in quantities(names, inner):
            yield [text if text.startswith(asked[0]) else f"{asked[0]} of {text}" for text in group]
        return
    if len(asked) != 1:
        return
    [quantity] = asked
    rest = clause.without("quantity")
    if rest.has("part", "in own axes"):
        for group in composed(names, quantity, rest.without("part", "in own axes")):
            owned = [(text, *_owner(names, text.rpartition(" of ")[2])) for text in group]
            yield [f"{text}{on} in {body}" for text, on, body in owned if body]
        return
    yield from composed(names, quantity, rest)


def _owner(names: Names, thing: str) -> tuple[str, str]:
    """Whose axes are those of a thing: its own, or those of the only body that a bearing holds, on which it acts."""
    if thing not in names.connections:
        return "", thing
    held = sorted(names.connections[thing].mentions(names) - {GROUND})
    return (f" on {held[0]}", held[0]) if len(held) == 1 else ("", "")


def _guided(names: Names, of: list[str]) -> list[str]:
    """The positions along their guides of what is named, or of all that is guided, where no place of it is measured."""
    bodies = of or lookup.moving(names)
    bodies = [body for body in bodies if not (lookup.places(names, body) or lookup.angles(names, body))]
    return [f"position of {body} along {guide}" for body in bodies for guide in joining.guides(names, body)]


def _bare(names: Names, clause: Clause) -> Groups:
    """A measure by its name alone."""
    if not clause.only("name", *SILENT) or len(clause.names) != 1:
        return
    [(_, name)] = clause.names
    if name in names.measures:
        yield [name]
    elif name in names.loads and name not in names.bodies and {*names.called.get(name, ())} & {*_NAMED_AS_FORCES}:
        yield [f"force in {name}"]  # the motor torque, the engine force
