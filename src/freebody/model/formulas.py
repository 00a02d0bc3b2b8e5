"""What a model gives as formulas and quantities: expressions in its parameters, with the dimension that is wanted."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from contextlib import suppress
from itertools import pairwise
from typing import Any, cast

from freebody.errors import ExpressionError, InputError, NoQuantity, UnitError
from freebody.language.expression import (
    FUNCTIONS,
    Call,
    Expr,
    Number,
    PowerOf,
    ProductOf,
    Sum,
    Symbol,
    evaluate,
    free_symbols,
    number,
    substitute,
)
from freebody.language.notation import to_python
from freebody.language.parser import parse
from freebody.language.sentences import Message, as_found, in_turn, listed
from freebody.language.units import (
    ACCELERATION,
    ANGULAR_VELOCITY,
    DIMENSIONLESS,
    FORCE,
    INERTIA,
    LARGEST,
    LENGTH,
    MASS,
    STIFFNESS,
    TIME,
    TORQUE,
    VELOCITY,
    Dimension,
    dimension_of,
    is_unit,
    parse_quantity,
    quantities_within,
)
from freebody.measures.geometry import ZERO, Components
from freebody.model.elements import Parameter
from freebody.model.noting import Noting, did_you_mean, reads
from freebody.model.spec import Spec

PI = Symbol("pi")
_NAME = re.compile(r"(?<!\w)[^\W\d]\w*")
_OPERATORS = ("+", "-", "*", "/", "^")
_AFTER_A_VALUE = ("=", "<", ">", *_OPERATORS)
_BEFORE_A_VALUE = (*_AFTER_A_VALUE, "(", " reaches", " by")
_QUANTITY = re.compile(r"\s*[+-]?[\d.]+([eE][+-]?\d+)?(\s*[A-Za-zµμ°%]|\s+1\s*/\s*[A-Za-z])")
_WITH_UNIT = re.compile(r"(?<![\w.])[\d.]+([eE][+-]?\d+)?\s+(?P<unit>[A-Za-zµμ°%]+)")


class Formulas(Noting):
    """Reads formulas in the parameters of a model."""

    def __init__(self) -> None:
        super().__init__()
        self.parameters: dict[str, Parameter] = {}
        self.hangs_on: set[str] = (
            set()
        )  # parameters whose numbers were asked for: with others a model may read otherwise
        self.used = set[str]()  # names that formulas of the model have
        self.units_of_use: dict[str, Dimension] = {}  # of parameters that have neither number nor unit, by their use
        self.shorthands: dict[str, Expr] = {}  # parameters that are formulas of others, by these
        self.space = False
        self.taken: Mapping[str, object] = {}  # what names stand for that are no parameters: bodies

    @property
    def origin(self) -> Components:
        """The components of zero."""
        return (ZERO, ZERO, ZERO) if self.space else (ZERO, ZERO)

    def dimensions(self, *, in_time: bool = False) -> dict[str, Dimension]:
        """Of the parameters; functions of time are among them where time may be."""
        return {p.name: p.dimension for p in self.parameters.values() if p.form is None or in_time}

    def no_parameter(self, name: str) -> Message:
        """That a name that should be one is no parameter, and what is one."""
        if name in self.shorthands:
            used = in_turn(sorted(free_symbols(self.shorthands[name]) & self.parameters.keys()))
            return Message(
                "{name} is short for a formula of {others}: ask for what stands in it", name=name, others=used
            )
        hint = did_you_mean(name, self.parameters)
        return Message("there is no parameter {name}.{hint}", name=name, hint=hint)

    def spelt_out(self, text: str) -> str:
        """A text in which shorthands stand as the formulas that they are short for, where they stand for a value."""

        def formula(found: re.Match[str]) -> str:
            name = found.group()
            beside = text[: found.start()].rstrip(), text[found.end() :].lstrip()
            is_value = beside[0].endswith(_BEFORE_A_VALUE) or beside[1].startswith(_AFTER_A_VALUE)
            if name not in self.shorthands or not is_value:
                return name
            is_side = not beside[0].endswith(_OPERATORS) and not beside[1].startswith(_OPERATORS)
            formula = to_python(self.shorthands[name])
            return formula if is_side else f"({formula})"

        return _NAME.sub(formula, text) if self.shorthands else text

    def parsed(self, text: str) -> Expr:
        """A formula in the parameters themselves. Raises ExpressionError."""
        return self.in_parameters(parse(text))

    def in_parameters(self, expr: Expr) -> Expr:
        """With what each shorthand stands for."""
        return substitute(expr, self.shorthands) if free_symbols(expr) & self.shorthands.keys() else expr

    @reads
    def angle(self, value: Any, *path: str | int) -> Expr:
        """A formula for an angle; a number of more than a full turn needs a unit, since degrees are nearly always
        meant: alone, or as a parameter in a sum of angles."""
        expr = self.formula(value, DIMENSIONLESS, *path)
        bare = _as_number(value)
        if bare is not None and abs(bare) > math.tau:
            told = Message("the angle {value} has no unit: write {value} deg, or {value} rad", value=f"{bare:g}")
            self.problem(told, *path)
        for term in expr.terms if isinstance(expr, Sum) else (expr,):
            plain = term.factors[1] if isinstance(term, ProductOf) and term.factors[0] == number(-1) else term
            parameter = self.parameters.get(plain.name) if isinstance(plain, Symbol) else None
            if parameter is None or parameter.is_angle:
                continue
            given = self.number_of(parameter.name)
            if given is not None and abs(given) > math.tau:
                told = Message(
                    "{name} is used as an angle, and its value {value} has no unit: write {value} deg, or {value} rad",
                    name=parameter.name,
                    value=f"{given:g}",
                )
                self.problem(told, *path)
        return expr

    @reads
    def formula(
        self,
        value: Any,
        dimension: Dimension,
        *path: str | int,
        extra: Mapping[str, Dimension] | None = None,
    ) -> Expr:
        """An expression in the parameters (and `extra` names), or a quantity with its unit."""
        if isinstance(value, Expr):  # what the reading itself has found
            return value
        known = self.dimensions(in_time="t" in (extra or {})) | dict(extra or {})
        if isinstance(value, str) and (mixed := self._with_quantities(value, dimension, known)) is not None:
            self.used |= free_symbols(mixed)
            return mixed
        if isinstance(value, bool) or not isinstance(value, (str, int, float)):
            self.problem(Message("expected a number or an expression, found {value}", value=as_found(value)), *path)
            return ZERO
        if isinstance(value, (int, float)):
            if not math.isfinite(value):
                self.problem(Message("{value} is not a finite number", value=value), *path)
                return ZERO
            if abs(value) > LARGEST:
                self.problem(
                    Message(
                        "{value} is too large to calculate with: sizes go up to {most:.0e}", value=value, most=LARGEST
                    ),
                    *path,
                )
                return ZERO
            return number(value)
        try:
            expr = self._beside(extra or {}, parse(value))
        except ExpressionError as error:
            return ZERO if self.is_broken_in(value) else self._quantity(value, dimension, path, str(error))
        self.used |= free_symbols(expr)
        unknown = sorted(free_symbols(expr) - set(known))
        if free_symbols(expr) & self.broken or (unknown and self.is_cut_short):
            return ZERO
        if unknown and unknown[0] in self.parameters:
            message = Message(
                "{name} is a function of time; it may stand in drivers and in the laws of loads only", name=unknown[0]
            )
            return self._quantity(value, dimension, path, message)
        if unknown and unknown[0] in self.taken:
            message = Message("{name} is a body; here stands a number, or a formula in parameters", name=unknown[0])
            return self._quantity(value, dimension, path, message)
        if unknown:
            of, ending = unknown[0].removesuffix("_dot"), unknown[0].endswith("_dot")
            if ending and of in known and of not in self.parameters:
                message = Message("the rate of {name} is written rate({name})", name=of)
                return self._quantity(value, dimension, path, message)
            message = _not_a_parameter(unknown[0], value, dimension, did_you_mean(unknown[0], known))
            self.undeclared.setdefault(unknown[0], message)
            return self._quantity(value, dimension, path, message)
        try:
            found = dimension_of(expr, known)
        except UnitError as error:
            told = self._without_units(value, expr, dimension, known)
            told = told or Message("in '{text}': {error}", text=value, error=error)
            return self._quantity(value, dimension, path, told)
        if found != dimension and expr != ZERO:
            if self.is_broken_in(value):
                return ZERO
            self._note_unit_of_use(expr, found, dimension, known)
            told = unit_differs(value, found, dimension)
            own = self.parameters.get(value)
            if (
                own is not None and own.value is not None and found == DIMENSIONLESS
            ):  # told once, with where it is given
                told = Message(
                    "{told}: write {name}: {value:g} {unit} under parameters",
                    told=told,
                    name=value,
                    value=own.value,
                    unit=dimension,
                )
                self.broken.add(value)
            elif own is not None and found == DIMENSIONLESS:
                told = Message(
                    "{told}: write {name}: {unit} under parameters, or a number with that unit",
                    told=told,
                    name=value,
                    unit=dimension,
                )
                self.broken.add(value)
            elif (without := self._without_units(value, expr, dimension, known)) is not None:
                told = without
            return self._quantity(value, dimension, path, told)
        return expr

    def _without_units(
        self, text: str, expr: Expr, wanted: Dimension, known: Mapping[str, Dimension]
    ) -> Message | None:
        """What to write where parameters that have numbers without units, such as the gains of a controller, are all
        that keeps the terms of a formula from fitting."""
        found: dict[str, Dimension] = {}
        for term in expr.terms if isinstance(expr, Sum) else (expr,):
            if (lacking := self._lacking(term, wanted, known)) is None:
                return None
            found |= lacking
        if any(self.parameters[name].value is None for name in found):
            for name, unit in found.items():
                self.units_of_use.setdefault(name, unit)
            return None
        self.broken |= found.keys()
        entries = ", ".join(f"{name}: {self.number_of(name):g} {unit}" for name, unit in found.items())
        names = listed([*found], "{first} and {second}")
        told = Message(
            "in '{text}' {names} must have units: write {entries} under parameters",
            names=names,
            text=text,
            entries=entries,
        )
        return told if found else None

    def _lacking(self, term: Expr, wanted: Dimension, known: Mapping[str, Dimension]) -> dict[str, Dimension] | None:
        """The unit with which the one parameter without a unit makes a term fit; none where it fits; None where that
        is not all."""
        with suppress(UnitError):
            own = dimension_of(term, known)
            if own == wanted:
                return {}
            names = [name for name in free_symbols(term) if name in self.parameters and self._is_plain(name)]
            unit = wanted / own
            if len(names) == 1 and dimension_of(term, {**known, names[0]: unit}) == wanted:
                return {names[0]: unit}
        return None

    def _is_plain(self, name: str) -> bool:
        """Whether a parameter has a number without a unit, or neither."""
        p = self.parameters[name]
        return p.dimension == DIMENSIONLESS and not p.unit and not p.is_angle and p.form is None

    def _beside(self, extra: Mapping[str, Dimension], expr: Expr) -> Expr:
        """In the parameters, where other names mean what they mean there."""
        own = {name: short for name, short in self.shorthands.items() if name not in extra}
        return substitute(expr, own) if free_symbols(expr) & own.keys() else expr

    def _with_quantities(self, text: str, dimension: Dimension, known: Mapping[str, Dimension]) -> Expr | None:
        """An expression in which numbers have units, where it reads as no other: 180 deg - alpha."""
        named, quantities = quantities_within(text, known)
        if not quantities:
            return None
        dimensions = {**known, **{name: q.dimension for name, q in quantities.items()}}

        def fits(written: str) -> Expr | None:
            with suppress(ExpressionError, UnitError):
                expr = self.in_parameters(parse(written))
                if free_symbols(expr) <= dimensions.keys() and dimension_of(expr, dimensions) == dimension:
                    return expr
            return None

        found = None if fits(text) is not None else fits(named)
        values = {name: quantity_expression(q) for name, q in quantities.items()}
        return None if found is None else substitute(found, values)

    def _note_unit_of_use(
        self, expr: Expr, found: Dimension, wanted: Dimension, known: Mapping[str, Dimension]
    ) -> None:
        """The unit with which the one parameter in a formula that has neither number nor unit makes it fit."""
        names = [name for name in free_symbols(expr) if name in self.parameters and self.parameters[name].is_bare]
        if len(names) != 1:
            return
        unit = wanted / found
        with suppress(UnitError):
            if dimension_of(expr, {**known, names[0]: unit}) == wanted:
                self.units_of_use.setdefault(names[0], unit)

    def _quantity(self, text: str, dimension: Dimension, path: tuple[str | int, ...], why_not: str) -> Expr:
        quantity = None
        if _QUANTITY.match(text):
            try:
                quantity = parse_quantity(text)
            except NoQuantity:  # then it is meant as an expression
                pass
            except UnitError as error:
                why_not = str(error)
        if quantity is None:
            self.problem(self._mixed(text) or why_not, *path)
            return ZERO
        if quantity.dimension != dimension:
            self.problem(unit_differs(text, quantity.dimension, dimension), *path)
            return ZERO
        return quantity_expression(quantity)

    def _mixed(self, text: str) -> Message | None:
        """What to say of an expression in which a value with its unit stands beside other things."""
        names = {*self.parameters, *FUNCTIONS}
        if not names.intersection(re.findall(r"\w+", text)) and not re.search(r"\S\s*\+|\s-\s", text):
            return None
        for found in _WITH_UNIT.finditer(text):
            if found["unit"] not in self.parameters and is_unit(found["unit"]):
                return Message(
                    "'{value}' in '{text}': a value with its unit does not fit here. Give it a name with its unit "
                    "under parameters, and write that name here",
                    value=found.group(),
                    text=text,
                )
        return None

    @reads
    def positive(self, spec: Spec, field: str, dimension: Dimension) -> Expr:
        """A formula that must not be negative."""
        expr = self.formula(getattr(spec, field), dimension, field)
        value = self.below_zero(expr)
        if value is not None:
            self.problem(
                Message(
                    "{field} is negative ({value:g} {dimension}); give a positive one",
                    field=field,
                    value=value,
                    dimension=dimension,
                ),
                field,
            )
        return expr

    @reads
    def above_zero(self, spec: Spec, field: str, dimension: Dimension) -> Expr:
        """A formula that must be positive; 1 where it is not, so that one can divide by it."""
        expr = self.positive(spec, field, dimension)
        value = self.numeric(expr)
        if value == 0.0 and not self.is_told(field):
            self.problem(Message("{field} is 0; give a positive one", field=field), field)
        return number(1) if value is not None and value <= 0.0 else expr

    def optional(self, spec: Spec, field: str, dimension: Dimension) -> Expr | None:
        return None if getattr(spec, field) is None else self.positive(spec, field, dimension)

    def numbers_in(self, *expressions: Expr) -> dict[str, float]:
        """The numbers that parameters in expressions have, in SI. What is read hangs on them from now on."""
        names = {name for expr in expressions for name in free_symbols(expr)} & self.parameters.keys()
        given = ((name, self.number_of(name)) for name in names)
        return {name: value for name, value in given if value is not None}

    def number_of(self, name: str) -> float | None:
        """The number of a parameter in SI, None where it has none. What is read hangs on it from now on."""
        self.hangs_on.add(name)
        return self.parameters[name].value

    def numeric(self, expr: Expr) -> float | None:
        """Its value, where all parameters in it have values."""
        try:
            result = evaluate(expr, self.numbers_in(expr))
        except (InputError, ZeroDivisionError, OverflowError, ValueError):
            return None
        return float(result)

    def below_zero(self, expr: Expr) -> float | None:
        """Its value where that is negative, which needs no number where the signs of the parameters tell."""
        if self.is_never_negative(expr):
            return None
        value = self.numeric(expr)
        return value if value is not None and value < 0.0 else None

    def is_never_negative(self, expr: Expr) -> bool:
        """Whether the signs of the parameters alone say so: sums, products and powers of what is not negative."""
        match expr:
            case Number(value):
                return value >= 0
            case Symbol(name):
                known = self.parameters.get(name)
                return known is not None and known.sign != "any" and known.value is not None and known.value >= 0.0
            case Sum(parts) | ProductOf(parts):
                return all(map(self.is_never_negative, parts))
            case PowerOf(base):
                return self.is_never_negative(base)
            case Call("sqrt" | "abs"):
                return True
            case _:
                return False

    def vector(self, spec: Spec, field: str, dimension: Dimension) -> Components | None:
        value = getattr(spec, field)
        return None if value is None else self.components(value, dimension, field)

    @reads
    def components(self, value: Any, dimension: Dimension, *path: str | int) -> Components:
        """[x, y], or [x, y, z] in space, where z may be left out."""
        items = cast("list[Any]", value) if isinstance(value, (list, tuple)) else []
        if self.space and len(items) == 2:
            items = [*items, 0]
        if len(items) != len(self.origin):
            wanted = Message("three components [x, y, z]" if self.space else "two components [x, y]")
            if told := _decimal_comma(items):
                self.problem(told, *path)
                return self.origin
            hint = Message(". For a model in space write space: true") if len(items) == 3 else ""
            if (example := _by_components(value)) and not self.space:
                hint = Message(", e.g. {example}", example=example)
            if not items and isinstance(value, (str, int, float)):
                example = f"[{', '.join(str(each) for each in (value, *[0] * (len(self.origin) - 1)))}]"
                hint = Message(", e.g. {example}", example=example)
                if isinstance(value, str) and "." in value and value.replace(".", "_").isidentifier():
                    hint = Message(
                        ": where {point} is follows from what joins both, a weld or a pin, and from that alone",
                        point=value,
                    )
            self.problem(
                Message(
                    "expected {wanted}, found {value}{hint}",
                    wanted=wanted,
                    value=as_found(cast("object", value)),
                    hint=hint,
                ),
                *path,
            )
            return self.origin
        return tuple(self.formula(item, dimension, *path, k) for k, item in enumerate(items))

    @reads
    def sides(self, value: Any, dimension: Dimension, field: str) -> Components:
        """Components of which none may be negative: the sides of a box."""
        found = self.components(value, dimension, field)
        for k, side in enumerate(found):
            if (size := self.below_zero(side)) is not None:
                self.problem(
                    Message(
                        "{field} is negative ({value:g} {dimension}); give a positive one",
                        field=field,
                        value=size,
                        dimension=dimension,
                    ),
                    field,
                    k,
                )
        return found

    def vectors(self, spec: Spec, field: str, dimension: Dimension) -> list[Components]:
        return [self.components(v, dimension, field, k) for k, v in enumerate(getattr(spec, field))]

    def length_or(self, spec: Spec, field: str, fallback: Expr | None = None) -> Expr | None:
        value = getattr(spec, field)
        return fallback if value is None else self.positive(spec, field, LENGTH)


def _decimal_comma(items: list[Any]) -> Message | None:
    """Of `[1,5 m, 2 m]`: a bare whole number before digits with a unit is what a comma has left of a decimal."""
    for n, rest in pairwise(items):
        if type(n) is int and isinstance(rest, str) and re.match(r"\d+(e[-+]?\d+)?\s*[^\W\d]", rest):
            return Message("a comma separates entries; write a point: {n}.{rest}", n=n, rest=rest)
    return None


def _by_components(value: Any) -> str:
    """`{magnitude: v, angle: alpha}` by its components in the plane; nothing where it is no such thing."""
    given = cast("dict[str, Any]", value) if isinstance(value, dict) else {}
    turned = next((key for key in ("angle", "direction", "along") if key in given), "")
    if len(given) != 2 or not turned:
        return ""
    size = next(each for key, each in given.items() if key != turned)
    return f"[{size}*cos({given[turned]}), {size}*sin({given[turned]})]"


def quantity_expression(quantity: Any) -> Expr:
    """A quantity in SI as an exact expression; degrees and revolutions as fractions of pi."""
    if quantity.of_pi is not None:
        return PI * quantity.of_pi
    if quantity.exact is not None:
        return number(quantity.exact)
    return number(quantity.value)


def _not_a_parameter(name: str, value: str, dimension: Dimension, hint: str) -> Message:
    if name == value.strip() and dimension != DIMENSIONLESS:
        return Message(
            "{name} is not a parameter.{hint} Add it under parameters, e.g. {name}: {number} {unit}, or without a "
            "number {name}: {unit}",
            name=name,
            hint=hint,
            number="9.81" if dimension == ACCELERATION else "1",
            unit=dimension,
        )
    return no_parameter_in(name, value, hint)


def no_parameter_in(name: str, formula: str, hint: str) -> Message:
    """That a name in a formula is none of a parameter."""
    return Message(
        "{name} in '{value}' is not a parameter.{hint} Add it under parameters, e.g. {name}: 1",
        name=name,
        value=formula,
        hint=hint,
    )


def unit_differs(text: str, found: Dimension, wanted: Dimension) -> Message:
    """That what a text says has no unit, or another one than is wanted."""
    kinds = {
        LENGTH: Message("a length"),
        MASS: Message("a mass"),
        TIME: Message("a time"),
        FORCE: Message("a force"),
        VELOCITY: Message("a velocity"),
        ACCELERATION: Message("an acceleration"),
        ANGULAR_VELOCITY: Message("an angular velocity"),
        INERTIA: Message("a moment of inertia"),
        TORQUE: Message("a torque"),
        STIFFNESS: Message("a stiffness"),
    }
    kind = kinds.get(wanted, Message("a quantity"))
    if wanted == DIMENSIONLESS:
        return Message(
            "{text} must be a pure number or an angle, but is given in {dimension}", text=text, dimension=found
        )
    if found == DIMENSIONLESS:
        return Message("{text} must be {kind} ({unit}), but has no unit", text=text, kind=kind, unit=wanted)
    return Message(
        "{text} must be {kind} ({unit}), but is given in {dimension}",
        text=text,
        kind=kind,
        unit=wanted,
        dimension=found,
    )


def _as_number(value: Any) -> float | None:
    """A number without a unit; None for anything else."""
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return float(value)
    try:
        return float(value)
    except (TypeError, ValueError):
        return None
