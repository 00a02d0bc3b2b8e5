"""Results as text for a terminal."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from freebody.language.expression import Expr, n_operations
from freebody.language.notation import to_pretty_lines, to_text
from freebody.present.lines import number_text, option_lines, plural, wrapped
from freebody.present.phases import case_lines, phase_lines
from freebody.system.system import System

if TYPE_CHECKING:
    from freebody.study.answering.answer import Answer
    from freebody.study.answering.solution import Solution
    from freebody.study.eom import Equations

_RULE = "─"
LONGEST = 300  # operations of a formula that is shown; some six lines
LONGEST_CONDITION = 1200  # characters
WHERE_IT_IS = "--full shows it, --json has it for Python and LaTeX"


def system_line(system: System, dof: int, coordinates: tuple[str, ...], dependent: tuple[str, ...]) -> str:
    """One line on the system."""
    bodies = len(system.moving)
    names = ", ".join(to_text(_name(c)) for c in coordinates)
    text = (
        f"{plural(bodies, 'moving body', 'moving bodies')}, {plural(len(system.connections), 'connection')}, "
        f"{plural(dof, 'degree')} of freedom"
    )
    if coordinates:
        text += f"; {plural(len(coordinates), 'coordinate').split(' ', 1)[1]}: {names}"
    if dependent:
        text += f"; dependent: {', '.join(to_text(_name(c)) for c in dependent)}"
    return text


def _name(c: str) -> Expr:
    from freebody.language.expression import Symbol

    return Symbol(c)


def solution_lines(solution: Solution, *, is_full: bool = False) -> Iterator[str]:
    """The whole answer sheet; long formulas as they are if it `is_full`, else by their size."""
    system = solution.system
    yield system.title
    yield _RULE * min(len(system.title), 78)
    yield system_line(system, solution.degrees_of_freedom, solution.coordinates, solution.dependent)
    for text in solution.assumptions:
        yield f"assumed: {text}"
    if solution.redundant:
        yield f"redundant constraints: {', '.join(solution.redundant)}"
    if solution.phases is not None:
        yield ""
        yield from phase_lines(solution.phases)
    for answer in solution.answers:
        yield ""
        yield from answer_lines(answer, is_full=is_full)
    if not solution.answers:
        yield ""
        yield "The file asks nothing. Add questions, or see its equations with: freebody eom FILE"


def answer_lines(answer: Answer, *, is_full: bool = False) -> Iterator[str]:
    """One answer; a formula that nobody would read is told by its size, unless it `is_full`."""
    yield f"{answer.id}  {answer.question}"
    if answer.expression is None:
        word = "never: " if answer.never else "" if "no closed form" in answer.reason else "no closed form: "
        yield from _indented(f"{word}{answer.reason}", 4)
        if answer.value is not None:
            yield f"    by numbers  {_value_text(answer)}"
        return
    yield ""
    if isinstance(answer.expression, tuple):
        for k, part in enumerate(answer.expression):
            yield from _indented(_displayed(part, f"[{k + 1}] = ", is_full=is_full), 6)
    else:
        yield from _indented(_displayed(answer.expression, "= ", is_full=is_full), 6)
    yield ""
    if answer.value is not None:
        yield f"    value       {_value_text(answer)}"
    yield from _listed("valid", answer.conditions if is_full else tuple(map(_shortened, answer.conditions)))
    if answer.cases:
        yield from case_lines(answer)
    yield from _listed("note", answer.notes)
    if answer.options:
        yield from option_lines(answer.choice, answer.options)
    if answer.author_notes:
        yield from _listed("to author", answer.author_notes)
    if answer.evidence is not None:
        e = answer.evidence
        yield from wrapped("evidence", f"{e.draws} random draws: {e.route};")
        yield f"                largest relative difference {e.worst_relative_difference:.1g}"


def _shortened(condition: str) -> str:
    """A condition, or how long it is where nobody would read it."""
    if len(condition) <= LONGEST_CONDITION:
        return condition
    return f"a condition of {len(condition)} characters holds ({WHERE_IT_IS})"


def _displayed(e: Expr, prefix: str, *, is_full: bool = False) -> str:
    """The formula with `prefix` before the line on which it stands."""
    n = n_operations(e)
    if n > LONGEST and not is_full:
        return f"{prefix}a formula of {n} operations ({WHERE_IT_IS})"
    lines, baseline = to_pretty_lines(e)
    pad = " " * len(prefix)
    return "\n".join((prefix if k == baseline else pad) + line.rstrip() for k, line in enumerate(lines))


def _value_text(answer: Answer) -> str:
    unit = "" if answer.unit == "1" else f" {answer.unit}"
    if isinstance(answer.value, tuple):
        return "(" + ", ".join(map(number_text, answer.value)) + ")" + unit
    assert answer.value is not None
    return number_text(answer.value) + unit


def _indented(text: str, by: int) -> Iterator[str]:
    for line in text.splitlines():
        yield " " * by + line


def _listed(label: str, texts: tuple[str, ...]) -> Iterator[str]:
    for k, text in enumerate(texts):
        yield f"    {label if k == 0 else '':<12}{text}"


def equation_lines(equations: Equations) -> Iterator[str]:
    """Equations of motion as text."""
    system = equations.system
    yield system.title
    yield _RULE * min(len(system.title), 78)
    yield system_line(system, len(equations.coordinates), equations.coordinates, equations.dependent)
    if equations.dependent:
        yield ""
        yield "Closed loops (the dependent coordinates follow from them)"
        for loop in equations.loops:
            yield f"    0 = {to_text(loop)}"
        yield "Rates of the dependent coordinates"
        for name, rate in equations.dependent_rates.items():
            yield f"    {to_text(_name(name))}' = {to_text(rate)}"
    if equations.velocity_constraints:
        yield ""
        yield "Velocity constraints"
        for row in equations.velocity_constraints:
            yield f"    0 = {to_text(row)}"
    yield ""
    yield "Equations of motion"
    for left, right in equations.lines():
        yield f"    {to_text(left)} = {to_text(right)}"
    if len(equations.coordinates) > 1:
        yield ""
        yield "Mass matrix"
        for row in equations.mass_matrix:
            yield "    [ " + ",  ".join(map(to_text, row)) + " ]"
    if equations.redundant:
        yield ""
        yield f"redundant constraints: {', '.join(equations.redundant)}"
    for pose in equations.singular:
        yield f"not at {pose}"
