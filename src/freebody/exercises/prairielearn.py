"""What stands in every question for PrairieLearn: its pages, and the code that picks a variant and marks formulas.

The code is the same in each: all that differs is data, in `exercise.json` beside it. Formulas are compared by numbers
at the points of the data, where the mechanics admits them, and not by SymPy's `equals`, which knows no domain and may
time out.
"""

from __future__ import annotations

from freebody.exercises.formulas import SAME

_PANEL = """<pl-question-panel>
{{{params.statement}}}
<p><strong>{{{params.prompt}}}</strong></p>
{{{params.note}}}
</pl-question-panel>
"""
_ANSWER = """<pl-answer-panel>
{{{params.solution}}}
</pl-answer-panel>
"""
_FEEDBACK = """<pl-submission-panel>
{{#feedback.answer}}<p>{{{feedback.answer}}}</p>{{/feedback.answer}}
</pl-submission-panel>
"""

PAGES = {
    "formula": f"""{_PANEL}{{{{#params.parts}}}}
<p><pl-symbolic-input answers-name="{{{{name}}}}" variables="{{{{variables}}}}"
 label="{{{{label}}}}" size="60"></pl-symbolic-input></p>
{{{{/params.parts}}}}
{_FEEDBACK}{_ANSWER}""",
    "options": f"""{_PANEL}<pl-multiple-choice answers-name="answer">
{{{{#params.options}}}}
<pl-answer correct="{{{{correct}}}}" feedback="{{{{feedback}}}}">{{{{{{html}}}}}}</pl-answer>
{{{{/params.options}}}}
</pl-multiple-choice>
{_ANSWER}""",
    "number": f"""{_PANEL}<p><pl-number-input answers-name="answer" suffix="{{{{params.unit}}}}"
 comparison="{{{{params.comparison}}}}"
 rtol="{{{{params.rtol}}}}" atol="{{{{params.atol}}}}"
 digits="{{{{params.digits}}}}"></pl-number-input></p>
{_FEEDBACK}{_ANSWER}""",
}

SERVER = f'''"""Written by freebody: picks a variant, and marks what is no matter of a single number or option."""

import json
import math
import pathlib

import sympy
import prairielearn.sympy_utils as psu

EXERCISE = json.loads(pathlib.Path(__file__).with_name("exercise.json").read_text("utf-8"))


def generate(data):
    """The variant of this student."""
    variant = EXERCISE["variants"][data["variant_seed"] % len(EXERCISE["variants"])]
    data["params"].update(variant["params"])
    data["correct_answers"].update(variant["correct_answers"])


def value(formula, point):
    """Of a formula, nan where it has no real one."""
    expr = psu.json_to_sympy(formula)
    at = {{symbol: sympy.Float(point[str(symbol)], 30) for symbol in expr.free_symbols}}
    try:
        found = complex(sympy.N(expr.xreplace(at), 20))
    except (TypeError, ValueError, ArithmeticError):
        return math.nan
    return found.real if abs(found.imag) <= 1e-12 * abs(found.real) else math.nan


def values(formula):
    """At all points; how much it changes until a later instant, where only that counts."""
    found = [value(formula, point) for point in EXERCISE["points"]]
    later = [value(formula, point) for point in EXERCISE["later"]]
    return [a - b for a, b in zip(found, later)] if later else found


def same(given, wanted):
    """Whether formulas agree at all points."""
    return all(
        abs(a - b) <= {SAME} * abs(b) + 1e-9
        for own, its in zip(given, wanted) for a, b in zip(own, its)
    )


def grade(data):
    """Formulas are right that agree with the answer wherever the mechanics admits; a known mistake is named."""
    if EXERCISE["kind"] == "formula":
        names = [part["name"] for part in data["params"]["parts"]]
        given = [values(data["submitted_answers"][name]) for name in names]
        for name, own, its in zip(names, given, EXERCISE["values"]):
            data["partial_scores"][name] = {{"score": int(same([own], [its])), "weight": 1}}
        data["score"] = sum(data["partial_scores"][name]["score"] for name in names) / len(names)
        known = [w["feedback"] for w in EXERCISE["wrong"] if same(given, w["values"])]
    elif EXERCISE["kind"] == "number":
        given = float(data["submitted_answers"]["answer"])
        known = [w["feedback"] for w in data["params"]["wrong"] if abs(given - w["value"]) <= w["room"]]
    else:
        known = []
    if data["score"] < 1 and known:
        data["feedback"]["answer"] = known[0]
'''
