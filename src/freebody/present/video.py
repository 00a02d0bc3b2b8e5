"""The program that codes videos: that of imageio-ffmpeg, or one on the PATH."""

from __future__ import annotations

import importlib
import shutil
from importlib.util import find_spec

from freebody.errors import InputError
from freebody.messages import Message


def ffmpeg() -> str:
    """Where it is. Raises InputError where there is none."""
    try:
        program: str = importlib.import_module("imageio_ffmpeg").get_ffmpeg_exe()
    except (ImportError, RuntimeError):
        program = shutil.which("ffmpeg") or ""
    if not program:
        raise InputError(
            Message(
                'an MP4 needs ffmpeg, and there is none: pip install "freebody[video]", or write .html or .gif instead'
            )
        )
    return program


def has_ffmpeg() -> bool:
    """Whether there is one, without starting it."""
    try:
        is_package = find_spec("imageio_ffmpeg") is not None
    except ValueError:  # its name is taken by nothing
        is_package = False
    return is_package or shutil.which("ffmpeg") is not None
