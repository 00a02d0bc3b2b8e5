"""The documentation as a site: python -m sphinx -W docs OUT."""

project = "freebody"
author = "the freebody authors"
extensions = ["myst_parser"]
source_suffix = {".md": "markdown"}
exclude_patterns = ["gallery", "_build"]
html_theme = "furo"
html_title = "freebody"
myst_heading_anchors = 3
suppress_warnings = ["misc.highlighting_failure"]
