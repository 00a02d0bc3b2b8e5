"""Parts that a file tells in short: what can be read safely is, and anything else is refused with what to write."""

from __future__ import annotations

import pytest

import freebody as fb


def answer(text: str, question: str) -> float:
    value = fb.System.from_text(text).solve(question)["q1"].value
    return float(value[0] if isinstance(value, list | tuple) else value)


@pytest.mark.parametrize(
    "parts",
    [
        "sun: {teeth: 24}, planet: {n: 3}, ring: {teeth: 72}",
        "sun: {teeth: 24}, planet: {teeth: 24, n: 3}, ring: {teeth: 72}",
        "sun: 24, planets: 3, ring: 72",
        "sun_teeth: 24, planets: 3, ring_teeth: 72",
        "N_sun: 24, N_planet: 24, N_planets: 3, N_ring: 72",
    ],
)
def test_how_many_planets_there_are_is_no_number_of_teeth(parts: str) -> None:
    # Willis with the ring at rest: omega_C = omega_S z_S/(z_S + z_R), omega_P = omega_C (1 - z_R/z_P)
    text = f"planetary: {{{parts}, fixed: ring, input: {{sun: 1 rad/s}}}}\n"
    assert answer(text, "angular velocity of planet") == pytest.approx(0.25 * (1 - 72 / 24))
    assert any("3 copies of planet" in str(each) for each in fb.System.from_text(text).assumptions)


@pytest.mark.parametrize(
    ("parts", "told"),
    [
        ("n_sun: 1000 rpm, z_sun: 24, z_ring: 72", "stands under input: {sun: 1000 rpm}"),
        ("z_sun: 24, n_sun: 1000 rpm, z_ring: 72", "stands under input: {sun: 1000 rpm}"),
        ("n_sun: 1000, z_sun: 24, z_ring: 72", "said twice"),
        ("sun: 1000 rpm, ring: 72", "is no number of teeth"),
        ("sun: {teeth: 24, z: 25}, ring: 72", "said twice"),
        ("sun: {N: 24}, ring: 72", "write teeth"),
        ("sun: 24, planet: 20, ring: 72", "72 is not 24 \\+ 2\\*20"),
        ("sun: {teeth: 24, module: 2 mm}, ring: {teeth: 72, module: 3 mm}", "one module"),
        ("sun: 24, ring: 72, output: carrier", "has no output"),
        ("sun: 24, ring: 72, input: sun", "input: {sun: 1000 rpm}"),
        ("sun: 24, ring: 72, carrier: 5", "no teeth"),
        ("sun: 24", "needs the teeth"),
        ("sun: 24, ring: {teeth: 72, fixed: no way}", "true or false"),
    ],
)
def test_what_a_planetary_gear_says_besides_is_not_dropped(parts: str, told: str) -> None:
    with pytest.raises(fb.ModelError, match=told):
        fb.System.from_text(f"planetary: {{{parts}}}\n")


def test_what_is_held_is_a_part() -> None:
    with pytest.raises(fb.ModelError, match="input of the planetary gear is said twice"):
        fb.System.from_text("planetary: {sun: 24, ring: 72, input: {sun: 1 rad/s}}\ndrive: {ring: 0}\n")
    with pytest.raises(fb.ModelError, match="rng is none of them"):
        fb.System.from_text("planetary: {sun: 24, ring: 72, fixed: rng}\n")
    text = "planetary: {sun: 24, ring_gear: 72, fixed: ring, input: {sun: 4 rad/s}}\n"
    assert answer(text, "angular velocity of carrier") == pytest.approx(1)


@pytest.mark.parametrize(
    ("wheels", "mesh", "told"),
    [
        ("a: {teeth: 15, module: 4 mm}, b: {teeth: 45, angle: 30 deg}", "[a, b]", "b.angle"),
        ("a: {teeth: 15, omega: 10 rad/s}, b: {teeth: 45}", "[a, b]", "a.omega"),
        ("a: {teeth: 15, radius: 200 mm}, b: {teeth: 45}", "[a, b]", "a.radius"),
        ("a: {teeth: 15, module: 4 mm}, b: {teeth: 45, module: 5 mm}", "[a, b]", "one module"),
        ("a: {teeth: 15}, b: {teeth: 45}", "{between: [a, b], pressure_angle: 20 deg}", "mesh stands under"),
        ("a: {teeth: 15}, b: {teeth: 45}", "[a, c]", "mesh stands under"),
    ],
)
def test_what_bevel_gears_by_their_teeth_do_not_read_is_refused(wheels: str, mesh: str, told: str) -> None:
    with pytest.raises(fb.ModelError, match=told):
        fb.System.from_text(f"bevel_gears: {{{wheels}}}\nmesh: {mesh}\n")


COLLISION = """
parameters: {v: SPEED}
bodies: {A: {mass: 2 kg, velocity: v}, B: {mass: 1 kg, velocity: 2*v}}
collision: {between: [A, B], e: 0.5}
"""


def test_who_catches_up_is_calculated_from_the_parameters() -> None:
    # B behind with 4 m/s, A with 2 m/s: the mean is 8/3, and A leaves faster by e 2 m/s m_B/(m_A + m_B)
    system = fb.System.from_text(COLLISION.replace("SPEED", "2 m/s"))
    assert "B is on the left of A, by gap_B_A = 1 m" in map(str, system.assumptions)
    assert system.solve("velocity of A after the impact")["q1"].value[0] == pytest.approx(8 / 3 + 0.5 * 2 / 3)
    system = fb.System.from_text(COLLISION.replace("SPEED", "-2 m/s"))
    assert "A is on the left of B, by gap_A_B = 1 m" in map(str, system.assumptions)


def test_who_catches_up_is_left_open_where_a_speed_has_no_number() -> None:
    system = fb.System.from_text(COLLISION.replace("SPEED", "m/s"))
    assert not any("on the left" in str(each) for each in system.assumptions)


LENGTHS = {"ground": "10 cm", "crank": "3 cm", "coupler": "9 cm", "rocker": "7 cm"}


def test_links_go_by_their_names_in_any_order() -> None:
    found = []
    for section, order in (
        ("four_bar", ("ground", "crank", "coupler", "rocker")),
        ("links", ("crank", "rocker", "coupler", "ground")),
    ):
        links = ", ".join(f"{name}: {LENGTHS[name]}" for name in order)
        text = f"{section}: {{{links}}}\nstart: {{crank: 60 deg, rate(angle of crank): 10 rad/s}}\n"
        found.append(answer(text, "angular velocity of rocker"))
    assert found[0] == pytest.approx(found[1])
    with pytest.raises(fb.ModelError, match="which link is which"):
        fb.System.from_text("links: {crank: 3 cm, rocker: 7 cm, link3: 9 cm, ground: 10 cm}\n")


def test_letters_of_a_four_bar_are_told() -> None:
    system = fb.System.from_text("four_bar: {l1: 10 cm, l2: 3 cm, l3: 9 cm, l4: 7 cm}\nstart: {crank: 60 deg}\n")
    assert "l2 is the crank, l3 the coupler, l4 the rocker and l1 the ground" in map(str, system.assumptions)


@pytest.mark.parametrize("axle", ["[ground.O, arm.start]", "[sun, arm.start]", "[[0, 0], arm.start]"])
def test_an_arm_on_the_axle_of_a_sun_may_carry_the_planet(axle: str) -> None:
    text = """
ground: {points: {O: [0, 0]}}
bodies:
  sun: {gear: {teeth: 24, module: 2 mm}}
  planet: {gear: {teeth: 24, module: 2 mm}, at: [48 mm, 0]}
  arm: {rod: {length: 48 mm}}
connections: {mesh: {gear_mesh: [sun, planet]}, shaft: {pin: [ground.O, sun]}, axle: {pin: AXLE}}
""".replace("AXLE", axle)
    told = "nothing holds planet: it turns in a bearing that stands still"
    assert told not in map(str, fb.System.from_text(text).assumptions)
    alone = text.replace(f", axle: {{pin: {axle}}}", "").replace("  arm: {rod: {length: 48 mm}}\n", "")
    assert told in map(str, fb.System.from_text(alone).assumptions)


@pytest.mark.parametrize(
    "text",
    [
        "bodies: {ball: particle at 0, b: {mass: 1 kg}}\nconnections: {c: {contact: [ball, wall]}}\n",
        "bodies: {A: 5, B: 3}\ncollision: {between: [A, B], e: 0.5}\n",
        "space: true\nbodies: {a: disk, b: disk}\nconnections: {m: {bevel_gears: [a, b]}}\n",
        "space: true\nbodies: {a: {rod: {mass: 1 kg, length: 1 m}, at: {}}}\n",
    ],
)
def test_values_of_another_form_are_told(text: str) -> None:
    with pytest.raises(fb.ModelError):
        fb.System.from_text(text)


@pytest.mark.parametrize("said", ["model: 3D", "system: planar", "model: 2-D", "problem: in space"])
def test_a_dimension_is_no_title(said: str) -> None:
    with pytest.raises(fb.ModelError, match="space: true says"):
        fb.System.from_text(f"{said}\nmass: 2 kg\nstiffness: 50 N/m\n")
    assert fb.System.from_text("problem: a plane\nmass: 2 kg\nstiffness: 50 N/m\n").title == "a plane"


def test_an_exponent_of_a_number_is_no_rate() -> None:
    system = fb.System.from_text("mass: 2 kg\nstiffness: 50 N/m\nforce: 10 N*sin(2e-3*t)\n")
    assert system.parameters["Omega"].value == pytest.approx(0.002)
