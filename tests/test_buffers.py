"""Springs that act on one side only: a cart against a buffer. With omega^2 = k/m, from the touch at v on:
m s'' = -(F0 + k s), so that s turns where k s^2/2 + F0 s = m v^2/2, and the force is zero again with the speed v."""

from __future__ import annotations

import math

import pytest

import freebody as fb

M, K, L, D, V = 2.0, 50.0, 1.0, 3.0, 3.0


def cart(buffer: str = "", **given: float) -> fb.System:
    values = {"l": L, "k": K, "d": D, "v0": V} | given
    return fb.System.from_text(f"""
parameters: {{m: 2 kg, k: {values["k"]} N/m, l: {values["l"]} m, d: {values["d"]} m, v0: {values["v0"]} m/s, F0: 4 N}}
ground: {{points: {{wall: [d, 0]}}}}
bodies: {{cart: {{particle: {{mass: m}}}}}}
connections: {{line: {{slider: {{body: cart, along: right}}}}}}
loads:
  buffer: {{spring: {{first: ground.wall, second: cart, stiffness: k, length: l, only: compressed{buffer}}}}}
measures: {{x: {{x of cart}}}}
start: {{x: 0, rate(x): v0}}
""")


def test_contact_with_a_buffer_takes_half_a_period_and_gives_the_speed_back() -> None:
    system = cart()
    solved = system.solve(["greatest x", "time when buffer is relaxed", "velocity of x when buffer is relaxed"])
    farthest, released, rebound = (answer.value for answer in solved.answers)
    assert farthest == pytest.approx(D - L + V * math.sqrt(M / K), rel=1e-12)
    assert released == pytest.approx((D - L) / V + math.pi * math.sqrt(M / K), rel=1e-12)
    assert rebound == pytest.approx(-V, rel=1e-12)


def test_preload_shortens_the_contact_and_the_way() -> None:
    """s = (sqrt(F0^2 + m k v^2) - F0)/k and T = 2 atan(v sqrt(m k)/F0)/omega, which is pi/omega without preload."""
    system = cart(", preload: F0")
    solved = system.solve(["greatest x", "force in buffer when rate(x) = 0", "time when buffer is relaxed"])
    farthest, force, released = (answer.value for answer in solved.answers)
    root = math.hypot(4.0, V * math.sqrt(M * K))
    assert farthest == pytest.approx(D - L + (root - 4.0) / K, rel=1e-12)
    assert force == pytest.approx(-root, rel=1e-12)
    lasts = 2 * math.atan(V * math.sqrt(M * K) / 4.0) * math.sqrt(M / K)
    assert released == pytest.approx((D - L) / V + lasts, rel=1e-12)


@pytest.mark.parametrize(("d", "length", "k"), [(3.0, 1.0, 50.0), (100.0, 0.1, 5e4), (1000.0, 0.01, 5e5)])
def test_a_simulation_does_not_jump_over_a_buffer_however_short_it_is(d: float, length: float, k: float) -> None:
    """The last buffer is touched for 6 ms after 333 s."""
    motion = cart(d=d, l=length, k=k).simulate(2.0 * d / V)
    reached, relaxed = motion.events
    assert (str(reached.name), str(relaxed.name)) == ("buffer is reached", "buffer is relaxed again")
    assert reached.time == pytest.approx((d - length) / V, rel=1e-9)
    assert relaxed.time - reached.time == pytest.approx(math.pi * math.sqrt(M / k), rel=1e-6)
    assert motion.series["x"][1][-1] == pytest.approx(-V, rel=1e-5)  # a step may be wrong by 1e-9 of a kilometre


def test_a_simulation_goes_on_behind_a_border_with_dry_friction_too() -> None:
    """m v1^2/2 = m v^2/2 - mu m g (d - l) at the buffer; k s^2/2 + mu m g s = m v1^2/2 where the block turns."""
    system = fb.System.from_text("""
parameters: {m: 2 kg, k: 500000 N/m, l: 0.1 m, d: 100 m, v0: 30 m/s, mu: 0.2, g: 9.81 m/s^2}
ground: {points: {wall: [d, 0]}, lines: {table: {along: right}}}
bodies: {block: {particle: {mass: m}}}
connections: {table: {contact: {between: [block, ground.table], friction: mu}}}
loads:
  weight: {gravity: g}
  buffer: {spring: {first: ground.wall, second: block, stiffness: k, length: l, only: compressed}}
measures: {x: {x of block}}
start: {x: 0, rate(x): v0}
""")
    motion = system.simulate(20.0)
    energy = 900.0 - 0.2 * 2 * 9.81 * 99.9
    pressed = (math.sqrt((0.4 * 9.81) ** 2 + 2 * 5e5 * energy) - 0.4 * 9.81) / 5e5
    assert motion.events[0].kind == "touches"
    assert max(motion.series["x"][0]) == pytest.approx(99.9 + pressed, abs=1e-3)
    back = energy - 2 * 0.4 * 9.81 * pressed
    assert motion.series["x"][0][-1] == pytest.approx(99.9 - back / (0.4 * 9.81), rel=1e-6)


def test_a_spring_that_only_pulls_is_an_elastic_string() -> None:
    def bound(load: str) -> fb.System:
        return fb.System.from_text(f"""
parameters: {{m: 2 kg, k: 50 N/m, l: 1 m, v0: 3 m/s}}
ground: {{points: {{wall: [0, 0]}}}}
bodies: {{cart: {{particle: {{mass: m}}}}}}
connections: {{line: {{slider: {{body: cart, along: right}}}}}}
loads: {{tie: {{{load}, stiffness: k, length: l}}}}}}
measures: {{x: {{x of cart}}}}
start: {{x: l/2, rate(x): v0}}
""")

    asked = ["greatest x", "time when tie goes taut", "force in tie when x turns back"]
    spring = bound("spring: {first: ground.wall, second: cart, only: stretched").solve(asked)
    string = bound("elastic_string: {from: ground.wall, to: cart").solve(asked)
    for one, other in zip(spring.answers, string.answers, strict=True):
        assert one.value == pytest.approx(other.value, rel=1e-12)


def test_a_spring_of_one_side_without_a_length_is_refused() -> None:
    with pytest.raises(fb.ModelError, match="needs its length"):
        fb.System.from_text("""
bodies: {cart: {particle: {mass: 1 kg}}}
loads: {buffer: {spring: {first: ground.O, second: cart, stiffness: 5 N/m, only: compressed}}}
""")


def test_derivation_of_the_deepest_point_tells_when_the_buffer_is_touched() -> None:
    told = " ".join(str(cart().explain("greatest x")).split())
    assert "buffer is touched when its ends are as far apart as it is long without load" in told
    assert "buffer is compressed: it can only push" in told
    assert "defect" not in told


def test_two_free_carts_press_the_buffer_between_them_by_the_speed_at_which_they_meet() -> None:
    """With the momentum kept, s = x1 - x2 swings by mu s'' = -k s, mu = m1 m2/(m1 + m2): it turns at v0 sqrt(mu/k),
    and the carts part after half a period as after an elastic impact. Gross et al., TM 3, ch. 2."""
    system = fb.System.from_text("""
parameters: {m1: 1 kg, m2: 2 kg, k: 100 N/m, v0: 2 m/s, L: 0.5 m, d: 1 m}
bodies: {first: {particle: {mass: m1}}, second: {particle: {mass: m2}}}
connections: {rail: {slider: {body: first, along: right}}, track: {slider: {body: second, along: right}}}
loads: {buffer: {spring: {first: second, second: first, stiffness: k, length: L, only: compressed}}}
measures: {x1: x of first, x2: x of second}
start: {x1: 0, x2: L + d, rate(x1): v0, rate(x2): 0}
""")
    asked = ["greatest compression of buffer", "greatest force in buffer", "time when buffer is relaxed"]
    solved = system.solve([*asked, "rate of x2 when buffer is relaxed", "compressive force in buffer when x1' = x2'"])
    assert all(answer.expression is not None for answer in solved.answers)
    pressed, force, parted, faster, hardest = solved.answers
    mu, v = 1.0 * 2.0 / 3.0, 2.0
    assert pressed.value == pytest.approx(v * math.sqrt(mu / 100.0), rel=1e-12)
    assert force.value == hardest.value == pytest.approx(v * math.sqrt(mu * 100.0), rel=1e-12)
    assert parted.value == pytest.approx(1.0 / v + math.pi * math.sqrt(mu / 100.0), rel=1e-12)
    assert faster.value == pytest.approx(2 * 1.0 * v / 3.0, rel=1e-12)


def test_a_spring_that_lets_go_has_given_what_friction_takes() -> None:
    """Pressed by s it has k s^2/2, all of which rubs off until the box stands still."""
    text = """
parameters: {m: 2 kg, k: 4000 N/m, s: 0.12 m, l: 0.5 m, mu: 0.3, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}, points: {F: [-l, 0]}}
bodies: {box: {particle: {mass: m}}}
connections: {c: {contact: {between: [box, floor], friction: mu}}}
loads:
  weight: {gravity: g}
  spring: {spring: {between: [ground.F, box], stiffness: k, length: l, only: compressed}}
measures: {x: x of box}
start: {x: -s, rate(x): 0}
"""
    (lost,) = fb.System.from_text(text).solve(["energy lost until rate(x) = 0"]).answers
    assert lost.value == pytest.approx(4000 * 0.12**2 / 2, rel=1e-9), lost.reason


@pytest.mark.parametrize(
    ("m", "k", "a", "d", "l"),
    [
        (3.728984117861538, 2590.0301652597136, 0.9786228973399704, 2.8585398970599694, 0.4588182191688439),
        (4.93727928591942, 2151.5619235719114, 2.7941239053819853, 8.363787268432459, 0.5305058241673395),
    ],
)
def test_no_step_leaps_over_a_buffer(m: float, k: float, a: float, d: float, l: float) -> None:  # noqa: E741
    """Under a constant force steps grow until one has most of its stages before and behind the buffer, which is reached
    at d = a t^2/2."""
    system = fb.System.from_text(f"""
parameters: {{m: {m} kg, k: {k} N/m, l: {l} m, d: {d} m, a: {a} m/s^2}}
ground: {{points: {{wall: [d + l, 0]}}}}
bodies: {{crate: {{particle: {{mass: m}}}}}}
connections: {{line: {{slider: {{body: crate, along: right}}}}}}
loads:
  pull: {{force: {{at: crate, along: right, magnitude: m*a}}}}
  buffer: {{spring: {{first: ground.wall, second: crate, stiffness: k, length: l, only: compressed}}}}
measures: {{x: x of crate}}
start: {{x: 0, rate(x): 0}}
""")
    course = fb.simulate(system, 60.0, method="dop853", tolerance=1e-9)
    reached = next(event for event in course.events if event.name == "buffer is reached")
    assert reached.time == pytest.approx(math.sqrt(2 * d / a), rel=1e-8)
