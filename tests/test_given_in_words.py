"""A mistake in what is given beside a file is told without a place in the file."""

from __future__ import annotations

from pathlib import Path

import pytest

import freebody as fb
from freebody.errors import InputError, ModelError

FILE = Path(__file__).parents[1] / "examples" / "simple_pendulum.yaml"


@pytest.fixture(scope="module")
def pendulum() -> fb.System:
    return fb.System.load(FILE)


def test_a_mistake_in_a_question_has_no_place_in_the_file(pendulum: fb.System) -> None:
    with pytest.raises(ModelError) as told:
        pendulum.question("acceleration of thta")
    assert str(told.value) == "thta is no measure, body or point. Did you mean theta?"


def test_a_mistake_in_a_value_is_told_with_the_name_of_its_parameter(pendulum: fb.System) -> None:
    with pytest.raises(ModelError) as told:
        pendulum.with_parameters(L="0,6 m")
    assert str(told.value).startswith("L: the unit ',6 m' cannot be read: decimals stand after a point, as in 0.5")


def test_what_a_value_breaks_elsewhere_has_its_place(pendulum: fb.System) -> None:
    with pytest.raises(ModelError, match=r"simple_pendulum\.yaml:\d+:\d+: connections"):
        pendulum.with_parameters(L="5 kg")


def test_a_slip_in_the_name_of_an_event_is_told_as_one(pendulum: fb.System) -> None:
    with pytest.raises(InputError) as told:
        pendulum.simulate(1.0, events=["thta = 0"])
    assert str(told.value) == "event 'thta = 0': there is no measure thta. Did you mean theta?"
