"""Studies: what freebody finds out about a system."""
