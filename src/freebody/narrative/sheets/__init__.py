"""Exercise sheets."""
