"""Pictures as PNG and PDF, drawn with Matplotlib."""

from __future__ import annotations

from io import BytesIO
from typing import TYPE_CHECKING, Any

from freebody.language.plain_text import plain, shortened
from freebody.present.picture.label import Label
from freebody.present.picture.shapes import Ink, Shape, Word
from freebody.present.theme import THEMES, Theme

if TYPE_CHECKING:
    from freebody.present.picture.picture import Picture

_DPI = 200
_SPECIAL = {c: f"\\{c}" for c in "#$%&_{}"} | {" ": r"\ ", "\u2009": r"\,"}
_PER_INCH = 72.0
_MOST = 500  # characters of a title in the data of a file


def rendered(picture: Picture, kind: str, *, dark: bool = False) -> bytes:
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
    for k, shape in enumerate(picture.shapes):
        if shape.scheme in ("", "dark" if dark else "light"):
            _draw(shape, axes, theme, 1 + k / len(picture.shapes), dark=dark)
    for word in picture.words:
        _write(word, axes, theme, dark=dark)
    out = BytesIO()
    key = "Title" if kind != "png" else "Description"
    figure.savefig(
        out, format=kind, dpi=_DPI, facecolor=theme.paper, metadata={key: shortened(plain(picture.title), _MOST)}
    )
    return out.getvalue()


def _draw(shape: Shape, axes: Any, theme: Theme, order: float, *, dark: bool) -> None:
    from matplotlib.lines import Line2D
    from matplotlib.patches import Polygon

    dashes = (0, tuple(d / shape.width for d in shape.dashes)) if shape.dashes else "-"
    if shape.fill is None and not shape.is_closed and shape.stroke is not None:
        look: dict[str, Any] = {"solid_capstyle": "round", "solid_joinstyle": "round", "dash_capstyle": "round"}
        color = _rgba(shape.stroke, theme, dark=dark)
        axes.add_line(Line2D(*shape.points.T, color=color, linewidth=shape.width, ls=dashes, zorder=order, **look))
        return
    face = "none" if shape.fill is None else _rgba(shape.fill, theme, dark=dark)
    edge = "none" if shape.stroke is None else _rgba(shape.stroke, theme, dark=dark)
    patch = Polygon(shape.points, closed=shape.is_closed, facecolor=face, edgecolor=edge, zorder=order)
    patch.set_linewidth(shape.width if shape.stroke is not None else 0.0)
    patch.set_linestyle(dashes)
    patch.set_joinstyle("round")
    axes.add_patch(patch)


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
        letters = "".join(_SPECIAL.get(c, c) for c in run.text)
        inner = rf"\mathit{{{letters}}}" if run.is_italic else rf"\mathrm{{{letters}}}"
        text += {-1: f"_{{{inner}}}", 0: inner, 1: f"^{{{inner}}}"}[run.level]
    return f"${text}$"


def _rgba(ink: Ink, theme: Theme, *, dark: bool) -> tuple[float, float, float, float]:
    color = ink.on(theme, dark=dark)
    red, green, blue = (int(color[k : k + 2], 16) / 255 for k in (1, 3, 5))
    return red, green, blue, ink.alpha
