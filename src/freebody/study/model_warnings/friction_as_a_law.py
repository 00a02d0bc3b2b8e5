"""Dry friction that is written as a law with the sign of a rate: it jumps where the motion turns back."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any, cast

from freebody.language.sentences import Message
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind

_FRICTION = re.compile(r"\s*-\s*(?P<size>[^+-]+?)\s*\*\s*sign\(\s*rate\(\s*(?P<measure>\w+)\s*\)\s*\)\s*")


class FrictionAsALaw(WarningKind, name="friction as a law"):
    """A law -F*sign(rate(x)) along x. It is zero at rest, so it holds nothing, and has no phases of sliding and
    sticking: those are what dry friction is."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        loads = model.system.document.data.get("loads")
        for name, load in cast("dict[str, Any]", loads if isinstance(loads, Mapping) else {}).items():
            law = load.get("law") if isinstance(load, Mapping) else None
            found = _FRICTION.fullmatch(str(law.get("force"))) if isinstance(law, Mapping) else None
            if found is not None and law is not None and found["measure"] == law.get("measure"):
                told = Message(
                    "{force} jumps where {measure} turns back and holds nothing at rest. Write it as dry friction, "
                    "under connections: {{dry_friction: {{measure: {measure}, force: {size}}}}}",
                    force=law["force"],
                    measure=found["measure"],
                    size=found["size"],
                )
                yield self.warning(told, "loads", name, "law", "force", about=frozenset((name,)))
