"""The sides of a rectangle are what a body lies or rolls on; elsewhere their names are the middles of them."""

from __future__ import annotations

import pytest

import freebody as fb

CARRIED = """
parameters: {m: 3 kg, M: 8 kg, mu: 0.4, F: 20 N, r: 20 cm, b: 40 cm, h: 60 cm, g: 9.81 m/s^2}
bodies:
  cart: {rectangle: {mass: M, SIZE}ABOUT}
  load: {SHAPE}
connections:
  floor: {slider: {body: cart, along: right}}
  deck: {JOINT}
loads: {weight: {gravity: g}, pull: {force: {at: cart, along: right, magnitude: F}}}
"""
SIZE = "width: 2 m, height: 30 cm"
CRATE = "rectangle: {mass: m, width: b, height: h}"
LIES = "contact: {between: [load, SIDE], friction: mu}"


def carried(*, shape: str = CRATE, joint: str = LIES, side: str = "cart.top", size: str = SIZE, about: str = "") -> str:
    text = CARRIED.replace("SHAPE", shape).replace("JOINT", joint).replace("SIDE", side)
    return text.replace("SIZE", size).replace("ABOUT", about)


def solved(text: str, question: str) -> fb.Answer:
    [answer] = fb.System.from_text(text).solve(question).answers
    return answer


@pytest.mark.parametrize("size", [SIZE, "height: 30 cm"], ids=["limited", "endless"])
def test_a_crate_lies_on_the_top_of_a_cart_and_tips_about_its_corner(size: str) -> None:
    """F = (m + M) a; it slips from mu = a/g, and tips from a/g = b/h."""
    answer = solved(carried(size=size), "acceleration of cart at start")
    assert answer.value[0] == pytest.approx(20.0 / 11.0)
    assert "μ ≥ F/(g·(m + M))" in answer.conditions
    assert "F ≤ b·g·(m + M)/h" in answer.conditions


def test_a_crate_that_stands_on_its_bottom_side_slides_down_as_one_that_stands_on_its_corners() -> None:
    """a = g (sin - mu cos)"""
    text = """
parameters: {m: 3 kg, mu: 0.2, theta: 20 deg, b: 40 cm, h: 60 cm, g: 9.81 m/s^2}
ground: {lines: {slope: {along: -theta}}}
bodies: {crate: {rectangle: {mass: m, width: b, height: h}, angle: -theta}}
connections: {c: {contact: {between: [WHAT, slope], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {s: travel of crate along slope}
start: {s: 0}
"""
    found = [solved(text.replace("WHAT", what), "acceleration of s at start") for what in ("crate", "crate.bottom")]
    assert found[0].expression == found[1].expression
    assert found[0].value == pytest.approx(9.81 * (0.3420201433 - 0.2 * 0.9396926208))


def test_a_drum_rolls_on_the_top_of_a_cart() -> None:
    """With the friction force f: f = m a_d, f r = m r^2/2 alpha, a_d = a - alpha r, so f = m a/3."""
    text = carried(shape="disk: {mass: m, radius: r}", joint="rolling: {body: load, on: SIDE}")
    answer = solved(text, "acceleration of cart")
    assert answer.value[0] == pytest.approx(20.0 / (8.0 + 3.0 / 3.0))


def test_a_point_of_ones_own_stays_a_point() -> None:
    text = carried(about=", points: {top: [0, 20 cm]}")
    found = fb.System.from_text(text).solve("acceleration of cart at start")
    assert any("cart.top" in row.name for row in fb.System.from_text(text).rows)
    assert found.answers[0].value[0] != pytest.approx(20.0 / 11.0)  # the crate balances on it


def test_a_side_is_no_direction_but_the_way_that_its_word_says() -> None:
    system = fb.System.from_text("""
bodies: {cart: {rectangle: {mass: 1 kg, width: 2 m, height: 1 m}}, bead: {particle: {mass: 1 kg}}}
connections: {floor: {slider: {body: cart, along: right}}, rail: {slider: {body: bead, along: cart.right, on: cart}}}
loads: {push: {force: {at: bead, along: right, magnitude: 3 N}}}
""")
    assert system.solve("acceleration of bead").answers[0].value[0] == pytest.approx(3.0)


def test_where_a_body_has_several_sides_they_are_named() -> None:
    text = carried(shape="disk: {mass: m, radius: r}", joint="rolling: {body: load, on: cart}")
    with pytest.raises(fb.ModelError, match=r"name the one: cart\.bottom, cart\.right, cart\.top, cart\.left"):
        fb.System.from_text(text)
    with pytest.raises(fb.ModelError, match=r"Did you mean cart\.top\?"):
        fb.System.from_text(text.replace("on: cart}", "on: cart.topp}"))


def test_a_stack_without_places_stands_on_the_floor_whatever_its_contacts_are_called() -> None:
    """Middles at h/2 and h + k/2 over the floor."""
    for over, under in (("a", "b"), ("b", "a")):
        system = fb.System.from_text(f"""
ground: {{lines: {{floor: {{along: right}}}}}}
bodies:
  upper: {{block: {{mass: 3 kg, width: 0.4 m, height: 0.3 m}}}}
  lower: {{block: {{mass: 8 kg, width: 0.8 m, height: 0.6 m}}}}
connections:
  {over}: {{contact: {{between: [upper, lower], friction: 0.4}}}}
  {under}: {{contact: {{between: [lower, floor], friction: 0.2}}}}
loads: {{weight: {{gravity: 9.81 m/s^2}}}}
""")
        places = system.simulate(0.1).dataset["body_position"].sel(axis="y")
        for body, height in (("upper", 0.75), ("lower", 0.3)):
            assert places.sel(body=body).values == pytest.approx(height, abs=1e-9)


def test_a_guided_plank_lies_on_the_roller_under_it_wherever_its_guide_is() -> None:
    """The roller goes half as far as the plank: F = (M + m/4 + m/8) a, and m/2 r^2 alpha needs m a/8 on either side."""
    text = """
parameters: {m: 4 kg, M: 10 kg, r: 0.1 m, F: 30 N, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {roller: {cylinder: {mass: m, radius: r}}, plank: {block: {mass: M, width: 2 m, height: 5 cm}}}
connections:
  guide: {slider: {body: plank, along: right}}
  below: {rolling: {body: roller, on: floor}}
  above: {rolling: {body: roller, on: plank.bottom}}
loads: {weight: {gravity: g}, pull: {force: {at: plank, along: right, magnitude: F}}}
"""
    assert solved(text, "acceleration of plank").value[0] == pytest.approx(30.0 / (10.0 + 1.5))
    heights = fb.System.from_text(text).simulate(0.1).dataset["body_position"].sel(body="plank", axis="y")
    assert heights.values == pytest.approx(0.225, abs=1e-9)
