"""The symbolic route: exact, over a field of rational functions."""
