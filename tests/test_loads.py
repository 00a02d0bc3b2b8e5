"""Every load: one family of tests that all of them pass, and a closed form for each."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import freebody as fb
import freebody.loads  # registers the kinds
from freebody.loads.base import Load
from freebody.numeric.reference import Reference
from freebody.testing.conformance import LOAD_CHECKS, loaded

Agree = Callable[[fb.Solution, str, str | list[str]], None]
KINDS = sorted(k for k, c in Load.kinds.items() if c.__module__.startswith("freebody."))
SEED = 12


@pytest.mark.parametrize("check", LOAD_CHECKS)
@pytest.mark.parametrize("kind", KINDS)
def test_load_passes_the_conformance_suite(kind: str, check: str) -> None:
    LOAD_CHECKS[check](kind)


@pytest.mark.parametrize("kind", ["damper", "torsional_damper", "drag"])
def test_dampers_only_take_energy(kind: str) -> None:
    reference = Reference(loaded(kind))
    q = reference.assemble()
    generator = np.random.default_rng(SEED)
    for _ in range(20):
        s = reference.snapshot(q, generator.standard_normal(len(q)))
        assert sum(s.law(push) * s.rate(push.measure) for push in reference.system.applied_loads) < 0, f"seed {SEED}"


# -- closed forms -----------------------------------------------------------------------------
CLOSED: dict[str, tuple[str, str, dict[str, str | list[str]]]] = {
    # a cord that is pulled from below the hub of a spool that rolls: about the point of contact
    # (m R^2 + m k^2) x''/R = F (R cos(beta) - r), and F_floor = F cos(beta) - m x''
    "cord that unwinds from a spool": (
        "force",
        """
parameters: {m: 10 kg, R: 0.3 m, r: 0.12 m, k: 0.2 m, F: 20 N, beta: 40 deg, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {spool: {disk: {mass: m, radius: R, hub: r, radius_of_gyration: k}}}
connections: {floor: {rolling: {body: spool, on: floor}}}
loads:
  weight: {gravity: g}
  it: {force: {at: wound on spool.hub at bottom, along: beta, magnitude: F}}
measures: {x: x of spool}
""",
        {
            "acceleration of x": "F*R*(R*cos(beta) - r)/(m*(R**2 + k**2))",
            "friction force of floor": "-F*(k**2*cos(beta) + R*r)/(R**2 + k**2)",
            "value of beta for which acceleration of x = 0": "acos(r/R)",
        },
    ),
    # one that is pulled to the right off the top of a disk on a fixed axle: m R^2/2 alpha = -F R
    "cord that unwinds from a drum clockwise": (
        "force",
        """
parameters: {m: 10 kg, R: 0.3 m, F: 20 N}
bodies: {drum: {disk: {mass: m, radius: R}}}
connections: {axle: {pin: [ground, drum]}}
loads: {it: {force: {at: wound on drum clockwise, along: right, magnitude: F}}}
measures: {phi: angle of drum}
""",
        {"acceleration of phi": "-2*F/(m*R)", "reaction of axle on drum along right": "-F"},
    ),
    # weight along another direction: a = g
    "gravity in a tilted frame": (
        "gravity",
        """
parameters: {m: 2 kg, alpha: 20 deg, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: m}}}
loads: {it: {gravity: {strength: g, along: alpha}}}
""",
        {"acceleration of ball along right": "g*cos(alpha)", "acceleration of ball along up": "g*sin(alpha)"},
    ),
    # m x'' = -k (x - l), energy k (x - l)^2/2 + m x'^2/2; from rest at x0 the speed at x = l is sqrt(k/m) (x0 - l)
    "spring on a rail": (
        "spring",
        """
parameters: {m: 2 kg, k: 50 N/m, l: 1 m, stretch: 0.2 m}
bodies: {block: {particle: {mass: m}}}
connections: {rail: {slider: {body: block, along: right}}}
measures: {x: x of block}
loads: {it: {spring: {first: ground.O, second: block, stiffness: k, length: l}}}
start: {x: l + stretch}
""",
        {
            "force in it": "k*(x - l)",
            "total energy": "m*rate(x)**2/2 + k*(x - l)**2/2",
            "velocity of x when x = l": "-stretch*sqrt(k/m)",
            "time when x = l": "pi/2*sqrt(m/k)",
            "work of it when x = l": "k*stretch**2/2",
        },
    ),
    # m v' = -c v: v = v0 exp(-c t/m), so half the speed after m log(2)/c at x0 + m v0/(2 c)
    "damper on a rail": (
        "damper",
        """
parameters: {m: 2 kg, c: 3 N s/m, v0: 4 m/s, x0: 1 m}
bodies: {block: {particle: {mass: m}}}
connections: {rail: {slider: {body: block, along: right}}}
measures: {x: x of block}
loads: {it: {damper: {first: ground.O, second: block, damping: c}}}
start: {x: x0, rate(x): v0}
""",
        {
            "force in it": "c*rate(x)",
            "power of it": "-c*rate(x)**2",
            "time when rate(x) = v0/2": "m*log(2)/c",
        },
    ),
    "torsional spring on a wheel": (
        "torsional_spring",
        """
parameters: {J: 0.2 kg m^2, k: 5 N m, beta: 10 deg}
bodies: {wheel: {body: {inertia: J, mass: 1 kg}}}
connections: {axle: {pin: [ground.O, wheel]}}
measures: {theta: angle of wheel}
loads: {it: {torsional_spring: {body: wheel, stiffness: k, angle: beta}}}
""",
        {
            "angular acceleration of wheel": "-k*(theta - beta)/J",
            "natural frequency": "sqrt(k/J)",
            "equilibrium of theta": "beta",
        },
    ),
    "torsional damper on a wheel": (
        "torsional_damper",
        """
parameters: {J: 0.2 kg m^2, c: 0.5 N m s, w0: 10 rad/s}
bodies: {wheel: {body: {inertia: J, mass: 1 kg}}}
connections: {axle: {pin: [ground.O, wheel]}}
measures: {theta: angle of wheel}
loads: {it: {torsional_damper: {body: wheel, damping: c}}}
start: {theta: 0, rate(theta): w0}
""",
        {"time when rate(theta) = w0/10": "J*log(10)/c", "power of it": "-c*rate(theta)**2"},
    ),
    # the force changes in time only: m x'' = F0 sin(w t)
    "force that changes in time": (
        "force",
        """
parameters: {m: 2 kg, F0: 3 N, w: 5 rad/s}
bodies: {ball: {particle: {mass: m}}}
loads: {it: {force: {at: ball, along: [3, 4], magnitude: F0*sin(w*t)}}}
""",
        {"acceleration of ball": ["3*F0*sin(w*t)/(5*m)", "4*F0*sin(w*t)/(5*m)"]},
    ),
    # a force that turns with a pinned rod: m L^2/3 theta'' = F L; after one turn its work is 2 pi F L, not zero
    "follower force": (
        "force",
        """
parameters: {m: 3 kg, L: 2 m, F: 4 N}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {hinge: {pin: [ground.O, rod.start]}}
measures: {theta: angle of rod}
loads: {it: {force: {at: rod.end, along: rod.up, magnitude: F}}}
start: {theta: 0}
""",
        {
            "angular acceleration of rod": "3*F/(m*L)",
            "velocity of theta when theta = 2*pi": "sqrt(2*2*pi*F*L/(m*L**2/3))",
            "power of it": "F*L*rate(theta)",
        },
    ),
    # a motor between two free bodies turns them against each other, H = 0
    "torque of a motor that reacts": (
        "torque",
        """
parameters: {I1: 0.2 kg m^2, I2: 0.7 kg m^2, T: 3 N m}
bodies: {rotor: {body: {mass: 1 kg, inertia: I1}}, housing: {body: {mass: 2 kg, inertia: I2}}}
connections: {bearing: {pin: [housing, rotor]}}
loads: {it: {torque: {on: rotor, magnitude: T, reacts_on: housing}}}
""",
        {"angular acceleration of rotor": "T/I1", "angular acceleration of housing": "-T/I2"},
    ),
    # V = k x^4/4: from rest at x0, m v^2/2 = k (x0^4 - x^4)/4
    "cubic spring": (
        "law",
        """
parameters: {m: 2 kg, k: 5 N/m^3, x0: 0.6 m}
bodies: {ball: {particle: {mass: m}}}
connections: {rail: {slider: {body: ball, along: right}}}
measures: {x: x of ball}
loads: {it: {law: {measure: x, force: -k*x^3}}}
start: {x: x0}
""",
        {
            "acceleration of x": "-k*x**3/m",
            "potential energy": "k*x**4/4",
            "velocity of x when x = 0": "-x0**2*sqrt(k/(2*m))",
            "work of it when x = x0/2": "15*k*x0**4/64",
        },
    ),
    # the law may use other measures and rates: a drag by the relative speed
    "law of another measure": (
        "law",
        """
parameters: {m1: 2 kg, m2: 3 kg, c: 5 N s/m}
bodies: {a: {particle: {mass: m1}}, b: {particle: {mass: m2}}}
connections: {r1: {slider: {body: a, along: right}}, r2: {slider: {body: b, along: right}}}
measures: {x1: x of a, x2: x of b}
loads: {it: {law: {measure: {expression: x2 - x1}, force: c*(rate(x1) - rate(x2))}}}
""",
        {"acceleration of x1": "c*(rate(x2) - rate(x1))/m1", "acceleration of x2": "c*(rate(x1) - rate(x2))/m2"},
    ),
    # the work of a constant tension is S times what the string gets shorter
    "collar on a bar": (
        "tensioned_string",
        """
parameters: {m: 2 kg, S: 15 N, h: 1 m, x0: 2 m}
ground: {points: {P: [0, h], W: [-1 m, 0]}}
bodies: {collar: {particle: {mass: m}}}
connections: {bar: {slider: {body: collar, along: right}}}
loads: {it: {tensioned_string: {from: ground.W, over: [ground.P], to: collar, tension: S}}}
measures: {x: x of collar}
start: {x: x0, rate(x): 0}
""",
        {
            "velocity of x when x = 0": "-sqrt(2*S*(sqrt(x0**2 + h**2) - h)/m)",
            "force of it": "S",
            "acceleration of x": "-S*x/(m*sqrt(x**2 + h**2))",
        },
    ),
    # a mass at an elastic string over a pulley that stays taut: the equilibrium is m g/k beyond its length
    "mass at an elastic string": (
        "elastic_string",
        """
parameters: {m: 2 kg, k: 50 N/m, l: 3 m, b: 1 m, g: 9.81 m/s^2}
ground: {points: {P: [0, 0], A: [-b, 0]}}
bodies: {ball: {particle: {mass: m}}}
connections: {way: {slider: {body: ball, along: down}}}
measures: {y: drop of ball below ground.P}
loads:
  weight: {gravity: g}
  it: {elastic_string: {from: ground.A, over: [ground.P], to: ball, stiffness: k, length: l, taut: true}}
start: {y: l - b + m*g/k}
""",
        {
            "acceleration of y": "g - k*(y + b - l)/m",
            "equilibrium of y": "l - b + m*g/k",
            "period of small oscillations": "2*pi*sqrt(m/k)",
            "force of it": "k*(y + b - l)",
        },
    ),
    # m v' = -k v^2: v = v0/(1 + k v0 t/m), and v dv/ds = -k v^2/m: v = v0 exp(-k s/m)
    "a boat that coasts": (
        "drag",
        """
parameters: {m: 2 kg, k: 0.3 kg/m, v0: 4 m/s}
bodies: {boat: {particle: {mass: m}}}
connections: {course: {slider: {body: boat, along: 30 deg}}}
measures: {s: travel of boat along 30 deg}
loads: {it: {drag: {body: boat, quadratic: k}}}
start: {s: 0, rate(s): v0}
""",
        {
            "time when rate(s) = v0/2": "m/(k*v0)",
            "s when rate(s) = v0/2": "m*log(2)/k",
            "force of it at start": "k*v0**2",
        },
    ),
    # v^2 = (m g/k)(1 - exp(-2 k h/m)); freely falling, so that there is no other motion
    "fall against the air": (
        "drag",
        """
parameters: {m: 2 kg, k: 0.3 kg/m, g: 9.81 m/s^2, h: 10 m}
bodies: {ball: {particle: {mass: m}}}
loads: {weight: {gravity: g}, it: {drag: {body: ball, quadratic: k}}}
measures: {y: drop of ball}
start: {y: 0, rate(y): 0}
""",
        {
            "velocity of y when y = h": "sqrt(m*g/k*(1 - exp(-2*k*h/m)))",
            "terminal velocity of y": "sqrt(m*g/k)",
        },
    ),
    # linear in each component: v_x = v0 cos(alpha) exp(-c t/m), and m v_y' = -m g - c v_y
    "throw against the air": (
        "drag",
        """
parameters: {m: 2 kg, c: 0.3 kg/s, g: 9.81 m/s^2, v0: 10 m/s, alpha: 40 deg}
bodies: {ball: {particle: {mass: m}, velocity: [v0*cos(alpha), v0*sin(alpha)]}}
loads: {weight: {gravity: g}, it: {drag: {body: ball, linear: c}}}
measures: {x: x of ball, y: y of ball}
start: {x: 0, y: 0}
""",
        {"velocity of x when rate(y) = 0": "v0*cos(alpha)/(1 + c*v0*sin(alpha)/(m*g))", "force of it at start": "c*v0"},
    ),
    # J w' = T_0 (1 - w/w_0)
    "motor runs up a wheel": (
        "motor",
        """
parameters: {J: 2 kg m^2, T_0: 3 N m, w_0: 50 rad/s}
bodies: {wheel: {body: {inertia: J, mass: 1 kg}}}
connections: {axle: {pin: [ground.O, wheel]}}
measures: {phi: angle of wheel}
loads: {it: {motor: {on: wheel, stall_torque: T_0, no_load_speed: w_0}}}
start: {phi: 0, rate(phi): 0}
""",
        {
            "time when rate(phi) = w_0/2": "J*w_0*log(2)/T_0",
            "torque of it at start": "T_0",
            "power of it": "T_0*rate(phi)*(1 - rate(phi)/w_0)",
        },
    ),
    # p L/2 at 3/4 of the length, always across the lever: m L^2/3 phi'' = 3 p L^2/8
    "lever under a load along it": (
        "distributed",
        """
parameters: {m: 3 kg, L: 2 m, p: 5 N/m}
bodies: {lever: {rod: {mass: m, length: L}}}
connections: {axle: {pin: [ground.A, lever.start]}}
measures: {phi: angle of lever}
loads: {it: {distributed: {between: [lever.center, lever.end], along: lever.y, intensity: p}}}
""",
        {"acceleration of phi": "9*p/(8*m)", "power of it": "3*p*L**2*rate(phi)/8"},
    ),
    # Kepler: r^2 phi' = r_0 v_0 and the energy give the ellipse; straight out, v^2/2 = mu/r - mu/h
    "orbit": (
        "attraction",
        """
parameters: {m: 2 kg, mu: 30 m^3/s^2, r_0: 4 m, v_0: 3 m/s}
bodies: {planet: {particle: {mass: m}, at: [r_0, 0]}}
loads: {it: {attraction: {center: ground.O, strength: mu}}}
measures: {r: distance from ground.O to planet, phi: angle of line from ground.O to planet}
start: {r: r_0, phi: 0, rate(r): 0, rate(phi): v_0/r_0}
""",
        {
            "total energy": "m/2*(rate(r)**2 + r**2*rate(phi)**2) - m*mu/r",
            "force of it": "m*mu/r**2",
            "greatest r": "r_0/(2*mu/(r_0*v_0**2) - 1)",
        },
    ),
    # two bodies pull each other: M a = -m mu/r^2 of the centre, which is a body
    "fall to a body that is free": (
        "attraction",
        """
parameters: {m: 2 kg, M: 5 kg, mu: 30 m^3/s^2, d: 3 m}
bodies: {star: {particle: {mass: M}}, stone: {particle: {mass: m}, at: [d, 0]}}
loads: {it: {attraction: {center: star, strength: mu, on: [stone]}}}
""",
        {
            "acceleration of star along right at start": "m*mu/(M*d**2)",
            "acceleration of stone along right at start": "-mu/d**2",
        },
    ),
    # m d'' = m g - rho g A d
    "buoy": (
        "buoyancy",
        """
parameters: {m: 2 kg, rho: 1000 kg/m^3, A: 0.01 m^2, g: 9.81 m/s^2, h: 0.5 m}
bodies: {buoy: {rectangle: {mass: m, width: 0.1 m, height: h}}}
connections: {guide: {slider: {body: buoy, along: up}}}
loads: {weight: {gravity: g}, it: {buoyancy: {at: buoy.bottom, density: rho, strength: g, area: A}}}
measures: {d: drop of buoy.bottom}
start: {d: 0, rate(d): 0}
""",
        {
            "equilibrium of d": "m/(rho*A)",
            "period of small oscillations": "2*pi*sqrt(m/(rho*A*g))",
            "greatest d": "2*m/(rho*A)",
            "force of it": "rho*A*g*d",
        },
    ),
    # wholly immersed in a viscous liquid: m v' = (rho V - m) g - c v upwards
    "ball that rises in oil": (
        "buoyancy",
        """
parameters: {m: 0.1 kg, rho: 900 kg/m^3, V: 0.5 dm^3, c: 2 N s/m, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: m}}}
loads:
  weight: {gravity: g}
  it: {buoyancy: {at: ball, density: rho, strength: g, volume: V}}
  oil: {drag: {body: ball, linear: c}}
measures: {y: height of ball}
start: {y: 0, rate(y): 0}
""",
        {"acceleration of y at start": "(rho*V - m)*g/m", "terminal velocity of y": "(rho*V - m)*g/c"},
    ),
    # J = m v, and moments about the centre: J a = m r^2/2 w
    "impulse": (
        "impulse",
        """
parameters: {m: 2 kg, r: 0.3 m, J: 5 N s}
bodies: {puck: {disk: {mass: m, radius: r}, points: {rim: [0, r]}}}
loads: {it: {impulse: {at: puck.rim, along: right, magnitude: J}}}
""",
        {"velocity of puck along right at start": "J/m", "angular velocity of puck at start": "-2*J/(m*r)"},
    ),
    "impulse along a body": (
        "impulse",
        """
parameters: {m: 2 kg, L: 1 m, J: 5 N s, alpha: 30 deg}
bodies: {rod: {rod: {mass: m, length: L}, angle: alpha}}
loads: {it: {impulse: {at: rod.end, along: rod.y, magnitude: J}}}
""",
        {"velocity of rod along up at start": "J*cos(alpha)/m", "angular velocity of rod at start": "6*J/(m*L)"},
    ),
    "angular impulse": (
        "angular_impulse",
        """
parameters: {I1: 2 kg m^2, I2: 5 kg m^2, H: 3 N m s}
bodies: {rotor: {body: {mass: 1 kg, inertia: I1}}, frame: {body: {mass: 1 kg, inertia: I2}}}
connections: {bearing: {pin: [frame, rotor]}}
loads: {it: {angular_impulse: {on: rotor, reacts_on: frame, magnitude: H}}}
""",
        {"angular velocity of rotor at start": "H/I1", "angular velocity of frame at start": "-H/I2"},
    ),
}


def test_every_load_has_a_closed_form() -> None:
    assert {kind for kind, _model, _known in CLOSED.values()} == set(KINDS)


@functools.cache
def solved(name: str) -> fb.Solution:
    _kind, model, known = CLOSED[name]
    return fb.solve(fb.System.from_text(model + "questions:\n" + "".join(f"  - {{find: '{q}'}}\n" for q in known)))


@pytest.mark.parametrize(("name", "question"), [(n, q) for n, (_k, _m, known) in CLOSED.items() for q in known])
def test_load_acts_as_derived(name: str, question: str, agrees: Agree) -> None:
    known: dict[str, Any] = CLOSED[name][2]
    agrees(solved(name), f"q{list(known).index(question) + 1}", known[question])


def test_follower_force_has_no_potential_energy() -> None:
    """Its work depends on the way, so the energy of the system grows by it: the kinetic energy is all there is."""
    system = fb.System.from_text(CLOSED["follower force"][1])
    assert fb.solve(system, "potential energy")["q1"].value == 0
    assert fb.solve(system, "potential energy of rod")["q1"].value == 0


def test_relaxed_spring_stores_no_energy(agrees: Agree) -> None:
    system = fb.System.from_text(CLOSED["spring on a rail"][1])
    agrees(fb.solve(system, "potential energy"), "q1", "k*(x - l)**2/2")


def test_a_spring_of_no_length_has_a_force_over_time() -> None:
    """k r, the size of both components, through the anchor and back: from rest at r0, k r0 |cos(sqrt(k/m) t)|."""
    text = """
bodies: {ball: {particle: {mass: 1 kg}}}
connections: {rail: {slider: {body: ball, along: 30 deg, through: ground.O}}}
ground: {points: {O: [0, 0]}}
loads: {it: {spring: {first: ground.O, second: ball, stiffness: 4 N/m, length: 0}}}
measures: {r: {travel of ball along 30 deg from ground.O}}
start: {r: 0.5 m, rate(r): 0}
"""
    dataset = fb.System.from_text(text).simulate(2.0).dataset
    assert dataset["it.force"].values == pytest.approx(2.0 * np.abs(np.cos(2.0 * dataset["time"].values)), abs=1e-6)


def test_what_floats_may_dive_and_leave_the_water() -> None:
    # with h the law is rho g A min(max(d, 0), h)
    system = fb.System.from_text("""
bodies: {buoy: {rectangle: {mass: 1 kg, width: 0.1 m, height: 0.4 m}}}
loads:
  it: {buoyancy: {at: buoy.bottom, density: 1000 kg/m^3, strength: 10 m/s^2, area: 0.01 m^2, height: 0.4 m}}
measures: {d: drop of buoy.bottom}
""")
    assert not system.assumptions
    reference = Reference(system)
    (push,) = system.applied_loads
    for y, force in ((0.5, 0.0), (0.2, 0.0), (0.1, 10.0), (-0.2, 40.0), (-0.9, 40.0)):
        assert reference.snapshot(np.array((0.0, y, 0.0)), np.zeros(3)).law(push) == pytest.approx(force, abs=1e-12)


@pytest.mark.parametrize(
    ("load", "told"),
    [
        ("drag: {body: b}", "give linear: c"),
        ("motor: {on: b, stall_torque: 2 N m, no_load_speed: -5 rad/s}", "act the same way round"),
        ("buoyancy: {at: b, density: 1 kg/m^3, strength: 1 m/s^2}", "give area"),
        ("buoyancy: {at: b, density: 1 kg/m^3, strength: 1 m/s^2, volume: 1 m^3, height: 1 m}", "wholly immersed"),
    ],
)
def test_loads_ask_for_what_is_left_open(load: str, told: str) -> None:
    with pytest.raises(fb.ModelError, match=told):
        fb.System.from_text(f"bodies: {{b: {{disk: {{mass: 1 kg, radius: 1 m}}}}}}\nloads: {{it: {{{load}}}}}")


def test_drag_and_motor_in_space_are_those_of_the_plane() -> None:
    system = fb.System.from_text("""
space: true
bodies:
  ball: {particle: {mass: 2 kg}, velocity: [2 m/s, 3 m/s, 6 m/s]}
  wheel: {disk: {mass: 1 kg, radius: 1 m, axis: x}}
connections: {axle: {revolute: {first: ground.O, second: wheel, about: x}}}
measures: {psi: angle of wheel about x}
loads:
  air: {drag: {body: ball, quadratic: 0.1 kg/m}}
  motor: {motor: {on: wheel, stall_torque: 2 N m, no_load_speed: 50 rad/s, about: x}}
questions: {force: force of air at start, slow: "acceleration of ball along z at start", spin: acceleration of psi}
""")
    solution = system.solve()
    assert solution["force"].value == pytest.approx(4.9)  # 0.1 * 7^2
    assert solution["slow"].value == pytest.approx(-4.9 * 6 / 7 / 2)
    assert solution["spin"].value == pytest.approx(2 / 0.5)  # at rest


def bungee(start: str, *, space: bool) -> fb.System:
    zero = "[0, 0, 0]" if space else "[0, 0]"
    return fb.System.from_text(f"""
space: {str(space).lower()}
parameters: {{m: 70 kg, k: 100 N/m, l: 10 m, g: 9.81 m/s^2}}
ground: {{points: {{A: {zero}}}}}
bodies: {{jumper: {{particle: {{mass: m}}{", at: " + zero if start == "at" else ""}}}}}
loads:
  weight: {{gravity: g}}
  cord: {{elastic_string: {{from: ground.A, to: jumper, stiffness: k, length: l}}}}
measures: {{y: drop of jumper below ground.A}}
{"start: {y: 0, rate(y): 0}" if start == "start" else ""}
""")


@pytest.mark.parametrize("space", [False, True], ids=["plane", "space"])
@pytest.mark.parametrize("start", ["at", "start"])
def test_jumper_who_starts_at_the_anchor_falls_freely_and_is_caught(start: str, space: bool) -> None:
    # m g y = k/2 (y - l)^2 at the lowest place; the speed is greatest where k (y - l) = m g
    m, k, free, g = 70.0, 100.0, 10.0, 9.81
    sag = m * g / k
    lowest = free + sag + math.sqrt(sag * sag + 2 * sag * free)
    fall, omega = math.sqrt(2 * free / g), math.sqrt(k / m)
    lowest_after = fall + (math.pi - math.atan(g * fall / (sag * omega))) / omega
    wanted = {
        "greatest y": lowest,
        "greatest velocity of y": math.sqrt(2 * g * (free + sag) - k / m * sag * sag),
        "greatest force in cord": k * (lowest - free),
        "velocity of y when y = l": math.sqrt(2 * g * free),
        "time when y turns back": lowest_after,
    }
    system = bungee(start, space=space)
    for question, value in wanted.items():
        [answer] = system.solve(question).answers
        assert answer.value == pytest.approx(value, rel=1e-7), question
    motion = system.simulate(2 * lowest_after)
    assert float(motion.dataset["y"][-1]) == pytest.approx(0.0, abs=1e-4)  # it comes back to the anchor


def test_an_elastic_string_is_slack_where_it_is_short() -> None:
    # a jump of 20 m of free fall, then m g y = k (y - l)^2/2 at the lowest point
    system = fb.System.from_text("""
bodies: {jumper: {particle: {mass: 70 kg}}}
connections: {way: {slider: {body: jumper, along: down}}}
loads:
  weight: {gravity: 10 m/s^2}
  cord: {elastic_string: {from: ground.bridge, to: jumper, stiffness: 100 N/m, length: 20 m}}
measures: {y: drop of jumper}
start: {y: 5 m, rate(y): 10 m/s}
""")
    motion = system.simulate(5, every=0.001)
    lowest = max(motion.series["y"][0])
    assert 700 * lowest == pytest.approx(50 * (lowest - 20) ** 2, rel=1e-5)
    assert motion.series["y"][0][1000] == pytest.approx(5 + 10 * 1 + 5 * 1**2, rel=1e-9)  # at 1 s it still falls


@pytest.mark.parametrize("at", ["", ", at: [r_0, 0]"])
def test_a_satellite_is_followed_however_long_it_takes(at: str) -> None:
    """In SI, by a place or by its distance; r_a = r_0/(2 mu/(r_0 v_0^2) - 1), which needs mu < r_0 v_0^2 < 2 mu, and
    T = 2 pi sqrt(a^3/mu) with 2 a = r_0 + r_a (Kepler)."""
    mu, r, v = 4e14, 7e6, 9e3
    model = f"""
parameters: {{m: 2 kg, mu: {mu} m^3/s^2, r_0: {r} m, v_0: {v} m/s}}
bodies: {{satellite: {{particle: {{mass: m}}{at}}}}}
loads: {{it: {{attraction: {{center: ground.O, strength: mu}}}}}}
measures: {{r: distance from ground.O to satellite, phi: angle of line from ground.O to satellite}}
start: {{r: r_0, phi: 0, rate(r): 0, rate(phi): v_0/r_0}}
"""
    system = fb.System.from_text(model)
    apogee = r / (2 * mu / (r * v * v) - 1)
    assert system.solve("greatest r").answers[0].value == pytest.approx(apogee, rel=1e-9)
    period = system.solve("period of r").answers[0].value
    assert period == pytest.approx(2 * math.pi * math.sqrt(((r + apogee) / 2) ** 3 / mu), rel=1e-6)


def test_how_far_a_satellite_gets_is_derived_where_it_gets_farther() -> None:
    """With r_0 v_0^2 < mu it falls at first, and its greatest distance is that of the start."""
    model = (Path(__file__).parents[1] / "examples" / "planet_orbit.yaml").read_text()
    (derivation,) = fb.explain(fb.System.from_text(model), "greatest r").derivations
    assert not derivation.reason


def test_a_preloaded_spring_keeps_a_load_down_until_the_preload_is_overcome() -> None:
    """It pulls with F_0 + k x, x from the start: so that m x'' = F - F_0 - k x."""
    system = fb.System.from_text("""
parameters: {m: 2 kg, k: 100 N/m, F_0: 30 N, F: 50 N}
bodies: {block: {particle: {mass: m}, at: [0.5 m, 0]}}
connections: {rail: {slider: {body: block, along: right}}}
loads:
  spring: {spring: {first: ground.A, second: block, stiffness: k, preload: F_0}}
  pull: {force: {at: block, along: right, magnitude: F}}
measures: {x: travel of block along right}
start: {rate(x): 0}
""")
    assert system.solve("acceleration of x at start")["q1"].value == pytest.approx((50 - 30) / 2)
    assert system.solve("force in spring at start")["q1"].value == pytest.approx(30)
    with pytest.raises(fb.ModelError, match="preload"):
        fb.System.from_text("""
bodies: {block: {particle: {mass: 1 kg}, at: [0.5 m, 0]}}
loads: {it: {spring: {first: ground.A, second: block, stiffness: 1 N/m, preload: 1 N, length: 1 m}}}
""")


IMMERSED = """
parameters: {rho: 1000 kg/m^3, g: 9.81 m/s^2, V: 2 L, m: 0.5 kg, h: 3 m}
ground: {points: {water: [0, 0]}}
bodies: {ball: {particle: {mass: m}, at: [0, -h]}}
loads:
  weight: {gravity: g}
  lift: {buoyancy: {at: ball, density: rho, strength: g, volume: V, surface: ground.water}}
measures: {y: y of ball}
start: {y: -h, rate(y): 0}
"""


def test_a_volume_is_lifted_as_long_as_it_is_in_the_water(agrees: Callable[..., None]) -> None:
    """Released h below the surface it comes up with v^2 = 2 g h (rho V/m - 1), after 0.45 s; what follows is not that
    law any more."""
    system = fb.System.from_text(IMMERSED)
    agrees(system.solve("speed of ball when y = 0"), "q1", "sqrt(2*g*h*(rho*V/m - 1))")
    assert any("ball is in the water" in c for c in system.solve("acceleration of y")["q1"].conditions)
    late = system.solve("speed of ball at t = 1 s")["q1"]
    assert late.value is None
    assert "Not valid for the given numbers" in " ".join(late.notes)
    nowhere = fb.System.from_text(IMMERSED.replace(", surface: ground.water", ""))
    assert not any("in the water" in c for c in nowhere.solve("acceleration of y")["q1"].conditions)


@pytest.mark.parametrize(("given", "n"), [("", 1), (", length: 1 m", 0), (", preload: 5 N", 0)])
def test_a_spring_without_a_length_is_said_to_be_relaxed_at_the_start(given: str, n: int) -> None:
    system = fb.System.from_text(
        "bodies: {b: {particle: {mass: 1 kg}, at: [1 m, 0]}}\n"
        f"loads: {{s: {{spring: {{first: ground.A, second: b, stiffness: 5 N/m{given}}}}}}}\n"
    )
    said = [text for text in system.assumptions if "relaxed" in text]
    assert said == ["the spring from ground.A to b is relaxed at the start"] * n


def test_a_circle_of_a_body_is_no_place_for_a_force() -> None:
    text = """
parameters: {m: 1 kg, R: 0.3 m, r: 0.1 m}
bodies: {spool: {disk: {mass: m, radius: R, hub: r}}}
loads: {pull: {force: {at: spool.hub, along: right, magnitude: 5 N}}}
"""
    with pytest.raises(fb.InputError, match=r"spool.hub is a circle: .* at: wound on spool.hub at bottom"):
        fb.System.from_text(text)


def test_a_cord_that_comes_off_to_either_hand_needs_its_sense() -> None:
    text = """
parameters: {m: 1 kg, R: 0.3 m}
bodies: {drum: {disk: {mass: m, radius: R}}}
loads: {pull: {force: {at: wound on drum at right, along: right, magnitude: 5 N}}}
"""
    with pytest.raises(fb.InputError, match="comes off to either hand"):
        fb.System.from_text(text)


def test_a_cord_pulled_at_an_angle_that_is_not_acute_needs_its_sense() -> None:
    """Beyond a right angle the lowest place of the hub is on the other hand of the cord: R cos(beta) + r."""
    name = "cord that unwinds from a spool"
    text = CLOSED[name][1].replace("beta: 40 deg", "beta: 100 deg")
    with pytest.raises(fb.InputError, match="comes off to either hand"):
        fb.System.from_text(text)
    fb.System.from_text(text.replace("at bottom", "counterclockwise"))
