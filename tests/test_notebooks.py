"""In a notebook: what shows itself, and what there is to be found."""

from __future__ import annotations

from pathlib import Path

import pytest

import freebody as fb

EXAMPLES = Path(__file__).parents[1] / "examples"


def test_a_system_shows_its_title_and_its_picture() -> None:
    shown = fb.System.load(EXAMPLES / "atwood_machine.yaml")._repr_html_()
    assert "Atwood machine" in shown
    assert "<svg" in shown


def test_a_title_is_no_markup() -> None:
    text = (EXAMPLES / "yo_yo.yaml").read_text("utf-8").replace("title: Yo-yo on a vertical string", "title: a <b> c")
    assert "a &lt;b&gt; c" in fb.System.from_text(text)._repr_html_()


def test_a_system_that_cannot_be_drawn_says_why() -> None:
    text = """
bodies: {a: {particle: {mass: 1 kg}}}
connections: {one: {link: [ground.O, a, 1 m]}, two: {link: [ground.O, a, 2 m]}}
"""
    shown = fb.System.from_text(text)._repr_html_()
    assert "<svg" not in shown
    assert "one" in shown


def test_a_picture_shows_itself() -> None:
    assert fb.System.load(EXAMPLES / "yo_yo.yaml").picture()._repr_svg_().startswith("<svg")


@pytest.mark.parametrize("name", ["System", "Disk", "Pin", "Gravity", "Gearmesh", "solve", "simulate", "__version__"])
def test_the_package_lists_what_it_has(name: str) -> None:
    names = {listed.lower() for listed in dir(fb)}
    assert name.lower() in names


def test_everything_listed_is_there() -> None:
    for name in dir(fb):
        assert hasattr(fb, name), name


def crank() -> fb.System:
    return fb.System.load(EXAMPLES / "slider_crank.yaml")


def test_a_system_shows_its_parameters_and_questions() -> None:
    shown = crank()._repr_html_()
    assert "T = 5 N m" in shown
    assert "<li>velocity of piston along right</li>" in shown


def test_a_system_offers_its_forms_together() -> None:
    system = crank()
    assert system._repr_mimebundle_() == {"text/plain": repr(system), "text/html": system._repr_html_()}


def test_drawn_without_a_path_it_is_a_picture() -> None:
    assert crank().draw()._repr_svg_() == crank().picture()._repr_svg_()  # type: ignore[union-attr]
    assert crank().draw(free=["rod"])._repr_svg_().startswith("<svg")  # type: ignore[union-attr]
    assert repr(crank().draw()).startswith("<Picture 'Slider-crank'")


def test_an_answer_shows_its_formula() -> None:
    answer = fb.System.load(EXAMPLES / "yo_yo.yaml").solve("acceleration of y")["q1"]
    bundle = answer._repr_mimebundle_()
    assert set(bundle) == {"text/plain", "text/html", "text/latex"}
    assert bundle["text/latex"] == r"$\displaystyle \frac{2 g}{3}$"
    assert "<math" in bundle["text/html"]
    assert "valid" in bundle["text/plain"]
    assert str(answer) == bundle["text/plain"]


def test_a_motion_plots_and_plays_without_a_path(tmp_path: Path) -> None:
    run = crank().simulate(0.1)
    assert run.plot()._repr_svg_().startswith("<svg")
    film = run.animate()
    assert "<iframe srcdoc=" in film._repr_html_()
    assert film.write(tmp_path / "a.html").read_text("utf-8") == film.text()
    assert run.animate(tmp_path / "b.html") == tmp_path / "b.html"
    top = fb.System.load(EXAMPLES / "spinning_top.yaml").simulate(0.01).animate()
    assert "<iframe srcdoc=" in top._repr_html_()
    with pytest.raises(fb.InputError, match="positive"):
        run.animate(speed=0.0)


def test_a_model_in_the_making_shows_itself() -> None:
    model = fb.Model("rod")
    rod = model.body("rod", fb.Rod("1 kg", "1 m"))
    model.connect("pin", fb.Pin("ground.O", rod.start))
    assert "<svg" in model._repr_html_()
    assert repr(model) == "<Model 'rod': 1 bodies, 1 connections>"


def test_a_result_in_a_console_is_called_by_its_system() -> None:
    assert repr(crank().mobility()) == "<Mobility of 'Slider-crank': print() shows it>"
    assert len(repr(crank().mobility().report)) < 80
