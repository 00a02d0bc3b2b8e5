"""Studies: what can be found out about a system, as a method, a function and a command, from the table of studies."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator

import freebody as fb
from freebody.studies import STUDIES, Study
from reference.page import NothingSaid, Page, block, code, joined, prose, words_of

_HEAD = """A study is a method of a system, a function of `freebody` with the system as its first argument, and
most are a command. What it finds is a result: it shows itself in a notebook, prints as text, and has `to_plain`,
`to_html`, `to_latex` and `write`."""


def pages() -> Iterator[Page]:
    text = joined(["# Studies", _HEAD, *map(_section, STUDIES.values())])
    yield Page("studies", "Studies", "what can be found out about a system", 55, text)


def _section(study: Study) -> str:
    method = getattr(fb.System, study.name)
    if not study.help.strip():
        raise NothingSaid(f"the study {study.name} says nothing of itself")
    signature = re.sub(r"(: |-> )'([^']*)'", r"\1\2", str(inspect.signature(method)))  # types as they are written
    signature = re.sub(r"^\((?:self|system)(?:, )?", "(", signature)
    command = f"On the command line: [`freebody {study.command}`](commands.md)." if study.command else ""
    return joined(
        [
            f"## {code(study.name)}",
            words_of(method, f"the study {study.name}"),
            block("python", f"system.{study.name}{signature}"),
            prose(inspect.getdoc(study.function) or ""),
            command,
        ]
    )
