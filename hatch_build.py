"""What hatch does beside copying files: the kernels are compiled when the package is built (`tools/build_kernels.py`).

A wheel has the libraries of one platform: of this machine, or of the one that FREEBODY_PLATFORM names. An editable
installation has them beside the sources. For a platform without libraries the wheel is one of Python alone, whose
kernels run uncompiled or by numba.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

TAGS = {
    "linux-x86_64": "manylinux_2_17_x86_64.musllinux_1_1_x86_64",
    "linux-aarch64": "manylinux_2_17_aarch64.musllinux_1_1_aarch64",
    "macos-arm64": "macosx_11_0_arm64",
    "windows-x86_64": "win_amd64",
}


class KernelsHook(BuildHookInterface[Any]):
    """Compiles the kernels, and puts them into the wheel."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        if self.target_name != "wheel":
            return
        sys.path.insert(0, str(Path(self.root) / "tools"))
        import build_kernels

        name = os.environ.get("FREEBODY_PLATFORM") or build_kernels.native()
        if name not in build_kernels.TARGETS:
            self.app.display_warning(f"no kernels are compiled for {name}: freebody will run them uncompiled")
            return
        if version == "editable":
            build_kernels.place(name, build_kernels.KERNELS)
            return
        for path in build_kernels.built(name):
            build_data["force_include"][str(path)] = f"freebody/numeric/kernels/{path.name}"
        build_data["pure_python"] = False
        build_data["tag"] = f"py3-none-{TAGS[name]}"
