"""Lines of a derivation, the symbols in them, and how they are checked."""
