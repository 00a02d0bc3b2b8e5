"""The documentation says what is so: its commands, code and outputs are run."""

from __future__ import annotations

import ast
import importlib
import importlib.util
import re
import types
from pathlib import Path
from urllib.parse import urlsplit

import pytest

import freebody as fb

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")
GUIDE = {path.name: path.read_text(encoding="utf-8") for path in sorted((ROOT / "docs" / "guide").glob("*.md"))}
PAGES = "\n".join((README, *GUIDE.values()))
PAGES_OF_ALL = [
    ROOT / "README.md",
    *(page for page in sorted((ROOT / "docs").rglob("*.md")) if "reference" not in page.parts),
]
CONTRIBUTING = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")


def blocks(text: str, language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", text, re.DOTALL)


def test_readme_has_the_two_set_up_lines_that_ci_runs() -> None:
    lines = re.findall(r"^python3 -m venv \.venv && .*$", README, re.MULTILINE)
    assert [line.split("&& ", 1)[1].split(" && ")[0] for line in lines] == [
        ".venv/bin/pip install .",
        '.venv/bin/pip install ".[test]"',
    ]
    assert lines[0].endswith(".venv/bin/freebody solve examples/atwood_machine.yaml")
    assert lines[1].endswith(".venv/bin/python -m pytest")


def test_the_model_in_the_guide_solves() -> None:
    (model,) = (block for block in blocks(PAGES, "yaml") if block.startswith("freebody: 1"))
    solution = fb.solve(fb.System.from_text(model))
    assert solution["q1"].choice == "a"


def test_the_contacts_in_the_guide_can_be_read() -> None:
    (connections,) = (block for block in blocks(PAGES, "yaml") if block.startswith("connections:"))
    system = fb.System.from_text(
        connections
        + """
parameters: {mu: 0.3, e: 0.5, T: 1 N m, F: 1 N}
ground: {lines: {floor: {along: right}}}
bodies:
  ball: {sphere: {mass: 1 kg, radius: 0.1 m}}
  bowl: {ring: {mass: 1 kg, radius: 1 m}}
  a: {rectangle: {mass: 1 kg, width: 1 m, height: 1 m}}
  b: {rod: {mass: 1 kg, length: 1 m}}
  wheel: {disk: {mass: 1 kg, radius: 1 m}}
  block: {particle: {mass: 1 kg}}
measures: {theta: angle of b, x: x of block}
"""
    )
    assert {row.connection for row in system.rows} >= {"floor", "all", "bowl", "limit", "drum", "rub", "guide"}


def test_the_tour_is_true_and_names_every_room(monkeypatch: pytest.MonkeyPatch) -> None:
    """Its blocks run one after the other; each folder of the package is a room, named once as such."""
    tour = (ROOT / "docs" / "tour.md").read_text(encoding="utf-8")
    monkeypatch.chdir(ROOT)
    names: dict[str, object] = {}
    for code in blocks(tour, "python"):
        exec(compile(code, "tour.md", "exec"), names)
    rooms = {path.name for path in (ROOT / "src" / "freebody").iterdir() if (path / "__init__.py").exists()}
    named = re.findall(r"\*\*`(\w+)/`\*\*", tour)
    assert sorted(named) == sorted(rooms)


def test_every_kind_is_in_the_guide() -> None:
    from freebody.connections.base import Connection
    from freebody.loads.base import Load

    for kind in [*Connection.kinds, *Load.kinds]:
        if kind != "midpoint":
            assert f"`{kind}`" in PAGES, kind


def test_the_connection_of_contributing_works_as_written() -> None:
    from freebody.connections.base import Connection

    code, _question = blocks(CONTRIBUTING, "python")
    module = types.ModuleType("freebody.connections.midpoint")
    try:
        exec(compile(code, "CONTRIBUTING.md", "exec"), module.__dict__)
        model = module.Midpoint.example + "loads: {f: {force: {at: a, along: right, magnitude: 6 N}}}\n"
        # 2 x_m = x_a + x_b: the reaction is R on a and b and -2 R on m, so m a_a = F + R, a_b = R, a_m = -2 R
        # with a_m = (a_a + a_b)/2 give R = -F/6
        answer = fb.solve(fb.System.from_text(model), "acceleration of m along right")["q1"]
        assert answer.value == pytest.approx(2.0)
        (line,) = (shown.sign for shown in fb.System.from_text(model).glyphs if shown.owner == "it")
        assert [point.body for point in line.points] == ["a", "m", "b"]
    finally:
        Connection.kinds.forget("midpoint")


def test_what_benchmarks_and_tools_import_is_there() -> None:
    """They are no part of the package, and nothing else runs them."""
    missing: list[str] = []
    for path in [*ROOT.glob("benchmarks/**/*.py"), *ROOT.glob("tools/*.py")]:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "freebody":
                try:
                    module = importlib.import_module(str(node.module))
                except ImportError:
                    missing.append(f"{path.name}: {node.module}")
                    continue
                for alias in node.names:
                    if not hasattr(module, alias.name) and not importlib.util.find_spec(f"{node.module}.{alias.name}"):
                        missing.append(f"{path.name}: {node.module}.{alias.name}")
    assert not missing


def test_the_readme_is_read_in_minutes() -> None:
    assert len(README.splitlines()) < 150


@pytest.mark.parametrize("page", PAGES_OF_ALL, ids=lambda page: page.name)
def test_links_lead_somewhere(page: Path) -> None:
    """Those to pages that are written when the site is built are looked at where these are (`test_reference_pages`)."""
    for target in re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8")):
        if "://" not in target and "reference/" not in target:
            assert (page.parent / target).exists(), target


@pytest.mark.parametrize("page", PAGES_OF_ALL, ids=lambda page: page.stem)
def test_links_to_elsewhere_are_well_formed(page: Path) -> None:
    """No network is asked: they are https, to a host with a domain, and end with no stray punctuation."""
    for link in re.findall(r"https?://[^\s)>\]\"'`]+", page.read_text(encoding="utf-8")):
        found = urlsplit(link)
        assert found.scheme == "https", link
        assert re.fullmatch(r"[\w-]+(\.[\w-]+)+", found.netloc), link
        assert not link.endswith((".", ",", ";")), link


def test_every_page_is_on_the_site() -> None:
    index = (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
    pages = [page.relative_to(ROOT / "docs").with_suffix("") for page in PAGES_OF_ALL if page.parent != ROOT]
    assert {page.as_posix() for page in pages} - {"index"} <= set(index.split())


def test_the_drawing_section_of_the_guide_is_read() -> None:
    (section,) = (block for block in blocks(GUIDE["first_model.md"], "yaml") if block.startswith("drawing:"))
    model = """
space: true
parameters: {L: 1 m, theta: 30 deg}
bodies:
  ladder: {rod: {mass: 1 kg, length: L}}
  block: {particle: {mass: 1 kg}}
  shaft: {body: {inertia: 1 kg m^2}, points: {C: [L, 0, 0], B: [L, -L, 0]}}
"""
    looks = fb.System.from_text(model + section).looks
    assert (looks.paths["shaft"], looks.scale["block"]) == (("origin", "C", "B"), 2.0)


def test_the_index_of_the_gallery_keeps_the_cards_of_pages_that_are_not_written_anew() -> None:
    from tools.make_gallery import cards_in, index

    page = (ROOT / "docs" / "gallery" / "index.html").read_text(encoding="utf-8")
    cards = cards_in(page)
    assert sorted(cards) == sorted(path.stem for path in (ROOT / "examples").glob("*.yaml"))
    assert cards_in(index(list(cards.values()))) == cards
