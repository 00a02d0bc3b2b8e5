"""Many cases of one system: what its answers and motions come to while parameters and start values vary."""
