"""Statics with dry friction: what holds, by which margin, up to which value of a parameter, and how it fails."""
