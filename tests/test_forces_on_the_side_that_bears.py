"""Forces of a motion in which a chain, or teeth, are pressed on one side and then on the other."""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb

CHAIN = """
parameters: {z_1: 44, z_2: 16, p: 12.7 mm, d: 420 mm, I_1: 0.05 kg m^2, I_2: 0.15 kg m^2, M: 30 N m, w: 10 1/s}
ground: {points: {A: [0, 0], B: [d, 0]}}
bodies: {crank: {body: {inertia: I_1}}, hub: {body: {inertia: I_2}}}
connections:
  A: {pin: [ground.A, crank]}
  B: {pin: [ground.B, hub]}
  chain: {chain: {first: crank, second: hub, pitch: p, teeth: [z_1, z_2]MORE}}
loads: {pedal: {torque: {on: crank, magnitude: M*cos(w*t)}}}
"""
GEARS = """
parameters: {m: 2 mm, z1: 20, z2: 60, I_1: 0.01 kg m^2, I_2: 0.2 kg m^2, M: 30 N m, w: 10 1/s}
ground: {points: {A: [0, 0], B: [m*(z1 + z2)/2, 0]}}
bodies: {pinion: {body: {inertia: I_1}}, wheel: {body: {inertia: I_2}}}
connections:
  A: {pin: [ground.A, pinion]}
  B: {pin: [ground.B, wheel]}
  mesh: {gear_mesh: {first: pinion, second: wheel, module: m, teeth: [z1, z2], pressure_angle: 20 degMORE}}
loads: {drive: {torque: {on: pinion, magnitude: M*cos(w*t)}}}
"""
HELICAL = """
space: true
parameters: {J: 0.1 kg m^2, M: 30 N m, w: 10 1/s}
ground: {points: {A: [0, 0, 0], B: [0.3 m, 0, 0]}}
bodies: {a: {body: {mass: 1 kg, inertia: [J, J, J]}}, b: {body: {mass: 1 kg, inertia: [J, J, J]}, at: [0.3 m, 0, 0]}}
connections:
  A: {revolute: {first: ground.A, second: a, about: z}}
  B: {revolute: {first: ground.B, second: b, about: z}}
  mesh: {helical_gears: {first: a, second: b, teeth: [20, 40], radius: 0.1 m, helix_angle: 15 deg,
    pressure_angle: 20 degMORE}}
loads: {drive: {torque: {on: a, about: z, magnitude: M*cos(w*t)}}}
"""
OTHER = {"CHAIN": (CHAIN, ", other_run: true"), "GEARS": (GEARS, ", other_flank: true")}
OTHER["HELICAL"] = HELICAL, ", other_flank: true"


def forces(text: str) -> dict[str, np.ndarray]:
    """All series of a motion to t = 0.6 s, in which the torque changes its sense at pi/20 s and 3 pi/20 s."""
    data = fb.System.from_text(text).simulate(0.6, every=0.01).dataset
    return {
        str(name): data[name].values for name in data.data_vars if name.split(".")[0] in ("A", "B", "mesh", "chain")
    }


def test_bearings_of_a_chain_are_pulled_together_by_whichever_run_is_tight() -> None:
    found = forces(CHAIN.replace("MORE", ""))
    r1, r2 = (0.0127 * z / (2 * math.pi) for z in (44, 16))
    t = 0.01 * np.arange(61)
    # I_1 a_1 = M cos(wt) - F r1, I_2 a_1 r1/r2 = F r2; the tight run leans by sin(gamma) = (r1 - r2)/d
    force = 30.0 * np.cos(10.0 * t) * 0.15 * r1 / r2**2 / (0.05 + 0.15 * (r1 / r2) ** 2)
    lean = math.asin((r1 - r2) / 0.42)
    assert found["chain.chain_force"] == pytest.approx(force, abs=1e-6)
    assert np.abs(found["A.x"]) == pytest.approx(np.abs(force) * math.cos(lean), abs=1e-6)
    assert np.all(found["A.x"] * found["A.x"][0] >= 0.0)
    assert np.abs(found["A.y"]) == pytest.approx(np.abs(force) * math.sin(lean), abs=1e-6)
    assert found["A.y"][0] * found["A.y"][30] < 0.0


@pytest.mark.parametrize("kind", OTHER)
def test_a_model_of_either_side_has_the_same_forces_throughout(kind: str) -> None:
    text, other = OTHER[kind]
    one, two = (forces(text.replace("MORE", more)) for more in ("", other))
    largest = max(float(np.abs(series).max()) for series in one.values())
    for name, series in one.items():
        assert series == pytest.approx(two[name], abs=1e-9 * largest), name


def test_it_is_said_when_the_other_side_bears() -> None:
    told = fb.System.from_text(CHAIN.replace("MORE", "")).simulate(0.6, every=0.01).to_text()
    assert "from 0.16 s the other run of chain is tight" in " ".join(told.split())
    assert "wrong sign" not in told


def test_friction_that_depends_on_the_side_leaves_the_stated_one_and_says_so() -> None:
    rough = "A: {pin: {first: ground.A, second: crank, radius: 20 mm, friction: 0.1}}"
    text = CHAIN.replace("MORE", "").replace("A: {pin: [ground.A, crank]}", rough)
    told = " ".join(fb.System.from_text(text).simulate(0.3, every=0.01).to_text().split())
    assert "there its pull at the bearings has the wrong sign" in told
