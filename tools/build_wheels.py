"""Builds a wheel for every platform that kernels are compiled for: python tools/build_wheels.py [FOLDER]

Needs `pip` alone: it fetches the build requirements of pyproject.toml once for each wheel.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from build_kernels import ROOT, TARGETS


def main() -> None:
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "dist"
    for name in TARGETS:
        subprocess.run(
            [sys.executable, "-m", "pip", "wheel", "--no-deps", "--quiet", "-w", str(folder), str(ROOT)],
            env=os.environ | {"FREEBODY_PLATFORM": name},
            check=True,
        )
    for path in sorted(folder.glob("freebody-*.whl")):
        print(f"{path.name}: {path.stat().st_size // 1024} kB")


if __name__ == "__main__":
    main()
