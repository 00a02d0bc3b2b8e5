"""Verbs that no rule of spelling inflects: the forms of English and German strong verbs.

A line is a verb with its other forms. English: slide, slid; what is regular beside them (slides, sliding) is not
written. German: the infinitive with its third person, its past and its participle (sinken sinkt sank gesunken), from
which those of verbs with a prefix follow: abgesunken, sank ... ab.
"""

from __future__ import annotations

_ENGLISH = """
become became
begin began begun
bend bent
break broke broken
bring brought
catch caught
cling clung
come came
creep crept
draw drew drawn
drive drove driven
eat ate eaten
fall fell fallen
fling flung
fly flew flown
get got gotten
give gave given
go went gone
grind ground
grow grew grown
hang hung
hold held
keep kept
lean leant
leap leapt
leave left
lose lost
make made
meet met
pay paid
ride rode ridden
rise rose risen
run ran
shoot shot
shrink shrank shrunk
sink sank sunk
sit sat
slide slid
sling slung
spin spun
spring sprang sprung
stand stood
stick stuck
strike struck
sweep swept
swell swelled swollen
swing swung
take took taken
tear tore torn
wind wound
withstand withstood
"""
_UNSAID = {"left", "ground"}  # also the left one, and the ground
_GERMAN = """
beginnen beginnt begann begonnen
bleiben bleibt blieb geblieben
dringen dringt drang gedrungen
ertragen erträgt ertrug ertragen
fahren fährt fuhr gefahren
fallen fällt fiel gefallen
fangen fängt fing gefangen
fliegen fliegt flog geflogen
geben gibt gab gegeben
gehen geht ging gegangen
gleichen gleicht glich geglichen
gleiten gleitet glitt geglitten
greifen greift griff gegriffen
halten hält hielt gehalten
hängen hängt hing gehangen
heben hebt hob gehoben
kommen kommt kam gekommen
kriechen kriecht kroch gekrochen
laufen läuft lief gelaufen
nehmen nimmt nahm genommen
reissen reisst riss gerissen
rufen ruft rief gerufen
schieben schiebt schob geschoben
schiessen schiesst schoss geschossen
schlagen schlägt schlug geschlagen
schleifen schleift schliff geschliffen
schwingen schwingt schwang geschwungen
sinken sinkt sank gesunken
springen springt sprang gesprungen
stehen steht stand gestanden
steigen steigt stieg gestiegen
stossen stösst stiess gestossen
treffen trifft traf getroffen
treiben treibt trieb getrieben
überwinden überwindet überwand überwunden
übertragen überträgt übertrug übertragen
verlassen verlässt verliess verlassen
verlieren verliert verlor verloren
verschieben verschiebt verschob verschoben
verschwinden verschwindet verschwand verschwunden
weichen weicht wich gewichen
werfen wirft warf geworfen
widerstehen widersteht widerstand widerstanden
ziehen zieht zog gezogen
"""


def _read(table: str) -> dict[str, tuple[str, ...]]:
    lines = (line.split() for line in table.split("\n") if line)
    return {verb: tuple(forms) for verb, *forms in lines}


ENGLISH = {verb: tuple(x for x in forms if x not in _UNSAID) for verb, forms in _read(_ENGLISH).items()}
GERMAN = _read(_GERMAN)
