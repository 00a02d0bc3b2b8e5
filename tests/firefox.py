"""A Firefox of the system, led by Marionette, its own protocol (WebDriver's commands over a socket of this machine):
`length:[0, id, command, parameters]`, answered by `length:[1, id, error, result]`. Source: Firefox source docs,
testing/marionette/Protocol."""

from __future__ import annotations

import json
import shutil
import socket
import subprocess
import time
from base64 import b64decode
from pathlib import Path
from typing import Any

FIREFOX = next((found for name in ("firefox", "firefox-esr") if (found := shutil.which(name))), None)
ELEMENT = "element-6066-11e4-a52e-4f735466cecf"
KEYS = {"Enter": "\ue007", "ArrowRight": "\ue014", "End": "\ue010", "Escape": "\ue00c", "Control": "\ue009"}


class Firefox:
    """A window without a screen. profile: an empty folder"""

    def __init__(self, profile: Path) -> None:
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        quiet = {"marionette.port": port, "browser.shell.checkDefaultBrowser": False, "app.update.enabled": False}
        lines = [f"user_pref({json.dumps(name)}, {json.dumps(value)});" for name, value in quiet.items()]
        profile.joinpath("user.js").write_text("\n".join(lines), encoding="utf-8")
        assert FIREFOX is not None
        command = [
            FIREFOX,
            "--headless",
            "--marionette",
            "--remote-allow-system-access",
            "--no-remote",
            "--profile",
            str(profile),
        ]
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.number = 0
        self.socket = _reached(port)
        self._read()  # what it is
        self.send("WebDriver:NewSession", {"capabilities": {"alwaysMatch": {"unhandledPromptBehavior": "accept"}}})

    def close(self) -> None:
        """Ends the browser."""
        self.socket.close()
        self.process.terminate()
        self.process.wait(30)

    def _read(self) -> Any:
        size = b""
        while not size.endswith(b":"):
            size += self._bytes(1)
        return json.loads(self._bytes(int(size[:-1])))

    def _bytes(self, n: int) -> bytes:
        found = b""
        while len(found) < n:
            part = self.socket.recv(n - len(found))
            if not part:
                raise ConnectionError("Firefox has closed")
            found += part
        return found

    def send(self, command: str, parameters: dict[str, Any] | None = None) -> Any:
        """The result of a command. Raises RuntimeError with what Firefox says against it."""
        self.number += 1
        text = json.dumps([0, self.number, command, parameters or {}], ensure_ascii=False).encode()
        self.socket.sendall(f"{len(text)}:".encode() + text)
        _kind, _number, error, result = self._read()
        if error is not None:
            raise RuntimeError(f"{command}: {error['message']}")
        return result["value"] if isinstance(result, dict) and "value" in result else result

    # -- as a test of a page needs them ---------------------------------------------------------
    def open(self, address: str) -> None:
        self.send("WebDriver:Navigate", {"url": address})

    def evaluate(self, script: str, *arguments: Any) -> Any:
        return self.send("WebDriver:ExecuteScript", {"script": script, "args": list(arguments), "sandbox": None})

    def wait_for(self, condition: str, *arguments: Any, seconds: float = 60.0) -> None:
        """Until an expression is true on the page."""
        until = time.monotonic() + seconds
        while not self.evaluate(f"return Boolean({condition})", *arguments):
            assert time.monotonic() < until, f"not in {seconds:g} s: {condition} {arguments}"
            time.sleep(0.1)

    def element(self, selector: str) -> dict[str, str]:
        return self.send("WebDriver:FindElement", {"using": "css selector", "value": selector})

    def click(self, selector: str) -> None:
        self.send("WebDriver:ElementClick", {"id": self.element(selector)[ELEMENT]})

    def press(self, *keys: str) -> None:
        """Keys one after the other, wherever the focus is; Control+k holds the first."""
        actions: list[dict[str, str]] = []
        for key in keys:
            parts = [KEYS.get(part, part) for part in key.split("+")]
            actions += [{"type": "keyDown", "value": part} for part in parts]
            actions += [{"type": "keyUp", "value": part} for part in reversed(parts)]
        self.send("WebDriver:PerformActions", {"actions": [{"type": "key", "id": "keys", "actions": actions}]})

    def size(self, width: int, height: int) -> None:
        self.send("WebDriver:SetWindowRect", {"width": width, "height": height})

    def zoom(self, factor: float) -> None:
        """Makes all of the page larger: of a window that is as narrow as it goes the page then has fewer pixels."""
        self.send("Marionette:SetContext", {"value": "chrome"})
        self.evaluate("gBrowser.selectedBrowser.fullZoom = arguments[0]", factor)
        self.send("Marionette:SetContext", {"value": "content"})

    def picture(self) -> bytes:
        """What is seen of the page, as PNG."""
        return b64decode(self.send("WebDriver:TakeScreenshot", {"full": False, "hash": False}))


def _reached(port: int) -> socket.socket:
    """A connection, when the browser listens."""
    until = time.monotonic() + 120.0
    while True:
        try:
            return socket.create_connection(("127.0.0.1", port), timeout=120.0)
        except OSError:
            if time.monotonic() > until:
                raise
            time.sleep(0.2)
