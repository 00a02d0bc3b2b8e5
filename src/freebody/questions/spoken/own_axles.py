"""What turns about its own axle, as a planet does on its carrier: it turns relative to what carries that."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from freebody.measures.geometry import GROUND
from freebody.questions.spoken import of_axles
from freebody.questions.spoken.compounds import in_english_nouns
from freebody.questions.spoken.elements import Elements
from freebody.questions.spoken.lexicon import languages
from freebody.questions.spoken.naming import linked, plain_names

if TYPE_CHECKING:
    from freebody.model.names import Names

_OWN = re.compile(
    r"(?P<kind>[^\W\d]\w* )?(?P<who>[^\W\d]\w*) (?P<turns>(?:spin|turn|rotat|revolv)(?:s|es|e|ing)?) "
    r"(?:about|around|on) (?:its|their) "
    r"(?:own )?(?:axis|axes|axles?|pins?|shafts?|bearings?|spindles?|cent(?:re|er)s?)\b"
    r"|(?P<sich>dreht?|drehen|rotiert|rotieren) (?:sich )?(?:der |die |das )?(?P<wer>[^\W\d]\w*) (?:sich )?"
    r"(?:um|auf) (?:sein|ihr)e[nr]? (?:eigenen? )?(?:Achsen?|Bolzen|Zapfen|Welle)\b",
    re.IGNORECASE,
)


def about_own_axles(names: Names, elements: Elements, text: str) -> str:
    """A text in which what turns about its own axle turns relative to what carries that, if anything moving does."""

    def put(found: re.Match[str]) -> str:
        before, written = found["kind"] or "", found["who"] or found["wer"]
        bodies = _bodies(names, elements, before + written)  # the planet wheel
        before = "" if bodies else before
        bodies = bodies or _bodies(names, elements, written)
        carriers = _carriers(names, bodies[0]) if len(bodies) == 1 else None
        if carriers is None or len(carriers) > 1:
            return found[0]
        told = f"{found['sich']} sich {bodies[0]}" if found["wer"] else f"{before}{bodies[0]} {found['turns']}"
        leads = " relativ zu " if found["wer"] else " relative to "
        return told + "".join(leads + carrier for carrier in carriers)

    return _OWN.sub(put, text)


def _bodies(names: Names, elements: Elements, written: str) -> list[str]:
    said = {in_english_nouns(written, language, elements.taken) for language in languages()}
    meant = {plain_names(way.text) for word in said for way in linked(elements, word)}
    return sorted(meant & names.bodies.keys())


def _carriers(names: Names, body: str) -> list[str] | None:
    """What carries the axle of a body: none where that is the ground; None where nothing holds it by an axle."""
    held = [names.connections[name].mentions(names) for name in of_axles.axles(names)]
    others = [found - {body, GROUND} for found in held if body in found]
    if not others:
        return None
    return sorted(others[0]) if len(others) == 1 else None
