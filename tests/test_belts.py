"""Belts with pretension, mass and slip, and chains: tensions, bearings, power, lengths."""

from __future__ import annotations

import math

import pytest

import freebody as fb

DRIVE = """
parameters: {{I_1: 0.02 kg m^2, I_2: 0.5 kg m^2, r_1: 60 mm, r_2: 150 mm, d: 0.6 m, mu: 0.3, T_0: 400 N, M: 10 N m,
  w: {{value: {w} rad/s, sign: any}}, q: 0.25 kg/m}}
ground: {{points: {{A: [0, 0], B: [d, 0]}}}}
bodies:
  motor: {{body: {{inertia: I_1, radius: r_1}}, angular_velocity: w}}
  drum: {{body: {{inertia: I_2, radius: r_2}}, angular_velocity: {sign}w*r_1/r_2}}
connections:
  A: {{pin: [ground.A, motor]}}
  B: {{pin: [ground.B, drum]}}
  belt: {{belt: {{first: motor, second: drum{more}}}}}
loads: {{drive: {{torque: {{on: motor, magnitude: M}}}}}}
"""
FORCE = 0.5 * 0.06 * 10 / (0.02 * 0.15**2 + 0.5 * 0.06**2)  # I_2 r_1 M/(I_1 r_2^2 + I_2 r_1^2)
LIFT = math.asin(0.09 / 0.6)  # sin(gamma) = (r_2 - r_1)/d


def value(system: fb.System, question: str) -> object:
    return system.solve(question).answers[0].value


def drive(more: str, w: float = 0.0, sign: str = "") -> fb.System:
    return fb.System.from_text(DRIVE.format(more=more, w=w, sign=sign))


def test_the_runs_of_a_belt_share_its_pretension_and_the_bearings_carry_both() -> None:
    """T_1 + T_2 = 2 T_0, T_1 - T_2 = F. The drum is pulled along the line of centres by 2 T_0 cos(gamma), and
    across it by F sin(gamma)."""
    system = drive(", pretension: T_0")
    assert value(system, "belt force of belt") == pytest.approx(FORCE)
    assert value(system, "tight tension of belt") == pytest.approx(400 + FORCE / 2)
    assert value(system, "slack tension of belt") == pytest.approx(400 - FORCE / 2)
    pulled = (2 * 400 * math.cos(LIFT), FORCE * math.sin(LIFT))
    assert value(system, "reaction of B on drum") == pytest.approx(pulled)
    assert value(system, "reaction of A on motor") == pytest.approx((-pulled[0], -pulled[1]))


def test_a_belt_slips_where_its_tensions_have_the_ratio_of_euler_and_eytelwein() -> None:
    """(T_1 - q v^2)/(T_2 - q v^2) = e^(mu phi) with phi = pi - 2 gamma of the smaller pulley."""
    system = drive(", pretension: T_0, friction: mu, mass_per_length: q", w=100)
    speed, wrap = 6.0, math.pi - 2 * LIFT
    limit = value(system, "greatest belt force of belt at start")
    tight, slack = 400 + limit / 2, 400 - limit / 2
    centrifugal = 0.25 * speed**2
    assert (tight - centrifugal) / (slack - centrifugal) == pytest.approx(math.exp(0.3 * wrap))
    gain = math.exp(0.3 * wrap)
    best = math.sqrt(400 / (3 * 0.25))
    assert value(system, "speed of greatest power of belt") == pytest.approx(best)
    # P(v) = 2 (T_0 - q v^2) v (e - 1)/(e + 1) at q v^2 = T_0/3
    power = 2 * (400 - 0.25 * best**2) * best * (gain - 1) / (gain + 1)
    assert value(system, "greatest power of belt") == pytest.approx(power)


def test_a_belt_that_is_driven_too_hard_slips_with_that_force() -> None:
    """Sliding with F = 2 T_0 (e - 1)/(e + 1), motor and drum have accelerations of their own."""
    system = drive(", pretension: T_0/10, friction: mu, wrap: 150 deg")
    gain = math.exp(0.3 * math.radians(150))
    force = 2 * 40 * (gain - 1) / (gain + 1)
    assert force < FORCE
    found = system.simulate(0.2)
    assert float(found.course.velocities[-1, 0, 2]) == pytest.approx((10 - 0.06 * force) / 0.02 * 0.2, rel=1e-6)
    assert float(found.course.velocities[-1, 1, 2]) == pytest.approx(0.15 * force / 0.5 * 0.2, rel=1e-6)
    assert value(system, "belt force of belt") == pytest.approx(force)


def test_the_mass_of_a_fast_belt_makes_it_slip() -> None:
    """F = I_2 r_1 M/(...) exceeds 2 (T_0 - q v^2) (e - 1)/(e + 1) from some speed on; the motor gets there after
    t = (w_c - w)/a."""
    system = drive(", pretension: T_0, friction: mu, wrap: 163 deg, mass_per_length: q", w=480)
    gain = math.exp(0.3 * math.radians(163))
    share = 2 * (gain - 1) / (gain + 1)
    critical = math.sqrt((400 - FORCE / share) / 0.25) / 0.06
    acceleration = 0.15**2 * 10 / (0.02 * 0.15**2 + 0.5 * 0.06**2)
    found = system.simulate(1.5 * (critical - 480) / acceleration)
    slip = found.events[0]
    assert slip.name == "belt starts to slip"
    assert slip.time == pytest.approx((critical - 480) / acceleration, rel=1e-6)


def test_a_belt_that_has_lifted_off_carries_nothing() -> None:
    """At 42 m/s, faster than sqrt(T_0/q) = 40 m/s: motor and drum turn each for itself."""
    system = drive(", pretension: T_0, friction: mu, wrap: 163 deg, mass_per_length: q", w=700)
    assert value(system, "greatest belt force of belt") == 0.0
    assert value(system, "belt force of belt") == 0.0
    ends = system.simulate(0.3).course.velocities[-1, :, 2]
    assert ends[:2] == pytest.approx([700 + 10 / 0.02 * 0.3, 700 * 0.4])


def test_the_range_without_slip_is_one_inequality_for_the_torque() -> None:
    """F <= 2 (T_0 - q v^2) (e - 1)/(e + 1), solved for M; that F >= -2 (...) follows from it."""
    system = drive(", pretension: T_0, friction: mu, wrap: 163 deg, mass_per_length: q", w=150)
    (condition,) = system.solve("belt force of belt").answers[0].conditions
    left, relation, right = condition.expression.split(" ", 2)
    assert (left, relation) == ("M", "<=")
    gain = math.exp(0.3 * math.radians(163))
    most = 2 * (400 - 0.25 * (0.06 * 150) ** 2) * (gain - 1) / (gain + 1)
    numbers = {name: system.parameters[name].value for name in system.parameters}
    found = eval(right, {"exp": math.exp, "pi": math.pi}, numbers)
    assert found == pytest.approx(most * 10 / FORCE)


def test_a_tightened_belt_in_a_groove_carries_up_to_its_largest_tension() -> None:
    """Shigley, sec. 17-2: F = (T_max - q v^2)(1 - e^(-mu' phi)), mu' = mu/sin(beta/2)."""
    system = drive(", largest_tension: 600 N, friction: mu, groove_angle: 38 deg, mass_per_length: q, wrap: 163 deg")
    share = 1 - math.exp(-0.3 / math.sin(math.radians(19)) * math.radians(163))
    best = math.sqrt(600 / (3 * 0.25))
    assert value(system, "greatest power of belt") == pytest.approx(share * 400 * best)
    assert value(system, "greatest belt force of belt at start") == pytest.approx(600 * share)


@pytest.mark.parametrize(("crossed", "sign"), [("", 1), (", crossed: true", -1)])
def test_the_length_of_a_belt_is_that_of_its_straight_and_bent_parts(crossed: str, sign: int) -> None:
    system = drive(crossed, sign="" if sign > 0 else "-")
    r_1, r_2, d = 0.06, 0.15, 0.6
    lift = math.asin((r_2 - r_1) / d) if sign > 0 else math.asin((r_2 + r_1) / d)
    bent = r_1 * (math.pi - 2 * lift) + r_2 * (math.pi + 2 * lift) if sign > 0 else (r_1 + r_2) * (math.pi + 2 * lift)
    assert value(system, "length of belt") == pytest.approx(2 * d * math.cos(lift) + bent)


@pytest.mark.parametrize(
    ("more", "told"),
    [
        (", length: 1.5 m", r"1\.5 m long, and its way round the wheels 1\.8733 m"),
        (", friction: mu", "needs its pretension, or its largest_tension"),
        (", friction: mu, pretension: T_0, largest_tension: T_0", "one of both"),
    ],
)
def test_belts_that_do_not_fit_are_refused(more: str, told: str) -> None:
    with pytest.raises(fb.ModelError, match=told):
        drive(more)


def test_wheels_that_overlap_have_no_belt() -> None:
    with pytest.raises(fb.ModelError, match=r"0\.2 m apart, and their radii need more than 0\.21 m"):
        fb.System.from_text(DRIVE.format(more="", w=0, sign="").replace("d: 0.6 m", "d: 0.2 m"))


CHAIN = """
parameters: {z_1: 44, z_2: 16, p: 12.7 mm, M: 30 N m, d: 420 mm}
ground: {points: {A: [0, 0], B: [d, 0]}}
bodies: {crank: {body: {inertia: 0.05 kg m^2}}, hub: {body: {inertia: 0.1 kg m^2}}}
connections:
  A: {pin: [ground.A, crank]}
  B: {pin: [ground.B, hub]}
  chain: {chain: {first: crank, second: hub, pitch: p, teeth: [z_1, z_2]}}
loads: {pedal: {torque: {on: crank, magnitude: M}}}
"""


def test_sprockets_turn_as_the_inverse_of_their_teeth() -> None:
    """The links that one takes the other gives; the chain force is that of pulleys of the radii p z/(2 pi)."""
    system = fb.System.from_text(CHAIN)
    assert value(system, "ratio of angular velocity of hub to angular velocity of crank") == pytest.approx(44 / 16)
    radius, inertia = 0.0127 * 44 / (2 * math.pi), 0.05 + 0.1 * (44 / 16) ** 2
    force = (30 - 0.05 * 30 / inertia) / radius
    assert value(system, "chain force of chain") == pytest.approx(force)


def test_the_links_of_a_chain_are_those_of_its_length() -> None:
    """Shigley, sec. 17-5: L/p = 2 C/p + (z_1 + z_2)/2 + (z_1 - z_2)^2/(4 pi^2 C/p), for a small difference."""
    c = 420 / 12.7
    links = 2 * c + (44 + 16) / 2 + (44 - 16) ** 2 / (4 * math.pi**2 * c)
    assert value(fb.System.from_text(CHAIN), "links of chain") == pytest.approx(links, rel=1e-4)


@pytest.mark.parametrize(("torque", "more", "side"), [(30, "", 1), (-30, ", other_run: true", -1)])
def test_the_tight_run_of_a_chain_pulls_at_the_bearings(torque: float, more: str, side: int) -> None:
    """A tension F along the run, which is at gamma = asin((r_1 - r_2)/d) to the line of centres: F cos(gamma) towards
    the other sprocket whichever run is tight, and across it F sin(gamma) to the side of that run."""
    text = CHAIN.replace("M: 30 N m", f"M: {{value: {torque} N m, sign: any}}").replace("z_2]}", f"z_2]{more}}}")
    system = fb.System.from_text(text)
    force = abs(value(system, "chain force of chain"))
    lift = math.asin(0.0127 * (44 - 16) / (2 * math.pi * 0.42))
    along, across = force * math.cos(lift), side * force * math.sin(lift)
    assert value(system, "reaction of A on crank") == pytest.approx((-along, across))
    assert value(system, "reaction of B on hub") == pytest.approx((along, -across))


def test_the_wrong_run_of_a_chain_is_told() -> None:
    system = fb.System.from_text(CHAIN.replace("z_2]}", "z_2], other_run: true}"))
    answer = system.solve("reaction of A").answers[0]
    assert any("write other_run" in str(condition) for condition in answer.conditions)


def test_bearings_of_a_belt_without_pretension_carry_what_nobody_knows() -> None:
    with pytest.raises(fb.ModelError, match="the force in A is not known: both runs of belt pull at it"):
        drive("").solve("reaction of A")


@pytest.mark.parametrize("question", ["length of belt", "greatest power of belt", "speed of greatest power of belt"])
def test_what_a_belt_can_do_is_the_same_whether_it_slips_or_not(question: str) -> None:
    """No condition on the motor and no case of slip stands beside it."""
    answer = drive(", pretension: T_0, friction: mu, mass_per_length: q", w=50).solve(question).answers[0]
    assert answer.value is not None
    assert not any("M" in str(condition) or "slip" in str(condition) for condition in answer.conditions)


def test_a_tightener_keeps_the_tight_run_and_the_slack_one_gives_way() -> None:
    """T_1 is what the tightener keeps, T_2 = T_1 - F."""
    system = drive(", largest_tension: 2*T_0, friction: mu")
    assert value(system, "tight tension of belt") == pytest.approx(800)
    assert value(system, "slack tension of belt") == pytest.approx(800 - FORCE)


def test_a_chain_has_whole_teeth() -> None:
    with pytest.raises(fb.ModelError, match="a number of teeth is whole"):
        fb.System.from_text(CHAIN.replace("z_2: 16", "z_2: 16.5"))


def test_that_a_belt_does_not_slip_is_not_that_it_rests() -> None:
    """I_1 w_1' = T_1 - F r_1 and I_2 w_2' = F r_2 - T_2 with r_1 w_1 = r_2 w_2; at most F = 2 T_0 tanh(mu phi/2)."""
    text = """
parameters: {I1: 0.01 kg m^2, I2: 0.2 kg m^2, r1: 0.05 m, r2: 0.15 m, T1: 2 N m, T2: 1 N m, mu: 0.3,
  T_0: 100 N, phi: 170 deg}
ground: {points: {A: [0, 0], B: [0.6 m, 0]}}
bodies: {motor: {body: {inertia: I1, radius: r1}}, drum: {body: {inertia: I2, radius: r2}}}
connections:
  A: {pin: [ground.A, motor]}
  B: {pin: [ground.B, drum]}
  belt: {belt: {first: motor, second: drum, friction: mu, pretension: T_0, wrap: phi}}
loads: {drive: {torque: {on: motor, magnitude: T1}}, brake: {torque: {on: drum, magnitude: -T2}}}
"""
    system = fb.System.from_text(text)
    largest = system.solve("How large may T1 be so that the belt does not slip?")["q1"].value
    F = 2 * 100.0 * math.tanh(0.3 * math.radians(170) / 2)
    w2 = (F * 0.15 - 1.0) / 0.2
    assert largest == pytest.approx(0.01 * w2 * 0.15 / 0.05 + F * 0.05, rel=1e-9)
    assert system.solve("range of T1 for which the belt does not slip")["q1"].value == pytest.approx(largest, rel=1e-12)


@pytest.mark.parametrize(
    ("crossed", "beta"),
    [(False, 2.0 * math.acos(0.12 / 0.6)), (True, math.tau - 2.0 * math.acos(0.28 / 0.6))],
    ids=["open", "crossed"],
)
def test_the_angle_of_wrap_is_that_of_the_pulley_on_which_it_slips_first(crossed: bool, beta: float) -> None:
    """At the smaller pulley of an open belt cos(beta/2) = (R - r)/c; a crossed one embraces both by more than half a
    turn, cos(pi - beta/2) = (R + r)/c. Euler and Eytelwein: S_1/S_2 = e^(mu beta) where it is about to slip."""
    system = fb.System.from_text(f"""
parameters: {{r: 80 mm, R: 200 mm, c: 600 mm, mu: 0.4, F_0: 500 N}}
ground: {{points: {{A: [0, 0], B: [c, 0]}}}}
bodies: {{motor: {{disk: {{mass: 1 kg, radius: r}}}}, fan: {{disk: {{mass: 1 kg, radius: R}}, at: [c, 0]}}}}
connections:
  p: {{pin: [ground.A, motor]}}
  q: {{pin: [ground.B, fan]}}
  drive: {{belt: {{first: motor, second: fan, friction: mu, pretension: F_0, crossed: {str(crossed).lower()}}}}}
questions:
  - {{id: wrap, find: angle of wrap of drive}}
  - {{id: force, find: greatest belt force of drive}}
""")
    wrap, force = system.solve().answers
    assert wrap.value == pytest.approx(beta, rel=1e-9)
    assert wrap.unit == "rad"
    ratio = math.exp(0.4 * beta)
    assert force.value == pytest.approx(2.0 * 500.0 * (ratio - 1.0) / (ratio + 1.0), rel=1e-9)


def test_a_given_angle_of_wrap_is_told_again_and_a_chain_has_none() -> None:
    text = """
parameters: {mu: 0.3, F_0: 200 N}
ground: {points: [A, B]}
bodies: {a: {disk: {mass: 1 kg, radius: 0.1 m}}, b: {disk: {mass: 1 kg, radius: 0.2 m}}}
connections:
  p: {pin: [ground.A, a]}
  q: {pin: [ground.B, b]}
  drive: {belt: {first: a, second: b, friction: mu, pretension: F_0, wrap: 160 deg}}
questions: {it: angle of wrap of drive}
"""
    (answer,) = fb.System.from_text(text).solve().answers
    assert answer.value == pytest.approx(math.radians(160.0), rel=1e-12)
    chain = "{chain: {first: a, second: b, pitch: 12.7 mm, teeth: [19, 57]}}"
    text = text.replace("{belt: {first: a, second: b, friction: mu, pretension: F_0, wrap: 160 deg}}", chain)
    with pytest.raises(fb.errors.ModelError, match="angle of wrap"):
        fb.System.from_text(text)


@pytest.mark.parametrize(
    "words",
    ["how large is the angle of wrap?", "wrap angle of the belt drive", "Umschlingungswinkel des Riemens drive"],
)
def test_the_angle_of_wrap_is_understood_in_peoples_words(words: str) -> None:
    text = """
ground: {points: {A: [0, 0], B: [0.6 m, 0]}}
bodies: {a: {disk: {mass: 1 kg, radius: 0.1 m}}, b: {disk: {mass: 1 kg, radius: 0.1 m}, at: [0.6 m, 0]}}
connections: {p: {pin: [ground.A, a]}, q: {pin: [ground.B, b]}, drive: {belt: [a, b]}}
questions: {it: "WORDS"}
"""
    (answer,) = fb.System.from_text(text.replace("WORDS", words)).solve().answers
    assert answer.value == pytest.approx(math.pi)


def test_what_follows_from_the_parameters_of_a_belt_is_told_where_nothing_has_mass() -> None:
    # Source: Shigley, Mechanical Engineering Design, sec. 17-2: theta = pi - 2 asin((D - d)/(2 C))
    system = fb.System.from_text("""
parameters: {d1: 200 mm, d2: 500 mm, a: 1.2 m, n1: 1450 rpm, mu: 0.3, F1: 2 kN}
bodies: {small: {disk: {radius: d1/2}, at: [0, 0]}, large: {disk: {radius: d2/2}, at: [a, 0]}}
connections:
  axle1: {pin: [ground.O1, small]}
  axle2: {pin: [ground.O2, large]}
  belt: {belt: {around: [small, large], friction: mu, largest_tension: F1}}
  motor: {driver: {body: small, speed: n1}}
""")
    wrap, motion = system.solve(["angle of wrap", "angular velocity of large"]).answers
    assert wrap.value == pytest.approx(math.pi - 2 * math.asin((0.5 - 0.2) / 2.4), rel=1e-12)
    assert motion.expression is None
    assert "Give the body a mass" in str(motion.reason)
