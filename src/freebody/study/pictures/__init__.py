"""What is drawn of a system: as it stands, in motion, and bodies cut free with what acts on them."""
