"""The reference is written from the kinds: nothing is left out, all examples run, and links to its pages lead there."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import pytest

import freebody as fb
from freebody.connections.base import Connection
from freebody.loads.base import Load
from freebody.model.phrases import PHRASES
from freebody.model.shapes.base import Shape
from freebody.questions.base import Quantity
from freebody.questions.forms import FORMS
from freebody.studies import STUDIES

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "tools"))

from reference import pages  # noqa: E402
from reference.descriptions import FAMILIES, model_of  # noqa: E402
from reference.page import NothingSaid, Page, prose  # noqa: E402
from reference.units import listening  # noqa: E402


@pytest.fixture(scope="module")
def written() -> dict[str, Page]:
    """Written once: it runs every example."""
    return {page.name: page for page in pages()}


def headings(page: Page) -> list[str]:
    return re.findall(r"^#{2,3} (.*)$", page.text, re.MULTILINE)


def own(kinds: object) -> list[str]:
    return [k for k, c in dict(kinds).items() if c.__module__.startswith("freebody.")]  # type: ignore[call-overload]


def test_every_kind_has_its_section(written: dict[str, Page]) -> None:
    for name, kinds in (("bodies", Shape.kinds), ("connections", Connection.kinds), ("loads", Load.kinds)):
        assert headings(written[name]) == [f"`{kind}`" for kind in own(kinds)]
        assert len(written[name].pictures) == 2 * len(own(kinds))
    assert headings(written["measures"]) == [prose(phrase.form) for phrase in PHRASES]
    assert {kind.capitalize() for kind in own(Quantity.kinds)} <= set(headings(written["questions"]))
    for form in FORMS:
        if form.read.__module__.startswith("freebody."):
            assert form.form in written["questions"].text
    asked = headings(written["commands"])
    assert {f"`freebody {study.command}`" for study in STUDIES.values() if study.command} <= set(asked)
    assert "`freebody simulate`" in asked
    assert headings(written["studies"]) == [f"`{name}`" for name in STUDIES]


def test_every_name_of_the_package_is_documented(written: dict[str, Page]) -> None:
    named = set(re.findall(r":: freebody\.(\w+)", written["python"].text))
    assert named == {name for name in dir(fb) if not name.startswith("_")}


def test_links_to_the_reference_lead_to_its_pages(written: dict[str, Page]) -> None:
    for page in [*(ROOT / "docs").rglob("*.md"), ROOT / "README.md"]:
        if "reference" not in page.parts:
            for name in re.findall(r"\]\([^)]*reference/(\w+)\.md", page.read_text(encoding="utf-8")):
                assert name == "index" or name in written, f"{page.name}: {name}"


def test_units_are_those_that_the_reader_asks_for() -> None:
    spring = Load.kinds["spring"]
    with listening(spring) as units:
        fb.System.from_text(spring.example)
    assert units == {"stiffness": "N/m", "length": "m"}


def test_a_kind_without_a_text_or_an_example_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Connection.kinds["pin"], "example", "")
    with pytest.raises(NothingSaid, match="pin"):
        model_of("connections", "pin", Connection.kinds["pin"])
    monkeypatch.undo()
    monkeypatch.setattr(Connection.kinds["pin"], "__doc__", None)
    with pytest.raises(NothingSaid, match="pin"):
        next(iter(page for page in pages_of_connections()))


def pages_of_connections() -> list[Page]:
    from reference.descriptions import pages as described

    return [page for page in described() if page.name == FAMILIES[1].name]


def test_what_markdown_would_read_is_escaped() -> None:
    assert prose("I_x = m*(b^2 + c^2), `a_b*c`, [x]") == r"I\_x = m\*(b^2 + c^2), `a_b*c`, \[x\]"
