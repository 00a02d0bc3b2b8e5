"""Pictures and studies of a model, on the page and as files."""

from __future__ import annotations

import json
import tempfile
import zipfile
from base64 import b64encode
from io import BytesIO
from pathlib import Path
from typing import Any

from freebody.errors import InputError
from freebody.language.notation.parts import decimals_with
from freebody.messages import Message
from freebody.model.noting import did_you_mean
from freebody.present.report.formats.html import html_content
from freebody.present.report.result import Result
from freebody.present.report.results import finite
from freebody.studies import STUDIES, Study
from freebody.studio.meanings import meanings
from freebody.studio.reading import checked_system
from freebody.studio.telling import decimal_of
from freebody.studio.wire.studies import (
    ExportRequest,
    File,
    FilesAnswer,
    PageRequest,
    PictureAnswer,
    PictureRequest,
    StudyAnswer,
    StudyRequest,
)
from freebody.study.pictures.picture import free_body, picture
from freebody.study.simulation.files import SUFFIXES, write


def drawn(request: PictureRequest) -> PictureAnswer:
    """The model as it stands, or bodies of it cut free."""
    system = checked_system(request.text)
    options: dict[str, Any] = {"at": request.at, "show": request.show}
    with decimals_with(decimal_of(request.language)):
        made = free_body(system, *request.free, **options) if request.free else picture(system, **options)
    content: str | bytes
    match request.format:
        case "svg":
            content = made.svg(dark=request.dark, is_marked=bool(request.free))
        case "tex":
            content = made.tikz()
        case "png":
            content = made.png(dark=bool(request.dark))
        case _:
            content = made.pdf(dark=bool(request.dark))
    return PictureAnswer(content=_coded(content), meanings=meanings(system) if request.free else [])


def studied(request: StudyRequest) -> StudyAnswer:
    """What a study finds, as a part of a page."""
    found = _found(request)
    html = html_content(found.told, request.prefix, is_marked=True)
    return StudyAnswer(
        html=html,
        plain=finite(found.to_plain()),
        is_complete=found.is_complete,
        meanings=meanings(checked_system(request.text)) if "<mi" in html else [],
    )


def exported(request: ExportRequest) -> FilesAnswer:
    """The files of what a study finds."""
    found = _found(request)
    if request.format == "json":
        text = json.dumps(finite(found.to_plain()), indent=2, ensure_ascii=False)
        return FilesAnswer(files=[File(name=f"{request.name}.json", content=_coded(text))])
    with tempfile.TemporaryDirectory(prefix="freebody-") as folder:
        first, *others = found.write(Path(folder) / f"{request.name}.{request.format}")
        if not others:
            return FilesAnswer(files=[File(name=first.name, content=_coded(first.read_bytes()))])
        packed = _packed(Path(folder), [first, *others])
        return FilesAnswer(files=[File(name=f"{first.name}.zip", content=_coded(packed))])


def motion_file(request: PageRequest) -> FilesAnswer:
    """The motion as a file. Raises CannotAnswer where it cannot begin, InputError where an extra is not installed."""
    system = checked_system(request.text)
    every = request.until / (request.frames - 1)
    found = STUDIES["simulate"].function(system, request.until, every=every, language=request.language)
    with tempfile.TemporaryDirectory(prefix="freebody-") as folder:
        path = Path(folder) / f"motion.{request.format}"
        if path.suffix in SUFFIXES:
            write(found.recording, path)
        else:
            found.animate(path)
        return FilesAnswer(files=[File(name=path.name, content=_coded(path.read_bytes()))])


def _packed(folder: Path, paths: list[Path]) -> bytes:
    """Files that name each other, where they name each other: a browser puts what it is given side by side."""
    buffer = BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as out:
        for path in paths:
            entry = zipfile.ZipInfo(path.relative_to(folder).as_posix())  # without a date
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
            out.writestr(entry, path.read_bytes())
    return buffer.getvalue()


def _found(request: StudyRequest) -> Result:
    study = _study(request.name)
    known = {option.parameter: option for option in study.options if option.kind is not Path}
    given: dict[str, Any] = {}
    for name, word in request.options.items():
        if name not in known:
            raise InputError(
                Message("{what} has no {key}.{hint}", what=study.name, key=name, hint=did_you_mean(name, known))
            )
        given[name] = known[name].given(word)
    if "language" in known:
        given.setdefault("language", request.language)
    system = checked_system(request.text)
    return study.function(system, **{name: value for name, value in given.items() if value is not None})


def _study(name: str) -> Study:
    """One that has a report. Whatever writes a file of its own by a path is not for the page."""
    known = {
        each.name: each
        for each in STUDIES.values()
        if each.command and not any(option.default is ... for option in each.options)
    }
    if name not in known:
        raise InputError(Message("there is no study {name}.{hint}", name=name, hint=did_you_mean(name, known)))
    return known[name]


def _coded(content: str | bytes) -> str:
    return b64encode(content.encode() if isinstance(content, str) else content).decode()
