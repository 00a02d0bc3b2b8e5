"""Pictures for LaTeX: a tikzpicture, for which \\usepackage{tikz} is enough."""

from __future__ import annotations

import re

from freebody.language.plain_text import plain
from freebody.present.picture.content import PictureContent
from freebody.present.picture.label import Label
from freebody.present.picture.shapes import Ink, Shape, Word
from freebody.present.theme import THEMES

_LIGHT = THEMES["light"]
_ESCAPED = {c: f"\\{c}" for c in "#$%&_{}"} | {
    "\\": r"\textbackslash{}",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
}


def tikz(picture: PictureContent) -> str:
    """The picture on light paper."""
    colors: dict[str, str] = {}
    lines = [_path(shape, colors) for shape in picture.shapes if shape.scheme != "dark"]
    lines += [_node(word, colors) for word in picture.words]
    defined = [rf"\definecolor{{{name}}}{{HTML}}{{{color[1:].upper()}}}" for color, name in colors.items()]
    about = [f"% {plain(line)}" for line in (picture.title, picture.description)]
    begin = r"\begin{tikzpicture}[x=1bp,y=1bp,line cap=round,line join=round]"
    return "\n".join([*about, begin, *defined, *lines, r"\end{tikzpicture}", ""])


def _color(ink: Ink, colors: dict[str, str]) -> str:
    color = ink.on(_LIGHT, dark=False)
    return colors.setdefault(color, f"freebody{chr(ord('A') + len(colors) // 26)}{chr(ord('a') + len(colors) % 26)}")


def _path(shape: Shape, colors: dict[str, str]) -> str:
    options: list[str] = []
    if shape.stroke is not None:
        options += [f"draw={_color(shape.stroke, colors)}", f"line width={shape.width:.3g}bp"]
        options += [f"draw opacity={shape.stroke.alpha:.3g}"] if shape.stroke.alpha < 1.0 else []
    if shape.fill is not None:
        options += [f"fill={_color(shape.fill, colors)}"]
        options += [f"fill opacity={shape.fill.alpha:.3g}"] if shape.fill.alpha < 1.0 else []
        options += ["even odd rule"] if len(shape.points) > 40 else []
    if shape.dashes:
        pattern = " ".join(f"{'off' if k % 2 else 'on'} {d:g}bp" for k, d in enumerate(shape.dashes))
        options.append(f"dash pattern={pattern}")
    way = " -- ".join(f"({x:.2f},{y:.2f})" for x, y in shape.points.tolist())
    return rf"\path[{','.join(options)}] {way}{' -- cycle' if shape.is_closed else ''};"


def _node(word: Word, colors: dict[str, str]) -> str:
    x, y = word.at.tolist()
    size = rf"\fontsize{{{word.size:g}}}{{{1.2 * word.size:g}}}\selectfont"
    color = _color(word.ink, colors)
    return rf"\node[inner sep=0pt,text={color},font={size}] at ({x:.2f},{y:.2f}) {{{_content(word.label)}}};"


def _content(label: Label) -> str:
    if not label.latex:
        return r"\textsf{" + _escaped(label.text) + "}"
    return "$" + re.sub(r"\\text\{([^}]*)\}", lambda m: r"\mbox{" + _escaped(m[1]) + "}", label.latex) + "$"


def _escaped(text: str) -> str:
    return "".join(_ESCAPED.get(c, c) for c in plain(text)).replace("\u2212", "--").replace("\u2009", r"\,")
