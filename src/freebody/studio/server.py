"""The server of the page: for this machine, for whoever has the token, and for nothing but the page.

Only names of this machine are answered (`Host`), so that no other site reaches it by a name of its own (DNS rebinding);
requests that another page makes are refused (`Origin`), and every request that does anything has the token, which only
the address in the terminal tells: it stands in the fragment, which browsers send to nobody. Source: OWASP, Cross-Site
Request Forgery Prevention; RFC 3986, section 3.5.
"""

from __future__ import annotations

import asyncio
import json
import secrets
from collections.abc import AsyncGenerator, Awaitable, Callable
from contextlib import asynccontextmanager
from importlib.metadata import version
from importlib.resources import files
from typing import Any

from pydantic import BaseModel, ValidationError
from starlette.applications import Starlette
from starlette.requests import ClientDisconnect, Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from freebody.errors import InputError
from freebody.examples_folder import folder as examples_folder
from freebody.examples_folder import listed_examples, listed_templates, templates
from freebody.present.video import has_ffmpeg
from freebody.studio.folder import Folder
from freebody.studio.lanes import Lanes
from freebody.studio.late import LateAnswers
from freebody.studio.look import style_sheet
from freebody.studio.telling import told
from freebody.studio.wire.around import Call, Example, Opening, SaveAnswer, SaveRequest
from freebody.studio.work import WORK

LARGEST = 3_000_000  # [bytes] of a request
NAMES = ("127.0.0.1", "localhost", "[::1]")  # of this machine
# styles stand in pictures and reports as well as in the editor; scripts come from the page's own file alone
_POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
    "font-src 'self' data:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
_HEADERS = {
    "Content-Security-Policy": _POLICY,
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cache-Control": "no-store",
}
_TYPES = {
    "html": "text/html; charset=utf-8",
    "js": "text/javascript; charset=utf-8",
    "css": "text/css; charset=utf-8",
    "woff2": "font/woff2",
    "svg": "image/svg+xml",
}
Answer = Callable[[Any, Request], Awaitable[Any]]


def new_token() -> str:
    return secrets.token_urlsafe(24)


def studio(folder: Folder, token: str, port: int) -> Starlette:
    """The application. port: on which it is asked; only requests for it are answered."""
    lanes = Lanes(folder.path, examples_folder())
    late = LateAnswers(lanes.leave)
    hosts = {f"{name}:{port}" for name in NAMES}

    @asynccontextmanager
    async def life(_app: Starlette) -> AsyncGenerator[None]:
        lanes.begin(folder.foreseen())
        yield
        await lanes.end()

    def guarded(answer: Answer) -> Callable[[Request], Awaitable[Response]]:
        async def respond(request: Request) -> Response:
            refused = _refused(request, hosts, token)
            if refused is not None:
                return refused
            try:
                found = await answer(await _body(request), request)
                kind = Response if isinstance(found, bytes) else JSONResponse
                return kind(found, headers=_HEADERS, media_type="application/json")
            except (ValidationError, json.JSONDecodeError, KeyError, UnicodeDecodeError):
                return _plain(400, "this request cannot be read")
            except _TooLarge:
                return _plain(413, "this request is too large")
            except InputError as error:
                return JSONResponse({"message": str(error)}, 409, headers=_HEADERS)
            except ClientDisconnect:
                return _plain(400, "")

        return respond

    async def page(request: Request) -> Response:
        if not _is_here(request, hosts):
            return _plain(403, "")
        return _asset(request.path_params.get("name", "index.html"))

    async def look(request: Request) -> Response:
        if not _is_here(request, hosts):
            return _plain(403, "")
        return Response(style_sheet(), media_type=_TYPES["css"], headers=_HEADERS)

    async def open_page(_body: Any, _request: Request) -> Any:
        opening = Opening(
            file=folder.first_opened(),
            files=folder.names(),
            is_file=bool(folder.first),
            version=version("freebody"),
            has_ffmpeg=has_ffmpeg(),
        )
        return opening.model_dump()

    async def ask(body: Any, request: Request) -> Any:
        call = Call.model_validate(body)
        if call.kind not in WORK:
            raise KeyError(call.kind)
        async with _watched(request, lambda: lanes.leave(call.topic)):
            return await late.now_or_later(call, asyncio.create_task(lanes.ask(call)))

    async def later(body: Any, request: Request) -> Any:
        window = str(body["window"])
        async with _watched(request, lambda: late.left(window)):
            return await late.ready(window)

    async def cancel(body: Any, _request: Request) -> Any:
        lanes.cancel(str(body["topic"]))
        return {}

    async def leave(body: Any, _request: Request) -> Any:
        number = body.get("number")
        lanes.leave(str(body["topic"]), number if isinstance(number, int) else None)
        return {}

    async def busy(_body: Any, _request: Request) -> Any:
        return lanes.busy()

    async def read_file(body: Any, _request: Request) -> Any:
        return folder.opened(str(body["name"])).model_dump()

    async def save(body: Any, _request: Request) -> Any:
        request = SaveRequest.model_validate(body)
        try:
            return folder.save(request).model_dump()
        except InputError as error:  # a name that somebody typed: an answer, and no failure of the page
            message = told(str(error), request.language)
            return SaveAnswer(version="", is_changed=False, message=message).model_dump()

    async def examples(_body: Any, _request: Request) -> Any:
        return [each.model_dump() for each in _examples()]

    answers: dict[str, Answer] = {
        "open": open_page,
        "ask": ask,
        "later": later,
        "cancel": cancel,
        "leave": leave,
        "busy": busy,
        "file": read_file,
        "save": save,
        "examples": examples,
    }
    routes = [Route(f"/api/{name}", guarded(answer), methods=["POST"]) for name, answer in answers.items()]
    routes += [Route("/", page), Route("/look.css", look), Route("/{name}", page)]
    app = Starlette(routes=routes, lifespan=life)
    app.state.lanes = lanes
    return app


class _TooLarge(Exception):
    pass


def _is_here(request: Request, hosts: set[str]) -> bool:
    origin = request.headers.get("origin")
    host = request.headers.get("host", "")
    return host in hosts and (origin is None or origin == f"http://{host}")


def _refused(request: Request, hosts: set[str], token: str) -> Response | None:
    """Why a request is not answered, if it is not."""
    if not _is_here(request, hosts):
        return _plain(403, "the studio answers its own page on this machine alone")
    given = request.headers.get("authorization", "").removeprefix("Bearer ")
    if not secrets.compare_digest(given.encode(), token.encode()):
        return _plain(401, "open the studio by the address that it printed")
    if request.headers.get("content-type", "").split(";")[0] != "application/json":
        return _plain(415, "")
    return None


async def _body(request: Request) -> Any:
    size = request.headers.get("content-length")
    if size is not None and (not size.isdigit() or int(size) > LARGEST):
        raise _TooLarge
    content = bytearray()
    async for part in request.stream():
        content += part
        if len(content) > LARGEST:
            raise _TooLarge
    body = json.loads(content.decode("utf-8"))
    if not isinstance(body, dict):
        raise KeyError
    return body


@asynccontextmanager
async def _watched(request: Request, leave: Callable[[], None]) -> AsyncGenerator[None]:
    """While this is answered it is seen whether the window that has asked is still there."""
    waiting = asyncio.create_task(_gone(request, leave))
    try:
        yield
    finally:
        waiting.cancel()


async def _gone(request: Request, leave: Callable[[], None]) -> None:
    """When the window that has asked is gone, nobody waits for the answer."""
    while (await request.receive())["type"] != "http.disconnect":
        pass
    leave()


def _plain(status: int, text: str) -> Response:
    return Response(text, status, media_type="text/plain", headers=_HEADERS)


def _asset(name: str) -> Response:
    """A file of the built page: one of those that there are, by its whole name."""
    page = files("freebody.studio").joinpath("page")
    known = {each.name: each for each in page.iterdir() if each.is_file()}
    kind = _TYPES.get(name.rpartition(".")[2])
    if name not in known or kind is None:
        return _plain(404, "")
    return Response(known[name].read_bytes(), media_type=kind, headers=_HEADERS)


def _examples() -> list[BaseModel]:
    """The bundled models: templates to start from first."""
    bundled = [(name, title, templates()[name], True) for name, title in listed_templates()]
    bundled += [(name, title, examples_folder() / f"{name}.yaml", False) for name, title in listed_examples()]
    return [
        Example(name=name, title=title, text=path.read_text(encoding="utf-8"), is_template=is_template)
        for name, title, path, is_template in bundled
    ]
