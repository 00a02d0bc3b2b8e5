"""Files as newcomers write them from the README alone: what means one thing is read, and what is wrong is told once, at
its place, with an entry that can be pasted."""

from __future__ import annotations

import math
import re
from typing import Any

import pytest

import freebody as fb
from freebody.connections.base import Connection
from freebody.language.document import Document
from freebody.language.document.writer import flow_text
from freebody.loads.base import Load
from freebody.model.spec import Spec
from freebody.study.model_warnings.found import warnings_of
from freebody.system.reading.vocabulary import SHORT_FORMS

G = 9.81
ROD = "parameters: {m: 2 kg, L: 3 m, g: 9.81 m/s^2}\n"
HUNG = """
connections: {O: {pin: [ground.O, rod.P]}}
loads: {w: {gravity: g}}
measures: {theta: angle of rod from down}
questions: [period of small oscillations]
"""
# a rod of 3 m about a point 2 m from its start: J = L^2/12 + (1/2)^2 = 1 m^2, T = 2 pi sqrt(J/(g/2))
OFF_CENTRE = 2 * math.pi * math.sqrt(1 / (G / 2))
RIGHT = {
    # 20 teeth at 10 rad/s turn 60 by 10/3 rad/s, with one wheel between them the same way
    "gears with what meshes among them": (
        "gears: {a: {teeth: 20}, b: {teeth: 40}, c: {teeth: 60}, meshes: [[a, b], [b, c]]}\n"
        "start: {angular_velocity of a: 10 rad/s}\nquestions: [angular velocity of c at start]\n",
        10 / 3,
    ),
    "gears beside what meshes": (
        "gears: {a: {teeth: 20}, b: {teeth: 40}}\nmeshes: [[a, b]]\n"
        "start: {angular_velocity of a: 10 rad/s}\nquestions: [angular velocity of b at start]\n",
        -5.0,
    ),
    # 60 rpm are 2 pi rad/s, and no 60 rad/s
    "rpm without a unit": (
        "links: {ground: 10 cm, crank: 3 cm, coupler: 9 cm, rocker: 7 cm, angle: 90 deg, rpm: 60}\n"
        "questions: [angular velocity of crank at start]\n",
        2 * math.pi,
    ),
    # w^2 = (M + m) g/(M L)
    "a slider on what it leads": (
        "parameters: {M: 1000 kg, m: 500 kg, L: 5 m, g: 9.81 m/s^2}\n"
        "bodies: {trolley: {particle: {mass: M}}, load: {particle: {mass: m}}}\n"
        "connections: {rail: {slider: {on: trolley, along: right}}, cable: {link: [trolley, load, L]}}\n"
        "loads: {w: {gravity: g}}\nmeasures: {x: x of trolley, theta: angle of line from trolley to load from down}\n"
        "questions: [natural frequency]\n",
        math.sqrt(1.5 * G / 5),
    ),
    "a slot on what it leads": (
        "bodies: {bead: {particle: {mass: 2 kg}, at: [0, 0]}}\nconnections: {s: {slot: {on: bead, along: -30 deg}}}\n"
        "loads: {w: {gravity: 10 m/s^2}}\nmeasures: {s: travel of bead along -30 deg}\n"
        "questions: [acceleration of s]\n",
        5.0,
    ),
    # A = m g sin cos/(M + m sin^2)
    "travel along the slope of a wedge": (
        "parameters: {m: 1 kg, M: 3 kg, alpha: 30 deg, L: 1 m, g: 9.81 m/s^2}\n"
        "bodies: {wedge: {wedge: {mass: M, angle: alpha, length: L}}, block: {block: {mass: m}}}\n"
        "connections: {floor: {slider: {body: wedge, along: right}}, "
        "slope: {slider: {body: block, along: wedge.slope}}}"
        "\nloads: {w: {gravity: g}}\n"
        "measures: {X: x of wedge, s: travel of block along wedge.slope from wedge}\nquestions: [acceleration of X]\n",
        G * math.sin(math.pi / 6) * math.cos(math.pi / 6) / (3 + 0.25),
    ),
    # v = 5 m/s at 30 deg from 2 m: t = (v_y + sqrt(v_y^2 + 4 g))/g
    "a velocity with its angle": (
        "bodies: {ball: {particle: {mass: 2 kg}, position: [0, 2], velocity: 5 m/s at 30 deg}}\n"
        "loads: {w: {gravity: 9.81 m/s^2}}\nmeasures: {x: x of ball, y: y of ball}\nquestions: [x when y = 0]\n",
        5 * math.cos(math.pi / 6) * (2.5 + math.sqrt(2.5**2 + 4 * G)) / G,
    ),
    "a velocity with its way": (
        "bodies: {ball: {particle: {mass: 2 kg}, at: [0, 0], velocity: 5 m/s left}}\n"
        "measures: {x: x of ball}\nquestions: [velocity of x at start]\n",
        -5.0,
    ),
    # a = F/(m + J/R^2), a hoop or a disk
    "a wheel with its inertia": (
        "parameters: {m: 5 kg, J: 0.1 kg m^2, R: 0.2 m, F: 10 N, g: 9.81 m/s^2}\n"
        "bodies: {w: {wheel: {mass: m, inertia: J, radius: R}}}\nconnections: {roll: {rolling: {body: w, on: floor}}}\n"
        "loads: {weight: {gravity: g}, pull: {force: {on: w, direction: right, value: F}}}\n"
        "measures: {x: x of w}\nquestions: [acceleration of x]\n",
        10 / (5 + 0.1 / 0.2**2),
    ),
    # wound on a drum on the shaft of a wheel: M/R - m g = (m + J/R^2) a; the load goes up where the drum turns
    # against the side on which it hangs
    "a rope from a drum on the shaft of a wheel": (
        "parameters: {M: 100 N m, m: 40 kg, J: 2 kg m^2, R: 0.15 m, g: 9.81 m/s^2}\n"
        "bodies: {wheel: {disk: {radius: 0.4 m, inertia: J}}, drum: {disk: {radius: R}}, load: {particle: {mass: m}}}\n"
        "connections: {B: {pin: [ground.B, wheel]}, shaft: {weld: [wheel.center, drum.center]}, "
        "rope: {string: {from: drum, to: load}}}\n"
        "loads: {w: {gravity: g}, motor: {torque: {on: wheel, magnitude: M}}}\n"
        "measures: {h: height of load}\nquestions: [acceleration of h]\n",
        (100 / 0.15 - 40 * G) / (40 + 2 / 0.15**2),
    ),
    # 6 kN in the middle of the right half of 4 m: 3 kN at its roller
    "a roller on the ground": (
        "ground: {points: {A: [0, 0], B: [3 m, 0], C: [8 m, 0]}}\n"
        "bodies: {left: {beam: {length: 4 m}, points: {B: 3 m from start}}, right: {beam: {length: 4 m}}}\n"
        "connections: {A: {pin: [ground.A, left.start]}, B: {roller: {at: left.B, on: ground}}, "
        "G: {hinge: [left.end, right.start]}, C: {roller: {at: right.end, on: ground}}}\n"
        "loads: {F: {force: {at: right.center, direction: down, value: 6 kN}}}\nquestions: [normal force of C]\n",
        3000.0,
    ),
    "a point from the start of a rod": (
        f"{ROD}bodies: {{rod: {{rod: {{mass: m, length: L}}, points: {{P: 2 m from start}}}}}}{HUNG}",
        OFF_CENTRE,
    ),
    "a point from the end of a rod": (
        f"{ROD}bodies: {{rod: {{rod: {{mass: m, length: L}}, points: {{P: 1 m from end}}}}}}{HUNG}",
        OFF_CENTRE,
    ),
    "a point by its distance": (
        f"{ROD}bodies: {{rod: {{rod: {{mass: m, length: L}}, points: {{P: 2*L/3}}}}}}{HUNG}",
        OFF_CENTRE,
    ),
    # at rest hanging straight down: the weight turns it not
    "an angle by a direction": (
        f"{ROD}bodies: {{rod: {{rod: {{mass: m, length: L}}, angle: down}}}}\n"
        "connections: {O: {pin: [boden.O, rod.start]}}\nloads: {w: {gravity: g}}\n"
        "measures: {phi: angle of rod}\nquestions: [phi at start]\n",
        -math.pi / 2,
    ),
}


@pytest.mark.parametrize("case", RIGHT)
def test_what_means_one_thing_is_read(case: str) -> None:
    text, value = RIGHT[case]
    (answer,) = fb.System.from_text(text).solve().answers
    assert answer.value == pytest.approx(value, rel=1e-9), answer.reason


PENDULUM = "pendulum: {OWN}\ngravity: 9.81 m/s^2\nquestions: [period of small oscillations]\n"
CAM = "cam: {OWN}\nfollower: {mass: 1 kg}\nquestions: [largest acceleration of follower]\n"
TRUSS = "nodes: {A: [0, 0], B: [4 m, 0], C: [2 m, 3 m]}\nmembers: MEMBERS\nsupports: SUPPORTS\nloads: {C: 10 kN down}\n"
SUPPORTS = "{A: pin, B: roller}"
HELD = "bodies: {rod: {rod: {mass: 2 kg, length: 1 m}}}\nconnections: {O: {pin: [ground.O, rod.start]}}\n"
WRONG = {
    "a length of four": (
        "four_bar: {ground: 10 cm, crank: 3, coupler: 9 cm, rocker: 7 cm}\nquestions: [range of phi]\n",
        "four_bar.crank: crank must be a length.*write crank: 3 cm",
    ),
    "a speed of a sun": (
        "planetary: {sun: 24, ring: 72, fixed: ring, input: {sun: 1000}}\nquestions: [angular velocity of carrier]\n",
        "write sun: 1000 rad/s",
    ),
    "a length without a unit": (PENDULUM.replace("OWN", "length: 1, mass: 2 kg"), "write length: 1 m"),
    "a length in kilograms": (PENDULUM.replace("OWN", "length: 1 kg, mass: 2 kg"), "given in kg: write length: 1 m"),
    "a length in words": (PENDULUM.replace("OWN", "length: one metre, mass: 2 kg"), "is not a quantity: write"),
    "an angle in metres": (PENDULUM.replace("OWN", "length: 1 m, angle: 3 m"), "write angle: 30 deg"),
    "a mass twice": (PENDULUM.replace("OWN", "length: 1 m, m: 2 kg, mass: 2 kg"), "m and mass say the same"),
    "a mass of an oscillator": ("mass: 2\nstiffness: 50 N/m\nquestions: [period]\n", "write mass: 2 kg"),
    "a stiffness twice": ("mass: 2 kg\nk: 5 N/m\nstiffness: 50 N/m\nquestions: [period]\n", "k and stiffness say"),
    "a speed of a cam": (CAM.replace("OWN", "radius: 4 cm, eccentricity: 1 cm, speed: 12"), "write speed: 12 rad/s"),
    "an axle beside its cam": (CAM.replace("OWN", "radius: 4 cm, eccentricity: 5 cm"), "less than the radius, 4 cm"),
    "a hoop": ("hoop: {radius: 0.3}\nbead: {mass: 0.1 kg}\nquestions: [period]\n", "write radius: 0.3 m"),
    "a beam": (
        "beam: {length: 6}\nsupports: [{type: pin, at: 0}, {type: roller, at: 5 m}]\nquestions: [reaction at A]\n",
        "write length: 6 m",
    ),
    "a support of a beam": (
        "beam: {length: 6 m}\nsupports: [{type: pin, at: 0}, {type: roller, at: 5}]\nquestions: [reaction at A]\n",
        "write at: 5 m",
    ),
    "a member with a mass": (
        TRUSS.replace("MEMBERS", "{AB: {from: A, to: B, mass: 3 kg}, AC: [A, C], BC: [B, C]}").replace(
            "SUPPORTS", SUPPORTS
        ),
        "members.AB.mass: a member of a truss is a massless link",
    ),
    "a roller with friction": (
        TRUSS.replace("MEMBERS", "[AB, AC, BC]").replace("SUPPORTS", "{A: pin, B: {type: roller, friction: 0.2}}"),
        "a roller of a truss has no friction; it is B: roller",
    ),
    "a roller with friction inside": (
        TRUSS.replace("MEMBERS", "[AB, AC, BC]").replace("SUPPORTS", "{A: pin, B: {roller: {friction: 0.2}}}"),
        "a roller of a truss has no friction; it is B: roller",
    ),
    "an eccentricity of a cam with fields": (
        "bodies: {d: {disk: {radius: 4 cm}}, f: {particle: {mass: 1 kg}}}\n"
        "connections: {c: {cam: {cam: d, follower: f, base_radius: 4 cm, eccentricity: 1 cm}}}\n",
        r"lift: e\*\(1 \+ cos\(phi\)\)",
    ),
    "an empty entry above its kind": (
        HELD.replace("{O: {pin: [ground.O, rod.start]}}", "\n  O:\n  pin: [ground.O, rod.start]"),
        "begin the line of pin with two more spaces",
    ),
    "an empty entry above its own name": (
        "bodies:\n  rod:\n  rod: {mass: 2 kg, length: 1 m}\n",
        "begin this line with two more spaces",
    ),
    "a measure with a slip": (
        f"{HELD}measures: {{theta: angel of rod from down}}\n",
        "Did you mean: angle of rod from down$",
    ),
    "a field by its second word with a slip": (
        f"{HELD}loads: {{s: {{spring: {{form: ground.Q, to: rod.end, k: 5 N/m}}}}}}\n",
        "spring has no form. Did you mean from",
    ),
    "a short form that there is not": (
        "geneva_drive: {crank: 5 cm, rod: 20 cm, rpm: 1200}\nquestions: [stroke]\n",
        "there is no section and no short form geneva_drive: short forms are pendulum",
    ),
    "a body that is not indented": (
        "bodies:\nrod: {rod: {mass: 2 kg, length: 1 m}}\nquestions: [acceleration of rod]\n",
        "rod is not indented, so that it is no part of bodies: begin its line with two spaces",
    ),
    "no bodies": ("loads: {w: {gravity: 9.81 m/s^2}}\n", "bodies: {block: {particle: {mass: 1 kg}}}"),
}


@pytest.mark.parametrize("case", WRONG)
def test_what_is_wrong_is_told_once_with_its_cure(case: str) -> None:
    text, said = WRONG[case]
    with pytest.raises(fb.ModelError, match=said.replace("{", r"\{").replace("}", r"\}")) as raised:
        fb.System.from_text(text)
    assert len(raised.value.problems) == 1
    assert raised.value.problems[0].line is not None


def test_a_guide_on_a_body_guides_it_only_where_nothing_else_can_be_meant() -> None:
    text = (
        "bodies: {cart: {block: {mass: 1 kg}}, ram: {block: {mass: 2 kg}}}\n"
        "connections: {a: {slider: {body: cart, along: right}}, b: {slider: {on: BODY, along: up}}}\n"
    )
    told = "b guides ram, along a line of the ground"
    assert told in map(str, fb.System.from_text(text.replace("BODY", "ram")).assumptions)
    with pytest.raises(fb.ModelError, match=r"slider needs body.*slider: \{on: cart, along: up, body: ram\}"):
        fb.System.from_text(text.replace("BODY", "cart"))


def test_slips_inside_of_a_misspelt_kind_are_told_with_it() -> None:
    text = f"{HELD}loads: {{s: {{gravty: {{strength: 9.81 m/s, alnog: down}}}}, t: {{froce: {{at: rod.edn}}}}}}\n"
    with pytest.raises(fb.ModelError) as raised:
        fb.System.from_text(text)
    told = str(raised.value)
    assert "gravty is no kind of load. Did you mean gravity?" in told
    assert "9.81 m/s must be an acceleration" in told or "alnog" in told


def test_a_ball_is_a_spherical_joint_in_space_and_a_pin_in_the_plane() -> None:
    text = HELD.replace("pin: [", "ball: [")
    with pytest.raises(fb.ModelError, match=r"Did you mean pin\?"):
        fb.System.from_text(text)
    with pytest.raises(fb.ModelError, match=r"Did you mean spherical, e\.g\. spherical: \[ground\.A, rod"):
        fb.System.from_text(f"space: true\n{text}")


def test_a_body_that_nothing_holds_and_nobody_names_is_told() -> None:
    text = HELD.replace("bodies: {", "bodies: {bob: {disk: {mass: 1 kg, radius: 0.1 m}}, ")
    text += "loads: {w: {gravity: 9.81 m/s^2}}\nmeasures: {theta: angle of rod}\n"
    (found,) = warnings_of(fb.System.from_text(text))
    assert found.kind == "left alone"
    assert "no connection holds bob" in found.text()
    assert not warnings_of(fb.System.from_text(text.replace("angle of rod}", "angle of rod, y: y of bob}")))
    assert not warnings_of(fb.System.from_text(text.replace("radius: 0.1 m}", "radius: 0.1 m}, velocity: [1 m/s, 0]")))
    weld = "rod.start]}, W: {weld: [rod.end, bob]}}"
    assert not warnings_of(fb.System.from_text(text.replace("rod.start]}}", weld)))


KINDS: dict[str, tuple[str, type[Spec]]] = {
    name: (section, kind)
    for section, kinds in (("connections", Connection.kinds), ("loads", Load.kinds))
    for name, kind in sorted(kinds.items())
    if kind.example
}


def _example(kind: type[Spec]) -> dict[str, Any]:
    """The example of a kind, with bodies by other names than its own."""
    data = Document.read(kind.example).data
    bodies = {name: f"own_{name}" for name in data.get("bodies") or {} if name != "it"}
    data["bodies"] = {bodies.get(name, name): each for name, each in (data.get("bodies") or {}).items()}
    return {section: _renamed(each, bodies) for section, each in data.items()}


def _renamed(value: Any, names: dict[str, str]) -> Any:
    if isinstance(value, dict):
        return {key: _renamed(each, names) for key, each in value.items()}
    if isinstance(value, list):
        return [_renamed(each, names) for each in value]
    for name, own in names.items() if isinstance(value, str) else ():
        value = re.sub(rf"(?<![\w.]){name}\b", own, value)
    return value


@pytest.mark.parametrize("name", KINDS)
def test_an_entry_that_a_message_advises_is_read_where_it_is_pasted(name: str) -> None:
    """Each field that a kind needs is left out in turn."""
    section, kind = KINDS[name]
    entry = _example(kind).get(section, {}).get("it")
    for left in [field.alias or key for key, field in kind.model_fields.items() if field.is_required()]:
        data = _example(kind)
        whole = kind.from_plain(entry[kind.kind]) if entry and kind.kind in entry else {}
        if left not in whole:
            continue
        data[section]["it"] = {**entry, kind.kind: {key: each for key, each in whole.items() if key != left}}
        try:
            fb.System.from_text(flow_text(data))
            continue  # the figure tells what is left out
        except fb.ModelError as error:
            said = str(error)
        told = re.search(rf"e\.g\. ({kind.kind}: .*)$", said, re.MULTILINE)
        assert told is not None, said
        data[section]["it"] = {**entry, **Document.read(f"x: {{{told[1]}}}").data["x"]}
        fb.System.from_text(flow_text(data))


@pytest.mark.parametrize("word", SHORT_FORMS)
def test_every_short_form_that_a_message_names_is_a_section(word: str) -> None:
    """What it says inside is refused for what it says, or for what is left out, and not as an unknown section."""
    with pytest.raises(fb.FreebodyError) as raised:
        fb.System.from_text(f"{word}: {{strange_word: 1 m}}\n")
    assert "no short form" not in str(raised.value)


ROOF = """
truss:
  joints: {A: [0, 0], B: [3 m, 0], C: [6 m, 0], D: [3 m, 2 m]}
  members: [AB, BC, AD, CD, BD]
  supports: {A: pin, C: roller}
  loads: {D: [2 kN, -6 kN], B: [0, -3 kN]}
"""


def test_a_truss_is_a_section_of_its_own() -> None:
    """About A: 6 C = 3*6 + 3*3 + 2*2; at A, AD = -(9 - C) sqrt(13)/2; BD carries the load at B."""
    reaction, rafter, post = fb.System.from_text(ROOF).solve(["reaction at C", "force in AD", "force in BD"]).answers
    assert reaction.value == pytest.approx((0, 31e3 / 6))
    assert rafter.value == pytest.approx(-(9e3 - 31e3 / 6) * 13**0.5 / 2)
    assert post.value == pytest.approx(3e3)
    with pytest.raises(fb.ModelError, match=r"truss\.members\.4: BX is no member"):
        fb.System.from_text(ROOF.replace("BD]", "BX]"))


HOIST = """
parameters: {m: 200 kg, R: 0.2 m, i: 30, J: 0.05 kg m^2, M: 15 N m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], Q: [2 m, 0]}}
bodies: {drum: {disk: {radius: R}}, rotor: {body: {mass: 10 kg, inertia: J}}, load: {particle: {mass: m}}}
measures: {phi: angle of rotor, psi: angle of drum, h: height of load}
connections:
  b1: {pin: [ground.O, drum.center]}
  b2: {pin: [ground.Q, rotor.center]}
  box: BOX
  rope: {string: {from: wound on drum at right, to: load}}
loads: {w: {gravity: g}, motor: {torque: {on: rotor, magnitude: M}}}
"""


def test_gears_with_a_ratio_alone_are_a_constraint() -> None:
    """M i - m g R = (m R^2 + J i^2) psi''."""
    with pytest.raises(fb.ModelError, match=r"constraint: phi - 30\*psi"):
        fb.System.from_text(HOIST.replace("BOX", "{transmission: {first: rotor, second: drum, ratio: i}}"))
    box = fb.System.from_text(HOIST.replace("BOX", "{constraint: phi - i*psi}"))
    (answer,) = box.solve("angular acceleration of drum").answers
    assert answer.value == pytest.approx((15 * 30 - 200 * 9.81 * 0.2) / (200 * 0.2**2 + 0.05 * 30**2))
