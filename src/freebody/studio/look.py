"""The colours of the page and the look of its reports: those of all reports, by the theme that the page has chosen."""

from __future__ import annotations

from functools import cache

from freebody.present.assets import asset, embedded
from freebody.present.theme import THEMES, properties


@cache
def style_sheet() -> str:
    """The text of the style sheet. `data-theme` at the root says which theme is on, whatever the system prefers."""
    font = embedded("font/woff2", "report", "font", "math.woff2")
    rules = [f'@font-face {{ font-family: "Freebody Math"; src: url({font}) format("woff2"); }}']
    rules.append(asset("report", "report.css"))
    for name, theme in THEMES.items():
        bodies = " ".join(f"--body-{k}: {color};" for k, color in enumerate(theme.bodies))
        arrows = ("force", "reaction", "measure", "velocity", "acceleration")
        more = " ".join(f"--{each}: {getattr(theme, each)};" for each in arrows) + f" {bodies}"
        root = f':root[data-theme="{name}"]'
        rules.append(f"{root}, {root} .freebody-report {{ {properties(name)} {more} color-scheme: {name}; }}")
    return "\n".join(rules)
