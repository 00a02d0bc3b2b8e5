"""The shape of an exam for Numbas: what stands in each one, and the notes by which its parts mark.

Numbas compares formulas at random numbers of its own. Here it is given the points instead, as a variable of the
question: the note `vset` of its marking is replaced, and where only changes count also `agree`, which compares there.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

from freebody.exercises.formulas import SAME

HEADER = "// Numbas version: finer_feedback_settings\n"
VARIANT, POINTS, LATER, LOW, HIGH = "fb_variant", "fb_points", "fb_later", "fb_low", "fb_high"

_NAMED = "map(dict(map([normalise_subscripts(k), p[k]], k, keys(p))), p, {})"
_POINTS = f"vset: {_NAMED.format(POINTS)}"
_CHANGES = f"""{_POINTS}

later: {_NAMED.format(LATER)}

agree:
    apply(vset);
    map(
        try(
            let(
                scope, case_sensitive(evaluation_scope, settings["caseSensitive"]),
                resultsequal(
                    eval(studentCompare, scope, vset[k]) - eval(studentCompare, scope, later[k]),
                    eval(correctCompare, scope, vset[k]) - eval(correctCompare, scope, later[k]),
                    settings["checkingType"],
                    settings["checkingAccuracy"]
                )
            ),
            message,
            warn(translate("part.jme.answer invalid", ["message": message]));
            fail(translate("part.jme.answer invalid", ["message": message]));
            false
        ),
        k,
        0..len(vset)-1
    )"""


def exam(name: str, questions: Sequence[Mapping[str, Any]]) -> bytes:
    """A file of all questions, in one group."""
    group: dict[str, Any] = {
        "name": "Group",
        "pickingStrategy": "all-ordered",
        "pickQuestions": 1,
        "questionNames": [""] * len(questions),
        "variable_overrides": [[] for _ in questions],
        "questions": list(questions),
    }
    content: dict[str, Any] = {
        "name": name,
        "metadata": {"description": "", "licence": "None specified"},
        "duration": 0,
        "percentPass": 0,
        "showQuestionGroupNames": False,
        "shuffleQuestionGroups": False,
        "showstudentname": True,
        "question_groups": [group],
        "navigation": {
            "allowregen": True,
            "reverse": True,
            "browse": True,
            "allowsteps": True,
            "showfrontpage": True,
            "showresultspage": "oncompletion",
            "navigatemode": "sequence",
            "onleave": {"action": "none", "message": ""},
            "preventleave": True,
            "startpassword": "",
        },
        "timing": {
            "allowPause": True,
            "timeout": {"action": "none", "message": ""},
            "timedwarning": {"action": "none", "message": ""},
        },
        "feedback": {
            "enterreviewmodeimmediately": True,
            "showactualmarkwhen": "always",
            "showtotalmarkwhen": "always",
            "showanswerstatewhen": "always",
            "showpartfeedbackmessageswhen": "always",
            "showexpectedanswerswhen": "inreview",
            "showadvicewhen": "inreview",
            "allowrevealanswer": True,
            "intro": "",
            "end_message": "",
            "results_options": {"printquestions": True, "printadvice": True},
            "feedbackmessages": [],
        },
        "contributors": [],
        "extensions": [],
        "custom_part_types": [],
        "resources": [],
    }
    return (HEADER + json.dumps(content, ensure_ascii=False, indent=1) + "\n").encode()


def question(
    name: str, statement: str, advice: str, variables: Mapping[str, str], parts: Sequence[Mapping[str, Any]]
) -> dict[str, Any]:
    """variables: their definitions. The letters e, i and j are names like others."""
    return {
        "name": name,
        "tags": [],
        "metadata": {"description": "", "licence": "None specified"},
        "statement": statement,
        "advice": advice,
        "rulesets": {},
        "builtin_constants": {"e": False, "pi,\u03c0": True, "i": False, "j": False},
        "constants": [],
        "extensions": [],
        "variables": {key: _variable(key, definition) for key, definition in variables.items()},
        "variablesTest": {"condition": "", "maxRuns": 100},
        "ungrouped_variables": list(variables),
        "variable_groups": [],
        "functions": {},
        "preamble": {"js": "", "css": ""},
        "parts": list(parts),
        "partsMode": "all",
    }


def _variable(name: str, definition: str) -> dict[str, Any]:
    return {
        "name": name,
        "group": "Ungrouped variables",
        "definition": definition,
        "description": "",
        "templateType": "anything",
        "can_override": False,
    }


def formula_part(answer: str, marks: float, prompt: str = "", *, only_changes: bool = False) -> dict[str, Any]:
    """A formula that is compared at the points of the question."""
    return {
        **_part("jme", marks, prompt),
        "answer": answer,
        "answerSimplification": "basic",
        "showPreview": True,
        "checkingType": "reldiff",
        "checkingAccuracy": SAME,
        "failureRate": 1,
        "vsetRangePoints": 5,
        "vsetRange": ["0.5", "2"],
        "checkVariableNames": False,
        "singleLetterVariables": False,
        "allowUnknownFunctions": False,
        "implicitFunctionComposition": False,
        "caseSensitive": True,
        "valuegenerators": [],
        "customMarkingAlgorithm": _CHANGES if only_changes else _POINTS,
        "extendBaseMarkingAlgorithm": True,
    }


def number_part(low: str, high: str, marks: float, prompt: str = "", *, comma: bool = False) -> dict[str, Any]:
    """A number between two others. comma: decimals may have one."""
    return {
        **_part("numberentry", marks, prompt),
        "minValue": low,
        "maxValue": high,
        "precisionType": "none",
        "allowFractions": False,
        "notationStyles": ["plain", "plain-eu" if comma else "en", "scientific"],
        "correctAnswerStyle": "plain-eu" if comma else "plain",
    }


def choice_part(choices: Sequence[tuple[str, bool, str]], marks: float, prompt: str) -> dict[str, Any]:
    """choices: what is shown, whether it is right, what is said about it."""
    return {
        **_part("1_n_2", marks, prompt),
        "minMarks": 0,
        "maxMarks": 0,
        "shuffleChoices": True,
        "displayType": "radiogroup",
        "displayColumns": "1",
        "showCellAnswerState": True,
        "choices": [shown for shown, _right, _said in choices],
        "matrix": [str(marks) if right else "0" for _shown, right, _said in choices],
        "distractors": [said for _shown, _right, said in choices],
    }


def alternative(part: Mapping[str, Any], feedback: str) -> dict[str, Any]:
    """A wrong answer that is named: no marks, and what is said about it."""
    return {**part, "marks": 0, "alternativeFeedbackMessage": feedback, "useAlternativeFeedback": False}


def _part(kind: str, marks: float, prompt: str) -> dict[str, Any]:
    return {
        "type": kind,
        "useCustomName": False,
        "customName": "",
        "marks": marks,
        "showCorrectAnswer": True,
        "showFeedbackIcon": True,
        "scripts": {},
        "variableReplacements": [],
        "variableReplacementStrategy": "originalfirst",
        "adaptiveMarkingPenalty": 0,
        "customMarkingAlgorithm": "",
        "extendBaseMarkingAlgorithm": True,
        "unitTests": [],
        "prompt": prompt,
        "alternatives": [],
    }
