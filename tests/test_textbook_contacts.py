"""Contacts as textbooks ask for them, against answers derived by hand in the line beside them."""

from __future__ import annotations

import pytest

import freebody as fb
from conftest import assert_same_function
from freebody.language.expression import Expr
from freebody.language.notation import to_python
from freebody.numeric.contact.start import assembled_touching
from freebody.numeric.reference import Reference
from posed import is_formula

BEAM_OVER_PEG = """
parameters: {W: 200 N, L: 3 m, alpha: 35 deg, h: 1.2 m, mu: 0.5}
ground: {lines: {floor: {along: right}}, points: {peg: [h/tan(alpha), h]}}
bodies: {beam: {rod: {length: L}, angle: alpha, at: [L*cos(alpha)/2, L*sin(alpha)/2]}}
connections:
  floor: {contact: {between: [beam.start, floor], friction: mu}}
  peg: {contact: {between: [beam, ground.peg]}}
loads: {w: {force: {at: beam.center, along: down, magnitude: W}}}
"""
RISING_FORCE = """
parameters: {m: 10 kg, mu: 0.3, c: 6 N/s, T: 8 s, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {block: {particle: {mass: m}}}
connections: {f: {contact: {between: [block, floor], friction: mu}}}
loads: {w: {gravity: g}, F: {force: {at: block, along: right, magnitude: c*t}}}
measures: {x: x of block}
start: {x: 0, rate(x): 0}
"""
PILE = """
parameters: {m1: 500 kg, m2: 200 kg, h: 1.5 m, R: 60 kN, g: 9.81 m/s^2}
bodies:
  hammer: {particle: {mass: m1}, at: [0, h], velocity: [0, 0]}
  pile: {disk: {mass: m2, radius: 0.1 m}, at: [0, -0.1 m], velocity: [0, 0], points: {P: [0, 0.1 m]}}
connections:
  g1: {slider: {body: hammer, along: up}}
  g2: {slider: {body: pile, along: up}}
  hit: {contact: {between: [hammer, pile]}}
  soil: {dry_friction: {measure: y, force: R}}
loads: {w: {gravity: g}}
measures: {y: y of pile.P}
"""
UNWINDING = """
parameters: {m: 10 kg, r: 0.2 m, beta: 35 deg, mu: 0.15, d: 2 m, g: 9.81 m/s^2}
bodies: {drum: {cylinder: {mass: m, radius: r}, at: [0, 0]}}
ground:
  points: {W: [r*sin(beta) - d*cos(beta), r*cos(beta) + d*sin(beta)]}
  lines: {slope: {through: [-r*sin(beta), -r*cos(beta)], along: -beta}}
connections:
  slope: {contact: {between: [drum, slope], friction: mu, touching: true}}
  cord: {string: {from: ground.W, to: wound on drum at top}}
loads: {weight: {gravity: g}}
measures: {s: travel of drum along -beta}
"""


@pytest.mark.parametrize(
    ("model", "question", "expected", "near"),
    [
        # N at the peg by moments about the foot, N h/sin a = W L/2 cos a; then F = N sin a <= mu (W - N cos a). The
        # beam has no mass of its own
        (
            BEAM_OVER_PEG,
            "least mu so that it stays at rest",
            "L*sin(alpha)**2*cos(alpha)/(2*h - L*sin(alpha)*cos(alpha)**2)",
            {"L": 3.0, "h": 1.2, "alpha": 0.6},
        ),
        # it slips from c t = mu m g on, with m x'' = c (t - t1)
        (RISING_FORCE, "velocity of x at t = T", "c/(2*m)*(T - mu*m*g/c)**2", {}),
        (RISING_FORCE, "x at t = T", "c/(6*m)*(T - mu*m*g/c)**3", {}),
        # the cord is parallel to the slope and holds the top still, so the foot slips at 2 v and x'' = r w':
        # m x'' = m g sin b - T - F and m r^2/2 w' = (T - F) r with F = mu m g cos b
        (UNWINDING, "acceleration of s", "2*g*(sin(beta) - 2*mu*cos(beta))/3", {"beta": 0.6, "mu": 0.15}),
        (UNWINDING, "tension of cord", "m*g*(sin(beta) + mu*cos(beta))/3", {"beta": 0.6, "mu": 0.15}),
        # it stays where the cord and friction carry half of m g sin b each
        (UNWINDING, "least mu so that it stays at rest", "tan(beta)/2", {"beta": 0.6}),
        # both go on with m1 sqrt(2 g h)/(m1 + m2), and R - (m1 + m2) g stops them
        (PILE, "least y", "-m1**2*g*h/((m1 + m2)*(R - (m1 + m2)*g))", {}),
    ],
)
def test_contacts_that_textbooks_ask_for(model: str, question: str, expected: str, near: dict[str, float]) -> None:
    (answer,) = fb.solve(fb.System.from_text(model), question).answers
    assert isinstance(answer.expression, Expr), answer.reason
    assert answer.value is not None
    assert_same_function(to_python(answer.expression), expected, near)


def test_what_nobody_has_placed_lies_on_top_of_the_plank() -> None:
    """Top and bottom of the plank are equally near: the weight drives the disk onto the top."""
    system = fb.System.from_text(
        """
parameters: {m: 6 kg, M: 4 kg, a: 0.1 m, g: 9.81 m/s^2}
bodies:
  plank: {rectangle: {mass: M, width: 3 m, height: 0.1 m}}
  disk: {disk: {mass: m, radius: a}}
connections:
  gl: {slider: {body: plank, along: right}}
  c: {contact: {between: [disk, plank]}}
loads: {G: {gravity: g}}
measures: {X: x of plank, x: x of disk, y: y of disk}
start: {X: 0, x: 0, rate(X): 0, rate(x): 0}
"""
    )
    reference = Reference(system, {"m": 6.0, "M": 4.0, "a": 0.1, "g": 9.81})
    q = assembled_touching(reference)
    assert reference.snapshot(q, 0 * q).value(system.measures["y"]) == pytest.approx(0.15)


@pytest.mark.parametrize("at", ["", ", at: [0, 0]"])
def test_a_rope_leads_to_the_left_as_it_does_to_the_right(at: str) -> None:
    """A block on a table to the right of the pulley, over which the rope leads: the load hangs on its left."""
    system = fb.System.from_text(
        f"""
parameters: {{m1: 3 kg, m2: 5 kg, r: 0.1 m, g: 9.81 m/s^2}}
ground: {{points: {{edge: [-1 m, -r]}}, lines: {{table: {{along: right}}}}}}
bodies: {{a: {{particle: {{mass: m1}}{at}}}, b: {{particle: {{mass: m2}}}}, p: {{disk: {{radius: r}}}}}}
connections:
  c: {{contact: {{between: [a, table]}}}}
  ax: {{pin: [ground.edge, p.center]}}
  rope: {{string: {{from: a, over: [p], to: b}}}}
loads: {{G: {{gravity: g}}}}
measures: {{z: travel of b along down}}
"""
    )
    (answer,) = fb.solve(system, "acceleration of z").answers
    assert isinstance(answer.expression, Expr)
    assert_same_function(to_python(answer.expression), "m2*g/(m1 + m2)", {})


RAMP = """
parameters: {m: 0.5 kg, L: 2 m, al: 30 deg, v0: 8 m/s, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right, through: [0, -L*sin(al)]}}}
bodies:
  ramp:
    polygon: {mass: 0, corners: [[-L*cos(al), -L*sin(al)], [0, -L*sin(al)], [0, 0]]}
    fixed: true
    at: [0, 0]
    angle: 0
  ball: {particle: {mass: m}, at: [-L*cos(al), -L*sin(al)], velocity: [v0*cos(al), v0*sin(al)]}
connections: {t: {contact: {between: [ball, ramp]}}, f: {contact: {between: [ball, ground.floor]}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball}
"""


def test_what_starts_at_the_foot_of_a_ramp_runs_up_and_flies_from_its_top() -> None:
    """At the corner it gets behind the lower edge of the ramp, but keeps before its face: it strikes neither. It leaves
    the top with v1^2 = v0^2 - 2 g L sin(al) and falls through L sin(al)."""
    v1 = "sqrt(v0^2 - 2*g*L*sin(al))"
    is_formula(RAMP, "speed of ball when ball leaves ramp", v1, factors=(1.0, 1.02, 0.99))
    time = f"({v1}*sin(al) + sqrt({v1}^2*sin(al)^2 + 2*g*L*sin(al)))/g"
    is_formula(RAMP, "x when ball hits floor", f"{v1}*cos(al)*{time}", factors=(1.0, 1.02, 0.99))


def test_at_the_foot_of_a_ramp_the_simulation_has_no_impact() -> None:
    run = fb.System.from_text(RAMP).simulate(1.0)
    assert [event.name.split()[1] for event in run.events] == ["leaves"]
