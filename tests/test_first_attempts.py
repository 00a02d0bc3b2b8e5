"""What people write first: one mistake is one message, with the cause and what to write, in their own names."""

from __future__ import annotations

import math
from typing import Any

import pytest

import freebody as fb
from freebody.language.expression import evaluate
from freebody.loads.base import Load
from freebody.model.elements import RigidBody

ROD = "bodies: {rod: {rod: {mass: 2 kg, length: 1 m}}}\n"
BLOCK = "bodies: {block: {particle: {mass: 1 kg}}}\n"
MISTAKES = {
    "units for the whole file": (
        f"{BLOCK}units: mm, kg, N",
        "each number has its own unit, as 1500 mm or 10 kg; one without is in SI units: leave units out",
    ),
    "a distance along a rod": (
        f"{ROD}connections: {{s: {{pin: [ground.O, rod at 0.2 m]}}}}",
        "rod at 0.2 m is no point: declare it, by its distance from the middle of rod: rod: {points: {P: [0.2 m - "
        "(1/2), 0]}} where 0.2 m counts from rod.start, and write rod.P",
    ),
    "gains without units": (
        "parameters: {kp: 10, kd: 3}\nbodies: {arm: {disk: {mass: 1 kg, radius: 1 m}}}\nmeasures: {phi: angle of arm}\n"
        "connections: {O: {pin: [ground.O, arm]}}\n"
        "loads: {motor: {torque: {on: arm, magnitude: -kp*phi - kd*rate(phi)}}}",
        "in '-kp*phi - kd*rate(phi)' kp and kd must have units: write kp: 10 N m, kd: 3 N m s under parameters",
    ),
    "a band brake": (
        "bodies: {drum: {disk: {radius: 1 m}}}\nconnections: {b: {band_brake: {drum: drum, friction: 0.3}}}",
        "band_brake is no kind of connection: the band is a string with friction: string: {from: ground.A, over: "
        "[drum], to: lever.P, friction: {drum: mu}}, its angle on the drum, where its leads do not tell, "
        "wrap: {drum: 180 deg}",
    ),
    "a cone clutch": (
        "bodies: {a: {disk: {radius: 1 m}}}\nconnections: {b: {cone_clutch: {between: [a, ground]}}}",
        "cone_clutch is no kind of connection: it is a disc_clutch with the angle between its faces and the "
        "axis beside the rest: cone_angle: 12 deg",
    ),
    "an eccentric disk": (
        "bodies: {cam: {disk: {radius: 1 m, eccentricity: 0.1 m}}}",
        "disk has no eccentricity: an axle beside its middle is a point of it, at which it is pinned: beside the disk "
        "points: {axle: [-e, 0]}",
    ),
    "a rough line": (
        f"{BLOCK}ground: {{surfaces: {{floor: {{angle: 0, friction: 0.3}}}}}}",
        "a line has no friction: that is of contact: {between: [BODY, floor], friction: 0.3}",
    ),
    "a contact of two particles": (
        "bodies: {A: {particle: {mass: 1 kg}}, B: {particle: {mass: 1 kg}}}\n"
        "connections: {hit: {contact: {between: [A, B], restitution: 0.5}}}",
        "A and B are points, and two points do not touch: give one of them a size (a disk, a rectangle), or guide "
        "both along one line, each by a slider: {body: A, along: right}",
    ),
    "a string on a part of a drum": (
        "ground: {points: {O: [0, 0]}}\n"
        "bodies: {drum: {body: {inertia: 1 kg m^2, radius: 1 m}}, A: {particle: {mass: 1 kg}}}\n"
        "connections: {axle: {pin: [ground.O, drum]}, rope: {string: {path: [A, wound on drum.hub at right]}}}",
        "a string runs round a body, not round a part of it: in place of drum.hub write drum, and for another circle "
        "than its rim its radius, as in 'drum radius r'",
    ),
    "a contact of a point that there is not": (
        f"ground: {{points: {{C: [0, 0]}}}}\n{ROD}"
        "connections: {step: {contact: {between: [ground.C, rod.axis]}}}",
        "rod has no point axis. Its ends are rod.start and rod.end, in its middle is rod.center. Points of your own: "
        "rod: {points: {axis: [x, y]}}",
    ),
    "a plural of a unit": (
        "bodies: {block: {particle: {mass: 2 kgs}}}",
        "the unit 'kgs' is not known: write kg, or kg s for kg times seconds",
    ),
    "parameters made of each other": (
        "parameters: {a: {value: 3*b/2}, b: a/3}\n" + ROD.replace("1 m", "a"),
        "a, b are formulas of each other; give a number for one",
    ),
    "a parameter made of another and of a value with its unit": (
        "parameters: {r: 0.1 m, R: r + 5 cm}\nbodies: {w: {disk: {mass: 1 kg, radius: R}}}",
        "in 'r + 5 cm' every value with a unit needs a name: a parameter",
    ),
    "a parameter made of one that there is not": (
        "parameters: {r: 0.1 m, R: 2*q, J: R/2}\nbodies: {w: {disk: {mass: 1 kg, radius: J}}}",
        "q in '2*q' is not a parameter. There is: r. Add it under parameters, e.g. q: 1",
    ),
    "a parameter made of others that do not fit": (
        "parameters: {r: 0.1 m, M: 1 kg, R: r + M}\nbodies: {w: {disk: {mass: M, radius: R}}}",
        "in 'r + M': r [m] + M [kg]: unlike units cannot be added",
    ),
    "the value of what is short for a formula": (
        "parameters: {r: 0.1 m, R: 2*r}\nbodies: {w: {disk: {mass: 1 kg, radius: R}}}\n"
        "questions: [value of R for which kinetic energy = 1 J]",
        "R is short for a formula of r: ask for what stands in it",
    ),
    "no colon behind a name": (
        "bodies:\n  rod {rod: {mass: 2 kg, length: 1 m}}  # the rod",
        "a colon is missing after rod: rod: {rod: {mass: 2 kg, length: 1 m}}",
    ),
    "two shapes": (
        "bodies: {it: {rod: {mass: 2 kg, length: 1 m}, disk: {mass: 1 kg, radius: 1 m}}}",
        "it has more than one shape: rod and disk. Keep one; a body of several parts is a composite",
    ),
    "a start of no measure": (
        f"{ROD}start: {{phi: 1 rad}}",
        "phi is no named measure or rate of one. Say what it is, e.g. measures: {phi: angle of rod from down}, or from "
        "right",
    ),
    "a start of no measure of a particle": (
        f"{BLOCK}start: {{s: 1 m}}",
        "s is no named measure or rate of one. Say what it is, e.g. measures: {s: x of block}",
    ),
    "a floor beside the lines": (
        f"ground: {{floor: true}}\n{BLOCK}connections: {{c: {{contact: [block, floor]}}}}\n"
        "questions: [normal force of c]",
        "a line of the ground stands under lines: ground: {lines: {floor: {along: right}}}",
    ),
    "decimal commas in a list": (
        f"ground: {{points: {{A: [1,5 m, 2 m]}}}}\n{ROD}connections: {{p: {{pin: [ground.A, rod.start]}}}}",
        "a comma separates entries; write a point: 1.5 m",
    ),
    "a force on a body, twice": (
        f"{BLOCK}loads: {{F: {{force: {{on: block, at: block, along: right, magnitude: 10 N}}}}}}",
        "force has no on. Did you mean at?",
    ),
    "a word for a shape that is misspelt": (
        "bodies: {crate: {blok: {mass: 1 kg}}}",
        "a body has no blok. Did you mean block?",
    ),
    "a contact that is misread, and a question about what it does": (
        f"ground: {{lines: {{floor: {{along: right}}}}}}\n{BLOCK}"
        "connections: {touch: {contact: {between: [block, floor], frction: 0.2}}}\nquestions: [normal force, find N]",
        "contact has no frction. Did you mean friction?",
    ),
    "a rope that ends on the drum over which it runs": (
        f"{BLOCK.replace('bodies: {', 'bodies: {drum: {disk: {mass: 2 kg, radius: 1 m}}, ')}connections: "
        "{p: {pin: [ground, drum]}, r: {string: {from: block, over: drum, to: drum}}}",
        "the string runs over the rim of drum and ends in its middle; what is fastened to a drum is wound on it: to: "
        "wound on drum, with nothing over it",
    ),
    "where a body starts": (
        "bodies: {ball: {particle: {mass: 1 kg}, start: [0, 1 m]}}",
        "a body has no start. Did you mean at?",
    ),
    "how fast it spins": (
        "bodies: {w: {disk: {mass: 1 kg, radius: 1 m}, spin: 3 rad/s}}",
        "a body has no spin. Did you mean angular_velocity?",
    ),
    "a weight": (
        "bodies: {b: {block: {weight: 20 N}}}",
        "particle has no weight: a weight is a force, and what has the weight W has the mass W/g: {mass: W/g}",
    ),
    "a velocity by its size and angle": (
        "parameters: {v: 3 m/s, beta: 40 deg}\n"
        "bodies: {b: {particle: {mass: 1 kg}, velocity: {magnitude: v, angle: beta}}}",
        "expected two components [x, y], found {'magnitude': 'v', 'angle': 'beta'}, e.g. [v*cos(beta), v*sin(beta)]",
    ),
    "a place along a rod": (
        f"{ROD}loads: {{F: {{force: {{at: rod.start + 0.2 m, along: up, magnitude: 1 N}}}}}}",
        "rod.start + 0.2 m is no point: declare one in rod, by its place from center: rod: {points: {P: [x, y]}}, and "
        "write rod.P",
    ),
    "a bar between points that there are not": (
        "ground: {points: {A: [0, 0]}}\nbodies: {bar: {rod: {from: A, to: [1 m, 0]}}, tie: {rod: {from: A, to: B}}}",
        "there is no point B of the ground: ground: {points: {B: [x, y]}}",
    ),
    "a damper by its damping ratio": (
        f"{BLOCK}loads: {{d: {{damper: {{from: ground, to: block, damping_ratio: 0.1}}}}}}",
        "damper has no damping_ratio: it has a damping c, which is 2*zeta*sqrt(k*m) for a mass on a spring: {damping: "
        "2*zeta*sqrt(k*m)}",
    ),
    "a parameter by an equals sign": (
        f"parameters:\n  k: 1 N/m\n  m = 2 kg\n  g: 9.81 m/s^2\n{BLOCK}",
        "a colon is missing after m: m: 2 kg",
    ),
    "a rate with a dot": (
        f"parameters: {{k: 1 N m}}\n{ROD}measures: {{phi: angle of rod}}\n"
        "loads: {t: {torque: {on: rod, magnitude: -k*phi_dot}}}",
        "the rate of phi is written rate(phi)",
    ),
    "a driver of a joint": (
        f"{ROD}connections: {{h: {{pin: [ground, rod.start]}}, d: {{driver: {{joint: h, speed: 1 rad/s}}}}}}",
        "driver has no joint: it leads the angle of a body, or a measure: {body: arm, speed: w}",
    ),
    "a driver of a coordinate": (
        f"{BLOCK}connections: {{d: {{driver: {{body: block, y: 1 m}}}}}}",
        "driver has no y: it leads a measure: {measure: y of cart, follows: Y*sin(Omega*t)}",
    ),
    "a direction that is misspelt under a rope": (
        f"{BLOCK.replace('bodies: {', 'bodies: {load: {particle: {mass: 1 kg}}, p: {disk: {radius: 1 m}}, ')}"
        "connections: {a: {pin: [ground, p]}, s: {slider: {body: block, along: Right}}, "
        "r: {string: {from: block, over: p, to: load}}}",
        "Right is no direction. Did you mean right? Write right, left, up, down, an angle such as 30 deg, components "
        "[1, 2], a line, or body.x",
    ),
    "a roller of two points": (
        f"ground: {{points: {{A: [0, 0]}}}}\n{ROD}connections: {{r: {{roller: [rod.end, rod.start]}}}}",
        "rod.start is no direction: it is a point. Write right, left, up, down, an angle such as 30 deg, components "
        "[1, 2], a line, or body.x",
    ),
    "the axis of a body in space": (
        "space: true\nbodies: {b: {body: {mass: 1 kg, inertia: [1 kg m^2, 1 kg m^2, 1 kg m^2], axis: x}}}",
        "body has no axis: its moments of inertia are those about its axes x, y and z: inertia: [Ixx, Iyy, Izz]",
    ),
    "a floor among the bodies": (
        "bodies: {block: {particle: {mass: 1 kg}}, floor: ground}",
        "the ground is a body already, and floor may be a line of it: ground: {lines: {floor: {along: right}}}, then "
        "ground.floor",
    ),
    "coordinates for a point": (
        f"{BLOCK}loads: {{F: {{force: {{at: [0, 1 m], along: right, magnitude: 10 N}}}}}}",
        "at takes a point by its name: give the ground or a body points: {P: [0, 1 m]}, then at: ground.P, or that of "
        "the body",
    ),
    "gravity without a value": (
        f"{BLOCK}loads: {{gravity: }}",
        "give it a name of its own beside its kind, e.g. my_gravity: {gravity: 9.81 m/s^2}",
    ),
    "teeth of a body": (
        "bodies: {a: {disk: {teeth: 20}}}",
        "disk has no teeth: teeth and a module are those of a gear: {gear: {teeth: 20, module: 2 mm}}",
    ),
    "a force without a value": (
        f"{BLOCK}loads: {{push: {{force: {{at: block, along: right, magnitude: P}}}}}}",
        "P is not a parameter. There is: t. Add it under parameters, e.g. P: 1 N, or without a number P: N",
    ),
    "a force by its components": (
        f"{BLOCK}loads: {{F: {{force: {{at: block, components: [3 N, 4 N], along: up, magnitude: 1 N}}}}}}",
        "force has no components: it has a direction and a magnitude: {along: [3, 4], magnitude: 5 N}",
    ),
    "a force between two bodies": (
        f"{BLOCK}loads: {{F: {{force: {{between: [block, ground.O], pulls: 3 N}}}}}}",
        "force has no between: what two bodies A and B exert on each other is a law of their distance: law: "
        "{measure: gap, force: -F} pulls with F, with measures: {gap: distance from A to B}",
    ),
    "the ends of a rope": (
        f"{BLOCK}connections: {{r: {{rope: {{ends: [ground.A, block, ground.B]}}}}}}",
        "string has no ends: its way is from one end over pulleys to the other: {from: a, over: [pulley], to: b}",
    ),
    "units written together": (
        "parameters: {m: 1 kg, c: 5 Ns/m}\nbodies: {block: {particle: {mass: m}}}\nloads: {w: {gravity: c*1 m/(s^2)}}",
        "the unit 'Ns' is not known: write N, or N s for N times seconds",
    ),
    "the angle of a hinge": (
        f"{ROD}connections: {{hinge: {{pin: [ground, rod.start]}}}}\nmeasures: {{phi: angle of hinge}}",
        "there is no body hinge. hinge is the connection of rod: name a body.",
    ),
    "a rate as a measure": (
        f"{BLOCK}measures: {{s: x of block, v: rate(s)}}",
        "a measure has its rate beside it: rate(s) may stand in start and in questions",
    ),
    "what touches, apart": (
        f"ground: {{lines: {{road: {{along: right}}}}}}\n{BLOCK}connections: {{c: {{contact: {{body: block}}}}}}",
        "contact has no body: what touches stands together: between: [ball, ground.floor]",
    ),
    "a spring by its constant": (
        f"{BLOCK}loads: {{s: {{spring: {{first: ground, second: block, constant: 20 N/m}}}}}}",
        "spring has no constant. Did you mean stiffness?",
    ),
    "a ball joint in the plane": (
        f"{ROD}connections: {{j: {{ball_joint: [ground, rod.end]}}}}",
        "ball_joint is no kind of connection. Did you mean pin?",
    ),
    "the resistance of what rolls as a load": (
        f"{BLOCK}loads: {{r: {{rolling_resistance: {{body: block, coefficient: 0.01}}}}}}",
        "rolling_resistance is no kind of load; it is a field of contact: contact: {..., rolling_resistance: ...}",
    ),
    "a clutch by its plates": (
        f"{ROD}connections: {{c: {{disc_clutch: {{between: [rod, ground], force: 1 N, friction: 0.1, "
        "inner_radius: 1 m, outer_radius: 2 m, plates: 3}}}",
        "disc_clutch has no plates: faces is the number of pairs of faces that rub: a plate between two disks has 2",
    ),
    "a clockwise torque in space": (
        "space: true\nbodies: {b: {box: {mass: 1 kg, size: [1 m, 1 m, 1 m]}}}\n"
        "loads: {t: {torque: {on: b, magnitude: 1 N m, about: z, direction: clockwise}}}",
        "in space the axis says which way round: about: -z turns the other way as about: z",
    ),
    "an inertia about one axis alone": (
        "space: true\nbodies: {b: {body: {mass: 1 kg, inertia: [0, 0, 1 kg m^2]}}}",
        "no body has this inertia tensor: its principal moments are 0, 0, 1 kg m^2, and the largest cannot be more "
        "than the sum of the other two. Check the entries, and about which point the tensor is given (about:)",
    ),
    "an entry that is not indented": (
        f"{ROD}measures:\nphi: {{angle of rod from right}}",
        "phi is not indented, so that measures is empty: begin the line of phi with two spaces",
    ),
    "a section without a colon": (
        f"{ROD}measures: {{phi: angle of rod}}\nstart {{phi: 1 rad}}",
        "a colon is missing after start: start: {phi: 1 rad}",
    ),
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_is_one_message_that_says_what_to_write(mistake: str) -> None:
    text, told = MISTAKES[mistake]
    with pytest.raises(fb.ModelError) as refused:
        fb.System.from_text(text)
    assert [problem.message for problem in refused.value.problems] == [told]


ON_A_FLOOR = (
    "ground: {points: {A: [0, 2 m]}, lines: {floor: {along: right}}}\n"
    "bodies: {rod: {rod: {mass: 2 kg, length: 1 m}, angle: 30 deg}, ball: {sphere: {mass: 1 kg, radius: 0.1 m}}, "
    "ring: {ring: {mass: 1 kg, radius: 0.2 m}, at: [1 m, 0]}}\n"
)
SAME = {
    "a contact of what lies on something": ("contact: {body: ball, on: floor}", "contact: {between: [ball, floor]}"),
    "a contact of a point": ("contact: {at: rod.start, on: floor, mu: 0.3}",
                             "contact: {between: [rod.start, floor], friction: 0.3}"),
    "a contact of a first and a second": ("contact: {first: ball, second: floor}", "contact: {between: [ball, floor]}"),
    "a point of the ground": ("pin: [A, rod.start]", "pin: [ground.A, rod.start]"),
    "the direction of a rod": ("slot: {pin: ball, along: rod}", "slot: {pin: ball, along: rod.x}"),
    "a support on rollers": ("roller: {at: rod.end, on: floor}", "slot: {pin: rod.end, along: floor}"),
    "a support on rollers with its free direction": (
        "roller: {at: rod.end, along: up}", "slot: {pin: rod.end, along: up}"
    ),
    "a direction with a minus": (
        "force: {at: rod.end, along: -rod.y, magnitude: 3 N}",
        "force: {at: rod.end, along: against rod.y, magnitude: 3 N}"
    ),
    "a clutch by its torque": (
        "clutch: {between: [rod, ball], torque: 3 N m}", "brake: {between: [rod, ball], torque: 3 N m}"
    ),
    "a load along all of a rod": (
        "distributed: {on: rod, magnitude: 2 N/m}", "distributed: {between: [rod.start, rod.end], intensity: 2 N/m}"
    ),
    "a load along a part of a rod": (
        "distributed: {on: rod, from: start, to: center, value: 2 N/m}",
        "distributed: {between: [rod.start, rod.center], intensity: 2 N/m}",
    ),
    "a load along a rod from a point to another": (
        "distributed: {from: rod.start, to: rod.center, intensity: 2 N/m}",
        "distributed: {between: [rod.start, rod.center], intensity: 2 N/m}",
    ),
    "a spring from a point to another": (
        "spring: {from: A, to: rod.end, k: 5 N/m, rest_length: 1 m}",
        "spring: {first: ground.A, second: rod.end, stiffness: 5 N/m, length: 1 m}",
    ),
    "a damper from a point to another": (
        "damper: {from: A, to: rod.end, c: 5 N s/m}", "damper: {first: ground.A, second: rod.end, damping: 5 N s/m}"
    ),
    "a shaft between two bodies": (
        "torsional_spring: {between: [rod, ball], k: 5 N m}",
        "torsional_spring: {body: rod, on: ball, stiffness: 5 N m}",
    ),
    "a shaft from one body to a second": (
        "torsional_spring: {first: rod, second: ball, k: 5 N m}",
        "torsional_spring: {body: rod, on: ball, stiffness: 5 N m}",
    ),
    "a motor between two bodies": (
        "torque: {between: [rod, ball], value: 5 N m}", "torque: {on: rod, reacts_on: ball, magnitude: 5 N m}"
    ),
    "the resistance of the air": (
        "air_resistance: {body: ball, quadratic: 2 kg/m}", "drag: {body: ball, quadratic: 2 kg/m}"
    ),
    "the strength of gravity in a liquid": (
        "buoyancy: {at: ball, density: 1000 kg/m^3, g: 9.81 m/s^2, volume: 0.01 m^3}",
        "buoyancy: {at: ball, density: 1000 kg/m^3, strength: 9.81 m/s^2, volume: 0.01 m^3}",
    ),
    "what is drawn to a centre": (
        "central_gravity: {center: A, strength: 2 m^3/s^2}", "attraction: {center: ground.A, strength: 2 m^3/s^2}"
    ),
    "a motor by its current": (
        "dc_motor: {on: rod, stall_torque: 2 N m, no_load_speed: 9 rad/s}",
        "motor: {on: rod, stall_torque: 2 N m, no_load_speed: 9 rad/s}",
    ),
    "a torque by its direction": (
        "torque: {on: rod, magnitude: 5 N m, direction: clockwise}", "torque: {on: rod, magnitude: -5 N m}"
    ),
    "a torque by its sense": (
        "torque: {on: rod, magnitude: 5 N m, sense: counter-clockwise}", "torque: {on: rod, magnitude: 5 N m}"
    ),
    "a force by the way it points": (
        "force: {at: rod.end, down: 3 N}", "force: {at: rod.end, along: down, magnitude: 3 N}"
    ),
    "a contact of two bodies": ("contact: {bodies: [ball, floor]}", "contact: {between: [ball, floor]}"),
    "a torque on a body": ("torque: {body: rod, value: 5 Nm}", "torque: {on: rod, magnitude: 5 N m}"),
    "a belt round its pulleys": (
        "belt: {pulleys: [ball, ring]}", "belt: {first: ball, second: ring}",
    ),
    "a driver by its angular velocity": (
        "driver: {body: rod, angular_velocity: 3 rad/s}", "driver: {body: rod, speed: 3 rad/s}"
    ),
    "a force on a point": (
        "force: {on: rod.end, direction: down, value: 3 N}", "force: {at: rod.end, along: down, magnitude: 3 N}"
    ),
}  # fmt: skip


@pytest.mark.parametrize("words", SAME)
def test_words_that_can_mean_one_thing_only_are_read_as_it(words: str) -> None:
    written, meant = (_read(text) for text in SAME[words])
    assert written == meant


def _read(entry: str) -> list[str]:
    """What holds and what pushes in a model with one connection, or one load."""
    word = entry.partition(":")[0]
    is_load = any(word in (name, *kind.also) for name, kind in Load.kinds.items())
    section = "loads" if is_load else "connections"
    system = fb.System.from_text(f"{ON_A_FLOOR}{section}: {{it: {{{entry}}}}}")
    held = [*system.constraint_rows, *system.applied_loads, *system.contacts, *system.dry_friction]
    return [*map(str, held)]


SAME_BODIES = {
    "by letters": ("{disk: {m: 2 kg, R: 0.1 m}}", "{disk: {mass: 2 kg, radius: 0.1 m}}"),
    "by its diameter": ("{disk: {mass: 2 kg, diameter: 20 cm}}", "{disk: {mass: 2 kg, radius: 0.1 m}}"),
    "by its radius of gyration": (
        "{body: {m: 2 kg, radius_of_gyration: 30 cm}}",
        "{body: {mass: 2 kg, inertia: 0.18 kg m^2}}",
    ),
    "by where it starts": (
        "{particle: {m: 1 kg}, position: [1 m, 0], initial_velocity: [2 m/s, 0]}",
        "{particle: {mass: 1 kg}, at: [1 m, 0], velocity: [2 m/s, 0]}",
    ),
    "by its ends": ("{bar: {from: A, to: [1 m, 2 m]}}", "{rod: , at: {start: A, end: [1 m, 2 m]}}"),
    "by how fast it turns": (
        "{gear: {radius: 1 m, J: 2 kgm^2}, omega: 3 rad/s}",
        "{gear: {radius: 1 m, inertia: 2 kg m^2}, angular_velocity: 3 rad/s}",
    ),
}


@pytest.mark.parametrize("words", SAME_BODIES)
def test_words_for_a_body_that_can_mean_one_thing_only_are_read_as_it(words: str) -> None:
    ground = "ground: {A: [0, 2 m]}", "ground: {points: {A: [0, 2 m]}}"
    texts = (f"{own}\nbodies: {{it: {body}}}" for own, body in zip(ground, SAME_BODIES[words], strict=True))
    written, meant = (fb.System.from_text(text).bodies["it"] for text in texts)
    assert _in_numbers(written) == pytest.approx(_in_numbers(meant))


def _in_numbers(body: RigidBody) -> list[float]:
    """What the places, masses and speeds of a body come to."""
    start = body.start
    of_start = (*(start.at or ("", ()))[1], *(start.velocity or ()), start.angle, start.angular_velocity)
    return [evaluate(x, {"pi": math.pi}) for x in (body.mass, body.inertia, body.radius, *of_start) if x is not None]


def test_a_cone_may_be_given_by_its_half_angle() -> None:
    cone = "space: true\nbodies: {{it: {{cone: {{mass: 2 kg, height: 3 m, {}}}}}}}"
    by_angle, by_radius = (fb.System.from_text(cone.format(x)) for x in ("half_angle: 45 deg", "radius: 3 m"))
    assert evaluate(by_angle.bodies["it"].inertia, {"pi": math.pi}) == pytest.approx(
        evaluate(by_radius.bodies["it"].inertia, {})
    )


def test_a_body_goes_before_a_point_of_the_ground_of_its_name() -> None:
    """`A` is the body where there is one."""
    text = (
        "ground: {points: {A: [0, 0], B: [1 m, 0]}}\nbodies: {A: {particle: {mass: 1 kg}}}\n"
        "connections: {c: {link: [A, B]}}"
    )
    (row,) = fb.System.from_text(text).constraint_rows
    assert {*row.measure.bodies()} == {"A", "ground"}


def test_a_symbol_may_have_the_unit_that_another_one_is_called() -> None:
    """m: a mass, L: in metres."""
    system = fb.System.from_text("parameters: {m: kg, L: m, h: 1/4 m}\nbodies: {rod: {rod: {mass: m, length: L + h}}}")
    assert system.parameters["L"].value is None


def test_the_words_for_a_start_that_contradicts_itself_lead_to_who_names_the_culprits() -> None:
    text = f"""{ROD}ground: {{points: {{A: [0, 0]}}}}
connections: {{p: {{pin: [ground.A, rod.start]}}}}
measures: {{phi: angle of rod, y: y of rod.end}}
start: {{phi: 0, y: 0.5 m}}
questions: [acceleration of phi]
"""
    system = fb.System.from_text(text)
    with pytest.raises(fb.FreebodyError, match="freebody mobility says which parts contradict each other"):
        system.solve()
    assert "contradict each other" in system.mobility().to_text()


# -- in Python ------------------------------------------------------------------------------------------
def test_one_wheel_of_a_string_needs_no_list_in_python() -> None:
    """a = g (m_2 - m_1)/(m_1 + m_2 + M/2)"""
    model = fb.Model("Atwood")
    first, second = (model.body(name, fb.Particle(mass)) for name, mass in (("a", "1 kg"), ("b", "2 kg")))
    pulley = model.body("p", fb.Disk("1 kg", "0.1 m"))
    model.connect("axle", fb.Pin("ground.P", pulley))
    model.connect("rope", fb.String(first, second, over=pulley))
    model.load("weight", fb.Gravity("9.81 m/s^2"))
    model.measure("y", "y of a")
    model.ask("acceleration of y")
    assert model.system().solve().answers[0].value == pytest.approx(9.81 / 3.5)


def test_words_that_a_file_may_have_are_read_in_python_too() -> None:
    spring = fb.Spring("ground.A", "block", k="20 N/m", rest_length="1 m")
    assert spring == fb.Spring("ground.A", "block", stiffness="20 N/m", length="1 m")
    assert fb.Disk(m="1 kg", diameter="2 m") == fb.Disk("1 kg", "(2 m)/2")


@pytest.mark.parametrize(
    ("shape", "fields", "told"),
    [
        (
            fb.Spring,
            {"first": "ground", "second": "b", "stiff": "1 N/m"},
            "Spring has no stiff. Did you mean stiffness?",
        ),
        (fb.Gravity, {}, "Gravity needs strength; it takes strength, along"),
        (
            fb.Rod,
            {"length": "1 m", "points": {"C": [0, 0]}},
            "What is no field of a shape stands beside it: model.body(name, Rod(...), points=...)",
        ),
        (fb.Particle, {"weight": "3 N"}, "what has the weight W has the mass W/g"),
        (fb.Contact, {"between": 3}, "Contact: between takes a list, between=[...]"),
    ],
)
def test_a_field_that_there_is_not_is_told_as_python_does(shape: Any, fields: dict[str, Any], told: str) -> None:
    with pytest.raises(TypeError) as found:
        shape(**fields)
    assert told in str(found.value)


def test_a_model_is_asked_by_its_system_and_a_system_is_made_from_data() -> None:
    model = fb.Model("Rod")
    with pytest.raises(AttributeError, match=r"write model.system\(\).solve"):
        model.solve()
    with pytest.raises(TypeError, match="from_data"):
        fb.System({"bodies": {}})
    rod = model.body("rod", fb.Rod("2 kg", "1 m"))
    with pytest.raises(TypeError, match=r"model.body\('rod', ..., points={'P': ...}\)"):
        rod.point("P", [0, 0])
    model.connect("pin", fb.Pin(model.ground.A, rod.start))
    assert model.system().bodies["ground"].points.keys() >= {"A"}


def test_what_has_to_be_called_says_so() -> None:
    model = fb.Model("Rod")
    rod = model.body("rod", fb.Rod("2 kg", "1 m"))
    model.measure("phi", rod.angle)  # pyright: ignore[reportArgumentType]
    with pytest.raises(fb.ModelError, match=r"angle is a function: call it, as angle\(\)"):
        model.system()


def test_a_point_of_the_ground_has_its_place_as_a_list_or_as_numbers() -> None:
    one, other = fb.Model("A"), fb.Model("A")
    one.point("A", "1 m", 0)
    other.point("A", ["1 m", 0])
    for model in (one, other):
        model.body("ball", fb.Particle("1 kg"))
    assert one.system().to_yaml() == other.system().to_yaml()


def test_a_start_with_value_and_rate_in_braces_is_told_how_both_are_written() -> None:
    text = """
freebody: 1
bodies: {ball: {particle: {mass: 1 kg}}}
connections: {line: {slider: {body: ball, along: up}}}
measures: {y: height of ball}
start: {y: {value: 0, rate: 2 m/s}}
"""
    with pytest.raises(fb.ModelError) as found:
        fb.System.from_text(text)
    assert "start has values: y: ..., and the rate beside it as rate(y): ..." in str(found.value)


# -- what people write first, and is read -------------------------------------------------------------
def test_a_driver_may_have_a_speed_in_place_of_a_law_and_lead_a_body() -> None:
    model = """
parameters: {a: 0.2 m, w: 3 rad/s, phi_0: 40 deg}
bodies: {crank: {rod: {mass: 1 kg, length: a}ANGLE}}
connections: {A: {pin: [ground.A, crank.start]}, motor: {driver: DRIVER}}
measures: {phi: angle of crank from right}
START
questions: {there: x of crank.end at t = 0.5 s}
"""
    cases = [
        ("{body: crank, speed: w}", ", angle: phi_0", ""),
        ("{measure: phi, speed: w}", "", "start: {phi: phi_0}"),
        ("{measure: phi, speed: w}", ", angle: phi_0", ""),
        ("{measure: angle of crank, speed: w}", ", angle: phi_0", ""),
        ("{measure: phi, follows: phi_0 + w*t}", "", ""),
    ]
    for driver, angle, start in cases:
        text = model.replace("DRIVER", driver).replace("ANGLE", angle).replace("START", start)
        (answer,) = fb.System.from_text(text).solve().answers
        assert answer.value == pytest.approx(0.2 * math.cos(math.radians(40) + 1.5), rel=1e-12), driver


@pytest.mark.parametrize("turned", ["-phi_0 about y", "phi_0 about -y"])
def test_a_driver_in_space_goes_on_from_where_its_body_is_turned_at_the_start(turned: str) -> None:
    """An arm is raised about -y while its column turns: the height of its end is L sin(phi_0 + w t)."""
    system = fb.System.from_text(f"""
space: {{up: z}}
parameters: {{L: 0.8 m, w: 1 rad/s, phi_0: 30 deg}}
bodies:
  column: {{cylinder: {{mass: 10 kg, radius: 0.1 m, length: 0.5 m}}}}
  arm: {{rod: {{mass: 5 kg, length: L}}, turned: {turned}}}
connections:
  base: {{revolute: {{first: ground.O, second: column, axis: z}}}}
  shoulder: {{revolute: {{first: column, second: arm.start, axis: y}}}}
  one: {{driver: {{body: column, speed: 2 rad/s}}}}
  other: {{driver: {{body: arm, speed: -w}}}}
questions: [height of arm.end above arm.start at t = 0.5 s]
""")
    (answer,) = system.solve().answers
    assert answer.value == pytest.approx(0.8 * math.sin(math.radians(30) + 0.5), rel=1e-12)


@pytest.mark.parametrize(
    ("driver", "told"),
    [
        ("{follows: w*t}", "give one of measure and body"),
        ("{body: crank}", "the law that a driver follows, or its speed"),
        ("{body: crank, follows: w*t, speed: w}", "the law that a driver follows, or its speed"),
        ("{body: bob, speed: w}", "bob is a particle and does not turn"),
    ],
)
def test_what_leaves_a_driver_open_is_told(driver: str, told: str) -> None:
    with pytest.raises(fb.ModelError, match=told):
        fb.System.from_text(f"""
parameters: {{w: 3 rad/s}}
bodies: {{crank: {{rod: {{mass: 1 kg, length: 1 m}}}}, bob: {{particle: {{mass: 1 kg}}}}}}
connections: {{motor: {{driver: {driver}}}}}
""")


@pytest.mark.parametrize(
    "way", ["[cabin, over sheave, weight]", "[cabin, sheave, weight]", "[cabin, around sheave, weight]"]
)
def test_a_string_may_be_a_list_of_places_with_their_ways(way: str) -> None:
    system = fb.System.from_text(f"""
parameters: {{M: 9 kg, m: 7 kg, g: 9.81 m/s^2}}
bodies: {{cabin: {{particle: {{mass: M}}}}, weight: {{particle: {{mass: m}}}}, sheave: {{disk: {{radius: 0.3 m}}}}}}
connections: {{axle: {{pin: [ground.A, sheave]}}, cable: {{string: {way}}}}}
loads: {{gravity: {{gravity: g}}}}
questions: {{it: tension of cable}}
""")
    assert system.solve()["it"].value == pytest.approx(2 * 63 * 9.81 / 16)


def test_the_start_may_say_in_words_what_it_is_of() -> None:
    system = fb.System.from_text("""
parameters: {m: 2 kg, v: 3 m/s, mu: 0.2, g: 9.81 m/s^2}
bodies: {sledge: {particle: {mass: m}}}
connections: {track: {slider: {body: sledge, along: right, friction: mu}}}
loads: {weight: {gravity: g}}
start: {x of sledge: 1 m, rate(x of sledge): v}
questions: {it: time until sledge stops}
""")
    assert system.solve()["it"].value == pytest.approx(3 / (0.2 * 9.81))
    assert list(system.measures) == ["x_of_sledge"]


def test_the_start_may_say_how_fast_a_body_turns() -> None:
    system = fb.System.from_text("""
parameters: {J: 2 kg m^2, T: 4 N m, w: 6 rad/s}
bodies: {rotor: {flywheel: {radius: 1 m, inertia: J}}}
connections: {axle: {pin: [ground.O, rotor]}, brake: {brake: {between: [rotor, ground], torque: T}}}
start: {angular velocity of rotor: w}
""")
    assert system.solve("time when rotor comes to rest").answers[0].value == pytest.approx(3)


@pytest.mark.parametrize(
    ("section", "entry"),
    [
        ("connections", "chain: {rope: {from: rod.end, to: ball}}"),
        ("connections", "spring: {hinge: [A, rod.start]}"),
        ("loads", "motor: {dc_motor: {on: rod, stall_torque: 2 N m, no_load_speed: 9 rad/s}}"),
    ],
)
def test_a_thing_may_have_the_name_of_another_kind(section: str, entry: str) -> None:
    name = entry.partition(":")[0]
    assert name in getattr(fb.System.from_text(f"{ON_A_FLOOR}{section}: {{{entry}}}"), section)


def _placed(at: str, length: str = "") -> fb.System:
    length = f"{{length: {length}}}" if length else "{mass: 1 kg}"
    return fb.System.from_text(
        "parameters: {a: 2 m, h: 3 m, L: 5 m}\nground: {points: {A: [0, 0], B: [2*a, 0]}}\n"
        f"bodies: {{bar: {{rod: {length}, at: {at}}}}}"
    )


@pytest.mark.parametrize(
    ("at", "degrees"),
    [
        ("{start: A, end: [a, h]}", math.degrees(math.atan2(3, 2))),
        ("{start: ground.B, end: [a, h]}", math.degrees(math.atan2(3, -2))),
        ("{end: A, start: [a, h]}", math.degrees(math.atan2(-3, -2))),
        ("{start: A, end: [0, -h]}", -90.0),
        ("{start: B, end: A}", 180.0),
        ("{start: [L, 0], end: [a, h]}", math.degrees(math.atan2(3, 2 - 5))),
    ],
)
def test_two_points_say_where_a_rod_is_how_it_is_turned_and_how_long(at: str, degrees: float) -> None:
    """The rod goes from one place to the other, by the tangent of its angle in all quarters."""
    system = _placed(at)
    bar, start = system.bodies["bar"], system.bodies["bar"].start
    assert start.angle is not None
    numbers = {"a": 2.0, "h": 3.0, "L": 5.0, "pi": math.pi}
    angle = float(evaluate(start.angle, numbers))
    assert math.degrees(math.remainder(angle - math.radians(degrees), math.tau)) == pytest.approx(0.0, abs=1e-9)
    ends = {
        "{start: A, end: [a, h]}": math.hypot(2, 3),
        "{start: B, end: A}": 4.0,
        "{start: [L, 0], end: [a, h]}": math.hypot(3, 3),
    }
    assert float(evaluate(bar.sizes[0], numbers)) == pytest.approx(ends.get(at, float(evaluate(bar.sizes[0], numbers))))


@pytest.mark.parametrize(
    ("at", "length", "told"),
    [
        ("{start: A, end: B}", "L", "start and end are put 4 m apart, but lie 5 m apart in the body"),
        ("{start: A, end: [3 m, 4 m]}", "L", "are as far apart as the two points for these numbers only"),
        ("{start: A, end: A}", "L", "start and end are at one place"),
        ("{start: A, top: B}", "L", "there is no point top"),
    ],
)
def test_two_places_that_do_not_fit_a_body_are_told(at: str, length: str, told: str) -> None:
    with pytest.raises(fb.ModelError, match=told):
        _placed(at, length)


def test_a_length_that_is_that_of_the_places_as_a_formula_may_stand() -> None:
    assert _placed("{start: A, end: [a, h]}", "sqrt(a^2 + h^2)").bodies["bar"].start.angle is not None


def test_an_angle_about_an_axis_of_another_body_is_relative_to_that() -> None:
    text = """
space: {up: z}
bodies: {ship: {body: {inertia: [1, 1, 1]}}, rotor: {body: {mass: 1 kg, inertia: [1, 1, 1]}}}
connections:
  turn: {revolute: {first: ground.O, second: ship.origin, axis: z}}
  shaft: {revolute: {first: ship.origin, second: rotor.origin, about: x}}
measures: {phi: angle of rotor about ship.x SAID}
"""
    plain, said = (fb.System.from_text(text.replace("SAID", of)) for of in ("", "relative to ship"))
    assert plain.measures["phi"] == said.measures["phi"]


ON_A_SLOPE = """
parameters: {m: 2 kg, r: 0.1 m, beta: 20 deg, h: 1 m, mu: 0.3, g: 9.81 m/s^2}
ground: {lines: {slope: {along: -beta}}}
bodies: {ball: {sphere: {mass: m, radius: r}}}
connections: {roll: {rolling: {body: ball, on: slope}}}
loads: {weight: {gravity: g}}
measures: {s: travel of ball along slope}
START
"""


def test_what_is_thrown_from_no_place_that_is_given_lands_where_it_started() -> None:
    """A ball lands as fast as it was thrown; without a velocity it is not said that it comes back."""
    ball = "bodies: {{ball: {{particle: {{mass: 1 kg}}{velocity}}}}}\nloads: {{weight: {{gravity: 9.81 m/s^2}}}}\n"
    model = ball + "measures: {{y: height of ball}}\n"
    thrown = fb.System.from_text(model.format(velocity=", velocity: [3 m/s, 4 m/s]"))
    assert thrown.solve("speed of ball when it lands").answers[0].value == pytest.approx(5)
    with pytest.raises(fb.FreebodyError):
        fb.System.from_text(model.format(velocity="")).solve("speed of ball when it lands")


THROWN = """
parameters: {v: 9 m/s, alpha: 55 deg, h: 1.1 m, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: 0.6 kg}, at: PLACE, velocity: [v*cos(alpha), v*sin(alpha)]}}
loads: {weight: {gravity: g}}
MEASURES
"""


@pytest.mark.parametrize("measures", ["", "measures: {x: x of ball, y: height of ball}"])
@pytest.mark.parametrize(("place", "x", "y"), [("[0, 0]", 0.0, 0.0), ("[0, h]", 0.0, 1.1), ("[2 m, 0]", 2.0, 0.0)])
def test_what_is_thrown_from_a_place_lands_at_the_height_zero(measures: str, place: str, x: float, y: float) -> None:
    system = fb.System.from_text(THROWN.replace("PLACE", place).replace("MEASURES", measures))
    up, along = 9 * math.sin(math.radians(55)), 9 * math.cos(math.radians(55))
    t = (up + math.sqrt(up**2 + 2 * 9.81 * y)) / 9.81
    asked = {"time of flight": t, "when does it hit the ground": t, "impact speed": math.sqrt(81 + 2 * 9.81 * y)}
    if not (measures and x):
        asked["range"] = along * t
    for question, value in asked.items():
        assert system.solve(question).answers[0].value == pytest.approx(value), question


def test_what_is_let_fall_from_a_place_lands_at_the_height_zero() -> None:
    text = (
        THROWN.replace("PLACE", "[0, h]")
        .replace("MEASURES", "")
        .replace(", velocity: [v*cos(alpha), v*sin(alpha)]", "")
    )
    (answer,) = fb.System.from_text(text).solve("time of fall").answers
    assert answer.value == pytest.approx(math.sqrt(2 * 1.1 / 9.81))


# -- no measures at all -------------------------------------------------------------------------------
FLYWHEEL = """
parameters: {J: 3 kg m^2, n1: 300 rpm, n2: 260 rpm, M: 200 N m}
bodies: {flywheel: {body: {inertia: J}, angular_velocity: n1}}
connections: {axle: {pin: [ground.O, flywheel]}}
loads: {shear: {torque: {on: flywheel, magnitude: -M}}}
"""
PUSHED = """
parameters: {m: 3 kg, F: 12 N, mu: 0.2, g: 9.81 m/s^2, d: 4 m, v: 6 m/s}
ground: {lines: {floor: {along: right}}}
bodies: {block: {particle: {mass: m}}}
connections: {c: {slider: {body: block, along: floor, friction: mu}}}
loads: {w: {gravity: g}, push: {force: {at: block, right: F}}}
"""
FALLING_ROD = """
parameters: {m: 3 kg, L: 1 m, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}, angle: 90 deg, angular_velocity: SPIN}}
connections: {hinge: {pin: [ground.O, rod.start]}}
loads: {w: {gravity: g}}
"""


@pytest.mark.parametrize(
    ("model", "question", "value"),
    [
        (FLYWHEEL, "time until the speed is n2", 3 * 40 * math.pi / 30 / 200),
        (FLYWHEEL, "turns until the speed is n2", 3 * (300**2 - 260**2) * (math.pi / 30) ** 2 / 400 / math.tau),
        (FLYWHEEL, "rpm of flywheel after 0.1 s", 10 * math.pi - 20 / 3),
        (PUSHED, "time until the speed is v", 6 / (4 - 0.2 * 9.81)),
        (PUSHED, "speed of block after it has moved d", math.sqrt(8 * (4 - 0.2 * 9.81))),
        (FALLING_ROD.replace("SPIN", "-2 rad/s"), "angular velocity when the rod is horizontal", -math.sqrt(4 + 29.43)),
        (FALLING_ROD.replace("SPIN", "2 rad/s"), "angular velocity when the rod is horizontal", math.sqrt(4 + 29.43)),
        (FALLING_ROD.replace("SPIN", "-2 rad/s"), "angular velocity of rod at the bottom", -math.sqrt(4 + 58.86)),
    ],
)
def test_a_single_body_may_be_asked_for_events_without_a_measure(model: str, question: str, value: float) -> None:
    (answer,) = fb.System.from_text(model).solve(question).answers
    assert answer.value == pytest.approx(value), answer.reason


def test_the_revolutions_of_which_a_question_asks_are_told_in_their_unit() -> None:
    (asked,) = fb.System.from_text(FLYWHEEL).asked("rpm of flywheel")
    assert asked.in_unit == "rpm"


def test_a_sprocket_is_a_disk() -> None:
    model = "bodies: {wheel: {disk: {mass: 2 kg, radius: 0.1 m}}}"
    asked = fb.System.from_text(model.replace("disk", "sprocket"))
    assert asked.bodies == fb.System.from_text(model).bodies


def test_how_far_something_has_come_needs_where_it_started() -> None:
    asked = "speed of ball when height of ball has changed by -h"
    (answer,) = fb.System.from_text(ON_A_SLOPE.replace("START", "")).solve(asked).answers
    assert "give the start, e.g. start: {s: 0}" in str(answer.reason)
    (answer,) = fb.System.from_text(ON_A_SLOPE.replace("START", "start: {s: 0}")).solve(asked).answers
    assert answer.value == pytest.approx(math.sqrt(10 * 9.81 / 7))


def test_a_parameter_of_a_question_that_the_model_has_nowhere_is_told() -> None:
    """What rolls ideally rolls with every coefficient of friction, which is not what is asked."""
    system = fb.System.from_text(ON_A_SLOPE.replace("START", "start: {s: 0}"))
    (answer,) = system.solve("least mu so that ball rolls without slipping").answers
    assert "nothing in the model depends on mu" in str(answer.reason)


def test_a_disc_clutch_by_its_torque_is_told_to_be_a_brake() -> None:
    clutch = "connections: {it: {disc_clutch: {between: [rod, ground], torque: 3 N m}}}"
    with pytest.raises(fb.ModelError, match=r"is brake: {between: \[drum, shaft\], torque: T}"):
        fb.System.from_text(f"{ROD}{clutch}")


@pytest.mark.parametrize(
    ("written", "point"),
    [
        ("connections: {c: {link: {between: [[1 m, 2 m], b]}}}", "A"),
        ("loads: {c: {spring: {from: [1 m, 2 m], to: b, stiffness: 10 N/m, length: 1 m}}}", "A"),
        ("connections: {c: {slider: {body: b, along: right, through: [1 m, 2 m]}}}", "A"),
        ("parameters: {A: 1 m^2}\nconnections: {c: {pin: {between: [[1 m, 2 m], b]}}}", "B"),
    ],
)
def test_coordinates_at_the_end_of_something_are_those_of_a_point_of_the_ground(written: str, point: str) -> None:
    system = fb.System.from_text(f"bodies: {{b: {{rod: {{mass: 1 kg, length: 1 m}}}}}}\n{written}\n")
    assert [evaluate(x, {}) for x in system.bodies["ground"].points[point]] == [1, 2]


def test_coordinates_beside_the_body_on_which_something_is_guided_are_asked_for() -> None:
    with pytest.raises(fb.ModelError, match="through takes a point by its name"):
        fb.System.from_text(
            "bodies: {a: {rod: {mass: 1 kg, length: 1 m}}, b: {particle: {mass: 1 kg}}}\n"
            "connections: {s: {slider: {body: b, on: a, along: a.x, through: [0, 1 m]}}}\n"
        )


def test_gains_that_have_neither_numbers_nor_units_have_those_of_their_use() -> None:
    text = f"{BLOCK}parameters: {{k: null, c: null}}\nmeasures: {{x: x of block}}\n"
    system = fb.System.from_text(text + "loads: {F: {force: {at: block, along: right, magnitude: -k*x - c*rate(x)}}}")
    assert [str(system.parameters[name].dimension) for name in ("k", "c")] == ["N/m", "N s/m"]
