"""Tooth forces with a pressure angle, and equal planets of which one is written."""

from __future__ import annotations

import math

import pytest

import freebody as fb

PAIR = """
parameters: {{m: 2 mm, z1: 20, z2: 60, alpha: 20 deg, T1: 20 N m, T2: 60 N m}}
ground: {{points: {{A: [0, 0], B: [m*(z1 + z2)/2, 0]}}}}
bodies:
  pinion: {{body: {{inertia: 0.01 kg m^2}}}}
  wheel: {{body: {{inertia: 0.2 kg m^2}}}}
connections:
  A: {{pin: [ground.A, pinion]}}
  B: {{pin: [ground.B, wheel]}}
  mesh: {{gear_mesh: {{first: pinion, second: wheel, module: m, teeth: [z1, z2], pressure_angle: alpha{more}}}}}
loads:
  drive: {{torque: {{on: pinion, magnitude: {sign}T1}}}}
  load: {{torque: {{on: wheel, magnitude: {sign}T2}}}}
"""
TANGENTIAL = 20.0 / 0.02  # T1/r1, both torques in balance: T1/r1 = T2/r2


def test_the_bearings_carry_the_radial_force_as_well() -> None:
    # Shigley, sec. 13-14: W_t = T/r, W_r = W_t tan(alpha), W = W_t/cos(alpha); the wheel is pushed away and up
    system = fb.System.from_text(PAIR.format(more="", sign=""))
    radial = TANGENTIAL * math.tan(math.radians(20))
    assert system.solve("tangential tooth force of mesh").answers[0].value == pytest.approx(TANGENTIAL)
    assert system.solve("radial tooth force of mesh").answers[0].value == pytest.approx(radial)
    assert system.solve("size of reaction of B").answers[0].value == pytest.approx(
        TANGENTIAL / math.cos(math.radians(20))
    )
    assert system.solve("reaction of B on wheel").answers[0].value == pytest.approx((-radial, -TANGENTIAL))
    assert system.solve("reaction of A on pinion").answers[0].value == pytest.approx((radial, TANGENTIAL))


def test_the_other_flank_parts_the_gears_too() -> None:
    system = fb.System.from_text(PAIR.format(more=", other_flank: true", sign="-"))
    radial = TANGENTIAL * math.tan(math.radians(20))
    assert system.solve("tooth force of mesh").answers[0].value == pytest.approx(-TANGENTIAL)
    assert system.solve("radial tooth force of mesh").answers[0].value == pytest.approx(radial)
    assert system.solve("reaction of B on wheel").answers[0].value == pytest.approx((-radial, TANGENTIAL))


def test_a_reaction_is_not_given_for_a_flank_that_does_not_bear() -> None:
    system = fb.System.from_text(PAIR.format(more="", sign="-"))
    answer = system.solve("reaction of B on wheel").answers[0]
    assert answer.value is None
    assert "other_flank" in system.solve("reaction of B on wheel").to_text()
    assert system.solve("angular acceleration of wheel").answers[0].value == pytest.approx(0.0, abs=1e-9)
    assert "bears on its other flank" in system.simulate(0.01).to_text()


@pytest.mark.parametrize(("angle", "told"), [("50 deg", "between 0 and 45 deg"), ("-20 deg", "as a rule 20 deg")])
def test_a_pressure_angle_that_no_gear_has_is_refused(angle: str, told: str) -> None:
    with pytest.raises(fb.ModelError, match=told):
        fb.System.from_text(PAIR.format(more="", sign="").replace("pressure_angle: alpha", f"pressure_angle: {angle}"))


RING = """
parameters: {{T: 9 N m}}
ground: {{points: {{O: [0, 0], P: [60 mm, 0]}}}}
bodies: {{ring: {{body: {{inertia: 1 kg m^2}}}}, planet: {{body: {{inertia: 1 g m^2}}}}}}
connections:
  O: {{pin: [ground.O, ring]}}
  P: {{pin: [ground.P, planet]}}
  mesh: {{gear_mesh: {{first: ring, second: planet, internal: true, first_radius: 90 mm, second_radius: 30 mm,
    pressure_angle: 20 deg}}}}
loads: {{drive: {{torque: {{on: ring, magnitude: T}}}}, brake: {{torque: {{on: planet, magnitude: -T/3}}}}}}
"""


def test_a_ring_gear_pushes_its_planet_towards_the_middle() -> None:
    # F_t = T/R on the ring at its right side acts down, on the planet up, and F_t tan(alpha) on it to the left
    system = fb.System.from_text(RING.format())
    force = 9.0 / 0.09
    radial = force * math.tan(math.radians(20))
    assert system.solve("reaction of P on planet").answers[0].value == pytest.approx((radial, -force))
    assert system.solve("reaction of O on ring").answers[0].value == pytest.approx((-radial, force))


@pytest.mark.parametrize(("above", "sign"), [("", 1.0), (", above: true", -1.0)])
def test_a_rack_is_pushed_away_from_its_pinion(above: str, sign: float) -> None:
    # the pinion drives with F = T/r; the guide of the rack carries F tan(alpha)
    text = f"""
parameters: {{T: 4 N m, k: 800 N/m}}
bodies:
  pinion: {{body: {{inertia: 0.02 kg m^2, radius: 0.05 m}}}}
  rack: {{rectangle: {{mass: 5 kg, width: 1 m, height: 5 cm}}}}
connections:
  axle: {{pin: [ground.O, pinion]}}
  guide: {{slider: {{body: rack, along: right}}}}
  teeth: {{rack_and_pinion: {{pinion: pinion, rack: rack, pressure_angle: 20 deg{above}}}}}
loads:
  drive: {{torque: {{on: pinion, magnitude: {"" if sign > 0 else "-"}T}}}}
  hold: {{force: {{at: rack, along: left, magnitude: T/(0.05 m)}}}}
"""
    system = fb.System.from_text(text)
    radial = 80.0 * math.tan(math.radians(20))
    assert system.solve("tooth force of teeth").answers[0].value == pytest.approx(80.0)
    assert system.solve("reaction of guide on rack along up").answers[0].value == pytest.approx(sign * radial)


# -- equal planets ----------------------------------------------------------------------------
PLANETS = """
parameters: {{m: 2 mm, z_S: {z_S}, z_P: {z_P}, J: 1 g m^2, J_P: 0.02 g m^2, m_P: 0.1 kg, T: 2 N m{more}}}
ground: {{points: {{S: [0, 0]}}}}
bodies:
  sun: {{body: {{inertia: J}}}}
  planet: {{body: {{mass: m_P, inertia: J_P}}, copies: {n}}}
  carrier: {{body: {{inertia: J}}, points: {{axle: [m*(z_S + z_P)/2, 0]}}}}
  ring: {{ring: {{radius: m*(z_S + 2*z_P)/2}}, at: [0, 0], fixed: true}}
connections:
  sun_bearing: {{pin: [ground.S, sun]}}
  carrier_bearing: {{pin: [ground.S, carrier]}}
  planet_axle: {{pin: [carrier.axle, planet]}}
  inner: {{gear_mesh: {{first: sun, second: planet, module: m, teeth: [z_S, z_P]}}}}
  outer: {{gear_mesh: {{first: ring, second: planet, internal: true, module: m, teeth: [z_S + 2*z_P, z_P]}}}}
loads: {{drive: {{torque: {{on: sun, magnitude: T}}}}{loads}}}
measures: {{psi: angle of carrier}}
"""


@pytest.mark.parametrize("n", [2, 3, 4])
def test_all_planets_count_and_each_carries_its_share(n: int) -> None:
    """T w_S = d/dt of the energy: with w_S = 2 a/r_S w, w_P = -(r_S/r_P + 1) w + ..., all by hand."""
    system = fb.System.from_text(PLANETS.format(z_S=24, z_P=12, n=n, more="", loads=""))
    r_S, r_P, a = 0.024, 0.012, 0.036
    sun, planet = 2 * a / r_S, 1 - (r_S + 2 * r_P) / r_P  # turns for one of the carrier
    inertia = 1e-3 * sun**2 + 1e-3 + n * (0.1 * a**2 + 2e-5 * planet**2)
    acceleration = 2.0 * sun / inertia
    assert system.solve("acceleration of psi").answers[0].value == pytest.approx(acceleration)
    force = (2.0 - 1e-3 * sun * acceleration) / (n * r_S)
    assert system.solve("tooth force of inner").answers[0].value == pytest.approx(force)
    # the forces of the planets on the sun balance, as do their centrifugal forces on the carrier
    assert system.solve("reaction of sun_bearing").answers[0].value == pytest.approx((0.0, 0.0), abs=1e-9)
    assert system.solve("reaction of carrier_bearing").answers[0].value == pytest.approx((0.0, 0.0), abs=1e-9)
    assert sum(body.name.startswith("planet") for body in system.moving) == n
    assert system.mobility().degrees_of_freedom == 1


def test_the_weight_of_all_planets_is_carried() -> None:
    text = PLANETS.format(z_S=24, z_P=12, n=3, more=", g: 9.81 m/s^2", loads=", weight: {gravity: g}")
    system = fb.System.from_text(text)
    assert system.solve("reaction of carrier_bearing").answers[0].value == pytest.approx((0.0, 3 * 0.981), abs=1e-9)


def test_a_torque_on_the_written_planet_is_one_on_each() -> None:
    """A torque M on each of n planets does n M w_P."""
    text = PLANETS.format(z_S=24, z_P=12, n=3, more=", M: 0.1 N m", loads=", m: {torque: {on: planet, magnitude: M}}")
    a, r_S, r_P = 0.036, 0.024, 0.012
    sun, planet = 2 * a / r_S, 1 - (r_S + 2 * r_P) / r_P
    inertia = 1e-3 * sun**2 + 1e-3 + 3 * (0.1 * a**2 + 2e-5 * planet**2)
    found = fb.System.from_text(text).solve("acceleration of psi").answers[0].value
    assert found == pytest.approx((2.0 * sun + 3 * 0.1 * planet) / inertia)


@pytest.mark.parametrize(
    ("n", "z_S", "z_P", "told"),
    [
        (5, 24, 18, "84 would have to be divisible by 5; possible numbers: 2, 3, 4, 6, 7"),
        (12, 24, 18, "at most 7 do"),
        (1, 24, 18, "a whole number, at least 2"),
    ],
)
def test_planets_that_cannot_be_assembled_are_refused(n: int, z_S: int, z_P: int, told: str) -> None:
    text = PLANETS.format(z_S=z_S, z_P=z_P, n=n, more="", loads="").replace(
        "inertia: J_P}", "inertia: J_P, radius: m*z_P/2}"
    )
    assert len(fb.System.from_text(text.replace(f"copies: {n}", "copies: 7")).moving) == 9
    with pytest.raises(fb.ModelError, match=told):
        fb.System.from_text(text)


def test_copies_are_for_what_a_pin_carries() -> None:
    text = """
bodies: {block: {rectangle: {mass: 1 kg, width: 1 m, height: 1 m}, copies: 3}}
connections: {rail: {slider: {body: block, along: right}}}
"""
    with pytest.raises(fb.ModelError, match="rail does neither"):
        fb.System.from_text(text)
