"""Every connection: one family of tests that all of them pass, and a closed form for each."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable

import pytest

import freebody as fb
import freebody.connections  # registers the kinds
from freebody.connections.base import Connection
from freebody.language.expression import free_symbols
from freebody.testing.conformance import CONNECTION_CHECKS, names_of
from posed import is_formula

Agree = Callable[[fb.Solution, str, str | list[str]], None]
KINDS = sorted(k for k, c in Connection.kinds.items() if c.__module__.startswith("freebody."))
NAMES = [name for kind in KINDS for name in names_of(kind)]


@pytest.mark.parametrize("check", CONNECTION_CHECKS)
@pytest.mark.parametrize("kind", NAMES)
def test_connection_passes_the_conformance_suite(kind: str, check: str) -> None:
    CONNECTION_CHECKS[check](kind)


_RISE = "h*w/(2*H*sinh(l*w/(2*H)))"
_MIDDLE = f"log({_RISE} + sqrt(1 + ({_RISE})**2))"  # x_m/a of a chain between unequal supports


# -- one closed form of each ------------------------------------------------------------------
# Per model: the YAML, and by question the formula; the derivation stands above.
CLOSED: dict[str, tuple[str, str, dict[str, str | list[str]]]] = {
    # a wheel whose mass centre is e off the axle turns freely at w: the axle pulls m e w^2
    "pin holds an eccentric wheel": (
        "pin",
        """
parameters: {m: 2 kg, J: 0.3 kg m^2, ecc: 0.02 m, w: 40 rad/s}
bodies: {wheel: {body: {mass: m, inertia: J, center_of_mass: [ecc, 0]}, angular_velocity: w}}
connections: {it: {pin: [ground.O, wheel.origin]}}
""",
        {"size of reaction of it at start": "m*ecc*w**2", "reaction of it at start": ["-m*ecc*w**2", "0"]},
    ),
    # cantilever of weight m g with F at its end: couple m g L/2 + F L, shear m g + F
    "weld of a cantilever carries shear and moment": (
        "weld",
        """
parameters: {m: 2 kg, L: 3 m, F: 50 N, g: 9.81 m/s^2}
bodies: {beam: {rod: {mass: m, length: L}}}
connections: {it: {weld: [ground.A, beam.start]}}
loads: {weight: {gravity: g}, tip: {force: {at: beam.end, along: down, magnitude: F}}}
""",
        {
            "moment of it": "m*g*L/2 + F*L",
            "reaction of it": ["0", "m*g + F"],
            "moment of it on beam about beam.end": "-m*g*L/2",
        },
    ),
    # block on a smooth wedge on a smooth floor (BJ sample problem 12.3): A = m g s c/(M + m s^2)
    "slider on a moving wedge": (
        "slider",
        """
parameters: {m: 2 kg, M: 5 kg, alpha: 30 deg, g: 9.81 m/s^2}
bodies:
  wedge: {particle: {mass: M}}
  block: {particle: {mass: m}}
connections:
  floor: {slider: {body: wedge, along: right}}
  it: {slider: {body: block, along: -alpha, on: wedge}}
loads: {weight: {gravity: g}}
""",
        {
            "acceleration of wedge along right": "-m*g*sin(alpha)*cos(alpha)/(M + m*sin(alpha)**2)",
            "normal force of it": "M*m*g*cos(alpha)/(M + m*sin(alpha)**2)",
            "normal force of floor": "M*(M + m)*g/(M + m*sin(alpha)**2)",
        },
    ),
    # a straight wire y = x tan(beta) is an incline: a = -g sin(beta) cos(beta) along x, N = m g cos(beta)
    "curved rail that is straight": (
        "curved_rail",
        """
parameters: {m: 2 kg, beta: 30 deg, g: 9.81 m/s^2}
bodies: {bead: {particle: {mass: m}, near: {at: [0.5 m, 0.3 m]}}}
connections: {it: {curved_rail: {point: bead, y: x*tan(beta)}}}
loads: {weight: {gravity: g}}
""",
        {"acceleration of bead along right": "-g*sin(beta)*cos(beta)", "normal force of it": "m*g*cos(beta)"},
    ),
    # over the top of a hill y = -a x^2, of radius 1/(2 a), at the speed v: N = m (g - 2 a v^2)
    "curved rail over a hill": (
        "curved_rail",
        """
parameters: {m: 2 kg, a: 0.1 1/m, v: 3 m/s, g: 9.81 m/s^2}
bodies: {cart: {particle: {mass: m}, near: {at: [0, 0]}}}
measures: {x: x of cart}
connections: {it: {curved_rail: {point: cart, y: -a*x^2, leaves: true}}}
loads: {weight: {gravity: g}}
start: {x: 0, rate(x): v}
""",
        {"normal force of it at start": "m*(g - 2*a*v**2)"},
    ),
    # at the lowest point of a bowl of the curvature 2 k, at the speed v: N = m (g + 2 k v^2)
    "surface at the bottom of a bowl": (
        "point_on_surface",
        """
space: {up: z}
parameters: {m: 2 kg, k: 0.5 1/m, v: 3 m/s, g: 9.81 m/s^2}
bodies: {bead: {particle: {mass: m}, at: [0, 0, 0], velocity: [v, 0, 0]}}
connections: {it: {point_on_surface: {point: bead, z: k*rho^2}}}
loads: {weight: {gravity: g}}
""",
        {"normal force of it at start": "m*(g + 2*k*v**2)"},
    ),
    # kappa = s/A^2 after the way s at the speed v: N = m v^2 s/A^2
    "clothoid": (
        "clothoid",
        """
parameters: {m: 2 kg, A: 3 m, v: 4 m/s, b: 2 m}
bodies: {car: {particle: {mass: m}}}
connections: {it: {clothoid: {point: car, scale: A}}}
measures: {s: {parameter of it}}
start: {s: b, rate(s): v}
""",
        {"normal force of it at start": "m*v**2*b/A**2", "acceleration of s": "0"},
    ),
    # down a straight curve as down an incline, 2/3 g sin(beta) along it
    "rolling on a straight curve": (
        "rolling_on_curve",
        """
parameters: {m: 2 kg, r: 0.1 m, beta: 20 deg, g: 9.81 m/s^2}
bodies: {disk: {disk: {mass: m, radius: r}}}
connections: {it: {rolling_on_curve: {body: disk, y: -x*tan(beta)}}}
loads: {weight: {gravity: g}}
""",
        {"acceleration of disk along right": "2/3*g*sin(beta)*cos(beta)", "normal force of it": "m*g*cos(beta)"},
    ),
    "sphere down a plane surface": (
        "rolling_on_surface",
        """
space: {up: z}
parameters: {m: 2 kg, r: 0.1 m, beta: 20 deg, g: 9.81 m/s^2}
bodies: {ball: {sphere: {mass: m, radius: r}, at: [r*sin(beta), 0, r*cos(beta)]}}
connections: {it: {rolling_on_surface: {body: ball, z: -x*tan(beta)}}}
loads: {weight: {gravity: g}}
""",
        {"acceleration of ball along x": "5/7*g*sin(beta)*cos(beta)", "normal force of it": "m*g*cos(beta)"},
    ),
    # the cam at rest carries the tappet: N = m g, held by a torque of N times lift'
    "cam that carries a tappet": (
        "cam",
        """
parameters: {m: 2 kg, r: 0.05 m, h: 0.02 m, w: 5 rad/s, g: 9.81 m/s^2}
bodies: {disk: {body: {inertia: 0.01 kg m^2}}, tappet: {particle: {mass: m}}}
measures: {phi: angle of disk from up}
connections:
  axle: {pin: [ground.O, disk]}
  motor: {driver: {measure: phi, follows: w*t}}
  guide: {slider: {body: tappet, along: up}}
  it: {cam: {cam: disk, follower: tappet, base_radius: r, lift: h*phi^2, along: up}}
loads: {weight: {gravity: g}}
""",
        {"contact force of it": "m*(g + 2*h*w**2)", "driving torque of motor": "2*h*w*t*m*(g + 2*h*w**2)"},
    ),
    # new faces: 2/3 mu F (R^3 - r^3)/(R^2 - r^2); a cone of 1/sin(alpha) times that
    "disc brake with new faces": (
        "disc_clutch",
        """
parameters: {J: 2 kg m^2, F: 500 N, mu: 0.3, r: 0.08 m, R: 0.12 m, w: 40 rad/s}
bodies: {wheel: {body: {inertia: J}, angular_velocity: w}}
connections:
  p: {pin: [ground.O, wheel]}
  it: {disc_clutch: {between: [wheel, ground], force: F, friction: mu, inner_radius: r, outer_radius: R, faces: 4,
    pressure: uniform}}
""",
        {"friction torque of it at start": "-4*2/3*mu*F*(R**3 - r**3)/(R**2 - r**2)"},
    ),
    "cone clutch": (
        "disc_clutch",
        """
parameters: {J: 2 kg m^2, F: 500 N, mu: 0.3, r: 0.08 m, R: 0.12 m, w: 40 rad/s, alpha: 12 deg}
bodies: {wheel: {body: {inertia: J}, angular_velocity: w}}
connections:
  p: {pin: [ground.O, wheel]}
  it: {disc_clutch: {between: [wheel, ground], force: F, friction: mu, inner_radius: r, outer_radius: R,
    cone_angle: alpha}}
""",
        {"friction torque of it at start": "-mu*F*(R + r)/(2*sin(alpha))"},
    ),
    # a screw locks itself where mu >= tan(lambda) = p/(2 pi r)
    "screw that locks itself": (
        "screw",
        """
space: {up: z}
parameters: {m: 100 kg, g: 9.81 m/s^2, p: 8 mm, r: 15 mm, mu: 0.15, J: 0.05 kg m^2}
bodies: {spindle: {body: {mass: m, inertia: J}}}
connections: {it: {screw: {first: ground.A, second: spindle, about: z, pitch: p, friction: mu, radius: r}}}
loads: {weight: {gravity: g}}
measures: {phi: angle of spindle about z}
start: {phi: 0, rate(phi): 0}
""",
        {"least mu so that it stays at rest": "p/(2*pi*r)", "range of p that keeps it at rest": "2*pi*r*mu"},
    ),
    # Scotch yoke x = r cos(w t); T w = m x'' x'
    "slot of a Scotch yoke moves harmonically": (
        "slot",
        """
parameters: {r: 0.1 m, m: 3 kg, w: 10 rad/s}
bodies:
  crank: {rod: {length: r}}
  yoke: {particle: {mass: m}}
  frame: {rectangle: {width: 1 m, height: 1 m}}
connections:
  main: {pin: [ground.O, crank.start]}
  guide: {slider: {body: frame, along: right}}
  rivet: {pin: [frame, yoke]}
  it: {slot: {pin: crank.end, along: up, on: frame}}
  motor: {driver: {measure: angle of crank, follows: w*t}}
""",
        {
            "acceleration of yoke along right": "-r*w**2*cos(w*t)",
            "velocity of yoke along right": "-r*w*sin(w*t)",
            "driving torque of motor": "m*r**2*w**2*sin(w*t)*cos(w*t)",
            "size of reaction of rivet at start": "m*r*w**2",
        },
    ),
    # ladder of two masses on a massless link: (m1 c^2 + m2 s^2) L phi'' = m2 g s + (m1 - m2) L s c phi'^2 and
    # m1 (L sin(phi))'' = -S sin(phi)
    "link between two guided masses": (
        "link",
        """
parameters: {m1: 2 kg, m2: 3 kg, L: 1 m, beta: 30 deg, g: 9.81 m/s^2}
bodies: {foot: {particle: {mass: m1}}, top: {particle: {mass: m2}}}
connections:
  floor: {slider: {body: foot, along: right, through: ground.O}}
  wall: {slider: {body: top, along: up, through: ground.O}}
  it: {link: [foot, top, L]}
loads: {weight: {gravity: g}}
measures: {phi: angle of line from foot to top from up}
start: {phi: beta}
""",
        {
            "degrees of freedom": "1",
            "acceleration of phi": "(m2*g*sin(phi)/L + (m1 - m2)*sin(phi)*cos(phi)*rate(phi)**2)"
            "/(m1*cos(phi)**2 + m2*sin(phi)**2)",
            "tension of it at start": "-m1*m2*g*cos(beta)/(m1*cos(beta)**2 + m2*sin(beta)**2)",
        },
    ),
    # a disk rolls off a fixed drum: 3/2 (R + r) phi'' = g sin(phi), m g cos(phi) - N = m (R + r) phi'^2
    "rolling on the outside of a drum": (
        "rolling",
        """
parameters: {m: 2 kg, r: 0.1 m, R: 0.5 m, g: 9.81 m/s^2}
bodies:
  drum: {disk: {radius: R}, fixed: true}
  roll: {disk: {mass: m, radius: r}, at: [0, R + r]}
connections: {it: {rolling: {body: roll, on: drum}}}
loads: {weight: {gravity: g}}
measures: {phi: angle of line from ground.origin to roll from up clockwise}
start: {phi: 0}
""",
        {
            "acceleration of phi": "2*g*sin(phi)/(3*(R + r))",
            "normal force of it": "m*g*cos(phi) - m*(R + r)*rate(phi)**2",
            "ratio of angular velocity of roll to velocity of phi": "-(R + r)/r",
        },
    ),
    # a disk inside a ring that turns freely about its fixed centre, both about the contact:
    # I_ring = M R^2; rolling: R w_ring = (R - r) phi' + r w_roll
    "rolling inside a ring that turns": (
        "rolling",
        """
parameters: {m: 2 kg, r: 0.1 m, M: 3 kg, R: 0.5 m, g: 9.81 m/s^2}
bodies:
  ring: {ring: {mass: M, radius: R}}
  roll: {disk: {mass: m, radius: r}, at: [0, r - R]}
connections:
  axle: {pin: [ground.O, ring]}
  it: {rolling: {body: roll, inside: ring}}
loads: {weight: {gravity: g}}
measures: {phi: angle of line from ground.origin to roll from down, psi: angle of ring}
start: {phi: 0, psi: 0}
""",
        # friction F on the roll in the direction of phi: m D phi'' = -m g s + F, m r/2 w' = F, M R psi'' = -F,
        # R psi'' = D phi'' + r w'  =>  F (1/m + 2/m + 1/M) = g s ... with D = R - r
        {
            "acceleration of phi": "-g*sin(phi)*(1 - 1/(1 + 2 + m/M))/(R - r)",
            "acceleration of psi": "-g*sin(phi)/(1 + 2 + m/M)*m/(M*R)",
            "normal force of it": "m*g*cos(phi) + m*(R - r)*rate(phi)**2",
        },
    ),
    # I1 a1 = T - F r1, I2 a2 = F r2, r1 a1 = r2 a2 (open); a2 changes its sign with a crossed belt
    "open belt": (
        "belt",
        """
parameters: {I1: 0.1 kg m^2, I2: 0.5 kg m^2, r1: 0.1 m, r2: 0.3 m, T: 2 N m}
ground: {points: {A: [0, 0], B: [1 m, 0]}}
bodies: {a: {body: {inertia: I1, radius: r1}}, b: {body: {inertia: I2, radius: r2}}}
connections: {p: {pin: [ground.A, a]}, q: {pin: [ground.B, b]}, it: {belt: [a, b]}}
loads: {drive: {torque: {on: a, magnitude: T}}}
""",
        {
            "angular acceleration of a": "T*r2**2/(I1*r2**2 + I2*r1**2)",
            "angular acceleration of b": "T*r1*r2/(I1*r2**2 + I2*r1**2)",
            "belt force of it": "T*I2*r1/(I1*r2**2 + I2*r1**2)",
        },
    ),
    "crossed belt": (
        "belt",
        """
parameters: {I1: 0.1 kg m^2, I2: 0.5 kg m^2, r1: 0.1 m, r2: 0.3 m, T: 2 N m}
ground: {points: {A: [0, 0], B: [1 m, 0]}}
bodies: {a: {body: {inertia: I1, radius: r1}}, b: {body: {inertia: I2, radius: r2}}}
connections: {p: {pin: [ground.A, a]}, q: {pin: [ground.B, b]}, it: {belt: {first: a, second: b, crossed: true}}}
loads: {drive: {torque: {on: a, magnitude: T}}}
""",
        {
            "angular acceleration of a": "T*r2**2/(I1*r2**2 + I2*r1**2)",
            "angular acceleration of b": "-T*r1*r2/(I1*r2**2 + I2*r1**2)",
            "belt force of it": "T*I2*r1/(I1*r2**2 + I2*r1**2)",
        },
    ),
    # a pinion in a ring gear on fixed axles turns it the same way: a_ring = a r/R; F r = I_ring a_ring r/R
    "internal gear": (
        "gear_mesh",
        """
parameters: {Ip: 0.01 kg m^2, Ir: 0.4 kg m^2, r: 0.05 m, R: 0.2 m, T: 2 N m}
ground: {points: {A: [0, 0], B: [R - r, 0]}}
bodies: {ring: {body: {inertia: Ir, radius: R}}, pinion: {body: {inertia: Ip, radius: r}}}
connections:
  p: {pin: [ground.A, ring]}
  q: {pin: [ground.B, pinion]}
  it: {gear_mesh: {first: ring, second: pinion, internal: true}}
loads: {drive: {torque: {on: pinion, magnitude: T}}}
""",
        {
            "angular acceleration of pinion": "T/(Ip + Ir*r**2/R**2)",
            "angular acceleration of ring": "T*r/R/(Ip + Ir*r**2/R**2)",
            # the pinion pushes the ring counter-clockwise, so the force on it is against "resists"
            "tooth force of it": "-Ir*T*r/R**2/(Ip + Ir*r**2/R**2)",
        },
    ),
    # a falling rack turns the pinion: m g - F = m a, F r = I a/r; the rack on its left turns it counter-clockwise
    "falling rack": (
        "rack_and_pinion",
        """
parameters: {m: 3 kg, J: 0.01 kg m^2, r: 0.05 m, g: 9.81 m/s^2}
bodies: {gear: {body: {inertia: J, radius: r}}, bar: {rectangle: {mass: m, width: 0.02 m, height: 1 m}}}
connections:
  p: {pin: [ground.A, gear]}
  guide: {slider: {body: bar, along: down}}
  it: {rack_and_pinion: {pinion: gear, rack: bar, along: down}}
loads: {weight: {gravity: g}}
""",
        {
            "acceleration of bar along down": "m*g/(m + J/r**2)",
            "angular acceleration of gear": "m*g/(m + J/r**2)/r",
            "tooth force of it": "-J/r**2*m*g/(m + J/r**2)",
        },
    ),
    # teeth above the pinion: it turns the other way
    "rack above": (
        "rack_and_pinion",
        """
parameters: {m: 3 kg, J: 0.01 kg m^2, r: 0.05 m, F: 5 N}
bodies: {gear: {body: {inertia: J, radius: r}}, bar: {rectangle: {mass: m, width: 1 m, height: 0.02 m}}}
connections:
  p: {pin: [ground.A, gear]}
  guide: {slider: {body: bar, along: right}}
  it: {rack_and_pinion: {pinion: gear, rack: bar, above: true}}
loads: {push: {force: {at: bar, along: right, magnitude: F}}}
""",
        {
            "acceleration of bar along right": "F/(m + J/r**2)",
            "angular acceleration of gear": "-F/(m + J/r**2)/r",
        },
    ),
    # movable pulley (MK sample problem 3/2): 2 x2 + x1 = const, m1 g - S = m1 a1, m2 g - 2 S = -m2 a1/2
    "string under a movable pulley": (
        "string",
        """
parameters: {m1: 2 kg, m2: 3 kg, R: 0.1 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], C: [-0.4 m, 0]}}
bodies:
  fixed_pulley: {disk: {radius: R}}
  moving: {disk: {mass: m2, radius: R}}
  weight: {particle: {mass: m1}}
connections:
  axle: {pin: [ground.O, fixed_pulley]}
  it: {string: {path: [ground.C, under moving, over fixed_pulley, weight], grips: [fixed_pulley]}}
loads: {gravity: {gravity: g}}
""",
        {
            "acceleration of weight along down": "g*(4*m1 - 2*m2)/(4*m1 + m2)",
            "acceleration of moving along up": "g*(2*m1 - m2)/(4*m1 + m2)",
            "tension of it between moving and fixed_pulley": "3*m1*m2*g/(4*m1 + m2)",
        },
    ),
    # n falls carry the load, hauled over a fixed block: n F - m g = m a (MK sec. 4/6)
    "tackle of n falls": (
        "string",
        """
parameters: {m: 100 kg, n: 4, r: 0.1 m, F: 300 N, g: 9.81 m/s^2}
bodies: {upper: {disk: {radius: r}}, load: {particle: {mass: m}}, hand: {particle: {mass: 0}}}
connections:
  axle: {pin: [ground.top, upper]}
  it: {string: {from: hand, over: [upper], to: load, falls: n}}
loads: {gravity: {gravity: g}, pull: {force: {at: hand, along: down, magnitude: F}}}
""",
        {
            "acceleration of load along up": "n*F/m - g",
            "reaction of axle along up": "(n + 1)*F",
            "tension of it at load": "F",
        },
    ),
    # the hauling part leaves the moving block and carries as well: 4 F - m g = m a
    "tackle hauled from the moving block": (
        "string",
        """
parameters: {m: 100 kg, r: 0.1 m, F: 300 N, g: 9.81 m/s^2}
bodies: {block: {disk: {radius: r}}, load: {particle: {mass: m}}, hand: {particle: {mass: 0}}}
connections:
  it: {string: {path: [hand, under block, ground.top], falls: 3}}
  hook: {string: [block, load]}
loads: {gravity: {gravity: g}, pull: {force: {at: hand, along: up, magnitude: F}}}
""",
        {"acceleration of load along up": "4*F/m - g"},
    ),
    # n S d/dphi |A B| of a boom of the length L below a mast of the height b: n S = (m + M/2) g |A B|/b
    "topping lift of a derrick": (
        "string",
        """
parameters: {L: 8 m, b: 5 m, m: 1000 kg, M: 200 kg, phi_0: 40 deg, R: 0.2 m, g: 9.81 m/s^2}
ground: {points: {foot: [0, 0], top: [0, b], W: [-3 m, 0]}}
bodies: {boom: {rod: {length: L, mass: M}}, drum: {disk: {radius: R}}, load: {particle: {mass: m}}}
connections:
  foot: {pin: [ground.foot, boom.start]}
  winch: {pin: [ground.W, drum]}
  it: {string: {path: [wound on drum at left, over ground.top, boom.end], falls: 5}}
  hook: {string: [boom.end, load]}
  turning: {driver: {measure: psi, follows: 0}}
loads: {weight: {gravity: g}}
measures: {phi: angle of boom, psi: angle of drum}
start: {phi: phi_0}
""",
        {"tension of it at boom": "g*(2*m + M)*sqrt(L**2 - 2*L*b*sin(phi_0) + b**2)/(10*b)"},
    ),
    # supports at different heights: H = q l^2/(8 f), V = q l/2 -+ H h/l (BJ sec. 7.4)
    "cable with an even load": (
        "hanging_cable",
        """
parameters: {l: 90 m, h: 12 m, q: 400 N/m, f: 8 m, M: 50 kg, b: 6 m, g: 9.81 m/s^2}
ground: {points: {A: [0, 0], B: [l, b + h]}}
bodies: {mast: {rod: {length: b, mass: M}, angle: 90 deg}}
connections:
  foot: {weld: [ground.A, mast.start]}
  it: {hanging_cable: {between: [mast.end, ground.B], load: q, sag: f}}
loads: {weight: {gravity: g}}
""",
        {
            "moment of foot": "b*q*l**2/(8*f)",
            "reaction of foot along up": "M*g + q*l/2 - q*l*h/(8*f)",
            "tension of it at mast": "q*l/(8*f)*sqrt(l**2 + (4*f - h)**2)",
            "greatest tension of it": "q*l/(8*f)*sqrt(l**2 + (4*f + h)**2)",
        },
    ),
    # the same from the right to the left; y = a cosh(x/a) with sinh(x_m/a) = h/(2 a sinh(l/(2 a))) (BJ sec. 7.5)
    "chain between unequal supports": (
        "hanging_cable",
        """
parameters: {l: 90 m, h: 12 m, w: 400 N/m, H: 60 kN}
ground: {points: {A: [0, 0], B: [l, h]}}
bodies: {mast: {rod: {length: 1 m, mass: 0}, angle: 90 deg}}
connections:
  foot: {weld: [ground.A, mast.end]}
  it: {hanging_cable: {between: [ground.B, mast.end], weight: w, pull: H}}
""",
        {
            "length of it": "sqrt(h**2 + (2*H/w*sinh(l*w/(2*H)))**2)",
            "tension of it at mast": f"H*cosh({_MIDDLE} - l*w/(2*H))",
            "reaction of foot along up": f"H*sinh(l*w/(2*H) - {_MIDDLE})",
        },
    ),
    # a sled that the model puts on its ramp, where the string leaves the pulley along it, is pulled along it as one is
    # that has no place: (m1 + m2 + M/2) a = (m2 - m1 sin alpha) g
    "string along the ramp to a sled with a place": (
        "string",
        """
parameters: {m1: 4 kg, m2: 3 kg, M: 1 kg, r: 0.1 m, alpha: 30 deg, g: 9.81 m/s^2}
ground: {points: {top: [0, 0]}, lines: {ramp: {angle: alpha, through: [-r*sin(alpha), r*cos(alpha)]}}}
bodies:
  sled: {particle: {mass: m1}, at: [-r*sin(alpha) - 2 m*cos(alpha), r*cos(alpha) - 2 m*sin(alpha)]}
  load: {particle: {mass: m2}, at: [r, -1 m]}
  pulley: {disk: {mass: M, radius: r}, at: [0, 0]}
connections:
  hub: {pin: [ground.top, pulley.center]}
  run: {slider: [sled, ground.ramp]}
  hang: {slider: {body: load, along: up}}
  it: {string: {path: [sled, over pulley, load]}}
loads: {gravity: {gravity: g}}
""",
        {
            "acceleration of load along down": "2*g*(m2 - m1*sin(alpha))/(2*m1 + 2*m2 + M)",
            "tension of it at load": "m2*g*(1 - 2*(m2 - m1*sin(alpha))/(2*m1 + 2*m2 + M))",
        },
    ),
    # a string wound on a drum with a bearing: m g - S = m a, S R = I a/R
    "string unwinds from a drum": (
        "string",
        """
parameters: {m: 2 kg, J: 0.3 kg m^2, R: 0.2 m, g: 9.81 m/s^2}
bodies: {drum: {body: {inertia: J, radius: R}}, bucket: {particle: {mass: m}}}
connections:
  axle: {pin: [ground.O, drum]}
  it: {string: {from: wound on drum at right, to: bucket}}
loads: {gravity: {gravity: g}}
""",
        {
            "acceleration of bucket along down": "g/(1 + J/(m*R**2))",
            "angular acceleration of drum": "-g/(1 + J/(m*R**2))/R",
            "tension of it": "J/R**2*g/(1 + J/(m*R**2))",
        },
    ),
    # one run goes up by R w and the other one down by r w: the block rises by half of the difference and turns by
    # (R + r) w/(2 a) = w with its radius a = (R + r)/2; J a from T and the weight at the arm (R - r)/2
    "a block in the loop of a differential hoist": (
        "string",
        """
parameters: {m: 50 kg, J: 0.2 kg m^2, R: 0.12 m, r: 0.1 m, T: 6 N m, g: 9.81 m/s^2}
bodies: {shaft: {body: {inertia: J, radius: R}}, block: {disk: {mass: m, radius: (R + r)/2}}}
connections:
  axle: {pin: [ground.O, shaft]}
  it: {string: {path: [wound on shaft radius R at right, under block, wound on shaft radius r at left]}}
loads: {gravity: {gravity: g}, crank: {torque: {on: shaft, magnitude: T}}}
""",
        {
            "ratio of angular velocity of block to angular velocity of shaft": "1",
            "ratio of velocity of block along up to angular velocity of shaft": "(R - r)/2",
            "angular acceleration of shaft": "(T - m*g*(R - r)/2)/(J + m*(R - r)**2/4 + m*(R + r)**2/8)",
        },
    ),
    # three pulleys with inertia (m_k R_k^2/2) in a row: (m1 + m2 + (M1 + M2 + M3)/2) a = (m1 - m2) g
    "string over three pulleys with mass": (
        "string",
        """
parameters: {m1: 5 kg, m2: 2 kg, M1: 1 kg, M2: 2 kg, M3: 3 kg, R: 0.1 m, g: 9.81 m/s^2}
ground: {points: {A: [0, 0], B: [1 m, 0], C: [2 m, 0]}}
bodies:
  left: {particle: {mass: m1}}
  p1: {disk: {mass: M1, radius: R}}
  p2: {disk: {mass: M2, radius: 2*R}}
  p3: {disk: {mass: M3, radius: 3*R}}
  right_weight: {particle: {mass: m2}}
connections:
  a1: {pin: [ground.A, p1]}
  a2: {pin: [ground.B, p2]}
  a3: {pin: [ground.C, p3]}
  it: {string: {path: [left, over p1, over p2, over p3, right_weight]}}
loads: {gravity: {gravity: g}}
""",
        {
            "acceleration of left along down": "(m1 - m2)*g/(m1 + m2 + (M1 + M2 + M3)/2)",
            "tension of it between left and p1": "m1*g*(1 - (m1 - m2)/(m1 + m2 + (M1 + M2 + M3)/2))",
            "tension of it between p2 and p3": "m2*g + (m2 + M3/2)*(m1 - m2)*g/(m1 + m2 + (M1 + M2 + M3)/2)",
            "angular acceleration of p3": "(m1 - m2)*g/(m1 + m2 + (M1 + M2 + M3)/2)/(3*R)",
        },
    ),
    # a rod turned at w against its weight needs the torque m g L/2 cos(w t); uniform, so no inertia
    "driver turns a rod": (
        "driver",
        """
parameters: {m: 2 kg, L: 1 m, w: 3 rad/s, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {p: {pin: [ground.A, rod.start]}, it: {driver: {measure: angle of rod, follows: w*t}}}
loads: {weight: {gravity: g}}
""",
        {
            "degrees of freedom": "0",
            "driving torque of it": "m*g*L/2*cos(w*t)",
            "power of it": "m*g*L/2*w*cos(w*t)",
            "horizontal reaction of p": "-m*L/2*w**2*cos(w*t)",
        },
    ),
    # bead on the parabola y = x^2/(2 p): L = m (1 + x^2/p^2) x'^2/2 - m g x^2/(2 p)
    "constraint of a parabolic wire": (
        "constraint",
        """
parameters: {m: 1 kg, p: 0.5 m, g: 9.81 m/s^2}
bodies: {bead: {particle: {mass: m}}}
measures: {x: x of bead, y: y of bead}
connections: {it: {constraint: y - x^2/(2*p)}}
loads: {weight: {gravity: g}}
start: {x: 0}
""",
        {
            "degrees of freedom": "1",
            "acceleration of x": "-(x*rate(x)**2/p**2 + g*x/p)/(1 + x**2/p**2)",
            "natural frequency": "sqrt(g/p)",
        },
    ),
    # Chaplygin sleigh: v' = a w^2, (I + m a^2) w' = -m a v w (Neimark & Fufaev, Nonholonomic Systems)
    "velocity constraint of the Chaplygin sleigh": (
        "velocity_constraint",
        """
parameters: {m: 3 kg, J: 0.5 kg m^2, a: 0.4 m, v: 2 m/s, w: 1.5 rad/s}
bodies: {sleigh: {body: {mass: m, inertia: J, center_of_mass: [a, 0]}}}
measures: {x: x of sleigh, y: y of sleigh, theta: angle of sleigh}
connections: {it: {velocity_constraint: rate(y)*cos(theta) - rate(x)*sin(theta)}}
start: {x: 0, y: 0, theta: 0, rate(x): v, rate(theta): w}
""",
        {
            "angular acceleration of sleigh at start": "-m*a*v*w/(J + m*a**2)",
            "acceleration of x at start": "a*w**2",
            # across the blade: m (v w + a w') = R
            "constraint force of it at start": "m*(v*w - m*a**2*v*w/(J + m*a**2))",
        },
    ),
    # a disk thrown along a rough floor: m x' = m v0 - mu m g t, I w = mu m g R t until x' = R w
    "contact of a disk that slides, then rolls": (
        "contact",
        """
parameters: {m: 2 kg, R: 0.2 m, v0: 3 m/s, mu: 0.3, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {disk: {disk: {mass: m, radius: R}}}
connections: {it: {contact: {between: [disk, floor], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: x of disk}
start: {x: 0, rate(x): v0}
""",
        {
            "acceleration of x at start": "-mu*g",
            "time when rolling begins": "v0/(3*mu*g)",
            "velocity of x when rolling begins": "2*v0/3",
            "normal force of it at start": "m*g",
        },
    ),
    # I w = T t
    "brake of a drum": (
        "brake",
        """
parameters: {m: 2 kg, R: 0.2 m, w: 30 rad/s, T: 0.5 N m}
bodies: {drum: {disk: {mass: m, radius: R}, angular_velocity: w}}
connections: {p: {pin: [ground.A, drum]}, it: {brake: {between: [drum, ground], torque: T}}}
measures: {theta: angle of drum}
start: {theta: 0}
""",
        {
            "angular acceleration of drum at start": "-2*T/(m*R**2)",
            "time when slipping ends": "m*R**2*w/(2*T)",
            "theta when slipping ends": "m*R**2*w**2/(4*T)",
        },
    ),
    "dry friction of a block": (
        "dry_friction",
        """
parameters: {m: 2 kg, F: 3 N, v0: 2 m/s}
bodies: {b: {particle: {mass: m}}}
measures: {x: x of b}
connections: {rail: {slider: {body: b, along: right}}, it: {dry_friction: {measure: x, force: F}}}
start: {x: 0, rate(x): v0}
""",
        {
            "acceleration of x at start": "-F/m",
            "time when slipping ends": "m*v0/F",
            "x when slipping ends": "m*v0**2/(2*F)",
        },
    ),
    # a block hinged at the middle of one face: I = m (a^2 + b^2)/12 + m a^2/4
    "revolute joint of a hinged block": (
        "revolute",
        """
space: true
parameters: {m: 2 kg, a: 0.6 m, b: 0.2 m, g: 9.81 m/s^2}
bodies: {block: {box: {mass: m, size: [a, b, 0.1 m]}}}
connections: {it: {revolute: {first: ground.A, second: block.left, about: z}}}
loads: {weight: {gravity: g}}
measures: {theta: angle of block about z}
start: {theta: 0}
""",
        {"acceleration of theta": "-m*g*a/2*cos(theta)/(m*(a**2 + b**2)/12 + m*a**2/4)", "degrees of freedom": "1"},
    ),
    "prismatic joint along a slope": (
        "prismatic",
        """
space: true
parameters: {m: 2 kg, alpha: 30 deg, g: 9.81 m/s^2}
bodies: {block: {box: {mass: m, size: [0.1 m, 0.1 m, 0.1 m]}}}
connections: {it: {prismatic: {first: ground.A, second: block, along: [0, sin(alpha), cos(alpha)]}}}
loads: {weight: {gravity: g}}
measures: {s: "travel of block along [0, sin(alpha), cos(alpha)]"}
start: {s: 0}
""",
        {"acceleration of s": "-g*sin(alpha)", "reaction of it along x": "0"},
    ),
    # travel and turn do not know of each other
    "cylindrical joint of a falling collar": (
        "cylindrical",
        """
space: true
parameters: {m: 2 kg, J: 0.1 kg m^2, T: 0.4 N m, g: 9.81 m/s^2}
bodies: {collar: {body: {mass: m, inertia: [J, J, J]}}}
connections: {it: {cylindrical: {first: ground.A, second: collar, about: y}}}
loads: {weight: {gravity: g}, twist: {torque: {on: collar, about: y, magnitude: T}}}
measures: {s: y of collar, phi: angle of collar about y}
start: {s: 0, phi: 0}
""",
        {"acceleration of s": "-g", "acceleration of phi": "T/J"},
    ),
    # (m + J (2 pi/p)^2) s'' = -m g
    "screw joint of a nut under its weight": (
        "screw",
        """
space: true
parameters: {m: 2 kg, J: 0.1 kg m^2, p: 0.05 m, g: 9.81 m/s^2}
bodies: {nut: {body: {mass: m, inertia: [J, J, J]}}}
connections: {it: {screw: {first: ground.A, second: nut, about: y, pitch: p}}}
loads: {weight: {gravity: g}}
measures: {s: y of nut}
start: {s: 0}
""",
        {"acceleration of s": "-m*g/(m + J*(2*pi/p)**2)"},
    ),
    # (A + m l^2) theta'' = m g l sin(theta) from rest
    "spherical joint of a standing pendulum": (
        "spherical",
        """
space: {up: z}
parameters: {m: 2 kg, A: 0.1 kg m^2, l: 0.3 m, g: 9.81 m/s^2}
bodies:
  bob:
    body: {mass: m, inertia: [A, A, A]}
    points: {foot: [0, 0, -l]}
    turned: [psi about z, theta about x, phi about z]
connections: {it: {spherical: [ground.A, bob.foot]}}
loads: {weight: {gravity: g}}
start: {theta: 40 deg, psi: 0, phi: 0}
""",
        {"acceleration of theta at start": "m*g*l*sin(2*pi/9)/(A + m*l**2)", "degrees of freedom": "3"},
    ),
    "universal joint of a hanging body": (
        "universal",
        """
space: true
parameters: {m: 2 kg, A: 0.1 kg m^2, l: 0.3 m, g: 9.81 m/s^2}
bodies: {bob: {body: {mass: m, inertia: [A, A, A]}, points: {top: [0, l, 0]}, turned: [q about x, p about z]}}
connections: {it: {universal: {first: ground.A, second: bob.top, arm: x, second_arm: z}}}
loads: {weight: {gravity: g}}
start: {q: 0, p: 20 deg}
""",
        {"acceleration of p at start": "-m*g*l*sin(pi/9)/(A + m*l**2)", "degrees of freedom": "2"},
    ),
    # shafts at an angle turn equally fast
    "constant-velocity joint of two bent shafts": (
        "constant_velocity",
        """
space: true
parameters: {alpha: 30 deg, J: 0.1 kg m^2}
frames: {bent: {turned: alpha about x}}
bodies:
  drive: {body: {inertia: [J, J, J]}}
  driven: {body: {inertia: [J, J, J]}, near: {turned: alpha about x}}
connections:
  a: {revolute: {first: ground.O, second: drive, about: z}}
  b: {revolute: {first: ground.O, second: driven, about: bent.z, second_axis: z}}
  it: {constant_velocity: {first: drive, second: driven, about: z}}
measures: {psi: angle of drive about z}
start: {psi: 0, rate(psi): 3 rad/s}
""",
        {"ratio of angular velocity of driven along bent.z to rate of psi": "1"},
    ),
    "planar joint of a plate on ice": (
        "planar",
        """
space: true
parameters: {m: 2 kg, F: 3 N}
bodies: {plate: {box: {mass: m, size: [0.3 m, 0.02 m, 0.2 m]}}}
connections: {it: {planar: {body: plate, normal: y}}}
loads: {push: {force: {at: plate, along: x, magnitude: F}}, down: {force: {at: plate, along: down, magnitude: 2*F}}}
measures: {x: x of plate}
start: {x: 0}
""",
        {"acceleration of x": "F/m", "normal force of it": "2*F", "degrees of freedom": "3"},
    ),
    # T1 - k T = I1 a1, T = I2 k a1
    "gear pair of two wheels across": (
        "gear_pair",
        """
space: true
parameters: {I1: 0.1 kg m^2, I2: 0.3 kg m^2, k: 0.5, T: 2 N m}
bodies: {a: {body: {inertia: [I1, I1, I1]}}, b: {body: {inertia: [I2, I2, I2]}}}
connections:
  p: {revolute: {first: ground.O, second: a, about: x}}
  q: {revolute: {first: ground.O, second: b, about: y}}
  it: {gear_pair: {first: a, second: b, first_axis: x, second_axis: y, ratio: -k}}
loads: {motor: {torque: {on: a, about: x, magnitude: T}}}
measures: {u: angle of a about x, w: angle of b about y}
start: {u: 0}
""",
        {"acceleration of u": "T/(I1 + k**2*I2)", "acceleration of w": "-k*T/(I1 + k**2*I2)"},
    ),
    "point on a line: a bead on a slanted wire": (
        "point_on_line",
        """
space: true
parameters: {m: 2 kg, alpha: 30 deg, g: 9.81 m/s^2}
bodies: {bead: {particle: {mass: m}}}
connections: {it: {point_on_line: {point: bead, through: ground.A, along: [cos(alpha), sin(alpha), 0]}}}
loads: {weight: {gravity: g}}
measures: {s: "travel of bead along [cos(alpha), sin(alpha), 0]"}
start: {s: 0}
""",
        {"acceleration of s": "-g*sin(alpha)", "size of reaction of it": "m*g*cos(alpha)"},
    ),
    "point on a plane: a puck": (
        "point_on_plane",
        """
space: true
parameters: {m: 2 kg, g: 9.81 m/s^2, F: 1 N}
ground: {planes: {ice: {normal: up}}}
bodies: {puck: {particle: {mass: m}}}
connections: {it: {point_on_plane: {point: puck, on: ice}}}
loads: {weight: {gravity: g}, push: {force: {at: puck, along: z, magnitude: F}}}
measures: {z: z of puck}
start: {z: 0}
""",
        {"acceleration of z": "F/m", "normal force of it": "m*g"},
    ),
    "stop under a weight": (
        "stop",
        """
parameters: {m: 2 kg, g: 9.81 m/s^2}
bodies: {b: {particle: {mass: m}}}
measures: {y: y of b}
connections: {rail: {slider: {body: b, along: up}}, it: {stop: {measure: y, min: 0}}}
loads: {weight: {gravity: g}}
start: {y: 0}
""",
        {"stop force of it at start": "m*g", "acceleration of y at start": "0"},
    ),
    # M - F r_1 = I a, F r_2 = J b, a z_1 = b z_2
    "chain between two sprockets": (
        "chain",
        """
parameters: {I: 0.1 kg m^2, J: 0.3 kg m^2, M: 5 N m, p: 12.7 mm, d: 0.4 m}
ground: {points: {A: [0, 0], B: [d, 0]}}
bodies: {a: {body: {inertia: I}}, b: {body: {inertia: J}, at: [d, 0]}}
connections:
  p: {pin: [ground.A, a]}
  q: {pin: [ground.B, b]}
  it: {chain: {first: a, second: b, pitch: p, teeth: [40, 20]}}
loads: {drive: {torque: {on: a, magnitude: M}}}
""",
        {"angular acceleration of a": "M/(I + 4*J)", "angular acceleration of b": "2*M/(I + 4*J)"},
    ),
    # tan(delta_1) = z_1/z_2 at a right angle: r_1 = 2 r_2, so the second turns twice as fast, the other way
    "bevel gears at a right angle": (
        "bevel_gears",
        """
space: true
parameters: {I: 0.1 kg m^2, J: 0.3 kg m^2, M: 5 N m, r: 0.2 m}
ground: {points: {A: [r/2, 0, 0], B: [0, r, 0]}}
bodies: {a: {body: {inertia: I}}, b: {body: {inertia: J}}}
connections:
  p: {revolute: {first: ground.A, second: a, about: x}}
  q: {revolute: {first: ground.B, second: b, about: y}}
  it: {bevel_gears: {first: a, second: b, teeth: [40, 20], radius: r}}
loads: {drive: {torque: {on: a, about: x, magnitude: M}}}
measures: {phi: angle of a about x, psi: angle of b about y}
start: {phi: 0, psi: 0}
""",
        {"acceleration of phi": "M/(I + 4*J)", "acceleration of psi": "-2*M/(I + 4*J)"},
    ),
    # rope, bodies and the rim of the disk run with the same speed; both sides are alike where y is (L - pi R)/2
    "rope with mass over a disk": (
        "heavy_rope",
        """
parameters: {rho: 2 kg/m, L: 4 m, R: 0.1 m, M: 3 kg, m: 1 kg, g: 9.81 m/s^2}
bodies:
  wheel: {disk: {mass: M, radius: R}}
  rope: {rope: {mass_per_length: rho, length: L}}
  a: {particle: {mass: m}}
  b: {particle: {mass: m}}
connections:
  p: {pin: [ground.O, wheel]}
  it: {heavy_rope: {rope: rope, over: [wheel], leads: [up, down], from: a, to: b}}
loads: {weight: {gravity: g}}
measures: {y: drop of rope}
start: {y: 1.3 m, rate(y): 0}
""",
        {"acceleration of y": "2*rho*g*(y - (L - pi*R)/2)/(rho*L + 2*m + M/2)"},
    ),
    # the helix pushes along the shafts, which do not give way: r_2 = 2 r_1
    "helical gears": (
        "helical_gears",
        """
space: true
parameters: {I: 0.1 kg m^2, J: 0.3 kg m^2, M: 5 N m, r: 0.2 m}
ground: {points: {A: [0, 0, 0], B: [0, 0, 3*r]}}
bodies: {a: {body: {inertia: I}}, b: {body: {inertia: J}}}
connections:
  p: {revolute: {first: ground.A, second: a, about: x}}
  q: {revolute: {first: ground.B, second: b, about: x}}
  it: {helical_gears: {first: a, second: b, teeth: [20, 40], radius: r, helix_angle: 20 deg}}
loads: {drive: {torque: {on: a, about: x, magnitude: M}}}
measures: {phi: angle of a about x, psi: angle of b about x}
start: {phi: 0, psi: 0}
""",
        {"acceleration of phi": "M/(I + J/4)", "acceleration of psi": "-M/(2*I + J/2)"},
    ),
    # a turn of the worm moves the wheel by one of its 30 teeth
    "worm without friction": (
        "worm_gear",
        """
space: true
parameters: {I: 0.001 kg m^2, J: 0.3 kg m^2, M: 5 N m, r: 0.05 m}
ground: {points: {A: [0, 0, 2*r], B: [0, 0, -2*r]}}
bodies: {a: {body: {inertia: I}}, b: {body: {inertia: J}}}
connections:
  p: {revolute: {first: ground.A, second: a, about: x}}
  q: {revolute: {first: ground.B, second: b, about: y}}
  it: {worm_gear: {worm: a, wheel: b, starts: 1, teeth: 30, radius: r, lead_angle: atan(1/10)}}
loads: {drive: {torque: {on: a, about: x, magnitude: M}}}
measures: {phi: angle of a about x}
start: {phi: 0}
""",
        {"acceleration of phi": "M/(I + J/900)"},
    ),
}


def test_every_connection_has_a_closed_form() -> None:
    assert {kind for kind, _model, _known in CLOSED.values()} == set(KINDS)


@functools.cache
def solved(name: str) -> fb.Solution:
    _kind, model, known = CLOSED[name]
    questions = "questions:\n" + "".join(f"  - {{find: '{q}'}}\n" for q in known)
    return fb.solve(fb.System.from_text(model + questions))


@pytest.mark.parametrize(("name", "question"), [(n, q) for n, (_k, _m, known) in CLOSED.items() for q in known])
def test_connection_moves_and_transmits_as_derived(name: str, question: str, agrees: Agree) -> None:
    _kind, _model, known = CLOSED[name]
    solution = solved(name)
    agrees(solution, f"q{list(known).index(question) + 1}", known[question])


# BJ sample problem 16.2: a plate on two equal parallel links is translated, m L phi'' = -m g s, T1 + T2 = m g c;
# moments about its mass centre: T1 (h s - b c) + T2 (h s + b c) = 0
PLATE = """
parameters: {m: 8 kg, b: 0.5 m, h: 0.2 m, L: 0.15 m, beta: 30 deg, g: 9.81 m/s^2}
ground: {points: {A: [-b/2, 0], B: [b/2, 0]}}
bodies:
  plate: {rectangle: {mass: m, width: b, height: h}, at: {top_left: [L*sin(beta) - b/2, -L*cos(beta)]}, angle: 0}
connections:
  first: {link: [ground.A, plate.top_left, L]}
  second: {link: [ground.B, plate.top_right, L]}
loads: {weight: {gravity: g}}
measures: {phi: angle of line from ground.A to plate.top_left from down}
"""
PLATE_QUESTIONS = {
    "acceleration of phi at start": "-g*sin(beta)/L",
    "tension of first at start": "m*g*(b*cos(beta) + h*sin(beta))/(2*b)",
    "tension of second at start": "m*g*(b*cos(beta) - h*sin(beta))/(2*b)",
    "angular acceleration of plate at start": "0",
}


@pytest.mark.parametrize("question", PLATE_QUESTIONS)
def test_plate_released_on_parallel_links_has_the_values_of_the_textbook(question: str) -> None:
    answer = fb.solve(fb.System.from_text(PLATE), question)["q1"]
    numbers = {"m": 8, "b": 0.5, "h": 0.2, "L": 0.15, "beta": math.pi / 6, "g": 9.81}
    expected = eval(PLATE_QUESTIONS[question], {"sin": math.sin, "cos": math.cos} | numbers)
    assert answer.value == pytest.approx(expected, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("question", PLATE_QUESTIONS)
def test_plate_released_on_parallel_links_has_the_formulas_of_the_textbook(question: str, agrees: Agree) -> None:
    agrees(fb.solve(fb.System.from_text(PLATE), question), "q1", PLATE_QUESTIONS[question])


def test_start_may_say_the_same_thing_twice() -> None:
    system = fb.System.from_text(PLATE + "start: {phi: beta}\n")
    assert fb.solve(system, "degrees of freedom")["q1"].value == 1


def test_weights_over_a_smooth_massless_pulley_need_no_grip(agrees: Agree) -> None:
    # Atwood's machine with a light smooth pulley: (m1 + m2) a = (m1 - m2) g
    system = fb.System.from_text("""
parameters: {m1: 3 kg, m2: 2 kg, R: 0.1 m, g: 9.81 m/s^2}
bodies: {pulley: {disk: {radius: R}}, a: {particle: {mass: m1}}, b: {particle: {mass: m2}}}
connections: {axle: {pin: [ground.O, pulley]}, rope: {string: {from: a, over: [pulley], to: b, grips: []}}}
loads: {weight: {gravity: g}}
""")
    agrees(fb.solve(system, "acceleration of a along down"), "q1", "(m1 - m2)*g/(m1 + m2)")


SLED = """
parameters: {m1: 4 kg, m2: 3 kg, r: 0.1 m, g: 9.81 m/s^2, d: 0.1 m}
ground: {lines: {floor: {along: right, through: [0, d]}}}
bodies:
  sled: {particle: {mass: m1}, at: [-2 m, d]}
  load: {particle: {mass: m2}}
  pulley: {disk: {radius: r}, at: [0, 0]}
connections:
  hub: {pin: [ground.O, pulley]}
  run: {slider: [sled, ground.floor]}
  it: {string: {path: [sled, WAY, load]}}
loads: {gravity: {gravity: g}}
questions: [acceleration of load along down]
"""


def test_a_lead_runs_along_a_guide_only_where_it_does_so_for_all_lengths() -> None:
    """The floor is at the height d, which is r in the numbers of the file: the string is level only there."""
    by_length = fb.solve(fb.System.from_text(SLED.replace("WAY", "over pulley"))).answers[0]
    level = fb.solve(fb.System.from_text(SLED.replace("WAY", "over pulley").replace(", d]", ", r]"))).answers[0]
    assert level.expression is not None
    assert level.value == pytest.approx(9.81 * 3 / 7)
    assert not {"d", "r"} & free_symbols(level.expression)
    assert by_length.value == pytest.approx(9.81 * 3 / 7)
    assert str(by_length.expression) != str(level.expression)


def test_bodies_on_guides_that_a_pin_joins_are_placed_by_neither() -> None:
    text = """
parameters: {m: 3 kg, M: 2 kg, h: 0.5 m, g: 9.81 m/s^2}
bodies: {ram: {particle: {mass: m}}, plate: {particle: {mass: M}}}
connections:
  guide: {slider: {body: ram, along: up}}
  other: {slider: {body: plate, along: up}}
  hit: {pin: [ram, plate], closes: when y = 0}
measures: {y: y of ram, z: y of plate}
loads: {weight: {force: {at: ram, along: down, magnitude: m*g}}}
start: {y: h, z: 0}
"""
    is_formula(text, "energy lost in the blow", "m*M*h*g/(m + M)")


def test_a_wheel_in_the_middle_of_a_string_says_on_which_side() -> None:
    with pytest.raises(fb.ModelError, match=r"write 'over pulley', 'under pulley' or pulley\.center"):
        fb.System.from_text(SLED.replace("WAY", "pulley"))
    fb.System.from_text(SLED.replace("WAY", "pulley.center"))


def test_a_contact_with_a_misspelt_line_of_the_ground_is_told_which_is_meant() -> None:
    with pytest.raises(fb.ModelError, match=r"there is no line flor on the ground. Did you mean ground\.floor\?"):
        fb.System.from_text(
            "ground: {lines: {floor: {along: right}}}\nbodies: {ball: {particle: {mass: 1 kg}}}\n"
            "connections: {touch: {contact: {between: [ball, ground.flor]}}}"
        )


@pytest.mark.parametrize(
    ("entry", "told"),
    [
        (
            "{slider: {body: block, along: right}, size: 2}",
            "it has no size; slider takes body, along, on, through, friction, e.g.",
        ),
        ("{slider: {body: block, along: right}, closing: true}", "it has no closing. Did you mean closes?"),
        (
            "{weld: {first: block, second: ground, closes: at start}}",
            "write closes beside weld, not inside it: {weld: {first: block, second: ground}, closes: at start}",
        ),
    ],
)
def test_what_stands_beside_a_kind_is_led_to_where_it_belongs(entry: str, told: str) -> None:
    text = f"freebody: 1\nbodies: {{block: {{particle: {{mass: 1 kg}}}}}}\nconnections: {{it: {entry}}}\n"
    with pytest.raises(fb.ModelError) as found:
        fb.System.from_text(text)
    assert told in str(found.value)


CABLE = """
parameters: {l: 90 m, h: 12 m, w: 400 N/m, H: 60 kN, s: 95 m}
ground: {points: {A: [0, 0], B: [l, h]}}
bodies: {mast: {rod: {length: 1 m, mass: 0}, angle: 90 deg}}
connections:
  foot: {weld: [ground.A, mast.end]}
  it: {hanging_cable: {between: [ground.A, ground.B], weight: w, pull: H}}
"""


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("weight: w, pull: H", "weight: w, sag: 2 m", "by no formula"),
        ("weight: w, pull: H", "weight: w", "give its pull"),
        ("weight: w, pull: H", "weight: w, load: w, pull: H", "give either weight"),
        ("B: [l, h]", "B: [0, h]", "above each other"),
        ("between: [ground.A, ", "between: [bob, ", "put its body there"),
    ],
)
def test_a_cable_that_does_not_hang_says_why(old: str, new: str, says: str) -> None:
    model = CABLE.replace("bodies: {", "bodies: {bob: {particle: {mass: 1 kg}}, ")
    with pytest.raises(fb.ModelError, match=says):
        fb.System.from_text(model.replace(old, new))


def test_the_pull_of_a_chain_by_its_length_is_the_only_one() -> None:
    # s^2 = h^2 + (2 a sinh(l/(2 a)))^2; the sag is the greatest distance below the chord
    answers = fb.System.from_text(CABLE).solve(["value of H for which length of it = s", "sag of it"]).answers
    a = answers[0].value / 400.0
    assert math.hypot(12.0, 2 * a * math.sinh(45.0 / a)) == pytest.approx(95.0)
    assert "exactly one solution" in str(answers[0].reason)
    a, chord = 150.0, [(0.09 * k, 0.012 * k) for k in range(1001)]
    low = a * math.asinh(12.0 / (2 * a * math.sinh(45.0 / a))) - 45.0
    depths = [y + a * math.cosh(low / a) - a * math.cosh((low + x) / a) for x, y in chord]
    assert answers[1].value == pytest.approx(max(depths), rel=1e-6)
