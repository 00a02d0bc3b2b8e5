"""A planet that is written once beside the same planets written one by one, and beside Willis.

With the ring gear held, sun and planets of s and p teeth turn with i = 2 (s + p)/s and -(s + p)/p times the speed of
the carrier; with the radius a = m (s + p)/2 of the carrier

    I = J_S i^2 + J_C + n (J_P ((s + p)/p)^2 + m_P a^2),    psi'' = T i/I,    n F m s/2 = T - J_S i psi''.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.language.expression import number
from posed import is_formula

HEAD = """
parameters: {mod: 0.25 cm, s: SUN, p: PLANET, J_S: 0.8 g m^2, J_C: 3 g m^2, J_P: 0.02 g m^2, m_P: 90 g, T: 150 N cm}
ground: {points: {S: [0, 0]}}
bodies:
  sun: {body: {inertia: J_S}}
  carrier: {body: {inertia: J_C}, points: {AXLES}}
  ring: {ring: {radius: mod*(s + 2*p)/2}, at: [0, 0], fixed: true}
PLANETS
connections:
  sun_bearing: {pin: [ground.S, sun]}
  carrier_bearing: {pin: [ground.S, carrier]}
MESHES
loads: {drive: {torque: {on: sun, magnitude: T}}}
measures: {psi: angle of carrier}
start: {psi: 25 deg, rate(psi): 30 rpm}
"""
INERTIA = "J_S*(2*(s + p)/s)**2 + J_C + n*(J_P*((s + p)/p)**2 + m_P*(mod*(s + p)/2)**2)"


def planetary(n: int, teeth: tuple[int, int], written: int) -> str:
    """written: how many of the n planets are written out, 1 or n."""
    axles, planets, meshes = [], [], []
    for k in range(written):
        turned = f"{2 * k}*pi/{n}"
        axles.append(f"A{k}: [mod*(s + p)/2*cos({turned}), mod*(s + p)/2*sin({turned})]")
        count = f", copies: {n}" if written == 1 else ""
        planets.append(f"  P{k}: {{body: {{mass: m_P, inertia: J_P}}{count}}}")
        meshes.append(f"""  axle{k}: {{pin: [carrier.A{k}, P{k}]}}
  inner{k}: {{gear_mesh: {{first: sun, second: P{k}, module: mod, teeth: [s, p]}}}}
  outer{k}: {{gear_mesh: {{first: ring, second: P{k}, internal: true, module: mod, teeth: [s + 2*p, p]}}}}""")
    text = HEAD.replace("SUN", str(teeth[0])).replace("PLANETS", "\n".join(planets)).replace("PLANET", str(teeth[1]))
    return text.replace("AXLES", ", ".join(axles)).replace("MESHES", "\n".join(meshes))


CASES = [(2, (24, 18)), (3, (30, 21)), (5, (20, 15))]


@pytest.mark.parametrize(("n", "teeth"), CASES)
def test_copies_of_a_planet_move_as_the_planets_written_one_by_one(n: int, teeth: tuple[int, int]) -> None:
    s, p = teeth
    i, a, v = 2 * (s + p) / s, 0.0025 * (s + p) / 2, math.pi
    inertia = 8e-4 * i**2 + 3e-3 + n * (2e-5 * ((s + p) / p) ** 2 + 0.09 * a**2)
    for written in (1, n):
        system = fb.System.from_text(planetary(n, teeth, written))
        assert system.solve("acceleration of psi")["q1"].value == pytest.approx(1.5 * i / inertia)
        assert system.solve("kinetic energy")["q1"].value == pytest.approx(inertia * v**2 / 2)


@pytest.mark.parametrize(("n", "teeth"), CASES)
def test_each_of_equal_planets_carries_its_share(n: int, teeth: tuple[int, int]) -> None:
    text = planetary(n, teeth, 1)
    inertia = INERTIA.replace("n*(", f"{n}*(")
    is_formula(text, "tooth force of inner0", f"2*(T - J_S*T*(2*(s + p)/s)**2/({inertia}))/({n}*mod*s)", factors=(1.0,))
    told = f"the {n} copies of P0 stand at equal angles and share the load equally"
    assert any(str(note).startswith(told) for note in fb.System.from_text(text).assumptions)


@pytest.mark.parametrize(("n", "teeth"), CASES)
def test_bearings_between_equal_planets_carry_nothing(n: int, teeth: tuple[int, int]) -> None:
    system = fb.System.from_text(planetary(n, teeth, 1))
    for bearing in ("carrier_bearing", "sun_bearing"):
        assert system.solve(f"reaction of {bearing}")["q1"].expression == (number(0), number(0))


BEVELS = Path(__file__).parents[1] / "examples/bevel_differential_with_four_planets.yaml"


def bevels(written: int) -> str:
    """The bevel differential with one planet that counts four times, or four of them: axes of two lie along z."""
    text = BEVELS.read_text("utf-8").partition("questions:")[0]
    if written == 1:
        return text
    text = text.replace("spider: [0, a, 0]", "s0: [0, a, 0], s1: [0, 0, a], s2: [0, -a, 0], s3: [0, 0, -a]")
    planet = "  planet: {body: {mass: m, inertia: [J_q, J_p, J_q]}, copies: 4}\n"
    assert planet in text
    inertias = ["[J_q, J_p, J_q]", "[J_q, J_q, J_p]"] * 2
    text = text.replace(planet, "".join(f"  p{k}: {{body: {{mass: m, inertia: {inertias[k]}}}}}\n" for k in range(4)))
    before, _, rest = text.partition("  spider:")
    pairs = "".join(
        f"""  spider{k}: {{revolute: {{first: carrier.s{k}, second: p{k}, about: {("y", "z", "-y", "-z")[k]}}}}}
  left{k}: {{bevel_gears: {{first: left, second: p{k}, on: carrier, teeth: [z_s, z_p], radius: r}}}}
  right{k}: {{bevel_gears: {{first: right, second: p{k}, on: carrier, teeth: [z_s, z_p], radius: r}}}}
"""
        for k in range(4)
    )
    return before + pairs + "loads:" + rest.partition("loads:")[2]


def test_copies_of_a_bevel_gear_move_as_the_gears_written_one_by_one() -> None:
    """T = I_C w^2/2 + J_s (w_l^2 + (2 w - w_l)^2)/2 + n J_p ((w_l - w) z_s/z_p)^2/2, I_C = J_c + n (m a^2 + J_q); the
    engine drives w against the wheels, T_left w_l + T_right (2 w - w_l)."""
    wheel, spin = 0.02, 4 * 0.2e-3 * (20 / 16) ** 2
    carrier = 0.1 + 4 * (0.4 * 0.06**2 + 0.12e-3)
    inertia = [[carrier + 4 * wheel + spin, -2 * wheel - spin], [-2 * wheel - spin, 2 * wheel + spin]]
    phi, psi = np.linalg.solve(inertia, [50 - 2 * 10, -30 + 10])
    for written in (1, 4):
        found = fb.System.from_text(bevels(written)).solve(["acceleration of phi", "acceleration of psi"])
        assert [found[q].value for q in ("q1", "q2")] == pytest.approx([phi, psi], rel=1e-10)
    # the left wheel is turned by four teeth at r
    tooth = fb.System.from_text(bevels(1)).solve("tooth force of left_mesh")["q1"].value
    assert abs(tooth) == pytest.approx((wheel * psi + 30) / (4 * 0.05), rel=1e-10)
