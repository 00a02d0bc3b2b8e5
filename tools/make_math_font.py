"""Makes the font for mathematics that web pages carry: a subset of STIX Math, renamed as its licence (OFL 1.1) asks.

    python tools/make_math_font.py STIXMath-Regular.otf

The source is STIX Math 1.1.1 (package fonts-stix of Debian, or stixfonts.org). Needs fonttools and brotli; the result
is kept in the tree, so that nobody needs them to build the package.
"""

from __future__ import annotations

import sys
from pathlib import Path

from fontTools import subset
from fontTools.ttLib import TTFont

OUT = Path(__file__).parents[1] / "src/freebody/present/report/font/math.woff2"
NAME = "Freebody Math"
SIGNS = "·×±−⋅∓÷≤≥≠≈≡∞√∂∇∑∏∫→←⇒⇔↔∥⊥°′″‴…ℎϕϑϵ∈|‖⟨⟩⌈⌉⌊⌋˙¨^ˆ˜¯⃗̇̈⃛⃜∝∗"
RANGES = (
    (0x20, 0x7F),  # ASCII
    (0x391, 0x3AA),  # Greek
    (0x3B1, 0x3CA),
    (0x1D434, 0x1D468),  # italic Latin letters
    (0x1D6E2, 0x1D71C),  # italic Greek letters
    (0x2061, 0x2065),  # signs that are not seen
    (0xA0, 0xA1),
    (0x2009, 0x200A),
)
FAMILY, FULL_NAME, UNIQUE, POSTSCRIPT = 1, 4, 3, 6


ASCENT, DESCENT = 800, 250  # thousandths of the letter size


def close_lines(font: TTFont) -> None:
    """The font says that its tallest integral is a line high; Firefox makes every formula in a text so high, and sets
    dots that far above their letters."""
    font["hhea"].ascent, font["hhea"].descent, font["hhea"].lineGap = ASCENT, -DESCENT, 0
    metrics = font["OS/2"]
    metrics.sTypoAscender, metrics.sTypoDescender, metrics.sTypoLineGap = ASCENT, -DESCENT, 0
    metrics.usWinAscent, metrics.usWinDescent = ASCENT, DESCENT


def main(source: str) -> None:
    """Writes the subset."""
    wanted = set(map(ord, SIGNS)) | {code for first, end in RANGES for code in range(first, end)}
    options = subset.Options()
    options.layout_features = ["ssty", "dtls", "kern"]  # letters of indices, dotless letters
    options.hinting, options.desubroutinize = False, True
    options.name_IDs = [0, 1, 2, 3, 4, 5, 6, 13, 14]
    font = TTFont(source)
    maker = subset.Subsetter(options)
    maker.populate(unicodes=wanted)
    maker.subset(font)
    for record in font["name"].names:
        if record.nameID in (FAMILY, FULL_NAME):
            record.string = NAME
        elif record.nameID in (UNIQUE, POSTSCRIPT):
            record.string = NAME.replace(" ", "")
    close_lines(font)
    font.flavor = "woff2"
    OUT.parent.mkdir(exist_ok=True)
    font.save(OUT)
    print(f"{OUT}: {OUT.stat().st_size} bytes")


if __name__ == "__main__":
    main(sys.argv[1])
