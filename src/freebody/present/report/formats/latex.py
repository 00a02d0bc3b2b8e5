r"""A report as a LaTeX document for pdflatex with plain packages; drawings are TikZ.

Numbers are the report's own (\tag), so that a part of it can stand in another document.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from freebody.present.report.blocks import (
    Block,
    Emphasis,
    Entries,
    Equation,
    Equations,
    Figure,
    Formula,
    Report,
    Section,
    Step,
    Table,
    Text,
)
from freebody.present.report.formulas.displayed import WRITER, Dialect, aligned_rows
from freebody.present.report.formulas.rows import formula_width, text_width
from freebody.present.report.latex_text import latex_words, math_words
from freebody.present.report.words import capital, word
from freebody.present.report.writer import BlockWriter, ReportFormat, in_its_decimals
from freebody.present.theme import PAGES, THEMES

_ROW_WIDTH, _COLUMN_WIDTH = 72, 28  # characters of a displayed formula
_SET = 0.8  # how wide one is in print, by its width on a terminal
_HEADINGS = {1: "section", 2: "section", 3: "subsection", 4: "subsubsection"}
_LOOKS = {
    "code": r"\texttt{{{}}}",
    "strong": r"\textbf{{{}}}",
    "soft": r"{{\color{{frmuted}}{}}}",
    "name": r"\textit{{{}}}",
}
_MARKS = {"": "", "right": r"\textcolor{frright}{$\checkmark$}", "wrong": r"\textcolor{frwrong}{$\times$}"}

_COLORS = {f"fr{name}": PAGES["light"][name] for name in ("muted", "accent", "right", "wrong")}
# \frfitted{width}{what} shrinks what is wider, \frdrawing{what} what is wider or higher than a drawing may be;
# \frbox{colour}{text} is a frame.
MACROS = r"""\providecommand{\frfitted}[2]{\sbox0{#2}\ifdim\wd0>#1\resizebox{#1}{!}{\usebox0}\else\usebox0\fi}
\providecommand{\frdrawing}[1]{\sbox0{#1}\ifdim\ht0>52mm\sbox0{\resizebox{!}{52mm}{\usebox0}}\fi\frfitted{\linewidth}{\usebox0}}
\providecommand{\frbox}[2]{\par\medskip\noindent{\setlength{\fboxsep}{6pt}%
  \fcolorbox{#1}{white}{\parbox{\dimexpr\linewidth-2\fboxsep-2\fboxrule}{#2}}}\par\medskip}
"""
PACKAGES = "amsmath, amssymb, textcomp, xcolor, graphicx, booktabs, array, tikz, hyperref"


@in_its_decimals
def latex_document(report: Report) -> str:
    """The text of a .tex file."""
    language = word(report, "babel")
    light = THEMES["light"]
    named = {"ink": light.ink, "muted": light.muted, "faint": light.faint, "paper": light.paper, **_COLORS}
    defined = _defined("definecolor", named)
    subtitle = rf"\par\smallskip{{\color{{frmuted}}{latex_words(report.subtitle)}}}" if report.subtitle else ""
    return rf"""\documentclass[10pt,a4paper,fleqn]{{article}}
\usepackage[utf8]{{inputenc}}
\usepackage[T1]{{fontenc}}
\usepackage{{lmodern}}
\usepackage[{language}]{{babel}}
\usepackage[hmargin=20mm,top=18mm,bottom=20mm]{{geometry}}
\usepackage{{amsmath,amssymb,textcomp,xcolor,graphicx,booktabs,array,tikz}}
\usetikzlibrary{{arrows.meta,calc,patterns,decorations.pathmorphing}}
\usepackage[hidelinks]{{hyperref}}
\setlength{{\parindent}}{{0pt}}
\setlength{{\parskip}}{{4pt plus 1pt}}
\setlength{{\mathindent}}{{1em}}
\makeatletter % lists and headings close to the text that they belong to
\def\@listi{{\leftmargin\leftmargini\topsep2pt\partopsep0pt\parsep0pt\itemsep1pt}}\let\@listI\@listi\@listi
\renewcommand{{\section}}{{\@startsection{{section}}{{1}}{{0pt}}{{2.2ex plus .5ex}}{{1ex}}%
  {{\normalfont\Large\bfseries}}}}
\renewcommand{{\subsection}}{{\@startsection{{subsection}}{{2}}{{0pt}}{{1.8ex plus .5ex}}{{.8ex}}%
  {{\normalfont\large\bfseries}}}}
\makeatother
\AtBeginDocument{{\abovedisplayskip5pt plus 2pt\belowdisplayskip5pt plus 2pt%
  \abovedisplayshortskip3pt\belowdisplayshortskip4pt}}
\setcounter{{secnumdepth}}{{0}}
\allowdisplaybreaks
{defined}{MACROS}\hypersetup{{pdftitle={{{latex_words(report.title)}}}}}
\begin{{document}}
{{\LARGE\bfseries\raggedright {latex_words(report.title)}\par}}{subtitle}
\bigskip

{_Writer(report).blocks(report.blocks)}
\end{{document}}
"""


@in_its_decimals
def latex_fragment(report: Report) -> str:
    """The body alone, to be read by \\input where the packages named in its first line are loaded."""
    colors = _defined("providecolor", _COLORS)
    return f"% needs the packages {PACKAGES}\n{MACROS}{colors}{_Writer(report).blocks(report.blocks)}\n"


def _defined(command: str, colors: Mapping[str, str]) -> str:
    return "".join(rf"\{command}{{{name}}}{{HTML}}{{{color[1:].upper()}}}" + "\n" for name, color in colors.items())


class _Writer(BlockWriter[str]):
    """Writes the blocks of one report. width: [characters] of a displayed formula."""

    def __init__(self, report: Report, width: int = _ROW_WIDTH) -> None:
        super().__init__(report)
        self.width = width

    # -- blocks -----------------------------------------------------------------------------------
    def blocks(self, blocks: Sequence[Block]) -> str:
        """A formula goes on with the paragraph before it, which keeps the space above it small."""
        return "".join(("\n" if isinstance(b, Equations) else "\n\n") + self.block(b) for b in blocks).strip("\n")

    def paragraph(self, text: Text) -> str:
        return self.text(text)

    def bullets(self, items: Sequence[str], *, is_numbered: bool) -> str:
        name = "enumerate" if is_numbered else "itemize"
        # \relax keeps a bracket at the start of an item from being its option.
        inner = "\n".join(rf"\item\relax {item}" for item in items)
        return f"\\begin{{{name}}}\n{inner}\n\\end{{{name}}}"

    def choices(self, items: Sequence[tuple[str, str]]) -> str:
        inner = "\n".join(
            rf"\item[{latex_words(letter)}] {{\everymath{{\displaystyle}}{said}}}" for letter, said in items
        )
        return f"\\begin{{itemize}}\\setlength{{\\itemsep}}{{6pt}}\n{inner}\n\\end{{itemize}}"

    def unbroken(self, blocks: Sequence[Block]) -> str:
        return (
            "\\par\\addvspace{9pt}\\noindent\\begin{minipage}{\\linewidth}\\setlength{\\parskip}{6pt plus 2pt}\n"
            f"{self.blocks(blocks)}\n\\end{{minipage}}\\par"
        )

    def room(self, height: float) -> str:
        return rf"\vspace*{{{height:g}cm}}"

    def figure(self, figure: Figure) -> str:
        return "\\begin{center}\n" + self.drawing(figure) + "\n\\end{center}"

    def figures(self, figures: Sequence[Figure]) -> str:
        share = 0.95 / max(1, min(3, len(figures)))
        drawn = [_minipage(share, r"\centering", self.drawing(figure)) for figure in figures]
        return "\\begin{center}\n" + "\\hfill\n".join(drawn) + "\n\\end{center}"

    def section(self, section: Section) -> str:
        heading = _HEADINGS.get(section.level, "paragraph")
        title = rf"\{heading}{{\texorpdfstring{{{self.text(section.title)}}}{{{self.bookmark(section.title)}}}}}"
        page = "\\clearpage\n" if section.is_apart else ""
        return f"{page}{title}\n{self.blocks(section.blocks)}"

    def beside(self, left: Sequence[Block], right: Sequence[Block]) -> str:
        narrow = _Writer(self.report, _COLUMN_WIDTH)
        parts = [_minipage(0.48, r"\setlength{\parskip}{4pt}", narrow.blocks(side)) for side in (left, right)]
        return "\\noindent" + "\\hfill\n".join(parts)

    def step(self, step: Step) -> str:
        """A line before the title; no hint, as nothing can be hidden on paper."""
        rule = r"\medskip{\color{fraccent}\rule{1.2em}{1.5pt}}\enspace"
        title = rf"{rule}\textbf{{{self.text(step.title)}}}\nopagebreak"
        return f"{title}\n\n{self.blocks(step.blocks)}"

    def remark(self, text: str, kind: str) -> str:
        if kind == "evidence":
            return rf"{{\small\color{{frmuted}}{_MARKS['right']}\enspace {text}\par}}"
        sign = r"\textcolor{frwrong}{\textbf{!}}\enspace " if kind == "warning" else ""
        text = text if kind == "warning" else rf"\everymath{{\displaystyle}}{text}"
        return rf"\frbox{{{'frwrong' if kind == 'warning' else 'fraccent'}}}{{{sign}{text}}}"

    def equations(self, lines: Sequence[Equation]) -> str:
        dialect = Dialect(math_words, _tag, self.above, _shrunk)
        return f"\\begin{{alignat*}}{{3}}\n{aligned_rows(lines, self.width, dialect)}\\end{{alignat*}}"

    def above(self, text: Text) -> str:
        """A text over the whole line between the rows of a formula."""
        return rf"\noalign{{\vskip6pt\vbox{{\normalbaselines\noindent {self.text(text)}\endgraf}}\vskip2pt}}" + "\n"

    def table(self, table: Table) -> str:
        marked = any(table.marks)
        kinds = "@{}" + ("c@{\\enspace}" if marked else "") + _column_kinds(table)
        rows = [("" if marked else None, table.header)] if table.header else []
        rows += [
            (_MARKS[table.marks[k] if k < len(table.marks) else ""] if marked else None, row)
            for k, row in enumerate(table.rows)
        ]
        texts = [" & ".join([*([mark] if mark is not None else []), *map(self.cell, row)]) for mark, row in rows]
        # Fractions need room between the rows.
        space = "\\addlinespace[5pt]\n" if any("\\frac" in line for line in texts) else ""
        head = f"{texts.pop(0)} \\\\\n\\midrule\n" if table.header else ""
        body = f" \\\\\n{space}".join(texts)
        return (
            f"{{\\par\\nopagebreak\\centering\\renewcommand{{\\arraystretch}}{{1.2}}\n"
            f"\\begin{{tabular}}{{{kinds}@{{}}}}\n\\toprule\n"
            f"{head}{body} \\\\\n\\bottomrule\n\\end{{tabular}}\\par}}"
        )

    def entries(self, entries: Entries) -> str:
        """A list, which goes on over pages where a table would not."""
        items = [
            rf"\item[{{{latex_words(entry.label)}}}] " + "\\par\n".join(map(self.cell, entry.texts))
            for entry in entries.entries
        ]
        inner = "\n".join(items)
        return f"\\begin{{description}}\n{inner}\n\\end{{description}}"

    def cell(self, text: Text) -> str:
        """A formula is no wider than its column."""
        parts = (
            rf"\frfitted{{\linewidth}}{{${WRITER.formula(p)}$}}" if isinstance(p, Formula) else self.text((p,))
            for p in text
        )
        return r"{\everymath{\displaystyle}" + "".join(parts) + "}"

    def drawing(self, figure: Figure) -> str:
        name = rf"\textbf{{{capital(self.word('figure'))} {figure.number}}}"
        return (
            f"\\phantomsection\\label{{fig:{figure.number}}}\\frdrawing{{%\n{figure.picture.tikz()}}}\\\\[4pt]\n"
            f"{{\\small {name}\\enspace {self.text(figure.caption)}}}"
        )

    # -- text -------------------------------------------------------------------------------------
    def words(self, text: str) -> str:
        return latex_words(text)

    def formula(self, formula: Formula) -> str:
        written = f"${WRITER.formula(formula)}$"
        return rf"\frfitted{{\linewidth}}{{{written}}}" if formula_width(formula) > self.width else written

    def emphasis(self, emphasis: Emphasis) -> str:
        return _LOOKS[emphasis.look].format(latex_words(emphasis.words))

    def equation_link(self, number: int) -> str:
        return rf"(\ref{{eq:{number}}})"

    def figure_link(self, number: int) -> str:
        return rf"\hyperref[fig:{number}]{{{self.word('figure')}~{number}}}"

    def bookmark(self, text: Text) -> str:
        """A title without formulas, for the list of contents of a PDF."""
        return "".join(latex_words(p) for p in text if isinstance(p, str)).replace(r"\ensuremath", "")


def _minipage(share: float, setting: str, content: str) -> str:
    # The empty line at the top is what they are aligned at.
    return f"\\begin{{minipage}}[t]{{{share:.2f}\\linewidth}}{setting}\\vspace{{0pt}}\n{content}\n\\end{{minipage}}"


def _tag(number: int) -> str:
    return rf"\tag{{{number}}}\label{{eq:{number}}}"


def _shrunk(formula: str) -> str:
    return rf"\vcenter{{\hbox{{\frfitted{{0.78\linewidth}}{{$\displaystyle {formula}$}}}}}}"


def _column_kinds(table: Table) -> str:
    """Columns of long texts are paragraphs that share the width of the line."""
    every = [row for row in (table.header, *table.rows) if row]
    n = max(map(len, every), default=0)
    columns = [[row[k] for row in every if k < len(row)] for k in range(n)]
    lengths = [max(map(text_width, column), default=0) for column in columns]
    if sum(lengths) <= _ROW_WIDTH:
        return "l" * n
    solid = [
        max((formula_width(p) for cell in column for p in cell if isinstance(p, Formula)), default=0)
        for column in columns
    ]
    shares = _shares(lengths, solid)
    return "".join(rf">{{\raggedright\arraybackslash}}p{{{0.86 * share:.3f}\linewidth}}" for share in shares)


def _shares(lengths: Sequence[int], solid: Sequence[int]) -> list[float]:
    """Of the width of a line by column: short ones have what they need, and long ones at least their widest formula, up
    to a half of the line; they share the rest."""
    room, short = float(_ROW_WIDTH), _ROW_WIDTH // len(lengths)
    least = [max(n, 4) if n <= short else max(min(_SET * s, room / 2), 4) for n, s in zip(lengths, solid, strict=True)]
    more = [0.0 if n <= short else max(n - own, 1.0) for n, own in zip(lengths, least, strict=True)]
    left = max(room - sum(least), 0.0)
    widths = [own + left * extra / (sum(more) or 1.0) for own, extra in zip(least, more, strict=True)]
    return [width / sum(widths) for width in widths]


ReportFormat(".tex", "LaTeX", lambda report, path, _code: [(path, latex_document(report).encode())], place=2)
