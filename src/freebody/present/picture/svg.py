"""Pictures as SVG, for pages and files. Light colours stand at every element, so that any program shows them; where
style sheets are read, classes follow the page: custom properties `--freebody-ink` and the like, dark ones on dark
screens."""

from __future__ import annotations

import hashlib
import html
from collections.abc import Iterator

import numpy as np

from freebody.language.plain_text import plain
from freebody.present.figures import Array
from freebody.present.picture.content import PictureContent
from freebody.present.picture.label import Label
from freebody.present.picture.shapes import Ink, Shape, Word
from freebody.present.theme import THEMES

SANS = "'Source Sans 3','Segoe UI','Helvetica Neue',Arial,sans-serif"
SERIF = "'STIX Two Text','Latin Modern Roman','Times New Roman',Times,serif"
_HALO = 2.6
_LIGHT, _DARK = THEMES["light"], THEMES["dark"]


def svg(picture: PictureContent, *, dark: bool | None = None, is_marked: bool = False) -> str:
    """dark: on light paper, on dark paper, or None: on that of the page; is_marked: with what lines belong to"""
    return _Writer(picture, dark, is_marked).text()


class _Writer:
    def __init__(self, picture: PictureContent, dark: bool | None, is_marked: bool) -> None:
        self.picture, self.dark, self.is_marked = picture, dark, is_marked
        self.low, self.high = picture.corners
        self.inks: dict[Ink, str] = {}
        self.key = ""

    def text(self) -> str:
        body = "\n".join(self._body())
        self.key = "freebody-" + hashlib.sha256((self.picture.title + body).encode()).hexdigest()[:8]
        wide, tall = (self.high - self.low).tolist()
        title, described = html.escape(plain(self.picture.title)), html.escape(plain(self.picture.description))
        head = (
            f'<svg xmlns="http://www.w3.org/2000/svg" class="{self.key}" role="img" '
            f'aria-labelledby="{self.key}-title {self.key}-description" viewBox="0 0 {wide:.1f} {tall:.1f}" '
            f'width="{wide:.1f}pt" height="{tall:.1f}pt" stroke-linecap="round" stroke-linejoin="round" fill="none">'
        )
        words = f'<title id="{self.key}-title">{title}</title>\n<desc id="{self.key}-description">{described}</desc>'
        style = f"<style>{self._style()}</style>\n" if self.dark is None else ""
        return f"{head}\n{words}\n{style}{body}\n</svg>\n"

    # -- colours ------------------------------------------------------------------------------
    def _style(self) -> str:
        """Rules for this picture alone: names are those of its class."""
        root = f".{self.key}"
        light = [f"{root}{{color-scheme:light dark}}", f"{root} .on-dark{{display:none}}"]
        dark = [f"{root} .on-dark{{display:inline}}", f"{root} .on-light{{display:none}}"]
        for ink, name in self.inks.items():
            for scheme, theme, rules in (("", _LIGHT, light), ("dark", _DARK, dark)):
                color = ink.on(theme, dark=bool(scheme))
                plain = ink.share == 1.0 and ink.dark_share in (None, 1.0)
                value = f"var(--freebody-{_property(ink)},{color})" if plain else color
                rules.append(f"{root} .s{name}{{stroke:{value}}}{root} .f{name}{{fill:{value}}}")
        return "".join(light) + "@media screen and (prefers-color-scheme:dark){" + "".join(dark) + "}"

    def _class(self, ink: Ink) -> str:
        plain = Ink(ink.color, ink.body, 1.0, ink.share, ink.dark_share)
        return self.inks.setdefault(plain, str(len(self.inks)))

    def _color(self, ink: Ink) -> str:
        return ink.on(_DARK if self.dark else _LIGHT, dark=bool(self.dark))

    def _painted(self, stroke: Ink | None, fill: Ink | None, scheme: str) -> str:
        """The attributes of the colours."""
        classes = [f"{kind}{self._class(ink)}" for kind, ink in (("s", stroke), ("f", fill)) if ink is not None]
        classes += [f"on-{scheme}"] if scheme else []
        text = f' class="{" ".join(classes)}"' if self.dark is None else ""
        for kind, ink in (("stroke", stroke), ("fill", fill)):
            if ink is not None:
                text += f' {kind}="{self._color(ink)}"'
                text += f' {kind}-opacity="{ink.alpha:.3g}"' if ink.alpha < 1.0 else ""
        return text

    # -- elements -----------------------------------------------------------------------------
    def _body(self) -> Iterator[str]:
        if self.dark is not None:
            yield f'<rect width="100%" height="100%" fill="{self._color(Ink("paper"))}"/>'
        for shape in self.picture.shapes:
            if not shape.scheme or self.dark is None or shape.scheme == ("dark" if self.dark else "light"):
                yield self._shape(shape)
        for word in self.picture.words:
            yield self._word(word)

    def _shape(self, shape: Shape) -> str:
        colors = self._painted(shape.stroke, shape.fill, shape.scheme if self.dark is None else "")
        width = f' stroke-width="{shape.width:.3g}"' if shape.stroke is not None else ""
        dashes = f' stroke-dasharray="{",".join(f"{d:g}" for d in shape.dashes)}"' if shape.dashes else ""
        hidden = ' display="none"' if shape.scheme == "dark" and self.dark is None else ""
        rule = ' fill-rule="evenodd"' if shape.fill is not None and len(shape.points) > 40 else ""
        return f'<path d="{self._way(shape)}"{colors}{width}{dashes}{rule}{hidden}{self._of(shape)}/>'

    def _of(self, each: Shape | Word) -> str:
        """What it belongs to, for pages."""
        return f' data-of="{html.escape(each.of)}"' if each.of and self.is_marked else ""

    def _at(self, point: Array) -> Array:
        return np.array((point[0] - self.low[0], self.high[1] - point[1]))

    def _way(self, shape: Shape) -> str:
        flipped = np.stack((shape.points[:, 0] - self.low[0], self.high[1] - shape.points[:, 1]), axis=-1)
        steps = [f"{_short(x)} {_short(y)}" for x, y in flipped.tolist()]
        return "M" + "L".join(steps) + ("Z" if shape.is_closed else "")

    def _word(self, word: Word) -> str:
        x, y = self._at(word.at)
        paint = self._painted(None, word.ink, "")
        place = f'x="{_short(x)}" y="{_short(y + 0.34 * word.size)}" text-anchor="middle" font-size="{word.size:g}"'
        font = SERIF if word.label.latex else SANS
        inside = "".join(_spans(word.label, word.size))
        text = f'<text {place} font-family="{font}"{paint}{self._of(word)}>{inside}</text>'
        if not word.has_halo:
            return text
        halo = self._painted(Ink("paper"), None, "")
        look = f'stroke-width="{_HALO:g}" stroke-opacity="0.8" aria-hidden="true"'
        behind = f'<text {place} font-family="{font}"{halo} {look}>{inside}</text>'
        return behind + "\n" + text


def _spans(label: Label, size: float) -> Iterator[str]:
    """Letters with shifts for indices, taken back after them."""
    level = 0.0
    for run in label.runs:
        wanted = {-1: 0.24, 0: 0.0, 1: -0.38}[run.level]
        shift = f' dy="{(wanted - level) * size:.2f}"' if wanted != level else ""
        look = ' font-style="italic"' if run.is_italic else ""
        small = f' font-size="{0.72 * size:.3g}"' if run.level else ""
        level = wanted
        inside = html.escape(plain(run.text), quote=False)
        yield f"<tspan{shift}{look}{small}>{inside}</tspan>" if shift or look or small else inside


def _property(ink: Ink) -> str:
    return f"body-{ink.body % len(_LIGHT.bodies)}" if ink.color == "body" else ink.color


def _short(value: float) -> str:
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text in ("", "-0") else text
