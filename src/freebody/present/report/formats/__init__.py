"""The formats of reports, a file each: a writer of blocks, and the suffix by which a name asks for it."""
