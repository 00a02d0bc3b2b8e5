"""The command line, from the parser itself."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import typer

from freebody.cli import commands
from freebody.examples_folder import listed_templates, templates
from reference.page import NothingSaid, Page, block, code, joined, prose, table

_HEAD = """Every command reads a model file first; all mistakes of a file come in one message, with line, column
and what to do. Exit codes: 0 answered, 1 could not answer (and says why), 2 bad input or a file that cannot be
written, 70 a defect of freebody, 130 and 143 interrupted."""
_WITHOUT_VALUE = (None, False, "", ())


def pages() -> Iterator[Page]:
    group: Any = typer.main.get_command(commands())
    parts = ["# Command line", _HEAD, *(_section(name, command) for name, command in group.commands.items())]
    yield Page("commands", "Command line", "every command with its options", 60, joined(parts))
    yield Page("templates", "Templates", "models to start from", 70, _templates())


def _section(name: str, command: Any) -> str:
    said = (command.help or "").strip()
    if not said:
        raise NothingSaid(f"the command {name} has no help")
    usage = " ".join(["freebody", name, *(_shown(each) for each in command.params)])
    rows = [_row(name, each) for each in command.params]
    return joined(
        [
            f"## {code(f'freebody {name}')}",
            prose(said),
            block("text", usage),
            table(("option", "what", "default"), rows),
        ]
    )


def _shown(each: Any) -> str:
    """How it stands in the usage: only what must be given is spelt out."""
    if each.param_type_name == "argument":
        word = (each.metavar or each.name.upper()).strip("[]")
        return word if each.required else f"[{word}]"
    return f"{each.opts[-1]} {each.name.upper()}" if each.required else ""


def _row(command: str, each: Any) -> tuple[str, str, str]:
    said = str(getattr(each, "help", None) or "")
    if not said:
        raise NothingSaid(f"{each.name} of {command} has no help")
    if each.param_type_name == "argument":
        names = code((each.metavar or each.name.upper()).strip("[]"))
    else:
        names = ", ".join(map(code, each.opts))
    default = each.default
    shown = "needed" if each.required else "" if default in _WITHOUT_VALUE or callable(default) else code(str(default))
    return names, prose(said), shown


def _templates() -> str:
    """`freebody new FILE --like NAME`, each as it is written."""
    titles = dict(listed_templates())
    sections = [
        joined(
            [
                f"## {code(name)}",
                f"{prose(titles[name])}. {code(f'freebody new model.yaml --like {name}')}",
                block("yaml", path.read_text(encoding="utf-8")),
            ]
        )
        for name, path in templates().items()
    ]
    head = (
        "`freebody new FILE --like NAME` writes one of these models, with its comments. A bundled example can be a "
        "template as well."
    )
    return joined(["# Templates", head, *sections])
