"""Closed-form answers: what is found for a question, under which conditions, with which evidence."""
