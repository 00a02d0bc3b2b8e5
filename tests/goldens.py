"""Goldens: what studies of the bundled examples said when it was last looked at.

A golden is a JSON document in `tests/golden/<study>/<example>.json`. It says nothing about what is true (other tests
do); it holds that a change which is not meant to change an answer changes none. Text and whole numbers are compared as
they stand, decimals as numbers: their last digits differ between processors.

python tests/test_golden.py --write [example ...]      writes them anew, to be read in the diff before it is committed
"""

from __future__ import annotations

import difflib
import hashlib
import json
import math
import os
import re
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).parent / "golden"
WRITE = "FREEBODY_WRITE_GOLDENS"
RELATIVE, ABSOLUTE = 1e-7, 1e-8  # of decimals: beyond the round-off of a motion at tolerance 1e-9
COARSE = 1e-3  # of the size of all decimals of a page, which are rounded one by one
MOST_LINES = 60  # of a difference that are shown

_NUMBER = re.compile(r"(?<![\w.#])[-~]?\d+(?:\.\d+)?(?:[eE][+-]?\d+)?(?!\w|\.\w)")
_COURSE = re.compile(r'(?<= d=")[^"]*')
_COORDINATE = re.compile(r"-?\d+(?:\.\d+)?(?:e-?\d+)?")  # the letters of a course stand beside its numbers
_PICTURE = re.compile(r"<svg.*?</svg>", re.DOTALL)
_KEY = re.compile(r"freebody-[0-9a-f]{8}\b")  # of a picture: a hash of what it draws, with the last digits of numbers
_UNSTEADY = ("worst_relative_difference", "largest_drift")  # round-off alone
_UNSTEADY_WORDS = re.compile(r"(difference|drift|differ by) [^\s<]+?(?=[,;.)]*(?:\s|<|$))")


def assert_golden(study: str, example: str, document: Any) -> None:
    """Raises AssertionError with the difference if a document is not the one that was written before. Under
    `FREEBODY_WRITE_GOLDENS=1` it is written instead."""
    path = FOLDER / study / f"{example}.json"
    found = json.loads(json.dumps(_steady(document), ensure_ascii=False))
    if os.environ.get(WRITE):
        path.parent.mkdir(parents=True, exist_ok=True)
        before = json.loads(path.read_text(encoding="utf-8")) if path.exists() else None
        if before is None or _lines_that_differ(_lines(before), _lines(found)):
            path.write_text("\n".join(_lines(found)) + "\n", encoding="utf-8")
        return
    assert path.exists(), f"{path.name} of {study} was never written: python tests/test_golden.py --write {example}"
    before = json.loads(path.read_text(encoding="utf-8"))
    difference = _lines_that_differ(_lines(before), _lines(found))
    said = f"{study} of {example} is not what it was; if it should not be: python tests/test_golden.py --write"
    assert not difference, "\n".join([said, *difference])


def digest(page: str) -> dict[str, Any]:
    """A page or picture in short: a hash of its text without decimals, and how many these are with the sum of
    their sizes, so that round-off changes neither. Pictures count apart: they have the most numbers."""
    pictures = _COURSE.sub(lambda course: _COORDINATE.sub(r" \g<0> ", course[0]), "".join(_PICTURE.findall(page)))
    return {"text": _short(_PICTURE.sub("<svg/>", page)), "pictures": _short(pictures)}


def _short(text: str) -> dict[str, Any]:
    text = _KEY.sub("freebody-*", _UNSTEADY_WORDS.sub(r"\1 *", text))
    decimals = [float(n) for n in _NUMBER.findall(text) if not _is_whole(n)]
    # a coordinate may be written 4 or 4.0001: pictures are told by their text without any number
    words = _NUMBER.sub("#", text)
    return {
        "sha256": hashlib.sha256(" ".join(words.split()).encode()).hexdigest()[:16],
        "numbers": len(_NUMBER.findall(text)),
        "size": f"~{math.fsum(map(abs, decimals)):.3f}",
    }


def _steady(document: Any) -> Any:
    """Without what is nothing but round-off; numbers of NumPy as plain ones, what is not finite as a word."""
    if isinstance(document, dict):
        return {str(k): _steady(v) for k, v in document.items() if k not in _UNSTEADY}
    if isinstance(document, list | tuple):
        return [_steady(v) for v in document]
    if hasattr(document, "tolist"):
        return _steady(document.tolist())
    if isinstance(document, float):
        return float(f"{document:.10g}") if math.isfinite(document) else str(document)
    return _UNSTEADY_WORDS.sub(r"\1 *", document) if isinstance(document, str) else document


def _lines(document: Any) -> list[str]:
    return json.dumps(document, indent=1, ensure_ascii=False).splitlines()


def _lines_that_differ(before: list[str], after: list[str]) -> list[str]:
    """A unified difference of both; nothing if they agree."""
    if len(before) == len(after) and all(_agree(a, b) for a, b in zip(before, after, strict=True)):
        return []
    # lines that agree but for round-off are made alike, so that the difference shows the others only
    words = [[_NUMBER.sub("#", line) for line in lines] for lines in (before, after)]
    after = list(after)
    for i, j, n in difflib.SequenceMatcher(None, *words, autojunk=False).get_matching_blocks():
        for k in range(n):
            after[j + k] = before[i + k] if _agree(before[i + k], after[j + k]) else after[j + k]
    shown = list(difflib.unified_diff(before, after, "before", "now", n=1, lineterm=""))
    more = [f"... and {len(shown) - MOST_LINES} lines more"] if len(shown) > MOST_LINES else []
    return [*shown[:MOST_LINES], *more]


def _agree(a: str, b: str) -> bool:
    if a == b:
        return True
    if " ".join(_NUMBER.sub("#", a).split()) != " ".join(_NUMBER.sub("#", b).split()):
        return False
    pairs = zip(_NUMBER.findall(a), _NUMBER.findall(b), strict=True)
    return all(x == y or (not (_is_whole(x) and _is_whole(y)) and _close(x, y)) for x, y in pairs)


def _close(x: str, y: str) -> bool:
    relative = COARSE if x.startswith("~") else RELATIVE
    return math.isclose(float(x.strip("~")), float(y.strip("~")), rel_tol=relative, abs_tol=ABSOLUTE)


def _is_whole(number: str) -> bool:
    return not set(number) & set(".eE")
