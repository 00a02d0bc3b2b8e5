"""Every command loads only what it uses: a process spends more time on loading packages than on mechanics."""

from __future__ import annotations

import ast
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[1] / "examples"
# packages that take long to load, or that are not there without an extra; those of the standard library are cheap
HEAVY = {
    "PIL",
    "flint",
    "fontTools",
    "h5py",
    "llvmlite",
    "matplotlib",
    "numba",
    "numpy",
    "pandas",
    "pint",
    "pydantic",
    "pygments",
    "rich",
    "ruamel",
    "scipy",
    "sympy",
    "typst",
    "xarray",
}
READING = {"pydantic", "ruamel", "numpy"}
EXACT = READING | {"flint"}
MOTION = EXACT | {"rich"}
DRAWN = {"matplotlib", "fontTools", "PIL"}  # by Matplotlib: plots, and pictures of pixels


def loaded(*words: str) -> set[str]:
    """The modules that a command leaves loaded."""
    code = (
        f"import sys\nfrom freebody.cli import main\nsys.argv = ['freebody', *{list(words)!r}]\n"
        "try:\n    main()\nexcept SystemExit as end:\n    assert not end.code, end.code\n"
        "print('loaded:', *sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return set(done.stdout.rpartition("loaded:")[2].split())


def packages(modules: set[str]) -> set[str]:
    return {name.partition(".")[0] for name in modules}


@pytest.mark.parametrize(
    ("command", "wanted"),
    [
        ("--version", set[str]()),
        ("--help", set[str]()),
        ("schema", {"pydantic"}),
        ("mobility four_bar", EXACT),
        ("eom cart_and_pendulum", EXACT),
        ("solve atwood_machine", EXACT),
        ("solve falling_hinged_rod", EXACT),
        ("solve cardan_joint", EXACT),
        ("explain atwood_machine", EXACT),
        ("conserved atwood_machine", EXACT),
        ("modes two_masses_three_springs", EXACT),
        ("statics ladder_rough_wall", EXACT | {"scipy"}),  # linear programmes: what forces friction can hold
        ("simulate four_bar --until 1s", MOTION),
        ("simulate bouncing_ball --until 1s", MOTION),
        ("simulate four_bar --until 1s --out FOLDER/motion.csv", MOTION),
        ("simulate four_bar --until 1s --plot FOLDER/motion.svg", MOTION | DRAWN),
        ("draw four_bar --out FOLDER/picture.svg", EXACT),
        ("draw four_bar --out FOLDER/picture.png", EXACT | DRAWN),
    ],
)
def test_a_command_loads_what_it_uses(command: str, wanted: set[str], tmp_path: Path) -> None:
    words = [word.replace("FOLDER", str(tmp_path)) for word in command.split()]
    words = [str(EXAMPLES / f"{w}.yaml") if (EXAMPLES / f"{w}.yaml").exists() else w for w in words]
    assert packages(loaded(*words)) & HEAVY <= wanted


def test_an_answer_without_contact_loads_neither_simulation_nor_contact() -> None:
    modules = loaded("solve", str(EXAMPLES / "atwood_machine.yaml"))
    rooms = ("numeric.contact", "numeric.timestepping", "numeric.engine.motion", "study.simulation")
    assert not [m for m in modules for room in rooms if m.startswith(f"freebody.{room}")]


SOURCE = Path(__file__).parents[1] / "src"


@cache
def borrowed(module: str) -> frozenset[str]:
    """The names that a module imports from another one of freebody and does not offer as its own."""
    file = SOURCE / f"{module.replace('.', '/')}.py"
    if not file.exists():  # a package offers what it imports
        return frozenset()
    tree = ast.parse(file.read_text("utf-8"))
    offered = {word.value for line in tree.body if is_offer(line) for word in ast.walk(line) if is_word(word)}
    imports = (line for line in ast.walk(tree) if isinstance(line, ast.ImportFrom))
    return frozenset(
        alias.asname or alias.name
        for line in imports
        if (line.module or "").startswith("freebody")
        for alias in line.names
    ) - frozenset(offered)


def is_offer(line: ast.stmt) -> bool:
    return isinstance(line, ast.Assign) and ast.unparse(line.targets[0]) == "__all__"


def is_word(node: ast.AST) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, str)


def test_a_name_is_imported_from_where_it_is_defined() -> None:
    """Otherwise a reader looks for it in two rooms, and a room cannot be split without touching all others."""
    through = [
        f"{file.relative_to(SOURCE)}:{line.lineno} {alias.name} through {line.module}"
        for file in sorted(SOURCE.rglob("*.py"))
        for line in ast.walk(ast.parse(file.read_text("utf-8")))
        if isinstance(line, ast.ImportFrom) and (line.module or "").startswith("freebody.")
        for alias in line.names
        if alias.name in borrowed(line.module or "")
    ]
    assert not through
