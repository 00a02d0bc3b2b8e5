"""A figure of Matplotlib that shows itself in a notebook, whichever backend is chosen there, or none."""

from __future__ import annotations

from io import StringIO
from typing import Any

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure


class ShownFigure(Figure):
    """As the figure it is; also as a picture."""

    def _repr_svg_(self) -> str:
        text = StringIO()
        shown: Any = self
        shown.savefig(text, format="svg", facecolor=self.get_facecolor())
        svg = text.getvalue()
        return svg[svg.index("<svg") :]


def shown_figure(width: float, height: float) -> ShownFigure:
    """An empty figure [inch], with a canvas of its own, so that nothing of pyplot is needed."""
    figure = ShownFigure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(figure)
    return figure
