"""Colours and widths of lines, one table for every canvas.

The colours of bodies are those of Okabe and Ito, which people of all kinds of colour vision tell apart; on dark
paper they are lightened. Source: Okabe & Ito, Color Universal Design, 2008.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Style:
    """A stroke [points] and a fill; a colour is a name of the theme, `body` for that of the body, or empty."""

    stroke: str = "ink"
    width: float = 1.2
    fill: str = ""
    alpha: float = 1.0
    dashes: tuple[float, ...] = ()


STYLES: dict[str, Style] = {
    "body": Style("body", 1.5, "body", 0.3),
    "body ring": Style("", 0.0, "body", 0.3),
    "fixed body": Style("muted", 1.5, "muted", 0.2),
    "fixed body ring": Style("", 0.0, "muted", 0.25),
    "dot": Style("body", 1.0, "body"),
    "center": Style("ink", 1.0, "ink"),
    "hole": Style("body", 1.3, "paper"),
    "rim": Style("body", 1.3),
    "hoop": Style("body", 2.6),
    "fixed rim": Style("muted", 1.3),
    "spoke": Style("body", 1.6),
    "mass center": Style("body", 0.8, "body"),
    "joint": Style("ink", 1.2, "paper"),
    "support": Style("ink", 1.2, "paper"),
    "surface": Style("ink", 1.5),
    "hatch": Style("muted", 0.8),
    "roller": Style("ink", 1.2, "paper"),
    "slot": Style("muted", 1.0, "", 1.0),
    "link": Style("ink", 2.2),
    "string": Style("ink", 1.5),
    "spring": Style("ink", 1.2),
    "sticks": Style("ink", 1.2, "ink"),
    "slips": Style("ink", 1.2, "paper"),
    "presses": Style("muted", 1.0, "muted"),
    "shoe": Style("ink", 1.2, "muted"),
    "load line": Style("force", 1.0),
    "load tip": Style("force", 0.6, "force"),
    "pull": Style("muted", 1.2, dashes=(4.0, 3.0)),
    "gear": Style("", 0.0, "body", 0.3),
    "pitch circle": Style("body", 1.0, dashes=(7.0, 2.0, 1.0, 2.0)),
}


def style_of(name: str) -> Style:
    return STYLES[name]


@dataclass(frozen=True)
class Theme:
    """The colours of one paper, as #rrggbb."""

    paper: str
    ink: str
    muted: str
    faint: str
    bodies: tuple[str, ...]
    force: str  # loads
    reaction: str
    measure: str  # coordinates
    velocity: str
    acceleration: str

    def color(self, name: str, body: int = -1) -> str:
        """A colour by name; empty for none."""
        if not name:
            return ""
        return self.bodies[body % len(self.bodies)] if name == "body" else str(getattr(self, name))


THEMES = {
    "light": Theme(
        "#ffffff",
        "#1f2328",
        "#66707b",
        "#d0d5da",
        ("#0072b2", "#d55e00", "#009e73", "#b5568c", "#a67c00", "#3a8fc0", "#555555"),
        "#b3261e",
        "#2145b8",
        "#7a3fb5",
        "#1a7f37",
        "#b45309",
    ),
    "dark": Theme(
        "#14171b",
        "#e6e9ec",
        "#98a2ad",
        "#3a424b",
        ("#56b4e9", "#f0883e", "#2ec49a", "#e08fc0", "#e6b830", "#8ccbf0", "#b8b8b8"),
        "#ff8a80",
        "#9db8ff",
        "#cfa6ff",
        "#5fd17f",
        "#f0a858",
    ),
}


def _page(theme: Theme, muted: str, wash: str, right: str, wrong: str, result: str) -> dict[str, str]:
    """The colours of a page with drawings of a theme on it. Muted words are read, so they differ more from paper."""
    same = {"paper": theme.paper, "ink": theme.ink, "muted": muted, "faint": theme.faint, "wash": wash}
    return {**same, "accent": theme.bodies[0], "right": right, "wrong": wrong, "warning": wrong, "result": result}


PAGES = {
    "light": _page(THEMES["light"], "#59636e", "#f4f6f8", "#00704f", "#b03a00", "#eef6fb"),
    "dark": _page(THEMES["dark"], "#98a2ad", "#1c2127", "#2ec49a", "#f0883e", "#172733"),
    "print": {
        **{"paper": "#ffffff", "ink": "#000000", "muted": "#444444", "faint": "#bbbbbb", "wash": "#ffffff"},
        **{"accent": "#005a8c", "right": "#00563d", "wrong": "#8a2e00", "warning": "#8a2e00", "result": "#ffffff"},
    },
}


def properties(page: str) -> str:
    """The colours of a page as custom properties of a style sheet."""
    return " ".join(f"--{name}: {color};" for name, color in PAGES[page].items())
