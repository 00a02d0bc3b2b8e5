"""The pages of the documentation as scripts: what they show is run, in the order in which it stands there.

A page is run in a folder of its own, in which `examples` are at hand.

    yaml      with a first line `# NAME.yaml` is written there; whole models (those with bodies) are read
    sh        lines that begin with `freebody` are run, but for those that wait for a file to be saved
    console   `$ freebody ...`: run, and compared with the output below, which may be cut short by a last line `...`
    python    run with the names of the blocks before; a `text` block that follows at once is what it prints

    python tests/snippets.py PAGE...    writes the outputs anew; a last line `[12]` stands for twelve lines and `...`
"""

from __future__ import annotations

import importlib.util
import io
import re
import shlex
import sys
from contextlib import chdir, redirect_stdout
from dataclasses import dataclass
from pathlib import Path

import freebody as fb
from command import freebody

ROOT = Path(__file__).parents[1]
PAGES = [
    ROOT / "README.md",
    *sorted(path for path in (ROOT / "docs").rglob("*.md") if path.name != "tour.md" and "reference" not in path.parts),
]
_BLOCK = re.compile(r"^```(?P<language>[a-z]+)\n(?P<text>.*?)^```$", re.DOTALL | re.MULTILINE)
_FILE = re.compile(r"# (?P<name>\w+\.yaml)\n")
_NAMED_LINES = re.compile(r"\[(\d+)\]\n\Z")
_PEERS = re.compile(r"^(?:import|from) (mujoco|sympy)\b", re.MULTILINE)


class Differs(AssertionError):
    """What a page shows is not what comes out."""


@dataclass(frozen=True)
class Block:
    """A block of code: where its text stands in the page."""

    language: str
    text: str
    start: int
    end: int


def blocks_of(page: str) -> list[Block]:
    return [Block(m["language"], m["text"], m.start("text"), m.end("text")) for m in _BLOCK.finditer(page)]


def varying(text: str) -> str:
    """What differs between machines is left out: round-off, and the computing time."""
    text = re.sub(r"difference \S+", "difference *", text)
    text = re.sub(r"\d+ steps, \d+ evaluations, \S+ s comp", "* steps, * evaluations, * s comp", text)
    return re.sub(r"-?\d\.\de[-+]\d\d|-?\d\.\d+e-1\d", "*", text)


class Run:
    """A page while it is run. corrected: outputs that stand there otherwise, as blocks with their true texts."""

    def __init__(self, page: str, folder: Path) -> None:
        self.page, self.folder = page, folder
        self.names: dict[str, object] = {}
        self.corrected: list[tuple[Block, str]] = []
        if not (folder / "examples").exists():
            (folder / "examples").symlink_to(ROOT / "examples")

    def go(self) -> None:
        """Raises Differs, or what goes wrong."""
        blocks = blocks_of(self.page)
        for k, block in enumerate(blocks):
            following = blocks[k + 1] if k + 1 < len(blocks) else None
            match block.language:
                case "yaml":
                    self._model(block)
                case "sh":
                    self._commands(block)
                case "console":
                    self._console(block)
                case "python":
                    self._python(block, following)
                case _:
                    pass

    def _model(self, block: Block) -> None:
        """A model is read, and kept if it has a name."""
        named = _FILE.match(block.text)
        if named is not None:
            (self.folder / named["name"]).write_text(block.text, encoding="utf-8")
        if re.search(r"^bodies:", block.text, re.MULTILINE):
            fb.System.from_text(block.text)

    def _commands(self, block: Block) -> None:
        for line in block.text.splitlines():
            if line.startswith("freebody ") and "--watch" not in line:
                self._run(line)

    def _run(self, line: str) -> str:
        done = freebody(*shlex.split(line.removeprefix("freebody "), comments=True), cwd=self.folder)
        if done.returncode not in (0, 1):
            raise Differs(f"{line}\n{done.stderr}")
        if done.returncode == 1 and not done.stdout:
            raise Differs(f"{line}\n{done.stderr}")
        return done.stdout

    def _console(self, block: Block) -> None:
        command, _, shown = block.text.partition("\n")
        assert command.startswith("$ freebody "), command
        self._compare(block, command + "\n", shown, self._run(command.removeprefix("$ ")))

    def _python(self, block: Block, following: Block | None) -> None:
        peer = _PEERS.search(block.text)
        if peer is not None and importlib.util.find_spec(peer[1]) is None:
            return  # not installed here
        printed = io.StringIO()
        with chdir(self.folder), redirect_stdout(printed):
            exec(compile(block.text, "<page>", "exec"), self.names)
        if following is not None and following.language == "text":
            between = self.page[block.end : following.start]
            if not between.replace("```text", "").replace("```", "").strip():
                self._compare(following, "", following.text, printed.getvalue())

    def _compare(self, block: Block, head: str, shown: str, real: str) -> None:
        lines = _NAMED_LINES.search(shown)
        wanted = int(lines[1]) if lines else len(shown.splitlines()) - 1 if shown.endswith("...\n") else None
        real = "\n".join(line.rstrip() for line in real.strip("\n").splitlines()) + "\n"
        if wanted is not None and len(real.splitlines()) > wanted:
            real = "\n".join(real.splitlines()[:wanted]) + "\n...\n"
        if varying(real) != varying(shown):
            self.corrected.append((block, head + real))


def run(page: Path, folder: Path) -> Run:
    """Runs a page. Raises Differs where an output is another one."""
    made = Run(page.read_text(encoding="utf-8"), folder)
    made.go()
    return made


def write(page: Path, folder: Path) -> int:
    """Puts the true outputs into a page; how many were others."""
    made = run(page, folder)
    text = made.page
    for block, real in sorted(made.corrected, key=lambda each: -each[0].start):
        text = text[: block.start] + real + text[block.end :]
    page.write_text(text, encoding="utf-8")
    return len(made.corrected)


if __name__ == "__main__":
    from tempfile import TemporaryDirectory

    for name in sys.argv[1:]:
        with TemporaryDirectory() as temporary:
            print(f"{name}: {write(Path(name), Path(temporary))} outputs written anew")
