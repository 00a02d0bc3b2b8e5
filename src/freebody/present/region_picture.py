"""A picture of which case holds where in the plane of two parameters."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from freebody.present.figures import Array


def region_picture(x: Array, y: Array, index: Array, cases: Sequence[str], labels: tuple[str, str]) -> Figure:
    """Draws which case holds where in the plane of two parameters. index: (n_y, n_x) the case at y[j], x[k], -1 where
    none is known; cases: in words; labels: of the parameters."""
    import numpy as np
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

    from freebody.present.shown_figure import shown_figure

    colors = ["#ffffff", "#9ecae1", "#fdae6b", "#a1d99b", "#bcbddc", "#fdd0a2", "#c7e9c0", "#d9d9d9"]
    figure: Any = shown_figure(6.4, 4.6)
    axes: Any = figure.subplots()
    n = len(cases)
    shown = ListedColormap([colors[0], *(colors[1 + k % (len(colors) - 1)] for k in range(n))])
    axes.pcolormesh(x, y, index, cmap=shown, vmin=-1.5, vmax=n - 0.5, shading="nearest", rasterized=True)
    present = [int(k) for k in np.unique(index) if k >= 0]
    handles = [
        Patch(color=shown.colors[k + 1], label=cases[k])  # pyrefly: ignore[bad-argument-type, bad-index]
        for k in present
    ]
    axes.set_xlabel(labels[0])
    axes.set_ylabel(labels[1])
    if handles:
        figure.legend(handles=handles, loc="outside upper center", frameon=False, fontsize="small")
    return figure
