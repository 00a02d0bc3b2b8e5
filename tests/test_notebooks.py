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
