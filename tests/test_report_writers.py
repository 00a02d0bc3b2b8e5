"""Reports in every format: what each can do, and that words stay words."""

import base64
import json
import re
import shutil
import subprocess
import sys
from dataclasses import replace
from html.parser import HTMLParser
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
from markdown_it import MarkdownIt

from freebody.errors import InputError
from freebody.language.expression import Number
from freebody.language.parser import parse
from freebody.narrative.telling.catalogue import Catalogue
from freebody.present.report import formats
from freebody.present.report.blocks import (
    Columns,
    Difference,
    Entries,
    Entry,
    Equation,
    Equations,
    Formula,
    Paragraph,
    Report,
    Section,
    Table,
    equation_numbers,
    text,
)
from freebody.present.report.formats.html import html_fragment, html_page
from freebody.present.report.formats.latex import latex_document, latex_fragment
from freebody.present.report.formats.markdown import markdown_files
from freebody.present.report.formats.notebook import notebook_text
from freebody.present.report.formats.terminal import columns, terminal_text
from freebody.present.report.formats.typst import pdf_bytes, typst_files
from freebody.present.report.formulas.latex import LatexFormulas
from freebody.present.report.formulas.line import LineFormulas
from freebody.present.report.formulas.mathml import MathMLFormulas
from freebody.present.report.formulas.rows import rows
from freebody.present.report.formulas.stacked import StackedFormulas
from freebody.present.report.formulas.typst import TypstFormulas
from freebody.present.report.latex_text import latex_words, web_words
from freebody.present.report.typeset import typeset
from freebody.present.report.write import check_report_path, report_formats, write_report
from freebody.present.report.writer import ReportFormat
from report_sample import HOSTILE, LAGRANGE, formula, hostile, sample, vector

needs_pdflatex = pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")
needs_typst = pytest.mark.skipif(find_spec("typst") is None, reason="typst is not installed")


# -- formulas -------------------------------------------------------------------------------------
def test_lagranges_equation_in_every_format() -> None:
    equation = Formula((LAGRANGE, parse("0")), ("=",))
    assert LineFormulas().formula(equation) == "d/dt(∂L/∂θ₁') - ∂L/∂θ₁ = 0"
    assert LatexFormulas().formula(equation) == (
        r"\frac{\mathrm{d}}{\mathrm{d}t}\left(\frac{\partial L}{\partial \dot{\theta}_{1}}\right) - "
        r"\frac{\partial L}{\partial \theta_{1}} = 0"
    )
    assert TypstFormulas().formula(equation) == (
        "frac(upright(d) , upright(d) t) (frac(∂ L, ∂ dot(θ)_(1))) - frac(∂ L, ∂ θ_(1)) = 0"
    )
    assert StackedFormulas().formula(equation).lines[1] == "──⎜────⎟ - ─── = 0"
    ElementTree.fromstring(f"<math>{MathMLFormulas().formula(equation)}</math>")


def test_units_are_upright_with_raised_exponents() -> None:
    speed = formula("v", "=", "2", unit="m/s^2")
    assert LatexFormulas().formula(speed) == r"v = 2\,\mathrm{m/s^{2}}"
    assert LineFormulas().formula(speed) == "v = 2 m/s²"
    assert TypstFormulas().formula(speed) == 'v = 2 thin "m/""s"^(2)'
    assert '<msup><mi mathvariant="normal">s</mi><mn>2</mn></msup>' in MathMLFormulas().formula(speed)
    assert LineFormulas().formula(formula("a", "=", "30", unit="°")) == "a = 30°"
    assert LineFormulas().formula(formula("J", "=", "2", unit="kg m^2")) == "J = 2 kg m²"


def test_a_sum_before_a_unit_and_a_sum_that_is_subtracted_have_brackets() -> None:
    assert LineFormulas().formula(formula("x", "=", "1 + a", unit="m")) == "x = (1 + a) m"
    difference = Difference(parse("a"), Difference(parse("b"), Number(-parse("3").value)))  # type: ignore[union-attr]
    assert LineFormulas().side(difference) == "a - (b - (-3))"


def test_vectors_are_columns() -> None:
    r = Formula((vector("x", "-y", "0"),))
    assert LatexFormulas().formula(r) == r"\begin{pmatrix}x \\ -y \\ 0\end{pmatrix}"
    assert StackedFormulas().formula(r).lines == ("⎛x ⎞", "⎜-y⎟", "⎝0 ⎠")
    assert MathMLFormulas().formula(r).count("<mtr>") == 3
    assert TypstFormulas().formula(r) == "vec(x, -y, 0)"


def test_a_long_formula_is_broken_at_relations_and_then_at_signs() -> None:
    short = formula("a", "=", "b", "=", "c")
    assert len(rows(short, 40)) == 1
    long = formula("a", "=", " - ".join(f"b_{k}" for k in range(12)), "≈", "c", unit="N")
    broken = rows(long, 30)
    assert [row.right[0][0] for row in broken] == ["=", "-", "-", "≈"]
    assert [row.unit for row in broken] == ["", "", "", "N"]
    terms = [LineFormulas().side(side) for row in broken[:3] for _, side in row.right]
    assert " - ".join(terms) == LineFormulas().side(long.sides[1])


# -- HTML -----------------------------------------------------------------------------------------
class Page(HTMLParser):
    """What a browser sees: elements, names, links and the text outside of scripts and styles."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.words: list[str] = []
        self.open: list[str] = []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))
        if tag not in ("meta", "br", "path", "rect", "mspace"):
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if not self.open or self.open[-1] not in ("script", "style"):
            self.words.append(data)

    def count(self, tag: str) -> int:
        return sum(name == tag for name, _ in self.elements)


def test_html_is_one_page_that_needs_nothing_else() -> None:
    text = html_page(sample())
    page = Page(text)
    assert page.open == []
    assert page.count("script") == 1
    assert {tag for tag, _ in page.elements} >= {
        "main",
        "section",
        "h1",
        "h2",
        "h3",
        "figure",
        "figcaption",
        "th",
        "svg",
    }
    assert not re.search(r'(src|href)="(?!#)', text)
    for found in re.findall(r"<math.*?</math>", text):
        ElementTree.fromstring(found)


def test_html_references_lead_to_equations_and_figures_that_exist() -> None:
    page = Page(html_page(sample()))
    names = {attrs["id"] for _, attrs in page.elements if "id" in attrs}
    links = {(attrs["href"] or "").removeprefix("#") for tag, attrs in page.elements if tag == "a"}
    assert links <= names
    assert {f"eq-{n}" for n in equation_numbers(sample().blocks)} <= names
    assert "section-1" in links  # the contents


def test_html_steps_are_closed_until_opened_and_hints_are_seen() -> None:
    text = html_page(sample("de"))
    page = Page(text)
    assert page.count("details") == 2
    assert 'lang="de"' in text
    assert "<details open" not in text
    assert text.index("Hinweis") < text.index("Schritt zeigen") < text.index("cut free")


def test_html_fragment_has_a_style_of_its_own_and_no_script() -> None:
    text = html_fragment(sample())
    page = Page(text)
    assert page.count("script") == page.count("html") == page.count("main") == 0
    css = re.search("<style>(.*?)</style>", text, re.DOTALL)
    assert css is not None
    assert css[1].strip().startswith(".freebody-report {")
    other = html_fragment(replace(sample(), title="Another"))
    assert set(re.findall(r' id="(r\w+-[\w-]+)"', text)).isdisjoint(re.findall(r' id="(r\w+-[\w-]+)"', other))


def test_html_table_says_right_and_wrong_in_words() -> None:
    text = html_page(sample())
    assert 'aria-label="right">✓' in text
    assert 'aria-label="wrong">✗' in text
    assert text.count('<th scope="col">') == 3


def test_hostile_words_stay_words_in_html() -> None:
    page = Page(html_page(hostile()))
    assert page.count("script") == 1
    assert "".join(page.words).count(HOSTILE) > 20


# -- the other formats ----------------------------------------------------------------------------
def test_markdown_has_formulas_tags_files_and_folded_steps() -> None:
    text, files = markdown_files(sample(), "disk")
    assert list(files) == [f"disk-figures/{k}.svg" for k in (1, 2, 3)]
    assert all(f"]({name})" in text for name in files)
    assert all(rf"\tag{{{n}}}" in text for n in range(1, 9))
    assert text.count("<details>") == text.count("</details>") == 2
    assert "$F_{r}$" in text
    assert "| ✓ | B |" in text
    for block in re.findall(r"\$\$\n.*?\n\$\$", text, re.DOTALL):
        assert "<" not in block
        assert "\n\n" not in block


def test_hostile_words_stay_words_in_markdown() -> None:
    text, _ = markdown_files(hostile(), "disk")
    page = Page(MarkdownIt("commonmark", {"html": True}).enable("table").render(text))
    assert {tag for tag, _ in page.elements} <= {
        *(
            "h1",
            "h2",
            "p",
            "ul",
            "li",
            "table",
            "thead",
            "tbody",
            "tr",
            "th",
            "td",
            "img",
            "strong",
            "em",
            "code",
            "hr",
        ),
        *("details", "summary", "blockquote", "br"),
    }
    assert "".join(page.words).count(HOSTILE) > 20
    assert "$x$" not in text.replace("$$", "")


@pytest.mark.parametrize(
    "line", ["1. a", "- a", "+ a", "# a", "> a", "= a", "* a", "a\n\n    b", "[a]: b", "12) c", "---", "==="]
)
def test_a_paragraph_of_markdown_that_begins_like_something_else_is_a_paragraph(line: str) -> None:
    report = Report("t", "en", "", (Paragraph((line,)),), {})
    page = Page(MarkdownIt("commonmark").render(markdown_files(report, "x")[0]))
    assert [tag for tag, _ in page.elements] == ["h1", "p"]


def test_latex_numbers_and_references_are_those_of_the_report() -> None:
    text = latex_document(sample("de"))
    assert "[ngerman]{babel}" in text
    assert all(rf"\tag{{{n}}}\label{{eq:{n}}}" in text for n in range(1, 9))
    assert r"(\ref{eq:4})" in text
    assert r"\begin{tikzpicture}" in text
    assert "documentclass" not in latex_fragment(sample())


def test_words_of_latex() -> None:
    assert latex_words("50 % of a_b & c") == r"50 \% of a\_b \& c"
    assert latex_words("↶ 30° m/s² √2 − μ₁") == (
        r"\ensuremath{\curvearrowleft} 30\ensuremath{^{\circ}} m/s\ensuremath{^{2}} \ensuremath{\surd}2 "
        r"\ensuremath{-} \ensuremath{\mu}\ensuremath{_{1}}"
    )
    assert latex_words("Größe é č") == "Größe é č"
    assert latex_words("力") == "[U+529B]"
    assert web_words("a_b") == r"\text{a}\_\text{b}"


@needs_pdflatex
@pytest.mark.slow
@pytest.mark.parametrize("kind", ["sample", "german", "hostile", "wide", "fragment"])
def test_latex_compiles(kind: str, tmp_path: Path) -> None:
    signs = Equation(formula("a", "=", "b"), 1, "↓ ↑ → ← ↶ ↷ ° ² √ α Ω − ≥ ≤ ≠ ≈ · × ± “ ” – … µ ₂ ∥ ⊥ 力 😀 \x07", ())
    more = replace(sample(), blocks=(*sample().blocks, Equations((signs,)), Equations((signs, signs))))
    head = r"\documentclass{article}\usepackage[utf8]{inputenc}\usepackage[T1]{fontenc}"
    packages = r"\usepackage{amsmath,amssymb,textcomp,xcolor,graphicx,booktabs,array,tikz,hyperref}"
    documents = {
        "sample": latex_document(more),
        "german": latex_document(sample("de")),
        "hostile": latex_document(hostile()),
        "wide": latex_document(wide()),
        "fragment": rf"{head}{packages}\begin{{document}}{latex_fragment(sample())}\end{{document}}",
    }
    (tmp_path / "report.tex").write_text(documents[kind], encoding="utf-8")
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "report.tex"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, timeout=600, check=False)
    assert done.returncode == 0, done.stdout[-2000:].decode(errors="replace")
    assert (tmp_path / "report.pdf").exists()


@needs_typst
def test_a_pdf_is_made() -> None:
    assert pdf_bytes(hostile()).startswith(b"%PDF")
    assert pdf_bytes(wide()).startswith(b"%PDF")
    assert pdf_bytes(sample()).startswith(b"%PDF")


@needs_typst
def test_hostile_words_stay_words_in_a_pdf(tmp_path: Path) -> None:
    if shutil.which("pdftotext") is None:
        pytest.skip("pdftotext is not installed")
    path = tmp_path / "a.pdf"
    path.write_bytes(pdf_bytes(hostile()))
    done = subprocess.run(["pdftotext", "-layout", str(path), "-"], capture_output=True, timeout=600, check=True)
    assert "#1 \"q\" 'p' *b* `c` [l](u) {d}" in done.stdout.decode()


def test_typst_keeps_drawings_beside_and_without_colours_for_dark_screens() -> None:
    source, drawings = typst_files(sample())
    assert set(drawings) == {"1.svg", "2.svg", "3.svg"}
    assert all(f'"{name}"' in source for name in drawings)
    assert not any("@media" in svg for svg in drawings.values())


def test_a_notebook_is_valid_and_begins_with_the_code() -> None:
    text = notebook_text(sample(), code="import freebody\nsystem = 1\n")
    notebook: dict[str, Any] = json.loads(text)
    if find_spec("nbformat") is not None:
        import_module("nbformat").validate(notebook)
    assert [cell["cell_type"] for cell in notebook["cells"][:3]] == ["markdown", "code", "markdown"]
    assert notebook["cells"][1]["source"] == ["import freebody\n", "system = 1"]
    pictures = [cell["attachments"] for cell in notebook["cells"] if "attachments" in cell]
    assert sum(map(len, pictures)) == 3
    assert base64.b64decode(pictures[0]["figure-1.png"]["image/png"]).startswith(b"\x89PNG")
    assert "<details>" in text


def test_the_terminal_shows_fractions_numbers_and_marks() -> None:
    lines = terminal_text(sample(), 100).splitlines()
    assert max(columns(line) for line in lines) <= 100
    numbered = [line for line in lines if re.search(r"\s{2}\(\d+\)$", line)]
    assert len(numbered) == 11
    assert {len(line) for line in numbered} == {100}
    assert any(re.fullmatch(r"    ──⎜────⎟ - ─── = 0 +\(6\)", line) for line in lines)
    assert any(line.startswith("✓  B") for line in lines)
    assert any(line.startswith("[figure 3: After: ω_max = ") for line in lines)


def wide() -> Report:
    """Formulas that no row can hold, with and without words beside them."""
    terms = "+".join(f"m_{k}*L_{k}^2*cos(theta_{k}-theta_1)" for k in range(1, 12))
    fraction = formula("a_1", "=", f"({terms})/(J_S+m*r^2)", unit="m/s^2")
    first = Equation(fraction, 1, "along, ↓:", text("a note"))
    lines = (first, Equation(formula("b", "=", "c"), 2), Equation(fraction))
    blocks = (Equations(lines), Columns((Equations(lines),), (Equations((Equation(fraction),)),)))
    return Report("Wide", "en", "", (*blocks, Paragraph(text("It is ", fraction, "."))), {})


def test_formulas_that_no_row_can_hold_are_written_in_every_format() -> None:
    lines = terminal_text(wide(), 80).splitlines()
    assert max(map(columns, lines)) <= 80
    assert "--widest:" in html_page(wide())
    assert 'class="wide"' in html_page(wide())
    assert r"\frfitted{0.78\linewidth}" in latex_document(wide())
    assert "along, ↓: a note" in markdown_files(wide(), "x")[0]
    typst_files(wide())
    notebook_text(wide())


def test_a_long_left_side_has_its_relation_behind_it_and_not_a_narrow_column_beside_it() -> None:
    terms = "+".join(f"m_{k}*L_{k}*cos(theta_{k})" for k in range(1, 12))
    report = Report("Wide", "en", "", (Equations((Equation(formula(terms, "=", terms)),)),), {})
    lines = terminal_text(report, 80).splitlines()
    assert max(map(columns, lines)) <= 80
    assert max(len(line) - len(line.lstrip()) for line in lines) <= 8


@pytest.mark.parametrize("width", [40, 60, 300])
def test_paragraphs_fit_the_terminal(width: int) -> None:
    prose = replace(sample(), blocks=tuple(b for b in sample().blocks if not isinstance(b, Section)))
    lines = terminal_text(prose, width).splitlines()
    assert max(map(columns, lines)) <= min(width, 120)


def test_a_summary_tells_the_size_of_a_condition_that_nobody_would_read_in_tables_too() -> None:
    long = " + ".join(f"{k}·r^{k}" for k in range(400))
    report = Report("Phases", "en", "", (Table((), ((text("1  sticks"), text(f"{long} > 0")),)),), {}, is_summary=True)
    short, full = (terminal_text(report, is_short=is_short) for is_short in (True, False))
    assert long in full
    assert f"({len(long) + 4} characters;" in short
    assert len(short) < 400


def test_a_summary_says_in_the_language_of_the_report_what_is_shown_on_request() -> None:
    german = Catalogue("de").report_words
    steps = Equations((Equation(formula("a", "=", "b")), Equation(formula("c", "=", "d"))), on_request=True)
    long = Equations((Equation(formula("a", "=", "+".join(f"sin({k}*b)" for k in range(2, 40)))),))
    report = Report("Formeln", "de", "", (steps, long), german, is_summary=True)
    told = terminal_text(report, is_short=True)
    assert "nacheinander über 2 benannte Formeln (--full" in told
    assert "eine Formel aus " in told
    assert "formulas" not in told


def test_a_terminal_is_given_no_control_characters() -> None:
    report = replace(sample(), title="a\x1b[31mb\x07", subtitle="c\nd")
    assert terminal_text(report).startswith("a[31mb\nc d\n")


# -- files ----------------------------------------------------------------------------------------
@pytest.mark.parametrize("suffix", report_formats())
def test_a_report_is_written_by_the_suffix(suffix: str, tmp_path: Path) -> None:
    if suffix == ".pdf" and find_spec("typst") is None:
        pytest.skip("typst is not installed")
    path = tmp_path / f"my disk{suffix}"
    written = write_report(sample(), path, code="import freebody")
    assert written[0] == path
    assert all(file.stat().st_size > 0 for file in written)
    assert len(written) == (4 if suffix == ".md" else 1)
    assert sorted(p.name for p in tmp_path.iterdir()) == sorted({p.relative_to(tmp_path).parts[0] for p in written})


def test_a_path_that_cannot_be_written_is_told_before_any_work(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"must end in one of \.html .*\.txt .*[Dd]id you mean a\.html\?"):
        check_report_path(tmp_path / "a.htm")
    with pytest.raises(InputError, match="must end in one of"):
        check_report_path("report")
    with pytest.raises(InputError, match="there is no folder"):
        check_report_path(tmp_path / "none" / "a.html")
    (tmp_path / "b.html").mkdir()
    with pytest.raises(InputError, match="this is a folder"):
        check_report_path(tmp_path / "b.html")
    (tmp_path / "c-figures").write_text("x")
    with pytest.raises(InputError, match="c-figures"):
        check_report_path(tmp_path / "c.md")
    check_report_path(tmp_path / "d.html")
    assert not (tmp_path / "d.html").exists()


def test_without_typst_a_pdf_is_refused_with_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("freebody.present.report.formats.typst.find_spec", lambda name: None)
    with pytest.raises(InputError, match=r"freebody\[report\]"):
        check_report_path(tmp_path / "a.pdf")


# -- a format of one's own ------------------------------------------------------------------------
ASCIIDOC = '''"""Reports in AsciiDoc, with formulas in its own mathematics."""

from freebody.language.notation import to_text
from freebody.present.report.formulas.line import LineFormulas
from freebody.present.report.writer import BlockWriter, ReportFormat


class AsciiMath(LineFormulas):
    def expression(self, expr):
        return to_text(expr).replace("·", "*")

    def over(self, above, below):
        return f"({above})/({below})"


class AsciiDocWriter(BlockWriter[str]):
    formulas = AsciiMath()

    def blocks(self, blocks):
        return "\\n\\n".join(map(self.block, blocks))

    def paragraph(self, text):
        return self.text(text)

    def equations(self, lines):
        inner = "\\n".join(self.formulas.formula(line.formula) for line in lines)
        return f"[stem]\\n++++\\n{inner}\\n++++"

    def bullets(self, items, *, is_numbered):
        return "\\n".join(f"{'.' if is_numbered else '*'} {item}" for item in items)

    def table(self, table):
        rows = [row for row in (table.header, *table.rows) if row]
        return "\\n".join(["|===", *("|" + " |".join(map(self.text, row)) for row in rows), "|==="])

    def figure(self, figure):
        return f".{self.text(figure.caption)}\\nimage::{figure.number}.svg[]"

    def figures(self, figures):
        return "\\n\\n".join(map(self.figure, figures))

    def step(self, step):
        return f".{self.text(step.title)}\\n[%collapsible]\\n====\\n{self.blocks(step.blocks)}\\n===="

    def section(self, section):
        return f"{'=' * section.level} {self.text(section.title)}\\n\\n{self.blocks(section.blocks)}"

    def beside(self, left, right):
        return self.blocks([*left, *right])

    def remark(self, text, kind):
        return f"{'WARNING' if kind == 'warning' else 'NOTE'}: {text}"

    def words(self, text):
        return f"pass:c[{text}]"

    def formula(self, formula):
        return f"stem:[{self.formulas.formula(formula)}]"

    def emphasis(self, emphasis):
        return f"*{self.words(emphasis.words)}*"

    def equation_link(self, number):
        return f"<<eq-{number}>>"

    def figure_link(self, number):
        return f"<<fig-{number}>>"


def files(report, path, code):
    return [(path, f"= {report.title}\\n\\n{AsciiDocWriter(report).blocks(report.blocks)}\\n".encode())]


ReportFormat(".adoc", "AsciiDoc", files, place=9)
'''


def test_a_new_format_is_one_file_with_a_writer_and_a_dialect(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "asciidoc.py").write_text(ASCIIDOC, encoding="utf-8")
    monkeypatch.setattr(formats, "__path__", [*formats.__path__, str(tmp_path)])
    monkeypatch.setattr(ReportFormat, "known", dict(ReportFormat.known))
    try:
        with pytest.raises(InputError, match=r"\.adoc \(AsciiDoc\)"):
            check_report_path(tmp_path / "a.doc")
        report = sample()
        short = (Entries((Entry("value", (text("2.5 m/s"),)), Entry("valid", (text(formula("m", ">", "0")),)))),)
        (path,) = write_report(replace(report, blocks=(*report.blocks, *short)), tmp_path / "a.adoc")
    finally:
        sys.modules.pop(f"{formats.__name__}.asciidoc", None)
    written = path.read_text(encoding="utf-8")
    assert written.startswith(f"= {report.title}\n")
    assert "[stem]\n++++\n" in written
    assert "|*pass:c[value]* |pass:c[2.5 m/s]\n|*pass:c[valid]* |stem:[m > 0]\n|===" in written
    for mark in ("\n== ", "|===", "image::1.svg[]", "[%collapsible]"):
        assert mark in written


@pytest.mark.parametrize(
    ("plain", "printed"),
    [
        ("stable (lowest stiffness -7.1131 1/s^2, along x)", "stable (lowest stiffness −7.1131 1/s², along x)"),
        ("(-1.2, -.5) m, -38.5°", "(−1.2, −.5) m, −38.5°"),
        ("the smallest is 6.6e-01, above 1e-06", "the smallest is 6.6·10⁻¹, above 10⁻⁶"),
        ("DOF = n L - K = 3*1 - 3 = 0", "DOF = n L − K = 3·1 − 3 = 0"),
        ("ground - ladder", "ground – ladder"),
        ("   <- the model's own values", "   ← the model's own values"),
        ("the corner (-a/2, -b/2) of crate", "the corner (−a/2, −b/2) of crate"),
        ("part-2 of 3-5, --seed 3, a_1e5", "part-2 of 3-5, --seed 3, a_1e5"),
    ],
)
def test_numbers_in_words_are_printed_with_a_minus_and_raised_exponents(plain: str, printed: str) -> None:
    assert typeset(plain) == (printed,)
