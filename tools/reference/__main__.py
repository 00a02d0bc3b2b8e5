"""python tools/reference FOLDER"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from reference import write

print(f"wrote {len(write(Path(sys.argv[1])))} files to {sys.argv[1]}")
