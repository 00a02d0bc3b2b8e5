"""What cannot be answered is refused with its cause in the user's terms, and what can be is not."""

from __future__ import annotations

import math
import re

import pytest

import freebody as fb
from freebody.errors import CannotAnswer

SCREW = """
space: true
ground: {points: {A: [0, 2 m, 0.3 m]}}
bodies: {nut: {sphere: {mass: 3 kg, radius: 0.125 m}}}
connections: {thread: {screw: {first: ground.A, second: nut, about: -x, pitch: 0.2 m, second_axis: [1, 1, 0]}}}
measures: {d: distance from ground.A to nut}
questions: [velocity of d, speed of nut]
"""


def test_a_distance_that_starts_at_nothing_stands_still() -> None:
    """d = |pitch phi/(2 pi)|: at d = 0 its rate has no sign, and the nut stands there."""
    rate, speed = fb.System.from_text(SCREW).solve().answers
    assert rate.value == speed.value == pytest.approx(0.0)


def test_a_distance_that_starts_open_is_the_one_coordinate() -> None:
    """|phi'| = 2 pi d'/pitch."""
    text = SCREW.replace(
        "questions: [", "start: {d: 0.4 m, rate(d): 0.1 m/s}\nquestions: [angular velocity of nut along x, "
    )
    found = fb.System.from_text(text).solve()
    assert found.coordinates == ("d",)
    assert all(answer.expression is not None for answer in found.answers)
    assert [answer.value for answer in found.answers] == pytest.approx([2 * math.pi * 0.1 / 0.2, 0.1, 0.1])


LINKED = """
bodies:
  hub: {disk: {mass: 2 kg, radius: 0.3 m}, at: [0.5 m, 1 m]}
  arm: {rod: {mass: 1 kg, length: 1 m}, points: {eye: [0.2 m, 0]}, near: {at: [0.4 m, 1 m]}}
connections:
  fast: {weld: [arm.eye, hub]}
  bar: {link: [hub, arm.eye]}
loads: {weight: {gravity: 9.81 m/s^2}}
"""
WHEELS = """
bodies:
  small: {ring: {mass: 1 kg, radius: 0.2 m}}
  large: {ring: {mass: 1 kg, radius: 0.4 m}}
connections:
  axle: {pin: [small.center, large.center]}
  gears: {gear_mesh: [small, large]}
loads: {drive: {torque: {on: large, magnitude: 2 N m}}}
"""


@pytest.mark.parametrize(("text", "row"), [(LINKED, "bar"), (WHEELS, "gears")])
def test_points_that_are_in_one_place_but_for_round_off_are_named(text: str, row: str) -> None:
    with pytest.raises(CannotAnswer, match=rf"in one place, and {row} needs a line between them"):
        fb.System.from_text(text).simulate(1.0)


BRAKED = """
parameters: {m: 2 kg, R: 3 N, c: 0.4 N m s, v: 6 m/s}
bodies: {disk: {disk: {mass: m, radius: 0.5 m}, velocity: [v, 0], angular_velocity: 2 rad/s}}
measures: {s: x of disk}
connections: {rub: {dry_friction: {measure: s, force: R}}}
loads: {drag: {torsional_damper: {body: disk, damping: c}}}
questions: [time until rate(s) = 0]
"""


def test_friction_ends_a_translation_beside_a_turn_that_decays() -> None:
    """Two laws of their own: s' = v - R t/m is zero at m v/R, while the turn goes on as exp(-c t/I)."""
    (stopped,) = fb.System.from_text(BRAKED).solve().answers
    assert stopped.value == pytest.approx(2 * 6 / 3)


STANDING = """
ground: {points: {A: [0, 1 m]}}
bodies: {ball: {disk: {mass: 2 kg, radius: 0.1 m}}}
connections: {end: {stop: {measure: y of ground.A, min: 0.5 m}}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: [reaction of end]
"""


def test_a_reaction_on_nothing_that_moves_is_said_to_be_one() -> None:
    (answer,) = fb.System.from_text(STANDING).solve().answers
    assert answer.reason == "end acts on nothing that moves"


SPRUNG = """
space: true
bodies: {nut: {sphere: {mass: 3 kg, radius: 0.125 m}}}
connections: {thread: {screw: {first: ground.origin, second: nut, about: -x, pitch: 0.2 m, second_axis: y}}}
loads: {hold: {spring: {first: ground.origin, second: nut, stiffness: 5 N/m, length: 0.1 m}}}
questions: [speed of nut]
"""


def test_a_start_without_a_draw_on_the_branch_of_the_formulas_is_refused() -> None:
    """A relaxed length of a spring whose ends coincide: it pushes, but neither way."""
    (answer,) = fb.System.from_text(SPRUNG).solve().answers
    assert answer.reason == "at the start the formulas have no value, or another sign than nearby"
    assert answer.value == pytest.approx(0.0, abs=1e-12)


STOPPED = """
bodies: {p: {disk: {mass: 3 kg, radius: 1 m}, at: [0, 0]}, q: {disk: {mass: 1 kg, radius: 1 m}, at: [3 m, 0]}}
measures: {c: alignment of p.x and right}
connections: {still: {velocity_constraint: {expression: rate(c)}}}
questions: [position of c]
"""


def test_formulas_are_not_compared_where_no_motion_leads() -> None:
    """(cos a)' = -sin a a' = 0 says nothing at a = 0 alone: nearby a is held, so no motion leads there."""
    (answer,) = fb.System.from_text(STOPPED).solve().answers
    assert "defect" not in answer.reason
    assert answer.value == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("magnitude", "told"),
    [
        ("9e999 N", "9e999 is too large or too small: the exponent of ten is at most 300"),
        ("2 xyz", "the unit 'xyz' is not known"),
        ("2 xyz" + "*1" * 100, "xyz in"),  # longer than any quantity, so it is meant as an expression
    ],
)
def test_what_begins_as_a_quantity_is_told_as_one(magnitude: str, told: str) -> None:
    bodies = "bodies: {b: {particle: {mass: 1 kg}}}\n"
    text = f"{bodies}loads: {{p: {{force: {{at: b, along: x, magnitude: {magnitude}}}}}}}\n"
    with pytest.raises(fb.InputError) as refused:
        fb.System.from_text(text)
    assert told in str(refused.value)


BEADED = """
ground: {points: {far: [10 m, 0]}}
bodies: {bead: {disk: {mass: 2 kg, radius: 3 m}, at: [-3 m, 0]}}
measures: {x: x of bead}
connections: {rod: {slider: {body: bead, along: right}}}
loads: {s: {spring: {first: ground.origin, second: bead, stiffness: 0.5 N/m, length: 1 m}}}
questions: [when is Jacobi integral conserved]
"""


def test_a_conserved_quantity_is_followed_as_far_as_its_formula_holds() -> None:
    """V = k (|x| - L)^2/2 goes through x = 0, where its formula for x > 0 ends."""
    (answer,) = fb.System.from_text(BEADED).solve().answers
    assert "defect" not in answer.reason


PAIRED = """
bodies: {wheel: {ring: {mass: 2 kg, radius: 0.5 m}}}
connections: {teeth: {rack_and_pinion: {pinion: wheel, rack: ground}}}
measures: {a: angle of line from ground.origin to ground.origin}
"""


def test_a_line_from_a_point_to_itself_is_named_where_a_motion_needs_its_direction() -> None:
    with pytest.raises(CannotAnswer, match="two points coincide, so the line between them has no direction"):
        fb.System.from_text(PAIRED).simulate(1.0)


GEARED = """
parameters: {k: 5 N/m^3}
bodies:
  p:
    body: {mass: 0.5 kg, inertia: 10 kg m^2, center_of_mass: [10 m, 0], radius: 0.125 m}
    near: {at: [-1 m, 0.5 m]}
connections: {teeth: {gear_mesh: {first: p, second: ground, second_radius: 3 m}}}
measures: {u: height of p.mass_center above ground.origin}
loads: {f: {law: {measure: u, force: -k*u^3}}}
questions: [angular acceleration of p at start]
"""


@pytest.mark.slow
def test_terms_that_cancel_are_added_with_more_digits() -> None:
    """u has the sine of 25 times an angle in it, as a polynomial with terms of 1e3, and its cube terms of 1e9."""
    (answer,) = fb.System.from_text(GEARED).solve().answers
    assert "defect" not in answer.reason
    assert answer.evidence is not None


GEARS = """
parameters: {{rs: 0.1 m, rp: 0.05 m, w: 12 rad/s}}
bodies:
  sun: {{disk: {{radius: rs}}}}
  planet: {{disk: {{radius: rp}}, at: [{place}, 0]}}
  ring: {{ring: {{radius: rs + 2*rp}}, fixed: true}}
  arm: {{rod: {{length: {place}}}}}
connections:
  a: {{pin: [ground.O, sun]}}
  b: {{pin: [ground.O, arm.start]}}
  c: {{pin: [arm.end, planet]}}
  first: {{gear_mesh: [sun, planet]}}
  second: {{gear_mesh: {outer}}}
  d: {{driver: {{measure: angle of sun, follows: w*t}}}}
"""


def test_a_gear_inside_a_ring_gear_is_not_taken_to_mesh_with_its_outside() -> None:
    """Willis: the arm turns at w rs/(2 (rs + rp)); with the ring's teeth outside it would be -w."""
    with pytest.raises(fb.ModelError, match="one pitch circle lies inside the other"):
        fb.System.from_text(GEARS.format(place="rs + rp", outer="[planet, ring]"))
    outer = "{first: ring, second: planet, internal: true}"
    solution = fb.System.from_text(GEARS.format(place="rs + rp", outer=outer)).solve("angular velocity of arm")
    assert solution.answers[0].value == pytest.approx(12 * 0.1 / (2 * 0.15))
    assert not solution.assumptions


def test_gears_that_do_not_touch_where_they_are_put_are_said_to_count_by_their_radii() -> None:
    outer = "{first: ring, second: planet, internal: true}"
    solution = fb.System.from_text(GEARS.format(place="0.2 m", outer=outer)).solve("angular velocity of arm")
    told = [text for text in solution.assumptions if "do not touch where these are put" in text]
    assert len(told) == 2
    assert "0.2 m between the centres instead of 0.15 m" in told[0]


def test_a_line_of_the_ground_is_not_taken_for_the_direction_of_that_name() -> None:
    """What is put on an incline called left would move level."""
    text = """
ground: {lines: {left: {along: 30 deg}}}
bodies: {block: {particle: {mass: 2 kg}}}
connections: {on: {slider: {body: block, along: left}}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {s: travel of block along left}
"""
    with pytest.raises(fb.ModelError, match="left is a direction and a line of the ground"):
        fb.System.from_text(text)
    answer = fb.System.from_text(text.replace("left", "ramp")).solve("acceleration of s").answers[0]
    assert answer.value == pytest.approx(-9.81 / 2)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (("theta: 60 deg", "theta: 60"), "the angle 60 has no unit: write 60 deg, or 60 rad"),
        (("theta: 60 deg", "theta: a"), "a is used as an angle, and its value 60 has no unit"),
        (("along: 30 deg", "along: 30"), "the angle 30 has no unit"),
        (("along: 30 deg", "along: -a"), "a is used as an angle"),
        (("along: 30 deg", "along: 180 deg - a"), "a is used as an angle"),
        (("angle: 20 deg", "angle: 20"), "the angle 20 has no unit"),
    ],
)
def test_an_angle_of_many_turns_needs_a_unit(change: tuple[str, str], said: str) -> None:
    text = """
parameters: {a: 60, L: 1 m}
ground: {lines: {ramp: {along: 30 deg}}}
bodies: {bob: {particle: {mass: 1 kg}}, rod: {rod: {mass: 1 kg, length: L}, at: [3 m, 0], angle: 20 deg}}
connections: {string: {link: [ground.O, bob, L]}}
measures: {theta: {angle of line from ground.O to bob from down}}
start: {theta: 60 deg}
"""
    fb.System.from_text(text)  # as it should be
    radians = change[1].replace("60", "1.2").replace("30", "0.5").replace("20", "6")
    fb.System.from_text(text.replace("a: 60", "a: 1.2").replace(change[0], radians))
    with pytest.raises(fb.ModelError, match=re.escape(said)):
        fb.System.from_text(text.replace(*change))


TACKLE = """
parameters: {m1: 20 kg, m2: 8 kg, mp: 1 kg, r: 0.1 m, g: 9.81 m/s^2}
ground: {points: {P: [0, 0], Q: [0.3 m, 0]}}
bodies:
  load: {particle: {mass: m1}}
  weight: {particle: {mass: m2}}
  lower: {disk: {mass: mp, radius: r}}
  upper: {disk: {mass: mp, radius: r}}
connections:
  axle: {pin: [ground.Q, upper.center]}
  rope: {string: {WAY}}
  hook: {string: {from: lower, to: load}}
loads: {gravity: {gravity: g}}
measures: {x: drop of load below ground.P}
questions: [acceleration of x]
"""


@pytest.mark.parametrize(
    ("way", "said"),
    [
        ("from: ground.P, over: [lower, upper], to: weight", r"path: \[\.\.\., under lower, \.\.\.\]"),
        ("from: ground.P, over: [upper], under: [lower], to: weight", r"path: \[ground\.P, over upper, under lower"),
    ],
)
def test_a_way_that_no_rope_could_take_or_that_is_open_is_refused(way: str, said: str) -> None:
    with pytest.raises(fb.ModelError, match=said):
        fb.System.from_text(TACKLE.replace("WAY", way))


def test_between_wheels_that_hang_a_rope_runs_over_something() -> None:
    way = "path: [ground.P, under lower, under upper, weight]"
    text = TACKLE.replace("WAY", way).replace("  axle: {pin: [ground.Q, upper.center]}\n", "")
    with pytest.raises(fb.ModelError, match=r"path: \[\.\.\., over pulley, under upper, \.\.\.\]"):
        fb.System.from_text(text)


def test_the_rope_under_the_lower_wheel_and_over_the_upper_one_is_a_tackle() -> None:
    """The load moves by x, the weight by 2x; both wheels are uniform disks that turn by x/r and 2x/r:
    (m1 + mp + 4 m2 + mp/2 + 4 mp/2) x'' = (m1 + mp - 2 m2) g."""
    [found] = (
        fb.System.from_text(TACKLE.replace("WAY", "path: [ground.P, under lower, over upper, weight]")).solve().answers
    )
    m1, m2, mp, g = 20.0, 8.0, 1.0, 9.81
    assert found.value == pytest.approx((m1 + mp - 2 * m2) * g / (m1 + 3.5 * mp + 4 * m2), rel=1e-12)


def test_a_model_without_formulas_has_the_numbers_that_are_unique() -> None:
    """A truss between two fixed pins, its lower bars in one line: their tensions are one too many, the others follow
    from the nodes (F/sqrt(2) of pressure in the slanted bars, F in the post)."""
    found = fb.System.from_text("""
parameters: {a: 2 m, F: 10 kN}
ground: {points: {A: [0, 0], B: [2*a, 0]}}
bodies: {n1: {particle: {mass: 0 kg}, at: [a, 0]}, n2: {particle: {mass: 0 kg}, at: [a, a]}}
connections:
  s1: {link: [ground.A, n1]}
  s2: {link: [n1, ground.B]}
  s3: {link: [ground.A, n2]}
  s4: {link: [n2, ground.B]}
  s5: {link: [n1, n2]}
loads: {F: {force: {at: n1, along: down, magnitude: F}}}
questions: [tension of s3, tension of s5, tension of s1]
""").solve()
    slanted, post, lower = found.answers
    assert slanted.value == pytest.approx(-1e4 / math.sqrt(2))
    assert post.value == pytest.approx(1e4)
    assert lower.value is None
    assert "not unique" in lower.reason


def test_a_law_that_jumps_with_a_rate_has_no_phases() -> None:
    """Beside a stop: where the pile turns back its law would jump, which is no border of a case distinction."""
    system = fb.System.from_text(
        "parameters: {M: 500 kg, m: 200 kg, h: 2 m, R: 40 kN, g: 9.81 m/s^2}\n"
        "bodies: {ram: {particle: {mass: M}, at: [0, h]}, pile: {particle: {mass: m}, at: [0, 0]}}\n"
        "connections: {g1: {slider: {body: ram, along: up}}, g2: {slider: {body: pile, along: up}},"
        " c: {stop: {measure: gap, min: 0, restitution: 0}}}\n"
        "loads: {weight: {gravity: g}, soil: {law: {measure: y, force: -R*sign(rate(y))}}}\n"
        "measures: {y: y of pile, z: y of ram, gap: {expression: z - y}}\nstart: {y: 0, rate(y): 0, z: h, rate(z): 0}"
    )
    [answer] = system.solve("speed of pile after the impact").answers
    assert answer.expression is None
    assert "the law of soil jumps" in answer.reason


def test_a_place_at_which_a_loop_cannot_be_closed_is_refused_in_words() -> None:
    """The rope is too short for the bar to get down to the level: |bar.end - P| = sqrt(8) m of its 3.118 m."""
    system = fb.System.from_text(
        "parameters: {m: 10 kg, L: 2 m, M: 4 kg, h: 2 m, g: 9.81 m/s^2}\nground: {points: {A: [0, 0], P: [0, h]}}\n"
        "bodies: {bar: {rod: {mass: m, length: L}}, w: {particle: {mass: M}, at: [-0.5 m, 1 m]}}\n"
        "connections: {hinge: {pin: [ground.A, bar.start]}, gw: {slider: {body: w, along: up}},"
        " rope: {string: {path: [bar.end, over ground.P, w]}}}\nloads: {weight: {gravity: g}}\n"
        "measures: {phi: angle of bar from up clockwise}\nstart: {phi: 60 deg, rate(phi): 0}"
    )
    [answer] = system.solve("angular velocity of bar when phi = 90 deg").answers
    assert answer.expression is None
    assert answer.value is None
    assert answer.reason


def test_after_it_has_happened_is_no_time() -> None:
    """`after T is` a time T where an equation goes on; `it` is none."""
    system = fb.System.from_text(
        "parameters: {L: 1 m}\nbodies: {rod: {rod: {mass: 1 kg, length: L}}}\n"
        "connections: {hinge: {pin: [ground.A, rod.start]}}\nmeasures: {phi: angle of rod}\n"
    )
    with pytest.raises(fb.InputError) as refused:
        system.solve("How must L be chosen so that the rod turns fastest after it is caught?")
    assert "Python" not in str(refused.value)
