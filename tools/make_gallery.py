"""Renders the gallery: a page for every bundled example with figures, answers and derivations, and an index of them.

python tools/make_gallery.py                     writes docs/gallery
python tools/make_gallery.py FOLDER [NAME ...]   writes elsewhere, or some examples only; others keep their cards
"""

from __future__ import annotations

import re
import sys
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from freebody import System

ROOT = Path(__file__).resolve().parent.parent
MOST_ANSWERS = 3  # that a card shows
_CARD = re.compile(r'<article>\n<a class="figure" href="(?P<name>\w+)\.html".*?</article>\n', re.DOTALL)


@dataclass(frozen=True)
class Card:
    """What the index shows of an example."""

    name: str
    title: str
    about: str  # in HTML
    svg: str
    answers: tuple[tuple[str, str], ...]  # question, and the answer as MathML or text
    n_more: int


def main() -> None:
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "docs" / "gallery"
    names = sys.argv[2:] or sorted(path.stem for path in (ROOT / "examples").glob("*.yaml"))
    folder.mkdir(parents=True, exist_ok=True)
    with ProcessPoolExecutor(max_workers=2) as pool:
        cards = list(pool.map(render, names, [folder] * len(names)))
    place = folder / "index.html"
    kept = cards_in(place.read_text(encoding="utf-8")) if sys.argv[2:] and place.exists() else {}
    articles = kept | {card.name: card_of(card) for card in cards}
    place.write_text(index([articles[name] for name in sorted(articles)]), encoding="utf-8")
    print(f"wrote {len(cards)} pages and an index of {len(articles)} to {folder}")


def cards_in(page: str) -> dict[str, str]:
    """The cards of an index by the names of their examples."""
    return {match["name"]: match[0] for match in _CARD.finditer(page)}


def render(name: str, folder: Path) -> Card:
    """Writes the page of one example and returns its card."""
    from freebody import System
    from freebody.study.pictures.picture import picture

    system = System.load(ROOT / "examples" / f"{name}.yaml")
    explanation = system.explain()
    (folder / f"{name}.html").write_text(explanation.to_html(), encoding="utf-8")
    trouble = [f"{d.question.text}: {d.reason}" for d in explanation.derivations if d.reason]
    print(f"{name}.html{' !! ' if trouble else ''}{'; '.join(trouble)}", flush=True)
    answers = [a for a in explanation.solution.answers if a.expression is not None]
    shown = tuple((a.question, formula(a.expression)) for a in answers[:MOST_ANSWERS])
    return Card(name, system.title, said(system), picture(system).svg(), shown, len(answers) - len(shown))


def said(system: System) -> str:
    """What the author says of an example, in HTML, its formulas typeset."""
    from freebody.narrative.sheets.authored import authored
    from freebody.present.report.blocks import Paragraph, Report
    from freebody.present.report.formats.html import html_content

    page = html_content(Report("", "en", "", (Paragraph(authored(system.about, system)),), {}), "")
    found = re.search(r"<p>(.*?)</p>", page, re.DOTALL)
    return found[1] if found else ""


def formula(expression: object) -> str:
    """An answer as MathML; a vector by its components."""
    from freebody.language.notation import to_mathml

    parts = expression if isinstance(expression, tuple) else (expression,)
    inner = '<mo separator="true">,</mo>'.join(to_mathml(part) for part in parts)
    row = f"<mo>(</mo>{inner}<mo>)</mo>" if len(parts) > 1 else inner
    return f"<math><mo>=</mo>{row}</math>"


def index(articles: list[str]) -> str:
    """The page that shows all examples."""
    from freebody.present.assets import colored

    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>freebody: worked examples</title>
<style>{colored(STYLE)}</style>
</head>
<body>
<header><h1>Worked examples</h1>
<p>Each was described in a short model file and solved, checked and written by <code>freebody explain</code>.</p>
</header>
<main>
{"".join(articles)}</main>
</body>
</html>
"""


def card_of(card: Card) -> str:
    """One example: figure, title, the first answers."""
    answers = "".join(f"<li><span>{escape(q)}</span> <span class='formula'>{a}</span></li>" for q, a in card.answers)
    more = f"<li class='more'>and {card.n_more} more</li>" if card.n_more else ""
    return f"""<article>
<a class="figure" href="{card.name}.html" aria-label="{escape(card.title)}">{card.svg}</a>
<h2><a href="{card.name}.html">{escape(card.title)}</a></h2>
<p>{card.about}</p>
<ul>{answers}{more}</ul>
</article>
"""


STYLE = """
:root { color-scheme: light dark; {{light}} }
@media (prefers-color-scheme: dark) {
  :root { {{dark}} }
}
body { margin: 0; padding: 2rem clamp(1rem, 4vw, 4rem); background: var(--paper); color: var(--ink);
  font: 1rem/1.5 system-ui, sans-serif; }
header { max-width: 44rem; margin-bottom: 2rem; }
h1 { font-size: 1.9rem; margin: 0; }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(19rem, 1fr)); gap: 1.5rem; }
article { border: 1px solid var(--faint); border-radius: 0.6rem; padding: 1rem 1.25rem; min-width: 0; }
.figure { display: flex; height: 12rem; justify-content: center; align-items: center; }
.figure svg { max-width: 100%; max-height: 100%; width: auto; height: 100%; }
h2 { font-size: 1.1rem; margin: 0.5rem 0 0.25rem; }
a { color: var(--ink); text-decoration: none; }
h2 a:hover { color: var(--accent); }
p { margin: 0.25rem 0; color: var(--muted); font-size: 0.95rem; }
ul { list-style: none; margin: 0.75rem 0 0; padding: 0; font-size: 0.9rem; }
li { margin: 0.4rem 0; overflow: auto hidden; padding: 0.1rem 0; }
li > span:first-child { color: var(--muted); }
.formula { display: inline-block; font-size: 1.1em; }
.more { color: var(--muted); }
@media print { article { break-inside: avoid; } }
"""


if __name__ == "__main__":
    main()
