"""A picture of which case holds where in the plane of two parameters."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from freebody.present.files import replaced

if TYPE_CHECKING:
    from freebody.study.phases.regions import Regions


def region_picture(regions: Regions, path: Path | str) -> Path:
    """Draws which case holds where in the plane of two parameters. Returns the path."""
    import matplotlib.figure
    import numpy as np
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

    colors = ["#ffffff", "#9ecae1", "#fdae6b", "#a1d99b", "#bcbddc", "#fdd0a2", "#c7e9c0", "#d9d9d9"]
    figure: Any = matplotlib.figure.Figure(figsize=(6.4, 4.6), layout="constrained")
    FigureCanvasAgg(figure)
    axes: Any = figure.subplots()
    n = len(regions.cases)
    shown = ListedColormap([colors[0], *(colors[1 + k % (len(colors) - 1)] for k in range(n))])
    axes.pcolormesh(regions.x, regions.y, regions.index, cmap=shown, vmin=-1.5, vmax=n - 0.5, shading="nearest")
    present = [int(k) for k in np.unique(regions.index) if k >= 0]
    handles = [
        Patch(color=shown.colors[k + 1], label=f"{regions.cases[k]}: {regions.conditions[k]}")  # type: ignore[index]
        for k in present
    ]
    axes.set_xlabel(regions.labels[0])
    axes.set_ylabel(regions.labels[1])
    if handles:
        figure.legend(handles=handles, loc="outside upper center", frameon=False, fontsize="small")
    with replaced(Path(path)) as file:
        figure.savefig(file)
    return Path(path)
