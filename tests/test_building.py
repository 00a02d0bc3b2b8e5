"""Models that are written in Python, and what editors know of them."""

from __future__ import annotations

import inspect
import sys
from pathlib import Path

import pytest

import freebody as fb
from freebody.functions import cos, sin, sqrt
from freebody.language.notation import to_python

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "tools"))

from write_interface import TARGET, interface  # noqa: E402


def ball_on_incline() -> fb.Model:
    model = fb.Model("Ball on an incline")
    m, R, alpha, g = model.parameters(m="2 kg", R="0.1 m", alpha="30 deg", g="9.81 m/s^2")
    incline = model.line("incline", along=-alpha)
    ball = model.body("ball", fb.Sphere(m, R))
    contact = model.connect("contact", fb.Rolling(ball, incline))
    model.load("weight", fb.Gravity(g))
    s = model.measure("s", ball.travel(along=incline))
    model.start({s: 0, s.rate: "1 m/s"})
    model.ask(s.acceleration, options={"a": 5 * g * sin(alpha) / 7, "b": g * sin(alpha)}, key="a")
    model.ask(contact.force("friction force"))
    return model


def test_a_model_of_objects_is_the_one_of_the_file() -> None:
    text = """
title: Ball on an incline
parameters: {m: 2 kg, R: 0.1 m, alpha: 30 deg, g: 9.81 m/s^2}
ground: {lines: {incline: {along: -alpha}}}
bodies: {ball: {sphere: {mass: m, radius: R}}}
connections: {contact: {rolling: [ball, incline]}}
loads: {weight: {gravity: g}}
measures: {s: travel of ball along incline}
start: {s: 0, rate(s): 1 m/s}
questions:
  - {find: acceleration of s, options: {a: 5*g*sin(alpha)/7, b: g*sin(alpha)}, key: a}
  - friction force of contact
"""
    made, read = ball_on_incline().system(), fb.System.from_text(text)
    assert made == read
    solution = made.solve()
    assert solution["q1"].choice == "a"
    # m r^2 2/5 a/r = F r with a = 5/7 g sin(alpha), against the motion
    assert abs(solution["q2"].value) == pytest.approx(2 / 7 * 2 * 9.81 / 2)  # type: ignore[arg-type]


def test_what_is_written_can_be_read_again() -> None:
    made = ball_on_incline().system()
    assert fb.System.from_text(made.to_yaml()) == made


def test_points_measures_and_directions_are_phrases_of_the_language() -> None:
    model = fb.Model()
    L, beta, c = model.parameters(L="1 m", beta="20 deg", c="3 N s/m")
    A = model.point("A", 0, L / 2)
    rod = model.body("rod", fb.Rod("1 kg", L), points={"P": [L / 4, 0]})
    bob = model.body("bob", fb.Particle("1 kg"), at=[L, 0])
    model.connect("pin", fb.Pin(A, rod.start))
    h = model.measure("h", rod.P.height(above=A))
    d = model.measure("d", bob.distance(rod.end))
    model.measure("phi", rod.angle("down", clockwise=True))
    model.measure("psi", A.bearing(bob, counted_from=[1, 2]))
    model.measure("both", h + d)
    model.measure("u", bob.travel(along=-beta, start=A))
    model.load("spring", fb.Spring(A, bob, "5 N/m"))
    model.load("law", fb.Law(d, -c * d.rate))
    written = model.system().to_yaml()
    for phrase in (
        "height of rod.P above ground.A",
        "distance from bob to rod.end",
        "angle of rod from down clockwise",
        "angle of line from ground.A to bob from [1, 2]",
        "expression: h + d",
        "travel of bob along -beta from ground.A",
    ):
        assert phrase in written


def test_mistakes_are_told_together_when_the_model_is_read() -> None:
    model = fb.Model()
    rod = model.body("rod", fb.Rod("1 kg", "2 kg"))
    model.connect("pin", fb.Pin("ground.A", rod.strat))
    with pytest.raises(fb.ModelError, match=r"(?s)strat.*length|length.*strat"):
        model.system()


def test_functions_make_formulas() -> None:
    model = fb.Model()
    F, Omega = model.parameters(F="1 N", Omega="2 rad/s")
    assert to_python(F * cos(Omega * model.time) / sqrt(2)) == "F*cos(Omega*t)/sqrt(2)"


def test_the_interface_for_editors_is_current() -> None:
    assert TARGET.read_text(encoding="utf-8") == interface(), "run python tools/write_interface.py"


def test_descriptions_show_their_fields() -> None:
    assert list(inspect.signature(fb.Pin).parameters) == ["first", "second", "friction", "radius", "further"]
    assert inspect.signature(fb.Box).parameters["size"].kind is inspect.Parameter.KEYWORD_ONLY
    assert fb.Box("1 kg", ["1 m", "1 m", "1 m"]).size == ["1 m", "1 m", "1 m"]
    with pytest.raises(TypeError, match="first twice"):
        fb.Pin("a.P", "b.P", first="c.P")


def test_what_one_tries_first_in_python_is_told() -> None:
    model = fb.Model("a rod")
    with pytest.raises(TypeError, match=r"parameters are given by model.parameters\(m='2 kg'\)"):
        fb.Model("a rod", m="2 kg")
    with pytest.raises(TypeError, match=r"model.body\('rod', fb.Rod\(mass=2, length=1\)\)"):
        model.body("rod", mass=2, length=1)
    with pytest.raises(AttributeError, match=r"write model.load\(name, fb.Gravity\(strength\)\)"):
        model.gravity("9.81 m/s^2")
    with pytest.raises(TypeError, match="a connection needs a name"):
        model.connect(fb.Pin("ground", "rod"))
    with pytest.raises(TypeError, match=r"model.line\(name, along=...\)"):
        model.ground.line("slope", 1)
    with pytest.raises(TypeError, match=r"freebody.solve\(freebody.System.load\('m.yaml'\)"):
        fb.solve("m.yaml")
    with pytest.raises(AttributeError, match=r"no attribute 'Block': write freebody\."):
        fb.Block(mass=1)
    with pytest.raises(TypeError, match="from_data"):
        fb.System()


def test_results_are_read_by_the_names_that_they_have() -> None:
    from freebody import cos

    model = fb.Model("pendulum")
    m, L, g = model.parameters(m="2 kg", L="1 m", g="9.81 m/s^2")
    bob = model.body("bob", fb.Particle(m))
    model.connect("link", fb.Link(model.ground.O, bob, L))
    model.load("weight", fb.Gravity(g))
    theta = model.measure("theta", model.ground.O.bearing(bob, "down"))
    model.start(theta="0.2 rad")
    system = model.system()
    solution = system.solve("acceleration of theta")
    assert [(key, answer.id) for key, answer in solution.items()] == [("q1", "q1")]
    assert [*solution] == ["q1"]
    assert solution[0] is solution["q1"]
    assert system.modes().frequencies == pytest.approx((9.81**0.5,))
    run = system.simulate(1.0)
    assert run["theta"][0] == pytest.approx(0.2)
    assert run["t"][-1] == pytest.approx(1.0)
    assert run["rate(theta)"][0] == pytest.approx(0.0)
    with pytest.raises(KeyError, match="there is t, theta"):
        run["phi"]
    assert str(m * g * cos(theta))


def test_symbols_may_be_named_without_values() -> None:
    """As SymPy's `symbols`: their units are those with which they are used."""
    model = fb.Model()
    M, k, g = model.parameters("M, k", g="9.81 m/s^2")
    cart = model.body("cart", fb.Particle(M))
    model.connect("rail", fb.Slider(cart, "right"))
    model.load("spring", fb.Spring(model.ground, cart, k))
    model.load("weight", fb.Gravity(g))
    x = model.measure("x", cart.x)
    model.ask(x.acceleration)
    system = model.system()
    assert str(system.parameters["k"].dimension) == "N/m"
    assert system.measures["x"] == fb.System.from_text(system.to_yaml()).measures["x"]


def test_what_one_tries_first_says_what_to_write() -> None:
    model = fb.Model()
    with pytest.raises(AttributeError, match=r"write model.body\(\.\.\.\)"):
        model.add_body("a", fb.Particle("1 kg"))
    with pytest.raises(AttributeError, match=r"write model.connect\(\.\.\.\)"):
        model.add_joint()
    with pytest.raises(TypeError, match="when='y = 0'"):
        model.ask("x of ball", when=False)  # type: ignore[arg-type]
    system = ball_on_incline().system()
    with pytest.raises(TypeError, match=r"system.with_parameters\(R='0.2 m'\)"):
        system.parameters["R"] = "0.2 m"  # type: ignore[index]
