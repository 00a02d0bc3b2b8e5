"""Whatever stands in a title, a description, a question or an option: every writer's output stays valid and inert."""

from __future__ import annotations

import json
import re
import unicodedata
from dataclasses import replace
from html.parser import HTMLParser
from io import BytesIO
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

import freebody as fb
from freebody.errors import InputError
from freebody.language.plain_text import plain, plain_lines, shortened
from freebody.present.animation import write_animation
from freebody.present.report.blocks import Bullets, Emphasis, Figure, Paragraph, Report, Section, Step, Table, text
from freebody.present.report.formats.html import html_page
from freebody.present.report.formats.latex import latex_document
from freebody.present.report.formats.markdown import markdown_files
from freebody.present.report.formats.notebook import notebook_text
from freebody.present.report.formats.terminal import terminal_text
from freebody.present.report.formats.typst import typst_files
from freebody.present.scene import Scene
from freebody.study.answering.answer import Answer
from freebody.study.answering.solution import Solution
from report_sample import Drawing

BIDI = "\u202eevil\u2066\u200f"
LINE_ENDS = "a\nb\r\nc\u2028d\u2029e\x85f\x0bg\x0ch"
HOSTILE = [
    "\x1b[31mred\x1b]0;title\x07\x9b2J\x00\x7f",
    BIDI,
    LINE_ENDS,
    "x\n\\input{/etc/passwd}\n\\immediate\\write18{id}",
    "x\u2028\\input{a}\r\\input{b}\x85\\input{c}",
    "100 % of $x$ & #1 ~^_ {y} \\end{document}",
    "</title></svg><script>alert(1)</script><!-- ]]> --> <![CDATA[",
    "\"'><img src=x onerror=alert(1)> &lt; &#x3c;",
    "`code` **bold** [l](javascript:alert(1)) <b> $$x$$ ![i](x) | a | --- #head\n---\n# head",
    '#read("/etc/passwd") #eval("1") $x$ */ // @ref <label> \\u{41}',
    "{{data}} {{script}} \\frac{1}{2} \ufffe\uffff",
    "=1+1\t@SUM(A1)",
]
LONG = "very long " * 900
TEXTS = [*HOSTILE, LONG]


def data(words: str) -> dict[str, Any]:
    """A model with these words wherever words can stand."""
    return {
        "title": words,
        "about": words,
        "bodies": {"b": {"particle": {"mass": "2 kg"}}},
        "connections": {"guide": {"slider": {"body": "b", "along": "right"}}},
        "loads": {"push": {"force": {"at": "b", "along": "right", "magnitude": "3 N"}}},
        "measures": {"x": "x of b"},
        "questions": [{"find": "acceleration of x", "id": words[:200] or "q", "options": {words[:50]: words[:300]}}],
    }


def is_clean(output: str) -> bool:
    """No control characters but line ends, and no marks of direction."""
    return not any(
        (unicodedata.category(c) in ("Cc", "Cs", "Zl", "Zp") and c != "\n")
        or unicodedata.bidirectional(c) in ("LRE", "RLE", "LRO", "RLO", "PDF", "LRI", "RLI", "FSI", "PDI")
        for c in output
    )


def live_tex(output: str) -> list[str]:
    """Commands of the hostile texts that TeX would run."""
    code = [re.sub(r"(?<!\\)%.*", "", line) for line in output.split("\n")]
    return [line for line in code if re.search(r"\\(input|immediate|write|end\{document\}x)\b", line)]


@pytest.mark.parametrize("words", TEXTS)
def test_a_model_keeps_its_words_on_one_clean_line(words: str) -> None:
    system = fb.System.from_data(data(words))
    (question,) = system.questions
    for found in (
        system.title,
        system.about,
        question.id,
        question.text,
        *question.options,
        *question.options.values(),
    ):
        assert is_clean(found)
        assert "\n" not in found
    again = fb.System.from_text(system.to_yaml())
    assert again.title == system.title


@pytest.mark.parametrize("words", TEXTS)
def test_pictures_with_any_title_are_valid_and_inert(words: str, tmp_path: Path) -> None:
    system = fb.System.from_data(data("plain"))
    drawn = system.picture()
    picture = replace(drawn, title=words, description=words)
    svg = picture.svg()
    root = ElementTree.fromstring(svg)
    assert is_clean(svg)
    elements = {e.tag.rpartition("}")[2] for e in root.iter()}
    assert elements <= {"svg", "title", "desc", "style", "path", "text", "tspan", "g"}
    tex = picture.tikz()
    assert is_clean(tex)
    assert live_tex(tex) == []
    code = re.sub("^%.*", "", tex, flags=re.MULTILINE)
    assert re.findall(r"\\(begin|end)\{(\w+)\}", code) == [("begin", "tikzpicture"), ("end", "tikzpicture")]


class Tags(HTMLParser):
    """What a browser would make elements of."""

    def __init__(self) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.handlers: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.handlers += [name for name, _v in attrs if name.startswith("on")]
        self.handlers += [v for name, v in attrs if name in ("href", "src") and v and "javascript:" in v]


def tags(page: str) -> Tags:
    found = Tags()
    found.feed(page)
    return found


def report(words: str) -> Report:
    said = text(words)
    blocks = (
        Paragraph(text(words, Emphasis(words, "code"), Emphasis(words))),
        Bullets((said,)),
        Table((said, said), ((said, said),), ("right",)),
        Figure(Drawing(words, words), said, 1),
        Step(said, said, (Paragraph(said),)),
        Section(said, (Paragraph(said),)),
    )
    return Report(words, "en", words, blocks, {})


@pytest.mark.parametrize("words", TEXTS)
def test_reports_with_any_words_are_valid_and_inert(words: str) -> None:
    hostile, harmless = report(words), report("words")
    page = html_page(hostile)
    assert is_clean(page)
    assert tags(page).tags == tags(html_page(harmless)).tags
    assert tags(page).handlers == tags(html_page(harmless)).handlers
    tex = latex_document(hostile)
    assert is_clean(tex)
    assert live_tex(tex) == live_tex(latex_document(harmless))
    assert tex.count(r"\end{document}") == 1
    markdown = markdown_files(hostile, "x")[0]
    assert is_clean(markdown)
    assert "<script" not in markdown
    assert "](javascript:" not in markdown.replace("\\", "") or "\\](" in markdown or "\\[" in markdown
    notebook = notebook_text(hostile)
    json.loads(notebook)
    source, _files = typst_files(hostile)
    assert is_clean(source)
    assert is_clean(terminal_text(hostile))


@pytest.mark.parametrize("words", [HOSTILE[0], LINE_ENDS, HOSTILE[6], LONG])
def test_a_player_with_any_title_runs_its_own_script_alone(words: str, tmp_path: Path) -> None:
    system = fb.System.from_data(data("plain"))
    scene = Scene.of(system, lambda e: 0.0)
    times, poses = np.array([0.0, 1.0]), np.zeros((2, 1, 3))
    poses[1, 0, 0] = 1.0
    pages = [
        write_animation(scene, times, poses, tmp_path / f"{k}.html", title=title).read_text(encoding="utf-8")
        for k, title in enumerate((words, "words"))
    ]
    assert is_clean(pages[0].replace("\t", ""))
    assert tags(pages[0]).tags == tags(pages[1]).tags


@pytest.mark.parametrize("words", TEXTS)
def test_the_terminal_is_not_given_orders(words: str) -> None:
    system = fb.System.from_data(data(words))
    answer = Answer(system.questions[0].id, system.questions[0].text, None, "m", None, reason="none")
    text = Solution(system, 1, ("x",), (), (), (answer,)).to_text()
    assert is_clean(text.rstrip("\n"))


def test_messages_do_not_repeat_orders(capsys: pytest.CaptureFixture[str]) -> None:
    from freebody.cli.running import say

    text = 'title: t\nbodies: {"\\e[31mb\\a": {particle: {mass: 1 kg}}}\nquestions: ["\\e[2Jacceleration"]\n'
    with pytest.raises(InputError) as refused:
        fb.System.from_text(text)
    say(str(refused.value))
    said = capsys.readouterr().err
    assert "bodies" in said
    assert is_clean(said)


def test_what_is_plain() -> None:
    assert plain("Ärger α₁ – 漢字 🚀") == "Ärger α₁ – 漢字 🚀"
    assert plain(LINE_ENDS) == "a b c d e f g h"
    assert plain(BIDI) == "evil"
    assert plain_lines("a\x1b\nb\r") == "a\nb "
    assert shortened("abcdef", 4) == "ab …"
    assert shortened("abcd", 4) == "abcd"


def test_a_long_title_is_shortened_in_the_data_of_a_png() -> None:
    drawn = fb.System.from_data(data("plain")).picture()
    picture = replace(drawn, title=LONG + "\x1b", description="")
    png = BytesIO(picture.png()).getvalue()
    assert png.startswith(b"\x89PNG")
    assert len(re.findall(b"very long", png)) < 60
