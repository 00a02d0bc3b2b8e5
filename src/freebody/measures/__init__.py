"""Measures: the only geometry in the project. One file per kind."""
