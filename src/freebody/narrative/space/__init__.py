"""Derivations in space."""
