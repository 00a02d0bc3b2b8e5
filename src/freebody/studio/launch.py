"""The command: an address of this machine, a token, the server, and a browser that opens it."""

from __future__ import annotations

import os
import socket
import webbrowser
from contextlib import suppress
from hashlib import sha256
from pathlib import Path
from typing import Any

from freebody.errors import InputError
from freebody.messages import Message
from freebody.studio import nursery


def launch(file: Path | None, port: int, *, opens_browser: bool) -> None:
    """Serves the studio until it is interrupted. port: 0 for that of the folder, or any where it is taken. The first
    line printed is the address. Raises InputError where the extra is not installed, or the port is taken."""
    nursery.begin()
    try:
        import uvicorn

        from freebody.studio.folder import Folder
        from freebody.studio.server import new_token, studio
    except ModuleNotFoundError as error:
        raise InputError(
            Message('the studio needs {package}; pip install "freebody[studio]"', package=error.name or "")
        ) from None
    folder = Folder.of(file)
    bound = bound_at(port) if port else _bound_for(folder.path)
    port, token = bound.getsockname()[1], new_token()
    address = f"http://127.0.0.1:{port}/#token={token}"
    print(address, flush=True)
    app = studio(folder, token, port)
    config = uvicorn.Config(app, log_level="warning", server_header=False, access_log=False)

    class Server(uvicorn.Server):
        async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
            """Nobody waits any more for what is being answered, or the terminal would not come back until then."""
            await app.state.lanes.end()
            await super().shutdown(sockets)

    if opens_browser:
        webbrowser.open(address)
    with suppress(KeyboardInterrupt):  # which is how it ends
        Server(config).run(sockets=[bound])


def port_of(folder: Path) -> int:
    """Browsers keep drafts by the address, so a folder has the same one whenever it is opened. Below the ports from
    which systems reach out."""
    return 20_000 + int.from_bytes(sha256(str(folder).encode("utf-8", "surrogatepass")).digest()[:4]) % 12_000


def _bound_for(folder: Path) -> socket.socket:
    try:
        return bound_at(port_of(folder))
    except InputError:  # somebody has it, perhaps a studio of this folder
        return bound_at(0)


def bound_at(port: int) -> socket.socket:
    """A socket of this machine alone."""
    # by its protocol the server knows that what is written in parts need not wait for each other (`TCP_NODELAY`)
    bound = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    if os.name == "posix":  # else a port is not free for minutes after a page has used it; on Windows it means to share
        bound.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        bound.bind(("127.0.0.1", port))
        bound.listen(100)  # a browser may come before the server
    except OSError as error:
        bound.close()
        raise InputError(Message("port {port} cannot be used: {why}", port=port, why=error.strerror or "")) from error
    return bound


def export(file: Path, to: Path, until: float, language: str, vary: list[str]) -> Path:
    """Writes the page of a model with all its answers in it, as one file that needs no server. vary: what its sliders
    move. Raises ModelError, InputError for ranges that cannot be read."""
    from freebody.language.document.file import text_of
    from freebody.present.files import write_whole
    from freebody.studio.sharing import shared_page
    from freebody.studio.wire.studies import ShareRequest

    given: Any = {"text": text_of(file), "language": language, "until": until, "name": file.name, "vary": vary}
    write_whole(to, shared_page(ShareRequest(**given)))
    return to
