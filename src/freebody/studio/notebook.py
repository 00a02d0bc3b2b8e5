"""The studio in a notebook: scene, time and sliders of a model in the output of a cell, answered by the kernel.

The page is that of the server, in a frame of its own; the kernel does for it what a worker does, by the same table.
Two views of one widget ask under numbers of their own, so an answer goes to all and each takes its own.
"""

from __future__ import annotations

import json
from importlib.resources import files
from typing import Any, cast

import anywidget
import traitlets

from freebody.language.plain_text import plain
from freebody.studio.sharing import opening_of, whole_page
from freebody.studio.wire.around import Call, Reply
from freebody.studio.work import WORK, done
from freebody.system.system import System


class Widget(anywidget.AnyWidget):
    """A model in a notebook. text: of the model as it stands, with what has been changed by hand; `system` is that
    system. Setting `text` changes what is shown."""

    _esm = files("freebody.studio").joinpath("widget.js").read_text(encoding="utf-8")
    text = traitlets.Unicode().tag(sync=True)
    page = traitlets.Unicode().tag(sync=True)
    title = traitlets.Unicode().tag(sync=True)
    height = traitlets.Unicode().tag(sync=True)

    def __init__(self, system: System, *, until: float, language: str, height: str) -> None:
        title = system.title or "freebody"
        settings = json.dumps({"until": until, "language": language})
        super().__init__(
            text=system.to_yaml(),
            page=whole_page(title, language, "notebook", settings),
            title=plain(title),
            height=height,
        )
        self._kind = type(system)
        cast(Any, self).on_msg(self._asked)

    @property
    def system(self) -> System:
        """The system as it stands. Raises ModelError where the text is none."""
        return self._kind.from_text(self.text)

    def answer(self, name: str, body: dict[str, Any]) -> dict[str, Any]:
        """What the page gets for `open` and `ask`, as from the server. Raises KeyError for anything else."""
        if name == "open":
            return opening_of("model.yaml", self.text).model_dump(mode="json")
        if name != "ask":
            raise KeyError(name)
        call = Call.model_validate(body)
        if call.kind not in WORK:
            raise KeyError(call.kind)
        return done(call.kind, call.request).model_dump(mode="json")

    def _asked(self, _widget: object, content: dict[str, Any], _buffers: object) -> None:
        try:
            answer = self.answer(content["name"], content["body"])
        except Exception as error:  # the page waits for an answer, whatever happened
            answer = Reply(status="crashed", message=f"{type(error).__name__}: {error}").model_dump(mode="json")
        cast(Any, self).send({"id": content["id"], "answer": answer})
