"""The documentation as a site: python -m sphinx -W docs OUT."""

from __future__ import annotations

import re
import shutil
import sys
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "tools"))

project = "freebody"
author = "the freebody authors"
extensions = ["myst_parser", "sphinx.ext.autodoc"]
source_suffix = {".md": "markdown"}
exclude_patterns = ["gallery", "_build"]
html_theme = "furo"
html_title = "freebody"
html_static_path = ["static"]
html_css_files = ["site.css"]
myst_heading_anchors = 3
smartquotes_action = "qe"  # two hyphens are those of an option
suppress_warnings = ["misc.highlighting_failure"]

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_preserve_defaults = False  # studies that take a language have a signature besides their source
autodoc_default_options = {"exclude-members": "model_config, kind, kinds, called, example"}

_LITERAL = re.compile(r"`([^`]*)`")


def _write_reference(_app: Any) -> None:
    """The pages of the reference are written before the site is read."""
    from reference import write
    from reference.pictures import draw

    from freebody import System

    write(HERE / "reference")
    draw(System.load(HERE.parent / "examples" / "atwood_machine.yaml"), "atwood_machine", HERE / "pictures")


def _add_pictures(_app: Any, page: str, source: list[str]) -> None:
    """Models that a page shows are drawn."""
    from reference.pictures import with_pictures

    source[0] = with_pictures(page, source[0], HERE / "pictures")


def _short_signature(
    _app: Any, what: str, _name: str, one: Any, _options: Any, signature: str | None, returned: str | None
) -> tuple[str | None, str | None] | None:
    """What nobody makes by hand needs no arguments; unions of types have the names that they have in the code."""
    from freebody import SimulationOptions, Simulator
    from freebody.model.spec import Formula, Heading, Spec

    if what == "class" and not issubclass(one, (Spec, Exception, SimulationOptions, Simulator)):
        return "", None
    if signature is None:
        return None
    for name, union in (("Heading", Heading), ("Formula", Formula)):
        signature = signature.replace(str(union), name)
    return signature, returned


def _plain_docstring(_app: Any, _what: str, _name: str, _object: object, _options: Any, lines: list[str]) -> None:
    """Docstrings are plain text with code between backticks; nothing else in them is markup."""
    for k, line in enumerate(lines):
        parts = _LITERAL.split(line)
        plain = [re.sub(r"([*|_\\])", r"\\\1", part) for part in parts[::2]]
        code = [f"``{part}``" for part in parts[1::2]]
        lines[k] = "".join(x for pair in zip(plain, [*code, ""], strict=True) for x in pair)


def _add_gallery(app: Any, error: Exception | None) -> None:
    """The gallery is made of pages of its own, which stand beside the site as they are."""
    if error is None and app.builder.format == "html":
        shutil.copytree(HERE / "gallery", Path(app.outdir) / "gallery", dirs_exist_ok=True)


def setup(app: Any) -> None:
    app.connect("builder-inited", _write_reference)
    app.connect("source-read", _add_pictures)
    app.connect("autodoc-process-signature", _short_signature)
    app.connect("autodoc-process-docstring", _plain_docstring)
    app.connect("build-finished", _add_gallery)
