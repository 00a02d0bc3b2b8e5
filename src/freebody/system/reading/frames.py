"""The section `frames`: axes fixed in a body, `tilted: {on: shaft, turned: beta about z}`."""

from __future__ import annotations

from typing import Any, cast

from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.model.chains import read_chain
from freebody.model.rotations import UNIT, columns_of, product
from freebody.system.reading.source import Source, known_keys


def read_frames(source: Source, *, first: bool) -> None:
    """Those on the ground are known before the bodies are (`first`), the others after."""
    names = source.names
    entries = source.named("frames")
    if entries and not names.space:
        if first:
            names.problem(Message("frames are for models in space: write space: true"), "frames")
        return
    for name, value in entries.items():
        entry = cast("dict[str, Any]", value) if isinstance(value, dict) else {"turned": value}
        on = str(entry.get("on", GROUND))
        is_early = on == GROUND or on in names.frames
        if is_early != first and not (not first and name not in names.frames):
            continue
        with names.at("frames", name):
            known_keys(names, entry, ("on", "turned"), Message("a frame"))
            if name in source.mapping("bodies") or name == GROUND:
                names.problem(Message("{name} is a body already; choose another name", name=name))
            chain = read_chain(names, entry.get("turned", []), "turned", named=False)
            body, axes = names.frames.get(on) or (names.body(on, "on").name, UNIT)
            names.frames[name] = body, product(axes, columns_of(chain))
