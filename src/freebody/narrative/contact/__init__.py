"""Derivations of motions in phases, and of rest under dry friction."""
