"""The kinds of things that a model can contain."""

from __future__ import annotations

from importlib import import_module


def register_kinds() -> None:
    """Imports every file of questions and shapes, each of which registers its kind; connections and loads are imported
    when they are named."""
    import_module("freebody.questions")
    import_module("freebody.model.composite")
