"""Answers that people type, checked by the mechanics."""
