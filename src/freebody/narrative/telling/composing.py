"""An explanation as a report: the opening, a section for each question, and how the answers were checked."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from freebody.errors import FreebodyError
from freebody.language.notation.parts import decimals_with
from freebody.language.sentences import Sentence
from freebody.narrative.derivation import Derivation, WorkedSolutions
from freebody.narrative.lines.script import DerivationStage, Drawn, Graph, ready
from freebody.narrative.sheets.asking import headline
from freebody.narrative.sheets.authored import authored, with_symbols
from freebody.narrative.telling.catalogue import Catalogue
from freebody.narrative.telling.house import in_style
from freebody.narrative.telling.telling import Telling
from freebody.present.report.blocks import Block, Columns, Emphasis, Paragraph, Picture, Remark, Report, Section

if TYPE_CHECKING:
    from freebody.system.system import System

_HEAD = 3  # lines of a text on a terminal: its title, a rule, an empty one


def report_of(explanation: WorkedSolutions) -> Report:
    """The report of an explanation, in its language."""
    catalogue = Catalogue(explanation.language)
    system = explanation.system

    drawn: dict[tuple[tuple[str, ...], ...], Picture | None] = {}

    def draw(diagram: Drawn) -> Picture | None:
        if diagram.shown not in drawn:
            with decimals_with(catalogue.decimal):
                drawn[diagram.shown] = _drawn(system, diagram)
        return drawn[diagram.shown]

    telling = Telling(catalogue, draw)
    blocks: list[Block] = []
    if system.about:
        blocks.append(Paragraph(authored(system.about, system)))
    for stage in explanation.opening:
        blocks.append(Section(catalogue.tell(stage.title), tuple(telling.blocks(stage.items))))
    routes: set[str] = set()  # of checks that have been described
    blocks += [_section(system, catalogue, telling, d, routes) for d in explanation.derivations]
    title = system.title or "freebody"
    solution = catalogue.word("report.worked_solution")
    report = Report(title, catalogue.language, solution, tuple(blocks), catalogue.report_words)
    return in_style(report, system.style, catalogue.decimal)


def _drawn(system: System, diagram: Drawn) -> Picture | None:
    """A derivation without its picture is better than none."""
    from freebody.study.pictures.diagrams import diagram_of
    from freebody.study.pictures.picture import free_body, picture

    try:
        if isinstance(diagram, Graph):
            return diagram_of(system, diagram.question, diagram.answer)
        if diagram.bodies:
            return free_body(system, *diagram.bodies, told=diagram.told)
        return picture(system, turning=diagram.turning)
    except FreebodyError:
        return None


def plain_derivations(explanation: WorkedSolutions) -> dict[str, Any]:
    """Stage by stage in lines, without pictures."""
    from freebody.present.report.formats.terminal import terminal_text

    catalogue = Catalogue(explanation.language)
    telling = Telling(catalogue, lambda _diagram: None)

    def told(stage: DerivationStage) -> dict[str, Any]:
        report = Report("", catalogue.language, "", tuple(telling.blocks(stage.items)), catalogue.report_words)
        return {"title": catalogue.plain(stage.title), "lines": terminal_text(report).splitlines()[_HEAD:]}

    derivations = [
        {
            "id": d.question.id,
            "method": d.method,
            "reason": catalogue.said(d.reason) or None,
            "stages": [told(stage) for stage in d.stages],
        }
        for d in explanation.derivations
    ]
    return {"opening": [told(stage) for stage in explanation.opening], "derivations": derivations}


def _section(system: System, catalogue: Catalogue, telling: Telling, d: Derivation, routes: set[str]) -> Section:
    title = with_symbols(catalogue.titled(headline(system, d.question)), d.question, system)
    blocks: list[Block] = []
    if d.compared:
        names = [(Emphasis(catalogue.word(f"method.{m}"), "strong"),) for m in (d.method, d.compared_method)]
        ends = [s for s in d.stages if s.title.key in ("stage.result", "stage.checks", "stage.options")]
        left = telling.stages([s for s in d.stages if s not in ends])
        blocks.append(Columns((Paragraph(names[0]), *left), (Paragraph(names[1]), *telling.stages(d.compared))))
        blocks.append(Remark(catalogue.tell(Sentence("compare.same"))))
        blocks += telling.stages(ends)
    else:
        blocks += telling.stages(d.stages)
    if d.reason:
        blocks.append(Remark(catalogue.tell(Sentence("report.no_derivation", {"reason": ready(d.reason)})), "warning"))
    if d.answer.evidence is not None:
        e = d.answer.evidence
        args = {"n": e.draws, "route": ready(e.route), "worst": f"@{e.worst_relative_difference:.1g}"}
        key = "report.evidence_again" if e.route in routes else "report.evidence"
        routes.add(e.route)
        blocks.append(Remark(catalogue.tell(Sentence(key, args)), "evidence"))
    return Section(title, tuple(blocks))
