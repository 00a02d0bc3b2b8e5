"""Where a system rests, and how it moves about rest."""
