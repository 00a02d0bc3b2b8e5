"""Options judged against a solved question."""
