"""How kernels are declared, and what runs them.

A kernel is a Python function over numbers and arrays. It owns no memory and returns none. What Python calls are
entries; the annotations of their arguments are their types:

    Floats, Floats2    arrays of float64 in one and two dimensions, contiguous
    Ints, Ints2        arrays of int32
    int, float         numbers
    a NamedTuple       a bundle of arrays; in a `Workspace` of the plane the field that only space has is None

and the annotation of what they return is int, bool, float or None. What runs them is chosen by FREEBODY_KERNELS:

    library   (the default) the shared library that was made of these sources when the package was built
    numba     compiled in this process, for those who write kernels (extra `jit`)
    python    not compiled: some hundred times slower, and every line can be stepped through

No option of the compiler may change a result: products and sums are not fused and no sum is put in another order, so
that results are the same on every processor of a kind.
"""

from __future__ import annotations

import os
from typing import Any, Literal, get_args

import numpy as np

from freebody.numeric.kernels.entries import ENTRIES, N_DIMENSIONS, RUNNING, Entry, Function, fields_of

Backend = Literal["library", "numba", "python"]

OPTIONS: dict[str, Any] = {"error_model": "numpy", "nogil": True, "_nrt": False}  # of numba's compiler


def chosen_backend() -> Backend:
    """What runs kernels in this process. Raises ValueError for a value of FREEBODY_KERNELS that is none."""
    named: Any = os.environ.get("FREEBODY_KERNELS") or "library"
    if named not in get_args(Backend):
        raise ValueError(f"FREEBODY_KERNELS is {named!r}: it is one of {', '.join(get_args(Backend))}")
    return named


BACKEND: Backend = chosen_backend()


def _jitted(function: Function, **options: Any) -> Function:
    if BACKEND != "numba":
        return function
    import numba

    compiler: Any = numba
    return compiler.njit(**OPTIONS, **options)(function)


def kernel(function: Function) -> Function:
    """A function that entries call: compiled with them, and without the wrapper by which Python could call it (that
    costs compile time); from Python use `plain`."""
    return _jitted(function, no_cpython_wrapper=True, no_cfunc_wrapper=True)


def leaf(function: Function) -> Function:
    """A kernel of a few numbers, which Python can call as well."""
    return _jitted(function)


def part(function: Function) -> Function:
    """A piece of one kernel, put into it before types are inferred: cheap to compile where it is used once."""
    return _jitted(function, inline="always")


def plain(function: Function) -> Function:
    """The Python original of a kernel or a part; what it calls must be leaves."""
    return getattr(function, "py_func", function)


def entry(function: Function) -> Function:
    """A function called from Python."""
    return _runner(_declared(function))


def of_either(function: Function) -> Function:
    """An entry that serves the plane and space: one source, compiled for each. Which of them a call needs shows in its
    room, the second argument: in the plane it has no frames, and what only space needs is left out while types are
    inferred."""
    in_plane, in_space = (_runner(_declared(function, is_spatial=s)) for s in (False, True))

    def called(layout: Any, room: Any, *rest: Any) -> Any:
        return (in_plane if room.frames is None else in_space)(layout, room, *rest)

    return called


def _declared(function: Function, *, is_spatial: bool = False) -> Entry:
    kinds: dict[str, str] = dict(function.__annotations__)
    result = kinds.pop("return")
    known = {**function.__globals__, **{kind: kind for kind in (*N_DIMENSIONS, "int", "float")}}
    arguments = tuple(known[kind] for kind in kinds.values())
    module = function.__module__.rsplit(".", 1)[-1]
    name = f"freebody_{module}_{function.__name__}" + ("_in_space" if is_spatial else "")
    ENTRIES[name] = declared = Entry(name, function, arguments, result, is_spatial)
    return declared


def _runner(declared: Entry) -> Function:
    """What is called for an entry; nothing is compiled or loaded before the first call."""
    if BACKEND == "python":
        return declared.function

    def called(*arguments: Any) -> Any:
        return (RUNNING.get(declared.name) or _begun(declared))(*arguments)

    return called


def _begun(declared: Entry) -> Function:
    if BACKEND == "library":
        from freebody.numeric.kernels import library

        found = library.found(declared)
    else:
        found = _jitted(declared.function)
        compiled: Any = found
        compiled.compile(numba_types(declared))
        compiled.disable_compile()
    RUNNING[declared.name] = found
    return found


# -- types ------------------------------------------------------------------------------------
def example_of(kind: Any, *, is_spatial: bool = False) -> Any:
    """An argument of a kind, by which types are inferred."""
    if kind in ("int", "float"):
        return 1 if kind == "int" else 1.0
    if isinstance(kind, str):
        if kind == "Floats2 | None" and not is_spatial:
            return None
        return np.zeros((1,) * N_DIMENSIONS[kind], np.int32 if kind.startswith("Ints") else np.float64)
    return kind(*(example_of(k, is_spatial=is_spatial) for _name, k in fields_of(kind)))


def numba_types(declared: Entry) -> tuple[Any, ...]:
    """The types of an entry's arguments, as numba names them."""
    import numba

    compiler: Any = numba
    return tuple(compiler.typeof(example_of(kind, is_spatial=declared.is_spatial)) for kind in declared.arguments)
