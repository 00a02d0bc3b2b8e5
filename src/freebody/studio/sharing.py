"""The page of the studio as one file: what it would ask the server is answered beforehand and kept in it, so it can be
looked at anywhere, and changed nowhere."""

from __future__ import annotations

import json
import re
from base64 import b64encode
from collections.abc import Iterator
from html import escape
from importlib.metadata import version
from importlib.resources import files
from pathlib import PurePath
from typing import Any

from freebody.language.plain_text import plain
from freebody.studio.beforehand import moved_beforehand
from freebody.studio.look import style_sheet
from freebody.studio.reading import checked_system
from freebody.studio.wire.around import OpenedFile, Opening, Reply
from freebody.studio.wire.studies import File, FilesAnswer, ShareRequest

_POLICY = (
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data: blob:; font-src data:"
)
# what answers hang on beside what stands in their key
_BESIDE = ("text", "language", "prefix", "until", "frames")


def share(request: ShareRequest) -> FilesAnswer:
    """The file. Raises ModelError where the text is no model."""
    content = shared_page(request)
    name = f"{PurePath(request.name).stem or 'model'}.html"
    return FilesAnswer(files=[File(name=name, content=b64encode(content.encode()).decode())])


def shared_page(request: ShareRequest) -> str:
    """The text of the page."""
    from freebody.studio.work import done

    system = checked_system(request.text)
    common = {"text": request.text, "language": request.language}
    replies: dict[str, Any] = {}
    for kind, given in _questions(request, [q.id for q in system.questions], [b.name for b in system.moving]):
        reply: Reply = done(kind, {**common, **given})
        replies[_key(kind, given)] = reply.model_dump(mode="json")
    opening = opening_of(request.name, request.text)
    own = replies[_key("motion", {})]["answer"]
    moved = moved_beforehand(system, request, own) if request.vary and own else None
    kept = {
        "opening": opening.model_dump(mode="json"),
        "replies": replies,
        "moved": None if moved is None else moved.model_dump(mode="json"),
    }
    return whole_page(system.title or request.name, request.language, "kept", json.dumps(kept, ensure_ascii=False))


def opening_of(name: str, text: str) -> Opening:
    """What a page begins with that has one model, and neither a folder nor anything to add."""
    file = OpenedFile(name=name, text=text, version="")
    return Opening(file=file, files=[], is_file=True, version=version("freebody"))


def _questions(request: ShareRequest, questions: list[str], bodies: list[str]) -> Iterator[tuple[str, dict[str, Any]]]:
    """All that the page asks for where nothing is typed."""
    yield "read", {}
    for kind in ("motion", "curves"):
        yield kind, {"until": request.until, "frames": request.frames}
    shown = ["velocity", "acceleration", "reaction", "load", "mass-centres"]
    yield "overlays", {"until": request.until, "frames": request.frames, "show": shown}
    yield "count", {"name": "mobility", "prefix": "count-"}
    yield "picture", {}
    yield from (("picture", {"free": [name]}) for name in bodies)
    for name, topic in (("solve", "answer"), ("mobility", "mobility"), ("conserved", "conserved")):
        yield "study", {"name": name, "options": {}, "prefix": f"{topic}-"}
    yield "study", {"name": "equations_of_motion", "options": {}, "prefix": "more-"}
    for question in questions:
        options = {"question": question, "method": "auto"}
        yield "study", {"name": "explain", "options": options, "prefix": "derivation-"}


def _key(kind: str, given: dict[str, Any]) -> str:
    """As `studio/src/server.ts` finds it."""
    own = {name: value for name, value in given.items() if name not in _BESIDE}
    return json.dumps([kind, own], sort_keys=True, separators=(",", ":"), ensure_ascii=False)


def whole_page(title: str, language: str, name: str, kept: str) -> str:
    """One file: the built page with its style, its program and what it knows. kept: that, in JSON; name: of that part
    of the page, by which the program finds it"""
    built = files("freebody.studio").joinpath("page")
    program = re.sub(
        r"</(script)", r"<\\/\1", built.joinpath("studio.js").read_text(encoding="utf-8"), flags=re.IGNORECASE
    )
    data = kept.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")
    return f"""<!DOCTYPE html>
<html lang="{language}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{_POLICY}">
<title>{escape(plain(title))}</title>
<style>
{style_sheet()}
{built.joinpath("studio.css").read_text(encoding="utf-8")}
</style>
</head>
<body>
<div id="app"></div>
<script type="application/json" id="{name}">{data}</script>
<script type="module">{program}</script>
<!--
{built.joinpath("LICENSES.txt").read_text(encoding="utf-8").replace("--", "- -")}
-->
</body>
</html>
"""
