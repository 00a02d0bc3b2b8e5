"""Closed forms of motion that goes on evenly: steady motion, its stability, extremes over a turn."""
