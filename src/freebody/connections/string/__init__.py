"""A string: its way as people write it (`way`), how that lies over the wheels (`laying`), and the rows that keep the
lengths of its sections (`sections`); drums with friction (`capstan`) and bodies that hang on it (`hanging`)."""

from freebody.connections.string.connection import String

__all__ = ["String"]
