"""Derivations about motion that goes on evenly."""
