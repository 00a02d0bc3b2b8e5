"""The symbolic route in space: orientations by chains of angles, six components a body."""
