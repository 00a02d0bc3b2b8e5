"""The sections of a file, what people call them, and the keys that entries have beside their kinds."""

from __future__ import annotations

from collections.abc import Mapping

from freebody.model.friction import AT_REST, IN_MOTION
from freebody.model.spec import FRICTION, RESTITUTION

SECTIONS = (
    "freebody",
    "title",
    "about",
    "source",
    "space",
    "parameters",
    "ground",
    "frames",
    "bodies",
    "connections",
    "loads",
    "measures",
    "states",
    "start",
    "questions",
    "drawing",
    "style",
)

# what people write for a section
MEANT_SECTIONS: Mapping[str, str] = {
    **dict.fromkeys(
        ("joints", "constraints", "supports", "contacts", "drivers", "drives", "motors", "collisions"), "connections"
    ),
    **dict.fromkeys(("forces", "torques", "springs", "dampers", "actions"), "loads"),
    **dict.fromkeys(("initial", "initial_conditions", "initial_values", "at_start"), "start"),
    **dict.fromkeys(("coordinates", "variables", "outputs"), "measures"),
    **dict.fromkeys(("constants", "symbols", "values", "given"), "parameters"),
    **dict.fromkeys(("find", "ask", "wanted"), "questions"),
    **dict.fromkeys(("elements", "parts", "masses", "objects", "components"), "bodies"),
    **dict.fromkeys(("name",), "title"),
    **{"Parameter": "parameters", "gegeben": "parameters", "Körper": "bodies", "verbindungen": "connections"},
    **{"Verbindungen": "connections", "Gelenke": "connections", "Lager": "connections", "Boden": "ground"},
    **{"Lasten": "loads", "lasten": "loads", "Kräfte": "loads", "Anfang": "start", "Fragen": "questions"},
    **{
        "fragen": "questions",
        "gesucht": "questions",
        "körper": "bodies",
        "Titel": "title",
        "Messgrößen": "measures",
        "Koordinaten": "measures",
        "Federn": "loads",
    },
    **dict.fromkeys(("description",), "about"),
}
CALLED_LINES = ("floor", "wall", "slope", "incline", "ramp", "table", "road", "ceiling")
OF_LINES = ("through", "along", "angle", "solid", "x", "y")  # the fields of a line
ROUGH = (  # of what touches
    *("friction", "mu", "Reibung", "Reibungszahl", "Reibbeiwert", *FRICTION, *AT_REST, *IN_MOTION),
    *("restitution", "e", *RESTITUTION),
)
LIES_ON = ("on", "lies_on", "rests_on")  # of a body, in itself, how it is held
ATTACHED = ("attached_to", "fixed_to", "welded_to", "glued_to", "mounted_on", "fixed_at", "befestigt_an")
HINGED = ("hinged_to", "pinned_to", "pivoted_to", "hinged_at", "pinned_at", "pivoted_at", "gelenkig_an")
OF_GROUND = ("points", "lines", "planes")  # that the ground and bodies have
OF_PARAMETERS = ("value", "unit", "sign", "about")

SAYS_KIND = ("type", "kind", "shape")  # in an entry
CLOSES = "closes"  # beside the kind of a connection
# beside the shape of a body
_ALWAYS = ("at", "near", "velocity", "angular_velocity", "points", "lines", "fixed", "copies")
PLANAR_OPTIONS = (*_ALWAYS, "angle", "outline")
SPATIAL_OPTIONS = (*_ALWAYS, "turned", "frame", "planes")
OF_DRAWINGS = ("paths", "labels", "scale", "wheels", "hide")
OF_STYLES = ("names", "axes", "order", "decimal")
