"""Energies, momenta, periods and what else is asked of a whole system, in the grammar."""

from __future__ import annotations

import re
from itertools import product
from typing import TYPE_CHECKING

from freebody.language.expression import ZERO, free_symbols
from freebody.measures.distance import Distance
from freebody.measures.geometry import GROUND
from freebody.questions.spoken import driving, given, joining, lookup, losing, of_axles, rubbing, transmitting
from freebody.questions.spoken.composing import ALONG, JOINT, SILENT, Groups, said_of
from freebody.questions.spoken.keeping import n_freedoms
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.of_motion import motion
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_EULER = 3  # angles of a body that is turned as a top is
_OF_BEATS = 2  # natural frequencies


@said_of("kinetic energy", "potential energy", "total energy")
def _energy(names: Names, quantity: str, rest: Clause) -> Groups:
    of = [name for _, name in rest.names]
    if rest.only("name", *SILENT) and len(of) <= 1:
        yield [" of ".join((quantity, *of))]


@said_of("rotational energy", "translational energy")
def _share(names: Names, quantity: str, rest: Clause) -> Groups:
    """Of what turns about its centre all energy is rotational; of what turns about another axle it is left open about
    which point it is meant."""
    of = [name for _, name in rest.names]
    axles = {of_axles.axle_of(names, name) for name in of or lookup.moving(names)}
    if axles == {"center"} and quantity == "rotational energy":
        yield from _energy(names, "kinetic energy", rest)
    elif axles == {""}:
        yield from _energy(names, quantity.replace(" ", " kinetic "), rest)


@said_of("energy")
def _whole_energy(names: Names, quantity: str, rest: Clause) -> Groups:
    yield from _energy(names, "total energy", rest)


@said_of("linear momentum", "angular momentum")
def _momentum(names: Names, quantity: str, rest: Clause) -> Groups:
    about = [joining.pinned_at(names, name) for before, name in rest.names if before in ("about", "relative")]
    along = [name for before, name in rest.names if before in ("along", "up", "down")]
    along += [ALONG[part] for part in rest.all("part") if part in ALONG]
    of = [name for before, name in rest.names if before not in ("about", "relative", "along", "up", "down")]
    frames = [name for before, name in rest.names if before == "in" and name in of[1:] and names.space]
    of = [name for name in of if name not in frames]
    if not rest.only("name", "part", *SILENT) or len(about) > 1 or len(along) > 1 or (about and quantity[0] == "l"):
        return
    ends = (
        [f" in {name}" for name in frames] + [f" about {name}" for name in about] + [f" along {name}" for name in along]
    )
    whose = f" of {' and '.join(of)}" if of else ""
    size = "size of " if rest.has("part", "size") else ""
    yield [f"{size}{quantity}{whose}{''.join(ends)}"]


@said_of("moment of inertia", "radius of gyration")
def _inertia(names: Names, quantity: str, rest: Clause) -> Groups:
    """Of what is named, about a joint or a point of it that is named, else about its mass centre."""
    named = [(before, name.removesuffix(".mass_center")) for before, name in rest.names]
    about = [name for before, name in named if before in ("about", "relative") or name not in names.bodies]
    of = [name for _, name in named if name not in about]
    if names.space and rest.has("part", "vertical") and not about:  # of what turns about an axle through its centre
        plain = rest.without("part", "vertical").only("name", *SILENT)
        bodies = [body for body in of or lookup.massive(names)[:1] if of_axles.axle_of(names, body) == "center"]
        yield [f"{quantity} of {body} along up" for body in bodies if plain]
        return
    if not rest.only("name", "pronoun", *SILENT) or len(about) > 1 or any(before == "along" for before, _ in named):
        return
    if Word("preposition", "about") in rest.words and not about and not rest.has("pronoun", "mass_center"):
        bodies = of or lookup.massive(names)[:1]  # about its pivot
        about = [
            name for name in of_axles.axles(names) if names.connections[name].mentions(names) - {GROUND} == {*bodies}
        ]
        if len(about) != 1:
            return
    own = [name.partition(".")[0] for name in about if name.partition(".")[0] in names.bodies]
    of = of or [name for name in own if name != GROUND] or lookup.massive(names)[:1]
    where = "".join(f" about {name}" for name in about)
    yield [f"{quantity} of {' and '.join(of)}{where}"]


@said_of("period")
def _period(names: Names, quantity: str, rest: Clause) -> Groups:
    of = [name for _, name in rest.names]
    if rest.has("part", "small"):
        yield ["period of small oscillations"]
    elif rest.only("name", *SILENT) and len(of) <= 1:
        if of and of[0] in names.measures:
            yield [f"period of {of[0]}"]
        else:
            yield ["period of the motion" if lookup.swings(names) else "period of small oscillations"]
            own = dict.fromkeys((*lookup.angles(names, of[0]), *lookup.hung(names, of[0]))) if of else {}
            yield (
                [f"period of {name}" for name in own]
                if not lookup.is_all_that_moves(names, of[0] if of else "")
                else []
            )


@said_of("equilibrium")
def _equilibrium(names: Names, quantity: str, rest: Clause) -> Groups:
    of = [name for _, name in rest.names]
    if not rest.only("name", *SILENT) or len(of) > 1:
        return
    own = (lookup.places, lookup.angles, lookup.hung)
    measures = [name for find in own for name in find(names, of[0])] if of else lookup.measured(names)
    yield [f"equilibrium of {name}" for name in dict.fromkeys(measures)]


@said_of("free amplitude")
def _free_amplitude(names: Names, quantity: str, rest: Clause) -> Groups:
    """Half of the way between both ends of a vibration that nothing forces; else the steady one."""
    of = [name for _, name in rest.names]
    if lookup.is_forced(names):
        yield from _of_coordinate(names, "steady amplitude", rest)
    elif rest.only("name", *SILENT) and len(of) <= 1 and not losing.damped(names) and not rubbing.is_rough(names):
        measures = [*lookup.places(names, next(iter(of), "")), *lookup.angles(names, next(iter(of), ""))]
        yield [f"(greatest {name} - least {name})/2" for name in measures]


@said_of("amplitude decay", "amplitude loss")
def _decay(names: Names, quantity: str, rest: Clause) -> Groups:
    """One amplitude over the next, of which the decrement is the logarithm; or what is lost of the first."""
    if rest.only("name", *SILENT) and len(rest.names) <= 1:
        yield ["exp(logarithmic decrement)" if quantity == "amplitude decay" else "1 - exp(-logarithmic decrement)"]


@said_of("beat period", "beat frequency")
def _beats(names: Names, quantity: str, rest: Clause) -> Groups:
    """Of two vibrations that run beside each other: by the difference of both natural frequencies."""
    if rest.only("name", *SILENT) and not rest.names and n_freedoms(names) == _OF_BEATS:
        apart = "highest natural frequency - lowest natural frequency"
        yield [f"2*pi/({apart})" if quantity == "beat period" else apart]


@said_of("cycles per second")
def _cycles(names: Names, quantity: str, rest: Clause) -> Groups:
    """One over the period."""
    for group in _period(names, "period", rest):
        yield [f"1/({text})" for text in group]


@said_of(
    "stroke", "time ratio", "extremes", "steady amplitude", "phase lag", "resonance frequency", "magnification factor"
)
def _of_coordinate(names: Names, quantity: str, rest: Clause) -> Groups:
    """What is asked of the place of something: its stroke, its time ratio."""
    of = [name for _, name in rest.names if name not in names.parameters]  # the speed Omega at which it resonates
    if quantity == "steady amplitude" and not lookup.is_forced(names):
        return
    pace = [name for _, name in rest.names if name in names.parameters]
    if quantity == "resonance frequency" and pace:  # the speed n, or that of a car on a wavy road
        for group in _of_coordinate(names, "steady amplitude", rest.without("name", *pace)):
            yield [f"value of {name} for which {text} is largest" for text in group for name in pace]
        return
    if not of and quantity in lookup.FORCED and rest.only("name", *SILENT):
        driven = driving.driven(names)  # an angle that goes round evenly does not swing
        yield [f"{quantity} of {name}" for name in names.measures if name not in driven]
    if not of and quantity in ("stroke", "time ratio") and rest.only(*SILENT):
        angles = [name for name in lookup.angles(names, "") if name not in driving.driven(names)]
        yield [
            f"{quantity} of {name}" for name in lookup.places(names, "") or (angles if driving.driven(names) else [])
        ]
    if len(of) == 1 and rest.only("name", "instant", *SILENT):
        measures = lookup.places(names, of[0]) or lookup.angles(names, of[0])
        measures = measures or ([f"angle of {of[0]}"] if of_axles.axle_of(names, of[0]) else [])
        yield [f"{quantity} of {name}" for name in measures]
        guides = [] if measures else joining.guides(names, of[0])
        yield [f"{quantity} of position of {of[0]} along {guide}" for guide in guides]


@said_of("critical damping")
def _critical_damping(names: Names, quantity: str, rest: Clause) -> Groups:
    """Of the parameter of the only damper, or of the one that is named."""
    of = [name for _, name in rest.names]
    if rest.only("name", *SILENT) and len(of) <= 1:
        laws = [p.law for p in names.applied_loads if p.load in losing.damped(names)]
        strengths = dict.fromkeys(name for law in laws for name in free_symbols(law) if name in names.parameters)
        yield [f"critical damping of {name}" for name in strengths if not of or name == of[0] or of[0] in names.loads]


@said_of("dead points")
def _dead_points(names: Names, quantity: str, rest: Clause) -> Groups:
    """Of what is measured of something that is named, or of itself."""
    of = [name for _, name in rest.names]
    if not of and rest.only(*SILENT):
        yield [f"dead points of {name}" for name in lookup.places(names, "")]
    if len(of) == 1 and rest.only("name", *SILENT):
        yield [f"dead points of {name}" for name in lookup.places(names, of[0]) or of]
        yield [f"dead points of {of[0]}"]


@said_of("transmissibility")
def _transmissibility(names: Names, quantity: str, rest: Clause) -> Groups:
    """To what is named; or from the only measure that is driven to the only other one; from the force that shakes to
    that of all springs and dampers on the ground."""
    of = [name for _, name in rest.names]
    driven = driving.driven(names)
    others = [name for name in names.measures if name not in driven]
    if len(of) == 1 and rest.only("name", *SILENT):
        yield [f"transmissibility to {of[0]}"]
    elif not of and rest.only(*SILENT) and len(driven) == len(others) == 1:
        yield [f"transmissibility from {driven[0]} to {others[0]}"]
    elif not of and rest.only(*SILENT) and not driven and (pressing := transmitting.through_springs(names)):
        whole = " + ".join(f"force in {name}" for name in pressing)
        yield [f"transmissibility to ({whole})"] if lookup.is_forced(names) else []


@said_of("terminal velocity", "terminal angular velocity")
def _terminal(names: Names, quantity: str, rest: Clause) -> Groups:
    """To what a velocity tends; what turns about its centre has no other than that of turning. What nothing keeps from
    going ever faster has the last one where its motion ends."""
    turns = any(of_axles.axle_of(names, name) == "center" for _, name in rest.names) or quantity.endswith(
        "angular velocity"
    )
    of = next((name for _, name in rest.names), "")
    ends = losing.at_the_end(names, of)
    goes = "speed" if of in names.bodies and not rest.has("direction") else "velocity"  # of a body its size
    for group in motion(names, "angular velocity" if turns else goes, rest):
        yield [f"{text} when {end}" for end in ends or ["t grows"] for text in group]


_RATIO = re.compile(
    r"^ratio of (?:rate|velocity|angular velocity) of (\w+) to (?:rate|velocity|angular velocity) of (\w+)$"
)


def _asked_ratio(names: Names, of: list[str]) -> str:
    """The only ratio of velocities that the file itself asks for, where it is of both things that are named:
    the shaft turns, and the load, which could turn as well, is lifted."""
    asked = [found for question in names.usual_questions if (found := _RATIO.match(question)) is not None]
    if len(asked) != 1:
        return ""
    owners = [names.measures[name].bodies() if name in names.measures else (name,) for name in asked[0].groups()]
    is_of = [any(thing in (name, *own) for name, own in zip(asked[0].groups(), owners, strict=True)) for thing in of]
    return asked[0][0] if len(of) == 2 and all(is_of) and of[0] in (asked[0][1], *owners[0]) else ""


def _only_goes(names: Names, body: str) -> bool:
    """Whether what is measured of a body is where it is, and not how it is turned, though it could turn as well."""
    is_turned = bool(of_axles.axle_of(names, body) or lookup.angles(names, body))
    return bool(lookup.places(names, body)) and not is_turned


@said_of("gear ratio")
def _gear_ratio(names: Names, quantity: str, rest: Clause) -> Groups:
    """How fast one body turns for another: of the two that are named; of the only two both ways, for which is meant
    custom leaves open."""
    of = [lookup.acted_on(names, name) for _, name in rest.names if name not in names.connections]
    if not rest.only("name", *SILENT):
        return
    if asked := _asked_ratio(names, of):
        yield [asked]
        return
    for first, second in [of] if len(of) == 2 else []:
        lifted = [name for name in (first, second) if _only_goes(names, name)]
        if len(lifted) == 1:  # the shaft turns, and the load is lifted: no ratio of what turns
            return
        if {first, second} <= {*lookup.turning(names)} or not {first, second} <= {*lookup.moving(names)}:
            yield [f"ratio of angular velocity of {first} to angular velocity of {second}"]
            continue
        for a, b in product(lookup.places(names, first), lookup.places(names, second)):
            yield [f"ratio of velocity of {a} to velocity of {b}"]
    two = [name for name in lookup.turning(names) if of_axles.axle_of(names, name) or names.space] if not of else []
    if len(two) > 2:  # of a train: its first and its last wheel
        driving = ("tooth force", "belt force", "chain force")
        meshes = dict.fromkeys(row.connection for row in names.constraint_rows if row.reaction in driving)
        two = [name for name in two if sum(joining.touches(names, mesh, name) for mesh in meshes) == 1]
    if len(two) == 2:
        both = (f"ratio of angular velocity of {a} to angular velocity of {b}" for a, b in (two, two[::-1]))
        yield [JOINT.join(both)]


@said_of("efficiency")
def _efficiency(names: Names, quantity: str, rest: Clause) -> Groups:
    """Of a screw or a worm that is named, or of the only one; else of the teeth, which is told what they lose."""
    of = [name for _, name in rest.names]
    known = names.bodies.keys() | names.connections.keys()
    if rest.only("name", *SILENT) and len(of) <= 2 and known.issuperset(of):
        meshes = [row.connection for row in names.constraint_rows if row.reaction == "tooth force"]
        meshes = [name for name in meshes if all(joining.touches(names, name, thing) for thing in of)]
        named = [name for name in of if name in names.connections]  # itself, and not what it is beside
        found = joining.threads(names, of) or meshes[:1]
        yield [f"efficiency of {name}" for name in found if not named or name in named]


@said_of("mechanical advantage")
def _advantage(names: Names, quantity: str, rest: Clause) -> Groups:
    """Of a load to an effort: of two that are named, or of the only weight to the only drive."""
    of = [name for _, name in rest.names if name in names.loads]
    effort = lookup.driving(names)
    weights = [name for name in names.loads if "gravity" in names.called.get(name, ())]
    if rest.only("name", *SILENT) and len(of) == 2:
        yield [f"mechanical advantage of {of[0]} to {of[1]}"]
    elif rest.only("name", *SILENT) and len(names.loads) == 2 and len(effort) == len(weights) == 1:
        yield [f"mechanical advantage of {weights[0]} to {effort[0]}"]


@said_of("conserved quantities")
def _conserved(names: Names, quantity: str, rest: Clause) -> Groups:
    """What of energy and momentum stays as it is."""
    if rest.only("pronoun", *SILENT):
        momenta = ("along right", "along up") if not names.space else ()
        about = "" if not names.space else " along up"
        asked = ["total energy", *(f"linear momentum {way}" for way in momenta), f"angular momentum{about}"]
        yield [JOINT.join(f"is {text} conserved" for text in asked)]


@said_of("escape velocity", "circular orbit speed")
def _orbit(names: Names, quantity: str, rest: Clause) -> Groups:
    """The speed at the start with which it never comes back, or goes round in a circle: no energy, no acceleration
    outwards."""
    drawn = [name for name in names.loads if "attraction" in names.called.get(name, ())]
    if not rest.only("name", *SILENT):
        return
    named = [name for _, name in rest.names if name in names.parameters]
    if len(drawn) != 1 or {*names.loads} - {*drawn}:
        if quantity == "circular orbit speed":
            yield from _round_the_vertical(names, named)
        return
    found = given.started_with(names, [*lookup.moving(names), *names.start_rates])
    found = [name for name in named or found if name in found]
    outward = [name for name, measure in names.measures.items() if isinstance(measure, Distance)]
    if len(found) == 1:
        what = ["total energy"] if quantity == "escape velocity" else [f"acceleration of {name}" for name in outward]
        yield [f"value of {found[0]} for which {text} = 0 at start" for text in what]


def _round_the_vertical(names: Names, named: list[str]) -> Groups:
    """With which start something goes round steadily: its only coordinate that starts at rest, beside one that does
    not, stays as it is."""
    going = {name: rate for name, rate in names.start_rates.items() if rate != ZERO}
    still = [name for name in names.placed_at_start if name in names.measures and name not in going]
    chosen = frozenset[str]().union(*map(free_symbols, going.values()))
    speeds = [name for name in named or given.of_kind(names, "speed") if name in chosen]
    if len(going) == len(still) == len(speeds) == 1:
        yield [f"value of {speeds[0]} for which {still[0]} stays constant"]


@said_of(*(f"{far}node of mode {k}" for k in (1, 2, 3) for far in ("", "distance of ")))
def _node(names: Names, quantity: str, rest: Clause) -> Groups:
    """Of a body, from its mass centre or another point of it."""
    of = [name for before, name in rest.names if before != "from"]
    origin = [name for before, name in rest.names if before == "from"]
    if rest.only("name", "pronoun", *SILENT) and len(of) <= 1 and len(origin) <= 1:
        bodies = [name for name in of if name in names.bodies]
        yield [" of ".join((quantity, *bodies)) + "".join(f" from {name}" for name in origin)]


@said_of("spin rate")
def _spin(names: Names, quantity: str, rest: Clause) -> Groups:
    """The rate of the last of the angles by which a body is turned, about its own axis; the only one in a plane."""
    if not names.space:
        yield from motion(names, "angular velocity", rest)
        return
    of = [name for _, name in rest.names]
    if rest.only("name", *SILENT) and len(of) <= 1:
        chains = [names.bodies[body].chain for body in (of or lookup.moving(names)) if body in names.bodies]
        yield [f"velocity of {chain[-1].name}" for chain in chains if len(chain) > 1 and chain[0].axis == names.up]


@said_of("precession rate", "nutation rate")
def _precession(names: Names, quantity: str, rest: Clause) -> Groups:
    """The rate of the first, or the second, of the angles by which a body is turned from the ground."""
    of = [name for _, name in rest.names if name not in names.measures]
    named = [name for _, name in rest.names if name in names.measures]
    if not names.space or not rest.only("name", *SILENT) or len(of) + len(named) > 1:
        return
    k = 0 if quantity == "precession rate" else 1
    chains = [names.bodies[body].chain for body in (of or lookup.moving(names)) if body in names.bodies]
    angles = named or [chain[k].name for chain in chains if len(chain) == _EULER and chain[0].axis == names.up]
    if not angles and k == 0:  # of what carries the rest round
        angles = [chain[0].name for chain in chains if chain and chain[0].axis == names.up]
    yield [f"velocity of {angle}" for angle in angles]
