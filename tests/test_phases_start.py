"""Motions in phases from their first instant: the velocities of the start, impacts, edges that end, ways that turn
round; and that the cases of a distinction exclude each other and cover the whole space of parameters."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from conftest import assert_same_function
from freebody.study.phases.case import PhaseCase
from freebody.study.phases.numbers import coefficients_of_friction, holds
from freebody.study.phases.result import Phases, phases
from freebody.system.system import System
from posed import is_formula

FOLDER = Path(__file__).parents[1] / "examples"
Agree = Callable[[str, str], None]

THROWN = """
freebody: 1
title: thrown from the floor
parameters: {m: 2 kg, u: 3 m/s, v: VELOCITY, e: 0.5, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {particle: {mass: m}}}
connections: {hit: {contact: {between: [ball, floor], restitution: e}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball}
start: {x: 0, y: 0, rate(x): u, rate(y): v}
"""
UP = THROWN.replace("VELOCITY", "4 m/s")
EITHER = THROWN.replace("VELOCITY", "{value: 4 m/s, sign: any}")
ROUGH = """
freebody: 1
title: thrown from a rough floor
parameters: {m: 2 kg, R: 0.1 m, u: 3 m/s, v: 4 m/s, mu: 0.3, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: m, radius: R}}}
connections: {hit: {contact: {between: [ball, floor], friction: mu, restitution: 0.5}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball, turn: angle of ball clockwise}
start: {x: 0, y: R, rate(x): u, rate(y): v, rate(turn): 0}
"""
WALL = """
freebody: 1
title: pushed against a wall
parameters: {m: 2 kg, R: 0.3 m, v: 1.5 m/s, e: 0.5}
ground: {lines: {wall: {along: up}}}
bodies: {ball: {particle: {mass: m}, at: [0, 0]}}
connections: {hit: {contact: {between: [ball, wall], restitution: e}}}
measures: {x: x of ball, y: y of ball}
start: {x: 0, y: 0, rate(x): v, rate(y): v}
"""
CORNER = """
freebody: 1
title: in a corner
parameters: {m: 1 kg, u: {value: 2 m/s, sign: any}, v: {value: 3 m/s, sign: any}, e: 0.5}
ground: {lines: {floor: {along: right}, wall: {along: down}}}
bodies: {p: {particle: {mass: m}}}
connections:
  low: {contact: {between: [p, floor], restitution: e}}
  side: {contact: {between: [p, wall], restitution: e}}
measures: {x: x of p, y: y of p}
start: {x: 0, y: 0, rate(x): u, rate(y): v}
"""
RAIL = """
freebody: 1
title: two disks on a rail
parameters: {m1: 1 kg, m2: 2 kg, v: 3 m/s, w: 1 m/s, r: 0.1 m, d: 1 m, X: 5 m}
bodies:
  a: {disk: {mass: m1, radius: r}, at: [0, 0]}
  b: {disk: {mass: m2, radius: r}, at: [d + 2*r, 0]}
connections:
  ga: {slider: {body: a, along: right}}
  gb: {slider: {body: b, along: right}}
  hit: {contact: {between: [a, b]}}
measures: {x1: x of a, x2: x of b}
start: {x1: 0, x2: d + 2*r, rate(x1): v, rate(x2): w}
"""
PUCK = """
freebody: 1
title: puck against a rough wall
parameters: {m: 1 kg, r: 0.05 m, u: 2 m/s, v: 1 m/s, e: 0.6, mu: 0.2, d: 1 m}
ground: {lines: {wall: {along: up}}}
bodies: {puck: {disk: {mass: m, radius: r}, at: [-d - r, 0]}}
connections: {hit: {contact: {between: [puck, wall], restitution: e, friction: mu}}}
measures: {x: x of puck, y: y of puck, turn: angle of puck}
start: {x: -d - r, y: 0, turn: 0, rate(x): u, rate(y): v, rate(turn): 0}
"""
LOOP = """
freebody: 1
title: disk rolling in a loop
parameters: {m: 1 kg, r: 0.1 m, R: 0.8 m, g: 9.81 m/s^2, v0: 4.5 m/s}
bodies:
  pipe: {ring: {radius: R}, fixed: true}
  disk: {disk: {mass: m, radius: r}, at: [0, r - R]}
connections: {contact: {rolling: {body: disk, inside: pipe}}}
loads: {weight: {gravity: g}}
measures: {phi: angle of line from ground.origin to disk from down}
start: {phi: 0, rate(phi): v0/(R - r)}
"""
DOME = """
freebody: 1
title: bead shot up a dome
parameters: {m: 1 kg, R: 1 m, v: 0.5 m/s, a: 20 deg, g: 9.81 m/s^2}
bodies:
  dome: {disk: {radius: R}, fixed: true}
  bead: {particle: {mass: m}, at: [R*sin(a), R*cos(a)]}
connections: {c: {contact: {between: [bead, dome]}}}
loads: {weight: {gravity: g}}
measures: {phi: angle of line from ground.origin to bead from up clockwise}
start: {phi: a, rate(phi): -v/R}
"""
SPRING = """
freebody: 1
title: block on a spring beside a stop
parameters: {m: 1 kg, v: 2 m/s, k: 50 N/m}
bodies: {block: {particle: {mass: m}}}
connections:
  guide: {slider: {body: block, along: right}}
  end: {stop: {measure: x, min: 0, restitution: 0.4}}
loads: {spring: {force: {at: block, along: right, magnitude: -k*x}}}
measures: {x: x of block}
start: {x: 0, rate(x): v}
"""
TABLE = """
freebody: 1
title: off a table
parameters: {m: 1 kg, r: 0.05 m, L: 1 m, h: 0.8 m, v: 2 m/s, g: 9.81 m/s^2}
bodies:
  table: {polygon: {corners: [[-L, -h/2], [L, -h/2], [L, h/2], [-L, h/2]]}, fixed: true, at: [0, -h/2]}
  p: BODY
connections: {c: {contact: {between: [p, table]}}}
loads: {weight: {gravity: g}}
measures: {x: x of p, y: height of p}
start: {x: 0, y: HEIGHT, rate(x): v, rate(y): 0}
"""
EDGE = TABLE.replace("BODY", "{particle: {mass: m}, at: [0, 0]}").replace("HEIGHT", "0")
ROUND = TABLE.replace("BODY", "{disk: {mass: m, radius: r}, at: [0, r]}").replace("HEIGHT", "r")
STACKED = """
freebody: 1
title: two blocks stacked
parameters: {m: 1 kg, M: 3 kg, v: 2 m/s, mu1: 0.3, mu2: 0.1, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies:
  low: {particle: {mass: M}, lines: {top: {along: right}}}
  up: {particle: {mass: m}}
connections:
  f: {contact: {between: [low, floor], friction: mu2}}
  c: {contact: {between: [up, low.top], friction: mu1}}
loads: {weight: {gravity: g}}
measures: {x: x of low, z: x of up}
start: {x: 0, z: 0, rate(x): 0, rate(z): v}
"""
UPHILL = """
freebody: 1
title: thrown up an incline
parameters: {m: 1 kg, v: 3 m/s, theta: 30 deg, mu_s: 0.5, mu_k: 0.4, g: 9.81 m/s^2}
ground: {lines: {slope: {along: theta}}}
bodies: {b: {particle: {mass: m}}}
connections: {c: {contact: {between: [b, slope], friction: {static: mu_s, kinetic: mu_k}}}}
loads: {weight: {gravity: g}}
measures: {x: travel of b along slope}
start: {x: 0, rate(x): v}
"""


@cache
def system(text: str) -> fb.System:
    return fb.System.from_text(text)


@cache
def cases(text: str) -> Phases:
    return phases(system(text))


def ask(text: str, question: str) -> fb.Answer:
    (answer,) = fb.solve(system(text), question).answers
    assert answer.expression is not None, answer.reason
    return answer


@pytest.fixture
def agrees(agrees_with: Callable[[fb.Answer, str], None]) -> Callable[[str, str, str], None]:
    def check(text: str, question: str, expected: str) -> None:
        agrees_with(ask(text, question), expected)

    return check


@pytest.fixture
def agrees_with() -> Callable[[fb.Answer, str], None]:
    from freebody.language.notation import to_python

    def check(answer: fb.Answer, expected: str) -> None:
        assert not isinstance(answer.expression, tuple)
        assert answer.expression is not None
        assert_same_function(to_python(answer.expression), expected, {})

    return check


# -- the velocities of the start --------------------------------------------------------------
@pytest.mark.parametrize(
    ("question", "expected"),
    [
        ("y when rate(y) = 0", "v**2/(2*g)"),
        ("x when y = 0", "2*u*v/g"),
        ("normal force of hit", "0"),
        ("acceleration of y", "-g"),
        ("velocity of y at start", "v"),
        ("time when hit opens", "0"),
        ("velocity of x when hit opens", "u"),
    ],
)
def test_a_ball_thrown_up_leaves_the_floor_at_once(
    question: str, expected: str, agrees: Callable[[str, str, str], None]
) -> None:
    agrees(UP, question, expected)
    assert cases(UP).cases[0].what.startswith("flies")


@pytest.mark.parametrize(
    ("question", "expected"), [("velocity of x at start", "-e*v"), ("time when y = R", "R/v"), ("x when y = R", "-e*R")]
)
def test_a_ball_that_runs_into_a_wall_at_the_start_rebounds_at_once(
    question: str, expected: str, agrees: Callable[[str, str, str], None]
) -> None:
    agrees(WALL, question, expected)


def test_which_side_of_an_impact_is_meant_is_said() -> None:
    assert "just after the impact of hit at the start" in ask(WALL, "velocity of x at start").notes


def test_the_sign_of_a_velocity_decides_whether_it_flies_or_hits() -> None:
    flies, hits = cases(EITHER).cases
    assert flies.conditions == ("v > 0",)
    assert hits.conditions == ("v < 0",)
    assert not flies.phases[0].impact
    assert hits.phases[0].impact == "impact of hit"


def test_every_pair_of_signs_in_a_corner_has_its_own_case() -> None:
    found = {frozenset(case.conditions): case.phases[0].impact for case in cases(CORNER).cases}
    assert found == {
        frozenset({"u > 0", "v > 0"}): "",
        frozenset({"u < 0", "v > 0"}): "impact of side",
        frozenset({"u > 0", "v < 0"}): "impact of low",
        frozenset({"u < 0", "v < 0"}): "impact of low, side",
    }


def test_a_ball_from_a_rough_floor_does_not_roll_before_it_has_come_back() -> None:
    (answer,) = fb.solve(system(ROUGH), "time when rolling begins").answers
    assert answer.expression is None
    assert "never" not in answer.reason
    # the impulse m (1 + e) v of the floor ends the slip of a sphere, 2/7 m u, if the friction is large enough
    assert any("μ ≥ 4·u/(21·v)" in case.conditions for case in cases(ROUGH).cases)


# -- impacts ----------------------------------------------------------------------------------
def test_the_first_rebound_takes_its_part_of_the_energy(agrees_with: Callable[[fb.Answer, str], None]) -> None:
    ball = fb.System.load(FOLDER / "bouncing_ball.yaml")
    (lost,) = fb.solve(ball, "energy lost until contact opens").answers
    agrees_with(lost, "m*g*h*(1 - e**2)")


@pytest.mark.parametrize(
    ("question", "expected"),
    [
        ("velocity of x1 when x2 = X", "(m1*v + m2*w)/(m1 + m2)"),
        ("velocity of x2 when x2 = X", "(m1*v + m2*w)/(m1 + m2)"),
        ("energy lost until x2 = X", "m1*m2*(v - w)**2/(2*(m1 + m2))"),
    ],
)
def test_an_event_behind_a_plastic_impact_is_behind_it(
    question: str, expected: str, agrees_with: Callable[[fb.Answer, str], None]
) -> None:
    answer = ask(RAIL, question)
    agrees_with(answer, expected)
    assert "v > w" in answer.conditions
    assert answer.value is not None


def test_a_puck_against_a_rough_wall_grips_or_slips(agrees_with: Callable[[fb.Answer, str], None]) -> None:
    answer = ask(PUCK, "velocity of y when hit opens")
    agrees_with(answer, "2*v/3")  # a disk that grips keeps two thirds of its speed along the wall
    assert answer.conditions == ("μ ≥ v/(3·u·(e + 1))",)
    assert len(answer.cases) == 2


# -- energy -----------------------------------------------------------------------------------
def test_a_disk_in_a_loop_swings_leaves_or_goes_round() -> None:
    """u^2 = v0^2 - (4/3) g (R - r)(1 - cos phi), and N = 0 where u^2 = -g (R - r) cos phi: from 4/3 to 11/3."""
    found = {"rolls": 0, "rolls, then flies": 0}
    for v0 in (1.0, 3.0, 3.1, 4.5, 5.0, 5.1, 9.0):
        names = [case.what for case in cases(LOOP).cases if _at(cases(LOOP), case, v0=v0)]
        s = v0**2 / (9.81 * 0.7)
        assert names == ["rolls, then flies" if 4 / 3 < s < 11 / 3 else "rolls"]
        found[names[0]] += 1
    assert min(found.values()) > 1


def _at(found: Phases, case: PhaseCase, **values: float) -> bool:
    own = {p.name: np.array([values.get(p.name, p.value or 0.0)]) for p in found.system.parameters.values()}
    sets = found.tree.sets.at(own)
    return all(holds(r, sets.evaluate(found.tree.home.model, r.element))[0] for r in case.relations)


def test_a_bead_shot_up_a_dome_turns_round_and_leaves_it_on_its_own_side() -> None:
    angle = ask(DOME, "phi when bead leaves the dome").value
    v2 = 0.5**2 / 9.81
    assert isinstance(angle, float)
    assert math.cos(angle) == pytest.approx((2 * math.cos(math.radians(20)) + v2) / 3, abs=1e-12)
    assert angle > 0
    faster = system(DOME).with_parameters(v="1.2 m/s")  # over the top: v^2 > 2 g R (1 - cos a)
    (answer,) = fb.solve(faster, "phi when bead leaves the dome").answers
    assert isinstance(answer.value, float)
    assert answer.value < 0


def test_what_comes_back_to_its_start_hits_the_stop_there(agrees: Callable[[str, str, str], None]) -> None:
    agrees(SPRING, "x when rate(x) = 0", "v*sqrt(m/k)")
    agrees(SPRING, "velocity of x when x = 0", "-v")
    assert "just before the impact of end" in ask(SPRING, "velocity of x when x = 0").notes[0]


# -- edges ------------------------------------------------------------------------------------
def test_a_particle_that_slides_off_a_table_falls(agrees: Callable[[str, str, str], None]) -> None:
    agrees(EDGE, "time when c opens", "L/v")
    agrees(EDGE, "x when y = -h", "L + v*sqrt(2*h/g)")


def test_a_fast_disk_flies_off_the_corner_and_a_slow_one_goes_round_it_first() -> None:
    found = cases(ROUND)
    assert {case.what: case.conditions for case in found.cases} == {
        "moves in contact, then flies": ("v² > r·g",),
        "moves in contact, then moves in contact, then flies": ("r·g ≥ v²",),
    }
    # as from a dome of radius r: m g sin(phi) = m r phi'^2 with r^2 phi'^2 = v^2 + 2 g r (1 - sin(phi))
    assert "opens at φ_c = asin((2·r·g + v²)/(3·r·g)), if r·g > v²" in found.to_text()


# -- cases exclude each other and cover everything --------------------------------------------
EXAMPLES = (
    "ball_in_bowl",
    "ball_leaving_cylinder",
    "ball_with_back_spin",
    "band_brake",
    "billiard_ball",
    "block_on_rough_incline",
    "block_pushed_on_incline",
    "bouncing_ball",
    "capstan",
    "particle_leaving_dome",
    "sphere_launched_down_incline",
)
MODELS = {
    "thrown up": UP,
    "thrown either way": EITHER,
    "rough floor": ROUGH,
    "corner": CORNER,
    "rail": RAIL,
    "puck": PUCK,
    "loop": LOOP,
    "dome": DOME,
    "spring": SPRING,
    "round": ROUND,
    "stacked": STACKED,
    "uphill": UPHILL,
}


@pytest.mark.parametrize("name", [*EXAMPLES, *MODELS])
def test_exactly_one_case_holds_at_parameters_over_ten_decades(name: str) -> None:
    found = cases(MODELS[name]) if name in MODELS else phases(fb.System.load(FOLDER / f"{name}.yaml"))
    tree = found.tree
    sets = tree.sets.at(_drawn(tree.system, 2000))
    sets.constants = {name: sets.evaluate(tree.home.model, x) for name, x in tree.constants.items()}
    inside = np.ones(sets.n, dtype=bool)
    for c in tree.assumed:
        inside &= sets.evaluate(tree.home.model, c.element) > 0
    n_holding = np.zeros(sets.n, dtype=int)
    for case in found.cases:
        inside_case = np.ones(sets.n, dtype=bool)
        for r in case.relations:
            inside_case &= holds(r, sets.evaluate(tree.home.model, r.element))
        n_holding += inside_case
    assert not found.missing
    assert set(n_holding[inside].tolist()) == {1}


def _drawn(model: System, n: int) -> dict[str, np.ndarray]:
    """Values within ten decades, as many of them near those of the file; static friction not below the kinetic one."""
    rng = np.random.default_rng(5)
    friction = coefficients_of_friction(model)
    found: dict[str, np.ndarray] = {}
    for p in model.parameters.values():
        width = np.where(rng.random(n) < 0.5, 1.0, 5.0)
        if p.acute:
            found[p.name] = rng.uniform(1e-3, math.pi / 2 - 1e-3, n)
        elif p.is_share:
            found[p.name] = rng.uniform(0.001, 0.999, n)
        elif p.name in friction:
            found[p.name] = 10 ** rng.uniform(-3.0, 1.0, n)
        else:
            sign = rng.choice((-1.0, 1.0), n) if p.sign == "any" else 1.0
            found[p.name] = sign * (p.value or 1.0) * 10 ** (width * rng.uniform(-1.0, 1.0, n))
    for rub in model.dry_friction:
        s, k = str(getattr(rub.static, "name", "")), str(getattr(rub.kinetic, "name", ""))
        if s != k and s in found and k in found:
            found[s], found[k] = np.maximum(found[s], found[k]), np.minimum(found[s], found[k])
    return found


def test_the_first_phase_of_a_particle_in_space_has_a_closed_form() -> None:
    """Friction R along its height slows it, m u'' = -R: u = v t - R t^2 / (2 m). Of the place that nobody gave no
    symbol is left."""
    system = fb.System.from_text("""
space: true
bodies: {q: {particle: {mass: 3 kg}}}
measures: {u: height of q}
connections: {c: {dry_friction: {measure: u, force: 0.2 N}}}
start: {u: 0, rate(u): 1 m/s}
questions: [time when u = 0.1 m]
""")
    (answer,) = system.solve().answers
    assert answer.value == pytest.approx(15 - math.sqrt(222))
    (derivation,) = system.explain().derivations
    assert not derivation.reason


def test_an_answer_at_an_assembled_start_has_no_symbol_of_a_phase() -> None:
    """A plate hangs on a pin at (0.3, 0), its angle is that of the assembly; a stop makes phases of the motion."""
    system = fb.System.from_text("""
ground: {points: {A: [0.3 m, 0]}}
bodies:
  p: {rectangle: {mass: 10 kg, width: 0.2 m, height: 0.5 m}}
  q: {ring: {mass: 3 kg, radius: 0.125 m}, angle: 180 deg}
measures: {u: distance from q.mass_center to p.top_right}
connections:
  c0: {pin: {first: p.bottom_right, second: ground.A}}
  c1: {stop: {measure: x of p.bottom from q.center, min: 0, restitution: 0.5}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: [instant centre of p, angular acceleration of q relative to p]
""")
    centre, turning = system.solve().answers
    assert centre.value == pytest.approx((0.3, 0.0))
    assert turning.expression is not None
    assert turning.value is None  # the angle of the assembly is no number of the file


# a disk that nothing but the floor has put where it lies is drawn off it at once by a spring from above: it begins at
# the height R, so the spring is as long as h - R, and it lifts where k (h - R - l) > m g
DRAWN_OFF = """
parameters: {m: 2 kg, R: 0.2 m, h: 1 m, k: 200 N/m, l: 0.5 m, g: 9.81 m/s^2}
ground: {points: {S: [0, h]}, lines: {floor: {along: right}}}
bodies: {ball: {disk: {mass: m, radius: R}}}
connections: {contact: {contact: {between: [ball, floor], friction: 0}}}
loads: {weight: {gravity: g}, pull: {spring: {between: [ground.S, ball.center], stiffness: k, length: l}}}
"""


def test_what_opens_at_once_begins_where_it_touched() -> None:
    is_formula(DRAWN_OFF, "force in pull at start", "k*(h - R - l)")
    lifts = is_formula(DRAWN_OFF, "acceleration of ball along up at start", "k*(h - R - l)/m - g")
    assert any(str(c).startswith("m < k·(h - R - l)/g") for c in lifts.conditions)


HOOP = """
parameters: {m: 2 kg, r: 0.2 m, b: 20 deg, s: 3 m, mu: 0.25, g: 9.81 m/s^2}
ground: {lines: {ramp: {along: -b}}}
bodies: {hoop: {ring: {mass: m, radius: r}}}
connections: {roll: {contact: {between: [hoop, ramp], friction: mu}}}
loads: {weight: {gravity: g}}
"""


def test_what_nobody_put_on_its_line_touches_it_where_the_line_begins() -> None:
    """A hoop rolls down with g sin(b)/2. Its middle begins at r (sin(b), cos(b)): over the point that the line goes
    through, where the simulation has it, too."""
    is_formula(HOOP, "speed of hoop when travel of hoop along ramp has moved 3 m", "sqrt(3*g*sin(b))")
    is_formula(HOOP, "time when travel of hoop along ramp has moved s", "2*sqrt(s/(g*sin(b)))")
    is_formula(HOOP, "x of hoop at t = 2 s", "(r + g*cos(b))*sin(b)")


DRAWN_OFF_IN_SPACE = """
space: true
parameters: {m: 2 kg, R: 0.2 m, h: 1 m, k: 200 N/m, l: 0.5 m, g: 9.81 m/s^2}
ground: {points: {S: [0, h, 0]}, planes: {floor: {normal: up}}}
bodies: {ball: {sphere: {mass: m, radius: R}}}
connections: {contact: {contact: {between: [ball, floor], friction: 0}}}
loads: {weight: {gravity: g}, pull: {spring: {between: [ground.S, ball.center], stiffness: k, length: l}}}
"""


def test_what_opens_at_once_in_space_begins_where_it_touched() -> None:
    is_formula(DRAWN_OFF_IN_SPACE, "acceleration of ball along up at start", "k*(h - R - l)/m - g")
