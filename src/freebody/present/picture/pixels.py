"""Pictures as PNG and PDF, drawn with Matplotlib."""

from __future__ import annotations

import re
from collections.abc import Sequence
from io import BytesIO
from typing import Any

import numpy as np

from freebody.language.plain_text import plain, shortened
from freebody.present.picture.content import PictureContent
from freebody.present.picture.label import Label
from freebody.present.picture.shapes import Ink, Shape, Word
from freebody.present.theme import THEMES, Theme

_DPI = 200
_SPECIAL = {c: f"\\{c}" for c in "#$%&_{}"} | {" ": r"\ ", "\u2009": r"\,"}
_DOTTED, _TWICE_DOTTED = re.compile("(.)\u0307"), re.compile("(.)\u0308")
_PER_INCH = 72.0
_MOST = 500  # characters of a title in the data of a file


def rendered(picture: PictureContent, kind: str, *, dark: bool = False) -> bytes:
    """kind: png, pdf, or another one that Matplotlib writes."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    theme = THEMES["dark" if dark else "light"]
    low, high = picture.corners
    figure: Any = Figure(figsize=tuple((high - low) / _PER_INCH), facecolor=theme.paper)
    FigureCanvasAgg(figure)
    axes: Any = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])
    shown = [shape for shape in picture.shapes if shape.scheme in ("", "dark" if dark else "light")]
    paint(shown, axes, dark=dark)
    for word in picture.words:
        _write(word, axes, theme, dark=dark)
    out = BytesIO()
    key = "Title" if kind != "png" else "Description"
    figure.savefig(
        out, format=kind, dpi=_DPI, facecolor=theme.paper, metadata={key: shortened(plain(picture.title), _MOST)}
    )
    return out.getvalue()


def paint(shapes: Sequence[Shape], axes: Any, *, dark: bool = False) -> Any:
    """Draws shapes, in units of the axes, one over the other; returns what was drawn. Widths and dashes are in points
    whatever the units."""
    from matplotlib.collections import PathCollection
    from matplotlib.path import Path

    theme = THEMES["dark" if dark else "light"]
    rims = [np.concatenate((s.points, s.points[:1])) if s.is_closed else s.points for s in shapes]
    clear = (0.0, 0.0, 0.0, 0.0)
    collection = PathCollection(
        [Path(rim, closed=shape.is_closed) for rim, shape in zip(rims, shapes, strict=True)],
        facecolors=[clear if s.fill is None else _rgba(s.fill, theme, dark=dark) for s in shapes],
        edgecolors=[clear if s.stroke is None else _rgba(s.stroke, theme, dark=dark) for s in shapes],
        linewidths=[0.0 if s.stroke is None else s.width for s in shapes],
        linestyles=[(0, tuple(d / s.width for d in s.dashes)) if s.dashes else "-" for s in shapes],
        capstyle="round",
        joinstyle="round",
        zorder=2,
    )
    return axes.add_collection(collection, autolim=False)


def _write(word: Word, axes: Any, theme: Theme, *, dark: bool) -> None:
    from matplotlib.patheffects import withStroke

    halo = [withStroke(linewidth=3.0, foreground=theme.paper)] if word.has_halo else []
    is_math = bool(word.label.latex)
    look: dict[str, Any] = {"fontsize": word.size, "ha": "center", "va": "center", "path_effects": halo, "zorder": 9}
    look |= {"math_fontfamily": "stix", "parse_math": True} if is_math else {"parse_math": False}
    text = _mathtext(word.label) if is_math else plain(word.label.text)
    axes.text(*word.at, text, color=_rgba(word.ink, theme, dark=dark)[:3], **look)


def _mathtext(label: Label) -> str:
    """In Matplotlib's own mathematics, run by run."""
    text = ""
    for run in label.runs:
        letters = _DOTTED.sub(r"\\dot{\1}", "".join(_SPECIAL.get(c, c) for c in run.text))
        letters = _TWICE_DOTTED.sub(r"\\ddot{\1}", letters)
        inner = rf"\mathit{{{letters}}}" if run.is_italic else rf"\mathrm{{{letters}}}"
        text += {-1: f"_{{{inner}}}", 0: inner, 1: f"^{{{inner}}}"}[run.level]
    return f"${text}$"


def _rgba(ink: Ink, theme: Theme, *, dark: bool) -> tuple[float, float, float, float]:
    color = ink.on(theme, dark=dark)
    red, green, blue = (int(color[k : k + 2], 16) / 255 for k in (1, 3, 5))
    return red, green, blue, ink.alpha
