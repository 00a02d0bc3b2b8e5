"""Typed answers: the verdicts of `freebody check` beside the naive `simplify(answer - typed) == 0` in SymPy.

    python benchmarks/typed_answers.py [EXAMPLE ...]

The answers are those of tests/typed_answers.tsv, with verdicts worked out by hand. "Right" for the naive comparison is
what is correct; it knows no other form, convention or condition. Each typed text is given to SymPy's `parse_expr` with
implicit multiplication after the most common replacements (^, Greek letters); this is the authors' own table, and never
users' text.
"""

from __future__ import annotations

import statistics
import sys
import time
from collections import Counter
from pathlib import Path
from typing import Any

import sympy
from sympy.parsing.sympy_parser import (
    convert_xor,
    implicit_multiplication,
    parse_expr,
    standard_transformations,
)

import freebody as fb
from freebody.language.notation import to_python
from freebody.language.parser import GREEK
from freebody.narrative.marking.check import marked_question

ROOT = Path(__file__).parents[1]
_SAME = {
    "π": "pi",
    "·": "*",
    "−": "-",
    "²": "**2",
    "³": "**3",
    "⁴": "**4",
    "√": "sqrt",
    "½": "(1/2)",
    "₀": "0",
    "₁": "1",
}


def naive(typed: str, answer: str, names: set[str]) -> str:
    """right, wrong or error."""
    text = typed
    for letter, name in {**_SAME, **{k: f" {v} " for k, v in GREEK.items()}}.items():
        text = text.replace(letter, name)
    local: dict[str, Any] = {name: sympy.Symbol(name, positive=True) for name in names}
    rules = (*standard_transformations, convert_xor, implicit_multiplication)
    try:
        mine = parse_expr(text, local_dict=local, transformations=rules)
        its = parse_expr(answer, local_dict=local)
        return "right" if sympy.simplify(mine - its) == 0 else "wrong"
    except Exception:  # whatever SymPy raises for what it cannot read
        return "error"


def main(only: list[str]) -> None:
    rows = [line.split("\t") for line in (ROOT / "tests/typed_answers.tsv").read_text("utf-8").splitlines()[1:]]
    systems: dict[str, fb.System] = {}
    counts: Counter[tuple[str, str, str]] = Counter()
    seconds: dict[str, list[float]] = {"freebody": [], "naive": []}
    for example, question, verdict, typed in rows:
        if only and example not in only:
            continue
        system = systems.setdefault(example, fb.System.load(ROOT / f"examples/{example}.yaml"))
        marked = marked_question(system, question)
        expression = marked.answer.expression
        if expression is None or isinstance(expression, tuple) or marked.judging is None:
            continue
        is_right = "right" if verdict == "correct" else "not right"
        start = time.perf_counter()
        found = system.check(question, typed).verdict
        seconds["freebody"].append(time.perf_counter() - start)
        told = {"correct": "right", "unreadable": "error"}.get(found, "wrong")
        counts["freebody", is_right, told] += 1
        start = time.perf_counter()
        told = naive(typed, to_python(expression), set(marked.judging.vocabulary.names))
        seconds["naive"].append(time.perf_counter() - start)
        counts["naive", is_right, told] += 1
    for who in ("freebody", "naive"):
        for is_right in ("right", "not right"):
            told = {t: counts[who, is_right, t] for t in ("right", "wrong", "error")}
            print(f"{who:9} answers that are {is_right:9}: {told}")
        print(f"{who:9} median {1000 * statistics.median(seconds[who]):.0f} ms, most {max(seconds[who]):.1f} s")


if __name__ == "__main__":
    main(sys.argv[1:])
