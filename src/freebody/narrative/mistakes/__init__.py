"""Which mistake leads to a wrong option."""
