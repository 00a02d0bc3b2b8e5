"""Bevel, helical and worm gears: what turns, what the teeth do to the bearings, and what friction holds."""

from __future__ import annotations

import math

import pytest

import freebody as fb

BEVEL = """
space: true
parameters: {{z_1: 20, z_2: 40, r: 45 mm, T_1: 30 N m, T_2: 60 N m}}
ground: {{points: {{A: [0.1 m, 0, 0], B: {at}}}}}
bodies: {{pinion: {{body: {{mass: 1 kg, inertia: 1 g m^2}}}}, crown: {{body: {{mass: 1 kg, inertia: 1 g m^2}}}}}}
connections:
  A: {{revolute: {{first: ground.A, second: pinion, about: x}}}}
  B: {{revolute: {{first: ground.B, second: crown, about: {about}}}}}
  mesh: {{bevel_gears: {{first: pinion, second: crown, teeth: [z_1, z_2], radius: r, pressure_angle: 20 deg}}}}
loads:
  motor: {{torque: {{on: pinion, about: x, magnitude: T_1}}}}
  machine: {{torque: {{on: crown, about: {about}, magnitude: {sign}T_2}}}}
measures: {{phi: angle of pinion about x}}
start: {{phi: 0}}
"""


def test_bevel_gears_load_their_bearings_as_in_shigley() -> None:
    """W_t = T/r, W_r = W_t tan(alpha) cos(delta), W_a = W_t tan(alpha) sin(delta) with tan(delta) = z_1/z_2."""
    system = fb.System.from_text(BEVEL.format(at="[0, 0.06 m, 0]", about="y", sign=""))
    tangential, delta = 30 / 0.045, math.atan(20 / 40)
    parting = tangential * math.tan(math.radians(20))
    assert system.solve("tooth force of mesh").answers[0].value == pytest.approx(tangential)
    assert system.solve("radial tooth force of mesh").answers[0].value == pytest.approx(parting * math.cos(delta))
    assert system.solve("axial tooth force of mesh").answers[0].value == pytest.approx(parting * math.sin(delta))
    on_pinion = (-parting * math.sin(delta), parting * math.cos(delta), tangential)
    assert system.solve("reaction of A on pinion").answers[0].value == pytest.approx(on_pinion)
    # the pinion's radial part is the axial one of the crown; actio = reactio
    assert system.solve("reaction of B on crown").answers[0].value == pytest.approx(tuple(-x for x in on_pinion))
    # about the bearing of the pinion: r_1/tan(delta) from the apex, 0.1 m from there to A
    arm = 0.045 / math.tan(delta) - 0.1
    moment = system.solve("moment of A on pinion").answers[0].value
    force = (parting * math.sin(delta), -parting * math.cos(delta), -tangential)
    expected = (0.0, arm * force[2], -(arm * force[1] - 0.045 * force[0]))
    assert moment == pytest.approx(expected, abs=1e-9)


def test_axes_of_bevel_gears_may_meet_at_any_angle() -> None:
    """Axes at 60 degrees: tan(delta_1) = sin(60)/(z_2/z_1 + cos(60)); the ratio is that of the teeth."""
    about = "[1/2, sqrt(3)/2, 0]"
    system = fb.System.from_text(BEVEL.format(at="[r, r*sqrt(3), 0]", about=about, sign="-"))
    # both torques drive: w_2 = -w_1 z_1/z_2 about the axis away from the apex
    acceleration = (30 + 60 / 2) / (1e-3 + 1e-3 / 4)
    assert system.solve("acceleration of phi").answers[0].value == pytest.approx(acceleration)
    tangential, delta = (30 - 1e-3 * acceleration) / 0.045, math.atan(math.sin(math.pi / 3) / (2 + 0.5))
    assert system.solve("tangential tooth force of mesh").answers[0].value == pytest.approx(tangential)
    # it is negative: the other flank bears
    other = fb.System.from_text(
        BEVEL.format(at="[r, r*sqrt(3), 0]", about=about, sign="-").replace("20 deg}", "20 deg, other_flank: true}")
    )
    axial = -tangential * math.tan(math.radians(20)) * math.sin(delta)
    assert other.solve("axial tooth force of mesh").answers[0].value == pytest.approx(axial)
    assert other.solve("reaction of A on pinion along x").answers[0].value == pytest.approx(-axial)


def test_axes_that_miss_each_other_are_no_bevel_gears() -> None:
    with pytest.raises(fb.ModelError, match=r"miss each other by 0\.02 m"):
        fb.System.from_text(BEVEL.format(at="[0, 0.06 m, 0.02 m]", about="y", sign=""))
    with pytest.raises(fb.ModelError, match="parallel"):
        fb.System.from_text(BEVEL.format(at="[0, 0.06 m, 0]", about="x", sign=""))


WORM = """
space: {{up: z}}
parameters: {{z_1: 2, z_2: 40, r: 20 mm, gamma: {gamma} deg, mu: {mu}, T: 5 N m, M: 80 N m}}
ground: {{points: {{A: [0, 0, r], B: [0, 0, -r*tan(gamma)*z_2/z_1{off}]}}}}
bodies: {{worm: {{body: {{mass: 1 kg, inertia: 0.1 g m^2}}}}, wheel: {{body: {{mass: 3 kg, inertia: 20 g m^2}}}}}}
connections:
  A: {{revolute: {{first: ground.A, second: worm, about: x}}}}
  B: {{revolute: {{first: ground.B, second: wheel, about: y}}}}
  mesh: {{worm_gear: {{worm: worm, wheel: wheel, starts: z_1, teeth: z_2, radius: r, lead_angle: gamma{more}}}}}
loads:
  load: {{torque: {{on: wheel, about: y, magnitude: M}}}}
{motor}
measures: {{phi: angle of worm about x, psi: angle of wheel about y}}
start: {{phi: 0, psi: 0, rate(phi): 0}}
"""
MOTOR = "  motor: {torque: {on: worm, about: x, magnitude: T}}"


@pytest.mark.parametrize(("hand", "sign"), [("", -1.0), (", left_handed: true", 1.0)])
def test_the_wheel_of_a_worm_turns_by_threads_over_teeth(hand: str, sign: float) -> None:
    """Right-handed, turning about x above the wheel: the thread pushes the top of the wheel along -x, against a turn
    about y."""
    system = fb.System.from_text(WORM.format(gamma=5, mu=0.1, off="", more=hand, motor=MOTOR))
    found = system.solve("ratio of rate of psi to rate of phi").answers[0].value
    assert found == pytest.approx(sign * 2 / 40)


def test_a_worm_drives_with_the_tangents_of_its_lead_and_friction_angle() -> None:
    """T = r F tan(lambda + phi'), tan(phi') = mu/cos(alpha), F = M/r_2; without the motor it holds where phi' >= lambda
    (Niemann & Winter)."""
    text = WORM.format(gamma=5, mu=0.12, off="", more=", friction: mu, pressure_angle: 20 deg", motor=MOTOR)
    low, high = fb.System.from_text(text).solve("range of T that keeps it at rest").answers[0].value
    lam, phi = math.radians(5), math.atan(0.12 / math.cos(math.radians(20)))
    force = 80 / (0.02 * math.tan(lam) * 20)
    assert high == pytest.approx(0.02 * force * math.tan(lam + phi))
    assert low == pytest.approx(0.02 * force * math.tan(lam - phi))
    assert low < 0  # it locks itself


def test_a_worm_locks_itself_from_the_friction_on_whose_angle_is_that_of_the_lead() -> None:
    text = WORM.format(gamma=5, mu=0.12, off="", more=", friction: mu, pressure_angle: 20 deg", motor="")
    least = fb.System.from_text(text).solve("least mu so that it stays at rest").answers[0].value
    assert least == pytest.approx(math.tan(math.radians(5)) * math.cos(math.radians(20)))


def test_a_steep_worm_is_driven_by_its_wheel() -> None:
    """lambda = 20 degrees, phi' = atan(0.05): J_1 a + J_2 (z_1/z_2)^2 a/eta' = M (z_1/z_2) eta', by virtual power."""
    text = WORM.format(gamma=20, mu=0.05, off="", more=", friction: mu", motor="")
    system = fb.System.from_text(text)
    lam, phi = math.radians(20), math.atan(0.05)
    back = math.tan(lam - phi) / math.tan(lam)  # efficiency when the wheel drives
    acceleration = -80 * 0.05 * back / (1e-4 + 0.05**2 * back * 0.02)
    found = system.simulate(0.05)
    assert float(found.series["phi"][0][-1]) == pytest.approx(acceleration * 0.05**2 / 2, rel=1e-6)


def test_a_worm_that_does_not_reach_its_wheel_is_refused_with_the_distance() -> None:
    with pytest.raises(fb.ModelError, match=r"0\.075 m apart, and the teeth need 0\.055 m"):
        fb.System.from_text(WORM.format(gamma=5, mu=0.1, off=" - 20 mm", more="", motor=MOTOR))


HELICAL = """
space: true
parameters: {{T: 5 N m, r: 0.1 m, beta: 25 deg, alpha: 20 deg}}
ground: {{points: {{A: [0, 0, 0], B: [0, 3*r, 0]}}}}
bodies:
  pinion: {{disk: {{mass: 1 kg, radius: r, axis: x}}}}
  wheel: {{disk: {{mass: 4 kg, radius: 2*r, axis: x}}}}
connections:
  shaft: {{revolute: {{first: ground.A, second: pinion, about: x}}}}
  output: {{revolute: {{first: ground.B, second: wheel, about: x}}}}
  mesh: {{helical_gears: {{first: pinion, second: wheel, teeth: [20, 40], radius: r, helix_angle: beta,
    pressure_angle: alpha{more}}}}}
loads: {{drive: {{torque: {{on: pinion, about: x, magnitude: {sign}T}}}}}}
measures: {{phi: angle of pinion about x}}
start: {{phi: 0}}
questions:
  {{force: reaction of shaft on pinion, moment: moment of shaft on pinion, teeth: tangential tooth force of mesh}}
"""


@pytest.mark.parametrize("is_left", [False, True])
@pytest.mark.parametrize("sign", [1, -1])
def test_the_thrust_on_a_helical_driver_follows_the_hand_of_its_teeth(sign: int, *, is_left: bool) -> None:
    """Curl the hand of the helix with the turn of the driver: the thumb points along the thrust. The bearing holds it,
    and the moment r F_a by which it tilts the wheel. Source: Shigley, Mechanical Engineering Design, sec. 13-16."""
    more = (", left_handed: true" if is_left else "") + (", other_flank: true" if sign < 0 else "")
    text = HELICAL.format(more=more, sign="" if sign > 0 else "-")
    solution = fb.System.from_text(text).solve()
    force, moment = solution["force"].value, solution["moment"].value
    tangential = solution["teeth"].value
    assert isinstance(tangential, float)
    assert math.copysign(1, tangential) == sign
    thrust = sign * (-1 if is_left else 1) * abs(tangential) * math.tan(math.radians(25))
    radial = abs(tangential) * math.tan(math.radians(20)) / math.cos(math.radians(25))
    assert force == pytest.approx([-thrust, radial, tangential], rel=1e-9)
    # on the wheel r y x thrust x = -r thrust z
    assert moment == pytest.approx([0, 0, 0.1 * thrust], rel=1e-9, abs=1e-12)


# -- equal planets ------------------------------------------------------------------------------------
HELICAL_PLANETS = """
space: true
parameters: {{J: 2 g m^2, J_p: 0.5 g m^2, T: 3 N m, r: 40 mm, z: 20, z_p: 15, beta: 20 deg}}
bodies:
  carrier: {{body: {{inertia: 1 g m^2}}, points: {{spider: [0, r*(1 + z_p/z), 0]}}}}
  sun: {{body: {{inertia: J}}}}
  planet: {{body: {{mass: 0.2 kg, inertia: J_p}}, {copies}}}
connections:
  base: {{revolute: {{first: ground.O, second: carrier, about: x}}}}
  held: {{driver: {{measure: psi, follows: 0}}}}
  sun_bearing: {{revolute: {{first: carrier, second: sun, about: x}}}}
  spider: {{revolute: {{first: {first}, second: {second}, about: x}}}}
  mesh: {{helical_gears: {{first: sun, second: planet, on: carrier, teeth: [z, z_p], radius: r, helix_angle: beta}}}}
measures: {{psi: angle of carrier about x, phi: angle of sun about x}}
loads: {{drive: {{torque: {{on: sun, about: x, magnitude: T}}}}}}
start: {{phi: 0, psi: 0}}
questions: [acceleration of phi, tooth force of mesh, reaction of sun_bearing along x]
"""


@pytest.mark.parametrize("n", [1, 2, 3, pytest.param(5, marks=pytest.mark.slow)])
@pytest.mark.parametrize("order", [("carrier.spider", "planet"), ("planet", "carrier.spider")])
def test_helical_planets_share_the_load(n: int, order: tuple[str, str]) -> None:
    """J x'' = T - n F r, J_p x'' z/z_p = F r z_p/z; the thrusts F tan(beta) of all planets add up on the sun."""
    copies = "fixed: false" if n == 1 else f"copies: {n}"
    system = fb.System.from_text(HELICAL_PLANETS.format(copies=copies, first=order[0], second=order[1]))
    acceleration, force, thrust = (answer.value for answer in system.solve().answers)
    J_p = 5e-4 * (20 / 15) ** 2
    assert acceleration == pytest.approx(3.0 / (2e-3 + n * J_p))
    assert force == pytest.approx(J_p * acceleration / 0.04)
    assert abs(thrust) == pytest.approx(n * force * math.tan(math.radians(20)))


def test_a_planet_that_is_not_round_has_no_copies_in_space() -> None:
    text = HELICAL_PLANETS.format(copies="copies: 3", first="carrier.spider", second="planet")
    text = text.replace("inertia: J_p}", "inertia: [J_p, J_p, 2*J_p]}")
    with pytest.raises(fb.ModelError, match="copies are of round wheels; planet"):
        fb.System.from_text(text)


def test_planets_in_space_that_would_run_into_each_other_are_refused() -> None:
    text = HELICAL_PLANETS.format(copies="copies: 12", first="carrier.spider", second="planet")
    text = text.replace("{body: {mass: 0.2 kg, inertia: J_p}", "{disk: {mass: 0.2 kg, radius: 30 mm, axis: x}")
    with pytest.raises(fb.ModelError, match="at most 7 do"):
        fb.System.from_text(text)


DIFFERENTIAL = """
space: true
parameters: {{J: 0.02 kg m^2, T: 8 N m, U: 5 N m}}
bodies:
  carrier: {{body: {{inertia: 0.1 kg m^2}}}}
  left: {{body: {{inertia: J}}}}
  right: {{body: {{inertia: J}}}}
  planet: {{disk: {{mass: 1 kg, radius: 40 mm, axis: y}}, {copies}}}
{more_bodies}
connections:
  base: {{revolute: {{first: ground.O, second: carrier, about: x}}}}
  p: {{revolute: {{first: ground.O, second: left, about: x}}}}
  q: {{revolute: {{first: ground.O, second: right, about: x}}}}
  pin: {{revolute: {{first: carrier, second: planet, about: y}}}}
  one: {{gear_pair: {{first: left, second: planet, on: carrier, first_axis: x, second_axis: y, ratio: 1}}}}
  two: {{gear_pair: {{first: right, second: planet, on: carrier, first_axis: x, second_axis: y, ratio: -1}}}}
{more}
measures: {{phi: angle of carrier about x, psi: angle of left about x}}
loads:
  drive: {{torque: {{on: carrier, about: x, magnitude: T}}}}
  load: {{torque: {{on: left, about: x, magnitude: U}}}}
start: {{phi: 0, psi: 0, rate(phi): 2 rad/s, rate(psi): 5 rad/s}}
questions: [acceleration of phi, acceleration of psi]
"""


def test_two_planets_of_a_differential_move_it_as_two_that_are_written_out() -> None:
    opposite = """
  pin_2: {revolute: {first: carrier, second: planet_2, about: -y, second_axis: y}}
  one_2: {gear_pair: {first: left, second: planet_2, on: carrier, first_axis: x, second_axis: -y, ratio: 1}}
  two_2: {gear_pair: {first: right, second: planet_2, on: carrier, first_axis: x, second_axis: -y, ratio: -1}}
"""
    second = "  planet_2: {disk: {mass: 1 kg, radius: 40 mm, axis: y}}"
    written = fb.System.from_text(DIFFERENTIAL.format(copies="fixed: false", more_bodies=second, more=opposite))
    copied = fb.System.from_text(DIFFERENTIAL.format(copies="copies: 2", more_bodies="", more=""))
    values = [[answer.value for answer in system.solve().answers] for system in (written, copied)]
    assert values[0] == pytest.approx(values[1])
    assert str(copied.mobility().degrees_of_freedom) == str(written.mobility().degrees_of_freedom)


@pytest.mark.parametrize("n", [2, pytest.param(3, marks=pytest.mark.slow), pytest.param(4, marks=pytest.mark.slow)])
def test_bevel_planets_share_the_load_of_a_differential(n: int) -> None:
    """The side wheels turn alike with the carrier, and by the difference D against the planets: with k = z_s/z_p,
    (J_s + n J_p k^2/2) D'' = T_R - T_L, and of the left wheel J_s x'' = -T_L - n r F."""
    text = f"""
space: true
parameters: {{J_s: 0.02 kg m^2, m: 0.4 kg, J_p: 0.2 g m^2, J_q: 0.12 g m^2, a: 60 mm, r: 50 mm, T: 50 N m,
  L: 30 N m, R: 10 N m}}
bodies:
  carrier: {{body: {{inertia: 0.1 kg m^2}}, points: {{spider: [0, a, 0]}}}}
  left: {{body: {{inertia: J_s}}}}
  right: {{body: {{inertia: J_s}}}}
  planet: {{body: {{mass: m, inertia: [J_q, J_p, J_q]}}, copies: {n}}}
connections:
  base: {{revolute: {{first: ground.O, second: carrier, about: x}}}}
  p: {{revolute: {{first: carrier, second: left, about: x}}}}
  q: {{revolute: {{first: carrier, second: right, about: -x}}}}
  spider: {{revolute: {{first: carrier.spider, second: planet, about: y}}}}
  one: {{bevel_gears: {{first: left, second: planet, on: carrier, teeth: [20, 16], radius: r}}}}
  two: {{bevel_gears: {{first: right, second: planet, on: carrier, teeth: [20, 16], radius: r}}}}
loads:
  engine: {{torque: {{on: carrier, about: x, magnitude: T}}}}
  left_wheel: {{torque: {{on: left, about: x, magnitude: -L}}}}
  right_wheel: {{torque: {{on: right, about: x, magnitude: -R}}}}
measures: {{l: angle of left about x, c: angle of carrier about x}}
start: {{l: 0, c: 0}}
questions: [acceleration of c, acceleration of l, tooth force of one]
"""
    carrier, left, force = (answer.value for answer in fb.System.from_text(text).solve().answers)
    together = (50 - 30 - 10) / (0.1 + 2 * 0.02 + n * (0.12e-3 + 0.4 * 0.06**2))
    apart = (10 - 30) / (0.02 + n * 1e-4 * (20 / 16) ** 2)
    assert carrier == pytest.approx(together)
    assert left == pytest.approx(together + apart / 2)
    assert force == pytest.approx((-30 - 0.02 * left) / (n * 0.05))


SIDES = """
space: true
parameters: {{w: 50 rad/s, wl: 45 rad/s, r: 30 mm}}
bodies:
  cage: {{body: {{inertia: 0.1 kg m^2}}, points: {{P: [0, r, 0]}}}}
  left: {{body: {{inertia: 0.02 kg m^2}}, points: {{hub: [{hub}, 0, 0]}}}}
  right: {{body: {{inertia: 0.02 kg m^2}}}}
  pinion: {{body: {{inertia: 0.02 kg m^2}}}}
connections:
  base: {{revolute: {{first: ground.O, second: cage, about: x}}}}
  p: {{revolute: {{first: cage, second: left.hub, about: x}}}}
  q: {{revolute: {{first: cage, second: right, about: {about}}}}}
  s: {{revolute: {{first: cage.P, second: pinion, about: y}}}}
  one: {{bevel_gears: {{first: left, second: pinion, on: cage, teeth: [1, 1], radius: r}}}}
  two: {{bevel_gears: {{first: right, second: pinion, on: cage, teeth: [1, 1], radius: r}}}}
  drive: {{driver: {{body: cage, speed: w}}}}
  brake: {{driver: {{{led}, speed: wl}}}}
questions: [angular velocity of right along x]
"""


@pytest.mark.parametrize(
    ("hub", "about", "told", "speed"),
    [
        ("0", "x", ["left", "right"], 45),  # both on one side
        ("0", "-x", [], 55),  # the mean of both is the speed of the cage
        ("0.03 m", "x", ["right"], 55),  # the centre lies on the other side of the apex
    ],
)
def test_the_side_of_a_bevel_gear_that_is_borne_in_the_apex_is_told(
    hub: str, about: str, told: list[str], speed: float
) -> None:
    system = fb.System.from_text(SIDES.format(hub=hub, about=about, led="measure: angle of left about x"))
    assert [str(x).split(":")[0] for x in system.assumptions] == [f"bevel gear {name}" for name in told]
    assert system.solve().answers[0].value == pytest.approx(speed)


def test_a_driver_of_what_a_moving_body_carries_says_that_it_is_relative() -> None:
    system = fb.System.from_text(SIDES.format(hub="0", about="-x", led="body: left"))
    assert [str(x)[:44] for x in system.assumptions] == ["brake: left is led relative to cage, which c"]
    assert system.solve().answers[0].value == pytest.approx(5)
