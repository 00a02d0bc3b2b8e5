"""An exercise sheet as a report: exercises, and where they are wanted solutions and the answer key."""

from __future__ import annotations

from freebody.language.sentences import Sentence
from freebody.narrative.sheets.answer_key import key_table
from freebody.narrative.sheets.content import SheetContent
from freebody.narrative.sheets.in_numbers import options_in_numbers
from freebody.narrative.sheets.statement import ExerciseStatement, title_of
from freebody.narrative.sheets.variants import Variant
from freebody.narrative.sheets.worked import as_solution, figure_numbers
from freebody.narrative.telling.catalogue import Catalogue
from freebody.narrative.telling.house import in_style
from freebody.present.report.blocks import (
    Block,
    Paragraph,
    Remark,
    Report,
    Section,
    Step,
    Text,
    equation_numbers,
)


class SheetWriter:
    """Writes one variant."""

    def __init__(self, sheet: SheetContent, variant: int) -> None:
        self.sheet = sheet
        self.n = variant
        self.exercises = sheet.variant(variant)
        self.catalogue = Catalogue(sheet.language)
        self.n_equations = 0
        self.n_figures = 0
        self.drawn = dict[int, list[int]]()  # of the exercises, by their number

    def report(self) -> Report:
        catalogue, sheet = self.catalogue, self.sheet
        blocks: list[Block] = [self._name_line()] if sheet.solutions == "none" else []
        solutions: list[Block] = []
        # figures are counted as they stand: those of solutions at the end after those of all exercises
        set_first = sheet.solutions == "end"
        sets = [self._counted_set(exercise, k) for k, exercise in enumerate(self.exercises, 1)] if set_first else []
        for number, exercise in enumerate(self.exercises, 1):
            title = {"n": number, "title": f"@{title_of(exercise.system, catalogue)}"}
            set_ = sets[number - 1] if set_first else self._counted_set(exercise, number)
            solved: tuple[Block, ...] = ()
            if sheet.solutions == "inline":
                solved = self._solution(exercise, number)
            elif sheet.solutions == "end":
                heading = catalogue.tell(Sentence("sheet.exercise", title))
                solutions.append(Section(heading, self._solution(exercise, number), 3))
            if exercise.is_as_in_file and exercise.system.has_values and sheet.solutions != "none":
                solved = (Remark(catalogue.tell(Sentence("sheet.no_numbers", {"n": number})), "warning"), *solved)
            blocks.append(Section(catalogue.tell(Sentence("sheet.exercise", title)), (*set_, *solved)))
        if solutions:
            blocks.append(Section((catalogue.word("sheet.solutions"),), tuple(solutions), is_apart=True))
        if sheet.solutions != "none":
            blocks.append(Section((catalogue.word("sheet.key_title"),), (key_table(catalogue, sheet.key(self.n)),)))
        title, language, words = catalogue.word("sheet.title"), catalogue.language, catalogue.report_words
        return Report(title, language, self._subtitle(), tuple(blocks), words, decimal=catalogue.decimal)

    def _counted_set(self, exercise: Variant, number: int) -> tuple[Block, ...]:
        set_ = self._set(exercise, number)
        self.drawn[number] = figure_numbers(set_)
        self.n_figures = max([self.n_figures, *self.drawn[number]])
        return set_

    def _set(self, exercise: Variant, number: int) -> tuple[Block, ...]:
        """The exercise as it is set."""
        system, numbers = exercise.system, dict[str, Text]()
        if self.sheet.in_numbers:
            for question, answer in zip(system.questions, exercise.solution.answers, strict=True):
                numbers |= options_in_numbers(system, question, answer)
        figure, room = self.n_figures + 1, self.sheet.room
        statement = ExerciseStatement(system, self.catalogue, number, figure, room=room, numbers=numbers)
        return in_style(statement.blocks(), system.style, self.catalogue.decimal)

    def _name_line(self) -> Paragraph:
        points = self.sheet.points
        key = "sheet.name_line_of" if points else "sheet.name_line"
        return Paragraph((self.catalogue.plain(Sentence(key, {"points": f"@{points:g}"})),))

    def _subtitle(self) -> str:
        if self.sheet.variants == 1:
            return self.catalogue.word("sheet.sheet")
        return self.catalogue.plain(Sentence("sheet.variant", {"n": self.n}))

    def _solution(self, exercise: Variant, number: int) -> tuple[Block, ...]:
        """The worked solution of every question, its numbers going on from those of the exercise before."""
        from freebody.narrative.explain import explain

        explanation = explain(exercise.system, language=self.sheet.language)
        blocks, n = explanation.report.blocks, self.n_equations
        inside = as_solution(blocks, self.drawn[number], equations=n, figures=self.n_figures)
        self.n_equations = max([n, *equation_numbers(inside)])
        self.n_figures = max([self.n_figures, *figure_numbers(inside)])
        title = self.catalogue.tell(Sentence("sheet.solution", {"n": number}))
        return (Step(title, (), inside),) if self.sheet.solutions == "inline" else inside
