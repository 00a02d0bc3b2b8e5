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
    "babel": "english",  # the name by which LaTeX knows the language
}


def word(report: Report, key: str) -> str:
    return report.words.get(key) or ENGLISH[key]


def capital(text: str) -> str:
    """Its first letter in upper case, the others as they are."""
    return text[:1].upper() + text[1:]
