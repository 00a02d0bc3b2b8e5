"""Systems: read from files or built in Python."""
