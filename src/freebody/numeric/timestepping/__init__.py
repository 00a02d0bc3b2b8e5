"""Time stepping with contacts: many at once, none of their events located (Moreau-Jean)."""
