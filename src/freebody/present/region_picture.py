"""A picture of which case holds where in the plane of two parameters."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from freebody.present.files import replaced

if TYPE_CHECKING:
    from freebody.present.figures import Array


def region_picture(
    x: Array, y: Array, index: Array, cases: Sequence[str], labels: tuple[str, str], path: Path | str
) -> Path:
    """Draws which case holds where in the plane of two parameters. index: (n_y, n_x) the case at y[j], x[k], -1 where
    none is known; cases: in words; labels: of the parameters. Returns the path."""
    import matplotlib.figure
    import numpy as np
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

    colors = ["#ffffff", "#9ecae1", "#fdae6b", "#a1d99b", "#bcbddc", "#fdd0a2", "#c7e9c0", "#d9d9d9"]
    figure: Any = matplotlib.figure.Figure(figsize=(6.4, 4.6), layout="constrained")
    FigureCanvasAgg(figure)
    axes: Any = figure.subplots()
    n = len(cases)
    shown = ListedColormap([colors[0], *(colors[1 + k % (len(colors) - 1)] for k in range(n))])
    axes.pcolormesh(x, y, index, cmap=shown, vmin=-1.5, vmax=n - 0.5, shading="nearest")
    present = [int(k) for k in np.unique(index) if k >= 0]
    handles = [
        Patch(color=shown.colors[k + 1], label=cases[k])  # type: ignore[index]
        for k in present
    ]
    axes.set_xlabel(labels[0])
    axes.set_ylabel(labels[1])
    if handles:
        figure.legend(handles=handles, loc="outside upper center", frameon=False, fontsize="small")
    with replaced(Path(path)) as file:
        figure.savefig(file)
    return Path(path)
