"""A model file's text, or why it cannot be had: no such file, a folder, too large, not UTF-8."""

from __future__ import annotations

import difflib
import os
import stat
from pathlib import Path
from typing import NoReturn

from freebody.errors import ModelError, Problem
from freebody.language.document.tree import MAX_BYTES
from freebody.messages import Message

_READ_NOW = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)


def text_of(path: Path) -> str:
    def refuse(message: Message, line: int | None = None) -> NoReturn:
        raise ModelError([Problem((), message, line)], str(path))

    try:
        if path.is_dir():
            refuse(Message("is a folder, not a model file.{hint}", hint=_did_you_mean(path, path)))
        if not path.exists():
            refuse(Message("there is no such file.{hint}", hint=_did_you_mean(path, path.parent)))
        # a pipe or a device may never end, and opening it may wait for ever: what is opened is looked at again
        if not path.is_file():
            refuse(Message("is not a regular file"))
        with open(os.open(path, _READ_NOW), "rb") as stream:
            if not stat.S_ISREG(os.fstat(stream.fileno()).st_mode):
                refuse(Message("is not a regular file"))
            content = stream.read(MAX_BYTES + 1)
    except OSError as error:
        refuse(Message("cannot be read: {why}", why=error.strerror))
    except ValueError as error:  # a zero byte in the name
        refuse(Message("cannot be read: {why}", why=error))
    if len(content) > MAX_BYTES:
        refuse(
            Message(
                "is larger than {most} MB; a model file is a few kB. Is it the right file?", most=MAX_BYTES // 1_000_000
            )
        )
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        refuse(Message("is not UTF-8 text; save it as UTF-8"), content.count(b"\n", 0, error.start) + 1)


def _did_you_mean(path: Path, folder: Path) -> str:
    try:
        names = sorted(p.name for p in folder.iterdir() if p.suffix == ".yaml")
    except OSError:
        return "" if folder.is_dir() else Message(" There is no folder {folder} either.", folder=folder)
    close = difflib.get_close_matches(path.name, names, n=1)
    if close:
        return Message(" Did you mean {x}?", x=folder / close[0])
    shown = ", ".join(names[:8]) + (" ..." if len(names) > 8 else "")
    return Message(" That folder has: {shown}.", shown=shown) if names else ""
