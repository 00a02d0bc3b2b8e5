"""Questions turned round: for which value, or range, of a parameter something is so. Twelve problems in the style of
textbooks, in words and numbers of our own; from what the formula follows by hand stands beside it."""

from __future__ import annotations

import pytest

from posed import is_derived, is_formula

# Meriam & Kraige, Dynamics, ch. 3: work and energy, a wagon and its buffer
BUFFER = """
parameters: {m: 3000 kg, v: 1.5 m/s, k: 90 kN/m, s: 0.3 m}
ground: {lines: {rail: {along: right}}}
bodies: {wagon: {particle: {mass: m}}}
connections: {rail: {slider: [wagon, ground.rail]}}
loads: {buffer: {law: {measure: x, force: -k*x}}}
measures: {x: x of wagon}
start: {x: 0, rate(x): v}
"""
# Hibbeler, Statics, ch. 8, and Dynamics, ch. 13: a rope at an angle over rough ground
SLEDGE = """
parameters: {m: 40 kg, P: 200 N, mu: 0.3, beta: 20 deg, a: 1 m/s^2, g: 9.81 m/s^2, v: 1 m/s}
ground: {lines: {snow: {along: right}}}
bodies: {sledge: {particle: {mass: m}}}
connections: {c: {contact: {between: [sledge, ground.snow], friction: mu}}}
loads: {weight: {gravity: g}, rope: {force: {at: sledge, along: beta, magnitude: P}}}
measures: {x: x of sledge}
start: {x: 0, rate(x): v}
"""
# Beer & Johnston, Dynamics, ch. 13: a collar on an upright hoop, a spring from its top
COLLAR_ON_A_HOOP = """
parameters: {m: 0.6 kg, R: 0.3 m, k: 20 N/m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], T: [0, R]}}
bodies: {collar: {particle: {mass: m}}}
connections: {wire: {link: [ground.O, collar, R]}}
loads: {weight: {gravity: g}, s: {spring: {first: ground.T, second: collar, stiffness: k, length: R}}}
measures: {theta: angle of line from ground.O to collar from down}
start: {theta: 90 deg, rate(theta): 0}
"""
# French, Vibrations and Waves, ch. 3: a block on a platform that vibrates
BLOCK_ON_A_PLATFORM = """
parameters: {M: 4 kg, m: 1 kg, k: 500 N/m, A: 0.05 m, g: 9.81 m/s^2}
bodies:
  plate: {particle: {mass: M}, lines: {top: {along: right}}, at: [0, -A]}
  block: {particle: {mass: m}, at: [0, -A]}
connections: {g1: {slider: {body: plate, along: up}}, c: {contact: {between: [block, plate.top]}}}
loads: {weight: {gravity: g}, s: {law: {measure: y, force: (M + m)*g - k*y}}}
measures: {y: y of plate}
start: {y: -A, rate(y): 0}
"""
# Hibbeler, Statics, ch. 5: a plank on two supports and who walks out on it
PLANK = """
parameters: {M: 30 kg, m: 70 kg, b: 3 m, c: 2 m, s: 1 m, g: 9.81 m/s^2}
ground: {points: {A: [0, 0], B: [b, 0]}, lines: {floor: {along: right}}}
bodies:
  plank: {body: {mass: M}, points: {A: [-c, 0], B: [b - c, 0], M: [s - c, 0]}}
  man: {particle: {mass: m}}
connections: {A: {pin: [ground.A, plank.A]}, B: {slot: [plank.B, ground.floor]}, stands: {pin: [man, plank.M]}}
loads: {weight: {gravity: g}}
"""
# Meriam & Kraige, Statics, ch. 3: a load on a bar that hangs on two cables
BAR_ON_TWO_CABLES = """
parameters: {W: 900 N, L: 3 m, s: 1 m, h: 2 m}
ground: {points: {P: [0, h], Q: [L, h]}}
bodies: {bar: {rod: {mass: 0, length: L}, points: {S: [s - L/2, 0]}, at: {start: [0, 0]}, angle: 0}}
connections: {left: {string: {from: ground.P, to: bar.start}}, right: {string: {from: ground.Q, to: bar.end}}}
loads: {w: {force: {at: bar.S, along: down, magnitude: W}}}
"""
# Thomson & Dahleh, Theory of Vibration, ch. 2: a damper from what it does
DAMPED = """
parameters: {m: 2 kg, k: 800 N/m, c: 10 N*s/m, D: 0.2, wd: 15 rad/s}
bodies: {b: {particle: {mass: m}}}
connections: {g: {slider: {body: b, along: right}}}
loads: {s: {law: {measure: x, force: -k*x}}, d: {law: {measure: x, force: -c*rate(x)}}}
measures: {x: x of b}
start: {x: 0.1 m, rate(x): 0}
"""
# Meriam & Kraige, Dynamics, ch. 6: a bucket on a drum, after a drop of h - 1 m
BUCKET = """
parameters: {M: 12 kg, R: 0.2 m, m: 5 kg, h: 3 m, w: 20 rad/s, T: 20 N, g: 9.81 m/s^2}
bodies: {drum: {disk: {mass: M, radius: R}, at: [0, 0]}, bucket: {particle: {mass: m}, at: [R, -1 m]}}
connections: {axle: {pin: [ground.O, drum.center]}, rope: {string: {path: [wound on drum at right, bucket]}}}
loads: {weight: {gravity: g}}
measures: {x: drop of bucket below ground.O}
start: {x: 1 m, rate(x): 0}
"""
# Beer & Johnston, Dynamics, ch. 13: direct central impact
CENTRAL_IMPACT = """
parameters: {mA: 2 kg, mB: 5 kg, v: 3 m/s, e: 0.6, d: 1 m}
bodies: {A: {particle: {mass: mA}, at: [0, 0]}, B: {particle: {mass: mB}, at: [d, 0]}}
connections:
  gA: {slider: {body: A, along: right}}
  gB: {slider: {body: B, along: right}}
  hit: {stop: {measure: gap, min: 0, restitution: e}}
measures: {x: x of A, z: x of B, gap: {expression: z - x}}
start: {x: 0, rate(x): v, z: d, rate(z): 0}
"""
# Hibbeler, Dynamics, ch. 17 and 18: a flywheel that is braked by a moment
FLYWHEEL = """
parameters: {I: 4 kg*m^2, w0: 30 rad/s, M: 20 N*m, N: 10, T: 5 s}
bodies: {wheel: {body: {mass: 1 kg, inertia: I}, points: {O: [0, 0]}}}
connections: {axle: {pin: [ground.O, wheel.O]}}
loads: {brake: {torque: {on: wheel, magnitude: -M}}}
measures: {phi: angle of wheel}
start: {phi: 0, rate(phi): w0}
"""
# Hibbeler, Dynamics, ch. 22: where a rod is hung up for the shortest period
REVERSIBLE_PENDULUM = """
parameters: {m: 2 kg, L: 1 m, b: 0.2 m, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}, points: {P: [-b, 0]}}}
connections: {pivot: {pin: [ground.O, rod.P]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of line from rod.P to rod.mass_center from down}
start: {theta: 0, rate(theta): 0}
"""
# Halliday & Resnick, Fundamentals of Physics, ch. 5: two weights over a pulley in a lift
ATWOOD_IN_A_LIFT = """
parameters: {m1: 3 kg, m2: 2 kg, R: 0.1 m, g: 9.81 m/s^2, a: 1 m/s^2, F: 30 N}
bodies:
  lift: {particle: {mass: 1 kg}}
  pulley: {pulley: {mass: 0, radius: R}}
  A: {particle: {mass: m1}}
  B: {particle: {mass: m2}}
connections:
  shaft: {slider: {body: lift, along: up}}
  motor: {driver: {measure: y, follows: a*t^2/2}}
  axle: {pin: [lift, pulley.center]}
  rope: {string: {path: [A, over pulley, B]}}
loads: {weight: {gravity: g}}
measures: {y: y of lift, u: height of A above lift}
start: {u: -1 m, rate(u): 0}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # the kinetic energy is in the spring: m v^2 = k s^2
        (BUFFER, "value of k for which greatest x = s", "m*v**2/s**2"),
        # the same, for the speed
        (BUFFER, "least v so that x reaches s", "s*sqrt(k/m)"),
        # the force k x at the turn is k v sqrt(m/k)
        (BUFFER, "value of m for which greatest force in buffer = k*s", "k*s**2/v**2"),
        # P (cos + mu sin) is largest where its derivative -sin + mu cos vanishes
        (SLEDGE, "value of beta for which acceleration of x is largest", "atan(mu)"),
        # m a = P cos - mu (m g - P sin)
        (SLEDGE, "value of P for which acceleration of x = a", "m*(a + mu*g)/(cos(beta) + mu*sin(beta))"),
        # P cos = mu (m g - P sin)
        (SLEDGE, "value of mu for which acceleration of x = 0", "P*cos(beta)/(m*g - P*sin(beta))"),
        # from the side, where the spring has sqrt(2) R, to the bottom, where it has 2 R
        (COLLAR_ON_A_HOOP, "speed of collar when theta = 0", "sqrt(2*g*R - 2*(sqrt(2) - 1)*k*R**2/m)"),
        # no speed is left: m g R = (sqrt(2) - 1) k R^2
        (COLLAR_ON_A_HOOP, "value of k for which speed of collar = 0 when theta = 0", "m*g/(R*(sqrt(2) - 1))"),
        # N = m g + m v^2/R - k R = 3 m g - k R (2 sqrt(2) - 1)
        (COLLAR_ON_A_HOOP, "value of k for which tension of wire = 0 when theta = 0", "3*m*g/(R*(2*sqrt(2) - 1))"),
        # it falls as fast as it can where the platform has A w^2 = g, with w^2 = k/(M + m)
        pytest.param(
            BLOCK_ON_A_PLATFORM, "largest A so that the block stays on the plate", "(M + m)*g/k", marks=pytest.mark.slow
        ),
        # no acceleration in the middle
        pytest.param(BLOCK_ON_A_PLATFORM, "normal force of c when y = 0", "m*g", marks=pytest.mark.slow),
        # at the top m g - N = m A w^2
        pytest.param(
            BLOCK_ON_A_PLATFORM, "normal force of c when rate(y) = 0", "m*g - m*k*A/(M + m)", marks=pytest.mark.slow
        ),
        # moments about B: M (b - c) = m (s - b)
        (PLANK, "value of s for which vertical reaction of A = 0", "b + M*(b - c)/m"),
        # both carry half: M c + m s = b (M + m)/2
        (PLANK, "value of s for which vertical reaction of A = vertical reaction of B", "(b*(M + m)/2 - M*c)/m"),
        # by moments W (L - s)/L and W s/L
        (BAR_ON_TWO_CABLES, "value of s for which tension of left = 3*tension of right", "L/4"),
        # L - s > 2 s
        (BAR_ON_TWO_CABLES, "range of s for which tension of left > 2*tension of right", "L/3"),
        # m wd^2 = k - c^2/(4 m)
        (DAMPED, "value of c for which damped frequency = wd", "2*sqrt(m*(k - m*wd**2))"),
        # D = 2 pi zeta/sqrt(1 - zeta^2)
        (DAMPED, "value of c for which logarithmic decrement = D", "2*D*sqrt(k*m/(4*pi**2 + D**2))"),
        # m g (h - 1 m) = (m + M/2) (w R)^2/2
        (
            BUCKET,
            "value of m for which angular velocity of drum = -w when x = h",
            "M*(w*R)**2/2/(2*g*(h - 1) - (w*R)**2)",
        ),
        # T = m g M/2/(m + M/2)
        (BUCKET, "value of M for which tension of rope = T", "2*m*T/(m*g - T)"),
        # v' = v (mA - e mB)/(mA + mB)
        (CENTRAL_IMPACT, "value of e for which velocity of x = 0 after the impact", "mA/mB"),
        # the same, for the mass
        (CENTRAL_IMPACT, "value of mB for which velocity of x after the impact = 0", "mA/e"),
        # mA mB/(mA + mB) (1 - e^2) v^2/2 is half of mA v^2/2
        (CENTRAL_IMPACT, "value of e for which energy lost in the impact = mA*v^2/4", "sqrt(1 - (mA + mB)/(2*mB))"),
        # I w0^2/2 = M 2 pi N
        (FLYWHEEL, "value of M for which phi = 2*pi*N when rate(phi) = 0", "I*w0**2/(4*pi*N)"),
        # I w0 = M T
        (FLYWHEEL, "value of M for which time when the wheel stops = T", "I*w0/T"),
        # L^2/(12 b) + b is least where both are alike
        (REVERSIBLE_PENDULUM, "value of b for which period of small oscillations is least", "L/sqrt(12)"),
        # reduced length 2 b = L/sqrt(3)
        (REVERSIBLE_PENDULUM, "least period of small oscillations over b", "2*pi*sqrt(L/(sqrt(3)*g))"),
        # as at rest with g + a for g
        (ATWOOD_IN_A_LIFT, "value of a for which tension of rope = F", "F*(m1 + m2)/(2*m1*m2) - g"),
        # a - (g + a) (m1 - m2)/(m1 + m2) = 0
        (ATWOOD_IN_A_LIFT, "value of a for which acceleration of A along up = 0", "(m1 - m2)*g/(2*m2)"),
    ],
)
def test_the_value_of_a_parameter_is_that_of_its_derivation(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("model", "question"),
    [
        (SLEDGE, "value of P for which acceleration of x = a"),
    ],
)
def test_it_is_derived(model: str, question: str) -> None:
    is_derived(model, question)
