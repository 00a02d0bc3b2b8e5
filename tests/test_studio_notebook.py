"""The widget for notebooks, on the side of the kernel: what it says to its page, and what it says of itself."""

from __future__ import annotations

import sys
from typing import Any

import pytest

import freebody as fb
from freebody.errors import InputError
from freebody.studio.work import done

PENDULUM = """# a pendulum
parameters: {L: 1 m, m: 2 kg, g: 9.81 m/s^2}  # what can be moved
bodies:
  rod: {rod: {mass: m, length: L}}  # thin
connections:
  A: {pin: [ground.A, rod.start]}
loads: {weight: {gravity: g}}
measures: {theta: {angle of rod}}
start: {theta: -60 deg}
"""


@pytest.fixture
def widget() -> Any:
    pytest.importorskip("anywidget", reason='NOT RUN: pip install "freebody[notebook]" for the widget of notebooks')
    return fb.System.from_text(PENDULUM).widget(until=2.0)


def asked(widget: Any, name: str, body: dict[str, Any]) -> Any:
    """What the page would be sent."""
    sent: list[dict[str, Any]] = []
    widget.send = sent.append
    widget._handle_custom_msg({"id": [0.5, 7], "name": name, "body": body}, [])
    ((identity, answer),) = [(each["id"], each["answer"]) for each in sent]
    assert identity == [0.5, 7]
    return answer


@pytest.mark.parametrize(
    ("kind", "more"),
    [
        ("read", {}),
        ("motion", {"until": 1.0, "frames": 31}),
        ("curves", {"until": 1.0, "frames": 31}),
        ("drag", {"body": "rod", "grabbed": [0.5, -0.866], "to": [0.8, -0.6]}),
        ("study", {"name": "solve", "options": {"question": "acceleration of theta"}}),
        ("motion", {"until": -1.0}),
    ],
)
def test_the_kernel_answers_as_a_worker_does(widget: Any, kind: str, more: dict[str, Any]) -> None:
    request = {"text": PENDULUM, **more}
    call = {"kind": kind, "topic": kind, "request": request}
    assert asked(widget, "ask", call) == done(kind, request).model_dump(mode="json")


def test_the_page_begins_with_the_text_as_it_stands(widget: Any) -> None:
    assert asked(widget, "open", {})["file"]["text"] == PENDULUM
    widget.text = PENDULUM.replace("L: 1 m", "L: 2 m")
    assert asked(widget, "open", {})["file"]["text"] == widget.text


def test_what_is_changed_by_hand_is_the_system_of_the_widget(widget: Any) -> None:
    widget.text = PENDULUM.replace("L: 1 m", "L: 2 m")
    assert widget.system == fb.System.from_text(PENDULUM).with_parameters(L="2 m")
    assert type(widget.system) is fb.System


def test_what_there_is_no_answer_to_is_a_message_and_not_silence(widget: Any) -> None:
    for name, body in (("file", {"name": "/etc/passwd"}), ("ask", {"kind": "eval", "topic": "x", "request": {}})):
        assert asked(widget, name, body)["status"] == "crashed"


def test_the_page_is_the_built_one_and_needs_no_server(widget: Any) -> None:
    assert 'id="notebook">{"until": 2.0, "language": "en"}' in widget.page
    assert "default-src 'none'" in widget.page


def test_without_the_extra_the_package_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "anywidget", None)
    monkeypatch.delitem(sys.modules, "freebody.studio.notebook", raising=False)
    with pytest.raises(InputError, match=r'needs anywidget; pip install "freebody\[notebook\]"'):
        fb.System.from_text(PENDULUM).widget()
