"""What the writers themselves have to say, in English unless the report brings its own words."""

from __future__ import annotations

from freebody.present.report.blocks import Report

ENGLISH = {
    "hint": "Hint",
    "show the step": "Show the step",
    "show next": "Show the next step",
    "show all": "Show all",
    "equation": "equation",
    "figure": "figure",
    "contents": "Contents",
    "right": "right",
    "wrong": "wrong",
    "by one formula": "by one named formula",  # of a long result on a terminal, and where it is shown
    "by formulas in turn": "by {n} named formulas in turn",
    "a long formula": "a formula of {n} operations",
    "characters": "{n} characters",
    "where it is": "--full or --formula long shows it, --json has it, too",
    "where they are": "--full or --formula long shows them, --json has them, too",
    "babel": "english",  # the name by which LaTeX knows the language
}


def word(report: Report, key: str) -> str:
    return report.words.get(key) or ENGLISH[key]


def capital(text: str) -> str:
    """Its first letter in upper case, the others as they are."""
    return text[:1].upper() + text[1:]
