"""Runs questions that were written for PrairieLearn through PrairieLearn's own element code.

    PYTHONPATH=<checkout>/apps/prairielearn/python python3.13 prairielearn_driver.py <package> ...

Each answer of `selftests.json` is submitted as a student would; printed is a list, for each package, of what became of
them: `question`, `what`, `response`, `wanted`, `score`, `said` (whether the wanted feedback was given), `seconds`,
`error`. The phases follow each other as in its server (`question-servers/freeform.ts`): `generate` is server.py
alone; `prepare`, `parse` and `grade` are the elements of question.html, the score, then server.py. With the right
answer all three panels are rendered, with others that of the submission.
"""

from __future__ import annotations

import copy
import json
import sys
import time
from pathlib import Path
from typing import Any

import chevron  # type: ignore[import-not-found]
import lxml.html  # type: ignore[import-not-found]
import prairielearn as pl  # type: ignore[import-not-found]
from prairielearn.internal.check_data import check_data  # type: ignore[import-not-found]
from prairielearn.internal.question_phases import CORE_ELEMENTS_PATH, process  # type: ignore[import-not-found]

PATHS = (
    "client_files_question_url",
    "client_files_question_dynamic_url",
    "client_files_course_url",
    "course_element_files_url",
    "course_element_extension_files_url",
    "submission_files_url",
    "base_url",
    "workspace_url",
)


def elements() -> dict[str, Any]:
    """What PrairieLearn's loader knows of its elements: the controller of each."""
    found = {}
    for info in sorted(CORE_ELEMENTS_PATH.glob("*/info.json")):
        name = info.parent.name
        found[name] = {"name": name, "type": "core", **json.loads(info.read_text("utf-8"))}
    return found


class Variant:
    """One variant of a question, prepared as the server does it once for a student."""

    def __init__(self, course: Path, question: str, seed: int) -> None:
        self.course, self.folder = course, course / "questions" / question
        self.info = json.loads((self.folder / "info.json").read_text("utf-8"))
        self.html = (self.folder / "question.html").read_text("utf-8")
        self.server: dict[str, Any] = {"__file__": str(self.folder / "server.py")}
        source = (self.folder / "server.py").read_text("utf-8")
        exec(compile(source, str(self.folder / "server.py"), "exec"), self.server)
        options = {
            "question_path": str(self.folder),
            "client_files_question_path": str(self.folder / "clientFilesQuestion"),
        }
        self.data: dict[str, Any] = {
            "params": {}, "correct_answers": {}, "variant_seed": seed, "options": options, "preferences": {},
        }  # fmt: skip
        self._server("generate", self.data)
        self.data["answers_names"] = {}
        self._both("prepare", self.data)
        del self.data["answers_names"]
        json.dumps(self.data, allow_nan=False)

    def _server(self, phase: Any, data: dict[str, Any]) -> None:
        if phase in self.server:
            before = copy.deepcopy(data)
            self.server[phase](data)
            check_data(before, data, phase)

    def _elements(self, phase: Any, data: dict[str, Any]) -> str | None:
        context = {
            "html": chevron.render(self.html, data),
            "elements": ELEMENTS,
            "element_extensions": {},
            "course_path": str(self.course),
        }
        return process(phase, data, context)[0]  # type: ignore[arg-type]

    def _both(self, phase: Any, data: dict[str, Any]) -> None:
        self._elements(phase, data)
        self._server(phase, data)

    def render(self, data: dict[str, Any], panels_wanted: tuple[str, ...]) -> dict[str, str]:
        """Panels of the page."""
        panels = {}
        for panel in panels_wanted:
            seen = copy.deepcopy(data)
            for key, default in (("submitted_answers", {}), ("raw_submitted_answers", {}), ("partial_scores", {}),
                                 ("format_errors", {}), ("feedback", {}), ("score", 0)):  # fmt: skip
                seen.setdefault(key, copy.deepcopy(default))
            seen.update(panel=panel, editable=True, manual_grading=False, ai_grading=False, num_valid_submissions=0)
            seen.pop("gradable", None)
            seen["options"].update(dict.fromkeys(PATHS, "/files"))
            panels[panel] = self._elements("render", seen) or ""
        return panels

    def submit(self, answers: dict[str, str], panels: tuple[str, ...]) -> dict[str, Any]:
        """What becomes of a student's answers."""
        data = copy.deepcopy(self.data)
        data.update(
            submitted_answers=dict(answers), raw_submitted_answers=dict(answers), format_errors={}, feedback={},
            gradable=True,
        )  # fmt: skip
        self._both("parse", data)
        if not data["format_errors"]:
            data.update(partial_scores={}, score=0)
            self._elements("grade", data)
            parts = [(p["score"] or 0, p.get("weight", 1)) for p in data["partial_scores"].values()]
            weight = sum(w for _, w in parts)
            data["score"] = sum(s * w for s, w in parts) / (weight or 1)
            self._server("grade", data)
        json.dumps(data, allow_nan=False)
        data["panels"] = self.render(data, panels)
        return data

    def answers(self, response: str) -> dict[str, str]:
        """A response of a self-test as the fields of the page."""
        kind = self.info["tags"][-1]
        if kind == "options":
            shown = inner(f"<pl-answer>{response}</pl-answer>")
            return {"answer": next(o["key"] for o in self.data["params"]["answer"] if o["html"].strip() == shown)}
        names = [part["name"] for part in self.data["params"].get("parts", [{"name": "answer"}])]
        given = json.loads(response) if len(names) > 1 else [response]
        return dict(zip(names, given, strict=True))


def inner(html: str) -> str:
    """What stands in an element, as the parser of PrairieLearn writes it."""
    return str(pl.inner_html(lxml.html.fragment_fromstring(html))).strip()


def tried(package: Path, variants: dict[tuple[Path, str], Variant], test: dict[str, str]) -> dict[str, Any]:
    """What becomes of one self-test."""
    start = time.perf_counter()
    wanted = test["verdict"] == "correct"
    found: dict[str, Any] = {
        "question": test["question"],
        "what": test["what"],
        "response": test["response"],
        "wanted": wanted,
    }
    try:
        name, _, n = test["question"].partition("#")
        key = (package, test["question"])
        variant = variants.get(key) or variants.setdefault(key, Variant(package, name, int(n or 1) - 1))
        panels = ("question", "submission", "answer") if test["what"] == "key" else ("submission",)
        data = variant.submit(variant.answers(test["response"]), panels)
        scores = [p.get("feedback") for p in data.get("partial_scores", {}).values()]
        feedback = [*filter(None, [*data["feedback"].values(), *scores])]
        found |= {
            "score": data.get("score"),
            "said": not test["feedback"]
            or test["feedback"] in feedback
            or inner(f"<p>{test['feedback']}</p>") in feedback,
            "shown": all(panel.strip() for panel in data["panels"].values()),
            "error": "; ".join(data["format_errors"].values()),
        }
        found["passed"] = (
            found["score"] is not None and (found["score"] == 1) == wanted and found["said"] and found["shown"]
        )
    except Exception as error:
        found |= {"passed": False, "error": f"{type(error).__name__}: {error} {getattr(error, '__notes__', '')}"}
    return {**found, "seconds": round(time.perf_counter() - start, 4)}


def main() -> None:
    results = []
    for package in [Path(place).resolve() for place in sys.argv[1:]]:  # elements change the folder
        tests = json.loads((package / "selftests.json").read_text("utf-8"))["tests"]
        variants: dict[tuple[Path, str], Variant] = {}
        results.append({"package": package.name, "tests": [tried(package, variants, test) for test in tests]})
    json.dump(results, sys.stdout)


ELEMENTS = elements()

if __name__ == "__main__":
    main()
