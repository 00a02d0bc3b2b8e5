"""Results say themselves in blocks, and so in every format."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import pytest
from markdown_it import MarkdownIt

import freebody as fb
from command import freebody
from freebody.present.report.blocks import Entries, Entry, Equations, Report, Section, Table
from freebody.present.report.latex_text import latex_words
from freebody.present.report.results import Result

EXAMPLES = Path(__file__).parents[1] / "examples"
STUDIES: dict[str, tuple[str, Callable[[fb.System], Result]]] = {
    "solve": ("block_on_rough_incline", fb.System.solve),
    "eom": ("simple_pendulum", fb.System.equations_of_motion),
    "mobility": ("four_bar", fb.System.mobility),
    "conserved": ("body_on_driven_roller", fb.System.conserved),
    "equilibria": ("simple_pendulum", fb.System.equilibria),
    "modes": ("two_masses_three_springs", fb.System.modes),
    "statics": ("ladder_against_wall", fb.System.statics),
    "inverse dynamics": (
        "simple_pendulum",
        lambda system: system.inverse_dynamics({"theta": lambda t: (0.3 + t, 1.0, 0.0)}, [0.1 * k for k in range(41)]),
    ),
    "simulate": ("bouncing_ball", lambda system: system.simulate(1.0)),
}
found: dict[str, Result] = {}


def result_of(study: str) -> Result:
    if study not in found:
        name, run = STUDIES[study]
        found[study] = run(fb.System.load(EXAMPLES / f"{name}.yaml"))
    return found[study]


def entries_of(report: Report) -> list[Entry]:
    inner = [block for section in report.blocks if isinstance(section, Section) for block in section.blocks]
    return [e for block in (*report.blocks, *inner) if isinstance(block, Entries) for e in block.entries]


@pytest.mark.parametrize("study", STUDIES)
def test_every_result_is_a_report_in_every_format(study: str, tmp_path: Path) -> None:
    result = result_of(study)
    assert result.report.is_summary
    title = result.report.title
    html = result.to_html()
    ElementTree.fromstring(html[html.index("<main") : html.index("</main>") + 7])
    assert f"<h1>{title}</h1>" in html
    for suffix in (".html", ".md", ".tex", ".ipynb", ".txt"):
        (path,) = result.write(tmp_path / f"a{suffix}")
        assert (latex_words(title) if suffix == ".tex" else title) in path.read_text(encoding="utf-8")
    assert (tmp_path / "a.txt").read_text(encoding="utf-8") == result.to_text()
    markdown = MarkdownIt("commonmark").enable("table").render((tmp_path / "a.md").read_text(encoding="utf-8"))
    n_tables = html.count("<table>")
    assert markdown.count("<table>") == n_tables
    latex = (tmp_path / "a.tex").read_text(encoding="utf-8")
    assert latex.count(r"\begin{tabular}") == latex.count(r"\bottomrule")
    assert latex.count(r"\begin{tabular}") + latex.count(r"\begin{description}") == n_tables
    json.dumps(result.to_plain(), default=float)


@pytest.mark.parametrize("study", STUDIES)
def test_what_is_labelled_is_said_in_the_terminal_and_on_the_page(study: str) -> None:
    result = result_of(study)
    text, html = " ".join(result.to_text().split()), result.to_html()
    for entry in entries_of(result.report):
        for words in (piece for each in entry.texts for piece in each if isinstance(piece, str)):
            assert " ".join(words.split()) in text
        assert not entry.label or f"<strong>{entry.label}</strong>" in html


def test_an_answer_has_its_formula_its_value_and_where_it_holds() -> None:
    report = result_of("solve").report
    sections = {section.title[0]: section for section in report.blocks if isinstance(section, Section)}
    assert "Phases" in sections
    (time,) = (s for s in sections.values() if "time when block stops" in s.title[-1])
    formula, said = time.blocks
    assert isinstance(formula, Equations)
    assert isinstance(said, Entries)
    assert [entry.label for entry in said.entries] == ["value", "valid", "evidence"]


def test_reactions_are_a_table_with_the_use_of_friction_where_that_is_known() -> None:
    blocks = result_of("statics").report.blocks
    (table,) = (b for s in blocks if isinstance(s, Section) for b in s.blocks if isinstance(b, Table))
    assert [cell[0] for cell in table.header] == ["where", "what", "force", "used of friction"]


def test_a_result_is_written_from_the_command_line(tmp_path: Path) -> None:
    out = tmp_path / "a.html"
    done = freebody("modes", str(EXAMPLES / "simple_pendulum.yaml"), "-o", str(out))
    assert done.returncode == 0
    assert done.stdout.strip() == f"wrote {out}"
    assert "Mode 1: omega" in out.read_text(encoding="utf-8")
    done = freebody("modes", str(EXAMPLES / "simple_pendulum.yaml"), "-o", str(tmp_path / "a.xyz"))
    assert done.returncode == 2
    assert "must end in one of" in done.stderr
