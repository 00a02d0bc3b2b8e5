"""Ropes that run along a jib, over the sheaves of a trolley that travels on it, and down to a load.

With x the trolley and h the depth of the load below it, of a rope from the mast over a sheave to the hook

    x + h - R psi = constant,

so that a trolley that moves draws the load up or lets it down, while one that goes down to a hook block and up to the
other sheave and on to the tip of the jib at c keeps x + 2 h + (c - x) - R psi: the load keeps its height. A load
that is kept below its trolley moves sideways as it does. Sources: Meriam & Kraige, Dynamics, sec. 2/9 (constrained
motion of connected particles); the equations below are Newton's, written by hand.
"""

from __future__ import annotations

import pytest

import freebody as fb
from posed import is_derived, is_formula, posed

HOIST = """
parameters:
  {m: 800 kg, M: 200 kg, I: 5 kg m^2, R: 0.3 m, r: 0.2 m, b: 6 m, c: 12 m, F: 300 N, T: 2600 N m, g: 9.81 m/s^2}
ground: {points: {mast: [WHERE, r - R]}}
bodies:
  drum: {body: {inertia: I, radius: R}}
  trolley: {rectangle: {mass: M, width: 1 m, height: 0.2 m}, points: {lug: [0.1 m, 0]}}
  sheave: {disk: {mass: 0, radius: r}}
  load: {particle: {mass: m}}
connections:
  winch: {pin: [ground.mast, drum]}
  rail: {slider: {body: trolley, along: right}}
  axle: {pin: [trolley.lug, sheave]}
  rope: {string: {path: [wound on drum SENSE, over sheave, load]}}
loads:
  weight: {gravity: g}
  push: {force: {at: trolley, along: right, magnitude: F}}
  motor: {torque: {on: drum, magnitude: SIGN T}}
measures: {x: x of trolley, y: y of load}
start: {y: -5 m, x: b}
"""
LEFT = HOIST.replace("WHERE", "-1 m").replace("SENSE", "clockwise").replace("c: 12 m, ", "").replace("SIGN ", "")
RIGHT = HOIST.replace("WHERE", "c").replace("SENSE", "counterclockwise").replace("SIGN ", "-")
CRANE = """
parameters: {m: 800 kg, M: 200 kg, R: 0.3 m, r: 0.2 m, b: 6 m, c: 30 m, F: 300 N, u: 0.4 m/s, g: 9.81 m/s^2}
ground: {points: {mast: [0, r - R], tip: [c, r]}}
bodies:
  drum: {disk: {mass: 0, radius: R}}
  trolley: {rectangle: {mass: M, width: 1.2 m, height: 0.2 m}, points: {left: [-2*r, 0], right: [2*r, 0]}}
  one: {disk: {mass: 0, radius: r}}
  other: {disk: {mass: 0, radius: r}}
  block: {disk: {mass: 0, radius: r}}
  load: {particle: {mass: m}}
connections:
  winch: {pin: [ground.mast, drum]}
  rail: {slider: {body: trolley, along: right}}
  left: {pin: [trolley.left, one]}
  right: {pin: [trolley.right, other]}
  rope: {string: {path: PATH}}
  hook: {string: {from: block, to: load}}
  hoisting: {driver: {measure: psi, follows: u*t/R}}
loads: {weight: {gravity: g}, push: {force: {at: trolley, along: right, magnitude: F}}}
measures: {x: x of trolley, y: y of load, psi: angle of drum}
start: {y: -6 m, x: b}
"""
FORTH = "[wound on drum clockwise, over one, under block, over other, ground.tip]"
BACK = "[ground.tip, over other, under block, over one, wound on drum counterclockwise]"


@pytest.mark.parametrize(("model", "side"), [(LEFT, "-1"), (RIGHT, "1")])
def test_a_rope_from_a_winch_beside_the_rail_draws_its_trolley_by_the_tension(model: str, side: str) -> None:
    """S the tension, e = -1 with the winch to the left: (M + m) x'' = F + e S, m y'' = S - m g, and what is drawn in,
    w, is e x + y = w with I w''/R^2 = T/R - S. Then S (1/(M + m) + 1/m + R^2/I) = R T/I + g - e F/(M + m)."""
    tension = f"(R*T/I + g - ({side})*F/(M + m))/(1/(M + m) + 1/m + R^2/I)"
    is_formula(model, "tension of rope at load", tension)
    is_formula(model, "acceleration of x", f"(F + ({side})*{tension})/(M + m)")
    is_formula(model, "acceleration of y", f"{tension}/m - g")


@pytest.mark.parametrize("path", [FORTH, BACK])
def test_a_load_on_two_falls_keeps_its_height_while_the_trolley_travels(path: str) -> None:
    model = CRANE.replace("PATH", path)
    is_formula(model, "velocity of y", "u/2")
    is_formula(model, "tension of rope at drum", "m*g/2")
    is_formula(model, "acceleration of x", "F/(M + m)")


def test_a_trolley_that_is_driven_starts_where_its_driver_puts_it() -> None:
    model = CRANE.replace("PATH", FORTH).replace(", x: b}", "}")
    model = model.replace("  hoisting:", "  going: {driver: {measure: x, follows: b + F*t^2/(2*M)}}\n  hoisting:")
    model = model.replace(", push: {force: {at: trolley, along: right, magnitude: F}}", "")
    found = is_formula(model, "driving force of going", "(M + m)*F/M")
    assert [str(condition) for condition in found.conditions] == ["for all positive parameters"]


def test_both_falls_are_said_to_be_askew_where_the_block_is_not_as_wide_as_they_are_apart() -> None:
    wide = CRANE.replace("PATH", FORTH).replace("block: {disk: {mass: 0, radius: r}}", "block: {disk: {radius: 2*r}}")
    for model, is_askew in ((CRANE.replace("PATH", FORTH), False), (wide, True)):
        told = fb.System.from_text(model).assumptions
        assert any("from block to other" in str(text) for text in told) == is_askew


def test_the_load_stays_level_in_a_simulation() -> None:
    still = CRANE.replace("PATH", FORTH).replace("u*t/R", "0").replace(", u: 0.4 m/s", "")
    motion = fb.System.from_text(still).simulate(5.0)
    y, x = (motion.series[name][0] for name in "yx")
    assert y == pytest.approx(-6.0, abs=1e-9)
    assert x[-1] == pytest.approx(6.0 + 0.3 * 25 / 2, rel=1e-9)


def test_how_a_load_is_lifted_over_a_trolley_is_derived() -> None:
    told = is_derived(CRANE.replace("PATH", FORTH), "tension of rope at drum")
    assert "Rope" not in told["de"]
    assert posed(LEFT, "tension of rope at drum").value is not None


ON_A_JIB = """
parameters: {m: 50 kg, M: 100 kg, L: 6 m, r: 0.1 m, alpha: 20 deg, g: 9.81 m/s^2}
bodies:
  jib: {rod: {length: L, mass: 800 kg}, points: {axle: [L/2, AXLE]}}
  trolley: {particle: {mass: M}}
  sheave: {disk: {radius: r}}
  weight: {particle: {mass: m}}
connections:
  pivot: {pin: [ground.O, jib.start]}
  rail: {slider: {body: trolley, on: jib, along: jib.x}}
  axle: {pin: [jib.axle, sheave]}
  rope: {string: [trolley, over sheave, weight]}
  turning: {driver: {measure: phi, follows: alpha}}
loads: {gravity: {gravity: g}}
measures: {phi: angle of jib, s: {travel of trolley along jib.x from jib.start}}
start: {s: 2 m}
"""


@pytest.mark.parametrize(("axle", "is_askew"), [("-r", False), ("0", True)])
def test_a_rope_runs_along_a_jib_that_turns(axle: str, is_askew: bool) -> None:
    # m g - S = m a, S - M g sin alpha = M a
    model = ON_A_JIB.replace("AXLE", axle)
    is_formula(model, "acceleration of s", "g*(m - M*sin(alpha))/(m + M)")
    is_formula(model, "tension of rope", "m*M*g*(1 + sin(alpha))/(m + M)")
    told = fb.System.from_text(model).assumptions
    assert any("taken to run along jib" in str(text) for text in told) == is_askew


def test_a_trolley_whose_way_is_not_said_has_the_common_tangent() -> None:
    # nobody says on which side of the sheave it starts, or it is put somewhere
    for change in ("start: {s: 2 m}", "trolley: {particle: {mass: M}"):
        model = ON_A_JIB.replace("AXLE", "0")
        new = {"start: {s: 2 m}": ""}.get(change, "trolley: {particle: {mass: M}, at: [2 m, 1 m]")
        system = fb.System.from_text(model.replace(change, new).replace("start: {s: 2 m}", ""))
        assert not any("taken to run along jib" in str(text) for text in system.assumptions)


LUFFING = """
parameters: {m: 500 kg, M: 100 kg, L: 12 m, w: 0.1 rad/s, a: 0.4 rad, s0: 4 m, v: 0.5 m/s, r: 0.2 m, g: 9.81 m/s^2}
bodies:
  jib: {rod: {length: L, mass: 0}, points: {drum: [-L/2, 0]}}
  trolley: {particle: {mass: M}}
  sheave: {disk: {radius: r}}
  drum: {disk: {radius: r}}
  load: {particle: {mass: m}}
connections:
  pivot: {pin: [ground.O, jib.start]}
  winch: {pin: [jib.drum, drum]}
  rail: {slider: {body: trolley, on: jib, along: jib.x}}
  axle: {pin: [trolley, sheave]}
  rope: {string: {path: [wound on drum clockwise, over sheave, load]}}
  turning: {driver: {measure: phi, follows: a + w*t}}
  running: {driver: {measure: s, follows: s0 + v*t}}
  holding: {driver: {measure: psi, follows: 0}}
loads: {weight: {gravity: g}}
measures:
  {phi: angle of jib, psi: angle of drum from jib, s: {travel of trolley along jib.x from jib.start}, y: y of load}
start: {y: -5 m}
"""


def test_a_load_on_a_luffing_jib_rises_by_the_jib_and_by_what_its_rope_comes_in() -> None:
    # s + r (phi + pi/2) + h = constant on a drum that turns with the jib; y = s sin phi - h
    is_formula(LUFFING, "rate of y at start", "v*sin(a) + s0*w*cos(a) + v + r*w")
    is_formula(LUFFING, "tension of rope at load at start", "m*(g + 2*v*w*cos(a) - s0*w^2*sin(a))")


def test_the_derivation_puts_in_the_length_that_the_start_gives() -> None:
    # S = M (g sin(alpha + w t) - s_0 w^2) of a trolley that a rope over the tip of the jib holds
    model = ON_A_JIB.replace("AXLE", "0").replace("[trolley, over sheave, weight]", "[trolley, over jib.end, ground.O]")
    model = model.replace("follows: alpha", "follows: alpha + w*t").replace("g: 9.81", "w: 0.2 rad/s, g: 9.81")
    for line in (
        "  sheave: {disk: {radius: r}}\n",
        "  weight: {particle: {mass: m}}\n",
        "  axle: {pin: [jib.axle, sheave]}\n",
    ):
        model = model.replace(line, "")
    assert "erhalten bleibt" in is_derived(model, "tension of rope")["de"]


def test_a_string_over_a_pinion_asks_nobody_twice() -> None:
    """On which side of its rack a pinion lies hangs on where it starts, and that on its string: no endless circle."""
    system = fb.System.from_text("""
parameters: {k1: 0.2 kg, k2: 3 m, k3: 0.2 kg, k4: 1 m}
bodies:
  p: {half_disk: {mass: k1, radius: k2}, near: {at: [-1 m, 1 m]}}
  q: {sector: {mass: k3, radius: k4/3, angle: 1/3}, near: {at: [0.5 m, 1 m]}, fixed: true}
connections:
  c0: {rack_and_pinion: {pinion: p, rack: q}}
  c1: {string: {from: q, over: [p], to: q}}
""")
    assert [row.connection for row in system.constraint_rows].count("c0") > 0
