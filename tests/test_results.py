"""Results say themselves in blocks, and so in every format."""

from __future__ import annotations

import inspect
import json
import re
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from xml.etree import ElementTree

import pytest
from markdown_it import MarkdownIt

import freebody as fb
import freebody.study as freebody_study
from command import freebody
from freebody.present.report.blocks import Entries, Entry, Equations, Report, Section, Table
from freebody.present.report.latex_text import latex_words
from freebody.present.report.result import Result
from freebody.studies import STUDIES, Option, study

EXAMPLES = Path(__file__).parents[1] / "examples"


def fitted() -> Result:
    """A cart's acceleration from three places."""
    model = "parameters: {m: 1 kg, F: 1 N}\nbodies: {cart: {particle: {mass: m}}}\nmeasures: {x: x of cart}\n"
    model += "loads: {push: {force: {at: cart, along: right, magnitude: F}}}\nstart: {x: 0, rate(x): 0}\ntitle: Cart"
    with TemporaryDirectory() as folder:
        data = Path(folder) / "data.csv"
        data.write_text("t,x\n0,0\n1,1.1\n2,3.9\n", encoding="utf-8")
        return fb.System.from_text(model).fit(data, ["F"])


RESULTS: dict[str, tuple[str, Callable[[fb.System], Result]]] = {
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
    "turn": ("slider_crank", lambda system: system.over_a_turn("theta", rate=5.0, n=24)),
    "sweep": ("atwood_machine", lambda system: system.sweep({"m1": "1..3 kg:3"})),
    "fit": ("atwood_machine", lambda _system: fitted()),
    "optimise": ("atwood_machine", lambda system: system.optimise("tension", over={"m1": "1..4 kg"}, starts=4)),
    "gradient": ("atwood_machine", lambda system: system.gradient(["tension"])),
    "sensitivity": (
        "atwood_machine",
        lambda system: system.sensitivity({"m1": "2..4 kg", "M": "1..2 kg"}, find=["tension"], sample="saltelli:64"),
    ),
    "speeds": ("planetary_gear_by_teeth", lambda system: system.speed_table(efficiency=0.98)),
    "simulate": ("bouncing_ball", lambda system: system.simulate(1.0)),
    "phases": ("block_on_rough_incline", fb.System.phases),
    "check": ("yo_yo", lambda system: system.check("acceleration", "g/2")),
}
found: dict[str, Result] = {}


def result_of(study: str) -> Result:
    if study not in found:
        name, run = RESULTS[study]
        found[study] = run(fb.System.load(EXAMPLES / f"{name}.yaml"))
    return found[study]


def entries_of(report: Report) -> list[Entry]:
    inner = [block for section in report.blocks if isinstance(section, Section) for block in section.blocks]
    return [e for block in (*report.blocks, *inner) if isinstance(block, Entries) for e in block.entries]


@pytest.mark.parametrize("study", RESULTS)
def test_every_result_is_a_report_in_every_format(study: str, tmp_path: Path) -> None:
    result = result_of(study)
    assert result.report.is_summary
    title = result.report.title
    html = result.to_html()
    ElementTree.fromstring(html[html.index("<main") : html.index("</main>") + 7])
    assert f"<h1>{title}</h1>" in html
    for suffix in (".html", ".md", ".tex", ".ipynb", ".txt"):
        path, *_pictures = result.write(tmp_path / f"a{suffix}")
        assert (latex_words(title) if suffix == ".tex" else title) in path.read_text(encoding="utf-8")
    assert (tmp_path / "a.txt").read_text(encoding="utf-8") == result.to_text()
    markdown = MarkdownIt("commonmark").enable("table").render((tmp_path / "a.md").read_text(encoding="utf-8"))
    n_tables = html.count("<table>") + html.count('<dl class="entries">')
    assert markdown.count("<table>") == n_tables
    latex = (tmp_path / "a.tex").read_text(encoding="utf-8")
    assert latex.count(r"\begin{tabular}") == latex.count(r"\bottomrule")
    assert latex.count(r"\begin{tabular}") + latex.count(r"\begin{description}") == n_tables
    json.dumps(result.to_plain(), default=float)


@pytest.mark.parametrize("study", RESULTS)
def test_what_is_labelled_is_said_in_the_terminal_and_on_the_page(study: str) -> None:
    result = result_of(study)
    text, html = " ".join(result.to_text().split()), result.to_html()
    for entry in entries_of(result.report):
        for words in (piece for each in entry.texts for piece in each if isinstance(piece, str)):
            assert " ".join(words.split()) in text
        assert not entry.label or f"<dt>{entry.label}</dt>" in html


def test_an_answer_has_its_formula_its_value_and_where_it_holds() -> None:
    report = result_of("solve").report
    sections = {section.title[0]: section for section in report.blocks if isinstance(section, Section)}
    assert "Phases" in sections
    (time,) = (s for s in sections.values() if "time when block stops" in s.title[-1])
    formula, said = time.blocks
    assert isinstance(formula, Equations)
    assert isinstance(said, Entries)
    assert [entry.label for entry in said.entries] == ["value", "valid", "note", "evidence"]


def test_reactions_are_a_table_with_the_use_of_friction_where_that_is_known() -> None:
    blocks = result_of("statics").report.blocks
    (table,) = (b for s in blocks if isinstance(s, Section) for b in s.blocks if isinstance(b, Table))
    assert [cell[0] for cell in table.header] == ["where", "what", "force", "used of friction"]


def test_a_result_is_written_from_the_command_line(tmp_path: Path) -> None:
    out = tmp_path / "a.html"
    done = freebody("modes", str(EXAMPLES / "simple_pendulum.yaml"), "-o", str(out))
    assert done.returncode == 0
    assert done.stdout.strip() == f"wrote {out}"
    assert re.search("Mode 1: <math.*?<mi>ω</mi>", out.read_text(encoding="utf-8"))
    done = freebody("modes", str(EXAMPLES / "simple_pendulum.yaml"), "-o", str(tmp_path / "a.xyz"))
    assert done.returncode == 2
    assert "must end in one of" in done.stderr


# -- the table of studies ---------------------------------------------------------------------
@pytest.mark.parametrize("name", STUDIES)
def test_a_line_of_the_table_is_the_signature_of_its_study(name: str) -> None:
    line = inspect.signature(getattr(fb.System, name))
    function = inspect.signature(getattr(fb, name))
    said = {p.name: (p.kind, p.default) for p in list(line.parameters.values())[1:] if p.kind is not p.VAR_KEYWORD}
    own = {p.name: (p.kind, p.default) for p in list(function.parameters.values())[1:]}
    assert said == {key: own[key] for key in said}
    assert {option.parameter for option in STUDIES[name].options} <= said.keys()
    assert STUDIES[name].help.endswith(".")


def test_the_derivations_of_answers_are_data_too() -> None:
    done = freebody("explain", "examples/atwood_machine.yaml", "--find", "tension", "--language", "de", "--json")
    assert done.returncode == 0, done.stderr
    document = json.loads(done.stdout)
    (answer,), (derivation,) = document["answers"], document["derivations"]
    assert derivation["id"] == answer["id"]
    lines = [line for stage in (*document["opening"], *derivation["stages"]) for line in stage["lines"]]
    assert any("(1)" in line for line in lines)
    assert any("✗  (a)" in line for line in lines)


TOTAL_MASS = '''"""Total mass: what the moving bodies have together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from freebody.errors import InputError
from freebody.language.expression import Expr, add
from freebody.language.notation import to_python
from freebody.present.report.blocks import Equation, Equations, Formula, Report
from freebody.present.report.result import Result
from freebody.present.report.results import summary
from freebody.system.system import System


@dataclass(frozen=True)
class TotalMass(Result):
    system: System
    mass: Expr

    def to_plain(self) -> dict[str, Any]:
        return {"mass": to_python(self.mass)}

    @property
    def report(self) -> Report:
        return summary(self.system.title, [Equations((Equation(Formula((self.mass,), unit="kg")),))])


def total_mass(system: System, without: Sequence[str] = ()) -> TotalMass:
    bodies = {body.name: body for body in system.moving}
    for name in without:
        if name not in bodies:
            raise InputError(f"there is no body {name}")
    return TotalMass(system, add(*(body.mass for name, body in bodies.items() if name not in without)))
'''


def test_a_new_study_is_one_file_and_its_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "total_mass.py").write_text(TOTAL_MASS, encoding="utf-8")
    monkeypatch.setattr(freebody_study, "__path__", [*freebody_study.__path__, str(tmp_path)])
    option = Option("without", ("--without",), "Leave this body out.", list[str], metavar="BODY", is_list=True)

    @study("freebody.study.total_mass", "mass", busy="adding up masses", options=[option])
    def total_mass(self: fb.System, without: Sequence[str] = ()) -> Result:
        """Add up the masses of the moving bodies."""
        ...

    monkeypatch.setattr(fb.System, "total_mass", total_mass, raising=False)
    file = "examples/atwood_machine.yaml"
    try:
        test_a_line_of_the_table_is_the_signature_of_its_study("total_mass")
        system = fb.System.load(EXAMPLES / "atwood_machine.yaml")
        assert total_mass(system).to_plain() == fb.total_mass(system).to_plain() == {"mass": "M + m1 + m2"}
        assert total_mass(system, ["left"]).to_text() == freebody("mass", file, "--without", "left").stdout
        assert json.loads(freebody("mass", file, "--json").stdout) == {"mass": "M + m1 + m2"}
        assert freebody("mass", file, "--without", "middle").returncode == 2
        assert "Add up the masses" in freebody("--help").stdout
        assert "BODY" in freebody("mass", "--help").stdout
        for suffix in (".html", ".md", ".tex", ".ipynb", ".txt"):
            assert freebody("mass", file, "-o", str(tmp_path / f"a{suffix}")).returncode == 0
            assert system.title in (tmp_path / f"a{suffix}").read_text(encoding="utf-8")
    finally:
        STUDIES.pop("total_mass")
        sys.modules.pop("freebody.study.total_mass", None)


def test_every_study_is_a_function_of_the_package_by_its_name() -> None:
    assert set(STUDIES) <= set(fb.__all__)
    assert all(getattr(fb, name).__name__ == name for name in STUDIES)
