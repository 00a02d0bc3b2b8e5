"""Motions in time: published values, identities, events, and how a motion can end."""

from __future__ import annotations

import itertools
import json
import math
import re
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import freebody as fb
from command import freebody
from freebody.numeric.engine import integrators as folder_of_integrators
from freebody.numeric.engine.course import Status
from freebody.numeric.engine.integrators import integrator, integrators
from freebody.numeric.spatial import gyroscopic
from freebody.testing.conformance import order_of
from mechanisms import ladder

ROOT = Path(__file__).parents[1]
EXAMPLES = sorted(path.stem for path in (ROOT / "examples").glob("*.yaml"))
G = 9.81


def example(name: str) -> fb.System:
    return fb.System.load(ROOT / "examples" / f"{name}.yaml")


def model(text: str) -> fb.System:
    return fb.System.from_text(text)


A01 = model("""
bodies: {ball: {particle: {mass: 1 kg}, at: [1 m, 0]}}
connections: {string: {link: [ground.O, ball]}}
loads: {g: {gravity: 9.81}}
measures: {x: x of ball, y: y of ball}
""")

OSCILLATOR = """
parameters: {m: 2 kg, k: 50 N/m, c: {value: 0 N s/m, sign: any}}
bodies: {block: {particle: {mass: m}, at: [0.3 m, 0]}}
connections: {guide: {slider: {body: block, along: right}}}
loads: {s: {law: {measure: x, force: -k*x - c*rate(x)}}}
measures: {x: x of block}
"""


# -- published values -------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("until", "tolerance", "place"),
    [(10.0, 1e-10, (0.275087462576, -0.961419205099)), (2000.0, 1e-12, (-0.814603068589, -0.580018827837))],
)
def test_the_pendulum_of_iftomm_a01_is_where_elliptic_functions_say(
    until: float, tolerance: float, place: tuple[float, float]
) -> None:
    result = A01.simulate(until, tolerance=tolerance, every=until)
    assert result.status is Status.FINISHED
    assert result.course.poses[-1, 0, :2] == pytest.approx(place, abs=1e-6)


def test_the_period_of_the_pendulum_is_found_by_its_events() -> None:
    result = A01.simulate(10.0, tolerance=1e-12, events=["x = 0"])
    times = [e.time for e in result.events if e.kind == "rising"]
    assert np.diff(times) == pytest.approx(2.36784194757624, rel=1e-11)


@pytest.mark.parametrize(
    ("n", "until", "place", "velocity"),
    [
        (2, 10.0, (0.328458111541, 0.944518538179), (1.423051470207, -0.494868845487)),
        (40, 20.0, (0.410901153763, 0.911679900972), (1.566785371909, -0.706162235594)),
    ],
)
def test_the_n_four_bar_of_iftomm_a02_passes_its_singular_poses_on_the_right_branch(
    n: int, until: float, place: tuple[float, float], velocity: tuple[float, float]
) -> None:
    result = ladder(n).simulate(until, tolerance=1e-10, every=until)
    assert result.status is Status.FINISHED, result.message
    angle, spin = result.course.poses[-1, 0, 2], result.course.velocities[-1, 0, 2]
    assert (math.cos(angle), math.sin(angle)) == pytest.approx(place, abs=1e-6)
    assert (-math.sin(angle) * spin, math.cos(angle) * spin) == pytest.approx(velocity, abs=1e-6)


# -- options ----------------------------------------------------------------------------------
def test_options_are_one_value_or_names() -> None:
    options = fb.SimulationOptions(tolerance=1e-6, max_step=0.01)
    one, other = A01.simulate(0.1, options=options), A01.simulate(0.1, tolerance=1e-6, max_step=0.01)
    assert one.options == other.options == options
    assert (one.course.poses == other.course.poses).all()
    assert A01.simulate(0.1, options=options, tolerance=1e-3).options == replace(options, tolerance=1e-3)


def test_options_without_sense_are_refused_wherever_they_are_made() -> None:
    for given in ({"tolerance": 1.0}, {"method": "euler"}, {"step": 0.1}, {"max_steps": 0}, {"impact": "hertz"}):
        with pytest.raises(fb.InputError):
            fb.SimulationOptions(**given)
        with pytest.raises(fb.InputError):
            A01.simulate(1.0, **given)


def test_the_run_that_verifies_follows_the_same_laws_more_finely() -> None:
    options = fb.SimulationOptions(impact="poisson", jams=True, max_step=0.1, max_steps=5, verify=True)
    finer = options.finer
    assert (finer.impact, finer.jams, finer.max_step) == ("poisson", True, 0.1)
    assert finer.tolerance == pytest.approx(options.tolerance / 100)
    assert finer.max_steps > 5
    assert fb.SimulationOptions(method="rk4", step=0.1).finer.step == pytest.approx(0.1 / 100**0.25)


# -- accuracy ---------------------------------------------------------------------------------
@pytest.mark.parametrize("method", integrators())
def test_a_method_converges_with_its_order(method: str) -> None:
    chosen = integrator(method)
    if chosen.steps is not None:  # its equations are solved as exactly as the tolerance says, so that is what varies
        found = order_of(method, A01, (1e-5, 1e-9), by_tolerance=True)
    else:
        h = {8: 0.125, 5: 0.05}.get(chosen.order, 0.02)
        found = order_of(method, A01, (h, h / 2))
    assert found > chosen.order - 0.6


BOGACKI_SHAMPINE = '''"""Order 3 with an embedded formula of order 2. Source: Bogacki & Shampine 1989."""

from freebody.numeric.engine.integrators.base import Integrator
from freebody.numeric.engine.tableaus import tableau

INTEGRATOR = Integrator(
    tableau(
        3,
        [{0: 1 / 2}, {1: 3 / 4}],
        {0: 2 / 9, 1: 1 / 3, 2: 4 / 9},
        error=[{0: -5 / 72, 1: 1 / 12, 2: 1 / 9, 3: -1 / 8}],
    )
)
'''


def test_a_new_method_is_one_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "bs23.py").write_text(BOGACKI_SHAMPINE, encoding="utf-8")
    with pytest.raises(fb.InputError, match="there is no method bs23; take auto, dop853, dopri5, radau5, rk4, moreau"):
        fb.SimulationOptions(method="bs23")
    monkeypatch.setattr(folder_of_integrators, "__path__", [*folder_of_integrators.__path__, str(tmp_path)])
    try:
        assert "bs23" in integrators()
        test_a_method_converges_with_its_order("bs23")
        # free fall from 1 m: 2 h/g = t^2; three stages make a parabola exact
        ball = "bodies: {b: {particle: {mass: 1 kg}, at: [0, 1 m]}}\nloads: {w: {gravity: 10 m/s^2}}\n"
        fall = model(ball).simulate(1.0, events=["y of b = 0"], method="bs23")
        assert fall.events[-1].time == pytest.approx(math.sqrt(0.2), rel=1e-12)
        assert "bs23" in fall.to_html()
        with pytest.raises(fb.InputError, match="is for the methods rk4 and moreau; bs23 chooses its steps"):
            fb.SimulationOptions(method="bs23", step=0.1)
        pendulum = str(ROOT / "examples" / "simple_pendulum.yaml")
        done = freebody("simulate", pendulum, "--until", "0.1", "--method", "bs23", "--json")
        assert json.loads(done.stdout)["method"] == "bs23"
    finally:
        sys.modules.pop(f"{folder_of_integrators.__name__}.bs23", None)


@pytest.mark.parametrize("name", EXAMPLES)
def test_an_example_simulates_within_its_constraints_and_energy(name: str) -> None:
    result = example(name).simulate(2.0, tolerance=1e-10)
    summary = result.summary()
    assert result.status is Status.FINISHED, result.message
    assert summary["max_position_violation"] < 1e-12
    assert summary["max_velocity_violation"] < 1e-10
    # the crank spins up to 400 turns; its energy is held to 2e-9
    at_rest = summary["energy_error"] < 1e-8  # [J] of what stays where it is, as a worm gear that locks itself
    assert at_rest or summary["energy_error_relative"] < (1e-9 if name != "slider_crank" else 1e-8)
    assert np.isfinite(result.course.poses).all()
    assert (np.diff(result.course.times) > 0).all()


@pytest.mark.parametrize("name", EXAMPLES)
def test_momentum_balances_on_every_body_to_round_off(name: str) -> None:
    """m a = sum of loads and reactions, put together by the reference route from the engine's multipliers."""
    result = example(name).simulate(0.5, every=0.25)
    reference, system = result.simulator.reference, result.system
    k = len(result.course.times) - 1
    engine = result.simulator.engine
    q, v = map(reference.by_column, engine.coordinates(engine.state_at(result.course, k)))
    snapshot = reference.snapshot(q, v, float(result.course.times[k]))
    accelerations = engine.accelerations(result.course)[k].reshape(len(system.all_moving) + 1, -1)
    columns = reference.frame.columns
    turning = gyroscopic(v, reference.masses, columns.values()) if system.space else np.zeros(len(v))
    for b, body in enumerate(system.all_moving):
        if body.name.startswith("⌒"):
            continue  # the foot on a curve, which carries nothing
        own = list(columns[body.name])
        force, size = turning[own], 1e-2
        for row, x in zip(system.rows, result.course.multipliers[k], strict=True):
            part = x * reference.jet(snapshot.geometry, row.measure).row(len(q))[own]
            force, size = force + part, max(size, float(np.abs(part).max()))
        for push in system.all_loads:
            part = snapshot.law(push) * reference.jet(snapshot.geometry, push.measure).row(len(q))[own]
            force, size = force + part, max(size, float(np.abs(part).max()))
        gap = reference.masses[own] * accelerations[b][: len(own)] - force
        assert np.abs(gap).max() < 1e-10 * size, body.name


def test_reactions_do_no_work() -> None:
    result = example("four_bar").simulate(1.0, tolerance=1e-11)
    assert result.energy.relative_error < 1e-9


def test_the_hinge_of_a_falling_rod_carries_what_the_closed_form_says() -> None:
    # released horizontal, theta below it, w^2 = 3 g sin/L:  H = (9/4) m g sin cos,  V = m g (1 + 9 sin^2)/4
    rod = model("""
bodies: {rod: {rod: {mass: 3 kg, length: 2 m}, at: {start: [0, 0]}, angle: 0}}
connections: {hinge: {pin: [ground.O, rod.start]}}
loads: {g: {gravity: 9.81}}
measures: {theta: angle of rod}
""")
    result = rod.simulate(0.6, tolerance=1e-12)
    theta = -result.series["theta"][0]
    m, sin, cos = 3.0, np.sin(theta), np.cos(theta)
    data = result.dataset
    assert np.abs(np.asarray(data["hinge.x"])) == pytest.approx(np.abs(9 / 4 * m * G * sin * cos), abs=1e-8)
    assert np.abs(np.asarray(data["hinge.y"])) == pytest.approx(m * G * (1 + 9 * sin**2) / 4, abs=1e-8)


def test_the_tension_of_a_pendulum_is_three_times_its_weight_at_the_bottom() -> None:
    result = A01.simulate(3.0, tolerance=1e-12, events=["x = 0"])
    at = [int(np.argmin(np.abs(result.course.times - e.time))) for e in result.events]
    values = np.abs(np.asarray(result.dataset["string.tension"]))
    assert values[at] == pytest.approx(3 * G, rel=1e-9)


# -- the same mechanism, built in two ways ----------------------------------------------------
SLIDER = """
parameters: {k: 30 N/m}
bodies: {block: {body: {mass: 2 kg, inertia: 0.1 kg m^2}, points: {A: [-0.1 m, 0], B: [0.1 m, 0]}, at: [0.2 m, 0]},
         rod: {rod: {mass: 1 kg, length: 0.5 m}, angle: -30 deg}}
connections: {%s, hinge: {pin: [block, rod.start]}}
loads: {g: {gravity: 9.81}, s: {law: {measure: x, force: -k*x}}}
measures: {x: x of block}
"""


def assert_moves_alike(first: str, second: str, until: float = 1.0) -> None:
    a, b = (model(text).simulate(until, tolerance=1e-12, every=until / 4) for text in (first, second))
    assert a.status is b.status is Status.FINISHED
    assert np.abs(a.course.poses - b.course.poses).max() < 1e-10


def test_a_slider_moves_like_two_slots() -> None:
    slots = ", ".join(
        f"{name}: {{slot: {{pin: block.{point}, along: right, through: ground.O}}}}" for name, point in ("aA", "bB")
    )
    assert_moves_alike(SLIDER % "guide: {slider: {body: block, along: right}}", SLIDER % slots)


def test_a_weld_moves_like_a_pin_and_a_held_angle() -> None:
    text = """
bodies: {a: {rod: {mass: 1 kg, length: 1 m}, at: {start: [0, 0]}, angle: 20 deg},
         b: {rod: {mass: 2 kg, length: 0.7 m}, angle: 20 deg}}
connections: {hinge: {pin: [ground.O, a.start]}, %s}
loads: {g: {gravity: 9.81}}
measures: {bend: {angle: b, relative to: a}}
"""
    weld = text.replace("measures: {bend: {angle: b, relative to: a}}\n", "")
    weld = weld % "w: {weld: [a.end, b.start]}"
    held = text.replace("{angle: b, relative to: a}", "angle of b relative to a")
    assert_moves_alike(weld, held % "p: {pin: [a.end, b.start]}, h: {constraint: bend}")


def test_a_gear_pair_moves_like_a_crossed_belt() -> None:
    text = """
parameters: {w0: 3 1/s, T0: 2 N m}
bodies: {a: {disk: {mass: 1 kg, radius: 0.2 m}, at: [0, 0]}, b: {disk: {mass: 3 kg, radius: 0.3 m}, at: [0.5 m, 0]}}
connections: {A: {pin: [ground.A, a]}, B: {pin: [ground.B, b]}, %s}
ground: {points: {A: [0, 0], B: [0.5 m, 0]}}
loads: {m: {torque: {on: a, magnitude: T0*cos(w0*t)}}}
"""
    assert_moves_alike(text % "g: {gear_mesh: [a, b]}", text % "g: {belt: {first: a, second: b, crossed: true}}")


# -- events -----------------------------------------------------------------------------------
def oscillating(events: list[str], until: float = 2.0) -> list[tuple[float, str, str]]:
    """x = 0.3 cos(5 t)."""
    result = model(OSCILLATOR).simulate(until, tolerance=1e-12, events=events)
    assert (np.diff(result.course.times) > 0).all()
    return [(e.time, e.name, e.kind) for e in result.events]


def test_crossings_are_found_with_their_direction() -> None:
    found = oscillating(["x = 0"])
    assert [t for t, _n, _k in found] == pytest.approx([math.pi * (2 * k + 1) / 10 for k in range(3)], rel=1e-11)
    assert [k for _t, _n, k in found] == ["falling", "rising", "falling"]


def test_an_event_can_be_asked_for_in_one_direction() -> None:
    assert [kind for _t, _n, kind in oscillating(["x = 0 rising"])] == ["rising"]
    assert [kind for _t, _n, kind in oscillating(["x = 0 falling"])] == ["falling", "falling"]


def test_two_events_at_one_instant_are_both_reported_in_their_order() -> None:
    found = oscillating(["rate(x) = -1.5 m/s", "x = 0"], until=0.5)
    at = [item for item in found if item[0] == pytest.approx(math.pi / 10, abs=1e-5)]
    assert [name for _t, name, _k in at] == ["rate(x) = -1.5 m/s", "x = 0"]


def test_an_event_at_the_start_is_said_to_be_one_and_crossed_later_only() -> None:
    found = oscillating(["rate(x) = 0"], until=1.0)
    assert found[0] == (0.0, "rate(x) = 0", "start")
    assert found[1][0] == pytest.approx(math.pi / 5, rel=1e-11)


def test_an_event_at_the_end_is_reported() -> None:
    found = oscillating(["x = 0"], until=math.pi / 10)
    assert len(found) <= 1
    assert oscillating(["x = 0"], until=math.pi / 10 + 1e-9)[0][0] == pytest.approx(math.pi / 10, rel=1e-11)


def test_grazing_is_a_touch_and_no_crossing() -> None:
    found = oscillating(["x = -0.3 m"], until=1.0)
    assert [kind for _t, _n, kind in found] == ["touch"]
    assert found[0][0] == pytest.approx(math.pi / 5, abs=1e-5)


def test_what_is_zero_throughout_is_said_once() -> None:
    result = model(OSCILLATOR + "\n").simulate(1.0, events=["y of block = 0"])
    assert [e.kind for e in result.events if e.kind != "start"] == ["zero"]


def test_a_terminal_event_ends_the_motion_there() -> None:
    result = model(OSCILLATOR).simulate(2.0, tolerance=1e-12, events=["stop when x = 0"])
    assert result.status is Status.EVENT
    assert result.t_end == pytest.approx(math.pi / 10, rel=1e-12)
    assert result.series["x"][0][-1] == pytest.approx(0.0, abs=1e-12)


def test_a_string_that_would_have_to_push_goes_slack() -> None:
    system = model("""
bodies: {ball: {particle: {mass: 1 kg}, at: [0, -1 m], velocity: [5 m/s, 0]}}
connections: {s: {string: [ground.O, ball]}}
ground: {points: {O: [0, 0]}}
loads: {g: {gravity: 9.81}}
""")
    result = system.simulate(1.0, tolerance=1e-11)
    first = result.events[0]
    assert (first.name, first.kind) == ("s goes slack", "goes slack")
    # slack where v^2 = g L cos(from the top): cos = (v0^2/(g L) - 2)/3
    above = np.arccos((25 / G - 2) / 3)
    k = int(np.argmin(np.abs(result.course.times - first.time)))
    x, y = result.course.poses[k, 0, :2]
    assert math.atan2(abs(x), y) == pytest.approx(above, abs=1e-9)


# -- how a motion can end ---------------------------------------------------------------------
FOUR_BAR = """
parameters: {r: 0.5 m, w0: 1 1/s, a0: 60 deg}
bodies: {crank: {rod: {mass: 1 kg, length: r}, at: {start: [0, 0]}, angle: 60 deg},
         coupler: {rod: {mass: 1 kg, length: 0.6 m}},
         rocker: {rod: {mass: 1 kg, length: 0.5 m}, at: {start: [1 m, 0]}, near: {angle: 110 deg}}}
ground: {points: {A: [0, 0], D: [1 m, 0]}}
connections: {A: {pin: [ground.A, crank.start]}, B: {pin: [crank.end, coupler.start]},
              C: {pin: [coupler.end, rocker.end]}, D: {pin: [ground.D, rocker.start]},
              motor: {driver: {measure: theta, follows: a0 + w0*t}}}
measures: {theta: angle of crank}
"""


@pytest.mark.parametrize("friction", ["", "  rub: {dry_friction: {measure: height of p, force: 0.2 N}}\n"])
def test_a_direction_is_driven_until_the_ends_of_its_line_meet(friction: str) -> None:
    """The line from p to the origin is held level. No force acts along it, so p goes on as it was thrown, with 1 m/s
    towards the origin 1 m away: it is there after 1 s, where the line has no direction."""
    text = f"""
bodies: {{p: {{particle: {{mass: 1 kg}}, at: [1 m, 0], velocity: [-1 m/s, 0]}}}}
connections:
  aim: {{driver: {{measure: angle of line from p to ground.O from left, follows: 0*t}}}}
{friction}"""
    result = model(text).simulate(2.0)
    assert result.status is Status.NOT_FINITE
    assert "aim" in result.message
    assert "no finite value" in result.message
    assert result.t_end == pytest.approx(1.0, abs=1e-6)


def test_a_driver_beyond_its_reach_stops_at_the_limit_with_names() -> None:
    result = model(FOUR_BAR).simulate(5.0)
    assert result.status is Status.UNREACHABLE
    assert "motor" in result.message
    # coupler and rocker in line: 1.1^2 = 0.5^2 + 1 - 2 0.5 cos(theta)
    limit = math.acos((0.25 + 1 - 1.1**2) / 1.0) - math.radians(60)
    assert result.t_end == pytest.approx(limit, abs=1e-4)
    said = re.search(r"beyond t = ([0-9.]+) s", result.message)
    assert said is not None
    assert float(said[1]) == pytest.approx(limit, abs=1e-8)
    assert np.isfinite(result.course.poses).all()


def test_a_law_without_a_value_ends_the_motion_with_its_name() -> None:
    system = model(OSCILLATOR.replace("-k*x - c*rate(x)", "-k*L*sqrt(x/L)").replace("m: 2 kg", "m: 2 kg, L: 1 m"))
    result = system.simulate(2.0)
    assert result.status is Status.NOT_FINITE
    assert result.message.startswith("s")
    assert 0.05 < result.t_end < 2.0


def test_a_long_motion_is_stopped_by_the_clock_and_keeps_what_it_has(monkeypatch: pytest.MonkeyPatch) -> None:
    looks = itertools.count()
    monkeypatch.setattr(time, "perf_counter", lambda: 0.01 * next(looks))
    result = example("double_pendulum").simulate(1e6, max_seconds=0.3, every=1e5)
    assert result.status is Status.TOO_LONG
    assert result.t_end > 0.0


def test_an_interruption_keeps_what_was_computed() -> None:
    def stop(now: float, _steps: int) -> None:
        if now > 1.0:
            raise KeyboardInterrupt

    result = A01.simulate(1e5, progress=stop, every=1e4)
    assert result.status is Status.INTERRUPTED
    assert 1.0 < result.t_end < 1e5


def test_a_motion_is_continued_from_its_result() -> None:
    system = example("simple_pendulum")
    whole = system.simulate(2.0, tolerance=1e-12, every=1.0)
    parts = system.simulate(1.0, tolerance=1e-12, every=0.5).continued(2.0, every=0.5)
    assert parts.course.poses[-1] == pytest.approx(whole.course.poses[-1], abs=1e-9)
    assert parts.t_end == 2.0


def test_a_system_without_freedom_says_so_and_gives_its_reactions() -> None:
    truss = model("""
bodies: {a: {rod: {mass: 1 kg, length: 1 m}, at: {start: [0, 0]}, angle: 60 deg},
         b: {rod: {mass: 1 kg, length: 1 m}, at: {start: [1 m, 0]}, near: {angle: 120 deg}}}
ground: {points: {A: [0, 0], B: [1 m, 0]}}
connections: {A: {pin: [ground.A, a.start]}, B: {pin: [ground.B, b.start]}, C: {pin: [a.end, b.end]}}
loads: {g: {gravity: 9.81}}
""")
    result = truss.simulate(1.0)
    assert "0 degrees of freedom" in result.message
    assert result.t_end == 0.0
    assert abs(float(result.dataset["A.y"][0])) == pytest.approx(G, rel=1e-9)


# -- redundant, massless, stiff, chaotic ------------------------------------------------------
def parallelogram(extra: str = "") -> fb.System:
    return model(f"""
bodies: {{a: {{rod: {{mass: 1 kg, length: 1 m}}, at: {{start: [0, 0]}}, angle: 70 deg}},
         b: {{rod: {{mass: 1 kg, length: 1 m}}, at: {{start: [2 m, 0]}}, angle: 70 deg}},
         c: {{body: {{mass: 2 kg, inertia: 1 kg m^2}}, points: {{L: [-1 m, 0], M: [0, 0], R: [1 m, 0]}}}}
         {", d: {rod: {mass: 1e-9 kg, length: 1 m}, at: {start: [1 m, 0]}, angle: 70 deg}" if extra else ""}}}
ground: {{points: {{A: [0, 0], M: [1 m, 0], B: [2 m, 0]}}}}
connections: {{A: {{pin: [ground.A, a.start]}}, B: {{pin: [ground.B, b.start]}}, L: {{pin: [a.end, c.L]}},
              R: {{pin: [b.end, c.R]}}{", M: {pin: [ground.M, d.start]}, T: {pin: [d.end, c.M]}" if extra else ""}}}
loads: {{g: {{gravity: 9.81}}}}
""")


def test_a_redundant_bar_changes_nothing_and_its_reactions_are_marked() -> None:
    plain, redundant = (parallelogram(extra).simulate(1.5, tolerance=1e-11, every=0.5) for extra in ("", "yes"))
    assert redundant.status is Status.FINISHED
    assert redundant.course.poses[:, :3] == pytest.approx(plain.course.poses[:, :3], abs=1e-7)
    data = redundant.dataset
    assert "non_unique" in data["L.x"].attrs
    assert np.isnan(data["L.x"]).all()
    assert plain.course.unique.all()


def test_a_stiff_spring_changes_the_method_and_keeps_the_number_of_steps_bounded() -> None:
    system = model(OSCILLATOR).with_parameters(c="2e7 N s/m", k="1e9 N/m")
    result = system.simulate(10.0, tolerance=1e-8)
    assert result.status is Status.FINISHED
    assert "radau5" in result.course.method
    assert result.course.n_steps < 5000
    # overdamped: the slow rate is k/c
    slow = (2e7 - math.sqrt(4e14 - 4 * 2 * 1e9)) / 4
    fast = (2e7 + math.sqrt(4e14 - 4 * 2 * 1e9)) / 4
    exact = 0.3 * (fast * math.exp(-slow * 0.05) - slow * math.exp(-fast * 0.05)) / (fast - slow)
    x = np.interp(0.05, result.course.times, result.series["x"][0])
    assert x == pytest.approx(exact, abs=1e-5)
    # the same where every step is looked at for an event: 0.3 exp(-slow t) = 0.1 once the fast part is gone
    watched = system.simulate(1.0, tolerance=1e-8, events=["x = 0.1 m"])
    assert "radau5" in watched.course.method
    assert watched.course.n_steps < 5000
    assert watched.events[0].time == pytest.approx(math.log(3.0 * fast / (fast - slow)) / slow, rel=1e-6)


def test_a_mass_ratio_of_a_thousand_million_is_followed() -> None:
    system = model("""
bodies: {a: {particle: {mass: 1e9 kg}, at: [0, -1 m]}, b: {particle: {mass: 1 kg}, at: [1 m, -1 m]}}
connections: {l: {link: [ground.O, a]}, m: {link: [a, b]}}
ground: {points: {O: [0, 0]}}
loads: {g: {gravity: 9.81}}
""")
    result = system.simulate(5.0, tolerance=1e-10)
    assert result.status is Status.FINISHED
    assert result.course.n_steps < 2000
    # the heavy one stays; the light one swings from the horizontal
    light = solve_ivp(
        lambda _t, y: [y[1], -G * math.cos(y[0])], (0, 5), [0, 0], rtol=1e-12, atol=1e-12, method="DOP853"
    ).y[0, -1]
    x, y = result.course.poses[-1, 1, :2] - result.course.poses[-1, 0, :2]
    assert (x, y) == pytest.approx((math.cos(light), math.sin(light)), abs=1e-6)


def test_chaotic_motion_is_trusted_up_to_where_two_tolerances_part() -> None:
    system = example("double_pendulum")
    text = system.to_yaml()
    assert text
    wild = model("""
bodies: {a: {rod: {mass: 1 kg, length: 1 m}, at: {start: [0, 0]}, angle: 120 deg},
         b: {rod: {mass: 1 kg, length: 1 m}, angle: 170 deg}}
connections: {A: {pin: [ground.O, a.start]}, B: {pin: [a.end, b.start]}}
loads: {g: {gravity: 9.81}}
""")
    result = wild.simulate(60.0, tolerance=1e-8, verify=True)
    assert result.trusted_until is not None
    assert 3.0 < result.trusted_until < 59.0
    assert A01.simulate(20.0, tolerance=1e-10, verify=True).trusted_until == 20.0


# -- arguments and files ----------------------------------------------------------------------
@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"until": 0.0}, "positive time"),
        ({"until": -1.0}, "positive time"),
        ({"until": math.nan}, "positive time"),
        ({"until": 1.0, "method": "euler"}, "no method euler"),
        ({"until": 1.0, "tolerance": 3.0}, "tolerance"),
        ({"until": 1.0, "every": -1.0}, "every"),
    ],
)
def test_arguments_without_sense_are_refused(options: dict[str, object], message: str) -> None:
    with pytest.raises(fb.InputError, match=message):
        A01.simulate(**options)  # type: ignore[arg-type]


def test_a_parameter_without_a_value_is_named() -> None:
    system = model("parameters: {m: {unit: kg}}\nbodies: {ball: {particle: {mass: m}}}\nloads: {g: {gravity: 9.81}}\n")
    with pytest.raises(fb.CannotAnswer, match="m"):
        system.simulate(1.0)


def test_a_dataset_has_units_and_comes_back_from_its_file(tmp_path: Path) -> None:
    import xarray

    from freebody.study.simulation.files import write

    result = example("mass_on_spring").simulate(0.5, every=0.1)
    data = result.dataset
    assert all(v.attrs["units"] and v.attrs["long_name"] for v in data.data_vars.values())
    write(result.recording, tmp_path / "run.nc")
    with xarray.open_dataset(tmp_path / "run.nc", engine="h5netcdf") as back:
        assert float(np.abs(back["body_position"] - data["body_position"]).max()) == 0.0
        assert back["body_position"].attrs["units"] == "m"
    write(result.recording, tmp_path / "run.csv")
    table = np.genfromtxt(tmp_path / "run.csv", delimiter=",", names=True)
    assert len(table) == len(result.course.times)


def test_without_xarray_tables_and_plots_are_written_and_datasets_say_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from freebody.study.simulation import files

    monkeypatch.setitem(sys.modules, "xarray", None)
    monkeypatch.setattr(files, "find_spec", lambda _name: None)
    result = example("mass_on_spring").simulate(0.5, every=0.1)
    files.write(result.recording, tmp_path / "run.csv")
    result.plot(path=tmp_path / "run.png")
    with pytest.raises(fb.InputError, match=r'pip install "freebody\[data\]"'):
        _ = result.dataset
    with pytest.raises(fb.InputError, match=r'pip install "freebody\[data\]"'):
        files.check_path(tmp_path / "run.nc", files.SUFFIXES)


def test_a_path_that_cannot_be_written_is_told_before_the_run(tmp_path: Path) -> None:
    from freebody.study.simulation.files import SUFFIXES, check_path

    with pytest.raises(fb.InputError, match="no folder"):
        check_path(tmp_path / "nowhere" / "run.nc", SUFFIXES)
    with pytest.raises(fb.InputError, match="must end in"):
        check_path(tmp_path / "run.xls", SUFFIXES)
    assert not (tmp_path / "run.xls").exists()


def test_the_summary_is_one_json_document() -> None:
    summary = json.loads(json.dumps(A01.simulate(1.0, events=["x = 0"]).summary()))
    expected = {"status", "message", "t_end", "steps", "evaluations", "wall_time", "max_position_violation"}
    expected |= {"max_velocity_violation", "energy_error", "events", "final"}
    assert expected <= summary.keys()
    assert summary["final"]["measures"].keys() == {"x", "y"}
    assert summary["events"][0].keys() == {"time", "name", "kind"}


def test_a_misspelt_event_is_named_with_the_nearest_measure() -> None:
    with pytest.raises(fb.InputError, match="Did you mean x"):
        A01.simulate(1.0, events=["xx = 0"])


def test_a_result_shows_itself_in_a_notebook() -> None:
    html = A01.simulate(0.5)._repr_html_()
    assert "<svg" in html
    assert "energy" in html


def test_turns_of_a_line_are_counted_between_distant_output_times() -> None:
    system = model("""
bodies: {wheel: {rod: {mass: 1 kg, length: 1 m}, at: {start: [0, 0]}, angle: 30 deg, angular_velocity: 50 rad/s}}
connections: {hub: {pin: [ground.O, wheel.start]}}
measures: {theta: angle of line from ground.O to wheel.end, phi: angle of wheel}
""")
    result = system.simulate(10.0, every=2.5)
    assert result.series["theta"][0] == pytest.approx(result.series["phi"][0], abs=1e-6)
    assert result.series["phi"][0][-1] == pytest.approx(math.radians(30) + 500.0, abs=1e-6)


def test_a_law_with_a_jump_is_no_linear_law() -> None:
    system = model("""
parameters: {m: 1 kg, mu: 0.3, g: 9.81 m/s^2}
bodies: {b: {particle: {mass: m}, at: [0, 0], velocity: [1 m/s, 0]}}
connections: {s: {slider: {body: b, along: right}}}
loads: {f: {law: {measure: x, force: -mu*m*g*sign(rate(x))}}}
measures: {x: x of b}
""")
    result = system.simulate(0.3, every=0.1)
    assert result.series["x"][0][-1] == pytest.approx(0.3 - 0.5 * 0.3 * G * 0.09, abs=1e-12)
    chattering = system.simulate(5.0, max_steps=3000)
    assert chattering.status is Status.TOO_LONG
    assert "the law of f jumps" in chattering.message


@pytest.mark.parametrize(
    "law", ["-k*x", "-k*x - c*rate(x)", "-k*x^3/L^2", "-k*L*sin(x/L)", "-k*abs(x)*sign(x)", "-c*abs(rate(x))*rate(x)/v"]
)
def test_energy_balances_whatever_the_law_of_a_load(law: str) -> None:
    text = OSCILLATOR.replace("-k*x - c*rate(x)", law)
    text = text.replace("c: {value: 0 N s/m", "L: 1 m, v: 1 m/s, c: {value: 3 N s/m")
    assert model(text).simulate(2.0, tolerance=1e-10).energy.relative_error < 1e-8


def test_a_skate_on_an_incline_moves_as_its_closed_form_says() -> None:
    # theta = w t,  v = (g sin(alpha)/w) (cos(w t) - 1) along the blade (Neimark & Fufaev, Nonholonomic Systems)
    skate = model("""
parameters: {m: 1.5 kg, I: 0.2 kg m^2, g: 9.81 m/s^2, alpha: 20 deg}
bodies: {b: {body: {mass: m, inertia: I}}}
connections: {blade: {velocity_constraint: rate(y)*cos(theta) - rate(x)*sin(theta)}}
loads: {w: {gravity: g*sin(alpha)}}
measures: {x: x of b, y: y of b, theta: angle of b}
start: {x: 0 m, y: 0 m, theta: 0 deg, rate(x): 0 m/s, rate(theta): 1 rad/s}
""")
    result = skate.simulate(3.0, every=0.5)
    t = result.course.times
    v = G * math.sin(math.radians(20)) * (np.cos(t) - 1.0)
    assert result.series["x"][1] == pytest.approx(v * np.cos(t), abs=1e-8)
    assert result.series["y"][1] == pytest.approx(v * np.sin(t), abs=1e-8)
    assert result.course.n_steps < 100
    slip = result.series["y"][1] * np.cos(t) - result.series["x"][1] * np.sin(t)
    assert np.abs(slip).max() < 1e-10


@pytest.mark.parametrize("far", ["150 m", "1e4 m"])
def test_a_start_far_from_the_size_of_the_bodies_is_assembled(far: str) -> None:
    particle = model(f"bodies: {{b: {{particle: {{mass: 1 kg}}}}}}\nmeasures: {{x: x of b}}\nstart: {{x: {far}}}\n")
    assert particle.simulate(1.0).course.poses[0, 0, 0] == pytest.approx(float(far.split(maxsplit=1)[0]))
    wheel = model("""
parameters: {m: 1 kg, R: 0.005 m, g: 9.81 m/s^2}
bodies: {d: {disk: {mass: m, radius: R}}}
connections: {c: {rolling: {body: d, on: ground.l}}}
ground: {lines: {l: {along: -10 deg}}}
loads: {w: {gravity: g}}
measures: {s: travel of d along -10 deg}
start: {s: 2 m, rate(s): 0}
""")
    result = wheel.simulate(1.0, tolerance=1e-11)
    assert result.series["s"][0][-1] == pytest.approx(2 + G * math.sin(math.radians(10)) / 3, rel=1e-9)


def test_arguments_that_would_be_ignored_or_never_end_are_refused() -> None:
    for options, message in (
        ({"step": 0.001}, "rk4"),
        ({"every": 1e-9}, "output times"),
        ({"max_seconds": math.nan}, "max_seconds"),
        ({"max_seconds": -1.0}, "max_seconds"),
    ):
        with pytest.raises(fb.InputError, match=message):
            A01.simulate(1.0, **options)  # type: ignore[arg-type]
    with pytest.raises(fb.InputError, match="not positive"):
        model(OSCILLATOR).simulate(1.0, values={"m": -1.0})


def test_what_leaves_zero_at_the_start_is_listed_once() -> None:
    found = oscillating(["rate(x) = 0", "x = 0.3 m"], until=0.5)
    assert [(t, kind) for t, _n, kind in found] == [(0.0, "start"), (0.0, "start")]


@pytest.mark.parametrize("length", ["1e6 m", "1 m", "1e-4 m"])
def test_a_motion_does_not_depend_on_the_size_of_the_system(length: str) -> None:
    pendulum = model(f"""
bodies: {{b: {{particle: {{mass: 1 kg}}}}}}
connections: {{l: {{link: [ground.O, b, {length}]}}}}
loads: {{g: {{gravity: 9.81}}}}
measures: {{theta: angle of line from ground.O to b from down}}
start: {{theta: 0.1 rad}}
""")
    # T = 2 pi sqrt(L/g) (1 + a^2/16 + 11 a^4/3072 + 173 a^6/737280 + ...)
    period = (
        2 * math.pi * math.sqrt(float(length.removesuffix(" m")) / G) * (1 + 1e-2 / 16 + 11e-4 / 3072 + 173e-6 / 737280)
    )
    result = pendulum.simulate(5 * period, tolerance=1e-10, every=5 * period)
    assert result.series["theta"][0][-1] == pytest.approx(0.1, abs=1e-9)
    assert 90 < result.course.n_steps < 115


def test_a_string_that_would_have_to_push_from_the_start_is_slack_at_once() -> None:
    # thrown slowly over the top: m g > m v^2/L, so the string is slack at once
    system = model("""
bodies: {ball: {particle: {mass: 1 kg}, at: [0, 1 m], velocity: [1 m/s, 0]}}
connections: {s: {string: [ground.O, ball]}}
ground: {points: {O: [0, 0]}}
loads: {g: {gravity: 9.81}}
""")
    result = system.simulate(0.1)
    assert (result.events[0].time, result.events[0].kind) == (0.0, "goes slack")
    assert float(result.dataset["s.tension"][0]) == 0.0
    assert result.course.poses[-1, 0, :2] == pytest.approx([0.1, 1.0 - G * 0.1**2 / 2], rel=1e-9)


def test_a_pose_that_is_searched_disturbs_nothing_that_it_need_not() -> None:
    """The bead is described in the middle of its ring, which is no place on it: what nothing says of the others, and
    what a guide keeps, is as it is described without it."""
    system = fb.System.from_text("""
ground: {points: {O: [0, 0]}}
bodies:
  bead: {particle: {mass: 1 kg}}
  cart: {rectangle: {mass: 2 kg, width: 1 m, height: 0.4 m}}
  wheel: {disk: {mass: 1 kg, radius: 0.1 m}}
connections:
  ring: {link: {first: ground.O, second: bead, length: 0.5 m}}
  rail: {slider: {body: cart, along: right}}
  hub: {pin: [wheel.center, bead]}
loads: {c: {spring: {first: bead, second: cart, stiffness: 5 N/m, length: 1 m}}}
""")
    start = system.simulate(0.01).dataset.isel(time=0)
    angles = start.body_angle.sel(body=["cart", "wheel"]).values
    assert angles == pytest.approx([0.0, 0.0], abs=1e-15)
    assert abs(start.body_position.sel(body="cart", axis="y").item()) < 1e-15
