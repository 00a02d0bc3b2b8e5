"""Compiles the kernels to shared libraries with a C interface, which need nothing of Python, numba or the system.

python tools/build_kernels.py                      for this machine, beside the sources
python tools/build_kernels.py --into FOLDER        elsewhere
python tools/build_kernels.py --platform NAME      for another machine (`TARGETS`)

numba translates every entry (`freebody.numeric.kernels.declaring`) with a wrapper that takes its arguments from a table
of words; the modules, of which only these wrappers can be called, are compiled and linked by Zig's clang for any
machine. Products and sums are not fused, so that all processors of a kind compute the same; on x86-64 there is a second
library for processors with vectors of four numbers. The elementary functions are Zig's own.

What was compiled once is kept in the user's cache by the digest of the sources, of this file, and of the compilers.
"""

from __future__ import annotations

import argparse
import hashlib
import importlib
import importlib.metadata
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import types
from dataclasses import dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
KERNELS = ROOT / "src/freebody/numeric/kernels"
RUNTIME = Path(__file__).with_name("kernels_runtime.zig")
HALVES = ("plane", "space")  # translated by a process each


@dataclass(frozen=True)
class Target:
    """A kind of machine, and a library for it. cpu: what instructions may be used."""

    triple: str
    cpu: str
    file: str


TARGETS = {
    "linux-x86_64": (
        Target("x86_64-linux", "x86_64_v2", "kernels.so"),
        Target("x86_64-linux", "x86_64_v3", "kernels_v3.so"),
    ),
    "linux-aarch64": (Target("aarch64-linux", "generic", "kernels.so"),),
    "macos-arm64": (Target("aarch64-macos", "apple_m1", "kernels.dylib"),),
    "windows-x86_64": (Target("x86_64-windows-gnu", "x86_64_v2", "kernels.dll"),),
}
_SYSTEMS = {"linux": "linux", "darwin": "macos", "win32": "windows"}
_MACHINES = {"AMD64": "x86_64", "x64": "x86_64", "arm64": "arm64" if sys.platform == "darwin" else "aarch64"}


def native() -> str:
    """The name of this machine's platform, as in `TARGETS`; it need not be there."""
    machine = platform.machine()
    return f"{_SYSTEMS.get(sys.platform, sys.platform)}-{_MACHINES.get(machine, machine)}"


# -- the cache --------------------------------------------------------------------------------
def sources_digest() -> str:
    """As `freebody.numeric.kernels.library.digest`, which is not imported: what it needs may not be installed."""
    found = hashlib.sha256()
    for path in sorted(KERNELS.glob("*.py")):
        if path.name != "library.py":
            found.update(path.name.encode() + b"\0" + path.read_bytes().replace(b"\r\n", b"\n") + b"\0")
    return found.hexdigest()[:32]


def cache_folder() -> Path:
    """Where the libraries of these sources are kept."""
    found = hashlib.sha256(sources_digest().encode())
    for path in (Path(__file__), RUNTIME):
        found.update(path.read_bytes())
    for name in ("numba", "llvmlite", "ziglang"):
        found.update(f"{name} {importlib.metadata.version(name)}".encode())
    home = os.environ.get("XDG_CACHE_HOME")
    try:
        base = Path(home) if home else Path.home() / ".cache"
        (base / "freebody-kernels").mkdir(parents=True, exist_ok=True)
    except (OSError, RuntimeError):  # no home, or one that cannot be written
        base = Path(tempfile.gettempdir())
    return base / "freebody-kernels" / found.hexdigest()[:32]


def built(name: str) -> list[Path]:
    """The libraries for a platform, compiled if they are not kept. Raises KeyError for an unknown platform,
    RuntimeError where a compiler fails."""
    kept = cache_folder() / name
    wanted = [kept / target.file for target in TARGETS[name]]
    if not all(path.exists() for path in wanted):
        with tempfile.TemporaryDirectory() as folder:
            work = Path(folder)
            translated = _translated(cache_folder(), work)
            for target in TARGETS[name]:
                _put(_linked(target, translated, work), kept / target.file)
    return wanted


def _put(made: Path, place: Path) -> None:
    """A file appears whole or not at all, whoever else makes the same one."""
    place.parent.mkdir(parents=True, exist_ok=True)
    passing = place.with_name(f"{place.name}.{os.getpid()}")
    shutil.copyfile(made, passing)
    os.replace(passing, place)


# -- translation ------------------------------------------------------------------------------
def _translated(cache: Path, work: Path) -> list[Path]:
    """The modules of both halves as text."""
    kept = [cache / f"{half}.ll" for half in HALVES]
    if not all(path.exists() for path in kept):
        made = [work / f"{half}.ll" for half in HALVES]
        settings = {"FREEBODY_KERNELS": "numba", "NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": ""}
        settings |= {"NUMBA_LOOP_VECTORIZE": "0", "NUMBA_SLP_VECTORIZE": "0", "NUMBA_ENABLE_AVX": "0"}
        running = [
            subprocess.Popen([sys.executable, __file__, "--translate", half, str(out)], env=os.environ | settings)
            for half, out in zip(HALVES, made, strict=True)
        ]
        for half, process in zip(HALVES, running, strict=True):
            if process.wait() != 0:
                raise RuntimeError(f"numba could not translate the kernels of {half}")
        for path, place in zip(made, kept, strict=True):
            _put(path, place)
    return kept


def _declaring() -> Any:
    """The module that declares entries, all entries declared, without the rest of freebody."""
    for name, folder in (("freebody", KERNELS.parents[1]), ("freebody.numeric", KERNELS.parent)):
        package = types.ModuleType(name)
        package.__path__ = [str(folder)]
        sys.modules[name] = package
    for path in sorted(KERNELS.glob("*.py")):
        if path.stem not in ("__init__", "library"):
            importlib.import_module(f"freebody.numeric.kernels.{path.stem}")
    return importlib.import_module("freebody.numeric.kernels.declaring")


def translate(half: str, out: Path) -> None:
    """Writes the module of all entries of one half. Entries of which only one is there, such as those of time stepping,
    belong to the half that has less to do: space."""
    import llvmlite.binding as llvm

    declaring = _declaring()
    both = {name for name in declaring.ENTRIES if f"{name}_in_space" in declaring.ENTRIES}
    entries = [e for e in declaring.ENTRIES.values() if (e.name in both) == (half == "plane")]
    whole = None
    for entry in entries:
        module = llvm.parse_assembly(_compiled(entry, declaring))
        if whole is None:
            whole = module
        else:
            whole.link_in(module)
    assert whole is not None
    out.write_text(str(whole))


def _compiled(entry: Any, declaring: Any) -> str:
    """The module of an entry, of which nothing but the wrapper is seen from outside."""
    import llvmlite.binding as llvm
    import numba

    compiler: Any = numba
    inner = compiler.njit(**declaring.OPTIONS)(entry.function)
    wrapper = compiler.njit(no_cpython_wrapper=True, no_cfunc_wrapper=True, **declaring.OPTIONS)(
        _wrapper(entry, inner, declaring)
    )
    wrapper.compile(compiler.float64(compiler.int64))
    (overload,) = wrapper.overloads.values()
    text = overload.library.get_llvm_str()
    module = llvm.parse_assembly(text)
    symbol = overload.fndesc.llvm_func_name
    for function in module.functions:
        if not function.is_declaration:
            function.linkage = "external" if function.name == symbol else "internal"
    for variable in module.global_variables:
        if not variable.is_declaration:
            variable.linkage = "internal"
    module.get_function(symbol).name = entry.name
    return str(module)


def _wrapper(entry: Any, inner: Any, declaring: Any) -> Any:
    """A function of the place of a table of words, written as text: arguments are taken from it, and the result is a
    float."""
    names: dict[str, Any] = {"entry": inner, **_intrinsics()}
    at, lines, taken = 0, ["def called(words):"], list[str]()
    for k, kind in enumerate(entry.arguments):
        if kind in ("int", "float"):
            taken.append(f"{kind}_at(words, {at})")
            at += 1
        elif isinstance(kind, str):
            taken.append(_array("words", at, kind, declaring))
            at += 1 + declaring.N_DIMENSIONS[kind]
        else:
            names[f"Bundle{k}"] = kind
            parts, inside = [], 0
            for _name, of in declaring.fields_of(kind):
                is_there = not of.endswith("None") or entry.is_spatial
                parts.append(_array(f"table{k}", inside, of, declaring) if is_there else "None")
                inside += 1 + declaring.N_DIMENSIONS[of]
            lines.append(f"    table{k} = int_at(words, {at})")
            taken.append(f"Bundle{k}({', '.join(parts)})")
            at += 1
    call = f"entry({', '.join(taken)})"
    ends = {"None": [call, "return 0.0"], "bool": [f"return 1.0 if {call} else 0.0"]}
    lines += [f"    {line}" for line in ends.get(entry.result, [f"return float({call})"])]
    exec("\n".join(lines), names)
    return names["called"]


def _array(table: str, at: int, kind: str, declaring: Any) -> str:
    n = declaring.N_DIMENSIONS[kind]
    words = ", ".join(f"int_at({table}, {at + k})" for k in range(1 + n))
    return f"{'ints' if kind.startswith('Ints') else 'floats'}_{n}({words})"


def _intrinsics() -> dict[str, Any]:
    """Words of a table by its place, and arrays by theirs: views of memory that is not theirs."""
    from numba.core import types as kinds
    from numba.extending import intrinsic
    from numba.np.arrayobj import make_array, populate_array

    def word(kind: Any) -> Any:
        def typed(_context: Any, _table: Any, _k: Any) -> Any:
            def code(context: Any, builder: Any, _signature: Any, values: Any) -> Any:
                table = builder.inttoptr(values[0], context.get_value_type(kinds.CPointer(kind)))
                return builder.load(builder.gep(table, [values[1]]))

            return kind(kinds.int64, kinds.int64), code

        return intrinsic(typed)

    def array(kind: Any, n: int) -> Any:
        whole, size = kinds.Array(kind, n, "C"), kind.bitwidth // 8

        def code(context: Any, builder: Any, _signature: Any, values: Any) -> Any:
            place, *shape = values
            made = make_array(whole)(context, builder)
            number = context.get_constant
            strides = [number(kinds.intp, size)]
            if n == 2:
                strides.insert(0, builder.mul(shape[1], strides[0]))
            populate_array(
                made,
                data=builder.inttoptr(place, context.get_value_type(kinds.CPointer(kind))),
                shape=shape,
                strides=strides,
                itemsize=number(kinds.intp, size),
                meminfo=None,
            )
            return made._getvalue()

        def of_one(_context: Any, place: Any, rows: Any) -> Any:
            return whole(kinds.int64, kinds.int64), code

        def of_two(_context: Any, place: Any, rows: Any, columns: Any) -> Any:
            return whole(kinds.int64, kinds.int64, kinds.int64), code

        return intrinsic(of_one if n == 1 else of_two)

    return {
        "int_at": word(kinds.int64),
        "float_at": word(kinds.float64),
        **{f"floats_{n}": array(kinds.float64, n) for n in (1, 2)},
        **{f"ints_{n}": array(kinds.int32, n) for n in (1, 2)},
    }


# -- compiling and linking --------------------------------------------------------------------
def _linked(target: Target, modules: list[Path], work: Path) -> Path:
    """The library for a target."""
    made: list[str] = []
    for module in modules:
        text = re.sub(r"^target (triple|datalayout) = .*\n", "", module.read_text(), flags=re.M)
        source = work / f"{target.cpu}-{module.name}"
        source.write_text(text)
        made.append(str(source.with_suffix(".o")))
        _zig(
            *("cc", "-c", "-O3", "-fPIC", "-ffp-contract=off", "-fno-sanitize=all", "-Wno-override-module"),
            *("-target", target.triple, f"-mcpu={target.cpu}", str(source), "-o", made[-1]),
        )
    about = work / f"{target.cpu}-digest.zig"
    about.write_text(RUNTIME.read_text() + f'\nexport const freebody_digest: [32:0]u8 = "{sources_digest()}".*;\n')
    out = work / target.file
    _zig(
        *("build-lib", "-dynamic", "-O", "ReleaseFast", "-fcompiler-rt", "-fno-unwind-tables", "-fstrip", "-z", "defs"),
        *("-target", target.triple, f"-mcpu={target.cpu}", f"-femit-bin={out}", str(about), *made),
    )
    return out


def _zig(*arguments: str) -> None:
    done = subprocess.run([sys.executable, "-m", "ziglang", *arguments], capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"zig {arguments[0]}: {done.stderr[-2000:]}")


# -- as a program -----------------------------------------------------------------------------
def place(name: str, folder: Path) -> list[Path]:
    """Puts the libraries for a platform into a folder, and takes away those of another make."""
    made = built(name)
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("kernels*.*"):
        if old.suffix in (".so", ".dylib", ".dll") and old.name not in {path.name for path in made}:
            old.unlink()
    for path in made:
        _put(path, folder / path.name)
    return [folder / path.name for path in made]


def main() -> None:
    reader = argparse.ArgumentParser(description="Compiles the kernels of freebody.")
    reader.add_argument("--into", type=Path, default=KERNELS, metavar="FOLDER")
    reader.add_argument("--platform", choices=TARGETS, default=native(), metavar="NAME")
    reader.add_argument("--translate", nargs=2, metavar=("HALF", "FILE"), help=argparse.SUPPRESS)
    asked = reader.parse_args()
    if asked.translate:
        translate(asked.translate[0], Path(asked.translate[1]))
        return
    for path in place(asked.platform, asked.into):
        print(f"{path.name}: {path.stat().st_size // 1024} kB")


if __name__ == "__main__":
    main()
