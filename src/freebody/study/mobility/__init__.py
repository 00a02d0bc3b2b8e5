"""How a mechanism can move: freedoms, dependent constraints, linkages, centres, and what contradicts itself."""
