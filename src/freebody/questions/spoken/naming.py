"""Which element of a model words stand for: a name, or what people call a thing of its kind.

A kind says itself what its things are called (`Spec.called`): a string rope, cord or cable. Such a word alone stands
for every thing that it fits; beside a name it says no more than the name does: `the left block`, `pin A`, `mass m1`.
Names are marked («left») until the text is read, so that no rule takes them for words.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING

from freebody.language.expression import Symbol
from freebody.language.units import TORQUE
from freebody.measures.geometry import GROUND, ZERO
from freebody.questions.spoken import by_side, joining, lookup, motors, of_axles, rubbing, strings
from freebody.questions.spoken.elements import ALIKE, INFERRED, WRITTEN, Elements
from freebody.questions.spoken.lexicon import (
    CLOSE,
    ENGLISH,
    OPEN,
    is_in_language,
    is_left_out,
    is_verb,
    kinds_apart,
    quantity_words,
    stands_for_all,
    tells_apart,
    things_alike,
)
from freebody.questions.spoken.telling import told_apart

if TYPE_CHECKING:
    from freebody.model.names import Names

MOST = 96  # ways in which the words of one text may be meant: more are no question
_COMPONENT = re.compile(r"(\w+?)(_[xyhvXYHV])")
_GAIN = re.compile(r"[kK]_?([pdiPDI])")
_GAINS = {"p": "proportional", "d": "derivative", "i": "integral"}
_NO_LOAD = re.compile(r"\bno-load (?:speed|rpm|running speed)\b", re.IGNORECASE)
_LONGEST = 4  # words of a name
_SHORTEST_PLURAL = 4  # letters of a word that may be one
_TOKEN = re.compile(r"’\w+|[^\W\d]\w*(?:\.[^\W\d]\w*)?|\d[\w.]*|\s+|.", re.DOTALL)
_BODY_WORDS = ("body", "mass", "element", "member", "part")
_OF_WHAT_IS_LIGHT = ("element", "member", "part")
_OF_A_TRUSS = ("member",)
_JOINT_WORDS = ("joint", "connection", "support")
_EXCITATION = ("excitation", "forcing", "driving", "exciting")
_ROPES = ("rope", "string", "cord", "thread", "cable", "wire")
_RUBBING = ("capstan", "bollard", "rope friction")  # a string that runs on nothing rough is no such thing
_RODS = ("rod", "bar", "strut", "link")
_WHEELS = ("wheel",)
_BRAKES = ("brake", "brakes", "brake shoe", "shoe brake", "block brake", "pad")
_GEARS = ("gear", "gearwheel")
_BALLS = ("ball", "bead")
_WALL_WORDS = ("wall",)
_CEILING = ("ceiling", "foundation")  # what is held by the ground may be held by these
_MIDDLE = "center"
_NEAR = 1e-9  # of a direction to one that is upright
_LINE_WORDS = ("surface", "slope", "incline", "plane")
_POINT_WORDS = ("point", "end")
_WHO_RIDES = ("driver", "rider", "passenger", "passengers", "pilot", "occupant", "cyclist")
_SHORTEST_PART = 4  # letters of a name that is cut short
_PINION = "pinion"  # the smaller of two gears, which is called the wheel only where it is alone
_BEFORE_VERBS = ("to", "will", "would", "can", "could", "must", "should", "may", "might")
_OWN_AXES = ("axes", "frame", "coordinates", "system")
_ONESELF = "I"
_ASKING = ("do", "does", "can", "could", "must", "should", "may", "have", "need", "would", "will", "shall", "want")
_ARTICLES = ("the", "a", "an", "it")


@dataclass(frozen=True)
class Way:
    """The text with names put in, and how far that is from what is written."""

    text: str
    distance: int


def elements_of(names: Names) -> Elements:
    """What can be named in a model."""
    found = Elements(space=names.space)
    sides = (*names.bodies[GROUND].lines, *names.bodies[GROUND].planes)
    found.add(GROUND, () if sides else _CEILING)
    free = [name for name, body in names.bodies.items() if name != GROUND and not body.fixed]
    is_alone, is_still = len(free) == 1, not free
    light = {name for name in free if _is_light(names, name)}
    light = light if len(light) < len(free) else set()  # a truss of light members
    toothed = joining.toothed(names)
    links = [name for name in names.connections if "link" in names.called.get(name, ())]
    nodes = {name for name in free if links and not names.bodies[name].turns and _is_light(names, name)}  # of a truss
    for name, body in names.bodies.items():
        if name != GROUND:
            is_shaft = of_axles.axle_of(names, name) == "center"
            found.pinned |= {name} if of_axles.axle_of(names, name) else set()
            called = (*names.called.get(name, ()), *(_GEARS if name in toothed else ()))  # the ring gear
            kinds = _kinds(name, called, is_shaft=is_shaft, is_alone=is_alone)
            general = () if name in nodes else _OF_WHAT_IS_LIGHT if name in light else _BODY_WORDS
            found.add(name, (*kinds, *(() if body.fixed and not is_still else general)))
            found.bodies |= set() if body.fixed else {name}
            found.turning |= {name} if body.turns and not body.fixed else set()
            mass = names.numeric(body.mass)
            if mass is not None:
                found.masses[name] = mass
            radius = None if body.radius is None else names.numeric(body.radius)
            if radius is not None:
                found.radii[name] = radius
            if isinstance(body.mass, Symbol):  # `mass m1`, `the acceleration of m1`
                found.add(name, said=body.mass.name, distance=INFERRED)
        for point in body.points:
            found.add(f"{name}.{point}", _POINT_WORDS)
            if body.turns or body.fixed or point != _MIDDLE:  # `in the middle` is none of a particle
                found.add(f"{name}.{point}", said=point, distance=INFERRED)
    for point in names.free_ground_points:
        found.add(f"{GROUND}.{point}", _POINT_WORDS)
        found.add(f"{GROUND}.{point}", said=point, distance=INFERRED)
    if (origin := f"{GROUND}.O") not in found.exact:  # which every model has
        found.add(origin, _POINT_WORDS)
        found.add(origin, said="O", distance=INFERRED)
    touching = [
        (name, f"{body} {word}")
        for name, joint in names.connections.items()
        for body in sorted(joint.mentions(names) - {GROUND})
        for word in names.called.get(name, ())
    ]
    said_once = Counter(said for _, said in touching)
    for name in names.connections:
        called = [word for word in names.called.get(name, ()) if word not in _RUBBING or _rubs(names, name)]
        said = (*called, *_stems(name))
        pulls = {*_ROPES} & {*said, name.lower()}
        alike = [word for word in _alike(name, *said) if pulls or word not in _ROPES]  # a guide called line is no rope
        found.add(name, (*said, *alike, *_JOINT_WORDS, *(_OF_A_TRUSS if nodes and name in links else ())))
        found.touching[name] = frozenset(names.connections[name].mentions(names))
    if not any("brake" in element.words for element in found.exact.values()):  # a shoe that rubs a wheel on its axle
        for name in rubbing.on_wheels(names):
            found.add(name, _BRAKES)
    for name, said in touching:  # the bearing of the pulley, where it has one
        if said_once[said] == 1:
            found.add(name, said=said, distance=INFERRED)
    if not any("rope" in element.words for element in found.exact.values()):  # a light rod is told from no thread
        for name in (name for name in names.connections if "link" in names.called.get(name, ())):
            found.add(name, _ROPES)
    for name, said in by_side.by_side(names):
        found.add(name, said=said, distance=INFERRED)
        found.sides.add((said.partition(" ")[0], said.rpartition(" ")[2]))
    found.fields = {name for name in names.loads if "gravity" in names.called.get(name, ())}
    springs = lookup.springs(names)
    for name in (*names.loads, *sorted(names.impulses)):
        said = (*names.called.get(name, ()), *_stems(name), *(("spring", "springs") if name in springs else ()))
        found.add(name, (*said, *_alike(name, *said), *(_ROPES if {*_ROPES} & {*said, name.lower()} else ())))
    for name in (name for name in names.loads if name.lower().startswith("brake")):  # of which a braking torque is one
        kind = "torque" if names.loads[name] == TORQUE else "force"
        found.add(name, said=f"braking {kind}", distance=ALIKE)
    for name in (*names.bodies[GROUND].lines, *names.bodies[GROUND].planes):
        found.add(name, (*_LINE_WORDS, *_alike(name), *(_WALL_WORDS if _is_upright(names, name) else ())))
    for name in (*names.measures, *names.parameters):
        found.add(name)
        if gain := _GAIN.fullmatch(name):  # as control engineers write them
            found.add(name, said=f"{_GAINS[gain[1].lower()]} gain", distance=INFERRED)
    if excitation := lookup.excitation(names):
        for said in _EXCITATION:
            found.add(excitation, said=f"{said} frequency", distance=INFERRED)
    for name, said in motors.called(names):
        found.add(name, said=said, distance=INFERRED)
    for name in of_axles.planets(names):
        found.add(name, ("planet", "planets"))
    heavy = [name for name in found.bodies if names.bodies[name].mass != ZERO]
    if len(heavy) == 1 and not any("load" in element.words for element in found.exact.values()):
        found.add(heavy[0], ("load", "object"))
    if len(heavy) == 1:  # who moves with it feels what it does
        taken = frozenset(word for key in found.spoken for word in key)
        taken = taken.union(*(element.words for element in found.exact.values()))
        found.add(heavy[0], [word for word in _WHO_RIDES if word not in taken])
    found.hanging = strings.hanging(names)
    for name in found.hanging:  # the weights of an Atwood machine
        found.add(name, ("weights",))
    return found


def _rubs(names: Names, string: str) -> bool:
    """Whether a connection is given a coefficient of friction."""
    return str(getattr(names.connections[string], "friction", 0)) not in ("0", "0.0", "{}")


def _is_upright(names: Names, name: str) -> bool:
    """Whether a line or a plane of the ground stands upright, so far as the numbers of the model say."""
    ground, up = names.bodies[GROUND], names.compass["up"].components
    is_line = name in ground.lines
    way = ground.lines[name].direction if is_line else ground.planes[name].normal
    rise = [names.numeric(a * b) for a, b in zip(way.components, up, strict=True)]
    if any(part is None for part in rise):
        return False
    steep = abs(sum(part for part in rise if part is not None))
    return abs(steep - is_line) < _NEAR


def _is_light(names: Names, name: str) -> bool:
    """Whether a body neither has a mass nor resists turning: a frame between two axes."""
    body = names.bodies[name]
    return all(own == ZERO for own in (body.mass, body.inertia, *body.tensor))


def _kinds(name: str, words: Sequence[str], *, is_shaft: bool, is_alone: bool) -> Sequence[str]:
    """What a thing may be called: as its name says and, of the words for its shape, by those that do not contradict:
    one whose name says that it is a block is no cart; a bead that alone moves (is_alone) may be called ball. What
    turns about an axle in its middle (is_shaft) is a wheel of some kind, or a rod."""
    said = {*re.split(r"[\W_\d]+", name.lower()), *_stems(name)} - {""}
    own = [kinds for kinds in kinds_apart() if kinds & said]
    own = own or [kinds for kinds in kinds_apart() if is_shaft and kinds & {*_WHEELS, *_RODS}]
    alike = [kinds for kinds in kinds_apart() if is_alone and kinds & {*_BALLS}]  # no other is taken for it
    own += alike if any(kinds in alike for kinds in own) else []
    others = frozenset[str]().union(*(kinds for kinds in kinds_apart() if own and kinds not in own))
    words = [word for word in words if word not in others]
    as_well = frozenset[str]().union(*(kinds for kinds in things_alike() if kinds & {*words, *said}))
    return [word for word in dict.fromkeys((*words, *sorted(said), *sorted(as_well))) if word not in others]


def _alike(*said: str) -> list[str]:
    """Words for the things that a name, or words for its kind, say."""
    own = {word.lower() for word in said}
    return sorted(frozenset[str]().union(*(kinds for kinds in things_alike() if own & kinds)))


def _stems(name: str) -> list[str]:
    """A name without the number at its end, where it is a word: spring2 is a spring."""
    stem = name.rstrip("0123456789_").lower()
    return [stem] if stem != name.lower() and stem.isalpha() and len(stem) > 2 else []


def linked(elements: Elements, text: str) -> list[Way]:
    """The text with names put in, in every way that its words can be meant, the nearest to what is written first; none
    where what tells a body from others tells no one."""
    told = told_apart(elements, text)
    if told is None:
        return []
    if (*motors.NO_LOAD.split(), "speed") in elements.spoken:
        told = _NO_LOAD.sub(f"{motors.NO_LOAD} speed", told)
    tokens: list[str] = _TOKEN.findall(told)
    begun = f"{tokens[0][:1].lower()}{tokens[0][1:]}" if tokens else ""
    if tokens and tokens[0] not in elements.exact and begun in elements.exact:  # Drive force at t = 1 s
        tokens[0] = begun
    ways = list(islice(_linked(elements, tokens, 0, Way("", 0)), MOST))
    return sorted(ways, key=lambda way: way.distance)


def _linked(elements: Elements, tokens: Sequence[str], k: int, so_far: Way) -> Iterator[Way]:
    if k >= len(tokens):
        yield so_far
        return
    if tokens[k] == OPEN and CLOSE in tokens[k:]:  # a name that is marked already
        end = tokens.index(CLOSE, k) + 1
        yield from _linked(elements, tokens, end, Way(so_far.text + "".join(tokens[k:end]), so_far.distance))
        return
    for shown, n, distance in _readings(elements, tokens, k):
        yield from _linked(elements, tokens, k + n, Way(so_far.text + shown, so_far.distance + distance))


def _readings(elements: Elements, tokens: Sequence[str], k: int) -> Iterator[tuple[str, int, int]]:
    """What stands at a token: the marked name of an element or the token itself, the number of tokens, the distance."""
    is_unit = k > 1 and tokens[k - 2][0].isdigit() and not tokens[k - 1].strip()
    if is_unit or not re.match(r"[^\W\d]", tokens[k]):
        yield tokens[k], 1, WRITTEN
        return
    around = tokens[k - 2].lower() if k > 1 else "", tokens[k + 2].lower() if k + 2 < len(tokens) else ""
    if around[0] in _BEFORE_VERBS and around[1] in _ARTICLES and is_verb(tokens[k].lower()):
        yield tokens[k], 1, WRITTEN  # the force to lower the load, where a pulley is called lower
        return
    if tokens[k].lower() == "body" and around[1] in _OWN_AXES:
        yield tokens[k], 1, WRITTEN  # its body axes are no body
        return
    if tokens[k] == _ONESELF and (around[0] in _ASKING or around[1] in _ASKING):
        yield tokens[k], 1, WRITTEN  # which torque do I need, where I is a moment of inertia
        return
    if tokens[k] == "a" and (around[1] in quantity_words(ENGLISH) or (around[1],) in elements.spoken):
        yield tokens[k], 1, WRITTEN  # with a push of 120 N, though a is a length
        return
    seen: dict[str, int] = {}
    for n in range(_LONGEST, 0, -1):
        window = tokens[k : k + 2 * n - 1]
        if len(window) < 2 * n - 1 or any(token.strip() for token in window[1::2]):
            continue
        if n > 1 and tokens[k + 2 * n : k + 2 * n + 1] == ["to"] and is_verb(window[-1].lower()):
            continue  # the ladder starts to slide
        named = list(_named(elements, window[::2]))
        is_rope = n == 2 and tokens[k] in elements.bodies and window[-1].lower() in (*_ROPES, *_RODS)
        if is_rope and not named and (near := _ropes_at(elements, tokens[k], window[-1])):
            named = _told_by_others(elements, tokens[k], near)
            if not named:
                return  # the lower rope, where two of them are at the lower pulley
        for name, distance in named:
            if name not in seen:
                seen[name] = distance
                yield f"{OPEN}{name}{CLOSE}", len(window), distance
        if seen:
            break
    if not seen and (component := _COMPONENT.fullmatch(tokens[k])) and component[1] in elements.exact:
        yield f"{OPEN}{component[1]}{CLOSE}{component[2]}", 1, WRITTEN  # `A_y`: of the reaction at A
        return
    is_thing = bool(seen) and all(distance >= INFERRED and "." not in name for name, distance in seen.items())
    if is_thing and k > 1 and tokens[k - 2].lower() == "the" and _is_noun(tokens[k : k + 3 : 2]):
        return  # the lift at rest
    if seen and stands_for_all(tokens[k].lower()):
        return  # the machine, where a body is called so
    is_other = tells_apart(tokens[k].lower(), ENGLISH)  # the first impact, where a domino is called first
    if tokens[k] in elements.exact and around[0] == "the" and is_left_out(tokens[k]) and not is_other:
        return  # the person, where something is called so, is not anybody
    is_article = tokens[k] == "a" and "".join(tokens[k + 2 : k + 3]).isalpha()  # a full turn, though a is a length
    is_word = tokens[k].isalpha() and tokens[k].islower() and (len(tokens[k]) > 1 or is_article)
    if not seen or is_word or tokens[k] not in elements.exact:
        yield tokens[k], 1, WRITTEN if tokens[k] not in elements.exact else ALIKE


def _ropes_at(elements: Elements, body: str, word: str) -> list[tuple[str, int]]:
    """The ropes at a body whose name tells which of several is meant: the lower one."""
    ropes = [one for one in _named(elements, [word]) if one[0] in elements.touching]
    return [one for one in ropes if body in elements.touching[one[0]]] if tells_apart(body.lower(), ENGLISH) else []


def _told_by_others(elements: Elements, beside: str, ropes: list[tuple[str, int]]) -> list[tuple[str, int]]:
    """Of several ropes at the body that tells which is meant, the one that no other body tells alone: the lower rope,
    where the upper one is at the lower pulley as well."""
    here = [name for name, _ in ropes]
    others = [body for body in elements.bodies if body != beside and tells_apart(body.lower(), ENGLISH)]
    told = [[name for name in here if body in elements.touching[name]] for body in others]
    taken = {found[0] for found in told if len(found) == 1 < len(here)}
    left = [one for one in ropes if one[0] not in taken]
    return left if len(left) == 1 else []


def _is_noun(tokens: Sequence[str]) -> bool:
    """Whether a word behind an article, which could be a verb, is none: the lift, but not the rolling ball."""
    word, after = tokens[0].lower(), tokens[1].lower() if len(tokens) > 1 else ""
    return is_verb(word) and not word.endswith("ing") and after not in quantity_words(ENGLISH)


def _named(elements: Elements, written: Sequence[str]) -> Iterator[tuple[str, int]]:
    """Elements that all of some words name, and how far they are from it."""
    words = tuple(word.lower() for word in written)
    meant = elements.spoken.get(words, [])
    if len(words) > 1:  # `wrist pin` for wristpin
        meant = [*elements.spoken.get(("".join(words),), []), *meant]
    as_written = [found for found in meant if found[1] == " ".join(written)] if len(words) == 1 else []
    if len(words) == 1 and len(words[0]) < 3:
        meant = [one for one in meant if one[1].replace("_", "") == written[0]]  # m is not M, but v0 may be v_0
    for element, text, distance in as_written or meant:
        yield element.name, distance + (WRITTEN if text == " ".join(written) else ALIKE)
    if len(words) > 1 and not meant:  # the half ring
        said = " ".join(words)
        yield from ((e.name, INFERRED) for e in elements.exact.values() if "." not in e.name and said in e.words)
    if len(words) == 1 and not as_written:  # every thing of a kind
        of_kind = [e for e in elements.exact.values() if "." not in e.name and words[0] in e.words]
        of_kind = [e for e in of_kind if _PINION not in e.name.lower()] or of_kind  # the wheel that it drives
        own = [e for e in of_kind if words[0] in e.name.lower()]  # the block among blocks and boxes
        own = own or [e for e in of_kind if len(e.name) > 2 and words[0].endswith(e.name.lower())]  # turntable
        own = own or [e for e in of_kind if words[0] in _alike(e.name)]  # the elevator among them is the cabin
        yield from ((element.name, INFERRED) for element in own or of_kind)
        if not (meant or of_kind) and words[0].endswith("s") and len(words[0]) > _SHORTEST_PLURAL:
            one = words[0][:-1]  # the hinges of a door that has one
            of_one = [e.name for e in elements.exact.values() if one == e.name.lower() or one in e.words]
            yield from ((name, INFERRED) for name in of_one if len(of_one) == 1)
        if not (meant or of_kind) and len(words[0]) >= _SHORTEST_PART and not is_in_language(words[0]):
            whole = (name for name in elements.exact if "." not in name)
            begun = [name for name in whole if name.lower().startswith(words[0])]
            yield from ((name, INFERRED) for name in begun if len(begun) == 1)  # the loco
    for k in range(1, len(words)):  # a name beside the word for its kind; `the bead lift off` has a verb
        behind = [] if is_verb(words[k]) else [(written[:k], words[k:])]
        for rest, kind in (*behind, (written[k:], words[:k])):
            for element, text, _distance in elements.spoken.get(tuple(w.lower() for w in rest), []):
                if " ".join(kind[1:] if kind[:1] == ("side",) else kind) in element.words:
                    yield element.name, WRITTEN if text == " ".join(rest) else ALIKE


def plain_names(text: str) -> str:
    """The text without the marks of names."""
    return text.replace(OPEN, "").replace(CLOSE, "")
