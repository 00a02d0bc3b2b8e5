"""`python -m freebody`, where the command is not on the path."""

from freebody.cli import main

main()
