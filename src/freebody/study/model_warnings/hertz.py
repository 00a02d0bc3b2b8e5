"""A frequency where an angular rate is asked: Omega = 2 Hz is 2 rad/s, and 4 pi rad/s was likely meant; 300 1/min is
5 rad/s, and 10 pi rad/s was meant.

The hertz is the unit of cycles in a second, and the speed n = 300 1/min counts turns in a minute: omega = 2 pi n. An
angular rate has rad/s. Source: BIPM, The International System of Units, 9th ed., table 4, note (d); DIN 1304-1, 1994
(rotational frequency).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

from freebody.language.sentences import Message
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind

_NUMBER = r"(?P<number>[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:e[-+]?\d+)?)"
_PER_MINUTE = r"1\s*/\s*min|/\s*min|min\s*(?:\^|\*\*)\s*\(?-1\)?|min⁻¹"
_CYCLES = re.compile(rf"{_NUMBER}(?:\s*(?P<unit>[kM]?Hz|hertz)\b|\s+(?P<turns>{_PER_MINUTE})(?![\w^*]))")
_SIZES = {"kHz": 1e3, "MHz": 1e6}
_SECTIONS = ("ground", "frames", "bodies", "states", "start", "connections", "loads", "measures")
_TURN = re.compile(r"\bpi\b|\b6\.28|\b3\.14")
_OF_FORMULA = r"(?<![\w.]){name}(?!\w)"
_BELOW = r"/\s*(\([^()]*)?(?<![\w.]){name}(?!\w)"

Path = tuple[str | int, ...]


class Hertz(WarningKind, name="hertz"):
    """A number of hertz in a formula that has no 2 pi. 1/f is a period and asks for none."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        data = model.system.document.data
        texts = [each for section in _SECTIONS for each in _texts(data.get(section), (section,))]
        for path, text in texts:
            found = _CYCLES.search(text)
            if found is not None and not _TURN.search(text) and "/" not in text[: found.start()]:
                yield self._told(found, *path)
        yield from self._parameters(data.get("parameters"), texts)

    def _parameters(self, given: Any, texts: list[tuple[Path, str]]) -> Iterator[ModelWarning]:
        """Those that stand for an angular rate somewhere."""
        if not isinstance(given, Mapping):
            return
        for name, value in given.items():
            parts = (value.get("value", ""), value.get("unit", "")) if isinstance(value, Mapping) else (value,)
            text = " ".join(map(str, parts)).strip()
            found = _CYCLES.fullmatch(text)
            others = _texts({key: other for key, other in given.items() if key != name}, ())
            if found is not None and any(_is_rate(str(name), other) for _path, other in (*texts, *others)):
                yield self._told(found, "parameters", str(name), about=frozenset((str(name),)))

    def _told(self, found: re.Match[str], *path: str | int, about: frozenset[str] = frozenset()) -> ModelWarning:
        number = found["number"]
        if found["turns"]:
            told = Message(
                "{given} is a speed in turns per minute where an angular rate is asked, and is taken as {rate} rad/s. "
                "Write {number} rpm if revolutions are meant, or {rate} rad/s",
                given=found[0],
                number=number,
                rate=f"{float(number) / 60:.4g}",
            )
            return self.warning(told, *path, about=about)
        if found["unit"] in _SIZES:
            number = f"{float(number) * _SIZES[found['unit']]:g}"
        told = Message(
            "{given} is a frequency in hertz where an angular rate is asked, and is taken as {number} rad/s. Write "
            "{number} rev/s if revolutions are meant, or {number} rad/s",
            given=found[0],
            number=number,
        )
        return self.warning(told, *path, about=about)


def _is_rate(name: str, text: str) -> bool:
    """Whether a formula has the name as an angular rate: neither with pi nor below a line, where it gives a period."""
    own = re.escape(name)
    is_there, is_below = (re.search(form.format(name=own), text) for form in (_OF_FORMULA, _BELOW))
    return is_there is not None and is_below is None and _TURN.search(text) is None


def _texts(value: Any, path: Path) -> Iterator[tuple[Path, str]]:
    """All texts of a part of a file, and where they stand."""
    if isinstance(value, Mapping):
        for key, inner in value.items():
            yield from _texts(inner, (*path, str(key)))
    elif isinstance(value, list):
        for k, inner in enumerate(value):
            yield from _texts(inner, (*path, k))
    elif isinstance(value, str):
        yield path, value
