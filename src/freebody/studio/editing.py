"""Changes of a text: a value at a path, a new element, and what a question that is being typed means."""

from __future__ import annotations

from typing import Any

from freebody.errors import InputError, ModelError
from freebody.language.document import Document
from freebody.language.document.scalars import resolved
from freebody.language.document.writer import flow_text
from freebody.messages import Message
from freebody.studio.reading import checked_system, document_of
from freebody.studio.telling import told
from freebody.studio.wire.texts import (
    AddRequest,
    EditRequest,
    SuggestAnswer,
    Suggestion,
    SuggestRequest,
    TextAnswer,
)


def edit(request: EditRequest) -> TextAnswer:
    """Raises InputError where the text cannot be changed in place."""
    document, path = document_of(request.text), tuple(request.path)
    if request.value is None:
        return TextAnswer(text=document.without(path).dumps())
    return TextAnswer(text=document.with_value(path, _scalar(request.value)).dumps())


def _scalar(text: str) -> Any:
    """What is meant by a text in a field: [0, 1] is a list, as in the file."""
    try:
        return Document.read(f"value: {text.strip()}").data["value"]
    except InputError:
        return resolved(text.strip())


def add(request: AddRequest) -> TextAnswer:
    """A new element at the end of its section, under its name or the next that is free. It may be the first of all."""
    value = _scalar(request.value)
    if not any(line.split("#")[0].strip() for line in request.text.splitlines()):
        first = f"- {flow_text(value)}" if request.section == "questions" else f"{request.name}: {flow_text(value)}"
        above = request.text.rstrip()
        return TextAnswer(text=f"{above}{above and chr(10)}{request.section}:\n  {first}\n")
    return TextAnswer(text=with_element(document_of(request.text), request.section, request.name, value)[0])


def with_element(document: Document, section: str, name: str, value: Any) -> tuple[str, str]:
    """The text with one more element of a section, and its name: the given one or the next that is free."""
    known: Any = document.data.get(section) or {}
    if section == "questions" and not (isinstance(known, dict) and known):
        return document.with_item(("questions",), value).dumps(), ""
    if not isinstance(known, dict):
        raise InputError(Message("{section} is no mapping of names", section=section))
    free, number = name, 2
    while free in known:
        free, number = f"{name}{number}", number + 1
    return document.with_value((section, free), value).dumps(), free


def suggest(request: SuggestRequest) -> SuggestAnswer:
    """What a question means, and complete ones that are near."""
    from freebody.questions.spoken.suggesting import suggestions

    system = checked_system(request.text)

    def read(text: str) -> object | None:
        try:
            return system.question(text).quantity
        except InputError:
            return None

    understood, message = "", ""
    if request.question.strip():
        try:
            meant = [asked.understood or asked.text for asked in system.asked_with(request.question)[1]]
            understood = "; ".join(told(each, request.language) for each in meant)
        except ModelError as error:
            message = told(error.problems[0].message, request.language)
        except InputError as error:
            message = told(str(error), request.language)
    near = suggestions(system.names, request.question, (), read)
    offered = [Suggestion(question=each, said=told(each, request.language)) for each in near]
    return SuggestAnswer(understood=understood, message=message, suggestions=offered)
