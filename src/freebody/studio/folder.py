"""The opened folder: its model files, and nothing else, can be read and written from the page."""

from __future__ import annotations

import locale
import re
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path

from freebody.errors import InputError
from freebody.examples_folder import write_beside
from freebody.language.document.file import text_of
from freebody.messages import Message
from freebody.present.files import write_whole
from freebody.studio.wire.around import Call, OpenedFile, SaveAnswer, SaveRequest
from freebody.studio.wire.said import UNTIL

# a name without folders: no separator, no drive, no leading dot
_NAME = re.compile(r"[^\W_][\w .()+-]{0,150}\.ya?ml", re.ASCII | re.IGNORECASE)
_UNTITLED = "model.yaml"


@dataclass(frozen=True)
class Folder:
    """path: of the folder, resolved; first: the name of the file that was opened, empty for none"""

    path: Path
    first: str = ""

    @classmethod
    def of(cls, file: Path | None) -> Folder:
        """Raises InputError where there is no such folder, or the file is no YAML file."""
        if file is None:
            return cls(Path.cwd().resolve())
        if file.is_dir():
            return cls(file.resolve())
        folder = file.parent.resolve()
        if not folder.is_dir():
            raise InputError(Message("there is no folder {folder}", folder=str(folder)))
        opened = cls(folder, file.name)
        opened.target(file.name)
        return opened

    def names(self) -> list[str]:
        """The model files of the folder."""
        found = [path.name for path in self.path.iterdir() if _NAME.fullmatch(path.name)]
        return sorted(name for name in found if self._is_own(self.path / name))

    def target(self, name: str) -> Path:
        """A file of the folder by its name. Raises InputError for any other."""
        path = self.path / name
        if _NAME.fullmatch(name) is None or path.parent != self.path or not self._is_own(path):
            raise InputError(
                Message("{name}: a model file is called like pendulum.yaml, without a folder", name=name[:100])
            )
        return path

    def _is_own(self, path: Path) -> bool:
        """Is it in the folder, not a link that leads out of it?"""
        return not path.is_symlink() and path.resolve().parent == self.path and (path.is_file() or not path.exists())

    def opened(self, name: str) -> OpenedFile:
        """Raises InputError if it cannot be read."""
        path = self.target(name)
        if not path.exists():
            return OpenedFile(name=name, text="", version="")
        text = text_of(path)
        return OpenedFile(name=name, text=text, version=_version(text))

    def first_opened(self) -> OpenedFile:
        if self.first:
            return self.opened(self.first)
        return OpenedFile(name=_UNTITLED, text="", version="")

    def foreseen(self) -> list[Call]:
        """What the page asks first of the file that was opened, in the language that this machine speaks."""
        try:
            text = self.first_opened().text
        except InputError:
            return []  # the page is told
        is_german = (locale.getlocale()[0] or "").lower().startswith(("de_", "german"))
        request = {"text": text, "language": "de" if is_german else "en"}
        kinds = {"read": request, "motion": {**request, "until": UNTIL}}
        return [Call(kind=kind, topic=kind, request=each) for kind, each in kinds.items() if text]

    def save(self, request: SaveRequest) -> SaveAnswer:
        """Writes a file, unless somebody else has changed it since; one that is gone is there again. Raises InputError
        if it cannot be written."""
        path = self.target(request.name)
        now = _version(text_of(path)) if path.exists() else ""
        if now and now not in (request.version, _version(request.text)) and not request.overwrite:
            message = Message("{name} has been changed by another program since it was opened", name=request.name)
            return SaveAnswer(version=now, is_changed=True, message=message)
        write_whole(path, request.text)
        write_beside(request.text, self.path)
        return SaveAnswer(version=_version(request.text), is_changed=False, message="")


def _version(text: str) -> str:
    return sha256(text.encode("utf-8", "surrogatepass")).hexdigest()[:16]
