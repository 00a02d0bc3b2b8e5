"""The numeric route: absolute coordinates in floating point."""
