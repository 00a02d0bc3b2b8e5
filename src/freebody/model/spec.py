"""The base of everything a user writes: an immutable description with named fields.

A description can be given by position or by name, in Python (`Pin("ground.axle", "pulley")`) and in a file
(`pin: [ground.axle, pulley]`, `gravity: g`, `pin: {first: ground.axle, second: pulley}`).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from difflib import get_close_matches
from inspect import Parameter, Signature
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, cast, get_origin

from pydantic import BaseModel, ConfigDict, Strict, ValidationError

from freebody.language.written import as_text
from freebody.model.friction import with_both_coefficients

if TYPE_CHECKING:
    from pydantic_core import ErrorDetails

# What stands for a number: an expression in the parameters, a quantity with unit, or a plain SI number.
# True is none: `gravity: true` would be a gravity of 1.
Formula = str | Annotated[int, Strict()] | Annotated[float, Strict()]
# What stands for a direction: right, left, up, down, an angle, components, or a line or axis of a body.
Heading = Formula | list[Formula] | tuple[Formula, Formula]

FieldType = Literal["direction", "formula", "text", "flag", "other"]
_TYPES: tuple[tuple[Any, FieldType], ...] = (
    (Heading, "direction"),
    (Formula, "formula"),
    (str, "text"),
    (bool, "flag"),
)


PAIRS = (
    "between",
    "around",
    "bodies",
    "pulleys",
    "zwischen",
)  # words for a list, of as many as there are fields for it
FRICTION = ("friction_coefficient", "coefficient_of_friction", "coeff_of_friction", "friction_factor")
RESTITUTION = ("coefficient_of_restitution", "restitution_coefficient", "e_restitution")
# What people write for a field, whatever has it.
MEANT: Mapping[str, tuple[str, ...]] = {
    "from": ("first", "start", "reacts_on"),
    "to": ("second",),
    "first": ("body",),
    "second": ("on",),
    **dict.fromkeys(PAIRS, ("between", "first", "second", "body", "on", "reacts_on")),
    "direction": ("along",),
    "axis": ("along", "about"),
    "along": ("about",),
    "angle": ("along",),
    "magnitude": ("intensity",),
    "rest_length": ("length",),
    **dict.fromkeys(("natural_length", "free_length", "unstretched_length"), ("length",)),
    **dict.fromkeys(("center", "com", "centre_of_mass"), ("center_of_mass",)),
    **dict.fromkeys(("initial_position", "start"), ("at",)),
    **dict.fromkeys(("k", "constant", "spring_constant"), ("stiffness",)),
    **dict.fromkeys(("c", "coefficient"), ("damping",)),
    **dict.fromkeys(("value", "F"), ("magnitude", "strength", "intensity")),
    "force": ("magnitude",),
    "torque": ("magnitude",),
    "g": ("strength",),
    "body": ("on", "at", "pinion"),
    **dict.fromkeys(("point", "node"), ("pin", "at")),
    "on": ("at", "body"),
    "at": ("pin", "on"),
    "position": ("at",),
    "place": ("at",),
    "location": ("at",),
    "speed": ("velocity", "angular_velocity"),
    **dict.fromkeys(("initial_velocity", "v0", "v", "Anfangsgeschwindigkeit"), ("velocity",)),
    **dict.fromkeys(("omega", "initial_angular_velocity", "spin"), ("angular_velocity", "speed")),
    **dict.fromkeys(("initial_angle", "initial_orientation"), ("angle",)),
    "weight": ("mass",),
    "orientation": ("angle",),
    "rotation": ("angle",),
    **dict.fromkeys(("mu", *FRICTION), ("friction",)),
    **dict.fromkeys(("e", *RESTITUTION), ("restitution",)),
    **dict.fromkeys(("moment_of_inertia", "mass_moment_of_inertia"), ("inertia",)),
    **dict.fromkeys(("damping_coefficient", "damping_constant"), ("damping",)),
    **dict.fromkeys(("spring_stiffness", "spring_rate"), ("stiffness",)),
    **dict.fromkeys(("number_of_teeth", "n_teeth"), ("teeth",)),
    **dict.fromkeys(("initial_speed", "start_velocity"), ("velocity",)),
    **dict.fromkeys(("r", "R"), ("radius",)),
    **dict.fromkeys(("m", "M"), ("mass", "magnitude")),
    **dict.fromkeys(("l", "L"), ("length",)),
    **dict.fromkeys(("J", "I"), ("inertia",)),
    **dict.fromkeys(("angular_velocity", "angular_speed"), ("speed",)),
    "law": ("follows",),
    "in": ("inside",),
    "q": ("intensity",),
    "diameter": ("radius",),
    **{
        word: fields
        for words, fields in (
            (("von",), ("from", "first", "start")),
            (("nach",), ("to", "second")),
            (("Masse",), ("mass",)),
            (("Länge",), ("length",)),
            (("Ruhelänge", "ungespannte Länge"), ("rest_length", "length")),
            (("Radius", "Durchmesser"), ("radius",)),
            (("Breite",), ("width",)),
            (("Höhe",), ("height",)),
            (("Trägheitsmoment", "Massenträgheitsmoment"), ("inertia",)),
            (("Zähne", "Zähnezahl"), ("teeth",)),
            (("Modul",), ("module",)),
            (("innen", "Innenverzahnung"), ("internal",)),
            (("Schwerpunkt",), ("center_of_mass",)),
            (("fest",), ("fixed",)),
            (("Winkel",), ("angle", "along")),
            (("Lage", "Ort", "Position"), ("at",)),
            (("Geschwindigkeit",), ("velocity",)),
            (("Winkelgeschwindigkeit", "Drehzahl"), ("angular_velocity", "speed")),
            (("Federkonstante", "Federsteifigkeit", "Steifigkeit"), ("stiffness",)),
            (("Dämpfung", "Dämpfungskonstante"), ("damping",)),
            (("Reibung", "Reibungszahl", "Reibungskoeffizient", "Reibbeiwert"), ("friction",)),
            (("Stoßzahl",), ("restitution",)),
            (("Richtung",), ("along",)),
            (("Betrag", "Größe", "Wert"), ("magnitude", "strength", "intensity")),
            (("Körper", "Bauteil"), ("body", "on", "at", "pinion")),
            (("an",), ("at", "on")),
            (("Punkt",), ("pin", "at")),
            (("zwischen",), ("between", "first", "second", "body", "on", "reacts_on")),
        )
        for word in words
    },
}
# Of these the words that can mean nothing else where there is such a field: they are read as it.
SAME: frozenset[str] = frozenset((
    *FRICTION, *RESTITUTION, "moment_of_inertia", "mass_moment_of_inertia", "damping_coefficient", "spring_stiffness",
    "number_of_teeth", "n_teeth", "initial_speed", "start_velocity", "initial_orientation",
    "from", "to", "first", "second", "on", "at", "direction", "angle", "axis", "along", "value", "magnitude", "omega",
    "mu", "e", "g", "center", "com", "k", "spring_constant", "spring_rate", "c", "damping_constant",
    "rest_length", "natural_length", "free_length", "unstretched_length",
    "position", "initial_position", "initial_angle", "initial_velocity", "initial_angular_velocity",
    "r", "R", "m", "M", "l", "L", "F", "J", "I", "diameter", "angular_velocity", "angular_speed", "in", "q", "bodies",
    "law",
    "point", "node", "von", "nach", "Masse", "Länge", "Ruhelänge", "ungespannte Länge", "Radius", "Durchmesser",
    "Breite", "Höhe", "Trägheitsmoment", "Massenträgheitsmoment", "Zähne", "Zähnezahl", "Modul", "innen",
    "Innenverzahnung", "Schwerpunkt", "fest", "Winkel", "Lage", "Ort", "Position", "Geschwindigkeit",
    "Winkelgeschwindigkeit", "Drehzahl", "Federkonstante", "Federsteifigkeit", "Steifigkeit", "Dämpfung",
    "Dämpfungskonstante", "Reibung", "Reibungszahl", "Stoßzahl", "Reibungskoeffizient", "Reibbeiwert", "Richtung",
    "Betrag", "Größe", "Wert", "an", "Körper", "Bauteil", "Punkt", "zwischen",
))  # fmt: skip
# Fields for the ends of what leads from one thing to another: coordinates there are those of a point of the ground.
ENDS = ("first", "second", "between", "through", "center", "start", "to", "path")
# Of these the words for another size, with the formula that makes the field of it.
SIZES: Mapping[str, str] = dict.fromkeys(("diameter", "Durchmesser"), "({})/2")
_ModelClass: Any = type(BaseModel)


class WrongFields(TypeError):
    """Fields of a description are wrong. It says so as Python does; found is what readers of files tell of."""

    def __init__(self, kind: Any, found: ValidationError) -> None:
        super().__init__("; ".join(dict.fromkeys(_told_in_python(kind, fault) for fault in found.errors())))
        self.found = found


class _Described(_ModelClass):
    """The class of descriptions, which knows their signature: the fields, which may be given by position."""

    @property
    def __signature__(self) -> Signature:
        """What `help` and notebooks show."""
        parameters: list[Parameter] = []
        has_default = False
        for name, info in self.model_fields.items():
            # Python knows no argument that is needed behind one that is not: it is shown as one that is given by name
            by_name = has_default and (info.is_required() or parameters[-1].kind is Parameter.KEYWORD_ONLY)
            kind = Parameter.KEYWORD_ONLY if by_name else Parameter.POSITIONAL_OR_KEYWORD
            default = Parameter.empty if info.is_required() else info.get_default(call_default_factory=True)
            parameters.append(Parameter(name, kind, default=default, annotation=info.annotation))
            has_default = has_default or not info.is_required()
        return Signature(parameters)

    def __call__(self, *args: Any, **named: Any) -> Any:
        """A description. Raises WrongFields where a field is not there, is left out or holds something else."""
        try:
            return super().__call__(*args, **named)
        except ValidationError as error:
            raise WrongFields(self, error) from None

    @__signature__.setter
    def __signature__(self, found: object) -> None:
        """That of the library, which knows no positions, is not kept."""


class Spec(BaseModel, metaclass=_Described):
    """One described thing."""

    model_config = ConfigDict(frozen=True, extra="forbid", strict=False, defer_build=True)

    kind: ClassVar[str] = ""
    # what people call such a thing beside its kind: questions know it by these words
    called: ClassVar[tuple[str, ...]] = ()
    # of these and others the words that a file may say for the kind
    also: ClassVar[tuple[str, ...]] = ()
    # whether its force or torque is one that somebody chooses, as a motor's; a spring's follows from the motion
    # (False), and a shape has none (None)
    is_chosen: ClassVar[bool | None] = None
    # fields that people give it and that are another kind's: what to write there
    elsewhere: ClassVar[Mapping[str, str]] = {}
    # fields that such a word means by itself: a ring gear has its teeth inside
    meant_by_word: ClassVar[Mapping[str, Mapping[str, Any]]] = {}
    # what a word for the kind says of its fields where a file does not
    said_by_word: ClassVar[Mapping[str, Mapping[str, str]]] = {}
    # what people have a word for and what is written as this kind: how
    instead: ClassVar[Mapping[str, str]] = {}
    # where in Python what belongs beside such a thing stands
    beside: ClassVar[str] = ""
    # words of the kind's own under which a file may name what its fields say, by these fields; `from_plain` reads them
    more_words: ClassVar[Mapping[str, tuple[str, ...]]] = {}

    def __init__(self, *args: Any, **named: Any) -> None:
        cls: type = type(self)
        called, fields = cls.__name__, list(type(self).model_fields)
        if len(args) > len(fields):
            raise TypeError(f"{called} takes {', '.join(fields)}")
        if twice := set(fields[: len(args)]) & set(named):
            raise TypeError(f"{called} is given {', '.join(sorted(twice))} twice")
        given = {key: as_text(value) for key, value in (dict(zip(fields, args, strict=False)) | named).items()}
        meant = [pair for key, value in given.items() for pair in self._meant(key, value, given)]
        super().__init__(**{name: self._as_list(name, value) for name, value in meant})

    @classmethod
    def from_plain(cls, value: object) -> dict[str, Any]:
        """A file's value as named fields: a mapping is taken as it is, with a list under one word for several fields
        (`between: [a, b]`) as these; a list by position, anything else as the first field."""
        fields = list(cls.model_fields)
        if isinstance(value, dict):
            entries = cast("dict[str, Any]", value)
            read = {k: cls._as_list(k, v) for key, each in entries.items() for k, v in cls._meant(key, each, entries)}
            return with_both_coefficients(read) if "friction" in cls.model_fields else read
        if value is None:
            return {}
        if isinstance(value, list):
            items = cast("list[Any]", value)
            spread = next((f for f in fields if f in cls.spread), None)
            if spread is not None:
                return {spread: items}
            named = zip(fields, items, strict=False)
            return {field: cls._as_list(field, each) for field, each in named} | (
                {f"item {len(fields) + 1}": items[len(fields)]} if len(items) > len(fields) else {}
            )
        return {fields[0]: value}

    @classmethod
    def in_words(cls, text: str) -> dict[str, Any] | None:
        """The fields that a text says in place of the kind and its fields; None where it is no such text."""
        del text
        return None

    @classmethod
    def _meant(cls, key: str, value: Any, beside: Mapping[str, Any]) -> list[tuple[str, Any]]:
        """A field with its value, also under a word that means the same, or those that a list under one word gives.
        beside: all that is given."""
        known = {field.alias or name for name, field in cls.model_fields.items()}
        fields = () if key in known else cls.meant(key)
        items = cast("list[Any]", value) if isinstance(value, list) else []
        if len(fields) == len(items) > 1 and key not in cls.elsewhere:
            return list(zip(fields, items, strict=True))
        others = {field for other in beside if other != key for field in ({other} & known or cls.meant(other))}
        is_same = key in SAME and key not in cls.elsewhere and not {*fields} & others
        if len(fields) != 1 or not is_same:
            return [(key, value)]
        is_formula = isinstance(value, str | int | float)
        return [(fields[0], SIZES[key].format(value) if key in SIZES and is_formula else value)]

    @classmethod
    def _as_list(cls, key: str, value: Any) -> Any:
        """One name where a list of them is wanted is a list of one."""
        wanted = cls.model_fields.get(key)
        is_one = isinstance(value, str) and wanted is not None and get_origin(wanted.annotation) is list
        return [value] if is_one else value

    @classmethod
    def field_types(cls) -> dict[str, FieldType]:
        """What may stand in each field, or nothing: a direction, a formula, a text, true or false."""
        return {name: _type_of(info.annotation) for name, info in cls.model_fields.items()}

    @classmethod
    def meant(cls, key: str) -> tuple[str, ...]:
        """The fields that people mean by a word: two of a pair, such as `between`, else the first that there is."""
        known = [field.alias or name for name, field in cls.model_fields.items()]
        found = tuple(field for field in MEANT.get(key, ()) if field in known)
        return found[: 2 if key in PAIRS else 1]

    @classmethod
    def second_words(cls) -> dict[str, tuple[str, ...]]:
        """By each further word under which a file may give fields: which."""
        known = {field.alias or name for name, field in cls.model_fields.items()}
        found = {word: cls.meant(word) for word in MEANT if word not in known and word not in cls.elsewhere}
        return {word: fields for word, fields in found.items() if len(fields) > 1 or (fields and word in SAME)}

    @classmethod
    def words(cls) -> tuple[str, ...]:
        """What such a thing is called."""
        return (cls.kind.replace("_", " "), *cls.called)

    def called_by_fields(self) -> Iterator[tuple[str, str]]:
        """Names that alone are what a field says, and the words of the field: omega_0, no load speed."""
        for field, value in self:
            if isinstance(value, str) and value.isidentifier():
                yield value, field.replace("_", " ")

    # in space it joins only bodies that a planar joint keeps in the plane of x and y
    in_plane: ClassVar[bool] = False
    # what there is in space alone, and the kind of the plane that does the same
    space_only: ClassVar[bool] = False
    in_plane_take: ClassVar[str] = ""
    # a short example in YAML, in which it is called `it`
    example: ClassVar[str] = ""

    # names of a field that takes a whole list when the value is a list
    spread: ClassVar[tuple[str, ...]] = ()

    def to_plain(self) -> dict[str, Any]:
        """The fields that differ from their defaults, as plain data."""
        return self.model_dump(exclude_defaults=True)


def _told_in_python(kind: Any, fault: ErrorDetails) -> str:
    """What is wrong with a field of a description made in Python."""
    field = ".".join(map(str, fault["loc"]))
    takes = ", ".join(kind.model_fields)
    if fault["type"] == "missing":
        return f"{kind.__name__} needs {field}; it takes {takes}"
    if fault["type"] == "list_type":
        return f"{kind.__name__}: {field} takes a list, {field}=[...]"
    if fault["type"] != "extra_forbidden":
        return f"{kind.__name__}: {field}: {fault['msg']}"
    if (instead := kind.elsewhere.get(field)) is not None:
        return f"{kind.__name__} has no {field}: {instead}"
    near = kind.meant(field) or get_close_matches(field, kind.model_fields, n=1, cutoff=0.6)
    hint = f" Did you mean {near[0]}?" if near else kind.beside.format(kind=kind.__name__, field=field)
    return f"{kind.__name__} has no {field}.{hint} It takes {takes}"


def _type_of(annotation: Any) -> FieldType:
    for known, of in _TYPES:
        if annotation in (known, known | None):
            return of
    return "other"
